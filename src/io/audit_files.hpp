/// \file
/// The audit of a trace as JSON, and the scenes of its findings as files.
#pragma once

#include "audit/report.hpp"
#include "io/command_facts.hpp"

#include <carom/scene.hpp>

#include <string>

namespace carom::io {

/// Name of the file of the scene that shows a finding: "missed-0.json".
std::string finding_file(const audit::Finding& finding);

/// Format carom-scene/1, with its checks.
std::string finding_scene_json(const Scene& scene, const audit::Finding& finding);

/// Format carom-audit/1, one JSON object, indented, with its last line end.
std::string audit_json(const Scene& scene, const std::string& trace, const audit::TraceAudit& audit,
                       const CommandFacts& command = {});

}  // namespace carom::io
