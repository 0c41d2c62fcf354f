// The sums of a scene's shapes at the scales of its copies, each found once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/scene_sum.hpp"

namespace minkref::inline scene {

/// Work since the last change, or all work for a new scene.
struct SceneCounts {
  std::uint64_t copies_redone = 0;  ///< whose edges met the old or the new placed sum
  std::uint64_t edges_redone = 0;
  std::uint64_t sums_evaluated = 0;  ///< of a shape at a scale
  std::uint64_t indices_built = 0;   ///< of shapes with many scales
};

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

  /// Read off the shape's index, if its window has the scale; else found by the static route. Kept
  /// as long as somebody else keeps it. Counts in `evaluated` a sum found anew.
  std::shared_ptr<const SceneSum> sum(const Key& key, std::uint64_t& evaluated);

  /// The sums of distinct keys. A shape with many scales first gets an index of all sums between
  /// its least and its greatest one, which saves as many arrangements.
  std::vector<std::shared_ptr<const SceneSum>> sums(const std::vector<Key>& keys,
                                                    const BuildOptions& options,
                                                    SceneCounts& counts);

  /// The contacts of a sum's edges; found when they are first asked for.
  const SumContacts& contacts(const SceneSum& sum);

 private:
  void build_indices(const std::vector<Key>& keys, const BuildOptions& options,
                     const BuildControl& control, SceneCounts& counts);
  const SceneConvolution& convolution(std::uint32_t shape);
  std::shared_ptr<const SceneSum> found_sum(const Key& key) const;
  void forget_unused();

  static constexpr std::size_t many_scales = 200;  ///< so many static sums cost more than an index

  PolygonSet robot_, reflected_;
  std::vector<PolygonSet> shapes_;
  bool passages_;
  std::vector<std::uint32_t> same_;
  std::vector<std::optional<ScaleIndex>> indices_;
  std::mutex mutex_;
  std::vector<std::optional<SceneConvolution>> convolutions_;
  std::map<Key, std::weak_ptr<const SceneSum>> sums_;
  std::size_t kept_ = 0;
};

}  // namespace minkref::inline scene
