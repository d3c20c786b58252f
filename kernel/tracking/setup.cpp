// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/setup.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tracking/bodies/known_bodies.hpp"
#include "tracking/json_fields.hpp"
#include "tracking/sources/board_source.hpp"
#include "tracking/sources/synthetic_source.hpp"
#include "tracking/synthetic/clips.hpp"

namespace rhexis::tracking {
namespace {

std::string beside(const std::string& file, const std::string& path) {
    const std::filesystem::path given(path);
    return given.is_absolute() ? path : (std::filesystem::path(file).parent_path() / given).lexically_normal().string();
}

Result<SourcePlan> source_of(const Json& json, const std::string& path) {
    Fields fields(json, path + ", \"source\"");
    const std::string kind = fields.text("kind");
    SourcePlan plan;
    if (kind == "synthetic") {
        fields.only({"kind", "seed", "clip", "level", "seconds", "rate_hz"});
        SyntheticPlan synthetic;
        synthetic.seed = static_cast<std::uint64_t>(fields.number("seed", 0, 9e15, 1));
        synthetic.clip = fields.text("clip", "tremor");
        const std::string level = fields.text("level", "images");
        if (level != "images" && level != "markers") {
            fields.refuse("level", "\"images\" or \"markers\"");
        }
        synthetic.images = level == "images";
        synthetic.seconds = fields.number("seconds", 0.0, 86400.0, 0.0);
        synthetic.rate_hz = fields.number("rate_hz", 1.0, 1000.0, 120.0);
        plan = synthetic;
    } else if (kind == "folder") {
        fields.only({"kind", "path", "rate_hz"});
        plan = FolderPlan{beside(path, fields.text("path")), fields.number("rate_hz", 1.0, 1000.0, 120.0)};
    } else if (kind == "cameras") {
        fields.only({"kind", "devices", "rate_hz"});
        CapturePlan capture{fields.texts("devices"), fields.number("rate_hz", 1.0, 1000.0, 120.0)};
        for (std::string& device : capture.of) {
            const bool number = std::all_of(device.begin(), device.end(), [](char c) { return c >= '0' && c <= '9'; });
            device = number ? device : beside(path, device);
        }
        plan = capture;
    } else {
        fields.refuse("kind", "\"synthetic\", \"folder\" or \"cameras\"");
    }
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    return plan;
}

Result<ServePlan> serve_of(const Json& json, const std::string& path) {
    Fields fields(json, path + ", \"serve\"");
    fields.only({"address", "vrpn", "igtl", "others_may_hear"});
    ServePlan plan;
    plan.address = fields.text("address", plan.address);
    plan.vrpn_port = fields.whole("vrpn", -1, 65535, plan.vrpn_port);
    plan.igtl_port = fields.whole("igtl", -1, 65535, plan.igtl_port);
    if (!plan.address.starts_with("127.") && plan.address != "localhost" && !fields.yes("others_may_hear", false)) {
        fields.refuse("address", "127.0.0.1, or \"others_may_hear\": true for what the whole network can reach");
    }
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    return plan;
}

Result<std::string> inputs_of(const Json& json, const std::string& path) {
    Fields fields(json, path + ", \"inputs\"");
    fields.only({"vrpn"});
    std::string address = fields.text("vrpn", "");
    const Status status = fields.status();
    return status ? Result<std::string>(std::move(address)) : status.error();
}

Status read_bodies(const std::vector<std::string>& paths, const std::string& path, Setup& setup) {
    for (const std::string& of : paths) {
        Result<MarkerBody> body = read_marker_body(beside(path, of));
        if (!body) {
            return body.error();
        }
        setup.bodies.push_back(std::move(body).value());
        setup.body_paths.push_back(beside(path, of));
    }
    if (setup.bodies.empty()) {
        return Error{"no bodies to track", path, "\"bodies\": [\"head.json\", ...]"};
    }
    if (Status alike = check_signatures(setup.bodies); !alike) {
        return alike;
    }
    return success();
}

Status find_head(const std::string& name, const std::string& path, Setup& setup) {
    for (std::size_t i = 0; i < setup.bodies.size(); ++i) {
        if (setup.bodies[i].name == name) {
            setup.head = static_cast<int>(i);
            return success();
        }
    }
    return Error{"\"head\" is \"" + name + "\"", path, "the name of one of the bodies"};
}

synthetic::Film film_of(const SyntheticPlan& plan, double seconds) {
    synthetic::Film film;
    film.seed = plan.seed;
    film.delivery.rate_hz = plan.rate_hz;
    film.frames = std::llround(std::ceil(seconds * plan.rate_hz));
    return film;
}

Result<std::unique_ptr<SpotSource>> with_spots(Result<std::unique_ptr<FrameSource>> frames, const Setup& setup) {
    if (!frames) {
        return frames.error();
    }
    return std::unique_ptr<SpotSource>(std::make_unique<ImageSpots>(std::move(frames).value(), setup.spots));
}

Result<std::unique_ptr<SpotSource>> film_spots(const synthetic::SyntheticRig& rig, synthetic::Stage stage,
                                               const synthetic::Film& film, bool images, const Setup& setup) {
    return images ? with_spots(film_images(rig, std::move(stage), film), setup)
                  : film_markers(rig, std::move(stage), film);
}

/// Images that are there, or that cameras take.
Result<std::unique_ptr<FrameSource>> open_seen(const Setup& setup) {
    const auto* folder = std::get_if<FolderPlan>(&setup.source);
    return folder != nullptr ? open_folder(*folder, setup.rig)
                             : open_capture(std::get<CapturePlan>(setup.source), setup.rig);
}

/// A stage and what it is seen by, kept together: the stage's functions look into both.
struct Play {
    synthetic::SyntheticRig rig{};
    synthetic::Clip clip{};
};

/// The head's, and as many others as there is room for.
std::vector<MarkerBody> played_bodies(const std::vector<MarkerBody>& bodies) {
    std::vector<MarkerBody> played;
    int instruments = 0;
    for (const MarkerBody& body : bodies) {
        if (body.name == head_name || instruments++ < synthetic::most_instruments) {
            played.push_back(body);
        }
    }
    return played;
}

Result<std::unique_ptr<SpotSource>> open_synthetic(const SyntheticPlan& plan, const Setup& setup) {
    Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(plan.seed);
    if (!rig) {
        return rig.error();
    }
    Result<synthetic::Clip> clip =
        synthetic::make_clip(plan.clip, plan.seed, played_bodies(setup.bodies), rig.value().nominal);
    if (!clip) {
        return clip.error();
    }
    const auto play = std::make_shared<Play>(Play{std::move(rig).value(), std::move(clip).value()});
    const double duration_s = play->clip.duration_s;
    synthetic::Stage stage;
    stage.scene = [play, duration_s](double time_s, synthetic::Scene& scene) {
        scene_at(play->clip, std::fmod(time_s, duration_s), scene);
    };
    stage.camera = [play, duration_s](int camera, double time_s) {
        return camera_at(play->clip, play->rig, camera, std::fmod(time_s, duration_s));
    };
    constexpr double as_long_as_one_likes_s = 1e9;
    const synthetic::Film film = film_of(plan, plan.seconds > 0.0 ? plan.seconds : as_long_as_one_likes_s);
    return film_spots(play->rig, std::move(stage), film, plan.images, setup);
}

Result<std::unique_ptr<SpotSource>> open_synthetic_wand(const SyntheticPlan& plan, const Setup& setup) {
    constexpr double seconds = 30.0;
    constexpr double rate_hz = 20.0;
    const Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(plan.seed);
    if (!rig) {
        return rig.error();
    }
    SyntheticPlan slow = plan;
    slow.rate_hz = rate_hz;
    const synthetic::Film film = film_of(slow, seconds);
    return film_spots(rig.value(), synthetic::waved_wand(plan.seed), film, plan.images, setup);
}

}  // namespace

Result<Setup> read_setup(const std::string& path) {
    const Result<Json> json = read_json_object(path);
    if (!json) {
        return json.error();
    }
    Setup setup;
    setup.path = path;
    Fields fields(json.value(), path);
    fields.only({"rig", "bodies", "head", "source", "serve", "inputs", "threshold", "wand_mm", "wand_radius_mm"});
    const std::string rig = fields.text("rig");
    const std::vector<std::string> bodies = fields.texts("bodies");
    const std::string head = fields.text("head", "");
    setup.spots.threshold = fields.whole("threshold", 5, 250, setup.spots.threshold);
    const Json& source_json = fields.object("source");
    const Json& serve_json = fields.object("serve");
    const Json& inputs_json = fields.object("inputs");
    if (fields.has("wand_mm")) {
        const int spheres = json.value()["wand_mm"].is_array() ? static_cast<int>(json.value()["wand_mm"].size()) : 0;
        const VecX at = fields.numbers("wand_mm", std::clamp(spheres, 2, 3), 2000.0);
        setup.wand_mm.assign(at.begin(), at.end());
    } else {
        setup.wand_mm.assign(synthetic::wand_mm.begin(), synthetic::wand_mm.end());
    }
    setup.wand_radius_mm = fields.number("wand_radius_mm", 0.0, 20.0, setup.wand_radius_mm);
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    setup.rig_path = beside(path, rig);
    Result<Rig> read = read_rig(setup.rig_path);
    if (!read) {
        return read.error();
    }
    setup.rig = std::move(read).value();
    if (const Status status = read_bodies(bodies, path, setup); !status) {
        return status.error();
    }
    if (const Status status = head.empty() ? success() : find_head(head, path, setup); !status) {
        return status.error();
    }
    Result<SourcePlan> source = source_of(source_json, path);
    if (!source) {
        return source.error();
    }
    setup.source = std::move(source).value();
    Result<ServePlan> serve = serve_of(serve_json, path);
    if (!serve) {
        return serve.error();
    }
    setup.serve = std::move(serve).value();
    Result<std::string> inputs = inputs_of(inputs_json, path);
    if (!inputs) {
        return inputs.error();
    }
    setup.inputs = std::move(inputs).value();
    return setup;
}

Result<std::unique_ptr<SpotSource>> open_source(const Setup& setup) {
    const auto* synthetic = std::get_if<SyntheticPlan>(&setup.source);
    return synthetic != nullptr ? open_synthetic(*synthetic, setup) : with_spots(open_seen(setup), setup);
}

Result<std::unique_ptr<SpotSource>> open_wand(const Setup& setup) {
    const auto* synthetic = std::get_if<SyntheticPlan>(&setup.source);
    return synthetic != nullptr ? open_synthetic_wand(*synthetic, setup) : open_source(setup);
}

Result<std::unique_ptr<FrameSource>> open_boards(const Setup& setup, const GridPlan& board, int views) {
    const auto* synthetic = std::get_if<SyntheticPlan>(&setup.source);
    if (synthetic == nullptr) {
        return open_seen(setup);
    }
    const Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(synthetic->seed);
    return rig ? film_boards(rig.value(), board, views, synthetic->seed) : rig.error();
}

}  // namespace rhexis::tracking
