// SPDX-License-Identifier: GPL-3.0-or-later
// Tells over OpenIGTLink where tools are to all who connect: TDATA to who asks for it, a TRANSFORM for each tool to who
// asks for nothing, as 3D Slicer does. Nobody who sends half a message, nothing, or nonsense, keeps the others waiting.
#pragma once

#include <limits>
#include <list>
#include <string>
#include <utility>
#include <vector>

#include "net/guests.hpp"
#include "net/igtl_peer.hpp"

namespace rhexis::igtlink {

class Server {
public:
    /// device: the name of the tracking system, printable ASCII of 1 to longest_name characters. The error says what is
    /// wrong with it or with the address.
    static Result<Server> open(const NetAddress& address, std::string device);

    /// Lets peers in, reads, answers, sends, and drops those who are gone. Never waits. now_s: of a clock that only
    /// goes forward; time_us: since 1970.
    void turn(double now_s, std::int64_t time_us);

    /// Where the tools are that can be seen; none: nothing is told. Names: printable ASCII, 1 to longest_name
    /// characters, else it is a mistake of the caller.
    void tell(const std::vector<Tool>& tools, double now_s, std::int64_t time_us);

    /// How it is: to all when it differs from before, and to who connects or asks later. Its text is at most
    /// longest_text bytes.
    void tell_status(const DeviceStatus& status, std::int64_t time_us);

    [[nodiscard]] std::size_t peer_count() const;
    [[nodiscard]] int port() const { return listener_.port(); }
    /// Who was refused or dropped, and why, since the last call.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

private:
    /// What a guest is told of tools: transforms until it asks for tracking data, and nothing once it has stopped that.
    enum class Wish { transforms, tracking_data, nothing };
    struct Guest {
        Peer peer;
        bool introduced = false;
        Wish wish = Wish::transforms;
        double period_s = 0.0;  ///< between two tracking data, at least
        double told_s = -std::numeric_limits<double>::infinity();
        bool noted = false;  ///< that it tells where tools are, which only a server does
    };
    Server(Socket listener, std::string device) : listener_(std::move(listener)), device_(std::move(device)) {}
    void answer(Guest& guest, const Message& message, std::int64_t time_us);
    [[nodiscard]] WireBytes status_message(std::int64_t time_us) const;

    Socket listener_;
    std::string device_;
    DeviceStatus status_{};
    std::list<Guest> guests_;
    std::vector<std::string> notes_;
};

/// Whether it can be the name of a device or a tool: printable ASCII, 1 to longest_name characters.
bool is_name(std::string_view text);

}  // namespace rhexis::igtlink
