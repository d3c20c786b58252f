// SPDX-License-Identifier: GPL-3.0-or-later
// A VRPN server and its clients in one process, on the loopback: both ways to connect, and peers that do it wrong.
#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "net/vrpn_client.hpp"
#include "net/vrpn_server.hpp"

using namespace rhexis;
using namespace rhexis::vrpn;

namespace {

constexpr std::int64_t some_time_us = 1790000000123456;

Server a_server(int port = 0) {
    Result<Server> server = Server::open({"127.0.0.1", port}, {"phaco", "pedal"});
    REQUIRE(server.ok());
    return std::move(server).value();
}

ServerPlace place_of(const Server& server, bool asks_by_datagram) {
    return {{"127.0.0.1", server.port()}, asks_by_datagram};
}

/// A clock of the test's own, and all that is turned by it.
struct Bench {
    Server* server = nullptr;
    std::vector<Client*> clients;
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
    }
    /// Until it is so; a second of the test's clock at most.
    bool until(const std::function<bool()>& so) {
        for (int i = 0; i < 100 && !so(); ++i) {
            turn();
            std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        return so();
    }
};

/// Sends these bytes as a peer, and says whether the server closes on it within some turns.
bool is_dropped(Bench& bench, const WireBytes& bytes, double then_s = 0.0) {
    Result<Socket> socket = Socket::connect_to({"127.0.0.1", bench.server->port()});
    REQUIRE(socket.ok());
    WireBytes unsent = bytes;
    WireBytes come;
    bool open = true;
    for (int i = 0; i < 20 && open; ++i) {
        bench.turn(i == 10 ? then_s : 0.001);
        open = socket.value().write(unsent) && socket.value().read(come);
        std::this_thread::sleep_for(std::chrono::microseconds(300));
    }
    return !open;
}

WireBytes greeted(WireBytes then) {
    WireBytes bytes = greeting();
    bytes.insert(bytes.end(), then.begin(), then.end());
    return bytes;
}

}  // namespace

TEST_SUITE("vrpn link") {
    TEST_CASE("what the server tells comes to clients of both kinds, as it was told") {
        Server server = a_server();
        Client by_tcp(place_of(server, false), {"phaco", "pedal"});
        Client by_request(place_of(server, true), {"phaco"});
        Bench bench{&server, {&by_tcp, &by_request}};
        REQUIRE(bench.until([&] { return server.peer_count() == 2 && by_request.trouble(0.0).empty(); }));
        const Quat turned(Eigen::AngleAxisd(0.4, Vec3::UnitZ()));
        server.tell("phaco", pose_type, payload_of(PoseReport{2, Vec3(1.25, -3.0, 7.5), turned}), 4200);
        server.tell("pedal", analog_type, analog_payload({0.75}), 4300);
        REQUIRE(bench.until([&] { return bench.reports.size() == 3; }));
        int poses = 0;
        for (const DeviceReport& report : bench.reports) {
            if (const auto* pose = std::get_if<PoseReport>(&report.what)) {
                ++poses;
                CHECK(report.device == "phaco");
                CHECK(report.time_us == 4200);
                CHECK(pose->sensor == 2);
                CHECK((pose->position - Vec3(1.25, -3.0, 7.5)).norm() < 1e-12);
                CHECK(pose->turned.angularDistance(turned) < 1e-7);
            } else {
                CHECK(std::get<std::vector<double>>(report.what) == std::vector<double>{0.75});
                CHECK(report.device == "pedal");
            }
        }
        CHECK(poses == 2);
    }

    TEST_CASE("what is kept is told to who comes later, and again to who asks") {
        Server server = a_server();
        server.keep("pedal", buttons_type, buttons_payload({false, true}), some_time_us);
        Client client(place_of(server, false), {"pedal"});
        Bench bench{&server, {&client}};
        REQUIRE(bench.until([&] { return bench.reports.size() == 2; }));  // when it came, and for its ping
        for (const DeviceReport& report : bench.reports) {
            CHECK(std::get<std::vector<bool>>(report.what) == std::vector<bool>{false, true});
        }
    }

    TEST_CASE("a server from which nothing comes any more is given up; one that only has nothing to tell is not") {
        for (const bool answers : {true, false}) {
            Server server = a_server();
            Client client(place_of(server, false), {"phaco", "pedal"});
            Bench bench{&server, {&client}};
            REQUIRE(bench.until([&] { return client.is_connected(); }));
            for (int i = 0; i < 50; ++i) {
                bench.turn();
                std::this_thread::sleep_for(std::chrono::microseconds(300));
            }
            bench.server = answers ? &server : nullptr;
            bool lost = false;
            for (int i = 0; i < 100; ++i) {
                bench.turn(0.1);
                lost = lost || client.trouble(bench.now_s) == "nothing has come for 5 s";
                std::this_thread::sleep_for(std::chrono::microseconds(500));
            }
            CHECK(lost == !answers);
        }
    }

    TEST_CASE("a server that goes and comes again is found again") {
        std::optional<Server> server(a_server());
        const int port = server->port();
        for (const bool asks : {false, true}) {
            Client client(place_of(*server, asks), {"phaco"});
            Bench bench{&*server, {&client}};
            CHECK(client.trouble(0.0) == "no VRPN server has answered yet");
            REQUIRE(bench.until([&] { return client.is_connected(); }));
            bench.server = nullptr;
            server.reset();
            REQUIRE(bench.until([&] { return !client.is_connected(); }));
            CHECK(client.trouble(bench.now_s) == "it has closed the connection");
            server.emplace(a_server(port));
            bench.server = &*server;
            bench.turn(2.1);
            CHECK(bench.until([&] { return client.is_connected(); }));
            CHECK(client.trouble(bench.now_s).empty());
        }
    }

    TEST_CASE("a server that tells what cannot be is left, and tried again after a while only") {
        Server server = a_server();
        Client client(place_of(server, false), {"phaco"});
        Bench bench{&server, {&client}};
        REQUIRE(bench.until([&] { return client.trouble(0.0).empty(); }));
        bench.turn(5.0);
        server.tell("phaco", pose_type, {1, 2, 3}, some_time_us);
        REQUIRE(bench.until([&] { return !client.is_connected(); }));
        CHECK(client.trouble(bench.now_s) == "VRPN: a pose of 3 bytes (64)");
        CHECK_FALSE(bench.until([&] { return client.is_connected(); }));
        bench.turn(1.1);
        CHECK(bench.until([&] { return client.is_connected(); }));
        CHECK(bench.reports.empty());
    }

    TEST_CASE("a device that the server has not is told after three seconds") {
        Server server = a_server();
        Client client(place_of(server, false), {"phaco", "forceps"});
        Bench bench{&server, {&client}};
        REQUIRE(bench.until([&] { return client.is_connected(); }));
        bench.until([] { return false; });
        CHECK(client.trouble(bench.now_s).empty());
        bench.turn(3.1);
        CHECK(client.trouble(bench.now_s) == "the server has no 'forceps', or it does not answer");
    }

    TEST_CASE("peers that do it wrong are dropped, and the others hear on") {
        Server server = a_server();
        Client client(place_of(server, false), {"phaco"});
        Bench bench{&server, {&client}};
        REQUIRE(bench.until([&] { return client.is_connected(); }));
        const auto text = [](std::string_view words) { return WireBytes(words.begin(), words.end()); };
        CHECK(is_dropped(bench, text("GET / HTTP/1.1\r\nHost: somewhere\r\n\r\n")));
        CHECK(is_dropped(bench, text("vrpn: ver. 06.38  0\0\0\0\0\0")) == false);  // 19 bytes: more may come
        CHECK(is_dropped(bench, {'v'}, 3.1));                                      // and after 3 s not any more
        CHECK_FALSE(is_dropped(bench, greeted({0, 0, 0, 88})));                    // half a header
        CHECK(is_dropped(bench, greeted(WireBytes(24, 0))));                       // a message of no length
        Message unknown;
        unknown.sender = 77;
        unknown.type = 1234;
        WireBytes framed;
        append_message(unknown, 0, framed);
        CHECK_FALSE(is_dropped(bench, greeted(framed)));
        framed.clear();
        Message name = description(System::sender_description, 0, "x");
        name.sender = 2000;
        append_message(name, 0, framed);
        CHECK(is_dropped(bench, greeted(framed)));
        CHECK(client.is_connected());
        CHECK(server.take_notes().size() >= 4);
        bench.reports.clear();
        server.tell("phaco", pose_type, payload_of(PoseReport{}), some_time_us);
        CHECK(bench.until([&] { return bench.reports.size() == 1; }));
    }

    TEST_CASE("who does not read is dropped, and holds nobody up") {
        Server server = a_server();
        Client client(place_of(server, false), {"phaco"});
        Bench bench{&server, {&client}};
        Result<Socket> deaf = Socket::connect_to({"127.0.0.1", server.port()});
        WireBytes unsent = greeting();
        REQUIRE(bench.until(
            [&] { return deaf.value().write(unsent) && client.is_connected() && server.peer_count() == 2; }));
        std::size_t told = 0;
        for (; told < 300000 && server.peer_count() == 2; ++told) {
            server.tell("phaco", pose_type, payload_of(PoseReport{}), some_time_us);
            if (told % 100 == 0) {
                bench.turn(0.0);
            }
        }
        CHECK(server.peer_count() == 1);
        CHECK(client.is_connected());
        CHECK(bench.until([&] { return bench.reports.size() == told; }));
    }

    TEST_CASE("requests by datagram: the same one thrice is one connection, a broken or a stranger's one is none") {
        Server server = a_server();
        Result<Socket> listener = Socket::listen_at({"127.0.0.1", 0});
        Result<Socket> datagrams = Socket::datagrams_at({"127.0.0.1", 0});
        REQUIRE(listener.ok());
        Bench bench{&server, {}};
        const NetAddress to{"127.0.0.1", server.port()};
        for (int i = 0; i < 3; ++i) {
            datagrams.value().send_to(to, request_datagram({"127.0.0.1", listener.value().port()}));
        }
        datagrams.value().send_to(to, request_datagram({"10.0.0.1", 4711}));
        datagrams.value().send_to(to, WireBytes{1, 2, 3});
        std::vector<Socket> come;
        bench.until([&] {
            while (std::optional<Socket> one = listener.value().accept()) {
                come.push_back(std::move(*one));
            }
            return false;
        });
        CHECK(come.size() == 1);
        CHECK(server.take_notes().size() == 2);
    }

    TEST_CASE("addresses that are none, ports that others have, names that are too long") {
        CHECK(server_place("localhost").value().address.port == 3883);
        CHECK(server_place("10.0.0.7:4000").value().asks_by_datagram);
        CHECK(server_place("tcp://10.0.0.7:4000").value().address.host == "10.0.0.7");
        CHECK_FALSE(server_place("tcp://10.0.0.7").value().asks_by_datagram);
        for (const char* text : {"", "tracker", "10.0.0", "10.0.0.7:", "10.0.0.7:0", "10.0.0.7:70000", "10.0.0.7:4x",
                                 "udp://10.0.0.7", "10.0.0.7.8"}) {
            CHECK_FALSE(server_place(text).ok());
        }
        const Server server = a_server();
        CHECK(Server::open({"127.0.0.1", server.port()}, {}).error().text().find("in use") != std::string::npos);
        CHECK_FALSE(Server::open({"nowhere", 0}, {}).ok());
        CHECK_FALSE(Server::open({"127.0.0.1", 0}, {std::string(96, 'x')}).ok());
    }
}
