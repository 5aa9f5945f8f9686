// Zoom and read-off for the charts of the page. Every chart is complete without it.
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
      this.read = figure.querySelector(".read");
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
          `<text class="letter" x="${this.left + 6}" y="${y - this.top < 18 ? y + 14 : y - 5}" text-anchor="start">${escaped(label)}</text>`;
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

    // Reads off the points nearest to x (and y, in a field).
    show(x, y) {
      this.cursor = x;
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
        found.push([series.name, p[best + 1], series.filled ? null : p[best + 1]]);
      }
      if (at === null) return;
      this.point(at, found.map((f) => f[2]).filter((y) => y !== null));
      const [across, unit] = [this.data.x.unit, this.data.y.unit].map((u) => (u ? " " + u : ""));
      this.read.textContent = `${digits(at)}${across}: ` +
        found.map((f) => (found.length > 1 ? f[0] + " " : "") + digits(f[1]) + unit).join(", ");
    }
    point(x, ys) {
      const px = this.px(x);
      this.overlay.innerHTML = px < this.left - 1 || px > this.right + 1 ? "" :
        `<line class="cursor" x1="${px}" y1="${this.top}" x2="${px}" y2="${this.bottom}"/>` +
        ys.map((y) => this.py(y)).filter((y) => y >= this.top && y <= this.bottom)
          .map((y) => `<circle class="spot" cx="${px}" cy="${y}" r="3"/>`).join("");
    }
    hide() { this.overlay.innerHTML = ""; this.read.textContent = ""; }
  }

  for (const figure of document.querySelectorAll("figure.zoomable")) new Chart(figure);
})();
