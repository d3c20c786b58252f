// SPDX-License-Identifier: GPL-3.0-or-later
// How far the lens has been turned, what turns it, and how much of the turn the bag and its zonules have to take.
#include <cmath>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// The axis about which the lens turns: of the bag, or of the eye where there is none.
struct Axis {
    Vec3 point = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();

    [[nodiscard]] double torque(const Vec3& at, const Vec3& force) const {
        return direction.dot((at - point).cross(force));
    }
};

/// Of all contacts of the lens with partners of one kind, about the axis [uN mm].
double torque_on_lens(const ContactSet& contacts, ContactPartner partner, const Axis& axis) {
    double sum = 0.0;
    for (const Contact& contact : contacts) {
        if (contact.solid == 0 && contact.partner == partner) {
            sum += axis.torque(contact.point, contact.force);
        }
    }
    return sum;
}

double zonule_torque(const BagModel& model, const BagState& state, const Axis& axis) {
    double sum = 0.0;
    const ZonuleShares shares(model, state);
    for (std::size_t i = 0; i < model.zonules.size(); ++i) {
        const ZonuleSpring& spring = model.zonules[i];
        sum += axis.torque(state.pose.to_world(spring.on_bag), shares.of(i) * zonule_force(spring, state.pose));
    }
    return sum;
}

/// About the view axis, -180 to 180.
double turn_of(const Pose& pose) {
    const Vec3 x = pose.orientation * Vec3::UnitX();
    return std::atan2(x.y(), x.x()) * degrees;
}

class TurnMeasures : public MeasureGroup {
public:
    explicit TurnMeasures(bool bag) : bag_(bag) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back({"lens.rotation_deg", "deg",
                          "How far it has been turned about the view axis, ccw positive; "
                          "whole turns add up."});
        schema.push_back({"lens.tool_torque_mNmm", "mN mm",
                          "Torque of the instruments on the lens about the bag's "
                          "axis, ccw positive."});
        if (bag_) {
            schema.push_back({"lens.bag_torque_mNmm", "mN mm", "Torque of the capsular bag on the lens, likewise."});
            schema.push_back({"bag.turn_deg", "deg", "How far the bag is turned about the view axis, ccw positive."});
            schema.push_back({"bag.slip_deg", "deg", "How far the lens has been turned in its bag."});
            schema.push_back({"zonules.torque_mNmm", "mN mm", "Torque of the zonules on the bag about its axis."});
        }
    }
    /// The turn so far, so that whole turns add up.
    [[nodiscard]] std::size_t memory_size() const override { return 1; }

    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override {
        const double angle = std::atan2(lens.motion->turn.y(), lens.motion->turn.x()) * degrees;
        memory[0] = angle + 360.0 * std::round((memory[0] - angle) / 360.0);
        Axis axis;
        if (bag_) {
            const Pose& pose = input.state.bags[0].pose;
            axis = {pose.position, pose.orientation * Vec3::UnitZ()};
        }
        values[0] = memory[0];
        values[1] = torque_on_lens(input.contacts, ContactPartner::tool, axis) * 1e-3;
        if (bag_) {
            const double bag_turn = turn_of(input.state.bags[0].pose);
            values[2] = torque_on_lens(input.contacts, ContactPartner::bag, axis) * 1e-3;
            values[3] = bag_turn;
            values[4] = memory[0] - bag_turn;
            values[5] = zonule_torque(input.world.bags[0], input.state.bags[0], axis) * 1e-3;
        }
    }

private:
    bool bag_;
};

}  // namespace

std::unique_ptr<MeasureGroup> turn_measures(bool bag) { return std::make_unique<TurnMeasures>(bag); }

}  // namespace rhexis
