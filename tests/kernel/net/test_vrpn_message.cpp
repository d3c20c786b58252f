// SPDX-License-Identifier: GPL-3.0-or-later
// VRPN's frames, against bytes that are written out by hand from the facts of the protocol, and against what a peer
// may send that is broken.
#include "net/vrpn_message.hpp"

#include <doctest/doctest.h>

#include <string>

#include "base/rng.hpp"
#include "net/vrpn_report.hpp"

using namespace rhexis;
using namespace rhexis::vrpn;

namespace {

/// Of hexadecimal digits; blanks between them say nothing.
WireBytes bytes_of(std::string_view hex) {
    WireBytes bytes;
    int digits = 0;
    unsigned value = 0;
    for (const char c : hex) {
        if (c == ' ') {
            continue;
        }
        value = 16 * value + static_cast<unsigned>(c <= '9' ? c - '0' : c - 'A' + 10);
        if (++digits == 2) {
            bytes.push_back(static_cast<std::uint8_t>(value));
            digits = 0;
            value = 0;
        }
    }
    return bytes;
}

const char* const pose_frame =
    "00000058 00000001 00000002 00000003 00000004 00000005 00000001 00000001"
    "3FF0000000000000 C000000000000000 3FE0000000000000"
    "0000000000000000 0000000000000000 0000000000000000 3FF0000000000000";

/// Type 2 is called ab: 31 bytes, filled up to 32.
const char* const name_frame = "0000001F 00000000 00000000 00000002 FFFFFFFE 00000000 00000003 616200 00";

Message posed() {
    Message message;
    message.time_us = 1000002;
    message.sender = 3;
    message.type = 4;
    message.payload = payload_of(PoseReport{1, Vec3(1000.0, -2000.0, 500.0), Quat::Identity()});
    return message;
}

WireBytes framed(const Message& message) {
    WireBytes out;
    append_message(message, 0, out);
    return out;
}

/// All messages until there are no more whole ones; false: the peer has to be dropped.
bool drain(Stream& stream, std::vector<Message>& messages) {
    while (true) {
        Result<std::optional<Message>> next = stream.next();
        if (!next) {
            return false;
        }
        if (!next.value()) {
            return true;
        }
        messages.push_back(*std::move(next).value());
    }
}

}  // namespace

TEST_SUITE("vrpn message") {
    TEST_CASE("frames are these bytes") {
        WireBytes out;
        append_message(posed(), 5, out);
        CHECK(out == bytes_of(pose_frame));
        CHECK(framed(description(System::type_description, 2, "ab")) == bytes_of(name_frame));
        CHECK(greeting() == bytes_of("7672706E 3A207665 722E2030 372E3335 20203000 00000000"));
        CHECK(request_datagram({"127.0.0.1", 4711}) == bytes_of("3132372E 302E302E 31203437 313100"));
    }

    TEST_CASE("bytes are these frames, whatever pieces they come in") {
        WireBytes all = bytes_of(pose_frame);
        const WireBytes name = bytes_of(name_frame);
        all.insert(all.end(), name.begin(), name.end());
        for (std::size_t piece = 1; piece <= all.size(); ++piece) {
            Stream stream;
            std::vector<Message> messages;
            for (std::size_t at = 0; at < all.size(); at += piece) {
                stream.add(WireSpan(all).subspan(at, std::min(piece, all.size() - at)));
                REQUIRE(drain(stream, messages));
            }
            REQUIRE(messages.size() == 2);
            CHECK(messages[0].time_us == 1000002);
            CHECK(messages[0].sender == 3);
            CHECK(messages[0].type == 4);
            CHECK(messages[0].payload == posed().payload);
            CHECK(stream.waiting() == 0);
            Names names;
            REQUIRE(names.take(messages[1]).ok());
            CHECK(names.type(2) == "ab");
            CHECK(names.type(1).empty());
            CHECK(names.sender(2).empty());
        }
        CHECK(read_datagram(all).value().size() == 2);
        CHECK(read_datagram({}).value().empty());
        CHECK_FALSE(read_datagram(WireSpan(all).first(all.size() - 1)).ok());
        CHECK_FALSE(read_datagram(WireSpan(all).first(10)).ok());
    }

    TEST_CASE("greetings: another minor version is taken, another major one and what is no greeting are not") {
        const auto greets = [](std::string text) {
            text.resize(greeting_bytes, '\0');
            return check_greeting(WireBytes(text.begin(), text.end()));
        };
        CHECK(check_greeting(greeting()).ok());
        CHECK(greets("vrpn: ver. 07.10  3").ok());
        CHECK(greets("vrpn: ver. 06.38  0").error().text() ==
              "VRPN: the peer does not speak this version: 'vrpn: ver. 06.38' (vrpn: ver. 07.xx)");
        CHECK_FALSE(greets("vrpn: ver. 07.35  7").ok());
        CHECK_FALSE(greets("GET / HTTP/1.1\r\nHost: ").ok());
        CHECK_FALSE(check_greeting({}).ok());
    }

    TEST_CASE("lengths and names at their limits, and beyond") {
        const auto length_is_taken = [](std::string_view hex) {
            Stream stream;
            WireBytes bytes = bytes_of(hex);
            bytes.resize(header_bytes, 0);
            stream.add(bytes);
            return stream.next().ok();
        };
        CHECK(length_is_taken("00000018"));
        CHECK_FALSE(length_is_taken("00000017"));
        CHECK_FALSE(length_is_taken("00000000"));
        CHECK(length_is_taken("0000FA18"));
        CHECK_FALSE(length_is_taken("0000FA19"));
        CHECK_FALSE(length_is_taken("FFFFFFFF"));
        Names names;
        CHECK(names.take(description(System::sender_description, 1999, std::string(longest_name, 'x'))).ok());
        CHECK(names.sender(1999).size() == longest_name);
        CHECK(names.take(posed()).ok());
        const auto name_is_taken = [](std::int32_t id, std::string_view hex) {
            Message message;
            message.sender = id;
            message.type = -1;
            message.payload = bytes_of(hex);
            return Names().take(message).ok();
        };
        CHECK(name_is_taken(0, "00000002 6100"));
        CHECK_FALSE(name_is_taken(2000, "00000002 6100"));
        CHECK_FALSE(name_is_taken(-1, "00000002 6100"));
        CHECK_FALSE(name_is_taken(0, "00000001 00"));      // of no letter
        CHECK_FALSE(name_is_taken(0, "00000003 6100"));    // longer than what is there
        CHECK_FALSE(name_is_taken(0, "FFFFFFFF 6100"));    // shorter than nothing
        CHECK_FALSE(name_is_taken(0, "00000002 6162"));    // without an end
        CHECK_FALSE(name_is_taken(0, "00000003 610000"));  // with two
        CHECK_FALSE(name_is_taken(0, "000000"));
        Message long_one = description(System::sender_description, 0, std::string(longest_name, 'x'));
        long_one.payload[3] = 97;
        long_one.payload.insert(long_one.payload.begin() + 5, 'x');
        CHECK_FALSE(names.take(long_one).ok());
    }

    TEST_CASE("a server connects to who asks, and to nobody else") {
        const auto asked = [](std::string text, std::string_view from = "10.0.0.7") {
            return read_request(WireBytes(text.begin(), text.end()), from);
        };
        using namespace std::string_literals;
        CHECK(asked("10.0.0.7 4711\0"s).value().port == 4711);
        CHECK(asked("10.0.0.7 65535\0"s).ok());
        CHECK(asked("10.0.0.8 4711\0"s).error().text().find("from 10.0.0.7 to connect to 10.0.0.8") !=
              std::string::npos);
        for (const std::string& text :
             {""s, "10.0.0.7 4711"s, "10.0.0.7\0"s, "10.0.0.7 \0"s, "10.0.0.7 80\0"s, "10.0.0.7 65536\0"s,
              "10.0.0.7 4711x\0"s, "10.0.0.7 -1\0"s, "10.0.0 4711\0"s, "10.0.0.256 4711\0"s, "localhost 4711\0"s,
              "10..0.7 4711\0"s, " 4711\0"s, std::string(300, '1'), "10.0.0.7 4711"s + std::string(190, ' ') + '\0'}) {
            CHECK_FALSE(asked(text).ok());
        }
    }

    TEST_CASE("spoilt bytes are read or refused, and nothing else happens") {
        Rng random(7);
        const auto pick = [&random](std::size_t below) {
            return static_cast<std::size_t>(random.uniform() * static_cast<double>(below));
        };
        const WireBytes good = [] {
            WireBytes all = framed(posed());
            for (const Message& message : {description(System::type_description, 4, pose_type),
                                           description(System::sender_description, 3, "phaco")}) {
                append_message(message, 0, all);
            }
            return all;
        }();
#ifdef RHEXIS_CHECKS
        constexpr int cases = 20000;
#else
        constexpr int cases = 1000000;
#endif
        int dropped = 0;
        int poses = 0;
        for (int i = 0; i < cases; ++i) {
            WireBytes bytes = good;
            for (std::size_t change = 0; change <= pick(4); ++change) {
                bytes[pick(bytes.size())] = static_cast<std::uint8_t>(pick(256));
            }
            bytes.resize(pick(8) == 0 ? pick(bytes.size()) : bytes.size());
            Stream stream;
            stream.add(bytes);
            std::vector<Message> messages;
            dropped += drain(stream, messages) ? 0 : 1;
            static_cast<void>(read_datagram(bytes));
            static_cast<void>(read_request(bytes, "127.0.0.1"));
            Names names;
            for (const Message& message : messages) {
                static_cast<void>(names.take(message));
                poses += read_pose(message.payload) ? 1 : 0;
                static_cast<void>(read_velocity(message.payload));
                static_cast<void>(read_button(message.payload));
                static_cast<void>(read_buttons(message.payload));
                static_cast<void>(read_analog(message.payload));
                static_cast<void>(read_text(message.payload));
            }
        }
        CHECK(dropped > cases / 100);
        CHECK(poses > cases / 4);
    }
}
