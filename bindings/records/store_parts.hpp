// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "records/database.hpp"
#include "records/store.hpp"

namespace rhexis::records {

struct Store::Parts {
    std::string path;
    soci::session sql;
};

}  // namespace rhexis::records
