#include "queue/event_queue.hpp"

#include <algorithm>
#include <numeric>

namespace carom {

EventQueue::EventQueue(std::size_t slots) : keys_(slots), heap_(slots), place_(slots)
{
    std::iota(heap_.begin(), heap_.end(), 0u);
    std::iota(place_.begin(), place_.end(), 0u);
}

void EventQueue::set(std::size_t slot, const Key& key)
{
    const bool earlier = key < keys_[slot];
    keys_[slot] = key;
    if (earlier)
        rise(place_[slot]);
    else
        sink(place_[slot]);
}

void EventQueue::rise(std::size_t place)
{
    const std::uint32_t slot = heap_[place];
    while (place > 0) {
        const std::size_t parent = (place - 1) / 2;
        if (!(keys_[slot] < keys_[heap_[parent]])) break;
        heap_[place] = heap_[parent];
        place_[heap_[place]] = static_cast<std::uint32_t>(place);
        place = parent;
    }
    heap_[place] = slot;
    place_[slot] = static_cast<std::uint32_t>(place);
}

void EventQueue::sink(std::size_t place)
{
    const std::uint32_t slot = heap_[place];
    for (;;) {
        std::size_t child = 2 * place + 1;
        if (child >= heap_.size()) break;
        if (child + 1 < heap_.size() && keys_[heap_[child + 1]] < keys_[heap_[child]]) ++child;
        if (!(keys_[heap_[child]] < keys_[slot])) break;
        heap_[place] = heap_[child];
        place_[heap_[place]] = static_cast<std::uint32_t>(place);
        place = child;
    }
    heap_[place] = slot;
    place_[slot] = static_cast<std::uint32_t>(place);
}

std::size_t LinearQueue::first() const
{
    return static_cast<std::size_t>(std::min_element(keys_.begin(), keys_.end()) - keys_.begin());
}

}  // namespace carom
