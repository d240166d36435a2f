// OSMesa: Mesa's software rasteriser without any window system.
#include <GL/osmesa.h>

#include <array>

#include "core/error.hpp"
#include "results/gl_context.hpp"

namespace scanchor {
namespace {

class OsmesaContext final : public GlContext {
 public:
  OsmesaContext() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    context_ = OSMesaCreateContextAttribs(attributes, nullptr);
    if (context_ == nullptr) {
      fail_data("", "", "OSMesa gave no OpenGL 3.3 core context",
                "install libosmesa6 with llvmpipe, or build with -DSCANCHOR_GL=egl");
    }
  }
  ~OsmesaContext() override { OSMesaDestroyContext(context_); }

  void make_current() override {
    // OSMesa insists on a window buffer; nothing is ever drawn into these 16 pixels.
    if (OSMesaMakeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE, 4, 4) == GL_FALSE) {
      fail_data("", "", "OSMesa could not make its context current");
    }
  }
  void release() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  void* function(const char* name) override {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
  }

 private:
  OSMesaContext context_ = nullptr;
  std::array<unsigned char, 64> window_{};
};

}  // namespace

std::string_view gl_context_name() { return "osmesa"; }

std::unique_ptr<GlContext> make_gl_context() { return std::make_unique<OsmesaContext>(); }

}  // namespace scanchor
