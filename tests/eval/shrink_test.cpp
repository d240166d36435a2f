#include "eval/shrink.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

using Set = std::vector<std::size_t>;

bool holds(const Set& set, const std::set<std::size_t>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](auto i) { return std::binary_search(set.begin(), set.end(), i); });
}

TEST(Shrink, FindsExactlyWhatIsNeeded) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SequentialRandom random(seed);
    std::set<std::size_t> wanted;
    for (int i = 0; i < 3; ++i) wanted.insert(random.below(40));
    int asked = 0;
    const Set found = shrink_set(40, [&](const Set& set) {
      ++asked;
      return holds(set, wanted);
    });
    EXPECT_EQ(found, Set(wanted.begin(), wanted.end()));
    EXPECT_LT(asked, 40 * 40);
  }
}

TEST(Shrink, ResultIsOneMinimalForAnyFailure) {
  // Fails with at least four members whose sum is even: not monotone at all.
  const auto fails = [](const Set& set) {
    std::size_t sum = 0;
    for (const auto i : set) sum += i;
    return set.size() >= 4 && sum % 2 == 0;
  };
  const Set found = shrink_set(16, fails);
  ASSERT_TRUE(fails(found));
  for (std::size_t k = 0; k < found.size(); ++k) {
    Set less = found;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_FALSE(fails(less));
  }
}

TEST(Shrink, FailureOfNothingIsTheEmptySet) {
  EXPECT_TRUE(shrink_set(10, [](const Set&) { return true; }).empty());
}

FailingCase room_of(int things) {
  FailingCase start;
  for (int i = 0; i < things; ++i) {
    Instance instance;
    instance.id = i + 1;
    start.scene.instances.push_back(instance);
  }
  start.scene.sensor_poses.resize(3, Eigen::Isometry3d::Identity());
  start.pose = 2;
  start.lidar.range_sigma = 0.04;
  return start;
}

bool there(const FailingCase& c, std::int32_t id) {
  return std::any_of(c.scene.instances.begin(), c.scene.instances.end(),
                     [&](const Instance& i) { return i.id == id; });
}

TEST(Shrink, CaseKeepsThingsAndNoiseThatTheFailureNeeds) {
  const auto result = shrink_case(room_of(20), [](const FailingCase& c) {
    return there(c, 7) && there(c, 13) && c.lidar.range_sigma > 0.012;
  });
  EXPECT_EQ(result.smallest.scene.instances.size(), 2U);
  EXPECT_NEAR(result.smallest.lidar.range_sigma, 0.02, 1e-12);
  EXPECT_EQ(result.smallest.scene.sensor_poses.size(), 1U);
  EXPECT_EQ(result.smallest.pose, 0);
  EXPECT_GE(result.steps.size(), 3U);
}

TEST(Shrink, NoiseThatIsNotNeededGoes) {
  const auto result =
      shrink_case(room_of(5), [](const FailingCase& c) { return there(c, 2); }, {4});
  EXPECT_EQ(result.smallest.lidar.range_sigma, 0.0);
  EXPECT_TRUE(there(result.smallest, 4));  // was to be kept
  EXPECT_EQ(result.smallest.scene.instances.size(), 2U);
}

TEST(Shrink, WhatDoesNotFailIsAnError) {
  EXPECT_THROW(shrink_case(room_of(3), [](const FailingCase&) { return false; }), Error);
}

}  // namespace
}  // namespace scanchor
