// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "physics/fluid/mouth.hpp"
#include "physics/physics.hpp"
#include "scenes/bodies.hpp"
#include "tools/phaco_tip.hpp"

namespace rhexis::bench {
namespace {

constexpr double held_modulus = 50000.0;  ///< of a soft nucleus [Pa]
constexpr double held_edge = 2.0;         ///< [mm]
constexpr double grown_within = 1.5;      ///< the pull, to three times what suction can hold [s]
constexpr double torn_off = 0.6;          ///< farther than the kernel lets suction reach [mm]

/// One way to hold a cube on.
struct Holding {
    std::string name;
    Advance advance = Advance::explicit_;
    bool by_points = true;  ///< as lenses of exercises that are cut and emulsified
    double power = 0.0;
    bool is_default = false;
};

/// A cube of lens before a blunt mouth, pulled off along its axis by forces on all its nodes.
class PulledCube {
public:
    PulledCube(const Holding& way, int cells, double hold) : hold_(hold) {
        SolidModel cube = scenes::cube(cells, held_edge, held_modulus, 0.45);
        cube.damping_mass = 20.0;
        cube.advance = way.advance;
        cube.formulation = way.advance == Advance::implicit ? Formulation::linear : Formulation::nodal_pressure;
        cube.sought_step = way.advance == Advance::implicit ? 0.0 : 3e-4;
        cube.by_points = way.by_points;
        model_->solids.push_back(cube);
        model_->gravity = Vec3::Zero();
        model_->tools.push_back(phaco_tip());
        model_->tools[0].bevel = 0.0;
        state_ = rest_state(*model_);
        tool_.present = true;
        tool_.pose.position = Vec3(0.0, 0.0, 0.5 * held_edge + 0.02);
        tool_.previous_pose = tool_.pose;
        tool_.power = way.power;
        pull_.nodes.resize(cube.coarse.nodes.size());
        std::iota(pull_.nodes.begin(), pull_.nodes.end(), 0);
        hold_on();
    }

    /// What the tip bore at most, as a share of what suction can hold.
    [[nodiscard]] double borne(double dt) {
        Result<Physics> made = Physics::create(model_, {});
        if (!made) {
            return 0.0;
        }
        Physics physics = std::move(made).value();
        ContactSet contacts;
        Profile profile;
        WorldState next;
        const double start = height();
        double most = 0.0;
        for (double time = 0.5 * dt; time < grown_within && start - height() < torn_off; time += dt) {
            pull_.total = Vec3(0.0, 0.0, -3.0 * hold_ * time / grown_within);
            state_.loads = {pull_};
            if (physics.advance(state_, {&tool_, 1}, dt, next, contacts, profile).failure != StepFailure::none) {
                break;
            }
            std::swap(state_, next);
            hold_on();
            double upward = 0.0;
            for (const Contact& contact : contacts) {
                upward += contact.force.z();
            }
            most = std::max(most, upward);
            simulated_ += dt;
        }
        return most / hold_;
    }

    [[nodiscard]] double simulated() const { return simulated_; }

private:
    void hold_on() {
        TipState& tip = state_.tips[0];
        tip.lens = 1.0;
        tip.open = 0.0;
        tip.hold = hold_;
        tip.suction = hold_ / mouth_probe(model_->tools[0]).area;
    }

    [[nodiscard]] double height() const {
        double sum = 0.0;
        for (const Vec3& node : state_.solids[0].position) {
            sum += node.z();
        }
        return sum / static_cast<double>(state_.solids[0].position.size());
    }

    std::shared_ptr<WorldModel> model_ = std::make_shared<WorldModel>();
    WorldState state_;
    ToolState tool_;
    NodeLoad pull_;
    double hold_;
    double simulated_ = 0.0;
};

ChartPoint point_of_hold(const Holding& way, int cells, double dt, bool is_default, const ChartOptions& options) {
    std::vector<double> borne;
    for (const double mmhg : {50.0, 100.0, 250.0}) {
        const double area = mouth_probe(phaco_tip()).area;
        borne.push_back(PulledCube(way, cells, mmhg * pascal_per_mmhg * area).borne(dt));
    }
    double simulated = 0.0;
    const double seconds = time_interleaved({[&] {
                                                PulledCube cube(way, cells, 5000.0);
                                                static_cast<void>(cube.borne(dt));
                                                simulated = cube.simulated();
                                            }},
                                            std::min(options.repeats, 2))[0]
                               .seconds;
    return point_of(way.name, std::to_string(cells) + " cells, " + milliseconds(dt), is_default,
                    rms_share(borne, {1.0, 1.0, 1.0}), seconds / simulated);
}

std::vector<ChartPoint> measure_suction_grip(const ChartOptions& options) {
    const std::vector<Holding> ways{{"kernel: material points", Advance::explicit_, true, 0.0, true},
                                    {"kernel: vertices of the surface", Advance::explicit_, false},
                                    {"the same with ultrasound: contacts alone", Advance::explicit_, true, 0.01},
                                    {"implicit steps", Advance::implicit, false}};
    std::vector<ChartPoint> points;
    for (const Holding& way : ways) {
        for (const int cells : {2, 3, 4, 6}) {
            for (const double dt : {0.02, 0.01, 0.005}) {
                const bool is_default = way.is_default && cells == 3 && dt == 0.01;
                const bool wanted = options.only_default ? is_default : cells == 3 || dt == 0.01;
                if (wanted) {
                    points.push_back(point_of_hold(way, cells, dt, is_default, options));
                }
            }
        }
    }
    return points;
}

}  // namespace

Chart chart_suction_grip() {
    return {"suction_grip",
            "A cube of lens pulled off a mouth that holds it by 50, 100 and 250 mmHg",
            cpu_per_second,
            "greatest force of the tip on the cube, rms over the vacuums",
            "vacuum times the area of the mouth (statics)",
            true,
            measure_suction_grip};
}

}  // namespace rhexis::bench
