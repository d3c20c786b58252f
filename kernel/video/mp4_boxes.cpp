// SPDX-License-Identifier: GPL-3.0-or-later
#include "video/mp4_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "base/output_file.hpp"

namespace rhexis {

namespace {

using Bytes = std::span<unsigned char>;

struct Mp4Box {
    std::string letters;
    std::uint64_t start = 0;
    std::uint64_t head = 8;  ///< bytes before what it holds
    std::uint64_t length = 0;
};

std::uint64_t number_in(std::span<const unsigned char> bytes) {
    return std::accumulate(bytes.begin(), bytes.end(), std::uint64_t{0},
                           [](std::uint64_t sum, unsigned char byte) { return (sum << 8) | byte; });
}

void put_number(std::uint64_t number, Bytes bytes) {
    for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte, number >>= 8) {
        *byte = static_cast<unsigned char>(number);
    }
}

/// The box that begins with these bytes, of which `left` follow in all; none if it does not fit.
std::optional<Mp4Box> box_of(std::span<const unsigned char, 16> bytes, std::uint64_t start, std::uint64_t left) {
    Mp4Box box{std::string(bytes.begin() + 4, bytes.begin() + 8), start, 8, number_in(bytes.first(4))};
    if (box.length == 1) {  // a 64-bit length follows the letters
        box.head = 16;
        box.length = number_in(bytes.last(8));
    }
    return box.length >= box.head && box.length <= left ? std::optional<Mp4Box>(box) : std::nullopt;
}

/// Empty if the file ends within a box.
std::vector<Mp4Box> boxes_of(std::ifstream& file) {
    file.seekg(0, std::ios::end);
    const std::uint64_t end = file ? static_cast<std::uint64_t>(file.tellg()) : 0;
    std::vector<Mp4Box> boxes;
    for (std::uint64_t place = 0; place < end; place += boxes.back().length) {
        std::array<unsigned char, 16> bytes{};
        file.seekg(static_cast<std::streamoff>(place));
        file.read(reinterpret_cast<char*>(bytes.data()),
                  static_cast<std::streamsize>(std::min(end - place, std::uint64_t{16})));
        const std::optional<Mp4Box> box = box_of(bytes, place, end - place);
        if (!box) {
            return {};
        }
        boxes.push_back(*box);
    }
    return boxes;
}

/// Adds `shift` to all places of pictures in a list of them; false if one grows too large.
bool shift_list(Bytes list, std::size_t width, std::uint64_t shift) {
    if (list.size() < 8) {
        return false;
    }
    const std::uint64_t count = number_in(list.subspan(4, 4));
    if (count > (list.size() - 8) / width) {
        return false;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        const Bytes place = list.subspan(8 + i * width, width);
        const std::uint64_t moved = number_in(place) + shift;
        if (width == 4 && moved > std::numeric_limits<std::uint32_t>::max()) {
            return false;
        }
        put_number(moved, place);
    }
    return true;
}

/// The same in all lists within the contents of an index.
bool shift_index(Bytes contents, std::uint64_t shift) {
    while (contents.size() >= 8) {
        std::array<unsigned char, 16> head{};
        std::copy_n(contents.begin(), std::min<std::size_t>(16, contents.size()), head.begin());
        const std::optional<Mp4Box> box = box_of(head, 0, contents.size());
        if (!box) {
            return false;
        }
        const Bytes inner = contents.subspan(box->head, box->length - box->head);
        const std::string& is = box->letters;
        const bool nested = is == "trak" || is == "mdia" || is == "minf" || is == "stbl";
        if ((nested && !shift_index(inner, shift)) || (is == "stco" && !shift_list(inner, 4, shift)) ||
            (is == "co64" && !shift_list(inner, 8, shift))) {
            return false;
        }
        contents = contents.subspan(box->length);
    }
    return true;
}

Status copy_box(std::ifstream& from, const Mp4Box& box, OutputFile& to) {
    std::vector<char> block(1 << 20);
    from.seekg(static_cast<std::streamoff>(box.start));
    Status status = success();
    for (std::uint64_t left = box.length; left > 0 && from && status;) {
        const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(left, block.size()));
        from.read(block.data(), static_cast<std::streamsize>(count));
        status = to.write({block.data(), count});
        left -= count;
    }
    return status;
}

std::vector<Mp4Box>::const_iterator find(const std::vector<Mp4Box>& boxes, const char* letters) {
    return std::find_if(boxes.begin(), boxes.end(), [&](const Mp4Box& box) { return box.letters == letters; });
}

/// The index as it must read once it stands before the pictures; empty if it need not or cannot move.
std::vector<unsigned char> moved_index(std::ifstream& file, const std::vector<Mp4Box>& boxes) {
    const auto index = find(boxes, "moov");
    if (index < find(boxes, "mdat")) {
        return {};
    }
    std::vector<unsigned char> bytes(index->length);
    file.seekg(static_cast<std::streamoff>(index->start));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const bool moves = file && shift_index(Bytes(bytes).subspan(index->head), index->length);
    return moves ? bytes : std::vector<unsigned char>();
}

}  // namespace

bool is_whole_mp4(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<Mp4Box> boxes = boxes_of(file);
    return find(boxes, "moov") != boxes.end();
}

Status write_index_first(const std::string& from, const std::string& to) {
    std::ifstream file(from, std::ios::binary);
    const std::vector<Mp4Box> boxes = boxes_of(file);
    if (find(boxes, "moov") == boxes.end()) {
        return Error{"this is not a whole MP4 file", from, "one with an index"};
    }
    const std::vector<unsigned char> index = moved_index(file, boxes);
    Result<OutputFile> out = OutputFile::create(to);
    if (!out) {
        return out.error();
    }
    Status status = success();
    for (const Mp4Box& box : boxes) {
        if (box.letters == "mdat" && !index.empty() && box.start == find(boxes, "mdat")->start) {
            status = status ? out.value().write({reinterpret_cast<const char*>(index.data()), index.size()}) : status;
        }
        if (box.letters != "moov" || index.empty()) {
            status = status ? copy_box(file, box, out.value()) : status;
        }
    }
    if (status && !file) {
        return Error{"cannot be read", from, "a whole MP4 file"};
    }
    return status ? out.value().finish() : status;
}

}  // namespace rhexis
