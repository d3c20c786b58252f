// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh text meshes, versions 2.2 and 4.1: https://gmsh.info/doc/texinfo/gmsh.html#File-formats
#include <algorithm>
#include <limits>
#include <map>

#include "mesh/raw_mesh.hpp"

namespace rhexis {

namespace {

constexpr std::array<CellKind, 16> msh_kinds{{{1, 1, 2},
                                              {2, 2, 3},
                                              {3, 2, 4},
                                              {4, 3, 4},
                                              {5, 3, 8},
                                              {6, 3, 6},
                                              {7, 3, 5},
                                              {8, 1, 3},
                                              {9, 2, 6},
                                              {10, 2, 9},
                                              {11, 3, 10},
                                              {12, 3, 27},
                                              {13, 3, 18},
                                              {14, 3, 14},
                                              {15, 0, 1},
                                              {16, 2, 8}}};

constexpr std::int64_t most_int = std::numeric_limits<int>::max();

class MshReader {
public:
    MshReader(std::string_view text, const std::string& path) : in_(text, path) {}

    Result<RawMesh> run() {
        format();
        for (std::string_view word = in_.word(); !word.empty() && !in_.failed(); word = in_.word()) {
            section(word);
        }
        if (!in_.failed() && (!have_nodes_ || !have_elements_)) {
            in_.fail(have_nodes_ ? "has no $Elements" : "has no $Nodes", "");
        }
        if (in_.failed()) {
            return in_.error();
        }
        return std::move(raw_);
    }

private:
    void format() {
        if (in_.word() != "$MeshFormat") {
            in_.fail("is not a Gmsh file", "a first line \"$MeshFormat\"");
            return;
        }
        const std::string version(in_.needed_word("version"));
        version_4_ = version == "4.1";
        if (!in_.failed() && !version_4_ && version != "2.2" && version != "2.1" && version != "2") {
            in_.fail("is Gmsh version " + version.substr(0, 10), "2.2 or 4.1");
        }
        if (in_.integer("file type", 0, 1) == 1) {
            in_.fail("is a binary Gmsh file", "text (gmsh without -bin)");
        }
        in_.integer("size of a number", 1, 64);
        in_.expect("$EndMeshFormat");
    }

    void section(std::string_view word) {
        if (word == "$Nodes") {
            have_nodes_ = true;
            version_4_ ? nodes_4() : nodes_2();
            index_nodes();
            in_.expect("$EndNodes");
        } else if (word == "$Entities" && version_4_) {
            entities();
            in_.expect("$EndEntities");
        } else if (word == "$Elements") {
            if (!have_nodes_) {
                in_.fail("has $Elements before $Nodes", "nodes first");
            }
            have_elements_ = true;
            version_4_ ? elements_4() : elements_2();
            in_.expect("$EndElements");
        } else if (word.size() > 1 && word.front() == '$') {
            skip("$End" + std::string(word.substr(1)));
        } else {
            in_.fail("has text outside its sections", "$Nodes, $Elements, ...");
        }
    }

    void skip(const std::string& end) {
        for (std::string_view word = in_.needed_word(end); word != end && !in_.failed();) {
            word = in_.needed_word(end);
        }
    }

    void add_node(std::int64_t tag, int line, const Vec3& at) {
        tags_.push_back(tag);
        raw_.node_line.push_back(line);
        raw_.nodes.push_back(at);
    }

    std::int64_t tag(const char* what) { return in_.integer(what, 1, std::numeric_limits<std::int64_t>::max()); }

    Vec3 point() {
        const double x = in_.number("coordinate");
        const double y = in_.number("coordinate");
        const double z = in_.number("coordinate");
        return {x, y, z};
    }

    void nodes_2() {
        const std::size_t count = in_.count("nodes", 8);
        for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
            const std::int64_t id = tag("node number");
            const int line = in_.line();
            add_node(id, line, point());
        }
    }

    void nodes_4() {
        const std::size_t blocks = in_.count("node blocks", 8);
        const std::size_t announced = in_.count("nodes", 8);
        in_.number("smallest node number");
        in_.number("largest node number");
        for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
            const std::int64_t dimension = in_.integer("dimension", 0, 3);
            in_.integer("entity", -most_int, most_int);
            const bool parametric = in_.integer("parametric", 0, 1) == 1;
            const std::size_t count = in_.count("nodes", 8);
            std::vector<std::int64_t> ids;
            for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
                ids.push_back(tag("node number"));
            }
            for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
                const Vec3 at = point();
                add_node(ids[n], in_.line(), at);
                for (std::int64_t i = 0; parametric && i < dimension; ++i) {
                    in_.number("parameter");
                }
            }
        }
        if (!in_.failed() && raw_.nodes.size() != announced) {
            in_.fail("announces " + std::to_string(announced) + " nodes but lists " +
                     std::to_string(raw_.nodes.size()));
        }
    }

    void index_nodes() {
        raw_.in_lower_cell.assign(raw_.nodes.size(), 0);
        for (std::size_t n = 0; n < tags_.size(); ++n) {
            order_.emplace_back(tags_[n], static_cast<int>(n));
        }
        std::sort(order_.begin(), order_.end());
        for (std::size_t n = 1; n < order_.size() && !in_.failed(); ++n) {
            if (order_[n].first == order_[n - 1].first) {
                in_.fail("node number " + std::to_string(order_[n].first) + " is used twice", "each once");
            }
        }
    }

    /// Index of the node with the number that follows.
    int node() {
        const std::int64_t id = tag("node number");
        const std::vector<std::pair<std::int64_t, int>>::const_iterator found =
            std::lower_bound(order_.cbegin(), order_.cend(), std::pair<std::int64_t, int>{id, 0});
        if (found != order_.cend() && found->first == id) {
            return found->second;
        }
        in_.fail("tetrahedron or cell " + std::to_string(raw_.tets.size()) + " uses node number " + std::to_string(id),
                 "a number from $Nodes");
        return 0;
    }

    /// Which physical tag, if any, each volume carries.
    void entities() {
        std::array<std::size_t, 4> counts{};
        for (std::size_t& count : counts) {
            count = in_.count("entities", 8);
        }
        for (std::size_t dimension = 0; dimension < 4; ++dimension) {
            for (std::size_t e = 0; e < counts[dimension] && !in_.failed(); ++e) {
                entity(dimension);
            }
        }
    }

    void entity(std::size_t dimension) {
        const std::int64_t id = in_.integer("entity", -most_int, most_int);
        for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) {
            in_.number("bound");
        }
        const std::size_t physical = in_.count("physical tags", 2);
        for (std::size_t p = 0; p < physical && !in_.failed(); ++p) {
            const std::int64_t value = in_.integer("physical tag", -most_int, most_int);
            if (dimension == 3 && p == 0) {
                physical_[id] = static_cast<int>(value);
            }
        }
        const std::size_t bounding = dimension > 0 ? in_.count("bounding entities", 2) : 0;
        for (std::size_t b = 0; b < bounding && !in_.failed(); ++b) {
            in_.integer("bounding entity", -most_int, most_int);
        }
    }

    static const CellKind* kind_of(std::int64_t code) {
        const auto* found = std::find_if(msh_kinds.begin(), msh_kinds.end(),
                                         [code](const CellKind& kind) { return kind.code == code; });
        return found == msh_kinds.end() ? nullptr : found;
    }

    void element(std::int64_t code, int physical) {
        const CellKind* kind = kind_of(code);
        const int line = in_.line();
        std::vector<int> nodes;
        for (int i = 0; kind != nullptr && i < kind->nodes && !in_.failed(); ++i) {
            nodes.push_back(node());
        }
        if (!in_.failed() && add_cell(kind, code, nodes, line, raw_, in_)) {
            raw_.tag.push_back(physical);
        }
    }

    void elements_2() {
        const std::size_t count = in_.count("elements", 8);
        for (std::size_t e = 0; e < count && !in_.failed(); ++e) {
            tag("element number");
            const std::int64_t code = in_.integer("element type", 1, 1000);
            const std::size_t tags = in_.count("tags", 2);
            int physical = 0;
            for (std::size_t t = 0; t < tags && !in_.failed(); ++t) {
                const std::int64_t value = in_.integer("tag", -most_int, most_int);
                physical = t == 0 ? static_cast<int>(value) : physical;
            }
            element(code, physical);
        }
    }

    void elements_4() {
        const std::size_t blocks = in_.count("element blocks", 8);
        const std::size_t announced = in_.count("elements", 4);
        in_.number("smallest element number");
        in_.number("largest element number");
        std::size_t listed = 0;
        for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
            in_.integer("dimension", 0, 3);
            const std::int64_t entity = in_.integer("entity", -most_int, most_int);
            const std::int64_t code = in_.integer("element type", 1, 1000);
            const std::size_t count = in_.count("elements", 4);
            const std::map<std::int64_t, int>::const_iterator found = physical_.find(entity);
            for (std::size_t e = 0; e < count && !in_.failed(); ++e) {
                tag("element number");
                element(code, found == physical_.end() ? 0 : found->second);
            }
            listed += count;
        }
        if (!in_.failed() && listed != announced) {
            in_.fail("announces " + std::to_string(announced) + " elements but lists " + std::to_string(listed));
        }
    }

    TokenReader in_;
    RawMesh raw_;
    bool version_4_ = false;
    bool have_nodes_ = false;
    bool have_elements_ = false;
    std::vector<std::int64_t> tags_;                   ///< the file's number of each node
    std::vector<std::pair<std::int64_t, int>> order_;  ///< the same with indices, sorted
    std::map<std::int64_t, int> physical_;             ///< first physical tag of each volume
};

}  // namespace

Result<RawMesh> read_msh(std::string_view text, const std::string& path) { return MshReader(text, path).run(); }

}  // namespace rhexis
