#include "results/pack.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

namespace scanchor {
namespace {

TEST(Pack, Base64OfTheStandardsExamples) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Pack, DeflateIsReadBackByZlib) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += std::to_string(i * 7 % 113) + ",";
  const std::string small = deflate(text);
  EXPECT_LT(small.size(), text.size() / 2);
  std::string back(text.size(), '\0');
  uLongf size = uLong(back.size());
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                       reinterpret_cast<const Bytef*>(small.data()), uLong(small.size())),
            Z_OK);
  EXPECT_EQ(back, text);
  EXPECT_EQ(packed(text), base64(small));
}

TEST(Pack, NothingEscapesItsElement) {
  EXPECT_EQ(script_safe("{\"a\":\"</script><!--\"}"), "{\"a\":\"\\u003c/script>\\u003c!--\"}");
}

}  // namespace
}  // namespace scanchor
