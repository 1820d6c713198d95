// The work-precision diagram: error against work, both logarithmic; one line a method, one point a step.

import { above, axis, decades, floorLine, FONT, makeChart, pixels, symbolPath, tooltip } from "./chart.js";
import { COLUMN, ERRORS, WORKS } from "./columns.js";
import { choice, h } from "./dom.js";
import { figure, makeKey } from "./figure.js";
import { escapeHtml, formatDecade, formatQuantity, isNumber, powerOfTen, slug, withUnit } from "./format.js";
import { placeLabels, samples, textSeries, textWidth } from "./labels.js";
import { farBelow, logAxis } from "./logaxis.js";
import { groupRows, rowLabel, stepLabel } from "./rows.js";
import { methodStyle } from "./styles.js";
import { theme } from "./theme.js";

const NOTE = { size: 11.5, weight: 400 };
const NAME = { size: 13.5, weight: 700 };
const SYMBOL = 11; // px

/** Texts of the diagram: each line's name at its finest step (unless a key below has them), each point's step. */
function labelsOf(lines, { grid, width, height, narrow }) {
  const names = narrow ? [] : lines.filter((l) => l.points.length)
    .map((l) => ({ text: l.group.name, at: l.pixels.at(-1), color: l.style.color, ...NAME, required: true, reach: 13 }));
  const ends = (l, i) => i === 0 || i === l.points.length - 1; // there is no room for more on a narrow page
  const steps = lines.flatMap((l) => l.points.map((p, i) => ({ text: narrow && !ends(l, i) ? "" : stepLabel(p.row), at: l.pixels[i], color: l.style.color, ...NOTE, required: false, reach: 8 })))
    .filter((l) => l.text);
  const items = [...names, ...steps].map((l) => ({ ...l, x: l.at[0], y: l.at[1], width: textWidth(l.text, l.size, l.weight) }));
  const half = SYMBOL / 2;
  const points = lines.flatMap((l) => l.pixels.map(([x, y]) => ({ x: x - half, y: y - half, width: SYMBOL, height: SYMBOL })));
  const bounds = { x: grid.left + 2, y: grid.top - 8, width: width - grid.left - 4, height: height - grid.top - grid.bottom + 8 };
  return placeLabels(items, points, lines.flatMap((l) => samples(l.pixels)), bounds).map((box, i) => {
    if (!box) return null;
    const { text, color, size, weight, x, y } = items[i];
    const nearest = [Math.min(Math.max(x, box.x), box.x + box.width), box.y + box.height / 2];
    return { text, color, size, weight, x: box.x, y: box.y + box.height / 2, from: box.ring > 0 ? [x, y, ...nearest] : undefined };
  }).filter(Boolean);
}

function available(list, rows, alsoZero) {
  return list.filter(({ key }) => rows.some((row) => isNumber(row[key]) && (alsoZero || row[key] > 0)));
}

function whiskers(points, x, color) {
  const data = points.filter(({ row }) => row.cpu_min > 0 && row.cpu_max > row.cpu_min)
    .map((p) => [x.place(p.row.cpu_min), x.place(p.row.cpu_max), p.at[1]]);
  return {
    type: "custom", silent: true, data, encode: { x: [0, 1], y: 2 }, z: 1, tooltip: { show: false },
    renderItem: (_, api) => {
      const [from, to] = [api.coord([api.value(0), api.value(2)]), api.coord([api.value(1), api.value(2)])];
      const line = (x1, y1, x2, y2) => ({ type: "line", shape: { x1, y1, x2, y2 }, style: { stroke: color, lineWidth: 1 } });
      return { type: "group", children: [line(from[0], from[1], to[0], to[1]), line(from[0], from[1] - 3, from[0], from[1] + 3), line(to[0], to[1] - 3, to[0], to[1] + 3)] };
    },
  };
}

export function workFigure(comparison) {
  const { rows, units, reference, tolerance } = comparison;
  const errors = available(ERRORS, rows, true);
  const works = available(WORKS, rows, false);
  if (!errors.length || !works.length) return null;
  let [error, work] = [errors[0], works[0]];
  const groups = groupRows(rows);
  const key = makeKey();
  const note = h("p", { class: "note" });

  const unitOf = (what) => COLUMN[what.key].unit(units);
  const drawable = (row) => isNumber(row[error.key]) && isNumber(row[work.key]);

  const explain = (y, far) => {
    const missing = rows.filter((row) => !drawable(row)).map(rowLabel);
    const unit = unitOf(error);
    const parts = [];
    const distant = rows.filter((row) => drawable(row) && row[error.key] !== 0 && Math.abs(row[error.key]) <= far);
    if (distant.length) {
      parts.push(`Hollow symbols at the dotted line: far below this range, ${distant.map((row) => `${rowLabel(row)} at ${formatQuantity(row[error.key], unit, 2)}`).join("; ")}${rows.some((row) => row[error.key] === 0) ? ", or zero" : ""}.`);
    } else if (rows.some((row) => drawable(row) && (y.floored(row[error.key])))) {
      parts.push(y.boundShown ? "Hollow symbols: no further from the reference than its own bound." : `Hollow symbols at the dotted line: zero${error.bounded && reference.bound > 0 ? ", or below the reference’s bound" : ""}.`);
    }
    if (error.bounded && reference.bound > 0 && !y.boundShown) parts.push(`The reference’s bound, ${formatQuantity(reference.bound, unit, 2)}, lies far below this range.`);
    if (missing.length) parts.push(`Not drawn, without a figure for this choice: ${missing.join("; ")}.`);
    const cut = rows.filter((row) => row.status && row.status !== "reached_end").map((row) => `${rowLabel(row)} (${row.status})`);
    if (cut.length) parts.push(`Did not reach the end: ${cut.join("; ")}.`);
    note.textContent = parts.join(" ");
  };

  const option = ({ width, height, narrow }) => {
    const bound = error.bounded ? reference.bound ?? 0 : 0;
    const shown = rows.filter(drawable);
    const limit = error.bounded && tolerance > 0 ? [tolerance] : [];
    const far = farBelow([...shown.map((row) => row[error.key]), ...limit]);
    const y = logAxis(shown.map((row) => row[error.key]), { bound, tickCount: 7, far, include: limit });
    const spread = work.seconds ? shown.flatMap((row) => [row.cpu_min, row.cpu_max]).filter((v) => v > 0) : [];
    const x = logAxis([...shown.map((row) => row[work.key]), ...spread], { tickCount: width < 480 ? 4 : 7 });
    explain(y, far);
    key.element.hidden = !narrow;
    key.show(groups.map((g) => ({ style: methodStyle(g.method, g.variant), name: g.name })));
    const grid = { left: 58, right: 22, top: 42, bottom: 52, outerBoundsMode: "none" };
    const toPixel = pixels({ grid, width, height, x, y });
    const marks = [];
    if (y.boundShown) {
      marks.push({ yAxis: Math.log10(y.floor), lineStyle: { type: [8, 5], color: theme().mark, width: 1.2 }, label: { formatter: `reference bound ${formatQuantity(bound, unitOf(error), 2)}`, position: "insideEndBottom", color: theme().mark, fontSize: 12, fontFamily: FONT } });
    } else if (y.floor !== null) marks.push(floorLine(y, "yAxis"));
    if (x.floor !== null) marks.push(floorLine(x, "xAxis"));
    if (limit.length && Math.log10(tolerance) > y.min) {
      marks.push({ yAxis: Math.log10(tolerance), lineStyle: { type: "solid", color: theme().limit, width: 1.5 }, label: { formatter: `tolerance ${formatQuantity(tolerance, unitOf(error), 3)}`, position: "insideStartTop", color: theme().limitText, fontSize: 12, fontFamily: FONT } });
    }

    const lines = groups.map((group) => {
      const points = group.rows.filter(({ row }) => drawable(row)).map((p) => ({ ...p, at: [x.place(p.row[work.key]), y.place(p.row[error.key])] }));
      return { group, points, style: methodStyle(group.method, group.variant), pixels: points.map((p) => toPixel(p.at)) };
    });
    const series = [];
    lines.forEach(({ group, points, style }, index) => {
      series.push({
        type: "line", name: group.name, z: 3, symbol: symbolPath(style.symbol), symbolSize: points.length === 1 ? 16 : SYMBOL, showSymbol: true, showAllSymbol: true,
        lineStyle: { color: style.color, width: style.width, type: style.dash.length ? style.dash : "solid" },
        itemStyle: { color: style.color, borderColor: style.color, borderWidth: 1.5 }, emphasis: { scale: 1.3 },
        data: points.map(({ row, index: at, at: value }) => ({ value, row: at, itemStyle: y.floored(row[error.key]) || x.floored(row[work.key]) ? { color: theme().paper } : undefined })),
        markLine: index === 0 && marks.length ? { silent: true, symbol: "none", animation: false, data: marks } : undefined,
      });
      if (work.seconds && points.length) series.push(whiskers(points, x, style.color));
    });
    series.push(textSeries(labelsOf(lines, { grid, width, height, narrow }), FONT));

    return {
      animation: false, textStyle: { fontFamily: FONT, color: theme().ink },
      grid,
      tooltip: tooltip({
        trigger: "item",
        formatter: (p) => {
          const row = rows[p.data.row];
          const value = formatQuantity(row[error.key], unitOf(error), 4);
          const below = y.floored(row[error.key]) && row[error.key] !== 0 ? (Math.abs(row[error.key]) <= bound ? " (below the reference’s bound)" : " (far below this range)") : "";
          const span = work.seconds && row.cpu_max > row.cpu_min ? ` (${formatQuantity(row.cpu_min, "s")} to ${formatQuantity(row.cpu_max, "s")})` : "";
          return `<b>${escapeHtml(rowLabel(row))}</b><br>${escapeHtml(error.name)}: ${escapeHtml(value)}${below}<br>` +
            `${escapeHtml(work.name)}: ${escapeHtml(formatQuantity(row[work.key], unitOf(work), 4))}${span}` +
            (isNumber(row.lost) ? `<br>impacts missed: ${row.lost}${row.mistimed === null ? "" : `, late: ${row.mistimed}`}` : "<br>impacts not counted");
        },
      }),
      xAxis: axis(work.name + (work.seconds ? "" : " (count)"), { nameLocation: "middle", nameGap: 32, ...decades(x, (n) => formatDecade(n, work.seconds)) }),
      yAxis: axis(withUnit(error.name, unitOf(error)), { ...above(grid.left), ...decades(y, powerOfTen) }),
      series,
    };
  };

  const chart = makeChart({
    label: `Work-precision diagram of ${comparison.title}: error against work, one line a method; the table of rows has the numbers`,
    height: (width) => (width < 480 ? 400 : 500), option,
  });
  const pick = (list, key_) => list.find((entry) => entry.key === key_);
  const options = (list) => [{ options: list.map((e) => ({ value: e.key, label: e.option })) }];
  return figure({
    title: "What accuracy costs", className: "wide",
    caption: "Work-precision diagram: lower is more accurate, further left is cheaper. One line a method, one point a step (its length beside it)." + (works[0].seconds ? " Bars: fastest and slowest repeat." : ""),
    controls: [
      choice("Error", options(errors), error.key, (value) => { error = pick(errors, value); chart.update(); }),
      choice("Work", options(works), work.key, (value) => { work = pick(works, value); chart.update(); }),
    ],
    body: [chart.element, key.element, note],
    csv: {
      name: () => `${slug(comparison.title)}-${work.key}-${error.key}`,
      table: () => [["method", "label", "dt", work.key, error.key], rows.map((row) => [row.method, rowLabel(row), row.dt, row[work.key], row[error.key]])],
    },
  });
}
