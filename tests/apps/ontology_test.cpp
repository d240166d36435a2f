// Class files formatted, checked, shown and converted by the command.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::lines_of;
using testing_support::run_scanchor;
using testing_support::scratch;

TEST(OntologyVerb, FormatPrintsChecksAndRewrites) {
  write_file(scratch() + "own.sdl", "class  desk:\n  area 1..2 m2  # as sold\n");
  const std::string standard = "class desk:\n    area 1..2 m2  # as sold\n";
  EXPECT_EQ(run_scanchor("ontology format own.sdl").out, standard);
  const auto check = run_scanchor("ontology format --check own.sdl");
  EXPECT_EQ(check.code, 1);
  EXPECT_NE(check.out.find("own.sdl: not in standard form"), std::string::npos) << check.out;
  EXPECT_NE(read_file(scratch() + "own.sdl"), standard) << "--check changes nothing";
  EXPECT_EQ(run_scanchor("ontology format --in-place own.sdl").code, 0);
  EXPECT_EQ(read_file(scratch() + "own.sdl"), standard);
  EXPECT_EQ(run_scanchor("ontology format --check own.sdl office").code, 0);
  EXPECT_EQ(run_scanchor("ontology format --check --in-place own.sdl").code, 2);
}

TEST(OntologyVerb, LintNamesPlaceRuleAndReason) {
  write_file(scratch() + "odd.sdl",
             "class desk:\n    extension at most 1 m\n    extension at least 2 m\n");
  const auto odd = run_scanchor("ontology lint odd.sdl");
  EXPECT_EQ(odd.code, 1);
  EXPECT_NE(odd.out.find("odd.sdl:3:5: contradiction: class 'desk' can never hold"),
            std::string::npos)
      << odd.out;
  EXPECT_NE(odd.out.find("Widen one of them."), std::string::npos) << "and what to do";
  const auto json = nlohmann::json::parse(run_scanchor("ontology lint odd.sdl --json").out);
  ASSERT_EQ(json.size(), 1U);
  EXPECT_EQ(json[0].at("rule"), "contradiction");
  EXPECT_EQ(json[0].at("line"), 3);
  const auto fine = run_scanchor("ontology lint paper office home storage");
  EXPECT_EQ(fine.code, 0) << fine.out;
  EXPECT_EQ(lines_of(fine.out), 4);
}

TEST(OntologyVerb, ShowListsAndPrintsOne) {
  write_file(scratch() + "two.sdl",
             "class desk:\n    horizontal\nclass leg part of desk:\n    vertical\n    touching a "
             "desk\n");
  const auto all = run_scanchor("ontology show two.sdl");
  EXPECT_EQ(all.code, 0);
  EXPECT_EQ(all.out,
            "desk                1 clause\n"
            "leg                 2 clauses, part of desk\n");
  const auto one = run_scanchor("ontology show office --class screen");
  EXPECT_NE(one.out.find("class monitor, screen:\n"), std::string::npos) << one.out;
  EXPECT_NE(one.out.find("# asked for by: desk"), std::string::npos) << one.out;
  EXPECT_EQ(nlohmann::json::parse(run_scanchor("ontology show office --class screen --json").out)
                .at("name"),
            "monitor");
  EXPECT_EQ(run_scanchor("ontology show office --class dsek").code, 2);
}

TEST(OntologyVerb, ConvertGoesToTurtleAndBack) {
  const auto there = run_scanchor("ontology convert paper --out paper.ttl");
  ASSERT_EQ(there.code, 0) << there.error;
  EXPECT_EQ(read_file(scratch() + "paper.ttl").rfind("@prefix", 0), 0U);
#if __has_include(<serd/serd.h>)
  ASSERT_EQ(run_scanchor("ontology convert paper.ttl --out back.sdl").code, 0);
  // The same classes; comments are no part of OWL.
  const auto classes = [](const std::string& file) {
    auto json = nlohmann::json::parse(run_scanchor("ontology show " + file + " --json").out);
    for (auto& one : json["classes"]) {
      one.erase("file");
      one.erase("line");
    }
    return json["classes"];
  };
  EXPECT_EQ(classes("back.sdl"), classes("paper"));
  EXPECT_EQ(run_scanchor("ontology lint paper.ttl").code, 0);
#endif
  const auto page = run_scanchor("ontology convert office --to md");
  EXPECT_EQ(page.out.rfind("# office: ", 0), 0U);
  EXPECT_NE(page.out.find("## whiteboard\n"), std::string::npos);
  EXPECT_EQ(run_scanchor("ontology convert office --to docx").code, 2);
}

TEST(OntologyVerb, ABrokenFileIsAnErrorWithItsPlace) {
  write_file(scratch() + "broken.sdl", "class desk:\n    aera 1..2 m2\n");
  for (const std::string what : {"format", "lint", "show", "convert"}) {
    const auto ran = run_scanchor("ontology " + what + " broken.sdl");
    EXPECT_EQ(ran.code, 3) << what;
    EXPECT_NE(ran.error.find("broken.sdl:2:5: unknown clause 'aera'; did you mean 'area'?"),
              std::string::npos)
        << ran.error;
    EXPECT_EQ(ran.out, "") << what;
    EXPECT_EQ(run_scanchor("ontology " + what + " ofice").code, 3) << what;
    EXPECT_EQ(run_scanchor("ontology " + what + " absent.sdl").code, 3) << what;
  }
  EXPECT_EQ(run_scanchor("ontology").code, 2);
  EXPECT_EQ(run_scanchor("ontology lint").code, 2);
}

}  // namespace
}  // namespace scanchor
