// The page of `carom stress`: what passes in words, the matrix, then each case with its rule and why methods fail it.

import { h } from "./dom.js";
import { figure } from "./figure.js";
import { formatNumber, isNumber, slug } from "./format.js";
import { reasonsOf, resultOf, sceneOf } from "./stress_data.js";

const WORDS = { stopped: "stopped", other_run: "another run", sank: "sank", energy: "energy", missed: "missed", invented: "invented", late: "off" };

const anchor = (entry) => `case-${slug(entry.name)}`;

function size(figureOfRun) {
  return isNumber(figureOfRun) ? formatNumber(figureOfRun, 2) : "not finite";
}

function runsTable(result) {
  return h("div", { class: "table-box" }, h("table", { class: "plain" },
    h("thead", {}, h("tr", {}, ...["run", "figure", "result", "largest at"].map((text, i) => h("th", { scope: "col", class: i === 1 ? null : "text" }, text)))),
    h("tbody", {}, ...result.runs.map((run) => h("tr", {}, h("th", { scope: "row" }, run.scene), h("td", {}, size(run.figure)),
      h("td", { class: "text" }, run.symptom === "none" ? "passes" : WORDS[run.symptom] ?? run.symptom), h("td", { class: "text" }, run.worst || "–"))))));
}

function opened(entry, result) {
  const parts = [h("p", {}, h("strong", {}, `${result.method} on ${entry.name}: `), result.passed ? `passes, figure ${size(result.figure)} of at most ${formatNumber(result.limit)}.` : `${result.reason}.`),
    h("p", {}, "Figure: ", `${entry.figure}. `, h("code", {}, `carom run ${sceneOf(result.scene)} --method ${result.method}`), " runs the scene as it is, ", h("a", { href: `#${anchor(entry)}` }, "the case"), " says the rest.")];
  return [...parts, runsTable(result)];
}

function matrix({ cases, methods }) {
  const detail = h("div", { class: "detail", "aria-live": "polite" });
  const show = (entry, result) => {
    detail.replaceChildren(...opened(entry, result));
    detail.scrollIntoView({ block: "nearest" });
  };
  const cell = (entry, method) => {
    const result = resultOf(entry, method);
    if (!result) return h("td", { class: "none" }, "–");
    const words = result.passed ? "pass" : WORDS[result.symptom] ?? result.symptom;
    return h("td", { class: result.passed ? "passed" : "failed" }, h("button", {
      type: "button", "aria-label": `${entry.name}, ${method}: ${words}, figure ${size(result.figure)}`, onclick: () => show(entry, result),
    }, words, h("br", {}), h("span", { class: "step" }, size(result.figure))));
  };
  return figure({
    title: "Methods by cases", className: "full",
    caption: "Whether a method passes, else what is seen first: sank half a radius or more, lost energy, missed or invented impacts, or was off; below it the case's figure, its largest error. A cell tells why.",
    body: [h("div", { class: "table-box whole" }, h("table", { class: "map stress" },
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, "case"), ...methods.map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, ...cases.map((entry) => h("tr", {}, h("th", { scope: "row" }, h("a", { href: `#${anchor(entry)}` }, entry.name), entry.waits_for ? h("span", { class: "step" }, " waits") : null),
        ...methods.map((name) => cell(entry, name))))))), detail],
    csv: { name: () => "stress", table: () => [["case", "method", "passed", "figure", "limit", "symptom", "scene", "reason"],
      cases.flatMap((entry) => entry.results.map((r) => [entry.name, r.method, r.passed, r.figure, r.limit, r.symptom, r.scene, r.reason]))] },
  });
}

function caseSection(entry) {
  const fact = (term, text) => [h("dt", {}, term), h("dd", {}, text)];
  const reasons = reasonsOf(entry);
  return h("div", { class: "figure full", id: anchor(entry) },
    h("h3", {}, entry.title || entry.name), h("p", { class: "caption" }, entry.about),
    h("dl", { class: "rule" }, ...fact("figure", entry.figure), ...fact("passed if", entry.rule), ...fact("step", entry.step),
      ...(entry.waits_for ? fact("waits for", `${entry.waits_for}: run and shown, not required`) : [])),
    reasons.length ? h("ul", {}, ...reasons.map(({ methods, reason }) => h("li", {}, h("strong", {}, `${methods.join(", ")}: `), reason))) : h("p", {}, "All methods pass."));
}

/** The content of the page from its data. */
export function stressPage(data) {
  const { cases = [], methods = [] } = data;
  document.title = "Stiff and extreme cases – carom";
  const [first, ...others] = data.verdict ?? [];
  const runs = cases.reduce((sum, entry) => sum + entry.results.reduce((n, result) => n + result.runs.length, 0), 0);
  return [h("section", { "aria-labelledby": "stress-title" },
    h("h1", { id: "stress-title" }, "Stiff and extreme cases"),
    h("p", { class: "description" }, "Scenes whose answer is known without a simulation, each with a rule, put to every method at the step that the case says."),
    first ? h("div", { class: "verdict", role: "note", "aria-label": "Verdict" }, h("p", { class: "lead" }, first), others.length ? h("ul", {}, ...others.map((text) => h("li", {}, text))) : null) : null,
    h("p", { class: "facts" }, `${formatNumber(runs)} runs in ${formatNumber(cases.length)} cases${data.stopped ? ", stopped before the end" : ""}`),
    cases.length ? h("div", { class: "figures" }, matrix({ cases, methods }), ...cases.map(caseSection)) : h("p", {}, "No case was finished.")),
  h("footer", {}, `Written by ${data.generator ?? "carom"}. Everything on this page is in this one file.`)];
}
