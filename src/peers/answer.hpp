/// \file
/// The answer of a peer's program as a run.
#pragma once

#include <carom/study.hpp>

#include <string_view>

namespace carom::peers {

/// \param text as docs/peers.md has it, without the line that ends it. What is no such answer is a run that is
/// `unresolved`, with the reason as its message.
PeerRun run_of_answer(const Scene& scene, const std::vector<double>& times, std::string_view text);

}  // namespace carom::peers
