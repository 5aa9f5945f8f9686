// The form and the text of its case. The names of the fields are keys of the case.

const form = document.getElementById("form");
const fields = () => [...form.querySelectorAll("[name]")];
const field = (key) => form.elements.namedItem(key);

// Text of TOML: JSON writes it alike but for the character DEL and for halves of characters.
const quoted = (text) => JSON.stringify(text.toWellFormed?.() ?? text).replaceAll("\x7f", "\\u007f");
const isNumber = (text) => /^[+-]?(\d+(\.\d*)?|\.\d+)(e[+-]?\d+)?$/i.test(text);
const isPlainNumber = (text) => /^[+-]?(0|[1-9]\d*)(\.\d+)?(e[+-]?\d+)?$/i.test(text);
// What is no number goes in as text, so that the program can say what it is.
const number = (text) => (isPlainNumber(text) ? text : quoted(text));
const given = (key) => field(key).value.trim();

// A number without a unit has that of its field, which is then seen.
export function completed(input) {
  const text = input.value.trim();
  if (input.dataset.unit && isNumber(text)) input.value = `${text} ${input.dataset.unit}`;
}

function table(name, lines) {
  const kept = lines.filter(Boolean);
  return kept.length ? `\n[${name}]\n${kept.join("\n")}\n` : "";
}

const line = (key, value) => (value === undefined || value === "" ? "" : `${key} = ${value}`);
const quantity = (table, key) => line(key, given(`${table}.${key}`) && quoted(given(`${table}.${key}`)));

function pair(path, one, blank) {
  const both = [given(`${path}.0`), given(`${path}.1`)];
  if (!both[0] && !both[1]) return "";
  if (!both[1] && blank === undefined) return one(both[0]);
  return `[${both.map((text) => one(text || blank || "")).join(", ")}]`;
}

// Relief of the tips of a gear: none, an amount over a length, or not stated.
function tipRelief(body) {
  const at = (key) => given(`gears.${body}.tip_relief.${key}`);
  const [amount, length] = ["amount", "length"].map(at);
  if (/^(none|0+(\.0*)?( *[uµmn]?m)?)$/i.test(amount)) return `${body} = { tip_relief = "none" }`;
  const keys = [line("amount", amount && quoted(amount)), line("length", length && quoted(length))].filter(Boolean);
  return keys.length && `${body} = { tip_relief = { ${keys.join(", ")} } }`;
}

function flank(body, file) {
  // A case has a pinion; without a wheel its trace serves both.
  if (!file) return body === "pinion" ? "pinion = {}" : "";
  const keys = [
    line("file", quoted(file)),
    field(`surface.${body}.mirrored`).checked && "mirrored = true",
    quantity(`surface.${body}`, "dx"),
    quantity(`surface.${body}`, "z_unit"),
  ];
  return `${body} = { ${keys.filter(Boolean).join(", ")} }`;
}

function oil() {
  const name = given("lubricant.oil");
  if (name) return [line("oil", quoted(name))];
  const at = (key) => given(`lubricant.viscosity.${key}`);
  const both = ["at_40", "at_100"].map((key) => line(key, at(key) && quoted(at(key)))).filter(Boolean);
  const law = both.length && `viscosity = { law = "astm-d341", ${both.join(", ")} }`;
  return [law, quantity("lubricant", "density"), quantity("lubricant", "base_oil")];
}

// The table of the gears, which alone is enough to draw them.
export function gearsText() {
  return table("gears", [
    line("teeth", `[${number(given("gears.teeth.0"))}, ${number(given("gears.teeth.1"))}]`),
    quantity("gears", "module"),
    quantity("gears", "helix"),
    quantity("gears", "pressure_angle"),
    line("face_width", pair("gears.face_width", quoted)),
    line("profile_shift", pair("gears.profile_shift", number, "0")),
    quantity("gears", "centre_distance"),
    line("tip_diameter", pair("gears.tip_diameter", quoted, "")),
    tipRelief("pinion"),
    tipRelief("wheel"),
  ]);
}

// The text of the case in the form, with the files of these names.
export function caseText(files) {
  const title = given("title");
  const steel = ["steel", "hardness", "elastic_limit", "flow_pressure"];
  return [
    title && `title = ${quoted(title)}\n`,
    gearsText(),
    table("material.pinion", steel.map((key) => quantity("material.pinion", key))),
    table("operation", ["torque", "speed", "bulk_temperature"].map((key) => quantity("operation", key))),
    table("lubricant", oil()),
    table("surface", [quantity("surface", "cutoff"), flank("pinion", files.pinion), flank("wheel", files.wheel)]),
  ].join("").trimStart();
}

const at = (input, path) => path.split(".").reduce((value, key) => value?.[key], input);

// The files that a case names: traces of all flanks, an oil, tables of losses.
export function filesOf(input) {
  if (typeof input !== "object" || input === null) return [];
  const own = Object.entries(input).filter(([key, value]) => ["file", "oil_file", "loss_table", "xu"].includes(key) && typeof value === "string");
  const found = [...own.map(([, value]) => value), ...Object.values(input).flatMap(filesOf)];
  return [...new Set(found)];
}

// The keys of a case as the fields have them.
function byField(input) {
  const seen = structuredClone(input);
  const width = input.gears?.face_width;
  if (typeof width === "string") seen.gears.face_width = [width, ""];
  for (const body of ["pinion", "wheel"]) {
    if (at(seen, `gears.${body}.tip_relief`) === "none") seen.gears[body].tip_relief = { amount: "none" };
  }
  return seen;
}

// The keys of a case into the fields; keys that have no field are left out.
export function fill(input) {
  const seen = byField(input);
  for (const each of fields()) {
    const value = at(seen, each.name);
    // Both traces from root to tip: the wheel's is read from its other end.
    const unstated = each.name === "surface.wheel.mirrored" && !input.surface?.wheel;
    if (each.type === "checkbox") each.checked = value === true || unstated;
    else each.value = value === null || value === undefined ? "" : String(value);
    // A choice that the form does not have.
    if (each.tagName === "SELECT" && each.selectedIndex < 0) each.selectedIndex = 0;
  }
  shown();
}

// Puts the keys of a pair of the library into the fields: its gears, its operating point and its oil.
export function fillGears(keys) {
  const seen = byField(keys);
  for (const each of fields()) {
    const table = each.name.split(".")[0];
    const value = at(seen, each.name);
    if (table === "gears" || value !== undefined) each.value = value ?? "";
  }
  shown();
}

// The notes of what is chosen by name, and the part about the oil that the choice of the oil leaves.
export function shown() {
  document.getElementById("data-sheet").hidden = given("lubricant.oil") !== "";
  for (const [key, note] of [["lubricant.oil", "oil-note"], ["material.pinion.steel", "steel-note"]]) {
    const [chosen] = field(key).selectedOptions;
    document.getElementById(note).textContent = chosen?.dataset.note ?? "";
  }
}

// The words of a field, for a key of the case.
export function labelOf(key) {
  const found = fields().find((each) => each.name === key);
  const label = found?.closest("label")?.firstChild.textContent.trim();
  return label || key;
}

// Fields rest while the text says more than they can show; the files may still be chosen.
export function rest(resting) {
  for (const part of form.querySelectorAll("fieldset.keys")) part.disabled = resting;
  for (const part of form.querySelectorAll("#flanks .keys")) part.toggleAttribute("inert", resting);
}

// The field that a key of the case is shown in, or one of those of its table.
export function fieldOf(key) {
  if (!key) return undefined;
  const names = [key, `${key}.0`];
  const body = /^surface\.(pinion|wheel)(\.file)?$/.exec(key);
  if (body) return document.getElementById(`file-${body[1]}`);
  return fields().find((each) => names.includes(each.name)) ?? fields().find((each) => each.name.startsWith(`${key}.`));
}

// Fields that a case needs and that hold nothing.
export const missing = () => fields().filter((each) => each.required && !each.value.trim());

// What the form states about the file of a flank.
export function stated(body) {
  const found = {};
  for (const key of ["dx", "z_unit"]) {
    const value = given(`surface.${body}.${key}`);
    if (value) found[key] = value;
  }
  found.mirrored = field(`surface.${body}.mirrored`).checked;
  return found;
}

// Names to choose from, each with its note.
export function list(place, entries) {
  for (const { name, title, note } of entries) {
    const option = new Option(title ? `${name}: ${title}` : name, name);
    option.dataset.note = note;
    place.append(option);
  }
}
