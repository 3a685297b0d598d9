"use strict";
// Where the time went: the first thing to read.
const MostBars = 200; // More of them are thinner than a pixel, and pale.
const cyclesOf = (run) => figure(run, "total_cycles");

function addSummary() {
  const parent = section("summary");
  section("title").textContent = isPair ? `${runNames[0]} against ${runNames[1]}` : `Run ${runNames[0]}`;
  const frames = first.frames;
  const sizes = new Set(frames.map(({ width, height }) => `${width} × ${height}`));
  const others = sizes.size > 1 ? ` at first, and ${number(sizes.size - 1)} other sizes` : "";
  section("about").textContent =
    `${number(frames.length)} frame${frames.length > 1 ? "s" : ""}, ` +
    `${frames[0].width} × ${frames[0].height} pixels${others}. ffgpu: what the machine did, in its own cycles.`;
  if (!hasTiming) return addNotes(parent, "timing");
  const tiles = parent.querySelector(".tiles");
  const text = parent.querySelector(".sentence");
  const fill = () => {
    tiles.replaceChildren(...tileList());
    text.textContent = runs.map(sentence).join(" ");
  };
  fill();
  onSelect(fill);
  addNotes(parent, "waits");
  if (resources.length > 0) addWaits(parent);
  new ReportChart(parent, {
    title: "Cycles of each frame (a click shows the frame)",
    unit: "cycles",
    x: "frame",
    type: frames.length > MostBars ? "line" : "bar",
    isStacked: !isPair,
    pick: (frame) => select({ frame }),
    compute: frameSeries,
  });
}
function addWaits(parent) {
  new ReportChart(parent, {
    title: "Cycles by what the machine waited for",
    isHorizontal: true,
    unit: "cycles",
    compute: () => ({
      labels: runNames,
      series: waitSeries((counter) => runs.map((run) => figure(run, counter))),
    }),
    show: (value) => number(value),
  });
}
// The parts of a run's cycles, with the values that `of` tells of a counter.
const waitSeries = (of) =>
  resources.map((name) => ({
    name: words(name),
    color: colorOf(resources, name),
    values: of(`bottleneck_${name}_cycles`),
  }));
function frameSeries() {
  const labels = first.frames.map((frame) => frame.frame);
  const whole = (run, i) => ({ name: runNames[i], color: Palette[i], values: run.timing.total_cycles });
  const isWhole = isPair || resources.length === 0;
  return { labels, series: isWhole ? runs.map(whole) : waitSeries((counter) => first.timing[counter]) };
}
function sentence(run, i) {
  const found = resources
    .map((name) => [name, figure(run, `bottleneck_${name}_cycles`)])
    .filter(([, cycles]) => cycles > 0.005 * cyclesOf(run))
    .sort((a, b) => b[1] - a[1])
    .slice(0, 3)
    .map(([name, cycles]) => `${words(name)} (${percent(cycles, cyclesOf(run), 0)})`);
  if (found.length === 0) return "";
  return `${isPair ? runNames[i] : "The machine"} waited for ${found.join(", then ")}.`;
}

// Of the frame shown, or of all.
const selected = (column) => (selection.isAll ? sum(column) : column[selection.frame]);
const millisecondsOf = (run) => selected(run.frames.map((frame) => frame.milliseconds));
const trafficOf = (run) =>
  sum(
    clients.flatMap((name) => ["read", "written"].map((way) => figure(run, `memory_${name}_${way}_bytes`))),
  );
const shareOf = (run, part, whole, digits) => percent(figure(run, part), figure(run, whole), digits);

function tileList() {
  const count = selection.isAll ? first.frames.length : 1;
  const a = selection.isAll ? " a frame" : "";
  const written = (run) => selected(run.functional.fragments_written);
  const aFragment = (run) => (written(run) > 0 ? number(cyclesOf(run) / written(run), 2) : "–");
  const each = (show) => runs.map(show).join(" → ");
  const tile = (text, show) =>
    element("div", { class: "tile" }, element("b", {}, each(show)), element("span", {}, text));
  const rates = each((run) => number((1000 * count) / millisecondsOf(run)));
  const tiles = [
    tile(`cycles${a}`, (run) => short(cyclesOf(run) / count)),
    tile(`ms${a}, ${rates} frames/s`, (run) => number(millisecondsOf(run) / count, 3)),
    tile("cycles a fragment written", aFragment),
    tile(`of memory traffic${a}`, (run) => bytes(trafficOf(run) / count)),
    tile("of the buses' cycles carry data", (run) =>
      shareOf(run, "memory_data_cycles", "memory_bus_cycles", 0),
    ),
    tile("texel-cache hits", (run) => shareOf(run, "texel_cache_hits", "texel_cache_accesses", 1)),
  ];
  if (!isPair) return tiles;
  const [before, after] = runs.map(cyclesOf);
  const change = signed(percent(after - before, before), after - before);
  const changed = element("div", { class: "tile" }, element("b", {}, change), element("span", {}, "cycles"));
  return [changed, ...tiles];
}
