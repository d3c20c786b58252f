// SPDX-License-Identifier: GPL-3.0-or-later
// Gates of one solid that touches nothing.
#include <cmath>

#include "scenes/bodies.hpp"
#include "scenes/explicit_trials.hpp"
#include "scenes/implicit_trials.hpp"
#include "scenes/stability_gates.hpp"

namespace rhexis::scenes {
namespace {

double failed(bool condition) { return condition ? 1.0 : 0.0; }

std::string text(double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    return digits.back() == '.' ? digits + "0" : digits;
}

std::string name_of(BadStart start) {
    return start == BadStart::random ? "random" : start == BadStart::flat ? "flat" : "mirrored";
}

void add(Gates& gates, const std::string& id, const Recovery& found) {
    gates.push_back({id, "share of tetrahedra left inverted", found.finite ? found.inverted_at_end : NAN, 0.0});
    gates.push_back({id, "largest rise of the energy, share of that at the start", found.largest_rise, 1e-6});
    gates.push_back({id, "energy left, share of that at the start", found.energy_left, 1e-5});
}

/// Is the step that the explicit solid states the true limit? shorter: that it may be.
void add_limit(Gates& gates, const std::string& id, const SolidModel& model, double shorter) {
    const Limit limit = probe_limit(model);
    gates.push_back({id + " explicit", "runs away at 0.97 of the stable step (1: yes)", failed(!limit.below), 0.0});
    gates.push_back(
        {id + " explicit", "stays at 1.1 of the limit in double precision (1: yes)", failed(!limit.beyond), 0.0});
    gates.push_back({id + " explicit", "limit in double precision over the stable step",
                     limit.step > 0.0 ? limit.exact / limit.step : NAN, shorter});
}

}  // namespace

Gates gates_of_bad_starts(bool quick) {
    Gates gates;
    const SolidModel lens = default_eye(quick ? 1000 : 3000).lens;
    SolidModel block = cube(4, 2.0, 3000.0, 0.45);
    block.damping_mass = lens.damping_mass;
    block.damping_stiffness = lens.damping_stiffness;
    for (const SolidModel& model : {lens, block}) {
        for (const BadStart start : {BadStart::random, BadStart::flat, BadStart::mirrored}) {
            const std::string id = "T1 " + model.name + " " + name_of(start);
            add(gates, id + " explicit", recover(model, start, quick ? 1.0 : 2.0));
            add(gates, id + " implicit 1 ms", recover_implicit(model, start, quick ? 0.3 : 1.0, 1e-3));
        }
        // mirrored, a step of 10 ms may find a balance with the last few inside out: see docs/stability.md
        for (const BadStart start : {BadStart::random, BadStart::flat}) {
            add(gates, "T1 " + model.name + " " + name_of(start) + " implicit 10 ms",
                recover_implicit(model, start, 1.0, 1e-2));
        }
    }
    return gates;
}

Gates gates_of_big_turns(bool quick) {
    Gates gates;
    const int across = quick ? 2 : 4;
    for (const double dt : {0.01, 1.0, 100.0}) {
        for (const Contortion contortion : {Contortion::bent, Contortion::twisted}) {
            const std::string id =
                std::string(contortion == Contortion::bent ? "T2 bent " : "T2 twisted ").append(text(dt)).append(" s");
            const Untangling found = untangle(contortion, true, across, dt);
            gates.push_back({id, "Newton iterations to 1e-8", static_cast<double>(found.iterations), 20.0});
            gates.push_back({id, "residual left, relative", found.residual, 1e-8});
            gates.push_back({id, "largest residual of an iteration over the one before", found.worst_ratio, 0.99});
        }
    }
    // All of the turn in the last elements, some of them inside out: what falls from iteration to iteration is then the
    // energy along the search, not the residual.
    const Untangling thrown = untangle(Contortion::bent, false, 2, 1.0);
    gates.push_back({"T2 thrown over", "Newton iterations to 1e-8", static_cast<double>(thrown.iterations), 20.0});
    gates.push_back({"T2 thrown over", "share of tetrahedra left inverted", thrown.inverted_end, 0.0});
    return gates;
}

Gates gates_of_stiff_volume(bool quick) {
    Gates gates;
    struct Row {
        double nu;
        double reference;  ///< deflection of C3D10 [mm]
        double ratio;      ///< known share of it that linear tetrahedra reach, three across; 0: not known
    };
    for (const Row& row :
         {Row{0.3, 0.13284, 0.817}, Row{0.45, 0.12847, 0.762}, Row{0.49, 0.12595, 0.687}, Row{0.499, 0.12595, 0.0}}) {
        const std::string id = std::string("T3 nu ").append(text(row.nu));
        add_limit(gates, id, cube(quick ? 3 : 4, 2.0, 3000.0, row.nu), 1.1);
        const Sag found = sag(3, row.nu, row.reference, 1.0);
        gates.push_back({id + " implicit", "iterations of a linear solve to 1e-9",
                         found.converged ? static_cast<double>(found.linear) : NAN, 20.0});
        if (row.ratio > 0.0) {
            gates.push_back({id + " implicit", "deflection against the known share of C3D10, relative",
                             std::abs(found.ratio / row.ratio - 1.0), 0.01});
        }
    }
    return gates;
}

Gates gates_of_slivers(bool quick) {
    Gates gates;
    for (const double nu : {0.3, 0.45, 0.49, 0.499}) {
        for (const double share : {0.05, 0.01}) {
            if (nu > 0.49 && share < 0.05) {
                continue;  // steps of 0.1 us and strains of 1e-4 by rounding alone: no body to be stepped in float
            }
            const std::string id = std::string("T4 nu ").append(text(nu)).append(" sliver ").append(text(share));
            SolidModel model = cube(quick ? 3 : 4, 2.0, 3000.0, nu);
            flatten_one(model, share);
            // shaken by 1 um to find its limit, a sliver of a hundredth is no longer flat: it looks stiffer than it is
            add_limit(gates, id, model, share < 0.05 ? 1.3 : 1.1);
            model.sought_step = 2e-5;
            gates.push_back({id + " explicit, given inertia", "step that is sought over the stable one",
                             model.sought_step / probe_limit(model).step, 1.6});
            const Sag found = sag(3, nu, 0.13, share);
            gates.push_back({id + " implicit", "iterations of a linear solve to 1e-9",
                             found.converged ? static_cast<double>(found.linear) : NAN, 20.0});
        }
    }
    return gates;
}

Gates gates_of_stale_factors(bool quick) {
    Gates gates;
    for (const int steps : {10, quick ? 30 : 100}) {
        const Staleness found = grow_stale(steps);
        const std::string id = std::string("T16 ").append(std::to_string(steps)).append(" steps");
        gates.push_back({id, "iterations a step over those with a new factor", found.stale / found.fresh, 4.0});
        gates.push_back({id, "distance from the solution with new factors, share of the motion",
                         found.difference / found.moved, 1e-8});
    }
    return gates;
}

Gates gates_of_deletion(bool quick) {
    Gates gates;
    const SolidModel lens = default_eye(quick ? 1000 : 3000).lens;
    const Deletion deletion = delete_all(lens, 5, quick ? 20 : 100);
    gates.push_back({"T17 explicit", "removed + left against the start, relative",
                     deletion.finite ? deletion.mass_error : NAN, 1e-12});
    // nothing may get faster than what falls freely all the time that the trial takes
    gates.push_back({"T17 explicit", "fastest node over free fall for a second", deletion.fastest / 9810.0, 0.5});
    gates.push_back(
        {"T17 explicit", "stable step of the whole over the smallest on the way", 1.0 / deletion.smallest_step, 1.7});
    const QuietEnd end = remove_all(lens, 5);
    gates.push_back({"T17 implicit", "removed + left against the start, relative",
                     end.finite && end.converged ? end.mass_error : NAN, 1e-12});
    gates.push_back({"T17 implicit", "fastest node over free fall for a second", end.fastest / 9810.0, 0.5});
    gates.push_back({"T17 implicit", "speed of any node once nothing is left [mm/s]", end.rest_speed, 0.0});
    return gates;
}

Gates gates_of_momentum(bool quick) {
    Gates gates;
    const SolidModel model = cube(3, 2.0, 3000.0, 0.45);
    for (const double share : {0.5, 0.8}) {
        const Flight flight = fly(model, quick ? 5000 : 50000, share);
        const std::string id = std::string("T20 explicit at ").append(text(share));
        // forces are summed in float: their rounding, 6e-8 of each, is what remains
        gates.push_back({id, "momentum lost a step, relative", flight.linear_drift, 2e-8});
        gates.push_back({id, "angular momentum lost a step, relative", flight.angular_drift, 2e-8});
    }
    for (const double dt : {1e-4, 1e-2}) {
        const Drift found = drift(model, quick ? 200 : 1000, dt);
        const std::string id = std::string("T20 implicit ").append(text(1e3 * dt)).append(" ms");
        gates.push_back({id, "momentum lost a step, relative", found.linear, 1e-12});
        gates.push_back({id, "angular momentum lost a step beyond the method's own, relative", found.angular, 1e-12});
    }
    return gates;
}

Gates gates_of_energy(bool quick) {
    Gates gates;
    const SolidModel body = cube(quick ? 2 : 3, 2.0, 3000.0, 0.45);
    const int steps = quick ? 100000 : 1000000;
    for (const double share : {0.5, 0.8}) {
        const double own = drift_in_double(body, steps, share);
        const std::string id = std::string("T21 explicit at ").append(text(share));
        const std::string of = std::string(quick ? "1e5" : "1e6") + " steps, relative, undamped";
        gates.push_back({id, "energy drift of the method itself, in double precision, of " + of, std::abs(own), 0.02});
        // what single precision adds: see docs/stability.md
        gates.push_back({id, "energy drift beyond that of " + of, std::abs(fly(body, steps, share).energy_drift - own),
                         quick ? 0.01 : 0.08});
    }
    for (const double dt : {1e-4, 1e-2}) {
        const Drift found = drift(cube(3, 2.0, 3000.0, 0.45), quick ? 200 : 1000, dt);
        gates.push_back({std::string("T21 implicit ").append(text(1e3 * dt)).append(" ms"),
                         "largest rise of the energy in a step, relative, undamped", found.rise, 1e-14});
    }
    return gates;
}

}  // namespace rhexis::scenes
