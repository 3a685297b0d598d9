"use strict";
// The runs of the page (tools/report_page/run_data.h), what is selected, and how numbers are shown.
const data = JSON.parse(document.getElementById("data").textContent);
const runs = data.runs;
const first = runs[0],
  isPair = runs.length === 2;
const hasTiming = runs.every((run) => run.timing);
const runNames =
  isPair && runs[0].name === runs[1].name
    ? runs.map((run, i) => run.name + " " + "AB"[i])
    : runs.map((run) => run.name);

// A frame and a draw of it, an entry of its commands; the figures of one frame or of all.
// The first is the one with most to see.
const drawn = first.functional.fragments_written ?? [0];
const selection = {
  frame: drawn.indexOf(drawn.reduce((a, b) => Math.max(a, b), 0)),
  entry: null,
  isAll: true,
};
const listeners = [];
function onSelect(listener) {
  listeners.push(listener);
}
function select(change) {
  if ("frame" in change && change.frame !== selection.frame) selection.entry = null;
  Object.assign(selection, change);
  for (const listener of listeners) listener();
}

const sum = (values) => values.reduce((a, b) => a + b, 0);
// A figure of a run: of the frame shown, or of all.
function figure(run, name) {
  const column = run.timing[name] ?? [];
  return selection.isAll ? sum(column) : (column[selection.frame] ?? 0);
}
const names = (ending) =>
  [...new Set(runs.flatMap((run) => Object.keys(run.timing ?? {})))]
    .filter((name) => name.endsWith(ending))
    .map((name) => name.slice(0, -ending.length));

const units = names("_busy_cycles");
const resources = Object.keys(first.timing ?? {})
  .filter((name) => name.startsWith("bottleneck_"))
  .map((name) => name.slice(11, -7))
  .filter((name) => runs.some((run) => sum(run.timing[`bottleneck_${name}_cycles`] ?? []) > 0));
const reckonsWaits = (run) => resources.some((name) => sum(run.timing[`bottleneck_${name}_cycles`] ?? []) > 0);
const clients = names("_read_bytes")
  .filter((name) => name.startsWith("memory_"))
  .map((name) => name.slice(7))
  .filter((name) => runs.some((run) => sum(run.timing[`memory_${name}_requests`] ?? []) > 0));
const caches = names("_compulsory_misses").filter((name) =>
  runs.some((run) => sum(run.timing[`${name}_accesses`] ?? []) > 0),
);

const words = (name) => name.replaceAll("_", " ");
function number(value, digits = 0) {
  return value
    .toLocaleString("en", { maximumFractionDigits: digits, minimumFractionDigits: digits })
    .replaceAll(",", "\u202f");
}
// With three figures: 123, 12.3 k, 4.5 M.
function short(value) {
  const units = ["", "\u00a0k", "\u00a0M", "\u00a0G", "\u00a0T"];
  let at = 0;
  for (; Math.abs(value) >= 999.5 && at + 1 < units.length; ++at) value /= 1000;
  const digits =
    at === 0 && Number.isInteger(value) ? 0 : Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value) || 1)));
  return String(Number(value.toFixed(Math.min(digits, 2)))) + units[at];
}
function bytes(value) {
  const units = ["B", "KiB", "MiB", "GiB"];
  let at = 0;
  for (; Math.abs(value) >= 1024 && at + 1 < units.length; ++at) value /= 1024;
  return `${number(value, Number.isInteger(value) ? 0 : 1)}\u00a0${units[at]}`;
}
const percent = (part, whole, digits = 1) =>
  whole === 0 ? "–" : `${number((100 * part) / whole, digits)}\u00a0%`;
const signed = (text, value) => (value > 0 ? `+${text}` : text.replace("-", "\u2212"));

// <tag ...attributes>children</tag>
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null) made.setAttribute(name, value);
  made.append(...children);
  return made;
}
const controls = (...children) => element("div", { class: "controls" }, ...children);
// A colour and what it means.
const keyed = (color, text) =>
  element("span", {}, element("i", { class: "key", style: `background:${color}` }), text);
const section = (id) => document.getElementById(id);
function choice(label, options, onChange) {
  const select = element("select", { onchange: () => onChange(select.value) });
  for (const [value, text] of options) select.append(element("option", { value }, text));
  return element("label", {}, label + " ", select);
}
// What a part lacks, and how to get it.
function addNotes(parent, part) {
  runs.forEach((run, i) => {
    for (const text of run.notes[part] ?? [])
      parent.append(element("p", { class: "note" }, (isPair ? `${runNames[i]}: ` : "") + text));
  });
}
