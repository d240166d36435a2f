#include "sensors/suite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"

namespace scanchor {
namespace {

/// Smooth weighted round robin: after n turns each entry has had its share of n within one,
/// whatever n is.
class RoundRobin {
 public:
  explicit RoundRobin(std::vector<double> weights)
      : weights_(std::move(weights)), credit_(weights_.size()) {
    for (const double weight : weights_) sum_ += weight;
  }
  std::size_t next() {
    std::size_t best = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      credit_[i] += weights_[i] / sum_;
      // The margin keeps ties ties where the sums round differently.
      if (credit_[i] > credit_[best] + 1e-9 || weights_[best] == 0.0) best = i;
    }
    credit_[best] -= 1.0;
    return best;
  }

 private:
  std::vector<double> weights_, credit_;
  double sum_ = 0.0;
};

void vary_options(const Suite& suite, SceneTask& task) {
  OptionList list;
  list.add_group("room", task.room);
  list.add_group("settle", task.settle);
  list.add_group("lidar", task.lidar);
  for (const auto& variation : suite.vary) {
    const double u = CounterRandom(stream_seed(task.seed, variation.option)).uniform(0);
    const double value = variation.minimum + u * (variation.maximum - variation.minimum);
    const auto option = std::find_if(list.options().begin(), list.options().end(),
                                     [&](const Option& o) { return o.name == variation.option; });
    const bool whole =
        option != list.options().end() && std::holds_alternative<int*>(option->value);
    list.set(variation.option, whole ? fmt::format("{}", static_cast<long>(std::floor(value + 0.5)))
                                     : fmt::format("{}", value));
  }
}

}  // namespace

void Suite::describe(OptionList& list) {
  list.add_group("room", room);
  list.add_group("settle", settle);
  list.add_group("lidar", lidar);
}

void set_suite_option(Suite& suite, std::string_view name, std::string_view value) {
  if (name == "lidar.preset") {
    suite.lidar = lidar_preset(std::string(value));
    return;
  }
  OptionList list;
  list.add("name", suite.name, "name of the data set");
  list.add("seed", suite.seed, "of the rooms and scans");
  list.add("scenes", suite.scenes, "1", "rooms", 1, 10'000'000);
  list.add("scans", suite.scans, "1", "of each room", 1, 10'000);
  suite.describe(list);
  list.set(name, value);
  if (name == "room.family") suite.families = {{std::string(value), 1.0}};
}

std::vector<SceneTask> scene_tasks(const Suite& suite) {
  static const std::string split_names[] = {"train", "valid", "test"};
  std::vector<double> weights;
  for (const auto& family : suite.families) weights.push_back(family.second);
  if (std::none_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; })) {
    fail_data(suite.name, "families", "no family has a weight above 0");
  }
  RoundRobin families(weights);
  std::vector<RoundRobin> splits(
      weights.size(), RoundRobin({suite.split.train, suite.split.valid, suite.split.test}));
  std::vector<SceneTask> tasks;
  for (int index = 0; index < suite.scenes; ++index) {
    SceneTask task;
    task.index = index;
    task.name = fmt::format("{:02}", index);
    task.seed = stream_seed(suite.seed, "scene", static_cast<std::uint64_t>(index));
    task.room = suite.room;
    task.settle = suite.settle;
    task.lidar = suite.lidar;
    const std::size_t family = families.next();
    task.room.family = suite.families[family].first;
    task.split = split_names[splits[family].next()];
    vary_options(suite, task);
    tasks.push_back(std::move(task));
  }
  return tasks;
}

Shard parse_shard(std::string_view text) {
  Shard shard;
  const auto slash = text.find('/');
  const auto number = [&](std::string_view part, int& value) {
    const auto result = std::from_chars(part.data(), part.data() + part.size(), value);
    return !part.empty() && result.ec == std::errc{} && result.ptr == part.data() + part.size();
  };
  if (slash == std::string_view::npos || !number(text.substr(0, slash), shard.index) ||
      !number(text.substr(slash + 1), shard.count) || shard.count < 1 || shard.index < 1 ||
      shard.index > shard.count) {
    fail_usage(fmt::format("'{}' is no shard", text), "write i/n with i from 1 to n, as in 2/5");
  }
  --shard.index;
  return shard;
}

}  // namespace scanchor
