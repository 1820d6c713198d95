/// \file
/// Engines that are none of carom's, among the methods that a user asks for.
#pragma once

#include <carom/scene.hpp>
#include <carom/study.hpp>

#include <string>
#include <vector>

namespace carom::cli {

/// Names of carom's methods and of the engines beside.
std::vector<std::string> methods_and_peers();

struct AskedMethods {
    std::vector<std::string> methods;  ///< carom's
    std::vector<Peer> peers;           ///< those asked for that are there
    std::vector<std::string> absent;   ///< for each that is not: "bullet: how to get it"
};

/// \param names each one of methods_and_peers()
/// \throws InputError if peers are asked for that cannot have the scene. \param file of the scene
AskedMethods asked_methods(const std::vector<std::string>& names, const Scene& scene, const std::string& file);

/// \throws InputError for a scene with drag, which no engine beside has as carom means it
void expect_peers_know(const Scene& scene, const std::string& file);

}  // namespace carom::cli
