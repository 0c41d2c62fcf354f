// Area and length, enclosed.
#include "reference/disc/curves/angles.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

class Measuring {
 public:
  explicit Measuring(const StaticOffset& offset) : offset_(offset), at_(*offset.at) {}

  void add(const OffsetRing& ring) {
    for (const std::uint32_t number : ring.pieces) add(offset_.pieces[number]);
  }

  OffsetMeasures found{Interval(0), Interval(0)};

 private:
  void add(const OffsetPiece& piece) {
    const OffsetPatch& patch = at_.curves().patches[piece.patch];
    const Vector<Interval> from = at_.position(piece.patch, piece.from),
                           to = at_.position(piece.patch, piece.to);
    if (patch.edge != OffsetPatch::none) {
      const auto key = [](const PatchPlace& place) -> Interval {
        if (place.at == PatchPlace::At::inside) return place.near;
        return place.at == PatchPlace::At::start ? Interval(0) : Interval(1);
      };
      found.area += cross(from, to) / Interval(2);
      found.length += (key(piece.to) - key(piece.from)) * sqrt(at_.edge(patch.edge).squared_length);
      return;
    }
    const Vector<Interval> centre = numbers<Interval>(patch.centre);
    const Interval angle = angle_between(from - centre, to - centre);
    found.area += (Interval(at_.squared_radius()) * angle + cross(centre, to - from)) / Interval(2);
    found.length += at_.radius() * angle;
  }

  const StaticOffset& offset_;
  const PatchesAt& at_;
};

}  // namespace

OffsetMeasures measures(const OffsetRegion& region) {
  const FloatEnvironment standard;
  Measuring measuring(region.offset);
  for (const OffsetComponent& component : region.components) {
    measuring.add(component.outer);
    for (const OffsetRing& hole : component.holes) measuring.add(hole);
  }
  return measuring.found;
}

}  // namespace minkref::inline disc
