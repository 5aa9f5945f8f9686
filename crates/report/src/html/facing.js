// Shows the contact at the position of the slider. The first one stands in the page without it.
"use strict";
for (const figure of document.querySelectorAll("figure.facing")) {
  const { ellipse, top, bottom, frames } = JSON.parse(figure.querySelector("script").textContent);
  const label = figure.querySelector(".slider");
  if (!label) continue;
  const slider = label.querySelector("input"), told = figure.querySelector(".told");
  const part = (name) => figure.querySelector(`[data-part="${name}"]`);
  const sums = (steps) => { let sum = 0; return steps.map((step) => (sum += step)); };
  const line = (xs, ys) => xs.map((x, k) => `${k ? "L" : "M"}${x} ${ys[k]}`).join("");

  const show = (number) => {
    const frame = frames[number], x = sums(frame.x), above = sums(frame.upper);
    const lower = line(x, sums(frame.lower)), upper = line(x, above);
    const closed = (y) => `L${x[x.length - 1]} ${y}L${x[0]} ${y}Z`;
    const back = x.map((at, k) => `L${at} ${above[k]}`).reverse().join("");
    const outlines = {
      lower, upper, below: lower + closed(bottom), above: upper + closed(top), film: lower + back + "Z",
      solid: line(x, sums(frame.solid)), fluid: line(x, sums(frame.fluid)), hertz: line(ellipse, frame.hertz),
    };
    for (const [name, d] of Object.entries(outlines)) part(name).setAttribute("d", d);
    part("dot").setAttribute("cx", String(frame.at / 10));
    told.textContent = frame.text;
  };
  slider.addEventListener("input", () => show(Number(slider.value)));
  label.hidden = false;
}
