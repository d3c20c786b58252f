// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include <utility>

#include "render/renderer.hpp"

namespace rhexis::testing {

inline Renderer make_renderer(int width, int height, Light light = Light::anew) {
    Result<Renderer> renderer = Renderer::create(width, height, light);
    REQUIRE(renderer.ok());
    return std::move(renderer).value();
}

}  // namespace rhexis::testing
