// The sum of a shape at one scale with the reflected robot: edges with their contacts.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/tight_passages.hpp"
#include "reference/scene/scene_convolution.hpp"

namespace minkref::inline scene {

/// Convolution edges that run along edges of a sum, or along parts of them.
struct SumContacts {
  std::vector<ConvolutionEdge> contacts;
  std::vector<std::uint32_t> first;  ///< edge k has those from first[k] to before first[k + 1]

  std::span<const ConvolutionEdge> of(std::uint32_t edge) const {
    return std::span(contacts).subspan(first[edge], first[edge + 1] - first[edge]);
  }
};

/// At the place (0, 0). Rings come first, one after the other; then tight passages, if asked for.
struct SceneSum {
  /// With the sum on its left; of a tight passage with the sum on both sides. From a point to
  /// itself: a tight point.
  struct Edge {
    std::uint32_t from = 0, to = 0;
    std::uint32_t before = 0;  ///< the edge that arrives at `from`; of a passage the edge itself
  };
  /// An empty sum of a shape, by its number in the store.
  SceneSum(std::uint32_t of_shape, Rational at_scale)
      : shape(of_shape), scale(std::move(at_scale)) {}

  std::uint32_t shape;
  Rational scale;
  std::vector<FilteredPoint> points;
  std::vector<Edge> edges;
  std::uint32_t boundary = 0;                             ///< so many edges are of rings
  std::vector<std::vector<ConvolutionEdge>> of_passages;  ///< contacts of the other edges
  BoxTree tree;                                           ///< over the edges, if they are many
  /// Points inside of an edge of the same sum, (edge, point), sorted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> touches;

  void add_ring(std::vector<FilteredPoint> ring);
  void add_passage(const TightPassage& passage);
  /// Fills the tree and the touches: no edges come any more. Exact. O(n log n).
  void finish();

  /// Contacts of all edges, exact; found when first asked for, by `convolution()`: the shape's
  /// convolution. Safe to ask from several threads.
  template <class Convolution>
  const SumContacts& contacts(Convolution&& convolution) const {
    std::call_once(asked_, [&] { contacts_ = find_contacts(convolution()); });
    return contacts_;
  }

 private:
  SumContacts find_contacts(const SceneConvolution& convolution) const;

  mutable std::once_flag asked_;
  mutable SumContacts contacts_;
};

/// A sum moved to its place, ready to be asked for contacts.
struct PlacedSum {
  PlacedSum(std::shared_ptr<const SceneSum> of, const Point& to);

  std::shared_ptr<const SceneSum> sum;
  Point place;
  Box at;  ///< around the place
  std::vector<FilteredPoint> points;
  std::vector<Box> boxes;  ///< of edges
  Box box;

  const FilteredPoint& start(std::uint32_t edge) const { return points[sum->edges[edge].from]; }
  const FilteredPoint& end(std::uint32_t edge) const { return points[sum->edges[edge].to]; }
  bool is_boundary(std::uint32_t edge) const { return edge < sum->boundary; }
  bool is_point(std::uint32_t edge) const { return sum->edges[edge].from == sum->edges[edge].to; }

  /// Calls report(edge) for each edge whose box meets the closed box.
  template <class Report>
  void near(const Box& where, Report&& report) const {
    if (sum->tree.size() != 0) {
      sum->tree.query(reflected(at, where), [&](std::uint32_t edge) {
        if (boxes[edge].overlaps(where)) report(edge);
        return false;
      });
      return;
    }
    for (std::uint32_t edge = 0; edge < boxes.size(); ++edge) {
      if (boxes[edge].overlaps(where)) report(edge);
    }
  }
};

}  // namespace minkref::inline scene
