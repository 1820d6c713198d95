#include "queue/event_queue.hpp"

#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

/// Few different times and kinds, so that ties are common.
Key any(Random& random, std::size_t slot)
{
    if (random.integer(0, 9) == 0) return {};
    const auto kind = static_cast<Scheduled>(random.integer(0, 4));
    return {{random.integer(0, 3), 0.25 * random.integer(0, 3)},
            kind,
            random.integer(0, 2),
            Partner::sphere(static_cast<BodyId>(slot))};
}

}  // namespace

TEST_CASE("the queue agrees with a linear search through random changes, ties included")
{
    for (const std::size_t slots : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{7}, std::size_t{100}}) {
        Random random(slots);
        EventQueue queue(slots);
        LinearQueue twin(slots);
        for (int i = 0; i < 20000; ++i) {
            // Half of the changes hit the first slot, as in a run.
            const std::size_t slot = random.coin()
                                         ? queue.first()
                                         : static_cast<std::size_t>(random.integer(0, static_cast<int>(slots) - 1));
            const Key key = any(random, slot);
            queue.set(slot, key);
            twin.set(slot, key);
            const Key first = queue.key(queue.first());
            REQUIRE(first == twin.key(twin.first()));
            if (first.kind != Scheduled::nothing) REQUIRE(queue.first() == twin.first());
        }
        for (std::size_t slot = 0; slot < slots; ++slot) CHECK(queue.key(slot) == twin.key(slot));
    }
}

TEST_CASE("events leave the queue in order of time, then kind, then bodies, spheres before planes")
{
    const std::vector<Key> ordered{{{0, 0.5}, Scheduled::cell_crossing, 9, Partner::cell_wall(1, true)},
                                   {{1, 0.25}, Scheduled::pair_impact, 0, Partner::sphere(5)},
                                   {{1, 0.25}, Scheduled::pair_impact, 1, Partner::sphere(2)},
                                   {{1, 0.25}, Scheduled::pair_impact, 1, Partner::sphere(3)},
                                   {{1, 0.25}, Scheduled::plane_impact, 0, Partner::plane(7)},
                                   {{1, 0.25}, Scheduled::series_end, 0, Partner::plane(1)},
                                   {{1, 0.25}, Scheduled::intrusion, 0, Partner::sphere(9)},
                                   {{1, 0.25}, Scheduled::intrusion, 0, Partner::plane(0)},
                                   {{1, 0.5}, Scheduled::pair_impact, 0, Partner::sphere(1)},
                                   {}};
    EventQueue queue(ordered.size());
    for (std::size_t i = 0; i < ordered.size(); ++i) queue.set((i * 7 + 3) % ordered.size(), ordered[i]);
    for (const Key& key : ordered) {
        CHECK(queue.key(queue.first()) == key);
        queue.set(queue.first(), {});
    }
    CHECK(queue.key(queue.first()).time == never);
}
