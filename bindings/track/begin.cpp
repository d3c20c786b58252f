// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track begin and print.
#include <cstdio>
#include <filesystem>

#include "base/output_file.hpp"
#include "track/commands.hpp"
#include "tracking/marker_body_stl.hpp"
#include "tracking/rig.hpp"
#include "tracking/synthetic/bodies.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking {

Status begin(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code wrong;
    fs::create_directories(folder, wrong);
    if (wrong || !fs::is_empty(folder, wrong)) {
        return Error{"this folder cannot be begun in", folder, "one that is empty, or not there yet"};
    }
    const Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(1);
    if (!rig) {
        return rig.error();
    }
    std::string names;
    for (const MarkerBody& body : synthetic::standard_bodies()) {
        const std::string file = body.name + ".json";
        if (const Status written = write_marker_body(body, folder + "/" + file); !written) {
            return written.error();
        }
        names += (names.empty() ? "\"" : ", \"") + file + "\"";
    }
    if (const Status written = write_rig(rig.value().nominal, folder + "/rig.json"); !written) {
        return written.error();
    }
    const std::string setup = "{\n \"rig\": \"rig.json\",\n \"bodies\": [" + names +
                              "],\n \"head\": \"head\",\n"
                              " \"source\": {\"kind\": \"synthetic\", \"seed\": 1, \"clip\": \"tremor\"},\n"
                              " \"serve\": {\"address\": \"127.0.0.1\", \"vrpn\": 3883}\n}\n";
    if (const Status written = write_file(folder + "/track.json", setup); !written) {
        return written.error();
    }
    std::printf("%s/track.json: next, rhexis track calibrate %s/track.json\n", folder.c_str(), folder.c_str());
    return success();
}

Status print_body(const std::string& body, const std::string& stl) {
    const Result<MarkerBody> read = read_marker_body(body);
    if (!read) {
        return read.error();
    }
    const Result<std::string> shape = marker_body_stl(read.value());
    if (!shape) {
        return shape.error();
    }
    return write_file(stl, shape.value());
}

}  // namespace rhexis::tracking
