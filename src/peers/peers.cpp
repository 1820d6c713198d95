#include "peers/peers.hpp"

#include "core/expect.hpp"
#include "core/text.hpp"
#include "io/scene_json.hpp"
#include "peers/answer.hpp"
#include "peers/limits.hpp"
#include "peers/program.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include <unistd.h>

namespace carom::peers {

namespace {

struct Known {
    const char* name;      ///< of its rows
    const char* program;   ///< file name
    const char* package;   ///< of Debian
    const char* argument;  ///< nullptr: none but --serve
    /// As Contestant::chords_seen. ODE looks once a step and answers what approaches; Bullet's boxes have margins, and
    /// its detection on the way a law of its own.
    std::optional<double> chords;
};
constexpr std::array<Known, 5> known_peers{{{"bullet", "carom_peer_bullet", "libbullet-dev", nullptr, {}},
                                            {"bullet_ccd", "carom_peer_bullet", "libbullet-dev", "--ccd", {}},
                                            {"bullet_defaults", "carom_peer_bullet", "libbullet-dev", "--defaults", {}},
                                            {"ode", "carom_peer_ode", "libode-dev", nullptr, 1},
                                            {"ode_defaults", "carom_peer_ode", "libode-dev", "--defaults", {}}}};

const Known& known(const std::string& name)
{
    const auto* found =
        std::find_if(known_peers.begin(), known_peers.end(), [&](const Known& each) { return each.name == name; });
    CAROM_EXPECT(found != known_peers.end());
    return *found;
}

std::filesystem::path program_folder()
{
    if (const char* folder = std::getenv("CAROM_PEERS")) return folder;
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::shared_ptr<Program> server_of(const std::string& name, const std::filesystem::path& program)
{
    std::vector<std::string> arguments{"--serve"};
    if (known(name).argument != nullptr) arguments.emplace_back(known(name).argument);
    return std::make_shared<Program>(program, arguments);
}

PeerRun ask(Program& program, const Scene& scene, double dt, const std::vector<double>& times,
            const std::function<bool()>& keep_going)
{
    std::string request = "run " + to_text(dt);
    for (const double time : times) request.append(" ").append(to_text(time));
    request.append("\n").append(io::scene_json(scene)).append("\n");
    const Reply reply = program.ask(request, keep_going, longest_answer);
    if (reply.talk == Talk::answered) return run_of_answer(scene, times, reply.text);
    PeerRun run;
    run.status = reply.talk == Talk::interrupted ? Status::interrupted
                 : reply.talk == Talk::too_long  ? Status::time_limit
                                                 : Status::unresolved;
    run.message = reply.talk == Talk::too_long ? "no answer in " + to_text(longest_answer) + " s"
                                               : "its program ended without an answer";
    return run;
}

}  // namespace

std::optional<double> chords_seen_by(const std::string& name)
{
    return known(name).chords;
}

const std::vector<std::string>& peer_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Known& each : known_peers) all.emplace_back(each.name);
        return all;
    }();
    return names;
}

std::optional<std::filesystem::path> program_of(const std::string& name)
{
    std::filesystem::path file = program_folder() / known(name).program;
    if (::access(file.c_str(), X_OK) != 0) return {};
    return file;
}

std::string how_to_get(const std::string& name)
{
    return std::string("its program ") + known(name).program + " is not there (install " + known(name).package +
           ", tools/setup --peers, then tools/build release)";
}

Peer make_peer(const std::string& name, const std::filesystem::path& program)
{
    const std::shared_ptr<Program> server = server_of(name, program);
    return {name,
            [server](const Scene& scene, double dt, const std::vector<double>& times,
                     const std::function<bool()>& keep_going) { return ask(*server, scene, dt, times, keep_going); }};
}

}  // namespace carom::peers
