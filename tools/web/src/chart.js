// One chart in the page: made when it comes near the window, redrawn when its width changes, disposed of with its element.

import { CustomChart, LineChart, ScatterChart } from "echarts/charts";
import { GridComponent, MarkLineComponent, TooltipComponent } from "echarts/components";
import { init, use } from "echarts/core";
import { SVGRenderer } from "echarts/renderers";
import { h } from "./dom.js";
import { SYMBOLS } from "./styles.js";
import { theme } from "./theme.js";

use([CustomChart, LineChart, ScatterChart, GridComponent, MarkLineComponent, TooltipComponent, SVGRenderer]);

export const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif';
const NEAR = "800px"; // charts further from the window than this wait
const NARROW = 520; // below this width keys stand below the chart, not at the line ends

export function symbolPath(name) {
  return `path://${SYMBOLS[name]}`;
}

/** What all axes share. */
export function axis(name, extra = {}) {
  return {
    type: "value", name, nameTextStyle: { color: theme().ink, fontSize: 13, fontWeight: 600, fontFamily: FONT },
    axisLine: { show: true, onZero: false, lineStyle: { color: theme().axis } }, axisTick: { show: true, ...extra.axisTick },
    axisLabel: { color: theme().muted, fontSize: 12, hideOverlap: true, ...extra.axisLabel },
    splitLine: { lineStyle: { color: theme().grid } },
    ...Object.fromEntries(Object.entries(extra).filter(([key]) => key !== "axisTick" && key !== "axisLabel")),
  };
}

/** Name of the upward axis: written flat above it, where it can be read. */
export function above(left) {
  return { nameLocation: "end", nameGap: 14, nameTextStyle: { align: "left", padding: [0, 0, 0, -left + 4], color: theme().ink, fontSize: 13, fontWeight: 600, fontFamily: FONT } };
}

/** Pixels of a point, for grids that state their margins. */
export function pixels({ grid, width, height, x, y }) {
  const [w, h_] = [width - grid.left - grid.right, height - grid.top - grid.bottom];
  return ([a, b]) => [grid.left + ((a - x.min) / (x.max - x.min)) * w, grid.top + (1 - (b - y.min) / (y.max - y.min)) * h_];
}

/** A line across the chart at the floor of a logarithmic axis. */
export function floorLine(scale, key) {
  return { [key]: Math.log10(scale.floor), lineStyle: { type: [2, 3], color: theme().mark, width: 1.2 }, label: { show: false } };
}

/** Ticks of an axis that shows log10 values (see logaxis.js). */
export function decades(scale, format) {
  const write = (n) => (n === scale.floorTick ? scale.floorName : format(Math.round(n)));
  return {
    min: scale.min, max: scale.max,
    axisLabel: { customValues: scale.ticks, formatter: write }, axisTick: { customValues: scale.ticks },
  };
}

export function tooltip(extra) {
  return { confine: true, backgroundColor: theme().paper, borderColor: theme().axis, textStyle: { color: theme().ink, fontSize: 13, fontFamily: FONT }, extraCssText: "max-width:min(420px,90%);white-space:normal;", ...extra };
}

const charts = new Set(); // in the page
/** Draws charts that were not yet near the window: paper shows all. */
export function drawAllCharts() {
  charts.forEach((chart) => chart.drawNow());
}

/**
 * @param {{label: string, height: (width: number) => number, option: (size: {width: number, height: number, narrow: boolean}) => object}} spec
 * @returns {{element: HTMLElement, update: () => void}}
 */
export function makeChart({ label, height, option }) {
  const element = h("div", { class: "chart", role: "img", "aria-label": label });
  let chart = null;
  let width = 0;

  const draw = () => {
    if (!chart) return;
    chart.resize({ width, height: height(width) });
    element.style.height = `${height(width)}px`;
    chart.setOption(option({ width, height: height(width), narrow: width < NARROW }), { notMerge: true });
  };
  const start = () => {
    if (chart || width === 0) return;
    chart = init(element, null, { renderer: "svg", width, height: height(width) });
    draw();
  };

  let near = false;
  const resizer = new ResizeObserver(() => {
    if (!element.isConnected) { // taken out of the page
      chart?.dispose();
      chart = null;
      charts.delete(self);
      return;
    }
    const now = Math.floor(element.clientWidth);
    if (now === width || now === 0) return;
    width = now;
    requestAnimationFrame(() => { // not in the observer itself: this changes heights, which would call it again
      element.style.height = `${height(width)}px`;
      if (chart) draw();
      else if (near) start();
    });
  });
  resizer.observe(element);
  const watcher = new IntersectionObserver((entries) => {
    if (!entries.some((e) => e.isIntersecting)) return;
    near = true;
    watcher.disconnect();
    start();
  }, { rootMargin: NEAR });
  watcher.observe(element);
  const self = {
    drawNow: () => {
      width ||= Math.floor(element.clientWidth);
      start();
    },
  };
  charts.add(self);
  return { element, update: draw };
}
