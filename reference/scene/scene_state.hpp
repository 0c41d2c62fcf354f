// The placed sums of a scene with their stretches: a value that shares what a change leaves alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reference/build/build_control.hpp"
#include "reference/scene/edge_stretches.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/sum_store.hpp"

namespace minkref::inline scene {

/// Copies with equal shapes, scales and places share a placed sum.
class SceneState {
 public:
  SceneState(std::shared_ptr<SumStore> store, std::vector<Copy> copies,
             const BuildOptions& options);

  /// Puts `now` in the place of a copy, behind the last copy, or (none) removes a copy: later
  /// copies move up by one. The others' stretches are shared with this state where the change does
  /// not reach.
  SceneState with(std::uint32_t copy, const std::optional<Copy>& now,
                  const BuildOptions& options) const;

  std::size_t size() const { return copies_.size(); }
  const Copy& copy(std::uint32_t number) const { return *copies_[number]; }
  std::vector<Copy> copies() const;
  const std::shared_ptr<SumStore>& store() const { return store_; }
  const PlacedSums& sums() const { return sums_; }
  /// For each sum, its edges.
  const SceneStretches& stretches() const { return stretches_; }
  const SceneCounts& counts() const { return counts_; }
  /// The copies of each placed sum, ascending.
  std::vector<std::vector<std::uint32_t>> copies_of_sums() const;

 private:
  struct Change;

  void place_all(const BuildOptions& options, const BuildControl& control);
  void find_all(const BuildControl& control);
  void drop_if_unused(std::uint32_t sum, Change& change);
  std::uint32_t number_of(const Copy& copy, Change& change);
  void redo(const Change& change, const BuildControl& control);
  void neighbours_of(std::uint32_t sum, std::vector<std::uint32_t>& result) const;

  std::shared_ptr<SumStore> store_;
  std::vector<std::shared_ptr<const Copy>> copies_;
  std::vector<std::uint32_t> sum_numbers_;  ///< of copies
  PlacedSums sums_;
  std::vector<Box> boxes_;  ///< of sums
  SceneStretches stretches_;
  SceneCounts counts_;
};

}  // namespace minkref::inline scene
