"use strict";
// The machine over time: within frames, where a run left its series, or frame by frame.
// What a chart over time may show: columns of the counters, each with a name and a colour.
function timeViews() {
  const views = {};
  if (resources.length > 0)
    views.bottleneck = {
      text: "what the machine waits for, frame by frame",
      isOfFrames: true, // What a frame waited for is known at its end.
      unit: "% of cycles",
      parts: resources.map((name) => [`bottleneck_${name}_cycles`, words(name), colorOf(resources, name)]),
    };
  views.busy = {
    text: "busy share of all units",
    unit: "% of cycles",
    isLines: true,
    parts: units.map((name) => [`${name}_busy_cycles`, words(name), colorOf(units, name)]),
  };
  views.traffic = {
    text: "memory traffic by client",
    unit: "bytes a cycle",
    isTraffic: true,
    parts: clients.map((name) => [
      [`memory_${name}_read_bytes`, `memory_${name}_written_bytes`],
      words(name),
      colorOf(clients, name),
    ]),
  };
  for (const unit of units)
    views[unit] = {
      text: `the account of ${words(unit)}`,
      unit: "% of cycles",
      parts: Object.entries(AccountColors).map(([state, color]) => [
        `${unit}_${state}_cycles`,
        words(state),
        color,
      ]),
    };
  return views;
}
// Counters over time: intervals of the series, or frames. Both have their cycles.
function timeSource(run, view) {
  if (!run.series || view.isOfFrames)
    return { cycles: run.timing.total_cycles, columns: run.timing, frame: run.frames.map((_, i) => i) };
  return run.series;
}
function timeSeries(run, view) {
  const source = timeSource(run, view),
    labels = [],
    kept = [];
  let at = 0;
  source.cycles.forEach((cycles, i) => {
    if (!selection.isAll && source.frame[i] !== selection.frame) return;
    labels.push(at);
    kept.push(i);
    at += cycles;
  });
  const value = (name, i) => [name].flat().reduce((all, one) => all + (source.columns[one]?.[i] ?? 0), 0);
  const factor = view.isTraffic ? 1 : 100;
  const series = view.parts.map(([name, text, color]) => ({
    name: text,
    color,
    values: kept.map((i) => (source.cycles[i] === 0 ? 0 : (factor * value(name, i)) / source.cycles[i])),
  }));
  labels.push(at);
  return { labels, series: series.filter((one) => one.values.some((value) => value > 0)) };
}
function timeChart(parent, view, run, i) {
  return new ReportChart(parent, {
    type: "line",
    isStacked: !view.isLines,
    isSteps: true,
    xType: "linear",
    x: "cycles",
    unit: view.unit,
    isPercent: !view.isTraffic,
    show: (value) => number(value, 1),
    title: `Over time: ${view.text}${isPair ? `, ${runNames[i]}` : ""}`,
    compute: () => timeSeries(run, view),
    describe: () => `${view.unit} in ${number(timeSource(run, view).cycles.length)} intervals`,
  });
}
function addTime() {
  const parent = section("time");
  if (!hasTiming) return addNotes(parent, "timing");
  const views = timeViews(),
    box = element("div");
  let made = [];
  const show = (key) => {
    made.forEach((chart) => chart.remove());
    box.replaceChildren();
    const isShown = (run) => !views[key].isOfFrames || reckonsWaits(run);
    made = runs.flatMap((run, i) => (isShown(run) ? [timeChart(box, views[key], run, i)] : []));
  };
  const options = Object.entries(views).map(([key, view]) => [key, view.text]);
  const picker = controls(choice("Shown", options, show));
  parent.append(picker, box);
  const first = runs.some((run) => run.series) || !views.bottleneck ? "busy" : "bottleneck";
  picker.querySelector("select").value = first;
  show(first);
  addNotes(parent, "series");
}
