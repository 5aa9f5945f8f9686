// The result of a run or the reason why there is none.
import { filesOf, labelOf } from "./form.js";

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
  a.download = name.replaceAll("/", "_");
  a.dataset.name = name;
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

// What the result was computed of, in words.
function inputsOf({ operation, mesh, surface }) {
  const files = filesOf([surface, mesh]).map((name) => name.split(/[/\\]/).pop());
  const traces = files.length ? `, ${files.join(" and ")}` : "";
  const temperature = operation.bulk_temperature ?? operation.oil_temperature;
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

const REPORT = "report.html";

// The report in its frame; a gear train has one of the whole and one of each mesh.
function showReports(files) {
  const reports = Object.keys(files).filter((name) => name.endsWith(REPORT));
  const frame = element("report");
  const choice = element("reports");
  const folder = (name) => name.slice(0, name.lastIndexOf("/") + 1);
  const title = (name) => JSON.parse(new TextDecoder().decode(files[`${folder(name)}result.json`])).title.split(": ").pop();
  const show = (name) => {
    for (const each of choice.children) each.setAttribute("aria-pressed", each.dataset.name === name);
    for (const each of element("files").children) each.hidden = files[each.dataset.name] && folder(each.dataset.name) !== folder(name);
    frame.onload = () => {
      grow(frame);
      // Links of a report are files of its folder, which are in memory.
      for (const a of frame.contentDocument.querySelectorAll("a[href]")) {
        const target = folder(name) + a.getAttribute("href");
        if (!files[target]) continue;
        a.addEventListener("click", (event) => {
          event.preventDefault();
          if (target.endsWith(REPORT)) show(target);
          else [...element("files").children].find((each) => each.dataset.name === target)?.click();
        });
      }
    };
    frame.srcdoc = new TextDecoder().decode(files[name]);
  };
  const drawn = new Promise((resolve) => frame.addEventListener("load", resolve, { once: true }));
  choice.hidden = reports.length < 2;
  choice.replaceChildren(...reports.map((name) => {
    const each = button(name === REPORT ? "Whole gearbox" : `Mesh ${title(name)}`, () => show(name));
    each.dataset.name = name;
    return each;
  }));
  show(REPORT);
  return drawn;
}

// Marks the result as one of other inputs.
export function setStale(is) {
  element("stale").hidden = !is;
  element("found").classList.toggle("stale", is);
  element("report").tabIndex = is ? -1 : 0;
}

// Shows a result; done when its report is drawn.
export function showResult(found, given) {
  for (const place of shown) URL.revokeObjectURL(place);
  shown = [];
  document.title = `${found.title} - Asperity`;
  element("welcome").hidden = true;
  element("result").hidden = false;
  element("title").textContent = found.title;
  element("time").textContent = `Computed in ${found.seconds.toFixed(2)} s on this machine for ${inputsOf(found.inputs)}.`;
  showBoth(found.versus);
  element("summary").textContent = found.summary;
  const names = Object.keys(found.files);
  const links = [link(given.name, given.text), ...names.map((name) => link(name, found.files[name]))];
  element("files").replaceChildren("Save: ", ...links);
  const drawn = showReports(found.files);
  const { top } = element("main").getBoundingClientRect();
  if (top < 0 || top > innerHeight / 2) element("main").scrollIntoView({ block: "start" });
  return drawn;
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
