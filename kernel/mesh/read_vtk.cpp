// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK, text form: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include <algorithm>
#include <limits>

#include "mesh/raw_mesh.hpp"

namespace rhexis {

namespace {

/// nodes 0: any number.
constexpr std::array<CellKind, 17> vtk_kinds{{{1, 0, 1},
                                              {2, 0, 0},
                                              {3, 1, 2},
                                              {4, 1, 0},
                                              {5, 2, 3},
                                              {6, 2, 0},
                                              {7, 2, 0},
                                              {8, 2, 4},
                                              {9, 2, 4},
                                              {10, 3, 4},
                                              {11, 3, 8},
                                              {12, 3, 8},
                                              {13, 3, 6},
                                              {14, 3, 5},
                                              {21, 1, 3},
                                              {22, 2, 6},
                                              {24, 3, 10}}};

constexpr int most_region = 999;

class VtkReader {
public:
    VtkReader(std::string_view text, const std::string& path) : in_(text, path) {}

    Result<RawMesh> run() {
        header();
        for (std::string_view word = in_.word(); !word.empty() && !in_.failed(); word = in_.word()) {
            section(word);
        }
        if (!in_.failed()) {
            build();
        }
        if (in_.failed()) {
            return in_.error();
        }
        return std::move(raw_);
    }

private:
    struct Cell {
        std::size_t first;  ///< in nodes_
        std::size_t count;
        int line;
    };

    void header() {
        if (in_.rest_of_line().substr(0, 22) != "# vtk DataFile Version") {
            in_.fail("is not a legacy VTK file", "a first line \"# vtk DataFile Version 3.0\"");
        }
        in_.rest_of_line();
        const std::string_view form = in_.word();
        if (same_word(form, "BINARY")) {
            in_.fail("is a binary VTK file", "ASCII");
        } else if (!same_word(form, "ASCII")) {
            in_.fail("the third line should say ASCII");
        }
        in_.expect("DATASET");
        const std::string_view dataset = in_.needed_word("UNSTRUCTURED_GRID");
        if (!in_.failed() && !same_word(dataset, "UNSTRUCTURED_GRID")) {
            in_.fail("the dataset is not an unstructured grid", "UNSTRUCTURED_GRID");
        }
    }

    void section(std::string_view word) {
        if (same_word(word, "POINTS")) {
            points();
        } else if (same_word(word, "CELLS")) {
            cells();
        } else if (same_word(word, "CELL_TYPES")) {
            types();
        } else if (same_word(word, "METADATA")) {
            in_.skip_to_empty_line();
        } else if (same_word(word, "FIELD")) {
            field();
        } else if (same_word(word, "CELL_DATA")) {
            data_of_cells_ = true;
            data_count_ = static_cast<std::size_t>(in_.integer("number of cells", 0, in_cells()));
        } else if (same_word(word, "POINT_DATA")) {
            data_of_cells_ = false;
            data_count_ = static_cast<std::size_t>(
                in_.integer("number of points", 0, static_cast<std::int64_t>(raw_.nodes.size())));
        } else {
            attribute(word);
        }
    }

    [[nodiscard]] std::int64_t in_cells() const { return static_cast<std::int64_t>(cells_.size()); }

    void points() {
        const std::size_t count = in_.count("points", 6);
        in_.needed_word("type of the coordinates");
        raw_.nodes.clear();
        raw_.node_line.clear();
        for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
            const double x = in_.number("coordinate");
            raw_.node_line.push_back(in_.line());
            const double y = in_.number("coordinate");
            const double z = in_.number("coordinate");
            raw_.nodes.emplace_back(x, y, z);
        }
        raw_.in_lower_cell.assign(raw_.nodes.size(), 0);
    }

    int node() {
        return static_cast<int>(
            in_.integer("node index", std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
    }

    /// Up to version 4: "count n a b c ..." per cell. From 5.0: offsets and connectivity as two lists.
    void cells() {
        const std::size_t count = in_.count("cells", 2);
        const std::size_t size = in_.count("cell entries", 2);
        cells_.clear();
        nodes_.clear();
        if (count == 0) {
            return;
        }
        const std::string_view first = in_.needed_word("cells");
        if (same_word(first, "OFFSETS")) {
            offset_cells(count, size);
            return;
        }
        std::int64_t in_this = 0;
        for (std::size_t c = 0; c < count && !in_.failed(); ++c) {
            const std::int64_t most = static_cast<std::int64_t>(size - nodes_.size());
            if (c == 0) {
                in_this = leading_count(first, most);
            } else {
                in_this = in_.integer("number of nodes of a cell", 1, most);
            }
            cells_.push_back({nodes_.size(), static_cast<std::size_t>(in_this), in_.line()});
            for (std::int64_t i = 0; i < in_this && !in_.failed(); ++i) {
                nodes_.push_back(node());
            }
        }
    }

    /// The first cell's node count was read as a word, since it could have been a keyword.
    std::int64_t leading_count(std::string_view word, std::int64_t most) {
        TokenReader again(word, in_.path());
        const std::int64_t value = again.integer("number of nodes of a cell", 1, most);
        if (again.failed()) {
            in_.fail(again.error().what, again.error().allowed);
        }
        return value;
    }

    void offset_cells(std::size_t offset_count, std::size_t size) {
        in_.needed_word("type of the offsets");
        std::vector<std::size_t> offsets;
        std::int64_t last = 0;
        for (std::size_t c = 0; c < offset_count && !in_.failed(); ++c) {
            last = in_.integer("cell offset", last, static_cast<std::int64_t>(size));
            offsets.push_back(static_cast<std::size_t>(last));
        }
        in_.expect("CONNECTIVITY");
        in_.needed_word("type of the indices");
        std::vector<int> lines;
        for (std::size_t i = 0; i < size && !in_.failed(); ++i) {
            nodes_.push_back(node());
            lines.push_back(in_.line());
        }
        for (std::size_t c = 0; c + 1 < offsets.size() && !in_.failed(); ++c) {
            const int line = offsets[c] < lines.size() ? lines[offsets[c]] : in_.line();
            cells_.push_back({offsets[c], offsets[c + 1] - offsets[c], line});
        }
    }

    void types() {
        const std::size_t count = in_.count("cell types", 2);
        types_.clear();
        for (std::size_t c = 0; c < count && !in_.failed(); ++c) {
            types_.push_back(static_cast<int>(in_.integer("cell type", 0, 1000)));
        }
    }

    void skip_numbers(std::size_t count) {
        for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
            in_.number("value");
        }
    }

    void field() {
        in_.needed_word("name of the field");
        const std::size_t arrays = in_.count("arrays", 8);
        for (std::size_t a = 0; a < arrays && !in_.failed(); ++a) {
            in_.needed_word("name of an array");
            const std::size_t components = in_.count("components", 1);
            const std::size_t tuples = in_.count("tuples", 1);
            const bool text = same_word(in_.needed_word("type of an array"), "string");
            for (std::size_t t = 0; t < tuples && !in_.failed(); ++t) {
                if (text) {
                    in_.rest_of_line();
                } else {
                    skip_numbers(components);
                }
            }
        }
    }

    void attribute(std::string_view kind) {
        const std::string name(in_.needed_word("name of the data"));
        if (same_word(kind, "SCALARS")) {
            scalars(name);
        } else if (same_word(kind, "LOOKUP_TABLE")) {
            skip_numbers(4 * in_.count("colours", 8));
        } else if (same_word(kind, "VECTORS") || same_word(kind, "NORMALS")) {
            in_.needed_word("type of the data");
            skip_numbers(3 * data_count_);
        } else if (same_word(kind, "TENSORS")) {
            in_.needed_word("type of the data");
            skip_numbers(9 * data_count_);
        } else {
            in_.fail("has an unknown section", "POINTS, CELLS, CELL_TYPES, CELL_DATA, POINT_DATA and their data");
        }
    }

    void scalars(const std::string& name) {
        in_.needed_word("type of the data");
        std::string_view next = in_.needed_word("LOOKUP_TABLE");
        std::int64_t components = 1;
        if (!same_word(next, "LOOKUP_TABLE")) {
            TokenReader again(next, in_.path());
            components = again.integer("number of components", 1, 4);
            if (again.failed()) {
                in_.fail(again.error().what, again.error().allowed);
            }
            in_.expect("LOOKUP_TABLE");
        }
        in_.needed_word("name of the lookup table");
        if (!data_of_cells_ || name != "region" || components != 1) {
            skip_numbers(static_cast<std::size_t>(components) * data_count_);
            return;
        }
        regions_.clear();
        for (std::size_t c = 0; c < data_count_ && !in_.failed(); ++c) {
            regions_.push_back(static_cast<int>(in_.integer("region", 0, most_region)));
        }
    }

    void build() {
        if (types_.size() != cells_.size()) {
            in_.fail("has " + std::to_string(cells_.size()) + " cells and " + std::to_string(types_.size()) +
                     " cell types");
        }
        if (!regions_.empty() && regions_.size() != cells_.size()) {
            in_.fail("has " + std::to_string(regions_.size()) + " regions for " + std::to_string(cells_.size()) +
                     " cells");
        }
        for (std::size_t c = 0; c < cells_.size() && !in_.failed(); ++c) {
            const Cell& cell = cells_[c];
            const CellKind* kind = std::find_if(vtk_kinds.begin(), vtk_kinds.end(),
                                                [this, c](const CellKind& one) { return one.code == types_[c]; });
            const std::span<const int> nodes = std::span<const int>(nodes_).subspan(cell.first, cell.count);
            const bool solid =
                add_cell(kind == vtk_kinds.end() ? nullptr : kind, types_[c], nodes, cell.line, raw_, in_);
            if (solid && !regions_.empty()) {
                raw_.tag.push_back(regions_[c]);
            }
        }
    }

    TokenReader in_;
    RawMesh raw_;
    std::vector<Cell> cells_;
    std::vector<int> nodes_;
    std::vector<int> types_;
    std::vector<int> regions_;
    bool data_of_cells_ = false;
    std::size_t data_count_ = 0;
};

}  // namespace

Result<RawMesh> read_vtk(std::string_view text, const std::string& path) { return VtkReader(text, path).run(); }

}  // namespace rhexis
