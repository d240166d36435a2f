// A user's own class, from five lines beside the shipped ones to a label with its reason.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/file.hpp"
#include "tests/apps/support/command.hpp"

namespace scanchor {
namespace {

using testing_support::run_scanchor;
using testing_support::scratch;

using Json = nlohmann::json;

/// Objects of a labelled folder by their ids.
std::map<int, Json> objects(const std::string& folder) {
  const Json labels = Json::parse(read_file(scratch() + folder + "/labels.json"));
  std::map<int, Json> found;
  for (const auto& object : labels.at("objects")) found[object.at("id")] = object;
  return found;
}

/// Labels a bedroom, which no room is that the office classes were counted on.
std::map<int, Json> labelled(const std::string& ontology, const std::string& folder) {
  static const int made =
      run_scanchor(
          "run --scenes 1 --seed 311 --set room.family=bedroom --no-pictures --out bedroom -q")
          .code;
  EXPECT_EQ(made, 0);
  const auto label = run_scanchor("label bedroom/00/scan.pcd --no-pictures -q --ontology " +
                                  ontology + " --out " + folder);
  EXPECT_EQ(label.code, 0) << label.error;
  return objects(folder);
}

TEST(OwnClass, IsFoundWithItsReasonAndChangesNothingElse) {
  write_file(scratch() + "own_bed.sdl",
             "import office\n\nclass bed:\n    extension 1.7..2.3 m\n    width 0.7..2.1 m\n"
             "    horizontal\n    elevation 0.3..0.7 m above a floor\n");
  EXPECT_EQ(run_scanchor("ontology lint own_bed.sdl").code, 0);
  const auto before = labelled("office", "bedroom_office");
  const auto after = labelled("own_bed.sdl", "bedroom_own");
  ASSERT_EQ(before.size(), after.size());
  int bed = -1;
  for (const auto& [id, object] : after) {
    if (object.at("class") == "bed") {
      EXPECT_EQ(bed, -1) << "there is one";
      bed = id;
    } else {
      EXPECT_EQ(object.at("class"), before.at(id).at("class")) << id;
    }
  }
  ASSERT_GE(bed, 0);
  EXPECT_GE(after.at(bed).at("probability"), 0.5);
  const auto why = run_scanchor("explain bedroom_own " + std::to_string(bed));
  EXPECT_EQ(why.code, 0) << why.error;
  EXPECT_EQ(why.out.rfind(std::to_string(bed) + " is a bed (", 0), 0U) << why.out;
  EXPECT_NE(why.out.find("elevation 0.3..0.7 m above a floor: "), std::string::npos) << why.out;
  EXPECT_NE(why.out.find("is a floor"), std::string::npos) << "down to the axiom\n" << why.out;
  EXPECT_EQ(run_scanchor("find 'the bed' bedroom_own").code, 0);
  const auto elsewhere = run_scanchor("find 'the bed' bedroom_own --ontology own_bed.sdl");
  EXPECT_EQ(elsewhere.code, 0);
  std::filesystem::create_directories(scratch() + "elsewhere");
  const auto lost = run_scanchor("--version >/dev/null; cd elsewhere; '" SCANCHOR_COMMAND
                                 "' find 'the bed' ../bedroom_own");
  EXPECT_EQ(lost.code, 3);
  EXPECT_NE(lost.error.find("name its file: --ontology own_bed.sdl"), std::string::npos)
      << lost.error;
}

TEST(OwnClass, ThatFitsMuchIsBelievedOfLittle) {
  write_file(scratch() + "own_thing.sdl", "import office\n\nclass platform:\n    horizontal\n");
  const auto before = labelled("office", "bedroom_office");
  int changed = 0;
  for (const auto& [id, object] : labelled("own_thing.sdl", "bedroom_thing")) {
    EXPECT_NE(object.at("class"), "platform") << id;
    changed += object.at("class") != before.at(id).at("class") ? 1 : 0;
  }
  EXPECT_LE(changed, 2)
      << "a hundredth goes to it from all that is level: what stood at 0.50 falls";
}

}  // namespace
}  // namespace scanchor
