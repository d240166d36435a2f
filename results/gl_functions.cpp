#include "results/gl_functions.hpp"

#include <string>

#include "core/error.hpp"

namespace scanchor::gl {

Functions load_functions(GlContext& context) {
  Functions table;
#define SCANCHOR_GL_LOAD(result, name, parameters)                                   \
  table.name = reinterpret_cast<result(*) parameters>(context.function("gl" #name)); \
  if (table.name == nullptr)                                                         \
    fail_data("", "", "the OpenGL driver has no gl" #name, "OpenGL 3.3 core is needed");
  SCANCHOR_GL_FUNCTIONS(SCANCHOR_GL_LOAD)
#undef SCANCHOR_GL_LOAD
  return table;
}

}  // namespace scanchor::gl
