// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/mapping_file.hpp"

#include <utility>

#include "base/clock.hpp"

namespace rhexis::station {

MappingFile::MappingFile(std::string path, Mapping read)
    : path_(std::move(path)), read_(std::move(read)), written_(last_written()) {}

std::vector<UserEvent> MappingFile::changes(Panels& panels) {
    const double now = wall_seconds();
    if (now - looked_s_ < 1.0) {
        return {};
    }
    looked_s_ = now;
    const std::filesystem::file_time_type written = last_written();
    if (written == written_) {
        return {};
    }
    written_ = written;
    Result<Mapping> mapping = Mapping::read(path_);
    if (!mapping) {
        panels.notice(mapping.error().text());
        return {};
    }
    std::vector<UserEvent> events = read_.changes_to(mapping.value());
    read_ = std::move(mapping).value();
    panels.notice(panels.words()("read again: %s", {path_}));
    return events;
}

std::filesystem::file_time_type MappingFile::last_written() const {
    std::error_code unknown;
    return std::filesystem::last_write_time(path_, unknown);
}

}  // namespace rhexis::station
