// The convolution of a shape with the reflected robot, ready to be asked for edges at any scale.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline scene {

/// The reduced convolution of a shape (P) with the reflected robot (Q).
class SceneConvolution {
 public:
  /// `by_wedges`: of the walks around the interiors' wedges, rather than of the rings, where rings
  /// touch (wedge_walks.hpp): then it also holds the passages between wedges.
  SceneConvolution(const PolygonSet& shape, const PolygonSet& reflected_robot,
                   bool by_wedges = false);

 private:
  friend class ContactFinder;
  /// An edge's parents, not scaled.
  struct Parents {
    FilteredPoint from, to, vertex;
  };

  std::vector<ConvolutionEdge> edges_;
  std::vector<Parents> parents_;
};

/// The box of a filtered point, a certain enclosure.
inline Box box_of(const FilteredPoint& p) {
  return {below(p.x()), below(p.y()), above(p.x()), above(p.y())};
}
inline Box box_of(const FilteredPoint& a, const FilteredPoint& b) {
  Box box = box_of(a);
  box.add(box_of(b));
  return box;
}

/// Finds the convolution edges along sides of the sum at one scale.
class ContactFinder {
 public:
  ContactFinder(const SceneConvolution& convolution, const Rational& scale);

  /// Appends the convolution edges that run the same way as a side of the sum and share more than a
  /// point with it, ascending. Exact.
  void add(const FilteredPoint& from, const FilteredPoint& to,
           std::vector<ConvolutionEdge>& contacts);

  /// The same for any stretch, and for edges that run either way; for a point the edges through it.
  void add_sharing(const FilteredPoint& from, const FilteredPoint& to,
                   std::vector<ConvolutionEdge>& contacts);

 private:
  /// Calls take(k) for edges of the sum near a stretch.
  template <class Take>
  void each_near(const FilteredPoint& from, const FilteredPoint& to, Take&& take) const;
  std::pair<FilteredPoint, FilteredPoint> ends(std::uint32_t edge) const;
  bool shares(std::uint32_t edge, const FilteredPoint& from, const FilteredPoint& to) const;

  const SceneConvolution& convolution_;
  Rational scale_;
  BoxTree tree_;
  std::vector<std::uint32_t> found_;
};

}  // namespace minkref::inline scene
