// SPDX-License-Identifier: GPL-3.0-or-later
// How far the capsular bag is displaced and how hard the zonules are pulled.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

struct ZonuleLoad {
    double load = 0.0;    ///< magnitude of the resultant [uN]
    double strain = 0.0;  ///< of the most stretched spring, relative to its length at rest
};

ZonuleLoad zonule_load(const BagModel& model, const BagState& state) {
    Vec3 sum = Vec3::Zero();
    ZonuleLoad result;
    const ZonuleShares shares(model, state);
    for (std::size_t i = 0; i < model.zonules.size(); ++i) {
        if (shares.of(i) > 0.0) {
            sum += shares.of(i) * zonule_force(model.zonules[i], state.pose);
            result.strain = std::max(result.strain, zonule_strain(model.zonules[i], state.pose));
        }
    }
    result.load = sum.norm();
    return result;
}

double tilt_deg(const Pose& pose) {
    const Vec3 axis = pose.orientation * Vec3::UnitZ();
    return std::atan2(std::hypot(axis.x(), axis.y()), axis.z()) * 180.0 / std::numbers::pi;
}

class BagMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"bag.displacement_mm", "mm", "How far the capsular bag is shifted."});
        schema.push_back({"bag.tilt_deg", "deg", "How far it is tilted."});
        schema.push_back({"zonules.load_mN", "mN", "Resulting pull of all zonules."});
        schema.push_back({"zonules.strain", "1", "Strain of the most stretched zonule."});
        schema.push_back({"zonules.peak_strain", "1", "Its greatest value so far."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const BagState& bag = input.state.bags[0];
        const ZonuleLoad zonules = zonule_load(input.world.bags[0], bag);
        memory[0] = std::max(memory[0], zonules.strain);
        values[0] = (bag.pose.position - bag.cushion_z * Vec3::UnitZ()).norm();
        values[1] = tilt_deg(bag.pose);
        values[2] = zonules.load * 1e-3;
        values[3] = zonules.strain;
        values[4] = memory[0];
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> bag_measures() { return std::make_unique<BagMeasures>(); }

}  // namespace rhexis
