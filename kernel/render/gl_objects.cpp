// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl_objects.hpp"

#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "render/shader_text.hpp"

namespace rhexis {

namespace {

std::string joined(const std::vector<const char*>& files, const std::string& defines) {
    std::string text = "#version 330 core\n" + defines;
    for (const char* file : files) {
        text += shader_text(file);
    }
    return text;
}

Result<GlName<release_shader>> compile(GLenum kind, const std::vector<const char*>& files, const std::string& defines) {
    GlName<release_shader> shader(glCreateShader(kind));
    const std::string text = joined(files, defines);
    const char* start = text.c_str();
    glShaderSource(*shader, 1, &start, nullptr);
    glCompileShader(*shader);
    GLint good = GL_FALSE;
    glGetShaderiv(*shader, GL_COMPILE_STATUS, &good);
    if (good == GL_TRUE) {
        return shader;
    }
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(*shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return Error{"the driver does not take this shader: " + log, files.back(), "OpenGL 3.3"};
}

GLuint new_name(void (*make)(GLsizei, GLuint*)) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

}  // namespace

Texture make_texture(int width, int height, GLenum format, GLenum filter, GLenum wrap) {
    Texture texture{GlName<release_texture>(new_name(glGenTextures)), width, height};
    glBindTexture(GL_TEXTURE_2D, *texture.name);
    const bool single = format == GL_R32F || format == GL_R8;
    const bool bytes = format == GL_RGBA8 || format == GL_R8 || format == GL_RG8;
    const bool two = format == GL_RG8 || format == GL_RG32F;
    const GLenum channels = single ? GL_RED : two ? GL_RG : GL_RGBA;
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, channels,
                 bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter == GL_NEAREST ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
    return texture;
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, *name);
    glViewport(0, 0, width, height);
}

Target make_target(std::vector<Texture> colours, bool with_depth) {
    RHEXIS_ASSERT(!colours.empty());
    Target target;
    target.width = colours[0].width;
    target.height = colours[0].height;
    target.name = GlName<release_framebuffer>(new_name(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, *target.name);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        glFramebufferTexture2D(GL_FRAMEBUFFER, slot, GL_TEXTURE_2D, *colours[i].name, 0);
    }
    if (with_depth) {
        target.depth = GlName<release_renderbuffer>(new_name(glGenRenderbuffers));
        glBindRenderbuffer(GL_RENDERBUFFER, *target.depth);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, target.width, target.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *target.depth);
    }
    target.colours = std::move(colours);
    RHEXIS_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    return target;
}

Target make_single_target(int width, int height, GLenum format, GLenum filter, GLenum wrap, bool with_depth) {
    std::vector<Texture> colours;
    colours.push_back(make_texture(width, height, format, filter, wrap));
    return make_target(std::move(colours), with_depth);
}

Target make_double_target(int width, int height, GLenum format, GLenum filter) {
    std::vector<Texture> colours;
    colours.push_back(make_texture(width, height, format, filter));
    colours.push_back(make_texture(width, height, format, filter));
    Target target = make_target(std::move(colours), false);
    const std::array<GLenum, 2> both = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, both.data());
    return target;
}

void cover_target() {
    const GlName<release_vertex_array> no_vertices(new_name(glGenVertexArrays));
    glBindVertexArray(*no_vertices);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Target make_multisampled_target(int width, int height, GLenum format) {
    GLint most = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &most);
    const GLsizei count = most < 4 ? most : 4;
    Target target;
    target.width = width;
    target.height = height;
    target.name = GlName<release_framebuffer>(new_name(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, *target.name);
    target.samples = GlName<release_renderbuffer>(new_name(glGenRenderbuffers));
    glBindRenderbuffer(GL_RENDERBUFFER, *target.samples);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, *target.samples);
    target.depth = GlName<release_renderbuffer>(new_name(glGenRenderbuffers));
    glBindRenderbuffer(GL_RENDERBUFFER, *target.depth);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, *target.depth);
    RHEXIS_ASSERT(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    return target;
}

void resolve(const Target& from, const Target& to, const PixelRect& rect) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, *from.name);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, *to.name);
    const int right = rect.x + rect.width;
    const int top = rect.y + rect.height;
    glBlitFramebuffer(rect.x, rect.y, right, top, rect.x, rect.y, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Result<Program> Program::build(const std::vector<const char*>& vertex, const std::vector<const char*>& fragment,
                               const std::string& defines) {
    const Result<GlName<release_shader>> first = compile(GL_VERTEX_SHADER, vertex, defines);
    if (!first.ok()) {
        return first.error();
    }
    const Result<GlName<release_shader>> second = compile(GL_FRAGMENT_SHADER, fragment, defines);
    if (!second.ok()) {
        return second.error();
    }
    Program program;
    program.name_ = GlName<release_program>(glCreateProgram());
    glAttachShader(*program.name_, *first.value());
    glAttachShader(*program.name_, *second.value());
    glLinkProgram(*program.name_);
    GLint good = GL_FALSE;
    glGetProgramiv(*program.name_, GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        std::string log(1024, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(*program.name_, static_cast<GLsizei>(log.size()), &length, log.data());
        return Error{"shaders do not link: " + log.substr(0, static_cast<std::size_t>(length)), fragment.back(),
                     "OpenGL 3.3"};
    }
    return program;
}

Result<ProgramVariants> ProgramVariants::create(std::vector<const char*> vertex, std::vector<const char*> fragment,
                                                std::vector<const char*> features, std::string defines) {
    ProgramVariants variants;
    variants.vertex_ = std::move(vertex);
    variants.fragment_ = std::move(fragment);
    variants.features_ = std::move(features);
    variants.defines_ = std::move(defines);
    for (const unsigned some : {0U, (1U << variants.features_.size()) - 1U}) {
        Result<Program> program = variants.build(some);
        if (!program.ok()) {
            return program.error();
        }
        variants.built_.emplace(some, std::move(program).value());
    }
    return variants;
}

Result<Program> ProgramVariants::build(unsigned features) const {
    std::string defines = defines_;
    for (std::size_t i = 0; i < features_.size(); ++i) {
        defines += std::string("#define ") + features_[i] + ((features >> i & 1U) != 0 ? " 1\n" : " 0\n");
    }
    return Program::build(vertex_, fragment_, defines);
}

Program& ProgramVariants::with(unsigned features) {
    const auto there = built_.find(features);
    if (there != built_.end()) {
        return there->second;
    }
    Result<Program> program = build(features);
    RHEXIS_ASSERT(program.ok());  // as its neighbours were
    return built_.emplace(features, std::move(program).value()).first->second;
}

GLint Program::place(const char* parameter, const void* bytes, std::size_t size) const {
    const GLint place = glGetUniformLocation(*name_, parameter);
    if (log_ != nullptr && place >= 0) {
        const auto* own = reinterpret_cast<const unsigned char*>(&place);
        const auto* given = static_cast<const unsigned char*>(bytes);
        log_->insert(log_->end(), own, own + sizeof place);
        log_->insert(log_->end(), given, given + size);
    }
    return place;
}

GLint Program::place(const char* parameter, std::span<const float> numbers) const {
    if (log_ == nullptr || grain_ <= 0.0F) {
        return place(parameter, numbers.data(), numbers.size_bytes());
    }
    std::array<float, 16> rounded{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        rounded[i] = std::round(numbers[i] / grain_);
    }
    return place(parameter, rounded.data(), numbers.size_bytes());
}

void Program::set(const char* parameter, int value) const {
    glUniform1i(place(parameter, &value, sizeof value), value);
}

void Program::set(const char* parameter, double value) const {
    const auto narrow = static_cast<float>(value);
    glUniform1f(place(parameter, std::span(&narrow, 1)), narrow);
}

void Program::set(const char* parameter, const Vec2& value) const {
    const Eigen::Vector2f narrow = value.cast<float>();
    glUniform2fv(place(parameter, std::span(narrow.data(), static_cast<std::size_t>(narrow.size()))), 1, narrow.data());
}

void Program::set(const char* parameter, const Vec3& value) const {
    const Eigen::Vector3f narrow = value.cast<float>();
    glUniform3fv(place(parameter, std::span(narrow.data(), static_cast<std::size_t>(narrow.size()))), 1, narrow.data());
}

void Program::set(const char* parameter, const Eigen::Vector4d& value) const {
    const Eigen::Vector4f narrow = value.cast<float>();
    glUniform4fv(place(parameter, std::span(narrow.data(), static_cast<std::size_t>(narrow.size()))), 1, narrow.data());
}

void Program::set(const char* parameter, const Eigen::Matrix4d& value) const {
    const Eigen::Matrix4f narrow = value.cast<float>();
    glUniformMatrix4fv(place(parameter, std::span(narrow.data(), static_cast<std::size_t>(narrow.size()))), 1, GL_FALSE,
                       narrow.data());
}

void Program::set(const char* parameter, const Mat3& value) const {
    const Eigen::Matrix3f narrow = value.cast<float>();
    glUniformMatrix3fv(place(parameter, std::span(narrow.data(), static_cast<std::size_t>(narrow.size()))), 1, GL_FALSE,
                       narrow.data());
}

void Program::set(const char* parameter, const Texture& texture, int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, *texture.name);
    const GLuint name = *texture.name;
    glUniform1i(place(parameter, &name, sizeof name), unit);
}

VertexStream::VertexStream(std::initializer_list<int> layout)
    : array_(new_name(glGenVertexArrays)), buffer_(new_name(glGenBuffers)), indices_(new_name(glGenBuffers)) {
    for (int floats : layout) {
        stride_ += floats;
    }
    glBindVertexArray(*array_);
    glBindBuffer(GL_ARRAY_BUFFER, *buffer_);
    GLuint attribute = 0;
    std::size_t offset = 0;
    for (int floats : layout) {
        glVertexAttribPointer(attribute, floats, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride_ * sizeof(float)),
                              reinterpret_cast<const void*>(offset));
        glEnableVertexAttribArray(attribute);
        offset += static_cast<std::size_t>(floats) * sizeof(float);
        ++attribute;
    }
}

void VertexStream::send(std::span<const float> vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, *buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(), GL_STREAM_DRAW);
    count_ = static_cast<int>(vertices.size()) / stride_;
    indexed_ = false;
}

void VertexStream::send(std::span<const float> vertices, std::span<const GLuint> indices) {
    send(vertices);
    glBindVertexArray(*array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, *indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                 GL_STREAM_DRAW);
    count_ = static_cast<int>(indices.size());
    indexed_ = true;
}

void VertexStream::draw(GLenum mode) const {
    glBindVertexArray(*array_);
    if (indexed_) {
        glDrawElements(mode, count_, GL_UNSIGNED_INT, nullptr);
    } else {
        glDrawArrays(mode, 0, count_);
    }
}

}  // namespace rhexis
