// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of recordings and states: a first line, then chunks of kind, size, payload and checksum.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace rhexis {

/// A kind of file made of chunks. Its first line is `family`, `version` and a newline. The versions rise whenever the
/// fields in kernel/session/codec.cpp change.
struct ChunkFile {
    std::string_view family;
    int version;
    std::string_view noun;     ///< "recording"
    std::string_view written;  ///< "a file written by ..."
};

inline constexpr ChunkFile recording_file{"rhexis recording ", 14, "recording", "a file written by rhexis run (.rhx)"};
inline constexpr ChunkFile state_file{"rhexis state ", 14, "state", "a file written by rhexis run --save-state"};

std::string first_line(const ChunkFile& kind);

/// Fails on bytes of another kind or version, in one line that names the path.
Status check_first_line(const ChunkFile& kind, std::string_view bytes, const std::string& path);

enum class ChunkKind : std::uint32_t { header = 1, start = 2, step = 3, checkpoint = 4, end = 5 };

std::string make_chunk(ChunkKind kind, std::string_view payload);

enum class ChunkState { whole, cut, damaged };

struct ChunkView {
    ChunkState state = ChunkState::cut;
    ChunkKind kind = ChunkKind::end;
    std::string_view payload;
    std::size_t size = 0;  ///< of the whole chunk in the file
};

/// The chunk that begins with the first of these bytes. cut: its end is missing.
ChunkView next_chunk(std::string_view bytes);

}  // namespace rhexis
