// All rows with all columns. Headings sort; numbers are short here and whole in the file and in the cell's title.

import { COLUMNS, TABLE_COLUMNS } from "./columns.js";
import { download, toCsv } from "./csv.js";
import { h } from "./dom.js";
import { formatQuantity, isNumber, slug } from "./format.js";
import { rowLabel, stepLabel } from "./rows.js";
import { methodStyle, swatch } from "./styles.js";

function show(column, row, units) {
  const value = row[column.key];
  if (value === null || value === undefined || value === "") return "–";
  if (column.kind === "text") return String(value);
  if (column.kind === "step") return stepLabel(row);
  if (column.kind === "count") return isNumber(value) ? value.toLocaleString("en").replaceAll(",", "\u202f") : "–";
  return formatQuantity(value, column.unit(units));
}

function compare(a, b) {
  const [noA, noB] = [a === null || a === undefined || a === "", b === null || b === undefined || b === ""];
  if (noA || noB) return Number(noA) - Number(noB); // what is empty comes last, whichever way
  return typeof a === "string" ? a.localeCompare(b) : a - b;
}

export function rowsTable(comparison) {
  const { rows, units } = comparison;
  const filled = (key) => rows.some((row) => row[key] !== undefined && row[key] !== null && row[key] !== "");
  const always1 = (key) => rows.every((row) => (row[key] ?? 1) === 1);
  const columns = TABLE_COLUMNS.filter(({ key }) => key === "method" || (filled(key) && !(["substeps", "passes"].includes(key) && always1(key))));
  const body = h("tbody", {});
  let sorted = { key: null, down: false };

  const fill = () => {
    const order = rows.map((row, index) => ({ row, index }));
    if (sorted.key) {
      order.sort((a, b) => {
        const [x, y] = [a.row[sorted.key], b.row[sorted.key]];
        const empty = (v) => v === null || v === undefined || v === "";
        return (sorted.down && !empty(x) && !empty(y) ? -1 : 1) * compare(x, y) || a.index - b.index;
      });
    }
    body.replaceChildren(...order.map(({ row }) => h("tr", {}, ...columns.map((column) => {
      if (column.key !== "method") {
        const exact = row[column.key];
        return h("td", { class: column.kind, title: isNumber(exact) ? String(exact) : null }, show(column, row, units));
      }
      const cell = h("th", { scope: "row", title: rowLabel(row) });
      cell.innerHTML = swatch(methodStyle(row.method));
      cell.append(row.method, h("span", { class: "step" }, stepLabel(row)));
      return cell;
    }))));
  };
  const heads = columns.map((column) => {
    const head = h("th", { scope: "col", title: `${column.key}: ${column.text}` });
    head.append(h("button", {
      type: "button",
      onclick: () => {
        sorted = { key: column.key, down: sorted.key === column.key && !sorted.down };
        heads.forEach((other) => other.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", sorted.down ? "descending" : "ascending");
        fill();
      },
    }, column.title));
    return head;
  });
  fill();

  const save = h("button", {
    type: "button", class: "save", "aria-label": "Download all rows as CSV",
    onclick: () => download(`${slug(comparison.title)}-rows.csv`, toCsv(COLUMNS.map((c) => c.key), rows.map((row) => COLUMNS.map((c) => row[c.key])))),
  }, "CSV");
  return h("div", { class: "figure full" },
    h("div", { class: "figure-head" }, h("h3", {}, "All figures"), save),
    h("p", { class: "caption" }, "One row a run, errors first; scroll to the right for what else was measured. Choose a heading to sort by it; what each column means stands at the end of the page."),
    h("div", { class: "table-box", tabindex: "0", role: "region", "aria-label": `All figures of ${comparison.title}` },
      h("table", {}, h("thead", {}, h("tr", {}, ...heads)), body)));
}

const GLOSSARY = [...COLUMNS, ...TABLE_COLUMNS.filter((c) => !COLUMNS.includes(c))];

export function glossary() {
  return h("details", { class: "glossary", id: "glossary" },
    h("summary", {}, "What the columns mean"),
    h("dl", {}, ...GLOSSARY.map((c) => h("div", {}, h("dt", {}, c.title, " ", h("code", {}, c.key)), h("dd", {}, c.text)))));
}
