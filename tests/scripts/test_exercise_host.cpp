// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"

using namespace rhexis;

namespace {

namespace fs = std::filesystem;

/// A curriculum of its own in a fresh folder, gone at the end.
class Folder {
public:
    explicit Folder(const std::string& curriculum) {
        std::string name = (fs::temp_directory_path() / "rhexis_host_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
        fs::create_directories(path_ / "demo");
        write("curriculum.lua", curriculum);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / "demo" / name) << text; }
    [[nodiscard]] std::string path() const { return (path_ / "demo").string(); }

private:
    fs::path path_;
};

ExerciseOptions options_for(const std::string& curriculum) {
    ExerciseOptions options;
    options.curriculum = curriculum;
    options.root = std::filesystem::current_path().string();
    return options;
}

std::string complaint(const ExerciseOptions& options) {
    const Result<ExerciseHost> host = ExerciseHost::load(options);
    if (host) {
        return {};
    }
    return host.error().text();
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string simple = R"(return exercise {
    title = "Simple", version = 3,
    patient = { age = 70, cataract = "NO4" },
    tissues = { "lens" }, instruments = { "phaco" },
    settings = { phaco = { power_limit = 0.5 } },
    goals = { x = { 1, from = 0, to = 2 } },
    steps = { step "deep" { marks = { { 2, 0, 3.5 } },
        done = function(eye) return eye.tip.depth_mm ~= nil and eye.tip.depth_mm > eye.goal.x end } },
})";

const ObservationSchema schema{{"tip.depth_mm", "mm", ""}, {"tip.touch", "bool", ""}};

}  // namespace

TEST_CASE("the groove curriculum loads by bare name, folder and file, with the same identity") {
    Result<ExerciseHost> by_name = ExerciseHost::load(options_for("groove"));
    REQUIRE_MESSAGE(by_name.ok(), complaint(options_for("groove")));
    Result<ExerciseHost> by_folder = ExerciseHost::load(options_for("curricula/groove/"));
    Result<ExerciseHost> by_file = ExerciseHost::load(options_for("curricula/groove/curriculum.lua"));
    REQUIRE(by_folder.ok());
    REQUIRE(by_file.ok());
    CHECK(by_name.value().identity() == by_folder.value().identity());
    CHECK(by_name.value().identity() == by_file.value().identity());
    CHECK(by_name.value().identity().at("id") == "groove");
    CHECK(by_name.value().identity().at("sha256").get<std::string>().size() == 64);
    CHECK(by_name.value().scene().patient.nuclear_grade == 3.0);
    REQUIRE(by_name.value().scene().instruments.size() == 1);
    CHECK(by_name.value().scene().instruments[0] == "phaco");
}

TEST_CASE("the hash of a curriculum changes with any of its scripts") {
    const Folder folder(simple);
    folder.write("part.lua", "return 1");
    const auto hash = [&] {
        return ExerciseHost::load(options_for(folder.path())).value().identity().at("sha256").get<std::string>();
    };
    const std::string before = hash();
    CHECK(hash() == before);
    folder.write("part.lua", "return 2");
    const std::string changed = hash();
    CHECK(changed != before);
    folder.write("part_test.lua", "return 3");  // a test of it is no part of it
    CHECK(hash() == changed);
}

TEST_CASE("an unknown curriculum or surgeon brings the nearest names") {
    CHECK(holds(complaint(options_for("grove")), "there is no curriculum 'grove' (did you mean 'groove'?)"));
    CHECK(holds(complaint(options_for("")), "no curriculum is named"));
    ExerciseOptions options = options_for("groove");
    options.surgeon = "expret";
    CHECK(holds(complaint(options), "there is no surgeon 'expret' (did you mean expert?)"));
}

TEST_CASE("a curriculum with a mistake is one line with file and line") {
    const Folder a("return exercise {\n title = 'x'\n tissues = {} }");
    CHECK(holds(complaint(options_for(a.path())), "demo/curriculum.lua:3:"));
    const Folder b("while true do end");
    CHECK(holds(complaint(options_for(b.path())), "demo/curriculum.lua:1:"));
    const Folder c("local t = {} for i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end");
    CHECK(holds(complaint(options_for(c.path())), "more memory than its limit"));
    const Folder d("return 3");
    CHECK(holds(complaint(options_for(d.path())), "must end with: return exercise"));
    const Folder e(
        "return exercise { title = 'x', tissues = { 'lens' }, instruments = { 'phaco' }, steps = { step 'a' { done = "
        "'time_s > 1' } },\n"
        " patient = { age = 0/0 } }");
    CHECK(holds(complaint(options_for(e.path())), "demo/curriculum.lua:2: patient: age must be a number"));
    for (const Folder* folder : {&a, &b, &c, &d, &e}) {
        CHECK(!holds(complaint(options_for(folder->path())), "\n"));
    }
}

TEST_CASE("values given with --set are checked and used") {
    const Folder folder(simple);
    ExerciseOptions options = options_for(folder.path());
    options.set = {{"patient.age", "55"}, {"goal.x", "1.5"}, {"phaco.power_limit", "0.25"}};
    const Result<ExerciseHost> host = ExerciseHost::load(options);
    REQUIRE_MESSAGE(host.ok(), complaint(options));
    CHECK(host.value().scene().patient.age == 55.0);
    CHECK(host.value().scene().settings.at("phaco.power_limit") == 0.25);
    options.set = {{"patient.age", "nan"}};
    CHECK(complaint(options) == "--set patient.age=nan: patient.age must be a number");
    options.set = {{"patient.age", "150"}};
    CHECK(holds(complaint(options), "patient.age = 150 is out of range (20 to 95)"));
    options.set = {{"patient.agee", "50"}};
    CHECK(holds(complaint(options), "did you mean patient.age"));
}

TEST_CASE("marks stand in a file beside the curriculum, by the names of steps, and do not decide") {
    const Folder folder(simple);
    const std::string before = hash_of_what_decides(folder.path(), ".");
    folder.write("curriculum.marks.lua", "return { deep = { { 0, 1, 2 }, { 0, 1, 3 } } }");
    CHECK(hash_of_what_decides(folder.path(), ".") == before);
    Result<ExerciseHost> host = ExerciseHost::load(options_for(folder.path()));
    REQUIRE_MESSAGE(host.ok(), complaint(options_for(folder.path())));
    REQUIRE(host.value().start(schema, {"phaco"}).ok());
    REQUIRE(host.value().observe({0.0, {0.1, 0.0}}).ok());
    const Result<std::vector<Vec3>> marks = host.value().marks();
    REQUIRE(marks.ok());
    REQUIRE(marks.value().size() == 2);
    CHECK(marks.value()[1] == Vec3(0.0, 1.0, 3.0));
    folder.write("curriculum.marks.lua", "return { deeep = { { 0, 1, 2 } } }");
    CHECK(holds(complaint(options_for(folder.path())), "curriculum.marks.lua"));
    CHECK(holds(complaint(options_for(folder.path())), "no step 'deeep' (did you mean deep?)"));
    folder.write("curriculum.marks.lua", "return 3");
    CHECK(holds(complaint(options_for(folder.path())), "must end with: return {"));
    folder.write("curriculum.marks.lua", "return { deep = { 1 } }");
    CHECK(holds(complaint(options_for(folder.path())), "marks of deep must be a list of places"));
}

TEST_CASE("an exercise watches observations, gives commands, and reports") {
    const Folder folder(simple);
    Result<ExerciseHost> loaded = ExerciseHost::load(options_for(folder.path()));
    REQUIRE(loaded.ok());
    ExerciseHost& host = loaded.value();
    REQUIRE(host.start(schema, {"phaco"}).ok());
    std::vector<Command> last;
    for (int i = 0; i < 300 && !host.finished(); ++i) {
        const double depth = i < 10 ? std::nan("") : 0.01 * i;
        Result<std::vector<Command>> commands = host.observe({0.01 * i, {depth, 0.0}});
        REQUIRE(commands.ok());
        last = commands.value();
        const Result<std::vector<Vec3>> marks = host.marks();
        REQUIRE(marks.ok());
        REQUIRE(marks.value().size() == (host.finished() ? 0 : 1));
        CHECK((host.finished() || marks.value()[0] == Vec3(2.0, 0.0, 3.5)));
    }
    CHECK(host.finished());
    REQUIRE(!last.empty());
    CHECK(last.back().kind == CommandKind::finish);
    const Result<nlohmann::json> result = host.result();
    REQUIRE(result.ok());
    CHECK(result.value().at("completed") == true);
    CHECK(result.value().at("steps").at(0).at("end_s").get<double>() == doctest::Approx(1.01));
    CHECK(result.value().at("events").is_array());
    CHECK(result.value().at("measures").is_object());
    CHECK(!host.has_surgeon());
}

TEST_CASE("a script that errs ends its exercise with file, line and step, and the report keeps what there is") {
    const Folder folder(R"(return exercise {
    title = "Bad", tissues = { "lens" }, instruments = { "phaco" },
    steps = { step "one" { done = "tip.depth_mm > 0.1" },
              step "two" { done = function(eye) return eye.tip.depth_mm.x end } } })");
    Result<ExerciseHost> loaded = ExerciseHost::load(options_for(folder.path()));
    REQUIRE(loaded.ok());
    ExerciseHost& host = loaded.value();
    REQUIRE(host.start(schema, {"phaco"}).ok());
    std::string text;
    for (int i = 0; i < 100 && text.empty(); ++i) {
        const Result<std::vector<Command>> commands = host.observe({0.01 * i, {0.01 * i, 0.0}});
        if (!commands) {
            text = commands.error().text();
        }
    }
    CHECK(holds(text, "demo/curriculum.lua:4:"));
    CHECK(holds(text, "in step 'two'"));
    CHECK(host.finished());
    REQUIRE(host.result().ok());
    CHECK(host.result().value().at("steps").at(0).at("completed") == true);
    CHECK(host.result().value().at("completed") == false);
}

TEST_CASE("a virtual surgeon moves its instrument, the same way for the same seed") {
    const Folder folder(simple);
    folder.write("surgeon.lua", R"(return function(me)
        me.wait_until(function(seen) return seen end)
        me.take_up({ 0, -6, 3 })
        me.pedal(3)
        me.go(me.see().landmarks.lens_front.position, 4)
    end)");
    const auto way = [&](std::uint64_t seed) {
        ExerciseOptions options = options_for(folder.path());
        options.surgeon = "expert";
        options.seed = seed;
        Result<ExerciseHost> host = ExerciseHost::load(options);
        REQUIRE_MESSAGE(host.ok(), complaint(options));
        REQUIRE(host.value().start(schema, {"phaco"}).ok());
        CHECK(host.value().has_surgeon());
        Percept percept;
        percept.tools.push_back({"phaco", false, {}});
        percept.landmarks = {{"lens_front", true, Vec3(0, 0, 1.9), 0.0}};
        std::vector<DeviceSample> samples;
        for (int i = 0; i < 600; ++i) {
            percept.time_s = 0.01 * i;
            const Result<OperatorStep> now = host.value().operate(percept);
            REQUIRE(now.ok());
            REQUIRE(now.value().samples.size() == 1);
            samples.push_back(now.value().samples[0]);
        }
        return samples;
    };
    const std::vector<DeviceSample> first = way(1);
    const std::vector<DeviceSample> again = way(1);
    const std::vector<DeviceSample> other = way(2);
    CHECK(!first.front().present);
    CHECK(first.back().present);
    CHECK(first.back().pedal == 3.0);
    CHECK((first.back().pose.position - Vec3(0, 0, 1.9)).norm() < 1.5);
    CHECK(first.back().pose.orientation.norm() == doctest::Approx(1.0));
    bool differs = false;
    for (std::size_t i = 0; i < first.size(); ++i) {
        CHECK(first[i].pose.position == again[i].pose.position);
        differs = differs || first[i].pose.position != other[i].pose.position;
    }
    CHECK(differs);
}

TEST_CASE("a plan with a mistake names its file and line") {
    const Folder folder(simple);
    folder.write("surgeon.lua", "return function(me)\n me.jump(3)\nend");
    ExerciseOptions options = options_for(folder.path());
    options.surgeon = "novice";
    Result<ExerciseHost> host = ExerciseHost::load(options);
    REQUIRE(host.ok());
    REQUIRE(host.value().start(schema, {"phaco"}).ok());
    const Result<OperatorStep> samples = host.value().operate(Percept{});
    REQUIRE(!samples.ok());
    CHECK(holds(samples.error().text(), "demo/surgeon.lua:2:"));
}
