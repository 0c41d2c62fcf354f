#include "reference/space/critical/parallel_facets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace minkref::inline space {
namespace {

using FlatPoint = std::array<Integer, 2>;
using FlatRing = std::vector<FlatPoint>;

Integer turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Two parallel facets seen along an axis.
class FlatPair {
 public:
  FlatPair(const MovingConvolution& convolution, const MovingFacet& first,
           const MovingFacet& second)
      : convolution_(convolution),
        facets_{&first, &second},
        axis_(longest_axis(first.normal.exact)) {}

  /// Counter-clockwise, times the denominator of s.
  FlatRing ring(std::size_t which, const Rational& s) const {
    namespace mp = boost::multiprecision;
    const MovingFacet& facet = *facets_[which];
    const Integer top = mp::numerator(s), bottom = mp::denominator(s);
    FlatRing ring;
    for (std::size_t k = 0; k < facet.size; ++k) {
      const IntegerVector &p = convolution_.P.points[facet.names[k].of_P].exact,
                          &q = convolution_.Q.points[facet.names[k].of_Q].exact;
      const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
      ring.push_back({top * p[i] + bottom * q[i], top * p[j] + bottom * q[j]});
    }
    if (turn(ring[0], ring[1], ring[2]) < 0) std::reverse(ring.begin() + 1, ring.end());
    return ring;
  }

  /// The number, within the facet, for corner k of a ring.
  std::uint8_t corner(std::size_t which, std::size_t k, const FlatRing& ring) const {
    const MovingFacet& facet = *facets_[which];
    const bool is_reversed = facet.normal.exact[axis_].sign() < 0;
    return static_cast<std::uint8_t>(is_reversed && k > 0 ? ring.size() - k : k);
  }

 private:
  const MovingConvolution& convolution_;
  std::array<const MovingFacet*, 2> facets_;
  std::size_t axis_;
};

bool has(const FlatRing& ring, const FlatPoint& point) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (turn(ring[k], ring[(k + 1) % ring.size()], point) < 0) return false;
  }
  return true;
}

/// Whether one convex polygon has a side with the other polygon behind it: apart, or at most
/// `touching`.
bool is_behind_a_side(const FlatRing& ring, const FlatRing& other, bool touching) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const FlatPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if (std::all_of(other.begin(), other.end(), [&](const FlatPoint& point) {
          const int side = turn(a, b, point).sign();
          return side < 0 || (touching && side == 0);
        })) {
      return true;
    }
  }
  return false;
}

bool meet(const FlatRing& f, const FlatRing& g) {
  return !is_behind_a_side(f, g, false) && !is_behind_a_side(g, f, false);
}

bool share_an_area(const FlatRing& f, const FlatRing& g) {
  return !is_behind_a_side(f, g, true) && !is_behind_a_side(g, f, true);
}

/// The first corner of a ring inside the other ring.
std::optional<std::size_t> corner_inside(const FlatRing& ring, const FlatRing& other) {
  const auto found =
      std::find_if(ring.begin(), ring.end(), [&](const FlatPoint& p) { return has(other, p); });
  if (found == ring.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ring.begin());
}

/// Whether, for two coplanar facets, a side of one has the other facet behind it from one scale to
/// another, as far as doubles tell: heights over a side change evenly.
bool certainly_apart(const MovingConvolution& convolution, const MovingFacet& first,
                     const MovingFacet& second, const BoundedDouble& from,
                     const BoundedDouble& to) {
  const auto is_behind = [&](const MovingFacet& own, std::size_t k, const MovingFacet& other) {
    const BoundedVector inwards = cross(own.normal.rounded, own.along[k].rounded);
    const auto &P = convolution.P.points, &Q = convolution.Q.points;
    const auto& start = own.names[k];
    for (std::size_t l = 0; l < other.size; ++l) {
      const auto& corner = other.names[l];
      const BoundedDouble slope = dot(inwards, P[corner.of_P].rounded - P[start.of_P].rounded),
                          height = dot(inwards, Q[corner.of_Q].rounded - Q[start.of_Q].rounded);
      if ((slope * from + height).certain_sign() != -1) return false;
      if ((slope * to + height).certain_sign() != -1) return false;
    }
    return true;
  };
  for (std::size_t k = 0; k < first.size; ++k) {
    if (is_behind(first, k, second)) return true;
  }
  for (std::size_t k = 0; k < second.size; ++k) {
    if (is_behind(second, k, first)) return true;
  }
  return false;
}

BoundedDouble bounded(const EventScale& s) {
  return {s.rounded(), std::abs(s.rounded()) * 0x1p-49};
}

std::vector<FacetEvent> in_one_plane_at(const FlatPair& pair, const Rational& s) {
  const FlatRing f = pair.ring(0, s), g = pair.ring(1, s);
  if (!meet(f, g)) return {};
  FacetEvent event{share_an_area(f, g) ? ContactKind::parallel : ContactKind::vertex,
                   ContactChange::touch, FacetEvent::no_corner, FacetEvent::no_corner,
                   EventScale(s)};
  const auto of_f = corner_inside(f, g), of_g = corner_inside(g, f);
  if (of_f) event.of_first = pair.corner(0, *of_f, f);
  const bool apart = of_f && of_g && f[*of_f] != g[*of_g];
  if (of_g && (event.kind == ContactKind::parallel || !apart)) {
    event.of_second = pair.corner(1, *of_g, g);
  }
  return {event};
}

/// The events where one ring's corner reaches the other ring's side.
std::vector<FacetEvent> in_one_plane_always(const FlatPair& pair) {
  // All is linear in s: the rings at 1 and at 2 tell the rest.
  const std::array<FlatRing, 2> at_one{pair.ring(0, 1), pair.ring(1, 1)},
      at_two{pair.ring(0, 2), pair.ring(1, 2)};
  std::vector<FacetEvent> found;
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}}) {
    const std::size_t other = 1 - which;
    for (std::size_t c = 0; c < at_one[which].size(); ++c) {
      for (std::size_t k = 0; k < at_one[other].size(); ++k) {
        const std::size_t next = (k + 1) % at_one[other].size();
        // The side's direction is constant up to a factor: the direction at 1 will do.
        const FlatPoint along{at_one[other][next][0] - at_one[other][k][0],
                              at_one[other][next][1] - at_one[other][k][1]};
        const auto height = [&](const std::array<FlatRing, 2>& rings) -> Integer {
          const FlatPoint &corner = rings[which][c], &from = rings[other][k];
          return along[0] * (corner[1] - from[1]) - along[1] * (corner[0] - from[0]);
        };
        const Integer one = height(at_one), slope = height(at_two) - one;
        if (slope == 0) continue;
        const Rational s(slope - one, slope);
        if (s <= 0) continue;
        const FlatRing own = pair.ring(which, s), ring = pair.ring(other, s);
        if (!has(ring, own[c])) continue;
        FacetEvent event{ContactKind::vertex, ContactChange::pass, FacetEvent::no_corner,
                         FacetEvent::no_corner, EventScale(s)};
        (which == 0 ? event.of_first : event.of_second) = pair.corner(which, c, own);
        const auto same = std::find(ring.begin(), ring.end(), own[c]);
        if (same != ring.end()) {
          const auto number = static_cast<std::size_t>(same - ring.begin());
          (which == 0 ? event.of_second : event.of_first) = pair.corner(other, number, ring);
        }
        found.push_back(event);
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const FacetEvent& a, const FacetEvent& b) {
    return std::tie(a.s, a.of_first, a.of_second) < std::tie(b.s, b.of_first, b.of_second);
  });
  found.erase(std::unique(found.begin(), found.end(),
                          [](const FacetEvent& a, const FacetEvent& b) {
                            return a.s == b.s && a.of_first == b.of_first &&
                                   a.of_second == b.of_second;
                          }),
              found.end());
  const auto meet_at = [&](const Rational& s) { return meet(pair.ring(0, s), pair.ring(1, s)); };
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Rational s = found[k].s.exact();
    Rational before = s / 2, after = s + 1;
    for (const FacetEvent& other : found) {
      const Rational middle = (other.s.exact() + s) / 2;
      if (other.s < found[k].s) before = std::max(before, middle);
      if (other.s > found[k].s) after = std::min(after, middle);
    }
    const bool down = meet_at(before), up = meet_at(after);
    if (up && !down) found[k].change = ContactChange::birth;
    if (!up && down) found[k].change = ContactChange::death;
    if (!up && !down) found[k].change = ContactChange::touch;
  }
  return found;
}

}  // namespace

std::vector<FacetEvent> parallel_events(const MovingConvolution& convolution,
                                        const MovingFacet& first, const MovingFacet& second,
                                        SignCounts& signs, const ScaleWindow* window) {
  const SpaceOperand &P = convolution.P, &Q = convolution.Q;
  const auto &a = first.names[0], &b = second.names[0];
  const auto apart = [&](const SpaceOperand& body, std::uint32_t from, std::uint32_t to) {
    return filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
      return dot(first.normal.as<T>(), body.points[to].as<T>() - body.points[from].as<T>());
    });
  };
  const int slope = apart(P, a.of_P, b.of_P), height = apart(Q, a.of_Q, b.of_Q);
  const FlatPair pair(convolution, first, second);
  if (slope == 0) {
    if (height != 0) return {};
    if (window != nullptr &&
        certainly_apart(convolution, first, second, bounded(window->from), bounded(window->to))) {
      return {};
    }
    std::vector<FacetEvent> found = in_one_plane_always(pair);
    if (window != nullptr) {
      std::erase_if(found, [&](const FacetEvent& event) { return !window->has(event.s); });
    }
    return found;
  }
  if (slope * height >= 0) return {};
  const auto exact = [&](const SpaceOperand& body, std::uint32_t from, std::uint32_t to) {
    return dot(first.normal.exact, body.points[to].exact - body.points[from].exact);
  };
  const EventScale s(-exact(Q, a.of_Q, b.of_Q), exact(P, a.of_P, b.of_P));
  if (window != nullptr && !window->has(s)) return {};
  if (certainly_apart(convolution, first, second, bounded(s), bounded(s))) return {};
  return in_one_plane_at(pair, s.exact());
}

bool are_coplanar(const MovingConvolution& convolution, const MovingFacet& first,
                  const MovingFacet& second) {
  const auto &a = first.names[0], &b = second.names[0];
  const SpaceOperand &P = convolution.P, &Q = convolution.Q;
  const IntegerVector& n = first.normal.exact;
  return dot(n, P.points[b.of_P].exact - P.points[a.of_P].exact) == 0 &&
         dot(n, Q.points[b.of_Q].exact - Q.points[a.of_Q].exact) == 0;
}

bool parallel_facets_meet(const MovingConvolution& convolution, const MovingFacet& first,
                          const MovingFacet& second, const Rational& s) {
  const auto &a = first.names[0], &b = second.names[0];
  const auto apart = [&](const SpaceOperand& body, std::uint32_t from, std::uint32_t to) {
    return Rational(dot(first.normal.exact, body.points[to].exact - body.points[from].exact));
  };
  if (s * apart(convolution.P, a.of_P, b.of_P) + apart(convolution.Q, a.of_Q, b.of_Q) != 0) {
    return false;
  }
  const BoundedDouble near = bounded(EventScale(s));
  if (certainly_apart(convolution, first, second, near, near)) return false;
  const FlatPair pair(convolution, first, second);
  return meet(pair.ring(0, s), pair.ring(1, s));
}

}  // namespace minkref::inline space
