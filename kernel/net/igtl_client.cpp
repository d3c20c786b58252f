// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/igtl_client.hpp"

#include <utility>

namespace rhexis::igtlink {
namespace {

constexpr double retry_s = 2.0;
constexpr double pose_within_s = 3.0;  ///< else it is told
constexpr const char* own_name = "rhexis";

/// Adds what a message says.
struct Reporting {
    const Message& message;
    std::int64_t time_us;
    std::vector<DeviceReport>& reports;

    void add_pose(const std::string& device, const Pose& pose) const {
        reports.push_back({device, time_us, PoseReport{0, pose.position, pose.orientation}});
    }
    void operator()(const Transform& transform) const { add_pose(message.device, transform.pose); }
    void operator()(const TrackingData& data) const {
        for (const Tool& tool : data.tools) {
            add_pose(tool.name, tool.pose);
        }
    }
    void operator()(const DeviceStatus& status) const {
        const Severity severity = status.code == status_ok ? Severity::normal : Severity::error;
        reports.push_back(
            {message.device, time_us, TextReport{severity, static_cast<std::uint32_t>(status.code), status.text}});
    }
    template <typename Question>
    void operator()(const Question& /*question*/) const {}  // nothing that a client answers
};

}  // namespace

Result<NetAddress> server_address(std::string_view text) {
    std::optional<NetAddress> address = read_address(text, port);
    if (!address) {
        return Error{"no OpenIGTLink server: '" + std::string(text) + "'", "",
                     "ADDRESS or ADDRESS:PORT, the address dotted or localhost"};
    }
    return *std::move(address);
}

void Client::turn(double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports) {
    if (!peer_) {
        reach_out(now_s);
    }
    if (!peer_) {
        return;
    }
    std::vector<Message> messages;
    peer_->turn(now_s, messages);
    if (peer_->is_open()) {
        ask(now_s, time_us);
    }
    for (const Message& message : messages) {
        take(message, now_s, time_us, reports);
    }
    if (!peer_->fault().empty()) {
        lost_ = peer_->fault();
        next_try_s_ = now_s + retry_s;
        asked_ = false;
        peer_.reset();
    }
}

void Client::reach_out(double now_s) {
    if (now_s < next_try_s_) {
        return;
    }
    next_try_s_ = now_s + retry_s;
    Result<Socket> socket = Socket::connect_to(address_);
    if (socket) {
        peer_.emplace(std::move(socket).value(), now_s);
    } else {
        lost_ = socket.error().text();
    }
}

void Client::ask(double now_s, std::int64_t time_us) {
    if (asked_) {
        return;
    }
    asked_ = true;
    refused_ = false;
    posed_s_ = now_s;
    lost_.clear();
    peer_->send(bytes_of({own_name, time_us, StartTracking{period_ms_, ""}}));
}

void Client::take(const Message& message, double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports) {
    if (const auto* reply = std::get_if<StartReply>(&message.content)) {
        refused_ = !reply->accepted;
        return;
    }
    const std::size_t before = reports.size();
    std::visit(Reporting{message, message.time_us == 0 ? time_us : message.time_us, reports}, message.content);
    const bool posed = reports.size() > before && std::holds_alternative<PoseReport>(reports.back().what);
    posed_s_ = posed ? now_s : posed_s_;
}

std::string Client::trouble(double now_s) const {
    if (!is_connected()) {
        return lost_.empty() ? "no OpenIGTLink server has answered yet" : lost_;
    }
    if (now_s - posed_s_ <= pose_within_s) {
        return "";
    }
    return refused_ ? "the server refuses to tell where tools are" : "the server tells no pose";
}

}  // namespace rhexis::igtlink
