#include "io/json.hpp"

#include "io/limits.hpp"

namespace carom::io {

const Json* Json::find(std::string_view key) const
{
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] == key) return &items[i];
    return nullptr;
}

std::string join(const std::string& parent, std::string_view key)
{
    std::string pointer = parent + "/";
    for (const char c : key) {
        if (c == '~')
            pointer += "~0";
        else if (c == '/')
            pointer += "~1";
        else
            pointer += c;
    }
    return pointer;
}

std::string join(const std::string& parent, std::size_t index)
{
    return parent + "/" + std::to_string(index);
}

std::string describe(const Json& value)
{
    switch (value.kind) {
        case Json::Kind::null:
            return "null";
        case Json::Kind::boolean:
            return value.boolean ? "true" : "false";
        case Json::Kind::number:
            return "the number " + value.text;
        case Json::Kind::string:
            return "the string \"" + value.text.substr(0, longest_quoted) +
                   (value.text.size() > longest_quoted ? "...\"" : "\"");
        case Json::Kind::array:
            return "a list of " + std::to_string(value.items.size());
        case Json::Kind::object:
            return "an object";
    }
    return "?";
}

}  // namespace carom::io
