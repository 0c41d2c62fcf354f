#include "reference/scene/scene_convolution.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/passages/wedge_walks.hpp"

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

}  // namespace

SceneConvolution::SceneConvolution(const PolygonSet& shape, const PolygonSet& reflected_robot,
                                   bool by_wedges) {
  const auto walks_of = [&](const PolygonSet& set) {
    return by_wedges ? wedge_walks(set) : std::nullopt;
  };
  const auto walks_p = walks_of(shape), walks_q = walks_of(reflected_robot);
  const PolygonSet &P = walks_p ? walks_p->walks : shape,
                   &Q = walks_q ? walks_q->walks : reflected_robot;
  const std::vector<FilteredRing> p = rings_of(P), q = rings_of(Q);
  for (const ConvolutionEdge& edge : reduced_convolution(P, Q)) {
    look_for_interrupt();
    const bool is_s = edge.kind == ConvolutionEdge::Kind::S;
    const FilteredRing& ring = (is_s ? p : q)[edge.edge.ring];
    const FilteredRing& other = (is_s ? q : p)[edge.vertex.ring];
    edges_.push_back(in_operands(edge, walks_p, walks_q));
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
    Box edge = box_of(parents.from, parents.to), vertex = box_of(parents.vertex);
    Box& of_shape = convolution.edges_[k].kind == ConvolutionEdge::Kind::S ? edge : vertex;
    of_shape = plane::scaled(of_shape, s.lower, s.upper);
    boxes.push_back(plane::sum_of(edge, vertex));
  }
  tree_ = BoxTree(std::move(boxes));
}

std::pair<FilteredPoint, FilteredPoint> ContactFinder::ends(std::uint32_t edge) const {
  const SceneConvolution::Parents& parents = convolution_.parents_[edge];
  const bool is_s = convolution_.edges_[edge].kind == ConvolutionEdge::Kind::S;
  const auto at = [&](const FilteredPoint& end) {
    const Point &of_shape = (is_s ? end : parents.vertex).exact(),
                &of_robot = (is_s ? parents.vertex : end).exact();
    return FilteredPoint({scale_ * of_shape.x + of_robot.x, scale_ * of_shape.y + of_robot.y});
  };
  return {at(parents.from), at(parents.to)};
}

bool ContactFinder::shares(std::uint32_t edge, const FilteredPoint& from,
                           const FilteredPoint& to) const {
  const auto [a, b] = ends(edge);
  const int way = compare_xy(from, to);
  return orientation(from, to, a) == 0 && compare_xy(from, b) == way && compare_xy(a, to) == way;
}

template <class Take>
void ContactFinder::each_near(const FilteredPoint& from, const FilteredPoint& to,
                              Take&& take) const {
  tree_.query(box_of(from, to), [&](std::uint32_t k) {
    take(k, convolution_.parents_[k]);
    return false;
  });
}

void ContactFinder::add(const FilteredPoint& from, const FilteredPoint& to,
                        std::vector<ConvolutionEdge>& contacts) {
  found_.clear();
  const int way = compare_xy(from, to);
  each_near(from, to, [&](std::uint32_t k, const SceneConvolution::Parents& parents) {
    if (compare_xy(parents.from, parents.to) == way &&
        turn(parents.from, parents.to, from, to) == 0) {
      found_.push_back(k);
    }
  });
  std::sort(found_.begin(), found_.end());
  // Some edge runs along each side: an edge alone must be it.
  if (found_.size() > 1)
    std::erase_if(found_, [&](std::uint32_t k) { return !shares(k, from, to); });
  for (const std::uint32_t k : found_) contacts.push_back(convolution_.edges_[k]);
}

void ContactFinder::add_sharing(const FilteredPoint& from, const FilteredPoint& to,
                                std::vector<ConvolutionEdge>& contacts) {
  found_.clear();
  const bool is_point = compare_xy(from, to) == 0;
  each_near(from, to, [&](std::uint32_t k, const SceneConvolution::Parents& parents) {
    if (!is_point && turn(parents.from, parents.to, from, to) != 0) return;
    const auto [a, b] = ends(k);
    const bool runs_back = !is_point && compare_xy(from, to) != compare_xy(a, b);
    int winding = 0;
    if (is_point ? add_winding(a, b, from, winding)
                 : shares(k, runs_back ? to : from, runs_back ? from : to)) {
      found_.push_back(k);
    }
  });
  std::sort(found_.begin(), found_.end());
  for (const std::uint32_t k : found_) contacts.push_back(convolution_.edges_[k]);
}

}  // namespace minkref::inline scene
