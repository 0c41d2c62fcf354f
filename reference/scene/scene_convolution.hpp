// The convolution of a shape with the reflected robot, ready to be asked for edges at any scale.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/convolution/convolution.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline scene {

/// The reduced convolution of a shape (P) with the reflected robot (Q).
class SceneConvolution {
 public:
  /// Both must outlive it.
  SceneConvolution(const PolygonSet& shape, const PolygonSet& reflected_robot);

  const PolygonSet& shape() const { return shape_; }
  const PolygonSet& reflected_robot() const { return reflected_; }

 private:
  friend class ContactFinder;
  /// An edge's parents, not scaled.
  struct Parents {
    FilteredPoint from, to, vertex;
  };

  const PolygonSet &shape_, &reflected_;
  std::vector<ConvolutionEdge> edges_;
  std::vector<Parents> parents_;
};

/// Finds the convolution edges along sides of the sum at one scale.
class ContactFinder {
 public:
  ContactFinder(const SceneConvolution& convolution, const Rational& scale);

  /// Appends the convolution edges that run the same way as a side of the sum and share more than a
  /// point with it, ascending. Exact.
  void add(const FilteredPoint& from, const FilteredPoint& to,
           std::vector<ConvolutionEdge>& contacts);

 private:
  bool shares(std::uint32_t edge, const FilteredPoint& from, const FilteredPoint& to) const;

  const SceneConvolution& convolution_;
  const Rational& scale_;
  BoxTree tree_;
  std::vector<std::uint32_t> found_;
};

}  // namespace minkref::inline scene
