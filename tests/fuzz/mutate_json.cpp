#include "fuzz/fuzz.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

namespace carom::fuzz {

namespace {

using nlohmann::ordered_json;

constexpr int deepest = 40;  // nlohmann writes recursively

void collect(ordered_json& node, std::vector<ordered_json*>& all)
{
    all.push_back(&node);
    if (node.is_structured())
        for (auto& child : node) collect(child, all);
}

class Mutation {
public:
    Mutation(ordered_json& root, Random& random, const std::vector<std::string_view>& words)
        : random_(random), words_(words)
    {
        collect(root, nodes_);
    }

    void apply()
    {
        switch (random_.below(8)) {
            case 0:
                drop();
                break;
            case 1:
                move();
                break;
            case 2:
                insert();
                break;
            case 3:
                replace();
                break;
            default:
                change_number();
        }
    }

private:
    ordered_json& any() { return *nodes_[random_.below(nodes_.size())]; }

    /// One for which `good` holds, if a few tries find it.
    template <class Good>
    ordered_json* find(const Good& good)
    {
        constexpr int tries = 50;
        for (int i = 0; i < tries; ++i)
            if (ordered_json& node = any(); good(node)) return &node;
        return nullptr;
    }

    void change_number()
    {
        ordered_json* node = find([](const ordered_json& each) { return each.is_number(); });
        if (node == nullptr) return;
        const double x = odd_number(random_, node->get<double>());
        constexpr double exact = 0x1p53;
        if (x == std::floor(x) && std::abs(x) < exact)
            *node = static_cast<std::int64_t>(x);
        else
            *node = x;
    }

    void drop()
    {
        ordered_json* node = find([](const ordered_json& each) { return each.is_structured() && !each.empty(); });
        if (node == nullptr) return;
        node->erase(std::next(node->begin(), static_cast<std::ptrdiff_t>(random_.below(node->size()))));
    }

    void move()
    {
        const ordered_json copy = any();
        any() = copy;
    }

    void insert()
    {
        ordered_json* node = find([](const ordered_json& each) { return each.is_structured(); });
        if (node == nullptr) return;
        const ordered_json copy = any();
        if (node->is_array())
            node->insert(std::next(node->begin(), static_cast<std::ptrdiff_t>(random_.below(node->size() + 1))), copy);
        else
            (*node)[word()] = copy;
    }

    void replace()
    {
        ordered_json& node = any();
        switch (random_.below(5)) {
            case 0:
                node = nullptr;
                break;
            case 1:
                node = random_.below(2) == 0;
                break;
            case 2:
                node = ordered_json::array({0, 0, 1});
                break;
            default:
                node = word();
        }
    }

    std::string word() { return std::string(words_[random_.below(words_.size())]); }

    Random& random_;
    const std::vector<std::string_view>& words_;
    std::vector<ordered_json*> nodes_;
};

}  // namespace

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned int seed,
                        const std::vector<std::string_view>& words)
{
    Random random(seed);
    if (random.below(6) == 0) return LLVMFuzzerMutate(data, size, most);
    bool shallow = true;
    const auto look = [&](int depth, ordered_json::parse_event_t, ordered_json&) {
        shallow = shallow && depth < deepest;
        return true;
    };
    const char* begin = reinterpret_cast<const char*>(data);
    ordered_json root = ordered_json::parse(begin, begin + size, look, false);
    if (root.is_discarded() || !shallow) return LLVMFuzzerMutate(data, size, most);
    for (std::size_t n = 1 + random.below(3); n > 0; --n) Mutation(root, random, words).apply();
    const std::string text = root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    if (text.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

}  // namespace carom::fuzz
