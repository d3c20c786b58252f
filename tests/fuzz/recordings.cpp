// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/recordings.hpp"

#include <fstream>
#include <sstream>

#include "fuzz/mutate.hpp"
#include "session/chunk.hpp"
#include "session/recording.hpp"
#include "session/replay.hpp"
#include "trial/attempt.hpp"

namespace rhexis::fuzz {
namespace {

constexpr std::size_t replayed_steps = 8;
constexpr std::uint64_t replayed_each = 5;  ///< building an eye takes a tenth of a second and more

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Chunk {
    ChunkKind kind;
    std::string payload;
};

/// Spoils what is in the chunks, or their order, and closes them with checksums that are right: what a reader meets
/// that trusts checksums.
std::string mutate_chunks(const std::string& bytes, Random& random) {
    const std::size_t begin = bytes.find('\n') + 1;
    std::vector<Chunk> chunks;
    for (std::size_t at = begin; at < bytes.size();) {
        const ChunkView view = next_chunk(std::string_view(bytes).substr(at));
        if (view.state != ChunkState::whole) {
            break;
        }
        chunks.push_back({view.kind, std::string(view.payload)});
        at += view.size;
    }
    const std::size_t one =
        pick(random, 2) == 0 ? pick(random, std::min<std::size_t>(8, chunks.size())) : pick(random, chunks.size());
    switch (pick(random, 8)) {
        case 0:
            std::swap(chunks[one], chunks[pick(random, chunks.size())]);
            break;
        case 1:
            chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(one));
            break;
        case 2:
            chunks[one].kind = static_cast<ChunkKind>(pick(random, 8));
            break;
        default:
            chunks[one].payload = mutate_bytes(chunks[one].payload, random);
    }
    std::string joined = bytes.substr(0, begin);
    for (const Chunk& chunk : chunks) {
        joined += make_chunk(chunk.kind, chunk.payload);
    }
    return joined;
}

std::string recording_fault(const Error& error) {
    const std::string text = error.text();
    return text.empty() || text.find('\n') != std::string::npos ? "not one line: " + text : "";
}

}  // namespace

Result<std::vector<std::string>> make_recordings(const std::string& root, const std::string& work) {
    std::vector<std::string> recordings;
    for (const char* name : {"groove", "capsulorhexis", "iol_injection"}) {
        AttemptOptions options;
        options.exercise = {name,
                            "random",
                            1,
                            {{"patient.tetrahedra", "500"}, {"capsule.triangles", "200"}, {"implant.triangles", "400"}},
                            root};
        options.folder = work + "/recorded";
        options.drawing = Drawing::none;
        options.limit_s = 0.3;
        options.quiet = true;
        const Result<AttemptResult> made = attempt(options);
        if (!made) {
            return Error{std::string(name) + ": " + made.error().text(), "", ""};
        }
        recordings.push_back(bytes_of(made.value().recording));
    }
    return recordings;
}

Outcome recording_case(const RecordingsPlan& plan, std::uint64_t number) {
    Random random(plan.seed * 1'000'003 + number);
    const std::string& bytes = (*plan.recordings)[pick(random, plan.recordings->size())];
    const std::string path = plan.work + "/case.rhx";
    std::ofstream(path, std::ios::binary)
        << (pick(random, 3) == 0 ? mutate_bytes(bytes, random) : mutate_chunks(bytes, random));
    Result<Recording> recording = read_recording(path);
    if (!recording) {
        return {"refused", 0, recording_fault(recording.error())};
    }
    Recording& read = recording.value();
    if (read.fault.find('\n') != std::string::npos) {
        return {"read", 0, "a fault of several lines: " + read.fault};
    }
    if (number % replayed_each != 0) {
        return {"read", 0, ""};
    }
    read.steps.resize(std::min(read.steps.size(), replayed_steps));
    read.header.scene.threads = 1;
    const Result<Verification> verified = verify(read, [](std::uint64_t, std::uint64_t) {});
    if (!verified) {
        return {"unbuilt", 0, recording_fault(verified.error())};
    }
    return {verified.value().divergence ? "differs" : "same", verified.value().steps, ""};
}

}  // namespace rhexis::fuzz
