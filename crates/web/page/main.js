// The page: files and form in, the case as text, the run, its result.
import { questions, runs } from "./engine.js";
import { caseText, completed, fieldOf, fill, listOils, missing, rest, shown, stated } from "./form.js";
import { clearError, showError, showResult } from "./result.js";

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
// Endings of a case; all other files are taken for profiles.
const CASE_ENDINGS = /\.(toml|json)$/i;
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
  // Whether the form is at rest, since the text says more.
  apart: false,
  // Whether a profile was chosen by the user.
  own: false,
};

const bare = (name) => name.split(/[/\\]/).pop();

// --- the text of the case

function write() {
  if (state.apart) return;
  // The form writes TOML, whatever it was filled from.
  state.name = state.name.replace(/\.json$/i, ".toml");
  text.value = caseText(state.files);
}

// Takes a text as the case. The form shows it, or rests where it cannot show all of it.
async function adopt(whole) {
  text.value = whole;
  // As it stands there, with line feeds alone.
  const given = text.value;
  const input = await questions.ask("keys", { name: state.name, text: given });
  if (text.value !== given) return;
  fill(input);
  for (const body of ["pinion", "wheel"]) state.files[body] = input.surface?.[body]?.file ?? "";
  const shows = { name: "form.toml", text: caseText(state.files) };
  const back = await questions.ask("keys", shows).catch(() => null);
  if (text.value !== given) return;
  setApart(JSON.stringify(back) !== JSON.stringify(input));
  await Promise.all(["pinion", "wheel"].map(look));
}

function setApart(apart) {
  state.apart = apart;
  rest(apart);
  element("apart").hidden = !apart;
  if (apart) element("text-part").open = true;
}

let pause;
text.addEventListener("input", () => {
  clearTimeout(pause);
  clearError();
  pause = setTimeout(() => {
    // While it is being written a text may be no case; the run says so, here the form rests.
    adopt(text.value).catch(() => setApart(true));
  }, PAUSE);
});

form.addEventListener("input", ({ target }) => {
  if (!target.name) return;
  target.removeAttribute("aria-invalid");
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
  const name = state.files[body];
  const bytes = state.held.get(name) ?? state.held.get(bare(name));
  place.classList.remove("refused");
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
    const told = `${bare(name)}: ${found.points} points, ${spacing} µm apart, ${length} mm, heights in ${found.z_unit}.`;
    place.textContent = [told, ...found.warnings].join(" ");
  } catch (failure) {
    if (failure.code === "cancelled") return;
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
  return name;
}

const same = (a, b) => a?.length === b.length && a.every((byte, at) => byte === b[at]);

async function setFlank(body, file) {
  clearError();
  const name = hold(file, body);
  state.own = true;
  // A text of its own names its files itself; one of this name is now at hand.
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

// Files as they come: a case, or traces for the flanks that have none, the wheel's by its name.
async function take(files, body) {
  clearError();
  try {
    const cases = files.filter(({ name }) => CASE_ENDINGS.test(name));
    const beside = files.filter(({ name }) => BESIDE.test(name));
    const traces = files.filter((file) => !cases.includes(file) && !beside.includes(file));
    for (const file of beside) hold(file);
    const [given] = cases;
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
    for (const [at, file] of traces.entries()) {
      const alone = isWheels(file) || (isFree("wheel") && !isFree("pinion")) ? "wheel" : "pinion";
      await setFlank(traces.length > 1 ? ["pinion", "wheel"][Math.min(at, 1)] : alone, file);
    }
  } catch (failure) {
    // What is no case is shown as it is, for its author to mend.
    setApart(true);
    refuse(failure);
  }
}

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
element("preset").addEventListener("change", ({ target }) => {
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
  const given = { name: state.name, text: text.value };
  const files = [...state.held].map(([name, bytes]) => ({ name, bytes }));
  try {
    const found = await runs.ask("run", { ...given, files }, (done, total) => {
      element("bar").max = total;
      element("bar").value = done;
      status.textContent = done < total ? `Position ${done} of ${total}` : "Uncertainty of the loss …";
    });
    showResult(found, given);
    note("done");
    status.textContent = `Done in ${found.seconds.toFixed(1)} s`;
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

// --- the start

runs.warm();
try {
  listOils(await questions.ask("oils"));
  await start(DEMO, false);
  note("ready");
} catch (failure) {
  refuse(failure);
}
