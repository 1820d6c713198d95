/// \file
/// Engines of others as rows: their programs, which tools/peers builds where the engines are installed. Nothing here
/// links an engine.
#pragma once

#include "tunnel/peers.hpp"

#include <carom/study.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace carom::peers {

/// Names of rows: `bullet`, `ode` with the settings that suit hard spheres best, `bullet_ccd` with continuous detection
/// beside, `bullet_defaults`, `ode_defaults` as they come.
const std::vector<std::string>& peer_names();

/// The program of a peer, in the folder that the environment's CAROM_PEERS names, else beside this program; none if it
/// is not there. \pre the name is one of peer_names()
std::optional<std::filesystem::path> program_of(const std::string& name);

/// Law of the engine as of other methods (docs/tunnel.md); none where none is known.
std::optional<double> chords_seen_by(const std::string& name);

/// How to get what is not there, for messages.
std::string how_to_get(const std::string& name);

/// The peer as rows of a comparison. Its program is started by the first run, and killed with the last copy.
/// \param program as program_of found it
Peer make_peer(const std::string& name, const std::filesystem::path& program);

/// The peer as who is thrown with. A throw that gets no answer throws InputError; Stopped if `keep_going` said no.
tunnel::Contestant peer_contestant(const std::string& name, const std::filesystem::path& program,
                                   std::function<bool()> keep_going);

}  // namespace carom::peers
