// SPDX-License-Identifier: GPL-3.0-or-later
// Who has connected to a server of any protocol: let in, and dropped when gone.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "net/socket.hpp"

namespace rhexis {

/// Lets in who has connected, as long as there are fewer than `most`. A Guest begins with its Peer.
template <typename Guest>
void let_in(Socket& listener, std::size_t most, double now_s, std::list<Guest>& guests,
            std::vector<std::string>& notes) {
    while (std::optional<Socket> come = listener.accept()) {
        if (guests.size() < most) {
            guests.push_back({{std::move(*come), now_s}});
        } else {
            notes.push_back("there are " + std::to_string(most) + " already");
        }
    }
}

/// Drops those who can only be dropped, and notes why.
template <typename Guest>
void drop_the_gone(std::list<Guest>& guests, std::vector<std::string>& notes) {
    std::erase_if(guests, [&notes](const Guest& guest) {
        if (guest.peer.fault().empty()) {
            return false;
        }
        notes.push_back(guest.peer.fault());
        return true;
    });
}

}  // namespace rhexis
