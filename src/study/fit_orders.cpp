#include "study/fit_orders.hpp"

#include "scene/tolerances.hpp"
#include "study/convergence.hpp"
#include "study/row_family.hpp"
#include "study/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace carom::study {

double exact_error(const Scene& scene, double reference_bound)
{
    return std::max(reference_bound, declared_contact * smallest_radius(scene));
}

std::vector<Convergence> fit_orders(const Scene& scene, const Comparison& comparison)
{
    const double exact = exact_error(scene, comparison.reference.bound);
    std::vector<Convergence> all;
    std::map<Family, std::vector<StepError>> families;
    for (const CompareRow& row : comparison.rows)
        if (row.dt && row.position_max && std::isfinite(*row.position_max) && *row.position_max > exact)
            families[family_of(row)].push_back({*row.dt, *row.position_max});
    for (const CompareRow& row : comparison.rows) {  // in the order of the rows
        const auto family = families.find(family_of(row));
        if (family == families.end()) continue;
        std::vector<StepError> points = std::move(family->second);
        families.erase(family);
        std::sort(points.begin(), points.end(), [](const StepError& a, const StepError& b) { return a.dt > b.dt; });
        const std::optional<FittedOrder> fit = fitted_order(points);
        if (!fit) continue;
        all.push_back({row.method, variant_text(row), fit->order, fit->uncertainty, fit->steps,
                       is_stalled(points, exact), points.back().error});
    }
    return all;
}

}  // namespace carom::study
