// The work of the page beside it, so that it never freezes. One message asks, one answers; a run also tells how far it is.
import init, { Files, gearbox, keys, library, look, pair, run } from "./asperity.js";

let ready;
// The last result, and the one that it is held against.
let last;
let before;

// Makes the last result A, or keeps A, and holds the new one against it.
function sideBySide(found, hold) {
  if (last && before && hold) last.free();
  else if (last) {
    before?.free();
    before = last;
  }
  last = found;
  return before ? JSON.parse(before.versus(found)) : null;
}

const tasks = {
  library: () => JSON.parse(library()),
  pair: ({ text }) => JSON.parse(pair("gears.toml", text)),
  gearbox: ({ name, bytes, stage, pinion, wheel }) => JSON.parse(gearbox(name, bytes, stage, pinion, wheel)),
  keys: ({ name, text }) => JSON.parse(keys(name, text)),
  look: ({ name, bytes, flank, stated }) => JSON.parse(look(name, bytes, flank, JSON.stringify(stated))),
  run: ({ name, text, files, hold }, id) => {
    const held = new Files();
    for (const file of files) held.hold(file.name, file.bytes);
    const begin = performance.now();
    const told = (done, total) => postMessage({ id, done, total });
    const found = run(name, text, held, told);
    const seconds = (performance.now() - begin) / 1000;
    const contents = Object.fromEntries(found.names.map((each) => [each, found.file(each)]));
    held.free();
    const { title, summary } = found;
    return { title, summary, files: contents, seconds, inputs: JSON.parse(found.inputs()), versus: sideBySide(found, hold) };
  },
};

// What the program refuses is the text of a JSON object; anything else is a fault of the program.
function failure(error) {
  if (typeof error === "string") return JSON.parse(error);
  return { code: "E501", message: `a fault of the program: ${error?.message ?? error}`, fatal: true };
}

onmessage = async ({ data: { id, task, ...given } }) => {
  if (task === "start") {
    ready = init({ module_or_path: given.module });
    return;
  }
  try {
    await ready;
    postMessage({ id, answer: tasks[task](given, id) });
  } catch (error) {
    postMessage({ id, failure: failure(error) });
  }
};
