/// \file
/// A scene in code, run, with the installed library: a ball dropped from 1 m comes to rest at 9 sqrt(2h/g).
#include <carom/carom.hpp>

#include <cmath>
#include <cstdio>

#if !defined(EIGEN_DONT_VECTORIZE) || EIGEN_MAX_ALIGN_BYTES != 16
#error "the package must hand its compile definitions on: Eigen's types and sums depend on them"
#endif

namespace {

carom::Scene bouncing_ball()
{
    carom::Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.end_time = 5;
    scene.materials[0].restitution = 0.8;
    carom::Sphere ball;
    ball.id = "ball";
    ball.radius = 0.1;
    ball.position = {0, 0, 1.1};
    scene.spheres.push_back(ball);
    carom::Plane floor;
    floor.id = "floor";
    scene.planes.push_back(floor);
    return scene;
}

}  // namespace

int main()
{
    const carom::Scene scene = bouncing_ball();
    for (const std::string& problem : carom::validate(scene)) std::printf("%s\n", problem.c_str());
    const carom::Outcome outcome = carom::simulate(scene, carom::EventDriven{});
    if (outcome.status != carom::Status::reached_end || !outcome.rest_times[0]) return 1;
    std::printf("%s comes to rest at %.10f\n", scene.spheres[0].id.c_str(), *outcome.rest_times[0]);

    const double expected = 9 * std::sqrt(2 * 1 / 9.81);
    const carom::TimeOfImpact first =
        carom::time_of_impact({.position = {0, 0, 1.1}, .acceleration = {0, 0, -9.81}, .radius = 0.1}, scene.planes[0]);
    std::printf("the first impact is at %.10f\n", first.t);
    return std::abs(*outcome.rest_times[0] - expected) < 1e-12 && std::abs(first.t - expected / 9) < 1e-15 ? 0 : 1;
}
