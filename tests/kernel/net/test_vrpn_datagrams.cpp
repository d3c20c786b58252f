// SPDX-License-Identifier: GPL-3.0-or-later
// VRPN's datagrams: what goes by them, what is wrong with some of them, and where none comes through.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "base/rng.hpp"
#include "net/vrpn_client.hpp"
#include "net/vrpn_server.hpp"

using namespace rhexis;
using namespace rhexis::vrpn;

namespace {

constexpr std::int64_t begun_us = 1790000000000000;

void a_moment() { std::this_thread::sleep_for(std::chrono::microseconds(300)); }

/// Whoever takes part, turned until something is so, a second of the test's clock at most.
struct Round {
    std::vector<std::function<void(double now_s)>> parts;
    double now_s = 0.0;

    bool until(const std::function<bool()>& so, double step_s = 0.01) {
        for (int i = 0; i < 100 && !so(); ++i) {
            now_s += step_s;
            for (const auto& part : parts) {
                part(now_s);
            }
            a_moment();
        }
        return so();
    }
};

/// A peer written out: TCP and a port for datagrams, none of the classes that are tested.
struct ByHand {
    Socket tcp{};
    Socket datagrams = std::move(Socket::datagrams_at({"127.0.0.1", 0})).value();
    WireBytes unsent = greeting();
    Stream stream{};
    std::size_t greeted = 0;
    std::vector<Message> heard{};
    bool open = true;
    std::uint32_t sequence = 0;

    void turn() {
        WireBytes come;
        open = open && tcp.write(unsent) && tcp.read(come);
        const std::size_t of_greeting = std::min(greeting_bytes - greeted, come.size());
        greeted += of_greeting;
        stream.add(WireSpan(come).subspan(of_greeting));
        for (Result<std::optional<Message>> next = stream.next(); next.ok() && next.value(); next = stream.next()) {
            heard.push_back(*std::move(next).value());
        }
    }
    void say(const Message& message) { append_message(message, sequence++, unsent); }
    void describe(std::string_view sender, const std::vector<std::string_view>& types) {
        say(description(System::sender_description, 0, sender));
        for (std::size_t i = 0; i < types.size(); ++i) {
            say(description(System::type_description, static_cast<std::int32_t>(i), types[i]));
        }
    }
    void announce() {
        Message own;
        own.sender = datagrams.port();
        own.type = -3;
        for (const char c : std::string("127.0.0.1")) {
            own.payload.push_back(static_cast<std::uint8_t>(c));
        }
        own.payload.push_back(0);
        say(own);
    }
    /// Where the peer wants datagrams; 0: it wants none.
    [[nodiscard]] int wanted_at() const {
        for (const Message& message : heard) {
            if (message.type == -3) {
                return message.sender;
            }
        }
        return 0;
    }
    [[nodiscard]] int count(std::int32_t type) const {
        return static_cast<int>(
            std::count_if(heard.begin(), heard.end(), [type](const Message& one) { return one.type == type; }));
    }
};

/// A server written out, that is asked by datagram to connect. Its types: pose 0, pong 1, analog 2.
struct ServerByHand {
    Socket requests = std::move(Socket::datagrams_at({"127.0.0.1", 0})).value();
    std::optional<ByHand> peer{};
    int peers = 0;
    bool describes = true;

    void turn() {
        while (const std::optional<Socket::Datagram> come = requests.receive()) {
            const Result<NetAddress> asked = read_request(come->bytes, come->from.host);
            REQUIRE(asked.ok());
            peer.emplace();
            ++peers;
            peer->tcp = std::move(Socket::connect_to(asked.value())).value();
            peer->announce();
            if (describes) {
                peer->describe("phaco", {pose_type, pong_type, analog_type});
            }
        }
        if (peer) {
            peer->turn();
        }
    }
    [[nodiscard]] ServerPlace place() const { return {{"127.0.0.1", requests.port()}, true}; }
    void send(const WireBytes& bytes) { peer->datagrams.send_to({"127.0.0.1", peer->wanted_at()}, bytes); }
};

WireBytes datagram_of(double x_mm, std::int64_t time_us, std::int32_t type = 0) {
    WireBytes bytes;
    append_message({time_us, 0, type, payload_of(PoseReport{0, Vec3(x_mm, 0.0, 0.0), Quat::Identity()})}, 0, bytes);
    return bytes;
}

std::vector<double> x_of(const std::vector<DeviceReport>& reports) {
    std::vector<double> all;
    for (const DeviceReport& report : reports) {
        if (const auto* pose = std::get_if<PoseReport>(&report.what)) {
            all.push_back(std::round(pose->position.x()));
        }
    }
    return all;
}

Server some_server() { return std::move(Server::open({"127.0.0.1", 0}, {"phaco", "pedal"})).value(); }

}  // namespace

TEST_SUITE("vrpn datagrams") {
    TEST_CASE("what announces a port are these bytes") {
        const Datagrams own = std::move(Datagrams::open("127.0.0.1", "127.0.0.1")).value();
        WireBytes bytes;
        append_message(own.announcement(), 1, bytes);
        const int port = own.announcement().sender;
        const WireBytes wanted{0, 0, 0, 34, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, static_cast<std::uint8_t>(port >> 8),
                               static_cast<std::uint8_t>(port & 255), 255, 255, 255, 253, 0, 0, 0, 1,
                               // 127.0.0.1, a 0, and what fills it up
                               '1', '2', '7', '.', '0', '.', '0', '.', '1', 0, 0, 0, 0, 0, 0, 0};
        CHECK(bytes == wanted);
    }

    TEST_CASE("who announces a port has poses there, as many in one as fit, and all else by TCP") {
        Server server = some_server();
        ByHand client;
        client.tcp = std::move(Socket::connect_to({"127.0.0.1", server.port()})).value();
        client.announce();
        Round round{{[&](double now_s) { server.turn(now_s, begun_us); }, [&](double) { client.turn(); }}};
        REQUIRE(round.until([&] { return client.count(-2) == 8; }));
        CHECK(client.wanted_at() == 0);  // it was not asked by datagram
        REQUIRE_FALSE(round.until([] { return false; }));
        for (int i = 0; i < 17; ++i) {
            server.tell("phaco", pose_type, payload_of(PoseReport{i, Vec3(i, 0.0, 0.0), Quat::Identity()}), begun_us);
        }
        server.tell("phaco", velocity_type, payload_of(VelocityReport{}), begun_us);
        server.tell("phaco", button_type, payload_of(ButtonReport{0, true}), begun_us);
        server.tell("phaco", text_type, payload_of(TextReport{}), begun_us);
        server.keep("pedal", analog_type, analog_payload({2.0}), begun_us);
        std::vector<WireBytes> come;
        REQUIRE(round.until([&] {
            while (std::optional<Socket::Datagram> one = client.datagrams.receive()) {
                come.push_back(std::move(one->bytes));
            }
            return come.size() == 2 && client.count(7) == 1;
        }));
        CHECK(come[0].size() == 16 * 88);
        CHECK(come[1].size() == 88 + 96);
        CHECK(read_datagram(come[0]).value().back().payload[3] == 15);
        CHECK(come[0][88 + 23] == 1);  // counted by this channel
        CHECK(client.count(3) == 0);
        CHECK(client.count(2) == 1);
        CHECK(client.count(5) == 1);
    }

    TEST_CASE("a client that asks by datagram has poses so, one that connects has all by TCP") {
        Server server = some_server();
        for (const bool asks : {true, false}) {
            Client client({{"127.0.0.1", server.port()}, asks}, {"phaco", "pedal"});
            std::vector<DeviceReport> reports;
            Round round{{[&](double now_s) { server.turn(now_s, begun_us); },
                         [&](double now_s) { client.turn(now_s, begun_us, reports); }}};
            REQUIRE(round.until([&] { return client.is_connected() && server.peer_count() == 1; }));
            REQUIRE_FALSE(round.until([] { return false; }));
            server.tell("phaco", pose_type, payload_of(PoseReport{}), begun_us);
            server.tell("pedal", analog_type, analog_payload({1.0}), begun_us);
            REQUIRE(round.until([&] { return reports.size() == 2; }));
            for (const DeviceReport& report : reports) {
                CHECK(report.by_datagram == (asks && report.device == "phaco"));
            }
            CHECK_FALSE(round.until([&] { return !client.is_connected(); }, 0.1));  // 10 s without a pose
            CHECK(client.trouble(round.now_s).empty());
            server = some_server();
        }
    }

    TEST_CASE("lost, doubled, late, of nobody, of somebody else, before it was told what it means: nothing is harmed") {
        ServerByHand server;
        server.describes = false;
        Client client(server.place(), {"phaco"});
        std::vector<DeviceReport> reports;
        Round round{{[&](double) { server.turn(); }, [&](double now_s) { client.turn(now_s, begun_us, reports); }}};
        REQUIRE(round.until([&] { return server.peer && server.peer->wanted_at() != 0; }));
        server.send(datagram_of(1.0, begun_us));
        CHECK_FALSE(round.until([&] { return !reports.empty(); }));
        server.peer->describe("phaco", {pose_type, pong_type, analog_type});
        REQUIRE_FALSE(round.until([&] { return !reports.empty(); }));
        server.send(datagram_of(2.0, begun_us + 1000));
        server.send(datagram_of(4.0, begun_us + 3000));
        server.send(datagram_of(3.0, begun_us + 2000));      // late
        server.send(datagram_of(4.0, begun_us + 3000));      // twice
        server.send({0, 0, 0, 88, 1, 2, 3});                 // broken
        server.send(datagram_of(7.0, begun_us + 7000, 77));  // of a type that was never told
        server.send(datagram_of(8.0, begun_us + 8000, 2));   // an analog with what makes a pose: no such size
        WireBytes name;
        append_message(description(System::sender_description, 0, "chopper"), 0, name);
        server.send(name);  // names come by TCP
        Result<Socket> stranger = Socket::datagrams_at({"127.0.0.2", 0});
        REQUIRE(stranger.ok());
        stranger.value().send_to({"127.0.0.1", server.peer->wanted_at()}, datagram_of(9.0, begun_us + 9000));
        WireBytes two = datagram_of(5.0, begun_us + 4000);
        const WireBytes second = datagram_of(6.0, begun_us + 5000);
        two.insert(two.end(), second.begin(), second.end());
        server.send(two);
        REQUIRE(round.until([&] { return reports.size() >= 4; }, 0.0001));
        CHECK(x_of(reports) == std::vector<double>{2.0, 4.0, 5.0, 6.0});
        CHECK(client.is_connected());
        // a clock that was set back is believed when for 0.2 s nothing else has come
        reports.clear();
        for (int i = 0; i < 40; ++i) {
            server.send(datagram_of(10.0 + i, begun_us - 5000000 + 10000 * i));
            round.now_s += 0.01;
            client.turn(round.now_s, begun_us, reports);
            a_moment();
        }
        REQUIRE_FALSE(reports.empty());
        CHECK(x_of(reports).front() > 25.0);
        CHECK(x_of(reports).back() == 49.0);
    }

    TEST_CASE("spoilt datagrams do nothing") {
        ServerByHand server;
        Client client(server.place(), {"phaco"});
        std::vector<DeviceReport> reports;
        Round round{{[&](double) { server.turn(); }, [&](double now_s) { client.turn(now_s, begun_us, reports); }}};
        REQUIRE(round.until([&] { return server.peer && server.peer->wanted_at() != 0; }));
        Rng random(11);
        const auto pick = [&random](std::size_t below) {
            return static_cast<std::size_t>(random.uniform() * static_cast<double>(below));
        };
        for (int i = 0; i < 20000; ++i) {
            WireBytes bytes = datagram_of(1.0, begun_us);
            const WireBytes more = datagram_of(2.0, begun_us);
            bytes.insert(bytes.end(), more.begin(), more.end());
            for (std::size_t change = 0; change <= pick(4); ++change) {
                bytes[pick(bytes.size())] = static_cast<std::uint8_t>(pick(256));
            }
            bytes.resize(pick(8) == 0 ? pick(bytes.size()) : bytes.size());
            server.send(bytes);
            if (i % 100 == 0) {
                round.now_s += 0.0001;
                client.turn(round.now_s, begun_us, reports);
            }
        }
        CHECK(reports.size() > 10);
        for (const DeviceReport& report : reports) {
            const auto* pose = std::get_if<PoseReport>(&report.what);
            REQUIRE(pose != nullptr);
            CHECK(pose->position.allFinite());
        }
        client.turn(round.now_s, begun_us, reports);
        reports.clear();
        round.now_s += 0.3;  // a spoilt stamp that is ahead holds others back for so long only
        server.send(datagram_of(3.0, begun_us));
        CHECK(round.until([&] { return x_of(reports) == std::vector<double>{3.0}; }));
        CHECK(client.is_connected());
    }

    TEST_CASE("where datagrams do not come through all comes by TCP, and it is said") {
        ServerByHand walled;
        Client client(walled.place(), {"phaco"});
        std::vector<DeviceReport> reports;
        Round round{{[&](double) { walled.turn(); }, [&](double now_s) { client.turn(now_s, begun_us, reports); }}};
        REQUIRE(round.until([&] { return walled.peer && walled.peer->wanted_at() != 0; }));
        std::string said;
        REQUIRE(round.until(
            [&] {
                const std::string trouble = client.trouble(round.now_s);
                said = trouble.find("by TCP") != std::string::npos ? trouble : said;
                return !said.empty();
            },
            0.05));
        CHECK(said ==
              "no pose and no datagram has come for 3 s: all by TCP from now on, as tcp://127.0.0.1 has it from the "
              "start");
        REQUIRE(round.until([&] { return walled.peers == 2 && walled.peer->count(-2) > 0; }));
        CHECK(walled.peer->wanted_at() == 0);
        walled.peer->say({begun_us, 0, 0, payload_of(PoseReport{})});
        CHECK(round.until([&] { return reports.size() == 1; }));
        CHECK_FALSE(round.until([&] { return walled.peers > 2; }, 0.04));
    }

    TEST_CASE("a peer that wants datagrams where nobody may is dropped") {
        Server server = some_server();
        ByHand client;
        client.tcp = std::move(Socket::connect_to({"127.0.0.1", server.port()})).value();
        Message low;
        low.sender = 53;
        low.type = -3;
        client.say(low);
        Round round{{[&](double now_s) { server.turn(now_s, begun_us); }, [&](double) { client.turn(); }}};
        REQUIRE(round.until([&] { return !client.open; }));
        const std::vector<std::string> notes = server.take_notes();
        REQUIRE(notes.size() == 1);
        CHECK(notes[0] == "VRPN: datagrams to port 53 (1024 to 65535)");
    }

    TEST_CASE("a second client that tells as an instrument is heard by nobody, and noted once") {
        Server server = some_server();
        Client client({{"127.0.0.1", server.port()}, true}, {"phaco", "pedal"});
        std::vector<DeviceReport> reports;
        ByHand other;
        other.tcp = std::move(Socket::connect_to({"127.0.0.1", server.port()})).value();
        Round round{{[&](double now_s) { server.turn(now_s, begun_us); },
                     [&](double now_s) { client.turn(now_s, begun_us, reports); }, [&](double) { other.turn(); }}};
        REQUIRE(round.until([&] { return client.is_connected() && other.greeted == greeting_bytes; }));
        other.describe("phaco", {pose_type, analog_type});
        for (int i = 0; i < 50; ++i) {
            other.say({begun_us, 0, 0, payload_of(PoseReport{0, Vec3(40.0, 0.0, 0.0), Quat::Identity()})});
        }
        other.say({begun_us, 0, 1, analog_payload({3.0})});
        REQUIRE_FALSE(round.until([&] { return !reports.empty(); }));
        const std::vector<std::string> notes = server.take_notes();
        REQUIRE(notes.size() == 1);
        CHECK(notes[0] == "it tells 'vrpn_Tracker Pos_Quat' of 'phaco': only the server tells, and it is left out");
        CHECK(other.open);
        CHECK(server.peer_count() == 2);
        server.tell("phaco", pose_type, payload_of(PoseReport{0, Vec3(5.0, 0.0, 0.0), Quat::Identity()}), begun_us);
        CHECK(round.until([&] { return x_of(reports) == std::vector<double>{5.0}; }));
    }
}
