// The page's helpers, and the built page if CAROM_PAGE names it:  node --test test.mjs

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import test from "node:test";
import { examplePage } from "./example.mjs";
import { auditedRows, percent } from "./src/audit_chart.js";
import { COLUMNS, TABLE_COLUMNS } from "./src/columns.js";
import { toCsv } from "./src/csv.js";
import { decodeTrack, frameAt, positionsAt } from "./src/decode.js";
import { escapeHtml, formatDecade, formatNumber, formatQuantity, formatStep, powerOfTen, slug } from "./src/format.js";
import { placeLabels, spread } from "./src/labels.js";
import { farBelow, logAxis } from "./src/logaxis.js";
import { groupRows, rowLabel, stepLabel, stepsOf, withLateAndLost } from "./src/rows.js";
import { methodStyle, SYMBOLS } from "./src/styles.js";
import { reasonsOf, resultOf, sceneOf } from "./src/stress_data.js";
import { chordsOf, lineName, objects, share, throwScene } from "./src/tunnel_data.js";
import { projection, suitableHeight } from "./src/view_draw.js";

// docs/compare.md is held against the table from which the file is written.
const CSV_COLUMNS = [...readFileSync(new URL("../../docs/compare.md", import.meta.url), "utf8").matchAll(/^\| `(\w+)` \|/gm)].map((row) => row[1]).join();

test("numbers are written as people write them", () => {
  assert.equal(formatNumber(0), "0");
  assert.equal(formatNumber(0.123456), "0.123");
  assert.equal(formatNumber(1.04e-15), "1.04 × 10⁻¹⁵");
  assert.equal(formatNumber(1e-40), "10⁻⁴⁰");
  assert.equal(formatNumber(-2.5e-7), "−2.5 × 10⁻⁷");
  assert.equal(formatNumber(1234), "1234");
  assert.equal(formatNumber(null), "–");
  assert.equal(formatNumber(NaN), "–");
});

test("axes get scales of their own only where spheres could not be seen otherwise", () => {
  const view = (height, radius) => ({ min: [0, 0], max: [0.2, height], radius: [radius] });
  const stretch = (v) => projection(v, { x: 0, y: 0, width: 400, height: suitableHeight(v, 400) }).stretch;
  assert.equal(stretch(view(0.4, 0.1)), 1);
  assert.equal(stretch(view(4, 0.1)), 1); // a tower of 20
  assert.ok(stretch(view(40, 0.1)) < 1);
  assert.ok(stretch({ min: [0, 0], max: [40, 0.2], radius: [0.1] }) > 1);
});

test("shares say what rounds away, and rows without an audit have none", () => {
  assert.equal(percent(0, 10), "0 %");
  assert.equal(percent(10, 10), "100 %");
  assert.equal(percent(1, 3), "33.3 %");
  assert.equal(percent(1, 10000), "below 0.1 %");
  assert.equal(percent(9999, 10000), "above 99.9 %");
  const rows = [{ audited: 0 }, { audited: 4, found: 4 }, {}, { audited: null }];
  assert.deepEqual(auditedRows(rows).map(({ index }) => index), [1]);
});

test("seconds and metres take prefixes, other units none", () => {
  assert.equal(formatQuantity(3.2e-3, "s"), "3.2 ms");
  assert.equal(formatQuantity(1e-6, "s"), "1 µs");
  assert.equal(formatQuantity(10, "s"), "10 s");
  assert.equal(formatQuantity(9.9999e-4, "s"), "1 ms");
  assert.equal(formatQuantity(0.02, "m"), "20 mm");
  assert.equal(formatQuantity(1020, "m"), "1.02 km");
  assert.equal(formatQuantity(1e-15, "m"), "10⁻¹⁵ m");
  assert.equal(formatQuantity(0, "m"), "0 m");
  assert.equal(formatQuantity(0.02, "ft"), "0.02 ft");
  assert.equal(formatQuantity(0.02), "0.02");
});

test("ticks and steps", () => {
  assert.equal(powerOfTen(-7), "10⁻⁷");
  assert.equal(powerOfTen(0), "1");
  assert.equal(formatDecade(-5, true), "10 µs");
  assert.equal(formatDecade(-5, false), "10⁻⁵");
  assert.equal(formatStep(1 / 240), "1/240");
  assert.equal(formatStep(1 / 60), "1/60");
  assert.equal(formatStep(0.001), "0.001");
  assert.equal(formatStep(null), "");
});

test("CSV quotes what needs it and keeps every digit", () => {
  assert.equal(toCsv(["a", "b,c"], [[0.1 + 0.2, 'say "x"'], [null, undefined]]), 'a,"b,c"\r\n0.30000000000000004,"say ""x"""\r\n,\r\n');
  assert.equal(slug("Bullet & plate: 1 km!"), "bullet-plate-1-km");
  assert.equal(slug("…"), "carom");
  assert.equal(escapeHtml(`<b>"&'`), "&#60;b&#62;&#34;&#38;&#39;");
});

test("zeros lie on a marked floor, a decade below the smallest value", () => {
  const axis = logAxis([0, 3e-7, 2e-3]);
  assert.equal(axis.floor, 1e-8);
  assert.equal(axis.place(0), -8);
  assert.ok(axis.floored(0) && !axis.floored(3e-7));
  assert.equal(axis.place(-2e-3), Math.log10(2e-3));
  assert.equal(axis.floorTick, -8);
  assert.equal(axis.floorName, "0");
  assert.ok(axis.min < -8 && axis.max > Math.log10(2e-3));
});

test("values below a bound that is near are drawn at the bound", () => {
  const axis = logAxis([3e-14, 1e-9, 0], { bound: 1e-12 });
  assert.ok(axis.boundShown);
  assert.equal(axis.floor, 1e-12);
  assert.equal(axis.place(3e-14), -12);
  assert.equal(axis.place(0), -12);
  assert.equal(axis.floorTick, null);
});

test("a bound far below the data does not stretch the axis", () => {
  const axis = logAxis([1e-15, 1e-2], { bound: 1e-40 });
  assert.ok(!axis.boundShown);
  assert.equal(axis.floor, null);
  assert.ok(axis.min > -18);
});

test("one method far below the others does not squeeze them into a corner", () => {
  const values = [4.6e-16, 0.0585, 0.0148, 0.00275];
  assert.equal(farBelow(values), 4.6e-16);
  assert.equal(farBelow([1e-6, 0.01, 0.1]), 0);
  assert.equal(farBelow([0, 0.01]), 0);
  const axis = logAxis(values, { bound: 3e-16, far: farBelow([...values, 5e-4]), include: [5e-4] });
  assert.equal(axis.floor, 1e-5);
  assert.equal(axis.floorName, "≤ 10⁻¹⁵");
  assert.ok(axis.floored(4.6e-16) && !axis.boundShown && axis.min < Math.log10(5e-4) && axis.min > -6);
  assert.ok(logAxis([2e-6, 3e-5], { include: [1e-3] }).max > -3);
});

test("impacts are late or missed, and neither where a run left the reference before the first", () => {
  const [both, never, old] = withLateAndLost([
    { missed_impacts: 6, mistimed_impacts: 5, reference_impacts: 16, divergence_time: null }, { missed_impacts: 0, mistimed_impacts: 0, reference_impacts: 0, divergence_time: 0.01 }, { missed_impacts: 2 }]);
  assert.deepEqual([both.mistimed, both.lost], [5, 1]);
  assert.deepEqual([never.mistimed, never.lost], [null, null]);
  assert.deepEqual([old.mistimed, old.lost], [null, 2]);
});

test("the table begins with errors and has every column once", () => {
  const keys = TABLE_COLUMNS.map((c) => c.key);
  assert.deepEqual(keys.slice(0, 2), ["method", "position_max"]);
  assert.equal(new Set(keys).size, keys.length);
  assert.ok(["mistimed", "lost", "audited", "cpu_seconds", "reference_bound"].every((key) => keys.includes(key)));
  assert.ok(keys.indexOf("cpu_seconds") > keys.indexOf("energy_error"));
});

test("an axis without a positive value still has ticks", () => {
  for (const values of [[], [0, 0], [null, NaN], [5]]) {
    const axis = logAxis(values);
    assert.ok(Number.isFinite(axis.min) && Number.isFinite(axis.max) && axis.max - axis.min >= 1.9);
    assert.ok(axis.ticks.length >= 1);
    assert.ok(Number.isFinite(axis.place(0)) || !values.includes(0));
  }
});

test("only so many decades are shown", () => {
  const axis = logAxis([1, 1e-3, 1e-30], { decades: 18 });
  assert.equal(axis.floor, 1e-4);
  assert.ok(axis.floored(1e-30));
  assert.equal(axis.floorName, "≈ 0");
});

test("rows are grouped by method, and by substeps where a method has several", () => {
  const rows = [
    { method: "event", dt: null }, { method: "pbd", dt: 0.001, substeps: 1, label: "pbd, dt = 1/1000" }, { method: "pbd", dt: 0.01, substeps: 1 }, { method: "pbd", dt: 0.01, substeps: 4 },
  ];
  const groups = groupRows(rows);
  assert.deepEqual(groups.map((g) => g.name), ["event", "pbd, 1 substeps", "pbd, 4 substeps"]);
  assert.deepEqual(groups[1].rows.map((r) => r.index), [2, 1]);
  assert.equal(rowLabel(rows[0]), "event");
  assert.equal(stepLabel(rows[1]), "1/1000");
  assert.deepEqual(stepsOf(rows).map((s) => s.label), ["0.01", "1/1000"]);
});

test("every method has a symbol and a dash of its own", () => {
  const styles = ["event", "pbd", "velocity", "bisection", "naive", "moreau", "penalty"].map((m) => methodStyle(m));
  assert.equal(new Set(styles.map((s) => s.symbol)).size, styles.length);
  assert.equal(new Set(styles.map((s) => s.dash.join())).size, styles.length);
  for (const name of ["event", "unheard-of", "constructor"]) for (const variant of [0, 1, 2]) assert.ok(SYMBOLS[methodStyle(name, variant).symbol]);
});

test("a track is decoded as little-endian and read between frames", () => {
  const view = { min: [0, -1], max: [10, 1], radius: [1], times: [0, 1, 3] };
  const bytes = Buffer.from(Uint16Array.from([0, 0, 0x1234, 32768, 65535, 65535]).buffer);
  const words = decodeTrack(bytes.toString("base64"));
  assert.deepEqual([...words], [0, 0, 0x1234, 32768, 65535, 65535]);
  assert.deepEqual(frameAt(view.times, 2), { frame: 1, part: 0.5 });
  assert.deepEqual(frameAt(view.times, 9), { frame: 2, part: 0 });
  const [at] = positionsAt(view, words, 1);
  assert.ok(Math.abs(at.x - (10 * 0x1234) / 65535) < 1e-12 && !at.outside);
  assert.ok(positionsAt(view, words, 3)[0].outside);
});

test("labels cover neither each other nor points", () => {
  const points = [[100, 100], [112, 100], [105, 108]];
  const items = points.map(([x, y]) => ({ x, y, width: 40, reach: 8, required: true }));
  const solid = points.map(([x, y]) => ({ x: x - 5, y: y - 5, width: 10, height: 10 }));
  const boxes = placeLabels(items, solid, [], { x: 0, y: 0, width: 300, height: 300 });
  const all = [...boxes, ...solid];
  for (const a of boxes) for (const b of all) if (a !== b) assert.ok(a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y);
  assert.deepEqual(spread([50, 50, 51], 0, 300, 15), [50, 65, 80]);
  assert.deepEqual(spread([299, 300], 0, 300, 15), [285, 300]);
});

test("columns are those of compare.csv, in its order", () => {
  assert.equal(COLUMNS.map((c) => c.key).join(), CSV_COLUMNS);
});

test("the example keeps to the format", () => {
  const page = examplePage(["ball", "bullet"]);
  for (const { rows, series, missed, view, until } of page.comparisons) {
    for (const row of rows) assert.deepEqual(Object.keys(row).filter((k) => !["label", "mistimed_impacts", "reference_impacts", "time"].includes(k)).join(), CSV_COLUMNS);
    assert.equal(new Set(rows.map((r) => r.label)).size, rows.length);
    for (const s of series) for (const key of ["energy_error", "penetration", "position_max"]) assert.equal(s[key].length, s.time.length);
    for (const m of missed) assert.ok(m.times.length === m.names.length && m.times.every((t) => t <= until) && m.times.length === rows[m.row].missed_impacts);
    for (const t of view.tracks) assert.equal(decodeTrack(t.data).length, view.times.length * view.radius.length * 2);
  }
});

test("a stress case says each reason once, with those who fail for it", () => {
  const results = [["event", true, ""], ["pbd", false, "late"], ["naive", false, "sank"], ["velocity", false, "late"]]
    .map(([method, passed, reason]) => ({ method, passed, reason }));
  assert.deepEqual(reasonsOf({ results }), [{ methods: ["pbd", "velocity"], reason: "late" }, { methods: ["naive"], reason: "sank" }]);
  assert.equal(resultOf({ results }, "naive").reason, "sank");
  assert.equal(resultOf({ results }, "toi"), undefined);
  assert.equal(sceneOf("zeno, e = 0.9"), "zeno");
  assert.equal(sceneOf("zeno"), "zeno");
});

test("rows of a tunnelling study are told apart by what differs", () => {
  const [row] = objects(["method", "integrator", "variant"], [["fcl_naive", null, "linear, indep"]]);
  assert.equal(lineName(row), "fcl_naive, linear, indep");
  assert.equal(lineName({ method: "pbd", integrator: "parabola", variant: "" }), "pbd, parabola");
  assert.equal(lineName({ method: "pbd", integrator: "euler", variant: "" }), "pbd");
});

test("the law that is drawn is 1 - k/x at a plate and its mean over offsets at a sphere", () => {
  assert.equal(share("plate", 1, 0.5), 0);
  assert.equal(share("plate", 2, 8), 0.75);
  assert.equal(share("wall", 1, 100), 0);
  for (const x of [0.4, 1, 7]) { // rings of equal area
    const n = 20000;
    let sum = 0;
    for (let i = 0; i < n; i += 1) sum += Math.max(0, 1 - Math.sqrt((i + 0.5) / n) / x) / n;
    assert.ok(Math.abs(share("sphere", 1, x) - sum) < 1e-6);
  }
  for (const target of ["plate", "sphere"]) for (const k of [1, 2, 18]) {
    const rows = [0.3, 5, 40, 400].map((number) => ({ target, number, law: share(target, k, number) }));
    assert.ok(Math.abs(chordsOf(rows) - k) < 1e-9 * k);
  }
  assert.equal(chordsOf([{ target: "plate", number: 3, law: null }]), null);
});

test("the scene of a throw touches its target where the phase says", () => {
  const row = { method: "velocity", variant: "", integrator: "euler", radius: 0.1, thickness: 0.02, speed: 30, dt: 0.01, example_phase: 0.25, example_offset: 0.6 };
  for (const target of ["plate", "sphere", "wall"]) {
    const offset = target === "sphere" ? 0.6 : 0;
    const scene = throwScene({ ...row, target, thickness: target === "wall" ? null : 0.02, example_offset: offset });
    const [x, y, z] = scene.spheres[0].position;
    const at = x + 30 * 0.25 * 0.01; // at the contact
    const reach = target === "wall" ? 0.1 : 0.11;
    assert.ok(Math.abs(Math.hypot(at, z) - reach) < 1e-15 && y === 0 && at < 0);
    assert.equal(scene.run.method, "velocity");
    assert.equal(scene.planes?.[0].thickness, target === "plate" ? 0.02 : undefined);
  }
  assert.equal(throwScene({ ...row, target: "plate", method: "fcl_naive", variant: "linear, indep" }).run, undefined);
  assert.equal(throwScene({ ...row, target: "plate", method: "ode", integrator: "" }).run, undefined);
});

test("the built page is one file", { skip: !existsSync(process.env.CAROM_PAGE ?? "") }, () => {
  const page = readFileSync(process.env.CAROM_PAGE, "utf8");
  assert.equal(page.split("@CAROM_DATA@").length, 2);
  assert.equal(page.match(/<script/g).length, page.match(/<\/script/g).length);
  assert.doesNotMatch(page, /<link|<iframe|(src|href)=["']?(https?:)?\/\/|@import|url\(["']?(https?:|\/\/)/);
  assert.ok(page.length < 1_000_000);
});
