// Planes in the picture: a line with hatching on the solid side, plates as bars, and their names.

import { theme } from "./theme.js";

const LEAST_PLATE = 4; // px
const HATCH = 9; // px between strokes, and their depth

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

/** The plane, unless it is parallel to the view. `map`: see projection() in view_draw.js. */
export function drawPlane(context, view, plane, map) {
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
  context.strokeStyle = theme().plane;
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
    context.fillStyle = theme().plate;
    context.fill();
    context.lineWidth = 1;
    context.stroke();
    context.restore();
    return;
  }
  const ends = surface(context, p, tangent, map.rect);
  if (!ends) return;
  context.lineWidth = 1;
  context.strokeStyle = theme().hatch;
  hatch(context, p, tangent, solid, ends, HATCH);
}

/** Its name: beside a plate, on the solid side of a half-space. */
export function namePlane(context, view, plane, map) {
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
  context.strokeStyle = theme().paper;
  context.strokeText(plane.name, 0, 0);
  context.fillStyle = theme().plane;
  context.fillText(plane.name, 0, 0);
  context.restore();
}
