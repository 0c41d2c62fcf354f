#include "reference/disc/convolution/arc_cuts.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {
namespace {

/// A node on a span.
struct ArcCut {
  Interval key;  ///< how far along
  std::uint32_t node;
};

class ArcCutter {
 public:
  ArcCutter(const ArcCurves& curves, OffsetCounts& counts)
      : curves_(curves), counts_(counts), nodes_(curves), cuts_(curves.spans.size()) {}

  CutArcs run() {
    std::vector<plane::Box> boxes;
    for (std::uint32_t k = 0; k < curves_.spans.size(); ++k) {
      const ArcSpan& span = curves_.spans[k];
      // The span is a segment, or an arc within one quadrant.
      plane::Box box = box_of(nodes_.position(span.from));
      box.add(box_of(nodes_.position(span.to)));
      boxes.push_back(box);
      add_cut(k, span.from);
      add_cut(k, span.to);
    }
    plane::BoxTree(std::move(boxes)).pairs([&](std::uint32_t a, std::uint32_t b) { cross(a, b); });
    join_nodes();
    std::vector<ArcPiece> pieces;
    for (std::uint32_t k = 0; k < cuts_.size(); ++k) add_pieces(k, pieces);
    return {std::move(nodes_), std::move(pieces)};
  }

 private:
  const ArcCarrier& carrier(const ArcSpan& span) const { return curves_.carriers[span.carrier]; }

  /// Grows along a span: for an arc, measured across the quadrant's middle.
  template <class N>
  N key(const ArcSpan& span, const Vector<N>& x) const {
    const ArcCarrier& own = carrier(span);
    if (!own.is_circle) return dot(numbers<N>(own.way), x);
    const Vector<N> y = x - numbers<N>(own.centre);
    switch (span.quadrant) {
      case 0:
        return y.y - y.x;
      case 1:
        return -(y.x + y.y);
      case 2:
        return y.x - y.y;
      default:
        return y.x + y.y;
    }
  }

  void add_cut(std::uint32_t span, std::uint32_t node) {
    cuts_[span].push_back({key(curves_.spans[span], nodes_.position(node)), node});
  }

  /// Whether a carrier's point lies on a span or at an end; nothing if intervals leave this open.
  template <class N>
  std::optional<bool> is_on(const ArcSpan& span, const Vector<N>& x) const {
    const auto signs = [&]() -> std::pair<N, N> {
      const ArcCarrier& own = carrier(span);
      if constexpr (std::is_same_v<N, Interval>) {
        if (!own.is_circle) {
          const N t = dot(own.near_way, x);
          return {t - span.near_low, span.near_high - t};
        }
        const Vector<N> y = x - own.near_point;
        return {disc::cross(span.near_first, y), disc::cross(y, span.near_last)};
      } else {
        if (!own.is_circle) {
          const N t = dot(numbers<N>(own.way), x);
          return {t - span.low, span.high - t};
        }
        const Vector<N> y = x - numbers<N>(own.centre);
        return {disc::cross(numbers<N>(span.first), y), disc::cross(y, numbers<N>(span.last))};
      }
    }();
    if constexpr (std::is_same_v<N, Interval>) {
      const std::optional<int> from = certified_sign(signs.first),
                               to = certified_sign(signs.second);
      if (from.value_or(0) < 0 || to.value_or(0) < 0) return false;
      return from && to ? std::optional(true) : std::nullopt;
    } else {
      return sign(signs.first) >= 0 && sign(signs.second) >= 0;
    }
  }

  static bool is_within(const ArcSpan& arc, const Direction& d) {
    return disc::cross(arc.first, d) >= 0 && disc::cross(d, arc.last) >= 0;
  }
  bool is_within(const ArcSpan& span, const Direction& d, const Point& centre) const {
    if (carrier(span).is_circle) return is_within(span, d);
    const Rational t = dot(carrier(span).way, {centre.x, centre.y});
    return span.low <= t && t <= span.high;
  }

  void touch(std::uint32_t a, std::uint32_t b, const CarrierCrossings::Touch& touch) {
    const ArcSpan &first = curves_.spans[a], &second = curves_.spans[b];
    const std::uint32_t circle = carrier(first).is_circle ? first.carrier : second.carrier;
    const Point& centre = curves_.carriers[circle].centre;
    if (!is_within(first, touch.of_first, centre) || !is_within(second, touch.of_second, centre)) {
      return;
    }
    const std::uint32_t node =
        nodes_.joint(circle, carrier(first).is_circle ? touch.of_first : touch.of_second);
    add_cut(a, node);
    add_cut(b, node);
  }

  void cross(std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    const ArcSpan &first = curves_.spans[a], &second = curves_.spans[b];
    if (first.carrier == second.carrier) return;
    ++counts_.pairs;
    const CarrierCrossings met = nodes_.meet(first.carrier, second.carrier);
    if (met.touch) touch(a, b, *met.touch);
    for (const ArcNode& each : met.crossings) {
      const Vector<Interval> near = nodes_.place<Interval>(each);
      std::optional<bool> on_first = is_on(first, near), on_second = is_on(second, near);
      if (on_first == false || on_second == false) continue;
      if (!on_first || !on_second) {
        ++counts_.exact_pairs;
        const RootPoint x = nodes_.place<RootNumber>(each);
        if (!*is_on(first, x) || !*is_on(second, x)) continue;
      }
      const std::uint32_t node = nodes_.add(each, near);
      add_cut(a, node);
      add_cut(b, node);
    }
  }

  /// Replaces nodes at the same place by the first.
  void join_nodes() {
    std::vector<plane::Box> boxes;
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) boxes.push_back(box_of(nodes_.position(k)));
    DisjointSets same(nodes_.size());
    plane::BoxTree(std::move(boxes)).pairs([&](std::uint32_t a, std::uint32_t b) {
      if (same.root(a) == same.root(b)) return;
      ++counts_.exact_orders;
      if (nodes_.are_same(a, b)) same.join(a, b);
    });
    std::vector<std::uint32_t> first(nodes_.size(), OffsetPatch::none);
    for (std::uint32_t k = 0; k < nodes_.size(); ++k) {
      std::uint32_t& own = first[same.root(k)];
      if (own == OffsetPatch::none) own = k;
    }
    for (std::vector<ArcCut>& cuts : cuts_) {
      for (ArcCut& cut : cuts) cut.node = first[same.root(cut.node)];
    }
  }

  bool comes_before(const ArcSpan& span, const ArcCut& a, const ArcCut& b) const {
    if (a.node == b.node) return false;
    if (a.key.upper() < b.key.lower()) return true;
    if (a.key.lower() > b.key.upper()) return false;
    ++counts_.exact_orders;
    return compare(key(span, nodes_.exact(a.node)), key(span, nodes_.exact(b.node))) < 0;
  }

  void add_pieces(std::uint32_t number, std::vector<ArcPiece>& pieces) {
    look_for_interrupt();
    const ArcSpan& span = curves_.spans[number];
    std::vector<ArcCut>& cuts = cuts_[number];
    const std::uint32_t first = cuts[0].node, last = cuts[1].node;
    std::sort(cuts.begin(), cuts.end(),
              [&](const ArcCut& a, const ArcCut& b) { return comes_before(span, a, b); });
    if (cuts.front().node != first || cuts.back().node != last) {
      throw std::logic_error("a curve is cut beyond its ends");
    }
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      const std::uint32_t from = cuts[k - 1].node, to = cuts[k].node;
      if (from != to) pieces.push_back({number, from, to, from == first, to == last});
    }
  }

  const ArcCurves& curves_;
  OffsetCounts& counts_;
  ArcNodes nodes_;
  std::vector<std::vector<ArcCut>> cuts_;  ///< by span, its ends first
};

}  // namespace

CutArcs cut_arcs(const ArcCurves& curves, OffsetCounts& counts) {
  return ArcCutter(curves, counts).run();
}

}  // namespace minkref::inline disc
