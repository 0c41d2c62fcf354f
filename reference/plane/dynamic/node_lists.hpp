// The nodes along every convolution edge, at any place of a timeline.
#pragma once

#include <span>

#include "reference/plane/dynamic/arrangement_timeline.hpp"

namespace minkref::inline plane {

/// Counts of node insertions, deletions and swaps with a neighbour; a new node does not swap but
/// settles among the nodes at its place.
struct ChangeCounts {
  std::uint64_t insertions = 0, deletions = 0, swaps = 0;
};

/// Lists that follow steps through a timeline both ways, change by change. Snapshots of whole
/// lists, taken at regular intervals of changes, shorten a long way: the walk begins at the
/// nearest. Place p comes after p steps.
class NodeLists {
 public:
  /// Starts at place 0. `timeline` must outlive the lists. O(changes) plus the snapshots, which may
  /// take 64 MiB, or as many bytes as the changes if more.
  explicit NodeLists(const ArrangementTimeline& timeline);

  std::uint32_t place() const { return place_; }
  /// The changes on the way, as if counted by a walk. An interrupt leaves the place as it was.
  /// O(min(changes on the way, slots)).
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
