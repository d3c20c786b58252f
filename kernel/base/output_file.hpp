// SPDX-License-Identifier: GPL-3.0-or-later
// Where the output that a path names goes, and what is written there: the one way by which files come to be.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

#include "base/result.hpp"

namespace rhexis {

/// What a path names as an output. Links are followed: what they point to is written, and they stay links.
struct OutputPlace {
    std::string path;  ///< with its links followed
    bool plain =
        true;  ///< a plain file, there or not yet; else a device, a pipe or a socket, which is written to directly
    mode_t mode = 0666;  ///< of the file that is there, or of one that is made, less the umask
};

/// Fails for a folder, and for links that go in circles.
Result<OutputPlace> output_place(const std::string& path);

/// A reason of the system, with the folder where that is what cannot be written.
Error cannot_write(const std::string& path, int code);

/// A file that is written bit by bit. A plain one has another name beside its own until finish() gives it that, so
/// that it appears whole or not at all, also where several processes write it at once; it is removed where finish() is
/// not called. It keeps the mode of the file that it replaces.
class OutputFile {
public:
    static Result<OutputFile> create(const std::string& path);
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    Status write(std::string_view bytes);
    Status finish();

private:
    explicit OutputFile(OutputPlace place) : place_(std::move(place)) {}

    OutputPlace place_;
    std::string unfinished_;  ///< name until it is finished; empty: none to remove
    int descriptor_ = -1;
};

/// Writes all of it; see OutputFile.
Status write_file(const std::string& path, std::string_view content);

/// All bytes to a descriptor. path: for the message.
Status write_bytes(int descriptor, const std::string& path, std::string_view bytes);

}  // namespace rhexis
