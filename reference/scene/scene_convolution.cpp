#include "reference/scene/scene_convolution.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/plane/location.hpp"

namespace minkref::inline scene {
namespace {

std::vector<FilteredRing> rings_of(const PolygonSet& set) {
  std::vector<FilteredRing> rings;
  for (const Polygon& polygon : set.polygons) {
    rings.push_back(filtered_ring(polygon.outer));
    for (const Ring& hole : polygon.holes) rings.push_back(filtered_ring(hole));
  }
  return rings;
}

Box box_around(const FilteredPoint& a, const FilteredPoint& b) {
  Box box{below(a.x()), below(a.y()), above(a.x()), above(a.y())};
  box.add({below(b.x()), below(b.y()), above(b.x()), above(b.y())});
  return box;
}

}  // namespace

SceneConvolution::SceneConvolution(const PolygonSet& shape, const PolygonSet& reflected_robot)
    : shape_(shape),
      reflected_(reflected_robot),
      edges_(reduced_convolution(shape, reflected_robot)) {
  const std::vector<FilteredRing> p = rings_of(shape), q = rings_of(reflected_robot);
  parents_.reserve(edges_.size());
  for (const ConvolutionEdge& edge : edges_) {
    look_for_interrupt();
    const bool is_s = edge.kind == ConvolutionEdge::Kind::S;
    const FilteredRing& ring = (is_s ? p : q)[edge.edge.ring];
    const FilteredRing& other = (is_s ? q : p)[edge.vertex.ring];
    parents_.push_back({ring[edge.edge.index], ring[(edge.edge.index + 1) % ring.size()],
                        other[edge.vertex.index]});
  }
}

ContactFinder::ContactFinder(const SceneConvolution& convolution, const Rational& scale)
    : convolution_(convolution), scale_(scale) {
  const Enclosure s = enclose(scale);
  std::vector<Box> boxes;
  boxes.reserve(convolution.edges_.size());
  for (std::size_t k = 0; k < convolution.edges_.size(); ++k) {
    const SceneConvolution::Parents& parents = convolution.parents_[k];
    Box edge = box_around(parents.from, parents.to),
        vertex = box_around(parents.vertex, parents.vertex);
    Box& of_shape = convolution.edges_[k].kind == ConvolutionEdge::Kind::S ? edge : vertex;
    of_shape = plane::scaled(of_shape, s.lower, s.upper);
    boxes.push_back(plane::sum_of(edge, vertex));
  }
  tree_ = BoxTree(std::move(boxes));
}

bool ContactFinder::shares(std::uint32_t edge, const FilteredPoint& from,
                           const FilteredPoint& to) const {
  const Segment at =
      at_scale(convolution_.edges_[edge], convolution_.shape_, convolution_.reflected_, scale_);
  const FilteredPoint a(at.start), b(at.end);
  const int way = compare_xy(from, to);
  return orientation(from, to, a) == 0 && compare_xy(from, b) == way && compare_xy(a, to) == way;
}

void ContactFinder::add(const FilteredPoint& from, const FilteredPoint& to,
                        std::vector<ConvolutionEdge>& contacts) {
  found_.clear();
  const int way = compare_xy(from, to);
  tree_.query(box_around(from, to), [&](std::uint32_t k) {
    const SceneConvolution::Parents& parents = convolution_.parents_[k];
    if (compare_xy(parents.from, parents.to) == way &&
        turn(parents.from, parents.to, from, to) == 0) {
      found_.push_back(k);
    }
    return false;
  });
  std::sort(found_.begin(), found_.end());
  // Some edge runs along each side: an edge alone must be it.
  if (found_.size() > 1)
    std::erase_if(found_, [&](std::uint32_t k) { return !shares(k, from, to); });
  for (const std::uint32_t k : found_) contacts.push_back(convolution_.edges_[k]);
}

}  // namespace minkref::inline scene
