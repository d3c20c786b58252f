// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/socket.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace rhexis {
namespace {

constexpr std::size_t at_once = 16384;       ///< bytes that one read takes
constexpr std::size_t most_at_once = 65536;  ///< and all reads of a turn: others want theirs too
constexpr int waiting_peers = 16;

Error refused(const std::string& what, const NetAddress& address) {
    return Error{what + " at " + address.host + ":" + std::to_string(address.port) + ": " + std::strerror(errno), "",
                 ""};
}

Result<sockaddr_in> numbers_of(const NetAddress& address) {
    sockaddr_in numbers{};
    numbers.sin_family = AF_INET;
    numbers.sin_port = htons(static_cast<std::uint16_t>(address.port));
    if (inet_pton(AF_INET, address.host.c_str(), &numbers.sin_addr) != 1 || address.port < 0 || address.port > 65535) {
        return Error{"no address: " + address.host + ":" + std::to_string(address.port), "",
                     "four numbers with dots, and a port of 0 to 65535"};
    }
    return numbers;
}

NetAddress address_of(const sockaddr_in& numbers) {
    std::array<char, INET_ADDRSTRLEN> text{};
    inet_ntop(AF_INET, &numbers.sin_addr, text.data(), text.size());
    return {text.data(), ntohs(numbers.sin_port)};
}

const sockaddr* plain(const sockaddr_in& numbers) { return reinterpret_cast<const sockaddr*>(&numbers); }
sockaddr* plain(sockaddr_in& numbers) { return reinterpret_cast<sockaddr*>(&numbers); }

bool would_wait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

void send_at_once(int handle) {
    const int on = 1;
    ::setsockopt(handle, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

}  // namespace

Socket::~Socket() {
    if (handle_ >= 0) {
        ::close(handle_);
    }
}

Result<Socket> Socket::bound(int kind, const NetAddress& address) {
    const Result<sockaddr_in> numbers = numbers_of(address);
    if (!numbers) {
        return numbers.error();
    }
    Socket socket(::socket(AF_INET, kind | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    const int on = 1;
    if (socket.handle_ < 0 ||
        (kind == SOCK_STREAM && ::setsockopt(socket.handle_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0) ||
        ::bind(socket.handle_, plain(numbers.value()), sizeof(sockaddr_in)) != 0) {
        return refused("no socket", address);
    }
    return socket;
}

Result<Socket> Socket::listen_at(const NetAddress& address) {
    Result<Socket> socket = bound(SOCK_STREAM, address);
    if (socket && ::listen(socket.value().handle_, waiting_peers) != 0) {
        return refused("nobody can connect", address);
    }
    return socket;
}

Result<Socket> Socket::datagrams_at(const NetAddress& address) { return bound(SOCK_DGRAM, address); }

Result<Socket> Socket::connect_to(const NetAddress& address) {
    const Result<sockaddr_in> numbers = numbers_of(address);
    if (!numbers) {
        return numbers.error();
    }
    Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (socket.handle_ < 0 ||
        (::connect(socket.handle_, plain(numbers.value()), sizeof(sockaddr_in)) != 0 && errno != EINPROGRESS)) {
        return refused("nobody answers", address);
    }
    send_at_once(socket.handle_);
    return socket;
}

int Socket::port() const {
    sockaddr_in numbers{};
    socklen_t size = sizeof numbers;
    return ::getsockname(handle_, plain(numbers), &size) == 0 ? ntohs(numbers.sin_port) : 0;
}

std::string Socket::own_host() const {
    sockaddr_in numbers{};
    socklen_t size = sizeof numbers;
    return ::getsockname(handle_, plain(numbers), &size) == 0 ? address_of(numbers).host : "";
}

std::string Socket::other_host() const {
    sockaddr_in numbers{};
    socklen_t size = sizeof numbers;
    return ::getpeername(handle_, plain(numbers), &size) == 0 ? address_of(numbers).host : "";
}

std::optional<Socket> Socket::accept() {
    const int handle = ::accept4(handle_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (handle < 0) {
        return std::nullopt;
    }
    send_at_once(handle);
    return Socket(handle);
}

std::optional<bool> Socket::is_connected() const {
    pollfd look{handle_, POLLOUT, 0};
    if (::poll(&look, 1, 0) <= 0) {
        return std::nullopt;
    }
    int fault = 0;
    socklen_t size = sizeof fault;
    return ::getsockopt(handle_, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 && fault == 0;
}

bool Socket::read(WireBytes& into) {
    for (std::size_t all = 0; all < most_at_once;) {
        const std::size_t before = into.size();
        into.resize(before + at_once);
        const ssize_t count = ::recv(handle_, &into[before], at_once, 0);
        into.resize(before + static_cast<std::size_t>(count > 0 ? count : 0));
        if (count <= 0) {
            return count < 0 && would_wait();
        }
        all += static_cast<std::size_t>(count);
    }
    return true;
}

bool Socket::write(WireBytes& from) {
    if (from.empty()) {
        return true;
    }
    const ssize_t count = ::send(handle_, from.data(), from.size(), MSG_NOSIGNAL);
    if (count < 0) {
        return would_wait();
    }
    from.erase(from.begin(), from.begin() + count);
    return true;
}

std::optional<Socket::Datagram> Socket::receive() {
    Datagram datagram;
    datagram.bytes.resize(2048);
    sockaddr_in numbers{};
    socklen_t size = sizeof numbers;
    const ssize_t count = ::recvfrom(handle_, datagram.bytes.data(), datagram.bytes.size(), 0, plain(numbers), &size);
    if (count < 0) {
        return std::nullopt;
    }
    datagram.bytes.resize(static_cast<std::size_t>(count));
    datagram.from = address_of(numbers);
    return datagram;
}

std::string Socket::address_towards(const NetAddress& address) {
    const Result<sockaddr_in> numbers = numbers_of(address);
    const Socket look(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));  // connecting it sends nothing
    sockaddr_in own{};
    socklen_t size = sizeof own;
    if (!numbers || ::connect(look.handle_, plain(numbers.value()), sizeof(sockaddr_in)) != 0 ||
        ::getsockname(look.handle_, plain(own), &size) != 0) {
        return "";
    }
    return address_of(own).host;
}

void Socket::send_to(const NetAddress& address, WireSpan bytes) {
    if (const Result<sockaddr_in> numbers = numbers_of(address)) {
        static_cast<void>(
            ::sendto(handle_, bytes.data(), bytes.size(), MSG_NOSIGNAL, plain(numbers.value()), sizeof(sockaddr_in)));
    }
}

void Socket::wait_for(const std::vector<const Socket*>& sockets, int longest_ms) {
    std::vector<pollfd> looks;
    for (const Socket* socket : sockets) {
        looks.push_back({socket->handle_, POLLIN, 0});
    }
    ::poll(looks.data(), looks.size(), longest_ms);
}

}  // namespace rhexis
