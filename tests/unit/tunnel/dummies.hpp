/// \file
/// Methods that are known to be wrong, each in one way.
#pragma once

#include "tunnel/contestant.hpp"

namespace carom::test {

/// It flies on as if there were nothing.
inline tunnel::Contestant blind()
{
    tunnel::Contestant who;
    who.method = "blind";
    who.fly = [](const tunnel::Throw& t, double dt, std::int64_t steps) {
        const Sphere& ball = t.scene.spheres[static_cast<std::size_t>(t.body)];
        tunnel::Flown flown;
        flown.velocity = flown.end_velocity = ball.velocity;
        flown.position = ball.position + 2 * dt * ball.velocity;
        flown.end_position = ball.position + static_cast<double>(steps) * dt * ball.velocity;
        return flown;
    };
    return who;
}

/// It says that it has answered, and flies on.
inline tunnel::Contestant liar()
{
    tunnel::Contestant who = blind();
    who.method = "liar";
    who.fly = [fly = who.fly](const tunnel::Throw& t, double dt, std::int64_t steps) {
        tunnel::Flown flown = fly(t, dt, steps);
        flown.answered = t.contact_time;
        return flown;
    };
    return who;
}

/// It has the truth, `late` after the contact, with the velocity off by `slower` of it.
inline tunnel::Contestant truthful(double late = 0, double slower = 0)
{
    tunnel::Contestant who;
    who.method = "truthful";
    who.fly = [late, slower](const tunnel::Throw& t, double dt, std::int64_t steps) {
        tunnel::Flown flown;
        flown.answered = t.contact_time + late;
        flown.position = t.position;
        flown.velocity = flown.end_velocity = (1 - slower) * t.velocity;
        flown.end_position = t.position + static_cast<double>(steps - 2) * dt * flown.velocity;
        return flown;
    };
    return who;
}

}  // namespace carom::test
