#include "io/assign.hpp"

#include <algorithm>
#include <carom/error.hpp>
#include <charconv>
#include <optional>
#include <vector>

#include "core/text.hpp"

namespace carom::io {

namespace {

/// The keys of a pointer with ~0 and ~1 taken back; none if it is no pointer.
std::optional<std::vector<std::string>> split(std::string_view pointer)
{
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        const char c = pointer[i];
        if (c == '/') {
            keys.emplace_back();
        } else if (keys.empty()) {
            return {};
        } else if (c != '~') {
            keys.back() += c;
        } else {
            const char code = ++i < pointer.size() ? pointer[i] : ' ';
            if (code != '0' && code != '1') return {};
            keys.back() += code == '0' ? '~' : '/';
        }
    }
    return keys;
}

Json value_of(const std::string& text)
{
    try {
        return parse_json(text, "");
    } catch (const InputError&) {  // no JSON: a bare string
        Json json;
        json.kind = Json::Kind::string;
        json.text = text;
        return json;
    }
}

Json* member(Json& object, const std::string& key)
{
    const auto found = std::find(object.keys.begin(), object.keys.end(), key);
    const auto index = static_cast<std::size_t>(found - object.keys.begin());
    if (found == object.keys.end()) {
        object.keys.push_back(key);
        object.items.emplace_back().kind = Json::Kind::object;  // what it is becomes clear when it is assigned to
    }
    return &object.items[index];
}

Json* element(Json& list, const std::string& key)
{
    if (key == "-") {
        list.items.emplace_back().kind = Json::Kind::object;
        return &list.items.back();
    }
    std::size_t index = list.items.size();
    const char* end = key.data() + key.size();
    std::size_t number = 0;
    const auto read = std::from_chars(key.data(), end, number);
    if (read.ec == std::errc{} && read.ptr == end) index = number;
    return index < list.items.size() ? &list.items[index] : nullptr;
}

}  // namespace

void assign(Json& document, const std::string& assignment, Problems& problems)
{
    const std::size_t equals = assignment.find('=');
    const std::string pointer = assignment.substr(0, equals);
    const auto keys = split(pointer);
    if (equals != std::string::npos && !pointer.empty() && pointer.front() != '/') {
        problems.add("/" + pointer, "--set " + quoted(assignment) + " must begin with / (write /" + assignment + ")");
        return;
    }
    if (equals == std::string::npos || !keys || keys->empty()) {
        problems.add(pointer, "--set " + quoted(assignment) + " is no assignment (write /pointer/to/key=value)");
        return;
    }
    Json* place = &document;
    std::string path;
    for (const std::string& key : *keys) {
        const std::string parent = path.empty() ? "/" : path;
        path = join(path, key);
        if (place->kind == Json::Kind::object) {
            place = member(*place, key);
        } else if (place->kind == Json::Kind::array) {
            const std::size_t size = place->items.size();
            place = element(*place, key);
            if (place == nullptr) {
                problems.add(path, "--set: no such element, " + parent + " has " +
                                       (size == 0 ? "none" : "0 to " + std::to_string(size - 1)) + " (write " +
                                       join(parent, "-") + " to add one)");
                return;
            }
        } else {
            problems.add(path, "--set: " + parent + " is " + describe(*place) + ", which has no parts");
            return;
        }
    }
    *place = value_of(assignment.substr(equals + 1));
}

}  // namespace carom::io
