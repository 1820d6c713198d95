// A quantity over time, one line a row: the rows of one step, or all steps of one method.

import { above, axis, decades, floorLine, FONT, makeChart, pixels, symbolPath, tooltip } from "./chart.js";
import { choice, h, toggle } from "./dom.js";
import { figure, makeKey } from "./figure.js";
import { escapeHtml, formatNumber, formatQuantity, isNumber, powerOfTen, slug, withUnit } from "./format.js";
import { spread, textSeries, textWidth } from "./labels.js";
import { logAxis } from "./logaxis.js";
import { groupRows, isStepped, rowLabel, stepLabel, stepsOf } from "./rows.js";
import { indexStyle, methodStyle } from "./styles.js";
import { theme } from "./theme.js";

const SYMBOLS_A_LINE = 6;
const SPAN_FOR_LOG = 100; // lines that differ by more than this are drawn on a logarithmic axis at first
const NAME = { size: 13, weight: 700 };
const ROUNDING = 1e-14; // relative energy errors up to this are no picture
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

/** Names of the lines at their right ends. */
function endNames(lines, points, toPixel, { grid, width, height }) {
  const ends = points.map((list) => list.findLast(([, v]) => v !== null) ?? [0, 0]).map(toPixel);
  const heights = spread(ends.map(([, y]) => y), grid.top, height - grid.bottom);
  return lines.map(({ name, style }, i) => ({
    text: name, color: style.color, ...NAME, x: width - grid.right + 14, y: heights[i], from: [width - grid.right + 1, ends[i][1], width - grid.right + 12, heights[i]],
  }));
}

/** Limits of a linear axis at round numbers. */
function niceRange(low, high) {
  const step = 10 ** Math.floor(Math.log10(high - low)) / 2;
  return { min: Math.floor(low / step) * step, max: Math.ceil(high / step) * step };
}

/**
 * @param {{quantity: "energy_error"|"penetration"|"position_max", title: string, caption: string, axisName: string, unit: string}} what
 */
export function timeFigure(comparison, what) {
  // What is known at the start only is no line.
  const series = (comparison.series ?? []).filter((s) => s[what.quantity]?.slice(1).some(isNumber) && comparison.rows[s.row]);
  if (!series.length) return null;
  if (what.quantity === "penetration" && series.every((s) => s.penetration.every((v) => !v))) {
    return figure({ title: what.title, caption: what.caption, className: "full", body: [h("p", {}, "None: no run had an overlap at any sample.")] });
  }
  const largest = series.flatMap((s) => s[what.quantity]).filter(isNumber).reduce((most, v) => Math.max(most, Math.abs(v)), 0);
  if (what.quantity === "energy_error" && largest <= ROUNDING) {
    return figure({ title: what.title, caption: what.caption, className: "full", body: [h("p", {}, largest === 0 ? "None in any run." : `None but rounding: at most ${formatNumber(largest, 2)} in all runs.`)] });
  }
  const { steps, methods } = selections(comparison, series);
  const verdicts = steps.find(({ value }) => value === `step:${comparison.step_shown}`);
  let selection = (verdicts ?? steps[Math.floor(steps.length / 2)])?.value ?? "step:";
  const timeUnit = comparison.units.time;
  const key = makeKey();

  const sizes = series.flatMap((s) => s[what.quantity]).filter(isNumber).map(Math.abs).filter((v) => v > 0);
  const range = sizes.length ? sizes.reduce((a, b) => Math.max(a, b)) / sizes.reduce((a, b) => Math.min(a, b)) : 1;
  let scale = range > SPAN_FOR_LOG ? "log" : "linear";

  const option = ({ width, height, narrow }) => {
    const lines = linesOf(comparison, series, selection);
    const values = lines.flatMap(({ s }) => s[what.quantity]).filter(isNumber);
    const log = scale === "log" ? logAxis(values, { tickCount: 6, decades: DECADES }) : null;
    const end = lines.flatMap(({ s }) => s.time.filter((_, i) => isNumber(s[what.quantity][i]))).reduce((a, b) => Math.max(a, b), 0) || 1;
    key.element.hidden = !narrow;
    key.show(lines.map(({ style, name }) => ({ style, name })));
    const nameWidth = lines.reduce((w, l) => Math.max(w, textWidth(l.name, NAME.size, NAME.weight)), 0);
    const grid = { left: 58, right: narrow ? 18 : nameWidth + 20, top: 42, bottom: 52, outerBoundsMode: "none" };
    const zeros = log && log.floor !== null && values.some((v) => log.floored(v));
    const largest = values.map(Math.abs).reduce((a, b) => Math.max(a, b), 0);
    const negative = values.some((v) => v < 0);
    const linear = largest === 0 ? { min: 0, max: 1 } : niceRange(negative ? -largest : 0, largest);
    const points = lines.map(({ s }) => s[what.quantity].map((v, i) => [s.time[i], isNumber(v) ? (log ? log.place(v) : v) : null]));
    const toPixel = pixels({ grid, width, height, x: { min: 0, max: end }, y: log ?? linear });
    return {
      animation: false, textStyle: { fontFamily: FONT, color: theme().ink },
      grid,
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
        ? axis(withUnit(what.axisName, what.unit), { ...above(grid.left), ...decades(log, powerOfTen) })
        : axis(withUnit(what.axisName, what.unit), { ...above(grid.left), ...linear, axisLabel: { formatter: (v) => (largest === 0 && v !== 0 ? "" : formatNumber(v, 2)) } }),
      series: [...lines.map(({ s, name, style }, n) => {
        const stride = Math.max(1, Math.floor(s.time.length / SYMBOLS_A_LINE));
        const shift = Math.floor((stride * (n + 0.5)) / lines.length);
        return {
          type: "line", name, z: 3, symbol: symbolPath(style.symbol), showSymbol: true, showAllSymbol: true,
          symbolSize: (_, p) => (p.dataIndex % stride === shift ? 9 : 0),
          lineStyle: { color: style.color, width: Math.min(style.width, 2.5), type: style.dash.length ? style.dash : "solid" },
          itemStyle: { color: style.color },
          data: points[n],
          markLine: n === 0 && zeros ? { silent: true, symbol: "none", animation: false, data: [floorLine(log, "yAxis")] } : undefined,
        };
      }), ...(narrow ? [] : [textSeries(endNames(lines, points, toPixel, { grid, width, height }), FONT)])],
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
