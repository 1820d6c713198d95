/// \file
/// The time-of-impact query as a service of one line.
#pragma once

#include <iosfwd>

namespace carom::cli {

/// Answers each line of `in` with a line on `out`, until the end. Written out when nothing more waits to be read, so
/// that one who asks line by line is answered line by line.
void serve_toi(std::istream& in, std::ostream& out);

}  // namespace carom::cli
