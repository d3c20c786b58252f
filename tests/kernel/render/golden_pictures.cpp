// SPDX-License-Identifier: GPL-3.0-or-later
// golden_pictures FILE: writes what tests/data/pictures/golden.json holds, of the pictures as they are drawn now.
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/output_file.hpp"
#include "base/text_file.hpp"
#include "scenes/golden_frames.hpp"

using namespace rhexis;
using namespace rhexis::testing;

int main(int count, char** words) {
    Result<Renderer> renderer = Renderer::create(golden_width, golden_height);
    if (count != 2 || !renderer.ok()) {
        std::fprintf(stderr, "%s\n", count != 2 ? "golden_pictures FILE" : renderer.error().text().c_str());
        return 2;
    }
    nlohmann::json golden = nlohmann::json::object();
    for (const GoldenFrame& one : golden_frames()) {
        nlohmann::json tiles = nlohmann::json::array();
        for (const std::array<double, 3>& tile : tiles_of(golden_picture(renderer.value(), one))) {
            for (const double value : tile) {
                tiles.push_back(std::lround(value));
            }
        }
        golden[one.name] = std::move(tiles);
    }
    std::string text = "{";
    for (const auto& [name, tiles] : golden.items()) {
        text += (text.size() > 1 ? ",\n" : "\n") + nlohmann::json(name).dump() + ": " + tiles.dump();
    }
    const Status written = write_file(words[1], text + "\n}\n");
    return written ? 0 : 1;
}
