// SPDX-License-Identifier: GPL-3.0-or-later
// What an instructor lets happen while a person operates: causes, which become commands, a head that moves under hands
// and microscope, and a microscope that is pushed. What follows is simulated.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "flow/command.hpp"
#include "math/types.hpp"

namespace rhexis::station {

/// As scripts/theatre/injections.lua declares it.
struct Injection {
    struct Setting {
        std::string name;
        double to = 0.0;
        double over_s = 0.0;
    };
    struct HeadPlace {
        double time_s = 0.0;
        Vec3 shift = Vec3::Zero();  ///< of the eye [mm]
    };
    std::string id;
    std::string title;
    std::vector<Setting> settings;  ///< one after the other
    std::vector<HeadPlace> head;
    Vec3 microscope = Vec3::Zero();  ///< pushed aside by so much, once [mm]
};

/// From what ExerciseHost::injections gives.
std::vector<Injection> injections_of(const nlohmann::json& listing, bool has_microscope);

class Injector {
public:
    Injector() = default;
    explicit Injector(std::vector<Injection> known) : known_(std::move(known)) {}

    [[nodiscard]] const std::vector<Injection>& known() const { return known_; }
    [[nodiscard]] bool runs(const std::string& id) const { return running_.contains(id); }

    /// The error says what the scene knows. Begun already: nothing more happens.
    Status begin(const std::string& id);
    /// Puts right what was begun: settings go back to what they were, the head comes back.
    void end(const std::string& id);

    /// Time goes on by dt [s]. settings: as they are now. What is to be commanded.
    std::vector<Command> advance(double dt, const std::map<std::string, double>& settings);
    /// Where the head has gone [mm].
    [[nodiscard]] const Vec3& head() const { return head_; }
    /// The microscope is pushed by so much now; asked once.
    std::optional<Vec3> take_push() { return std::exchange(push_, std::nullopt); }

private:
    struct Running {
        double time_s = 0.0;
        std::size_t at = 0;                    ///< setting that is on its way
        double begun_s = 0.0;                  ///< when that was
        std::map<std::string, double> before;  ///< settings
    };

    static void run(const Injection& injection, const std::map<std::string, double>& settings, Running& running,
                    std::vector<Command>& commands);

    std::vector<Injection> known_;
    std::map<std::string, Running> running_;
    std::vector<Command> next_;  ///< of what was begun or ended since the last step
    Vec3 head_ = Vec3::Zero();
    std::optional<Vec3> push_;
};

}  // namespace rhexis::station
