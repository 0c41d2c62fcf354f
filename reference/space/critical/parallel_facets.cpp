#include "reference/space/critical/parallel_facets.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace minkref::inline space {
namespace {

using FlatPoint = std::array<Rational, 2>;
using FlatRing = std::vector<FlatPoint>;

Rational turn(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c) {
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

  /// Counter-clockwise.
  FlatRing ring(std::size_t which, const Rational& s) const {
    const MovingFacet& facet = *facets_[which];
    FlatRing ring;
    for (std::size_t k = 0; k < facet.size; ++k) {
      const IntegerVector &p = convolution_.P.points[facet.names[k].of_P].exact,
                          &q = convolution_.Q.points[facet.names[k].of_Q].exact;
      const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
      ring.push_back({s * Rational(p[i]) + Rational(q[i]), s * Rational(p[j]) + Rational(q[j])});
    }
    if (turn(ring[0], ring[1], ring[2]) < 0) std::reverse(ring.begin() + 1, ring.end());
    return ring;
  }

  /// The number in the facet of corner k of a ring.
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

/// What two convex polygons share: its corners; fewer than three where it has no area.
FlatRing shared(FlatRing ring, const FlatRing& other) {
  for (std::size_t k = 0; k < other.size() && !ring.empty(); ++k) {
    const FlatPoint &a = other[k], &b = other[(k + 1) % other.size()];
    FlatRing left;
    const auto add = [&](const FlatPoint& point) {
      if (left.empty() || (left.back() != point && left.front() != point)) left.push_back(point);
    };
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const FlatPoint &from = ring[i], &to = ring[(i + 1) % ring.size()];
      const Rational here = turn(a, b, from), there = turn(a, b, to);
      if (here >= 0) add(from);
      if (sign(here) * sign(there) < 0) {
        const Rational t = here / (here - there);
        add({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
      }
    }
    ring = std::move(left);
  }
  return ring;
}

/// The first corner of a ring that is in the other.
std::optional<std::size_t> corner_inside(const FlatRing& ring, const FlatRing& other) {
  const auto found =
      std::find_if(ring.begin(), ring.end(), [&](const FlatPoint& p) { return has(other, p); });
  if (found == ring.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ring.begin());
}

std::vector<FacetEvent> in_one_plane_at(const FlatPair& pair, const Rational& s) {
  const FlatRing f = pair.ring(0, s), g = pair.ring(1, s);
  const FlatRing both = shared(f, g);
  if (both.empty()) return {};
  FacetEvent event{both.size() > 2 ? ContactKind::parallel : ContactKind::vertex,
                   ContactChange::touch, FacetEvent::no_corner, FacetEvent::no_corner, s};
  const auto of_f = corner_inside(f, g), of_g = corner_inside(g, f);
  if (of_f) event.of_first = pair.corner(0, *of_f, f);
  const bool apart = of_f && of_g && f[*of_f] != g[*of_g];
  if (of_g && (event.kind == ContactKind::parallel || !apart)) {
    event.of_second = pair.corner(1, *of_g, g);
  }
  return {event};
}

/// Corners of one ring and sides of the other come to lie on each other.
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
        // The direction of the side is constant up to a factor: that at 1 will do.
        const FlatPoint along{at_one[other][next][0] - at_one[other][k][0],
                              at_one[other][next][1] - at_one[other][k][1]};
        const auto height = [&](const std::array<FlatRing, 2>& rings) -> Rational {
          const FlatPoint &corner = rings[which][c], &from = rings[other][k];
          return along[0] * (corner[1] - from[1]) - along[1] * (corner[0] - from[0]);
        };
        const Rational one = height(at_one), slope = height(at_two) - one;
        if (slope == 0) continue;
        const Rational s = 1 - one / slope;
        if (s <= 0) continue;
        const FlatRing own = pair.ring(which, s), ring = pair.ring(other, s);
        if (!has(ring, own[c])) continue;
        FacetEvent event{ContactKind::vertex, ContactChange::pass, FacetEvent::no_corner,
                         FacetEvent::no_corner, s};
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
  const auto meet = [&](const Rational& s) {
    return !shared(pair.ring(0, s), pair.ring(1, s)).empty();
  };
  for (std::size_t k = 0; k < found.size(); ++k) {
    Rational before = found[k].s / 2, after = found[k].s + 1;
    for (const FacetEvent& other : found) {
      if (other.s < found[k].s) before = std::max(before, Rational((other.s + found[k].s) / 2));
      if (other.s > found[k].s) after = std::min(after, Rational((other.s + found[k].s) / 2));
    }
    const bool down = meet(before), up = meet(after);
    if (up && !down) found[k].change = ContactChange::birth;
    if (!up && down) found[k].change = ContactChange::death;
    if (!up && !down) found[k].change = ContactChange::touch;
  }
  return found;
}

}  // namespace

std::vector<FacetEvent> parallel_events(const MovingConvolution& convolution,
                                        const MovingFacet& first, const MovingFacet& second,
                                        SignCounts& signs) {
  const SpaceOperand &P = convolution.P, &Q = convolution.Q;
  const auto &a = first.names[0], &b = second.names[0];
  const auto apart = [&](const SpaceOperand& body, std::uint32_t from, std::uint32_t to) {
    return filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
      return dot(first.normal.as<T>(), body.points[to].as<T>() - body.points[from].as<T>());
    });
  };
  const int slope = apart(P, a.of_P, b.of_P), height = apart(Q, a.of_Q, b.of_Q);
  const FlatPair pair(convolution, first, second);
  if (slope == 0) return height == 0 ? in_one_plane_always(pair) : std::vector<FacetEvent>{};
  if (slope * height >= 0) return {};
  const auto exact = [&](const SpaceOperand& body, std::uint32_t from, std::uint32_t to) {
    return dot(first.normal.exact, body.points[to].exact - body.points[from].exact);
  };
  return in_one_plane_at(pair, Rational(-exact(Q, a.of_Q, b.of_Q), exact(P, a.of_P, b.of_P)));
}

}  // namespace minkref::inline space
