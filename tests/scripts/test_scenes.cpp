// SPDX-License-Identifier: GPL-3.0-or-later
// No more than a scene needs: what each exercise builds, steps and draws, by tests/scripts/scenes.json. What is
// simulated more than stands there is a mistake of the exercise or of the kernel; if it is meant, it is written there.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "lua/exercise_host.hpp"
#include "scenes/scene_parts.hpp"

using namespace rhexis;

namespace {

constexpr int steps = 5;

nlohmann::json expected_scenes() {
    std::ifstream file("tests/scripts/scenes.json");
    return nlohmann::json::parse(file);
}

std::string joined(const nlohmann::json& names) {
    std::string text;
    for (const auto& name : names) {
        text += (text.empty() ? "" : " ") + name.get<std::string>();
    }
    return text;
}

/// Names of the exercises; an operation is made of them.
std::set<std::string> exercises() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator("curricula")) {
        const std::string name = entry.path().filename();
        if (std::filesystem::exists(entry.path() / "curriculum.lua") && name != "full_operation") {
            names.insert(name);
        }
    }
    return names;
}

}  // namespace

TEST_CASE("each exercise builds, steps and draws what it needs, and no more") {
    const nlohmann::json scenes = expected_scenes();
    std::set<std::string> expected;
    for (const auto& [name, scene] : scenes.items()) {
        expected.insert(name);
    }
    CHECK(expected == exercises());
    for (const std::string& name : exercises()) {
        CAPTURE(name);
        const Result<ExerciseHost> host =
            ExerciseHost::load({name, "none", 1, {}, std::filesystem::current_path().string()});
        REQUIRE_MESSAGE(host.ok(), (host.ok() ? "" : host.error().text()));
        Result<Session> session = Session::create(host.value().scene(), 1);
        REQUIRE_MESSAGE(session.ok(), (session.ok() ? "" : session.error().text()));
        for (int i = 0; i < steps; ++i) {
            session.value().step({}, {});
        }
        const scenes::SceneParts parts = scenes::parts_of(session.value());
        const nlohmann::json scene = scenes.value(name, nlohmann::json::object());
        CHECK(joined(parts.built) == joined(scene.value("built", nlohmann::json::array())));
        CHECK(joined(parts.stepped) == joined(scene.value("stepped", nlohmann::json::array())));
        CHECK(joined(parts.drawn) == joined(scene.value("drawn", nlohmann::json::array())));
    }
}
