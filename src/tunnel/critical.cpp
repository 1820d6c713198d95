#include "core/patience.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/law.hpp"
#include "tunnel/study.hpp"
#include "tunnel/tolerances.hpp"

#include <algorithm>

namespace carom::tunnel {

namespace {

/// Whether a throw tunnels in one of so many equal parts of a step, one throw in the middle of each.
bool some_tunnel(const Contestant& who, const Cell& cell, double offset)
{
    CellThrows throws(cell);
    for (std::size_t k = 0; k < searched_phases; ++k) {  // contacts soon after the begin are those that are missed
        const double phase = searched_phase(k);
        if (judge(who, throws.at({phase, offset}), cell.dt).fate == Fate::tunnelled) return true;
    }
    return false;
}

}  // namespace

CriticalSpeed find_critical(const Contestant& who, Cell cell, double offset)
{
    return search_critical(chord_of(cell, offset) / cell.dt, [&](double speed) -> std::optional<bool> {
        cell.speed = speed;
        return some_tunnel(who, cell, offset);
    });
}

void find_criticals(const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
                    const OnProgress& on_progress)
{
    Matrix speedless = matrix;
    speedless.speed = {1};  // any: it is what is looked for
    std::erase(speedless.targets, Target::wall);
    const std::vector<Cell> cells = cells_of(speedless);
    const std::vector<double> central{0};
    Patience patience(on_progress);
    patience.begin("critical speeds", static_cast<double>(cells.size() * contestants.size()), "searches");
    std::size_t done = 0;
    for (const Contestant& who : contestants) {
        patience.name(who.method);
        for (const Cell& cell : cells) {
            for (const double offset : cell.target == Target::sphere ? matrix.offsets : central) {
                if (!patience.lasts(static_cast<double>(done))) break;
                report.criticals.push_back({.method = who.method,
                                            .variant = who.variant,
                                            .integrator = who.integrator,
                                            .cell = cell,
                                            .offset = offset,
                                            .speed = find_critical(who, cell, offset),
                                            .law = critical_speed(who, cell, offset)});
            }
            ++done;
        }
    }
    report.interrupted = report.interrupted || patience.ended();
}

}  // namespace carom::tunnel
