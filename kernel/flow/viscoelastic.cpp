// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/viscoelastic.hpp"

#include <algorithm>

namespace rhexis {

double viscoelastic_pressure(const ViscoelasticModel& model, const ViscoelasticState& state) {
    return model.vitreous_pressure * std::min(1.0, state.fill) +
           model.overfill_pressure * std::max(0.0, state.fill - 1.0);
}

}  // namespace rhexis
