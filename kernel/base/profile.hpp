// SPDX-License-Identifier: GPL-3.0-or-later
// What each part of a step costs. A Profile is owned by its session and handed down; there is no global one.
#pragma once

#include <map>
#include <string>

#include "base/clock.hpp"

namespace rhexis {

struct Profile {
    struct Part {
        double cpu_s = 0.0;  ///< CPU seconds of the thread that ran the part
        long calls = 0;
    };
    std::map<std::string, Part, std::less<>> parts;

    void add(const char* name, double cpu_s) {
        Part& part = parts[name];
        part.cpu_s += cpu_s;
        ++part.calls;
    }
};

/// Charges the time between construction and destruction to one part.
class ProfileScope {
public:
    ProfileScope(Profile& profile, const char* name) : profile_(profile), name_(name), start_(thread_cpu_seconds()) {}
    ~ProfileScope() { profile_.add(name_, thread_cpu_seconds() - start_); }
    ProfileScope(const ProfileScope&) = delete;
    ProfileScope& operator=(const ProfileScope&) = delete;

private:
    Profile& profile_;
    const char* name_;
    double start_;
};

}  // namespace rhexis
