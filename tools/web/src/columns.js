// The columns of compare.csv: heading, unit, and what each means. Table, glossary and axis names all read from here.

const length = (u) => u.length;
const speed = (u) => `${u.length}/${u.time}`;
const time = (u) => u.time;
const seconds = () => "s";
const none = () => "";

export const COLUMNS = [
  { key: "method", title: "method", kind: "text", unit: none, text: "How the scene was simulated. “event” is exact in time and takes no step." },
  { key: "dt", title: "step dt", kind: "step", unit: time, text: "Length of a time step; none for the event-driven method." },
  { key: "substeps", title: "substeps", kind: "count", unit: none, text: "Equal parts into which each step is cut." },
  { key: "passes", title: "passes", kind: "count", unit: none, text: "How often the contacts are visited in a substep; none where a method reads no passes." },
  { key: "order", title: "order", kind: "text", unit: none, text: "Order in which contacts are visited; none where a method reads no order." },
  { key: "integrator", title: "integrator", kind: "text", unit: none, text: "Motion between contacts: “euler” moves by the speed after gravity, “parabola” is exact in flight." },
  { key: "impact", title: "operator", kind: "text", unit: none, text: "Operator of the event method for several contacts at once." },
  { key: "stiffness", title: "stiffness", kind: "number", unit: none, text: "Stiffness of the springs of “penalty”, mass/time^2; none where each contact has its own." },
  { key: "hertz", title: "hertz", kind: "number", unit: none, text: "Frequency of the springs of “soft”, 1/time." },
  { key: "damping_ratio", title: "damping ratio", kind: "number", unit: none, text: "Damping ratio of the springs of “soft”." },
  { key: "cpu_seconds", title: "CPU time", kind: "number", unit: seconds, text: "Processor time of one run up to the end of what is compared, giving its samples: the median of the repeats." },
  { key: "cpu_min", title: "CPU time, least", kind: "number", unit: seconds, text: "The fastest repeat." },
  { key: "cpu_max", title: "CPU time, most", kind: "number", unit: seconds, text: "The slowest repeat." },
  { key: "position_rms", title: "position error, rms", kind: "number", unit: length, text: "Distance to the reference: root mean square over spheres and sample times." },
  { key: "position_max", title: "position error, greatest", kind: "number", unit: length, text: "Distance to the reference: the greatest over spheres and sample times." },
  { key: "position_final_rms", title: "final position error, rms", kind: "number", unit: length, text: "Distance to the reference at the end: root mean square over spheres." },
  { key: "position_final_max", title: "final position error", kind: "number", unit: length, text: "Distance to the reference at the end: the sphere that is worst." },
  { key: "velocity_rms", title: "velocity error, rms", kind: "number", unit: speed, text: "Difference of velocity to the reference: root mean square over spheres and sample times." },
  { key: "energy_error", title: "energy error", kind: "number", unit: none, text: "Greatest difference of energy to the reference at a sample time, divided by the reference’s greatest kinetic energy." },
  { key: "max_penetration", title: "deepest penetration", kind: "number", unit: length, text: "Deepest overlap seen; for discrete methods at the end of a substep, before correction, which a chart over time does not see." },
  { key: "overlap_left", title: "overlap left", kind: "number", unit: length, text: "Deepest overlap at a sample time, after the method’s corrections." },
  { key: "missed_impacts", title: "late or missed impacts", kind: "count", unit: none, text: "Impacts of the reference that the method did not find within 3 steps: those that came early or late, and those that never came. Counted up to the divergence." },
  { key: "invented_impacts", title: "invented impacts", kind: "count", unit: none, text: "Impacts of the method that the reference does not have within 3 steps. Counted up to the divergence." },
  { key: "impacts", title: "impacts", kind: "count", unit: none, text: "Contacts that got an impulse." },
  { key: "audited", title: "audited", kind: "count", unit: none, text: "Impacts that the method was put to one at a time: begun anew from the exact state at a random phase of the step before each, it takes two steps. Where there are few, each at several phases. For “event”: impacts of the reference that its run was held against." },
  { key: "found", title: "found", kind: "count", unit: none, text: "Of those audited, answered in their step, and the velocity after two steps is right to 1 % of what the impact changed. For “event”: at the right time, to 1e-9 of the smallest radius at the speed of the scene." },
  { key: "late", title: "late", kind: "count", unit: none, text: "Of those audited, answered in the step after. For “event”: early or late by more than that." },
  { key: "missed", title: "missed", kind: "count", unit: none, text: "Of those audited, not answered within two steps." },
  { key: "wrong", title: "wrong", kind: "count", unit: none, text: "Of those audited, answered in their step, but with another velocity." },
  { key: "invented", title: "invented", kind: "count", unit: none, text: "Two steps of bodies that have no impact in them, in which the method answers one all the same; how many were looked at says compare.json. For “event”: impacts that the reference does not have." },
  { key: "crowded", title: "crowded", kind: "count", unit: none, text: "Impacts not audited at this step: one of the bodies has another contact within the two steps." },
  { key: "absorbed", title: "absorbed", kind: "count", unit: none, text: "Impacts of the reference closing slower than v_c that the event method took for rest, neither found nor missed; its errors say what that costs." },
  { key: "rest_jitter", title: "jitter at rest", kind: "number", unit: speed, text: "Root mean square speed of bodies that rest in the reference." },
  { key: "divergence_time", title: "divergence time", kind: "number", unit: time, text: "First sample at which some sphere is further than a hundredth of the smallest radius from the reference; empty if never." },
  { key: "reference_bound", title: "reference bound", kind: "number", unit: length, text: "How far the reference itself may be off. Errors below it are not resolved." },
  { key: "steps", title: "steps", kind: "count", unit: none, text: "Time steps taken, substeps counted." },
  { key: "root_solves", title: "root solves", kind: "count", unit: none, text: "Contact times computed by solving for a root: work that does not depend on the machine." },
  { key: "pair_tests", title: "pair tests", kind: "count", unit: none, text: "Pairs of bodies examined: work that does not depend on the machine." },
  { key: "status", title: "status", kind: "text", unit: none, text: "How the run ended; “reached_end” is the good one." },
  { key: "peer_settings", title: "other engine", kind: "text", unit: none, text: "Name, version and settings of an engine that is none of carom’s. Its impacts are not counted, and its time is that of its own steps, as it says itself, without reading and writing." },
];

/** What the table has in place of `missed_impacts`: its two parts (see rows.js). */
const LATE = { key: "mistimed", title: "late impacts", kind: "count", unit: none, text: "Impacts of the reference that came more than 3 steps early or late. Counted up to the divergence; a dash: it came before the first impact." };
const LOST = { key: "lost", title: "missed impacts", kind: "count", unit: none, text: "Impacts of the reference that never came. Counted up to the divergence; a dash: it came before the first impact." };
const BY_KEY = Object.fromEntries([...COLUMNS, LATE, LOST].map((column) => [column.key, column]));
const FIRST = ["method", "position_max", "position_final_max", "energy_error", "max_penetration", "audited", "found", "late", "missed", "wrong", "invented", "mistimed", "lost", "invented_impacts", "divergence_time", "rest_jitter", "cpu_seconds", "status"];

/** The table's columns: errors first, then what they cost, then the rest in the order of the file. The step stands beside the method. */
export const TABLE_COLUMNS = [...FIRST, ...COLUMNS.map((c) => c.key).filter((key) => !FIRST.includes(key) && !["dt", "missed_impacts"].includes(key))].map((key) => BY_KEY[key]);

export const COLUMN = Object.fromEntries(COLUMNS.map((column) => [column.key, column]));

/** What the work-precision diagram may draw upwards, the first by default. `bounded`: the reference's bound is in the same quantity. */
export const ERRORS = [
  { key: "position_max", name: "greatest position error", option: "position, greatest over time", bounded: true },
  { key: "position_final_max", name: "position error at the end", option: "position, at the end (worst sphere)", bounded: true },
  { key: "position_rms", name: "position error, rms", option: "position, rms over time", bounded: true },
  { key: "velocity_rms", name: "velocity error, rms", option: "velocity, rms over time" },
  { key: "energy_error", name: "energy error, relative", option: "energy, relative" },
  { key: "max_penetration", name: "deepest penetration", option: "penetration, deepest" },
];

/** What it may draw to the right. */
export const WORKS = [
  { key: "cpu_seconds", name: "CPU time of one run", option: "CPU time", seconds: true },
  { key: "steps", name: "steps taken", option: "steps" },
  { key: "root_solves", name: "roots solved", option: "root solves" },
  { key: "pair_tests", name: "pairs tested", option: "pair tests" },
];
