// EGL on the "surfaceless" platform of Mesa: no X server, no Wayland, no GPU needed.
#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>

#include "core/error.hpp"
#include "results/gl_context.hpp"

namespace scanchor {
namespace {

[[noreturn]] void fail_egl(const char* step) {
  char code[32];
  std::snprintf(code, sizeof code, " (EGL error 0x%04x)", unsigned(eglGetError()));
  fail_data("", "", std::string("EGL gave no OpenGL 3.3 core context: ") + step + code,
            "install libegl1 and libegl-mesa0, or build with -DSCANCHOR_GL=osmesa");
}

class EglContext final : public GlContext {
 public:
  EglContext() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY) fail_egl("no surfaceless display");
    if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) fail_egl("initialisation");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail_egl("no desktop OpenGL");
    const EGLint config_wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                    EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display_, config_wanted, &config, 1, &count) == EGL_FALSE || count == 0) {
      fail_egl("no configuration");
    }
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                             3,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, wanted);
    if (context_ == EGL_NO_CONTEXT) fail_egl("creation");
  }
  // The display is shared by the whole process and stays.
  ~EglContext() override { eglDestroyContext(display_, context_); }

  void make_current() override {
    // The bound interface is a property of the thread.
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      fail_egl("making it current");
    }
  }
  void release() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  void* function(const char* name) override {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
  }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::string_view gl_context_name() { return "egl"; }

std::unique_ptr<GlContext> make_gl_context() { return std::make_unique<EglContext>(); }

}  // namespace scanchor
