// SPDX-License-Identifier: GPL-3.0-or-later
// OpenIGTLink's messages [Tokuda2009]: read out of a stream of bytes, and written. The packaged library packs and
// unpacks the bodies; lengths, sums and numbers that a peer sends are checked here first, and nothing of it is
// believed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"
#include "net/wire_bytes.hpp"

namespace rhexis::igtlink {

inline constexpr int port = 18944;
inline constexpr std::size_t header_bytes = 58;
inline constexpr std::size_t most_body_bytes = 65536;
inline constexpr std::size_t longest_name = 20;    ///< characters of a device, a tool or an error's name
inline constexpr std::size_t longest_text = 1000;  ///< bytes of a status' text that is told
inline constexpr double off_orthonormal = 1e-3;    ///< of the products of a rotation's columns

/// TRANSFORM: where the device is that the message names.
struct Transform {
    Pose pose{};
};

struct Tool {
    std::string name{};  ///< printable ASCII, at most longest_name characters
    Pose pose{};         ///< [mm]; on the wire as float32, so to 0.03 µm at 500 mm
};

/// TDATA: where all tools are that can be seen.
struct TrackingData {
    std::vector<Tool> tools{};
};

/// STT_TDATA: asks for TrackingData.
struct StartTracking {
    int period_ms = 0;          ///< the least between two; 0: as often as there are any
    std::string coordinates{};  ///< name of the coordinate system, at most 32 characters
};

/// STP_TDATA: no more of it.
struct StopTracking {};

/// RTS_TDATA: what becomes of a StartTracking.
struct StartReply {
    bool accepted = true;
};

/// STATUS
struct DeviceStatus {
    int code = 1;  ///< 1: all is well; 2 to 19 as the protocol numbers its errors
    std::int64_t subcode = 0;
    std::string error{};  ///< its name, at most longest_name - 1 characters
    std::string text{};   ///< without a 0
    bool operator==(const DeviceStatus&) const = default;
};
inline constexpr int status_ok = 1;

/// GET_STATUS: asks for a DeviceStatus.
struct StatusRequest {};

/// Of a type that is not read.
struct Other {
    std::string type{};
};

struct Message {
    std::string device{};      ///< printable ASCII, at most longest_name characters
    std::int64_t time_us = 0;  ///< by the clock of who sent it, since 1970, 0 to 2^32 s; 0: it gives none
    std::variant<Transform, TrackingData, StartTracking, StopTracking, StartReply, DeviceStatus, StatusRequest, Other>
        content{};
};

/// As it goes over the wire, with a header of version 1. Names and texts fit; the content is not Other.
WireBytes bytes_of(const Message& message);

/// Messages of one peer, in a stream that comes in pieces of any size.
class Stream {
public:
    void add(WireSpan bytes) { waiting_.insert(waiting_.end(), bytes.begin(), bytes.end()); }
    /// The next whole message; none: it has not come yet. An error says what the peer sent that cannot be: a header
    /// other than of version 1, or of version 2 (whose extended header and metadata are passed over), a body over
    /// most_body_bytes or with another CRC, a body of another size than its type has, a number that is not finite, a
    /// rotation that is none. After an error the peer can only be dropped.
    Result<std::optional<Message>> next();
    /// Bytes that have come and are no whole message yet.
    [[nodiscard]] std::size_t waiting() const { return waiting_.size() - taken_; }

private:
    WireBytes waiting_;
    std::size_t taken_ = 0;
};

}  // namespace rhexis::igtlink
