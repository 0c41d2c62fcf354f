// The largest disc that gets from one place to another, or away, among obstacles.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/disc/clearance/disc_on_path.hpp"
#include "reference/disc/index/disc_index.hpp"

namespace minkref::inline disc {

/// How large a disc may be that gets from a place to another one, or to infinity.
struct DiscPassage {
  enum class Limit : std::uint8_t {
    apart,  ///< no disc gets there: a place is not outside of the obstacles, or in another
            ///< component
    start,  ///< the disc of that radius touches where it starts
    end,    ///< where it is to go
    neck    ///< between two features on the way
  };
  Limit limit = Limit::apart;
  /// At the places, if outside of the obstacles: the largest disc there.
  std::optional<DiscOnPath> at_start, at_end;
  /// The necks on a best way, in order: numbers of events, all of one radius. Each is an entrance
  /// of a saddle or of a flat ridge.
  std::vector<std::uint32_t> necks;
};

/// Answers for the largest radius ρ at which two places lie in one component of the places that are
/// as far as ρ from a set, or farther: a bottleneck of the outer Voronoi diagram. Exact. Reasons:
/// docs/paths.md.
class DiscRooms {
 public:
  /// The obstacles: a valid polygon set, a point or a segment, which must outlive the rooms. Errors
  /// and cost as for DiscIndex.
  explicit DiscRooms(const PolygonSet& obstacles, const BuildOptions& options = {});

  const DiscIndex& index() const { return index_; }
  /// The passage to `to`, or away to infinity. O(n log n).
  DiscPassage passage(const Point& from, const std::optional<Point>& to) const;

 private:
  std::uint32_t above(const Point& place, const DiscOnPath& largest) const;
  int order_on_half(const DiagramHalf& half, bool at_end, const Point& foot,
                    const Point& place) const;
  void check_is_free_beyond(const Point& foot, const Point& place) const;
  std::uint32_t infinity() const { return nodes_; }
  std::uint32_t number(std::uint32_t node) const;

  const PolygonSet& obstacles_;
  DiscIndex index_;
  std::uint32_t nodes_;                             ///< infinity is one more
  std::vector<std::vector<std::uint32_t>> joined_;  ///< other nodes, by node
};

}  // namespace minkref::inline disc
