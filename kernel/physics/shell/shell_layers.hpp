// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which triangles of a shell can meet which places of it, layers of what is folded or rolled.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "flow/shell.hpp"
#include "physics/contact/box_grid.hpp"
#include "physics/shell/shell_samples.hpp"

namespace rhexis {

class ShellLayers {
public:
    /// The model must outlive this.
    explicit ShellLayers(const ShellModel& model);

    /// Where samples of the shell are now. What it found before is kept until two of them may have come nearer to each
    /// other by more than it looked beyond `gap`, the most that is asked for.
    void look(const ShellSamples& on, const std::vector<Vec3>& points, double gap);

    struct Candidate {
        int triangle;
        double spare;  ///< how much farther away than the gap it was at the last search, at least [mm]; less: nearer
    };
    /// Triangles whose surface may come within that gap of a sample's before the next search, ascending; but none that
    /// is near it along the surface: closer than one and a half times its thickness, by edges, or of the same nodes.
    [[nodiscard]] std::span<Candidate> near(std::size_t sample) {
        return {candidates_.data() + first_[sample], candidates_.data() + first_[sample + 1]};
    }
    /// Whether it may be within a gap of the sample now.
    [[nodiscard]] bool may_meet(std::size_t sample, const Candidate& candidate, double gap) const {
        return candidate.spare + gap_ <= gap + closed(sample, candidate.triangle);
    }
    /// It is no nearer to the sample than that now: until both have come nearer by what it is beyond a gap, it is of no
    /// use.
    void learn(std::size_t sample, Candidate& candidate, double apart) const;
    /// Half the thickness of a triangle where it is thickest, of the last search [mm].
    [[nodiscard]] double half(int triangle) const { return halves_[static_cast<std::size_t>(triangle)]; }

private:
    void find_near(const std::vector<std::vector<std::pair<int, double>>>& edges);
    [[nodiscard]] double find_moved(const ShellSamples& on, const std::vector<Vec3>& points);
    /// By how much both may have come nearer to each other since the last search [mm].
    [[nodiscard]] double closed(std::size_t sample, int triangle) const {
        return moved_[sample] + triangle_moved_[static_cast<std::size_t>(triangle)];
    }
    void bound(const ShellSamples& on);
    void find_around();
    void find(const Vec3& point, const ShellSamples::Sample& sample);
    [[nodiscard]] bool is_near(int triangle, const ShellPlace& place) const;

    const ShellModel* model_;
    std::vector<std::uint64_t> near_;  ///< per triangle: a bit for each node, set where it is near
    std::size_t near_words_ = 0;       ///< of a triangle
    // of the last search
    std::vector<Box> boxes_;  ///< of triangles
    std::vector<double> halves_;
    double thickest_ = 0.0;  ///< half [mm]
    std::vector<Vec3> points_;
    double gap_ = 0.0;
    std::vector<int> first_;  ///< per sample and one more: into candidates_
    std::vector<Candidate> candidates_;
    std::vector<double> moved_;             ///< samples, since then, beyond what all did [mm]
    std::vector<double> triangle_moved_;    ///< likewise, that corner of it which went farthest
    std::vector<std::vector<int>> around_;  ///< per triangle: what may be near any place of it, ascending
    BoxGrid grid_;
};

}  // namespace rhexis
