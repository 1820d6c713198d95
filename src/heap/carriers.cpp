#include "heap/carriers.hpp"

#include <algorithm>
#include <iterator>

namespace carom {

void Carriers::add(const Parts& parts)
{
    for (const auto& part : parts)
        if (std::find(parts_.begin(), parts_.end(), part) == parts_.end()) parts_.push_back(part);
}

std::optional<std::vector<ForceChange>> Carriers::bear(const std::vector<Load>& further,
                                                       const ContactsAtRest& contacts_of)
{
    std::vector<ForceChange> out;
    std::vector<const RestingPart*> done;
    for (const Load& load : further) {
        if (!contacts_of(load.body)) continue;  // fixed, or woken
        const RestingPart& part = part_of(load.body, contacts_of);
        if (std::find(done.begin(), done.end(), &part) != done.end()) continue;
        done.push_back(&part);
        auto forces = part.is_current(state_, contacts_of) ? part.bear(further, contacts_of) : std::nullopt;
        if (!forces) {
            overloaded_ = load.body;
            return {};
        }
        std::move(forces->begin(), forces->end(), std::back_inserter(out));
    }
    return out;
}

const RestingPart& Carriers::part_of(BodyId body, const ContactsAtRest& contacts_of)
{
    std::erase_if(parts_, [&](const auto& part) { return part->has(body) && !part->is_current(state_, contacts_of); });
    for (const auto& part : parts_)
        if (part->has(body)) return *part;
    parts_.push_back(std::make_shared<const RestingPart>(state_, moment_, body, contacts_of));
    return *parts_.back();
}

void set_forces(std::vector<ForceChange> changes, EventOutcome& out)
{
    for (ForceChange& change : changes) {
        std::erase_if(out.forces, [&](const ForceChange& f) { return f.body == change.body; });
        out.forces.push_back(std::move(change));
    }
}

}  // namespace carom
