// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <zmq.hpp>

#include "base/clock.hpp"
#include "theatre/link.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

std::string an_address(const char* name) {
    return "ipc://" +
           (std::filesystem::temp_directory_path() / ("rhexis_" + std::to_string(::getpid()) + name)).string();
}

TheatreMoment a_moment(double time_s) {
    TheatreMoment moment;
    moment.exercise = "Demo";
    moment.time_s = time_s;
    moment.steps = {{"One", "done", ""}, {"Two", "now", "Go on."}};
    moment.machine.there = true;
    moment.machine.vacuum_mmhg = 120.0;
    moment.forces = {{"phaco", "Force on the lens.", 3.5}};
    return moment;
}

/// Until a monitor has joined, moments go nowhere.
std::optional<TheatreMoment> first_of(TheatreFeed& feed, TheatreView& view) {
    for (int i = 0; i < 100; ++i) {
        feed.show(a_moment(i));
        if (std::optional<TheatreMoment> moment = view.newest(0.05)) {
            return moment;
        }
    }
    return std::nullopt;
}

std::vector<UserEvent> asked(TheatreFeed& feed) {
    for (int i = 0; i < 100; ++i) {
        if (std::vector<UserEvent> list = feed.requests(); !list.empty()) {
            return list;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return {};
}

}  // namespace

TEST_CASE("a moment goes to every monitor whole, and requests come back") {
    const std::string address = an_address("a");
    Result<std::unique_ptr<TheatreView>> early = TheatreView::open(address);  // before there is a station
    REQUIRE(early.ok());
    CHECK_FALSE(early.value()->newest(0.01).has_value());
    CHECK_FALSE(early.value()->ask({EventKind::staff, "pause"}, 0.05));
    Result<std::unique_ptr<TheatreFeed>> feed = TheatreFeed::open(address);
    REQUIRE(feed.ok());
    Result<std::unique_ptr<TheatreView>> second = TheatreView::open(address);
    REQUIRE(second.ok());
    for (TheatreView* view : {early.value().get(), second.value().get()}) {
        const std::optional<TheatreMoment> moment = first_of(*feed.value(), *view);
        REQUIRE(moment.has_value());
        CHECK(nlohmann::json(*moment) == nlohmann::json(a_moment(moment->time_s)));
    }
    CHECK(second.value()->ask({EventKind::staff, "note", 0.0, 0.0, 0.0, "well \"held\""}, 2.0));
    const std::vector<UserEvent> list = asked(*feed.value());
    REQUIRE(list.size() == 1);
    CHECK(list[0].name == "note");
    CHECK(list[0].control == "well \"held\"");
}

TEST_CASE("a station waits for no monitor, and a slow one sees the newest moment") {
    const std::string address = an_address("b");
    Result<std::unique_ptr<TheatreFeed>> feed = TheatreFeed::open(address);
    REQUIRE(feed.ok());
    Result<std::unique_ptr<TheatreView>> view = TheatreView::open(address);
    REQUIRE(view.ok());
    REQUIRE(first_of(*feed.value(), *view.value()).has_value());
    constexpr int many = 2000;
    for (int i = 0; i < many; ++i) {  // nobody looks meanwhile
        feed.value()->show(a_moment(1000.0 + i));
    }
    std::optional<TheatreMoment> last;
    for (int i = 0; i < 20; ++i) {
        feed.value()->show(a_moment(5000.0 + i));
        if (std::optional<TheatreMoment> moment = view.value()->newest(0.1)) {
            last = std::move(moment);
        }
    }
    REQUIRE(last.has_value());
    CHECK(last->time_s > 4999.0);
    view.value().reset();  // it is closed in the middle
    for (int i = 0; i < many; ++i) {
        feed.value()->show(a_moment(i));
    }
    CHECK(feed.value()->requests().empty());
}

TEST_CASE("what is no moment and no request is left out") {
    const std::string address = an_address("c");
    zmq::context_t context;
    zmq::socket_t stranger(context, zmq::socket_type::pub);
    stranger.bind(address);
    Result<std::unique_ptr<TheatreView>> view = TheatreView::open(address);
    REQUIRE(view.ok());
    for (const std::string text : {R"({"version":99})", "no JSON", R"({"version":1,"steps":7})"}) {
        bool strange = false;
        for (int i = 0; i < 100 && !strange; ++i) {
            stranger.send(zmq::buffer(text), zmq::send_flags::dontwait);
            CHECK_FALSE(view.value()->newest(0.02).has_value());
            strange = view.value()->strange();
        }
        CHECK_MESSAGE(strange, text);
    }
    const std::string other = an_address("d");
    Result<std::unique_ptr<TheatreFeed>> feed = TheatreFeed::open(other);
    REQUIRE(feed.ok());
    zmq::socket_t rude(context, zmq::socket_type::push);
    rude.set(zmq::sockopt::linger, 0);
    rude.connect(other + ".requests");
    for (const std::string text : {"nonsense", R"({"event":"key","name":"E","value":1})",
                                   R"({"event":"staff","value":"x"})", R"({"event":"staff","name":"pause"})"}) {
        rude.send(zmq::buffer(text), zmq::send_flags::none);
    }
    const std::vector<UserEvent> list = asked(*feed.value());
    REQUIRE(list.size() == 1);
    CHECK(list[0].name == "pause");
}

TEST_CASE("what is no address is refused, with what one looks like") {
    for (const char* wrong : {"", "here", "tcp://host", "tcp://host:0", "tcp://host:99999", "ipc://"}) {
        const Result<std::unique_ptr<TheatreFeed>> feed = TheatreFeed::open(wrong);
        REQUIRE_FALSE(feed.ok());
        CHECK(feed.error().text().find("tcp://127.0.0.1:5555") != std::string::npos);
        CHECK_FALSE(TheatreView::open(wrong).ok());
    }
    CHECK_FALSE(TheatreFeed::open("ipc:///nowhere/at/all").ok());
    CHECK(check_theatre(usual_theatre()).ok());
}
