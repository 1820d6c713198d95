/// \file
/// `--set /pointer=value`: a change of the document before anybody reads it.
#pragma once

#include <string>

#include "io/json.hpp"
#include "io/problems.hpp"

namespace carom::io {

/// Puts the value (JSON, or else a bare string) where the JSON pointer says (RFC 6901). The last key of an object may
/// be new, and so may the objects on the way to it; an element of a list is replaced, or added at its end by the next
/// index or "-". What cannot be done becomes a problem that names the pointer.
void assign(Json& document, const std::string& assignment, Problems& problems);

}  // namespace carom::io
