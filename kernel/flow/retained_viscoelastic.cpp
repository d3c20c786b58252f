// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/retained_viscoelastic.hpp"

namespace rhexis {

RetainedViscoelasticState rest_state(const RetainedViscoelasticModel& model) {
    RetainedViscoelasticState state;
    state.front = model.start_front;
    state.behind = model.start_behind;
    state.angle = model.start_angle;
    return state;
}

double viscoelastic_left(const RetainedViscoelasticState& state) { return state.front + state.behind + state.angle; }

double viscoelastic_at_start(const RetainedViscoelasticModel& model) {
    return model.start_front + model.start_behind + model.start_angle;
}

}  // namespace rhexis
