// SPDX-License-Identifier: GPL-3.0-or-later
// What the groups of measures have in common: what they may read, and how they say and write their numbers.
#pragma once

#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "flow/contact.hpp"
#include "flow/eye_model.hpp"
#include "flow/observation.hpp"
#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "observe/bag_place.hpp"
#include "observe/groove_arms.hpp"
#include "observe/implant_place.hpp"
#include "observe/lens_columns.hpp"
#include "observe/lens_motion.hpp"
#include "observe/lens_pieces.hpp"
#include "observe/reflex.hpp"
#include "observe/rim.hpp"

namespace rhexis {

inline constexpr double degrees = 180.0 / std::numbers::pi;  ///< of a radian
inline constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();

/// One step as the stages before observe left it.
struct ObserveInput {
    const EyeModel& eye;
    const WorldModel& world;
    const WorldState& state;
    std::span<const ToolState> tools;
    const ContactSet& contacts;
    double dt = 0.01;  ///< [s]
};

/// What groups need of the lens and its capsule, made once per step. Null pointers: the scene has no such tissue.
struct LensView {
    const SolidModel* model = nullptr;
    const ColumnGrid* grid = nullptr;
    const ColumnFill* fill = nullptr;
    const GrooveShape* groove = nullptr;
    const std::vector<GrooveShape>* arms = nullptr;  ///< see GrooveFinder
    const LensMotion* motion = nullptr;
    const std::vector<LensPiece>* pieces = nullptr;
    const Reflex* reflex = nullptr;
    const RhexisShape* rhexis = nullptr;    ///< of the membrane that is the anterior capsule; null: there is none
    const ImplantPlace* implant = nullptr;  ///< of shell 0; null: there is no implant
    const BagPlace* soft_bag = nullptr;     ///< of the membrane that is the bag; null: there is none
    const BagGauge* bag_gauge = nullptr;    ///< that measured it
};

class MeasureGroup {
public:
    virtual ~MeasureGroup() = default;
    /// Appends its entries to the schema, in the order in which measure writes them.
    virtual void describe(ObservationSchema& schema) const = 0;
    /// Doubles that it carries from step to step. They are state: snapshots keep them.
    [[nodiscard]] virtual std::size_t memory_size() const { return 0; }
    /// Writes one value per schema entry. memory has memory_size() entries, all 0 at the start.
    virtual void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                         std::span<double> values) const = 0;
};

/// What an instrument is measured against.
struct ToolSurroundings {
    bool lens = false;
    bool bag = false;
    bool cornea = false;
    bool chamber = false;
};
/// tool: index of the instrument in the scene.
std::unique_ptr<MeasureGroup> tool_measures(const ToolModel& model, int tool, const ToolSurroundings& around);
std::unique_ptr<MeasureGroup> tremor_measures(const std::string& instrument, int tool, double dt);
std::unique_ptr<MeasureGroup> lens_measures();
std::unique_ptr<MeasureGroup> groove_measures(bool bag);
std::unique_ptr<MeasureGroup> grooves_measures();
std::unique_ptr<MeasureGroup> turn_measures(bool bag);
std::unique_ptr<MeasureGroup> bag_measures();
/// moves: whether the scene has an iris that moves and can be captured.
std::unique_ptr<MeasureGroup> iris_measures(bool moves);
/// bag: whether the scene has one, whose wall pieces can fall behind.
std::unique_ptr<MeasureGroup> fragment_measures(bool bag);
std::unique_ptr<MeasureGroup> crack_measures();
std::unique_ptr<MeasureGroup> chamber_measures();
std::unique_ptr<MeasureGroup> capsule_measures();
std::unique_ptr<MeasureGroup> reflex_measures();
std::unique_ptr<MeasureGroup> viscoelastic_measures();
std::unique_ptr<MeasureGroup> vitreous_measures();
std::unique_ptr<MeasureGroup> globe_measures();
std::unique_ptr<MeasureGroup> prolapse_measures();
std::unique_ptr<MeasureGroup> wounds_measures();
std::unique_ptr<MeasureGroup> zonule_measures();
std::unique_ptr<MeasureGroup> hydrodissection_measures();
std::unique_ptr<MeasureGroup> cortex_measures();
std::unique_ptr<MeasureGroup> retained_viscoelastic_measures();
/// Of an aspirator.
std::unique_ptr<MeasureGroup> port_measures(const ToolModel& model, int tool);
std::unique_ptr<MeasureGroup> presence_measures();
/// tools: how many instruments the scene has.
std::unique_ptr<MeasureGroup> motion_measures(std::size_t tools);
std::unique_ptr<MeasureGroup> microscope_measures();
std::unique_ptr<MeasureGroup> lids_measures();
/// forceps: index of the instrument; -1: there is none.
std::unique_ptr<MeasureGroup> bead_measures(int forceps);
/// injector: index of the instrument that holds shell 0.
std::unique_ptr<MeasureGroup> injection_measures(int injector);
/// Of shell 0. injector: as before; bag: number of the membrane; -1: there is none.
std::unique_ptr<MeasureGroup> implant_measures(int injector, int bag, bool cornea);
/// membrane: number of the bag.
std::unique_ptr<MeasureGroup> soft_bag_measures(int membrane);
/// membrane: number of the anterior capsule.
std::unique_ptr<MeasureGroup> rhexis_measures(int membrane);
std::unique_ptr<MeasureGroup> capsule_tool_measures(const ToolModel& model, int tool, int membrane);

}  // namespace rhexis
