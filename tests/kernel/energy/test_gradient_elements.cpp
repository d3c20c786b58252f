// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "energy/gradient_elements.hpp"

using namespace rhexis;

namespace {

/// A cube cut into 5 tetrahedra.
TetMesh cube() {
    TetMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.nodes.emplace_back(corner & 1, (corner >> 1) & 1, (corner >> 2) & 1);
    }
    mesh.tets = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};
    for (std::array<int, 4>& tet : mesh.tets) {
        const Vec3 a = mesh.nodes[static_cast<std::size_t>(tet[1])] - mesh.nodes[static_cast<std::size_t>(tet[0])];
        const Vec3 b = mesh.nodes[static_cast<std::size_t>(tet[2])] - mesh.nodes[static_cast<std::size_t>(tet[0])];
        const Vec3 c = mesh.nodes[static_cast<std::size_t>(tet[3])] - mesh.nodes[static_cast<std::size_t>(tet[0])];
        if (a.cross(b).dot(c) < 0.0) {
            std::swap(tet[2], tet[3]);
        }
    }
    mesh.region.assign(5, 0);
    return mesh;
}

double volume_of(const GradientElements& elements, int first, int last) {
    return std::accumulate(elements.volume.begin() + first, elements.volume.begin() + last, 0.0);
}

Mat3 gradient_of(const GradientElements& elements, int e, const Mat3& map, const std::vector<Vec3>& nodes) {
    Mat3 f = Mat3::Zero();
    for (int k = elements.first[static_cast<std::size_t>(e)]; k < elements.first[static_cast<std::size_t>(e) + 1];
         ++k) {
        const auto i = static_cast<std::size_t>(k);
        f += (map * nodes[static_cast<std::size_t>(elements.node[i])]) * elements.gradient[i].transpose();
    }
    return f;
}

}  // namespace

TEST_SUITE("energy") {
    TEST_CASE("both formulations reproduce an affine map and share out the whole volume") {
        const TetMesh mesh = cube();
        Mat3 map;
        map << 1.2, 0.3, -0.1, 0.05, 0.8, 0.2, -0.3, 0.1, 1.1;
        for (const Formulation formulation : {Formulation::linear, Formulation::edge_smoothed}) {
            const ElementDomains domains = element_domains(mesh, formulation);
            const GradientElements elements = make_elements(mesh, domains, std::vector<TetStiffness>(5));
            const int patches = elements.count() - domains.first_patch;
            CHECK(domains.first_patch == (formulation == Formulation::linear ? 5 : 18));
            CHECK(std::abs(volume_of(elements, 0, domains.first_patch) - 1.0) < 1e-14);
            CHECK((patches > 0) == (formulation == Formulation::edge_smoothed));
            CHECK((patches == 0 || std::abs(volume_of(elements, domains.first_patch, elements.count()) - 1.0) < 1e-14));
            for (int e = 0; e < elements.count(); ++e) {
                CHECK((gradient_of(elements, e, map, mesh.nodes) - map).norm() < 1e-13);
            }
        }
    }

    TEST_CASE("bulk beyond that of Poisson's ratio 0.25 goes over patches, all of it") {
        const TetMesh mesh = cube();
        const ElementDomains domains = element_domains(mesh, Formulation::edge_smoothed);
        for (const double lambda : {0.5, 10.0}) {
            const GradientElements elements =
                make_elements(mesh, domains, std::vector<TetStiffness>(5, TetStiffness{lambda, 2.0, 1.0}));
            for (int e = 0; e < elements.count(); ++e) {
                const auto i = static_cast<std::size_t>(e);
                const bool patch = e >= domains.first_patch;
                CHECK(elements.mu[i] == doctest::Approx(patch ? 0.0 : 2.0));
                CHECK(elements.lambda[i] ==
                      doctest::Approx(patch ? std::max(0.0, lambda - 2.0) : std::min(lambda, 2.0)));
            }
        }
    }

    TEST_CASE("an edge shared by two materials takes their volume mean") {
        const TetMesh mesh = cube();
        std::vector<TetStiffness> stiffness(5, TetStiffness{1.0, 2.0, 1.0});
        stiffness[4] = {3.0, 6.0, 1.0};  // the middle tetrahedron holds a third of the volume, a corner one a sixth
        const ElementDomains domains = element_domains(mesh, Formulation::edge_smoothed);
        const GradientElements elements = make_elements(mesh, domains, stiffness);
        double weighted = 0.0;
        for (int e = 0; e < elements.count(); ++e) {
            weighted += elements.volume[static_cast<std::size_t>(e)] * elements.mu[static_cast<std::size_t>(e)];
        }
        CHECK(weighted == doctest::Approx(2.0 * 2.0 / 3.0 + 6.0 / 3.0));
    }

    TEST_CASE("updating after a removal equals making anew, and the last removal leaves nothing") {
        const TetMesh mesh = cube();
        const ElementDomains domains = element_domains(mesh, Formulation::edge_smoothed);
        std::vector<TetStiffness> stiffness(5, TetStiffness{1.0, 2.0, 1.0});
        GradientElements kept = make_elements(mesh, domains, stiffness);
        for (int t = 0; t < 5; ++t) {
            stiffness[static_cast<std::size_t>(t)].share = 0.0;
            update_elements(mesh, domains, stiffness, {t}, kept);
            const GradientElements fresh = make_elements(mesh, domains, stiffness);
            for (std::size_t k = 0; k < fresh.gradient.size(); ++k) {
                CHECK(kept.gradient[k] == fresh.gradient[k]);
                CHECK(kept.gradient[k].allFinite());
            }
            CHECK(kept.volume == fresh.volume);
        }
        CHECK(volume_of(kept, 0, kept.count()) == 0.0);
    }
}
