#include "stepping/contact_solver.hpp"

#include "stepping/response.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::stepping {

int solve_contacts(Bodies& bodies, std::vector<ContactRow>& rows, int sweeps, Patience& patience, double scale)
{
    double largest = scale;  // lacking velocity met so far
    for (int sweep = 1; sweep <= sweeps; ++sweep) {
        double change = 0;
        for (ContactRow& row : rows) {
            const double lacking = row.least - normal_velocity(bodies, row.contact);
            const double mass = effective_mass(bodies, row.contact);
            const double impulse = std::max(0.0, row.impulse + mass * lacking);
            const double added = impulse - row.impulse;
            if (added == 0) continue;
            apply(bodies, row.contact, added * row.contact.normal);
            row.impulse = impulse;
            largest = std::max(largest, lacking);
            change = std::max(change, std::abs(added / mass));
        }
        if (change <= solved_contacts * largest || !patience.lasts_for(rows.size())) return sweep;
    }
    return sweeps;
}

}  // namespace carom::stepping
