// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl_context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace rhexis {

namespace {

const char* const what_is_needed = "EGL with OpenGL 3.3 and no window; Debian packages libegl1 and libgl1-mesa-dri";

Error missing(const std::string& what) { return Error{"cannot draw: " + what, "EGL", what_is_needed}; }

/// Whether a list of words parted by blanks holds this one.
bool lists(const char* extensions, std::string_view name) {
    std::string_view rest = extensions == nullptr ? std::string_view() : std::string_view(extensions);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == name) {
            return true;
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

/// Functions of an extension must not be touched unless the client lists it: the loader ends the process.
bool client_has(std::string_view name) { return lists(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name); }

/// A GPU's display, if there is a GPU. Devices that only emulate one are left to the surfaceless platform.
EGLDisplay gpu_display() {
    if (!client_has("EGL_EXT_platform_base") || !client_has("EGL_EXT_platform_device") ||
        !client_has("EGL_EXT_device_enumeration") || !client_has("EGL_EXT_device_query")) {
        return EGL_NO_DISPLAY;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) {
        return EGL_NO_DISPLAY;
    }
    for (EGLint i = 0; i < count; ++i) {
        if (lists(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) {
            continue;
        }
        const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE) {
            return display;
        }
    }
    return EGL_NO_DISPLAY;
}

EGLDisplay surfaceless_display() {
    if (!client_has("EGL_EXT_platform_base") || !client_has("EGL_MESA_platform_surfaceless")) {
        return EGL_NO_DISPLAY;
    }
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) == EGL_TRUE ? display : EGL_NO_DISPLAY;
}

EGLContext context_on(EGLDisplay display) {
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!lists(extensions, "EGL_KHR_surfaceless_context") || !lists(extensions, "EGL_KHR_create_context") ||
        !lists(extensions, "EGL_KHR_no_config_context") || eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        return EGL_NO_CONTEXT;
    }
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION_KHR,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION_KHR,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                           EGL_NONE};
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
}

std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(text));
}

}  // namespace

Result<GlContext> GlContext::create() {
    if (!epoxy_has_egl()) {
        return missing("no EGL library");
    }
    if (eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS) == nullptr) {
        return missing("no EGL driver on this machine");
    }
    // A display is the process's, shared by all renderers: it is never terminated.
    for (EGLDisplay (*open)() : {gpu_display, surfaceless_display}) {
        const EGLDisplay display = open();
        const EGLContext made = display == EGL_NO_DISPLAY ? EGL_NO_CONTEXT : context_on(display);
        if (made == EGL_NO_CONTEXT) {
            continue;
        }
        GlContext context;
        context.display_ = display;
        context.context_ = made;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, made) == EGL_TRUE && epoxy_gl_version() >= 33) {
            context.device_ = text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            return context;
        }
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    return missing("no EGL device gives an OpenGL 3.3 context");
}

Result<GlContext> GlContext::current() {
    if (epoxy_gl_version() < 33) {
        return missing("the window's OpenGL is older than 3.3");
    }
    GlContext context;
    context.device_ = text_of(GL_RENDERER) + ", OpenGL " + text_of(GL_VERSION);
    return context;
}

GlContext::GlContext(GlContext&& other) noexcept
    : display_(other.display_), context_(std::exchange(other.context_, nullptr)), device_(std::move(other.device_)) {}

GlContext::~GlContext() {
    if (context_ != nullptr) {
        eglDestroyContext(display_, context_);
    }
}

GlContext::Use::Use(const GlContext& context) : context_(context) {
    if (context.context_ != nullptr) {
        eglBindAPI(EGL_OPENGL_API);
        eglMakeCurrent(context.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_);
    }
}

GlContext::Use::~Use() {
    if (context_.context_ != nullptr) {
        eglMakeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
}

}  // namespace rhexis
