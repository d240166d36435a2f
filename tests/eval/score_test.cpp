#include "eval/score.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "eval/truth.hpp"
#include "tests/eval/support/small_scan.hpp"

namespace scanchor {
namespace {

std::string failure_of(const Scan& scan, const PointPrediction& prediction) {
  try {
    score_scan(scan, nullptr, prediction, Protocol{});
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_data);
    return error.what();
  }
  return "no error";
}

TEST(Score, PerfectAnswerIsPerfectUnderEveryProtocol) {
  const SmallScan made = small_scan();
  for (const auto& name : builtin_protocols()) {
    const Protocol protocol = find_protocol(name);
    const auto prediction = perfect_prediction(truth_of(made.scan, &made.scene, protocol));
    const Score score = score_scan(made.scan, &made.scene, prediction, protocol);
    for (const char* metric_name : {"objects.f1", "points.accuracy", "planes.recall@0.80",
                                    "planes.precision@0.80", "planes.rand", "instances.ap50"}) {
      EXPECT_NEAR(metric(score, protocol, metric_name), 1.0, 1e-9) << name << " " << metric_name;
    }
    if (protocol.absent_class != "skip") continue;
    EXPECT_NEAR(metric(score, protocol, "panoptic.pq"), 1.0, 1e-9) << name;
  }
}

TEST(Score, NoAnswerIsAllMissedAndListed) {
  const SmallScan made = small_scan();
  const Score score = score_failed(made.scan, &made.scene, "00/3", "killed after 60 s", Protocol{});
  EXPECT_EQ(score.failed, std::vector<std::string>{"00/3: killed after 60 s"});
  EXPECT_EQ(score.objects.total().found, 0);
  EXPECT_EQ(score.objects.total().truths, 3);
  EXPECT_EQ(metric(score, Protocol{}, "scans.failed"), 1.0);
}

TEST(Score, WhatCannotBeIsAnErrorWithOneClearLine) {
  const SmallScan made = small_scan();
  PointPrediction good = perfect_prediction(truth_of(made.scan, nullptr, Protocol{}));
  PointPrediction p = good;
  p.class_id.pop_back();
  EXPECT_THAT(failure_of(made.scan, p), testing::HasSubstr("one row a point"));
  p = good;
  p.class_id[7] = 900;
  EXPECT_THAT(failure_of(made.scan, p),
              testing::AllOf(testing::HasSubstr("point 7"), testing::HasSubstr("label map")));
  p = good;
  p.confidence.assign(p.class_id.size(), 1.0F);
  p.confidence[3] = std::nanf("");
  EXPECT_THAT(failure_of(made.scan, p), testing::HasSubstr("point 3"));
}

TEST(Score, PoolingIsAssociative) {
  const SmallScan made = small_scan();
  const Protocol protocol;
  const auto perfect = perfect_prediction(truth_of(made.scan, &made.scene, protocol));
  std::vector<Score> scores;
  for (std::size_t cut : {3U, 5U, 7U}) {
    PointPrediction p = perfect;
    for (std::size_t i = 0; i < p.class_id.size(); i += cut)
      p.class_id[i] = unlabelled, p.plane[i] = -1;
    scores.push_back(score_scan(made.scan, &made.scene, p, protocol));
  }
  Score left = scores[0], right = scores[1];
  left.add(scores[1]);
  left.add(scores[2]);
  right.add(scores[2]);
  Score all = scores[0];
  all.add(right);
  EXPECT_EQ(left, all);
  EXPECT_EQ(left.scans, 3);
}

TEST(Score, OtherProtocolsAndDataDoNotAddUp) {
  const SmallScan made = small_scan();
  const auto prediction = perfect_prediction(truth_of(made.scan, &made.scene, Protocol{}));
  Score a = score_scan(made.scan, &made.scene, prediction, Protocol{});
  const Score b = score_scan(made.scan, &made.scene, prediction, find_protocol("coco"));
  EXPECT_THROW(a.add(b), Error);
  Score c = a;
  c.data = "another suite";
  EXPECT_THROW(a.add(c), Error);
}

TEST(Score, UnknownMetricSaysWhatWasMeant) {
  const SmallScan made = small_scan();
  const Score score = score_failed(made.scan, &made.scene, "x", "y", Protocol{});
  try {
    metric(score, Protocol{}, "points.mIoU");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("points.miou"));
  }
}

}  // namespace
}  // namespace scanchor
