#include "reasoning/sdl_format.hpp"

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor {
namespace {

TEST(SdlFormat, StandardForm) {
  const std::string text = R"(# about the file

axiom   floor :
  horizontal   # level
  lowest
class shelf,rack part of a floor:   # head
   # in front
   at least 2 floors,each pair   # g
          parallel # p
          same size and  within  190cm
   extension under 200cm
# the end)";
  const std::string formatted = R"(# about the file

axiom floor:
    horizontal  # level
    lowest

class shelf, rack part of floor:  # head
    # in front
    at least 2 floors, each pair  # g
        parallel  # p
        same size
        within 190 cm
    extension under 200 cm

# the end
)";
  EXPECT_EQ(format_sdl(text, "x.sdl"), formatted);
}

TEST(SdlFormat, CountsOfGroups) {
  for (const std::string count : {"at least 2", "exactly 3", "2..4"}) {
    const std::string text = "axiom floor:\n    lowest\n\nclass pile:\n    " + count +
                             " floors, each pair\n        near\n";
    EXPECT_EQ(format_sdl(text, "x.sdl"), text);
  }
}

TEST(SdlFormat, WhatIsSaidOfTargets) {
  const std::string text =
      "class a:\n  on the b that has extension over 1m and is near an c ( that is lowest ) and "
      "horizontal\nclass b:\n  lowest\nclass c:\n  lowest\n";
  const std::string line =
      "    on a b that has extension over 1 m and is near a c (that is lowest) and horizontal\n";
  const std::string once = format_sdl(text, "x.sdl");
  EXPECT_NE(once.find(line), std::string::npos) << once;
  EXPECT_EQ(format_sdl(once, "x.sdl"), once);
}

TEST(SdlFormat, IdempotentAndFaithfulOnWhatIsShipped) {
  for (const std::string name : {"paper", "office", "home", "storage"}) {
    const std::string path = std::string(SCANCHOR_SOURCE_DIR) + "/ontologies/" + name + ".sdl";
    const std::string once = format_sdl(read_file(path), path);
    EXPECT_EQ(format_sdl(once, path), once);
    EXPECT_EQ(read_file(path), once) << path << " is not in its standard form";
    const auto a = parse_ontology(read_file(path), path);
    const auto b = parse_ontology(once, path);
    ASSERT_EQ(a.classes.size(), b.classes.size());
    for (std::size_t c = 0; c < a.classes.size(); ++c) {
      ASSERT_EQ(a.classes[c].clauses.size(), b.classes[c].clauses.size());
      for (std::size_t i = 0; i < a.classes[c].clauses.size(); ++i) {
        EXPECT_EQ(clause_text(a.classes[c].clauses[i]), clause_text(b.classes[c].clauses[i]));
      }
    }
  }
}

}  // namespace
}  // namespace scanchor
