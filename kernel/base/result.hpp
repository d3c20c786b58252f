// SPDX-License-Identifier: GPL-3.0-or-later
// Errors at the edges (files, devices, scripts): what was wrong, where, and what is allowed.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/assert.hpp"

namespace rhexis {

/// One clear line for the person who can fix it.
struct Error {
    std::string what;                 ///< what was wrong, with the offending value
    std::string where;                ///< file:line, field name, or empty
    std::string allowed;              ///< what is allowed instead, or empty
    std::vector<std::string> more{};  ///< what else was wrong there, each a line as of text()

    /// "where: what (allowed)" on a single line; how much more there is, is told after it.
    [[nodiscard]] std::string text() const;
    /// Each of what was wrong on a line of its own.
    [[nodiscard]] std::vector<std::string> lines() const;
};

/// A value or an Error. Used where input comes from outside; our own bugs are asserted instead.
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    [[nodiscard]] bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }

    [[nodiscard]] T& value() & {
        RHEXIS_ASSERT(ok());
        return std::get<T>(content_);
    }
    [[nodiscard]] const T& value() const& {
        RHEXIS_ASSERT(ok());
        return std::get<T>(content_);
    }
    [[nodiscard]] T&& value() && {
        RHEXIS_ASSERT(ok());
        return std::get<T>(std::move(content_));
    }
    [[nodiscard]] const Error& error() const {
        RHEXIS_ASSERT(!ok());
        return std::get<Error>(content_);
    }

private:
    std::variant<T, Error> content_;
};

/// Result of an operation that returns nothing.
using Status = Result<std::monostate>;
inline Status success() { return Status(std::monostate{}); }

}  // namespace rhexis
