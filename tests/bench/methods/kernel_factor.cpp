// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/kernel_factor.hpp"

#include <cmath>

#include "math/supernodes.hpp"

namespace rhexis::bench {

BlockPattern node_pattern(const SplitSystem& system) {
    const TriMesh& mesh = system.state.sheet->mesh;
    std::vector<int> first{0};
    std::vector<int> nodes;
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        nodes.insert(nodes.end(), triangle.begin(), triangle.end());
        first.push_back(static_cast<int>(nodes.size()));
    }
    return block_pattern(static_cast<int>(mesh.nodes.size()), first, nodes);
}

long factor_entries(const BlockPattern& pattern) {
    const Supernodes tree = find_supernodes(pattern);
    long sum = 0;
    for (int s = 0; s < tree.count(); ++s) {
        const long width = 3L * tree.width(s);
        sum += width * (width + 1) / 2 + width * 3L * tree.below(s);
    }
    return sum;
}

int iterate(const SplitSystem& system, double tolerance, FactorPreconditioner& factor, std::vector<double>& x,
            PcgWork& work) {
    const double size = std::sqrt(dot(system.b, system.b));
    x.resize(system.b.size());
    return pcg(
               system.b, tolerance * size, 1000,
               [&](std::span<const double> in, std::span<double> out) { system.matrix.multiply(in, out); },
               [&](std::span<const double> r, std::span<double> z) { factor.apply(r, z); }, x, PcgStart::zero, work)
        .iterations;
}

}  // namespace rhexis::bench
