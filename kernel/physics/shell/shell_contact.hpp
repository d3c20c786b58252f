// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a shell of its thickness against half-spaces, balls that it is in, tubes, bags and instruments, a
// membrane, and itself.
// Sampled places of its curved middle surface meet a partner where its distance is less than half the thickness there,
// another layer where it is less than half of both, and a membrane, which has no thickness here, on either side. The
// place and the normal of that layer or membrane stay for a step, so that
// Newton's method finds no kinks; at its start both sides' forces and moments sum to nothing, later the moments by what
// the layers have slid in the step. The force of a sample is the pressure of a spring on the area that
// it stands for (friction.hpp), so that it is the same however finely the surface is sampled; it goes to the nodes by
// the transposed of the interpolation, forces and moments. Friction acts where the surfaces touch, half a thickness
// from the middle. Without it the forces are the gradient of the springs' energy but for partners whose distance is not
// exact. Layers that touched at the end of a step hold to each other from the next on, until they are farther apart
// than the range of their tack (tack.hpp); each of two layers that face each other bears half of it. Jaws that close
// take hold of the samples between them: each is led by a spring, slips when that pulls harder than its share of what
// the jaws bear, and is lost when it has slipped out. Open jaws, and those that hold something, push nothing.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "flow/bag.hpp"
#include "flow/membrane.hpp"
#include "flow/shell.hpp"
#include "flow/tool.hpp"
#include "flow/tube.hpp"
#include "flow/world.hpp"
#include "physics/contact/friction.hpp"
#include "physics/contact/rigid_partner.hpp"
#include "physics/shell/shell_contact_settings.hpp"
#include "physics/shell/shell_layers.hpp"
#include "physics/shell/shell_pose.hpp"
#include "physics/shell/shell_samples.hpp"
#include "physics/shell/shell_sheet.hpp"
#include "physics/shell/tack.hpp"

namespace rhexis {

/// What a shell may touch in a step, from share `from` to share `to` of the instruments' way. Bags stay as they are.
struct ShellPartners : RigidPartners {
    std::span<const ToolState> tube_states;  ///< of what carries each; none: they stand still
    std::span<const int> tube_tools;         ///< of each: the number of the tool that pushes in it; or none: then
                                             ///< what lies in one begins its steps as it went
    std::span<const Pose> bag_poses;
    std::span<const ToolState> tool_states;
    bool layers = true;  ///< of itself
    /// A membrane that is solved for with the shell: its node n is point 2 x (nodes of the shell) + n. Or null.
    const MembraneState* sheet = nullptr;
    const MembraneModel* sheet_model = nullptr;
    double from = 0.0;
    double to = 1.0;
};

/// Energy of a step [nJ].
struct ShellContactWork {
    double brought = 0.0;   ///< by instruments that move
    double friction = 0.0;  ///< taken by it
    double stored = 0.0;    ///< in the springs at the end, and in what holds layers together
    // with accounts
    std::optional<double> found;  ///< in the springs at the start: not all may be those of the end of the step before
    double lost = 0.0;            ///< taken by backward Euler from the springs
};

class ShellContacts {
public:
    /// The model must outlive this and pass check_shell.
    explicit ShellContacts(const ShellModel& model, const ShellContactSettings& settings = {});

    /// What can touch in a step from a state. The partners must outlive the calls that follow. ways: how far each node
    /// may go in it beyond what all of them go, as far as layers are concerned [mm]; or empty: most_travel().
    void look(const ShellState& state, const ShellPartners& partners, std::vector<double> ways = {});
    /// Whether a node went farther than that, so that layers may have been missed.
    [[nodiscard]] bool went_too_far(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const;
    [[nodiscard]] bool empty() const { return list_.empty(); }
    /// No node may go farther in a step, or something may have been missed [mm].
    [[nodiscard]] double most_travel() const { return most_travel_; }

    /// Pairs of nodes that layers nearer than a gap [mm] may tie in the step, ascending.
    [[nodiscard]] std::vector<std::array<int, 2>> links(double gap) const;
    /// The same of nodes of the shell and of the membrane, in that order.
    [[nodiscard]] std::vector<std::array<int, 2>> ties(double gap) const;

    /// Forces and stiffness at an iterate. points: as of ShellBody, turns since the state's rotations.
    void terms(const std::vector<Vec3>& points, std::vector<ContactTerm>& terms);
    /// In the springs at an iterate and in what holds layers together, without friction [nJ].
    double normal_energy(const std::vector<Vec3>& points);
    /// Ends a step: lets go of what slid or is apart.
    void settle(const std::vector<Vec3>& points, std::vector<ShellTouch>& touches);

    // Of the last step that was settled.
    [[nodiscard]] const ShellContactWork& work() const { return work_; }
    [[nodiscard]] double deepest() const { return deepest_; }  ///< penetration over thickness
    [[nodiscard]] int touching() const { return touching_; }   ///< samples
    /// On the shell at the end [uN].
    [[nodiscard]] Vec3 force_of(ContactPartner partner, int index) const;

private:
    static constexpr int level_of_layers = 1;  ///< of the samples that meet layers, a membrane and jaws
    /// Of a layer or a membrane at the first iterate of a step, and how it can change since.
    struct Known {
        double gap = -HUGE_VAL;  ///< [mm]
        double by_move = 0.0;    ///< at most, per movement of any node
        double by_turn = 0.0;    ///< and per turn [mm]
    };
    struct Contact {
        ShellTouch touch;
        const ShellSamples* on = nullptr;
        double stiffness = 0.0;  ///< [uN/mm]
        double friction = 0.0;
        double stuck = 0.0;          ///< area that holds to another layer [mm^2]
        double most = 0.0;           ///< of jaws: force that they bear here [uN]
        Vec3 lever = Vec3::Zero();   ///< from the middle to the surface that touches, at the start [mm]
        Vec3 anchor = Vec3::Zero();  ///< where friction holds it, in the partner's frame; of layers: the difference
        // of layers and membranes, at the start: nothing goes far in a step
        ShellPlace foot;                 ///< what it is above; of a membrane: nodes and weights
        Vec3 foot_lever = Vec3::Zero();  ///< likewise
        Vec3 normal = Vec3::Zero();
        double gap = 0.0;           ///< [mm]
        Vec3 force = Vec3::Zero();  ///< on the shell at the end
        Known known;
    };
    /// Where a contact is at an iterate.
    struct Meeting {
        double gap = HUGE_VAL;
        Vec3 normal = Vec3::UnitZ();  ///< into the sample
        Vec3 point = Vec3::Zero();    ///< of the middle surface
    };
    /// The nearest place of a triangle.
    struct Layer {
        double gap = HUGE_VAL;
        Vec3 normal = Vec3::UnitZ();
        int facet = 0;                  ///< of the samples
        std::array<double, 3> share{};  ///< of its corners
        Vec3 way = Vec3::Zero();        ///< from the sample to it
        double own_share = 0.5;         ///< of that way, to where the surfaces touch
    };
    /// A contact at the start of a step.
    struct Before {
        double gap = 0.0;             ///< [mm]
        Vec3 stretch = Vec3::Zero();  ///< [mm]
        double energy = 0.0;          ///< [nJ]
    };
    struct Ball {
        Vec3 middle = Vec3::Zero();
        double radius = 0.0;
    };
    [[nodiscard]] std::vector<std::array<int, 2>> pairs(ContactPartner partner, double gap) const;
    [[nodiscard]] int level_for(double radius) const;
    [[nodiscard]] const ShellSamples& samples_at(int level);
    void find_points(const ShellSamples& on);
    [[nodiscard]] bool within(int tube, const Vec3& point) const;
    [[nodiscard]] bool in_tube(const Vec3& point) const;
    [[nodiscard]] bool kept_from(int tool, const Vec3& point) const;
    void meet_rigid(ContactPartner partner, int index, double radius, double reach, const std::optional<Box>& box);
    [[nodiscard]] Vec3 front(const ShellSamples& on, std::size_t sample) const;
    [[nodiscard]] double stiffness(const ShellSamples& on, std::size_t sample, const Vec3& normal) const;
    void meet_tools();
    void meet_jaws();
    void take(int tool, const ShellSamples& on, std::size_t sample);
    [[nodiscard]] std::vector<std::size_t> between_jaws(int tool, const ShellSamples& on) const;
    [[nodiscard]] bool holds(int tool) const;
    void find_ways();
    void bound_facets(const ShellSamples& on);
    void meet_layers();
    void meet_sheet();
    void add_layer(const ShellSamples& on, std::size_t sample, bool front, const Layer& near);
    void add(Contact contact);
    [[nodiscard]] Pose pose_of(ContactPartner partner, int index, double share) const;
    [[nodiscard]] Pose partner_pose(const Contact& contact, double share) const {
        return pose_of(contact.touch.partner, contact.touch.index, share);
    }
    [[nodiscard]] SurfaceDistance distance(ContactPartner partner, int index, double share, const Vec3& point) const;
    [[nodiscard]] Meeting meeting(const Contact& contact, double share = 1.0) const;
    std::array<Layer, 2> nearest_layers(const ShellSamples& on, std::size_t sample,
                                        std::span<ShellLayers::Candidate> near);
    [[nodiscard]] Layer nearest_layer(const ShellSamples& on, std::size_t sample, int triangle, double reach) const;
    [[nodiscard]] Vec3 offset(const Contact& contact, const Vec3& point, double share = 1.0) const;
    [[nodiscard]] Vec3 foot_of(const Contact& contact) const;
    void set_iterate(const std::vector<Vec3>& points);
    [[nodiscard]] Known known_of(const Contact& contact, double gap) const;
    [[nodiscard]] std::optional<Meeting> touching(const Contact& contact) const;
    /// Whether where it touches stays as it was at the start of the step.
    static bool is_flat(const Contact& contact) {
        return contact.touch.partner == ContactPartner::layer || contact.touch.partner == ContactPartner::sheet;
    }
    static bool is_held(const Contact& contact) { return contact.touch.partner == ContactPartner::jaws; }
    [[nodiscard]] const ShellPlace& place(const Contact& contact) const;
    [[nodiscard]] Vec3 arm(const Contact& contact, const Meeting& now) const;
    [[nodiscard]] bool is_kept(const Contact& contact, const Vec3& place) const;
    [[nodiscard]] bool still_holds(const Contact& contact, const Vec3& place) const;
    [[nodiscard]] double sticking(const Contact& contact) const;
    [[nodiscard]] SpringResponse lead(const Contact& contact, const Meeting& now) const;
    [[nodiscard]] SpringResponse push(const Contact& contact, const Meeting& now) const;
    [[nodiscard]] double normal_energy(const Contact& contact, double gap) const;
    [[nodiscard]] double stuck_area(const Contact& contact) const;
    [[nodiscard]] bool is_apart(const Contact& contact, double gap) const;
    [[nodiscard]] SpringResponse respond(const Contact& contact, const Meeting& now) const;
    [[nodiscard]] double energy_of(const Contact& contact, const Meeting& now, double share = 1.0) const;
    void fill(const Contact& contact, const Meeting& now, const SpringResponse& pushed, ContactTerm& term) const;

    void account_start();
    void account_end(std::size_t index, const std::vector<Vec3>& points, const Meeting& now,
                     const SpringResponse& pushed, const Vec3& stretch, const Vec3& way);

    const ShellModel* model_;
    ShellContactSettings settings_;
    double thinnest_ = 0.0;
    double edge_ = 0.0;               ///< mean, at rest [mm]
    double modulus_ = 0.0;            ///< at once [Pa]
    Tack tack_;                       ///< of layers
    std::vector<std::uint8_t> free_;  ///< six per node
    ShellLayers layers_;
    ShellSheet sheet_;
    std::map<int, ShellSamples> samples_;  ///< by level
    ShellSamples samples_of_sheet_;        ///< that meet a membrane
    ShellPartners partners_;
    double most_travel_ = 0.0;
    ShellPose pose_;
    std::vector<Contact> list_;
    ShellContactWork work_;
    double deepest_ = 0.0;
    int touching_ = 0;
    std::vector<double> ways_;           ///< of nodes in the step, beyond what all go [mm]; or empty: most_travel_
    std::vector<double> triangle_ways_;  ///< likewise
    // scratch
    const ShellState* state_ = nullptr;
    const std::vector<Vec3>* now_ = nullptr;   ///< the iterate
    std::vector<Vec3> first_;                  ///< iterate of the step, at which gaps are known; or empty
    double moved_ = 0.0;                       ///< any node since then, at most [mm]
    double turned_ = 0.0;                      ///< likewise
    std::vector<Vec3> points_;                 ///< of samples at the start,
    const ShellSamples* points_of_ = nullptr;  ///< of these; null: of none
    std::vector<Vec3> start_;
    std::vector<Ball> facets_;                           ///< about those of the samples of layers
    std::vector<Ball> around_;                           ///< about all facets of a triangle
    std::vector<std::pair<double, std::size_t>> order_;  ///< of candidates, by squared distance
    std::vector<Before> at_start_;
};

}  // namespace rhexis
