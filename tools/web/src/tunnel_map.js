// The heat map: methods by speeds, for one size and step. A cell opens what it stands on, and the throw that shows it as a scene.

import { download } from "./csv.js";
import { choice, h } from "./dom.js";
import { figure } from "./figure.js";
import { formatNumber, formatStep, isNumber } from "./format.js";
import { percent } from "./audit_chart.js";
import { lineName, throwScene, valuesOf } from "./tunnel_data.js";

const AXES = [["target", "Thrown at", (v) => v], ["radius", "Radius", formatNumber], ["thickness", "Thickness", (v) => (v === null ? "none" : formatNumber(v))], ["dt", "Step", formatStep]];
const QUANTITIES = { tunnelled: "tunnelled", wrong: "late or wrong" };

/** File name of a throw. */
function fileOf(row) {
  return `${row.method}-${row.target}-v${row.speed}.json`;
}

function opened(row) {
  const facts = `${lineName(row)} at speed ${formatNumber(row.speed)}: ${percent(row.tunnelled, row.trials)} of ${formatNumber(row.trials)} throws tunnelled` +
    `${isNumber(row.law) ? ` (the law says ${percent(row.law * row.trials, row.trials)})` : ""}, ${percent(row.wrong, row.trials)} were answered late or with another velocity` +
    `${isNumber(row.worst_error) ? `; those that did not tunnel were off by up to ${formatNumber(row.worst_error)}` : ""}. v dt / (radius + thickness/2) = ${formatNumber(row.number)}.`;
  if (row.scene === "") return [h("p", {}, facts)];
  const kind = row.tunnelled > 0 ? "a throw that tunnelled" : row.wrong > 0 ? "a throw that was answered wrongly" : "a throw";
  const save = h("button", { type: "button", class: "save", onclick: () => download(fileOf(row), row.scene ?? `${JSON.stringify(throwScene(row), null, 2)}\n`, "application/json") }, `Scene of ${kind}`);
  return [h("p", {}, facts), h("p", {}, save, " then ", h("code", {}, `carom run ${fileOf(row)}`), " shows it, and ", h("code", {}, `carom compare ${fileOf(row)}`), " every method beside it.")];
}

export function mapFigure({ rows, scene }) {
  const chosen = {};
  let quantity = "tunnelled";
  const box = h("div", { class: "table-box whole" });
  const detail = h("div", { class: "detail", "aria-live": "polite" });
  const controls = h("div", { class: "controls" });
  const matching = (upTo = AXES.length) => rows.filter((row) => AXES.slice(0, upTo).every(([key]) => row[key] === chosen[key]));
  /** Choices are kept where there still are rows of them. */
  const settle = () => AXES.forEach(([key], i) => {
    const values = valuesOf(matching(i), key);
    if (!values.includes(chosen[key])) chosen[key] = values[key === "target" ? 0 : Math.floor((values.length - 1) / 2)];
  });

  const cell = (row) => {
    if (!row || !row.trials) return h("td", { class: "none" }, "–");
    const part = row[quantity] / row.trials;
    const button = h("button", { type: "button", "aria-label": `${lineName(row)}, speed ${formatNumber(row.speed)}: ${percent(row[quantity], row.trials)} ${QUANTITIES[quantity]}`, onclick: () => detail.replaceChildren(...opened(row)) }, percent(row[quantity], row.trials).replace("below ", "<").replace("above ", ">"));
    const element = h("td", { class: "heat" }, button);
    element.style.setProperty("--heat", `${Math.round(100 * part)}%`);
    return element;
  };
  const show = () => {
    const own = matching();
    const speeds = valuesOf(own, "speed").sort((a, b) => a - b);
    const names = valuesOf(own.map((row) => ({ name: lineName(row) })), "name");
    const number = (speed) => own.find((row) => row.speed === speed).number;
    box.replaceChildren(h("table", { class: "map" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "speed", h("br", {}), h("span", { class: "step" }, "v dt / reach")),
        ...speeds.map((speed) => h("th", { scope: "col" }, formatNumber(speed), h("br", {}), h("span", { class: "step" }, formatNumber(number(speed), 2)))))),
      h("tbody", {}, ...names.map((name) => h("tr", {}, h("th", { scope: "row" }, name), ...speeds.map((speed) => cell(own.find((row) => row.speed === speed && lineName(row) === name))))))));
    detail.replaceChildren();
  };
  const build = () => {
    settle();
    controls.replaceChildren(
      ...AXES.map(([key, label, write], i) => {
        const values = valuesOf(matching(i), key);
        return choice(label, [{ options: values.map((v, k) => ({ value: String(k), label: write(v) })) }], String(values.indexOf(chosen[key])), (k) => { chosen[key] = values[Number(k)]; build(); });
      }),
      choice("Share", [{ options: Object.entries(QUANTITIES).map(([value, label]) => ({ value, label })) }], quantity, (value) => { quantity = value; show(); }));
    show();
  };
  build();
  return figure({
    title: "Who goes through, at which speed", className: "full",
    caption: `Share of throws, random in phase${scene ? "" : " and, at spheres, in offset"}. A cell tells what it stands on and opens the throw that shows it.`,
    body: [controls, box, detail],
  });
}
