// How lines look. Each has a symbol and a dash of its own, so that colour is never needed to tell them apart.

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

const METHODS = {
  event: { color: "#0b3d91", symbol: "diamond", dash: [], width: 3 },
  velocity: { color: "#c1352b", symbol: "circle", dash: [8, 4], width: 2 },
  pbd: { color: "#17784a", symbol: "square", dash: [2, 3], width: 2 },
  bisection: { color: "#7d4696", symbol: "triangle", dash: [10, 3, 2, 3], width: 2 },
  naive: { color: "#5b5b5b", symbol: "cross", dash: [1, 5], width: 2 },
  moreau: { color: "#9a5b00", symbol: "wedge", dash: [14, 5], width: 2 },
  penalty: { color: "#006f80", symbol: "plus", dash: [5, 2, 1, 2, 1, 2], width: 2 },
};
const OTHERS = ["#0b3d91", "#c1352b", "#17784a", "#7d4696", "#9a5b00", "#006f80", "#a3185f", "#5b5b5b"];
const DASHES = [[], [8, 4], [2, 3], [10, 3, 2, 3], [14, 5], [5, 2, 1, 2, 1, 2], [1, 5]];

/** The n-th of several lines that are no methods (steps of one method). */
export function indexStyle(n) {
  const symbols = Object.keys(SYMBOLS);
  return { color: OTHERS[n % OTHERS.length], symbol: symbols[(n + 1) % symbols.length], dash: DASHES[n % DASHES.length], width: 2 };
}

/** A method's line; `variant` > 0 for further lines of the same method (other substeps): the same colour, another symbol. */
export function methodStyle(method, variant = 0) {
  const known = Object.hasOwn(METHODS, method) ? METHODS[method] : indexStyle([...method].reduce((sum, c) => sum + c.charCodeAt(0), 0));
  if (variant === 0) return known;
  return { ...indexStyle(variant + Object.keys(SYMBOLS).indexOf(known.symbol)), color: known.color };
}

/** A line with its symbol as inline SVG, for keys. The style is ours, so it needs no escaping. */
export function swatch({ color, symbol, dash, width }) {
  return `<svg class="swatch" width="40" height="14" viewBox="0 0 40 14" aria-hidden="true">` +
    `<path d="M0 7H40" stroke="${color}" stroke-width="${width}" stroke-dasharray="${dash.join(" ")}"/>` +
    `<path transform="translate(14 1) scale(.6)" d="${SYMBOLS[symbol]}" fill="${color}" stroke="#fff" stroke-width="1.5"/></svg>`;
}
