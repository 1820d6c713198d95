#include "io/object_view.hpp"

#include <algorithm>

namespace carom::io {

namespace {

std::string list_of(std::initializer_list<std::string_view> keys)
{
    std::string text;
    for (const auto key : keys) text += (text.empty() ? "\"" : ", \"") + std::string(key) + "\"";
    return text;
}

}  // namespace

ObjectView::ObjectView(const Place& place, Problems& problems)
    : place_(place), problems_(problems), consumed_(place.value->keys.size())
{
    if (!is_object()) problems_.add(place_.pointer, "must be an object, is " + describe(*place_.value));
}

std::optional<Place> ObjectView::find(std::string_view key)
{
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) asked_.emplace_back(key);
    const auto& keys = place_.value->keys;
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end()) return {};
    const auto index = static_cast<std::size_t>(found - keys.begin());
    consumed_[index] = true;
    return Place{&place_.value->items[index], pointer(key)};
}

void ObjectView::require(std::initializer_list<std::string_view> keys)
{
    if (!is_object()) return;
    for (const auto key : keys)
        if (!has(key)) problem(key, "is missing (it has no default)");
}

void ObjectView::one_of(std::initializer_list<std::string_view> keys, bool need_one)
{
    if (!is_object()) return;
    std::size_t n = 0;
    for (const auto key : keys) n += has(key) ? 1 : 0;
    if (n > 1) problems_.add(place_.pointer, "has more than one of " + list_of(keys) + " (give one)");
    if (n == 0 && need_one) problems_.add(place_.pointer, "has none of " + list_of(keys) + " (give one)");
}

std::optional<double> ObjectView::number(std::string_view key, const Range& range)
{
    const auto place = find(key);
    return place ? as_number(*place, range, problems_) : std::nullopt;
}

std::optional<std::uint64_t> ObjectView::integer(std::string_view key, std::uint64_t min, std::uint64_t max)
{
    const auto place = find(key);
    return place ? as_integer(*place, min, max, problems_) : std::nullopt;
}

std::optional<std::string> ObjectView::string(std::string_view key)
{
    const auto place = find(key);
    return place ? as_string(*place, problems_) : std::nullopt;
}

std::optional<bool> ObjectView::boolean(std::string_view key)
{
    const auto place = find(key);
    return place ? as_boolean(*place, problems_) : std::nullopt;
}

std::optional<Vec3> ObjectView::vector(std::string_view key)
{
    const auto place = find(key);
    return place ? as_vector(*place, problems_) : std::nullopt;
}

std::optional<std::string> ObjectView::word(std::string_view key, const std::vector<std::string>& words,
                                            const std::vector<std::string>& later)
{
    const auto place = find(key);
    return place ? as_word(*place, words, later, problems_) : std::nullopt;
}

std::vector<Place> ObjectView::list(std::string_view key)
{
    const auto place = find(key);
    return place ? as_list(*place, problems_) : std::vector<Place>{};
}

void ObjectView::not_yet(std::string_view key, bool (*harmless)(const Json&))
{
    const auto place = find(key);
    if (place && !harmless(*place->value)) problem(key, "not yet supported (remove it)");
    std::erase(asked_, key);  // no suggestion
}

void ObjectView::never(std::initializer_list<std::string_view> keys, const std::string& cure)
{
    for (const auto key : keys) {
        if (has(key)) problem(key, "unknown key (" + cure + ")");
        std::erase(asked_, key);  // no suggestion
    }
}

void ObjectView::finish()
{
    for (std::size_t i = 0; i < consumed_.size(); ++i) {
        const std::string& key = place_.value->keys[i];
        if (!consumed_[i]) problem(key, "unknown key" + suggestion(key, asked_, "known here"));
    }
}

}  // namespace carom::io
