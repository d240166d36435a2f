#pragma once
// Real sensors bend planes: errors that many neighbouring points share grow with extent, and no
// noise estimate sees them.

#include "perception/cell_planes.hpp"

namespace scanchor {

/// [m] Systematic error that a range sensor may show over a surface: the +-30 mm that data sheets
/// state for the UTM-30LX (up to 10 m) and the VLP-16 (docs/why/planes.md).
inline constexpr double systematic_error = 0.03;
/// [m/m] How deep that error may bend a patch, relative to its half extent: a slope of 2 x 0.03 rad
/// at the rim. A ball or a column that a room holds is bent by several times that.
inline constexpr double systematic_bend = 0.03;

/// Surfaces count as bent where their flatness exceeds this share of the noise: three times the
/// most that simulated rooms show by chance (0.08, docs/why/planes.md).
inline constexpr double bent_from = 0.25;

/// [m] How far surfaces deviate from planes at scales where noise has averaged out: root of the
/// median, weighted by points, of what the variance across a broad cell exceeds the pooled variance
/// across its parts by, over cells whose parts are flat and turned by less than 0.1 rad against
/// each other. 0 for mathematical planes, up to chance.
double estimate_flatness(const CellTree& tree, double sigma);

/// Joins pieces of one bent surface. Pieces join where they touch, their own planes agree there to
/// within one `sigma`, their normals differ by less than 0.1 rad, and both stay within the
/// systematic error of the common plane (mean square). Labels follow; where joined, `planes` holds
/// the common plane.
void join_bent_planes(const CanonicalCloud& cloud, const CellTree& tree, double sigma,
                      PlaneLabels& labels);

}  // namespace scanchor
