// A logarithmic axis that can also show what has no logarithm: zeros, and values below what the reference can tell.
// The charts draw log10 on a plain axis: that is exact for 1e-40 and keeps the choice of ticks here.

import { isNumber } from "./format.js";

const EMPTY = 1e-16; // decade of the floor when there is nothing positive to measure from
const REACH = 4; // a bound further than so many decades below the data is told in words, not drawn
const PADDING = 0.3; // decades kept free beyond the outermost points,
const ROOM = 0.07; // and this part of the axis, for the labels of points

/**
 * @param {number[]} values what will be drawn; only magnitudes count
 * @param {{bound?: number, tickCount?: number, decades?: number}} options `bound`: values at or below it mean "no more than bound";
 *        `tickCount`: about so many labels fit; `decades`: the most that is shown below the largest value, smaller ones lie on the floor
 */
export function logAxis(values, { bound = 0, tickCount = 8, decades = Infinity } = {}) {
  const sizes = values.filter(isNumber).map(Math.abs);
  const largest = sizes.reduce((a, b) => Math.max(a, b), 0);
  const cut = Math.max(bound, largest * 10 ** -decades);
  const above = sizes.filter((v) => v > cut);
  const lowest = above.reduce((a, b) => Math.min(a, b), Infinity);
  const someBelow = sizes.some((v) => v <= cut);
  const boundShown = bound > 0 && (above.length === 0 || Math.log10(lowest) - Math.log10(bound) <= REACH);

  let floor = null;
  if (boundShown) floor = bound;
  else if (above.length === 0) floor = EMPTY;
  else if (someBelow) floor = Number(`1e${Math.floor(Math.log10(lowest)) - 1}`);

  const low = Math.log10(floor ?? lowest);
  const high = above.length ? Math.log10(above.reduce((a, b) => Math.max(a, b), 0)) : low + 2;
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
    floorTick, floorName: sizes.some((v) => v !== 0 && v <= cut) ? "≈ 0" : "0",
    /** Is this value drawn at the floor rather than where it is? */
    floored,
    /** Where to draw it: log10 of its magnitude, or of the floor. */
    place: (v) => (floored(v) ? Math.log10(floor) : Math.log10(Math.abs(v))),
  };
}
