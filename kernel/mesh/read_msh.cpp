// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh meshes, text and binary, versions 1, 2, 4.0 and 4.1: https://gmsh.info/doc/texinfo/gmsh.html#File-formats
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
    enum class Version { one, two, four_0, four_1 };

    void format() {
        const std::string_view first = in_.word();
        if (first == "$NOD") {
            version_ = Version::one;
            section(first);
            return;
        }
        if (first != "$MeshFormat") {
            in_.fail("is not a Gmsh file", "a first line \"$MeshFormat\" or \"$NOD\"");
            return;
        }
        const std::string version(in_.needed_word("version"));
        if (version == "4.1") {
            version_ = Version::four_1;
        } else if (version == "4" || version == "4.0") {
            version_ = Version::four_0;
        } else if (!in_.failed() && version != "2.2" && version != "2.1" && version != "2.0" && version != "2") {
            in_.fail("is Gmsh version " + version.substr(0, 10), "1, 2, 4.0 or 4.1");
        }
        binary_ = in_.integer("file type", 0, 1) == 1;
        const std::int64_t size = in_.integer("size of a number", 1, 64);
        size_ = {NumberForm::natural, size == 4 ? 4 : 8};
        if (binary_ && size != 8 && (size != 4 || !version_4())) {
            in_.fail("numbers have " + std::to_string(size) + " bytes", version_4() ? "4 or 8" : "8");
        }
        if (binary_) {
            order_of_bytes();
        }
        in_.expect("$EndMeshFormat");
    }

    [[nodiscard]] bool version_4() const { return version_ == Version::four_0 || version_ == Version::four_1; }

    /// A binary file begins with the whole number 1.
    void order_of_bytes() {
        in_.begin_bytes(false);
        const std::int64_t one = in_.integer("the number 1", -most_int - 1, most_int);
        in_.end_bytes();
        big_end_first_ = one == 1 << 24;
        if (one != 1 && !big_end_first_) {
            in_.fail("the order of its bytes cannot be told", "the number 1 after $MeshFormat");
        }
    }

    /// Where a section's numbers begin: from there on they may be bytes.
    void begin_numbers() {
        if (binary_ && !in_.in_bytes()) {
            in_.begin_bytes(big_end_first_);
        }
    }

    void section(std::string_view word) {
        if (word == "$Nodes" || word == "$NOD") {
            have_nodes_ = true;
            version_4() ? nodes_4() : nodes_2();
            index_nodes();
            close(word == "$NOD" ? "$ENDNOD" : "$EndNodes");
        } else if (word == "$Entities" && version_4()) {
            entities();
            close("$EndEntities");
        } else if (word == "$Elements" || word == "$ELM") {
            if (!have_nodes_) {
                in_.fail("has $Elements before $Nodes", "nodes first");
            }
            have_elements_ = true;
            version_4() ? elements_4() : elements_2();
            close(word == "$ELM" ? "$ENDELM" : "$EndElements");
        } else if (word.size() > 1 && word.front() == '$') {
            in_.skip_behind("$End" + std::string(word.substr(1)));
        } else {
            in_.fail("has text outside its sections", "$Nodes, $Elements, ...");
        }
    }

    void close(const char* end) {
        in_.end_bytes();
        in_.expect(end);
    }

    void add_node(std::int64_t tag, int line, const Vec3& at) {
        raw_.node_number.push_back(tag);
        raw_.node_line.push_back(line);
        raw_.nodes.push_back(at);
    }

    /// Numbers of nodes and elements are as wide as counts in version 4.1, and plain whole numbers before it.
    std::int64_t tag(const char* what) {
        const NumberForm form = version_ == Version::four_1 ? size_ : NumberForm{};
        return in_.integer(what, 1, std::numeric_limits<std::int64_t>::max(), form);
    }

    Vec3 point() {
        const double x = in_.number("coordinate");
        const double y = in_.number("coordinate");
        const double z = in_.number("coordinate");
        return {x, y, z};
    }

    void nodes_2() {
        const std::size_t count = in_.count("nodes", 8);
        begin_numbers();
        for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
            const std::int64_t id = tag("node number");
            const int line = in_.line();
            add_node(id, line, point());
        }
    }

    void nodes_4() {
        begin_numbers();
        const std::size_t blocks = in_.count("node blocks", 8, size_);
        const std::size_t announced = in_.count("nodes", 8, size_);
        least_and_largest();
        for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
            const Block block = block_of();
            const bool parametric = in_.integer("parametric", 0, 1) == 1;
            const std::size_t count = in_.count("nodes", 8, size_);
            const bool apart = version_ == Version::four_1;  // all numbers of a block, then all places
            std::vector<std::int64_t> ids;
            for (std::size_t n = 0; apart && n < count && !in_.failed(); ++n) {
                ids.push_back(tag("node number"));
            }
            for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
                const std::int64_t id = apart ? ids[n] : tag("node number");
                const Vec3 at = point();
                add_node(id, in_.line(), at);
                for (std::int64_t i = 0; parametric && i < block.dimension; ++i) {
                    in_.number("parameter");
                }
            }
        }
        if (!in_.failed() && raw_.nodes.size() != announced) {
            in_.fail("announces " + std::to_string(announced) + " nodes but lists " +
                     std::to_string(raw_.nodes.size()));
        }
    }

    struct Block {
        std::int64_t dimension;
        std::int64_t entity;
    };

    /// The first two numbers of a block, which version 4.1 turned round.
    Block block_of() {
        if (version_ == Version::four_1) {
            const std::int64_t dimension = in_.integer("dimension", 0, 3);
            return {dimension, in_.integer("entity", -most_int, most_int)};
        }
        const std::int64_t entity = in_.integer("entity", -most_int, most_int);
        return {in_.integer("dimension", 0, 3), entity};
    }

    void least_and_largest() {
        if (version_ == Version::four_1) {
            in_.number("smallest number", size_);
            in_.number("largest number", size_);
        }
    }

    void index_nodes() {
        raw_.in_lower_cell.assign(raw_.nodes.size(), 0);
        for (std::size_t n = 0; n < raw_.node_number.size(); ++n) {
            order_.emplace_back(raw_.node_number[n], static_cast<int>(n));
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
        in_.fail("element " + std::to_string(element_) + " uses node number " + std::to_string(id),
                 "a number from $Nodes");
        return 0;
    }

    /// Which physical tag, if any, each volume carries.
    void entities() {
        begin_numbers();
        std::array<std::size_t, 4> counts{};
        for (std::size_t& count : counts) {
            count = in_.count("entities", 8, size_);
        }
        for (std::size_t dimension = 0; dimension < 4; ++dimension) {
            for (std::size_t e = 0; e < counts[dimension] && !in_.failed(); ++e) {
                entity(dimension);
            }
        }
    }

    void entity(std::size_t dimension) {
        const std::int64_t id = in_.integer("entity", -most_int, most_int);
        for (int i = 0; i < (dimension == 0 && version_ == Version::four_1 ? 3 : 6); ++i) {
            in_.number("bound");
        }
        const std::size_t physical = in_.count("physical tags", 2, size_);
        for (std::size_t p = 0; p < physical && !in_.failed(); ++p) {
            const std::int64_t value = in_.integer("physical tag", -most_int, most_int);
            if (dimension == 3 && p == 0) {
                physical_[id] = static_cast<int>(value);
            }
        }
        const std::size_t bounding = dimension > 0 ? in_.count("bounding entities", 2, size_) : 0;
        for (std::size_t b = 0; b < bounding && !in_.failed(); ++b) {
            in_.integer("bounding entity", -most_int, most_int);
        }
    }

    static const CellKind* kind_of(std::int64_t code) {
        const auto* found = std::find_if(msh_kinds.begin(), msh_kinds.end(),
                                         [code](const CellKind& kind) { return kind.code == code; });
        return found == msh_kinds.end() ? nullptr : found;
    }

    /// The nodes of an element, whose number has been read.
    void element(std::int64_t code, int physical) {
        const CellKind* kind = kind_of(code);
        const int line = in_.line();
        if (kind == nullptr) {
            in_.fail("element " + std::to_string(element_) + " is of type " + std::to_string(code),
                     "tetrahedra of 4 nodes, and points, lines and surfaces, which are left out");
            return;
        }
        std::vector<int> nodes;
        for (int i = 0; i < kind->nodes && !in_.failed(); ++i) {
            nodes.push_back(node());
        }
        if (!in_.failed() && add_cell(kind, code, nodes, {line, element_}, raw_, in_)) {
            raw_.tag.push_back(physical);
        }
    }

    void number_element() { element_ = tag("element number"); }

    /// Elements of version 2 in bytes stand in blocks of one type.
    void elements_2() {
        const std::size_t count = in_.count("elements", 8);
        begin_numbers();
        if (version_ == Version::one) {
            elements_1(count);
            return;
        }
        for (std::size_t e = 0; e < count && !in_.failed();) {
            std::int64_t code = 0;
            std::size_t in_block = 1;
            std::size_t tags = 0;
            if (binary_) {
                code = in_.integer("element type", 1, 1000);
                in_block = static_cast<std::size_t>(
                    in_.integer("elements of a block", 1, static_cast<std::int64_t>(count - e)));
                tags = in_.count("tags", 2);
            }
            for (std::size_t i = 0; i < in_block && !in_.failed(); ++i, ++e) {
                number_element();
                if (!binary_) {
                    code = in_.integer("element type", 1, 1000);
                    tags = in_.count("tags", 2);
                }
                element(code, first_of(tags));
            }
        }
    }

    int first_of(std::size_t tags) {
        int physical = 0;
        for (std::size_t t = 0; t < tags && !in_.failed(); ++t) {
            const std::int64_t value = in_.integer("tag", -most_int, most_int);
            physical = t == 0 ? static_cast<int>(value) : physical;
        }
        return physical;
    }

    void elements_1(std::size_t count) {
        for (std::size_t e = 0; e < count && !in_.failed(); ++e) {
            number_element();
            const std::int64_t code = in_.integer("element type", 1, 1000);
            const int physical = first_of(2);
            const CellKind* kind = kind_of(code);
            const std::int64_t nodes = in_.integer("number of nodes", 1, 1000);
            if (!in_.failed() && kind != nullptr && kind->nodes != nodes) {
                in_.fail("element " + std::to_string(element_) + " has " + std::to_string(nodes) + " nodes",
                         std::to_string(kind->nodes) + " for type " + std::to_string(code));
            }
            element(code, physical);
        }
    }

    void elements_4() {
        begin_numbers();
        const std::size_t blocks = in_.count("element blocks", 8, size_);
        const std::size_t announced = in_.count("elements", 4, size_);
        least_and_largest();
        std::size_t listed = 0;
        for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
            const Block block = block_of();
            const std::int64_t code = in_.integer("element type", 1, 1000);
            const std::size_t count = in_.count("elements", 4, size_);
            const std::map<std::int64_t, int>::const_iterator found = physical_.find(block.entity);
            const bool of_volume = block.dimension == 3 && found != physical_.end();
            for (std::size_t e = 0; e < count && !in_.failed(); ++e) {
                number_element();
                element(code, of_volume ? found->second : 0);
            }
            listed += count;
        }
        if (!in_.failed() && listed != announced) {
            in_.fail("announces " + std::to_string(announced) + " elements but lists " + std::to_string(listed));
        }
    }

    TokenReader in_;
    RawMesh raw_;
    Version version_ = Version::two;
    bool binary_ = false;
    bool big_end_first_ = false;
    NumberForm size_{NumberForm::natural, 8};  ///< of counts in version 4
    std::int64_t element_ = 0;                 ///< number of the one that is read
    bool have_nodes_ = false;
    bool have_elements_ = false;
    std::vector<std::pair<std::int64_t, int>> order_;  ///< the same with indices, sorted
    std::map<std::int64_t, int> physical_;             ///< first physical tag of each volume
};

}  // namespace

Result<RawMesh> read_msh(std::string_view text, const std::string& path) { return MshReader(text, path).run(); }

}  // namespace rhexis
