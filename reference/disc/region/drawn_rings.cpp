#include "reference/disc/region/drawn_rings.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "reference/disc/region/exact_pieces.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/radicals/nearest_double.hpp"

namespace minkref::inline disc {
namespace {

/// With c and s the squared radius times the angle's cosine and sine, the half angle's tangent is s
/// / (ρ² + c).
double bulge_of(const ExactPiece& piece, const Rational& squared_radius) {
  const RootPoint centre = numbers<RootNumber>(piece.patch->centre);
  const RootPoint a = piece.from - centre, b = piece.to - centre;
  const auto near = [&](long bits) {
    const auto by_bits = [&](const RootPoint& p) -> Vector<MpfrInterval> {
      return {p.x.enclosure(bits), p.y.enclosure(bits)};
    };
    const Vector<MpfrInterval> u = by_bits(a), v = by_bits(b);
    const MpfrInterval one(1, bits);
    const MpfrInterval half = cross(u, v) / (MpfrInterval(squared_radius, bits) + dot(u, v));
    return half / (one + sqrt(one + half * half));
  };
  return nearest_double(RealNumber{near, {}});
}

}  // namespace

DrawingFrame drawing_frame(const OffsetRegion& region) {
  namespace mp = boost::multiprecision;
  const auto& features = region.offset.at->curves().features;
  std::optional<std::pair<Point, Point>> box;
  for (const OffsetCurves::Feature& feature : features) {
    if (feature.edge != OffsetPatch::none) continue;
    const Point& p = feature.centre;
    if (!box) box = {p, p};
    box->first = {std::min(box->first.x, p.x), std::min(box->first.y, p.y)};
    box->second = {std::max(box->second.x, p.x), std::max(box->second.y, p.y)};
  }
  const auto exponent = [](const Rational& value) {
    return static_cast<long>(mp::msb(mp::numerator(value))) -
           static_cast<long>(mp::msb(mp::denominator(value)));
  };
  long size = exponent(region.offset.at->squared_radius()) / 2;
  DrawingFrame frame;
  if (box) {
    const auto& [low, high] = *box;
    frame.origin = {low.x + region.origin.x, low.y + region.origin.y};
    const Rational side = std::max(Rational(high.x - low.x), Rational(high.y - low.y));
    if (side > 0) size = std::max(size, exponent(side));
  }
  const Rational power(Integer(1) << static_cast<unsigned>(std::abs(size)));
  frame.factor = size < 0 ? power : Rational(1 / power);
  return frame;
}

DrawnRing drawn_ring(const OffsetRegion& region, const OffsetRing& ring,
                     const DrawingFrame& frame) {
  const RootNumber factor(frame.factor);
  const Direction shift{region.origin.x - frame.origin.x, region.origin.y - frame.origin.y};
  const auto x_of = [&](const RootNumber& x) {
    return nearest_double(factor * (x + RootNumber(shift.x)));
  };
  const auto y_of = [&](const RootNumber& y) {
    return nearest_double(factor * (y + RootNumber(shift.y)));
  };
  DrawnRing found;
  for (const ExactPiece& piece : exact_pieces(region, ring)) {
    look_for_interrupt();
    DrawnPiece drawn{piece.is_arc(), x_of(piece.from.x), y_of(piece.from.y), 0, 0, 0, 0, 0};
    if (piece.is_arc()) {
      drawn.cx = x_of(piece.patch->centre.x);
      drawn.cy = y_of(piece.patch->centre.y);
      drawn.bulge = bulge_of(piece, region.offset.at->squared_radius());
    }
    found.push_back(drawn);
  }
  for (std::size_t k = 0; k < found.size(); ++k) {
    const DrawnPiece& next = found[k + 1 == found.size() ? 0 : k + 1];
    found[k].x1 = next.x0;
    found[k].y1 = next.y0;
  }
  return found;
}

}  // namespace minkref::inline disc
