// Moves along the path of contact: turns the gears, shows the contact there, and sets the cursor of every chart over the
// path. Without it the page shows the pitch point and the first contact.
(() => {
  const tell = (s) => document.dispatchEvent(new CustomEvent("along", { detail: s }));
  const follow = (action) => document.addEventListener("along", (e) => action(e.detail));
  const dataOf = (figure) => JSON.parse(figure.querySelector("script").textContent);
  const enabled = (figure) => {
    const label = figure.querySelector(".slider");
    label.hidden = false;
    return label.querySelector("input");
  };

  // The gears, turned so that their flanks touch at s.
  function turn(figure) {
    const { path: [a, e], pitch, turns, along, contacts, step, place } = dataOf(figure);
    const slider = enabled(figure), caption = figure.querySelector(".caption");
    const gears = [...figure.querySelectorAll("[data-gear]")], dots = [...figure.querySelectorAll(".touch")];
    const share = (s) => (s - a) / (e - a);
    follow((s) => {
      gears.forEach((gear, k) => gear.setAttribute("transform", `rotate(${turns[k][0] * (s - pitch)} ${turns[k][1]} ${turns[k][2]})`));
      dots.forEach((dot, k) => {
        const at = s + contacts[k] * step;
        dot.setAttribute("cx", place[0] + along[0] * (at - pitch));
        dot.setAttribute("cy", place[1] + along[1] * (at - pitch));
        dot.setAttribute("visibility", at >= a - 1e-9 && at <= e + 1e-9 ? "visible" : "hidden");
      });
      slider.value = String(Math.round(share(s) * Number(slider.max)));
      caption.textContent = `Contact ${s.toFixed(2)} mm from T₁, ${Math.round(100 * share(s))} % of the way from A to E`;
    });
    const go = (step) => tell(a + (e - a) * step / Number(slider.max));

    // From A to E in 10 s; slowly and in few steps for readers who prefer reduced motion.
    const slow = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const [wait, stride] = slow ? [1000, Number(slider.max) / 10] : [40, 1];
    player(figure.querySelector("button"), slider, go, wait, stride);
    return pitch;
  }

  // The flanks facing each other at the position next to s.
  function show(figure) {
    const { ellipse, top, bottom, frames } = dataOf(figure);
    if (frames.length < 2) return frames[0].s;
    const slider = enabled(figure), caption = figure.querySelector(".caption");
    const part = (name) => figure.querySelector(`[data-part="${name}"]`);
    // Equal steps are counted.
    const sums = (steps) => {
      let sum = 0;
      return steps.flatMap((step) => {
        const [by, times] = Array.isArray(step) ? step : [step, 1];
        return Array.from({ length: times }, () => (sum += by));
      });
    };
    const line = (xs, ys) => xs.map((x, k) => `${k ? "L" : "M"}${x} ${ys[k]}`).join("");
    let shown = Number(slider.value);
    const draw = (frame) => {
      const x = sums(frame.x), above = sums(frame.upper);
      const lower = line(x, sums(frame.lower)), upper = line(x, above);
      const closed = (y) => `L${x[x.length - 1]} ${y}L${x[0]} ${y}Z`;
      const back = x.map((at, k) => `L${at} ${above[k]}`).reverse().join("");
      const outlines = {
        lower, upper, below: lower + closed(bottom), above: upper + closed(top), film: lower + back + "Z",
        solid: line(x, sums(frame.solid)), fluid: line(x, sums(frame.fluid)), hertz: line(ellipse, frame.hertz),
      };
      for (const [name, d] of Object.entries(outlines)) part(name).setAttribute("d", d);
      part("dot").setAttribute("cx", String(frame.at / 10));
      caption.textContent = frame.text;
    };
    const distance = (k, s) => Math.abs(frames[k].s - s);
    follow((s) => {
      const near = frames.reduce((best, _, k) => (distance(k, s) < distance(best, s) ? k : best), 0);
      slider.value = String(near);
      if (near !== shown) draw(frames[shown = near]);
    });
    slider.addEventListener("input", () => tell(frames[Number(slider.value)].s));
    return frames[shown].s;
  }

  // The cursor of charts without data.
  for (const group of document.querySelectorAll("[data-shared]")) {
    const [left, right, low, high, top, bottom] = group.dataset.shared.split(" ").map(Number);
    follow((s) => {
      const x = left + (right - left) * (s - low) / (high - low);
      group.innerHTML = `<line class="cursor" x1="${x}" x2="${x}" y1="${top}" y2="${bottom}"/>`;
    });
  }
  const pitches = [...document.querySelectorAll("figure.mesh")].map(turn);
  const [first] = [...[...document.querySelectorAll("figure.facing")].map(show), ...pitches];
  if (first !== undefined) addEventListener("DOMContentLoaded", () => tell(first));
})();
