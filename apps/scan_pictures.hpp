#pragma once
// The pictures that go with a labelled scan, and with a simulated room.

#include <filesystem>
#include <vector>

#include "cloud/point_cloud.hpp"
#include "perception/surface.hpp"
#include "reasoning/labelling.hpp"
#include "scenes/scene.hpp"
#include "sensors/scan.hpp"

namespace scanchor::apps {

/// Turns a cloud so that the up direction that reasoning found points up in the picture.
Eigen::Isometry3d upright(const Labelling& labelling);

/// Draws cloud.png (by height), planes.png (by plane) and labels.png into the folder; returns what
/// it wrote.
std::vector<std::filesystem::path> draw_scan(const std::filesystem::path& folder,
                                             const PointCloud& cloud, const Surfaces& surfaces,
                                             const Labelling& labelling);

/// Draws scene.png, cloud.png (true classes), planes.png and labels.png from one viewpoint; returns
/// what it wrote.
std::vector<std::filesystem::path> draw_room(const std::filesystem::path& folder,
                                             const Scene& scene, const Scan& scan,
                                             const Surfaces& surfaces, const Labelling& labelling);

}  // namespace scanchor::apps
