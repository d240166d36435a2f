// scanchor segment: stops after the planes (or the shapes), for people who want to judge perception
// alone.

#include <fmt/format.h>

#include "apps/scan_input.hpp"
#include "core/parallel.hpp"

namespace scanchor::apps {
namespace {

struct SegmentArguments : ScanArguments {
  std::string points;
  std::string surfaces;
};

int run_segment(SegmentArguments& arguments) {
  const ThreadLimit limit(arguments.common.threads);
  const PointCloud cloud = load_scan(arguments);
  const Surfaces surfaces = perceive(cloud, arguments.perceive);
  require_surfaces(arguments, cloud, surfaces);

  if (!arguments.points.empty()) write_labelled_points(arguments.points, cloud, surfaces, nullptr);
  if (!arguments.surfaces.empty()) write_surfaces(arguments.surfaces, surfaces);
  answer(arguments.common, surfaces_to_json(surfaces, false));

  std::size_t on_planes = 0;
  for (const auto plane : surfaces.plane_of_point) on_planes += plane >= 0 ? 1 : 0;
  say(arguments.common,
      fmt::format("{} points, {} on {} planar surfaces; noise {:.1f} mm, spacing {:.1f} mm",
                  cloud.size(), on_planes, surfaces.surfaces.size(), 1e3 * surfaces.noise_sigma,
                  1e3 * surfaces.point_spacing));
  const SetAside& aside = surfaces.set_aside;
  if (aside.not_finite + aside.out_of_range + aside.scanner_body > 0) {
    say(arguments.common,
        fmt::format("set aside: {} not finite, {} at the maximum range, {} on the scanner's body",
                    aside.not_finite, aside.out_of_range, aside.scanner_body));
  }
  if (!arguments.points.empty()) say(arguments.common, "points:   " + arguments.points);
  if (!arguments.surfaces.empty()) say(arguments.common, "surfaces: " + arguments.surfaces);
  return 0;
}

}  // namespace

void add_segment(CLI::App& root, ExitCodeSlot& code) {
  auto* verb = root.add_subcommand("segment", "Find the planar surfaces of a scan");
  verb->footer(
      "Example:\n  scanchor segment room.pcd --points planes.ply --surfaces surfaces.json");
  auto arguments = std::make_shared<SegmentArguments>();
  add_scan_arguments(*verb, *arguments, false);
  verb->add_option("--points", arguments->points,
                   "Write the points in their order with the field `plane` (-1: none)")
      ->type_name("FILE");
  verb->add_option("--surfaces", arguments->surfaces, "Write surfaces.json")->type_name("FILE");
  verb->callback([arguments, &code] { code = run_segment(*arguments); });
}

}  // namespace scanchor::apps
