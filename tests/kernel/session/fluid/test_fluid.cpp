// SPDX-License-Identifier: GPL-3.0-or-later
// A session with chamber, capsule and moving iris: what it hashes, keeps and balances.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/rng.hpp"
#include "kernel/session/operate.hpp"
#include "session/codec.hpp"
#include "session/settings.hpp"
#include "topology/come_apart.hpp"
#include "topology/remove.hpp"

using namespace rhexis;
using namespace rhexis::test;

namespace {

SceneDescription fluid_scene() {
    SceneDescription scene = small_scene();
    scene.tissues = {"lens", "bag", "capsule", "iris", "cornea", "chamber"};
    scene.instruments = {"phaco", "probe"};
    scene.settings["machine.vacuum_mmhg"] = 400.0;
    return scene;
}

double value(const Session& session, const std::string& name) {
    for (std::size_t i = 0; i < session.schema().size(); ++i) {
        if (session.schema()[i].name == name) {
            return session.observation().values[i];
        }
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// Where the middles of the lens's pieces are.
class LensPieceCentres {
public:
    explicit LensPieceCentres(const Session& session) {
        const std::vector<std::array<int, 4>>& tets = session.world().solids[0].coarse.tets;
        const std::vector<int> pieces = pieces_of(session.world().solids[0], session.state().solids[0]);
        std::map<int, int> count;
        for (std::size_t t = 0; t < pieces.size(); ++t) {
            if (pieces[t] >= 0) {
                Vec3& sum = centres_.emplace(pieces[t], Vec3::Zero()).first->second;
                for (const int node : tets[t]) {
                    sum += 0.25 * session.state().solids[0].position[node];
                }
                ++count[pieces[t]];
            }
        }
        for (auto& [piece, sum] : centres_) {
            sum /= count[piece];
        }
    }

    /// Of the piece that has gone farthest along a direction since then [mm].
    [[nodiscard]] double farthest_along(const Vec3& direction, const LensPieceCentres& before) const {
        double most = -1e9;
        for (const auto& [piece, centre] : centres_) {
            const auto found = before.centres_.find(piece);
            most = found == before.centres_.end() ? most : std::max(most, direction.dot(centre - found->second));
        }
        return most;
    }

private:
    std::map<int, Vec3> centres_;
};

double between(Rng& rng, double low, double high) { return low + (high - low) * rng.uniform(); }

/// Both hands anywhere in the eye, pedals anywhere, at up to 40 mm/s.
void operate_blindly(Session& session, Rng& rng, std::array<Vec3, 2>& tips, std::array<Vec3, 2>& goals, int steps) {
    std::array<DeviceSample, 2> samples;
    for (int i = 0; i < steps; ++i) {
        for (int hand = 0; hand < 2; ++hand) {
            const Vec3 way = goals[hand] - tips[hand];
            if (way.norm() < 0.2) {
                goals[hand] = Vec3(between(rng, -4.0, 4.0), between(rng, -4.0, 4.0), between(rng, -3.5, 3.0));
            }
            tips[hand] += way.normalized() * std::min(way.norm(), between(rng, 0.0, 0.4));
            DeviceSample& sample = samples[hand];
            sample.instrument = hand;
            sample.present = true;
            sample.pose.position = tips[hand];
            sample.pose.orientation = Quat(Eigen::AngleAxisd(1.05, Vec3::UnitX()));
            sample.pedal = i % 50 == 0 ? between(rng, 0.0, 3.0) : sample.pedal;
        }
        session.step(samples, {});
    }
}

}  // namespace

TEST_SUITE("session with fluid") {
    TEST_CASE("irrigation deepens the chamber; what goes in is what leaks and stays") {
        Session session = make_session(fluid_scene());
        const double start = value(session, "chamber.depth_mm");
        DeviceSample sample;
        sample.present = true;
        sample.pose.position = Vec3(0.0, -1.0, 4.0);
        sample.pedal = 1.0;
        for (int i = 0; i < 200; ++i) {
            session.step({&sample, 1}, {});
        }
        CHECK(value(session, "chamber.depth_mm") > start + 0.3);
        CHECK(value(session, "chamber.pressure_mmhg") > 40.0);
        CHECK(value(session, "lens.displacement_mm") < 0.15);  // it is carried, not pushed
        const ChamberState& chamber = *session.state().chamber;
        const ChamberState first = chamber_state(*session.world().chamber, session.world().chamber->rest_pressure, 0.0);
        const double stored = chamber.eye_volume + chamber.tube_volume - first.eye_volume - first.tube_volume;
        CHECK(stored == doctest::Approx(chamber.totals.infused + chamber.totals.vented - chamber.totals.aspirated -
                                        chamber.totals.leaked)
                            .epsilon(1e-9));
    }

    TEST_CASE("a snapshot of all of it, through bytes, goes on with the same hashes") {
        Session session = make_session(fluid_scene());
        operate(session, 60);
        REQUIRE(session.state().removed_mass > 0.0);
        const std::string bytes = encode(session.snapshot());
        const std::optional<Snapshot> read = decode_snapshot(bytes);
        REQUIRE(read);
        Session other = make_session(fluid_scene());
        REQUIRE(other.restore(*read).ok());
        CHECK(other.state_hash() == session.state_hash());
        CHECK(hashes_of(other, 30) == hashes_of(session, 30));
        for (std::size_t cut = 0; cut < bytes.size(); cut += 1 + bytes.size() / 97) {
            CHECK_FALSE(decode_snapshot(std::string_view(bytes).substr(0, cut)));
        }
        // A scene without the fluid does not take it
        CHECK_FALSE(make_session().restore(*read).ok());
        Snapshot wrong = *read;
        wrong.world.capsule->tool = 7;
        CHECK_FALSE(other.restore(wrong).ok());
        wrong = *read;
        wrong.world.chamber->eye_volume = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(other.restore(wrong).ok());
        wrong = *read;
        wrong.world.solids[0].splits.push_back({1 << 20, {0}});
        CHECK_FALSE(other.restore(wrong).ok());
    }

    TEST_CASE("pedal at 2 removes nothing of a whole lens at the vacuum of sculpting, and soft cortex at a high one") {
        const auto removed = [](double vacuum) {
            SceneDescription scene = fluid_scene();
            scene.settings["machine.vacuum_mmhg"] = vacuum;
            Session session = make_session(scene);
            for (int i = 0; i < 150; ++i) {
                DeviceSample sample = hand_at(session, session.time_s() + 0.01);
                sample.pedal = 2.0;
                session.step({&sample, 1}, {});
            }
            CHECK(value(session, "phaco.occlusion") > 0.0);
            return session.state().removed_mass;
        };
        CHECK(removed(100.0) == 0.0);
        CHECK(removed(500.0) > 0.0);
    }

    TEST_CASE("pulses give their share of the power, whatever their rate and the step") {
        const auto emitted = [](double hz, double duty, double step_s) {
            SceneDescription scene = fluid_scene();
            scene.tissues = {"cornea"};
            scene.step_s = step_s;
            scene.settings["phaco.pulse_hz"] = hz;
            scene.settings["phaco.duty"] = duty;
            Session session = make_session(scene);
            DeviceSample sample;
            sample.present = true;
            sample.pose.position = Vec3(0.0, -1.0, 4.0);
            sample.pedal = 3.0;
            for (int i = 0; i < static_cast<int>(std::lround(2.0 / step_s)); ++i) {
                session.step({&sample, 1}, {});
            }
            return value(session, "phaco.cde");
        };
        CHECK(emitted(0.0, 0.5, 0.01) == doctest::Approx(200.0));
        for (const double hz : {3.0, 10.0, 80.0}) {
            for (const double step_s : {0.001, 0.01, 0.02}) {
                CHECK(emitted(hz, 0.4, step_s) == doctest::Approx(80.0).epsilon(0.01));
            }
        }
    }

    TEST_CASE("cortex that adheres holds the lens against a turn that a freed one follows") {
        const auto turn = [](double freed) {
            SceneDescription scene = fluid_scene();
            scene.settings["hydrodissection.freed"] = freed;
            Session session = make_session(scene);
            std::array<DeviceSample, 2> samples;
            samples[1].instrument = 1;
            for (int i = 0; i < 120; ++i) {
                // A probe sunk into the front, off the axis, dragged across
                DeviceSample& probe = samples[1];
                probe.present = true;
                probe.pose.position = Vec3(1.8, -1.0 + 0.015 * i, 1.4);
                session.step(samples, {});
            }
            return std::abs(value(session, "lens.rotation_deg"));
        };
        const double free = turn(1.0);
        const double held = turn(0.0);
        CHECK(free > 5.0);
        CHECK(held < 0.3 * free);
    }

    TEST_CASE("a nucleus cut into quarters: a quarter follows the tip that holds it, more than one that does not") {
        SceneDescription scene = fluid_scene();
        scene.patient.tetrahedra = 1000;
        scene.settings["nucleus.segments"] = 4.0;
        scene.settings["machine.flow_ml_min"] = 35.0;
        scene.settings["machine.bottle_cm"] = 95.0;
        Session session = make_session(scene);
        CHECK(value(session, "fragments.count") == 4.0);
        const double mass = tissue_mass(session);
        const Vec3 over(1.0, -0.9, 2.0);
        const Vec3 deep(1.0, 1.1, -0.4);
        const Vec3 drawn(1.0, 0.3, 0.5);
        const auto lead = [&](Session& eye, int from, int to, double pedal) {
            DeviceSample sample;
            sample.present = true;
            sample.pose.orientation = Quat(Eigen::AngleAxisd(0.9, Vec3::UnitX()));
            for (int i = from; i < to; ++i) {
                const double in = std::clamp((i - 100) / 120.0, 0.0, 1.0);
                const double out = std::clamp((i - 260) / 80.0, 0.0, 1.0);
                sample.pose.position = over + in * (deep - over) + out * (drawn - deep);
                sample.pedal = i < 100 ? 1.0 : (i < 220 ? 2.8 : pedal);
                eye.step({&sample, 1}, {});
            }
        };
        lead(session, 0, 220, 1.0);
        const Snapshot buried = session.snapshot();
        const auto followed = [&](double pedal) {
            REQUIRE(session.restore(buried).ok());
            lead(session, 220, 260, pedal);
            const LensPieceCentres held(session);
            lead(session, 260, 340, pedal);
            CHECK(tissue_mass(session) == doctest::Approx(mass).epsilon(1e-12));
            return LensPieceCentres(session).farthest_along((drawn - deep).normalized(), held);
        };
        const double with = followed(2.0);
        const double without = followed(1.0);
        MESSAGE("follows by " << with << " mm, without vacuum by " << without);
        CHECK(with > 0.12);
        CHECK(without < 0.7 * with);  // a tip that is buried drags it a little
    }

    TEST_CASE("a lens in pieces stays in pieces when implicit steps advance it") {
        SceneDescription scene = small_scene();
        scene.advance = Advance::implicit;
        scene.settings["nucleus.segments"] = 4.0;
        scene.settings["nucleus.trench_mm"] = 1.2;
        Session session = make_session(scene);
        const std::size_t splits = session.state().solids[0].splits.size();
        CHECK(splits > 0);
        operate(session, 30);
        CHECK(session.state().solids[0].splits.size() >= splits);
        CHECK(session.state().solids[0].position.size() == session.world().solids[0].coarse.nodes.size());
        CHECK(validate(session.world().solids[0], session.state().solids[0]).ok());
    }

    TEST_CASE("segments that there are not") {
        SceneDescription scene = fluid_scene();
        scene.settings["nucleus.segments"] = 3.0;
        CHECK(Session::create(scene, 1).error().text().find("settings.nucleus.segments is 3") == 0);
        scene.settings["nucleus.segments"] = 0.0;
        scene.settings["nucleus.trench_mm"] = 1.0;
        CHECK(Session::create(scene, 1).error().text().find("settings.nucleus.trench_mm is 1 without cuts") == 0);
    }

    TEST_CASE("an operator who does anything leaves numbers finite, mass whole, and the same hash twice") {
        std::vector<std::uint64_t> hashes;
        for (int run = 0; run < 2; ++run) {
            Session session = make_session(fluid_scene());
            const double mass = tissue_mass(session);
            Rng rng(3, "blind");
            std::array<Vec3, 2> tips{Vec3(0, -3, 3), Vec3(1, -3, 3)};
            std::array<Vec3, 2> goals = tips;
            operate_blindly(session, rng, tips, goals, 250);
            CHECK(tissue_mass(session) == doctest::Approx(mass).epsilon(1e-12));
            for (const Vec3& node : session.state().solids[0].position) {
                REQUIRE(node.allFinite());
            }
            hashes.push_back(session.state_hash());
        }
        CHECK(hashes[0] == hashes[1]);
    }

    TEST_CASE("what does not go together is refused in one line") {
        SceneDescription scene = fluid_scene();
        scene.advance = Advance::implicit;
        CHECK(Session::create(scene, 1).error().text().find("advance is implicit with a chamber") == 0);
        scene = fluid_scene();
        std::erase(scene.tissues, "bag");
        CHECK(Session::create(scene, 1).error().text().find("tissues names capsule without bag") == 0);
        for (const char* name : {"machine.bottle_cm", "machine.flow_ml_min", "machine.vacuum_mmhg", "phaco.pulse_hz",
                                 "phaco.duty", "capsule.strength", "wound.leak_ml_min"}) {
            for (const double wrong : {-1.0, 1e6, std::numeric_limits<double>::quiet_NaN()}) {
                scene = fluid_scene();
                scene.settings[name] = wrong;
                CHECK(Session::create(scene, 1).error().text().find(std::string("settings.") + name) == 0);
            }
        }
    }

    TEST_CASE("an empty bag, a tool that starts in tissue, and a pedal that is stuck or no number") {
        SceneDescription scene = fluid_scene();
        std::erase(scene.tissues, "lens");
        Session empty = make_session(scene);
        operate(empty, 60);
        CHECK(std::isfinite(value(empty, "chamber.depth_mm")));
        Session inside = make_session(fluid_scene());
        DeviceSample sample;
        sample.present = true;
        sample.pose.position = Vec3(0.0, 0.0, 0.5);
        sample.pose.orientation = Quat(Eigen::AngleAxisd(1.05, Vec3::UnitX()));
        sample.pedal = 3.0;
        for (int i = 0; i < 100; ++i) {
            inside.step({&sample, 1}, {});
        }
        CHECK(inside.state().removed_mass > 0.0);
        for (const Vec3& node : inside.state().solids[0].position) {
            REQUIRE(node.allFinite());
        }
        sample.pedal = std::numeric_limits<double>::quiet_NaN();
        const std::size_t lines = inside.log().size();
        inside.step({&sample, 1}, {});
        inside.step({&sample, 1}, {});
        CHECK(inside.log().size() > lines);
        CHECK(inside.tools()[0].pedal == 3.0);
    }
}
