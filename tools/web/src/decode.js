// Tracks of the picture: base64 of little-endian uint16, frame by frame, sphere by sphere, axis by axis.

const FULL = 65535;

/** @returns {Uint16Array} frames * spheres * 2 values */
export function decodeTrack(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const words = new DataView(bytes.buffer);
  return Uint16Array.from({ length: bytes.length >> 1 }, (_, i) => words.getUint16(2 * i, true));
}

/** The frame at or before `time`, and how far the next one has come (0 to 1). */
export function frameAt(times, time) {
  let [low, high] = [0, times.length - 1];
  if (time >= times[high]) return { frame: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  const span = times[high] - times[low];
  return { frame: low, part: span > 0 ? Math.min(1, Math.max(0, (time - times[low]) / span)) : 0 };
}

/**
 * Positions of all spheres at a time, straight between frames; a jump over half of the view (periodic images) is not drawn as a flight.
 * @returns {{x: number, y: number, outside: boolean}[]} in the view's length unit; `outside`: at or beyond the edge of what was recorded
 */
export function positionsAt(view, words, time) {
  const count = view.radius.length;
  const { frame, part } = frameAt(view.times, time);
  const place = (value, axis) => view.min[axis] + ((view.max[axis] - view.min[axis]) * value) / FULL;
  const coordinate = (sphere, axis) => {
    const at = words[(frame * count + sphere) * 2 + axis];
    const next = part > 0 ? words[((frame + 1) * count + sphere) * 2 + axis] : at;
    return Math.abs(next - at) > FULL / 2 && view.periodic ? at : at + (next - at) * part;
  };
  return Array.from({ length: count }, (_, sphere) => {
    const [a, b] = [coordinate(sphere, 0), coordinate(sphere, 1)];
    return { x: place(a, 0), y: place(b, 1), outside: a <= 0 || a >= FULL || b <= 0 || b >= FULL };
  });
}
