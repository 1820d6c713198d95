/// \file
/// A list of a few things that lives where it is declared: no allocation on the hot path.
#pragma once

#include "core/expect.hpp"

#include <array>
#include <cstddef>

namespace carom {

template <class T, std::size_t most>
class Few {
public:
    void push_back(const T& value)
    {
        CAROM_EXPECT(size_ < most);
        items_[size_++] = value;
    }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T& front() { return items_[0]; }
    const T& front() const { return items_[0]; }
    T* begin() { return items_.data(); }
    T* end() { return items_.data() + size_; }
    const T* begin() const { return items_.data(); }
    const T* end() const { return items_.data() + size_; }

private:
    std::array<T, most> items_;
    std::size_t size_ = 0;
};

}  // namespace carom
