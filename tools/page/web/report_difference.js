"use strict";
// Two runs: the parameters that differ, and what they did, the largest effect first.
const EffectKinds = {
  time: "cycles, of all",
  traffic: "bytes, of all",
  cache: "misses, of look-ups",
  account: "a unit's cycles, of all",
};

function parameterTable(configuration) {
  if (configuration.length === 0) return element("p", {}, "No parameter differs.");
  const text = (value) => (value === null ? "–" : String(value));
  const head = ["parameter", ...runNames].map((name) => element("th", { scope: "col" }, name));
  const rows = configuration.map(({ name, before, after }) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, name),
      ...[before, after].map((value) => element("td", {}, text(value))),
    ),
  );
  return element(
    "div",
    { class: "scroll", tabindex: 0 },
    element(
      "table",
      { id: "parameters" },
      element("caption", {}, "Parameters that differ"),
      element("thead", {}, element("tr", {}, ...head)),
      element("tbody", {}, ...rows),
    ),
  );
}
function effectColumns() {
  const change = (row) => row.after - row.before;
  const shown = (row, value) => (row.kind === "traffic" ? bytes(value) : number(value));
  return [
    { name: "figure", isWord: true, value: (row) => row.name, show: (row) => words(row.name) },
    {
      name: "size of the effect",
      value: (row) => ratio(Math.abs(change(row)), row.whole),
      show: (row) => signed(percent(change(row), row.whole, 2), change(row)),
    },
    { name: runNames[0], value: (row) => row.before, show: (row) => shown(row, row.before) },
    { name: runNames[1], value: (row) => row.after, show: (row) => shown(row, row.after) },
    { name: "part", isWord: true, value: (row) => row.kind, show: (row) => EffectKinds[row.kind] },
  ];
}
function addDifference() {
  if (!isPair) return;
  const parent = section("difference");
  parent.hidden = section("to-difference").hidden = false;
  const { configuration, figures } = data.difference;
  const isShown = (row, kind) => (kind ? row.kind === kind : row.kind !== "account");
  const fill = (kind) => table.setRows(figures.filter((row) => isShown(row, kind)));
  const kinds = [["", "time, traffic, misses"], ...Object.entries(EffectKinds)];
  parent.append(parameterTable(configuration), controls(choice("Figures", kinds, fill)));
  const table = new SortedTable(parent, {
    id: "effects",
    caption: "What they did, in all frames; an effect is the change as a part of the whole",
    sort: "size of the effect",
    columns: effectColumns(),
  });
  if (figures.length === 0) parent.append(element("p", {}, "No figure differs."));
  fill("");
}

function addConfiguration() {
  const parent = section("configuration");
  if (first.configuration.length === 0) return addNotes(parent, "timing");
  const others = new Map(runs.at(-1).configuration);
  const rows = first.configuration.map(([name, value]) => ({
    name,
    values: isPair ? [value, others.get(name)] : [value],
  }));
  const columns = [{ name: "parameter", isWord: true, value: (row) => row.name }];
  runNames.forEach((name, i) =>
    columns.push({
      name: isPair ? name : "value",
      isWord: true,
      value: (row) => String(row.values[i] ?? "–"),
    }),
  );
  const table = new SortedTable(parent, {
    id: "parameter-table",
    caption: "Parameters, as ffgpu config names them",
    columns,
    sort: "parameter",
    isDescending: false,
  });
  const fill = (wanted) => table.setRows(rows.filter((row) => row.name.includes(wanted)));
  const find = element("input", { type: "search", oninput: () => fill(find.value) });
  parent.querySelector("h2").after(controls(element("label", {}, "Find ", find)));
  fill("");
}
