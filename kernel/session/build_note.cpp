// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/recording.hpp"

extern "C" char* openblas_get_corename();

namespace rhexis {

std::string build_note() { return std::string("rhexis ") + RHEXIS_VERSION + ", BLAS core " + openblas_get_corename(); }

}  // namespace rhexis
