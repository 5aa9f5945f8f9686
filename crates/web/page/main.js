// The page: files and form in, the case as text, the run, its result.
import { questions, runs } from "./engine.js";
import { asLink, forget, fromLink, keep, kept } from "./draft.js";
import { caseText, completed, fieldOf, filesOf, fill, fillGears, gearsText, list, missing, rest, shown, stated } from "./form.js";
import { clearError, setStale, showError, showResult } from "./result.js";

const element = (id) => document.getElementById(id);
const form = element("form");
const text = element("text");
const status = element("status");

// Worked cases that the form can start from; beside the page, with their profiles.
const CASES = [
  ["e-drive", "E-drive stage, 23/68, module 1.8 mm"],
  ["e-drive-superfinished", "the same, superfinished flanks"],
  ["fzg-c", "FZG test gears type C, load stage 7"],
];
const DEMO = "e-drive";
// Endings of a case and of a gearbox; all other files are taken for profiles.
const CASE_ENDINGS = /\.(toml|json)$/i;
const GEARBOX_ENDINGS = /\.rexs[jz]?$/i;
// Files beside a profile that hold the conditions of its measurement.
const BESIDE = /\.tx3$/i;
// Time without a key pressed before the text is read [ms].
const PAUSE = 250;

const state = {
  // Name of the case, for messages and downloads.
  name: "case.toml",
  // Files in memory, by their names.
  held: new Map(),
  // Names of the traces as the case has them.
  files: { pinion: "", wheel: "" },
  // Names of all files in a text that the form does not show.
  named: [],
  // The gearbox file that the case was made of, its content, and the names of its stages.
  gearbox: null,
  // Whether the form is at rest, since the text says more.
  apart: false,
  // Whether a profile was chosen by the user.
  own: false,
  // Whether anything was chosen or written by the user, so that the draft is kept.
  touched: false,
  // The pair of flanks to compare with the present one.
  first: null,
  // What the result that is shown was computed of.
  ran: null,
  // The gears of the library, by their names.
  gears: new Map(),
};

const bare = (name) => name.split(/[/\\]/).pop();

// --- the text of the case

function write() {
  if (state.apart) return;
  // The form writes TOML, whatever it was filled from.
  state.name = state.name.replace(/\.json$/i, ".toml");
  text.value = caseText(state.files);
  changed();
}

// The files that the case names and that are at hand.
const used = () => {
  const names = new Set([...Object.values(state.files), ...(state.apart ? state.named : [])].filter(Boolean).map(bare));
  return [...state.held].filter(([name]) => names.has(bare(name))).map(([name, bytes]) => ({ name, bytes }));
};

// The inputs as far as they count: comments of a text that the form shows whole do not.
const inputs = () => (state.apart ? text.value : caseText(state.files));

let later;
// After every change: the result is marked, and a little later the gears are drawn and the draft is kept.
function changed() {
  if (state.ran) setStale(state.ran.inputs !== inputs() || used().some(({ name, bytes }) => state.ran.held.get(name) !== bytes));
  clearTimeout(later);
  later = setTimeout(() => {
    drawPair();
    keepDraft();
  }, PAUSE);
}

// --- the gears as a picture

async function drawPair() {
  const figure = element("pair");
  const drawing = figure.querySelector(".drawing"), caption = figure.querySelector("[role=status]");
  const given = state.apart ? text.value : gearsText();
  // The gears of a train are drawn in the reports of its meshes.
  figure.hidden = form.classList.contains("train");
  if (figure.hidden) return;
  try {
    const { svg, facts } = await questions.ask("pair", { text: given });
    drawing.innerHTML = svg;
    caption.textContent = facts.map((fact) => fact.join(" ")).join(", ");
    figure.classList.remove("refused");
    figure.hidden = false;
  } catch (failure) {
    if (failure.code === "cancelled") return;
    // While it is being written, what was drawn before stays, and it says why it is not new.
    figure.classList.add("refused");
    caption.textContent = `Not drawn: ${failure.message}`;
  }
}

// --- the draft

function keepDraft() {
  const place = element("draft-note");
  if (!state.touched) return;
  const whole = keep({ name: state.name, text: text.value, files: used() });
  place.textContent = {
    true: "This draft is kept in this browser, with its traces.",
    false: "This draft is kept in this browser; its traces are too large for that and must be chosen again.",
  }[whole] ?? "This browser keeps no draft.";
}

element("forget").addEventListener("click", async () => {
  [state.touched, state.own] = [false, false];
  forget();
  history.replaceState(null, "", location.pathname);
  clearError();
  state.held.clear();
  for (const body of ["pinion", "wheel"]) element(`file-${body}`).value = "";
  await start(DEMO, false);
  for (const body of ["pinion", "wheel"]) state.files[body] = "";
  write();
  await Promise.all(["pinion", "wheel"].map(look));
  element("draft-note").textContent = "The draft is forgotten.";
});

element("link").addEventListener("click", async () => {
  history.replaceState(null, "", asLink(text.value));
  const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
  element("draft-note").textContent = `The link is ${copied ? "copied and " : ""}in the address bar. It holds the text of the case, not the traces.`;
});

// Reads a draft or a link; gives whether there was one.
async function restored() {
  const linked = fromLink();
  const draft = linked === undefined ? kept() : { name: "case.toml", text: linked, files: [] };
  if (!draft) return false;
  state.name = draft.name;
  state.own = draft.files.length > 0;
  for (const file of draft.files) state.held.set(file.name, file.bytes);
  try {
    await adopt(draft.text);
  } catch {
    setApart(true);
  }
  state.touched = true;
  element("draft-note").textContent = linked === undefined
    ? "The draft of the last visit, kept in this browser."
    : "From a link, which holds no traces: choose the profiles.";
  return true;
}

addEventListener("hashchange", () => restored().catch(refuse));

// Takes a text as the case. The form shows it, or rests where it cannot show all of it.
async function adopt(whole) {
  text.value = whole;
  // As it stands there, with line feeds alone.
  const given = text.value;
  const input = await questions.ask("keys", { name: state.name, text: given });
  if (text.value !== given) return;
  fill(input);
  state.named = filesOf(input);
  form.classList.toggle("train", Boolean(input.mesh ?? input.planetary));
  for (const body of ["pinion", "wheel"]) state.files[body] = input.surface?.[body]?.file ?? "";
  const shows = { name: "form.toml", text: caseText(state.files) };
  const back = await questions.ask("keys", shows).catch(() => null);
  if (text.value !== given) return;
  setApart(JSON.stringify(back) !== JSON.stringify(input));
  changed();
  await Promise.all(["pinion", "wheel"].map(look));
}

// The files that a text names beyond the two of the form, and whether they are at hand.
function showNamed() {
  const beyond = state.apart ? state.named.filter((name) => !Object.values(state.files).includes(name)) : [];
  const parts = beyond.map((name) => `${bare(name)} ${state.held.has(bare(name)) || state.held.has(name) ? "(chosen)" : "(not chosen yet: drop it on the page)"}`);
  element("named").hidden = !beyond.length;
  element("named").textContent = `The case also names ${parts.join(", ")}.`;
}

function setApart(apart) {
  state.apart = apart;
  if (!apart) form.classList.remove("train");
  rest(apart);
  showNamed();
  element("apart").hidden = !apart;
  if (apart) element("text-part").open = true;
}

let pause;
text.addEventListener("input", () => {
  clearTimeout(pause);
  clearError();
  state.touched = true;
  changed();
  pause = setTimeout(() => {
    // While it is being written a text may be no case; the run says so, here the form rests.
    adopt(text.value).catch(() => setApart(true));
  }, PAUSE);
});

form.addEventListener("input", ({ target }) => {
  if (!target.name) return;
  target.removeAttribute("aria-invalid");
  state.touched = true;
  shown();
  write();
});

form.addEventListener("change", ({ target }) => {
  if (!target.name) return;
  completed(target);
  write();
  const flank = /^surface\.(pinion|wheel)\./.exec(target.name);
  if (flank) look(flank[1]);
});

element("to-form").addEventListener("click", () => {
  setApart(false);
  write();
});

// --- files

async function look(body) {
  const place = element(`look-${body}`);
  const drawing = element(`trace-${body}`);
  const name = state.files[body];
  const bytes = state.held.get(name) ?? state.held.get(bare(name));
  place.classList.remove("refused");
  if (!name || !bytes) drawing.hidden = true;
  if (!name) return void (place.textContent = "");
  if (!bytes) {
    place.classList.add("refused");
    return void (place.textContent = `${bare(name)} is named in the case and has not been chosen yet.`);
  }
  try {
    const flank = `surface.${body}`;
    const found = await questions.ask("look", { name: bare(name), bytes, flank, stated: stated(body) });
    const spacing = Number(found.spacing_um.toPrecision(4));
    const length = Number(found.length_mm.toPrecision(4));
    const told = `${bare(name)}: ${found.points} points, ${spacing} µm apart, ${length} mm, heights in ${found.z_unit.replace("um", "µm")}.`;
    place.textContent = [told, ...found.warnings].join(" ");
    drawing.innerHTML = found.svg;
    drawing.hidden = false;
  } catch (failure) {
    if (failure.code === "cancelled") return;
    drawing.hidden = true;
    place.classList.add("refused");
    place.textContent = `${failure.code} ${failure.message}`;
  }
}

// Keeps a file; a second one of the same name and other content gets a name of its own.
function hold(file, body) {
  const other = body === "pinion" ? "wheel" : "pinion";
  const isTaken = body && bare(state.files[other]) === file.name;
  const name = isTaken && !same(state.held.get(file.name), file.bytes) ? `${body}-${file.name}` : file.name;
  state.held.set(name, file.bytes);
  showNamed();
  return name;
}

const same = (a, b) => a?.length === b.length && a.every((byte, at) => byte === b[at]);

async function setFlank(body, file) {
  clearError();
  const name = hold(file, body);
  [state.own, state.touched] = [true, true];
  const { gearbox } = state;
  if (gearbox) gearbox.flanks = { ...gearbox.flanks, [body]: name };
  // The case of a gearbox that is as it was made takes the trace; a text of its own names its files itself, and one of this
  // name is now at hand.
  if (state.apart && gearbox?.made === text.value) return takeGearbox(gearbox, Number(element("stage").value));
  if (!state.apart) state.files[body] = name;
  write();
  await look(body);
}

const read = async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });

for (const body of ["pinion", "wheel"]) {
  element(`file-${body}`).addEventListener("change", async ({ target }) => {
    const [file] = target.files;
    if (file) await take([await read(file)], body);
  });
}

// A case of a gearbox file, of the whole or of a stage, with the flanks that are chosen.
async function takeGearbox({ name, bytes, flanks = state.own ? state.files : { pinion: "", wheel: "" } }, wanted = 0) {
  const { stage, stages, case: made, notes } = await questions.ask("gearbox", { name, bytes, stage: wanted, ...flanks });
  state.name = `${name.replace(/\.[^.]*$/, "")}.toml`;
  const adopted = adopt(made);
  state.gearbox = { name, bytes, flanks, made: text.value };
  element("stage-part").hidden = stages.length < 2;
  element("stage").replaceChildren(new Option("the whole gearbox", 0), ...stages.map((each, at) => new Option(each, at + 1)));
  element("stage").value = String(stage);
  status.textContent = [`${name} is read.`, ...notes].join(" ");
  // A stage without roughness has no flanks before its profiles are chosen.
  await adopted.catch(() => setApart(true));
}

function leaveGearbox() {
  state.gearbox = null;
  element("stage-part").hidden = true;
}

element("stage").addEventListener("change", ({ target }) => {
  clearError();
  takeGearbox(state.gearbox, Number(target.value)).catch(refuse);
});

// Files as they come: a case, a gearbox, or traces for the flanks that have none, the wheel's by its name.
async function take(files, body) {
  clearError();
  try {
    if (files.some(({ name }) => CASE_ENDINGS.test(name))) leaveGearbox();
    const cases = files.filter(({ name }) => CASE_ENDINGS.test(name));
    const beside = files.filter(({ name }) => BESIDE.test(name));
    const gearboxes = files.filter(({ name }) => GEARBOX_ENDINGS.test(name));
    const traces = files.filter((file) => ![...cases, ...beside, ...gearboxes].includes(file));
    for (const file of beside) hold(file);
    const [given] = cases;
    state.touched = true;
    if (given) {
      for (const file of traces) hold(file);
      state.name = given.name;
      return await adopt(new TextDecoder().decode(given.bytes));
    }
    if (body) {
      for (const file of traces) await setFlank(body, file);
      return;
    }
    const isWheels = ({ name }) => /wheel|rad|gear.?2/i.test(name);
    traces.sort((a, b) => isWheels(a) - isWheels(b));
    const isFree = (each) => !state.held.has(bare(state.files[each]));
    const isWhole = state.own && !isFree("pinion") && !isFree("wheel");
    let before = isWhole ? { ...state.files } : null;
    for (const pair of pairsOf(traces, isWheels)) {
      for (const [at, file] of pair.entries()) {
        const alone = isWheels(file) || (isFree("wheel") && !isFree("pinion")) ? "wheel" : "pinion";
        await setFlank(pair.length > 1 ? ["pinion", "wheel"][Math.min(at, 1)] : alone, file);
      }
      if (pair.length === 2) askToCompare(before);
      before = { ...state.files };
    }
    if (gearboxes.length) await takeGearbox(gearboxes[0]);
  } catch (failure) {
    // What is no case is shown as it is, for its author to mend.
    setApart(true);
    refuse(failure);
  }
}

// Traces of two finishes as two pairs, each with its wheel second; others as they are.
function pairsOf(traces, isWheels) {
  if (traces.length !== 4) return [traces];
  const half = traces.filter(isWheels).length === 2 ? 2 : 1;
  return half === 2 ? [[traces[0], traces[2]], [traces[1], traces[3]]] : [traces.slice(0, 2), traces.slice(2)];
}

// With two pairs of flanks at hand, asks whether to compare them.
function askToCompare(first) {
  const names = (files) => `${bare(files.pinion)} and ${bare(files.wheel)}`;
  const second = { ...state.files };
  state.first = first && !state.apart && names(first) !== names(second) ? first : null;
  element("two").hidden = !state.first;
  if (state.first) element("two-names").textContent = `Two finishes: A, ${names(first)}; B, ${names(second)}.`;
}

element("compare").addEventListener("click", async () => {
  const [first, second] = [state.first, { ...state.files }];
  element("two").hidden = true;
  const set = async (files) => {
    state.files = { ...files };
    write();
    await Promise.all(["pinion", "wheel"].map(look));
  };
  // What is shown may be the first finish already.
  await set(first);
  const isShown = state.ran?.inputs === inputs() && !used().some(({ name, bytes }) => state.ran.held.get(name) !== bytes);
  if (!isShown) await run();
  if (form.dataset.run !== "done") return;
  element("hold").checked = false;
  await set(second);
  await run();
});

for (const kind of ["dragenter", "dragover"]) {
  addEventListener(kind, (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
}
addEventListener("dragleave", ({ relatedTarget }) => relatedTarget || document.body.classList.remove("dropping"));
addEventListener("drop", async (event) => {
  event.preventDefault();
  document.body.classList.remove("dropping");
  const files = [...event.dataTransfer.files];
  await take(await Promise.all(files.map(read)));
});

// --- worked cases

async function fetched(name) {
  const response = await fetch(new URL(`examples/${name}`, document.baseURI));
  if (!response.ok) throw { code: "E103", message: `examples/${name}: ${response.status} ${response.statusText}` };
  return new Uint8Array(await response.arrayBuffer());
}

// A worked case with its synthetic profiles, or without, on the flanks that have been chosen.
async function start(name, withProfiles) {
  leaveGearbox();
  const { ...mine } = state.files;
  state.name = `${name}.toml`;
  const given = new TextDecoder().decode(await fetched(state.name));
  if (withProfiles) {
    const { surface } = await questions.ask("keys", { name: state.name, text: given });
    const names = [surface.pinion.file, surface.wheel?.file].filter(Boolean).map(bare);
    for (const each of names) state.held.set(each, await fetched(each));
    state.own = false;
  }
  await adopt(given);
  if (withProfiles) return;
  state.files = mine;
  form.elements.namedItem("title").value = CASES.find(([known]) => known === name)[1];
  setApart(false);
  write();
  await Promise.all(["pinion", "wheel"].map(look));
}

element("preset").append(new Option("a worked case …", ""), ...CASES.map(([name, title]) => new Option(title, name)));
element("gears-by-name").addEventListener("change", ({ target }) => {
  const chosen = state.gears.get(target.value);
  element("gears-note").textContent = chosen ? `${chosen.note} Its operating point and its oil are filled in, too.` : "";
  if (!chosen) return;
  state.touched = true;
  fillGears(chosen.keys);
  form.elements.namedItem("title").value = chosen.title;
  write();
});

element("preset").addEventListener("change", ({ target }) => {
  state.touched = true;
  if (target.value) start(target.value, !state.own).catch(refuse);
});
element("demo").addEventListener("click", async () => {
  clearError();
  try {
    for (const body of ["pinion", "wheel"]) element(`file-${body}`).value = "";
    element("preset").value = DEMO;
    await start(DEMO, true);
    await run();
  } catch (failure) {
    refuse(failure);
  }
});

// --- the run

// How the last run ended, for whoever watches the page from outside.
const note = (how) => (form.dataset.run = how);

function busy(is) {
  element("run").disabled = is;
  element("demo").disabled = is;
  element("cancel").hidden = !is;
  element("bar").hidden = !is;
  if (is) element("bar").removeAttribute("value");
}

function refuse(failure) {
  if (failure.code === "cancelled") return void note("cancelled");
  note("refused");
  showError(failure, text, fieldOf(failure.place?.key));
  status.textContent = failure.code ? `Not run: ${failure.code}` : "Not run";
}

// What is missing before the program is asked.
function lacking() {
  if (state.apart) return false;
  const [first] = state.files.pinion ? missing() : [element("file-pinion")];
  if (!first) return false;
  first.setAttribute("aria-invalid", "true");
  first.focus();
  const name = first.ariaLabel ?? first.closest("label").firstChild.textContent.trim();
  status.textContent = `Fill in first: ${name}`;
  return true;
}

async function run() {
  clearError();
  if (lacking()) return;
  busy(true);
  note("running");
  status.textContent = "Reading the traces …";
  element("show").hidden = true;
  const given = { name: state.name, text: text.value, inputs: inputs(), held: new Map(state.held) };
  const files = [...state.held].map(([name, bytes]) => ({ name, bytes }));
  try {
    const found = await runs.ask("run", { name: given.name, text: given.text, files, hold: element("hold").checked }, (done, total) => {
      element("bar").max = total;
      element("bar").value = done;
      status.textContent = done < total ? `Position ${done} of ${total}` : "Uncertainty of the loss …";
    });
    await showResult(found, given);
    state.ran = given;
    changed();
    note("done");
    status.textContent = `Done in ${found.seconds.toFixed(1)} s`;
    element("show").hidden = false;
  } catch (failure) {
    if (failure.code === "cancelled") status.textContent = "Cancelled";
    refuse(failure);
  } finally {
    busy(false);
    runs.warm();
  }
}

form.addEventListener("submit", (event) => {
  event.preventDefault();
  if (!element("run").disabled) run();
});
element("cancel").addEventListener("click", () => runs.stop());
element("show").addEventListener("click", () => {
  element("main").scrollIntoView({ block: "start" });
  element("main").focus({ preventScroll: true });
});

// --- the start

runs.warm();
try {
  const { gears, oils, steels } = await questions.ask("library");
  list(form.elements.namedItem("lubricant.oil"), oils);
  list(form.elements.namedItem("material.pinion.steel"), steels);
  list(element("gears-by-name"), gears);
  for (const each of gears) state.gears.set(each.name, each);
  if (!await restored()) await start(DEMO, false);
  await drawPair();
  note("ready");
} catch (failure) {
  refuse(failure);
}
