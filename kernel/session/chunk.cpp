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
