#include "results/gl_context.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "core/error.hpp"

namespace scanchor {
namespace {

TEST(GlContext, GivesFunctionsOrSaysWhatIsMissing) {
  if (gl_context_name() == "none") {
    try {
      make_gl_context();
      FAIL() << "a build without OpenGL gave a context";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("install"), std::string::npos);
    }
    return;
  }
  const auto context = make_gl_context();
  context->make_current();
  EXPECT_NE(context->function("glClear"), nullptr);
  EXPECT_NE(context->function("glBlitFramebuffer"), nullptr);
  context->release();
}

TEST(GlContext, MovesBetweenThreads) {
  if (gl_context_name() == "none") return;
  const auto context = make_gl_context();
  context->make_current();
  context->release();
  std::thread([&] {
    EXPECT_NO_THROW(context->make_current());
    context->release();
  }).join();
  EXPECT_NO_THROW(context->make_current());
  context->release();
}

TEST(GlContext, IsOneOfTheThree) {
  EXPECT_TRUE(gl_context_name() == "osmesa" || gl_context_name() == "egl" ||
              gl_context_name() == "none");
}

}  // namespace
}  // namespace scanchor
