// Where an offset curve crosses the boundary of the points nearer to an edge than the radius.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/disc/curves/patch_numbers.hpp"

namespace minkref::inline disc {

/// Half a circle about an end of the edge, or a side parallel to the edge.
enum class NearCurve : std::uint8_t { start, end, outside, inside };

template <class N>
struct Crossing {
  N key;  ///< how far along the patch
  Vector<N> point;
  NearCurve curve;
  std::int8_t way;  ///< which of two
  /// For an arc, which runs counter-clockwise: whether it enters the nearer points.
  bool enters;
  /// The curves only touch, from outside: the edge is right across.
  bool touches = false;
};

/// The crossings of one patch, or of the patch's whole line or circle, with the boundary of the
/// points near one edge. Signs use N: intervals may throw UndecidedSign.
template <class N>
class PatchCrossings {
 public:
  PatchCrossings(const N& squared_radius, const EdgeNumbers<N>& by)
      : squared_radius_(squared_radius), by_(by) {}

  /// Adds the crossings along an edge's line. `has_start`, `has_end`: whether the edge ends at the
  /// start, the end of the other edge.
  void add_of_line(const EdgeNumbers<N>& own, bool has_start, bool has_end);
  void add_of_arc(const ArcNumbers<N>& arc);

  const std::vector<Crossing<N>>& found() const { return found_; }

 private:
  void add_circle(const EdgeNumbers<N>& own, NearCurve which);
  void add_circle(const ArcNumbers<N>& arc, NearCurve which);
  void add_line(const EdgeNumbers<N>& own, NearCurve which);
  void add_line(const ArcNumbers<N>& arc, NearCurve which);
  const Vector<N>& end(NearCurve which) const {
    return which == NearCurve::end ? by_.end : by_.start;
  }
  bool is_beyond(const Vector<N>& x, NearCurve which) const {
    const int foot = sign(dot(by_.along, x - end(which)));
    return which == NearCurve::end ? foot >= 0 : foot <= 0;
  }
  bool is_beside(const Vector<N>& x) const {
    const N foot = dot(by_.along, x - by_.start);
    return sign(foot) >= 0 && sign(foot - by_.squared_length) <= 0;
  }

  const N& squared_radius_;
  const EdgeNumbers<N>& by_;
  std::vector<Crossing<N>> found_;
};

template <class N>
void PatchCrossings<N>::add_of_line(const EdgeNumbers<N>& own, bool has_start, bool has_end) {
  // A circle about an end of the patch's own edge touches the patch's line.
  if (!has_start) add_circle(own, NearCurve::start);
  if (!has_end) add_circle(own, NearCurve::end);
  add_line(own, NearCurve::outside);
  add_line(own, NearCurve::inside);
}

template <class N>
void PatchCrossings<N>::add_of_arc(const ArcNumbers<N>& arc) {
  add_circle(arc, NearCurve::start);
  add_circle(arc, NearCurve::end);
  add_line(arc, NearCurve::outside);
  add_line(arc, NearCurve::inside);
}

template <class N>
void PatchCrossings<N>::add_circle(const EdgeNumbers<N>& own, NearCurve which) {
  const Vector<N> w = own.start - end(which);
  const N height = dot(w, own.normal);
  if (sign(height) >= 0) return;  // behind the edge: all of the circle is on the inner side
  const N square = -(height * (height + N(2) * own.reach));
  const int found = sign(square);
  if (found < 0) return;
  const N middle = -dot(w, own.along);
  const N out = own.reach / own.squared_length;
  const auto add = [&](int way, const N& root) {
    const N u = (middle + N(way) * root) / own.squared_length;
    const Vector<N> x = own.start + u * own.along + out * own.normal;
    if (is_beyond(x, which)) {
      found_.push_back({u, x, which, static_cast<std::int8_t>(way), way < 0, way == 0});
    }
  };
  if (found == 0) {
    add(0, N(0));
    return;
  }
  const N root = sqrt(square);
  add(-1, root);
  add(1, root);
}

template <class N>
void PatchCrossings<N>::add_circle(const ArcNumbers<N>& arc, NearCurve which) {
  const Vector<N> w = end(which) - arc.centre;
  const N square = dot(w, w);
  const N left = squared_radius_ - square / N(4);
  const int found = sign(left);
  if (found < 0) return;
  const Vector<N> half{w.x / N(2), w.y / N(2)};
  const auto add = [&](int way, const Vector<N>& y) {
    if (sign(dot(arc.middle, y)) <= 0 || !is_beyond(arc.centre + y, which)) return;
    found_.push_back({dot(turned(arc.middle), y), arc.centre + y, which,
                      static_cast<std::int8_t>(way), way < 0, way == 0});
  };
  if (found == 0) {
    add(0, half);
    return;
  }
  const N root = sqrt(left / square);
  for (const int way : {-1, 1}) add(way, half + N(way) * root * turned(w));
}

template <class N>
void PatchCrossings<N>::add_line(const EdgeNumbers<N>& own, NearCurve which) {
  const N slope = dot(by_.normal, own.along);
  if (sign(slope) == 0) return;
  const N out = own.reach / own.squared_length;
  const N reach = which == NearCurve::outside ? by_.reach : -by_.reach;
  const N u =
      (dot(by_.normal, by_.start - own.start) + reach - out * dot(by_.normal, own.normal)) / slope;
  const Vector<N> x = own.start + u * own.along + out * own.normal;
  if (is_beside(x)) found_.push_back({u, x, which, 0, false});
}

template <class N>
void PatchCrossings<N>::add_line(const ArcNumbers<N>& arc, NearCurve which) {
  const N height = dot(by_.normal, by_.start - arc.centre);
  const N level = which == NearCurve::outside ? height + by_.reach : height - by_.reach;
  const N square = by_.squared_reach - level * level;
  const int found = sign(square);
  // With the centre on the edge's line the arc touches a side from inside; behind the edge,
  // everything is inside.
  const bool touches = found == 0 && which == NearCurve::outside && sign(level) < 0;
  if (found < 0 || (found == 0 && !touches)) return;
  const auto add = [&](int way, const Vector<N>& y) {
    if (sign(dot(arc.middle, y)) <= 0 || !is_beside(arc.centre + y)) return;
    const bool enters = which == NearCurve::outside ? way > 0 : way < 0;
    found_.push_back({dot(turned(arc.middle), y), arc.centre + y, which,
                      static_cast<std::int8_t>(way), enters, touches});
  };
  const N inverse = N(1) / by_.squared_length;
  const Vector<N> foot = (level * inverse) * by_.normal;
  if (touches) {
    add(0, foot);
    return;
  }
  const N root = sqrt(square) * inverse;
  add(-1, foot + (-root) * by_.along);
  add(1, foot + root * by_.along);
}

}  // namespace minkref::inline disc
