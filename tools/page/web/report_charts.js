"use strict";
// Charts, each with a description and, on demand, its numbers as a table. compute() tells
// {labels, series: [{name, values, color}]} of what is selected.
const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const Palette = [
  "#4e79a7",
  "#f28e2b",
  "#59a14f",
  "#e15759",
  "#b07aa1",
  "#76b7b2",
  "#edc948",
  "#9c755f",
  "#ff9da7",
  "#7f9f3f",
  "#5f6fc9",
  "#c9669b",
  "#3f9fc0",
  "#a0a0a0",
  "#8f5fd0",
  "#d0703f",
  "#2f8f6f",
  "#b0a050",
];
// What comes up most has a colour of its own in every chart.
const KnownColors = {
  memory_bandwidth: "#d1495b",
  memory_latency: "#f2a1ab",
  host: "#8f8f9c",
  texture: "#edae49",
  raster: "#59a14f",
  depth: "#4e79a7",
  color: "#b07aa1",
  geometry: "#2f9c95",
  fragment: "#9c755f",
  vertex: "#a8c66c",
  vertex_fetch: "#a8c66c",
  clip: "#6fc3df",
  setup: "#d7b5a6",
  command_processor: "#5f6fc9",
  command: "#5f6fc9",
  index: "#c9669b",
  links: "#c9c9c9",
};
// Others take the colours that nothing known of the list has, in turn.
function colorOf(list, name) {
  if (name in KnownColors) return KnownColors[name];
  const taken = list.map((other) => KnownColors[other]);
  const free = Palette.filter((color) => !taken.includes(color));
  const others = list.filter((other) => !(other in KnownColors));
  return free[others.indexOf(name) % free.length];
}
const AccountColors = {
  busy: "#4e9a5f",
  idle: "#9aa4ae",
  stalled_output: "#edae49",
  stalled_memory: "#d1495b",
  stalled_requests: "#8f5fd0",
};
const MostPoints = 100; // that a line marks
const charts = [];

function tableOf(labels, series, first, show) {
  const head = [first, ...series.map((one) => one.name)].map((name) => element("th", { scope: "col" }, name));
  const rows = labels.map((label, i) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, String(label)),
      ...series.map((one) => element("td", {}, show(one.values[i] ?? 0))),
    ),
  );
  return element(
    "div",
    { class: "scroll tall", tabindex: 0 },
    element(
      "table",
      { class: "numbers" },
      element("thead", {}, element("tr", {}, ...head)),
      element("tbody", {}, ...rows),
    ),
  );
}

// Intervals as lines that go up and down at their edges: N values and N + 1 edges. Stacked, each
// line lies on the one before; what a tooltip shows is its own part.
function steps({ labels, series }, isStacked) {
  const edges = labels.slice(0, -1).flatMap((from, i) => [from, labels[i + 1]]);
  const below = edges.map(() => 0);
  return {
    labels: edges,
    series: series.map((one) => {
      const parts = one.values.flatMap((value) => [value, value]);
      const tops = parts.map((part, i) => (isStacked ? (below[i] += part) : part));
      return { ...one, parts, values: tops };
    }),
  };
}

// A label of the scale, with as much of its middle left out that it takes less than two fifths of
// the chart.
function fitted(scale, label) {
  const { ctx, width } = scale.chart;
  ctx.font = Chart.helpers.toFont(scale.options.ticks.font).string;
  let text = label;
  for (let left = label.length - 1; left > 4 && ctx.measureText(text).width > 0.4 * width; --left)
    text = `${label.slice(0, Math.ceil(left / 2))}…${label.slice(label.length - Math.floor(left / 2))}`;
  return text;
}

// options: title, unit, type ("bar" or "line"), isHorizontal, isStacked, isPercent, x (what the
// labels are), xType, isSteps, show(value), pick(index), describe()
class ReportChart {
  constructor(parent, options) {
    this.options = { show: short, isStacked: true, type: "bar", ...options };
    this.canvas = element("canvas", { role: "img" });
    this.plot = element("div", { class: "plot" }, this.canvas);
    this.details = element(
      "details",
      { ontoggle: () => this.fillTable() },
      element("summary", {}, "As a table"),
    );
    this.keys = element("p", { class: "keys" });
    parent.append(
      element(
        "figure",
        { class: "chart" },
        element("figcaption", {}, options.title),
        this.plot,
        this.keys,
        this.details,
      ),
    );
    this.chart = new Chart(this.canvas, {
      type: this.options.type,
      data: { labels: [], datasets: [] },
      options: this.configured(),
    });
    charts.push(this);
    this.refresh();
  }

  labelAxis() {
    const { isStacked, isSteps, isHorizontal, x, xType } = this.options;
    const axis = {
      type: xType ?? "category",
      stacked: isStacked && !isSteps,
      title: { display: Boolean(x), text: x ?? "" },
      grid: { display: Boolean(xType) },
      ticks: { autoSkip: !isHorizontal, maxRotation: 0, includeBounds: false },
    };
    if (isHorizontal)
      axis.ticks.callback = function (value) {
        return fitted(this, this.getLabelForValue(value));
      };
    if (xType === "linear") {
      axis.max = this.content?.labels.at(-1);
      axis.ticks.callback = short;
    }
    if (xType === "logarithmic") {
      axis.ticks.callback = (value) => bytes(value);
      axis.ticks.autoSkipPadding = 12;
      axis.afterBuildTicks = (scale) => {
        scale.ticks = [];
        for (let power = Math.ceil(Math.log2(scale.min)); power <= Math.log2(scale.max); ++power)
          scale.ticks.push({ value: 2 ** power });
      };
    }
    return axis;
  }

  valueAxis() {
    const { isStacked, isSteps, isPercent, unit } = this.options;
    return {
      stacked: isStacked && !isSteps,
      title: { display: true, text: unit },
      beginAtZero: true,
      max: isPercent ? 100 : undefined,
      ticks: { maxTicksLimit: 7, callback: (value) => short(value) },
    };
  }

  tooltip() {
    const { isHorizontal, show, xType } = this.options;
    const part = (item) =>
      item.dataset.parts?.[item.dataIndex] ?? (isHorizontal ? item.parsed.x : item.parsed.y);
    const places = {
      linear: (item) => `from cycle ${number(Math.round(item.parsed.x))} on`,
      logarithmic: (item) => bytes(item.parsed.x),
    };
    return {
      filter: (item) => Boolean(part(item)),
      callbacks: {
        title: ([item]) => (item ? (places[xType]?.(item) ?? item.label) : ""),
        label: (item) => `${item.dataset.label}: ${show(part(item))}`,
      },
    };
  }

  configured() {
    const { isHorizontal, pick } = this.options;
    const [label, value] = [this.labelAxis(), this.valueAxis()];
    return {
      animation: false,
      responsive: true,
      maintainAspectRatio: false,
      indexAxis: isHorizontal ? "y" : "x",
      interaction: { mode: "index", axis: isHorizontal ? "y" : "x", intersect: false },
      scales: isHorizontal ? { x: value, y: label } : { x: label, y: value },
      onClick: (event, found) => {
        if (pick && found.length > 0) pick(found[0].index);
      },
      plugins: { legend: { display: false }, tooltip: this.tooltip() }, // HTML has room for all names.
      elements: { point: { radius: 0, hitRadius: 6 } },
    };
  }

  refresh() {
    const { compute, type, isStacked, isSteps, xType, title, isHorizontal, describe } = this.options;
    this.content = compute();
    const { labels, series } = isSteps ? steps(this.content, isStacked) : this.content;
    const isArea = type === "line" && isStacked;
    this.plot.style.height = isHorizontal ? `${66 + 26 * labels.length}px` : "16rem";
    this.chart.data.labels = xType ? undefined : labels;
    this.chart.data.datasets = series.map((one, at) => ({
      label: one.name,
      backgroundColor: one.color,
      borderColor: one.color,
      spanGaps: true,
      data: xType ? one.values.map((y, i) => ({ x: labels[i], y })) : one.values,
      parts: one.parts,
      fill: isArea ? (at === 0 ? "origin" : "-1") : false,
      pointRadius: type === "line" && !isStacked && !isSteps && labels.length <= MostPoints ? 2.5 : 0,
      borderDash: one.dash ?? [],
      borderWidth: type === "bar" || isArea ? 0 : 1.5,
    }));
    const isSeen = (one) => one.values.some((value) => value > 0);
    this.keys.replaceChildren(...this.content.series.filter(isSeen).map((one) => keyed(one.color, one.name)));
    const told =
      describe?.() ??
      series
        .map((one) => `${one.name} ${this.options.show(sum(one.values))}`)
        .slice(0, 8)
        .join(", ");
    this.canvas.setAttribute("aria-label", `${title}. ${told}`);
    this.restyle();
    this.fillTable();
  }

  restyle() {
    Chart.defaults.color = style("--ink");
    Chart.defaults.borderColor = style("--line");
    Chart.defaults.font.family = "system-ui, sans-serif";
    this.chart.options = this.configured();
    this.chart.update("none");
  }

  remove() {
    this.chart.destroy();
    charts.splice(charts.indexOf(this), 1);
  }

  fillTable() {
    if (this.details.childElementCount > 1) this.details.lastElementChild.remove();
    if (!this.details.open) return;
    const { labels, series } = this.content;
    const rows = this.options.isSteps ? labels.slice(0, -1) : labels;
    this.details.append(
      tableOf(
        rows.map((label) => (typeof label === "number" ? number(label) : label)),
        series,
        this.options.x ?? "",
        this.options.show,
      ),
    );
  }
}
onSelect(() => charts.forEach((chart) => chart.refresh()));
document.addEventListener("themechange", () => charts.forEach((chart) => chart.restyle()));

// Rows "raster", or with two runs "raster, A" and "raster, B".
function byRun(list) {
  return list.flatMap((name) =>
    runs.map((run, i) => ({ name, run, label: isPair ? `${words(name)}, ${runNames[i]}` : words(name) })),
  );
}
