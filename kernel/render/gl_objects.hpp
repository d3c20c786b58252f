// SPDX-License-Identifier: GPL-3.0-or-later
// OpenGL objects that free themselves. All of it needs a current context, destruction included.
#pragma once

#include <epoxy/gl.h>

#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"
#include "render/pixel_rect.hpp"

namespace rhexis {

/// Owns one name of a kind that is freed by `release`.
template <void (*release)(GLuint)>
class GlName {
public:
    GlName() = default;
    explicit GlName(GLuint name) : name_(name) {}
    GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlName& operator=(GlName&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlName() {
        if (name_ != 0) {
            release(name_);
        }
    }
    [[nodiscard]] GLuint operator*() const { return name_; }

private:
    GLuint name_ = 0;
};

inline void release_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void release_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void release_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void release_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void release_renderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void release_program(GLuint name) { glDeleteProgram(name); }
inline void release_shader(GLuint name) { glDeleteShader(name); }

struct Texture {
    GlName<release_texture> name;
    int width = 0;
    int height = 0;
};

/// format: GL_RGBA8, GL_R32F, ...; filter: GL_NEAREST, GL_LINEAR or GL_LINEAR_MIPMAP_LINEAR; wrap: GL_REPEAT, ...
Texture make_texture(int width, int height, GLenum format, GLenum filter, GLenum wrap = GL_CLAMP_TO_EDGE);

/// Somewhere to draw into: textures, with or without depth, with or without 4 samples per pixel.
struct Target {
    GlName<release_framebuffer> name;
    std::vector<Texture> colours;
    GlName<release_renderbuffer> samples;  ///< instead of a texture, where there are several samples per pixel
    GlName<release_renderbuffer> depth;
    int width = 0;
    int height = 0;

    void bind() const;  ///< and sets the viewport
};

Target make_target(std::vector<Texture> colours, bool with_depth);
Target make_multisampled_target(int width, int height, GLenum format);
/// Several textures of one size, drawn into at once.
Target make_double_target(int width, int height, GLenum format, GLenum filter);
/// One texture, drawn into.
Target make_single_target(int width, int height, GLenum format, GLenum filter, GLenum wrap = GL_CLAMP_TO_EDGE,
                          bool with_depth = false);
/// Runs the program in use once for every pixel of the bound target (fullscreen.vert).
void cover_target();
/// All samples of a pixel into one, within a part of both.
void resolve(const Target& from, const Target& to, const PixelRect& rect);

/// A vertex and a fragment shader with their parameters.
class Program {
public:
    /// Names of files in assets/shaders, joined in order, after lines that define what they read.
    static Result<Program> build(const std::vector<const char*>& vertex, const std::vector<const char*>& fragment,
                                 const std::string& defines = "");

    void use() const { glUseProgram(*name_); }
    /// Each sets the parameter of this name of the program in use; names that the shader does not use are ignored.
    void set(const char* parameter, int value) const;
    void set(const char* parameter, double value) const;
    void set(const char* parameter, const Vec2& value) const;
    void set(const char* parameter, const Vec3& value) const;
    void set(const char* parameter, const Eigen::Vector4d& value) const;
    void set(const char* parameter, const Eigen::Matrix4d& value) const;
    void set(const char* parameter, const Mat3& value) const;
    /// Binds a texture to unit `unit` under this name.
    void set(const char* parameter, const Texture& texture, int unit) const;

    /// From now on what is set of the parameters that the shader uses is written here too: equal bytes, equal picture,
    /// as long as its textures hold the same. Null: nowhere. grain: to which real numbers are rounded for that; 0: they
    /// are not.
    void log_to(std::vector<unsigned char>* log, float grain = 0.0F) {
        log_ = log;
        grain_ = grain;
    }

private:
    /// Of a parameter that is set to these bytes.
    [[nodiscard]] GLint place(const char* parameter, const void* bytes, std::size_t size) const;
    [[nodiscard]] GLint place(const char* parameter, std::span<const float> numbers) const;
    GlName<release_program> name_;
    std::vector<unsigned char>* log_ = nullptr;
    float grain_ = 0.0F;
};

/// Programs of the same files, one for each set of features: in the files the name of a feature is 1 or 0. A driver
/// without a GPU runs every branch of a shader for every pixel, taken or not.
class ProgramVariants {
public:
    /// The least and the most of them are built at once, so that what a driver refuses is told here.
    static Result<ProgramVariants> create(std::vector<const char*> vertex, std::vector<const char*> fragment,
                                          std::vector<const char*> features, std::string defines = "");
    /// Bit i: with the i-th feature. Built when it is first asked for.
    Program& with(unsigned features);

private:
    [[nodiscard]] Result<Program> build(unsigned features) const;

    std::vector<const char*> vertex_;
    std::vector<const char*> fragment_;
    std::vector<const char*> features_;
    std::string defines_;
    std::map<unsigned, Program> built_;
};

/// Vertices that are sent anew for each picture: `layout` counts the floats of each attribute.
class VertexStream {
public:
    explicit VertexStream(std::initializer_list<int> layout);
    void send(std::span<const float> vertices);
    /// Vertices that triangles share: three numbers of them per triangle.
    void send(std::span<const float> vertices, std::span<const GLuint> indices);
    void draw(GLenum mode = GL_TRIANGLES) const;
    [[nodiscard]] int count() const { return count_; }

private:
    GlName<release_vertex_array> array_;
    GlName<release_buffer> buffer_;
    GlName<release_buffer> indices_;
    bool indexed_ = false;
    int stride_ = 0;
    int count_ = 0;
};

}  // namespace rhexis
