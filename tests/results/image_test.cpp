#include "results/image.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/results/samples.hpp"

namespace scanchor {
namespace {

Image sample_image() {
  Image image{7, 5, {}};
  for (int i = 0; i < 105; ++i) image.rgb.push_back(std::uint8_t(i * 37));
  return image;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Image, IsReadBackAsItWasWritten) {
  const auto path = samples::scratch("image") / "a.png";
  write_png(path, sample_image());
  const Image back = read_png(path);
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.rgb, sample_image().rgb);
}

TEST(Image, SamePictureSameBytes) {
  const auto folder = samples::scratch("image");
  write_png(folder / "a.png", sample_image());
  write_png(folder / "b.png", sample_image());
  EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
}

TEST(Image, RefusesWhatIsNoPicture) {
  const auto folder = samples::scratch("image");
  write_file(folder / "text.png", "this is no picture");
  EXPECT_NE(message_of([&] { read_png(folder / "text.png"); }).find("text.png"), std::string::npos);
  write_png(folder / "a.png", sample_image());
  std::string bytes = read_file(folder / "a.png");
  write_file(folder / "cut.png", bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(message_of([&] { read_png(folder / "cut.png"); }).find("cut.png"), std::string::npos);
  EXPECT_NE(message_of([&] { write_png(folder / "none.png", Image{}); }), "");
  EXPECT_NE(message_of([&] { write_png(folder / "short.png", Image{4, 4, {1, 2, 3}}); }), "");
  EXPECT_FALSE(std::filesystem::exists(folder / "none.png"));
}

TEST(Image, AFolderThatCannotBeWrittenIsOneClearLine) {
  const auto folder = samples::scratch("image");
  write_file(folder / "file", "");
  const std::string line =
      message_of([&] { write_png(folder / "file" / "a.png", sample_image()); });
  EXPECT_NE(line.find("a.png"), std::string::npos);
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace scanchor
