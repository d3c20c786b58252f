// SPDX-License-Identifier: GPL-3.0-or-later
// A folder that one process writes its results into.
#pragma once

#include <string>
#include <utility>

#include "base/result.hpp"

namespace rhexis {

/// Held as long as it lives, by this process and those that it forks. It is the system's lock on the folder itself: no
/// file is left behind, and it ends with a process that is killed. Where the file system knows no locks nothing is held
/// and nothing refused.
class FolderLock {
public:
    /// Makes the folder and its parents where they are missing; one that is still empty in the end goes again. Fails at
    /// once if another holds it, with its process number where the system tells it.
    static Result<FolderLock> take(const std::string& folder);
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&&) = delete;
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    FolderLock(int descriptor, std::string made) : descriptor_(descriptor), made_(std::move(made)) {}

    int descriptor_;
    std::string made_;  ///< the folder, if there was none before
};

}  // namespace rhexis
