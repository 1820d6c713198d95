// A quantity over time, one line a row: the rows of one step, or all steps of one method.

import { above, axis, decades, FONT, INK, makeChart, symbolPath, tooltip } from "./chart.js";
import { choice, toggle } from "./dom.js";
import { figure, makeKey } from "./figure.js";
import { escapeHtml, formatNumber, formatQuantity, isNumber, powerOfTen, slug, withUnit } from "./format.js";
import { logAxis } from "./logaxis.js";
import { groupRows, isStepped, rowLabel, stepLabel, stepsOf } from "./rows.js";
import { indexStyle, methodStyle } from "./styles.js";

const SYMBOLS_A_LINE = 6;
const SPAN_FOR_LOG = 100; // lines that differ by more than this are drawn on a logarithmic axis at first
const DECADES = 18; // shown at most below the largest value

/** What to draw: {"step:0.001"} or {"method:pbd"}, with names and styles of the lines. */
function selections(comparison, series) {
  const rows = series.map((s) => comparison.rows[s.row]);
  const steps = stepsOf(rows).map(({ dt, label }) => ({ value: `step:${dt}`, label: `dt = ${label}` }));
  const methods = [...new Set(rows.filter(isStepped).map((row) => row.method))]
    .filter((method) => new Set(rows.filter((row) => row.method === method).map((row) => row.dt)).size > 1)
    .map((method) => ({ value: `method:${method}`, label: `${method}` }));
  return { steps, methods };
}

function linesOf(comparison, series, selection) {
  const groups = groupRows(comparison.rows);
  const groupOf = (index) => groups.find((g) => g.rows.some((r) => r.index === index));
  const [kind, value] = [selection.slice(0, selection.indexOf(":")), selection.slice(selection.indexOf(":") + 1)];
  const chosen = series.filter((s) => {
    const row = comparison.rows[s.row];
    return !isStepped(row) || (kind === "step" ? String(row.dt) === value : row.method === value);
  });
  return chosen.map((s, n) => {
    const row = comparison.rows[s.row];
    const group = groupOf(s.row);
    if (kind === "step" || !isStepped(row)) return { s, name: group.name, style: methodStyle(group.method, group.variant) };
    const more = group.variant ? group.name.slice(group.method.length) : "";
    return { s, name: `dt = ${stepLabel(row)}${more}`, style: indexStyle(n) };
  });
}

/**
 * @param {{quantity: "energy_error"|"penetration"|"position_max", title: string, caption: string, axisName: string, unit: string}} what
 */
export function timeFigure(comparison, what) {
  const series = (comparison.series ?? []).filter((s) => s[what.quantity]?.some(isNumber) && comparison.rows[s.row]);
  if (!series.length) return null;
  const { steps, methods } = selections(comparison, series);
  let selection = steps[Math.floor(steps.length / 2)]?.value ?? "step:";
  const timeUnit = comparison.units.time ?? "";
  const key = makeKey();

  const sizes = series.flatMap((s) => s[what.quantity]).filter(isNumber).map(Math.abs).filter((v) => v > 0);
  const spread = sizes.length ? sizes.reduce((a, b) => Math.max(a, b)) / sizes.reduce((a, b) => Math.min(a, b)) : 1;
  let scale = spread > SPAN_FOR_LOG ? "log" : "linear";

  const option = ({ narrow }) => {
    const lines = linesOf(comparison, series, selection);
    const values = lines.flatMap(({ s }) => s[what.quantity]).filter(isNumber);
    const log = scale === "log" ? logAxis(values, { tickCount: 6, decades: DECADES }) : null;
    const end = lines.flatMap(({ s }) => s.time).reduce((a, b) => Math.max(a, b), 0);
    const left = 58;
    key.element.hidden = !narrow;
    key.show(lines.map(({ style, name }) => ({ style, name })));
    const longest = lines.reduce((n, l) => Math.max(n, l.name.length), 0);
    const zeros = log && log.floor !== null && values.some((v) => log.floored(v));
    const largest = values.map(Math.abs).reduce((a, b) => Math.max(a, b), 0);
    return {
      animation: false, textStyle: { fontFamily: FONT, color: INK },
      grid: { left, right: narrow ? 18 : 24 + Math.min(150, 7.2 * longest), top: 42, bottom: 52, outerBoundsMode: "none" },
      tooltip: tooltip({
        trigger: "axis", axisPointer: { type: "line" },
        formatter: (points) => {
          const at = points[0]?.dataIndex;
          if (at === undefined) return "";
          const body = points.map((p) => `<br>${escapeHtml(lines[p.seriesIndex].name)}: <b>${escapeHtml(formatQuantity(lines[p.seriesIndex].s[what.quantity][p.dataIndex], what.unit, 4))}</b>`);
          return `t = ${escapeHtml(formatQuantity(lines[0].s.time[at], timeUnit, 4))}${body.join("")}`;
        },
      }),
      xAxis: axis(withUnit("time", timeUnit), { nameLocation: "middle", nameGap: 32, min: 0, max: end, axisLabel: { formatter: (v) => formatNumber(v), showMaxLabel: true } }),
      yAxis: log
        ? axis(withUnit(what.axisName, what.unit), { ...above(left), ...decades(log, powerOfTen) })
        : axis(withUnit(what.axisName, what.unit), { ...above(left), min: largest === 0 ? 0 : undefined, max: largest === 0 ? 1 : undefined, axisLabel: { formatter: (v) => formatNumber(v, 2) } }),
      series: lines.map(({ s, name, style }, n) => {
        const stride = Math.max(1, Math.floor(s.time.length / SYMBOLS_A_LINE));
        const shift = Math.floor((stride * (n + 0.5)) / lines.length);
        return {
          type: "line", name, z: 3, symbol: symbolPath(style.symbol), showSymbol: true, showAllSymbol: true,
          symbolSize: (_, p) => (p.dataIndex % stride === shift ? 9 : 0),
          lineStyle: { color: style.color, width: Math.min(style.width, 2.5), type: style.dash.length ? style.dash : "solid" },
          itemStyle: { color: style.color },
          endLabel: { show: !narrow, formatter: () => name, color: style.color, fontSize: 12.5, fontWeight: 700, fontFamily: FONT, distance: 8 },
          labelLayout: { moveOverlap: "shiftY" },
          data: s[what.quantity].map((v, i) => [s.time[i], isNumber(v) ? (log ? log.place(v) : v) : null]),
          markLine: n === 0 && zeros ? {
            silent: true, symbol: "none", animation: false, lineStyle: { type: [2, 3], color: "#444", width: 1 },
            label: { formatter: values.some((v) => v !== 0 && log.floored(v)) ? "0 or next to it" : "0", position: "insideStartBottom", color: "#444", fontSize: 12, fontFamily: FONT },
            data: [{ yAxis: Math.log10(log.floor) }],
          } : undefined,
        };
      }),
    };
  };

  const chart = makeChart({ label: `${what.title}, ${comparison.title}: ${what.axisName} over time`, height: (width) => (width < 480 ? 300 : 320), option });
  const groups = [{ label: "All methods at one step", options: steps }, { label: "All steps of one method", options: methods }].filter((g) => g.options.length);
  return figure({
    title: what.title, caption: what.caption,
    controls: [
      groups.length ? choice("Show", groups, selection, (value) => { selection = value; chart.update(); }) : null,
      toggle("Scale", [{ value: "log", label: "log" }, { value: "linear", label: "linear" }], scale, (value) => { scale = value; chart.update(); }),
    ].filter(Boolean),
    body: [chart.element, key.element],
    csv: {
      name: () => `${slug(comparison.title)}-${what.quantity}`,
      table: () => [["row", "label", "time", what.quantity],
        series.flatMap((s) => s.time.map((t, i) => [s.row, rowLabel(comparison.rows[s.row]), t, s[what.quantity][i]]))],
    },
  });
}
