#pragma once
// The figures of the paper, remade from simulated scans.

#include <filesystem>
#include <string>
#include <vector>

#include "results/image.hpp"
#include "results/vector.hpp"

namespace scanchor {

struct Figure {
  std::string name;      ///< "figure-1-shelf": the file's name without ending
  std::string caption;   ///< one sentence, as it stands below the figure
  Image image;           ///< for pixels
  VectorPicture vector;  ///< for SVG; no items where the figure is made of pixels
};

/// Fig. 1: the cloud of a shelf with things on its boards.
Figure figure_shelf();
/// Fig. 3 and 4: points of a surface, their Delaunay triangles, the alpha shape for three radii.
Figure figure_alpha_shape();
/// Fig. 5 and 6: an office of 100,000 points, and its planes with their polygons.
Figure figure_office_cloud();
Figure figure_office_planes();
/// Fig. 7: two monitors on a desk with polygon, fitted rectangle, A, E and R.
Figure figure_monitors();

/// Makes all of them into the folder as PNG, and as SVG where there are vectors; returns the files
/// written. Seconds of work. Deterministic. Throws Error if there is no OpenGL or the folder cannot
/// be written.
std::vector<std::filesystem::path> write_figures(const std::filesystem::path& folder);

}  // namespace scanchor
