// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "base/rng.hpp"
#include "kernel/session/operate.hpp"
#include "session/replay.hpp"
#include "support/folder.hpp"

using namespace rhexis;
using namespace rhexis::test;
namespace fs = std::filesystem;

namespace {

bool one_line(const std::string& text) { return !text.empty() && text.find('\n') == std::string::npos; }

void no_progress(std::uint64_t, std::uint64_t) {}

}  // namespace

TEST_SUITE("recording") {
    TEST_CASE("a recording reads back as it was written and simulates to the same hashes") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 30, 10);
        CHECK_FALSE(fs::exists(path + ".part"));
        Result<Recording> read = read_recording(path);
        REQUIRE(read.ok());
        Recording& recording = read.value();
        CHECK(recording.whole);
        CHECK(recording.fault.empty());
        CHECK(recording.steps.size() == 30);
        CHECK(recording.checkpoints.size() == 3);
        CHECK(recording.header.scene.instruments == std::vector<std::string>{"phaco"});
        CHECK(recording.header.identity == R"({"id":"test"})");
        CHECK(recording.steps[4].commands[0].value == 0.8);
        for (const int threads : {1, 2}) {
            recording.header.scene.threads = threads;
            recording.header.scene.instruction_set = threads == 2 ? "baseline" : "";
            const Result<Verification> verification = verify(recording, no_progress);
            REQUIRE(verification.ok());
            CHECK(verification.value().steps == 30);
            CHECK_FALSE(verification.value().divergence.has_value());
        }
    }

    TEST_CASE("verify names the first step that ends differently") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 20, 10);
        Recording recording = std::move(read_recording(path)).value();
        recording.steps[11].samples[0].pose.position.z() -= 1e-9;
        const Result<Verification> verification = verify(recording, no_progress);
        REQUIRE(verification.ok());
        REQUIRE(verification.value().divergence.has_value());
        CHECK(verification.value().divergence->step == 12);
        CHECK(verification.value().steps == 20);
    }

    TEST_CASE("scrubbing to any step through a checkpoint gives the recorded state") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 30, 10);
        const Recording recording = std::move(read_recording(path)).value();
        for (const std::uint64_t step : {1, 9, 10, 11, 25, 30}) {
            Result<Session> session = session_at(recording, step);
            REQUIRE(session.ok());
            CHECK(session.value().state_hash() == recording.steps[step - 1].hash);
        }
        CHECK(session_at(recording, 0).value().state_hash() == recording.start.hash);
        CHECK_FALSE(session_at(recording, 31).ok());
    }

    TEST_CASE("a recording cut at any byte is read to its last whole step or refused in one line") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 12, 5);
        const std::string bytes = bytes_of(path);
        const std::string cut = folder / "cut.rhx";
        std::size_t most_steps = 0;
        std::vector<std::size_t> sizes;
        for (std::size_t size = 0; size < bytes.size(); size += size < 400 ? 7 : 977) {
            sizes.push_back(size);
        }
        sizes.push_back(bytes.size() - 1);
        for (const std::size_t size : sizes) {
            write_bytes(cut, bytes.substr(0, size));
            const Result<Recording> read = read_recording(cut);
            if (!read) {
                CHECK(one_line(read.error().text()));
                CHECK(most_steps == 0);
                continue;
            }
            CHECK_FALSE(read.value().whole);
            CHECK(one_line(read.value().fault));
            CHECK(read.value().steps.size() >= most_steps);
            most_steps = read.value().steps.size();
        }
        CHECK(most_steps == 12);
    }

    TEST_CASE("a damaged byte anywhere is noticed and never crashes the reader") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 8, 5);
        const std::string bytes = bytes_of(path);
        const std::string damaged = folder / "damaged.rhx";
        Rng rng(5, "damage");
        for (int trial = 0; trial < 300; ++trial) {
            const std::int64_t range = trial % 2 == 0 ? 300 : static_cast<std::int64_t>(bytes.size());
            const std::size_t at = static_cast<std::size_t>(rng.integer(0, range - 1));
            std::string changed = bytes;
            changed[at] = static_cast<char>(changed[at] ^ static_cast<char>(rng.integer(1, 127)));
            write_bytes(damaged, changed);
            const Result<Recording> read = read_recording(damaged);
            if (read) {
                CHECK_FALSE(read.value().whole);
                CHECK(one_line(read.value().fault));
            } else {
                CHECK(one_line(read.error().text()));
            }
        }
    }

    TEST_CASE("foreign files, folders and other versions are refused in one line that says what is wrong") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        CHECK(read_recording(path).error().text().find("cannot read: No such file") != std::string::npos);
        write_bytes(path, "\x89PNG\r\n\x1a\n and so on, long enough to be something");
        CHECK(read_recording(path).error().text().find("this is not a recording") != std::string::npos);
        write_bytes(path, "rhexis recording 99\nwhatever");
        CHECK(read_recording(path).error().text().find("format version 99 (this program reads version 14)") !=
              std::string::npos);
        write_bytes(path, "");
        CHECK(read_recording(path).error().text().find("the file is empty") != std::string::npos);
        CHECK_FALSE(read_recording(folder / ".").ok());
    }

    TEST_CASE("a recording that never ended lies under its .part name and can be read") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        record(path, 12, 5, false);
        CHECK_FALSE(fs::exists(path));
        const Result<Recording> read = read_recording(path + ".part");
        REQUIRE(read.ok());
        CHECK_FALSE(read.value().whole);
        CHECK(read.value().steps.size() == 12);
        CHECK(read.value().fault.find("after step 12") != std::string::npos);
    }

    TEST_CASE("few bytes too are in the file within a second, where a killed process leaves them") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        Session session = make_session();
        RecordingHeader header = header_of(session);
        Result<RecordingWriter> writer = RecordingWriter::create(path, header);
        REQUIRE(writer.ok());
        REQUIRE(writer.value().add(RecordedStart{session.observation(), session.state_hash()}).ok());
        for (int i = 0; i < 3; ++i) {
            session.step({}, {});
            REQUIRE(writer.value()
                        .add(RecordedStep{session.step_count(), {}, {}, session.observation(), session.state_hash()})
                        .ok());
            std::this_thread::sleep_for(std::chrono::milliseconds(950));
        }
        CHECK(read_recording(path + ".part").value().steps.size() >= 2);
    }

    TEST_CASE("a folder that is not there is an error before anything is simulated") {
        const Folder folder;
        const RecordingHeader header;
        const Result<RecordingWriter> writer = RecordingWriter::create(folder / "nowhere/recording.rhx", header);
        REQUIRE_FALSE(writer.ok());
        CHECK(writer.error().text().find("there is no folder ") != std::string::npos);
    }

    TEST_CASE("a full disk is reported and what was written stays readable") {
        const Folder folder;
        const std::string path = folder / "recording.rhx";
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{100000, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        std::string message;
        try {
            record(path, 200, 5);
        } catch (const std::runtime_error& error) {
            message = error.what();
        }
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        CHECK(message.find("recording.rhx.part: cannot write: ") != std::string::npos);
        CHECK_FALSE(fs::exists(path));
        const Result<Recording> read = read_recording(path + ".part");
        REQUIRE(read.ok());
        CHECK(read.value().steps.size() > 0);
    }
}
