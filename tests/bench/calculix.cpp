// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/calculix.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/index.hpp"
#include "mesh/surface.hpp"

namespace rhexis::bench {
namespace {

/// Nodes and elements as CalculiX numbers them (from 1 in the deck).
struct Deck {
    std::vector<Vec3> nodes;
    std::vector<std::vector<int>> elements;
    std::set<int> held;
    std::vector<double> load;  ///< toward -z, per node
    std::map<std::pair<int, int>, int> middles;

    int middle(int a, int b) {
        const auto [entry, fresh] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(nodes.size()));
        if (fresh) {
            const Vec3 point = 0.5 * (nodes[at(a)] + nodes[at(b)]);
            nodes.push_back(point);
        }
        return entry->second;
    }
};

void add_elements(const TetMesh& mesh, CalculixElement element, Deck& deck) {
    for (const std::array<int, 4>& t : mesh.tets) {
        std::vector<int> nodes(t.begin(), t.end());
        if (element == CalculixElement::c3d10) {
            for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}) {
                nodes.push_back(deck.middle(t[at(a)], t[at(b)]));
            }
        }
        deck.elements.push_back(std::move(nodes));
    }
}

/// Consistent load of a flat triangle: linear shape functions, or quadratic ones through the edge middles.
void add_face_load(const scenes::PokeLoad& load, const std::array<int, 3>& face, CalculixElement element, Deck& deck) {
    constexpr int cuts = 16;
    const Vec3 a = deck.nodes[at(face[0])];
    const Vec3 b = deck.nodes[at(face[1])];
    const Vec3 c = deck.nodes[at(face[2])];
    const double projected = 0.5 * (b - a).cross(c - a).z();
    if (projected <= 0.0) {
        return;
    }
    const bool quadratic = element == CalculixElement::c3d10;
    const std::array<int, 3> middle =
        quadratic ? std::array<int, 3>{deck.middle(face[0], face[1]), deck.middle(face[1], face[2]),
                                       deck.middle(face[2], face[0])}
                  : face;
    deck.load.resize(deck.nodes.size(), 0.0);
    for (int i = 0; i < cuts; ++i) {
        for (int j = 0; j < cuts - i; ++j) {
            const double v = (i + 1.0 / 3.0) / cuts;
            const double w = (j + 1.0 / 3.0) / cuts;
            const std::array<double, 3> l{1.0 - v - w, v, w};
            const double p = projected * scenes::poke_pressure(load, a + v * (b - a) + w * (c - a));
            for (std::size_t k = 0; k < 3; ++k) {
                deck.load[at(face[k])] += p * (quadratic ? l[k] * (2.0 * l[k] - 1.0) : l[k]);
                if (quadratic) {
                    deck.load[at(middle[k])] += p * 4.0 * l[k] * l[(k + 1) % 3];
                }
            }
        }
    }
}

Deck make_deck(const scenes::LensPoke& poke, CalculixElement element) {
    Deck deck;
    deck.nodes = poke.lens.coarse.nodes;
    add_elements(poke.lens.coarse, element, deck);
    deck.held.insert(poke.lens.fixed_nodes.begin(), poke.lens.fixed_nodes.end());
    const Surface surface = surface_of(poke.lens.coarse);
    for (const std::array<int, 3>& face : surface.triangles) {
        if (deck.nodes[at(face[0])].z() > 0.0) {
            add_face_load(poke.load, face, element, deck);
        }
        for (std::size_t k = 0; k < 3 && element == CalculixElement::c3d10; ++k) {
            const int a = face[k];
            const int b = face[(k + 1) % 3];
            if (deck.held.contains(a) && deck.held.contains(b)) {
                deck.held.insert(deck.middle(a, b));
            }
        }
    }
    deck.load.resize(deck.nodes.size(), 0.0);
    double sum = 0.0;
    for (const double p : deck.load) {
        sum += p;
    }
    for (double& p : deck.load) {
        p *= poke.load.total / sum;
    }
    return deck;
}

void write_elements(std::ostream& out, const Deck& deck, const scenes::LensPoke& poke, CalculixElement element) {
    for (std::size_t m = 0; m < poke.lens.materials.size(); ++m) {
        out << "*ELEMENT,TYPE=" << (element == CalculixElement::c3d10 ? "C3D10" : "C3D4") << ",ELSET=M" << m << "\n";
        for (std::size_t e = 0; e < deck.elements.size(); ++e) {
            if (poke.lens.coarse.region[e] != static_cast<int>(m)) {
                continue;
            }
            out << e + 1;
            for (const int node : deck.elements[e]) {
                out << "," << node + 1;
            }
            out << "\n";
        }
        out << "*MATERIAL,NAME=M" << m << "\n*ELASTIC\n"
            << poke.lens.materials[m].young_modulus << "," << poke.lens.materials[m].poisson_ratio
            << "\n*SOLID SECTION,ELSET=M" << m << ",MATERIAL=M" << m << "\n";
    }
}

void write_deck(const std::string& path, const Deck& deck, const scenes::LensPoke& poke, CalculixElement element) {
    std::ofstream out(path);
    out.precision(12);
    out << "*NODE,NSET=ALL\n";
    for (std::size_t i = 0; i < deck.nodes.size(); ++i) {
        out << i + 1 << "," << deck.nodes[i].x() << "," << deck.nodes[i].y() << "," << deck.nodes[i].z() << "\n";
    }
    write_elements(out, deck, poke, element);
    out << "*NSET,NSET=LOADED\n";
    for (std::size_t i = 0; i < deck.load.size(); ++i) {
        if (deck.load[i] != 0.0) {
            out << i + 1 << ",\n";
        }
    }
    out << "*BOUNDARY\n";
    for (const int node : deck.held) {
        out << node + 1 << ",1,3\n";
    }
    out << "*STEP\n*STATIC\n*CLOAD\n";
    for (std::size_t i = 0; i < deck.load.size(); ++i) {
        if (deck.load[i] != 0.0) {
            out << i + 1 << ",3," << -deck.load[i] << "\n";
        }
    }
    out << "*NODE PRINT,NSET=LOADED\nU\n*END STEP\n";
}

/// Sum of load times displacement over the lines "node ux uy uz" of the result file.
Result<double> work_of(const std::string& path, const Deck& deck) {
    std::ifstream in(path);
    std::string line;
    double work = 0.0;
    int rows = 0;
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        long node = 0;
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        if (fields >> node >> x >> y >> z && node >= 1 && node <= static_cast<long>(deck.load.size())) {
            work -= deck.load[static_cast<std::size_t>(node - 1)] * z;
            ++rows;
        }
    }
    if (rows == 0) {
        return Error{"no displacements in CalculiX's output", path, "is calculix-ccx installed?"};
    }
    return work;
}

}  // namespace

Result<double> calculix_compliance(const scenes::LensPoke& poke, CalculixElement element, const std::string& folder) {
    std::filesystem::create_directories(folder);
    const Deck deck = make_deck(poke, element);
    write_deck(folder + "/poke.inp", deck, poke, element);
    const std::string command = "cd '" + folder + "' && rm -f poke.dat && OMP_NUM_THREADS=1 ccx poke >poke.log 2>&1";
    if (std::system(command.c_str()) != 0) {
        return Error{"CalculiX failed", folder + "/poke.log", "needs the Debian package calculix-ccx"};
    }
    const Result<double> work = work_of(folder + "/poke.dat", deck);
    if (!work) {
        return work.error();
    }
    return work.value() / (poke.load.total * poke.load.total);
}

std::map<int, double> kept_compliances() {
    std::map<int, double> table;
    std::ifstream file("docs/data/calculix.csv");
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream fields(line);
        std::string element;
        int size = 0;
        double compliance = 0.0;
        char comma = 0;
        if (std::getline(fields, element, ',') && fields >> size >> comma >> compliance && element == "C3D10") {
            table[size] = 1e-3 * compliance;
        }
    }
    return table;
}

}  // namespace rhexis::bench
