#include <carom/error.hpp>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "io/json.hpp"
#include "io/limits.hpp"
#include "io/syntax_error.hpp"

namespace carom::io {

namespace {

/// Builds the tree from the parser's calls.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(std::string_view text, const std::string& file, Patience& patience)
        : text_(text), file_(file), patience_(patience)
    {
    }

    Json root;
    std::vector<std::string> problems;

    bool null() override { return add({}); }
    bool boolean(bool value) override
    {
        Json json;
        json.kind = Json::Kind::boolean;
        json.boolean = value;
        return add(std::move(json));
    }
    bool number_integer(number_integer_t value) override
    {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_unsigned(number_unsigned_t value) override
    {
        return number(static_cast<double>(value), std::to_string(value));
    }
    bool number_float(number_float_t value, const string_t& digits) override { return number(value, digits); }
    bool string(string_t& value) override
    {
        Json json;
        json.kind = Json::Kind::string;
        json.text = std::move(value);
        return add(std::move(json));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Kind::object); }
    bool start_array(std::size_t) override { return open(Json::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override
    {
        if (!open_.back().known.insert(value).second)
            problems.push_back(file_ + ": " + join(pointer(), value) + ": duplicate key (remove one of the two)");
        open_.back().json.keys.push_back(std::move(value));
        return true;
    }

    bool parse_error(std::size_t read, const std::string&, const nlohmann::detail::exception& error) override
    {
        constexpr int number_too_large = 406;
        const std::string pointer = error.id == number_too_large ? next_pointer() : "";
        problems.push_back(syntax_error(text_, file_, read, error.what(), pointer));
        return false;
    }

private:
    struct Open {
        Json json;
        std::unordered_set<std::string> known;  ///< keys so far
    };

    bool number(double value, const std::string& digits)
    {
        Json json;
        json.kind = Json::Kind::number;
        json.number = value;
        json.text = digits;
        return add(std::move(json));
    }
    bool add(Json json)
    {
        if (open_.empty())
            root = std::move(json);
        else
            open_.back().json.items.push_back(std::move(json));
        return patience_.lasts_for(1);
    }
    bool open(Json::Kind kind)
    {
        if (open_.size() >= deepest_json) {
            problems.push_back(file_ + ": nested deeper than " + std::to_string(deepest_json) +
                               " levels (no scene is)");
            return false;
        }
        open_.emplace_back();
        open_.back().json.kind = kind;
        return true;
    }
    bool close()
    {
        Json done = std::move(open_.back().json);
        open_.pop_back();
        return add(std::move(done));
    }

    /// Pointer to the container that is being read.
    std::string pointer() const
    {
        std::string path;
        for (std::size_t level = 0; level + 1 < open_.size(); ++level) path = step(path, open_[level].json);
        return path;
    }
    /// Pointer to the value that comes next.
    std::string next_pointer() const { return open_.empty() ? "/" : step(pointer(), open_.back().json); }
    static std::string step(const std::string& path, const Json& container)
    {
        return container.kind == Json::Kind::object ? join(path, container.keys.back())
                                                    : join(path, container.items.size());
    }

    std::string_view text_;
    const std::string& file_;
    Patience& patience_;
    std::vector<Open> open_;
};

}  // namespace

Json parse_json(std::string_view text, const std::string& file)
{
    Patience endless;
    return parse_json(text, file, endless);
}

Json parse_json(std::string_view text, const std::string& file, Patience& patience)
{
    refuse_what_is_no_text(text, file);
    TreeBuilder builder(text, file, patience);
    const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    if (patience.ended()) throw Stopped();
    if (!builder.problems.empty()) throw InputError(std::move(builder.problems));
    if (!complete) throw InputError({file + ": is no JSON text"});
    return std::move(builder.root);
}

}  // namespace carom::io
