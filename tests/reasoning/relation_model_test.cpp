#include "reasoning/relation_model.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "core/data_folder.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "reasoning/relation.hpp"

namespace scanchor {
namespace {

TEST(RelationModel, IsTheSameAfterARoundTrip) {
  RelationFile file;
  file.fitted_on = "three rooms";
  double x = 0.0;
  for (const auto& constant : relation_constants())
    file.model.*constant.value = constant.low + (x += 1e-3) * (constant.high - constant.low);
  const RelationFile again = relation_file_from_json(relation_file_to_json(file), "a.json");
  EXPECT_EQ(again.fitted_on, file.fitted_on);
  for (const auto& constant : relation_constants())
    EXPECT_EQ(again.model.*constant.value, file.model.*constant.value) << constant.name;
}

TEST(RelationModel, TheTableHasEveryConstantOnce) {
  std::set<std::string> names;
  for (const auto& constant : relation_constants()) {
    EXPECT_TRUE(names.insert(constant.name).second) << constant.name;
    const double usual = RelationModel{}.*constant.value;
    EXPECT_GE(usual, constant.low) << constant.name;
    EXPECT_LE(usual, constant.high) << constant.name;
  }
  EXPECT_EQ(names.size() * sizeof(double), sizeof(RelationModel));
}

TEST(RelationModel, FilesThatCannotBeMeantAreRefused) {
  Json json = relation_file_to_json({"a room", {}});
  Json other = json;
  other["constants"]["gross_share"] = 2.0;
  EXPECT_THROW(relation_file_from_json(other, "a.json"), Error);
  other = json;
  other["constants"].erase("askew");
  EXPECT_THROW(relation_file_from_json(other, "a.json"), Error);
  other = json;
  other["constants"]["askev"] = 2.0;
  EXPECT_THROW(relation_file_from_json(other, "a.json"), Error);
  other = json;
  other["constants"]["faces_parallel"] = 0.5;
  other["constants"]["faces_orthogonal"] = 0.5;
  EXPECT_THROW(relation_file_from_json(other, "a.json"), Error) << "shares above 1";
  other = json;
  other["format"] = "scanchor background 1";
  EXPECT_THROW(relation_file_from_json(other, "a.json"), Error);
}

TEST(RelationModel, TheShippedFileIsInUse) {
  const auto path = look_up_data_file("ontologies", "relations", ".json");
  ASSERT_TRUE(path.has_value());
  const RelationFile shipped = read_relation_file(*path);
  EXPECT_NE(shipped.fitted_on.find("relations-training"), std::string::npos);
  bool differs = false;
  for (const auto& constant : relation_constants()) {
    EXPECT_EQ(relation_model().*constant.value, shipped.model.*constant.value) << constant.name;
    differs = differs || relation_model().*constant.value != RelationModel{}.*constant.value;
  }
  EXPECT_TRUE(differs) << "nothing was fitted";
  EXPECT_EQ(Surrounding{}.model, &relation_model());
}

TEST(RelationModel, TheDocsNameEveryConstantWithItsValues) {
  std::ifstream page(SCANCHOR_SOURCE_DIR "/docs/reference/relations.md");
  std::stringstream text;
  text << page.rdbuf();
  for (const auto& constant : relation_constants()) {
    std::stringstream row;
    row << "| `" << constant.name << "` | " << constant.unit << " | " << constant.part << " | "
        << constant.meaning << " | " << RelationModel{}.*constant.value << " | "
        << relation_model().*constant.value << " |";
    EXPECT_NE(text.str().find(row.str()), std::string::npos) << row.str();
  }
}

}  // namespace
}  // namespace scanchor
