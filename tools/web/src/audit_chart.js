// The audit of steps: for each row the shares of impacts found, late, missed and wrong, as one bar with its numbers beside it.

import { h } from "./dom.js";
import { figure } from "./figure.js";
import { formatNumber, isNumber, slug } from "./format.js";
import { rowLabel } from "./rows.js";

/** In the order of the bar; each with a pattern of its own (style.css), so that colour is never needed to tell them apart. */
export const OUTCOMES = ["found", "late", "missed", "wrong"];

/** "99.5 %"; what is some but rounds to nothing or all is said so. */
export function percent(count, all) {
  const share = (100 * count) / all;
  if (count === 0) return "0 %";
  if (count === all) return "100 %";
  if (share < 0.1) return "below 0.1 %";
  if (share > 99.9) return "above 99.9 %";
  return `${formatNumber(share, 3)} %`;
}

/** Rows that were audited, with their shares. */
export function auditedRows(rows) {
  return rows.map((row, index) => ({ row, index })).filter(({ row }) => isNumber(row.audited) && row.audited > 0);
}

function sentence(row) {
  const some = OUTCOMES.filter((outcome) => row[outcome] > 0).map((outcome) => `${percent(row[outcome], row.audited)} ${outcome}`);
  const more = [row.invented > 0 ? `${formatNumber(row.invented)} invented` : "", row.crowded > 0 ? `${formatNumber(row.crowded)} too crowded to ask` : ""];
  return [`${some.join(", ")} of ${formatNumber(row.audited)}`, ...more].filter(Boolean).join("; ");
}

function bar(row) {
  const parts = OUTCOMES.filter((outcome) => row[outcome] > 0).map((outcome) => {
    const part = h("span", { class: `share ${outcome}` });
    part.style.flexGrow = String(row[outcome] / row.audited);
    return part;
  });
  return h("div", { class: "shares", "aria-hidden": "true" }, ...parts);
}

export function auditFigure(comparison) {
  const rows = auditedRows(comparison.rows);
  if (!rows.length) return null;
  const key = h("ul", { class: "key" }, ...OUTCOMES.map((outcome) => h("li", {}, h("span", { class: `share sample ${outcome}`, "aria-hidden": "true" }), outcome)));
  return figure({
    title: "Would a step have missed it?", className: "full",
    caption: "Impact by impact, whatever happened before: the method begins anew from the exact state, somewhere in the step before an impact, and takes two steps. Found: answered in its step, with the right velocity after two. Late: in the step after. The event method is held against the reference instead.",
    body: [key, h("table", { class: "audit" }, h("tbody", {}, ...rows.map(({ row }) =>
      h("tr", {}, h("th", { scope: "row" }, rowLabel(row)), h("td", { class: "bar" }, bar(row)), h("td", { class: "text" }, sentence(row))))))],
    csv: {
      name: () => `${slug(comparison.title)}-audit`,
      table: () => [["row", "label", "audited", ...OUTCOMES, "invented", "crowded"],
        rows.map(({ row, index }) => [index, rowLabel(row), row.audited, ...OUTCOMES.map((outcome) => row[outcome]), row.invented, row.crowded])],
    },
  });
}
