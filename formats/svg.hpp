// Pictures: layers of regions and segments drawn over each other.
#pragma once

#include <string>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref {

/// A layer draws its region, then its segments. Colours are SVG's ("#c33", "none").
struct Layer {
  std::string name;        ///< becomes the title of the group
  PolygonSet region = {};  ///< filled even-odd, rings outlined; points and segments are drawn
  std::vector<Segment> segments = {};
  std::string fill = "#4c78a8";
  std::string stroke = "#1f3b57";
  double opacity = 0.5;     ///< of the fill
  double stroke_width = 1;  ///< in picture units; the longer side measures 1000
};

/// An SVG document with all layers, first one undermost. The y axis points up. Coordinates are
/// moved and scaled (exactly, then rounded to doubles) so that the common bounding box's longer
/// side measures 1000.
std::string write_svg(const std::vector<Layer>& layers);

}  // namespace minkref
