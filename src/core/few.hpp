/// \file
/// A short list that never allocates.
#pragma once

#include "core/expect.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace carom {

/// A list of up to `most` values. Places that hold none are left as they are, for an event makes many lists and fills
/// few.
template <class T, std::size_t most>
class Few {
    static_assert(std::is_trivially_destructible_v<T>);

public:
    Few() {}
    Few(const Few& other) : size_(other.size_) { std::uninitialized_copy(other.begin(), other.end(), begin()); }
    Few& operator=(const Few& other)
    {
        if (this == &other) return *this;
        size_ = other.size_;
        std::uninitialized_copy(other.begin(), other.end(), begin());
        return *this;
    }

    void push_back(const T& value)
    {
        CAROM_EXPECT(size_ < most);
        std::construct_at(begin() + size_, value);
        ++size_;
    }
    bool empty() const { return size_ == 0; }
    std::size_t size() const { return size_; }
    T& front() { return *begin(); }
    const T& front() const { return *begin(); }
    T* begin() { return storage_.items.data(); }
    T* end() { return begin() + size_; }
    const T* begin() const { return storage_.items.data(); }
    const T* end() const { return begin() + size_; }

private:
    union Storage {
        Storage() {}
        std::array<T, most> items;
    };

    Storage storage_;
    std::size_t size_ = 0;
};

}  // namespace carom
