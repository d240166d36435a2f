#pragma once
// What has sunk into a body that is no hull. Private to sim/settle.cpp.

#include "scenes/scene.hpp"

namespace scanchor {

/// Whether a point (part's frame) is inside a closed mesh, by more than `depth` [m] up and down.
bool inside_mesh(const Part& part, const Eigen::Vector3d& point, double depth);

/// Whether a corner of the thing is inside a part of `other` that physics takes as triangles: a
/// hollow shell to Bullet, which sees nothing wrong once a thing is within.
bool sunk_into(const Instance& thing, const Instance& other, double depth);

}  // namespace scanchor
