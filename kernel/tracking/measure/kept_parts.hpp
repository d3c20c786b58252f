// SPDX-License-Identifier: GPL-3.0-or-later
// What parts of a measurement gave, kept in a folder: a long one goes on where it was cut.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/folder_lock.hpp"
#include "base/result.hpp"

namespace rhexis::tracking {

/// Rows of numbers by name; those of several seeds are one after another.
using Numbers = std::map<std::string, std::vector<double>>;

void append(const Numbers& from, Numbers& to);

/// A row that may not be there is empty.
const std::vector<double>& row_of(const Numbers& numbers, const std::string& name);

class KeptParts {
public:
    /// Keeps nothing.
    KeptParts() = default;
    /// The error is that of a folder that cannot be written, or that another process writes to.
    static Result<KeptParts> open(const std::string& folder);

    /// None: it was not kept. `plan`: how it was to be measured; the error names the file, if that was another way or
    /// if it holds something else.
    [[nodiscard]] Result<std::optional<Numbers>> read(std::uint64_t seed, const std::string& part,
                                                      const std::string& plan) const;
    /// A file of its own for each seed and part: SEED-PART.json, to six digits. All numbers are finite.
    [[nodiscard]] Status write(std::uint64_t seed, const std::string& part, const std::string& plan,
                               const Numbers& numbers) const;

private:
    [[nodiscard]] std::string path_of(std::uint64_t seed, const std::string& part) const;

    std::string folder_{};
    std::unique_ptr<FolderLock> lock_{};
};

}  // namespace rhexis::tracking
