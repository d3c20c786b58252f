// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/observer.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "observe/field.hpp"
#include "observe/implant_marks.hpp"
#include "observe/rhexis_marks.hpp"
#include "observe/seen.hpp"

namespace rhexis {
namespace {

constexpr double column_spacing = 0.2;  // [mm], a fifth of the phaco tip's width

/// Number of the membrane, or -1.
int membrane_named(const WorldModel& world, const char* name) {
    const auto found = std::find_if(world.membranes.begin(), world.membranes.end(),
                                    [&](const MembraneModel& membrane) { return membrane.name == name; });
    return found == world.membranes.end() ? -1 : static_cast<int>(found - world.membranes.begin());
}

int anterior_capsule(const WorldModel& world) { return membrane_named(world, anterior_capsule_name); }

/// Number of the first instrument of a kind, or -1.
int first_of(const WorldModel& world, ToolKind kind) {
    const auto found =
        std::find_if(world.tools.begin(), world.tools.end(), [&](const ToolModel& tool) { return tool.kind == kind; });
    return found == world.tools.end() ? -1 : static_cast<int>(found - world.tools.begin());
}

bool has_contents(const WorldModel& world) { return world.hydrodissection || world.cortex || world.retained; }

void add_bag_contents(const WorldModel& world, std::vector<std::unique_ptr<MeasureGroup>>& groups) {
    if (world.hydrodissection) {
        groups.push_back(hydrodissection_measures());
    }
    if (world.cortex) {
        groups.push_back(cortex_measures());
    }
    if (world.retained) {
        groups.push_back(retained_viscoelastic_measures());
    }
}

/// Of the instrument that holds the implant.
int injector(const WorldModel& world) { return first_of(world, ToolKind::injector); }

std::vector<std::unique_ptr<MeasureGroup>> make_groups(const WorldModel& world, const ObservedTissues& tissues,
                                                       double dt) {
    std::vector<std::unique_ptr<MeasureGroup>> groups;
    for (int i = 0; i < static_cast<int>(world.tools.size()); ++i) {
        groups.push_back(
            tool_measures(world.tools[i], i, {tissues.lens, tissues.bag, tissues.cornea, world.chamber.has_value()}));
        groups.push_back(tremor_measures(world.tools[i].name, i, dt));
        if (anterior_capsule(world) >= 0) {
            groups.push_back(capsule_tool_measures(world.tools[i], i, anterior_capsule(world)));
        }
        if (world.tools[i].kind == ToolKind::aspirator) {
            groups.push_back(port_measures(world.tools[i], i));
        }
        if (world.tools[i].kind == ToolKind::injector && !world.shells.empty()) {
            groups.push_back(injection_measures(i));
        }
    }
    if (!world.tools.empty()) {
        groups.push_back(motion_measures(world.tools.size()));
    }
    if (tissues.lens) {
        groups.push_back(lens_measures());
        groups.push_back(groove_measures(tissues.bag));
        groups.push_back(grooves_measures());
        groups.push_back(turn_measures(tissues.bag));
        groups.push_back(reflex_measures());
        if (world.chamber) {
            groups.push_back(fragment_measures(tissues.bag));
            groups.push_back(crack_measures());
        }
    }
    if (tissues.bag) {
        groups.push_back(bag_measures());
    }
    if (world.implant) {
        groups.push_back(implant_measures(injector(world), membrane_named(world, empty_bag_name), tissues.cornea));
    }
    if (membrane_named(world, empty_bag_name) >= 0) {
        groups.push_back(soft_bag_measures(membrane_named(world, empty_bag_name)));
    }
    if (tissues.iris) {
        groups.push_back(iris_measures(world.iris.has_value()));
    }
    if (world.chamber) {
        groups.push_back(chamber_measures());
    }
    if (world.capsule) {
        groups.push_back(capsule_measures());
    }
    if (world.vitreous) {
        groups.push_back(vitreous_measures());
    }
    if (world.globe) {
        groups.push_back(globe_measures());
    }
    if (world.prolapse) {
        groups.push_back(prolapse_measures());
    }
    if (world.wounds) {
        groups.push_back(wounds_measures());
    }
    if (!world.bags.empty() && world.bags[0].breakable) {
        groups.push_back(zonule_measures());
    }
    add_bag_contents(world, groups);
    if (anterior_capsule(world) >= 0 || world.microscope || world.implant || world.vitreous || world.globe ||
        world.wounds || has_contents(world)) {
        groups.push_back(presence_measures());
    }
    if (anterior_capsule(world) >= 0) {
        groups.push_back(rhexis_measures(anterior_capsule(world)));
    }
    if (world.viscoelastic) {
        groups.push_back(viscoelastic_measures());
    }
    if (world.microscope) {
        groups.push_back(microscope_measures());
    }
    if (world.lids) {
        groups.push_back(lids_measures());
    }
    if (world.beads) {
        groups.push_back(bead_measures(first_of(world, ToolKind::forceps)));
    }
    return groups;
}

/// A bag that is a membrane has measures of its own.
ObservedTissues with_rigid_bag_only(ObservedTissues tissues, const WorldModel& world) {
    tissues.bag = tissues.bag && !world.bags.empty();
    return tissues;
}

}  // namespace

Observer::Observer(const WorldModel& world, const ObservedTissues& tissues, double dt)
    : tissues_(with_rigid_bag_only(tissues, world)),
      groups_(make_groups(world, tissues_, dt)),
      anterior_capsule_(anterior_capsule(world)),
      soft_bag_(membrane_named(world, empty_bag_name)) {
    if (world.implant) {
        implant_gauge_.emplace(world.shells[0], *world.implant);
    }
    if (soft_bag_ >= 0) {
        bag_gauge_.emplace(world.membranes[at(soft_bag_)]);
    }
    for (const std::unique_ptr<MeasureGroup>& group : groups_) {
        first_value_.push_back(schema_.size());
        group->describe(schema_);
        memory_size_ += group->memory_size();
    }
    first_value_.push_back(schema_.size());
    if (tissues.lens) {
        lens_ = &world.solids[0];
        grid_ = make_columns(*lens_, column_spacing);
        volumes_ = coarse_volumes(*lens_);
    }
}

void Observer::follow(const WorldModel& world) {
    if (lens_ != nullptr) {
        lens_ = &world.solids[0];
    }
}

LensView Observer::view() const {
    LensView view;
    if (lens_ != nullptr) {
        view = {lens_, &grid_, &fill_, &groove_, &arms_, &motion_, &pieces_, &reflex_};
    }
    view.rhexis = anterior_capsule_ >= 0 ? &rhexis_.shape() : nullptr;
    view.implant = implant_gauge_ ? &implant_ : nullptr;
    view.soft_bag = bag_gauge_ ? &bag_place_ : nullptr;
    view.bag_gauge = bag_gauge_ ? &*bag_gauge_ : nullptr;
    return view;
}

void Observer::look_at_lens(const ObserveInput& input) {
    const SolidState& state = input.state.solids[0];
    if (update_columns(*lens_, grid_, state.fraction, fill_)) {
        groove_ = groove_shape(grid_, fill_);
        arms_ = groove_finder_.find(grid_, fill_);
    }
    motion_ = lens_motion(*lens_, volumes_, state);
    if (input.world.chamber) {
        pieces_ = lens_pieces(*lens_, volumes_, state);
    }
    reflex_ = reflex_of(grid_, fill_, motion_, input.eye.anatomy.pupil_radius);
}

void Observer::look_at_implant(const ObserveInput& input) {
    if (implant_gauge_) {
        implant_ = implant_gauge_->measure(input.state.shells[0]);
    }
    if (bag_gauge_) {
        bag_place_ = bag_gauge_->measure(input.state.membranes[at(soft_bag_)]);
    }
}

void Observer::observe(const ObserveInput& input, std::vector<double>& memory, Observation& observation) {
    if (lens_ != nullptr) {
        look_at_lens(input);
    }
    if (anterior_capsule_ >= 0) {
        rhexis_.measure(input.world.membranes[anterior_capsule_], input.state.membranes[anterior_capsule_]);
    }
    look_at_implant(input);
    memory.resize(memory_size_, 0.0);
    observation.time_s = input.state.time_s;
    observation.values.assign(schema_.size(), 0.0);
    const LensView lens = view();
    std::size_t used = 0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        const std::span<double> values(observation.values);
        const std::span<double> kept(memory);
        groups_[i]->measure(input, lens, kept.subspan(used, groups_[i]->memory_size()),
                            values.subspan(first_value_[i], first_value_[i + 1] - first_value_[i]));
        used += groups_[i]->memory_size();
    }
}

Percept Observer::percept(const ObserveInput& input, const Observation& observation) const {
    Percept percept = seen(input, view(), tissues_.iris);
    if (anterior_capsule_ >= 0) {
        add_rhexis_landmarks(input, rhexis_.shape(), anterior_capsule_, percept.landmarks);
    }
    if (implant_gauge_) {
        add_implant_landmarks(input, implant_, view().soft_bag, percept.landmarks);
    }
    const auto share = std::find_if(schema_.begin(), schema_.end(),
                                    [](const MeasureInfo& measure) { return measure.name == "crack.bridge_share"; });
    if (share != schema_.end() && !observation.values.empty()) {
        const double* const value = &observation.values[static_cast<std::size_t>(share - schema_.begin())];
        add_bridge_landmark(value[0], Vec3(value[1], value[2], value[3]), input.eye.anatomy, percept);
    }
    if (input.state.globe) {
        put_into_room(*input.world.globe, *input.state.globe, percept);
    }
    if (input.world.microscope) {
        look_through(*input.world.microscope, *input.state.microscope, input.eye.anatomy, pupil_middle(input), percept);
    }
    return percept;
}

}  // namespace rhexis
