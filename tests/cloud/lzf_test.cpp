#include "cloud/lzf.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace scanchor {
namespace {

TEST(Lzf, DecodesAHandWrittenStream) {
  // Literal "abc" (control 2), then length 7 + 2 + 1 = 10 at distance 3, then length 3 at
  // distance 1.
  const std::string stream = std::string(
                                 "\x02"
                                 "abc",
                                 4) +
                             std::string("\xE0\x01\x02", 3) + std::string("\x20\x00", 2);
  EXPECT_EQ(lzf_decompress(stream, 16), "abcabcabcabcaaaa");
}

TEST(Lzf, RoundTripOfManyKindsOfBytes) {
  SequentialRandom random(3);
  for (int i = 0; i < 300; ++i) {
    std::string text;
    const std::uint32_t size = random.below(i < 20 ? 5 : 30000);
    const std::uint32_t letters = 1 + random.below(i % 3 == 0 ? 2 : 256);
    while (text.size() < size) {
      if (random.chance(0.1) && !text.empty()) {
        text +=
            text.substr(random.below(static_cast<std::uint32_t>(text.size())), random.below(400));
      }
      text += static_cast<char>(random.below(letters));
    }
    const std::string packed = lzf_compress(text);
    EXPECT_LE(packed.size(), text.size() + text.size() / 32 + 1);
    EXPECT_EQ(lzf_decompress(packed, text.size()), text);
  }
}

TEST(Lzf, RunsShrinkToTheGreatestExpansion) {
  const std::string zeros(1 << 20, '\0');
  const std::string packed = lzf_compress(zeros);
  EXPECT_LT(packed.size(), zeros.size() / 80);
  EXPECT_GE(packed.size() * lzf_greatest_expansion, zeros.size());
}

TEST(Lzf, DamageIsSeen) {
  const std::string packed = lzf_compress("aaaaaaaaaaaaaaaaaaaabcdefgh");
  EXPECT_EQ(lzf_decompress(packed, 27), "aaaaaaaaaaaaaaaaaaaabcdefgh");
  EXPECT_EQ(lzf_decompress(packed, 26), std::nullopt);
  EXPECT_EQ(lzf_decompress(packed, 28), std::nullopt);
  for (std::size_t cut = 0; cut < packed.size(); ++cut)
    EXPECT_EQ(lzf_decompress(packed.substr(0, cut), 27), std::nullopt);
  EXPECT_EQ(lzf_decompress(std::string("\x20\x00", 2), 3), std::nullopt)
      << "a reference before the first byte";
}

}  // namespace
}  // namespace scanchor
