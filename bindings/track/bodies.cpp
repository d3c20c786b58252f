// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track begin, design and print.
#include <cstdio>
#include <filesystem>

#include "base/output_file.hpp"
#include "flow/microscope.hpp"
#include "lua/exercise_instruments.hpp"
#include "track/commands.hpp"
#include "track/replica.hpp"
#include "tracking/bodies/design.hpp"
#include "tracking/bodies/known_bodies.hpp"
#include "tracking/rig.hpp"
#include "tracking/synthetic/synthetic_rig.hpp"

namespace rhexis::tracking {
namespace {

Result<std::vector<MarkerBody>> bodies_for(const BeginOptions& options) {
    Result<std::vector<std::string>> instruments = instruments_of(options.exercise, options.root);
    if (!instruments) {
        return instruments.error();
    }
    std::erase(instruments.value(), microscope_name);  // it stays with keys and foot
    return known_bodies(instruments.value());
}

Status make_empty_folder(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code wrong;
    fs::create_directories(folder, wrong);
    if (wrong || !fs::is_empty(folder, wrong)) {
        return Error{"this folder cannot be begun in", folder, "one that is empty, or not there yet"};
    }
    return success();
}

Result<std::vector<MarkerBody>> read_all(const std::vector<std::string>& paths) {
    std::vector<MarkerBody> bodies;
    for (const std::string& path : paths) {
        Result<MarkerBody> body = read_marker_body(path);
        if (!body) {
            return body.error();
        }
        bodies.push_back(std::move(body).value());
    }
    return bodies;
}

/// Of an instrument that is not known here there is no shape: its handle is taken to be 8 mm thick and to lie along the
/// body's z axis.
Result<Replica> replica_for(const MarkerBody& body, bool with_shape) {
    constexpr double radius_mm = 4.0;
    constexpr double long_mm = 200.0;
    if (body.name == head_name) {
        return Replica{};
    }
    Result<Replica> replica = replica_of(body.name);
    if (with_shape) {
        return replica;
    }
    if (replica) {
        replica.value().shape.clear();
        return replica;
    }
    const Vec3 foot(0.0, 0.0, body.tip.position.z());
    const std::array<RoundedCone, 1> rod{
        {{body.tip.to_body(foot), body.tip.to_body(foot + long_mm * Vec3::UnitZ()), radius_mm, radius_mm}}};
    Result<Handle> handle = handle_of(rod, body.name);
    return handle ? Result<Replica>(Replica{std::move(handle).value(), {}}) : Result<Replica>(handle.error());
}

}  // namespace

Status begin(const BeginOptions& options) {
    const std::string& folder = options.folder;
    const Result<std::vector<MarkerBody>> bodies = bodies_for(options);
    if (!bodies) {
        return bodies.error();
    }
    if (const Status made = make_empty_folder(folder); !made) {
        return made.error();
    }
    const Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(1);
    if (!rig) {
        return rig.error();
    }
    std::string names;
    for (const MarkerBody& body : bodies.value()) {
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

Status design(const DesignOptions& options) {
    const Result<Replica> replica = replica_of(options.instrument);
    if (!replica) {
        return replica.error();
    }
    Result<std::vector<MarkerBody>> unlike = read_all(options.unlike);
    Result<std::vector<MarkerBody>> beside = read_all(options.beside);
    if (!unlike || !beside) {
        return unlike ? beside.error() : unlike.error();
    }
    DesignPlan plan;
    plan.name = options.instrument;
    plan.handle = *replica.value().handle;
    plan.reach_mm = options.reach_mm;
    plan.seed = options.seed;
    const Result<MarkerBody> body = design_body(plan, {std::move(unlike).value(), std::move(beside).value()});
    if (!body) {
        return body.error();
    }
    if (const Status written = write_marker_body(body.value(), options.body); !written) {
        return written.error();
    }
    std::printf("%s: an error of 10 um of each sphere is one of %.0f um of the tip\n", options.body.c_str(),
                10.0 * tip_error_share(body.value()));
    return success();
}

Status print_body(const PrintOptions& options) {
    const Result<MarkerBody> body = read_marker_body(options.body);
    if (!body) {
        return body.error();
    }
    const Result<Replica> replica = replica_for(body.value(), options.with_shape);
    if (!replica) {
        return replica.error();
    }
    const Result<std::string> solid = marker_body_stl(body.value(), replica.value());
    if (!solid) {
        return solid.error();
    }
    return write_file(options.stl, solid.value());
}

}  // namespace rhexis::tracking
