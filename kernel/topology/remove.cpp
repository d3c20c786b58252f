// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/remove.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rhexis {

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool children_gone(const SolidState& state, int coarse) {
    const std::vector<double>::const_iterator first = state.fraction.begin() + 8 * static_cast<std::ptrdiff_t>(coarse);
    return std::all_of(first, first + 8, [](double fraction) { return fraction == 0.0; });
}

/// Stops the nodes that no present tetrahedron holds any more.
void stop_orphans(const SolidModel& model, SolidState& state) {
    std::vector<std::uint8_t> held(state.position.size(), 0);
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        if (state.present[t] != 0) {
            for (int node : model.coarse.tets[t]) {
                held[index(node)] = 1;
            }
        }
    }
    for (std::size_t n = 0; n < held.size(); ++n) {
        if (held[n] == 0) {
            state.velocity[n].setZero();
        }
    }
}

Error fault(const SolidModel& model, const char* part, std::size_t number, const std::string& what,
            const char* allowed) {
    return {part + std::string(" ") + std::to_string(number) + " " + what, "solid " + model.name, allowed};
}

Status check_sizes(const SolidModel& model, const SolidState& state) {
    const std::size_t nodes = model.coarse.nodes.size();
    const bool good = state.position.size() == nodes && state.velocity.size() == nodes &&
                      state.present.size() == model.coarse.tets.size() &&
                      state.fraction.size() == model.fine.tets.size();
    if (!good) {
        return Error{"the state's arrays do not fit the mesh", "solid " + model.name, ""};
    }
    return success();
}

Status check_nodes(const SolidModel& model, const SolidState& state) {
    for (std::size_t n = 0; n < state.position.size(); ++n) {
        if (!state.position[n].allFinite() || !state.velocity[n].allFinite()) {
            return fault(model, "node", n, "has a position or velocity that is not a number", "finite");
        }
    }
    return success();
}

Status check_fractions(const SolidModel& model, const SolidState& state) {
    for (std::size_t f = 0; f < state.fraction.size(); ++f) {
        const double fraction = state.fraction[f];
        if (!(fraction >= 0.0 && fraction <= 1.0)) {
            return fault(model, "fine tetrahedron", f, "has fraction " + std::to_string(fraction), "0 to 1");
        }
        if (fraction > 0.0 && state.present[f / 8] == 0) {
            return fault(model, "fine tetrahedron", f, "outlives its coarse one", "fraction 0 once that is removed");
        }
    }
    return success();
}

Status check_masks(const SolidModel& model, const SolidState& state) {
    for (std::size_t t = 0; t < state.present.size(); ++t) {
        if (state.present[t] > 1) {
            return fault(model, "tetrahedron", t, "has mask " + std::to_string(state.present[t]), "0 or 1");
        }
        if (state.present[t] == 1 && !state.fraction.empty() && children_gone(state, static_cast<int>(t))) {
            return fault(model, "tetrahedron", t, "is present though its 8 children are gone", "removed with them");
        }
    }
    return success();
}

}  // namespace

MeshEdit spent_elements(const SolidState& before, const SolidState& after, int solid) {
    MeshEdit edit{solid, {}, {}};
    for (std::size_t f = 0; f < after.fraction.size(); ++f) {
        if (after.fraction[f] == 0.0 && before.fraction[f] != 0.0) {
            edit.removed_fine.push_back(static_cast<int>(f));
        }
    }
    for (int fine : edit.removed_fine) {
        const int coarse = fine / 8;
        const bool listed = !edit.removed_coarse.empty() && edit.removed_coarse.back() == coarse;
        if (!listed && after.present[index(coarse)] != 0 && children_gone(after, coarse)) {
            edit.removed_coarse.push_back(coarse);
        }
    }
    return edit;
}

MeshEdit spent_elements(const SolidModel& model, const SolidState& state, int solid) {
    MeshEdit edit{solid, {}, {}};
    if (state.fraction.empty()) {
        return edit;
    }
    for (int t = 0; t < static_cast<int>(model.coarse.tets.size()); ++t) {
        if (state.present[index(t)] == 0) {
            continue;
        }
        for (int child = 8 * t; child < 8 * t + 8; ++child) {
            if (state.fraction[index(child)] == 0.0) {
                edit.removed_fine.push_back(child);
            }
        }
        if (children_gone(state, t)) {
            edit.removed_coarse.push_back(t);
        }
    }
    return edit;
}

MeshEdit remove_coarse(const SolidModel& model, const SolidState& state, int solid, const std::vector<int>& tets) {
    MeshEdit edit{solid, {}, tets};
    std::vector<int>& coarse = edit.removed_coarse;
    std::sort(coarse.begin(), coarse.end());
    coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
    std::erase_if(coarse, [&state](int t) { return state.present[index(t)] == 0; });
    if (!model.fine.tets.empty()) {
        for (int t : coarse) {
            for (int child = 8 * t; child < 8 * t + 8; ++child) {
                if (state.fraction[index(child)] > 0.0) {
                    edit.removed_fine.push_back(child);
                }
            }
        }
    }
    return edit;
}

double edit_mass(const MeshEdit& edit, const SolidModel& model, const SolidState& state) {
    double sum = 0.0;
    for (int fine : edit.removed_fine) {
        sum += state.fraction[index(fine)] * tet_mass(model, fine / 8) / 8.0;
    }
    if (model.fine.tets.empty()) {
        for (int t : edit.removed_coarse) {
            sum += tet_mass(model, t);
        }
    }
    return sum;
}

void apply(const MeshEdit& edit, const SolidModel& model, SolidState& state) {
    for (int fine : edit.removed_fine) {
        set_fraction(state, fine, 0.0);
    }
    for (int t : edit.removed_coarse) {
        state.present[index(t)] = 0;
    }
    if (!edit.removed_coarse.empty()) {
        stop_orphans(model, state);
    }
}

Status validate(const SolidModel& model, const SolidState& state) {
    for (const auto check : {check_sizes, check_nodes, check_fractions, check_masks}) {
        if (Status status = check(model, state); !status.ok()) {
            return status;
        }
    }
    return success();
}

}  // namespace rhexis
