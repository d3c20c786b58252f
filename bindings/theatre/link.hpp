// SPDX-License-Identifier: GPL-3.0-or-later
// The wire between the station and theatre's monitors: moments one way, requests back. Over ZeroMQ, which neither waits
// for a monitor that is slow, stopped or gone, nor minds a second one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "station/theatre.hpp"
#include "station/user_event.hpp"

namespace rhexis::station {

/// An address as ZeroMQ has them, "ipc:///folder/name" or "tcp://127.0.0.1:5555"; requests go to the one beside it,
/// ".requests" or the next port. The error says what is allowed.
Status check_theatre(const std::string& address);

/// The station's end. show() on one thread, requests() on another.
class TheatreFeed final : public Theatre {
public:
    /// Fails where another station has the address.
    static Result<std::unique_ptr<TheatreFeed>> open(const std::string& address);
    ~TheatreFeed() override;
    TheatreFeed(const TheatreFeed&) = delete;
    TheatreFeed& operator=(const TheatreFeed&) = delete;

    void show(const TheatreMoment& moment) override;
    /// Those that have come since this was asked last; what is no request is left out.
    std::vector<UserEvent> requests();

private:
    struct Parts;
    explicit TheatreFeed(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// A monitor's end.
class TheatreView {
public:
    /// Whether a station is there or not: it may come later.
    static Result<std::unique_ptr<TheatreView>> open(const std::string& address);
    ~TheatreView();
    TheatreView(const TheatreView&) = delete;
    TheatreView& operator=(const TheatreView&) = delete;

    /// The newest moment, waiting so long for one; none: there was none. What is no moment, or of another version, is
    /// left out, and strange() says so.
    std::optional<TheatreMoment> newest(double longest_s);
    [[nodiscard]] bool strange() const;
    /// False: no station took it within this time.
    bool ask(const UserEvent& request, double longest_s);

private:
    struct Parts;
    explicit TheatreView(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis::station
