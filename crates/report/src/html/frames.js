// Plays the frames of a rough film. The first frame stands in the page without it.
(() => {
  const source = document.getElementById("frames");
  if (!source) return;
  const { x, frames } = JSON.parse(source.textContent);
  const part = (name) => document.querySelector(`[data-player="${name}"]`);
  const slider = part("frame"), travel = part("travel");
  const curves = [part("curve0"), part("curve1")];
  const line = (ys) => ys.map((y, k) => `${k ? "L" : "M"}${x[k]} ${y}`).join("");

  function show(number) {
    const frame = frames[number];
    curves.forEach((curve, k) => curve.setAttribute("d", line(frame.y[k])));
    travel.textContent = frame.t;
    slider.value = String(number);
  }

  player(part("play"), slider, show, 80);
})();
