// A robot among many scaled, placed copies of some shapes (Behar & Lien 2012, Sec. 8.1).
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline scene {

/// The obstacle `place` + `scale` times a shape of the scene.
struct Copy {
  std::uint32_t shape = 0;
  Rational scale = 1;
  Point place;
  friend bool operator==(const Copy&, const Copy&) = default;
};

/// Robot and shapes have passed `validate`. The sum of a copy with the reflected robot, the copy's
/// *placed sum*, has the robot's places at which the two meet.
struct Scene {
  PolygonSet robot;
  std::vector<PolygonSet> shapes;
  std::vector<Copy> copies;
};

/// Throws BadInput ("no-shape", "bad-scale").
void refuse_bad_copy(const Copy& copy, std::size_t shapes);
/// Throws BadInput ("no-area") where neither the robot nor some shape has an area.
void refuse_without_area(const PolygonSet& robot, const std::vector<PolygonSet>& shapes);

/// A contact of the robot with a copy: an edge of the convolution of the copy's shape (P) with the
/// reflected robot (Q).
struct Owner {
  std::uint32_t copy = 0;
  ConvolutionEdge edge;
  friend bool operator==(const Owner&, const Owner&) = default;
};

/// By copy, then S-edges before T-edges, then by parents.
bool less(const Owner& a, const Owner& b);

/// Sorts, and removes duplicates.
void sort_unique(std::vector<Owner>& owners);

}  // namespace minkref::inline scene
