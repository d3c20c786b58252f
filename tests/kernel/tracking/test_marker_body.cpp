// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "tracking/marker_body.hpp"

namespace rhexis::tracking {
namespace {

MarkerBody phaco() { return {"phaco", {{0, 0, 0}, {20, 0, 0}, {0, 26, 5}, {-20, 4, 33}}, 3.0, {}}; }

MarkerBody chopper() { return {"chopper", {{0, 0, 0}, {45, 0, 0}, {0, 57, 0}}, 3.0, {}}; }

std::string signature_error(const std::vector<MarkerBody>& bodies) {
    const Status status = check_signatures(bodies);
    return status ? std::string("ok") : status.error().text();
}

}  // namespace

TEST_CASE("bodies whose distances all differ are accepted, and such as share a distance but no triangle") {
    CHECK(signature_error({phaco(), chopper()}) == "ok");
    MarkerBody shares = chopper();
    shares.markers[1] = {20, 0, 0};
    CHECK(signature_error({phaco(), shares}) == "ok");
}

TEST_CASE("two distances of a body that are nearly alike are named") {
    MarkerBody within = phaco();
    within.markers[1] = {26.2, 0, 0};
    CHECK(signature_error({within}).find(
              "body \"phaco\": distances of markers 1-2 (26.2 mm) and 1-3 (26.48 mm) differ by 0.28 mm") !=
          std::string::npos);
}

TEST_CASE("three markers that could be three of another body are named, in whatever order they are") {
    MarkerBody like = chopper();
    like.markers = {{20.5, 0, 0}, {0, 26, 4.5}, {0, 0, 0}};
    CHECK(signature_error({phaco(), like})
              .find("\"phaco\" 3-2-1 (20, 26.48 and 33.18 mm) and \"chopper\" 2-1-3 (20.5, 26.39 and 33.41 mm) fit "
                    "within 0.5 mm") != std::string::npos);
    CHECK(check_signatures(std::vector<MarkerBody>{phaco(), like}, 0.2).ok());
}

TEST_CASE("all that is wrong is told, not only the first") {
    const std::vector<MarkerBody> twins{phaco(), phaco()};
    const Status status = check_signatures(twins);
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().lines().size() == 4);
}

TEST_CASE("a body of four in a plane is refused, its own mirror image as it is") {
    MarkerBody flat = phaco();
    flat.markers = {{0, 0, 0}, {20, 0, 0}, {0, 26, 0}, {-14, -31, 0.5}};
    CHECK(signature_error({flat}).find("its 4 markers lie within") != std::string::npos);
}

TEST_CASE("a body of three with two sides alike is refused, for turned over it is the same") {
    MarkerBody alike = chopper();
    alike.markers[2] = {0, 45, 0};
    CHECK(signature_error({alike}).find("markers 1-2 (45 mm) and 1-3 (45 mm) differ by 0 mm") != std::string::npos);
}

TEST_CASE("bodies with too few or too many markers, or markers nowhere, are refused") {
    MarkerBody few = phaco();
    few.markers.resize(2);
    CHECK(signature_error({few}).find("body \"phaco\": 2 markers (3 to 8)") != std::string::npos);
    MarkerBody nowhere = phaco();
    nowhere.markers[2].x() = std::nan("");
    CHECK(signature_error({nowhere}).find("marker 3 is not at a finite place") != std::string::npos);
}

}  // namespace rhexis::tracking
