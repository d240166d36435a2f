#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reasoning/places.hpp"
#include "tests/reasoning/support/labelled.hpp"

namespace scanchor {
namespace {

const Ontology& office() {
  static const Ontology ontology = test::shipped("office");
  return ontology;
}

TEST(PlaceWords, ReadsBothKinds) {
  const auto free =
      parse_place_question("Find a free place of 30 x 40 cm on a desk near a window", office());
  ASSERT_TRUE(free);
  EXPECT_EQ(free->kind, PlaceQuestion::Kind::free_place);
  EXPECT_NEAR(free->length, 0.4, 1e-12);
  EXPECT_NEAR(free->width, 0.3, 1e-12);
  EXPECT_EQ(place_question_text(*free), "a free place of 40 x 30 cm on a desk near a window");
  EXPECT_NEAR(parse_place_question("free place of 0.2x0.1 m on the desk", office())->length, 0.2,
              1e-12);
  const auto stand =
      parse_place_question("Where could a robot of 50 cm stand in front of the cabinet?", office());
  ASSERT_TRUE(stand);
  EXPECT_EQ(stand->kind, PlaceQuestion::Kind::standing_place);
  EXPECT_NEAR(stand->diameter, 0.5, 1e-12);
  EXPECT_EQ(place_question_text(*stand), "a place to stand of 50 cm in front of the cabinet");
  // What is said of a question reads the same again.
  EXPECT_EQ(place_question_text(*parse_place_question(place_question_text(*stand), office())),
            place_question_text(*stand));
}

TEST(PlaceWords, LeavesOtherQuestionsAlone) {
  for (const auto* text : {"screen on a desk", "how many chairs near a desk", "find a desk",
                           "where is the cabinet", "is there a box"})
    EXPECT_FALSE(parse_place_question(text, office())) << text;
}

std::string complaint(const std::string& text) {
  try {
    parse_place_question(text, office());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_usage);
    return error.what();
  }
  return "";
}

TEST(PlaceWords, SaysWhatIsWrongAndWhere) {
  EXPECT_NE(complaint("free place of 30 cm on a desk").find("two sides"), std::string::npos);
  EXPECT_NE(complaint("free place of 30 x 40 on a desk").find("unit"), std::string::npos);
  EXPECT_NE(complaint("free place of 0 x 40 cm on a desk").find("above 0"), std::string::npos);
  EXPECT_NE(complaint("free place").find("on a thing"), std::string::npos);
  EXPECT_NE(complaint("place to stand").find("in front of"), std::string::npos);
  EXPECT_NE(complaint("free place on a dsek").find("did you mean 'desk'"), std::string::npos);
  EXPECT_NE(complaint("free place on a dsek").find("question:1:17"), std::string::npos)
      << complaint("free place on a dsek");
}

}  // namespace
}  // namespace scanchor
