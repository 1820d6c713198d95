// The dimensionless curve: share missed against v dt / (radius + thickness/2), every method's cells with their intervals, the law drawn.

import { above, axis, FONT, makeChart, symbolPath, tooltip } from "./chart.js";
import { choice } from "./dom.js";
import { figure, makeKey } from "./figure.js";
import { escapeHtml, formatNumber, formatStep, isNumber, powerOfTen } from "./format.js";
import { methodStyle } from "./styles.js";
import { theme } from "./theme.js";
import { chordsOf, lineName, share, valuesOf } from "./tunnel_data.js";

const POINTS_OF_LAW = 200;
const ALL = "all methods";

function whiskers(points, color) {
  return {
    type: "custom", silent: true, z: 1, tooltip: { show: false }, encode: { x: 0, y: [1, 2] },
    data: points.filter((row) => isNumber(row.share_low)).map((row) => [Math.log10(row.number), row.share_low, row.share_high]),
    renderItem: (_, api) => {
      const [x, low] = api.coord([api.value(0), api.value(1)]);
      const [, high] = api.coord([api.value(0), api.value(2)]);
      return { type: "line", shape: { x1: x, y1: low, x2: x, y2: high }, style: { stroke: color, lineWidth: 1.2 } };
    },
  };
}

function lawLine(target, chords, [low, high]) {
  const data = Array.from({ length: POINTS_OF_LAW + 1 }, (_, i) => low + ((high - low) * i) / POINTS_OF_LAW)
    .map((log) => [log, share(target, chords, 10 ** log)]);
  return { type: "line", data, showSymbol: false, silent: true, z: 2, lineStyle: { color: theme().ink, width: 1.5, type: "solid" }, tooltip: { show: false } };
}

export function curveFigure({ rows, title, scene }) {
  const targets = valuesOf(rows, "target");
  const names = valuesOf(rows.map((row) => ({ name: lineName(row) })), "name");
  let target = targets[0];
  let shown = ALL;
  const key = makeKey();
  const drawn = () => rows.filter((row) => row.target === target && isNumber(row.share) && row.number > 0 && (shown === ALL || lineName(row) === shown));

  const option = ({ narrow }) => {
    const points = drawn();
    const lines = valuesOf(points.map((row) => ({ name: lineName(row) })), "name").map((name) => {
      const own = points.filter((row) => lineName(row) === name);
      return { name, own, style: methodStyle(own[0].method) };
    });
    const methods = valuesOf(points, "method");
    key.show(methods.map((name) => ({ name, style: { ...methodStyle(name), dash: [0, 40] } })));
    const logs = points.map((row) => Math.log10(row.number));
    const range = points.length ? [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))] : [-1, 1];
    // At a sphere of a scene all throws have one offset, of which the rows alone tell the law.
    const laws = scene && target === "sphere" ? [] : [...new Set(lines.map(({ name }) => chordsOf(rows.filter((row) => lineName(row) === name))).filter(isNumber).map((k) => Number(k.toPrecision(6))))];
    const step = Math.max(1, Math.ceil((range[1] - range[0]) / (narrow ? 4 : 8)));
    const ticks = Array.from({ length: Math.floor((range[1] - range[0]) / step) + 1 }, (_, i) => range[0] + i * step);
    return {
      animation: false, textStyle: { fontFamily: FONT, color: theme().ink },
      grid: { left: 52, right: 22, top: 42, bottom: 52, outerBoundsMode: "none" },
      tooltip: tooltip({
        trigger: "item",
        formatter: ({ data: { row } }) => `<b>${escapeHtml(lineName(row))}</b><br>${formatNumber(row.tunnelled)} of ${formatNumber(row.trials)} tunnelled, ${formatNumber(row.wrong)} wrong` +
          `<br>speed ${formatNumber(row.speed)}, radius ${formatNumber(row.radius)}${isNumber(row.thickness) ? `, thickness ${formatNumber(row.thickness)}` : ""}, dt ${formatStep(row.dt)}` +
          (isNumber(row.law) ? `<br>law: ${formatNumber(row.law, 4)}` : ""),
      }),
      xAxis: axis("v dt / (radius + thickness/2)", {
        nameLocation: "middle", nameGap: 32, min: range[0], max: range[1],
        axisLabel: { customValues: ticks, formatter: (n) => powerOfTen(Math.round(n)) }, axisTick: { customValues: ticks },
      }),
      yAxis: axis("share missed", { ...above(52), min: 0, max: 1 }),
      series: [
        ...laws.map((chords) => lawLine(target, chords, range)),
        ...lines.flatMap(({ name, own, style }) => [
          { type: "scatter", name, z: 3, symbol: symbolPath(style.symbol), symbolSize: 8, itemStyle: { color: style.color }, data: own.map((row) => ({ value: [Math.log10(row.number), row.share], row })) },
          whiskers(own, style.color),
        ]),
      ],
    };
  };

  const chart = makeChart({ label: `Share of throws missed of ${title} against v dt over reach, one symbol a method; the map below has the numbers`, height: (width) => (width < 480 ? 380 : 460), option });
  const options = (list) => [{ options: list.map((each) => ({ value: each, label: each })) }];
  return figure({
    title: "One curve for every size, speed and step", className: "full",
    caption: "Share of throws that went through, one point a cell of the matrix; bars are intervals of 95 %. Lines: the law. A method that looks once a step and answers what approaches misses a plate with probability max(0, 1 − (r + thickness/2)/(v dt)); one that answers on both sides of the middle sees twice as far, FCL’s ten poses eighteen times.",
    controls: [
      choice("Thrown at", options(targets), target, (value) => { target = value; chart.update(); }),
      choice("Shown", options([ALL, ...names]), shown, (value) => { shown = value; chart.update(); }),
    ],
    body: [chart.element, key.element],
    csv: {
      name: () => `tunnel-curve-${target}`,
      table: () => [["method", "number", "share", "share_low", "share_high", "law"], drawn().map((row) => [lineName(row), row.number, row.share, row.share_low, row.share_high, row.law])],
    },
  });
}
