// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <EGL/egl.h>
#include <GLES3/gl3.h>

namespace croquis {

/// An OpenGL ES 3 context without surface, display or window.
class GlContext {
 public:
  /// Throws Error{internal} with what is missing.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes the context current while it lives, and none after.
  class Use {
   public:
    explicit Use(const GlContext& context);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    const GlContext& context_;
  };

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// An object of OpenGL that is deleted with its owner. Needs the context to be current when it is made and when it
/// goes.
class GlObject {
 public:
  using Delete = void (*)(GLuint);
  GlObject() = default;
  GlObject(GLuint name, Delete destroy) : name_(name), destroy_(destroy) {}
  ~GlObject() {
    if (name_ != 0) destroy_(name_);
  }
  GlObject(GlObject&& other) noexcept : name_(other.name_), destroy_(other.destroy_) { other.name_ = 0; }
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_ = 0;
  Delete destroy_ = nullptr;
};

[[nodiscard]] GlObject make_program(const std::string& vertex_source, const std::string& fragment_source);
[[nodiscard]] GlObject make_texture();
[[nodiscard]] GlObject make_buffer();
[[nodiscard]] GlObject make_vertex_array();
[[nodiscard]] GlObject make_framebuffer();
/// Multisampled storage of the given format.
[[nodiscard]] GlObject make_renderbuffer(GLenum format, int samples, int width, int height);
/// A texture to draw into, read without filtering unless `filter` says otherwise.
[[nodiscard]] GlObject make_target(GLenum format, int width, int height, GLint filter = GL_NEAREST);

/// Throws Error{internal} if the bound framebuffer cannot be drawn into, or if OpenGL reported an error since the last
/// call; `doing` says what was going on.
void check_framebuffer(const char* doing);
void check_gl(const char* doing);

}  // namespace croquis
