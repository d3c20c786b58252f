// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/random_tears.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/capsule_scene.hpp"
#include "scenes/sheet_accounts.hpp"
#include "tools/rhexis_tools.hpp"
#include "topology/tear.hpp"

namespace rhexis::scenes {
namespace {

constexpr int needle = 0;
constexpr int jaws = 1;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// One sheet and what is done to it.
class Tearing {
public:
    Tearing(const RandomTearsTask& task, int number, Rng& rng, RandomTears& found)
        : task_(task),
          rng_(rng),
          found_(found),
          // every other one with fibres, along which tearing is cheaper
          scene_(68.0, {.triangles = task.triangles, .circles = number % 2 == 1, .toughness = 0.2},
                 {cystotome(), capsulorhexis_forceps()}),
          accounts_(scene_.model()) {}

    /// Until it is all torn, its time is over, or something is wrong.
    void run() {
        for (int i = 0; i < task_.longest_sheet && found_.operations < task_.operations; ++i) {
            ++found_.operations;
            if (rng_.uniform() < task_.by_instrument) {
                operate();
            } else {
                ask();
            }
            if (i % 50 == 49) {
                note(accounts_.descent_fault(sheet()));
            }
            if (!found_.fault.empty()) {
                return;
            }
            if (sheet().area_out > 0.0) {
                ++found_.taken_out;
                break;
            }
            if (10 * inner_edges(*sheet().sheet) < inner_edges(*scene_.model().sheet)) {
                ++found_.torn_up;
                return;
            }
        }
        note(accounts_.descent_fault(sheet()));
    }

    [[nodiscard]] const std::vector<Vec3>& places() { return sheet().position; }

private:
    MembraneState& sheet() { return scene_.sheet(); }
    int any(std::size_t count) {
        return std::min(static_cast<int>(rng_.uniform() * static_cast<double>(count)), static_cast<int>(count) - 1);
    }
    Vec3 any_way() { return 2.0 * uniform3(rng_) - Vec3::Ones(); }

    void note(const std::string& fault) {
        if (found_.fault.empty() && !fault.empty()) {
            found_.fault = "sheet " + std::to_string(found_.sheets) + ", operation " +
                           std::to_string(found_.operations) + ": " + fault;
        }
    }

    Result<MembraneEdit> mad_edit() {
        const MembraneState& state = sheet();
        const int nodes = static_cast<int>(state.sheet->mesh.nodes.size());
        const int triangles = static_cast<int>(state.sheet->mesh.triangles.size());
        const Vec3 place = state.sheet->mesh.nodes[at(any(at(nodes)))];
        switch (any(5)) {
            case 0:
                return tear(scene_.model(), state, static_cast<int>(state.tips.size()), any_way());
            case 1:
                return notch(scene_.model(), state, nodes + any(9), any_way());
            case 2:
                return puncture(scene_.model(), state, -1 - any(9), place, any_way());
            case 3:
                return puncture(scene_.model(), state, any(at(triangles)), place, Vec3(not_a_number, 1.0, 0.0));
            default:
                return notch(scene_.model(), state, any(at(nodes)), Vec3::Zero());
        }
    }

    Result<MembraneEdit> any_edit() {
        const MembraneState& state = sheet();
        const TriMesh& mesh = state.sheet->mesh;
        const double choice = rng_.uniform();
        if (choice < 0.6 && !state.tips.empty()) {
            const int tip = any(state.tips.size());
            // more often on than back
            return tear(scene_.model(), state, tip, state.tips[at(tip)].direction + 1.5 * any_way());
        }
        if (choice < 0.8) {
            return notch(scene_.model(), state, any(mesh.nodes.size()), any_way());
        }
        const int triangle = any(mesh.triangles.size());
        return puncture(scene_.model(), state, triangle, triangle_middle(mesh, triangle) + 0.3 * any_way(), any_way());
    }

    /// An edit, by topology alone.
    void ask() {
        const bool mad = rng_.uniform() < 0.03;
        const Result<MembraneEdit> edit = mad ? mad_edit() : any_edit();
        if (!edit.ok()) {
            ++found_.refused;
            found_.mad += mad ? 1 : 0;
            note(edit.error().what.empty() ? "refused without a word" : "");
            return;
        }
        note(mad ? "was not refused" : "");
        ++found_.edits;
        const double before = elastic_energy(scene_.model(), sheet());
        sheet() = applied(sheet(), edit.value());
        const double after = elastic_energy(scene_.model(), sheet());
        found_.elastic_off = std::max(found_.elastic_off, std::abs(after - before) / std::max(before, 1e-3));
        note(accounts_.look(sheet(), found_));
    }

    /// To somewhere, in so many steps of 10 ms.
    void lead(int tool, const Vec3& to, int steps, double jaw) {
        const Vec3 from = scene_.tool(tool).pose.position;
        for (int i = 1; i <= steps; ++i) {
            const std::shared_ptr<const MembraneSheet> before = sheet().sheet;
            const Vec3 place = from + (to - from) * (static_cast<double>(i) / steps);
            ++found_.steps;
            found_.given_up += scene_.lead(tool, place, 1e6, jaw) ? 0 : 1;
            if (sheet().area_out > 0.0) {
                note(accounts_.taken_out_fault(sheet()));
            } else if (sheet().sheet != before) {
                ++found_.torn_by_pull;
                note(accounts_.look(sheet(), found_));
            } else {
                note(accounts_.motion_fault(sheet()));
            }
        }
    }

    Vec3 above_something() {
        return sheet().position[at(any(sheet().position.size()))] + 0.1 * rng_.uniform() * Vec3::UnitZ();
    }

    /// Inside the eye.
    static Vec3 kept_in(const Vec3& place) {
        return place.cwiseMax(Vec3(-4.5, -4.5, -1.0)).cwiseMin(Vec3(4.5, 4.5, 4.0));
    }

    void operate() {
        const double choice = rng_.uniform();
        if (choice < 0.1) {
            stab();
        } else if (choice < 0.45 || sheet().grips.empty()) {
            grasp();
        } else {
            ++found_.pulls;
            const Vec3 to = kept_in(scene_.tool(jaws).pose.position + 1.0 * any_way());
            lead(jaws, to, 2 + any(6), 0.0);
        }
    }

    void grasp() {
        scene_.withdraw(needle);
        const Vec3 place = above_something();
        scene_.put(jaws, place, 1.0);
        lead(jaws, place, 1, 1.0);  // lets go of what they held
        lead(jaws, place, 1, 0.0);
        found_.grasps += sheet().grips.empty() ? 0 : 1;
    }

    void stab() {
        scene_.withdraw(jaws);
        const Vec3 place = above_something();
        const int before = scene_.punctures;
        scene_.put(needle, place + 0.2 * Vec3::UnitZ());
        lead(needle, place - 0.6 * Vec3::UnitZ(), 8, 0.0);
        lead(needle, kept_in(scene_.tool(needle).pose.position + Vec3(0.7, 0.7, 0.0).cwiseProduct(any_way())), 8, 0.0);
        found_.punctures += scene_.punctures - before;
        scene_.withdraw(needle);
    }

    const RandomTearsTask& task_;
    Rng& rng_;
    RandomTears& found_;
    CapsuleScene scene_;
    SheetAccounts accounts_;
};

/// FNV-1a.
void add_print(const std::vector<Vec3>& places, std::uint64_t& print) {
    for (const Vec3& place : places) {
        for (const double number : {place.x(), place.y(), place.z()}) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            print = (print ^ bits) * 1099511628211ULL;
        }
    }
}

}  // namespace

RandomTears random_tears(const RandomTearsTask& task) {
    RandomTears found;
    found.print = 14695981039346656037ULL;
    Rng rng(task.seed, "random tears");
    while (found.operations < task.operations && found.fault.empty()) {
        const std::unique_ptr<Tearing> tearing =
            std::make_unique<Tearing>(task, static_cast<int>(found.sheets++), rng, found);
        tearing->run();
        add_print(tearing->places(), found.print);
    }
    return found;
}

}  // namespace rhexis::scenes
