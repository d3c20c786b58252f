// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/link.hpp"

#include <filesystem>
#include <utility>
#include <zmq.hpp>

#include "base/clock.hpp"
#include "base/folder_lock.hpp"

namespace rhexis::station {
namespace {

constexpr const char* by_file = "ipc://";
constexpr const char* by_net = "tcp://";
constexpr int waiting_moments = 2;  ///< for a monitor that is slow: older ones are dropped

/// 0: it has none.
int port_of(const std::string& address) {
    const std::size_t colon = address.rfind(':');
    const std::string digits = colon == std::string::npos ? "" : address.substr(colon + 1);
    const bool number = !digits.empty() && digits.size() <= 5 && digits.find_first_not_of("0123456789") == digits.npos;
    return number ? std::stoi(digits) : 0;
}

std::string requests_of(const std::string& address) {
    if (address.starts_with(by_file)) {
        return address + ".requests";
    }
    return address.substr(0, address.rfind(':') + 1) + std::to_string(port_of(address) + 1);
}

Error not_there(const std::string& what, const std::string& address, const zmq::error_t& error) {
    return Error{"the theatre's " + what + " cannot be opened: " + error.what(), address,
                 "another --theatre, as ipc:///tmp/name or tcp://127.0.0.1:5555"};
}

/// The folder of a local address, for this station alone as long as it lives.
Result<std::optional<FolderLock>> lock_folder(const std::string& address) {
    if (!address.starts_with(by_file) || address != usual_theatre()) {
        return std::optional<FolderLock>();
    }
    const std::filesystem::path folder = std::filesystem::path(address.substr(6)).parent_path();
    Result<FolderLock> lock = FolderLock::take(folder.string());
    if (!lock) {
        return Error{"another station feeds the theatre's monitor", address,
                     "another --theatre for this one, as ipc:///tmp/name"};
    }
    std::error_code ignored;
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all, ignored);
    return std::optional<FolderLock>(std::move(lock).value());
}

}  // namespace

Status check_theatre(const std::string& address) {
    const bool file = address.starts_with(by_file) && address.size() > 6 && address.size() < 90;
    const bool net = address.starts_with(by_net) && port_of(address) > 0 && port_of(address) < 65535;
    if (file || net) {
        return success();
    }
    return Error{"--theatre " + address + " is no address", "", "ipc:///folder/name, or tcp://127.0.0.1:5555"};
}

struct TheatreFeed::Parts {
    explicit Parts(std::optional<FolderLock> held) : lock(std::move(held)) {}

    std::optional<FolderLock> lock;
    zmq::context_t context{1};
    zmq::socket_t moments{context, zmq::socket_type::pub};
    zmq::socket_t requests{context, zmq::socket_type::pull};
};

TheatreFeed::TheatreFeed(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
TheatreFeed::~TheatreFeed() = default;

Result<std::unique_ptr<TheatreFeed>> TheatreFeed::open(const std::string& address) {
    if (const Status good = check_theatre(address); !good) {
        return good.error();
    }
    Result<std::optional<FolderLock>> lock = lock_folder(address);
    if (!lock) {
        return lock.error();
    }
    try {
        std::unique_ptr<Parts> parts = std::make_unique<Parts>(std::move(lock).value());
        parts->moments.set(zmq::sockopt::sndhwm, waiting_moments);
        parts->moments.set(zmq::sockopt::linger, 200);  // [ms] for the last moment, which says how it ended
        parts->requests.set(zmq::sockopt::linger, 0);
        parts->moments.bind(address);
        parts->requests.bind(requests_of(address));
        return std::unique_ptr<TheatreFeed>(new TheatreFeed(std::move(parts)));
    } catch (const zmq::error_t& error) {
        return not_there("feed", address, error);
    }
}

void TheatreFeed::show(const TheatreMoment& moment) {
    const std::string text = nlohmann::json(moment).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    try {
        static_cast<void>(parts_->moments.send(zmq::buffer(text), zmq::send_flags::dontwait));
    } catch (const zmq::error_t&) {
        // interrupted: the next moment is whole again
    }
}

std::vector<UserEvent> TheatreFeed::requests() {
    std::vector<UserEvent> list;
    try {
        zmq::message_t message;
        while (parts_->requests.recv(message, zmq::recv_flags::dontwait)) {
            const nlohmann::json json = nlohmann::json::parse(message.to_string_view(), nullptr, false);
            const Result<UserEvent> event = json.is_object() ? event_from(json) : Error{"", "", ""};
            if (event && event.value().kind == EventKind::staff) {
                list.push_back(event.value());
            }
        }
    } catch (const zmq::error_t&) {
        // interrupted: asked again in a moment
    }
    return list;
}

struct TheatreView::Parts {
    zmq::context_t context{1};
    zmq::socket_t moments{context, zmq::socket_type::sub};
    zmq::socket_t requests{context, zmq::socket_type::push};
    bool strange = false;
};

TheatreView::TheatreView(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
TheatreView::~TheatreView() = default;

Result<std::unique_ptr<TheatreView>> TheatreView::open(const std::string& address) {
    if (const Status good = check_theatre(address); !good) {
        return good.error();
    }
    try {
        std::unique_ptr<Parts> parts = std::make_unique<Parts>();
        parts->moments.set(zmq::sockopt::conflate, 1);  // the newest only
        parts->moments.set(zmq::sockopt::subscribe, "");
        parts->moments.set(zmq::sockopt::linger, 0);
        parts->requests.set(zmq::sockopt::linger, 500);   // [ms] for a request on its way
        parts->requests.set(zmq::sockopt::immediate, 1);  // to a station that is there, or to none
        parts->moments.connect(address);
        parts->requests.connect(requests_of(address));
        return std::unique_ptr<TheatreView>(new TheatreView(std::move(parts)));
    } catch (const zmq::error_t& error) {
        return not_there("monitor", address, error);
    }
}

std::optional<TheatreMoment> TheatreView::newest(double longest_s) {
    try {
        parts_->moments.set(zmq::sockopt::rcvtimeo, static_cast<int>(1e3 * longest_s));
        zmq::message_t message;
        if (!parts_->moments.recv(message)) {
            return std::nullopt;
        }
        const nlohmann::json json = nlohmann::json::parse(message.to_string_view(), nullptr, false);
        parts_->strange = !json.is_object() || json.value("version", nlohmann::json()) != TheatreMoment{}.version;
        if (!parts_->strange) {
            return json.get<TheatreMoment>();
        }
    } catch (const zmq::error_t&) {
        // interrupted: there was none
    } catch (const nlohmann::json::exception&) {
        parts_->strange = true;
    }
    return std::nullopt;
}

bool TheatreView::strange() const { return parts_->strange; }

bool TheatreView::ask(const UserEvent& request, double longest_s) {
    try {
        parts_->requests.set(zmq::sockopt::sndtimeo, static_cast<int>(1e3 * longest_s));
        return parts_->requests.send(zmq::buffer(to_json(request).dump()), zmq::send_flags::none).has_value();
    } catch (const zmq::error_t&) {
        return false;
    }
}

}  // namespace rhexis::station
