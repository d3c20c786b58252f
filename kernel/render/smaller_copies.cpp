// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/smaller_copies.hpp"

#include <algorithm>

namespace rhexis {

namespace {

/// The texture shows these of its levels only.
void show_levels(int least, int most) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, least);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, most);
}

/// Whole pixels of the copy that some of a rectangle falls on.
PixelRect shrunk(const PixelRect& rect, int level, int width, int height) {
    const int x = rect.x >> level;
    const int y = rect.y >> level;
    const int round_up = (1 << level) - 1;
    // an odd size loses its last row to the one before
    const int right = std::min(width, ((rect.x + rect.width + round_up) >> level) + 1);
    const int top = std::min(height, ((rect.y + rect.height + round_up) >> level) + 1);
    return {x, y, right - x, top - y};
}

}  // namespace

Result<SmallerCopies> SmallerCopies::create() {
    Result<Program> halve = Program::build({"part.vert"}, {"halve.frag"});
    return halve ? Result<SmallerCopies>(SmallerCopies(std::move(halve).value())) : halve.error();
}

/// The first time somewhere to draw them into.
void SmallerCopies::reach_for(const Texture& picture, int levels) {
    if (targets_.empty() && levels > 0) {
        constexpr int as_many_as_there_are = 1000;
        show_levels(0, as_many_as_there_are);
        glGenerateMipmap(GL_TEXTURE_2D);
    }
    while (static_cast<int>(targets_.size()) < levels) {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        targets_.emplace_back(name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *picture.name,
                               static_cast<GLint>(targets_.size()));
    }
}

void SmallerCopies::make(const Texture& picture, const TileMask& changed, int levels) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, *picture.name);
    reach_for(picture, levels);
    const PixelRect all{0, 0, picture.width, picture.height};
    const std::vector<PixelRect> rects = levels > made_ ? std::vector{all} : changed.rects();
    made_ = levels;
    for (int level = 1; level <= levels; ++level) {
        const int width = std::max(1, picture.width >> level);
        const int height = std::max(1, picture.height >> level);
        std::vector<PixelRect> small;
        for (const PixelRect& rect : rects) {
            small.push_back(shrunk(rect, level, width, height));
        }
        glBindFramebuffer(GL_FRAMEBUFFER, *targets_[static_cast<std::size_t>(level) - 1]);
        glViewport(0, 0, width, height);
        show_levels(level - 1, level - 1);
        halve_.use();
        halve_.set("source", picture, 0);
        rectangles_.send(triangles_of(small, width, height));
        rectangles_.draw();
    }
    show_levels(0, levels);
}

}  // namespace rhexis
