// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_stepper.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "base/assert.hpp"
#include "math/rotation.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "physics/solve/paired_body.hpp"

namespace rhexis {
namespace {

constexpr double tied_share = 0.25;     // of a step's way: layers nearer than that are about to touch
constexpr double room_share = 0.5;      // likewise: those that a new pattern has room for
constexpr double missing_share = 0.02;  // of what is about to touch

}  // namespace

Result<ShellStepper> ShellStepper::create(const ShellModel& model, std::string_view instruction_set) {
    if (Status status = check_shell(model); !status) {
        return status.error();
    }
    const linear_kernel::Kernel* const linear = linear_kernel::choose(instruction_set);
    const shell_kernel::Kernel* const shell = shell_kernel::choose(instruction_set);
    if (linear == nullptr || shell == nullptr) {
        return Error{"unknown or missing instruction set \"" + std::string(instruction_set) + "\"", "instruction_set",
                     "\"\", \"baseline\", \"avx2\" or \"avx512\", as the machine has"};
    }
    return ShellStepper(model, *linear, *shell);
}

ShellStepper::ShellStepper(const ShellModel& model, const linear_kernel::Kernel& linear,
                           const shell_kernel::Kernel& shell)
    : model_(&model), linear_(&linear), shell_(&shell), relaxation_(model) {
    build(nullptr);
}

void ShellStepper::build(const ShellWall* wall) {
    std::unique_ptr<ShellBody> body = std::make_unique<ShellBody>(*model_, *shell_, shell_triangle, links_);
    body_ = body.get();
    wall_sheet_ = wall != nullptr ? wall->state.sheet : nullptr;
    if (wall == nullptr) {
        step_.emplace(std::move(body), *linear_);
        return;
    }
    std::unique_ptr<MembraneBody> membrane =
        std::make_unique<MembraneBody>(wall->model, wall_sheet_, *membrane_kernel::choose(linear_->name));
    std::vector<std::array<int, 2>> ties;  // of places and of turns
    for (const std::array<int, 2>& tie : ties_) {
        ties.push_back({2 * tie[0], tie[1]});
        ties.push_back({2 * tie[0] + 1, tie[1]});
    }
    step_.emplace(std::make_unique<PairedBody>(std::move(body), std::move(membrane), ties), *linear_);
}

/// A pattern with room for all that is near, made anew when what is about to touch is not in it. The few that touch in
/// a step without having been near before stay beside the pattern, which costs iterations of the solver.
void ShellStepper::tie(const ShellContacts* contacts, const ShellWall* wall) {
    bool anew = wall_sheet_ != (wall != nullptr ? wall->state.sheet : nullptr);
    if (contacts != nullptr) {
        const double gap = tied_share * contacts->most_travel();
        const std::vector<std::array<int, 2>> links = contacts->links(gap);
        const std::vector<std::array<int, 2>> ties = contacts->ties(gap);
        std::vector<std::array<int, 2>> missing;
        std::set_difference(links.begin(), links.end(), links_.begin(), links_.end(), std::back_inserter(missing));
        std::set_difference(ties.begin(), ties.end(), ties_.begin(), ties_.end(), std::back_inserter(missing));
        anew = anew ||
               static_cast<double>(missing.size()) > missing_share * static_cast<double>(links.size() + ties.size());
        if (anew) {
            const double room = room_share * contacts->most_travel();
            links_ = contacts->links(room);
            ties_ = contacts->ties(room);
        }
    }
    if (anew) {
        build(wall);
    }
}

void ShellStepper::drop_caches() {
    if (!links_.empty() || wall_sheet_ != nullptr) {
        links_.clear();
        ties_.clear();
        build(nullptr);
    }
    step_->drop_caches();
}

/// Held freedoms bear their loads themselves.
void ShellStepper::lay_out(const ShellState& state, const ShellLoad& load, const Vec3& gravity) {
    const std::size_t nodes = state.position.size();
    position_.assign(2 * nodes, Vec3::Zero());
    velocity_.assign(2 * nodes, Vec3::Zero());
    external_.assign(2 * nodes, Vec3::Zero());
    for (std::size_t n = 0; n < nodes; ++n) {
        const std::size_t row = 2 * static_cast<std::size_t>(body_->rank(static_cast<int>(n)));
        position_[2 * n] = state.position[n];
        velocity_[2 * n] = state.velocity[n];
        velocity_[2 * n + 1] = state.spin[n];
        external_[2 * n] = body_->mass().weight[row] * gravity;
        if (!load.force.empty()) {
            external_[2 * n] += load.force[n];
        }
        if (!load.moment.empty()) {
            external_[2 * n + 1] = load.moment[n];
        }
        for (std::size_t i = 0; i < 6; ++i) {
            if (body_->free()[3 * row + i] == 0) {
                external_[2 * n + i / 3][static_cast<Eigen::Index>(i % 3)] = 0.0;
                velocity_[2 * n + i / 3][static_cast<Eigen::Index>(i % 3)] = 0.0;
            }
        }
    }
}

/// Adds the wall's nodes.
void ShellStepper::lay_out(const ShellWall& wall) {
    const std::size_t first = position_.size();
    const std::vector<Vec3>& nodes = wall.state.position;
    position_.insert(position_.end(), nodes.begin(), nodes.end());
    velocity_.insert(velocity_.end(), wall.state.velocity.begin(), wall.state.velocity.end());
    external_.resize(position_.size(), Vec3::Zero());
    for (const SheetLoad& load : wall.state.loads) {
        for (const int node : load.nodes) {
            external_[first + static_cast<std::size_t>(node)] += load.total / static_cast<double>(load.nodes.size());
        }
    }
}

CouplingFunction ShellStepper::coupling(ShellContacts* contacts, const ShellWall* wall) {
    const bool touched = wall != nullptr && wall->touching;
    if ((contacts == nullptr || contacts->empty()) && !touched) {
        return {};
    }
    return [this, contacts, wall, touched](const std::vector<Vec3>& points, std::span<const RigidUnknown> /*bodies*/,
                                           std::vector<ContactTerm>& terms, std::vector<RigidTerm>& /*rigid*/) {
        if (contacts != nullptr) {
            contacts->terms(points, terms);
        }
        if (touched) {
            const std::size_t before = terms.size();
            const std::size_t first = points.size() - wall->state.position.size();
            wall_position_.assign(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
            wall->touching(wall_position_, terms);
            for (std::size_t i = before; i < terms.size(); ++i) {
                for (int& node : terms[i].nodes) {
                    node = node >= 0 ? static_cast<int>(first) + node : node;
                }
            }
        }
    };
}

/// Of the shell's points, of which more may follow.
const std::vector<double>& ShellStepper::rows_of(const std::vector<Vec3>& points) {
    const std::size_t own = 2 * model_->mesh.nodes.size();
    rows_.assign(3 * own + 1, 0.0);
    for (std::size_t i = 0; i < own; ++i) {
        const std::size_t row = static_cast<std::size_t>(body_->row_of()[i]);
        Eigen::Map<Vec3>(rows_.data() + 3 * row) = points[i];
    }
    return rows_;
}

ImplicitReport ShellStepper::step(const ShellState& state, const ShellLoad& load, const Vec3& gravity, double dt,
                                  const ImplicitSettings& settings, ShellState& next, ShellContacts* contacts,
                                  const ShellWall* wall, std::vector<Vec3> guess) {
    const std::size_t nodes = state.position.size();
    RHEXIS_ASSERT((load.force.empty() || load.force.size() == nodes) &&
                  (load.moment.empty() || load.moment.size() == nodes));
    tie(contacts, wall);
    body_->set_reference(state.rotation);
    lay_out(state, load, gravity);
    relaxation_.begin(state.branch, dt, rows_of(position_), *body_);
    if (wall != nullptr) {
        lay_out(*wall);
    }
    if (!guess.empty()) {
        guess.insert(guess.end(), velocity_.begin() + static_cast<std::ptrdiff_t>(2 * nodes), velocity_.end());
    }
    const ImplicitReport report = step_->step(position_, velocity_, Vec3::Zero(), external_, dt, settings,
                                              coupling(contacts, wall), no_bodies_, motion_, guess);
    if (&next != &state) {
        next = state;
    }
    std::vector<ShellTouch> touches;
    if (contacts != nullptr) {
        contacts->settle(motion_.position, touches);
    }
    relaxation_.finish(state.branch, rows_of(motion_.position), *body_, next.branch);
    next.touches = std::move(touches);
    for (std::size_t n = 0; n < nodes; ++n) {
        next.position[n] = motion_.position[2 * n];
        next.velocity[n] = motion_.velocity[2 * n];
        next.spin[n] = motion_.velocity[2 * n + 1];
        next.rotation[n] = turned(next.rotation[n], motion_.position[2 * n + 1]);
    }
    if (wall != nullptr) {
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(2 * nodes);
        wall->next.position.assign(motion_.position.begin() + first, motion_.position.end());
        wall->next.velocity.assign(motion_.velocity.begin() + first, motion_.velocity.end());
    }
    return report;
}

std::vector<Vec6> ShellStepper::hold_forces() {
    body_->forces_everywhere(rows_of(motion_.position), forces_);
    std::vector<Vec6> result;
    for (const ShellHold& hold : model_->holds) {
        Vec6 own = Eigen::Map<const Vec6>(forces_.data() + 6 * static_cast<std::size_t>(body_->rank(hold.node)));
        for (int i = 0; i < 6; ++i) {
            own[i] = hold.held[static_cast<std::size_t>(i)] ? own[i] : 0.0;
        }
        result.push_back(own);
    }
    return result;
}

}  // namespace rhexis
