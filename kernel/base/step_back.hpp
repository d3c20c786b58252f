// SPDX-License-Identifier: GPL-3.0-or-later
// Threads whose work may wait.
#pragma once

namespace rhexis {

/// This thread, and those that it begins from now on, run where nobody else wants to. On Linux; where it is refused all
/// share as they did.
void step_back();

}  // namespace rhexis
