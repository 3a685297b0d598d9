"use strict";
// What each command of the frame shown took and waited for: it sorts, filters, and a pick shows the
// draw's pixels.
const factColumns = first.facts?.columns ?? [];
const CountedFacts = ["call", "vertices", "texel_cache_misses"];

// The commands of a frame of a run, as objects; of two runs those of the other beside.
function commandsOf(run, frame) {
  const columns = run.commands[frame];
  return columns.kind.map((kind, entry) => ({
    entry,
    frame,
    kind: run.kinds[kind],
    draw: columns.draw[entry],
    count: columns.count[entry],
    cycles: columns.cycles[entry],
    bottleneck: run.resources[columns.bottleneck[entry]],
    waited: columns.bottleneck_cycles[entry],
    pieces: columns.pieces[entry],
    quads: columns.quads[entry],
    covered: columns.covered[entry],
    written: columns.written[entry],
    facts: run.facts ? run.facts.places[frame][entry].map((place) => run.facts.texts[place]) : [],
  }));
}
// Clears and copies have no numbers of their own: the order tells them apart.
function named(commands) {
  const counts = new Map();
  return new Map(
    commands.map((command) => {
      const name = `${command.kind} ${command.draw}`;
      counts.set(name, (counts.get(name) ?? 0) + 1);
      return [`${name} ${counts.get(name)}`, command];
    }),
  );
}
function drawRows(frame) {
  const rows = commandsOf(first, frame);
  if (!isPair) return rows;
  const others = named(commandsOf(runs[1], frame));
  for (const [name, row] of named(rows)) {
    row.after = others.get(name)?.cycles ?? 0;
    others.delete(name);
  }
  for (const other of others.values()) rows.push({ ...other, entry: null, cycles: 0, after: other.cycles });
  return rows;
}
function drawName(row) {
  if (row.count > 1 || row.kind === "rest") return `${words(row.kind)} × ${number(row.count)}`;
  return row.kind === "draw" || row.kind === "image" ? `${row.kind} ${row.draw}` : words(row.kind);
}
function withBar(text, part) {
  return element(
    "span",
    {},
    element("i", { class: "bar", style: `--part:${Math.round(100 * part)}%` }),
    text,
  );
}

const ratio = (a, b) => (b === 0 ? 0 : a / b);
const counted = (name, of) => ({ name, value: of, show: (row) => number(of(row)) });
const wholeOf = (row) => first.timing.total_cycles[row.frame];
const changeOf = (row) => row.after - row.cycles;

const costColumns = [
  counted("cycles", (row) => row.cycles),
  {
    name: "of the frame",
    value: (row) => ratio(row.cycles, wholeOf(row)),
    show: (row) => withBar(percent(row.cycles, wholeOf(row)), ratio(row.cycles, wholeOf(row))),
  },
];
const changeColumns = [
  {
    name: "change",
    value: changeOf,
    show: (row) => signed(number(changeOf(row)), changeOf(row)),
  },
  {
    name: "size of the change",
    value: (row) => ratio(Math.abs(changeOf(row)), wholeOf(row)),
    show: (row) => percent(Math.abs(changeOf(row)), wholeOf(row)),
  },
  counted(`cycles, ${runNames[0]}`, (row) => row.cycles),
  counted(`cycles, ${runNames[1]}`, (row) => row.after),
];
const workColumns = [
  { name: "waits for", isWord: true, value: (row) => row.bottleneck, show: (row) => words(row.bottleneck) },
  {
    name: "of its cycles",
    value: (row) => ratio(row.waited, row.cycles),
    show: (row) => percent(row.waited, row.cycles, 0),
  },
  counted("pieces", (row) => row.pieces),
  counted("fragments", (row) => row.covered),
  {
    name: "killed",
    value: (row) => ratio(row.covered - row.written, row.covered),
    show: (row) => percent(row.covered - row.written, row.covered, 0),
  },
  {
    name: "cycles a fragment",
    value: (row) => ratio(row.cycles, row.covered),
    show: (row) => (row.covered ? number(row.cycles / row.covered, 2) : "–"),
  },
  {
    name: "lanes a quad",
    value: (row) => ratio(row.covered, row.quads),
    show: (row) => (row.quads ? number(row.covered / row.quads, 2) : "–"),
  },
];
function drawColumns() {
  const frame = {
    name: "frame",
    value: (row) => row.frame,
    show: (row) => `${first.frames[row.frame].frame}`,
  };
  const facts = factColumns.map((name, i) =>
    CountedFacts.includes(name)
      ? counted(words(name), (row) => Number(row.facts[i] ?? 0))
      : { name: words(name), isWord: true, value: (row) => row.facts[i] ?? "" },
  );
  return [
    { name: "command", value: (row) => row.draw, show: drawName },
    ...(first.frames.length > 1 ? [frame] : []),
    ...(isPair ? changeColumns : costColumns),
    ...workColumns,
    ...facts,
  ];
}

// What of the commands is listed: its controls call `refill` when it changes.
class DrawFilter {
  constructor(refill) {
    Object.assign(this, { text: "", kind: "", bottleneck: "", frames: "shown" });
    const set = (key) => (value) => {
      this[key] = value;
      refill();
    };
    const any = (values) => [["", "all"], ...values.map((value) => [value, words(value)])];
    const frames = [
      ["shown", "the frame shown"],
      ["all", "all frames"],
    ];
    const find = element("input", { type: "search", id: "find", oninput: () => set("text")(find.value) });
    this.controls = controls(
      element("label", {}, "Find ", find),
      choice("Of", frames, set("frames")),
      choice("Kind", any(first.kinds), set("kind")),
      choice("Waits for", any(resources), set("bottleneck")),
    );
  }

  matches(row) {
    const text = [drawName(row), row.bottleneck, ...row.facts].join(" ").toLowerCase();
    return (
      (!this.kind || row.kind === this.kind) &&
      (!this.bottleneck || row.bottleneck === this.bottleneck) &&
      text.includes(this.text.toLowerCase())
    );
  }

  rows() {
    const frames = this.frames === "shown" ? [selection.frame] : first.frames.map((_, frame) => frame);
    return frames.flatMap(drawRows).filter((row) => this.matches(row));
  }
}

function addDraws() {
  const parent = section("draws");
  if (!hasTiming) return addNotes(parent, "timing");
  const isPicked = (row) =>
    row.entry !== null && row.frame === selection.frame && row.entry === selection.entry;
  const refill = () => table.setRows(filter.rows(), isPicked);
  const filter = new DrawFilter(refill);
  const detail = element("p", { class: "sentence", role: "status" });
  const idea =
    "Every command with its own cycles: those of a frame add up to the frame's. " +
    "A click on a line shows its pixels in the frame above.";
  parent.append(element("p", {}, idea), filter.controls, detail);
  const table = new SortedTable(parent, {
    id: "draw-table",
    caption: "Commands, and what each waited for",
    columns: drawColumns(),
    sort: isPair ? "size of the change" : "cycles",
    onPick: (row) => select({ frame: row.frame, entry: isPicked(row) ? null : row.entry }),
  });
  addNotes(parent, "draws");
  let filled = null;
  const follow = () => {
    detail.textContent = detailOf();
    if (filled !== selection.frame && filter.frames === "shown") refill();
    else table.show(table.shown);
    filled = selection.frame;
  };
  onSelect(follow);
  follow();
}

function detailOf() {
  if (selection.entry === null) return "";
  const row = commandsOf(first, selection.frame)[selection.entry];
  const box = boxOf(first, selection.frame, selection.entry);
  const written = box ? countOf(box, "w") : 0;
  const pixels = box
    ? `It covers ${number(written + countOf(box, "k"))} pixels of the picture, and wrote ${number(written)} of them.`
    : "Its pixels are not known, or it drew none of the picture's.";
  const waited = `${percent(row.waited, row.cycles, 0)} of them waiting for ${words(row.bottleneck)}`;
  return `${drawName(row)}: ${number(row.cycles)} cycles, ${waited}. ${pixels}`;
}
