// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: two elastic bodies as one, so that what they do to each other is solved with what they do. Nodes are
// those of the first, then those of the second; rows are in an order of elimination of their own.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "physics/solve/elastic_body.hpp"

namespace rhexis {

class PairedBody final : public ElasticBody {
public:
    /// Neither body may have damping of its stiffness. ties: pairs of nodes, of the first and of the second, that
    /// contact may tie: they are in the pattern too.
    PairedBody(std::unique_ptr<ElasticBody> first, std::unique_ptr<ElasticBody> second,
               std::span<const std::array<int, 2>> ties);

    [[nodiscard]] ElasticBody& first() { return *parts_[0].body; }
    [[nodiscard]] ElasticBody& second() { return *parts_[1].body; }

    void forces(const std::vector<double>& position, std::vector<double>& force) override;
    void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                              std::vector<double>& force, BlockValues& stiffness) override;
    void predict(const std::vector<double>& position, const std::vector<double>& step) override;
    void forget_prediction() override;

private:
    /// Where the block of a part's slot goes.
    struct Move {
        int from = 0;
        int to = 0;
        bool turned = false;  ///< transposed
    };
    struct Part {
        std::unique_ptr<ElasticBody> body;
        std::vector<int> row;  ///< here, per row of the body
        std::vector<Move> moves;
        std::vector<double> position, force;
        BlockValues stiffness;
    };

    void number_rows(std::span<const std::array<int, 2>> ties);
    void weigh();
    static void take(const std::vector<double>& all, const Part& part, std::vector<double>& own);
    void put_forces(std::vector<double>& force) const;

    std::array<Part, 2> parts_;
};

}  // namespace rhexis
