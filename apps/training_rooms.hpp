#pragma once
// What the fitting verbs look at: every scan of a suite's training rooms.

#include <iterator>
#include <vector>

#include "apps/command.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "eval/run.hpp"
#include "sensors/suite.hpp"

namespace scanchor::apps {

/// What look(room, scan) makes of each scan, in the order of the tasks; side by side. `unit`: of
/// the progress, a task each. Throws Error(nothing_measured) without a task or when interrupted.
template <class Look>
auto look_at_scans(const std::vector<SceneTask>& tasks, const Suite& suite, const Common& common,
                   const char* unit, const Look& look) {
  using Seen = decltype(look(MadeScene{}, Scan{}));
  if (tasks.empty()) {
    throw Error(ExitCode::nothing_measured,
                "suite " + suite.name + " has no training rooms; name one with more scenes");
  }
  std::vector<std::vector<Seen>> made(tasks.size());
  {
    Progress progress(unit, tasks.size(), {.quiet = common.quiet || common.json});
    parallel_blocks(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        if (interrupted) return;
        const MadeScene room = make_scene(tasks[i], suite.scans);
        for (const auto& scan : room.scans) made[i].push_back(look(room, scan));
        progress.add();
      }
    });
  }
  if (interrupted)
    throw Error(ExitCode::nothing_measured,
                "interrupted before all rooms were seen; nothing was written");
  std::vector<Seen> all;
  for (auto& room : made)
    all.insert(all.end(), std::make_move_iterator(room.begin()),
               std::make_move_iterator(room.end()));
  return all;
}

}  // namespace scanchor::apps
