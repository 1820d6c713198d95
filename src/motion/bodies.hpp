/// \file
/// The motions of all spheres of a run: their one owner, and the one function that changes them.
#pragma once

#include "motion/motion.hpp"
#include "motion/persistent_contacts.hpp"

#include "flight/flight.hpp"

namespace carom {

/// The motion with which a body goes on.
struct Change {
    BodyId body = no_body;
    Flight flight{};
    Motion motion = Flying{};
    std::vector<PersistentContact> contacts{};  ///< of a body that is held by several, or in a numeric piece
};

/// The number type in which free flights are advanced and predicted.
enum class Precision : std::uint8_t { plain, certified };

class Bodies {
public:
    Bodies(const Scene& scene, const Frame& frame, Precision precision);

    BodyId count() const { return static_cast<BodyId>(hot_.size()); }
    double radius(BodyId body) const { return radii_[at(body)]; }  ///< [length]
    const Flight& flight(BodyId body) const { return hot_[at(body)].flight; }
    MotionKind kind(BodyId body) const { return hot_[at(body)].kind; }
    /// The number of changes of the body's flight since the start; 0: as the scene began.
    std::uint32_t stamp(BodyId body) const { return hot_[at(body)].stamp; }
    const Motion& motion(BodyId body) const { return motions_[at(body)]; }
    /// The body's motion if it is of that alternative, else null.
    template <class Alternative>
    const Alternative* as(BodyId body) const
    {
        return kind(body) == Alternative::kind ? &std::get<Alternative>(motions_[at(body)]) : nullptr;
    }
    /// Whether some body is in a numeric step or a window of the guard.
    bool some_in_piece() const { return in_piece_ > 0; }
    bool is_in_piece(BodyId body) const { return is_piece(kind(body)); }
    /// Whether the body is in a window of a heap, which knows all planes that it could reach.
    bool is_in_heap_window(BodyId body) const
    {
        const auto* window = as<Windowed>(body);
        return window && window->piece;
    }
    /// Whether both go on in the same window, in which they do not meet.
    bool share_window(BodyId a, BodyId b) const
    {
        const auto *of_a = as<Windowed>(a), *of_b = as<Windowed>(b);
        return of_a && of_b && of_a->piece && of_a->piece == of_b->piece;
    }
    /// Whether spheres or several planes hold the body, or it is in a piece.
    bool is_held_by_several(BodyId body) const { return carom::is_held_by_several(kind(body)); }

    const PersistentContacts& contacts() const { return contacts_; }
    const Accelerations& accelerations() const { return accelerations_; }
    /// The acceleration of a flight [length/time^2].
    const Vec3& acceleration(const Flight& flight) const { return accelerations_[flight.acceleration]; }

    /// Sets the motion of a body from here on. Its stamp, its contacts and its own acceleration follow.
    void set(const Change& change)
    {
        Hot& hot = hot_[at(change.body)];
        hot.flight = change.flight;
        ++hot.stamp;
        if (hot.kind != MotionKind::flying || kind_of(change.motion) != MotionKind::flying) enter(change);
    }
    /// Sets other forces in the same persistent contacts: no change of the motion.
    void set_forces(BodyId body, const std::vector<PersistentContact>& contacts);
    /// Stamps begin at 0: the present motions are those with which the scene begins.
    void begin();

private:
    struct Hot {
        Flight flight{};
        std::uint32_t stamp = 0;
        MotionKind kind = MotionKind::flying;
    };

    /// The part of `set` for bodies that were not flying or do not fly on.
    void enter(const Change& change);
    static std::size_t at(BodyId body) { return static_cast<std::size_t>(body); }

    std::vector<Hot> hot_;         ///< by body
    std::vector<double> radii_;    ///< by body
    std::vector<Motion> motions_;  ///< by body
    PersistentContacts contacts_;
    Accelerations accelerations_;
    int in_piece_ = 0;  ///< bodies whose motion is stepping or windowed
};

}  // namespace carom
