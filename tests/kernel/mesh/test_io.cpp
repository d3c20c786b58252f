// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/text_file.hpp"
#include "mesh/io.hpp"
#include "mesh/quality.hpp"
#include "mesh/shapes.hpp"

using namespace rhexis;

namespace {

const std::string data = "tests/data/meshes/";

/// A folder that is gone when the test ends.
class TemporaryFolder {
public:
    TemporaryFolder() : path_(std::filesystem::temp_directory_path() / ("rhexis_mesh_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

bool left_unfinished(const TemporaryFolder& folder) {
    const std::filesystem::directory_iterator files(folder.file(""));
    return std::any_of(begin(files), end(files),
                       [](const auto& file) { return file.path().extension() == ".unfinished"; });
}

std::string text_of(const std::string& path) { return read_text_file(path, 1 << 24).value(); }

void write(const std::string& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

/// What is said of a file with that content, without its folder.
std::string fault(const std::string& name, const std::string& content) {
    const TemporaryFolder folder;
    write(folder.file(name), content);
    const Result<MeshFile> file = read_tet_mesh(folder.file(name));
    if (file.ok()) {
        return "";
    }
    const std::string text = file.error().text();
    CHECK(text.find('\n') == std::string::npos);
    REQUIRE(text.find(folder.file(name)) == 0);
    return text.substr(folder.file(name).size());
}

std::string with_cells(const std::string& points, const std::string& cells, const std::string& types) {
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + points + "\nCELLS " + cells +
           "\nCELL_TYPES " + types + "\n";
}

const std::string four = "4 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1";

/// The element's number on the line of a Gmsh 2 file that goes on at `at`.
std::string number_before(const std::string& text, std::size_t at) {
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, at - begin);
}

/// A file's numbers as bytes.
class Bytes {
public:
    explicit Bytes(bool big_end_first) : big_(big_end_first) {}
    template <typename Number>
    Bytes& add(Number value) {
        std::array<char, sizeof(Number)> bytes{};
        std::memcpy(bytes.data(), &value, sizeof(Number));  // this machine's order, low end first
        if (big_) {
            std::reverse(bytes.begin(), bytes.end());
        }
        text_.append(bytes.data(), bytes.size());
        return *this;
    }
    Bytes& add_text(const std::string& text) {
        text_ += text;
        return *this;
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    bool big_;
    std::string text_;
};

const std::array<std::array<double, 3>, 6> places{{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {9, 9, 9}}};
const std::array<std::array<int, 4>, 2> two_tets{
    {{1, 2, 3, 4}, {1, 3, 2, 5}}};  // of volume 0.5 each; node 6 is of none
const std::array<int, 2> physical{9, 7};

std::string gmsh_2_bytes() {
    Bytes out(false);
    out.add_text("$MeshFormat\n2.2 1 8\n").add(std::int32_t{1}).add_text("\n$EndMeshFormat\n$Nodes\n6\n");
    for (int n = 0; n < 6; ++n) {
        out.add(std::int32_t{n + 1});
        for (const double x : places[static_cast<std::size_t>(n)]) {
            out.add(x);
        }
    }
    out.add_text("\n$EndNodes\n$Elements\n3\n");
    for (const std::int32_t number : {2, 1, 2, 1, 3, 3, 1, 2, 3}) {  // one triangle
        out.add(number);
    }
    for (const std::int32_t number : {4, 2, 2}) {
        out.add(number);
    }
    for (int t = 0; t < 2; ++t) {
        out.add(std::int32_t{t + 2}).add(std::int32_t{physical[static_cast<std::size_t>(t)]}).add(std::int32_t{t});
        for (const std::int32_t node : two_tets[static_cast<std::size_t>(t)]) {
            out.add(node);
        }
    }
    return out.add_text("\n$EndElements\n").text();
}

std::string gmsh_4_bytes(bool big_end_first) {
    Bytes out(big_end_first);
    const auto sizes = [&out](std::initializer_list<std::uint64_t> numbers) {
        for (const std::uint64_t number : numbers) {
            out.add(number);
        }
    };
    out.add_text("$MeshFormat\n4.1 1 8\n").add(std::int32_t{1}).add_text("\n$EndMeshFormat\n$Entities\n");
    sizes({0, 0, 0, 2});
    for (int t = 0; t < 2; ++t) {
        out.add(std::int32_t{t + 1});
        for (int i = 0; i < 6; ++i) {
            out.add(0.0);
        }
        sizes({1});
        out.add(std::int32_t{physical[static_cast<std::size_t>(t)]});
        sizes({0});
    }
    out.add_text("\n$EndEntities\n$Nodes\n");
    sizes({1, 6, 1, 6});
    out.add(std::int32_t{3}).add(std::int32_t{1}).add(std::int32_t{0});
    sizes({6, 1, 2, 3, 4, 5, 6});
    for (const auto& place : places) {
        for (const double x : place) {
            out.add(x);
        }
    }
    out.add_text("\n$EndNodes\n$Elements\n");
    sizes({2, 2, 1, 2});
    for (int t = 0; t < 2; ++t) {
        out.add(std::int32_t{3}).add(std::int32_t{t + 1}).add(std::int32_t{4});
        sizes({1, static_cast<std::uint64_t>(t) + 1});
        for (const int node : two_tets[static_cast<std::size_t>(t)]) {
            sizes({static_cast<std::uint64_t>(node)});
        }
    }
    return out.add_text("\n$EndElements\n").text();
}

std::string place_lines(const char* separator) {
    std::string text;
    for (std::size_t n = 0; n < places.size(); ++n) {
        text += std::to_string(n + 1) + separator;
        for (const double x : places[n]) {
            text += std::to_string(x) + " ";
        }
        text += "\n";
    }
    return text;
}

/// The same two tetrahedra in every form that Gmsh has written.
std::vector<std::pair<std::string, std::string>> gmsh_files() {
    return {
        {"1", "$NOD\n6\n" + place_lines(" ") +
                  "$ENDNOD\n$ELM\n3\n1 2 1 1 3 1 2 3\n2 4 9 1 4 1 2 3 4\n3 4 7 2 4 1 3 2 5\n$ENDELM\n"},
        {"2 bytes", gmsh_2_bytes()},
        {"4.0",
         "$MeshFormat\n4 0 8\n$EndMeshFormat\n$Entities\n1 0 0 2\n1 0 0 0 0 0 0 0\n1 0 0 0 3 1 1 1 9 0\n"
         "2 0 0 0 3 1 1 1 7 0\n$EndEntities\n$Nodes\n1 6\n1 3 0 6\n" +
             place_lines(" ") + "$EndNodes\n$Elements\n2 2\n1 3 4 1\n1 1 2 3 4\n2 3 4 1\n2 1 3 2 5\n$EndElements\n"},
        {"4.1 bytes", gmsh_4_bytes(false)},
        {"4.1 bytes, big end first", gmsh_4_bytes(true)}};
}

/// A tetrahedron of volume 0.5 and a node of no cell, with every kind of attribute.
std::string vtk_with_attributes(bool binary) {
    Bytes out(true);
    const auto reals = [&](std::initializer_list<double> values) {
        for (const double value : values) {
            binary ? out.add(value) : out.add_text(std::to_string(value) + " ");
        }
        out.add_text("\n");
    };
    const auto wholes = [&](std::initializer_list<int> values) {
        for (const std::int32_t value : values) {
            binary ? out.add(value) : out.add_text(std::to_string(value) + " ");
        }
        out.add_text("\n");
    };
    out.add_text("# vtk DataFile Version 3.0\nt\n").add_text(binary ? "BINARY" : "ASCII");
    out.add_text("\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n");
    reals({0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 1, 8, 8, 8});
    out.add_text("CELLS 1 5\n");
    wholes({4, 0, 1, 2, 3});
    out.add_text("CELL_TYPES 1\n");
    wholes({10});
    out.add_text("CELL_DATA 1\nSCALARS six double 6\nLOOKUP_TABLE default\n");
    reals({1, 2, 3, 4, 5, 6});
    out.add_text("TENSORS6 t double\n");
    reals({1, 2, 3, 4, 5, 6});
    out.add_text("GLOBAL_IDS g int\n");
    wholes({3});
    out.add_text("PEDIGREE_IDS p vtkIdType\n");
    wholes({3});
    out.add_text("COLOR_SCALARS c 3\n").add_text(binary ? "abc\n" : "0 0.5 1\n");
    out.add_text("SCALARS region int 1\nLOOKUP_TABLE default\n");
    wholes({-3});
    out.add_text("POINT_DATA 5\nTEXTURE_COORDINATES x 2 double\n");
    reals({0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    out.add_text("FIELD f 2\nname 1 2 string\n");
    out.add_text(binary ? std::string("\xc3") + "one" + "\xc2" + "ab" : "one word\nab")
        .add_text("\nthree 3 5 double\n");
    reals({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    return out.add_text("METADATA\nCOMPONENT_NAMES\nX\n\n\nINFORMATION 1\nNAME u LOCATION v\nDATA mm\n\n").text();
}

}  // namespace

TEST_SUITE("mesh") {
    TEST_CASE("a mesh written and read again is the same, bit for bit") {
        const TemporaryFolder folder;
        TetMesh mesh = lens_body({4.8, 1.95, 2.8}, 500);
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            mesh.region[t] = static_cast<int>(t % 3);
        }
        for (const char* name : {"lens.vtk", "lens.msh"}) {
            REQUIRE(write_tet_mesh(mesh, folder.file(name)).ok());
            const Result<MeshFile> back = read_tet_mesh(folder.file(name));
            REQUIRE_MESSAGE(back.ok(), back.error().text());
            CHECK(back.value().mesh.nodes == mesh.nodes);
            CHECK(back.value().mesh.tets == mesh.tets);
            CHECK(back.value().mesh.region == mesh.region);
            CHECK(back.value().region_tags.size() == 3);
            CHECK_FALSE(left_unfinished(folder));
        }
    }

    TEST_CASE("the reference lens meshes load with the volume and quality stated for them") {
        const Result<MeshFile> file = read_tet_mesh(data + "lens_3000.vtk");
        REQUIRE(file.ok());
        const MeshQuality quality = mesh_quality(file.value().mesh);
        CHECK(file.value().mesh.nodes.size() == 747);
        CHECK(file.value().mesh.tets.size() == 2986);
        CHECK(quality.volume == doctest::Approx(192.22).epsilon(1e-4));
        CHECK(quality.min_ratio == doctest::Approx(0.296).epsilon(2e-3));
        CHECK(quality.mean_ratio == doctest::Approx(0.777).epsilon(2e-3));
    }

    TEST_CASE("files written by Gmsh load: both text versions, with physical volumes, and VTK with surfaces") {
        for (const char* name : {"two_boxes_2.2.msh", "two_boxes_4.1.msh", "two_boxes.vtk"}) {
            CAPTURE(name);
            const Result<MeshFile> file = read_tet_mesh(data + name);
            REQUIRE_MESSAGE(file.ok(), file.error().text());
            const TetMesh& mesh = file.value().mesh;
            CHECK(mesh_volume(mesh) == doctest::Approx(2.0).epsilon(1e-12));
            if (std::string(name).find(".msh") != std::string::npos) {
                CHECK(file.value().region_tags == std::vector<int>{5, 11});
                for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
                    double x = 0.0;
                    for (int node : mesh.tets[t]) {
                        x += 0.25 * mesh.nodes[static_cast<std::size_t>(node)].x();
                    }
                    CHECK(mesh.region[t] == (x > 1.0 ? 0 : 1));  // tag 5 is the box beyond x = 1
                }
            }
        }
    }

    TEST_CASE("the VTK 5 form with offsets and metadata is read") {
        const std::string text =
            "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + four +
            "\nMETADATA\nINFORMATION 1\nNAME x LOCATION y\n\nCELLS 2 4\nOFFSETS vtktypeint64\n0 4\nCONNECTIVITY "
            "vtktypeint64\n0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\nVECTORS v float\n0 0 0 0 0 0 0 0 0 0 0 0\n"
            "CELL_DATA 1\nFIELD FieldData 1\nq 1 1 double\n0.5\nSCALARS region int\nLOOKUP_TABLE default\n7\n";
        const TemporaryFolder folder;
        write(folder.file("five.vtk"), text);
        const Result<MeshFile> file = read_tet_mesh(folder.file("five.vtk"));
        REQUIRE_MESSAGE(file.ok(), file.error().text());
        CHECK(file.value().mesh.region == std::vector<int>{7});
    }

    TEST_CASE("an inverted, flat, repeated or broken element is named with its number and line") {
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 3", "1\n10")) == "");
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 2 1 3", "1\n10")) ==
              ":11: tetrahedron 0 is inverted (its volume is negative) (positive orientation)");
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 4", "1\n10")) == ":11: tetrahedron 0 uses node 4 (0 to 3)");
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 -1", "1\n10")).find("uses node -1") != std::string::npos);
        CHECK(
            fault("a.vtk", with_cells(four, "1 5\n4 0 1 1 3", "1\n10")).find(":11: tetrahedron 0 uses a node twice") ==
            0);
        CHECK(fault("a.vtk", with_cells(four, "2 10\n4 0 1 2 3\n4 1 2 0 3", "2\n10\n10"))
                  .find(":12: tetrahedron 1 repeats tetrahedron 0") == 0);
        CHECK(fault("a.vtk", with_cells("4 double\n0 0 0\n1 0 0\n0 1 0\n1 1 0", "1 5\n4 0 1 2 3", "1\n10"))
                  .find(":11: tetrahedron 0 is flat") == 0);
        CHECK(fault("a.vtk", with_cells("4 double\n0 0 0\n1 0 nan\n0 1 0\n0 0 1", "1 5\n4 0 1 2 3", "1\n10"))
                  .find(":7: node 1 is not at a number") == 0);
        CHECK(fault("a.vtk", with_cells("4 double\n0 0 0\n1 0 1e999\n0 1 0\n0 0 1", "1 5\n4 0 1 2 3", "1\n10"))
                  .find(":7: node 1 is not at a number") == 0);
        // Three tetrahedra on one face.
        CHECK(fault("a.vtk", with_cells("6 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n0 0 -1",
                                        "3 15\n4 0 1 2 3\n4 0 1 2 4\n4 0 2 1 5", "3\n10\n10\n10"))
                  .find("overlaps others") != std::string::npos);
    }

    TEST_CASE("an inverted element of a Gmsh file is named with its line") {
        const std::string text = text_of(data + "two_boxes_2.2.msh");
        const std::size_t at = text.find(" 4 2 11 1 ");
        const std::size_t end = text.find('\n', at);
        std::string line = text.substr(at + 10, end - at - 10);
        std::size_t gap = line.find(' ');
        const std::string first = line.substr(0, gap);
        const std::string second = line.substr(gap + 1, line.find(' ', gap + 1) - gap - 1);
        const std::string rest = line.substr(line.find(' ', gap + 1));
        const std::string flipped = text.substr(0, at + 10) + second + " " + first + rest + text.substr(end);
        CHECK(fault("a.msh", flipped).find("tetrahedron " + number_before(text, at) + " is inverted") !=
              std::string::npos);
    }

    TEST_CASE("solid cells that are not tetrahedra, and foreign files are refused") {
        const std::string eight = "8 float\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1";
        CHECK(fault("a.vtk", with_cells(eight, "1 9\n8 0 1 2 3 4 5 6 7", "1\n12")).find("cell 0 is of type 12") !=
              std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 3", "1\n1")).find("cell 0 of type 1 has 4 nodes") !=
              std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 3", "2\n10\n10")).find("1 cells and 2 cell types") !=
              std::string::npos);
        CHECK(fault("a.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
                  .find("has no tetrahedra") != std::string::npos);
        CHECK(fault("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n").find("unstructured") !=
              std::string::npos);
        CHECK(fault("a.vtk", "solid cube").find("is not a legacy VTK file") != std::string::npos);
        CHECK(fault("a.vtk", "").find("is not a legacy VTK file") != std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "0 0", "0")).find("has no tetrahedra") != std::string::npos);
        CHECK(fault("a.msh", "$MeshFormat\n4.1 1 8\n\x01").find(", byte 20: the file ends early") == 0);
        CHECK(fault("a.msh", "$MeshFormat\n3.0 0 8\n").find(":2: is Gmsh version 3.0 (1, 2, 4.0 or 4.1)") == 0);
        CHECK(fault("a.msh", "PK\x03\x04").find("is not a Gmsh file") != std::string::npos);
        CHECK(fault("a.stl", "solid").find("is no known kind of mesh file") != std::string::npos);
        CHECK(read_tet_mesh("no/such.vtk").error().text() == "no/such.vtk: does not exist");
        CHECK(read_tet_mesh("tests/.vtk").error().text() == "tests/.vtk: does not exist");
    }

    TEST_CASE("Gmsh files of every version, as text and as bytes of either order, give the same mesh") {
        for (const auto& [file_name, content] : gmsh_files()) {
            const std::string name = file_name;
            CAPTURE(name);
            const TemporaryFolder folder;
            write(folder.file("a.msh"), content);
            const Result<MeshFile> file = read_tet_mesh(folder.file("a.msh"));
            REQUIRE_MESSAGE(file.ok(), file.error().text());
            CHECK(file.value().mesh.nodes.size() == 5);
            CHECK(file.value().nodes_of_no_cell == 1);
            CHECK(mesh_volume(file.value().mesh) == doctest::Approx(1.0));
            CHECK(file.value().region_tags == std::vector<int>{7, 9});
            CHECK(file.value().mesh.region == std::vector<int>{1, 0});
        }
    }

    TEST_CASE("VTK bytes are read, and attributes of no use skipped, as text and as bytes") {
        for (const bool binary : {false, true}) {
            CAPTURE(binary);
            const TemporaryFolder folder;
            write(folder.file("a.vtk"), vtk_with_attributes(binary));
            const Result<MeshFile> file = read_tet_mesh(folder.file("a.vtk"));
            REQUIRE_MESSAGE(file.ok(), file.error().text());
            CHECK(file.value().mesh.nodes.size() == 4);
            CHECK(file.value().nodes_of_no_cell == 1);
            CHECK(mesh_volume(file.value().mesh) == doctest::Approx(0.5));
            CHECK(file.value().region_tags == std::vector<int>{-3});
        }
        // What is called region and was measured is none.
        const std::string measured = with_cells(four, "1 5\n4 0 1 2 3", "1\n10") +
                                     "CELL_DATA 1\nSCALARS region float 1\nLOOKUP_TABLE default\n0.5\n";
        CHECK(fault("a.vtk", measured) == "");
    }

    TEST_CASE("lines may end as on any machine, and a message names the file's own numbers") {
        std::string text = with_cells("5 double\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1", "1 5\n4 1 3 2 4", "1\n10");
        CHECK(fault("a.vtk", text).find(":12: tetrahedron 0 is inverted") == 0);
        std::replace(text.begin(), text.end(), '\n', '\r');
        CHECK(fault("a.vtk", text).find(":12: tetrahedron 0 is inverted") == 0);
        CHECK(fault("a.msh",
                    "$NOD\n4\n11 0 0 0\n12 1 0 0\n13 0 1 0\n14 0 0 1\n$ENDNOD\n$ELM\n2\n5 4 1 1 4 11 12 13 14\n"
                    "8 4 1 1 4 11 12 14 13\n$ENDELM\n")
                  .find(":11: tetrahedron 8 ") == 0);
        CHECK(fault("a.msh",
                    "$NOD\n4\n11 0 0 0\n12 1 0 0\n13 0 nan 0\n14 0 0 1\n$ENDNOD\n$ELM\n1\n5 4 1 1 4 11 12 13 14\n"
                    "$ENDELM\n")
                  .find(":5: node 13 is not at a number") == 0);
    }

    TEST_CASE("a count far beyond the file's size is refused before anything is allocated") {
        const std::string vtk = text_of(data + "two_boxes.vtk");
        for (const char* huge : {"999999999999", "4000000000", "99999999999999999999999", "-5"}) {
            CAPTURE(huge);
            CHECK(fault("a.vtk", replaced(vtk, "POINTS 78", std::string("POINTS ") + huge)).find(":5: ") == 0);
            CHECK(fault("a.vtk", replaced(vtk, "CELL_TYPES ", std::string("CELL_TYPES ") + huge)) != "");
            CHECK(fault("a.vtk", replaced(vtk, "CELLS ", std::string("CELLS ") + huge + " ")) != "");
        }
        const std::string msh = text_of(data + "two_boxes_4.1.msh");
        CHECK(fault("a.msh", replaced(msh, "$Nodes\n", "$Nodes\n99999999999 ")) != "");
        CHECK(fault("a.msh", replaced(msh, "$Elements\n", "$Elements\n99999999999 ")) != "");
        CHECK(fault("a.msh", replaced(msh, "$Entities\n", "$Entities\n99999999999 ")) != "");
    }

    TEST_CASE("a file cut anywhere is refused in one line") {
        for (const char* name : {"lens_3000.vtk", "two_boxes.vtk", "two_boxes_2.2.msh", "two_boxes_4.1.msh"}) {
            const std::string whole = text_of(data + name);
            const std::size_t stride = whole.size() > 20000 ? 2000 : 200;
            const std::string ending = std::string(name).substr(std::string(name).size() - 4);
            for (std::size_t length = 0; length + 2 < whole.size(); length += stride) {
                CAPTURE(name);
                CAPTURE(length);
                CHECK(fault("cut" + ending, whole.substr(0, length)) != "");
            }
        }
    }

    TEST_CASE("bytes that are cut or changed are read or refused, never worse") {
        std::vector<std::pair<std::string, std::string>> files = gmsh_files();
        files.emplace_back("a.vtk", vtk_with_attributes(true));
        std::uint64_t random = 54321;
        int refused = 0;
        for (const auto& [name, whole] : files) {
            const std::string file = name == "a.vtk" ? name : "a.msh";
            for (std::size_t length = 0; length < whole.size(); length += 7) {
                refused += fault(file, whole.substr(0, length)).empty() ? 0 : 1;
            }
            for (int trial = 0; trial < 300; ++trial) {
                std::string broken = whole;
                random = random * 6364136223846793005U + 1442695040888963407U;
                broken[(random >> 33) % broken.size()] = static_cast<char>(random >> 20);
                refused += fault(file, broken).empty() ? 0 : 1;
            }
        }
        CHECK(refused > 500);
    }

    TEST_CASE("a file with random bytes changed is read or refused, never worse") {
        for (const char* name : {"two_boxes.vtk", "two_boxes_2.2.msh", "two_boxes_4.1.msh"}) {
            const std::string whole = text_of(data + name);
            const std::string ending = std::string(name).substr(std::string(name).size() - 4);
            std::uint64_t random = 12345;
            int refused = 0;
            for (int trial = 0; trial < 300; ++trial) {
                std::string broken = whole;
                for (int change = 0; change < 3; ++change) {
                    random = random * 6364136223846793005U + 1442695040888963407U;
                    broken[(random >> 33) % broken.size()] = "0123456789 -.eE$\n\0x"[(random >> 20) % 19];
                }
                refused += fault("broken" + ending, broken).empty() ? 0 : 1;
            }
            CHECK(refused > 100);
        }
    }

    TEST_CASE("writing where there is no folder, or another kind of file, is refused") {
        const TetMesh mesh = bar(1, 1, 1, 1.0);
        CHECK(
            write_tet_mesh(mesh, "no/such/folder/a.vtk").error().text() ==
            "no/such/folder/a.vtk: cannot write: there is no folder no/such/folder (a file in a folder that is there)");
        CHECK(write_tet_mesh(mesh, "a.ply").error().text().find("a.ply: is no known kind") == 0);
        const TemporaryFolder folder;
        std::filesystem::create_directories(folder.file("b.vtk/inner"));
        CHECK(write_tet_mesh(mesh, folder.file("b.vtk")).error().text().find("b.vtk: this is a folder") !=
              std::string::npos);
        CHECK_FALSE(left_unfinished(folder));
    }

    TEST_CASE("a surface written as OBJ has its vertices and faces, numbered from 1") {
        const TemporaryFolder folder;
        const TetMesh mesh = bar(2, 2, 2, 1.0);
        REQUIRE(write_obj(surface_of(mesh), mesh.nodes, folder.file("a.obj")).ok());
        const std::string text = text_of(folder.file("a.obj"));
        CHECK(std::count(text.begin(), text.end(), 'v') == 26);  // 27 nodes, one of them inside
        CHECK(text.find("\nf 0") == std::string::npos);
        std::size_t faces = 0;
        for (std::size_t at = text.find("\nf "); at != std::string::npos; at = text.find("\nf ", at + 1)) {
            ++faces;
        }
        CHECK(faces == 48);
    }
}
