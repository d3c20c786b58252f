// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include <utility>

#include "render/renderer.hpp"

namespace rhexis::testing {

inline Renderer make_renderer(int width, int height) {
    Result<Renderer> renderer = Renderer::create(width, height);
    REQUIRE(renderer.ok());
    return std::move(renderer).value();
}

}  // namespace rhexis::testing
