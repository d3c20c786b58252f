// SPDX-License-Identifier: GPL-3.0-or-later
// Time for profiles and benchmarks only: nothing that is hashed or recorded may depend on it.
#pragma once

namespace rhexis {

double wall_seconds();         ///< monotonic wall clock [s]
double thread_cpu_seconds();   ///< CPU time of the calling thread [s]
double process_cpu_seconds();  ///< CPU time of all threads of this process [s]

}  // namespace rhexis
