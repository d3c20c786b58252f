// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/charts/models.hpp"

namespace rhexis::bench {

std::vector<Chart> charts() {
    return {chart_lens(),         chart_anterior_capsule(),
            chart_shell(),        chart_chamber(),
            chart_surge(),        chart_wounds(),
            chart_burn(),         chart_hydrodissection(),
            chart_cortex(),       chart_viscoelastic(),
            chart_vitreous(),     chart_cracking(),
            chart_zonules(),      chart_globe(),
            chart_iris(),         chart_posterior_capsule(),
            chart_suction_grip(), chart_piece_contact(),
            chart_implant_bag(),  chart_picture()};
}

}  // namespace rhexis::bench
