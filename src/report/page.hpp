/// \file
/// Self-contained pages: one HTML file with its scripts, styles and data, readable from disk and without a network.
///
/// Page data, "carom-page/1" (JSON, UTF-8). Times count from the start of the run; lengths, times and masses are in the
/// scene's units; what is not known is null or left out, never NaN. Every index counts from 0.
///
///     {"format": "carom-page/1", "generator": "carom 0.1.0", "comparisons": [COMPARISON, ...]}
///
/// COMPARISON:
/// - `title`, `description`: plain text; the title also names the files that can be downloaded.
/// - `units`: {`length`, `time`, `mass`}, texts as in the scene; without a key axes say "length", "time". "s" and "m"
/// get
///   prefixes.
/// - `verdict`: sentences; the first is set large and repeated in the overview.
/// - `until`: end of the comparison [time].
/// - `tolerance`: the position error that the verdict asks for [length]; may be left out.
/// - `step_shown`: the step that charts over time show at first, the verdict's [time]; null or left out: the middle
/// one.
/// - `reference`: {`kind`: "closed_form" | "multiprecision", `bound` [length], `until` [time], `reason`}; the reason
///   says why the reference ends before the run does, "" if it does not.
/// - `rows`: one object a run. Its keys are the columns of compare.csv (numbers as numbers, null for an empty cell)
///   and `label`, for instance "velocity, dt = 1/240": the word after "dt = " is written beside the run's point. Three
///   more may be left out: `mistimed_impacts`, the part of `missed_impacts` that came, but early or late;
///   `reference_impacts`, how many were looked for (none where the run diverged before the first); `time` reached.
/// - `series`: errors over time, at most one a row, arrays of one length, null where not known:
///   {`row`: index into rows, `time`: [..], `energy_error`: [..] signed, (E - E_ref) / max kinetic energy of the
///   reference, `penetration`: [..] >= 0, of the state at the sample, for a stepper after its correction [length],
///   `position_max`: [..] [length]}.
/// - `missed`: {`row`, `times`: [..] ascending, `names`: ["ball - floor", ..]} for rows that missed impacts. The
///   lists may be cut to the first few hundred; the count is taken from the row's `missed_impacts`.
/// - `view`: the picture; may be left out.
///
/// VIEW:
/// - `axes`: names of the axes to the right and up, ["x", "z"]; `from_above`: true if gravity points into the picture.
/// - `min`, `max`: [right, up], the box in which tracks are stored: a few percent wider than all that the reference
///   visits and the planes it meets. What leaves the box is clamped and drawn as gone.
/// - `radius`, `color`, `names`: one for each sphere shown; colours are CSS texts, "" for the method's own colour.
/// - `planes`: {`normal`: [right, up], `offset`, `thickness`, `name`}, a plane's section with the view: all x with
///   normal.x = offset (a normal of any length, the offset to match). `thickness` null: a half-space, solid where
///   normal.x < offset; a number >= 0: a plate of that thickness about it. Planes parallel to the view are left out;
///   box walls are planes.
/// - `periodic`: true if spheres may jump to a periodic image (false).
/// - `times`: one for each frame, ascending, at least two.
/// - `tracks`: {`row`: index into rows, -1 for the reference, `data`}. The data are base64 (RFC 4648, padded) of
///   little-endian uint16, frame by frame, sphere by sphere, right then up: 65535 (x - min) / (max - min), rounded
///   and clamped to [0, 65535].
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// The page without data: the bundle of tools/web or, built without node, a stub that shows the rows as a table.
std::string_view page_template();

/// Where `page_template` takes its data; it occurs there exactly once.
inline constexpr std::string_view page_data_marker = "@CAROM_DATA@";

/// One self-contained HTML page that shows `data_json` (valid JSON, format carom-page/1, see above,
/// carom-tunnel-page/1, see tunnel_page.hpp, or carom-stress-page/1, see stress_page.hpp). Every '<' of the
/// data is written as the escape \\u003c, so that no "</script>" or "<!--" in a name can end the element that holds
/// them.
std::string comparison_page(std::string_view data_json);

}  // namespace carom
