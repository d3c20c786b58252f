// SPDX-License-Identifier: GPL-3.0-or-later
// Tells what devices do to all who connect, in both ways that VRPN knows: they connect, or ask by a datagram to be
// connected to. Nobody who sends half a message, nothing, or nonsense, keeps the others waiting.
#pragma once

#include <list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "net/guests.hpp"
#include "net/vrpn_peer.hpp"

namespace rhexis::vrpn {

class Server {
public:
    /// devices: their names, each 1 to longest_name characters. The error says what is wrong with the address.
    static Result<Server> open(const NetAddress& address, std::vector<std::string> devices);

    /// Lets peers in, reads, answers, sends, and drops those who are gone. Never waits. now_s: of a clock that only
    /// goes forward; time_us: since 1970.
    void turn(double now_s, std::int64_t time_us);

    /// To all who are connected; poses and speeds by datagram to who announced a port for such, all else by TCP: a
    /// datagram that is lost would leave a pedal where it was. It goes at the next turn(). A device that it has not is
    /// a mistake of the caller.
    void tell(std::string_view device, std::string_view type, const WireBytes& payload, std::int64_t time_us);

    /// The same, and to who connects or asks later: what is so until it changes, as buttons are.
    void keep(std::string_view device, std::string_view type, const WireBytes& payload, std::int64_t time_us);

    [[nodiscard]] std::size_t peer_count() const;
    [[nodiscard]] int port() const { return listener_.port(); }
    /// Who was refused or dropped, and why, since the last call.
    std::vector<std::string> take_notes() { return std::exchange(notes_, {}); }

private:
    struct Guest {
        Peer peer;
        bool introduced = false;
        NetAddress asked_from{};  ///< port 0: it connected by itself
        bool noted = false;       ///< that it tells what only a server tells
    };
    Server(Socket listener, Socket datagrams, std::vector<std::string> devices);
    void let_in(double now_s);
    void answer(Guest& guest, const Message& message, std::int64_t time_us);
    void introduce(Peer& peer) const;
    [[nodiscard]] Message report(std::string_view device, std::string_view type, const WireBytes& payload,
                                 std::int64_t time_us) const;
    void to_all(const Message& message);

    Socket listener_;
    Socket datagrams_;
    std::vector<std::string> devices_;
    std::list<Guest> guests_;
    std::map<std::pair<std::int32_t, std::int32_t>, Message> kept_;  ///< by sender and type
    std::vector<std::string> notes_;
};

}  // namespace rhexis::vrpn
