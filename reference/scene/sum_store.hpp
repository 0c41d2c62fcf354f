// The sums of a scene's shapes at the scales of its copies, each found once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/scene_sum.hpp"

namespace minkref::inline scene {

/// Shared by all scenes with the same robot and shapes; safe to ask from several threads.
class SumStore {
 public:
  /// Throws BadInput ("no-area") for a shape without area beside a robot without.
  SumStore(PolygonSet robot, std::vector<PolygonSet> shapes, bool passages);

  const PolygonSet& robot() const { return robot_; }
  const PolygonSet& reflected_robot() const { return reflected_; }
  const std::vector<PolygonSet>& shapes() const { return shapes_; }
  bool passages() const { return passages_; }

  /// The first shape with the same rings.
  std::uint32_t shape(std::uint32_t number) const { return same_[number]; }

  /// A shape, and its scale.
  using Key = std::pair<std::uint32_t, Rational>;

  /// Kept as long as somebody else keeps it. Counts in `evaluated` a sum found anew.
  std::shared_ptr<const SceneSum> sum(const Key& key, std::uint64_t& evaluated);

  /// The sums of distinct keys.
  std::vector<std::shared_ptr<const SceneSum>> sums(const std::vector<Key>& keys,
                                                    const BuildControl& control,
                                                    std::uint64_t& evaluated);

 private:
  const std::vector<ConvolutionEdge>& convolution(std::uint32_t shape);
  void forget_unused();

  PolygonSet robot_, reflected_;
  std::vector<PolygonSet> shapes_;
  bool passages_;
  std::vector<std::uint32_t> same_;
  std::mutex mutex_;
  std::vector<std::optional<std::vector<ConvolutionEdge>>> convolutions_;
  std::map<Key, std::weak_ptr<const SceneSum>> sums_;
  std::size_t kept_ = 0;
};

}  // namespace minkref::inline scene
