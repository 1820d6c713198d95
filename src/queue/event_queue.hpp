/// \file
/// The event queue: an indexed binary heap with one slot for each source of events. O(log n) to change a slot, O(1) to
/// look.
#pragma once

#include "queue/key.hpp"

#include <cstddef>
#include <vector>

namespace carom {

class EventQueue {
public:
    /// \param slots number of sources, all idle
    explicit EventQueue(std::size_t slots);

    /// The slot whose key is smallest. \pre there is a slot
    std::size_t first() const { return heap_[0]; }
    const Key& key(std::size_t slot) const { return keys_[slot]; }
    void set(std::size_t slot, const Key& key);

private:
    void rise(std::size_t place);
    void sink(std::size_t place);

    std::vector<Key> keys_;             ///< by slot
    std::vector<std::uint32_t> heap_;   ///< slots, smallest key at 0
    std::vector<std::uint32_t> place_;  ///< where a slot stands in the heap
};

/// The slow exact twin of the queue, for tests: it looks at every slot.
class LinearQueue {
public:
    explicit LinearQueue(std::size_t slots) : keys_(slots) {}
    std::size_t first() const;
    const Key& key(std::size_t slot) const { return keys_[slot]; }
    void set(std::size_t slot, const Key& key) { keys_[slot] = key; }

private:
    std::vector<Key> keys_;
};

}  // namespace carom
