// Impacts that a method did not notice: one strip a row, one mark an impact, the number beside the name.

import { axis, FONT, INK, makeChart, tooltip } from "./chart.js";
import { h } from "./dom.js";
import { figure } from "./figure.js";
import { escapeHtml, formatNumber, formatQuantity, isNumber, slug, withUnit } from "./format.js";
import { textWidth } from "./labels.js";
import { rowLabel } from "./rows.js";
import { methodStyle } from "./styles.js";

const STRIP = 30;
const FONT_SIZE = 12.5;
const MARK = "rect";

/** Rows whose impacts could be counted, in their order. */
export function missedRows(comparison) {
  const lists = new Map((comparison.missed ?? []).map((m) => [m.row, m]));
  return comparison.rows.map((row, index) => {
    const list = lists.get(index);
    return { row, index, times: list?.times ?? [], names: list?.names ?? [], count: isNumber(row.missed_impacts) ? row.missed_impacts : list ? list.times.length : null };
  }).filter(({ count }) => count !== null);
}

export function missedFigure(comparison) {
  const strips = missedRows(comparison);
  if (!strips.length) return null;
  const timeUnit = comparison.units.time ?? "";
  const total = strips.reduce((sum, s) => sum + s.count, 0);
  const clean = strips.filter((s) => s.count === 0);
  const hit = strips.filter((s) => s.count > 0);
  const title = "Missed impacts";
  const csv = {
    name: () => `${slug(comparison.title)}-missed-impacts`,
    table: () => [["row", "label", "missed_impacts", "time", "contact"],
      strips.flatMap((s) => (s.times.length ? s.times.map((t, i) => [s.index, rowLabel(s.row), s.count, t, s.names[i]]) : [[s.index, rowLabel(s.row), s.count, "", ""]]))],
  };
  const cleanText = clean.length ? `None missed: ${clean.map((s) => rowLabel(s.row)).join("; ")}.` : "";
  if (total === 0) {
    return figure({ title, className: "full", caption: "No method missed an impact of the reference.", body: [h("p", { class: "note" }, cleanText)], csv });
  }

  const names = hit.map((s) => [`${rowLabel(s.row)}:  `, `${formatNumber(s.count)} missed`]);
  const nameWidth = Math.max(...names.map(([row, count]) => textWidth(row, FONT_SIZE) + textWidth(count, FONT_SIZE, 700)));
  const option = ({ narrow }) => ({
    animation: false, textStyle: { fontFamily: FONT, color: INK },
    grid: { left: narrow ? 14 : nameWidth + 16, right: narrow ? 18 : 30, top: narrow ? 22 : 8, bottom: 52, outerBoundsMode: "none" },
    tooltip: tooltip({
      trigger: "item",
      formatter: (p) => {
        const strip = hit[p.data.strip];
        return `<b>${escapeHtml(rowLabel(strip.row))}</b><br>missed at t = ${escapeHtml(formatQuantity(strip.times[p.data.at], timeUnit, 5))}` +
          (strip.names[p.data.at] ? `<br>${escapeHtml(strip.names[p.data.at])}` : "");
      },
    }),
    xAxis: axis(withUnit("time", timeUnit), { nameLocation: "middle", nameGap: 32, min: 0, max: comparison.until, axisLabel: { formatter: (v) => formatNumber(v) } }),
    yAxis: {
      type: "category", inverse: true, data: names.map(([row, count]) => `${row}{n|${count}}`),
      axisLine: { show: !narrow, lineStyle: { color: "#8895a3" } }, axisTick: { show: false }, splitLine: { show: true, lineStyle: { color: "#e3e8ee" } },
      axisLabel: narrow
        ? { inside: true, align: "left", verticalAlign: "bottom", padding: [0, 0, 6, -8], color: INK, fontSize: 12, margin: 2, rich: { n: { fontWeight: 700, fontSize: 12 } }, interval: 0 }
        : { color: INK, fontSize: FONT_SIZE, interval: 0, rich: { n: { fontWeight: 700, fontSize: FONT_SIZE } } },
      z: 10,
    },
    series: [{
      type: "scatter", symbol: MARK, symbolSize: narrow ? [3, 12] : [3, 20], symbolOffset: narrow ? [0, 8] : [0, 0],
      data: hit.flatMap((s, strip) => s.times.map((t, at) => ({ value: [t, strip], strip, at, itemStyle: { color: methodStyle(s.row.method).color, opacity: 0.8 } }))),
    }],
  });
  const chart = makeChart({
    label: `Missed impacts over time, ${comparison.title}: ${hit.map((s) => `${rowLabel(s.row)} ${s.count}`).join(", ")}`,
    height: (width) => hit.length * (width < 520 ? 40 : STRIP) + 66, option,
  });
  const shortened = hit.some((s) => s.times.length < s.count) ? " Where there are very many, only the first are marked." : "";
  return figure({
    title, csv, 
    caption: `Impacts of the reference that a method did not notice, each marked at its time.${shortened}`,
    body: [chart.element, h("p", { class: "note" }, cleanText)],
  });
}
