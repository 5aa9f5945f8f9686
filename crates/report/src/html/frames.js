// Plays the frames of a rough film. The first frame stands in the page without it.
"use strict";
(() => {
  const source = document.getElementById("frames");
  if (!source) return;
  const { x, frames } = JSON.parse(source.textContent);
  const part = (name) => document.querySelector(`[data-player="${name}"]`);
  const slider = part("frame"), button = part("play"), travel = part("travel");
  const curves = [part("curve0"), part("curve1")];
  const line = (ys) => ys.map((y, k) => `${k ? "L" : "M"}${x[k]} ${y}`).join("");

  function show(number) {
    const frame = frames[number];
    curves.forEach((curve, k) => curve.setAttribute("d", line(frame.y[k])));
    travel.textContent = frame.t;
    slider.value = String(number);
  }

  let timer = null;
  function stop() {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  }
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    button.textContent = "Pause";
    timer = setInterval(() => show((Number(slider.value) + 1) % frames.length), 80);
  });
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
})();
