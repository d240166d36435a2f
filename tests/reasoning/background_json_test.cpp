#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/file.hpp"
#include "reasoning/background.hpp"

namespace scanchor {
namespace {

TEST(BackgroundJson, RoundTripAndSidecar) {
  Background background;
  background.fitted_on = "seeds 1 to 9";
  background.unknown_prior = 0.4;
  background.temperature = 0.8;
  background.priors = {{"a", 0.25}};
  background.rates = {{"a", "lowest", 0.9, 0.02}};
  const auto json = background_to_json(background);
  EXPECT_EQ(background_to_json(background_from_json(json, "b.json")), json);

  const auto folder = std::filesystem::path(testing::TempDir()) / "scanchor_background_test";
  std::filesystem::create_directories(folder);
  write_file(folder / "own.sdl", "axiom a:\n    lowest\n");
  write_background(folder / "own.background.json", background);
  const auto ontology = read_ontology(folder / "own.sdl");
  EXPECT_EQ(ontology.fitted_on, "seeds 1 to 9");
  EXPECT_DOUBLE_EQ(ontology.classes[0].clauses[0].background, 0.02);
  std::filesystem::remove_all(folder);
}

TEST(BackgroundJson, RefusesOtherFormatsAndImpossibleRates) {
  auto json = background_to_json({});
  json["format"] = "scanchor background 2";
  EXPECT_THROW(background_from_json(json, "b.json"), Error);
  Background background;
  background.rates = {{"a", "lowest", 1.5, 0.02}};
  EXPECT_THROW(background_from_json(background_to_json(background), "b.json"), Error);
}

}  // namespace
}  // namespace scanchor
