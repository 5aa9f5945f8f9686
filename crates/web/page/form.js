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

function flank(body, file) {
  if (!file) return "";
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

// The text of the case in the form, with the files of these names.
export function caseText(files) {
  const title = given("title");
  return [
    title && `title = ${quoted(title)}\n`,
    table("gears", [
      line("teeth", `[${number(given("gears.teeth.0"))}, ${number(given("gears.teeth.1"))}]`),
      quantity("gears", "module"),
      quantity("gears", "helix"),
      quantity("gears", "pressure_angle"),
      line("face_width", pair("gears.face_width", quoted)),
      line("profile_shift", pair("gears.profile_shift", number, "0")),
      quantity("gears", "centre_distance"),
    ]),
    table("material.pinion", [quantity("material.pinion", "elastic_limit"), quantity("material.pinion", "flow_pressure")]),
    table("operation", ["torque", "speed", "temperature"].map((key) => quantity("operation", key))),
    table("lubricant", oil()),
    table("surface", [quantity("surface", "cutoff"), flank("pinion", files.pinion), flank("wheel", files.wheel)]),
  ].join("").trimStart();
}

const at = (input, path) => path.split(".").reduce((value, key) => value?.[key], input);

// The keys of a case into the fields; keys that have no field are left out.
export function fill(input) {
  const width = input.gears?.face_width;
  const seen = structuredClone(input);
  if (typeof width === "string") seen.gears.face_width = [width, ""];
  for (const each of fields()) {
    const value = at(seen, each.name);
    if (each.type === "checkbox") each.checked = value === true;
    else each.value = value === null || value === undefined ? "" : String(value);
    // A choice that the form does not have.
    if (each.tagName === "SELECT" && each.selectedIndex < 0) each.selectedIndex = 0;
  }
  shown();
}

// The part about the oil that the choice of the oil leaves.
export function shown() {
  const name = given("lubricant.oil");
  document.getElementById("data-sheet").hidden = name !== "";
  const chosen = field("lubricant.oil").selectedOptions[0];
  document.getElementById("oil-note").textContent = chosen?.dataset.note ?? "";
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
  return found;
}

export function listOils(oils) {
  const list = field("lubricant.oil");
  for (const oil of oils) {
    const option = new Option(oil.name, oil.name);
    option.dataset.note = `${oil.note} (${oil.source})`;
    list.append(option);
  }
}
