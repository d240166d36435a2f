#include "perception/perceive.hpp"

#include "perception/find_planes.hpp"

namespace scanchor {

void PerceiveOptions::describe(OptionList& list) {
  list.add("method", method, "how planes and shapes are found: ours, or the paper's own chain",
           {"default", "paper"});
  list.add("noise_sigma", noise_sigma, "m",
           "standard deviation of the sensor's range noise; 0: estimated from the cloud", 0.0, 1.0);
  list.add("body_radius", body_radius, "m",
           "returns nearer to a known sensor are its own body; -1: found from the cloud, 0: none",
           -1.0, 10.0);
  list.add("shapes", shapes, "outlines, rectangles and features too; false: stop after the planes");
  list.add("paper_neighbours", paper.neighbours, "1", "k of the paper's nearest neighbours", 3,
           200);
  list.add("paper_delta", paper.delta, "1",
           "the paper's delta: bound of a region's mean square error, in squared noise sigmas",
           0.01, 1000.0);
}

Surfaces perceive(const PointCloud& cloud, const PerceiveOptions& options) {
  Surfaces surfaces = find_planes(cloud, options);  // section 2: KNN search, region growing
  if (options.shapes)
    find_shapes(cloud, options, surfaces);  // section 2: alpha shapes to form features
  return surfaces;
}

}  // namespace scanchor
