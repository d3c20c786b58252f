// SPDX-License-Identifier: GPL-3.0-or-later
// One chart for each model, a file each: charts/chart_NAME.cpp.
#pragma once

#include "bench/chart.hpp"

namespace rhexis::bench {

Chart chart_lens();
Chart chart_anterior_capsule();
Chart chart_shell();
Chart chart_chamber();
Chart chart_surge();
Chart chart_wounds();
Chart chart_burn();
Chart chart_hydrodissection();
Chart chart_cortex();
Chart chart_viscoelastic();
Chart chart_vitreous();
Chart chart_cracking();
Chart chart_zonules();
Chart chart_globe();
Chart chart_iris();
Chart chart_posterior_capsule();
Chart chart_suction_grip();
Chart chart_piece_contact();
Chart chart_implant_bag();
Chart chart_picture();

}  // namespace rhexis::bench
