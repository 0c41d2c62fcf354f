// The critical regions of all pairs of edges (Behar & Lien 2012, Sec. 4.2.3), by several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/build/in_parallel.hpp"
#include "reference/interrupt.hpp"
#include "reference/paper/plane/critical_regions.hpp"
#include "reference/paper/row_control.hpp"
#include "reference/plane/convolution/convolution_segments.hpp"

namespace minkref::inline plane {

template <class T>
struct RegionList {
  std::vector<CriticalRegion<T>> regions;  ///< by a, then by b
  std::uint64_t pairs = 0;                 ///< that were looked at
  std::uint64_t undecided = 0;             ///< that were left out: a sign was NaN
};

namespace detail {

/// The pairs of an edge with all later edges.
template <class T>
class RegionRow {
 public:
  RegionRow(const std::vector<MovingEdge<Vector2<T>>>& edges,
            const std::vector<PlacedEdge<T>>& placed, const std::vector<IndexedSegment>& segments,
            const Readings& readings, const T& zero)
      : edges_(edges), placed_(placed), segments_(segments), readings_(readings), zero_(zero) {}

  RegionList<T> find(std::uint32_t a) const {
    RegionList<T> row;
    for (std::uint32_t b = a + 1; b < edges_.size(); ++b) {
      if (!readings_.adjacent && share_vertex(a, b)) continue;
      ++row.pairs;
      try {
        add(a, b, row);
      } catch (const UndecidedSign&) {
        if constexpr (std::is_same_v<T, Interval>) throw;
        ++row.undecided;
      }
    }
    return row;
  }

 private:
  void add(std::uint32_t a, std::uint32_t b, RegionList<T>& row) const {
    const bool parallel = kernel_.turn(edges_[a].d, edges_[b].d) == 0;
    if (parallel && !readings_.parallel) return;
    auto region = parallel ? parallel_region(kernel_, edges_[a], edges_[b])
                           : critical_region<T>(placed_[a], placed_[b], readings_, zero_);
    if (!region) return;
    region->a = a;
    region->b = b;
    row.regions.push_back(std::move(*region));
  }

  bool share_vertex(std::uint32_t a, std::uint32_t b) const {
    const IndexedSegment &s = segments_[a], &t = segments_[b];
    return s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
  }

  const PlainKernel<T> kernel_;  ///< it counts, so each thread has one
  const std::vector<MovingEdge<Vector2<T>>>& edges_;
  const std::vector<PlacedEdge<T>>& placed_;
  const std::vector<IndexedSegment>& segments_;
  const Readings& readings_;
  const T& zero_;
};

}  // namespace detail

/// The critical regions of all pairs of edges, as read; `segments` are the same edges by their
/// vertices. The list is the same whatever the number of threads. `zero`: the tolerance below which
/// numbers count as zero. Throws LimitExceeded beyond `memory` bytes (0: no limit), UndecidedSign
/// if an interval cannot tell a sign. O(N^2) for N edges.
template <class T>
RegionList<T> find_regions(const std::vector<MovingEdge<Vector2<T>>>& edges,
                           const std::vector<IndexedSegment>& segments, const Readings& readings,
                           const T& zero, unsigned threads, std::uint64_t memory) {
  const std::vector<PlacedEdge<T>> placed(edges.begin(), edges.end());
  std::vector<RegionList<T>> rows(edges.size());
  RowControl control{threads, memory, "the list of critical regions"};
  in_parallel(edges.size(), 4, control, [&](unsigned) {
    return [&, row = detail::RegionRow<T>(edges, placed, segments, readings, zero)](std::size_t a) {
      rows[a] = row.find(static_cast<std::uint32_t>(a));
    };
  });
  RegionList<T> all;
  std::size_t count = 0;
  for (const RegionList<T>& row : rows) count += row.regions.size();
  all.regions.reserve(count);
  for (RegionList<T>& row : rows) {
    look_for_interrupt();
    all.pairs += row.pairs;
    all.undecided += row.undecided;
    for (CriticalRegion<T>& region : row.regions) all.regions.push_back(std::move(region));
    row = {};
  }
  return all;
}

}  // namespace minkref::inline plane
