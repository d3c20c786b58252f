// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/prepared_state.hpp"

#include <doctest/doctest.h>

#include "kernel/session/operate.hpp"
#include "session/replay.hpp"
#include "support/folder.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

RecordingHeader header_with_seed(const Session& session) {
    RecordingHeader header = header_of(session);
    header.seed = 1;
    return header;
}

PreparedState state_of(const Session& session) { return {header_with_seed(session), session.copy_state()}; }

bool one_line(const std::string& text) { return !text.empty() && text.find('\n') == std::string::npos; }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Why a session of this scene does not start from the state; "" when it does.
std::string refusal(const SceneDescription& scene, const PreparedState& state) {
    Session session = make_session(scene);
    const std::uint64_t before = session.state_hash();
    const Status status = start_from(session, state);
    if (status) {
        return {};
    }
    CHECK(session.state_hash() == before);
    CHECK(one_line(status.error().text()));
    return status.error().text();
}

}  // namespace

TEST_SUITE("prepared state") {
    TEST_CASE("a run that starts from a state has its tissue, and a clock and counters of its own") {
        const Folder folder;
        Session made = make_session();
        operate(made, 60);
        REQUIRE(made.state().removed_mass > 0.0);
        REQUIRE(write_state(folder / "a.rhxs", state_of(made)).ok());
        const Result<PreparedState> read = read_state(folder / "a.rhxs");
        REQUIRE(read.ok());
        SceneDescription scene = small_scene();
        scene.settings["phaco.power_limit"] = 0.25;
        Session session = make_session(scene);
        REQUIRE(start_from(session, read.value()).ok());
        CHECK(session.state().removed_mass == made.state().removed_mass);
        CHECK(session.state().solids[0].position == made.state().solids[0].position);
        CHECK(made.tools()[0].present);
        CHECK_FALSE(session.tools()[0].present);
        CHECK(session.step_count() == 0);
        CHECK(session.time_s() == 0.0);
        CHECK(session.copy_state().settings.at("phaco.power_limit") == 0.25);
        Session again = make_session(scene);
        REQUIRE(start_from(again, read.value()).ok());
        CHECK(hashes_of(session, 10) == hashes_of(again, 10));
    }

    TEST_CASE("keeping a state changes nothing in the run that it is of") {
        Session watched = make_session();
        Session alone = make_session();
        for (int i = 0; i < 15; ++i) {
            CHECK(watched.copy_state().step == static_cast<std::uint64_t>(i));
            CHECK(hashes_of(watched, 1) == hashes_of(alone, 1));
        }
    }

    TEST_CASE("a state of another scene is refused, and all that differs is named") {
        Session made = make_session();
        operate(made, 3);
        const PreparedState state = state_of(made);
        CHECK(refusal(small_scene(), state).empty());
        SceneDescription other = small_scene();
        other.patient.age = 74.0;
        other.instruments = {"phaco", "probe"};
        const std::string text = refusal(other, state);
        CHECK(holds(text, "patient.age 68 there, 74 here"));
        CHECK(holds(text, "instruments phaco there, phaco + probe here"));
        other = small_scene();
        other.tissues = {"lens", "bag"};
        CHECK(holds(refusal(other, state), "tissues lens + bag + iris + cornea there, lens + bag here"));
        other = small_scene();
        other.settings["zonules.strength"] = 0.5;
        CHECK(holds(refusal(other, state), "zonules.strength 1 there, 0.5 here"));
        other = small_scene();
        other.step_s = 0.005;
        CHECK(holds(refusal(other, state), "step_s 0.01 there, 0.005 here"));
    }

    TEST_CASE("a file that is cut, changed in a byte, of another version or kind is refused in one line") {
        const Folder folder;
        Session made = make_session();
        operate(made, 3);
        const std::string path = folder / "a.rhxs";
        REQUIRE(write_state(path, state_of(made)).ok());
        const std::string bytes = bytes_of(path);
        const std::string bad = folder / "bad.rhxs";
        const auto error_of = [&](const std::string& content) {
            write_bytes(bad, content);
            const Result<PreparedState> read = read_state(bad);
            const std::string text = read ? "" : read.error().text();
            CHECK(one_line(text));
            CHECK(holds(text, bad));
            return text;
        };
        for (std::size_t at = 0; at < bytes.size(); at += at < 200 ? 5 : 4999) {
            CAPTURE(at);
            error_of(bytes.substr(0, at));
            std::string changed = bytes;
            changed[at] = static_cast<char>(changed[at] ^ 0x10);
            error_of(changed);
        }
        CHECK(holds(error_of("rhexis state 99\n....."), "format version 99 (this program reads version"));
        CHECK(holds(error_of("rhexis recording 1\n....."), "this is not a state"));
        CHECK(holds(error_of(bytes + "x"), "something else than this program keeps"));
        CHECK(holds(error_of(""), "the file is empty"));
        CHECK_FALSE(read_state(folder / "nowhere.rhxs").ok());
        CHECK_FALSE(write_state(folder / "no_such_folder/a.rhxs", state_of(made)).ok());
    }

    TEST_CASE("a recording of a run that started from a state carries it: it verifies, and can be entered anywhere") {
        const Folder folder;
        Session made = make_session();
        operate(made, 40);
        const PreparedState state = state_of(made);
        Session session = make_session();
        REQUIRE(start_from(session, state).ok());
        RecordingWriter writer =
            std::move(RecordingWriter::create(folder / "a.rhx", header_with_seed(session))).value();
        REQUIRE(writer.add(session.copy_state()).ok());
        REQUIRE(writer.add(RecordedStart{session.observation(), session.state_hash()}).ok());
        for (int i = 0; i < 12; ++i) {
            const DeviceSample sample = hand_at(session, 0.4 + session.time_s());
            session.step({&sample, 1}, {});
            REQUIRE(
                writer
                    .add(RecordedStep{session.step_count(), {sample}, {}, session.observation(), session.state_hash()})
                    .ok());
        }
        REQUIRE(writer.finish().ok());
        Recording recording = std::move(read_recording(folder / "a.rhx")).value();
        CHECK(recording.whole);
        const auto progress = [](std::uint64_t, std::uint64_t) {};
        CHECK_FALSE(verify(recording, progress).value().divergence.has_value());
        CHECK(session_at(recording, 7).value().state_hash() == recording.steps[6].hash);
        recording.checkpoints.clear();
        CHECK(verify(recording, progress).value().divergence.has_value());
    }
}
