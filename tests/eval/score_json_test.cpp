#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/random.hpp"
#include "eval/score.hpp"
#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

Score full_score() {
  const SmallScan made = small_scan();
  const Protocol protocol;
  const ScanTruth truth = truth_of(made.scan, &made.scene, protocol);
  const Surfaces surfaces = true_surfaces(made.scan, truth);
  ScanAnswer answer;
  answer.points = perfect_prediction(truth);
  for (std::size_t i = 0; i < answer.points.class_id.size(); i += 3) answer.points.class_id[i] = 21;
  answer.surfaces = &surfaces;
  answer.relations = {{"on", 4, 2, true, false, 0.75}};
  Score score = score_scan(made.scan, &made.scene, answer, protocol,
                           {{"on", 4, 2, true, false, 1.0}, {"on", 3, 2, true, true, 1.0}});
  score.data = "small";
  score.failed = {"00/1: \"quoted\" cause"};
  return score;
}

TEST(ScoreJson, ReadsBackToTheSameCounts) {
  const Score score = full_score();
  const auto json = score_to_json(score, Protocol{});
  EXPECT_EQ(score_from_json(json, "scores.json"), score);
  EXPECT_EQ(score_from_json(nlohmann::ordered_json::parse(json.dump()), "scores.json"), score);
  EXPECT_EQ(json["metrics"]["objects.f1"], metric(score, Protocol{}, "objects.f1"));
}

// Squared degrees of a hundred rooms are more than 53 bits on the grid of the sums.
TEST(ScoreJson, LargeSumsReadBackToTheLastBit) {
  SequentialRandom random(11);
  for (int round = 0; round < 200; ++round) {
    Score score = full_score();
    const double size = std::pow(10.0, random.uniform(-6.0, 7.0));
    for (int i = 0; i < 4; ++i)
      score.geometry.normal_deg.squared.add(size * random.uniform(-1.0, 1.0));
    EXPECT_EQ(score_from_json(score_to_json(score, Protocol{}), "score.json"), score) << size;
  }
}

TEST(ScoreJson, BrokenFilesAreNamed) {
  const auto good = score_to_json(full_score(), Protocol{});
  auto json = good;
  json["planes"]["truths"] = -1;
  EXPECT_THROW(score_from_json(json, "s.json"), Error);
  json = good;
  json.erase("classes");
  EXPECT_THROW(score_from_json(json, "s.json"), Error);
  json = good;
  json["schema"] = 99;
  EXPECT_THROW(score_from_json(json, "s.json"), Error);
  json = good;
  json["classes"]["unicorn"] = json["classes"]["desk"];
  try {
    score_from_json(json, "s.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("s.json: classes.unicorn"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(score_from_json(nlohmann::ordered_json::parse("[1]"), "s.json"), Error);
}

}  // namespace
}  // namespace scanchor
