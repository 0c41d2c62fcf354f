#include "reference/disc/region/simple_rings.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/disc/region/piece_places.hpp"

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;

/// Splits a closed walk that does not cross itself into simple rings; only one way exists.
void split(const PiecePlaces& all, const std::vector<std::uint32_t>& walk,
           std::vector<SimpleRing>& rings) {
  std::vector<std::uint32_t> open;               // pieces
  std::map<std::uint32_t, std::size_t> started;  // how many were open at a place
  std::vector<std::uint32_t> places;
  for (const std::uint32_t piece : walk) {
    const std::uint32_t place = all.of_start(piece);
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
    open.push_back(piece);
  }
  rings.push_back({std::move(open), false});
}

/// The number of faces that the rings leave, the unbounded face included: by Euler's formula for
/// plane graphs.
std::size_t faces(const PiecePlaces& places, const std::vector<SimpleRing>& rings) {
  std::map<std::uint32_t, std::uint32_t> visited;  // places, by the ring that first does
  DisjointSets parts(rings.size());
  std::size_t pieces = 0;
  for (std::uint32_t k = 0; k < rings.size(); ++k) {
    pieces += rings[k].pieces.size();
    for (const std::uint32_t piece : rings[k].pieces) {
      const auto [found, is_new] = visited.try_emplace(places.of_start(piece), k);
      if (!is_new) parts.join(found->second, k);
    }
  }
  return pieces - visited.size() + parts.count() + 1;
}

/// A boundary point's first coordinate.
struct Leftmost {
  Interval near;
  std::uint32_t patch;
  std::optional<PatchPlace> place;  ///< none: the leftmost point of the circle
};

class Orientation {
 public:
  explicit Orientation(const StaticOffset& offset) : offset_(offset), at_(*offset.at) {}

  /// All arcs turn left and all corners right. At a ring's leftmost point the sum lies on the right
  /// if the boundary is smooth there, and then the ring goes round the sum; at a corner the
  /// complement lies there.
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
  /// Whether a piece contains the leftmost point of its circle.
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

SimpleRings simple_rings(const StaticOffset& offset) {
  const PiecePlaces places(offset);
  SimpleRings found;
  for (const std::vector<std::uint32_t>& walk : offset.rings) split(places, walk, found.rings);
  const Orientation orientation(offset);
  for (SimpleRing& ring : found.rings) ring.is_hole = orientation.is_hole(ring);
  found.faces = faces(places, found.rings);
  return found;
}

}  // namespace minkref::inline disc
