// SPDX-License-Identifier: GPL-3.0-or-later
// Which process an attempt belongs to, told so that it is known later whether that is gone.
#pragma once

#include <string>

namespace rhexis::records {

/// Of this process: machine, boot, namespace, id and the moment it began.
std::string process_mark();

enum class Life { alive, gone, unknown };

/// Unknown: of another machine or container.
Life life_of(const std::string& mark);

}  // namespace rhexis::records
