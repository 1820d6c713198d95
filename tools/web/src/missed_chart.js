// Impacts that a method did not notice: one strip a row, one mark an impact, the number beside the name.

import { axis, FONT, makeChart, tooltip } from "./chart.js";
import { h } from "./dom.js";
import { figure } from "./figure.js";
import { escapeHtml, formatNumber, formatQuantity, isNumber, slug, withUnit } from "./format.js";
import { textWidth } from "./labels.js";
import { isStepped, rowLabel, stepLabel } from "./rows.js";
import { methodStyle } from "./styles.js";
import { theme } from "./theme.js";

const STRIP = 30;
const FONT_SIZE = 12.5;
const MARK = "rect";

/** Rows whose impacts could be counted, in their order; `count` is late and lost together, the times listed are those of both. */
export function missedRows(comparison) {
  const lists = new Map((comparison.missed ?? []).map((m) => [m.row, m]));
  return comparison.rows.map((row, index) => {
    const list = lists.get(index);
    return { row, index, times: list?.times ?? [], names: list?.names ?? [], late: row.mistimed ?? 0, lost: row.lost, count: row.lost === null ? null : row.lost + (row.mistimed ?? 0) };
  });
}

const countText = ({ late, lost }) => [lost ? `${formatNumber(lost)} missed` : "", late ? `${formatNumber(late)} late` : ""].filter(Boolean).join(", ");

/** "pbd (dt = 1/60, 1/240), naive": rows in few words. */
function together(strips) {
  const steps = new Map();
  for (const { row } of strips) {
    const name = isStepped(row) ? /^(.*?), dt = [^,]*(.*)$/.exec(rowLabel(row)) : null;
    const key = name ? name[1] + name[2] : rowLabel(row);
    steps.set(key, [...(steps.get(key) ?? []), ...(name ? [stepLabel(row)] : [])]);
  }
  return [...steps].map(([name, list]) => (list.length ? `${name} (dt = ${list.join(", ")})` : name)).join("; ");
}

/** What was not, or only partly, looked at: counting ends where a run leaves the reference. */
function judgedText(strips) {
  const never = strips.filter((s) => s.count === null);
  const partly = strips.filter((s) => s.count !== null && isNumber(s.row.divergence_time));
  return [
    never.length ? `Not counted, for they leave the reference before its first impact: ${together(never)}.` : "",
    partly.length ? `Counted only until they leave the reference (divergence time below): ${together(partly)}.` : "",
  ];
}

export function missedFigure(comparison) {
  const strips = missedRows(comparison);
  const counted = strips.filter((s) => s.count !== null);
  const end = comparison.reference.until ?? comparison.until;
  if (!strips.length || !(end > 0)) return null;
  const timeUnit = comparison.units.time;
  const total = counted.reduce((sum, s) => sum + s.count, 0);
  const clean = counted.filter((s) => s.count === 0 && !isNumber(s.row.divergence_time));
  const hit = counted.filter((s) => s.count > 0);
  const title = "Late and missed impacts";
  const csv = {
    name: () => `${slug(comparison.title)}-missed-impacts`,
    table: () => [["row", "label", "missed", "late", "time", "contact"],
      strips.flatMap((s) => (s.times.length ? s.times.map((t, i) => [s.index, rowLabel(s.row), s.lost, s.row.mistimed, t, s.names[i]]) : [[s.index, rowLabel(s.row), s.lost, s.row.mistimed, "", ""]]))],
  };
  const cleanText = [clean.length ? `None missed, none late, ${end < comparison.until ? "up to the end of the reference" : "to the end"}: ${together(clean)}.` : "", ...judgedText(strips)].filter(Boolean).join(" ");
  if (total === 0) {
    return figure({ title, className: "full", caption: clean.length === strips.length ? "No method missed an impact of the reference." : "Where impacts were counted, none was missed.", body: [h("p", { class: "note" }, cleanText)], csv });
  }

  const names = hit.map((s) => [`${rowLabel(s.row)}:  `, countText(s)]);
  const nameWidth = Math.max(...names.map(([row, count]) => textWidth(row, FONT_SIZE) + textWidth(count, FONT_SIZE, 700)));
  const option = ({ narrow }) => ({
    animation: false, textStyle: { fontFamily: FONT, color: theme().ink },
    grid: { left: narrow ? 14 : nameWidth + 16, right: narrow ? 18 : 30, top: narrow ? 22 : 8, bottom: 52, outerBoundsMode: "none" },
    tooltip: tooltip({
      trigger: "item",
      formatter: (p) => {
        const strip = hit[p.data.strip];
        return `<b>${escapeHtml(rowLabel(strip.row))}</b><br>missed or late, at t = ${escapeHtml(formatQuantity(strip.times[p.data.at], timeUnit, 5))}` +
          (strip.names[p.data.at] ? `<br>${escapeHtml(strip.names[p.data.at])}` : "");
      },
    }),
    xAxis: axis(withUnit("time", timeUnit), { nameLocation: "middle", nameGap: 32, min: 0, max: Math.min(comparison.until, end), axisLabel: { formatter: (v) => formatNumber(v) } }),
    yAxis: {
      type: "category", inverse: true, data: names.map(([row, count]) => `${row}{n|${count}}`),
      axisLine: { show: !narrow, lineStyle: { color: theme().axis } }, axisTick: { show: false }, splitLine: { show: true, lineStyle: { color: theme().grid } },
      axisLabel: narrow
        ? { inside: true, align: "left", verticalAlign: "bottom", padding: [0, 0, 6, -8], color: theme().ink, fontSize: 12, margin: 2, rich: { n: { fontWeight: 700, fontSize: 12 } }, interval: 0 }
        : { color: theme().ink, fontSize: FONT_SIZE, interval: 0, rich: { n: { fontWeight: 700, fontSize: FONT_SIZE } } },
      z: 10,
    },
    series: [{
      type: "scatter", symbol: MARK, symbolSize: narrow ? [3, 12] : [3, 20], symbolOffset: narrow ? [0, 8] : [0, 0],
      data: hit.flatMap((s, strip) => s.times.map((t, at) => ({ value: [t, strip], strip, at, itemStyle: { color: methodStyle(s.row.method).color, opacity: 0.8 } }))),
    }],
  });
  const chart = makeChart({
    label: `Late and missed impacts over time, ${comparison.title}: ${hit.map((s) => `${rowLabel(s.row)} ${countText(s)}`).join("; ")}`,
    height: (width) => hit.length * (width < 520 ? 40 : STRIP) + 66, option,
  });
  const shortened = hit.some((s) => s.times.length < s.count) ? " Where there are very many, only the first are marked." : "";
  return figure({
    title, csv, 
    caption: `Impacts of the reference that never came (missed) or came more than 3 steps early or late (late), each marked at its time.${shortened}`,
    body: [chart.element, h("p", { class: "note" }, cleanText)],
  });
}
