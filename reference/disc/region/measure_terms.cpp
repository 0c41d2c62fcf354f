#include "reference/disc/region/measure_terms.hpp"

#include <cstddef>

#include "reference/disc/region/simple_rings.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

class MeasureSums {
 public:
  explicit MeasureSums(const StaticOffset& offset) : offset_(offset), at_(*offset.at) {}

  void add(const OffsetRing& ring) {
    const std::vector<std::uint32_t>& pieces = ring.pieces;
    for (const std::uint32_t number : pieces) {
      const OffsetPiece& piece = offset_.pieces[number];
      const OffsetPatch& patch = at_.curves().patches[piece.patch];
      if (patch.edge != OffsetPatch::none) {
        add_line(piece, at_.curves().edges[patch.edge]);
      } else {
        add_chord(piece, patch);
      }
    }
    add_angles(pieces);
  }

  const MeasureTerms& terms() const { return terms_; }

 private:
  bool is_arc(std::uint32_t number) const {
    return at_.curves().patches[offset_.pieces[number].patch].edge == OffsetPatch::none;
  }

  RootNumber key(std::uint32_t patch, const PatchPlace& place) const {
    if (place.at == PatchPlace::At::inside) return at_.exact(patch, place).key;
    return place.at == PatchPlace::At::start ? 0 : 1;
  }

  /// Along a line a point's product with the normal stays the same; the triangle that the piece
  /// spans with the origin has half this product times the piece's part of the edge as area.
  void add_line(const OffsetPiece& piece, const OffsetEdge& edge) {
    const Rational height = edge.normal.x * edge.start.x + edge.normal.y * edge.start.y;
    for (const int end : {-1, 1}) {
      const RootNumber u = key(piece.patch, end < 0 ? piece.from : piece.to);
      const Rational half(end, 2);
      terms_.length.add(u, end, edge.squared_length);
      terms_.area.add(u, half * height);
      terms_.area.add(u, half, at_.squared_radius() * edge.squared_length);
    }
  }

  /// Adds the area that an arc spans with the origin, without the arc's sector.
  void add_chord(const OffsetPiece& piece, const OffsetPatch& arc) {
    const Direction centre{arc.centre.x, arc.centre.y};
    for (const int end : {-1, 1}) {
      const PatchPlace& place = end < 0 ? piece.from : piece.to;
      const Rational half(end, 2);
      if (place.at != PatchPlace::At::inside) {
        const Direction& way = place.at == PatchPlace::At::start ? arc.first : arc.last;
        terms_.area.add(1, half * cross(centre, way), at_.squared_radius() / dot(way, way));
        continue;
      }
      const RootPoint x = at_.point(piece.patch, place);
      terms_.area.add(x.y, half * centre.x);
      terms_.area.add(x.x, -half * centre.y);
    }
  }

  RootPoint direction(std::uint32_t number, bool at_start) const {
    const OffsetPiece& piece = offset_.pieces[number];
    const OffsetPatch& arc = at_.curves().patches[piece.patch];
    const PatchPlace& place = at_start ? piece.from : piece.to;
    if (place.at == PatchPlace::At::inside) {
      return at_.point(piece.patch, place) - numbers<RootNumber>(arc.centre);
    }
    const Direction way = place.at == PatchPlace::At::start ? arc.first : arc.last;
    return numbers<RootNumber>(primitive(way));
  }

  bool goes_on_round(std::uint32_t piece, std::uint32_t next) const {
    const auto feature = [&](std::uint32_t k) {
      return at_.curves().patches[offset_.pieces[k].patch].feature;
    };
    return is_arc(piece) && is_arc(next) && feature(piece) == feature(next) &&
           goes_on(offset_, piece, next);
  }

  /// Adds angles; arcs of one curve that go on into each other count once.
  void add_angles(const std::vector<std::uint32_t>& pieces) {
    const std::size_t count = pieces.size();
    std::size_t first = 0;
    while (first < count && goes_on_round(pieces[(first + count - 1) % count], pieces[first])) {
      ++first;
    }
    if (first == count) {  // a circle
      const RootPoint way = direction(pieces[0], true);
      terms_.angles.push_back({way, way});
      return;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t piece = pieces[(first + k) % count];
      if (!is_arc(piece)) continue;
      const bool goes_on_here = k > 0 && goes_on_round(pieces[(first + k - 1) % count], piece);
      if (!goes_on_here) terms_.angles.push_back({direction(piece, true), {}});
      terms_.angles.back().to = direction(piece, false);
    }
  }

  const StaticOffset& offset_;
  const PatchesAt& at_;
  MeasureTerms terms_;
};

}  // namespace

MeasureTerms measure_terms(const OffsetRegion& region) {
  const FloatEnvironment standard;
  MeasureSums sums(region.offset);
  for (const OffsetComponent& component : region.components) {
    sums.add(component.outer);
    for (const OffsetRing& hole : component.holes) sums.add(hole);
  }
  return sums.terms();
}

}  // namespace minkref::inline disc
