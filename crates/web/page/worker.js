// The work of the page beside it, so that it never freezes. One message asks, one answers; a run also tells how far it is.
import init, { Files, keys, look, oils, run } from "./asperity.js";

let ready;

const tasks = {
  oils: () => JSON.parse(oils()),
  keys: ({ name, text }) => JSON.parse(keys(name, text)),
  look: ({ name, bytes, flank, stated }) => JSON.parse(look(name, bytes, flank, JSON.stringify(stated))),
  run: ({ name, text, files }, id) => {
    const held = new Files();
    for (const file of files) held.hold(file.name, file.bytes);
    const begin = performance.now();
    const told = (done, total) => postMessage({ id, done, total });
    const found = run(name, text, held, told);
    const seconds = (performance.now() - begin) / 1000;
    const contents = Object.fromEntries(found.names.map((each) => [each, found.file(each)]));
    const answer = { title: found.title, summary: found.summary, files: contents, seconds };
    found.free();
    held.free();
    return answer;
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
