// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the images of reflecting spheres: runs of bright pixels are linked to regions, and each region's centre is that
// of its outline: pixels weigh as what they have of the sphere, not by how bright it is there.
#pragma once

#include <vector>

#include "tracking/spot.hpp"
#include "tracking/spots/outline.hpp"

namespace rhexis::tracking {

struct SpotSettings {
    int threshold = 60;         ///< a pixel from this on is bright, 1 to 255
    double least_area = 12.0;   ///< [pixels]; smaller regions are noise or glints
    double most_area = 4000.0;  ///< [pixels]; larger ones are no marker
    int most_spots = 256;       ///< of an image; what comes after is left out, and told
    int margin = 3;  ///< pixels around a region that its light may reach, and as many again for what lies around it
    /// Shares of a region's brightness up to which a pixel weighs nothing, and from which on it weighs 1. Wide apart, a
    /// worn patch, the lens's shading and light of a hand beside the sphere draw the centre aside; near each other,
    /// the rim has few shades to tell it by. 0 and 1 weigh by light.
    double low = 0.15;
    double high = 0.4;
    bool outlines = true;       ///< centres are then those of fitted outlines, where they can be told
    double small_radius = 6.5;  ///< [pixels]; of a smaller whole spot the centre of light is taken, if it is near
    OutlineSettings outline{};
};

/// A part of an image [pixels]: from left and top up to right and bottom, without these.
struct SpotWindow {
    int left = 0;
    int right = 0;
    int top = 0;
    int bottom = 0;
};

struct FoundSpots {
    std::vector<Spot> spots{};
    bool too_many = false;  ///< more than most_spots: a lamp in the image, or too low a threshold
};

/// Scratch is kept between images; the result does not depend on it.
class SpotFinder {
public:
    explicit SpotFinder(const SpotSettings& settings) : settings_(settings) {}

    /// Spots in the order of their first line, then from left to right.
    const FoundSpots& find(const GreyImage& image);

private:
    struct Run {
        int line = 0;
        int begin = 0;
        int end = 0;     ///< after its last pixel
        int parent = 0;  ///< run of the same region; itself: it stands for the region
    };
    struct Region {
        int left = 0;
        int right = 0;  ///< after the last
        int top = 0;
        int bottom = 0;
        int pixels = 0;
        bool crowded = false;
    };

    void scan(const GreyImage& image);
    void add_run(int line, int begin, int end, std::size_t& above, std::size_t above_end);
    int root_of(int run);
    void gather();
    void find_crowded();
    [[nodiscard]] Spot measure(const GreyImage& image, const Region& region) const;
    void take_outline(const GreyImage& image, const SpotWindow& window, double around, double bright, Spot& spot) const;
    void take_light(const GreyImage& image, const SpotWindow& window, double around, Spot& spot) const;

    SpotSettings settings_;
    std::vector<Run> runs_{};
    std::vector<int> region_of_{};
    std::vector<Region> regions_{};
    FoundSpots found_{};
};

}  // namespace rhexis::tracking
