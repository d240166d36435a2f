// scanchor run: the main job. Rooms from a seed, scanned, understood, scored and drawn; the demo is
// this verb without arguments.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "apps/command.hpp"
#include "apps/room_run.hpp"
#include "apps/score_table.hpp"
#include "core/data_folder.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "core/progress.hpp"
#include "results/report.hpp"
#include "results/table.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct RunArguments {
  Common common;
  std::string suite;
  std::string out = "scanchor-run";
  std::string family;
  std::string ontology = "office";
  std::string protocol = "scanchor-1";
  int scenes = 0;
  int scans = 0;
  std::uint64_t seed = 0;
  bool pictures = true;
};

constexpr int demo_rooms = 3;

/// Three offices where no suite is named; the flags override what a suite says.
Suite chosen_suite(const RunArguments& arguments) {
  Suite suite;
  if (arguments.suite.empty()) {
    suite.name = "demo";
    suite.text = "offices of the demo";
    suite.scenes = demo_rooms;
  } else {
    suite = read_suite(find_data_file("suites", arguments.suite, ".yaml"));
  }
  if (!arguments.family.empty()) suite.families = {{arguments.family, 1.0}};
  if (arguments.scenes > 0) suite.scenes = arguments.scenes;
  if (arguments.scans > 0) suite.scans = arguments.scans;
  if (arguments.seed > 0) suite.seed = arguments.seed;
  return suite;
}

Json summary_json(const Suite& suite, const Chain& chain, const std::vector<RoomResult>& rooms,
                  const Score& total) {
  Json json;
  json["suite"] = suite_to_json(suite);
  Json& list = json["rooms"] = Json::array();
  for (const auto& room : rooms) {
    Json& row = list.emplace_back();
    row["name"] = room.name;
    row["family"] = room.family;
    row["seed"] = room.seed;
    row["points"] = room.points;
    row["surfaces"] = room.surfaces;
    row["found"] = room.objects.score.total().found;
    row["there"] = room.objects.score.total().truths;
    for (const auto& [stage, seconds] : room.seconds) row["seconds"][stage] = seconds;
    for (const auto& picture : room.pictures) row["pictures"].push_back(picture.string());
  }
  json["score"] = score_to_json(total, chain.protocol);
  return json;
}

void print_stages(const Common& common, const std::vector<RoomResult>& rooms) {
  std::string line;
  for (std::size_t stage = 0; stage < rooms.front().seconds.size(); ++stage) {
    std::vector<double> laps;
    for (const auto& room : rooms) laps.push_back(1e3 * room.seconds[stage].second);
    std::nth_element(laps.begin(), laps.begin() + static_cast<std::ptrdiff_t>(laps.size() / 2),
                     laps.end());
    line += fmt::format("{}{} {:.0f}", line.empty() ? "" : ", ", rooms.front().seconds[stage].first,
                        laps[laps.size() / 2]);
  }
  say(common, "\nTimes per scan [ms, median]: " + line + ".");
}

int run_run(RunArguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  Suite suite = chosen_suite(arguments);
  Chain chain;
  chain.ontology = find_ontology(arguments.ontology);
  chain.protocol = find_protocol(arguments.protocol);
  chain.pictures = arguments.pictures;
  OptionList list;
  suite.describe(list);
  list.add_group("perceive", chain.perceive);
  list.add_group("reason", chain.reason);
  apply_settings(suite, list, arguments.common);

  const fs::path out = arguments.out;
  make_folder(out);
  const auto tasks = scene_tasks(suite);
  std::vector<RoomResult> rooms;
  std::size_t done = 0;
  Score total;
  {
    Progress progress("rooms", tasks.size(),
                      {.quiet = arguments.common.quiet || arguments.common.json});
    for (const auto& task : tasks) {
      if (interrupted) break;
      for (auto& scan : run_room(task, suite.scans, chain, out)) {
        total.add(scan.score);
        rooms.push_back(std::move(scan));
      }
      ++done;
      progress.add();
    }
  }
  if (rooms.empty())
    throw Error(ExitCode::nothing_measured, "interrupted before the first room was done");

  const Json summary = summary_json(suite, chain, rooms, total);
  write_json(out / "summary.json", summary);
  write_json(out / "config.resolved.json", list.to_json());
  write_report(out, out / "report.html");
  answer(arguments.common, summary);

  const Common& common = arguments.common;
  const TableOptions style{terminal_width(stdout), wants_color(stdout), 0};
  say(common, fmt::format("Scanchor put {} {} of {} {} through the chain: {:.0f} mm range noise, "
                          "described by '{}', scored by {}.\n",
                          rooms.size(), rooms.size() == 1 ? "scan" : "scans", done,
                          done == 1 ? "room" : "rooms", 1e3 * suite.lidar.range_sigma,
                          chain.ontology.name, chain.protocol.name));
  Table overview({"room", "family", "points", "surfaces", "there", "found", "wrong"});
  for (const auto& room : rooms) {
    const auto counts = room.objects.score.total();
    overview.add_row({room.name, room.family, std::to_string(room.points),
                      std::to_string(room.surfaces), std::to_string(counts.truths),
                      std::to_string(counts.found),
                      std::to_string(counts.wrong + counts.repeated)});
  }
  say(common, overview.to_text(style));
  print_objects(common, total.objects);
  print_stages(common, rooms);
  for (const auto& room : rooms) {
    for (const auto& thing : room.objects.things) {
      if (thing.status == ThingStatus::missed) {
        say(common,
            fmt::format("Missed in {}: {} ({} points{})", room.name, thing.name, thing.points,
                        thing.called == unlabelled
                            ? ""
                            : ", called " + std::string(class_info(thing.called).name)));
      }
    }
  }
  if (!rooms.front().pictures.empty()) say(common, "\nPictures:");
  for (const auto& room : rooms) {
    for (const auto& picture : room.pictures) say(common, "  " + picture.string());
  }
  say(common,
      fmt::format(
          "Everything: {} (summary.json; in each room scene, scan, surfaces, labels, scores)",
          out.string()));
  say(common, fmt::format("Report:     {}", (out / "report.html").string()));
  return interrupted ? static_cast<int>(ExitCode::nothing_measured) : 0;
}

}  // namespace

void add_run(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("run", "Generate rooms, scan, understand, score and draw them");
  verb->footer(
      "Examples:\n  scanchor run --scenes 3 --out demo\n  scanchor run office --scenes 10 --set "
      "lidar.range_sigma=0.02");
  auto arguments = std::make_shared<RunArguments>();
  verb->add_option("suite", arguments->suite, "A suite by name or file; without one: three offices")
      ->type_name("SUITE");
  verb->add_option("--out", arguments->out, "Folder for everything that is written")
      ->type_name("DIR")
      ->capture_default_str();
  verb->add_option("--scenes", arguments->scenes, "Number of rooms; 0: as the suite says")
      ->check(CLI::Range(0, 1000000));
  verb->add_option("--scans", arguments->scans,
                   "Scans of each room, from its places in turn; 0: as the suite says")
      ->check(CLI::Range(0, 10000));
  verb->add_option("--seed", arguments->seed, "Seed; 0: as the suite says");
  verb->add_option("--family", arguments->family, "Only this family of rooms");
  verb->add_option("--ontology", arguments->ontology, "Descriptions: a name or a .sdl file")
      ->capture_default_str();
  verb->add_option("--protocol", arguments->protocol, "Scoring rules: a name or a file")
      ->capture_default_str();
  verb->add_flag("--pictures,!--no-pictures", arguments->pictures,
                 "Draw scene, cloud, planes and labels");
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_run(*arguments); });
}

}  // namespace scanchor::apps
