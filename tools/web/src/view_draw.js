// The picture, drawn: planes, spheres, their paths. Pure drawing; the controls are in view.js.

import { positionsAt } from "./decode.js";
import { formatQuantity } from "./format.js";
import { theme } from "./theme.js";
import { drawPlane, namePlane } from "./view_planes.js";

const MARGIN = 30; // px around the view's box, for planes and their names
const LEAST_RADIUS = 4; // px, so that a bullet on a range is seen
const LONGEST = 8; // sides of a view further apart than this get scales of their own
const HIGHEST = 430; // px
export const FEW = 12; // up to so many spheres have their paths drawn
const NAMED = 10; // up to so many planes are named

/**
 * From the view to pixels, centred in `rect` {x, y, width, height}: one scale for both axes, unless the view is so long and flat
 * (or tall and narrow) that nothing would be seen; then each axis fills its side, and spheres are dots. `stretch`: upward scale over rightward scale.
 */
export function projection(view, rect) {
  const room = [rect.width - 2 * MARGIN, rect.height - 2 * MARGIN];
  const span = [0, 1].map((axis) => view.max[axis] - view.min[axis]);
  const fit = [room[0] / span[0], room[1] / span[1]];
  const least = Math.min(...fit);
  const scale = isStretched(view, rect.width) ? fit : [least, least];
  const [cx, cy] = [0, 1].map((axis) => (view.min[axis] + view.max[axis]) / 2);
  return {
    scale, rect, stretch: scale[1] / scale[0],
    x: (a) => rect.x + rect.width / 2 + (a - cx) * scale[0], y: (b) => rect.y + rect.height / 2 - (b - cy) * scale[1],
  };
}

function aspectOf(view) {
  return (view.max[1] - view.min[1]) / (view.max[0] - view.min[0]);
}

/** With one scale, would spheres in the highest view of this width be too small to be seen? */
function isStretched(view, width) {
  if (aspectOf(view) >= 1 / LONGEST && aspectOf(view) <= LONGEST) return false;
  const scale = Math.min((width - 2 * MARGIN) / (view.max[0] - view.min[0]), (HIGHEST - 2 * MARGIN) / (view.max[1] - view.min[1]));
  return Math.max(...view.radius) * scale < LEAST_RADIUS;
}

/** Height that suits the view at this width. */
export function suitableHeight(view, width) {
  const asked = isStretched(view, width) ? (aspectOf(view) < 1 ? 230 : HIGHEST) : (width - 2 * MARGIN) * aspectOf(view) + 2 * MARGIN;
  return Math.round(Math.min(HIGHEST, Math.max(170, asked)));
}

/** How the spheres are drawn, in words, unless it is as large as they are. */
export function sizeNote(view, map) {
  if (map.stretch !== 1) return "Spheres are dots of one size, to be seen at all.";
  return view.radius.some((r) => r * map.scale[0] < LEAST_RADIUS) ? "Small spheres are drawn larger than they are, to be seen at all." : "";
}

function disc(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
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
  context.fillStyle = theme().paper;
  context.fillRect(rect.x, rect.y, rect.width, rect.height);
  (view.planes ?? []).forEach((plane) => drawPlane(context, view, plane, map));
  const few = view.radius.length <= FEW;
  const size = (i, more = 0) => (map.stretch === 1 ? Math.max(LEAST_RADIUS, view.radius[i] * map.scale[0]) : LEAST_RADIUS) + more;

  if (few && panel.reference) {
    Object.assign(context, { strokeStyle: theme().reference, lineWidth: 1.2 });
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
    Object.assign(context, { strokeStyle: theme().ink, lineWidth: 1, fillStyle: view.color?.[i] || panel.color });
    if (outside) return gone(context, px, py, map, view.color?.[i] || panel.color);
    disc(context, px, py, size(i));
    context.fill();
    context.stroke();
  });
  ghosts.forEach(({ x, y }, i) => {
    const [px, py] = [map.x(x), map.y(y)];
    Object.assign(context, { strokeStyle: theme().ghost, lineWidth: few ? 2 : 1.1 });
    context.setLineDash(size(i) > 6 ? [5, 3] : []);
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
  context.fillStyle = theme().veil;
  context.fillRect(right - width + 4, y - 19, width + 2, 26);
  Object.assign(context, { strokeStyle: theme().ink, lineWidth: 1.5, fillStyle: theme().ink, textAlign: "right" });
  context.beginPath();
  context.moveTo(right - px, y - 4);
  context.lineTo(right - px, y);
  context.lineTo(right, y);
  context.lineTo(right, y - 4);
  context.stroke();
  context.fillText(text, right, y - 6);
  context.textAlign = "left";
}
