// SPDX-License-Identifier: GPL-3.0-or-later
// Tells over the network where tracked instruments are.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/igtl_server.hpp"
#include "net/vrpn_server.hpp"
#include "track/forwarded.hpp"
#include "tracking/setup.hpp"

namespace rhexis::tracking {

/// The device whose text says what is wrong with the rig.
inline constexpr const char* rig_device = "rig";

class Server {
public:
    /// Instruments: all bodies but the head. The error: a port in use, an address that is not this computer's.
    static Result<Server> open(const Setup& setup);

    /// Tips that are seen, stamped with when they were exposed [us since 1970].
    void tell(const TrackedBodies& told, std::int64_t time_us, double now_s);
    /// What is wrong with the rig, once; empty: nothing is any more.
    void warn(const std::string& text, std::int64_t time_us);
    /// Lets in, answers, sends, and passes on what is heard of the setup's inputs; never waits.
    void turn(double now_s, std::int64_t time_us);

    [[nodiscard]] std::size_t listeners() const;
    /// "127.0.0.1:3883 (VRPN)", and so on.
    [[nodiscard]] std::string places() const;
    /// Which listener was refused or dropped, and why.
    std::vector<std::string> take_notes();
    /// What is wrong with the server of the inputs; empty: nothing.
    [[nodiscard]] std::string inputs_trouble(double now_s) const { return inputs_ ? inputs_->trouble(now_s) : ""; }

private:
    Server() = default;

    std::string address_;
    std::vector<std::string> names_;  ///< by body
    std::optional<int> head_;
    std::optional<vrpn::Server> vrpn_;
    std::optional<igtlink::Server> igtl_;
    std::optional<Forwarded> inputs_;
    std::string warned_;
};

}  // namespace rhexis::tracking
