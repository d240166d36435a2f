#include "results/gl_functions.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace scanchor {
namespace {

/// A driver without one function.
class LameContext final : public GlContext {
 public:
  void make_current() override {}
  void release() override {}
  void* function(const char* name) override {
    return std::string(name) == "glBlitFramebuffer" ? nullptr : this;
  }
};

TEST(GlFunctions, NamesTheMissingOne) {
  LameContext context;
  try {
    gl::load_functions(context);
    FAIL() << "a missing function was not noticed";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("glBlitFramebuffer"), std::string::npos);
  }
}

TEST(GlFunctions, FillsTheWholeTable) {
  if (gl_context_name() == "none") return;
  const auto context = make_gl_context();
  context->make_current();
  const gl::Functions table = gl::load_functions(*context);
  const auto* version = reinterpret_cast<const char*>(table.GetString(gl::version_name));
  ASSERT_NE(version, nullptr);
  EXPECT_GE(version[0], '3');
  context->release();
}

}  // namespace
}  // namespace scanchor
