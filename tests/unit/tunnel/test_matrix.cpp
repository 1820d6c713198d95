#include "tunnel/law.hpp"
#include "tunnel/peers.hpp"
#include "tunnel/study.hpp"
#include "unit/tunnel/binomial.hpp"
#include "unit/tunnel/dummies.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using namespace carom::tunnel;

namespace {

/// Numbers v dt / reach from 0.05 to 800.
Matrix small_matrix()
{
    Matrix matrix;
    matrix.thickness = {0, 0.02};
    matrix.radius = {0.01, 0.1};
    matrix.dt = {1.0 / 60, 1e-3};
    matrix.speed = {3, 11, 13, 100, 1000};
    return matrix;
}

Report thrown(const Matrix& matrix, const Contestant& who)
{
    Report report;
    run_matrix(matrix, {who}, report, {});
    return report;
}

/// Share missed of a look once a step, from geometry alone: the ball is seen where its centre is between the contact
/// and the middle of the target. Offsets in `parts` rings of equal area.
double share_by_counting(const Cell& cell)
{
    const double way = cell.speed * cell.dt, reach = cell.radius + cell.thickness.value_or(0) / 2;
    if (cell.target == Target::wall) return 0;
    if (cell.target == Target::plate) return way <= reach ? 0 : (way - reach) / way;
    constexpr int parts = 200'000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) {
        const double chord = reach * std::sqrt(1 - (k + 0.5) / parts);
        if (chord < way) sum += (way - chord) / way / parts;
    }
    return sum;
}

}  // namespace

TEST_CASE("velocity and approach-only pbd miss the share that geometry says, at plates, spheres and walls", "[tunnel]")
{
    for (const char* method : {"velocity", "pbd"}) {
        const Report report = thrown(small_matrix(), contestant(method));
        REQUIRE(report.rows.size() == 80);
        int low = 0;
        for (const Row& row : report.rows) {
            CAPTURE(method, row.cell.target, row.cell.number(), row.tunnelled);
            REQUIRE(row.trials == 1000);
            const double p = binomial_p(row.tunnelled, row.trials, share_by_counting(row.cell));
            CHECK(p >= 1e-6);
            low += p < 0.003;
            // A plate reflects whatever it answers; what is seen deep within a sphere has another normal.
            if (row.cell.target != Target::sphere) CHECK(row.wrong == 0);
        }
        CHECK(low <= 1);
    }
}

TEST_CASE("away from the critical speed a plate is missed never, or at a thousand chords a step nearly always",
          "[tunnel]")
{
    Matrix matrix = small_matrix();
    matrix.targets = {Target::plate};
    matrix.thickness = {0.02};
    matrix.radius = {0.1};
    matrix.dt = {0.01};
    matrix.speed = {0.99 * 11, 1000 * 11};  // (0.1 + 0.01) / 0.01 = 11
    const Report report = thrown(matrix, contestant("velocity"));
    CHECK(report.rows[0].tunnelled == 0);
    CHECK(report.rows[1].tunnelled >= 990);
}

TEST_CASE("the event method hits every time, to 1e-9 in time and velocity", "[tunnel]")
{
    const Report report = thrown(small_matrix(), contestant("event"));
    CHECK(report.exact_hold());
    std::int64_t throws = 0;
    for (const Row& row : report.rows) {
        CAPTURE(row.cell.target, row.cell.number());
        CHECK(row.tunnelled + row.wrong == 0);
        throws += row.trials;
    }
    CHECK(throws == 80'000);
}

TEST_CASE("a method that ignores contacts tunnels always, at a wall too", "[tunnel]")
{
    for (const Contestant& who : {blind(), liar()})
        for (const Row& row : thrown(small_matrix(), who).rows) {
            CAPTURE(row.method, row.cell.target, row.cell.number());
            // Whoever claims an answer is believed, unless he is behind a plate: then the velocity alone gives him
            // away.
            if (row.method == "blind" || row.cell.target == Target::plate)
                CHECK(row.tunnelled == row.trials);
            else
                CHECK(row.wrong == row.trials);
        }
}

TEST_CASE("the law of share_missed is that of counting", "[tunnel]")
{
    Contestant who = blind();
    who.chords_seen = 1;
    for (const Cell& cell : cells_of(small_matrix()))
        CHECK(share_missed(who, cell).value() == Approx(share_by_counting(cell)).margin(1e-7));
    who.chords_seen.reset();
    CHECK_FALSE(share_missed(who, {Target::plate, 0.1, 0.1, 1, 1}));
}

TEST_CASE("spheres have a size and walls no thickness", "[tunnel]")
{
    std::size_t plates = 0, spheres = 0, walls = 0;
    for (const Cell& cell : cells_of(small_matrix())) {
        plates += cell.target == Target::plate;
        spheres += cell.target == Target::sphere;
        walls += cell.target == Target::wall;
        CHECK(cell.thickness.has_value() == (cell.target != Target::wall));
        if (cell.target == Target::sphere) CHECK(*cell.thickness > 0);
    }
    CHECK(plates == 2 * 2 * 2 * 5);
    CHECK(spheres == 1 * 2 * 2 * 5);
    CHECK(walls == 2 * 2 * 5);
}

TEST_CASE("a cell has the same throws in every matrix, and other ones with another seed", "[tunnel]")
{
    const Report all = thrown(small_matrix(), contestant("velocity"));
    Matrix one;
    one.targets = {Target::sphere};
    one.thickness = {0.02};
    one.radius = {0.1};
    one.dt = {1.0 / 60};
    one.speed = {100};
    const Row alone = thrown(one, contestant("velocity")).rows.at(0);
    const auto same = [&](const Row& row) {
        return row.cell.target == Target::sphere && row.cell.radius == 0.1 && row.cell.dt == 1.0 / 60 &&
               row.cell.speed == 100;
    };
    const auto found = std::find_if(all.rows.begin(), all.rows.end(), same);
    REQUIRE(found != all.rows.end());
    CHECK(found->tunnelled == alone.tunnelled);
    CHECK(found->worst_error == alone.worst_error);
    CHECK(found->example.phase == alone.example.phase);
    one.seed = 2;
    CHECK(thrown(one, contestant("velocity")).rows.at(0).example.phase != alone.example.phase);
}

TEST_CASE("the example of a row tunnels if one does", "[tunnel]")
{
    Matrix matrix = small_matrix();
    matrix.speed = {13};
    for (const Row& row : thrown(matrix, contestant("velocity")).rows) {
        CellThrows throws(row.cell);
        const Flown flown = contestant("velocity").fly(throws.at(row.example), row.cell.dt, 3);
        CHECK(flown.answered.has_value() == (row.tunnelled == 0));
    }
}

TEST_CASE("who says stop gets the rows that were finished", "[tunnel]")
{
    Report report;
    int asked = 0;
    run_matrix(small_matrix(), {contestant("velocity")}, report, [&](const Progress&) { return ++asked < 10; });
    CHECK(report.interrupted);
    CHECK(report.rows.size() < 80);
    for (const Row& row : report.rows) CHECK(row.trials == 1000);
}

TEST_CASE("FCL's defaults miss what nine parts of a step do not see, advancement and libccd miss nothing", "[tunnel]")
{
    std::vector<Contestant> libraries = fcl_peers().contestants;
    for (const Contestant& who : libccd_peers().contestants) libraries.push_back(who);
    Matrix matrix = small_matrix();
    matrix.targets = {Target::plate, Target::sphere};
    matrix.thickness = {0.02};
    matrix.trials = 300;
    for (const Contestant& who : libraries)
        for (const Row& row : thrown(matrix, who).rows) {
            CAPTURE(row.method, row.variant, row.cell.target, row.cell.number());
            Cell finer = row.cell;  // ten poses are nine parts, and both sides of the middle show an overlap
            finer.dt /= 18;
            if (who.method == "fcl_naive")
                CHECK(binomial_p(row.tunnelled, row.trials, share_by_counting(finer)) >= 1e-6);
            else
                CHECK(row.tunnelled == 0);
        }
    for (const Peers& peers : {fcl_peers(), libccd_peers()}) CHECK(peers.contestants.empty() == !peers.absent.empty());
}
