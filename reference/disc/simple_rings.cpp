#include "reference/disc/simple_rings.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;

bool overlap(const Interval& a, const Interval& b) {
  return a.lower() <= b.upper() && b.lower() <= a.upper();
}

/// The starts of the pieces of a walk: those in one place have one number.
class Visits {
 public:
  Visits(const StaticOffset& offset, const std::vector<std::uint32_t>& walk)
      : offset_(offset), walk_(walk), places_(walk.size()) {
    std::vector<Vector<Interval>> near;
    for (const std::uint32_t piece : walk) near.push_back(position(piece));
    std::iota(places_.begin(), places_.end(), 0U);
    std::vector<std::uint32_t> order = places_;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return near[a].x.lower() < near[b].x.lower();
    });
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t l = k + 1; l < order.size(); ++l) {
        const std::uint32_t a = order[k], b = order[l];
        if (near[b].x.lower() > near[a].x.upper()) break;
        if (!overlap(near[a].x, near[b].x) || !overlap(near[a].y, near[b].y)) continue;
        if (places_[b] == b && are_same(a, b)) places_[b] = places_[a];
      }
    }
  }

  std::uint32_t place(std::size_t k) const { return places_[k]; }

 private:
  Vector<Interval> position(std::uint32_t piece) const {
    const OffsetPiece& own = offset_.pieces[piece];
    return offset_.at->position(own.patch, own.from);
  }
  RootPoint point(std::uint32_t k) const {
    const OffsetPiece& own = offset_.pieces[walk_[k]];
    return offset_.at->point(own.patch, own.from);
  }
  bool are_same(std::uint32_t a, std::uint32_t b) const {
    const RootPoint p = point(a), q = point(b);
    return compare(p.x, q.x) == 0 && compare(p.y, q.y) == 0;
  }

  const StaticOffset& offset_;
  const std::vector<std::uint32_t>& walk_;
  std::vector<std::uint32_t> places_;
};

/// A closed walk that does not cross itself falls into simple ones in one way.
void split(const StaticOffset& offset, const std::vector<std::uint32_t>& walk,
           std::vector<SimpleRing>& rings) {
  const Visits visits(offset, walk);
  std::vector<std::uint32_t> open;               // pieces
  std::map<std::uint32_t, std::size_t> started;  // how many were open at a place
  std::vector<std::uint32_t> places;
  for (std::size_t k = 0; k < walk.size(); ++k) {
    const std::uint32_t place = visits.place(k);
    const auto found = started.find(place);
    if (found != started.end()) {
      const auto from = static_cast<std::ptrdiff_t>(found->second);
      rings.push_back({{open.begin() + from, open.end()}, false});
      open.erase(open.begin() + from, open.end());
      while (places.back() != place) {
        started.erase(places.back());
        places.pop_back();
      }
    } else {
      started[place] = open.size();
      places.push_back(place);
    }
    open.push_back(walk[k]);
  }
  rings.push_back({std::move(open), false});
}

/// The first coordinate of a point of the boundary.
struct Leftmost {
  Interval near;
  std::uint32_t patch;
  std::optional<PatchPlace> place;  ///< none: the leftmost point of the circle
};

class Orientation {
 public:
  explicit Orientation(const StaticOffset& offset) : offset_(offset), at_(*offset.at) {}

  /// All arcs turn left and all corners right. At the leftmost point of a ring the sum is on the
  /// right if the boundary is smooth there, and then the ring goes round it; at a corner what is
  /// not in the sum is there.
  bool is_hole(const SimpleRing& ring) const {
    std::optional<Leftmost> smooth, corner;
    const auto take = [&](std::optional<Leftmost>& least, Leftmost other) {
      if (!least || order(other, *least) < 0) least = std::move(other);
    };
    for (std::size_t k = 0; k < ring.pieces.size(); ++k) {
      const std::uint32_t number = ring.pieces[k];
      const OffsetPiece& piece = offset_.pieces[number];
      const std::uint32_t before = ring.pieces[(k + ring.pieces.size() - 1) % ring.pieces.size()];
      take(goes_on(offset_, before, number) ? smooth : corner,
           {at_.position(piece.patch, piece.from).x, piece.patch, piece.from});
      if (has_leftmost(piece)) {
        const OffsetPatch& patch = at_.curves().patches[piece.patch];
        take(smooth, {Interval(patch.centre.x) - at_.radius(), piece.patch, std::nullopt});
      }
    }
    return corner && (!smooth || order(*corner, *smooth) <= 0);
  }

 private:
  /// Whether the leftmost point of its circle is on it.
  bool has_leftmost(const OffsetPiece& piece) const {
    const OffsetPatch& patch = at_.curves().patches[piece.patch];
    const Direction left{-1, 0};
    if (patch.edge != OffsetPatch::none || cross(patch.first, left) < 0 ||
        cross(left, patch.last) < 0 || dot(middle_of(patch), left) <= 0) {
      return false;
    }
    const Interval key = at_.key_of_normal(piece.patch, left);
    const auto side = [&](const PatchPlace& place) {
      if (place.near.upper() < key.lower()) return -1;
      if (place.near.lower() > key.upper()) return 1;
      return compare(at_.exact(piece.patch, place).key, at_.exact_key_of_normal(piece.patch, left));
    };
    return (piece.from.at != At::inside || side(piece.from) <= 0) &&
           (piece.to.at != At::inside || side(piece.to) >= 0);
  }

  int order(const Leftmost& a, const Leftmost& b) const {
    if (a.near.upper() < b.near.lower()) return -1;
    if (a.near.lower() > b.near.upper()) return 1;
    return compare(exact(a), exact(b));
  }
  RootNumber exact(const Leftmost& point) const {
    if (point.place) return at_.point(point.patch, *point.place).x;
    return RootNumber(at_.curves().patches[point.patch].centre.x) -
           sqrt(RootNumber(at_.squared_radius()));
  }

  const StaticOffset& offset_;
  const PatchesAt& at_;
};

}  // namespace

bool goes_on(const StaticOffset& offset, std::uint32_t piece, std::uint32_t next) {
  const OffsetPiece &a = offset.pieces[piece], &b = offset.pieces[next];
  if (a.to.at == At::end && b.from.at == At::start) {
    return offset.at->curves().patches[a.patch].next == b.patch;
  }
  OffsetCounts counts;
  return a.patch == b.patch && a.to.at == At::inside && b.from.at == At::inside &&
         offset.at->compare(a.patch, a.to, b.from, counts) == 0;
}

std::vector<SimpleRing> simple_rings(const StaticOffset& offset) {
  std::vector<SimpleRing> rings;
  for (const std::vector<std::uint32_t>& walk : offset.rings) split(offset, walk, rings);
  const Orientation orientation(offset);
  for (SimpleRing& ring : rings) ring.is_hole = orientation.is_hole(ring);
  return rings;
}

}  // namespace minkref::inline disc
