#pragma once
// Whether a surface ends where another one touches it.

#include <vector>

#include "perception/outline_samples.hpp"

namespace scanchor {

/// By other surface: 1 where this one is seen on the far side of its plane as well. A cabinet
/// touches the wall that it stands before, but the wall goes on behind it; the floor ends at the
/// wall, nothing of it lies behind. Only surfaces are asked that hide something here (samples
/// `blocked`). `gate` [m]: noise of a point across the plane.
std::vector<char> goes_on_behind(const Surfaces& surfaces, const OutlineSamples& samples,
                                 double gate);

}  // namespace scanchor
