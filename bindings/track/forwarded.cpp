// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/forwarded.hpp"

#include <utility>

#include "input/tracked_hands.hpp"
#include "net/vrpn_report.hpp"

namespace rhexis::tracking {
namespace {

/// One report, told: what is so until it changes is kept for who comes later.
struct Told {
    vrpn::Server& to;
    const std::string& device;
    std::int64_t time_us;
    void operator()(const ButtonReport& button) const {
        to.keep(device, vrpn::button_type, vrpn::payload_of(button), time_us);
    }
    void operator()(const std::vector<bool>& buttons) const {
        to.keep(device, vrpn::buttons_type, vrpn::buttons_payload(buttons), time_us);
    }
    void operator()(const std::vector<double>& channels) const {
        to.keep(device, vrpn::analog_type, vrpn::analog_payload(channels), time_us);
    }
    void operator()(const TextReport& text) const { to.tell(device, vrpn::text_type, vrpn::payload_of(text), time_us); }
    template <typename Seen>
    void operator()(const Seen&) const {}  // where instruments are the cameras say
};

}  // namespace

Result<Forwarded> Forwarded::open(const std::string& server, std::vector<std::string> instruments) {
    Result<vrpn::ServerPlace> place = vrpn::server_place(server);
    if (!place) {
        return place.error();
    }
    instruments.emplace_back(staff_device);
    vrpn::Client client(std::move(place).value(), {pedal_device}, instruments);
    instruments.emplace_back(pedal_device);
    return Forwarded(std::move(client), std::move(instruments));
}

void Forwarded::turn(double now_s, std::int64_t time_us, vrpn::Server& to) {
    reports_.clear();
    client_.turn(now_s, time_us, reports_);
    for (const DeviceReport& report : reports_) {
        std::visit(Told{to, report.device, time_us}, report.what);
    }
}

}  // namespace rhexis::tracking
