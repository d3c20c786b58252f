// SPDX-License-Identifier: GPL-3.0-or-later
// A mapping's file that is edited while the station runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "station/mapping.hpp"
#include "station/window/panels.hpp"

namespace rhexis::station {

class MappingFile {
public:
    /// read: what is in it now.
    MappingFile(std::string path, Mapping read);

    /// What has changed in it since it was read last, looked for once a second; what is wrong with it is told.
    std::vector<UserEvent> changes(Panels& panels);

private:
    [[nodiscard]] std::filesystem::file_time_type last_written() const;

    std::string path_;
    Mapping read_;
    std::filesystem::file_time_type written_;
    double looked_s_ = 0.0;
};

}  // namespace rhexis::station
