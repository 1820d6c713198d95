// How lines look. Each has a symbol and a dash of its own, so that colour is never needed to tell them apart.

import { theme } from "./theme.js";

/** Symbols in a box of 20 by 20, for the charts and for the keys beside them. */
export const SYMBOLS = {
  diamond: "M10 0L20 10L10 20L0 10Z",
  circle: "M10 1A9 9 0 1 1 9.99 1Z",
  square: "M2 2H18V18H2Z",
  triangle: "M10 1L20 18H0Z",
  wedge: "M0 2H20L10 19Z",
  cross: "M3 0L10 7L17 0L20 3L13 10L20 17L17 20L10 13L3 20L0 17L7 10L0 3Z",
  plus: "M7 0H13V7H20V13H13V20H7V13H0V7H7Z",
  star: "M10 0L13 7L20 8L15 13L16 20L10 16L4 20L5 13L0 8L7 7Z",
};

// Colours are [on white, on dark], each with a contrast of at least 4.5 to its paper.
const METHODS = {
  event: { colors: ["#0b3d91", "#7fb0ff"], symbol: "diamond", dash: [], width: 3 },
  velocity: { colors: ["#c1352b", "#ff8a80"], symbol: "circle", dash: [8, 4], width: 2 },
  pbd: { colors: ["#17784a", "#5fd39a"], symbol: "square", dash: [2, 3], width: 2 },
  bisection: { colors: ["#7d4696", "#cf9be6"], symbol: "triangle", dash: [10, 3, 2, 3], width: 2 },
  naive: { colors: ["#5b5b5b", "#b8b8b8"], symbol: "cross", dash: [1, 5], width: 2 },
  moreau: { colors: ["#9a5b00", "#eab05a"], symbol: "wedge", dash: [14, 5], width: 2 },
  penalty: { colors: ["#006f80", "#56cfe1"], symbol: "plus", dash: [5, 2, 1, 2, 1, 2], width: 2 },
  toi: { colors: ["#a3185f", "#ff8fc4"], symbol: "star", dash: [6, 2], width: 2 },
  speculative: { colors: ["#4b6b00", "#b9dc63"], symbol: "triangle", dash: [3, 3, 9, 3], width: 2 },
  fcl_naive: { colors: ["#5b4b00", "#d8c25a"], symbol: "cross", dash: [9, 2], width: 2 },
  fcl_advancement: { colors: ["#00695c", "#6fd6c6"], symbol: "wedge", dash: [4, 2], width: 2 },
  libccd_advancement: { colors: ["#5c3d99", "#b8a1f0"], symbol: "plus", dash: [12, 2, 2, 2], width: 2 },
  soft: { colors: ["#8a3c12", "#f0a07a"], symbol: "circle", dash: [1, 3], width: 2 },
};
const OTHERS = [
  ["#0b3d91", "#7fb0ff"], ["#c1352b", "#ff8a80"], ["#17784a", "#5fd39a"], ["#7d4696", "#cf9be6"], ["#9a5b00", "#eab05a"], ["#006f80", "#56cfe1"],
  ["#a3185f", "#ff8fc4"], ["#5b5b5b", "#b8b8b8"],
];
const DASHES = [[], [8, 4], [2, 3], [10, 3, 2, 3], [14, 5], [5, 2, 1, 2, 1, 2], [1, 5]];

const colorOf = (colors) => colors[theme().dark ? 1 : 0];

/** The n-th of several lines that are no methods (steps of one method). */
export function indexStyle(n) {
  const symbols = Object.keys(SYMBOLS);
  return { color: colorOf(OTHERS[n % OTHERS.length]), symbol: symbols[(n + 1) % symbols.length], dash: DASHES[n % DASHES.length], width: 2 };
}

/** A method's line; `variant` > 0 for further lines of the same method (other substeps): the same colour, another symbol. */
export function methodStyle(method, variant = 0) {
  const look = Object.hasOwn(METHODS, method) ? METHODS[method] : null;
  const known = look ? { color: colorOf(look.colors), symbol: look.symbol, dash: look.dash, width: look.width }
    : indexStyle([...method].reduce((sum, c) => sum + c.charCodeAt(0), 0));
  if (variant === 0) return known;
  return { ...indexStyle(variant + Object.keys(SYMBOLS).indexOf(known.symbol)), color: known.color };
}

/** A line with its symbol as inline SVG, for keys. The style is ours, so it needs no escaping. */
export function swatch({ color, symbol, dash, width }) {
  return `<svg class="swatch" width="40" height="14" viewBox="0 0 40 14" aria-hidden="true">` +
    `<path d="M0 7H40" stroke="${color}" stroke-width="${width}" stroke-dasharray="${dash.join(" ")}"/>` +
    `<path transform="translate(14 1) scale(.6)" d="${SYMBOLS[symbol]}" fill="${color}" stroke="${theme().paper}" stroke-width="1.5"/></svg>`;
}
