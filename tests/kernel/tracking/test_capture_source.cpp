// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras through OpenCV, as far as files go: the same images as a folder and as films are tracked to the same tips.
#include <doctest/doctest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "failure_support.hpp"
#include "support/folder.hpp"
#include "tracking/setup.hpp"

namespace rhexis::tracking {
namespace {

using namespace testing;

constexpr int filmed_frames = 4;
constexpr double film_rate_hz = 120.0;

std::vector<FrameSet> filmed() {
    const synthetic::Clip clip = clip_named("tremor");
    synthetic::Stage stage;
    stage.scene = [&clip](double time_s, synthetic::Scene& scene) { scene_at(clip, time_s, scene); };
    synthetic::Film film;
    film.frames = filmed_frames;
    const std::unique_ptr<FrameSource> source = film_images(workplace().rig, stage, film).value();
    std::vector<FrameSet> all;
    FrameSet set;
    while (source->next(set).value()) {
        REQUIRE(set.frames.size() == workplace().rig.cameras.size());
        all.push_back(set);
    }
    return all;
}

cv::Mat mat_of(const CameraFrame& frame) {
    return {frame.height, frame.width, CV_8UC1, const_cast<std::uint8_t*>(frame.pixels.data())};
}

/// Only the first so many frames; code: how it is compressed. Motion JPEG in grey is written so that another library
/// does not read it.
void write_film(const std::string& path, const std::string& code, const std::vector<FrameSet>& sets, std::size_t camera,
                std::size_t frames = filmed_frames, double rate_hz = film_rate_hz) {
    const CameraFrame& first = sets.front().frames[camera];
    const bool in_colour = code == "MJPG";
    cv::VideoWriter writer(path, cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]), rate_hz,
                           {first.width, first.height}, in_colour);
    REQUIRE(writer.isOpened());
    for (std::size_t i = 0; i < frames; ++i) {
        cv::Mat image = mat_of(sets[i].frames[camera]);
        if (in_colour) {
            cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        }
        writer.write(image);
    }
}

/// A place with a setup's files, and the clip's images in a folder and in films of each kind.
class FilmPlace {
public:
    FilmPlace() : sets_(filmed()) {
        REQUIRE(write_rig(workplace().solver, folder_ / "rig.json").ok());
        for (const MarkerBody& body : workplace().bodies) {
            bodies_ += (bodies_.empty() ? "\"" : ", \"") + body.name + ".json\"";
            REQUIRE(write_marker_body(body, folder_ / (body.name + ".json").c_str()).ok());
        }
        for (std::size_t i = 0; i < sets_.size(); ++i) {
            REQUIRE(keep_frames(folder_ / "images", workplace().solver, sets_[i], i).ok());
        }
        for (std::size_t i = 0; i < cameras(); ++i) {
            write_film(film("FFV1", i), "FFV1", sets_, i);
            write_film(film("MJPG", i), "MJPG", sets_, i);
        }
    }
    [[nodiscard]] const std::vector<FrameSet>& sets() const { return sets_; }
    [[nodiscard]] static std::size_t cameras() { return workplace().solver.cameras.size(); }
    [[nodiscard]] std::string film(const std::string& code, std::size_t camera) const {
        return folder_ / (code + std::to_string(camera) + ".avi").c_str();
    }
    [[nodiscard]] std::vector<std::string> films(const std::string& code) const {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < cameras(); ++i) {
            all.push_back(film(code, i));
        }
        return all;
    }
    [[nodiscard]] std::string beside(const char* name) const { return folder_ / name; }
    /// As read_setup() reads it.
    [[nodiscard]] Setup setup(const std::string& source) const {
        const std::string path = folder_ / "track.json";
        test::write_bytes(
            path, R"({"rig": "rig.json", "head": "head", "bodies": [)" + bodies_ + R"(], "source": )" + source + "}");
        Result<Setup> setup = read_setup(path);
        REQUIRE_MESSAGE(setup.ok(), (setup ? "" : setup.error().text()));
        return std::move(setup).value();
    }
    [[nodiscard]] Setup of_films(const std::vector<std::string>& films) const {
        std::string devices;
        for (const std::string& one : films) {
            devices += (devices.empty() ? "\"" : ", \"") + one + "\"";
        }
        return setup(R"({"kind": "cameras", "devices": [)" + devices + "]}");
    }

private:
    test::Folder folder_;
    std::vector<FrameSet> sets_;
    std::string bodies_;
};

const FilmPlace& film_place() {
    static const FilmPlace place;
    return place;
}

struct TrackedFilm {
    std::vector<TrackedBodies> told{};
    std::uint64_t lost = 0;
};

TrackedFilm tracked(const Setup& setup) {
    const Result<std::unique_ptr<SpotSource>> source = open_source(setup);
    REQUIRE_MESSAGE(source.ok(), (source ? "" : source.error().text()));
    Tracker tracker(setup.rig, setup.bodies, setup.head, TrackerSettings{});
    TrackedFilm all;
    std::vector<CameraSpots> exposures;
    while (source.value()->next(exposures).value()) {
        all.told.push_back(tracker.step(exposures));
    }
    all.lost = source.value()->lost();
    return all;
}

/// The farthest that a tip is told beside where the other says it is [mm]. Both see all bodies all the time.
double farthest_apart(const TrackedFilm& one, const TrackedFilm& other) {
    REQUIRE(one.told.size() == other.told.size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < one.told.size(); ++i) {
        for (std::size_t b = 0; b < one.told[i].bodies.size(); ++b) {
            const TrackedBody& body = one.told[i].bodies[b];
            REQUIRE(body.seen == Seen::seen);
            REQUIRE(other.told[i].bodies[b].seen == Seen::seen);
            farthest = std::max(farthest, (body.tip.position - other.told[i].bodies[b].tip.position).norm());
        }
    }
    return farthest;
}

const TrackedFilm& from_folder() {
    static const TrackedFilm all = tracked(film_place().setup(R"({"kind": "folder", "path": "images"})"));
    return all;
}

/// What opening these films is refused with.
std::string refusal(const std::vector<std::string>& films) {
    const Result<std::unique_ptr<SpotSource>> source = open_source(film_place().of_films(films));
    REQUIRE_FALSE(source.ok());
    CHECK(source.error().text().find('\n') == std::string::npos);
    return source.error().text();
}

}  // namespace

TEST_CASE("films without loss are tracked to the same tips as a folder of the same images") {
    const TrackedFilm films = tracked(film_place().of_films(film_place().films("FFV1")));
    CHECK(films.told.size() == filmed_frames);
    CHECK(films.lost == 0);
    CHECK(farthest_apart(films, from_folder()) == 0.0);
}

TEST_CASE("compressed films cost some micrometres at the tip") {
    const double apart_mm = farthest_apart(tracked(film_place().of_films(film_place().films("MJPG"))), from_folder());
    MESSAGE("MJPG: " << 1e3 * apart_mm << " um");
    CHECK(apart_mm > 0.0);
    CHECK(apart_mm < 0.05);
}

TEST_CASE("a film that ends early loses its exposures, and the other cameras go on") {
    constexpr std::size_t fewer = 2;
    std::vector<std::string> films = film_place().films("FFV1");
    films[2] = film_place().beside("early.avi");
    write_film(films[2], "FFV1", film_place().sets(), 2, filmed_frames - fewer);
    const TrackedFilm early = tracked(film_place().of_films(films));
    CHECK(early.told.size() == filmed_frames);
    CHECK(early.lost == fewer);
    for (const TrackedBody& body : early.told.back().bodies) {
        CHECK(body.seen == Seen::seen);
        CHECK(body.cameras == static_cast<int>(FilmPlace::cameras()) - 1);
    }
}

TEST_CASE("films that do not belong together are refused before anything is tracked") {
    const FilmPlace& place = film_place();
    std::vector<std::string> films = place.films("FFV1");
    films[4] = place.beside("nowhere.avi");
    CHECK(refusal(films).find("nowhere.avi: camera \"camera5\" cannot be opened (a video file)") != std::string::npos);
    films[4] = place.beside("small.avi");
    FrameSet small = place.sets().front();
    small.frames[4] = {4, 0.0, 640, 512, std::vector<std::uint8_t>(640 * 512)};
    write_film(films[4], "FFV1", {small}, 4, 1);
    CHECK(refusal(films).find("small.avi: an image of 640 x 512 (\"camera5\" has 1280 x 1024)") != std::string::npos);
    films[4] = place.beside("slow.avi");
    write_film(films[4], "FFV1", place.sets(), 4, 2, 60.0);
    CHECK(refusal(films).find("slow.avi: images were taken at 60 a second (120, as those before)") !=
          std::string::npos);
    films.pop_back();
    CHECK(refusal(films).find("5 devices for 6 cameras") != std::string::npos);
}

}  // namespace rhexis::tracking
