// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenIGTLink server and its clients in one process, on the loopback, and peers that do it wrong.
#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "net/igtl_client.hpp"
#include "net/igtl_server.hpp"

using namespace rhexis;

namespace {

using rhexis::igtlink::bytes_of;
using rhexis::igtlink::Client;
using rhexis::igtlink::DeviceStatus;
using rhexis::igtlink::Message;
using rhexis::igtlink::Server;
using rhexis::igtlink::StartTracking;
using rhexis::igtlink::StatusRequest;
using rhexis::igtlink::StopTracking;
using rhexis::igtlink::Stream;
using rhexis::igtlink::Tool;

constexpr std::int64_t some_time_us = 1790000000123456;

Server a_server(int port = 0) {
    Result<Server> server = Server::open({"127.0.0.1", port}, "tracker");
    REQUIRE(server.ok());
    return std::move(server).value();
}

std::vector<Tool> some_tools(double x = 1.25) {
    const Quat turned(Eigen::AngleAxisd(0.4, Vec3::UnitZ()));
    return {{"phaco", {Vec3(x, -3.0, 7.5), turned}}, {"chopper", {Vec3::Zero(), Quat::Identity()}}};
}

/// A peer written by hand.
struct Raw {
    Socket socket;
    WireBytes unsent{};
    Stream stream{};
    std::vector<Message> heard{};
    bool open = true;

    explicit Raw(const Server& server) : socket(std::move(Socket::connect_to({"127.0.0.1", server.port()})).value()) {}
    void turn() {
        WireBytes come;
        open = open && socket.write(unsent) && socket.read(come);
        stream.add(come);
        for (Result<std::optional<Message>> next = stream.next(); next.ok() && next.value(); next = stream.next()) {
            heard.push_back(*std::move(next).value());
        }
    }
    template <typename Content>
    [[nodiscard]] int count() const {
        int found = 0;
        for (const Message& message : heard) {
            found += std::holds_alternative<Content>(message.content) ? 1 : 0;
        }
        return found;
    }
    template <typename Content>
    void say(const Content& content) {
        const WireBytes bytes = bytes_of({"somebody", some_time_us, content});
        unsent.insert(unsent.end(), bytes.begin(), bytes.end());
    }
};

/// A clock of the test's own, and all that is turned by it.
struct Bench {
    Server* server = nullptr;
    std::vector<Client*> clients{};
    std::vector<Raw*> raws{};
    std::vector<DeviceReport> reports{};  ///< of all clients
    double now_s = 0.0;

    void turn(double by_s = 0.01) {
        now_s += by_s;
        if (server != nullptr) {
            server->turn(now_s, some_time_us);
        }
        for (Client* client : clients) {
            client->turn(now_s, some_time_us, reports);
        }
        for (Raw* raw : raws) {
            raw->turn();
        }
    }
    /// Until it is so; a second of the test's clock at most.
    bool until(const std::function<bool()>& so) {
        for (int i = 0; i < 100 && !so(); ++i) {
            turn();
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        return so();
    }
    void settle(int turns = 10) {
        for (int i = 0; i < turns; ++i) {
            turn(0.001);
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
    }
    [[nodiscard]] int poses() const {
        int found = 0;
        for (const DeviceReport& report : reports) {
            found += std::holds_alternative<PoseReport>(report.what) ? 1 : 0;
        }
        return found;
    }
};

/// Connects, and its wish has come: the server's status and its reply have been heard.
void join(Bench& bench) {
    const std::size_t there = bench.clients.size() + bench.raws.size();
    REQUIRE(bench.until([&] { return bench.server->peer_count() == there; }));
    bench.settle();
}

/// Sends these bytes as a peer, and says whether the server closes on it within some turns.
bool is_dropped(Bench& bench, const WireBytes& bytes, double then_s = 0.0) {
    Raw raw(*bench.server);
    raw.unsent = bytes;
    for (int i = 0; i < 20 && raw.open; ++i) {
        bench.turn(i == 10 ? then_s : 0.001);
        raw.turn();
        std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    return !raw.open;
}

}  // namespace

TEST_SUITE("igtl link") {
    TEST_CASE("what the server tells comes to clients as it was told") {
        Server server = a_server();
        Client client({"127.0.0.1", server.port()});
        Client another({"127.0.0.1", server.port()});
        Bench bench{&server, {&client, &another}};
        join(bench);
        CHECK(client.trouble(bench.now_s).empty());
        bench.reports.clear();
        server.tell(some_tools(), bench.now_s, 4200);
        REQUIRE(bench.until([&] { return bench.poses() == 4; }));
        for (const DeviceReport& report : bench.reports) {
            const auto& pose = std::get<PoseReport>(report.what);
            CHECK(report.time_us == 4200);
            CHECK(pose.sensor == 0);
            if (report.device == "phaco") {
                CHECK(pose.position == Vec3(1.25, -3.0, 7.5));
                CHECK(pose.turned.angularDistance(some_tools()[0].pose.orientation) < 1e-6);
            } else {
                CHECK(report.device == "chopper");
            }
        }
    }

    TEST_CASE("tracking data come at most as often as was asked, and not after a stop") {
        Server server = a_server();
        Client each_time({"127.0.0.1", server.port()});
        Client at_20_hz({"127.0.0.1", server.port()}, 50);
        Bench fast{&server, {&each_time}};
        join(fast);
        Bench slow{&server, {&at_20_hz}};
        slow.now_s = fast.now_s;
        REQUIRE(slow.until([&] { return server.peer_count() == 2; }));
        slow.settle();
        for (int i = 0; i < 100; ++i) {  // a second, at 100 Hz
            slow.turn();
            server.tell({some_tools()[0]}, slow.now_s, some_time_us);
        }
        slow.settle();
        CHECK(slow.poses() <= 21);
        CHECK(slow.poses() >= 16);
        fast.reports.clear();
        fast.server = nullptr;
        CHECK(fast.until([&] { return fast.poses() == 100; }));
        Raw stops(server);
        slow.raws = {&stops};
        stops.say(StartTracking{0, ""});
        slow.settle();
        CHECK(stops.count<rhexis::igtlink::StartReply>() == 1);
        server.tell(some_tools(), slow.now_s, some_time_us);
        slow.settle();
        CHECK(stops.count<rhexis::igtlink::TrackingData>() == 1);
        stops.say(StopTracking{});
        slow.settle();
        server.tell(some_tools(), slow.now_s, some_time_us);
        slow.settle();
        CHECK(stops.count<rhexis::igtlink::TrackingData>() == 1);
        CHECK(stops.count<rhexis::igtlink::Transform>() == 0);
    }

    TEST_CASE("who asks for nothing is told a transform of each tool") {
        Server server = a_server();
        Raw viewer(server);
        Bench bench{&server, {}, {&viewer}};
        join(bench);
        server.tell(some_tools(), bench.now_s, some_time_us);
        REQUIRE(bench.until([&] { return viewer.count<rhexis::igtlink::Transform>() == 2; }));
        CHECK(viewer.heard[viewer.heard.size() - 2].device == "phaco");
        CHECK(viewer.heard.back().device == "chopper");
        CHECK(viewer.count<rhexis::igtlink::TrackingData>() == 0);
    }

    TEST_CASE("the status comes at once, on request and when it changes, and else not") {
        Server server = a_server();
        Raw viewer(server);
        Bench bench{&server, {}, {&viewer}};
        join(bench);
        CHECK(viewer.count<DeviceStatus>() == 1);
        server.tell_status(DeviceStatus{}, some_time_us);  // as it was
        bench.settle();
        CHECK(viewer.count<DeviceStatus>() == 1);
        const DeviceStatus gone{16, 0, "hidden", "chopper is not seen"};
        server.tell_status(gone, some_time_us);
        bench.settle();
        REQUIRE(viewer.count<DeviceStatus>() == 2);
        CHECK(std::get<DeviceStatus>(viewer.heard.back().content) == gone);
        viewer.say(StatusRequest{});
        bench.settle();
        CHECK(viewer.count<DeviceStatus>() == 3);
        Client client({"127.0.0.1", server.port()});
        bench.clients = {&client};
        REQUIRE(bench.until([&] { return !bench.reports.empty(); }));
        const auto& text = std::get<TextReport>(bench.reports[0].what);
        CHECK(bench.reports[0].device == "tracker");
        CHECK(text.severity == Severity::error);
        CHECK(text.level == 16);
        CHECK(text.text == "chopper is not seen");
    }

    TEST_CASE("a server that goes and comes again is found again") {
        std::optional<Server> server(a_server());
        const int port = server->port();
        Client client({"127.0.0.1", port});
        Bench bench{&*server, {&client}};
        CHECK(client.trouble(0.0) == "no OpenIGTLink server has answered yet");
        REQUIRE(bench.until([&] { return client.is_connected(); }));
        bench.server = nullptr;
        server.reset();
        REQUIRE(bench.until([&] { return !client.is_connected(); }));
        CHECK(client.trouble(bench.now_s) == "it has closed the connection");
        server.emplace(a_server(port));
        bench.server = &*server;
        CHECK_FALSE(bench.until([&] { return client.is_connected(); }));  // not before two seconds
        bench.turn(1.1);
        CHECK(bench.until([&] { return client.is_connected(); }));
        CHECK(client.trouble(bench.now_s).empty());
    }

    TEST_CASE("a server that tells no pose is told after three seconds, one that tells nonsense is left") {
        Result<Socket> listener = Socket::listen_at({"127.0.0.1", 0});
        Client client({"127.0.0.1", listener.value().port()});
        Bench bench{nullptr, {&client}};
        std::optional<Socket> server;
        REQUIRE(bench.until([&] {
            server = server ? std::move(server) : listener.value().accept();
            return server && client.is_connected();
        }));
        CHECK(client.trouble(bench.now_s).empty());
        bench.turn(3.1);
        CHECK(client.trouble(bench.now_s) == "the server tells no pose");
        WireBytes reply = bytes_of({"x", some_time_us, rhexis::igtlink::StartReply{false}});
        server->write(reply);
        CHECK(bench.until([&] { return client.trouble(bench.now_s) == "the server refuses to tell where tools are"; }));
        WireBytes nonsense(58, 'x');
        server->write(nonsense);
        CHECK(bench.until([&] { return !client.is_connected(); }));
        CHECK(client.trouble(bench.now_s) == "OpenIGTLink: a header of version 30840 (1 or 2)");
        CHECK(bench.reports.empty());
    }

    TEST_CASE("peers that do it wrong are dropped, and the others hear on") {
        Server server = a_server();
        Client client({"127.0.0.1", server.port()});
        Bench bench{&server, {&client}};
        join(bench);
        const WireBytes pose = bytes_of({"x", some_time_us, rhexis::igtlink::Transform{}});
        WireBytes other_crc = pose;
        other_crc.back() ^= 1;
        WireBytes large = pose;
        large[45] = 1;
        CHECK_FALSE(is_dropped(bench, {}, 10.0));  // who only listens
        CHECK_FALSE(is_dropped(bench, pose, 10.0));
        CHECK(is_dropped(bench, other_crc));
        CHECK(is_dropped(bench, large));
        CHECK_FALSE(is_dropped(bench, WireBytes(pose.begin(), pose.begin() + 29)));  // half a header
        CHECK(is_dropped(bench, WireBytes(pose.begin(), pose.begin() + 29), 3.1));   // and silence
        CHECK(is_dropped(bench, WireBytes(pose.begin(), pose.end() - 1), 3.1));      // half a body
        std::string asked = "GET / HTTP/1.1\r\nHost: somewhere\r\nAccept: text/html, text/plain\r\n\r\n";
        CHECK(is_dropped(bench, WireBytes(asked.begin(), asked.end())));
        CHECK(client.is_connected());
        CHECK(server.take_notes().size() >= 5);
        bench.reports.clear();
        server.tell(some_tools(), bench.now_s, some_time_us);
        CHECK(bench.until([&] { return bench.poses() == 2; }));
    }

    TEST_CASE("a second client that tells where tools are is heard by nobody, and noted once") {
        Server server = a_server();
        Client client(NetAddress{"127.0.0.1", server.port()});
        Raw other(server);
        Bench bench{&server, {&client}, {&other}};
        join(bench);
        for (int i = 0; i < 20; ++i) {
            other.say(rhexis::igtlink::Transform{{Vec3(40.0, 0.0, 0.0), Quat::Identity()}});
            other.say(rhexis::igtlink::TrackingData{some_tools(40.0)});
        }
        bench.settle(30);
        CHECK(bench.poses() == 0);
        CHECK(other.open);
        const std::vector<std::string> notes = server.take_notes();
        REQUIRE(notes.size() == 1);
        CHECK(notes[0] == "it tells where 'somebody' is: only the server tells, and it is left out");
        server.tell(some_tools(), bench.now_s, some_time_us);
        CHECK(bench.until([&] { return bench.poses() == 2; }));
        CHECK(other.open);
    }

    TEST_CASE("of two clients one stalls: it is dropped, and the other hears all") {
        Server server = a_server();
        Client client({"127.0.0.1", server.port()});
        Raw deaf(server);
        deaf.say(StartTracking{0, ""});
        Bench bench{&server, {&client}, {&deaf}};
        join(bench);
        bench.raws.clear();
        bench.reports.clear();
        int told = 0;
        for (; told < 200000 && server.peer_count() == 2; ++told) {
            server.tell({some_tools()[0]}, bench.now_s, some_time_us);
            if (told % 100 == 0) {
                bench.turn(0.0);
            }
        }
        CHECK(server.peer_count() == 1);
        CHECK(client.is_connected());
        CHECK(bench.until([&] { return bench.poses() == told; }));
    }

    TEST_CASE("addresses that are none, ports that others have, names that are too long") {
        CHECK(rhexis::igtlink::server_address("localhost").value().port == 18944);
        CHECK(rhexis::igtlink::server_address("10.0.0.7:4000").value() == NetAddress{"10.0.0.7", 4000});
        for (const char* text : {"", "tracker", "10.0.0", "10.0.0.7:", "10.0.0.7:0", "10.0.0.7:4x", "tcp://10.0.0.7"}) {
            CHECK_FALSE(rhexis::igtlink::server_address(text).ok());
        }
        const Server server = a_server();
        CHECK(Server::open({"127.0.0.1", server.port()}, "x").error().text().find("in use") != std::string::npos);
        CHECK_FALSE(Server::open({"nowhere", 0}, "x").ok());
        CHECK_FALSE(Server::open({"127.0.0.1", 0}, "").ok());
        CHECK_FALSE(Server::open({"127.0.0.1", 0}, std::string(21, 'x')).ok());
        CHECK(Server::open({"127.0.0.1", 0}, std::string(20, 'x')).ok());
    }
}
