// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "base/clock.hpp"
#include "base/hash.hpp"
#include "base/output_file.hpp"
#include "session/chunk.hpp"
#include "session/codec.hpp"

namespace rhexis {

struct RecordingWriter::Parts {
    std::string path;
    std::string file;
    int descriptor = -1;
    std::string waiting;     ///< bytes not yet given to the system
    double flushed_s = 0.0;  ///< when the last were; what is written does not depend on it

    ~Parts() {
        if (descriptor >= 0) {
            static_cast<void>(flush());
            ::close(descriptor);
        }
    }

    [[nodiscard]] Error failure(int code) const { return cannot_write(file, code); }

    Status flush() {
        const Status written = write_bytes(descriptor, file, waiting);
        waiting.clear();  // of what failed the rest as well: it is not written twice
        flushed_s = wall_seconds();
        return written;
    }

    Status add(ChunkKind kind, const std::string& payload) {
        waiting += make_chunk(kind, payload);
        constexpr std::size_t enough = 32768;
        constexpr double longest_wait_s = 0.9;  // a process that is killed loses a second of its recording at most
        const bool waited = wall_seconds() - flushed_s > longest_wait_s;
        return waiting.size() >= enough || kind != ChunkKind::step || waited ? flush() : success();
    }
};

RecordingHeader header_of(const Session& session) {
    RecordingHeader header;
    header.scene = session.scene();
    header.schema = session.schema();
    header.build = build_note();
    return header;
}

RecordingWriter::RecordingWriter(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RecordingWriter::~RecordingWriter() = default;
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;

Result<RecordingWriter> RecordingWriter::create(const std::string& path, const RecordingHeader& header) {
    std::unique_ptr<Parts> parts = std::make_unique<Parts>();
    const Result<OutputPlace> place = output_place(path);
    if (!place) {
        return place.error();
    }
    const bool plain = place.value().plain;
    parts->path = place.value().path;
    parts->file = parts->path + (plain ? ".part" : "");
    parts->descriptor =
        ::open(parts->file.c_str(), O_WRONLY | O_CLOEXEC | (plain ? O_CREAT | O_TRUNC : 0), place.value().mode);
    if (parts->descriptor < 0) {
        return parts->failure(errno);
    }
    parts->waiting = first_line(recording_file);
    const Status status = parts->add(ChunkKind::header, encode(header));
    if (!status) {
        if (plain) {
            ::unlink(parts->file.c_str());  // not even a header: nothing to keep
        }
        return status.error();
    }
    return RecordingWriter(std::move(parts));
}

Status RecordingWriter::add(const RecordedStart& start) { return parts_->add(ChunkKind::start, encode(start)); }
Status RecordingWriter::add(const RecordedStep& step) { return parts_->add(ChunkKind::step, encode(step)); }
Status RecordingWriter::add(const Snapshot& checkpoint) {
    return parts_->add(ChunkKind::checkpoint, encode(checkpoint));
}

Status RecordingWriter::finish() {
    Status status = parts_->add(ChunkKind::end, "");
    if (!status) {
        return status;
    }
    const int descriptor = parts_->descriptor;
    parts_->descriptor = -1;
    const bool synced = ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
    const int code = errno;
    const bool closed = ::close(descriptor) == 0;
    if (!synced || !closed) {
        return parts_->failure(synced ? errno : code);
    }
    if (parts_->file != parts_->path && std::rename(parts_->file.c_str(), parts_->path.c_str()) != 0) {
        return parts_->failure(errno);
    }
    parts_->file = parts_->path;
    return success();
}

const std::string& RecordingWriter::file() const { return parts_->file; }

}  // namespace rhexis
