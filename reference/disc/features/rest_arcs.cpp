#include "reference/disc/features/rest_arcs.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/scalar.hpp"

namespace minkref::inline disc {
namespace {

Vector<Interval> intervals(const RootPoint& p) { return {p.x.enclosure(), p.y.enclosure()}; }

}  // namespace

RestArcs::RestArcs(const RegionOutlines& outlines)
    : outlines_(outlines), squared_(outlines.regions().radius.squared.value()) {
  const DiscIndex& index = outlines.index();
  const DiagramGraph& graph = index.graph();
  const auto& features = index.diagram().curves.features;
  for (const CornerBridge& corner : outlines.corners()) {
    rounded_.push_back(intervals(*corner.corner));
    const DiagramHalf& half = graph.halves[corner.half];
    Features near{half.feature, graph.halves[half.twin].feature};
    const bool is_event = outlines.regions().radius.at_event && graph.is_event(half.to) &&
                          index.high(corner.half) == outlines.regions().radius.level + 1;
    if (is_event) near = index.diagram().events[half.to].features;
    upper_.push_back(is_event ? half.to : DiagramGraph::none);
    std::erase_if(near, [&](std::uint32_t k) { return features[k].edge != OffsetPatch::none; });
    std::sort(near.begin(), near.end());
    touched_.push_back(std::move(near));
  }
  exact_.resize(rounded_.size());
}

template <class N>
const Vector<N>& RestArcs::centre(std::uint32_t corner) {
  if constexpr (std::is_same_v<N, Interval>) {
    return rounded_[corner];
  } else {
    if (!exact_[corner]) exact_[corner] = outlines_.surd_corner(corner);
    return *exact_[corner];
  }
}

/// A number's sign, from double intervals or roots.
template <class Of>
int RestArcs::decided(Of&& of) {
  if (const auto certain = certified_sign(of(Interval()))) return *certain;
  return sign(of(Surd()));
}

bool RestArcs::are_one_circle(std::uint32_t a, std::uint32_t b) const {
  return upper_[a] != DiagramGraph::none && upper_[a] == upper_[b];
}

std::uint32_t RestArcs::shared_foot(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t vertex : touched_[a]) {
    if (std::binary_search(touched_[b].begin(), touched_[b].end(), vertex)) return vertex;
  }
  return DiagramGraph::none;
}

bool RestArcs::is_vertex_foot(std::uint32_t corner, std::uint32_t vertex, bool at_start) const {
  const std::vector<DiagramHalf>& halves = outlines_.index().graph().halves;
  const DiagramHalf& half = halves[outlines_.corners()[corner].half];
  return (at_start ? half.feature : halves[half.twin].feature) == vertex;
}

/// Where a cover starts or ends, from the centre.
template <class N>
Vector<N> RestArcs::place(std::uint32_t corner, const Cover& cover, bool at_start) {
  const OffsetCurves& curves = outlines_.index().diagram().curves;
  // A free arc ends where a cover starts.
  return arc_end(curves, cover.end(), centre<N>(corner), centre<N>(cover.other), N(squared_),
                 N(Rational(1, 2)), !at_start);
}

/// Finds the part covered from a further corner. Discs cover neither foot, so each covers a part
/// inside the arc, or nothing, as the centre's direction tells.
std::optional<RestArcs::Cover> RestArcs::cover_of(std::uint32_t corner, std::uint32_t other) {
  if (are_one_circle(corner, other)) return std::nullopt;
  const auto way = [&]<class N>(const N&) { return centre<N>(other) - centre<N>(corner); };
  const auto to_foot = [&]<class N>(const N&, bool at_start) {
    if constexpr (std::is_same_v<N, Interval>) {
      const Chord<RootNumber>& own = outlines_.corners()[corner].chord;
      return intervals(at_start ? own.from : own.to) - centre<N>(corner);
    } else {
      const Chord<Surd> own = outlines_.surd_chord(corner);
      return (at_start ? own.from : own.to) - centre<N>(corner);
    }
  };
  const std::uint32_t vertex = shared_foot(corner, other);
  const int near = vertex != DiagramGraph::none ? 1 : decided([&]<class N>(const N& n) {
    const Vector<N> w = way(n);
    return N(Rational(4 * squared_)) - dot(w, w);
  });
  if (near < 0) return std::nullopt;
  const bool is_behind =
      decided([&](const auto& n) { return cross(to_foot(n, true), way(n)); }) > 0 &&
      decided([&](const auto& n) { return cross(way(n), to_foot(n, false)); }) > 0;
  if (!is_behind) return std::nullopt;
  if (near > 0) overlaps_.emplace_back(corner, other);
  Cover cover{other, false, false, near == 0, vertex};
  for (const std::uint32_t shared : touched_[corner]) {
    if (!std::binary_search(touched_[other].begin(), touched_[other].end(), shared)) continue;
    cover.from_foot |= is_vertex_foot(corner, shared, true);
    cover.to_foot |= is_vertex_foot(corner, shared, false);
  }
  return cover;
}

/// Along an arc below half a turn.
int RestArcs::order(std::uint32_t corner, const Cover& a, bool a_start, const Cover& b,
                    bool b_start) {
  const auto rank = [](const Cover& cover, bool start) {
    if (start) return cover.from_foot ? -1 : 0;
    return cover.to_foot ? 1 : 0;
  };
  const int of_a = rank(a, a_start), of_b = rank(b, b_start);
  if (of_a != 0 || of_b != 0) return of_a - of_b;
  return -decided([&]<class N>(const N&) {
    return cross(place<N>(corner, a, a_start), place<N>(corner, b, b_start));
  });
}

/// Adds the arc without covers.
void RestArcs::add_free(std::uint32_t corner, std::vector<Cover> covers,
                        std::vector<FreeArc>& found) {
  std::sort(covers.begin(), covers.end(),
            [&](const Cover& a, const Cover& b) { return order(corner, a, true, b, true) < 0; });
  ArcEnd last;  // behind the covers so far
  std::optional<Cover> first, farthest;
  for (const Cover& cover : covers) {
    const int gap = farthest ? order(corner, cover, true, *farthest, false) : 1;
    if (gap > 0) {
      if (farthest || !cover.from_foot) found.push_back({corner, last, cover.end()});
      first = farthest = cover;
      last = cover.end();
      continue;
    }
    // Several covers may start together, behind a free arc.
    if (order(corner, cover, true, *first, true) == 0 && !cover.from_foot) {
      found.back().to.with.push_back(cover.other);
    }
    const int further = order(corner, cover, false, *farthest, false);
    if (further > 0) {
      farthest = cover;
      last = cover.end();
    } else if (further == 0) {
      last.with.push_back(cover.other);
    }
  }
  if (!farthest || !farthest->to_foot) found.push_back({corner, last, {}});
}

std::vector<FreeArc> RestArcs::of(const std::vector<std::uint32_t>& corners) {
  // From left to right: discs meet only if the centres are less than two radii apart.
  std::vector<std::uint32_t> sorted = corners;
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t a, std::uint32_t b) {
    return rounded_[a].x.lower() < rounded_[b].x.lower();
  });
  const Interval reach = sqrt(Interval(Rational(4 * squared_)));
  std::vector<std::vector<Cover>> covers(sorted.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    for (std::size_t other = k + 1; other < sorted.size(); ++other) {
      look_for_interrupt();
      const Interval apart = rounded_[sorted[other]].x - rounded_[sorted[k]].x - reach;
      if (apart.lower() > 0) break;
      if (const auto cover = cover_of(sorted[k], sorted[other])) covers[k].push_back(*cover);
      if (const auto cover = cover_of(sorted[other], sorted[k])) covers[other].push_back(*cover);
    }
  }
  std::vector<FreeArc> found;
  for (std::size_t k = 0; k < sorted.size(); ++k) add_free(sorted[k], std::move(covers[k]), found);
  return found;
}

}  // namespace minkref::inline disc
