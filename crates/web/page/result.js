// The result of a run or the reason why there is none.
import { labelOf } from "./form.js";

const element = (id) => document.getElementById(id);
const KINDS = { html: "text/html", json: "application/json", csv: "text/csv", toml: "application/toml" };

let shown = [];
let watching;

// A link to a file in memory.
function link(name, content) {
  const ending = name.split(".").pop();
  const place = URL.createObjectURL(new Blob([content], { type: `${KINDS[ending] ?? "text/plain"};charset=utf-8` }));
  shown.push(place);
  const a = document.createElement("a");
  a.href = place;
  a.download = name;
  a.textContent = name;
  return a;
}

// The frame is as high as the report in it, so that there is one bar to scroll by.
function grow(frame) {
  watching?.disconnect();
  const page = frame.contentDocument?.documentElement;
  if (!page) return;
  const fit = () => {
    const height = Math.ceil(page.getBoundingClientRect().height) + 4;
    if (Math.abs(frame.clientHeight - height) > 2) frame.style.height = `${height}px`;
  };
  watching = new ResizeObserver(fit);
  watching.observe(page);
  fit();
}

function node(name, text, className) {
  const each = document.createElement(name);
  if (text) each.textContent = text;
  if (className) each.className = className;
  return each;
}

// A part of the headline: a value, or rows of names and values.
function tile({ name, value, rows, note }) {
  const box = node("div");
  const content = node("dd", value);
  if (rows.length) {
    const table = content.appendChild(node("table"));
    for (const [of, what] of rows) table.insertRow().append(node("th", of), node("td", what));
  }
  box.append(node("dt", name), content);
  if (note) box.append(node("dd", note, "hint"));
  return box;
}

// What the result was computed of, in words.
function inputsOf(result) {
  const { operation, surface } = result.inputs;
  const bare = (name) => name?.split(/[/\\]/).pop();
  const files = [bare(surface.pinion?.file), bare(surface.wheel?.file)].filter(Boolean);
  const traces = files.length ? `, ${files.join(" and ")}` : "";
  const temperature = operation.bulk_temperature ?? operation.oil_temperature ?? operation.temperature;
  return `${operation.torque}, ${operation.speed}, ${temperature}${traces}`;
}

function showBoth(versus) {
  const changed = versus?.inputs.length || (versus?.verdict && !versus.verdict.includes("exactly"));
  element("versus").hidden = !changed;
  if (!changed) return;
  element("verdict").textContent = versus.verdict && `${versus.verdict}.`;
  const table = element("both");
  table.replaceChildren();
  const head = table.createTHead().insertRow();
  head.append(...["", "A", "B", "B minus A"].map((name) => node("th", name)));
  const body = table.createTBody();
  const inputs = versus.inputs.map(([key, a, b]) => [labelOf(key), a, b, ""]);
  for (const [name, ...values] of [...versus.rows, ...inputs]) {
    const first = node("th", name);
    first.scope = "row";
    body.insertRow().append(first, ...values.map((value) => node("td", value)));
  }
}

// Marks the result as one of other inputs.
export function setStale(is) {
  element("stale").hidden = !is;
  element("found").classList.toggle("stale", is);
  element("report").tabIndex = is ? -1 : 0;
}

export function showResult(found, given) {
  for (const place of shown) URL.revokeObjectURL(place);
  shown = [];
  document.title = `${found.title} - Asperity`;
  element("welcome").hidden = true;
  element("result").hidden = false;
  element("title").textContent = found.title;
  const result = JSON.parse(new TextDecoder().decode(found.files["result.json"]));
  element("time").textContent = `Computed in ${found.seconds.toFixed(2)} s on this machine for ${inputsOf(result)}.`;
  element("tiles").replaceChildren(...found.tiles.map(tile));
  showBoth(found.versus);
  element("summary").textContent = found.summary;
  const names = Object.keys(found.files);
  const links = [link(given.name, given.text), ...names.map((name) => link(name, found.files[name]))];
  element("files").replaceChildren("Save: ", ...links);
  const report = element("report");
  report.onload = () => grow(report);
  report.srcdoc = new TextDecoder().decode(found.files["report.html"]);
  const { top } = element("main").getBoundingClientRect();
  if (top < 0 || top > innerHeight / 2) element("main").scrollIntoView({ block: "start" });
}

export function clearError() {
  element("error").hidden = true;
  for (const each of document.querySelectorAll("[aria-invalid]")) each.removeAttribute("aria-invalid");
}

function paragraph(...parts) {
  const p = document.createElement("p");
  p.append(...parts);
  return p;
}

// Shows an error with its code, its place and help; `field` is what it is about.
export function showError(failure, text, field) {
  const box = element("error");
  const code = document.createElement("strong");
  code.textContent = failure.code ?? "Error";
  const parts = [paragraph(code, ` ${failure.message ?? failure}`)];
  if (failure.help) parts.push(paragraph(`Help: ${failure.help}`));
  const acts = paragraph();
  if (field && !field.closest(":disabled, [inert]")) {
    field.setAttribute("aria-invalid", "true");
    acts.append(button("Go to the field", () => field.focus()), " ");
  }
  if (failure.place?.span) acts.append(button(`Show line ${failure.place.line}`, () => select(text, failure.place.span)));
  if (acts.childNodes.length) parts.push(acts);
  box.replaceChildren(...parts);
  box.hidden = false;
  box.scrollIntoView({ block: "nearest" });
}

function button(name, act) {
  const each = document.createElement("button");
  each.type = "button";
  each.textContent = name;
  each.addEventListener("click", act);
  return each;
}

// Selects a range of bytes in the text of the case.
function select(text, span) {
  const bytes = new TextEncoder().encode(text.value);
  const characters = (end) => new TextDecoder().decode(bytes.subarray(0, end)).length;
  text.closest("details").open = true;
  text.focus();
  text.setSelectionRange(characters(span.start), characters(span.end));
  const line = text.value.slice(0, characters(span.start)).split("\n").length;
  text.scrollTop = (line - 4) * (text.scrollHeight / text.value.split("\n").length);
}
