// The side view, drawn: planes with hatching on their solid side, spheres, their paths. Pure drawing; the controls are in view.js.

import { positionsAt } from "./decode.js";
import { formatQuantity } from "./format.js";

const MARGIN = 30; // px around the view's box, for planes and their names
const LEAST_RADIUS = 4; // px, so that a bullet on a range is seen
const LEAST_PLATE = 4; // px
const LONGEST = 8; // sides of a view further apart than this get scales of their own
const HATCH = 9; // px between strokes, and their depth
export const FEW = 12; // up to so many spheres have their paths drawn
const NAMED = 10; // up to so many planes are named

/**
 * From the view to pixels, centred in `rect` {x, y, width, height}: one scale for both axes, unless the view is so long and flat
 * (or tall and narrow) that nothing would be seen; then each axis fills its side. `stretch`: upward scale over rightward scale.
 */
export function projection(view, rect) {
  const room = [rect.width - 2 * MARGIN, rect.height - 2 * MARGIN];
  const span = [0, 1].map((axis) => view.max[axis] - view.min[axis]);
  const fit = [room[0] / span[0], room[1] / span[1]];
  const least = Math.min(...fit);
  const scale = isStretched(view) ? fit : [least, least];
  const [cx, cy] = [0, 1].map((axis) => (view.min[axis] + view.max[axis]) / 2);
  return {
    scale, rect, stretch: scale[1] / scale[0],
    x: (a) => rect.x + rect.width / 2 + (a - cx) * scale[0], y: (b) => rect.y + rect.height / 2 - (b - cy) * scale[1],
  };
}

function aspectOf(view) {
  return (view.max[1] - view.min[1]) / (view.max[0] - view.min[0]);
}

function isStretched(view) {
  return aspectOf(view) < 1 / LONGEST || aspectOf(view) > LONGEST;
}

/** Height that suits the view at this width. */
export function suitableHeight(view, width) {
  const asked = isStretched(view) ? (aspectOf(view) < 1 ? 230 : 460) : (width - 2 * MARGIN) * aspectOf(view) + 2 * MARGIN;
  return Math.round(Math.min(430, Math.max(170, asked)));
}

export function isEnlarged(view, map) {
  return view.radius.some((r) => r * Math.min(...map.scale) < LEAST_RADIUS);
}

/** The part of the line through `p` along `d` inside `rect`, as two ends; null if it passes by. */
function clip(p, d, rect) {
  let [from, to] = [-Infinity, Infinity];
  for (const [start, along, low, high] of [[p.x, d.x, rect.x, rect.x + rect.width], [p.y, d.y, rect.y, rect.y + rect.height]]) {
    if (Math.abs(along) < 1e-12) {
      if (start < low || start > high) return null;
      continue;
    }
    const [a, b] = [(low - start) / along, (high - start) / along];
    from = Math.max(from, Math.min(a, b));
    to = Math.min(to, Math.max(a, b));
  }
  return from < to ? { from, to } : null;
}

function surface(context, p, tangent, rect) {
  const ends = clip(p, tangent, rect);
  if (!ends) return null;
  context.beginPath();
  context.moveTo(p.x + tangent.x * ends.from, p.y + tangent.y * ends.from);
  context.lineTo(p.x + tangent.x * ends.to, p.y + tangent.y * ends.to);
  context.stroke();
  return ends;
}

/** Slanted strokes from the line into its solid side, `depth` px deep. */
function hatch(context, p, tangent, solid, ends, depth) {
  context.beginPath();
  for (let s = Math.ceil(ends.from / HATCH) * HATCH; s < ends.to; s += HATCH) {
    const [x, y] = [p.x + tangent.x * s, p.y + tangent.y * s];
    context.moveTo(x, y);
    context.lineTo(x + (solid.x - tangent.x) * depth, y + (solid.y - tangent.y) * depth);
  }
  context.stroke();
}

function drawPlane(context, view, plane, map) {
  const length = Math.hypot(plane.normal[0], plane.normal[1]);
  if (!(length > 1e-9)) return;
  const n = [plane.normal[0] / length, plane.normal[1] / length];
  const offset = plane.offset / length;
  const isPlate = plane.thickness !== null && plane.thickness !== undefined;
  // In pixels (the other way up, each axis at its own scale): along the surface, and square to it into the solid.
  const [tx, ty] = [n[1] * map.scale[0], n[0] * map.scale[1]];
  const tangent = { x: tx / Math.hypot(tx, ty), y: ty / Math.hypot(tx, ty) };
  const solid = { x: -tangent.y, y: tangent.x };
  const deep = n[0] * map.scale[0] * tangent.y + n[1] * map.scale[1] * tangent.x; // px for each unit along the normal
  // The point of the plane next to the middle of the view: far feet lose digits.
  const middle = [(view.min[0] + view.max[0]) / 2, (view.min[1] + view.max[1]) / 2];
  const away = offset - (n[0] * middle[0] + n[1] * middle[1]);
  const p = { x: map.x(middle[0] + n[0] * away), y: map.y(middle[1] + n[1] * away) };
  context.strokeStyle = "#3b4754";
  context.lineWidth = 1.6;
  if (isPlate) {
    const half = Math.max(LEAST_PLATE, plane.thickness * Math.abs(deep)) / 2;
    const ends = clip(p, tangent, map.rect);
    if (!ends) return;
    context.save();
    context.beginPath();
    for (const [side, end] of [[1, ends.from], [1, ends.to], [-1, ends.to], [-1, ends.from]])
      context.lineTo(p.x + tangent.x * end + solid.x * half * side, p.y + tangent.y * end + solid.y * half * side);
    context.closePath();
    context.fillStyle = "#8e9aa8";
    context.fill();
    context.lineWidth = 1;
    context.stroke();
    context.restore();
    return;
  }
  const ends = surface(context, p, tangent, map.rect);
  if (!ends) return;
  context.lineWidth = 1;
  context.strokeStyle = "#8b97a4";
  hatch(context, p, tangent, solid, ends, HATCH);
}

function namePlane(context, view, plane, map) {
  const length = Math.hypot(plane.normal[0], plane.normal[1]);
  if (!(length > 1e-9) || !plane.name) return;
  const [nx, ny] = [plane.normal[0] / length, plane.normal[1] / length];
  const flat = Math.abs(ny) > 0.5;
  const isPlate = plane.thickness !== null && plane.thickness !== undefined;
  context.font = "12px system-ui, sans-serif";
  const width = context.measureText(plane.name).width;
  const { rect } = map;
  const offset = plane.offset / length;
  let [x, y, turn] = [0, 0, 0];
  if (flat) {
    const a = view.min[0] + 0.02 * (view.max[0] - view.min[0]);
    x = Math.max(rect.x + 4, map.x(a));
    y = map.y((offset - nx * a) / ny) + (isPlate ? -8 : ny > 0 ? 21 : -14);
  } else {
    const b = view.max[1];
    const top = map.y(b);
    x = map.x((offset - ny * b) / nx);
    if (isPlate) [x, y] = [x + width + 8 < rect.x + rect.width ? x + 7 : x - width - 7, rect.y + 15];
    else [x, y, turn] = [x + (nx > 0 ? -13 : 21), top + width + 8, -Math.PI / 2];
  }
  if (x < rect.x - 2 || x > rect.x + rect.width || y < rect.y || y > rect.y + rect.height + 2) return;
  context.save();
  context.translate(x, y);
  context.rotate(turn);
  context.lineWidth = 4;
  context.strokeStyle = "#fff";
  context.strokeText(plane.name, 0, 0);
  context.fillStyle = "#3b4754";
  context.fillText(plane.name, 0, 0);
  context.restore();
}

function disc(context, x, y, [across, up]) {
  context.beginPath();
  context.ellipse(x, y, across, up, 0, 0, 2 * Math.PI);
}

/** A mark at the edge for a sphere that has left what was recorded. */
function gone(context, x, y, map, color) {
  const { rect } = map;
  const [cx, cy] = [rect.x + rect.width / 2, rect.y + rect.height / 2];
  const angle = Math.atan2(y - cy, x - cx);
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(10, 0);
  context.lineTo(-2, -6);
  context.lineTo(-2, 6);
  context.closePath();
  context.fillStyle = color;
  context.fill();
  context.stroke();
  context.restore();
}

function drawPath(context, view, words, map, until) {
  const count = view.radius.length;
  for (let sphere = 0; sphere < count; ++sphere) {
    context.beginPath();
    let last = null;
    for (const time of [...view.times.filter((t) => t < until), Math.min(until, view.times.at(-1))]) {
      const { x, y, outside } = positionsAt(view, words, time)[sphere];
      const jump = last && view.periodic && (Math.abs(x - last.x) > (view.max[0] - view.min[0]) / 2 || Math.abs(y - last.y) > (view.max[1] - view.min[1]) / 2);
      if (last && !jump) context.lineTo(map.x(x), map.y(y));
      else context.moveTo(map.x(x), map.y(y));
      last = outside ? null : { x, y }; // beyond the edge its place is unknown: the path ends there, or begins there
    }
    context.stroke();
  }
}

/**
 * @param {{rect: object, time: number, reference: Uint16Array|null, method: Uint16Array|null, color: string, caption: string}} panel
 *        `reference` is drawn as outlines with a dashed path, `method` as filled discs with a full path
 */
export function drawPanel(context, view, panel) {
  const map = projection(view, panel.rect);
  const { rect } = panel;
  context.save();
  context.beginPath();
  context.rect(rect.x, rect.y, rect.width, rect.height);
  context.clip();
  context.fillStyle = "#fff";
  context.fillRect(rect.x, rect.y, rect.width, rect.height);
  (view.planes ?? []).forEach((plane) => drawPlane(context, view, plane, map));
  const few = view.radius.length <= FEW;
  const size = (i, more = 0) => map.scale.map((s) => Math.max(LEAST_RADIUS, view.radius[i] * s) + more);

  if (few && panel.reference) {
    Object.assign(context, { strokeStyle: "#5d6875", lineWidth: 1.2 });
    context.setLineDash([4, 4]);
    drawPath(context, view, panel.reference, map, Infinity);
    context.setLineDash([]);
  }
  if (few && panel.method) {
    Object.assign(context, { strokeStyle: panel.color, lineWidth: 2 });
    drawPath(context, view, panel.method, map, panel.time);
  }
  const ghosts = panel.reference ? positionsAt(view, panel.reference, panel.time) : [];
  const solids = panel.method ? positionsAt(view, panel.method, panel.time) : [];
  solids.forEach(({ x, y, outside }, i) => {
    const [px, py] = [map.x(x), map.y(y)];
    Object.assign(context, { strokeStyle: "#1d2733", lineWidth: 1, fillStyle: view.color?.[i] || panel.color });
    if (outside) return gone(context, px, py, map, view.color?.[i] || panel.color);
    disc(context, px, py, size(i));
    context.fill();
    context.stroke();
  });
  ghosts.forEach(({ x, y }, i) => {
    const [px, py] = [map.x(x), map.y(y)];
    Object.assign(context, { strokeStyle: "#000", lineWidth: few ? 2 : 1.1 });
    context.setLineDash(Math.min(...size(i)) > 6 ? [5, 3] : []);
    disc(context, px, py, size(i, solids.length ? 1.5 : 0));
    context.stroke();
    context.setLineDash([]);
  });
  if ((view.planes ?? []).length <= NAMED) (view.planes ?? []).forEach((plane) => namePlane(context, view, plane, map));
  context.restore();
  return map;
}

/** A bar of a round length in the lower right corner. */
export function drawScaleBar(context, map, unit) {
  const { rect } = map;
  const scale = map.scale[0];
  const wanted = 90 / scale;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  const length = decade * [1, 2, 5, 10].findLast((m) => m * decade <= wanted);
  const px = length * scale;
  const [right, y] = [rect.x + rect.width - 10, rect.y + rect.height - 9];
  const text = formatQuantity(length, unit);
  context.font = "12px system-ui, sans-serif";
  const width = Math.max(px, context.measureText(text).width) + 12;
  context.fillStyle = "rgba(255,255,255,.85)";
  context.fillRect(right - width + 4, y - 19, width + 2, 26);
  Object.assign(context, { strokeStyle: "#1d2733", lineWidth: 1.5, fillStyle: "#1d2733", textAlign: "right" });
  context.beginPath();
  context.moveTo(right - px, y - 4);
  context.lineTo(right - px, y);
  context.lineTo(right, y);
  context.lineTo(right, y - 4);
  context.stroke();
  context.fillText(text, right, y - 6);
  context.textAlign = "left";
}
