#pragma once
// Vector pictures painted over pixels, anti-aliased by exact area coverage.

#include "results/image.hpp"
#include "results/vector.hpp"

namespace scanchor {

/// A picture of one colour.
Image blank_image(int width, int height, Color color = paper_white);
/// Paints over the image; what lies outside is cut off. `scale` enlarges everything (2: for
/// high-resolution output).
void paint(const VectorPicture& picture, Image& image, double scale = 1.0);
/// A fresh image of the picture's size times `scale`.
Image to_image(const VectorPicture& picture, double scale = 1.0, Color background = paper_white);
/// Copies `source` with its upper left corner at (x, y); what lies outside is cut off.
void copy_into(Image& image, const Image& source, int x, int y);

/// Coverage in [0, 1] of each pixel by the area inside the rings (non-zero winding), a row-major
/// window of w x h pixels at (0, 0). Exact for pieces that do not overlap; overlapping pieces of
/// one orientation are united.
std::vector<float> coverage(const std::vector<Path>& rings, int w, int h);

}  // namespace scanchor
