// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "session/chunk.hpp"
#include "session/codec.hpp"

namespace rhexis {
namespace {

Result<std::string> file_bytes(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return Error{std::string("cannot read: ") + std::strerror(errno), path, ""};
    }
    std::ostringstream content;
    if (!(content << stream.rdbuf()) && stream.bad()) {
        return Error{"cannot read it", path, "a recording (.rhx)"};
    }
    return std::move(content).str();
}

/// Takes chunks into a recording as long as they follow each other as they must.
class Assembler {
public:
    /// False: the chunk does not belong here.
    bool take(const ChunkView& chunk) {
        switch (chunk.kind) {
            case ChunkKind::header:
                return !header_ && take_header(chunk.payload);
            case ChunkKind::start:
                return header_ && !start_ && take_start(chunk.payload);
            case ChunkKind::step:
                return start_ && take_step(chunk.payload);
            case ChunkKind::checkpoint:
                return header_ && take_checkpoint(chunk.payload);  // before the start: what it began from
            case ChunkKind::end:
                recording.whole = start_;
                return start_;
        }
        return false;
    }

    [[nodiscard]] bool started() const { return start_; }
    Recording recording;

private:
    bool take_header(std::string_view payload) {
        std::optional<RecordingHeader> header = decode_header(payload);
        header_ = header.has_value();
        if (header_) {
            recording.header = std::move(*header);
        }
        return header_;
    }

    bool take_start(std::string_view payload) {
        std::optional<RecordedStart> start = decode_start(payload);
        start_ = start && start->observation.values.size() == recording.header.schema.size();
        if (start_) {
            recording.start = std::move(*start);
        }
        return start_;
    }

    bool take_step(std::string_view payload) {
        std::optional<RecordedStep> step = decode_step(payload);
        if (!step || step->step != recording.steps.size() + 1 ||
            step->observation.values.size() != recording.header.schema.size()) {
            return false;
        }
        recording.steps.push_back(std::move(*step));
        return true;
    }

    bool take_checkpoint(std::string_view payload) {
        std::optional<Snapshot> snapshot = decode_snapshot(payload);
        if (!snapshot || snapshot->step != recording.steps.size()) {
            return false;
        }
        recording.checkpoints.push_back(std::move(*snapshot));
        return true;
    }

    bool header_ = false;
    bool start_ = false;
};

std::string fault_at(std::size_t offset, ChunkState state, std::size_t steps) {
    const std::string where = " at byte " + std::to_string(offset) + ", after step " + std::to_string(steps);
    return (state == ChunkState::cut ? "cut short" : "damaged") + where;
}

}  // namespace

Result<Recording> read_recording(const std::string& path) {
    const Result<std::string> content = file_bytes(path);
    if (!content) {
        return content.error();
    }
    const std::string_view bytes = content.value();
    const Status magic = check_first_line(recording_file, bytes, path);
    if (!magic) {
        return magic.error();
    }
    Assembler assembler;
    std::size_t offset = first_line(recording_file).size();
    std::string fault;
    while (fault.empty() && !assembler.recording.whole) {
        const ChunkView chunk = next_chunk(bytes.substr(offset));
        if (chunk.state != ChunkState::whole) {
            fault = fault_at(offset, chunk.state, assembler.recording.steps.size());
        } else if (!assembler.take(chunk)) {
            fault = fault_at(offset, ChunkState::damaged, assembler.recording.steps.size());
        } else {
            offset += chunk.size;
        }
    }
    if (!assembler.started()) {
        return Error{"the recording is " + fault.substr(0, fault.find(',')) + ", before its first step", path, ""};
    }
    assembler.recording.fault = fault;
    return std::move(assembler.recording);
}

}  // namespace rhexis
