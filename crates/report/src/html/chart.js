// Zoom, read-off and saving of the charts of the page. Every chart is complete without it.
"use strict";
(() => {
  const raised = (n) => (n < 0 ? "⁻" : "") + String(Math.abs(n)).replace(/\d/g, (d) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[d]);
  const minus = (text) => text.replace(/-/g, "−");
  const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
  const digits = (v) => (v === null || !isFinite(v) ? "–" : minus(String(Number(v.toPrecision(5)))));

  // Where a value stands on an axis: 0 at its low end, 1 at its high end; and back.
  const share = (axis, v) => axis.scale === "log"
    ? Math.log(v / axis.low) / Math.log(axis.high / axis.low)
    : (v - axis.low) / (axis.high - axis.low);
  const value = (axis, s) => axis.scale === "log"
    ? axis.low * Math.pow(axis.high / axis.low, s)
    : axis.low + s * (axis.high - axis.low);

  function ticks(axis, wanted) {
    if (axis.scale === "log") {
      const a = Math.ceil(Math.log10(axis.low) - 1e-9), b = Math.floor(Math.log10(axis.high) + 1e-9);
      if (b - a < 1) {
        return [0, 0.25, 0.5, 0.75, 1].map((s) => value(axis, s)).map((v) => [v, minus(v.toPrecision(3))]);
      }
      const stride = Math.max(1, Math.ceil((b - a + 1) / wanted)), found = [];
      for (let k = a; k <= b; k += stride) found.push([Math.pow(10, k), "10" + raised(k)]);
      return found;
    }
    const raw = (axis.high - axis.low) / wanted, power = Math.pow(10, Math.floor(Math.log10(raw)));
    const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= raw * (1 - 1e-9));
    const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), found = [];
    for (let k = Math.ceil(axis.low / step - 1e-9); k <= axis.high / step + 1e-9; k += 1) {
      const v = k === 0 ? 0 : k * step;
      found.push([v, Math.abs(v) >= 1e6 ? v.toExponential(1) : minus(v.toFixed(places))]);
    }
    return found;
  }

  class Chart {
    constructor(figure) {
      this.figure = figure;
      this.svg = figure.querySelector("svg.chart");
      this.data = JSON.parse(figure.querySelector("script").textContent);
      // Equal values of a field are counted.
      if (this.data.values) this.data.values = this.data.values.flatMap((v) => (Array.isArray(v) ? Array(v[1]).fill(v[0]) : [v]));
      this.read = document.createElement("output");
      this.read.className = "read";
      figure.append(this.read);
      [this.left, this.top, this.right, this.bottom] = this.data.box;
      [this.beside, this.base, this.below] = this.data.ticks;
      this.x = { ...this.data.x };
      this.y = { ...this.data.y };
      this.original = new Map();
      for (const part of [".ticks", ".marks", ".curves"]) {
        const group = this.svg.querySelector(part);
        if (group) this.original.set(group, group.innerHTML);
      }
      this.svg.insertAdjacentHTML("beforeend", '<g class="overlay" pointer-events="none"></g>');
      this.overlay = this.svg.lastElementChild;
      this.reset = document.createElement("button");
      this.reset.type = "button";
      this.reset.className = "reset";
      this.reset.hidden = true;
      this.reset.textContent = "reset zoom";
      this.reset.setAttribute("aria-label", "Show the whole chart: " + this.svg.getAttribute("aria-label"));
      this.figure.append(this.reset);
      this.reset.addEventListener("click", () => this.whole());
      this.svg.setAttribute("tabindex", "0");
      this.svg.setAttribute("aria-roledescription",
        "chart; drag to zoom, arrow keys read off, plus and minus zoom, Escape shows the whole");
      this.svg.addEventListener("pointerdown", (e) => this.down(e));
      this.svg.addEventListener("pointermove", (e) => this.move(e));
      this.svg.addEventListener("pointerup", (e) => this.up(e));
      this.svg.addEventListener("pointercancel", () => { this.from = null; this.overlay.innerHTML = ""; });
      this.svg.addEventListener("pointerleave", () => { if (!this.from) this.hide(); });
      this.svg.addEventListener("dblclick", () => this.whole());
      this.svg.addEventListener("wheel", (e) => this.wheel(e), { passive: false });
      this.svg.addEventListener("keydown", (e) => this.key(e));
      this.svg.addEventListener("blur", () => this.hide());
      if (this.data.x.shared) document.addEventListener("along", (e) => { if (e.detail !== this.cursor) this.follow(e.detail); });
    }

    px(v) { return this.left + share(this.x, v) * (this.right - this.left); }
    py(v) {
      const s = share(this.y, v);
      return this.data.y.downward ? this.top + s * (this.bottom - this.top) : this.bottom - s * (this.bottom - this.top);
    }
    // Pointer to units of the drawing, kept inside the box.
    place(event) {
      const box = this.svg.getBoundingClientRect(), scale = this.data.width / box.width;
      const inside = (v, a, b) => Math.min(Math.max(v, a), b);
      return [inside((event.clientX - box.left) * scale, this.left, this.right),
        inside((event.clientY - box.top) * scale, this.top, this.bottom)];
    }
    shareX(px) { return (px - this.left) / (this.right - this.left); }
    shareY(py) {
      const down = (py - this.top) / (this.bottom - this.top);
      return this.data.y.downward ? down : 1 - down;
    }

    down(event) {
      if (event.button !== 0) return;
      this.from = this.place(event);
      try { this.svg.setPointerCapture(event.pointerId); } catch (_) { /* a pointer that is gone */ }
    }
    move(event) {
      const [px, py] = this.place(event);
      if (this.from) {
        const x = Math.min(px, this.from[0]), w = Math.abs(px - this.from[0]);
        this.overlay.innerHTML =
          `<rect class="frame-zoom" x="${x}" y="${this.top}" width="${w}" height="${this.bottom - this.top}"/>`;
      } else {
        this.show(value(this.x, this.shareX(px)), value(this.y, this.shareY(py)));
      }
    }
    up(event) {
      if (!this.from) return;
      const [px] = this.place(event), a = Math.min(px, this.from[0]), b = Math.max(px, this.from[0]);
      this.from = null;
      this.overlay.innerHTML = "";
      if (b - a > 6) this.zoom(value(this.x, this.shareX(a)), value(this.x, this.shareX(b)));
    }
    wheel(event) {
      // A page scrolls under the pointer; only a chart that was chosen, or Ctrl, zooms.
      if (document.activeElement !== this.svg && !event.ctrlKey) return;
      event.preventDefault();
      this.about(this.shareX(this.place(event)[0]), event.deltaY < 0 ? 0.8 : 1.25);
    }
    key(event) {
      const steps = { ArrowLeft: -1, ArrowRight: 1 };
      if (event.key in steps && event.shiftKey) this.about(0.5, 1, 0.1 * steps[event.key]);
      else if (event.key in steps) this.step(steps[event.key]);
      else if (event.key === "+" || event.key === "=") this.about(this.cursorShare(), 0.7);
      else if (event.key === "-") this.about(this.cursorShare(), 1 / 0.7);
      else if (event.key === "Escape" || event.key === "0" || event.key === "Home") this.whole();
      else return;
      event.preventDefault();
    }
    cursorShare() {
      const s = this.cursor === undefined ? 0.5 : share(this.x, this.cursor);
      return s >= 0 && s <= 1 ? s : 0.5;
    }
    step(by) {
      const xs = this.places();
      if (!xs.length) return;
      const now = this.cursor === undefined ? value(this.x, 0.5) : this.cursor;
      let at = xs.findIndex((x) => x >= now);
      if (at < 0) at = xs.length - 1;
      // One point at a time where few are seen, a hundredth of what is seen where many are.
      const seen = xs.filter((x) => x >= this.x.low && x <= this.x.high).length;
      at = Math.min(Math.max(at + by * Math.max(1, Math.round(seen / 100)), 0), xs.length - 1);
      this.show(xs[at], value(this.y, 0.5));
    }
    places() {
      if (this.data.kind === "contour") return this.data.columns;
      const first = this.data.series[0];
      const flat = first ? first.told || first.points : [];
      return flat.filter((v, i) => i % 2 === 0 && v !== null).sort((a, b) => a - b);
    }

    about(at, factor, shift = 0) {
      this.zoom(value(this.x, at - at * factor + shift), value(this.x, at + (1 - at) * factor + shift));
    }
    zoom(low, high) {
      const whole = this.data.x;
      const span = share(whole, high) - share(whole, low);
      if (!(span > 1e-4)) return;
      if (span >= 0.999) { this.whole(); return; }
      let a = share(whole, low), b = share(whole, high);
      if (a < 0) { b -= a; a = 0; }
      if (b > 1) { a -= b - 1; b = 1; }
      this.x = { ...whole, low: value(whole, Math.max(a, 0)), high: value(whole, Math.min(b, 1)) };
      this.fitY();
      this.draw();
      this.reset.hidden = false;
    }
    whole() {
      this.x = { ...this.data.x };
      this.y = { ...this.data.y };
      for (const [group, markup] of this.original) group.innerHTML = markup;
      const field = this.svg.querySelector(".field");
      if (field) field.removeAttribute("transform");
      this.overlay.innerHTML = "";
      this.reset.hidden = true;
    }
    // The heights that are seen fill the box; zero stays where the chart must show it.
    fitY() {
      if (this.data.kind === "contour") return;
      // A log axis keeps its decades.
      const log = this.data.y.scale === "log";
      let low = Infinity, high = -Infinity;
      const see = (v) => { low = Math.min(low, v); high = Math.max(high, v); };
      for (const series of this.data.series) {
        const p = series.points;
        for (let i = 0; i < p.length; i += 2) {
          if (p[i] === null || p[i + 1] === null) continue;
          if (p[i] >= this.x.low && p[i] <= this.x.high) see(p[i + 1]);
          // Where a line enters or leaves what is seen.
          if (!series.joined || i < 2 || p[i - 2] === null || p[i - 1] === null) continue;
          for (const edge of [this.x.low, this.x.high]) {
            if ((p[i - 2] < edge) !== (p[i] < edge)) {
              see(p[i - 1] + (edge - p[i - 2]) / (p[i] - p[i - 2]) * (p[i + 1] - p[i - 1]));
            }
          }
        }
      }
      if (low > high || log) { this.y = { ...this.data.y }; return; }
      if (this.data.y.zero) { low = Math.min(low, 0); high = Math.max(high, 0); }
      const air = 0.04 * (high - low) || 1, edge = (v) => this.data.y.zero && Math.abs(v) < 1e-9 * air;
      this.y = { ...this.data.y, low: edge(low) ? 0 : low - air, high: edge(high) ? 0 : high + air };
    }

    draw() {
      let text = "";
      for (const [v, label] of ticks(this.x, 6)) {
        const x = this.px(v).toFixed(1);
        text += `<line class="grid" x1="${x}" y1="${this.top}" x2="${x}" y2="${this.bottom}"/>` +
          `<text class="tick" x="${x}" y="${this.bottom + this.below}" text-anchor="middle">${label}</text>`;
      }
      for (const [v, label] of ticks(this.y, 5)) {
        const y = this.py(v).toFixed(1);
        text += `<line class="grid" x1="${this.left}" y1="${y}" x2="${this.right}" y2="${y}"/>` +
          `<text class="tick" x="${this.left - this.beside}" y="${Number(y) + this.base}" text-anchor="end">${label}</text>`;
      }
      this.svg.querySelector(".ticks").innerHTML = text;
      if (this.data.kind === "contour") this.moveField();
      else this.drawCurves();
    }
    moveField() {
      const field = this.svg.querySelector(".field"), width = this.right - this.left;
      const factor = 1 / (share(this.data.x, this.x.high) - share(this.data.x, this.x.low));
      const shift = this.left - factor * (this.left + share(this.data.x, this.x.low) * width);
      field.setAttribute("transform", `translate(${shift} 0) scale(${factor} 1)`);
    }
    drawCurves() {
      const paths = this.svg.querySelectorAll(".curves path");
      this.data.series.forEach((series, k) => paths[k].setAttribute("d", this.outline(series)));
      let text = "";
      for (const [at, label] of this.data.marks) {
        if (at < this.x.low || at > this.x.high) continue;
        const x = this.px(at).toFixed(1);
        text += `<line class="mark" x1="${x}" y1="${this.top}" x2="${x}" y2="${this.bottom}"/>` +
          `<text class="letter" x="${x}" y="${this.top - 5}" text-anchor="middle">${escaped(label)}</text>`;
      }
      for (const [at, label] of this.data.levels) {
        if (at < this.y.low || at > this.y.high) continue;
        const y = this.py(at);
        text += `<line class="level" x1="${this.left}" y1="${y}" x2="${this.right}" y2="${y}"/>` +
          `<text class="letter" x="${this.right - 6}" y="${y - this.top < 18 ? y + 14 : y - 5}" text-anchor="end">${escaped(label)}</text>`;
      }
      this.svg.querySelector(".marks").innerHTML = text;
    }
    outline(series) {
      let d = "", dots = "", joined = false;
      const p = series.points;
      for (let i = 0; i < p.length; i += 2) {
        const x = p[i] === null ? NaN : this.px(p[i]), y = p[i + 1] === null ? NaN : this.py(p[i + 1]);
        if (!isFinite(x) || !isFinite(y)) { joined = false; continue; }
        const at = `${x.toFixed(2)} ${y.toFixed(2)}`;
        if (series.joined) d += (joined ? "L" : "M") + at;
        const r = series.radius;
        if (r > 0) dots += `M${(x - r).toFixed(2)} ${y.toFixed(2)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
        joined = true;
      }
      return (series.filled && d ? d + "Z" : d) + dots;
    }

    // Moves the cursor to x, where another chart of the page has its own.
    follow(x) {
      this.cursor = x;
      this.read.textContent = "";
      this.point(x, []);
    }
    // Reads off the points nearest to x (and y, in a field).
    show(x, y) {
      this.cursor = x;
      if (this.data.x.shared) document.dispatchEvent(new CustomEvent("along", { detail: x }));
      this.tell(x, y);
      // The text stands beside the cursor and moves nothing.
      const figure = this.figure.getBoundingClientRect(), box = this.svg.getBoundingClientRect(), scale = box.width / this.data.width;
      const at = box.left - figure.left + scale * this.px(x);
      const free = figure.width - this.read.offsetWidth;
      const left = at + 12 > free ? at - 12 - this.read.offsetWidth : at + 12;
      this.read.style.left = `${Math.max(0, Math.min(left, free))}px`;
      this.read.style.top = `${box.top - figure.top + scale * this.top + 6}px`;
    }
    tell(x, y) {
      if (this.data.kind === "contour") {
        const near = (list, v) => list.reduce((best, w, k) => (Math.abs(w - v) < Math.abs(list[best] - v) ? k : best), 0);
        const i = near(this.data.columns, x), j = near(this.data.rows, y);
        const found = this.data.values[j * this.data.columns.length + i];
        this.point(this.data.columns[i], [this.data.rows[j]]);
        this.read.textContent = `${this.data.x.label} ${digits(this.data.columns[i])} ${this.data.x.unit}, ${this.data.y.label} ${digits(this.data.rows[j])} ${this.data.y.unit}: ${digits(found)} (${this.data.value})`;
        return;
      }
      const found = [];
      let at = null;
      for (const series of this.data.series) {
        const p = series.told || series.points;
        let best = -1;
        for (let i = 0; i < p.length; i += 2) {
          if (p[i] === null || p[i + 1] === null) continue;
          if (best < 0 || Math.abs(p[i] - x) < Math.abs(p[best] - x)) best = i;
        }
        if (best < 0) continue;
        if (at === null) at = p[best];
        found.push([series.unit ? "" : series.name, p[best + 1], series.filled ? null : p[best + 1], series.unit]);
      }
      if (at === null) return;
      this.point(at, found.map((f) => f[2]).filter((y) => y !== null));
      const [across, unit] = [this.data.x.unit, this.data.y.unit].map((u) => (u ? " " + u : ""));
      this.read.textContent = `${digits(at)}${across}: ` +
        found.map((f) => (found.length > 1 && f[0] ? f[0] + " " : "") + digits(f[1]) + (f[3] ? " " + f[3] : unit)).join(", ");
    }
    point(x, ys) {
      const px = this.px(x);
      this.overlay.innerHTML = px < this.left - 1 || px > this.right + 1 ? "" :
        `<line class="cursor" x1="${px}" y1="${this.top}" x2="${px}" y2="${this.bottom}"/>` +
        ys.map((y) => this.py(y)).filter((y) => y >= this.top && y <= this.bottom)
          .map((y) => `<circle class="spot" cx="${px}" cy="${y}" r="3"/>`).join("");
    }
    hide() {
      this.read.textContent = "";
      if (!this.data.x.shared) this.overlay.innerHTML = "";
    }
  }

  // Styles as attributes: a saved drawing looks the same in programs that know no style sheets.
  const STYLES = ["fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray", "stroke-linejoin",
    "font-family", "font-size", "font-weight", "paint-order", "vector-effect", "visibility"];
  function inlined(from, to) {
    const style = getComputedStyle(from), above = from.parentElement ? getComputedStyle(from.parentElement) : {};
    for (const name of STYLES) {
      const value = style.getPropertyValue(name);
      const inherited = to.parentElement && !["vector-effect"].includes(name) && value === (above.getPropertyValue?.(name) ?? "");
      if (value && !inherited) to.setAttribute(name, value);
    }
    [...from.children].forEach((child, k) => inlined(child, to.children[k]));
  }

  // The drawing of a figure as a file of its own, with its title and legend.
  function drawing(figure) {
    const SVG = "http://www.w3.org/2000/svg", ROW = 20;
    const svg = figure.querySelector("svg.chart"), copy = svg.cloneNode(true);
    inlined(svg, copy);
    for (const part of [...copy.querySelectorAll(".overlay, script")]) part.remove();
    const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
    const colour = getComputedStyle(svg).getPropertyValue("--paper"), ink = getComputedStyle(figure).color;
    const add = (name, attributes, text = "") => {
      const part = document.createElementNS(SVG, name);
      for (const [key, value] of Object.entries(attributes)) part.setAttribute(key, value);
      part.textContent = text;
      copy.insertBefore(part, copy.firstChild);
      return part;
    };
    const pen = document.createElement("canvas").getContext("2d");
    const font = getComputedStyle(svg).fontFamily;
    const wide = (text, size, weight = "") => { pen.font = `${weight} ${size}px ${font}`; return pen.measureText(text).width; };
    const rows = [];
    let line = "";
    for (const word of figure.querySelector("figcaption").textContent.trim().split(/\s+/)) {
      if (line && wide(`${line} ${word}`, 14, "600") > width - 20) { rows.push(line); line = word; } else line = line ? `${line} ${word}` : word;
    }
    rows.push(line);
    let top = -ROW * rows.length, x = 10, legend = 0;
    const samples = [...figure.querySelectorAll(".legend li")].map((item) => {
      const text = item.textContent.trim(), needs = 50 + wide(text, 12);
      if (x > 10 && x + needs > width) { x = 10; legend += 1; }
      const place = { item, text, x, row: legend };
      x += needs;
      return place;
    });
    const under = samples.length ? ROW * (legend + 1) : 0;
    top -= under + 8;
    for (const { item, text, x, row } of samples) {
      const y = -under + ROW * row, sample = item.querySelector("svg").cloneNode(true);
      inlined(item.querySelector("svg"), sample);
      for (const [key, value] of Object.entries({ x, y, width: 28, height: 12 })) sample.setAttribute(key, value);
      copy.insertBefore(sample, copy.firstChild);
      add("text", { x: x + 34, y: y + 10, fill: ink, "font-size": 12 }, text);
    }
    rows.forEach((text, k) => add("text", { x: 10, y: top + 8 + ROW * k + 12, fill: ink, "font-size": 14, "font-weight": 600 }, text));
    add("rect", { x: 0, y: top, width, height: height - top, fill: colour });
    copy.setAttribute("xmlns", SVG);
    copy.setAttribute("viewBox", `0 ${top} ${width} ${height - top}`);
    copy.setAttribute("width", width);
    copy.setAttribute("height", height - top);
    return new XMLSerializer().serializeToString(copy);
  }

  function download(name, href) {
    const link = document.createElement("a");
    link.download = name;
    link.href = href;
    link.click();
  }
  function save(figure, kind) {
    const text = drawing(figure), name = `${figure.id || "chart"}.${kind}`;
    const href = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text);
    if (kind === "svg") { download(name, href); return; }
    const image = new Image(), SCALE = 3;
    image.onload = () => {
      const canvas = document.createElement("canvas");
      canvas.width = SCALE * image.width;
      canvas.height = SCALE * image.height;
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      download(name, canvas.toDataURL("image/png"));
    };
    image.src = href;
  }
  for (const figure of document.querySelectorAll("figure")) {
    const row = figure.querySelector(".under:last-of-type");
    if (!row || !figure.querySelector("svg.chart")) continue;
    const buttons = document.createElement("span");
    buttons.className = "save";
    for (const kind of ["svg", "png"]) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = kind.toUpperCase();
      button.setAttribute("aria-label", `Save as ${kind.toUpperCase()}: ${figure.querySelector("figcaption").textContent}`);
      button.addEventListener("click", () => save(figure, kind));
      buttons.append(button);
    }
    row.append(buttons);
  }

  for (const figure of document.querySelectorAll("figure.zoomable")) new Chart(figure);

  // Tables that are wider than the page scroll by keyboard.
  const labels = new Map();
  for (const table of document.querySelectorAll(".scroll, pre")) {
    let heading = table;
    while (heading && !/^H[23]$|SUMMARY/.test(heading.tagName)) heading = heading.previousElementSibling || heading.parentElement;
    table.setAttribute("tabindex", "0");
    table.setAttribute("role", "region");
    const name = `Table: ${heading ? heading.textContent.trim() : document.title}`, count = (labels.get(name) || 0) + 1;
    labels.set(name, count);
    table.setAttribute("aria-label", count > 1 ? `${name}, ${count}` : name);
  }

  // Folded parts are open on paper, and where a link leads into them.
  const folded = [...document.querySelectorAll("details")];
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = folded.filter((part) => !part.open);
    for (const part of opened) part.open = true;
  });
  addEventListener("afterprint", () => { for (const part of opened) part.open = false; });
  const lead = () => {
    const target = location.hash.length > 1 && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (let part = target && (target.querySelector(":scope > details") || target); part; part = part.parentElement) {
      if (part.tagName === "DETAILS") part.open = true;
    }
    if (target) target.scrollIntoView();
  };
  addEventListener("hashchange", lead);
  lead();

  // The day on which the file was written, and links that lead somewhere only beside the files of the result.
  const written = document.querySelector(".written"), day = new Date(document.lastModified);
  if (written && day > 0) written.textContent = ` · written ${day.toLocaleDateString("sv")}`;
  if (!/^(file|https?):$/.test(location.protocol)) {
    for (const link of document.querySelectorAll(".source a")) link.removeAttribute("href");
  }
})();
