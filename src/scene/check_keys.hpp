/// \file
/// Which keys each type of check has, besides its type and its tolerance: the one table that reader and validation use.
#pragma once

#include <carom/scene.hpp>

#include <array>
#include <initializer_list>
#include <string_view>

namespace carom {

enum class CheckKey : std::uint8_t { event, time, count, kind, body, value, between };
inline constexpr std::array<std::string_view, 7> check_key_names{"event", "time",  "count",  "kind",
                                                                 "body",  "value", "between"};

class CheckKeySet {
public:
    constexpr CheckKeySet(std::initializer_list<CheckKey> keys)
    {
        for (const CheckKey key : keys) bits_ |= 1U << static_cast<unsigned>(key);
    }
    constexpr bool has(CheckKey key) const { return ((bits_ >> static_cast<unsigned>(key)) & 1U) != 0; }

private:
    unsigned bits_ = 0;
};

struct CheckKeys {
    CheckType type;
    CheckKeySet required{}, optional{};
    constexpr bool has(CheckKey key) const { return required.has(key) || optional.has(key); }
};

/// In the order of CheckType.
inline constexpr std::array<CheckKeys, check_type_names.size()> check_keys{{
    {CheckType::no_overlap},
    {CheckType::energy},
    {CheckType::final_energy},
    {CheckType::momentum},
    {CheckType::inside},
    {CheckType::event_time, {CheckKey::event, CheckKey::time}, {CheckKey::between}},
    {CheckType::event_count, {CheckKey::count}, {CheckKey::kind}},
    {CheckType::rest_time, {CheckKey::body, CheckKey::time}},
    {CheckType::position, {CheckKey::body, CheckKey::time, CheckKey::value}},
    {CheckType::final_position, {CheckKey::body, CheckKey::value}},
    {CheckType::final_velocity, {CheckKey::body, CheckKey::value}},
    {CheckType::moved, {CheckKey::value}},
    {CheckType::moved_origin, {CheckKey::value}},
    {CheckType::later, {CheckKey::time}},
    {CheckType::reversed},
    {CheckType::mirrored, {CheckKey::value}},
}};

/// \pre type is one of those in the table
constexpr const CheckKeys& check_keys_of(CheckType type)
{
    return check_keys[static_cast<std::size_t>(type)];
}

/// Row k is that of the k-th type.
constexpr bool check_keys_are_in_order()
{
    for (std::size_t k = 0; k < check_keys.size(); ++k)
        if (static_cast<std::size_t>(check_keys[k].type) != k) return false;
    return true;
}
static_assert(check_keys_are_in_order());

}  // namespace carom
