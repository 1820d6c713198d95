#include "stepping/contact_order.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace carom;
using stepping::Contact;
using stepping::ContactArranger;

namespace {

std::vector<Contact> three()
{
    return {{-0.1, 0, 1, Vec3::UnitX()}, {-0.3, 0, 2, Vec3::UnitX()}, {-0.2, 1, 2, Vec3::UnitX()}};
}

int code(const std::vector<Contact>& contacts)
{
    int value = 0;
    for (const Contact& c : contacts) value = 10 * value + (c.a + c.b);  // 1, 2, 3 in index order
    return value;
}

}  // namespace

TEST_CASE("Contacts are visited by index, in reverse, or the deepest first", "[stepping]")
{
    auto contacts = three();
    ContactArranger(ContactOrder::index, 1).arrange(contacts);
    CHECK(code(contacts) == 123);
    contacts = three();
    ContactArranger(ContactOrder::reverse, 1).arrange(contacts);
    CHECK(code(contacts) == 321);
    contacts = three();
    ContactArranger(ContactOrder::deepest, 1).arrange(contacts);
    CHECK(code(contacts) == 231);
}

TEST_CASE("A random order is uniform, and the seed decides it", "[stepping]")
{
    std::map<int, int> seen;
    ContactArranger arranger(ContactOrder::random, 42), again(ContactOrder::random, 42),
        other(ContactOrder::random, 43);
    int same_as_other = 0;
    for (int k = 0; k < 6000; ++k) {
        auto first = three(), second = three(), third = three();
        arranger.arrange(first);
        again.arrange(second);
        other.arrange(third);
        ++seen[code(first)];
        REQUIRE(code(first) == code(second));
        same_as_other += code(first) == code(third);
    }
    REQUIRE(seen.size() == 6);
    for (const auto& [order, count] : seen) CHECK(std::abs(count - 1000) < 120);  // 4 sigma
    CHECK(same_as_other < 1200);
}

TEST_CASE("The random generator is SplitMix64", "[stepping]")
{
    // First outputs for seed 1234567, published with the reference code.
    ContactArranger arranger(ContactOrder::random, 1234567);
    CHECK(arranger.draw() == 6457827717110365317ULL);
    CHECK(arranger.draw() == 3203168211198807973ULL);
    CHECK(arranger.draw() == 9817491932198370423ULL);
}
