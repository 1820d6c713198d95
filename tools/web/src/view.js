// The picture with its controls: one method beside or over the reference, so that a missed impact is seen.

import { choice, freshId, h, toggle } from "./dom.js";
import { decodeTrack } from "./decode.js";
import { figure } from "./figure.js";
import { formatNumber, formatQuantity } from "./format.js";
import { rowLabel } from "./rows.js";
import { methodStyle } from "./styles.js";
import { theme } from "./theme.js";
import { drawPanel, drawScaleBar, FEW, sizeNote, suitableHeight } from "./view_draw.js";

const REFERENCE = -1;
const LENGTHS = [{ value: 4, label: "4 s" }, { value: 8, label: "8 s" }, { value: 20, label: "20 s" }, { value: 60, label: "60 s" }];
const SIDE_BY_SIDE = 700; // px: in less than that, two views that are not tall stand one above the other
const AFTER_MISS = 0.04; // of the run: the view opens so much after the first missed impact

export function viewFigure(comparison) {
  const { view, rows, units } = comparison;
  if (!view?.tracks?.length || !view.times?.length) return null;
  const timeUnit = units.time;
  const words = new Map();
  const track = (row) => {
    const found = view.tracks.find((t) => t.row === row);
    if (found && !words.has(row)) words.set(row, decodeTrack(found.data));
    return words.get(row) ?? null;
  };
  const choices = view.tracks.filter((t) => t.row !== REFERENCE && rows[t.row]).map((t) => t.row);
  const missedOf = (row) => comparison.missed?.find((m) => m.row === row)?.times ?? [];
  const worst = choices.reduce((best, row) => (missedOf(row).length > missedOf(best).length ? row : best), choices[0] ?? REFERENCE);
  const [start, end] = [view.times[0], view.times.at(-1)];
  const known = Math.min(end, comparison.reference.until ?? end); // there is no reference to be drawn after that
  const state = { row: worst, mode: "overlay", time: known, seconds: 8, playing: false };
  if (missedOf(worst).length) state.time = Math.min(known, missedOf(worst)[0] + AFTER_MISS * (end - start));

  const from = view.from_above ? "from above" : "from the side";
  const canvas = h("canvas", { class: "view", role: "img" });
  const clock = h("output", { class: "clock" });
  const note = h("p", { class: "note" });
  const sliderId = freshId("time");
  const slider = h("input", { type: "range", id: sliderId, min: 0, max: 1000, step: 1, value: 0 });
  const ticks = h("div", { class: "ticks", "aria-hidden": "true" });
  const play = h("button", { type: "button", class: "play" }, "Play");
  const next = h("button", { type: "button" }, "Next late or missed");
  const legend = h("p", { class: "view-key" });

  const draw = () => {
    const width = Math.floor(canvas.parentElement?.clientWidth ?? 0);
    if (!width) return;
    const method = track(state.row);
    const reference = state.row === REFERENCE ? null : track(REFERENCE);
    const color = rows[state.row] ? methodStyle(rows[state.row].method).color : theme().reference;
    const beside = state.mode === "beside" && method && reference;
    const aspect = (view.max[1] - view.min[1]) / (view.max[0] - view.min[0]);
    const stacked = beside && (aspect < 0.5 || (width < SIDE_BY_SIDE && aspect < 1.2));
    const panelWidth = beside && !stacked ? Math.floor((width - 10) / 2) : width;
    const panelHeight = suitableHeight(view, panelWidth);
    const height = stacked ? 2 * panelHeight + 10 : panelHeight;
    const ratio = window.devicePixelRatio || 1;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      Object.assign(canvas, { width: Math.round(width * ratio), height: Math.round(height * ratio) });
      canvas.style.height = `${height}px`;
    }
    const context = canvas.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const second = stacked ? { x: 0, y: panelHeight + 10 } : { x: panelWidth + 10, y: 0 };
    const rect = { x: 0, y: 0, width: panelWidth, height: panelHeight };
    const panels = beside
      ? [{ rect, reference, method: null }, { rect: { ...rect, ...second }, reference: null, method }]
      : [{ rect, reference, method }];
    for (const panel of panels) {
      const map = drawPanel(context, view, { time: state.time, color, ...panel });
      context.strokeStyle = theme().frame;
      context.lineWidth = 1;
      context.strokeRect(panel.rect.x + 0.5, panel.rect.y + 0.5, panel.rect.width - 1, panel.rect.height - 1);
      drawScaleBar(context, map, units.length);
      note.textContent = `${view.from_above ? "From above" : "From the side"}: ${view.axes[0]} to the right, ${view.axes[1]} up, ` +
        (map.stretch === 1 ? "both to the same scale. " : `${view.axes[1]} drawn ${formatNumber(map.stretch, 2)} times as large as ${view.axes[0]}. `) + sizeNote(view, map);
    }
    describe();
  };

  const describe = () => {
    const missed = missedOf(state.row);
    const sofar = missed.filter((t) => t <= state.time).length;
    clock.textContent = `t = ${formatQuantity(state.time, timeUnit, 4)}` + (missed.length ? ` · ${formatNumber(sofar)} of ${formatNumber(missed.length)} late or missed` : "");
    slider.value = String(Math.round((1000 * (state.time - start)) / (end - start || 1)));
    slider.setAttribute("aria-valuetext", clock.textContent);
    play.textContent = state.playing ? "Pause" : "Play";
    next.hidden = missed.length === 0;
    canvas.setAttribute("aria-label", `${rows[state.row] ? rowLabel(rows[state.row]) : "Reference"} at ${clock.textContent}`);
  };

  const choose = () => {
    const row = rows[state.row];
    const color = row ? methodStyle(row.method).color : theme().reference;
    const lines = view.radius.length <= FEW;
    const filled = h("span", { class: "dot" });
    filled.style.background = view.color?.[0] || color;
    legend.replaceChildren(...(row ? [h("span", {}, filled, `${rowLabel(row)} (filled${lines ? ", full line" : ""})`)] : []), h("span", {}, h("span", { class: "dot ghost" }), `reference (outline${lines ? ", dashed line" : ""})${known < end ? `, up to t = ${formatQuantity(known, timeUnit, 5)}` : ""}`));
    ticks.replaceChildren(...missedOf(state.row).slice(0, 400).map((t) => {
      const tick = h("i", {});
      tick.style.left = `${(100 * (t - start)) / (end - start || 1)}%`;
      return tick;
    }));
    draw();
  };

  let began = null;
  const step = (now) => {
    if (!state.playing || !canvas.isConnected) return;
    began ??= { now, time: state.time };
    state.time = began.time + ((now - began.now) / 1000) * ((end - start) / state.seconds);
    if (state.time >= end) Object.assign(state, { time: end, playing: false });
    draw();
    if (state.playing) requestAnimationFrame(step);
  };
  const setPlaying = (on) => {
    state.playing = on;
    began = null;
    if (on && state.time >= end) state.time = start;
    draw();
    if (on) requestAnimationFrame(step);
  };
  play.addEventListener("click", () => setPlaying(!state.playing));
  slider.addEventListener("input", () => {
    state.time = start + ((end - start) * Number(slider.value)) / 1000;
    setPlaying(false);
  });
  next.addEventListener("click", () => {
    const missed = missedOf(state.row);
    const ahead = AFTER_MISS * (end - start);
    const found = missed.find((t) => Math.min(known, t + ahead) > state.time + 1e-9 * (end - start)) ?? missed[0];
    state.time = Math.min(known, found + ahead);
    setPlaying(false);
  });

  const box = h("div", { class: "view-box" }, canvas);
  new ResizeObserver(() => requestAnimationFrame(draw)).observe(box);
  queueMicrotask(choose);
  const options = [{ options: choices.map((row) => ({ value: String(row), label: rowLabel(rows[row]) })) }];
  return figure({
    title: "What it looks like",
    caption: choices.length ? `One run over the reference, ${from}.${comparison.missed?.length ? " Red ticks below the time line: impacts that the run missed, or met more than 3 steps early or late." : ""}` : `The reference, ${from}.`,
    controls: [
      choices.length ? choice("Run", options, String(state.row), (value) => { state.row = Number(value); choose(); }) : null,
      choices.length && track(REFERENCE) ? toggle("Arrangement", [{ value: "overlay", label: "overlaid" }, { value: "beside", label: "side by side" }], state.mode, (value) => { state.mode = value; draw(); }) : null,
    ].filter(Boolean),
    body: [
      box, legend,
      h("div", { class: "transport" }, play, h("div", { class: "slide" }, h("label", { for: sliderId, class: "visually-hidden" }, "Time"), slider, ticks), next),
      h("div", { class: "transport" }, clock, choice("Play in", [{ options: LENGTHS.map((l) => ({ value: String(l.value), label: l.label })) }], String(state.seconds), (value) => {
        state.seconds = Number(value);
        began = null;
      })),
      note,
    ],
  });
}
