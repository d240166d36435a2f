// The help is what a new user reads first.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;

class Help : public testing::TestWithParam<const char*> {};

TEST_P(Help, HasAnExampleAndTheCommonFlags) {
  const std::string verb = GetParam();
  const auto ran = run_scanchor(verb + " --help");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.error, "");
  EXPECT_NE(ran.out.find("Example"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("scanchor " + verb), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("--json"), std::string::npos) << ran.out;
}

INSTANTIATE_TEST_SUITE_P(Verbs, Help,
                         testing::Values("run", "generate", "label", "segment", "score", "render",
                                         "explain", "find", "fit", "fit-relations", "report",
                                         "figures", "gallery", "check", "baseline", "sweep",
                                         "blame", "shrink"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Help, EachVerbOfOntologies) {
  for (const std::string verb : {"format", "lint", "show", "convert"}) {
    const auto ran = run_scanchor("ontology " + verb + " --help");
    EXPECT_EQ(ran.code, 0);
    EXPECT_NE(ran.out.find("scanchor ontology " + verb), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find("--json"), std::string::npos) << ran.out;
  }
}

TEST(Help, VersionAndNoVerb) {
  EXPECT_EQ(run_scanchor("--version").out.rfind("scanchor ", 0), 0U);
  EXPECT_EQ(run_scanchor("").code, 2);
}

TEST(Help, ErrorsNameTheHelpOfTheirVerb) {
  EXPECT_NE(run_scanchor("find").error.find("see scanchor find --help"), std::string::npos);
  EXPECT_NE(run_scanchor("ontology show").error.find("see scanchor ontology show --help"),
            std::string::npos);
}

}  // namespace
}  // namespace scanchor
