// SPDX-License-Identifier: MIT
#include "croquis/picture/gl.h"

#include <array>
#include <cstring>
#include <utility>

#include <EGL/eglext.h>

#include "croquis/base/error.h"

namespace croquis {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorCode::internal, "no picture can be drawn here: " + what);
}

std::string hexadecimal(unsigned value) {
  std::string digits;
  for (int shift = 12; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(value >> shift) & 15U];
  return "0x" + digits;
}

EGLDisplay open_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (extensions == nullptr || get_platform_display == nullptr ||
      std::strstr(extensions, "EGL_MESA_platform_surfaceless") == nullptr) {
    fail("EGL knows no surfaceless platform (on Debian the packages libegl1 and libgl1-mesa-dri bring one)");
  }
  const EGLDisplay display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
    fail("EGL's surfaceless platform does not start (error " + hexadecimal(static_cast<unsigned>(eglGetError())) + ")");
  }
  return display;
}

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) {
    std::array<char, 1024> log{};
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader);
    fail("a shader does not compile: " + std::string(log.data()));
  }
  return shader;
}

}  // namespace

// The display is shared by the whole process and stays open: closing it would end the contexts of others.
GlContext::GlContext() : display_(open_display()) {
  if (eglBindAPI(EGL_OPENGL_ES_API) == EGL_FALSE) fail("EGL has no OpenGL ES");
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  const bool has_config = eglChooseConfig(display_, wanted.data(), &config, 1, &count) == EGL_TRUE && count > 0;
  const std::array<EGLint, 3> version{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  context_ = eglCreateContext(display_, has_config ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version.data());
  if (context_ == EGL_NO_CONTEXT) {
    fail("no OpenGL ES 3 context (error " + hexadecimal(static_cast<unsigned>(eglGetError())) + ")");
  }
}

GlContext::~GlContext() { eglDestroyContext(display_, context_); }

GlContext::Use::Use(const GlContext& context) : context_(context) {
  if (eglMakeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_.context_) == EGL_FALSE) {
    fail("the OpenGL context cannot be used (error " + hexadecimal(static_cast<unsigned>(eglGetError())) + ")");
  }
}

GlContext::Use::~Use() { eglMakeCurrent(context_.display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

GlObject make_program(const std::string& vertex_source, const std::string& fragment_source) {
  const std::string head = "#version 300 es\nprecision highp float;\nprecision highp sampler2DShadow;\n";
  const GLuint vertex = compile(GL_VERTEX_SHADER, head + vertex_source);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, head + fragment_source);
  GlObject program(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); });
  glAttachShader(program.name(), vertex);
  glAttachShader(program.name(), fragment);
  glLinkProgram(program.name());
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint done = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &done);
  if (done != GL_TRUE) fail("a shader does not link");
  return program;
}

GlObject make_texture() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return {name, [](GLuint n) { glDeleteTextures(1, &n); }};
}

GlObject make_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return {name, [](GLuint n) { glDeleteBuffers(1, &n); }};
}

GlObject make_vertex_array() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return {name, [](GLuint n) { glDeleteVertexArrays(1, &n); }};
}

GlObject make_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return {name, [](GLuint n) { glDeleteFramebuffers(1, &n); }};
}

GlObject make_renderbuffer(GLenum format, int samples, int width, int height) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  GlObject buffer(name, [](GLuint n) { glDeleteRenderbuffers(1, &n); });
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

GlObject make_target(GLenum format, int width, int height, GLint filter) {
  GlObject texture = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void check_framebuffer(const char* doing) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    fail(std::string(doing) + ": the driver refuses the framebuffer");
  }
}

void check_gl(const char* doing) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) fail(std::string(doing) + ": OpenGL error " + hexadecimal(error));
}

}  // namespace croquis
