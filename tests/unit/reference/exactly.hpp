/// \file
/// The reference's integrator at 50 digits, before anything is rounded to double.
#pragma once

#include "reference_scenes.hpp"

#include "reference/integrator.hpp"

#include <catch2/catch.hpp>

namespace carom::test {

using Real = reference::Decimal<50>;
using Exact = reference::Integrator<Real>;
using ExactVector = reference::Vector<Real>;

inline Exact exactly(const Scene& scene, double until)
{
    static Patience endless;  // the run that is returned keeps a reference to it
    Exact run(scene, until, endless);
    run.advance(until);
    return run;
}

inline double off(const ExactVector& a, const ExactVector& b)
{
    return static_cast<double>(reference::size(a - b));
}

inline ExactVector along_x(const Real& v)
{
    return {v, 0, 0};
}

/// Equal balls of radius 1/2 in a touching row from x = 0, velocities along x.
inline Scene row(const std::vector<double>& speeds, double restitution = 1)
{
    Scene scene;
    scene.materials[0].restitution = restitution;
    double x = 0;
    for (const double v : speeds) {
        scene.spheres.push_back(ball("ball-" + std::to_string(scene.spheres.size()), {x, 0, 0}, {v, 0, 0}, 1, 0.5));
        x += 1;
    }
    return scene;
}

}  // namespace carom::test
