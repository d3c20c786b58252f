// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/iris.hpp"

namespace rhexis {

IrisState rest_state(const IrisModel& model) {
    IrisState state;
    state.z = model.rest_z;
    state.pupil_radius = model.pupil_radius;
    return state;
}

}  // namespace rhexis
