#include "core/patience.hpp"
#include "core/random.hpp"
#include "study/largest.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/law.hpp"
#include "tunnel/study.hpp"
#include "tunnel/tally.hpp"

#include <algorithm>
#include <cmath>

namespace carom::tunnel {

namespace {

/// Aims of a cell: a phase in (0, 1], and a place of the path uniform over the disc in which it meets a sphere.
std::vector<Aim> aims_of(const Matrix& matrix, const Cell& cell)
{
    Random random(matrix.seed, stream_of(cell));
    std::vector<Aim> aims(static_cast<std::size_t>(matrix.trials));
    for (Aim& aim : aims) {
        aim.phase = 1 - random.uniform();
        const double area = random.uniform();
        if (cell.target == Target::sphere) aim.offset = std::sqrt(area);
    }
    return aims;
}

void add_thick(const Matrix& matrix, Target target, std::optional<double> thickness, std::vector<Cell>& cells)
{
    for (const double radius : matrix.radius)
        for (const double dt : matrix.dt)
            for (const double speed : matrix.speed) cells.push_back({target, thickness, radius, dt, speed});
}

}  // namespace

std::vector<Cell> cells_of(const Matrix& matrix)
{
    std::vector<Cell> cells;
    for (const Target target : matrix.targets) {
        if (target == Target::wall) add_thick(matrix, target, {}, cells);
        for (const double thickness : matrix.thickness)
            if (target == Target::plate || (target == Target::sphere && thickness > 0))
                add_thick(matrix, target, thickness, cells);
    }
    return cells;
}

void run_matrix(const Matrix& matrix, const std::vector<Contestant>& contestants, Report& report,
                const OnProgress& on_progress)
{
    const std::vector<Cell> cells = cells_of(matrix);
    Patience patience(on_progress);
    patience.begin("tunnel", static_cast<double>(cells.size() * contestants.size()), "cells");
    std::size_t done = 0;
    for (const Contestant& who : contestants) {
        patience.name(who.method);
        for (const Cell& cell : cells) {
            if (!patience.lasts(static_cast<double>(done++))) break;
            CellThrows throws(cell);
            Tally tally(who, cell);
            for (const Aim& aim : aims_of(matrix, cell)) {
                if (!patience.lasts_for(1)) break;
                tally.add(aim, judge(who, throws.at(aim), cell.dt));
            }
            if (patience.ended()) break;
            tally.row.law = share_missed(who, cell);
            report.rows.push_back(std::move(tally.row));
        }
    }
    report.interrupted = report.interrupted || patience.ended();
}

Throw example_of(const Row& row)
{
    return row.example_throw ? *row.example_throw : CellThrows(row.cell).at(row.example);
}

bool Report::exact_hold() const
{
    const std::string& exact = method_names().front();
    return std::all_of(rows.begin(), rows.end(),
                       [&](const Row& row) { return row.method != exact || row.tunnelled + row.wrong == 0; });
}

}  // namespace carom::tunnel
