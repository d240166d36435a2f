// A build without any off-screen OpenGL: vector pictures, plots, tables and the report still work.
#include "core/error.hpp"
#include "results/gl_context.hpp"

namespace scanchor {

std::string_view gl_context_name() { return "none"; }

std::unique_ptr<GlContext> make_gl_context() {
  fail_usage("this build cannot draw shaded pictures: it was made without OSMesa and EGL",
             "install libosmesa6-dev or libegl-dev and build again");
}

}  // namespace scanchor
