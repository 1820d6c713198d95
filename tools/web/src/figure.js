// A chart with its heading, its controls, its key, and the numbers behind it as a file.

import { download, toCsv } from "./csv.js";
import { freshId, h } from "./dom.js";
import { swatch } from "./styles.js";

/**
 * @param {{title: string, caption: string, controls?: Element[], body: Element[], className?: string,
 *          csv?: {name: () => string, table: () => [string[], any[][]]}}} parts
 */
export function figure({ title, caption, controls = [], body, csv, className = "" }) {
  const id = freshId("figure");
  const save = csv && h("button", {
    type: "button", class: "save", "aria-label": `Download the numbers of “${title}” as CSV`,
    onclick: () => download(`${csv.name()}.csv`, toCsv(...csv.table())),
  }, "CSV");
  return h("figure", { class: `figure ${className}`, "aria-labelledby": id },
    h("div", { class: "figure-head" }, h("h3", { id }, title), save),
    h("p", { class: "caption" }, caption),
    controls.length ? h("div", { class: "controls" }, ...controls) : null,
    ...body);
}

/** Key of a chart: [{style, name}] */
export function makeKey() {
  const element = h("ul", { class: "key" });
  const show = (entries) => {
    element.replaceChildren(...entries.map(({ style, name }) => {
      const item = h("li", {});
      item.innerHTML = swatch(style);
      item.append(name);
      return item;
    }));
  };
  return { element, show };
}
