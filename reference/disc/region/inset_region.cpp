#include "reference/disc/region/inset_region.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "reference/disc/region/piece_places.hpp"
#include "reference/disc/region/simple_rings.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"
#include "reference/plane/erosion/outside.hpp"

namespace minkref::inline disc {
namespace {

constexpr auto nobody = static_cast<std::size_t>(-1);

/// Links the pieces to walks along single wedges of the complement: where two walks meet, each goes
/// on as the other. (At a boundary point the sum has at least half of all directions, so three
/// walks never meet.)
StaticOffset linked_outside(const StaticOffset& offset) {
  StaticOffset linked = offset;
  const PiecePlaces places(offset);
  const auto count = static_cast<std::uint32_t>(offset.pieces.size());
  std::vector<std::uint32_t> before(count), next(count);
  for (const auto& ring : offset.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const std::uint32_t piece = ring[k], after = ring[k + 1 == ring.size() ? 0 : k + 1];
      next[piece] = after;
      before[after] = piece;
    }
  }
  std::map<std::uint32_t, std::uint32_t> started;
  for (const auto& ring : offset.rings) {
    for (const std::uint32_t piece : ring) {
      const auto [other, is_new] = started.try_emplace(places.of_start(piece), piece);
      if (is_new) continue;
      std::swap(before[piece], before[other->second]);
      next[before[piece]] = piece;
      next[before[other->second]] = other->second;
    }
  }
  linked.rings.clear();
  std::vector<bool> seen(count, false);
  for (const auto& ring : offset.rings) {
    for (const std::uint32_t first : ring) {
      if (seen[first]) continue;
      auto& walk = linked.rings.emplace_back();
      for (std::uint32_t piece = first; !seen[piece]; piece = next[piece]) {
        seen[piece] = true;
        walk.push_back(piece);
      }
    }
  }
  return linked;
}

/// Tells whether rings go round points of P's outside. Such points keep the radius as distance from
/// the boundary; an arc of at most a right angle stays nearer to its chord. So chords go round the
/// same points as arcs.
class Around {
 public:
  explicit Around(const StaticOffset& offset) : offset_(offset), at_(*offset.at) {}

  /// A point of P's outside next to a ring.
  Point beside(const SimpleRing& ring) const {
    const OffsetPatch& patch = at_.curves().patches[offset_.pieces[ring.pieces[0]].patch];
    return patch.edge == OffsetPatch::none ? patch.centre : at_.curves().edges[patch.edge].start;
  }

  bool goes_round(const SimpleRing& ring, const Point& x) const {
    bool odd = false;
    for (std::size_t k = 0; k < ring.pieces.size(); ++k) {
      look_for_interrupt();
      const std::uint32_t a = ring.pieces[k];
      const std::uint32_t b = ring.pieces[k + 1 == ring.pieces.size() ? 0 : k + 1];
      const bool up_a = is_above(a, x), up_b = is_above(b, x);
      if (up_a != up_b && (side(a, b, x) > 0) == up_b) odd = !odd;
    }
    return odd;
  }

 private:
  RootPoint point(std::uint32_t piece) const {
    return at_.point(offset_.pieces[piece].patch, offset_.pieces[piece].from);
  }
  bool is_above(std::uint32_t piece, const Point& x) const {
    const Interval y = at_.position(offset_.pieces[piece].patch, offset_.pieces[piece].from).y;
    const Interval level(x.y);
    if (y.lower() > level.upper()) return true;
    if (y.upper() < level.lower()) return false;
    return sign(point(piece).y - RootNumber(x.y)) > 0;
  }
  /// Left (1) or right (-1) of a chord, on which x does not lie.
  int side(std::uint32_t a, std::uint32_t b, const Point& x) const {
    const RootPoint from = point(a), to = point(b);
    for (long bits = RealNumber::first_bits; bits <= RealNumber::most_bits; bits *= 2) {
      const MpfrInterval ax = from.x.enclosure(bits), ay = from.y.enclosure(bits);
      const int found = ((to.x.enclosure(bits) - ax) * (MpfrInterval(x.y, bits) - ay) -
                         (to.y.enclosure(bits) - ay) * (MpfrInterval(x.x, bits) - ax))
                            .certain_sign();
      if (found != 0) return found;
    }
    throw std::logic_error("inset_region: a point of the outside lies on a chord");
  }

  const StaticOffset& offset_;
  const PatchesAt& at_;
};

/// The complement's rings, by bounded component.
class Complement {
 public:
  explicit Complement(const StaticOffset& linked)
      : rings(simple_rings(linked).rings), around_(linked) {
    std::vector<std::size_t> walk_of(linked.pieces.size());
    for (std::size_t w = 0; w < linked.rings.size(); ++w) {
      for (const std::uint32_t piece : linked.rings[w]) walk_of[piece] = w;
    }
    outer_of_walk_.assign(linked.rings.size(), nobody);
    for (std::size_t k = 0; k < rings.size(); ++k) {
      if (!rings[k].is_hole) continue;
      std::size_t& own = outer_of_walk_[walk_of[rings[k].pieces[0]]];
      if (own != nobody) throw std::logic_error("a walk of an inset has two outer rings");
      own = k;
      outers_.push_back(k);
    }
    for (const std::size_t outer : outers_) depth_[outer] = holders(rings[outer], outer).size();
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const std::size_t own = outer_of_walk_[walk_of[rings[k].pieces[0]]];
      outer_of_.push_back(own != nobody ? own : innermost(rings[k]));
    }
  }

  /// The outer ring of a ring's component; nobody's for the unbounded one.
  std::size_t outer_of(std::size_t ring) const { return outer_of_[ring]; }

  std::vector<SimpleRing> rings;

 private:
  std::vector<std::size_t> holders(const SimpleRing& ring, std::size_t but) const {
    const Point x = around_.beside(ring);
    std::vector<std::size_t> found;
    for (const std::size_t outer : outers_) {
      if (outer != but && around_.goes_round(rings[outer], x)) found.push_back(outer);
    }
    return found;
  }
  std::size_t innermost(const SimpleRing& ring) const {
    const std::vector<std::size_t> all = holders(ring, nobody);
    if (all.empty()) return nobody;
    return *std::max_element(all.begin(), all.end(), [&](std::size_t a, std::size_t b) {
      return depth_.at(a) < depth_.at(b);
    });
  }

  Around around_;
  std::vector<std::size_t> outers_, outer_of_walk_, outer_of_;
  std::map<std::size_t, std::size_t> depth_;  ///< how many outer rings go round an outer ring
};

std::vector<std::uint32_t> curves_along(const StaticOffset& offset,
                                        const std::vector<std::uint32_t>& pieces) {
  const auto feature = [&](std::uint32_t piece) {
    return offset.at->curves().patches[offset.pieces[piece].patch].feature;
  };
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const std::uint32_t before = pieces[k == 0 ? pieces.size() - 1 : k - 1];
    const std::uint32_t own = feature(pieces[k]);
    if (feature(before) != own || !goes_on(offset, before, pieces[k])) found.push_back(own);
  }
  if (found.empty()) found.push_back(feature(pieces[0]));
  return found;
}

/// The complement's bounded components, in canonical order.
std::vector<OffsetComponent> components_of(const StaticOffset& linked) {
  Complement complement(linked);
  const auto form_ring = [&](std::size_t k) -> FormRing {
    return {curves_along(linked, complement.rings[k].pieces), static_cast<std::uint32_t>(k)};
  };
  std::map<std::size_t, FormComponent> of_outer;
  for (std::size_t k = 0; k < complement.rings.size(); ++k) {
    const std::size_t outer = complement.outer_of(k);
    if (outer == nobody) continue;
    FormComponent& component = of_outer[outer];
    if (outer == k) {
      component.outer = form_ring(k);
    } else {
      component.holes.push_back(form_ring(k));
    }
  }
  OffsetForm form;
  for (auto& [outer, component] : of_outer) form.push_back(std::move(component));
  make_canonical(form, linked.at->curves());
  const auto ring = [&](FormRing& found) -> OffsetRing {
    return {std::move(complement.rings[found.id].pieces), std::move(found.curves)};
  };
  std::vector<OffsetComponent> components;
  for (FormComponent& component : form) {
    components.push_back({ring(component.outer), {}});
    for (FormRing& hole : component.holes) components.back().holes.push_back(ring(hole));
  }
  return components;
}

}  // namespace

OffsetRegion inset_region(const PolygonSet& P, const Rational& squared_radius,
                          const BuildOptions& options, OffsetRoute route) {
  const FloatEnvironment standard;
  OffsetRegion region =
      offset_region(P.is_region() ? outside_of(P).set : P, squared_radius, options, route);
  const std::size_t bodies = region.components.size(), holes = region.holes;
  region.components.clear();
  region.holes = 0;
  if (!P.is_region()) return region;
  region.components = components_of(linked_outside(region.offset));
  region.holes = bodies - 1;
  if (region.components.size() != holes) {
    throw std::logic_error("inset_region: the rings are not those of the holes of the sum");
  }
  return region;
}

std::string inset_json(const OffsetRegion& inset) {
  std::string text = canonical_json(inset);
  const std::size_t end = text.rfind("\"squared_radius\"");
  return text.insert(end, "\"inward\":true,");
}

}  // namespace minkref::inline disc
