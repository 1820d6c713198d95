/// \file
/// A certificate as JSON, format carom-verify/1.
#pragma once

#include "io/command_facts.hpp"

#include <carom/io.hpp>
#include <carom/verify.hpp>

#include <string>

namespace carom::io {

/// One JSON object, indented, with its last line end. What is not finite is null; so is `holds` where the examination
/// was stopped before it found anything wrong. \throws InputError as the reader
std::string verify_json(const Certificate& certificate, const RecordingReader& recording,
                        const CommandFacts& command = {});

}  // namespace carom::io
