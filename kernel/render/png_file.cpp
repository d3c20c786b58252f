// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>

#include <string_view>

#include "base/output_file.hpp"
#include "render/image_file.hpp"

namespace rhexis {
namespace {

/// Nothing: there is no memory for it.
std::optional<std::string> encoded(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;  // a picture is kept for minutes, and drawn while somebody waits
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
        return std::nullopt;
    }
    bytes.resize(size);
    return bytes;
}

}  // namespace

Status write_png(const Image& image, const std::string& path) {
    if (image.width < 1 || image.height < 1 ||
        image.rgb.size() != 3 * static_cast<std::size_t>(image.width) * image.height) {
        return Error{"the picture is empty", path, "at least 1 x 1 pixels"};
    }
    const std::optional<std::string> bytes = encoded(image);
    if (!bytes) {
        return Error{"the picture does not fit into memory", path, "a smaller one"};
    }
    const Status written = write_file(path, *bytes);
    if (written) {
        return written;
    }
    const std::string& why = written.error().what;
    const std::string::size_type colon = why.find(": ");
    return Error{"cannot write the picture: " + (colon == std::string::npos ? why : why.substr(colon + 2)), path,
                 "a writable path with room"};
}

}  // namespace rhexis
