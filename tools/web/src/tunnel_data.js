// The data of the page of `carom tunnel` (src/report/tunnel_page.hpp): rows as objects, and what is asked of them. No DOM.

/** [{column: value}] from names and rows of values. */
export function objects(columns, rows) {
  return (rows ?? []).map((row) => Object.fromEntries(columns.map((name, i) => [name, row[i]])));
}

/** "fcl_naive, linear, indep": method with what tells its rows apart. */
export function lineName(row) {
  return [row.method, row.integrator === "parabola" ? "parabola" : "", row.variant].filter(Boolean).join(", ");
}

/** Different values of a column, in the order of the rows; null among them where a row has none. */
export function valuesOf(rows, key) {
  return [...new Set(rows.map((row) => row[key]))];
}

/** Laws of the curve: share missed of throws with random phase (and offset, at a sphere) at x = v dt / reach, by chords seen. */
export function share(target, chords, x) {
  const seen = chords / x;
  if (target === "plate") return Math.max(0, 1 - seen);
  if (target === "sphere") return seen <= 1 ? 1 - (2 * seen) / 3 : 1 / (3 * seen * seen);
  return 0;
}

/** Chords that a method sees, from the critical numbers of its rows: read off a row with a law strictly between 0 and 1. */
export function chordsOf(rows) {
  const row = rows.find((r) => r.target === "plate" && r.law > 0 && r.law < 1);
  if (row) return (1 - row.law) * row.number;
  const ball = rows.find((r) => r.target === "sphere" && r.law > 0 && r.law < 1);
  if (!ball) return null;
  return ball.law >= 1 / 3 ? 1.5 * (1 - ball.law) * ball.number : ball.number / Math.sqrt(3 * ball.law);
}

/** The throw that shows a row, as a scene file: the same that carom threw, bit for bit, if sums are taken in its order. */
export function throwScene(row) {
  const { radius, thickness, speed, dt, target, example_phase: phase, example_offset: offset } = row;
  const reach = target === "sphere" ? radius + thickness / 2 : radius + (thickness ?? 0) / 2;
  const across = offset * reach;
  const chord = Math.sqrt((reach - across) * (reach + across));
  const ball = { id: "ball", radius, position: [-(chord + phase * speed * dt), 0, across], velocity: [speed, 0, 0] };
  const scene = { format: "carom-scene/1", name: `${row.method} at a ${target}`, end_time: 3 * dt, spheres: [ball] };
  if (target === "sphere") scene.spheres.push({ id: target, radius: thickness / 2, position: [0, 0, 0], fixed: true });
  else scene.planes = [{ id: target, normal: [-1, 0, 0], offset: 0, ...(target === "plate" ? { thickness } : {}) }];
  const isCaroms = row.variant === "" && (row.method === "event" || Boolean(row.integrator)); // no default for libraries and engines of others
  if (isCaroms) scene.run = { method: row.method, ...(row.integrator ? { dt, integrator: row.integrator } : {}) };
  if (isCaroms) scene.compare = { dt: [dt] };
  return scene;
}
