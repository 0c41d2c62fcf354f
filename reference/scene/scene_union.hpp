// The union of the placed sums of a scene, where the robot meets an obstacle (Behar & Lien 2012,
// Sec. 8.1), and what a change of a copy does to it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "reference/build/build_options.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/scene/free_components.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/scene_boundary.hpp"
#include "reference/scene/scene_state.hpp"

namespace minkref::inline scene {

/// A value: a change makes a new value, and both share all unchanged parts. Safe to ask from
/// several threads at once. Exact. For a robot without area the obstacles are merged first: boxes
/// that abut leave it no seam.
class SceneUnion {
 public:
  /// Robot and shapes must have passed `validate`. Without `passages` there are no tight passages
  /// to ask for. Throws BadInput ("bad-scale", "no-shape", "no-area"), LimitExceeded
  /// ("memory-limit"). Cost: each sum once for each scale of its shape, then each edge of a placed
  /// sum against the edges of others near it, by several threads.
  explicit SceneUnion(Scene scene, bool passages = false, const BuildOptions& options = {});

  /// The scene after a change of one copy, which takes the time of the edges near the old and the
  /// new placed sum. Throw as the constructor, and BadInput ("no-copy").
  SceneUnion changed(std::uint32_t copy, const Rational& scale, const Point& place,
                     const BuildOptions& options = {}) const;
  SceneUnion added(const Copy& copy, const BuildOptions& options = {}) const;
  /// Later copies move up by one.
  SceneUnion removed(std::uint32_t copy, const BuildOptions& options = {}) const;

  std::vector<Copy> copies() const;
  const PolygonSet& robot() const;
  const std::vector<PolygonSet>& shapes() const;

  /// The canonical form of the union. Found when first asked for, in O(b log b) for b stretches of
  /// the boundary, and kept.
  const Canonical& region() const;

  /// For each ring of region() (outer ring, holes, outer ring, holes, ...) and each side, from a
  /// vertex to the next: the owners of the side or of a part of it, sorted.
  const std::vector<RingOwners>& owners() const;

  /// The tight passages: the closure of the union's interior less the union of the open sums, as
  /// tight_passages gives them. Throws BadInput ("no-passages") if the scene was made without.
  const std::vector<ScenePassage>& passages() const;

  /// Finds the free components, by of_passage also for each of passages(). With contact allowed
  /// throws as passages(). O(n log n + h k) as free_components.
  FreeComponents components(ContactRule rule) const;

  /// The placed sum of a copy in canonical form. Throws BadInput ("no-copy").
  Canonical sum_of(std::uint32_t copy) const;

  const SceneCounts& counts() const { return counts_; }

 private:
  struct Kept;
  SceneUnion(SceneState state, std::shared_ptr<const SceneUnion> obstacles);
  static SceneUnion of(Scene scene, bool passages, const BuildOptions& options);
  static SceneUnion of(const PolygonSet& robot, std::vector<PolygonSet> shapes,
                       std::vector<Copy> copies, bool passages, const BuildOptions& options);
  static SceneUnion beside_segment(SceneUnion obstacles, const PolygonSet& robot, bool passages,
                                   const BuildOptions& options);
  void require_copy(std::uint32_t copy) const;
  SceneUnion with(std::uint32_t copy, const std::optional<Copy>& now,
                  const BuildOptions& options) const;
  std::uint32_t size() const;
  const Copy& copy(std::uint32_t number) const;
  const SceneBoundary& boundary() const;
  const SceneTightGraph& tight() const;
  const ScenePassages& pieces() const;
  AddOwners owners_of_edges() const;
  template <class Take>
  void each_contact(std::uint32_t number, std::uint32_t edge, const Point& from, const Point& to,
                    const Copy& copy, Take&& take) const;

  std::shared_ptr<const SceneState> state_;
  /// Beside a segment: the union of the placed shapes, whose components are the copies of `state_`.
  std::shared_ptr<const SceneUnion> obstacles_;
  SceneCounts counts_;
  std::shared_ptr<Kept> kept_;
};

}  // namespace minkref::inline scene
