// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as text that a web page can hold (RFC 4648).
#pragma once

#include <string>
#include <string_view>

namespace rhexis {

std::string base64(std::string_view bytes);

}  // namespace rhexis
