// The nodes along every convolution edge, at any place of a timeline.
#pragma once

#include <span>

#include "reference/plane/dynamic/arrangement_timeline.hpp"

namespace minkref::inline plane {

/// How often nodes were inserted, deleted and swapped with a neighbour; a node that has just come
/// is not swapped but settles among those in its place.
struct ChangeCounts {
  std::uint64_t insertions = 0, deletions = 0, swaps = 0;
};

/// Lists that are kept while one steps through a timeline in both directions, change by change. A
/// long way is cut short: whole lists stand ready every so many changes, and the walk begins at the
/// nearest. Place p is after p steps.
class NodeLists {
 public:
  /// At place 0. `timeline` must outlive it. O(changes) and the snapshots, for which there are 64
  /// MiB, or as many bytes as the changes have where that is more.
  explicit NodeLists(const ArrangementTimeline& timeline);

  std::uint32_t place() const { return place_; }
  /// The changes on the way, as if one had walked it. O(min(changes on the way, slots)).
  ChangeCounts move_to(std::uint32_t place);

  /// In their order; valid until the next move.
  std::span<const std::uint32_t> along(std::uint32_t edge) const {
    return {slots_.data() + first_slot_[edge], length_[edge]};
  }
  std::size_t edges() const { return length_.size(); }
  /// Over all edges.
  std::size_t size() const { return initial_size_ + counts_.insertions - counts_.deletions; }

 private:
  struct Snapshot {
    std::uint32_t place = 0;
    ChangeCounts before;                       ///< since place 0
    std::vector<std::uint32_t> length, slots;  ///< as below
  };
  void allot();
  void take_snapshots();
  std::size_t spacing() const;
  std::size_t load_cost() const;
  void load(const Snapshot& snapshot);
  void walk(std::uint32_t place);
  void insert(std::uint32_t node, std::uint32_t rank);
  void erase(std::uint32_t node, std::uint32_t rank);
  const Snapshot& nearest(std::uint32_t place) const;
  ChangeCounts counts_at(std::uint32_t place) const;
  std::size_t distance(std::uint32_t a, std::uint32_t b) const;

  const ArrangementTimeline& timeline_;
  std::vector<std::uint32_t> slots_;       ///< each edge has as many as it ever has nodes
  std::vector<std::uint32_t> first_slot_;  ///< of each edge
  std::vector<std::uint32_t> length_;
  std::size_t initial_size_ = 0;  ///< at place 0
  std::uint32_t place_ = 0;
  ChangeCounts counts_;  ///< from place 0 to here
  std::vector<Snapshot> snapshots_;
};

}  // namespace minkref::inline plane
