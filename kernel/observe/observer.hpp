// SPDX-License-Identifier: GPL-3.0-or-later
// The observe stage: one row of named measures per step, and what someone at the microscope can see.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/profile.hpp"
#include "flow/percept.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {

/// Tissues that the scene names: measures of others do not exist.
struct ObservedTissues {
    bool lens = false;
    bool bag = false;
    bool iris = false;
    bool cornea = false;
};

class Observer {
public:
    /// The lens is solid 0, the bag is bag 0 and the implant is shell 0 of the world; the membrane named
    /// "anterior_capsule" is what a rhexis is torn in, the one named "bag" what an implant is put into. dt: step [s].
    Observer(const WorldModel& world, const ObservedTissues& tissues, double dt);

    [[nodiscard]] const ObservationSchema& schema() const { return schema_; }
    /// Entries of the memory that `observe` carries from step to step; all 0 at the start.
    [[nodiscard]] std::size_t memory_size() const { return memory_size_; }

    /// Goes on with a model of the same tetrahedra that has more nodes.
    void follow(const WorldModel& world);

    /// Measures one step. The result depends on input and memory alone.
    void observe(const ObserveInput& input, std::vector<double>& memory, Observation& observation);

    /// What can be seen now, of the same step that was observed last.
    [[nodiscard]] Percept percept(const ObserveInput& input, const Observation& observation) const;

private:
    void look_at_lens(const ObserveInput& input);
    void look_at_implant(const ObserveInput& input);
    [[nodiscard]] LensView view() const;

    ObservedTissues tissues_;
    std::vector<std::unique_ptr<MeasureGroup>> groups_;
    std::vector<std::size_t> first_value_;
    ObservationSchema schema_;
    std::size_t memory_size_ = 0;

    // Scratch: follows from the state that is being observed.
    const SolidModel* lens_ = nullptr;
    ColumnGrid grid_;
    std::vector<double> volumes_;
    ColumnFill fill_;
    GrooveShape groove_;
    GrooveFinder groove_finder_;
    std::vector<GrooveShape> arms_;
    LensMotion motion_;
    std::vector<LensPiece> pieces_;
    Reflex reflex_;
    int anterior_capsule_ = -1;  ///< number of the membrane; -1: there is none
    RhexisGauge rhexis_;
    std::optional<ImplantGauge> implant_gauge_;
    ImplantPlace implant_;
    int soft_bag_ = -1;  ///< number of the membrane that is the bag; -1: there is none
    std::optional<BagGauge> bag_gauge_;
    BagPlace bag_place_;
};

}  // namespace rhexis
