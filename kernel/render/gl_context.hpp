// SPDX-License-Identifier: GPL-3.0-or-later
// An OpenGL 3.3 context: without a window, through EGL, on a GPU where there is one, else Mesa's CPU rasteriser; or
// that of a window, which others made.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis {

class GlContext {
public:
    /// The error says which part of EGL or OpenGL is missing.
    static Result<GlContext> create();
    /// The one that is current on this thread, and stays so as long as this lives. Fails without OpenGL 3.3.
    static Result<GlContext> current();
    ~GlContext();
    GlContext(GlContext&& other) noexcept;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    GlContext& operator=(GlContext&&) = delete;

    /// Current on this thread as long as it lives; afterwards none is, so that another thread may go on with it. A
    /// window's is current anyway.
    class Use {
    public:
        explicit Use(const GlContext& context);
        ~Use();
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

    private:
        const GlContext& context_;
    };

    [[nodiscard]] const std::string& device() const { return device_; }  ///< what draws, in the driver's words

private:
    GlContext() = default;
    void* display_ = nullptr;
    void* context_ = nullptr;  ///< null: a window's
    std::string device_;
};

}  // namespace rhexis
