// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt of a trainee on its way into the record store. Without a trainee nothing is kept, and every function here
// does nothing.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/result.hpp"

namespace rhexis::cli {

struct KeepOptions {
    std::string trainee;  ///< pseudonym; "": nothing is kept
    std::string cohort;
    std::string arm;
    std::string store;   ///< file; "": the user's own
    std::string root;    ///< folder with rubrics/ and courses/
    std::string course;  ///< whose closed lessons are told, or refused; "": none
    std::string input;   ///< device that a person operates with; "": none does
};

class KeptAttempt {
public:
    /// Stores that the attempt begins, and leaves attempt.json in its folder. identity: "id", "title", "version",
    /// "sha256" of the exercise. resume: an attempt that the folder holds already goes on. Fails on bad input and on a
    /// store that is no good; one that is locked is tried again at the end.
    static Result<KeptAttempt> begin(const KeepOptions& options, const nlohmann::json& identity,
                                     const std::string& surgeon, std::uint64_t seed, const std::string& folder,
                                     bool resume);
    ~KeptAttempt();
    KeptAttempt(KeptAttempt&&) noexcept;

    /// For the report: "attempt", its id, and "history" and "cohort" as far as the store has them.
    [[nodiscard]] const nlohmann::json& comparison() const;

    /// Stores the attempt. An error names the command that stores it later.
    Status finish(const nlohmann::json& report);
    /// The attempt never began, or broke off: forgotten, unless there is a recording of it.
    void give_up();

private:
    struct Parts;
    explicit KeptAttempt(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;  ///< none: nothing is kept
};

/// Fails on names that the store would refuse, and on a cohort or arm of nobody.
Status check_keep_options(const KeepOptions& options);

/// "groove-P07-20260301-093000", under which the runs of a trainee do not take each other's place.
std::string folder_name_of(const std::string& exercise, const std::string& trainee);

}  // namespace rhexis::cli
