#include "results/figures.hpp"

#include <gtest/gtest.h>

#include "results/gl_context.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

std::string all_text(const VectorPicture& picture) {
  std::string all;
  for (const auto& item : picture.items) {
    if (const auto* text = std::get_if<VectorText>(&item)) all += text->text + "|";
  }
  return all;
}

TEST(Figures, TheAlphaShapeHasItsFourSteps) {
  const Figure figure = figure_alpha_shape();
  const std::string text = all_text(figure.vector);
  for (const char* word : {"points", "α too small", "α fits", "α → ∞"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  EXPECT_GT(figure.vector.items.size(), 400u);  // the points themselves, four times
  EXPECT_LT(samples::count(figure.image, paper_white),
            std::size_t(figure.image.width * figure.image.height));
}

TEST(Figures, TheMonitorsHaveTheirFeatures) {
  if (gl_context_name() == "none") GTEST_SKIP() << "a build without OpenGL";
  const Figure figure = figure_monitors();
  const std::string text = all_text(figure.vector);
  const std::size_t first = text.find("A 0.");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_NE(text.find("A 0.", first + 1), std::string::npos) << "two monitors";
}

}  // namespace
}  // namespace scanchor
