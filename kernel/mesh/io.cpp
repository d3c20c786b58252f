// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/io.hpp"

#include <charconv>
#include <string_view>

#include "base/output_file.hpp"
#include "base/text_file.hpp"
#include "mesh/raw_mesh.hpp"

namespace rhexis {

namespace {

constexpr std::size_t longest_file = std::size_t{1} << 29;  ///< [bytes]

bool ends_with(const std::string& path, std::string_view ending) {
    return path.size() >= ending.size() &&
           same_word(std::string_view(path).substr(path.size() - ending.size()), ending);
}

bool is_vtk(const std::string& path) { return ends_with(path, ".vtk"); }

Error unknown_ending(const std::string& path) { return {"is no known kind of mesh file", path, ".vtk or .msh"}; }

void add(std::string& text, double value) {
    std::array<char, 32> digits{};
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

void add(std::string& text, int value) { text += std::to_string(value); }

void add(std::string& text, const Vec3& x) {
    for (int axis = 0; axis < 3; ++axis) {
        add(text, x[axis]);
        text += axis < 2 ? ' ' : '\n';
    }
}

std::string vtk_text(const TetMesh& mesh) {
    std::string text = "# vtk DataFile Version 3.0\ntetrahedra, mm\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    text += "POINTS " + std::to_string(mesh.nodes.size()) + " double\n";
    for (const Vec3& x : mesh.nodes) {
        add(text, x);
    }
    const std::string count = std::to_string(mesh.tets.size());
    text += "CELLS " + count + " " + std::to_string(5 * mesh.tets.size()) + "\n";
    for (const std::array<int, 4>& tet : mesh.tets) {
        text += "4";
        for (int node : tet) {
            add(text.append(" "), node);
        }
        text += '\n';
    }
    text += "CELL_TYPES " + count + "\n";
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        text += "10\n";
    }
    text += "CELL_DATA " + count + "\nSCALARS region int 1\nLOOKUP_TABLE default\n";
    for (int region : mesh.region) {
        text += std::to_string(region) + "\n";
    }
    return text;
}

std::string msh_text(const TetMesh& mesh) {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(mesh.nodes.size()) + "\n";
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        text += std::to_string(n + 1) + " ";
        add(text, mesh.nodes[n]);
    }
    text += "$EndNodes\n$Elements\n" + std::to_string(mesh.tets.size()) + "\n";
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        const std::string physical = std::to_string(mesh.region[t] + 1);
        text += std::to_string(t + 1) + " 4 2 " + physical + " " + physical;
        for (int node : mesh.tets[t]) {
            add(text.append(" "), node + 1);
        }
        text += '\n';
    }
    return text + "$EndElements\n";
}

Result<RawMesh> read_raw(const std::string& path) {
    if (!is_vtk(path) && !ends_with(path, ".msh")) {
        return unknown_ending(path);
    }
    const Result<std::string> text = read_text_file(path, longest_file);
    if (!text.ok()) {
        return text.error();
    }
    const std::string_view content = without_mark(text.value());
    return is_vtk(path) ? read_vtk(content, path) : read_msh(content, path);
}

}  // namespace

Result<MeshFile> read_tet_mesh(const std::string& path) {
    Result<RawMesh> raw = read_raw(path);
    return raw.ok() ? finish_mesh(std::move(raw).value(), !is_vtk(path), path) : raw.error();
}

Result<TriMesh> read_tri_mesh(const std::string& path) {
    Result<RawMesh> raw = read_raw(path);
    return raw.ok() ? finish_sheet(std::move(raw).value(), path) : raw.error();
}

Status write_tet_mesh(const TetMesh& mesh, const std::string& path) {
    if (ends_with(path, ".vtk")) {
        return write_file(path, vtk_text(mesh));
    }
    if (ends_with(path, ".msh")) {
        return write_file(path, msh_text(mesh));
    }
    return unknown_ending(path);
}

Status write_obj(const Surface& surface, const std::vector<Vec3>& positions, const std::string& path) {
    std::string text = "# surface, mm\n";
    std::vector<int> number(positions.size(), 0);
    int next = 1;
    for (int vertex : surface.vertices) {
        number[static_cast<std::size_t>(vertex)] = next++;
        text += "v ";
        add(text, positions[static_cast<std::size_t>(vertex)]);
    }
    for (const std::array<int, 3>& triangle : surface.triangles) {
        text += 'f';
        for (int vertex : triangle) {
            add(text.append(" "), number[static_cast<std::size_t>(vertex)]);
        }
        text += '\n';
    }
    return write_file(path, text);
}

}  // namespace rhexis
