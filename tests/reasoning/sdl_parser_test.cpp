#include "reasoning/sdl_parser.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

std::string parse_error(const std::string& text) {
  try {
    parse_ontology(text, "own.sdl");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "";
}

TEST(SdlParser, ReadsEveryKindOfClause) {
  const auto ontology = parse_ontology(R"(
axiom floor:
    lowest
    horizontal
class thing, object:
    unique
    several faces
    weight 0.5 area 900..17000 cm2   # a comment
    extension at least 130 cm
    width under 0.5 m
    height about 1 m
    elongation 1..3
    rectangularness over 0.7
    vertical within 20 deg
    rectangular
    largest
    orthogonal to and above a floor
    within 40 cm of a floor
    coplanar within 10 cm with a floor
    bottom at most 5 cm above a floor
    not supporting a floor
    usually near a floor
class pile:
    2..5 things, each pair
        parallel
        same size and vertically aligned
        within 80 cm
class kind is a thing:
    top 1..2 m above a floor
class piece part of thing:
    touching a thing
)",
                                       "own.sdl");
  ASSERT_EQ(ontology.classes.size(), 5U);
  const auto& thing = ontology.classes[1];
  EXPECT_EQ(thing.names, (std::vector<std::string>{"thing", "object"}));
  EXPECT_TRUE(thing.unique);
  EXPECT_TRUE(thing.several_faces);
  ASSERT_EQ(thing.clauses.size(), 15U);
  EXPECT_DOUBLE_EQ(thing.clauses[0].weight, 0.5);
  EXPECT_DOUBLE_EQ(thing.clauses[0].range.low, 0.09);
  EXPECT_DOUBLE_EQ(thing.clauses[0].range.high, 1.7);
  EXPECT_EQ(thing.clauses[0].comment, "a comment");
  EXPECT_DOUBLE_EQ(thing.clauses[1].range.low, 1.3);
  EXPECT_FALSE(thing.clauses[1].range.has_high());
  EXPECT_DOUBLE_EQ(thing.clauses[3].range.low, 0.8);
  EXPECT_DOUBLE_EQ(thing.clauses[6].range.high, 20.0);
  EXPECT_EQ(thing.clauses[9].relations.size(), 2U);
  EXPECT_EQ(thing.clauses[10].relations[0].relation, Relation::near);
  EXPECT_DOUBLE_EQ(thing.clauses[10].relations[0].range.high, 0.4);
  EXPECT_EQ(thing.clauses[13].kind, ClauseKind::negation);
  EXPECT_TRUE(thing.clauses[14].usually);
  const auto& pile = ontology.classes[2].clauses[0];
  EXPECT_EQ(pile.kind, ClauseKind::group);
  EXPECT_EQ(pile.count_low, 2);
  EXPECT_EQ(pile.count_high, 5);
  EXPECT_EQ(pile.target, "thing");
  ASSERT_EQ(pile.pairwise.size(), 4U);
  EXPECT_EQ(pile.pairwise[3].relation, Relation::near);
  EXPECT_DOUBLE_EQ(pile.pairwise[3].range.high, 0.8);
  EXPECT_EQ(ontology.classes[3].parent, "thing");
  EXPECT_EQ(ontology.classes[4].part_of, "thing");
}

TEST(SdlParser, ErrorsNamePlaceLineCaretAndRemedy) {
  EXPECT_EQ(parse_error("class desk:\n    aera 1..2 m2\n"),
            "own.sdl:2:5: unknown clause 'aera'; did you mean 'area'?\n"
            "      aera 1..2 m2\n"
            "      ^");
  const auto has = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(parse_error(text).find(part), std::string::npos) << parse_error(text);
  };
  has("class desk:\n    area 1..2\n", "own.sdl:2:14: a unit is missing");
  has("class desk:\n    area 1..2 m\n", "'area' cannot be measured in m");
  has("class desk:\n    area 1..2 qm\n", "unknown unit 'qm'");
  has("class desk:\n    area 2..1 m2\n", "the range is empty");
  has("class desk:\n    area 2 m2\n", "takes a range");
  has("class desk:\n    elongation 1..2 m\n", "pure number");
  has("class desk:\n    parallel to a flor\nclass floor:\n    lowest\n", "did you mean 'floor'?");
  has("class desk:\n    parallel to\n", "no target");
  has("class desk\n    lowest\n", "':' is missing");
  has("class desk:\n\nclass a:\n    lowest\n", "class 'desk' has no clause");
  has("clas desk:\n    lowest\n", "did you mean 'class'?");
  has("    lowest\n", "a clause needs a class");
  has("class a:\n    lowest\nclass a:\n    lowest\n", "described twice");
  has("class a:\n    weight 2 area 1..2 m2\n", "a weight is");
  has("class s:\n    at least 2 bs, each pair\n        paralel\nclass b:\n    lowest\n",
      "did you mean 'parallel'?");
  has("class s:\n    at least 2 bs, each pair\nclass b:\n    lowest\n", "'each pair' needs");
  has("axiom floor:\n    above a floor\n", "an axiom depends on no other class");
  has("class a:\n    lowest lowest\n", "nothing more was expected");
  has("", "describes no class");
}

TEST(SdlParser, ReadsWhatIsSaidOfATarget) {
  const auto ontology = parse_ontology(
      "class window:\n    vertical\nclass table:\n    horizontal\nclass box:\n"
      "    on and near the table that is near a window (that is rectangular) and has area over 1 "
      "m2 and not below a window\n",
      "own.sdl");
  const auto& clause = ontology.classes[2].clauses[0];
  EXPECT_EQ(clause.relations.size(), 2U);
  EXPECT_EQ(clause.target, "table");
  ASSERT_EQ(clause.target_clauses.size(), 3U);
  EXPECT_EQ(clause.target_clauses[0].target, "window");
  ASSERT_EQ(clause.target_clauses[0].target_clauses.size(), 1U);
  EXPECT_EQ(clause.target_clauses[0].target_clauses[0].kind, ClauseKind::rectangular);
  EXPECT_EQ(clause.target_clauses[1].kind, ClauseKind::feature);
  EXPECT_EQ(clause.target_clauses[2].kind, ClauseKind::negation);
  EXPECT_EQ(clause_text(clause),
            "on and near a table that is near a window (that is rectangular) and has area over 1 "
            "m2 and is not below a window");
  // Without brackets all goes to the class named last.
  const auto greedy = parse_ontology(
      "class window:\n    vertical\nclass box:\n"
      "    near a window that is near a window that is rectangular and horizontal\n",
      "own.sdl");
  EXPECT_EQ(greedy.classes[1].clauses[0].target_clauses.size(), 1U);
  EXPECT_EQ(greedy.classes[1].clauses[0].target_clauses[0].target_clauses.size(), 2U);
}

TEST(SdlParser, ErrorsBehindThatIs) {
  const auto has = [&](const std::string& clause, const std::string& part) {
    const std::string text = "class a:\n    lowest\nclass b:\n    " + clause + "\n";
    EXPECT_NE(parse_error(text).find(part), std::string::npos) << parse_error(text);
  };
  has("on an a that is", "own.sdl:4:20: a clause was expected here");
  has("on an a that is horizontl",
      "own.sdl:4:21: unknown clause 'horizontl'; did you mean "
      "'horizontal'?");
  has("on an a that is near a c", "unknown class 'c'");
  has("on an a that is usually lowest", "'usually' cannot stand behind 'that is'");
  has("usually at least 2 a, each pair", "'usually' cannot stand before the members of a group");
  has("on an a (that is lowest", "the bracket is not closed");
  has("on an a (lowest)", "a bracket behind a class goes on with 'that is ...'");
  EXPECT_NE(parse_error("class a:\n    on a b that is near a c\nclass b:\n    lowest\nclass c:\n   "
                        " on an a\n")
                .find("a needs c needs a"),
            std::string::npos)
      << "circles go through what is said of targets";
}

TEST(SdlParser, CirclesNameTheirClasses) {
  const std::string text = "class desk:\n    below a screen\nclass screen:\n    above a desk\n";
  const auto message = parse_error(text);
  EXPECT_NE(message.find("desk needs screen needs desk"), std::string::npos) << message;
  EXPECT_NE(message.find("can never be grounded"), std::string::npos);
  EXPECT_EQ(
      parse_error(
          "class desk:\n    lowest\n    usually below a screen\nclass screen:\n    above a desk\n"),
      "");
}

TEST(SdlParser, SurvivesAnyText) {
  const std::string base =
      "import office\naxiom floor:\n    area at least 2 m2\nclass shelf, rack:\n    at least 2 "
      "floors, each pair\n        parallel\n"
      "    usually not on a floor  # x\n";
  SequentialRandom random(5);
  for (int i = 0; i < 1500; ++i) {
    std::string text = base;
    for (std::uint32_t edits = 1 + random.below(6); edits > 0; --edits) {
      const auto at = random.below(static_cast<std::uint32_t>(text.size()));
      const std::uint32_t kind = random.below(3);
      if (kind == 0) text.erase(at, 1 + random.below(9));
      if (kind == 1) text.insert(at, 1, static_cast<char>(random.below(256)));
      if (kind == 2 && at < text.size()) text[at] = "\n\t #:,.0a9"[random.below(10)];
      if (text.empty()) text = base;
    }
    try {
      parse_sdl(text, "fuzz.sdl");
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("fuzz.sdl:", 0), 0U);
    }
  }
}

}  // namespace
}  // namespace scanchor
