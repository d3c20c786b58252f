// SPDX-License-Identifier: GPL-3.0-or-later
#include <png.h>
#include <zlib.h>

#include <csetjmp>

#include "base/output_file.hpp"
#include "render/image_file.hpp"

namespace rhexis {
namespace {

void append(png_structp png, png_bytep bytes, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// False: libpng has not come to the end. It leaves by a jump, which passes no destructor here.
bool write_rows(png_structp png, png_infop info, const Image& image) {
    if (setjmp(png_jmpbuf(png)) != 0) {
        return false;
    }
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    // Of a microscope's picture: 337 kB in 10 ms. libpng's own way takes 65 ms for 309 kB, its fast one 13 for 530.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        png_write_row(png, image.rgb.data() + 3 * static_cast<std::size_t>(y) * image.width);
    }
    png_write_end(png, nullptr);
    return true;
}

/// Nothing: there is no memory for it.
std::optional<std::string> encoded(const Image& image) {
    std::string bytes;
    bytes.reserve(image.rgb.size() + image.rgb.size() / 8 + 1024);  // more than it takes: nothing is thrown in libpng
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool whole = false;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, append, nullptr);
        whole = write_rows(png, info, image);
    }
    png_destroy_write_struct(&png, &info);
    return whole ? std::optional<std::string>(std::move(bytes)) : std::nullopt;
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
