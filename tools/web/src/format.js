// Numbers as people write them. Nothing here knows about the page.

const SUPERSCRIPT = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const PREFIXED = {
  s: [[1e-9, "ns"], [1e-6, "µs"], [1e-3, "ms"], [1, "s"]],
  m: [[1e-9, "nm"], [1e-6, "µm"], [1e-3, "mm"], [1, "m"], [1e3, "km"]],
};

export function isNumber(x) {
  return typeof x === "number" && Number.isFinite(x);
}

export function superscript(n) {
  return String(n).replace(/./g, (c) => SUPERSCRIPT[c]);
}

/** 10 to the integer n: "0.01", "1", "100", and "10⁻⁷" outside that range. */
export function powerOfTen(n) {
  if (n >= -2 && n <= 3) return String(Number(`1e${n}`));
  return `10${superscript(n)}`;
}

/** A plain number with `digits` significant digits; powers of ten where zeros would pile up. */
export function formatNumber(x, digits = 3) {
  if (!isNumber(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (Number.isInteger(x) && size < 1e6) return String(x).replace("-", "−");
  if (size >= 1e-3 && size < 1e5) return String(Number(x.toPrecision(digits))).replace("-", "−");
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  const short = String(Number(mantissa)).replace("-", "−");
  const power = `10${superscript(Number(exponent))}`;
  return short === "1" ? power : `${short} × ${power}`;
}

const UNSAID = ["length", "time", "length/time"]; // scenes without units: axes say what is meant, numbers stand alone

/** A number with its unit; seconds and metres take prefixes: 3.2e-3 s is "3.2 ms". */
export function formatQuantity(x, unitOrKind = "", digits = 3) {
  if (!isNumber(x)) return "–";
  const unit = UNSAID.includes(unitOrKind) ? "" : unitOrKind;
  const steps = PREFIXED[unit];
  const size = Math.abs(x);
  const outside = !steps || size < steps[0][0] || size >= steps.at(-1)[0] * 1e4;
  if (x === 0 || outside) return unit ? `${formatNumber(x, digits)} ${unit}` : formatNumber(x, digits);
  // A value that rounds up to 1000 of a prefix belongs to the next one.
  const rounded = Number(size.toPrecision(digits));
  const [factor, name] = steps.findLast(([f]) => rounded >= f) ?? steps[0];
  return `${formatNumber(Number((x / factor).toPrecision(digits)), digits)} ${name}`;
}

/** The tick 10^n of a time axis in seconds: "100 µs"; of any other axis "10⁻⁴". */
export function formatDecade(n, seconds = false) {
  return seconds && n >= -9 && n <= 3 ? formatQuantity(Number(`1e${n}`), "s") : powerOfTen(n);
}

/** A step as its user wrote it, most likely: "1/240", "0.001", "10⁻⁵". */
export function formatStep(dt) {
  if (!isNumber(dt)) return "";
  const inverse = 1 / dt;
  const whole = Math.round(inverse);
  const decimal = String(Number(dt.toPrecision(12)));
  if (whole > 1 && Math.abs(inverse - whole) < 1e-9 * inverse && decimal.replace(/e.*|^0\.0*/g, "").length > 3) return `1/${whole}`;
  return formatNumber(dt, 4);
}

/** "position error (m)"; without a unit the name alone. */
export function withUnit(name, unit) {
  return unit ? `${name} (${unit})` : name;
}

/** A file name from a title. */
export function slug(text) {
  return text.toLowerCase().normalize("NFKD").replace(/[^a-z0-9]+/g, "-").replace(/^-+|-+$/g, "").slice(0, 60) || "carom";
}

export function escapeHtml(text) {
  return String(text).replace(/[&<>"']/g, (c) => `&#${c.charCodeAt(0)};`);
}
