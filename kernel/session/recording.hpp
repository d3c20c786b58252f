// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings (.rhx): what happened in a session, step by step, so that it can be watched, judged and simulated again.
//
// A file is its first line (session/chunk.hpp), then chunks:
//   u32 kind, u32 size, the payload, u64 XXH3 of all before it in the chunk.
// Kinds: header, start, step, checkpoint, end. A checkpoint before the start is the state that the run began from;
// without one it began at rest. The file is written chunk by chunk to NAME.part and renamed when it ends; cut short
// anywhere, either file is readable to its last whole step.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/command.hpp"
#include "flow/device_sample.hpp"
#include "flow/observation.hpp"
#include "flow/scene.hpp"
#include "session/session.hpp"

namespace rhexis {

/// Simulated time between checkpoints [s].
inline constexpr double checkpoint_interval_s = 5.0;

struct RecordingHeader {
    SceneDescription scene;
    std::uint64_t seed = 0;
    std::string curriculum;  ///< what was asked for on the command line
    std::string identity;    ///< JSON: id, title, version, sha256
    std::string surgeon = "none";
    std::map<std::string, std::string> set;  ///< --set key=value
    std::string build;                       ///< program and BLAS core that made it, see build_note()
    ObservationSchema schema;
};

/// Before the first step.
struct RecordedStart {
    Observation observation;
    std::uint64_t hash = 0;
};

struct RecordedStep {
    std::uint64_t step = 0;  ///< from 1
    std::vector<DeviceSample> samples;
    std::vector<Command> commands;
    Observation observation;
    std::uint64_t hash = 0;
};

/// What a session says of itself: scene, schema and build. The rest is the caller's to fill in.
RecordingHeader header_of(const Session& session);

/// Program version and the BLAS core on which an implicit step's bits may depend.
std::string build_note();

class RecordingWriter {
public:
    /// Opens path.part. Fails when the folder cannot be written.
    static Result<RecordingWriter> create(const std::string& path, const RecordingHeader& header);
    ~RecordingWriter();
    RecordingWriter(RecordingWriter&&) noexcept;
    RecordingWriter& operator=(RecordingWriter&&) noexcept;

    // Each fails when the disk is full or gone; what was written before stays readable.
    Status add(const RecordedStart& start);
    Status add(const RecordedStep& step);
    Status add(const Snapshot& checkpoint);
    /// Writes the end and renames path.part to path.
    Status finish();

    /// Where the bytes are now: path.part, and path after finish.
    [[nodiscard]] const std::string& file() const;

private:
    struct Parts;
    explicit RecordingWriter(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

/// A recording as far as it can be read.
struct Recording {
    RecordingHeader header;
    RecordedStart start;
    std::vector<RecordedStep> steps;
    std::vector<Snapshot> checkpoints;  ///< ascending
    bool whole = false;                 ///< it has its end
    std::string fault;                  ///< one line: where and how it is cut or damaged; empty when whole
};

/// Fails on a file that is no recording, of another version, or cut or damaged before its first step.
Result<Recording> read_recording(const std::string& path);

}  // namespace rhexis
