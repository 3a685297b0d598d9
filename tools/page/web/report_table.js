"use strict";
// A table that sorts by a click on a column's head, shows a part of its rows, and may let rows be
// picked. Columns: {name, value(row), show(row), isWord}; the first one names the row.
const RowsShown = 60;

class SortedTable {
  constructor(parent, { id, caption, columns, sort, isDescending = true, onPick = null }) {
    this.columns = columns;
    this.order = { column: columns.findIndex((column) => column.name === sort), isDescending };
    this.onPick = onPick;
    this.rows = [];
    this.picked = null;
    this.heads = columns.map((column, i) =>
      element(
        "th",
        { scope: "col", class: column.isWord ? "word" : null },
        element("button", { type: "button", onclick: () => this.sortBy(i) }, column.name),
      ),
    );
    this.body = element("tbody");
    this.count = element("p", { role: "status", class: "keys" });
    this.more = element("button", { type: "button", onclick: () => this.show(this.shown * 4) }, "Show more");
    parent.append(
      element(
        "div",
        { class: "scroll tall", tabindex: 0, role: "region", "aria-label": caption },
        element(
          "table",
          { id, class: "numbers" },
          element("caption", {}, caption),
          element("thead", {}, element("tr", {}, ...this.heads)),
          this.body,
        ),
      ),
      controls(this.count, this.more),
    );
  }

  setRows(rows, picked = null) {
    this.rows = rows;
    this.picked = picked;
    this.show(RowsShown);
  }

  sortBy(i) {
    const isSame = this.order.column === i;
    this.order = { column: i, isDescending: isSame ? !this.order.isDescending : !this.columns[i].isWord };
    this.show(RowsShown);
  }

  sorted() {
    const { value } = this.columns[this.order.column],
      sign = this.order.isDescending ? -1 : 1;
    const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
    return [...this.rows].sort((a, b) => sign * compare(value(a), value(b)));
  }

  show(count) {
    this.shown = count;
    this.heads.forEach((head, i) => {
      if (i === this.order.column)
        head.setAttribute("aria-sort", this.order.isDescending ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    this.body.replaceChildren(
      ...this.sorted()
        .slice(0, count)
        .map((row) => this.line(row)),
    );
    this.count.textContent = `${number(Math.min(count, this.rows.length))} of ${number(this.rows.length)} lines`;
    this.more.hidden = this.rows.length <= count;
  }

  line(row) {
    const isPicked = this.picked !== null && this.picked(row);
    const cells = this.columns.map((column, i) => {
      let content = column.show ? column.show(row) : column.value(row);
      if (i > 0) return element("td", { class: column.isWord ? "word" : null }, content);
      if (this.onPick)
        content = element(
          "button",
          { type: "button", class: "pick", "aria-pressed": String(isPicked) },
          content,
        );
      return element("th", { scope: "row" }, content);
    });
    const attributes = { class: (this.onPick ? "pickable" : "") + (isPicked ? " picked" : "") };
    if (this.onPick) attributes.onclick = () => this.onPick(row);
    return element("tr", attributes, ...cells);
  }
}
