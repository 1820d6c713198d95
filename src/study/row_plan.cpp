#include "study/row_plan.hpp"

#include "study/words.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <type_traits>

namespace carom::study {

namespace {

/// Settings by which two runs of one method differ.
auto key_of(const RowPlan& plan)
{
    const StepOptions* step = step_options(plan.method);
    const StepOptions none;
    const StepOptions& s = step != nullptr ? *step : none;
    return std::tuple(plan.method.index(), plan.impact, s.dt, s.substeps, s.passes, s.order, s.integrator);
}

bool is_new(const std::vector<RowPlan>& rows, const RowPlan& plan)
{
    return std::none_of(rows.begin(), rows.end(), [&](const RowPlan& each) { return key_of(each) == key_of(plan); });
}

void add(std::vector<RowPlan>& rows, const RowPlan& plan)
{
    if (is_new(rows, plan)) rows.push_back(plan);
}

/// Options that a discrete method reads. What it does not read would make the same run again.
struct OptionsRead {
    bool passes = false, order = false;
    std::span<const ContactOrder> more_orders{};

    bool knows(ContactOrder asked) const
    {
        if (asked != ContactOrder::jacobi && asked != ContactOrder::shock) return order;
        return std::find(more_orders.begin(), more_orders.end(), asked) != more_orders.end();
    }
};

OptionsRead options_read(const Method& method)
{
    return std::visit(
        [](const auto& each) -> OptionsRead {
            using Each = std::decay_t<decltype(each)>;
            if constexpr (std::is_base_of_v<StepOptions, Each>)
                return {Each::reads_passes, Each::reads_order, Each::more_orders};
            else
                return {};
        },
        method);
}

/// The method of that name with the options that only it has.
Method method_of(const CompareOptions& options, const std::string& name, const StepOptions& step)
{
    Method method = make_method(name, step);
    if (auto* penalty = std::get_if<Penalty>(&method)) penalty->stiffness = options.stiffness;
    if (auto* soft = std::get_if<Soft>(&method)) {
        soft->hertz = options.hertz;
        soft->damping_ratio = options.damping_ratio;
    }
    return method;
}

/// Every combination of the lists for one method; what it does not read is as built in.
void add_steps(std::vector<RowPlan>& rows, const Scene& scene, const CompareOptions& options, const std::string& method)
{
    const OptionsRead reads = options_read(make_method(method, options.step));
    const bool curves = scene.gravity != Vec3::Zero() || scene.drag > 0;  // else all integrators fly alike
    for (const double dt : options.dt)
        for (const Integrator integrator : options.integrators)
            for (const ContactOrder order : options.orders)
                for (const int substeps : options.substeps)
                    for (const int passes : options.passes) {
                        StepOptions step = options.step;
                        step.dt = dt;
                        step.substeps = substeps;
                        step.passes = reads.passes ? passes : 1;
                        step.order = reads.knows(order) ? order : ContactOrder::index;
                        step.integrator = curves ? integrator : Integrator::euler;
                        add(rows, {method_of(options, method, step), std::nullopt});
                    }
}

}  // namespace

std::vector<RowPlan> rows_to_run(const Scene& scene, const CompareOptions& options)
{
    std::vector<RowPlan> rows;
    for (const std::string& method : options.methods) {
        const Method first = make_method(method, options.step);
        if (step_options(first) != nullptr) {
            add_steps(rows, scene, options, method);
            continue;
        }
        for (const ImpactOperator impact :
             options.impacts.value_or(std::vector<ImpactOperator>{scene.impact.impact_operator}))
            add(rows, {first, impact});
    }
    return rows;
}

std::string label(const Method& method)
{
    std::string text(name(method));
    if (const StepOptions* step = step_options(method)) text += " dt " + step_text(step->dt);
    return text;
}

double longest_step(const std::vector<RowPlan>& rows)
{
    double longest = 0;
    for (const RowPlan& row : rows)
        if (const StepOptions* step = step_options(row.method)) longest = std::max(longest, step->dt);
    return longest;
}

void describe(const RowPlan& plan, CompareRow& row)
{
    row.method = std::string(name(plan.method));
    row.impact = plan.impact;
    const StepOptions* step = step_options(plan.method);
    if (step == nullptr) return;
    const OptionsRead reads = options_read(plan.method);
    row.dt = step->dt;
    row.substeps = step->substeps;
    if (reads.passes) row.passes = step->passes;
    if (reads.order) row.order = step->order;
    row.integrator = step->integrator;
    if (const auto* penalty = std::get_if<Penalty>(&plan.method)) row.stiffness = penalty->stiffness;
    if (const auto* soft = std::get_if<Soft>(&plan.method)) {
        row.hertz = soft->hertz;
        row.damping_ratio = soft->damping_ratio;
    }
}

}  // namespace carom::study
