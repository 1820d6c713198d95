// The page of `carom tunnel`: what it found in words, the curve, the map, critical speeds.

import { h } from "./dom.js";
import { figure } from "./figure.js";
import { formatNumber, isNumber } from "./format.js";
import { curveFigure } from "./tunnel_curve.js";
import { lineName, objects, valuesOf } from "./tunnel_data.js";
import { mapFigure } from "./tunnel_map.js";

/** Critical speed in chords a step, which is one number for a method at every size, offset and step. */
function inChords(row, speed) {
  const reach = row.radius + row.thickness / 2;
  return (speed * row.dt) / (reach * Math.sqrt((1 - row.offset) * (1 + row.offset)));
}

function spanText(numbers) {
  const [low, high] = [Math.min(...numbers), Math.max(...numbers)].map((x) => formatNumber(x, 4));
  return low === high ? low : `${low} to ${high}`;
}

function criticalFigure({ critical }) {
  if (!critical.length) return null;
  const names = valuesOf(critical.map((row) => ({ name: lineName(row) })), "name");
  const line = (name, target) => {
    const own = critical.filter((row) => lineName(row) === name && row.target === target);
    const found = own.filter((row) => isNumber(row.critical_speed));
    const laws = own.filter((row) => isNumber(row.law));
    const off = found.filter((row) => isNumber(row.law)).map((row) => Math.abs(row.critical_speed / row.law - 1));
    return h("tr", {}, h("th", { scope: "row" }, name), h("td", { class: "text" }, target), h("td", {}, String(own.length)),
      h("td", {}, found.length ? spanText(found.map((row) => inChords(row, row.critical_speed))) : "never"),
      h("td", {}, laws.length ? spanText(laws.map((row) => inChords(row, row.law))) : "–"),
      h("td", {}, off.length ? `${formatNumber(100 * Math.max(...off), 2)} %` : "–"));
  };
  const head = ["method", "target", "searches", "critical speed", "law", "off by"].map((text) => h("th", { scope: "col", class: text === "target" ? "text" : null }, text));
  return figure({
    title: "Critical speeds", className: "full",
    caption: "The lowest speed that tunnels, found by bisection within 1 %, over all sizes, offsets and steps, in chords a step: v dt / (r + thickness/2) of a plate, v dt / sqrt((r₁+r₂)² − b²) of a sphere hit at offset b.",
    body: [h("div", { class: "table-box whole" }, h("table", { class: "plain" }, h("thead", {}, h("tr", {}, ...head)),
      h("tbody", {}, ...valuesOf(critical, "target").flatMap((target) => names.filter((name) => critical.some((row) => lineName(row) === name && row.target === target)).map((name) => line(name, target))))))],
  });
}

/** The content of the page from its data. */
export function tunnelPage(data) {
  const rows = objects(data.columns ?? [], data.rows);
  if (data.scenes?.length) rows.forEach((row, i) => { row.scene = data.scenes[i]; });
  const critical = objects(data.critical_columns ?? [], data.critical);
  const page = { title: data.title ?? "Tunnelling", scene: data.scene ?? "", rows, critical };
  document.title = `${page.title} – carom`;
  const [first, ...others] = data.verdict ?? [];
  const throws = rows.reduce((sum, row) => sum + row.trials, 0);
  return [h("section", { "aria-labelledby": "tunnel-title" },
    h("h1", { id: "tunnel-title" }, page.title),
    h("p", { class: "description" }, "A ball is thrown at a target, a random part of a step before the contact, and each method is asked: did it answer, when, and with the right velocity?"),
    first ? h("div", { class: "verdict", role: "note", "aria-label": "Verdict" }, h("p", { class: "lead" }, first), others.length ? h("ul", {}, ...others.map((text) => h("li", {}, text))) : null) : null,
    h("p", { class: "facts" }, `${formatNumber(throws)} throws in ${formatNumber(rows.length)} cells · seed ${data.seed}`),
    rows.length ? h("div", { class: "figures" }, ...[curveFigure(page), mapFigure(page), criticalFigure(page)].filter(Boolean)) : h("p", {}, "Nothing was thrown.")),
  h("footer", {}, `Written by ${data.generator ?? "carom"}. Everything on this page is in this one file.`)];
}
