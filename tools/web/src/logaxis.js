// A logarithmic axis that can also show what has no logarithm: zeros, and values below what the reference can tell.
// The charts draw log10 on a plain axis: that is exact for 1e-40 and keeps the choice of ticks here.

import { isNumber, superscript } from "./format.js";

const EMPTY = 1e-16; // decade of the floor when there is nothing positive to measure from
const REACH = 4; // a bound further than so many decades below the data is told in words, not drawn
const FAR = 6; // decades between two groups of values from which on the lower one is drawn at the floor
const PADDING = 0.3; // decades kept free beyond the outermost points,
const ROOM = 0.07; // and this part of the axis, for the labels of points

/**
 * Where the values fall into two groups far apart (an exact method and its steppers), the largest of the lower group: on a common
 * axis the others would be squeezed into a corner. 0 if they do not.
 */
export function farBelow(values) {
  const sizes = values.filter(isNumber).map(Math.abs).filter((v) => v > 0).sort((a, b) => b - a);
  const below = sizes.find((v, i) => i > 0 && Math.log10(sizes[i - 1] / v) > FAR);
  return below ?? 0;
}

/**
 * @param {number[]} values what will be drawn; only magnitudes count
 * @param {{bound?: number, tickCount?: number, decades?: number}} options `bound`: values at or below it mean "no more than bound";
 *        `tickCount`: about so many labels fit; `decades`: the most that is shown below the largest value, smaller ones lie on the floor;
 *        `far`: values up to this lie on the floor, too; `include`: what the axis must show besides
 */
export function logAxis(values, { bound = 0, tickCount = 8, decades = Infinity, far = 0, include = [] } = {}) {
  const sizes = values.filter(isNumber).map(Math.abs);
  const largest = sizes.reduce((a, b) => Math.max(a, b), 0);
  const cut = Math.max(bound, largest * 10 ** -decades, far);
  const above = sizes.filter((v) => v > cut);
  const shown = [...above, ...include.filter((v) => above.length && v > cut)];
  const lowest = shown.reduce((a, b) => Math.min(a, b), Infinity);
  const someBelow = sizes.some((v) => v <= cut);
  const boundShown = bound > 0 && far <= bound && (above.length === 0 || Math.log10(lowest) - Math.log10(bound) <= REACH);

  let floor = null;
  if (boundShown) floor = bound;
  else if (above.length === 0) floor = EMPTY;
  else if (someBelow) floor = Number(`1e${Math.floor(Math.log10(lowest)) - 1}`);

  const low = Math.log10(floor ?? lowest);
  const high = above.length ? Math.log10(shown.reduce((a, b) => Math.max(a, b), 0)) : low + 2;
  let [min, max] = [low - PADDING, high + PADDING];
  const room = ROOM * (max - min);
  [min, max] = [min - room, max + room];
  if (max - min < 2) [min, max] = [(min + max) / 2 - 1, (min + max) / 2 + 1];
  const step = Math.max(1, Math.ceil((max - min) / tickCount));
  const floorTick = floor !== null && !boundShown ? Math.log10(floor) : null;
  const ticks = floorTick === null ? [] : [floorTick];
  for (let n = Math.ceil(min / step) * step; n <= max; n += step) if (floorTick === null || n > floorTick + step / 2) ticks.push(n === 0 ? 0 : n);

  const floored = (v) => floor !== null && Math.abs(v) <= Math.max(floor, cut);
  return {
    min, max, ticks, floor, boundShown,
    /** The tick that stands for the floor, unless that is the bound, and what to write there. */
    floorTick, floorName: far > 0 ? `≤ 10${superscript(Math.ceil(Math.log10(far)))}` : sizes.some((v) => v !== 0 && v <= cut) ? "≈ 0" : "0",
    /** Is this value drawn at the floor rather than where it is? */
    floored,
    /** Where to draw it: log10 of its magnitude, or of the floor. */
    place: (v) => (floored(v) ? Math.log10(floor) : Math.log10(Math.abs(v))),
  };
}
