// SPDX-License-Identifier: GPL-3.0-or-later
// IPv4 sockets that never wait: who uses them comes back later.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "net/net_address.hpp"
#include "net/wire_bytes.hpp"

namespace rhexis {

class Socket {
public:
    /// Errors name the address, and say what the system says.
    static Result<Socket> listen_at(const NetAddress& address);
    /// Begins to connect; is_connected() tells when it is done.
    static Result<Socket> connect_to(const NetAddress& address);
    static Result<Socket> datagrams_at(const NetAddress& address);

    Socket() = default;
    ~Socket();
    Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
    Socket& operator=(Socket&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }

    [[nodiscard]] int port() const;                ///< of its own end
    [[nodiscard]] std::string own_host() const;    ///< likewise; empty: it has none
    [[nodiscard]] std::string other_host() const;  ///< of the other end; empty: there is none
    /// Who has connected to a listener; none: nobody has.
    std::optional<Socket> accept();
    /// nullopt: not yet; false: it was refused.
    [[nodiscard]] std::optional<bool> is_connected() const;

    /// What has come, at the end of `into`. False: the other end is closed, or broken.
    bool read(WireBytes& into);
    /// As much as goes, taken from the front of `from`. False: the other end is closed, or broken.
    bool write(WireBytes& from);

    struct Datagram {
        NetAddress from;
        WireBytes bytes;
    };
    std::optional<Datagram> receive();
    /// Its own address, as the one at `address` sees it; empty: there is no way there.
    [[nodiscard]] static std::string address_towards(const NetAddress& address);
    /// It may be lost.
    void send_to(const NetAddress& address, WireSpan bytes);

    /// Waits until something has come at one of them, no longer than this [ms]. Of none: so long.
    static void wait_for(const std::vector<const Socket*>& sockets, int longest_ms);

private:
    explicit Socket(int handle) : handle_(handle) {}
    static Result<Socket> bound(int kind, const NetAddress& address);
    int handle_ = -1;
};

}  // namespace rhexis
