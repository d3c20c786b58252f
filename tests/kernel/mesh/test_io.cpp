// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
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
        CHECK(fault("a.vtk", with_cells("5 double\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n9 9 9", "1 5\n4 0 1 2 3", "1\n10"))
                  .find(":10: node 4 belongs to no element") == 0);
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
        CHECK(fault("a.msh", flipped).find("tetrahedron 0 is inverted") != std::string::npos);
    }

    TEST_CASE("solid cells that are not tetrahedra, binary and foreign files are refused") {
        const std::string eight = "8 float\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1";
        CHECK(fault("a.vtk", with_cells(eight, "1 9\n8 0 1 2 3 4 5 6 7", "1\n12")).find("a cell is of type 12") !=
              std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 3", "1\n1")).find("a cell of type 1 has 4 nodes") !=
              std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "1 5\n4 0 1 2 3", "2\n10\n10")).find("1 cells and 2 cell types") !=
              std::string::npos);
        CHECK(fault("a.vtk", "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\n")
                  .find(":3: is a binary VTK file") == 0);
        CHECK(fault("a.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n").find("unstructured") !=
              std::string::npos);
        CHECK(fault("a.vtk", "solid cube").find("is not a legacy VTK file") != std::string::npos);
        CHECK(fault("a.vtk", "").find("is not a legacy VTK file") != std::string::npos);
        CHECK(fault("a.vtk", with_cells(four, "0 0", "0")).find("has no tetrahedra") != std::string::npos);
        CHECK(fault("a.msh", "$MeshFormat\n4.1 1 8\n\x01").find(":2: is a binary Gmsh file") == 0);
        CHECK(fault("a.msh", "$MeshFormat\n3.0 0 8\n").find(":2: is Gmsh version 3.0 (2.2 or 4.1)") == 0);
        CHECK(fault("a.msh", "PK\x03\x04").find("is not a Gmsh file") != std::string::npos);
        CHECK(fault("a.stl", "solid").find("is no known kind of mesh file") != std::string::npos);
        CHECK(read_tet_mesh("no/such.vtk").error().text() == "no/such.vtk: does not exist");
        CHECK(read_tet_mesh("tests/.vtk").error().text() == "tests/.vtk: does not exist");
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
