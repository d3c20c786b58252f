// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK, text and binary: https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include <algorithm>
#include <cmath>
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

constexpr std::int64_t most_index = std::numeric_limits<std::int64_t>::max();

constexpr std::size_t most_values = std::size_t{1} << 40;

/// What an array is made of.
struct DataType {
    std::string_view name;
    NumberForm form;
};

constexpr std::array<DataType, 18> data_types{{{"char", {NumberForm::whole, 1}},
                                               {"signed_char", {NumberForm::whole, 1}},
                                               {"unsigned_char", {NumberForm::natural, 1}},
                                               {"short", {NumberForm::whole, 2}},
                                               {"unsigned_short", {NumberForm::natural, 2}},
                                               {"int", {NumberForm::whole, 4}},
                                               {"unsigned_int", {NumberForm::natural, 4}},
                                               {"long", {NumberForm::whole, 8}},
                                               {"unsigned_long", {NumberForm::natural, 8}},
                                               {"long_long", {NumberForm::whole, 8}},
                                               {"unsigned_long_long", {NumberForm::natural, 8}},
                                               {"vtktypeint64", {NumberForm::whole, 8}},
                                               {"vtktypeuint64", {NumberForm::natural, 8}},
                                               {"vtkIdType", {NumberForm::whole, 4}},  // as legacy files write it
                                               {"float", {NumberForm::real, 4}},
                                               {"double", {NumberForm::real, 8}},
                                               {"bit", {NumberForm::natural, 0}},
                                               {"string", {NumberForm::natural, 0}}}};

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
        binary_ = same_word(form, "BINARY");
        if (!binary_ && !same_word(form, "ASCII")) {
            in_.fail("the third line should say ASCII or BINARY");
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
            metadata();
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

    /// The word that says what an array is made of.
    const DataType& data_type() {
        const std::string_view word = in_.needed_word("type of the data");
        const auto* found = std::find_if(data_types.begin(), data_types.end(),
                                         [word](const DataType& type) { return same_word(type.name, word); });
        if (found == data_types.end()) {
            in_.fail("the data is of type " + std::string(word.substr(0, 30)), "int, float, double, ...");
            return data_types.front();
        }
        return *found;
    }

    /// Where an array's values begin, behind the line that announces them.
    void begin_values() {
        if (binary_) {
            in_.begin_bytes(true);
        }
    }
    void end_values() { in_.end_bytes(); }

    void points() {
        const std::size_t count = in_.count("points", 6);
        const DataType& type = data_type();
        raw_.nodes.clear();
        raw_.node_line.clear();
        raw_.node_number.clear();
        begin_values();
        for (std::size_t n = 0; n < count && !in_.failed(); ++n) {
            const double x = in_.number("coordinate", type.form);
            raw_.node_line.push_back(in_.line());
            raw_.node_number.push_back(static_cast<std::int64_t>(n));
            const double y = in_.number("coordinate", type.form);
            const double z = in_.number("coordinate", type.form);
            raw_.nodes.emplace_back(x, y, z);
        }
        end_values();
        raw_.in_lower_cell.assign(raw_.nodes.size(), 0);
    }

    int node(NumberForm form = {}) {
        return static_cast<int>(
            in_.integer("node index", std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), form));
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
        if (in_.next_is("OFFSETS")) {
            offset_cells(count, size);
            return;
        }
        begin_values();
        for (std::size_t c = 0; c < count && !in_.failed(); ++c) {
            const std::int64_t most = static_cast<std::int64_t>(size - nodes_.size());
            const std::int64_t in_this = in_.integer("number of nodes of a cell", 1, most);
            cells_.push_back({nodes_.size(), static_cast<std::size_t>(in_this), in_.line()});
            for (std::int64_t i = 0; i < in_this && !in_.failed(); ++i) {
                nodes_.push_back(node());
            }
        }
        end_values();
    }

    void offset_cells(std::size_t offset_count, std::size_t size) {
        in_.expect("OFFSETS");
        const NumberForm of_offsets = data_type().form;
        begin_values();
        std::vector<std::size_t> offsets;
        std::int64_t last = 0;
        for (std::size_t c = 0; c < offset_count && !in_.failed(); ++c) {
            last = in_.integer("cell offset", last, static_cast<std::int64_t>(size), of_offsets);
            offsets.push_back(static_cast<std::size_t>(last));
        }
        end_values();
        in_.expect("CONNECTIVITY");
        const NumberForm of_nodes = data_type().form;
        begin_values();
        std::vector<int> lines;
        for (std::size_t i = 0; i < size && !in_.failed(); ++i) {
            nodes_.push_back(node(of_nodes));
            lines.push_back(in_.line());
        }
        end_values();
        for (std::size_t c = 0; c + 1 < offsets.size() && !in_.failed(); ++c) {
            const int line = offsets[c] < lines.size() ? lines[offsets[c]] : in_.line();
            cells_.push_back({offsets[c], offsets[c + 1] - offsets[c], line});
        }
    }

    void types() {
        const std::size_t count = in_.count("cell types", 2);
        types_.clear();
        begin_values();
        for (std::size_t c = 0; c < count && !in_.failed(); ++c) {
            types_.push_back(static_cast<int>(in_.integer("cell type", 0, 1000)));
        }
        end_values();
    }

    /// count: of tuples; width: of each.
    void skip_values(const DataType& type, std::size_t count, std::size_t width) {
        width_ = width;
        if (width != 0 && count > most_values / width) {
            in_.fail("announces more values than a file holds");
            return;
        }
        if (same_word(type.name, "string")) {
            skip_texts(count * width);
        } else if (binary_) {
            begin_values();
            const std::size_t bits = same_word(type.name, "bit") ? 1 : 8 * static_cast<std::size_t>(type.form.bytes);
            in_.skip_bytes((count * width * bits + 7) / 8);
            end_values();
        } else {
            for (std::size_t i = 0; i < count * width && !in_.failed(); ++i) {
                in_.needed_word("value");
            }
        }
    }

    /// A line each; in a binary file, each with its length before it, whose first two bits say how long that is.
    void skip_texts(std::size_t count) {
        begin_values();
        if (!binary_) {
            in_.rest_of_line();
        }
        for (std::size_t i = 0; i < count && !in_.failed(); ++i) {
            if (!binary_) {
                in_.needed_line("a text");
                continue;
            }
            const std::int64_t first = in_.integer("length of a text", 0, 255, {NumberForm::natural, 1});
            std::uint64_t length = static_cast<std::uint64_t>(first) & 63U;
            const int more = (1 << (3 - (first >> 6))) - 1;  // bytes of the length besides the first
            for (int b = 0; b < more && !in_.failed(); ++b) {
                length = length << 8 |
                         static_cast<std::uint64_t>(in_.integer("length of a text", 0, 255, {NumberForm::natural, 1}));
            }
            in_.skip_bytes(static_cast<std::size_t>(length));
        }
        end_values();
    }

    void field() {
        in_.needed_word("name of the field");
        const std::size_t arrays = in_.count("arrays", 4);
        for (std::size_t a = 0; a < arrays && !in_.failed(); ++a) {
            while (in_.next_is("METADATA")) {
                in_.word();
                metadata();
            }
            in_.needed_word("name of an array");
            const std::size_t components = size_of("components");
            const std::size_t tuples = size_of("tuples");
            skip_values(data_type(), tuples, components);
        }
    }

    /// What is announced, and may be zero bytes large.
    std::size_t size_of(const char* what) {
        return static_cast<std::size_t>(in_.integer(std::string("number of ") + what, 0, most_index));
    }

    /// Of the array before it: names of its components, one per line, which may be empty; then lines up to an empty
    /// one.
    void metadata() {
        in_.rest_of_line();
        for (std::string_view line = in_.rest_of_line(); !line.empty(); line = in_.rest_of_line()) {
            for (std::size_t i = 0; same_word(line, "COMPONENT_NAMES") && i < width_ && !in_.at_end(); ++i) {
                in_.rest_of_line();
            }
        }
    }

    void attribute(std::string_view kind) {
        struct Attribute {
            std::string_view kind;
            std::size_t width;
        };
        static constexpr std::array<Attribute, 6> plain{
            {{"VECTORS", 3}, {"NORMALS", 3}, {"TENSORS", 9}, {"TENSORS6", 6}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}}};
        const std::string name(in_.needed_word("name of the data"));
        const auto* found = std::find_if(plain.begin(), plain.end(),
                                         [kind](const Attribute& one) { return same_word(one.kind, kind); });
        if (found != plain.end()) {
            skip_values(data_type(), data_count_, found->width);
        } else if (same_word(kind, "SCALARS")) {
            scalars(name);
        } else if (same_word(kind, "COLOR_SCALARS")) {
            skip_values(colour(), data_count_, size_of("components"));
        } else if (same_word(kind, "TEXTURE_COORDINATES")) {
            const std::size_t width = size_of("components");
            skip_values(data_type(), data_count_, width);
        } else if (same_word(kind, "LOOKUP_TABLE")) {
            skip_values(colour(), size_of("colours"), 4);
        } else {
            in_.fail("has an unknown section", "POINTS, CELLS, CELL_TYPES, CELL_DATA, POINT_DATA and their data");
        }
    }

    /// Colours are bytes in a binary file.
    static const DataType& colour() { return data_types[2]; }

    void scalars(const std::string& name) {
        const DataType& type = data_type();
        std::size_t components = 1;
        if (!in_.next_is("LOOKUP_TABLE") && in_.next_is_on_this_line()) {
            components = size_of("components");
        }
        if (in_.next_is("LOOKUP_TABLE")) {
            in_.word();
            in_.needed_word("name of the lookup table");
        }
        if (!data_of_cells_ || name != "region" || components != 1 || type.form.bytes == 0) {
            skip_values(type, data_count_, components);
            return;
        }
        width_ = 1;
        std::vector<double> values;
        begin_values();
        for (std::size_t c = 0; c < data_count_ && !in_.failed(); ++c) {
            values.push_back(in_.number("region", type.form));
        }
        end_values();
        take_regions(values);
    }

    /// Whole numbers are regions; measured values, of whatever that name stood for, are not.
    void take_regions(const std::vector<double>& values) {
        regions_.clear();
        const bool whole = std::all_of(values.begin(), values.end(), [](double value) {
            return std::abs(value) <= std::numeric_limits<int>::max() && value == std::floor(value);
        });
        for (std::size_t c = 0; whole && c < values.size(); ++c) {
            regions_.push_back(static_cast<int>(values[c]));
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
            const bool solid = add_cell(kind == vtk_kinds.end() ? nullptr : kind, types_[c], nodes,
                                        {cell.line, static_cast<std::int64_t>(c)}, raw_, in_);
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
    bool binary_ = false;
    bool data_of_cells_ = false;
    std::size_t width_ = 0;  ///< components of the array last read
    std::size_t data_count_ = 0;
};

}  // namespace

Result<RawMesh> read_vtk(std::string_view text, const std::string& path) { return VtkReader(text, path).run(); }

}  // namespace rhexis
