// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.hpp"
#include "flow/frame.hpp"

namespace rhexis {

/// The file appears under its name only when it is whole. Fails if the path cannot be written or the disk is full; what
/// was there under that name then stays as it was.
Status write_png(const Image& image, const std::string& path);

}  // namespace rhexis
