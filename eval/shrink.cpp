#include "eval/shrink.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/text.hpp"

namespace scanchor {
namespace {

using Set = std::vector<std::size_t>;

Set without(const Set& set, std::size_t begin, std::size_t end) {
  Set rest(set.begin(), set.begin() + static_cast<std::ptrdiff_t>(begin));
  rest.insert(rest.end(), set.begin() + static_cast<std::ptrdiff_t>(end), set.end());
  return rest;
}

// Effects that a scan does without: numbers that scale noise. Geometry of the sweep is none of
// them.
bool is_noise(const std::string& name) {
  for (const char* part : {"sigma", "probability", "noise", "dropout", "jitter", "backlash",
                           "drift", "divergence", "mixed", "skew", "offset", "bias", "error"}) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

Set shrink_set(std::size_t count, const std::function<bool(const Set&)>& fails) {
  std::map<Set, bool> asked;
  const auto still = [&](const Set& set) {
    const auto found = asked.find(set);
    return found != asked.end() ? found->second : asked.emplace(set, fails(set)).first->second;
  };
  Set current(count);
  for (std::size_t i = 0; i < count; ++i) current[i] = i;
  if (still({})) return {};
  std::size_t pieces = 2;
  while (current.size() >= 2) {
    pieces = std::min(pieces, current.size());
    bool smaller = false;
    // A piece alone, then everything but a piece.
    for (const bool complement : {false, true}) {
      for (std::size_t k = 0; k < pieces && !smaller; ++k) {
        const std::size_t begin = k * current.size() / pieces,
                          end = (k + 1) * current.size() / pieces;
        const Set rest = without(current, begin, end);
        const Set piece(current.begin() + static_cast<std::ptrdiff_t>(begin),
                        current.begin() + static_cast<std::ptrdiff_t>(end));
        const Set& candidate = complement ? rest : piece;
        if (candidate.size() == current.size() || !still(candidate)) continue;
        current = candidate;
        pieces = complement ? std::max<std::size_t>(pieces - 1, 2) : 2;
        smaller = true;
      }
    }
    if (smaller) continue;
    if (pieces >= current.size()) break;
    pieces = std::min(2 * pieces, current.size());
  }
  return current;
}

ShrinkResult shrink_case(const FailingCase& start,
                         const std::function<bool(const FailingCase&)>& fails,
                         const std::vector<std::int32_t>& keep) {
  ShrinkResult result;
  const auto ask = [&](const FailingCase& candidate) {
    ++result.tried;
    return fails(candidate);
  };
  if (!ask(start)) fail_usage("the case does not fail, there is nothing to shrink");
  result.smallest = start;

  // Only the pose in use.
  FailingCase one = start;
  if (start.scene.sensor_poses.size() > 1) {
    one.scene.sensor_poses = {start.scene.sensor_poses[static_cast<std::size_t>(start.pose)]};
    one.pose = 0;
    result.smallest = one;
    result.steps.push_back(
        {"kept 1 of " + std::to_string(start.scene.sensor_poses.size()) + " sensor poses"});
  }
  std::vector<std::size_t> loose;  // places of the instances that may go
  for (std::size_t i = 0; i < start.scene.instances.size(); ++i) {
    if (std::find(keep.begin(), keep.end(), start.scene.instances[i].id) == keep.end())
      loose.push_back(i);
  }
  const auto with = [&](const Set& chosen) {
    std::vector<char> stays(start.scene.instances.size(), 1);
    for (const auto place : loose) stays[place] = 0;
    for (const auto k : chosen) stays[loose[k]] = 1;
    FailingCase candidate = result.smallest;
    candidate.scene.instances.clear();
    for (std::size_t i = 0; i < stays.size(); ++i) {
      if (stays[i]) candidate.scene.instances.push_back(start.scene.instances[i]);
    }
    return candidate;
  };
  const auto fails_with = [&](const Set& chosen) {
    if (chosen.size() == loose.size()) return true;
    const FailingCase candidate = with(chosen);
    return !candidate.scene.instances.empty() && ask(candidate);
  };
  const Set needed = shrink_set(loose.size(), fails_with);
  result.smallest = with(needed);
  if (needed.size() < loose.size()) {
    result.steps.push_back({"left out " + std::to_string(loose.size() - needed.size()) + " of " +
                            std::to_string(start.scene.instances.size()) + " things"});
  }

  OptionList names;
  LidarOptions probe = start.lidar;
  probe.describe(names);
  for (std::size_t i = 0; i < names.options().size(); ++i) {
    const Option& option = names.options()[i];
    double* const* was = std::get_if<double*>(&option.value);
    if (!was || !is_noise(option.name) || **was <= 0 || option.minimum > 0) continue;
    const double first = **was;
    double best = first;
    const auto try_value = [&](double value) {
      FailingCase candidate = result.smallest;
      OptionList list;
      candidate.lidar.describe(list);
      **std::get_if<double*>(&list.options()[i].value) = value;
      if (!ask(candidate)) return false;
      result.smallest = candidate;
      best = value;
      return true;
    };
    if (!try_value(0.0)) {
      for (double value = first / 2; value >= first / 16 && try_value(value);) value /= 2;
    }
    if (best < first)
      result.steps.push_back(
          {option.name + " " + shortest_text(first) + " -> " + shortest_text(best)});
  }
  return result;
}

}  // namespace scanchor
