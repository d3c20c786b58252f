// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/server.hpp"

#include "net/vrpn_report.hpp"

namespace rhexis::tracking {

Result<Server> Server::open(const Setup& setup) {
    Server server;
    server.address_ = setup.serve.address;
    server.head_ = setup.head;
    std::vector<std::string> devices;
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
        server.names_.push_back(setup.bodies[i].name);
        if (static_cast<int>(i) != setup.head.value_or(-1)) {
            devices.push_back(setup.bodies[i].name);
        }
    }
    if (!setup.inputs.empty() && setup.serve.vrpn_port >= 0) {
        Result<Forwarded> inputs = Forwarded::open(setup.inputs, devices);
        if (!inputs) {
            return Error{inputs.error().what, setup.path + ", \"inputs\": vrpn", inputs.error().allowed};
        }
        server.inputs_.emplace(std::move(inputs).value());
        devices = server.inputs_->devices();
    }
    devices.emplace_back(rig_device);
    if (setup.serve.vrpn_port >= 0) {
        Result<vrpn::Server> opened = vrpn::Server::open({setup.serve.address, setup.serve.vrpn_port}, devices);
        if (!opened) {
            return opened.error();
        }
        server.vrpn_.emplace(std::move(opened).value());
    }
    if (setup.serve.igtl_port >= 0) {
        Result<igtlink::Server> opened = igtlink::Server::open({setup.serve.address, setup.serve.igtl_port}, "rhexis");
        if (!opened) {
            return opened.error();
        }
        server.igtl_.emplace(std::move(opened).value());
    }
    return server;
}

void Server::tell(const TrackedBodies& told, std::int64_t time_us, double now_s) {
    std::vector<igtlink::Tool> tools;
    for (std::size_t i = 0; i < told.bodies.size(); ++i) {
        const TrackedBody& body = told.bodies[i];
        if (body.seen != Seen::seen || static_cast<int>(i) == head_.value_or(-1)) {
            continue;
        }
        if (vrpn_) {
            vrpn_->tell(names_[i], vrpn::pose_type,
                        vrpn::payload_of(PoseReport{0, body.tip.position, body.tip.orientation}), time_us);
        }
        tools.push_back({names_[i].substr(0, igtlink::longest_name), body.tip});
    }
    if (igtl_) {
        igtl_->tell(tools, now_s, time_us);
    }
}

void Server::warn(const std::string& text, std::int64_t time_us) {
    if (text == warned_) {
        return;
    }
    warned_ = text;
    const Severity severity = text.empty() ? Severity::normal : Severity::warning;
    if (vrpn_) {
        vrpn_->keep(rig_device, vrpn::text_type,
                    vrpn::payload_of(TextReport{severity, 0, text.empty() ? "all is well" : text}), time_us);
    }
    if (igtl_) {
        igtlink::DeviceStatus status;
        status.code = text.empty() ? igtlink::status_ok : 19;  // hardware failure
        status.text = text;
        igtl_->tell_status(status, time_us);
    }
}

void Server::turn(double now_s, std::int64_t time_us) {
    if (inputs_) {
        inputs_->turn(now_s, time_us, *vrpn_);
    }
    if (vrpn_) {
        vrpn_->turn(now_s, time_us);
    }
    if (igtl_) {
        igtl_->turn(now_s, time_us);
    }
}

std::size_t Server::listeners() const { return (vrpn_ ? vrpn_->peer_count() : 0) + (igtl_ ? igtl_->peer_count() : 0); }

std::string Server::places() const {
    std::string all;
    if (vrpn_) {
        all += address_ + ":" + std::to_string(vrpn_->port()) + " (VRPN)";
    }
    if (igtl_) {
        all += (all.empty() ? "" : ", ") + address_ + ":" + std::to_string(igtl_->port()) + " (OpenIGTLink)";
    }
    return all;
}

std::vector<std::string> Server::take_notes() {
    std::vector<std::string> all = vrpn_ ? vrpn_->take_notes() : std::vector<std::string>();
    if (igtl_) {
        for (std::string& note : igtl_->take_notes()) {
            all.push_back(std::move(note));
        }
    }
    return all;
}

}  // namespace rhexis::tracking
