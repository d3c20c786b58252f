// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/picture_size.hpp"

#include <doctest/doctest.h>

using namespace rhexis::station;

namespace {

/// Counts a picture; true: from now on it is another share, which is drawn with something new.
bool changes(PictureSize& size, double took_s) {
    const double before = size.share();
    size.count(took_s);
    if (size.share() == before) {
        return false;
    }
    size.begin_anew();
    return true;
}

/// Whole pictures that take so long in full size; the share that it comes to.
double settle(PictureSize& size, double full_s, int pictures) {
    for (int i = 0; i < pictures; ++i) {
        changes(size, full_s * size.share() * size.share());
    }
    return size.share();
}

}  // namespace

TEST_SUITE("picture size") {
    TEST_CASE("pictures that take longer than a fifteenth of a second are drawn smaller, as much as it takes") {
        PictureSize size;
        CHECK(settle(size, 0.06, 500) == 1.0);
        for (const double full_s : {0.08, 0.15, 0.30}) {
            PictureSize other;
            const double share = settle(other, full_s, 500);
            CHECK(share < 1.0);
            CHECK(full_s * share * share <= 1.0 / 15.0);
            CHECK(full_s * share * share > 0.5 / 15.0);
        }
        PictureSize hopeless;
        CHECK(settle(hopeless, 10.0, 500) == 0.35);
    }

    TEST_CASE("they grow again where there is time, and the smaller size that is needed is found again") {
        PictureSize size;
        CHECK(settle(size, 0.2, 300) < 0.6);
        CHECK(settle(size, 0.03, 2000) == 1.0);
        CHECK(settle(size, 0.2, 300) < 0.6);
    }

    TEST_CASE("what is built once, and the first look at something new, count for nothing") {
        PictureSize size;
        settle(size, 0.02, 100);
        for (int i = 0; i < 200; ++i) {
            size.count(i % 12 == 0 ? 2.0 : 0.02);
        }
        CHECK(size.share() == 1.0);
        size.begin_anew();
        for (int i = 0; i < 9; ++i) {
            CHECK_FALSE(changes(size, 0.5));
        }
        CHECK(size.share() == 1.0);
    }

    TEST_CASE("a size that is ever again too large is tried ever less often") {
        PictureSize size;
        int tried = 0;
        for (int i = 0; i < 20000; ++i) {
            // half as long as its pixels say: what is expected of a larger one is wrong
            const double took_s = size.share() > 0.8 ? 0.1 : 0.02;
            tried += changes(size, took_s) ? 1 : 0;
        }
        CHECK(tried < 25);  // in 800 looks
    }
}
