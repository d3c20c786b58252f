// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of a recording: kind, size, payload, checksum.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rhexis {

inline constexpr std::string_view recording_family = "rhexis recording ";
inline constexpr std::string_view recording_magic = "rhexis recording 1\n";

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
