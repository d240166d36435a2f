#pragma once
// A current OpenGL 3.3 core context without a window. Which one is linked is decided by the build
// (SCANCHOR_GL): gl_context_osmesa.cpp, gl_context_egl.cpp (surfaceless, for Mesa from 25.1 on,
// which has no OSMesa any more) or gl_context_none.cpp. Both real ones give the same pixels as long
// as one draws into an own framebuffer object.

#include <memory>
#include <string_view>

namespace scanchor {

class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
  /// Makes it the calling thread's context. Throws Error(bad_data) if the driver refuses.
  virtual void make_current() = 0;
  /// Afterwards another thread may take it.
  virtual void release() = 0;
  /// Address of a GL function, or nullptr. Valid while the context lives.
  virtual void* function(const char* name) = 0;
};

/// "osmesa", "egl" or "none".
std::string_view gl_context_name();

/// Throws Error(bad_data) with what to install, if this build or this machine has none.
std::unique_ptr<GlContext> make_gl_context();

}  // namespace scanchor
