"use strict";
// Texts are lists of numbers of lines: most lines are those of many pixels.
const data = JSON.parse(document.getElementById("data").textContent);
const canvas = document.getElementById("region"),
  pen = canvas.getContext("2d");
const zoom = Math.max(4, Math.min(32, Math.floor(640 / Math.max(data.width, data.height))));
let at = { x: 0, y: 0 };
canvas.width = data.width * zoom;
canvas.height = data.height * zoom;

function show() {
  data.colors.forEach((color, i) => {
    pen.fillStyle = "#" + color;
    pen.fillRect((i % data.width) * zoom, Math.floor(i / data.width) * zoom, zoom, zoom);
  });
  pen.strokeStyle = "#f0c";
  pen.lineWidth = 2;
  pen.strokeRect(at.x * zoom + 1, at.y * zoom + 1, zoom - 2, zoom - 2);
  const lines = data.pixels[at.y * data.width + at.x];
  document.getElementById("history").textContent = lines.map((i) => data.lines[i]).join("\n");
}
function move(x, y) {
  const within = (value, size) => Math.max(0, Math.min(size - 1, value));
  at = { x: within(x, data.width), y: within(y, data.height) };
  show();
}
canvas.addEventListener("click", (event) => {
  const shown = canvas.clientWidth / data.width; // It may be shrunk.
  move(Math.floor(event.offsetX / shown), Math.floor(event.offsetY / shown));
});
document.addEventListener("keydown", (event) => {
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const step = steps[event.key];
  if (!step) return;
  event.preventDefault();
  move(at.x + step[0], at.y + step[1]);
});
show();
