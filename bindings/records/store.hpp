// SPDX-License-Identifier: GPL-3.0-or-later
// The store of attempts: one SQLite file. Every function that writes is one transaction, on the disk when it returns.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "records/attempt.hpp"

namespace rhexis::records {

/// Which attempts are asked for; "" asks for all.
struct Wanted {
    std::string trainee;
    std::string exercise;
    std::string cohort;
    bool finished = false;  ///< without those that run or were interrupted
    bool details = false;   ///< with items, measures and events
};

class Store {
public:
    /// Makes the file if there is none.
    static Result<Store> open(const std::string& path);
    /// Fails if there is none.
    static Result<Store> open_existing(const std::string& path);
    ~Store();
    Store(Store&&) noexcept;
    Store& operator=(Store&&) noexcept;

    [[nodiscard]] const std::string& path() const;

    /// The trainee, with the cohort and arm that were named last.
    Result<Trainee> trainee(const std::string& pseudonym);
    Result<std::vector<Trainee>> trainees();

    /// An attempt that begins. A cohort or arm that is given is the trainee's from now on.
    Status begin(const Attempt& attempt);
    /// The same attempt at its end; stored as a whole, whether or not its begin was.
    Status finish(const Attempt& attempt);
    /// Takes back an attempt that never came to its first step.
    Status drop(const std::string& id);

    /// Oldest first.
    Result<std::vector<Attempt>> attempts(const Wanted& wanted);
    /// By its id or the beginning of it.
    Result<Attempt> attempt(const std::string& id);

    /// The trainee with all attempts and ratings of them, and as a rater; nothing of it is left in the file. Returns
    /// the folders of the runs.
    Result<std::vector<std::string>> remove(const std::string& pseudonym);

    /// All of them or none. Fails when the rater has rated one of the attempts already, unless replace.
    Status rate(const std::vector<Rating>& ratings, bool replace);
    /// In the order of attempts, then raters.
    Result<std::vector<Rating>> ratings();

    struct Parts;

private:
    explicit Store(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// RHEXIS_RECORDS, or rhexis/records.db in the user's data folder (XDG_DATA_HOME, or ~/.local/share); "": none of them
/// is known.
std::string default_store();

}  // namespace rhexis::records
