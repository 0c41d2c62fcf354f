// The contacts of a robot with single copies along a stretch of the union, by the copies' own
// convolutions: for a robot without area, whose obstacles were merged.
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/scene_convolution.hpp"

namespace minkref::inline scene {

/// Copies ready to be asked by one thread.
class CopyContacts {
 public:
  /// Shapes and the reflected robot must outlive it.
  CopyContacts(const std::vector<PolygonSet>& shapes, const PolygonSet& reflected_robot,
               std::vector<Copy> copies);

  /// Appends as owners all convolution edges of copies that share more than a point with a stretch
  /// of the union's boundary or of its tight passages; that contain it, if it is a point. Exact.
  void add(const Point& from, const Point& to, std::vector<Owner>& owners);

 private:
  ContactFinder& finder(const Copy& copy);

  const std::vector<PolygonSet>& shapes_;
  const PolygonSet& reflected_;
  std::vector<Copy> copies_;
  BasicBoxTree<Box> tree_;  ///< over the copies' sums
  std::map<std::uint32_t, SceneConvolution> convolutions_;
  std::map<std::pair<std::uint32_t, Rational>, ContactFinder> finders_;
};

}  // namespace minkref::inline scene
