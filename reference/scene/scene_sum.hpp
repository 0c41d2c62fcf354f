// The sum of a shape at one scale with the reflected robot: edges with their contacts.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/sum.hpp"
#include "reference/scene/scene_convolution.hpp"

namespace minkref::inline scene {

/// At the place (0, 0). Rings come first, one after the other; then tight passages, if asked for.
struct SceneSum {
  /// With the sum on its left; of a tight passage with the sum on both sides. From a point to
  /// itself: a tight point.
  struct Edge {
    std::uint32_t from = 0, to = 0;
    std::uint32_t before = 0;  ///< the edge that arrives at `from`; of a passage the edge itself
  };
  std::vector<Point> points;
  std::vector<Edge> edges;
  std::uint32_t boundary = 0;  ///< so many edges are of rings
  /// Convolution edges that run along an edge or a part of it: edge k has those from
  /// first_contact[k] to before first_contact[k + 1].
  std::vector<ConvolutionEdge> contacts;
  std::vector<std::uint32_t> first_contact;
  /// Points inside of an edge of the same sum, (edge, point), sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touches;
};

/// From the sum at a scale, with its tight passages if they are asked for. Exact. O(n log n).
SceneSum scene_sum(const Sum& found, const SceneConvolution& convolution, const Rational& scale);

/// A sum moved to its place, ready to be asked for contacts.
struct PlacedSum {
  PlacedSum(std::shared_ptr<const SceneSum> of, const Point& at);

  std::shared_ptr<const SceneSum> sum;
  Point place;
  std::vector<FilteredPoint> points;
  std::vector<Box> boxes;  ///< of edges
  Box box;
  BoxTree tree;  ///< over the edges, if they are many

  const FilteredPoint& start(std::uint32_t edge) const { return points[sum->edges[edge].from]; }
  const FilteredPoint& end(std::uint32_t edge) const { return points[sum->edges[edge].to]; }
  bool is_boundary(std::uint32_t edge) const { return edge < sum->boundary; }
  bool is_point(std::uint32_t edge) const { return sum->edges[edge].from == sum->edges[edge].to; }

  /// Calls report(edge) for each edge whose box meets the closed box.
  template <class Report>
  void near(const Box& where, Report&& report) const {
    if (tree.size() != 0) {
      tree.query(where, [&](std::uint32_t edge) {
        report(edge);
        return false;
      });
      return;
    }
    for (std::uint32_t edge = 0; edge < boxes.size(); ++edge) {
      if (boxes[edge].overlaps(where)) report(edge);
    }
  }
};

/// The box of a filtered point, a certain enclosure.
inline Box box_of(const FilteredPoint& p) {
  return {below(p.x()), below(p.y()), above(p.x()), above(p.y())};
}

}  // namespace minkref::inline scene
