// Area and length, enclosed.
#include <cmath>
#include <functional>

#include "reference/disc/region/exact_pieces.hpp"
#include "reference/disc/region/offset_region.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {
namespace {

template <class Visit>
void for_each_ring(const OffsetRegion& region, Visit&& visit) {
  for (const OffsetComponent& component : region.components) {
    visit(component.outer);
    for (const OffsetRing& hole : component.holes) visit(hole);
  }
}

/// Sums over the pieces, from exact corners, by as many bits as are asked for.
class Measuring {
 public:
  explicit Measuring(const OffsetRegion& region)
      : squared_radius_(region.offset.at->squared_radius()) {
    for_each_ring(region, [&](const OffsetRing& ring) {
      for (ExactPiece& piece : exact_pieces(region, ring)) pieces_.push_back(std::move(piece));
    });
  }

  /// Both measures are transcendental: the angles of a component's outer ring add up to at least
  /// one turn. So enough bits tell the two doubles around each measure.
  OffsetMeasures found() const {
    if (pieces_.empty()) return {Interval(0), Interval(0)};
    const auto between = [&](auto&& part) {
      return Interval(enclose(RealNumber{[&](long bits) {
                                           MpfrInterval sum(0, bits);
                                           for (const ExactPiece& piece : pieces_)
                                             sum = sum + part(piece, bits);
                                           return sum;
                                         },
                                         {}}));
    };
    return {between([&](const ExactPiece& piece, long bits) { return area(piece, bits); }),
            between([&](const ExactPiece& piece, long bits) { return length(piece, bits); })};
  }

 private:
  static Vector<MpfrInterval> near(const RootPoint& p, long bits) {
    return {p.x.enclosure(bits), p.y.enclosure(bits)};
  }
  static Vector<MpfrInterval> near(const Point& p, long bits) {
    return {MpfrInterval(p.x, bits), MpfrInterval(p.y, bits)};
  }
  static MpfrInterval angle(const ExactPiece& arc, long bits) {
    const Vector<MpfrInterval> centre = near(arc.patch->centre, bits),
                               a = near(arc.from, bits) - centre, b = near(arc.to, bits) - centre;
    return atan2(cross(a, b), dot(a, b));
  }

  MpfrInterval area(const ExactPiece& piece, long bits) const {
    const MpfrInterval half(Rational(1, 2), bits);
    const Vector<MpfrInterval> from = near(piece.from, bits), to = near(piece.to, bits);
    if (!piece.is_arc()) return half * cross(from, to);
    return half * (MpfrInterval(squared_radius_, bits) * angle(piece, bits) +
                   cross(near(piece.patch->centre, bits), to - from));
  }
  MpfrInterval length(const ExactPiece& piece, long bits) const {
    if (piece.is_arc()) return sqrt(MpfrInterval(squared_radius_, bits)) * angle(piece, bits);
    const Vector<MpfrInterval> way = near(piece.to, bits) - near(piece.from, bits);
    return sqrt(dot(way, way));
  }

  std::vector<ExactPiece> pieces_;
  Rational squared_radius_;
};

}  // namespace

bool is_sharp(const OffsetMeasures& found) {
  const auto is_narrow = [](const Interval& value) {
    return value.upper() - value.lower() <= widest_measure * value.lower();
  };
  return is_narrow(found.area) && is_narrow(found.length);
}

OffsetMeasures measures(const OffsetRegion& region) {
  const FloatEnvironment standard;
  return Measuring(region).found();
}

}  // namespace minkref::inline disc
