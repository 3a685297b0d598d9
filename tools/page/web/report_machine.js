"use strict";
// The machine's units, its caches and its memory.

// Bars of parts of a whole, in percent: one for each row {label, name, run}. parts: {name, color,
// of(name)}, a counter; whole(name): the counter that they are parts of.
function shareChart(parent, { title, unit, rows, parts, whole, isPercent = true, describe }) {
  const share = (row, counter) =>
    (100 * figure(row.run, counter)) / Math.max(1, figure(row.run, whole(row.name)));
  const compute = () => ({
    labels: rows.map((row) => row.label),
    series: parts.map(({ name, color, of }) => ({
      name,
      color,
      values: rows.map((row) => share(row, of(row.name))),
    })),
  });
  const show = (value) => `${number(value, 2)} %`;
  new ReportChart(parent, { title, unit, isHorizontal: true, isPercent, show, compute, describe });
}
const partsOf = (colors, of) =>
  Object.entries(colors).map(([key, color]) => ({ name: words(key), color, of: of(key) }));

function addUnits() {
  const parent = section("units");
  if (!hasTiming) return addNotes(parent, "timing");
  const rows = byRun(units);
  const busy = ({ label, name, run }) =>
    `${label} ${percent(figure(run, `${name}_busy_cycles`), cyclesOf(run), 0)} busy`;
  shareChart(parent, {
    title: "Each unit: busy, idle (no input), or stalled and on what",
    unit: "% of cycles",
    rows,
    parts: partsOf(AccountColors, (state) => (unit) => `${unit}_${state}_cycles`),
    whole: () => "total_cycles",
    describe: () => rows.map(busy).join(", "),
  });
}

function addCaches() {
  const parent = section("caches");
  const kinds = { compulsory_misses: "#4e79a7", capacity_misses: "#f28e2b", conflict_misses: "#e15759" };
  if (hasTiming)
    shareChart(parent, {
      title: "Misses of each cache, by kind",
      unit: "% of look-ups",
      rows: byRun(caches),
      parts: partsOf(kinds, (kind) => (cache) => `${cache}_${kind}`),
      whole: (cache) => `${cache}_accesses`,
      isPercent: false,
    });
  addCurves(parent);
}

// A line for each number of ways, over the sizes that any of them has.
function curveSeries({ ways, accesses }) {
  const isUsual = (size) => size >= 256 && size <= 4 * 1024 * 1024;
  const all = Object.values(ways).flatMap((points) => points.map(([size]) => size));
  const sizes = [...new Set(all)].filter(isUsual).sort((a, b) => a - b);
  const series = Object.entries(ways).map(([way, points], i) => {
    const misses = new Map(points);
    return {
      color: Palette[i],
      name: way === "full" ? "fully associative" : `${way} way${way > 1 ? "s" : ""}`,
      values: sizes.map((size) => (misses.has(size) ? (100 * misses.get(size)) / accesses : null)),
    };
  });
  return { labels: sizes, series };
}
function addCurves(parent) {
  const curves = runs.flatMap((run, i) =>
    (run.curves ?? []).map((curve) => ({ ...curve, name: curve.name + (isPair ? `, ${runNames[i]}` : "") })),
  );
  if (curves.length > 0) addCurveChart(parent, curves);
  addNotes(parent, "curves");
}
function addCurveChart(parent, curves) {
  let shown = 0;
  const options = curves.map((curve, i) => [i, curve.name]);
  const choose = (value) => {
    shown = Number(value);
    chart.refresh();
  };
  parent.append(controls(choice("Curve", options, choose)));
  const chart = new ReportChart(parent, {
    title: "Misses of LRU caches of all sizes (ffgpu cache)",
    type: "line",
    isStacked: false,
    xType: "logarithmic",
    x: "size of the cache",
    unit: "% of look-ups",
    show: (value) => `${number(value, 2)} %`,
    compute: () => curveSeries(curves[shown]),
    describe: () => curves[shown].name,
  });
}

function addTraffic(parent) {
  const rows = byRun(clients);
  const part = (name, color) => ({
    name,
    color,
    values: rows.map((row) => figure(row.run, `memory_${row.name}_${name}_bytes`)),
  });
  new ReportChart(parent, {
    title: "Bytes by client",
    isHorizontal: true,
    unit: "bytes",
    show: bytes,
    compute: () => ({
      labels: rows.map((row) => row.label),
      series: [part("read", Palette[0]), part("written", Palette[1])],
    }),
  });
}
function addMemory() {
  const parent = section("memory");
  if (!hasTiming) return addNotes(parent, "timing");
  addTraffic(parent);
  const side = element("div", { class: "side" });
  parent.append(side);
  const lost = names("_cycles").filter((name) => name.startsWith("memory_lost_"));
  const buses = ["memory_data", ...lost];
  const busName = (name) => (name === "memory_data" ? "data" : `lost: ${words(name.slice(12))}`);
  shareChart(side, {
    title: "What the memory's buses did",
    unit: "% of the buses' cycles",
    rows: runs.map((run, i) => ({ name: "", run, label: runNames[i] })),
    parts: buses.map((bus, i) => ({ name: busName(bus), color: Palette[i], of: () => `${bus}_cycles` })),
    whole: () => "memory_bus_cycles",
  });
  const ends = { hits: "#59a14f", misses: "#edc948", conflicts: "#e15759" };
  shareChart(side, {
    title: "Rows of the memory: open, none open, another open",
    unit: "% of requests",
    rows: byRun(clients),
    parts: partsOf(ends, (end) => (client) => `memory_${client}_row_${end}`),
    whole: (client) => `memory_${client}_requests`,
  });
  addLatencies(parent);
}
// Histograms are of all frames; place i counts 2^(i-1) to 2^i - 1 cycles.
function addLatencies(parent) {
  const compute = () => {
    const read = (run, name) => run.histograms[`memory_${name}_read_latency`] ?? [];
    const used = clients.filter((name) => runs.some((run) => sum(read(run, name)) > 0));
    const places = Math.max(1, ...used.flatMap((name) => runs.map((run) => read(run, name).length)));
    const labels = Array.from({ length: places }, (_, i) =>
      i === 0 ? "0" : i === 1 ? "1" : `${2 ** (i - 1)}–${2 ** i - 1}`,
    );
    return {
      labels,
      series: used.flatMap((name) =>
        runs.map((run, i) => ({
          color: colorOf(clients, name),
          dash: i === 1 ? [5, 4] : [],
          name: words(name) + (isPair ? `, ${runNames[i]}` : ""),
          values: labels.map(
            (_, place) => (100 * (read(run, name)[place] ?? 0)) / Math.max(1, sum(read(run, name))),
          ),
        })),
      ),
    };
  };
  new ReportChart(parent, {
    title: "Latency of reads by client, all frames",
    type: "line",
    isStacked: false,
    x: "cycles",
    unit: "% of a client's reads",
    show: (value) => `${number(value, 1)} %`,
    compute,
    describe: () => `Clients: ${clients.map(words).join(", ")}`,
  });
}
