// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/chunk.hpp"

#include <cstring>

#include "base/hash.hpp"

namespace rhexis {
namespace {

constexpr std::size_t head_size = 2 * sizeof(std::uint32_t);
constexpr std::size_t tail_size = sizeof(std::uint64_t);

std::uint64_t checksum(std::string_view bytes) {
    StateHash hash;
    hash.add_bytes(bytes.data(), bytes.size());
    return hash.value();
}

template <typename T>
T read_as(std::string_view bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

template <typename T>
void append(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::string first_line(const ChunkFile& kind) {
    return std::string(kind.family).append(std::to_string(kind.version)).append("\n");
}

Status check_first_line(const ChunkFile& kind, std::string_view bytes, const std::string& path) {
    const std::string noun(kind.noun);
    if (bytes.starts_with(first_line(kind))) {
        return success();
    }
    if (bytes.empty()) {
        return Error{"the file is empty", path, std::string(kind.written)};
    }
    if (!bytes.starts_with(kind.family)) {
        return Error{"this is not a " + noun, path, std::string(kind.written)};
    }
    const std::string_view rest = bytes.substr(kind.family.size());
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos || end > 8) {
        return Error{"the " + noun + " is cut short or damaged in its first line", path, ""};
    }
    return Error{"the " + noun + " has format version " + std::string(rest.substr(0, end)), path,
                 "this program reads version " + std::to_string(kind.version)};
}

std::string make_chunk(ChunkKind kind, std::string_view payload) {
    std::string chunk;
    chunk.reserve(head_size + payload.size() + tail_size);
    append(chunk, static_cast<std::uint32_t>(kind));
    append(chunk, static_cast<std::uint32_t>(payload.size()));
    chunk += payload;
    append(chunk, checksum(chunk));
    return chunk;
}

ChunkView next_chunk(std::string_view bytes) {
    ChunkView view;
    if (bytes.size() < head_size + tail_size) {
        return view;
    }
    const std::uint32_t kind = read_as<std::uint32_t>(bytes);
    const std::size_t size = read_as<std::uint32_t>(bytes.substr(sizeof(std::uint32_t)));
    if (kind < 1 || kind > 5) {
        view.state = ChunkState::damaged;
        return view;
    }
    if (size > bytes.size() - head_size - tail_size) {
        return view;
    }
    view.size = head_size + size + tail_size;
    view.kind = static_cast<ChunkKind>(kind);
    view.payload = bytes.substr(head_size, size);
    const std::uint64_t stored = read_as<std::uint64_t>(bytes.substr(head_size + size));
    view.state = stored == checksum(bytes.substr(0, head_size + size)) ? ChunkState::whole : ChunkState::damaged;
    return view;
}

}  // namespace rhexis
