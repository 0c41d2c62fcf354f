#include "reference/scene/scene.hpp"

#include <algorithm>
#include <string>
#include <tuple>

#include "reference/error.hpp"

namespace minkref::inline scene {
namespace {

auto key(const Owner& owner) {
  const ConvolutionEdge& e = owner.edge;
  return std::tuple(owner.copy, e.kind, e.edge.ring, e.edge.index, e.vertex.ring, e.vertex.index);
}

}  // namespace

void refuse_bad_copy(const Copy& copy, std::size_t shapes) {
  if (copy.shape >= shapes) {
    throw BadInput("no-shape", "there is no shape " + std::to_string(copy.shape),
                   "the scene has " + std::to_string(shapes) + " shapes, counted from 0");
  }
  if (sign(copy.scale) <= 0) {
    throw BadInput("bad-scale",
                   "the scale " + to_string(copy.scale) + " of a copy is not greater than zero",
                   "give a scale s > 0");
  }
}

void refuse_without_area(const PolygonSet& robot, const std::vector<PolygonSet>& shapes) {
  if (!robot.is_point() && !robot.is_segment()) return;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (!shapes[k].is_point() && !shapes[k].is_segment()) continue;
    throw BadInput("no-area",
                   "shape " + std::to_string(k) + " has no area, and neither has the robot",
                   "give one of them an area");
  }
}

bool less(const Owner& a, const Owner& b) { return key(a) < key(b); }

void sort_unique(std::vector<Owner>& owners) {
  std::sort(owners.begin(), owners.end(), less);
  owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
}

}  // namespace minkref::inline scene
