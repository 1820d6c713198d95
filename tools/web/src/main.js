// The page: verdicts in words, then what they rest on.

import { auditFigure } from "./audit_chart.js";
import { drawAllCharts } from "./chart.js";
import { h } from "./dom.js";
import { formatQuantity, isNumber } from "./format.js";
import { missedFigure } from "./missed_chart.js";
import { withLateAndLost } from "./rows.js";
import { glossary, rowsTable } from "./table.js";
import { stressPage } from "./stress_page.js";
import { onThemeChange } from "./theme.js";
import { timeFigure } from "./time_chart.js";
import { tunnelPage } from "./tunnel_page.js";
import { viewFigure } from "./view.js";
import { workFigure } from "./work_chart.js";

const PAGES = { "carom-page/1": build, "carom-tunnel-page/1": tunnelPage, "carom-stress-page/1": stressPage };
const KINDS = { closed_form: "closed form", multiprecision: "independent multiprecision integrator" };

/** What may be absent is made empty, so that nothing later has to ask. */
function complete(comparison, index) {
  const rows = withLateAndLost(comparison.rows ?? []);
  const units = { length: comparison.units?.length || "length", time: comparison.units?.time || "time" };
  return { title: `Comparison ${index + 1}`, description: "", verdict: [], ...comparison, rows, units, reference: comparison.reference ?? {}, id: `comparison-${index + 1}` };
}

function verdictBox(comparison) {
  const [first, ...others] = comparison.verdict;
  if (!first) return null;
  return h("div", { class: "verdict", role: "note", "aria-label": "Verdict" },
    h("p", { class: "lead" }, first), others.length ? h("ul", {}, ...others.map((text) => h("li", {}, text))) : null);
}

function referenceLine({ reference, until, units, rows, tolerance }) {
  const parts = [`${rows.length} ${rows.length === 1 ? "run" : "runs"}`];
  const time = (t) => formatQuantity(t, units.time, 5);
  const short = isNumber(reference.until) && isNumber(until) && reference.until < until;
  if (isNumber(until)) parts.push(short ? `asked for up to t = ${time(until)}, compared up to t = ${time(reference.until)}` : `compared up to t = ${time(until)}`);
  if (isNumber(tolerance)) parts.push(`tolerance: position error ${formatQuantity(tolerance, units.length)}`);
  if (reference.kind) parts.push(`reference: ${KINDS[reference.kind] ?? reference.kind}${reference.bound > 0 ? `, off by ${formatQuantity(reference.bound, units.length, 2)} at most` : ""}`);
  if (reference.reason) parts.push(`the reference ends there: ${reference.reason}`);
  return h("p", { class: "facts" }, parts.join(" · "));
}

function section(comparison, alone) {
  const { units } = comparison;
  const top = [workFigure(comparison), viewFigure(comparison)].filter(Boolean);
  const parts = [
    timeFigure(comparison, {
      quantity: "energy_error", title: "Energy error over time", axisName: "energy error, relative", unit: "",
      caption: "Energy less the reference’s, over its greatest kinetic energy; the logarithmic scale shows the magnitude.",
    }),
    timeFigure(comparison, {
      quantity: "penetration", title: "Penetration over time", axisName: "deepest overlap", unit: units.length,
      caption: "How deep the deepest overlap is at the sample times: sphere in sphere or in a plane. Rigid bodies have none. Samples see a stepper after its correction; the table’s deepest penetration is the one before, and larger.",
    }),
    timeFigure(comparison, {
      quantity: "position_max", title: "Position error over time", axisName: "greatest position error", unit: units.length,
      caption: "Distance of the worst sphere from where the reference has it.",
    }),
    missedFigure(comparison),
    auditFigure(comparison),
  ].filter(Boolean);
  for (const list of [top, parts]) { // two stand side by side; one that is left over takes the whole width
    const halves = list.filter((part) => !part.classList.contains("full"));
    if (halves.length % 2) halves.at(-1).classList.add("full");
  }
  return h("section", { id: comparison.id, "aria-labelledby": `${comparison.id}-title` },
    h(alone ? "h1" : "h2", { id: `${comparison.id}-title` }, comparison.title),
    comparison.description ? h("p", { class: "description" }, comparison.description) : null,
    verdictBox(comparison), referenceLine(comparison),
    h("div", { class: "figures" }, ...top, ...parts, rowsTable(comparison)));
}

function overview(comparisons) {
  return [
    h("header", {}, h("h1", {}, "Comparison of methods"), h("p", { class: "description" }, `${comparisons.length} scenes, each run by several methods and measured against a reference.`)),
    h("nav", { class: "overview", "aria-label": "Scenes and verdicts" }, h("ul", {}, ...comparisons.map((c) =>
      h("li", {}, h("a", { href: `#${c.id}` }, c.title), h("span", {}, c.verdict[0] ?? ""))))),
  ];
}

function build(data) {
  const comparisons = (data.comparisons ?? []).map(complete);
  const alone = comparisons.length === 1;
  document.title = `${alone ? comparisons[0].title : "Comparison of methods"} – carom`;
  return [
    ...(comparisons.length > 1 ? overview(comparisons) : []),
    ...comparisons.map((c) => section(c, alone)),
    comparisons.length ? glossary() : h("p", {}, "This page holds no comparison."),
    h("footer", {}, `Written by ${data.generator ?? "carom"}. Everything on this page is in this one file.`),
  ];
}

function start() {
  const main = document.getElementById("page");
  const show = () => {
    try {
      const data = JSON.parse(document.getElementById("carom-data").textContent);
      if (!Object.hasOwn(PAGES, data.format)) throw new Error(`its data are “${data.format}”, it can show ${Object.keys(PAGES).join(", ")}`);
      main.replaceChildren(...PAGES[data.format](data));
    } catch (error) {
      main.replaceChildren(h("p", { class: "failure" }, `This page cannot be shown: ${error.message}`));
      throw error;
    }
  };
  show();
  onThemeChange(show);
  window.addEventListener("beforeprint", () => {
    document.querySelectorAll("details").forEach((d) => { d.open = true; });
    drawAllCharts();
  });
}

start();
