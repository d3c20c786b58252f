// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/late_reports.hpp"

namespace rhexis {
namespace {

constexpr double late_within_s = 0.2;  ///< no network that hands can be followed over holds a datagram back for longer

struct NumberInDevice {
    int operator()(const PoseReport& pose) const { return pose.sensor; }
    int operator()(const VelocityReport& velocity) const { return velocity.sensor; }
    int operator()(const ButtonReport& button) const { return button.button; }
    template <typename Whole>
    int operator()(const Whole&) const {
        return 0;
    }
};

}  // namespace

bool LateReports::is_late(const DeviceReport& report, double now_s) {
    const auto [found, first] =
        newest_.try_emplace({report.device, report.what.index(), std::visit(NumberInDevice{}, report.what)});
    Newest& newest = found->second;
    if (!first && report.time_us <= newest.time_us && now_s - newest.came_s <= late_within_s) {
        return true;
    }
    newest = {report.time_us, now_s};
    return false;
}

}  // namespace rhexis
