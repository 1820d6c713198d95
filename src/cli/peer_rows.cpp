#include "cli/peer_rows.hpp"

#include "peers/peers.hpp"

#include <carom/error.hpp>
#include <carom/method.hpp>

#include <algorithm>

namespace carom::cli {

std::vector<std::string> methods_and_peers()
{
    std::vector<std::string> names = method_names();
    names.insert(names.end(), peers::peer_names().begin(), peers::peer_names().end());
    return names;
}

AskedMethods asked_methods(const std::vector<std::string>& names, const Scene& scene, const std::string& file)
{
    AskedMethods asked;
    for (const std::string& name : names) {
        const std::vector<std::string>& own = method_names();
        if (std::find(own.begin(), own.end(), name) != own.end()) {
            asked.methods.push_back(name);
            continue;
        }
        expect_peers_know(scene, file);
        const bool is_new =
            std::none_of(asked.peers.begin(), asked.peers.end(), [&](const Peer& each) { return each.name == name; });
        if (const auto program = peers::program_of(name); !program)
            asked.absent.push_back(name + ": " + peers::how_to_get(name));
        else if (is_new)
            asked.peers.push_back(peers::make_peer(name, *program));
    }
    return asked;
}

void expect_peers_know(const Scene& scene, const std::string& file)
{
    if (scene.drag > 0)
        throw InputError({file + ": /drag: engines beside have none that is linear (leave their rows out, or drag)"});
}

}  // namespace carom::cli
