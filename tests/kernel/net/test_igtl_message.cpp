// SPDX-License-Identifier: GPL-3.0-or-later
// OpenIGTLink's messages, against those that the packaged library packs, and against what a peer may send that is
// broken.
#include "net/igtl_message.hpp"

#include <doctest/doctest.h>
#include <igtlImageMessage.h>
#include <igtlStatusMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_util.h>

#include <cmath>
#include <limits>
#include <string>

#include "base/rng.hpp"

using namespace rhexis;

namespace {

namespace ours = rhexis::igtlink;
using ours::Message;

const Quat some_turn(Eigen::AngleAxisd(0.7, Vec3(1.0, -2.0, 0.5).normalized()));
constexpr std::size_t size_at = 42;
constexpr std::size_t crc_at = 50;

template <typename Packed>
WireBytes packed(const Packed& message, const char* device) {
    message->SetDeviceName(device);
    message->SetTimeStamp(1790000000U, 0x80000000U);
    message->Pack();
    const auto* bytes = static_cast<const std::uint8_t*>(message->GetPackPointer());
    return {bytes, bytes + message->GetPackSize()};
}

void fill(igtl::Matrix4x4& matrix, const Vec3& position) {
    const Mat3 turned = some_turn.toRotationMatrix();
    igtl::IdentityMatrix(matrix);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrix[row][column] = static_cast<float>(turned(row, column));
        }
        matrix[row][3] = static_cast<float>(position[row]);
    }
}

WireBytes library_transform(const Vec3& position = Vec3(1.5, -20.25, 300.0), float scale = 1.0F) {
    const auto message = igtl::TransformMessage::New();
    igtl::Matrix4x4 matrix{};
    fill(matrix, position);
    matrix[0][0] *= scale;
    message->SetMatrix(matrix);
    return packed(message, "phaco");
}

WireBytes library_tracking_data() {
    const auto message = igtl::TrackingDataMessage::New();
    for (const char* name : {"phaco", "a name of 20 letters"}) {
        auto element = igtl::TrackingDataElement::New();
        igtl::Matrix4x4 matrix{};
        fill(matrix, Vec3(name[0], 2.0, 3.0));
        element->SetName(name);
        element->SetType(igtl::TrackingDataElement::TYPE_TRACKER);
        element->SetMatrix(matrix);
        message->AddTrackingDataElement(element);
    }
    return packed(message, "Tracker");
}

WireBytes library_status() {
    const auto message = igtl::StatusMessage::New();
    message->SetCode(igtl::StatusMessage::STATUS_NOT_READY);
    message->SetSubCode(-128);
    message->SetErrorName("warming up");
    message->SetStatusString("the lamps are cold");
    return packed(message, "Tracker");
}

WireBytes library_start(int period_ms) {
    const auto message = igtl::StartTrackingDataMessage::New();
    message->SetResolution(period_ms);
    message->SetCoordinateName("Patient");
    return packed(message, "a client");
}

void append(const WireBytes& more, WireBytes& to) { to.insert(to.end(), more.begin(), more.end()); }

WireBytes all_of_the_library() {
    WireBytes all = library_transform();
    append(library_tracking_data(), all);
    append(library_status(), all);
    append(library_start(20), all);
    append(packed(igtl::StopTrackingDataMessage::New(), "a client"), all);
    append(packed(igtl::GetStatusMessage::New(), "a client"), all);
    return all;
}

/// All messages until there are no more whole ones; the error, if the peer has to be dropped.
std::string drain(ours::Stream& stream, std::vector<Message>& messages) {
    while (true) {
        Result<std::optional<Message>> next = stream.next();
        if (!next) {
            return next.error().text();
        }
        if (!next.value()) {
            return "";
        }
        messages.push_back(*std::move(next).value());
    }
}

/// What is said against it; empty: it is read whole.
std::string fault_of(const WireBytes& bytes, std::vector<Message>* read = nullptr) {
    ours::Stream stream;
    stream.add(bytes);
    std::vector<Message> messages;
    const std::string fault = drain(stream, messages);
    if (read != nullptr) {
        *read = messages;
    }
    return fault.empty() && stream.waiting() > 0 ? "it waits for more" : fault;
}

/// A message whose body is this, with its size and sum as they have to be.
WireBytes with_body(WireBytes message, WireBytes body) {
    message.resize(ours::header_bytes);
    const std::uint64_t crc = body.empty() ? 0 : ::crc64(body.data(), body.size(), 0);
    message.resize(size_at);
    append_u32(0, message);
    append_u32(static_cast<std::uint32_t>(body.size()), message);
    append_u32(static_cast<std::uint32_t>(crc >> 32), message);
    append_u32(static_cast<std::uint32_t>(crc), message);
    append(body, message);
    return message;
}

WireBytes body_of(const WireBytes& message) { return {message.begin() + ours::header_bytes, message.end()}; }

/// With a header of version 2: before the content 12 bytes and `more`, after it metadata.
WireBytes with_extended_header(const WireBytes& message, std::uint8_t more, std::uint8_t metadata) {
    WireBytes body{0, static_cast<std::uint8_t>(12 + more), 0, 2, 0, 0, 0, metadata, 0, 0, 0, 7};
    body.resize(body.size() + more, 0xAA);
    append(body_of(message), body);
    body.resize(body.size() + 2U + metadata, 0xBB);
    WireBytes out = with_body(message, body);
    out[1] = 2;
    return out;
}

const Pose& pose_in(const Message& message) { return std::get<ours::Transform>(message.content).pose; }

}  // namespace

TEST_SUITE("igtl message") {
    TEST_CASE("what the library packs is read, whatever pieces it comes in") {
        const WireBytes all = all_of_the_library();
        for (std::size_t piece = 1; piece <= all.size(); piece += piece < 80 ? 1 : 37) {
            ours::Stream stream;
            std::vector<Message> messages;
            for (std::size_t at = 0; at < all.size(); at += piece) {
                stream.add(WireSpan(all).subspan(at, std::min(piece, all.size() - at)));
                REQUIRE(drain(stream, messages).empty());
            }
            REQUIRE(messages.size() == 6);
            CHECK(stream.waiting() == 0);
            CHECK(messages[0].device == "phaco");
            CHECK(messages[0].time_us == 1790000000500000);
            CHECK((pose_in(messages[0]).position - Vec3(1.5, -20.25, 300.0)).norm() == 0.0);
            CHECK(pose_in(messages[0]).orientation.angularDistance(some_turn) < 1e-6);
            const auto& tools = std::get<ours::TrackingData>(messages[1].content).tools;
            REQUIRE(tools.size() == 2);
            CHECK(tools[0].name == "phaco");
            CHECK(tools[1].name == "a name of 20 letters");
            CHECK(tools[1].pose.position == Vec3('a', 2.0, 3.0));
            CHECK(tools[1].pose.orientation.angularDistance(some_turn) < 1e-6);
            CHECK(std::get<ours::DeviceStatus>(messages[2].content) ==
                  ours::DeviceStatus{13, -128, "warming up", "the lamps are cold"});
            CHECK(std::get<ours::StartTracking>(messages[3].content).period_ms == 20);
            CHECK(std::get<ours::StartTracking>(messages[3].content).coordinates == "Patient");
            CHECK(std::holds_alternative<ours::StopTracking>(messages[4].content));
            CHECK(std::holds_alternative<ours::StatusRequest>(messages[5].content));
        }
    }

    TEST_CASE("what is told is what the library packs, and is read again") {
        constexpr std::int64_t time_us = 1790000000500000;
        const Pose pose{Vec3(1.5, -20.25, 300.0), some_turn};
        CHECK(ours::bytes_of({"phaco", time_us, ours::Transform{pose}}) == library_transform());
        CHECK(ours::bytes_of({"a client", time_us, ours::StartTracking{20, "Patient"}}) == library_start(20));
        CHECK(ours::bytes_of({"Tracker", time_us, ours::DeviceStatus{13, -128, "warming up", "the lamps are cold"}}) ==
              library_status());
        for (const bool accepted : {true, false}) {
            std::vector<Message> read;
            REQUIRE(fault_of(ours::bytes_of({"Tracker", time_us, ours::StartReply{accepted}}), &read).empty());
            CHECK(std::get<ours::StartReply>(read.at(0).content).accepted == accepted);
        }
        for (const std::int64_t odd : {std::int64_t{1}, std::int64_t{999999}, time_us + 123457}) {
            std::vector<Message> read;
            REQUIRE(fault_of(ours::bytes_of({"x", odd, ours::TrackingData{}}), &read).empty());
            CHECK(read.at(0).time_us == odd);
            CHECK(std::get<ours::TrackingData>(read.at(0).content).tools.empty());
        }
    }

    TEST_CASE("of a header of version 2 the extended header and the metadata are passed over; a later one is refused") {
        WireBytes message = library_transform();
        for (const int more : {0, 9}) {
            std::vector<Message> read;
            REQUIRE(fault_of(with_extended_header(message, static_cast<std::uint8_t>(more), 5), &read) == "");
            REQUIRE(read.size() == 1);
            CHECK(pose_in(read[0]).position == Vec3(1.5, -20.25, 300.0));
        }
        WireBytes short_one = with_extended_header(message, 0, 0);
        for (const int size : {0, 11, 61}) {
            WireBytes body = body_of(short_one);
            body[1] = static_cast<std::uint8_t>(size);
            WireBytes out = with_body(short_one, body);
            CHECK(fault_of(out).find("extended header of " + std::to_string(size)) != std::string::npos);
        }
        WireBytes body = body_of(short_one);
        body[4] = 0xFF;  // metadata longer than anything
        CHECK(fault_of(with_body(short_one, body)).find("metadata of 4278190082") != std::string::npos);
        for (const int version : {0, 3}) {
            message[1] = static_cast<std::uint8_t>(version);
            CHECK(fault_of(message) == "OpenIGTLink: a header of version " + std::to_string(version) + " (1 or 2)");
        }
    }

    TEST_CASE("a type that is not read is passed over, and what follows is read") {
        const auto image = igtl::ImageMessage::New();
        image->SetDimensions(8, 8, 1);
        image->SetScalarTypeToUint8();
        image->AllocateScalars();
        WireBytes all = packed(image, "camera");
        append(library_transform(), all);
        std::vector<Message> read;
        CHECK(fault_of(all, &read).empty());
        REQUIRE(read.size() == 2);
        CHECK(std::get<ours::Other>(read[0].content).type == "IMAGE");
        CHECK(read[1].device == "phaco");
    }

    TEST_CASE("sums, sizes and names that are wrong are refused with a word") {
        const WireBytes good = library_transform();
        CHECK(fault_of(good).empty());
        for (const std::size_t at : {crc_at, ours::header_bytes, good.size() - 1}) {
            WireBytes spoilt = good;
            spoilt[at] ^= 1;
            CHECK(fault_of(spoilt).find("another CRC") != std::string::npos);
        }
        WireBytes large = good;
        large[size_at + 5] = 1;  // 65536 and 48
        CHECK(fault_of(large) == "OpenIGTLink: a body of 65584 bytes, of type TRANSFORM (at most 65536)");
        large[size_at] = 0xFF;
        CHECK(fault_of(large).find("at most 65536") != std::string::npos);
        CHECK(fault_of(WireBytes(good.begin(), good.end() - 1)) == "it waits for more");
        WireBytes unreadable = good;
        unreadable[14] = 7;
        CHECK(fault_of(unreadable).find("printable") != std::string::npos);
        for (const WireBytes& message : {good, library_tracking_data(), library_start(1)}) {
            WireBytes body = body_of(message);
            body.pop_back();
            CHECK(fault_of(with_body(message, body)).find(" bytes (") != std::string::npos);
            body.resize(body.size() + 2);
            CHECK(fault_of(with_body(message, body)).find(" bytes (") != std::string::npos);
        }
        WireBytes status = body_of(library_status());
        status.resize(30);
        CHECK(fault_of(with_body(library_status(), status)).empty());  // without a text
        status.resize(29);
        CHECK(fault_of(with_body(library_status(), status)) == "OpenIGTLink: STATUS of 29 bytes (30 or more)");
        CHECK(fault_of(library_start(-1)) == "OpenIGTLink: a period of -1 ms (0 or more)");
        WireBytes named = body_of(library_tracking_data());
        named[2] = 0x1B;
        CHECK(fault_of(with_body(library_tracking_data(), named)).find("name of a tool") != std::string::npos);
    }

    TEST_CASE("numbers that are not finite and rotations that are none are refused, one that is rounded is not") {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        CHECK(fault_of(library_transform(Vec3(nan, 0.0, 0.0))) ==
              "OpenIGTLink: a number that is not finite in the pose of 'phaco'");
        CHECK_FALSE(fault_of(library_transform(Vec3(0.0, std::numeric_limits<double>::infinity(), 0.0))).empty());
        CHECK_FALSE(fault_of(library_transform(Vec3::Zero(), std::numeric_limits<float>::quiet_NaN())).empty());
        CHECK(fault_of(library_transform(Vec3::Zero(), 1.0005F)).empty());
        CHECK(fault_of(library_transform(Vec3::Zero(), 1.01F)) ==
              "OpenIGTLink: the rotation of 'phaco' is none (orthonormal columns to 0.001, right-handed)");
        CHECK_FALSE(fault_of(library_transform(Vec3::Zero(), 0.0F)).empty());
        WireBytes mirrored = body_of(library_transform());
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t row = 0; row < 3; ++row) {
                mirrored[12 * column + 4 * row] ^= 0x80;
            }
        }
        CHECK_FALSE(fault_of(with_body(library_transform(), mirrored)).empty());
        WireBytes tools = body_of(library_tracking_data());
        tools[70 + 22] ^= 0x40;  // of the second tool's first column
        CHECK(fault_of(with_body(library_tracking_data(), tools)).find("'a name of 20 letters'") != std::string::npos);
    }

    TEST_CASE("spoilt bytes are read or refused, and nothing else happens") {
        Rng random(7);
        const auto pick = [&random](std::size_t below) {
            return static_cast<std::size_t>(random.uniform() * static_cast<double>(below));
        };
        const std::vector<WireBytes> good{library_transform(), library_tracking_data(), library_status(),
                                          library_start(20), with_extended_header(library_tracking_data(), 3, 9)};
#ifdef RHEXIS_CHECKS
        constexpr int cases = 20000;
#else
        constexpr int cases = 1000000;
#endif
        int dropped = 0;
        int read = 0;
        for (int i = 0; i < cases; ++i) {
            WireBytes bytes = good[pick(good.size())];
            for (std::size_t change = 0; change <= pick(4); ++change) {
                bytes[pick(bytes.size())] = static_cast<std::uint8_t>(pick(256));
            }
            if (pick(2) == 0) {  // so that what is within the body is looked at
                WireBytes body = body_of(bytes);
                body.resize(pick(8) == 0 ? pick(body.size()) : body.size());
                bytes = with_body(bytes, body);
            }
            ours::Stream stream;
            stream.add(bytes);
            std::vector<Message> messages;
            dropped += drain(stream, messages).empty() ? 0 : 1;
            read += messages.empty() ? 0 : 1;
        }
        CHECK(dropped > cases / 4);
        CHECK(read > cases / 8);
    }
}
