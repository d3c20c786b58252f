// SPDX-License-Identifier: GPL-3.0-or-later
// Hears a tracking system on a thread of its own, so that what comes is stamped when it comes and not when the
// simulation has time for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "math/types.hpp"
#include "net/vrpn_client.hpp"

namespace rhexis::station {

/// Whether an --input is a tracking system's address.
bool is_tracked(std::string_view input);

/// Of "vrpn://ADDRESS", "vrpn://ADDRESS:PORT", and "vrpn://tcp://ADDRESS" or "vrpn+tcp://ADDRESS" where datagrams do
/// not pass.
Result<vrpn::ServerPlace> tracking_place(std::string_view input);

/// From a file {"position_mm": [x, y, z], "orientation_xyzw": [x, y, z, w]}: where the frame of the tracked head lies
/// in that of the simulated eye. The error names the field and what it may be.
Result<Pose> read_registration(const std::string& path);

/// Of the clock by which arrivals are told: it only goes forward [us].
std::int64_t arrival_clock_us();

class TrackedLink {
public:
    /// optional: devices that are heard where there are such.
    TrackedLink(vrpn::ServerPlace place, std::vector<std::string> devices, const std::vector<std::string>& optional);
    ~TrackedLink();
    TrackedLink(const TrackedLink&) = delete;
    TrackedLink& operator=(const TrackedLink&) = delete;

    struct Arrived {
        DeviceReport report;
        std::int64_t arrival_us = 0;
    };
    struct News {
        std::vector<Arrived> reports{};
        bool connected = false;
        std::string trouble{};  ///< why it is not connected, or which device does not answer; empty: all is well
    };
    /// What has come since it was asked last.
    News collect();
    /// Waits for a connection that may be used, no longer than this. False: there is none.
    bool wait(double longest_s);

private:
    void run();

    vrpn::Client client_;  ///< of the thread only
    std::mutex mutex_;
    News news_;
    std::atomic<bool> ends_ = false;
    std::thread thread_;
};

}  // namespace rhexis::station
