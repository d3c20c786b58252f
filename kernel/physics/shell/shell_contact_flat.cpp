// SPDX-License-Identifier: GPL-3.0-or-later
// What a shell meets as a plane that stays for a step: its own layers, and a membrane.
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "mesh/nearest_place.hpp"
#include "physics/shell/shell_contact.hpp"

namespace rhexis {
namespace {

constexpr double beside = 1e-9;         // farther than a bound says: more than its rounding [mm]
constexpr std::size_t tried_first = 4;  // of the triangles near a sample, those whose middles are nearest
constexpr double edge_spacing = 0.6;    // of samples that meet a membrane, in thicknesses: it sinks in by a twentieth

}  // namespace

void ShellContacts::bound_facets(const ShellSamples& on) {
    facets_.resize(on.facets.size());
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const std::array<int, 3>& n = on.facets[f];
        Ball& ball = facets_[f];
        ball.middle = (points_[at(n[0])] + points_[at(n[1])] + points_[at(n[2])]) / 3.0;
        ball.radius = 0.0;
        for (const int one : n) {
            ball.radius = std::max(ball.radius, (points_[at(one)] - ball.middle).norm());
        }
    }
    around_.resize(facets_.size() / at(on.facets_each));
    for (std::size_t t = 0; t < around_.size(); ++t) {
        const std::span<const Ball> own(facets_.data() + t * at(on.facets_each), at(on.facets_each));
        Ball& ball = around_[t];
        ball = {};
        for (const Ball& facet : own) {
            ball.middle += facet.middle / static_cast<double>(own.size());
        }
        for (const Ball& facet : own) {
            ball.radius = std::max(ball.radius, (facet.middle - ball.middle).norm() + facet.radius);
        }
    }
}

void ShellContacts::find_ways() {
    triangle_ways_.assign(model_->mesh.triangles.size(), most_travel_);
    const double pulls = tack_.traction > 0.0 ? std::min(most_travel_, 0.5 * tack_.range) : 0.0;  // what sticks is met
    for (std::size_t t = 0; t < triangle_ways_.size() && !ways_.empty(); ++t) {
        const std::array<int, 3>& n = model_->mesh.triangles[t];
        triangle_ways_[t] = std::max({pulls, ways_[at(n[0])], ways_[at(n[1])], ways_[at(n[2])]});
    }
}

/// Behind a sample and before it, with what is nearest tried first: the others are then told by balls about them.
std::array<ShellContacts::Layer, 2> ShellContacts::nearest_layers(const ShellSamples& on, std::size_t sample,
                                                                  std::span<ShellLayers::Candidate> near) {
    const Vec3 forward = front(on, sample).normalized();
    const double own = 0.5 * on.samples[sample].place.thickness;
    const double own_way = triangle_ways_[at(on.samples[sample].triangle)];
    order_.clear();
    for (std::size_t c = 0; c < near.size(); ++c) {
        if (layers_.may_meet(sample, near[c], own_way + triangle_ways_[at(near[c].triangle)])) {
            order_.emplace_back((points_[sample] - around_[at(near[c].triangle)].middle).squaredNorm(), c);
        }
    }
    const std::size_t first = std::min(tried_first, order_.size());
    std::partial_sort(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(first), order_.end());
    std::array<Layer, 2> nearest;
    for (const auto& [square, c] : order_) {
        const Ball& ball = around_[at(near[c].triangle)];
        const double height = forward.dot(ball.middle - points_[sample]);
        const bool one_side = std::abs(height) > ball.radius + beside;
        const double other = std::max(nearest[0].gap, nearest[1].gap);
        // what is no nearer than that is of no use
        const double most = own_way + triangle_ways_[at(near[c].triangle)];
        const double within = std::min(most, one_side ? nearest[height > 0.0 ? 1 : 0].gap : other);
        const double reach = own + layers_.half(near[c].triangle) + within + beside;
        if (square > (reach + ball.radius) * (reach + ball.radius)) {
            layers_.learn(sample, near[c], std::sqrt(square) - ball.radius - own - layers_.half(near[c].triangle));
            continue;
        }
        const Layer layer = nearest_layer(on, sample, near[c].triangle, reach);
        layers_.learn(sample, near[c], std::min(within, layer.gap));
        const std::size_t side = forward.dot(layer.normal) < 0.0 ? 1 : 0;
        const Layer& known = nearest[side];
        // of two that are as near the first of the mesh, whichever was tried first
        if (layer.gap < most && (layer.gap < known.gap || (layer.gap == known.gap && layer.facet < known.facet))) {
            nearest[side] = layer;
        }
    }
    return nearest;
}

/// Every sample with what is nearest before it and behind it.
void ShellContacts::meet_layers() {
    const ShellSamples& on = samples_at(level_of_layers);
    find_points(on);
    layers_.look(on, points_, 2.0 * most_travel_);
    bound_facets(on);
    find_ways();
    for (std::size_t i = 0; i < on.samples.size(); ++i) {
        const std::span<ShellLayers::Candidate> near = layers_.near(i);
        if (near.empty()) {
            continue;
        }
        const std::array<Layer, 2> nearest = nearest_layers(on, i, near);
        for (const bool before : {false, true}) {
            if (nearest[before ? 1 : 0].gap < HUGE_VAL) {
                add_layer(on, i, before, nearest[before ? 1 : 0]);
            }
        }
    }
}

void ShellContacts::add_layer(const ShellSamples& on, std::size_t sample, bool front, const Layer& near) {
    Contact contact;
    contact.on = &on;
    contact.touch.partner = ContactPartner::layer;
    contact.touch.sample = static_cast<int>(sample);
    contact.touch.front = front;
    contact.stiffness = stiffness(on, sample, near.normal);
    contact.friction = model_->friction;
    contact.lever = near.own_share * near.way;
    contact.foot = place_between(on.corners[at(near.facet)], near.share);
    contact.foot_lever = (near.own_share - 1.0) * near.way;
    contact.normal = near.normal;
    contact.gap = near.gap;
    add(std::move(contact));
}

/// Every sample with what of the membrane is nearest before it and behind it. Springs as stiff as between layers would
/// be so beside what gives way a hundred times as much, and Newton's method would take a small step for each that it
/// meets.
void ShellContacts::meet_sheet() {
    sheet_.look(*partners_.sheet);
    if (samples_of_sheet_.samples.empty()) {
        samples_of_sheet_ = shell_samples(*model_, level_of_layers, edge_spacing);
    }
    const ShellSamples& on = samples_of_sheet_;
    find_points(on);
    const double most = stretch_stiffness(*partners_.sheet_model, *partners_.sheet->sheet, settings_.stiffer_sheet);
    for (std::size_t i = 0; i < on.samples.size(); ++i) {
        if (in_tube(points_[i])) {
            continue;
        }
        const double own = 0.5 * on.samples[i].place.thickness;
        const std::array<ShellSheet::Foot, 2> feet = sheet_.nearest(points_[i], front(on, i), own + 2.0 * most_travel_);
        for (std::size_t side = 0; side < 2; ++side) {
            const ShellSheet::Foot& foot = feet[side];
            if (!(foot.distance < HUGE_VAL) || !(foot.distance > 0.0)) {
                continue;
            }
            Contact contact;
            contact.on = &on;
            contact.touch.partner = ContactPartner::sheet;
            contact.touch.sample = static_cast<int>(i);
            contact.touch.front = side == 1;
            contact.normal = -foot.way / foot.distance;
            contact.stiffness = std::min(most, stiffness(on, i, contact.normal));
            contact.friction = partners_.sheet_model->shell_friction;
            contact.lever = foot.way;
            contact.foot.nodes = foot.nodes;
            contact.foot.weights = foot.weights;
            contact.gap = foot.distance - own;
            add(std::move(contact));
        }
    }
}

/// reach: what is farther than that from the sample counts as infinitely far [mm].
ShellContacts::Layer ShellContacts::nearest_layer(const ShellSamples& on, std::size_t sample, int triangle,
                                                  double reach) const {
    Layer nearest;
    const Vec3& point = points_[sample];
    const double own = 0.5 * on.samples[sample].place.thickness;
    for (int f = triangle * on.facets_each; f < (triangle + 1) * on.facets_each; ++f) {
        const Ball& ball = facets_[at(f)];
        if ((point - ball.middle).squaredNorm() > (reach + ball.radius) * (reach + ball.radius)) {
            continue;
        }
        const std::array<int, 3>& n = on.facets[at(f)];
        const std::array<ShellPlace, 3>& corner = on.corners[at(f)];
        const std::array<Vec3, 3> x{points_[at(n[0])], points_[at(n[1])], points_[at(n[2])]};
        const std::array<double, 3> weights = nearest_to_point(x, point);
        const Vec3 way = place_in(x, weights) - point;
        const double other = 0.5 * (weights[0] * corner[0].thickness + weights[1] * corner[1].thickness +
                                    weights[2] * corner[2].thickness);
        const double far = way.norm();
        const double gap = far - own - other;
        if (gap < nearest.gap) {
            nearest.gap = gap;
            nearest.normal = far > 0.0 ? Vec3(-way / far) : Vec3((x[1] - x[0]).cross(x[2] - x[0]).normalized());
            nearest.way = way;
            nearest.own_share = own / (own + other);
            nearest.facet = f;
            nearest.share = weights;
        }
    }
    return nearest;
}

}  // namespace rhexis
