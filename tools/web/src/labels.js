// Texts beside points and line ends, put where they cover neither each other nor the points. The charts do not do that well enough.

import { theme } from "./theme.js";

const LINE = 15; // px, height of a text
const HIT = 10; // cost of covering a text or a point; a line costs 1 for each of its samples
const SAMPLE = 7; // px between the samples of a line
const LATIN = 0.56; // width of a letter over the font's size, where no canvas is there to measure it

let pen = null;
export function textWidth(text, size, weight = 400) {
  if (typeof document === "undefined") return LATIN * size * text.length;
  pen ??= document.createElement("canvas").getContext("2d");
  pen.font = `${weight} ${size}px system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
  return pen.measureText(text).width;
}

function overlap(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/** Points every few pixels on the polyline through `points`. */
export function samples(points) {
  const list = [];
  for (let i = 1; i < points.length; ++i) {
    const [[x0, y0], [x1, y1]] = [points[i - 1], points[i]];
    const parts = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / SAMPLE));
    for (let k = 0; k <= parts; ++k) list.push({ x: x0 + ((x1 - x0) * k) / parts - 1, y: y0 + ((y1 - y0) * k) / parts - 1, width: 2, height: 2 });
  }
  return list;
}

/** Places around (x, y) for a text of this width, nearest first; each as the text's box. */
function candidates({ x, y, width, reach, rings }) {
  const list = [];
  for (let ring = 0; ring < rings; ++ring) {
    const d = reach + ring * LINE;
    const box = (left, top) => ({ x: left, y: top, width, height: LINE, ring });
    const middle = y - LINE / 2;
    list.push(box(x + d, middle), box(x - width / 2, y - d - LINE), box(x - width / 2, y + d), box(x - d - width, middle));
    for (const dy of [-d - LINE * 0.4, d - LINE * 0.6]) list.push(box(x + reach * 0.6, y + dy), box(x - width - reach * 0.6, y + dy));
  }
  return list;
}

/**
 * @param {{x: number, y: number, width: number, reach: number, required: boolean}[]} items in order of importance; `reach`: px from the point
 * @param {{x: number, y: number, width: number, height: number}[]} solid what must not be covered
 * @param {object[]} light boxes that may be covered if need be
 * @param {{x: number, y: number, width: number, height: number}} bounds where texts may be
 * @returns {(object|null)[]} a box for each item, null where there is no room for one that is not required
 */
export function placeLabels(items, solid, light, bounds) {
  const taken = [...solid];
  return items.map((item) => {
    let best = null;
    for (const box of candidates({ ...item, rings: item.required ? 7 : 4 })) {
      if (box.x < bounds.x || box.y < bounds.y || box.x + box.width > bounds.x + bounds.width || box.y + box.height > bounds.y + bounds.height) continue;
      const cost = box.ring * 3 + taken.filter((t) => overlap(box, t)).length * HIT + light.filter((t) => overlap(box, t)).length;
      if (!best || cost < best.cost) best = { ...box, cost };
    }
    if (!best || (!item.required && best.cost >= HIT)) return null;
    taken.push(best);
    return best;
  });
}

/** Heights of texts in one column, each as near to its own as the others let it, within [top, bottom]. */
export function spread(heights, top, bottom, gap = LINE) {
  const order = heights.map((y, i) => ({ y, i })).sort((a, b) => a.y - b.y || a.i - b.i);
  const placed = [];
  for (const { y } of order) placed.push(Math.max(y, placed.length ? placed.at(-1) + gap : top));
  let limit = bottom;
  for (let k = placed.length - 1; k >= 0; --k) {
    placed[k] = Math.min(placed[k], limit);
    limit = placed[k] - gap;
  }
  const result = [];
  order.forEach(({ i }, k) => { result[i] = placed[k]; });
  return result;
}

/** A series that writes texts at pixels. texts: {text, x, y (its middle), color, size, weight, from?: [x, y] of a leader} */
export function textSeries(texts, family) {
  return {
    type: "custom", silent: true, z: 6, tooltip: { show: false }, data: texts.map((_, i) => [i]), coordinateSystem: "none",
    renderItem: (params) => {
      const { text, x, y, color, size, weight = 400, from } = texts[params.dataIndex];
      const children = [{
        type: "text",
        style: { text, x, y, fill: color, font: `${weight} ${size}px ${family}`, textVerticalAlign: "middle", verticalAlign: "middle", stroke: theme().paper, lineWidth: 3 },
      }];
      if (from) children.unshift({ type: "line", shape: { x1: from[0], y1: from[1], x2: from[2], y2: from[3] }, style: { stroke: color, lineWidth: 0.8 } });
      return { type: "group", children };
    },
  };
}
