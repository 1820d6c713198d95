// The data of the page of `carom stress` (src/report/stress_page.hpp), as the page asks for them. No DOM.

/** Result of a method on a case; undefined where the runs ended before it. */
export function resultOf(entry, method) {
  return entry.results.find((result) => result.method === method);
}

/** Reasons of a case, each once, with the methods that fail for it: [{methods, reason}]. */
export function reasonsOf(entry) {
  const reasons = new Map();
  for (const { method, passed, reason } of entry.results) {
    if (!passed) reasons.set(reason, [...(reasons.get(reason) ?? []), method]);
  }
  return [...reasons].map(([reason, methods]) => ({ methods, reason }));
}

/** The catalogue name of a run, without its variation: "zeno, e = 0.9" is one of "zeno". */
export function sceneOf(run) {
  return run.split(", ", 1)[0];
}
