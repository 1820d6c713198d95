// Data for looking at the page and for its tests: small simulations of spheres that meet planes only, in two dimensions.
// Errors and impacts are computed, run times are invented. No figure of carom itself comes from here.
//   node example.mjs > example.json

import { fileURLToPath } from "node:url";

const SAMPLES = 200;
const SECONDS_A_STEP = { velocity: 3.1e-8, pbd: 4.4e-8, bisection: 9e-8, naive: 2.2e-8 };

const dot = (a, b) => a[0] * b[0] + a[1] * b[1];
const along = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1]];

function gapOf(scene, plane, radius, position, side) {
  const height = dot(plane.normal, position) - plane.offset;
  return plane.thickness === null ? height - radius : side * height - radius - plane.thickness / 2;
}

function sideOf(plane, position) {
  return plane.thickness === null || dot(plane.normal, position) >= plane.offset ? 1 : -1;
}

/** Bounce at a plane: e on the normal part. */
function reflect(scene, plane, velocity, side) {
  const normal = plane.normal.map((c) => c * side);
  const approach = dot(velocity, normal);
  return approach < 0 ? along(velocity, -(1 + scene.e) * approach, normal) : velocity;
}

/** Exact flights of one sphere: [{t, x, v, rest}], and its impacts. */
function exact(scene, sphere) {
  let [t, x, v] = [0, sphere.position, sphere.velocity];
  const flights = [{ t, x, v }];
  const impacts = [];
  for (let n = 0; n < 20000 && t < scene.until; ++n) {
    let best = { dt: Infinity };
    for (const plane of scene.planes) {
      const side = sideOf(plane, x);
      const normal = plane.normal.map((c) => c * side);
      const [a, b, c] = [dot(scene.gravity, normal) / 2, dot(v, normal), gapOf(scene, plane, sphere.radius, x, side)];
      const disc = b * b - 4 * a * c;
      if (disc < 0) continue;
      const q = -0.5 * (b + Math.sign(b || 1) * Math.sqrt(disc));
      for (const root of [q / a, c / q]) {
        if (root > 1e-9 && root < best.dt && b + 2 * a * root < 0) best = { dt: root, plane, side };
      }
    }
    if (t + best.dt >= scene.until || !best.plane) break;
    t += best.dt;
    x = along(along(x, best.dt, v), (best.dt * best.dt) / 2, scene.gravity);
    v = reflect(scene, best.plane, along(v, best.dt, scene.gravity), best.side);
    impacts.push({ t, plane: best.plane.name });
    if (best.dt < 1e-4) { // rests
      flights.push({ t, x, v: [v[0], 0], rest: true });
      break;
    }
    flights.push({ t, x, v });
  }
  return { flights, impacts };
}

function stateAt(scene, flights, t) {
  const flight = flights.findLast((f) => f.t <= t);
  const dt = t - flight.t;
  if (flight.rest) return { x: along(flight.x, dt, flight.v), v: flight.v };
  return { x: along(along(flight.x, dt, flight.v), (dt * dt) / 2, scene.gravity), v: along(flight.v, dt, scene.gravity) };
}

function stepper(method, scene, sphere, dt, times) {
  let [x, v, t] = [sphere.position, sphere.velocity, 0];
  const states = [{ x, v }];
  const impacts = [];
  const depths = [0];
  let [sample, steps, deepest, depth] = [1, 0, 0, 0];
  while (sample < times.length) {
    v = along(v, dt, scene.gravity);
    if (method === "velocity") {
      for (const plane of scene.planes) {
        const side = sideOf(plane, x);
        const normal = plane.normal.map((c) => c * side);
        if (gapOf(scene, plane, sphere.radius, x, side) <= 0 && dot(v, normal) < 0) {
          impacts.push({ t, plane: plane.name });
          v = reflect(scene, plane, v, side);
        }
      }
    }
    x = along(x, dt, v);
    t += dt;
    steps += 1;
    depth = 0;
    for (const plane of scene.planes) {
      const side = sideOf(plane, x);
      const normal = plane.normal.map((c) => c * side);
      const gap = gapOf(scene, plane, sphere.radius, x, side);
      depth = Math.max(depth, -gap);
      if (method === "pbd" && gap < 0) {
        if (dot(v, normal) < 0) {
          impacts.push({ t, plane: plane.name });
          v = reflect(scene, plane, v, side);
        }
        x = along(x, -gap, normal);
      }
    }
    deepest = Math.max(deepest, depth);
    while (sample < times.length && times[sample] <= t + 1e-12) {
      states.push({ x, v });
      depths.push(deepest);
      deepest = 0;
      sample += 1;
    }
  }
  return { states, impacts, depths, steps };
}

function energy(scene, sphere, { x, v }) {
  return sphere.mass * (dot(v, v) / 2 - dot(scene.gravity, x));
}

const root = Math.sqrt;
const mean = (list) => list.reduce((a, b) => a + b, 0) / list.length;

function encode(view, frames) {
  const bytes = Buffer.alloc(frames.length * view.radius.length * 4);
  let at = 0;
  for (const frame of frames) {
    for (const { x } of frame) {
      for (const axis of [0, 1]) {
        const part = (x[axis] - view.min[axis]) / (view.max[axis] - view.min[axis]);
        bytes.writeUInt16LE(Math.round(65535 * Math.min(1, Math.max(0, part))), at);
        at += 2;
      }
    }
  }
  return bytes.toString("base64");
}

function compare(scene) {
  const times = Array.from({ length: SAMPLES + 1 }, (_, i) => (scene.until * i) / SAMPLES);
  const reference = scene.spheres.map((s) => exact(scene, s));
  const truth = scene.spheres.map((s, i) => times.map((t) => stateAt(scene, reference[i].flights, t)));
  const kinetic = times.map((_, k) => scene.spheres.reduce((sum, s, i) => sum + (s.mass * dot(truth[i][k].v, truth[i][k].v)) / 2, 0));
  const scale = Math.max(...kinetic);
  const [rows, series, missed, tracks] = [[], [], [], []];
  const frames = (states) => times.map((_, k) => states.map((s) => s[k]));
  tracks.push({ row: -1, data: encode(scene.view, frames(truth)) });

  const total = reference.reduce((sum, r) => sum + r.impacts.length, 0);
  const add = (row, states, depths, lost) => {
    const index = rows.length;
    const distance = times.map((_, k) => states.map((s, i) => Math.hypot(...along(s[k].x, -1, truth[i][k].x))));
    const swift = times.map((_, k) => states.map((s, i) => Math.hypot(...along(s[k].v, -1, truth[i][k].v))));
    const drift = times.map((_, k) => states.reduce((sum, s, i) => sum + energy(scene, scene.spheres[i], s[k]) - energy(scene, scene.spheres[i], truth[i][k]), 0) / scale);
    const worst = distance.map((d) => Math.max(...d));
    const divergence = worst.findIndex((d) => d > 0.01 * Math.min(...scene.spheres.map((s) => s.radius)));
    rows.push({
      method: row.method, dt: row.dt, substeps: row.dt === null ? null : 1, passes: row.dt === null ? null : 1, label: row.label,
      order: null, integrator: null, impact: null, stiffness: null, hertz: null, damping_ratio: null,
      cpu_seconds: row.cpu, cpu_min: row.cpu * 0.94, cpu_max: row.cpu * 1.13,
      position_rms: root(mean(distance.flat().map((d) => d * d))), position_max: Math.max(...worst),
      position_final_rms: root(mean(distance.at(-1).map((d) => d * d))), position_final_max: worst.at(-1),
      velocity_rms: root(mean(swift.flat().map((d) => d * d))), energy_error: Math.max(...drift.map(Math.abs)), max_penetration: Math.max(...depths), overlap_left: 0,
      missed_impacts: lost.length, invented_impacts: row.invented, impacts: row.impacts,
      audited: null, found: null, late: null, missed: null, wrong: null, invented: null, crowded: null, absorbed: null, rest_jitter: row.jitter ?? null,
      divergence_time: divergence < 0 ? null : times[divergence], reference_bound: scene.bound, steps: row.steps, root_solves: row.roots, pair_tests: row.pairs, status: "reached_end", peer_settings: "",
      mistimed_impacts: Math.min(lost.length, row.invented), reference_impacts: total, time: scene.until,
    });
    series.push({ row: index, time: times, energy_error: drift, penetration: depths, position_max: worst });
    if (lost.length) missed.push({ row: index, times: lost.map((l) => l.t), names: lost.map((l) => l.name) });
    tracks.push({ row: index, data: encode(scene.view, frames(states)) });
  };

  // The event-driven method: the truth with errors of rounding.
  const rounding = truth.map((states, i) => states.map((s, k) => ({ x: along(s.x, 2e-16 * (k % 7) * scene.size, [Math.sin(k + i), Math.cos(3 * k + i)]), v: s.v })));
  add({ method: "event", dt: null, label: "event", cpu: 2e-7 + 1.9e-7 * total, invented: 0, impacts: total, steps: null, roots: total + scene.spheres.length, pairs: 0 }, rounding, times.map(() => 0), []);
  for (const method of scene.methods) {
    for (const [dt, text] of scene.steps) {
      const runs = scene.spheres.map((s) => stepper(method, scene, s, dt, times));
      const lost = [];
      let invented = 0;
      runs.forEach((run, i) => {
        const unused = [...run.impacts];
        for (const impact of reference[i].impacts) {
          const at = unused.findIndex((u) => u.plane === impact.plane && Math.abs(u.t - impact.t) <= 3 * dt);
          if (at >= 0) unused.splice(at, 1);
          else lost.push({ t: impact.t, name: `${scene.spheres[i].id} - ${impact.plane}` });
        }
        invented += unused.length;
      });
      lost.sort((a, b) => a.t - b.t);
      const steps = runs[0].steps;
      add({
        method, dt, label: `${method}, dt = ${text}`, cpu: steps * scene.spheres.length * SECONDS_A_STEP[method] + 4e-7, invented,
        impacts: runs.reduce((sum, r) => sum + r.impacts.length, 0), steps, roots: 0, pairs: steps * scene.spheres.length * scene.planes.length,
      }, runs.map((r) => r.states), times.map((_, k) => Math.max(...runs.map((r) => r.depths[k]))), lost);
    }
  }
  return {
    title: scene.title, description: scene.description, units: scene.units, verdict: scene.verdict, until: scene.until, tolerance: 1e-3, step_shown: scene.steps.at(-1)[0],
    reference: { kind: scene.kind, bound: scene.bound, until: scene.until, reason: scene.reason ?? "" },
    rows, series, missed, view: { ...scene.view, times, tracks },
  };
}

const SI = { length: "m", time: "s", mass: "kg" };
const STEPS = [[1 / 60, "1/60"], [1 / 240, "1/240"], [1e-3, "0.001"], [1e-4, "0.0001"], [1e-5, "1e-05"]];

function ball() {
  const spheres = [{ id: "ball", radius: 0.1, mass: 1, position: [0, 1.1], velocity: [0.2, 0] }];
  return {
    title: "Bouncing ball", description: "A ball of restitution 0.8 falls from 1 m. Every bounce is known in closed form; they end at 9 √(2h/g) = 4.06 s.",
    units: SI, until: 3, e: 0.8, gravity: [0, -9.81], size: 1, kind: "closed_form", bound: 1e-40, spheres,
    planes: [{ normal: [0, 1], offset: 0, thickness: null, name: "floor" }], methods: ["pbd", "velocity"], steps: STEPS,
    verdict: ["velocity needs dt ≤ 1e-05 for 1 mm; that costs 2 900 times the event run.", "pbd does not reach 1 mm at any step tried.", "No method missed an impact before its own divergence."],
    view: { axes: ["x", "z"], min: [-0.15, 0], max: [0.75, 1.25], radius: [0.1], color: ["#d1495b"], names: ["ball"], planes: [{ normal: [0, 1], offset: 0, thickness: null, name: "floor" }] },
  };
}

function bullet() {
  const plates = [[400, "first wall"], [700, "second wall"], [950, "back stop"]].map(([offset, name]) => ({ normal: [1, 0], offset, thickness: 0.02, name }));
  const planes = [{ normal: [0, 1], offset: 0, thickness: null, name: "ground" }, ...plates];
  return {
    title: "Bullet on a range", description: "A bullet of 1 cm at 900 m/s against walls of 2 cm. A step of 1/240 s carries it 3.75 m: it is before a wall, then behind it.",
    units: SI, until: 1.2, e: 0.5, gravity: [0, -9.81], size: 1000, kind: "multiprecision", bound: 3e-14,
    spheres: [{ id: "bullet", radius: 0.005, mass: 0.01, position: [0, 12], velocity: [900, 0] }], planes, methods: ["pbd", "velocity", "naive"], steps: STEPS.slice(0, 4),
    verdict: ["Every step tried lets the bullet through the first wall: all stepping methods miss the one impact and end 1 km from where the bullet is.", "No step tried reaches 1 mm; the event run takes 0.4 µs."],
    view: { axes: ["x", "z"], min: [-20, 0], max: [1120, 40], radius: [0.005], color: ["#222222"], names: ["bullet"], planes },
  };
}

function box() {
  let state = 12345;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  const colors = ["#0b3d91", "#c1352b", "#e0a100", "#17784a"];
  const spheres = Array.from({ length: 40 }, (_, i) => ({ id: `fill-0/${i}`, radius: 0.03, mass: 1, position: [0.1 + 0.8 * random(), 0.1 + 1.2 * random()], velocity: [8 * (random() - 0.5), 8 * (random() - 0.5)] }));
  const planes = [
    { normal: [1, 0], offset: 0, thickness: null, name: "box-x" }, { normal: [-1, 0], offset: -2, thickness: null, name: "box+x" },
    { normal: [0, 1], offset: 0, thickness: null, name: "box-z" }, { normal: [0, -1], offset: -1.5, thickness: null, name: "box+z" },
    { normal: [1, 0], offset: 1, thickness: 0.004, name: "</script><b>membrane</b>" },
  ];
  return {
    title: "Membrane", description: "Forty grains on the left of a membrane of 4 mm, elastic walls. Nothing may get to the right.",
    units: SI, until: 2, e: 1, gravity: [0, -9.81], size: 1, kind: "multiprecision", bound: 2e-18, spheres, planes, methods: ["pbd", "velocity"], steps: STEPS.slice(0, 4),
    reason: "a contact of three spheres at t = 2.0",
    verdict: ["Steps of 1/60 let grains through the membrane; 1/240 keeps them, but no step tried is within 1 mm of the reference.", "The event run costs as much as a velocity run of dt = 0.003.", "pbd gains energy at every step tried, 0.4 % at dt = 0.001."],
    view: { axes: ["x", "z"], min: [0, 0], max: [2, 1.5], radius: spheres.map((s) => s.radius), color: spheres.map((_, i) => colors[i % 4]), names: spheres.map((s) => s.id), planes },
  };
}

export function examplePage(which = ["ball", "bullet", "box"]) {
  const scenes = { ball, bullet, box };
  return { format: "carom-page/1", generator: "carom 0.1.0 (example data)", comparisons: which.map((name) => compare(scenes[name]())) };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  process.stdout.write(JSON.stringify(examplePage(process.argv.length > 2 ? process.argv.slice(2) : undefined)));
}
