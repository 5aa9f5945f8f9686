"use strict";
// Button and slider of a picture that moves. `show` draws a step; Play goes on by `stride` steps every `wait` ms and
// begins anew at the end.
function player(button, slider, show, wait, stride = 1) {
  let timer = null;
  const stop = () => {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  };
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    button.textContent = "Pause";
    timer = setInterval(() => show((Number(slider.value) + stride) % (Number(slider.max) + 1)), wait);
  });
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
}

