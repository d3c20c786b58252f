// SPDX-License-Identifier: GPL-3.0-or-later
// The SQLite file behind the store, through SOCI. SOCI throws; what it throws becomes an Error in guarded().
#pragma once

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include <string>

#include "base/result.hpp"

namespace rhexis::records {

/// What a failed statement means for who uses the store. Starts with "locked" when it is worth trying again.
Error database_error(const std::string& path, const std::exception& thrown);

/// f() returns a Result; what it throws becomes an Error.
template <typename F>
auto guarded(const std::string& path, F f) -> decltype(f()) {
    try {
        return f();
    } catch (const std::exception& thrown) {
        return database_error(path, thrown);
    }
}

/// Takes the write lock at once, so that it is waited for here and not in the middle. Undone unless committed.
class Writing {
public:
    explicit Writing(soci::session& sql);
    ~Writing();
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
    void commit();

private:
    soci::session& sql_;
    bool open_ = true;
};

enum class Opening { existing, create };

/// Opens the file, and makes or checks its tables. Throws what SOCI throws; call it in guarded().
Status open_database(soci::session& sql, const std::string& path, Opening how);

}  // namespace rhexis::records
