// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/curricula.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "fuzz/mutate.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_host.hpp"
#include "lua/operation_script.hpp"
#include "session/session.hpp"

namespace rhexis::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr int simulated_steps = 10;

/// As coarse as the settings allow: what is tried is the script, not the mesh.
const std::map<std::string, std::string> coarse{{"patient.tetrahedra", "500"},
                                                {"capsule.triangles", "200"},
                                                {"bag.triangles", "300"},
                                                {"implant.triangles", "400"}};

ExerciseOptions options_of(const std::string& curriculum, const std::string& surgeon, std::uint64_t seed,
                           const std::string& root) {
    return {curriculum, surgeon, seed, coarse, root};
}

Result<Base> make_base(const std::string& root, const std::string& name, int steps) {
    Base base;
    base.name = name;
    const Result<std::string> text = read_script(root + "/curricula/" + name + "/curriculum.lua");
    Result<ExerciseHost> host = ExerciseHost::load(options_of(name, "random", 1, root));
    if (!text || !host) {
        return text ? host.error() : text.error();
    }
    base.text = text.value();
    base.scene = host.value().scene();
    Result<Session> session = Session::create(base.scene, 1);
    if (!session) {
        return session.error();
    }
    base.schema = session.value().schema();
    const Status started = host.value().start(base.schema, base.scene.instruments);
    if (!started) {
        return started.error();
    }
    for (int step = 0; step < steps; ++step) {
        base.seen.push_back(session.value().observation());
        const Result<std::vector<Command>> commands = host.value().observe(session.value().observation());
        const Result<OperatorStep> done = host.value().operate(session.value().percept());
        if (!commands || !done) {
            return commands ? done.error() : commands.error();
        }
        session.value().step(done.value().samples, commands.value());
    }
    return base;
}

bool same_scene(const SceneDescription& a, const SceneDescription& b) {
    return a.tissues == b.tissues && a.instruments == b.instruments && a.settings == b.settings &&
           a.step_s == b.step_s && a.advance == b.advance && a.patient.age == b.patient.age &&
           a.patient.nuclear_grade == b.patient.nuclear_grade && a.patient.pupil_mm == b.patient.pupil_mm &&
           a.patient.side == b.patient.side && a.patient.cortical_opacity == b.patient.cortical_opacity;
}

/// Whether an error is what a user may get: one line that says something.
std::string fault_of(const Error& error) {
    const std::string text = error.text();
    if (text.empty()) {
        return "an empty error";
    }
    return text.find('\n') == std::string::npos ? "" : "an error of several lines: " + text;
}

/// What was seen, over and over with time going on; now and then a measure is what no eye shows.
Observation look(const Base& base, const std::vector<std::size_t>& places, std::uint64_t step, double step_s,
                 Random& random) {
    const Observation& seen = base.seen[step % base.seen.size()];
    Observation row;
    row.time_s = static_cast<double>(step) * step_s;
    for (const std::size_t place : places) {
        row.values.push_back(place < seen.values.size() ? seen.values[place]
                                                        : std::numeric_limits<double>::quiet_NaN());
    }
    if (!row.values.empty() && pick(random, 20) == 0) {
        static constexpr double odd[] = {0.0, 1.0, -1e300, 1e300, 1e-300, 1e9};
        row.values[pick(random, row.values.size())] = odd[pick(random, 6)];
    }
    return row;
}

/// Where each measure of a schema stands in the base's; its size where it does not.
std::vector<std::size_t> places_in(const ObservationSchema& schema, const ObservationSchema& base) {
    std::vector<std::size_t> places;
    for (const MeasureInfo& info : schema) {
        std::size_t at = 0;
        while (at < base.size() && base[at].name != info.name) {
            ++at;
        }
        places.push_back(at);
    }
    return places;
}

Outcome watch(const CurriculaPlan& plan, const Base& base, ExerciseHost host, const ObservationSchema& schema,
              Random& random) {
    const Status started = host.start(schema, host.scene().instruments);
    if (!started) {
        return {"refused", 0, fault_of(started.error())};
    }
    const std::vector<std::size_t> places = places_in(schema, base.schema);
    Outcome outcome{"watched", 0, ""};
    while (outcome.steps < plan.steps && !host.finished()) {
        const Result<std::vector<Command>> commands =
            host.observe(look(base, places, outcome.steps, host.scene().step_s, random));
        if (!commands) {
            outcome.kind = "stopped";
            outcome.fault = fault_of(commands.error());
            break;
        }
        ++outcome.steps;
    }
    if (outcome.kind == "watched" && outcome.steps < plan.steps) {
        outcome.kind = "ended";
    }
    const Result<nlohmann::json> result = host.result();
    if (!result && outcome.fault.empty()) {
        outcome.fault = outcome.kind == "stopped" ? fault_of(result.error()) : "no result: " + result.error().text();
    }
    return outcome;
}

/// The same with a real eye and the random operator, for a few steps.
std::string simulate(const std::string& folder, const CurriculaPlan& plan, std::uint64_t number) {
    Result<ExerciseHost> host = ExerciseHost::load(options_of(folder, "random", number, plan.root));
    Result<Session> session = host ? Session::create(host.value().scene(), number) : Result<Session>(host.error());
    if (!session) {
        return fault_of(session.error());
    }
    const Status started = host.value().start(session.value().schema(), session.value().scene().instruments);
    for (int step = 0; started && step < simulated_steps; ++step) {
        const Result<std::vector<Command>> commands = host.value().observe(session.value().observation());
        const Result<OperatorStep> done = host.value().operate(session.value().percept());
        if (!commands || !done) {
            break;
        }
        session.value().step(done.value().samples, commands.value());
        for (const double value : session.value().observation().values) {
            if (std::isinf(value)) {
                return "a measure is infinite";
            }
        }
    }
    return "";
}

}  // namespace

Result<std::vector<Base>> make_bases(const std::string& root, int steps) {
    std::vector<Base> bases;
    for (const std::string& name : curricula_in(root)) {
        const Result<std::optional<Operation>> operation = load_operation(name, root);
        if (!operation) {
            return operation.error();
        }
        if (operation.value()) {
            continue;  // its parts are here already
        }
        Result<Base> base = make_base(root, name, steps);
        if (!base) {
            return Error{name + ": " + base.error().text(), "", ""};
        }
        bases.push_back(std::move(base).value());
    }
    return bases;
}

Outcome curriculum_case(const CurriculaPlan& plan, std::uint64_t number) {
    Random random(plan.seed * 1'000'003 + number);
    const Base& base = (*plan.bases)[pick(random, plan.bases->size())];
    const std::size_t way = pick(random, 10);
    const std::string text = way < 2   ? mutate_bytes(base.text, random)
                             : way < 5 ? mutate_tokens(base.text, random)
                                       : mutate_meaning(base.text, random);
    const std::string folder = plan.work + "/case";
    fs::create_directories(folder);
    std::ofstream(folder + "/curriculum.lua", std::ios::binary) << text;
    Result<ExerciseHost> host = ExerciseHost::load(options_of(folder, "none", number, plan.root));
    if (!host) {
        return {"refused", 0, fault_of(host.error())};
    }
    ObservationSchema schema = base.schema;
    if (!same_scene(host.value().scene(), base.scene)) {
        Result<Session> session = Session::create(host.value().scene(), number);
        if (!session) {
            return {"refused", 0, fault_of(session.error())};
        }
        schema = session.value().schema();
    }
    Outcome outcome = watch(plan, base, std::move(host).value(), schema, random);
    if (outcome.fault.empty() && outcome.kind != "refused" && number % plan.simulate_each == 0) {
        outcome.fault = simulate(folder, plan, number);
    }
    return outcome;
}

}  // namespace rhexis::fuzz
