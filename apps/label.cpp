// scanchor label: a scan in, named things out, each with its reason.

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "apps/scan_input.hpp"
#include "apps/scan_pictures.hpp"
#include "core/file.hpp"
#include "core/parallel.hpp"
#include "reasoning/alternatives.hpp"
#include "reasoning/ontology.hpp"

namespace scanchor::apps {
namespace fs = std::filesystem;
namespace {

struct LabelArguments : ScanArguments {
  std::string out;
  std::string points;
  bool pictures = true;
};

std::size_t points_of(const Entity& entity, const std::vector<std::size_t>& counts) {
  std::size_t points = 0;
  for (const auto surface : entity.surfaces) points += counts[static_cast<std::size_t>(surface)];
  return points;
}

void print_entities(const Common& common, const Labelling& labelling,
                    const std::vector<std::size_t>& counts) {
  say(common, fmt::format("{:>4}  {:<16} {:>5}  {:>23}  {:>13} {:>8}", "id", "class", "p",
                          "centre [m]", "size [m]", "points"));
  std::size_t unnamed = 0;
  std::size_t unnamed_points = 0;
  for (const auto& entity : labelling.entities) {
    if (entity.members.empty() && entity.surfaces.size() == 1 &&
        labelling.entity_of_surface[static_cast<std::size_t>(entity.surfaces[0])] != entity.id) {
      continue;  // it belongs to a group that is in the list itself
    }
    if (entity.label == "unknown" || entity.label == "ambiguous") {
      ++unnamed;
      unnamed_points += points_of(entity, counts);
      continue;
    }
    say(common,
        fmt::format("{:>4}  {:<16} {:>5.2f}  {:>7.2f} {:>7.2f} {:>7.2f}  {:>6.2f}{:>7.2f} {:>8}",
                    entity.id, entity.label, entity.probability, entity.center.x(),
                    entity.center.y(), entity.center.z(), entity.size.x(), entity.size.y(),
                    points_of(entity, counts)));
  }
  if (unnamed > 0) {
    say(common,
        fmt::format(
            "      {} further surfaces ({} points) fit no description or more than one: unknown",
            unnamed, unnamed_points));
  }
}

int run_label(LabelArguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  const Ontology ontology = find_ontology(arguments.ontology);
  const PointCloud cloud = load_scan(arguments);
  const fs::path out = arguments.out.empty()
                           ? fs::path("scanchor-" + fs::path(arguments.scan).stem().string())
                           : fs::path(arguments.out);

  const auto start = std::chrono::steady_clock::now();
  Surfaces surfaces = perceive(cloud, arguments.perceive);
  require_surfaces(arguments, cloud, surfaces);
  const Labelling labelling = interpret(surfaces, cloud, ontology, arguments.reason);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;

  const auto counts = inlier_counts(surfaces);
  Json labels = labelling_to_json(labelling, counts);
  labels["classes"] = label_names(labelling);
  make_folder(out);
  write_surfaces(out / "surfaces.json", surfaces);
  write_json(out / "labels.json", labels);
  if (!arguments.points.empty())
    write_labelled_points(arguments.points, cloud, surfaces, &labelling);
  std::vector<fs::path> pictures;
  if (arguments.pictures) pictures = draw_scan(out, cloud, surfaces, labelling);

  answer(arguments.common, labels);
  const SetAside& aside = surfaces.set_aside;
  say(arguments.common,
      fmt::format("{}: {} points ({} set aside), {} surfaces, noise {:.1f} mm, {:.2f} s",
                  arguments.scan, cloud.size(),
                  aside.not_finite + aside.out_of_range + aside.scanner_body,
                  surfaces.surfaces.size(), 1e3 * surfaces.noise_sigma, took.count()));
  print_entities(arguments.common, labelling, counts);
  say(arguments.common, fmt::format("labels:   {}", (out / "labels.json").string()));
  for (const auto& picture : pictures)
    say(arguments.common, fmt::format("picture:  {}", picture.string()));
  return 0;
}

}  // namespace

void add_label(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("label", "Name the things in a real or simulated scan");
  verb->footer(
      "Example:\n  scanchor label room.pcd --up auto --ontology office --points labelled.ply");
  auto arguments = std::make_shared<LabelArguments>();
  add_scan_arguments(*verb, *arguments, true);
  verb->add_option(
          "--out", arguments->out,
          "Folder for labels.json, surfaces.json and the pictures; default scanchor-<scan>")
      ->type_name("DIR");
  verb->add_option(
          "--points", arguments->points,
          "Write the points in their order with the fields `label`, `instance`, `plane` (-1: none)")
      ->type_name("FILE");
  verb->add_flag("--pictures,!--no-pictures", arguments->pictures, "Draw the cloud and the labels");
  verb->callback([arguments, &code] { code = run_label(*arguments); });
}

}  // namespace scanchor::apps
