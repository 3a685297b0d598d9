"use strict";
// The pictures of the frame shown, a map of it at will, and over it the pixels of the draw picked.
const maps = [...new Set(runs.flatMap((run) => run.pictures.maps))].sort(
  (a, b) => (b === "frame") - (a === "frame") || a.localeCompare(b),
);
const Written = "#ff2fd0",
  Killed = "#ffb000";
let shownMap = maps[0];

// Calls paint(offset, length) for the runs of a letter: "n3w12k1" are pixels of a box, row by row.
function forRuns(runsText, letter, paint) {
  let at = 0;
  for (const [, kind, length] of runsText.matchAll(/([nkw])(\d+)/g)) {
    if (kind === letter) paint(at, Number(length));
    at += Number(length);
  }
}
function boxOf(run, frame, entry) {
  return run.pixels?.[frame]?.[entry] ?? null;
}
function countOf(box, letter) {
  let count = 0;
  forRuns(box[4], letter, (_, length) => {
    count += length;
  });
  return count;
}
function letterAt(box, x, y) {
  const [left, top, width, height, text] = box;
  if (x < left || y < top || x >= left + width || y >= top + height) return "n";
  const wanted = (y - top) * width + x - left;
  let found = "n";
  for (const letter of "kw")
    forRuns(text, letter, (at, length) => {
      if (at <= wanted && wanted < at + length) found = letter;
    });
  return found;
}

class FrameView {
  constructor(parent, run, i) {
    this.run = run;
    this.picture = element("canvas", { class: "picture", role: "img" });
    this.over = element("canvas", {
      class: "over",
      "aria-hidden": "true",
      onclick: (event) => this.pick(event),
    });
    this.legend = element("canvas", { class: "legend", role: "img", hidden: true });
    this.caption = element("figcaption");
    parent.append(
      element(
        "figure",
        {},
        isPair ? element("strong", {}, runNames[i]) : "",
        element("div", { class: "stack" }, this.picture, this.over),
        this.legend,
        this.caption,
      ),
    );
    this.show();
  }

  show() {
    const frame = this.run.frames[selection.frame];
    const entry = this.run.pictures.frames[selection.frame][shownMap];
    this.caption.textContent =
      `Frame ${frame.frame}, ${frame.width} × ${frame.height} pixels` +
      (this.run.timing ? `, ${number(this.run.timing.total_cycles[selection.frame])} cycles` : "") +
      (entry ? "" : ": there is no such picture");
    this.picture.setAttribute("aria-label", `${mapName(shownMap)} of frame ${frame.frame}`);
    for (const canvas of [this.picture, this.over])
      Object.assign(canvas, { width: frame.width, height: frame.height });
    this.legend.hidden = true;
    this.overlay(frame);
    if (!entry) return;
    const wanted = (this.wanted = new Image());
    wanted.onload = () => {
      if (this.wanted === wanted) this.draw(wanted, entry, frame);
    };
    wanted.src = entry.body;
  }

  draw(image, entry, frame) {
    const shrunk = this.run.pictures.shrunk,
      rows = shrunk > 1 ? image.height : frame.height;
    const pen = this.picture.getContext("2d");
    pen.imageSmoothingEnabled = false;
    pen.drawImage(image, 0, 0, image.width, rows, 0, 0, frame.width, frame.height);
    if (shrunk === 1 && image.height > frame.height) return this.drawLegend(image, frame.height);
    if (!entry.legend) return;
    const legend = new Image();
    legend.onload = () => this.drawLegend(legend, 0);
    legend.src = entry.legend;
  }

  drawLegend(image, from) {
    Object.assign(this.legend, { width: image.width, height: image.height - from, hidden: false });
    this.legend.setAttribute("aria-label", `Colours of ${mapName(shownMap)}, from 0 to full scale`);
    this.legend.getContext("2d").drawImage(image, 0, -from);
  }

  overlay(frame) {
    const box = selection.entry === null ? null : boxOf(this.run, selection.frame, selection.entry);
    if (!box) return;
    const [left, top, width, , text] = box,
      pen = this.over.getContext("2d");
    pen.fillStyle = "rgba(0, 0, 0, 0.6)";
    pen.fillRect(0, 0, frame.width, frame.height);
    for (const [letter, color] of [
      ["k", Killed],
      ["w", Written],
    ])
      forRuns(text, letter, (at, length) => {
        for (let x = at % width, y = Math.floor(at / width); length > 0; x = 0, ++y) {
          const part = Math.min(length, width - x);
          pen.clearRect(left + x, top + y, part, 1);
          pen.fillStyle = color + "90";
          pen.fillRect(left + x, top + y, part, 1);
          length -= part;
        }
      });
    pen.strokeStyle = "#fff";
    pen.strokeRect(left - 1.5, top - 1.5, width + 3, box[3] + 3);
  }

  // The last draw that wrote the pixel, or else covered it.
  pick(event) {
    const scale = this.over.width / this.over.clientWidth;
    const x = Math.floor(event.offsetX * scale),
      y = Math.floor(event.offsetY * scale);
    const boxes = this.run.pixels?.[selection.frame] ?? [];
    const last = (letter) => boxes.findLastIndex((box) => box && letterAt(box, x, y) === letter);
    const found = last("w") >= 0 ? last("w") : last("k");
    select({ entry: found >= 0 ? found : null });
  }
}

const MapNames = {
  frame: "the picture",
  heat_overdraw: "overdraw",
  heat_covered: "fragments covered",
  heat_depth_killed: "killed by depth",
  heat_stencil_killed: "killed by stencil",
  heat_alpha_killed: "killed by alpha",
  heat_quad_lanes: "lanes of quads",
  heat_level: "texture level",
  heat_texture: "texture",
  heat_texture_misses: "texel-cache misses",
  heat_cycles: "cycles",
  heat_stall_cause: "stall cause",
  heat_depth_blocks: "bytes of depth blocks",
  heat_color_blocks: "bytes of colour blocks",
};
function mapName(map) {
  return MapNames[map] ?? words((map ?? "no map").replace(/^(heat|view)_/, ""));
}

// The slider, and the buttons beside it.
function frameControls() {
  const most = first.frames.length - 1;
  const slider = element("input", {
    type: "range",
    min: 0,
    max: most,
    value: selection.frame,
    "aria-label": "Frame",
    oninput: () => select({ frame: Number(slider.value) }),
  });
  const step = (name, sign, by) => {
    const onclick = () => select({ frame: Math.min(most, Math.max(0, selection.frame + by)) });
    return element("button", { type: "button", onclick, "aria-label": name }, sign);
  };
  const now = element("output");
  onSelect(() => {
    slider.value = selection.frame;
    now.textContent = `${first.frames[selection.frame].frame}`;
  });
  return controls(step("Frame before", "◀", -1), slider, step("Next frame", "▶", 1), now);
}
function mapChoice(onChange) {
  const box = element("fieldset", {}, element("legend", {}, "Shown"));
  for (const map of maps) {
    const attributes = { type: "radio", name: "map", value: map, checked: map === shownMap };
    const onchange = () => {
      shownMap = map;
      onChange();
    };
    box.append(element("label", {}, element("input", { ...attributes, onchange }), " " + mapName(map)));
  }
  return box;
}
function addFrames() {
  const parent = section("frames");
  const grid = element("div", { class: "runs" });
  const views = runs.map((run, i) => new FrameView(grid, run, i));
  const show = () => views.forEach((view) => view.show());
  parent.append(frameControls(), maps.length > 1 ? mapChoice(show) : "", grid);
  parent.append(
    element(
      "p",
      { class: "keys" },
      keyed(Written, "written by the draw picked"),
      keyed(Killed, "covered, but killed by a test"),
      element("span", {}, "A click on a pixel picks the last draw that wrote it."),
    ),
  );
  addNotes(parent, "pictures");
  addNotes(parent, "pixels");
  onSelect(show);
}
