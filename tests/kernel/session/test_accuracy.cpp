// SPDX-License-Identifier: GPL-3.0-or-later
// Error budgets: the cheapest row of a table that keeps them, and what is said where there is none.
#include <doctest/doctest.h>

#include <fstream>

#include "session/accuracy_quantities.hpp"
#include "session/choose_accuracy.hpp"
#include "session/recording.hpp"
#include "support/folder.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

constexpr const char* head = "# rhexis accuracy table 1\n# machine: a table of this test\n";

/// Of the lens: coarse and cheap, fine and dear; what is coarsest is near the answer by chance.
constexpr const char* lens_rows =
    "way,not_with,patient.tetrahedra,step_ms,cost,volume,force,depth\n"
    "explicit,,500,10,0.1,0.01,4,0.02\n"
    "explicit,,1000,10,0.2,0.3,2,0.02\n"
    "explicit,,1000,20,0.15,0.3,2.1,0.02\n"
    "explicit,,3000,10,0.4,0.2,0.7,0.02\n"
    "explicit,,6000,10,0.8,0.09,0.5,0.02\n"
    "explicit,,6000,5,1.2,0.05,0.4,0.02\n"
    "implicit,chamber,6000,10,0.5,0.04,0.3,\n";
constexpr const char* chamber_rows = "step_ms,cost,pressure\n20,0.001,0.001\n10,0.001,0.001\n5,0.001,0.001\n";

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

/// A folder with tables of the lens and of the chamber.
struct Tables {
    Tables() {
        write(folder / "lens.csv", std::string(head) + lens_rows);
        write(folder / "chamber.csv", std::string(head) + chamber_rows);
    }
    [[nodiscard]] Result<SceneAccuracy> choose(const SceneDescription& scene, const AccuracyWish& wish) const {
        const Result<std::vector<AccuracyTable>> tables = read_accuracy_tables(path(), scene);
        return tables ? choose_accuracy(scene, wish, tables.value()) : tables.error();
    }
    [[nodiscard]] std::string path() const { return std::filesystem::path(folder / "lens.csv").parent_path().string(); }
    Folder folder;
};

SceneDescription scene_of_tissues(std::vector<std::string> tissues) {
    SceneDescription scene;
    scene.tissues = std::move(tissues);
    scene.instruments = {"phaco"};
    return scene;
}

SceneDescription phaco_scene() { return scene_of_tissues({"lens", "bag", "capsule", "iris", "cornea", "chamber"}); }

double tetrahedra(const SceneAccuracy& accuracy) {
    for (const ModelAccuracy& model : accuracy.models) {
        if (model.model == "lens") {
            return model.mesh.at("patient.tetrahedra");
        }
    }
    return 0.0;
}

AccuracyWish wish_of(std::map<std::string, double> budget) {
    AccuracyWish wish;
    wish.budget = std::move(budget);
    wish.where = "my/curriculum.lua:7";
    return wish;
}

}  // namespace

TEST_SUITE("error budgets") {
    TEST_CASE("the cheapest mesh and step that keeps every quantity is chosen") {
        const Tables tables;
        const auto chosen = [&tables](std::map<std::string, double> budget) {
            const Result<SceneAccuracy> found = tables.choose(phaco_scene(), wish_of(std::move(budget)));
            REQUIRE_MESSAGE(found.ok(), (found.ok() ? "" : found.error().text()));
            return found.value();
        };
        CHECK(tetrahedra(chosen({{"volume", 0.5}, {"force", 5.0}})) == 500);
        CHECK(tetrahedra(chosen({{"volume", 0.5}, {"force", 2.0}})) == 1000);
        CHECK(tetrahedra(chosen({{"volume", 0.5}, {"force", 1.0}})) == 3000);
        CHECK(tetrahedra(chosen({{"volume", 0.1}, {"force", 1.0}})) == 6000);
        CHECK(chosen({{"volume", 0.1}, {"force", 1.0}}).step_s == 0.01);
        const SceneAccuracy fine = chosen({{"volume", 0.06}, {"force", 1.0}});
        CHECK(tetrahedra(fine) == 6000);
        CHECK(fine.step_s == 0.005);
        CHECK(expected_cost(fine) == doctest::Approx(1.201));
        const SceneAccuracy slow = chosen({{"volume", 0.5}, {"force", 2.2}, {"time", 0.02}});
        CHECK(slow.step_s == 0.02);
        CHECK(tetrahedra(slow) == 1000);
    }

    TEST_CASE("what is coarse and near the answer by chance is not believed") {
        const Tables tables;
        const Result<AccuracyTable> lens = read_accuracy_table(tables.path(), "lens");
        REQUIRE(lens.ok());
        CHECK(expected_error(lens.value(), lens.value().rows[0], "volume").value() == 0.3);
        CHECK(expected_error(lens.value(), lens.value().rows[0], "force").value() == 4.0);
        AccuracyRow between = lens.value().rows[1];
        between.mesh["patient.tetrahedra"] = 1500.0;
        between.step_s = 0.008;
        CHECK(expected_error(lens.value(), between, "force").value() == 2.0);
        CHECK(expected_cost_of(lens.value(), between) == 1.2);
        CHECK_FALSE(expected_error(lens.value(), lens.value().rows[6], "depth").has_value());
        between.mesh["patient.tetrahedra"] = 400.0;
        CHECK_FALSE(expected_error(lens.value(), between, "force").has_value());
    }

    TEST_CASE("a way that knows nothing of a tissue is for scenes without it, and is what is set") {
        const Tables tables;
        SceneDescription scene = scene_of_tissues({"lens", "bag", "iris"});
        const Result<SceneAccuracy> chosen = tables.choose(scene, wish_of({{"volume", 0.1}, {"force", 1.0}}));
        REQUIRE(chosen.ok());
        CHECK(chosen.value().models[0].way == "implicit");
        CHECK_FALSE(chosen.value().models[0].budget.contains("depth"));
        set_accuracy(chosen.value(), scene);
        CHECK(scene.advance == Advance::implicit);
        CHECK(scene.patient.tetrahedra == 6000);
        CHECK(scene.step_s == 0.01);
    }

    TEST_CASE("what stands by hand stays, with what it is expected to be off by and what the budget would take") {
        const Tables tables;
        SceneDescription scene = phaco_scene();
        scene.patient.tetrahedra = 1000;
        AccuracyWish wish = wish_of({{"volume", 0.1}, {"force", 1.0}});
        wish.by_hand = {"patient.tetrahedra"};
        const Result<SceneAccuracy> chosen = tables.choose(scene, wish);
        REQUIRE(chosen.ok());
        CHECK(tetrahedra(chosen.value()) == 1000);
        CHECK(chosen.value().step_s == 0.01);
        const ModelAccuracy& lens = chosen.value().models[1];
        CHECK(lens.by_hand);
        CHECK(lens.expected.at("volume") == 0.3);
        CHECK(lens.instead.at("patient.tetrahedra") == 6000);
        wish.step_s = 0.02;
        CHECK(tables.choose(scene, wish).value().step_s == 0.02);
        CHECK(tables.choose(scene, wish).value().step_by_hand);
        scene.patient.tetrahedra = 400;  // coarser than any row: nobody knows
        CHECK(tables.choose(scene, wish).value().models[1].expected.empty());
    }

    TEST_CASE("a scene without a model that has a table takes the longest step that time allows") {
        const Tables tables;
        const SceneDescription scene = scene_of_tissues({"iris", "cornea"});
        CHECK(tables.choose(scene, {}).value().step_s == 0.01);
        CHECK(tables.choose(scene, wish_of({{"time", 0.004}})).value().step_s == 0.002);
        CHECK(tables.choose(scene, {}).value().models.empty());
    }

    TEST_CASE("a budget that nothing meets is told in one line, with the nearest there is") {
        const Tables tables;
        const Result<SceneAccuracy> chosen = tables.choose(phaco_scene(), wish_of({{"volume", 0.01}, {"force", 1.0}}));
        REQUIRE_FALSE(chosen.ok());
        CHECK(chosen.error().text() ==
              "my/curriculum.lua:7: accuracy: no mesh and step of the lens keeps depth 0.05, force 1, volume 0.01 (the "
              "nearest is depth 0.02, force 0.4, volume 0.05 with patient.tetrahedra = 6000, 5 ms, explicit)");
    }

    TEST_CASE("a quantity that nothing in the scene is judged by is told in one line") {
        const Tables tables;
        const Result<SceneAccuracy> chosen = tables.choose(phaco_scene(), wish_of({{"tear", 0.1}}));
        REQUIRE_FALSE(chosen.ok());
        CHECK(chosen.error().text() ==
              "my/curriculum.lua:7: accuracy: nothing in this scene is judged by tear (one of depth, force, pressure, "
              "time, volume)");
    }

    TEST_CASE("tables that are missing, of another version or no tables are told in one line") {
        const Tables tables;
        const std::string path = tables.folder / "lens.csv";
        const auto complaint = [&](const std::string& text) {
            write(path, text);
            const Result<AccuracyTable> read = read_accuracy_table(tables.path(), "lens");
            REQUIRE_FALSE(read.ok());
            const std::string told = read.error().text();
            CHECK(told.find('\n') == std::string::npos);
            CHECK(told.find(path) != std::string::npos);
            return told;
        };
        CHECK(complaint("# rhexis accuracy table 2\n").find("has version 2 (this program reads version 1") !=
              std::string::npos);
        CHECK(complaint("way,step_ms\n").find("this is no accuracy table") != std::string::npos);
        CHECK(complaint("").find("this is no accuracy table") != std::string::npos);
        CHECK(complaint(head).find("has no rows") != std::string::npos);
        CHECK(complaint(std::string(head) + "step_ms,force\n").find(":3: the table lacks the column cost") !=
              std::string::npos);
        CHECK(complaint(std::string(head) + "step_ms,cost,forse\n")
                  .find("the column forse is no quantity (did you mean "
                        "'force'?)") != std::string::npos);
        CHECK(complaint(std::string(head) + "step_ms,cost\n10\n").find(":4: the row has 1 fields") !=
              std::string::npos);
        CHECK(complaint(std::string(head) + "step_ms,cost\n10,-1\n").find("cost is '-1'") != std::string::npos);
        CHECK(complaint(std::string(head) + "step_ms,cost\n10,nan\n").find("cost is 'nan'") != std::string::npos);
        std::filesystem::remove(path);
        const Result<AccuracyTable> missing = read_accuracy_table(tables.path(), "lens");
        REQUIRE_FALSE(missing.ok());
        CHECK(missing.error().text().find("the accuracy table of lens cannot be read") != std::string::npos);
    }

    TEST_CASE("what was chosen is in the recording") {
        const Tables tables;
        SceneDescription scene = scene_of_tissues({"iris", "cornea", "chamber"});
        set_accuracy(tables.choose(scene, wish_of({{"time", 0.02}})).value(), scene);
        Result<Session> session = Session::create(scene, 1);
        REQUIRE(session.ok());
        const std::string path = tables.folder / "recording.rhx";
        Result<RecordingWriter> writer = RecordingWriter::create(path, header_of(session.value()));
        REQUIRE(writer.ok());
        REQUIRE(writer.value().add(RecordedStart{session.value().observation(), session.value().state_hash()}).ok());
        session.value().step({}, {});
        REQUIRE(writer.value()
                    .add(RecordedStep{1, {}, {}, session.value().observation(), session.value().state_hash()})
                    .ok());
        REQUIRE(writer.value().finish().ok());
        const Result<Recording> read = read_recording(path);
        REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().text()));
        const SceneAccuracy& kept = read.value().header.scene.accuracy;
        CHECK(kept.step_s == 0.02);
        CHECK(kept.time_s == 0.02);
        REQUIRE(kept.models.size() == 1);
        CHECK(kept.models[0].model == "chamber");
        CHECK(kept.models[0].expected.at("pressure") == 0.001);
        CHECK(kept.models[0].budget.at("pressure") == 0.01);
        CHECK(kept.models[0].machine == "a table of this test");
    }

    TEST_CASE("the committed tables are read, and every model's own budget is met by its table") {
        for (const AccuracyModel& model : accuracy_models()) {
            CAPTURE(std::string(model.tissue));
            SceneDescription scene = scene_of_tissues({std::string(model.tissue)});
            for (const std::string_view more : {model.with, model.quantities[0].with}) {
                if (!more.empty()) {
                    scene.tissues.emplace_back(more);
                }
            }
            const Result<std::vector<AccuracyTable>> read = read_accuracy_tables("assets/accuracy", scene);
            REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : read.error().text()));
            const Result<SceneAccuracy> chosen = choose_accuracy(scene, {}, read.value());
            REQUIRE_MESSAGE(chosen.ok(), (chosen.ok() ? "" : chosen.error().text()));
            CHECK(expected_cost(chosen.value()) > 0.0);
            for (const AccuracyTable& table : read.value()) {
                CHECK_FALSE(table.machine.empty());
                CHECK_FALSE(table.answer.empty());
            }
        }
    }
}
