#include "io/lift_json.hpp"

namespace carom::io {

nlohmann::ordered_json lifts_json(const Scene& scene, std::span<const Lift> lifts)
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Lift& lift : lifts)
        list.push_back({{"id", scene.body_name(lift.sphere)},
                        {"plane", scene.body_name(lift.plane)},
                        {"depth", lift.depth},
                        {"energy", lift.energy}});
    return list;
}

}  // namespace carom::io
