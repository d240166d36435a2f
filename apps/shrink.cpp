// scanchor shrink: the smallest scene and the least noise on which a thing is still missed.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "apps/suite_run.hpp"
#include "core/file.hpp"
#include "core/progress.hpp"
#include "core/random.hpp"
#include "eval/shrink.hpp"

namespace scanchor::apps {
namespace {

struct ShrinkArguments : SuiteArguments {
  std::string scene;
  int scan = 0;
  std::string thing;
  std::string out = "scanchor-case";
};

/// The task of a scene by its name in the suite.
SceneTask find_task(const Suite& suite, const std::string& name) {
  for (const auto& task : scene_tasks(suite)) {
    if (task.name == name || std::to_string(task.index) == name) return task;
  }
  fail_usage(fmt::format("suite {} has no scene '{}'", suite.name, name),
             "check and score name the scenes");
}

ObjectSummary summary_of(const FailingCase& one, const Method& method, const Protocol& protocol) {
  const World world(one.scene);
  const Scan scan = scan_room(world, one.scene.sensor_poses[static_cast<std::size_t>(one.pose)],
                              one.lidar, one.seed);
  const MethodAnswer said = method.answer(scan, "case");
  return summarize_objects(truth_of(scan, &one.scene, protocol), said.points, protocol,
                           method.described);
}

/// "desk 12" or "12": the thing that is missed; without a name the missed thing with most points.
const ThingResult& chosen_thing(const ObjectSummary& summary, const std::string& name) {
  const ThingResult* best = nullptr;
  std::string missed;
  for (const auto& thing : summary.things) {
    if (thing.status != ThingStatus::missed || thing.instance < 0) continue;
    missed += (missed.empty() ? "" : ", ") + thing.name;
    const bool named = thing.name == name || std::to_string(thing.instance) == name;
    if (named) return thing;
    if (name.empty() && (best == nullptr || thing.points > best->points)) best = &thing;
  }
  if (best == nullptr) {
    fail_usage(name.empty() ? "nothing is missed in this scan: there is nothing to shrink"
                            : fmt::format("'{}' is not missed in this scan", name),
               missed.empty() ? "choose another scene or scan" : "missed are: " + missed);
  }
  return *best;
}

int run_shrink(ShrinkArguments& arguments) {
  const Suite suite = load_suite(arguments);
  const Method method = load_method(arguments);
  const Protocol protocol = find_protocol(arguments.protocol);
  const SceneTask task = find_task(suite, arguments.scene);
  FailingCase start;
  const MadeScene made = make_scene(task, 1);
  start.scene = made.scene;
  start.lidar = task.lidar;
  start.pose = arguments.scan % static_cast<int>(start.scene.sensor_poses.size());
  start.seed = stream_seed(task.seed, "scan", static_cast<std::uint64_t>(arguments.scan));
  const ObjectSummary first = summary_of(start, method, protocol);
  const ThingResult thing = chosen_thing(first, arguments.thing);
  Progress progress("cases", 0, {.quiet = arguments.common.quiet || arguments.common.json});
  const auto fails = [&](const FailingCase& one) {
    if (interrupted)
      throw Error(ExitCode::nothing_measured, "interrupted: nothing smaller was written");
    progress.add();
    const ObjectSummary summary = summary_of(one, method, protocol);
    return std::any_of(summary.things.begin(), summary.things.end(), [&](const ThingResult& t) {
      return t.instance == thing.instance && t.status == ThingStatus::missed;
    });
  };
  const ShrinkResult result = shrink_case(start, fails, {thing.instance});

  const std::filesystem::path out = arguments.out;
  make_folder(out);
  write_scene(out / "scene.json", result.smallest.scene);
  OptionList lidar;
  LidarOptions smallest = result.smallest.lidar;
  lidar.add_group("lidar", smallest);
  Json json;
  json["thing"] = thing.name;
  json["method"] = method.name;
  json["scan_seed"] = std::to_string(result.smallest.seed);
  json["pose"] = result.smallest.pose;
  json["instances_before"] = start.scene.instances.size();
  json["instances"] = result.smallest.scene.instances.size();
  json["tried"] = result.tried;
  for (const auto& step : result.steps) json["steps"].push_back(step.text);
  json["options"] = lidar.to_json();
  write_json(out / "case.json", json);
  answer(arguments.common, json);
  say(arguments.common, fmt::format("'{}' is still missed with {} of {} things ({} cases tried):",
                                    thing.name, result.smallest.scene.instances.size(),
                                    start.scene.instances.size(), result.tried));
  for (const auto& step : result.steps) say(arguments.common, "  " + step.text);
  say(arguments.common, fmt::format("case: {0}/scene.json, {0}/case.json", arguments.out));
  return 0;
}

}  // namespace

void add_shrink(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand(
      "shrink", "The smallest scene and the least noise on which a thing is still missed");
  verb->footer("Example:\n  scanchor shrink quick --scene 000003 --thing 'desk 12' --out case");
  auto arguments = std::make_shared<ShrinkArguments>();
  add_suite_arguments(*verb, *arguments);
  verb->add_option("--scene", arguments->scene, "Of the suite, by name or number")
      ->required()
      ->type_name("NAME");
  verb->add_option("--scan", arguments->scan, "Number of the scan in the scene")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb->add_option("--thing", arguments->thing,
                   "Name or number of the missed thing; without: the missed one with most points");
  verb->add_option("--out", arguments->out, "Folder of the case")
      ->type_name("DIR")
      ->capture_default_str();
  verb->callback([arguments, &code] { code = run_shrink(*arguments); });
}

}  // namespace scanchor::apps
