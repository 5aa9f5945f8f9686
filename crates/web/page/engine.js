// Workers that the page asks: one for questions while the form is filled, one for the run, which can be cancelled.

// The module is compiled once and shared, and with it what the browser has optimised of it so far.
async function compiled() {
  const place = new URL("asperity_bg.wasm", import.meta.url);
  const response = await fetch(place);
  if (!response.ok) throw new Error(`${place.pathname}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

const module = compiled();
let last = 0;

class Engine {
  #worker;
  #waiting = new Map();

  async #start() {
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    worker.onmessage = ({ data }) => this.#heard(data);
    worker.onerror = (event) => this.stop({ code: "E501", message: event.message || "the worker cannot be started" });
    worker.postMessage({ task: "start", module: await module });
    return worker;
  }

  // Asks for a task; `told` hears how far it is.
  async ask(task, given = {}, told = () => {}) {
    this.#worker ??= this.#start();
    const started = this.#worker;
    const worker = await started;
    if (this.#worker !== started) throw { code: "cancelled" };
    const id = ++last;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, told });
      worker.postMessage({ id, task, ...given });
    });
  }

  // Ends the work at once; whoever waits for it is told why.
  stop(reason = { code: "cancelled" }) {
    const worker = this.#worker;
    this.#worker = undefined;
    worker?.then((each) => each.terminate());
    for (const { reject } of this.#waiting.values()) reject(reason);
    this.#waiting.clear();
  }

  // Has a worker at hand before it is needed.
  warm() {
    this.#worker ??= this.#start();
    // Whoever asks it is told.
    this.#worker.catch(() => {});
  }

  #heard({ id, answer, failure, done, total }) {
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    if (total !== undefined) return waiting.told(done, total);
    this.#waiting.delete(id);
    if (!failure) return waiting.resolve(answer);
    // After a fault its memory is not to be trusted.
    if (failure.fatal) this.stop(failure);
    waiting.reject(failure);
  }
}

export const questions = new Engine();
export const runs = new Engine();
