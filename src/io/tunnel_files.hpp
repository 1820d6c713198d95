/// \file
/// The study of tunnelling as tunnel.csv, critical.csv and tunnel.json, and a throw as a scene file.
#pragma once

#include "io/command_facts.hpp"
#include "tunnel/study.hpp"

#include <string>

namespace carom::io {

/// Header and a line for each row; what there is none of is an empty field.
std::string tunnel_csv(const tunnel::Report& report);
std::string critical_csv(const tunnel::Report& report);

/// Format carom-tunnel/1, indented. What is not finite is null.
std::string tunnel_json(const tunnel::Report& report, const CommandFacts& command = {});

/// The example of a row as a scene (carom-scene/1) that ends after three steps, with the row's method and step as
/// defaults of `run`; for a library or a peer none is written. \pre the row has a throw
std::string throw_scene_json(const tunnel::Row& row);

}  // namespace carom::io
