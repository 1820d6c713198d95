/// \file
/// One run of one kernel, to be counted by callgrind: `carom_kernels CASE KERNEL`. tests/bench/kernels makes the table.
#include "bounce_by_hand.hpp"

#include <carom/io.hpp>
#include <carom/simulate.hpp>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace {

using carom::Scene;

carom::Sphere sphere(const std::string& id, double radius, const carom::Vec3& position, const carom::Vec3& velocity)
{
    carom::Sphere s;
    s.id = id;
    s.radius = radius;
    s.position = position;
    s.velocity = velocity;
    return s;
}

carom::Plane plane(const std::string& id, const carom::Vec3& normal, double offset)
{
    carom::Plane p;
    p.id = id;
    p.normal = normal;
    p.offset = offset;
    return p;
}

/// A ball on a floor, e = 1, a little more than `impacts` impacts.
Scene bounce(int impacts)
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.spheres.push_back(sphere("ball", 0.1, {0, 0, 1.1}, {0.2, 0, 0}));
    scene.planes.push_back(plane("floor", {0, 0, 1}, 0));
    scene.end_time = (impacts + 0.5) * 2 * std::sqrt(2 / 9.81);
    return scene;
}

/// 12 x 12 x 12 equal spheres in a closed box.
Scene gas()
{
    Scene scene;
    const int n = 12;
    for (int i = 0; i < n * n * n; ++i) {
        const carom::Vec3 site(i % n, i / n % n, i / (n * n));
        const carom::Vec3 shift(i * 11 % 19 - 9.1, i * 13 % 23 - 11.2, i * 7 % 29 - 14.3);  // no two contacts at once
        const carom::Vec3 stir(i * 7 % 13 - 6, i * 5 % 11 - 5, i * 3 % 17 - 8);
        scene.spheres.push_back(sphere("s" + std::to_string(i), 0.3, site + shift / 300, stir / 6));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const carom::Vec3 e = carom::Vec3::Unit(axis);
        scene.planes.push_back(plane("low" + std::to_string(axis), e, -0.5));
        scene.planes.push_back(plane("high" + std::to_string(axis), -e, -(n - 0.5)));
    }
    scene.end_time = 2;
    return scene;
}

Scene make(std::string_view name)
{
    if (name == "one_ball" || name == "by_hand" || name == "plain_by_hand") return bounce(1'000'000);
    if (name == "gas_1000") return carom::read_scene(carom::find_scene("gas_1000", CAROM_SCENE_DIR));
    Scene scene = gas();
    scene.gravity = {0, 0, -9.81};
    if (name == "gas_with_gravity") return scene;
    for (std::size_t i = 0; i < scene.spheres.size(); i += 10) {
        scene.spheres[i].fixed = true;
        scene.spheres[i].velocity.setZero();
    }
    if (name == "gas_with_fixed_spheres") return scene;
    std::fprintf(stderr, "carom_kernels: no case %s\n", std::string(name).c_str());
    std::exit(2);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: carom_kernels CASE KERNEL\n");
        return 2;
    }
    const std::string_view name = argv[1];
    const Scene scene = make(name);
    if (name == "by_hand" || name == "plain_by_hand") {
        const bounce_by_hand::Log log =
            name == "by_hand" ? bounce_by_hand::same_bits(scene, nullptr) : bounce_by_hand::plain(scene);
        std::printf("%lld %016llx\n", static_cast<long long>(log.impacts), static_cast<unsigned long long>(log.hash));
        return 0;
    }
    const carom::Outcome run = carom::simulate(scene, carom::EventDriven{.kernel = argv[2]});
    if (run.status != carom::Status::reached_end) {
        std::fprintf(stderr, "carom_kernels: %s\n", run.message.c_str());
        return 1;
    }
    std::printf("%lld %016llx\n", static_cast<long long>(run.counts.impacts),
                static_cast<unsigned long long>(run.event_hash));
}
