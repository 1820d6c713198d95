// Rows of a comparison: which belong to one line, and what they are called.

import { formatStep, isNumber } from "./format.js";

/**
 * Rows with their missed impacts in two parts, `mistimed` (early or late) and `lost` (never there), both null where nothing was
 * counted: a run that parts from the reference before the first impact has none to miss.
 */
export function withLateAndLost(rows) {
  return rows.map((row) => {
    const judged = isNumber(row.missed_impacts) && !(isNumber(row.divergence_time) && row.reference_impacts === 0);
    const late = row.mistimed_impacts ?? 0;
    return { ...row, mistimed: judged && row.mistimed_impacts !== undefined ? late : null, lost: judged ? row.missed_impacts - late : null };
  });
}

/** Rows without a step (the event-driven method) are null in `dt`. */
export function isStepped(row) {
  return isNumber(row.dt);
}

export function rowLabel(row) {
  return row.label ?? (isStepped(row) ? `${row.method}, dt = ${formatStep(row.dt)}` : row.method);
}

/** The step as in the row's own label if that says it, so that texts and charts agree. */
export function stepLabel(row) {
  if (!isStepped(row)) return "";
  return /dt = ([^,;\s]+)/.exec(row.label ?? "")?.[1] ?? formatStep(row.dt);
}

/**
 * Lines of the work-precision diagram: one for each method, and for each choice of substeps and passes where a method has several.
 * @returns {{name: string, method: string, variant: number, rows: {row: object, index: number}[]}[]} in order of first appearance,
 *          rows from the largest step to the smallest; `variant` counts the lines of one method
 */
export function groupRows(rows) {
  const groups = new Map();
  rows.forEach((row, index) => {
    const key = JSON.stringify([row.method, row.substeps ?? null, row.passes ?? null, row.order ?? null, row.integrator ?? null, row.impact ?? null]);
    if (!groups.has(key)) groups.set(key, { method: row.method, substeps: row.substeps, passes: row.passes, order: row.order, integrator: row.integrator, impact: row.impact, rows: [] });
    groups.get(key).rows.push({ row, index });
  });
  const list = [...groups.values()];
  for (const group of list) {
    const family = list.filter((other) => other.method === group.method);
    const differs = (key) => new Set(family.map((g) => g[key] ?? null)).size > 1;
    const extra = [...["substeps", "passes"].filter(differs).map((key) => `${group[key] ?? "–"} ${key}`),
      ...["order", "integrator", "impact"].filter(differs).map((key) => group[key] ?? "–")];
    group.name = [group.method, ...extra].join(", ");
    group.variant = family.indexOf(group);
    group.rows.sort((a, b) => (b.row.dt ?? 0) - (a.row.dt ?? 0));
  }
  return list;
}

/** The steps that occur, largest first, each with its label. */
export function stepsOf(rows) {
  const labels = new Map();
  for (const row of rows) if (isStepped(row) && !labels.has(row.dt)) labels.set(row.dt, stepLabel(row));
  return [...labels].sort((a, b) => b[0] - a[0]).map(([dt, label]) => ({ dt, label }));
}
