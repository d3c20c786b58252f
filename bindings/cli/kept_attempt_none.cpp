// SPDX-License-Identifier: GPL-3.0-or-later
// In a program that was built without records.
#include "cli/kept_attempt.hpp"

namespace rhexis::cli {

struct KeptAttempt::Parts {};

KeptAttempt::KeptAttempt(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
KeptAttempt::~KeptAttempt() = default;
KeptAttempt::KeptAttempt(KeptAttempt&&) noexcept = default;

Status check_keep_options(const KeepOptions& options) {
    if (options.trainee.empty() && options.cohort.empty() && options.arm.empty() && options.store.empty()) {
        return success();
    }
    return Error{"this program was built without records", "--trainee", "cmake -DRHEXIS_RECORDS=ON"};
}

std::string folder_name_of(const std::string& exercise, const std::string& trainee) { return exercise + "-" + trainee; }

Result<KeptAttempt> KeptAttempt::begin(const KeepOptions& /*options*/, const nlohmann::json& /*identity*/,
                                       const std::string& /*surgeon*/, std::uint64_t /*seed*/,
                                       const std::string& /*folder*/, bool /*resume*/) {
    return KeptAttempt(nullptr);
}

const nlohmann::json& KeptAttempt::comparison() const {
    static const nlohmann::json none = nlohmann::json::object();
    return none;
}

Status KeptAttempt::finish(const nlohmann::json& /*report*/) { return success(); }
void KeptAttempt::give_up() {}

}  // namespace rhexis::cli
