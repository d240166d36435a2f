// scanchor generate: labelled scans on disk, in the layout that existing loaders read.

#include <fmt/format.h>

#include <filesystem>

#include "apps/command.hpp"
#include "core/data_folder.hpp"
#include "core/progress.hpp"
#include "sensors/dataset.hpp"

namespace scanchor::apps {
namespace {

struct GenerateArguments {
  Common common;
  std::string suite = "office";
  std::string out;
  std::string shard = "1/1";
  int scenes = 0;
  std::uint64_t seed = 0;
  DatasetOptions options;
};

int run_generate(GenerateArguments& arguments) {
  Suite suite = read_suite(find_data_file("suites", arguments.suite, ".yaml"));
  if (arguments.scenes > 0) suite.scenes = arguments.scenes;
  if (arguments.seed > 0) suite.seed = arguments.seed;
  OptionList list;
  suite.describe(list);
  apply_settings(suite, list, arguments.common);

  DatasetOptions options = arguments.options;
  options.threads = arguments.common.threads;
  options.shard = parse_shard(arguments.shard);
  options.stop = &interrupted;
  Progress progress("scans", 0, {.quiet = arguments.common.quiet || arguments.common.json});
  options.progress = [&](std::size_t done, std::size_t total) { progress.update(done, total); };
  const DatasetResult result = generate_dataset(suite, arguments.out, options);

  Json json;
  json["out"] = arguments.out;
  json["suite"] = suite.name;
  json["scenes_written"] = result.scenes_written;
  json["scenes_found"] = result.scenes_found;
  json["scans_written"] = result.scans_written;
  json["points_written"] = result.points_written;
  json["interrupted"] = result.interrupted;
  json["complete"] = result.complete;
  json["rooms_made_anew"] = result.rooms_made_anew;
  json["problems"] = result.problems;
  answer(arguments.common, json);
  say(arguments.common, fmt::format("{}: {} scenes written, {} were there; {} scans with {} points",
                                    arguments.out, result.scenes_written, result.scenes_found,
                                    result.scans_written, result.points_written));
  if (result.rooms_made_anew > 0) {
    say(arguments.common,
        fmt::format("  rooms that lacked something or did not come to rest, made anew: {}",
                    result.rooms_made_anew));
  }
  for (const auto& problem : result.problems) say(arguments.common, "  " + problem);
  if (result.interrupted) {
    throw Error(ExitCode::nothing_measured, "interrupted; the same command goes on from there");
  }
  say(arguments.common,
      result.complete
          ? "The data set is complete: dataset.json is its card."
          : "Other shards are missing; lay them side by side and run once more to finish.");
  return 0;
}

}  // namespace

void add_generate(CLI::App& root, ExitCodeSlot& code) {
  auto* verb =
      root.add_subcommand("generate", "Write a data set of labelled scans (SemanticKITTI layout)");
  verb->footer(
      "Example:\n  scanchor generate office --scenes 100 --out data --pcd --set "
      "lidar.range_sigma=0.02");
  auto arguments = std::make_shared<GenerateArguments>();
  verb->add_option("suite", arguments->suite,
                   "quick, office, storage, home, stress, or a YAML file")
      ->type_name("SUITE")
      ->capture_default_str();
  verb->add_option("--out", arguments->out,
                   "Folder of the data set; an interrupted one is continued")
      ->type_name("DIR")
      ->required();
  verb->add_option("--scenes", arguments->scenes, "Number of scenes; 0: as the suite says")
      ->check(CLI::Range(0, 1000000));
  verb->add_option("--seed", arguments->seed, "Seed; 0: as the suite says");
  verb->add_option("--shard", arguments->shard, "Only part i of n")
      ->type_name("I/N")
      ->capture_default_str();
  verb->add_flag("--pcd", arguments->options.formats.pcd,
                 "Also PCD files with all truth as fields");
  verb->add_flag("--ply", arguments->options.formats.ply,
                 "Also PLY files with all truth as fields");
  verb->add_flag("--s3dis", arguments->options.formats.s3dis, "Also S3DIS-style text");
  add_common(*verb, arguments->common);
  verb->callback([arguments, &code] { code = run_generate(*arguments); });
}

}  // namespace scanchor::apps
