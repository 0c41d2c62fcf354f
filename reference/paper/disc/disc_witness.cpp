#include "reference/paper/disc/disc_witness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reference/disc/region/drawn_rings.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/paper/disc/disc_collision.hpp"

namespace minkref::inline disc {
namespace {

using Piece = DiscAnswer::Piece;
using Rings = std::vector<std::vector<Piece>>;

struct Spot {
  double x, y;
};

bool is_right_of_centre(const Piece& arc) { return arc.from_x + arc.to_x > 2 * arc.centre_x; }

/// How often the rings run round a point: arcs are monotone in both coordinates.
int winding(const Rings& rings, const Spot& at) {
  int count = 0;
  for (const std::vector<Piece>& ring : rings) {
    for (const Piece& piece : ring) {
      const bool starts_above = piece.from_y > at.y, ends_above = piece.to_y > at.y;
      if (starts_above == ends_above) continue;
      double x = 0;
      if (piece.is_arc) {
        const double up = at.y - piece.centre_y;
        const double square = (piece.from_x - piece.centre_x) * (piece.from_x - piece.centre_x) +
                              (piece.from_y - piece.centre_y) * (piece.from_y - piece.centre_y);
        const double out = std::sqrt(std::max(square - up * up, 0.0));
        x = is_right_of_centre(piece) ? piece.centre_x + out : piece.centre_x - out;
      } else {
        x = piece.from_x +
            (piece.to_x - piece.from_x) * (at.y - piece.from_y) / (piece.to_y - piece.from_y);
      }
      if (x > at.x) count += ends_above ? 1 : -1;
    }
  }
  return count;
}

/// Places beside a piece's middle, at both sides.
void add_beside(const Piece& piece, double radius, std::vector<Spot>& spots) {
  Spot middle{(piece.from_x + piece.to_x) / 2, (piece.from_y + piece.to_y) / 2};
  Spot normal{piece.to_y - piece.from_y, piece.from_x - piece.to_x};
  const double length = std::hypot(normal.x, normal.y);
  if (!(length > 0)) return;
  normal = {normal.x / length, normal.y / length};
  if (piece.is_arc) {
    middle = {piece.centre_x + radius * normal.x, piece.centre_y + radius * normal.y};
  }
  for (const double part : {0x1p-4, 0x1p-8, 0x1p-14}) {
    for (const double side : {part, -part}) {
      const double by = side * std::min(radius, 8 * length);
      spots.push_back({middle.x + by * normal.x, middle.y + by * normal.y});
    }
  }
}

Rings drawn(const OffsetRegion& region) {
  Rings rings;
  const auto add = [&](const OffsetRing& ring) {
    auto& pieces = rings.emplace_back();
    for (const DrawnPiece& each : drawn_ring(region, ring, {})) {
      pieces.push_back({each.is_arc, each.cx, each.cy, each.x0, each.y0, each.x1, each.y1});
    }
  };
  for (const OffsetComponent& component : region.components) {
    add(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), add);
  }
  return rings;
}

class WitnessSearch {
 public:
  WitnessSearch(const PolygonSet& P, const Rational& squared_radius, const DiscAnswer& answer)
      : square_(squared_radius), answer_(answer) {
    for (const OffsetEdge& edge : offset_curves(P).edges) {
      MovingFeature<Rational> own;
      own.corner = {Vector<Rational>{edge.start.x, edge.start.y},
                    Vector<Rational>{edge.end.x, edge.end.y}};
      own.along = {edge.along.x, edge.along.y};
      edges_.push_back(std::move(own));
    }
  }

  std::optional<DiscWitness> at(const Spot& spot) const {
    if (!std::isfinite(spot.x) || !std::isfinite(spot.y)) return std::nullopt;
    const bool is_inside = winding(answer_.rings, spot) > 0;
    const double near = 0x1p-40 * (1 + std::abs(spot.x) + std::abs(spot.y));
    for (const auto& [x, y] : {Spot{near, 0}, Spot{-near, 0}, Spot{0, near}, Spot{0, -near}}) {
      if ((winding(answer_.rings, {spot.x + x, spot.y + y}) > 0) != is_inside) return std::nullopt;
    }
    const Vector<Rational> x{from_double(spot.x), from_double(spot.y)};
    const bool in_sum = meets_disc(edges_, square_, x);
    if (in_sum == is_inside) return std::nullopt;
    return DiscWitness{{x.x, x.y}, in_sum};
  }

 private:
  Rational square_;
  const DiscAnswer& answer_;
  std::vector<MovingFeature<Rational>> edges_;
};

std::vector<Spot> grid(const Rings& rings) {
  constexpr int steps = 24;
  double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
  for (const std::vector<Piece>& ring : rings) {
    for (const Piece& piece : ring) {
      low_x = std::min(low_x, piece.from_x);
      high_x = std::max(high_x, piece.from_x);
      low_y = std::min(low_y, piece.from_y);
      high_y = std::max(high_y, piece.from_y);
    }
  }
  std::vector<Spot> spots;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      spots.push_back({low_x + (high_x - low_x) * (i + 0.5) / steps,
                       low_y + (high_y - low_y) * (j + 0.5) / steps});
    }
  }
  return spots;
}

}  // namespace

std::optional<DiscWitness> disc_witness(const PolygonSet& P, const Rational& squared_radius,
                                        const DiscAnswer& answer) {
  const FloatEnvironment standard;
  const Rings exact = drawn(offset_region(P, squared_radius));
  const double radius = std::sqrt(to_double(squared_radius));
  std::vector<Spot> spots;
  for (const Rings* rings : {&answer.rings, &exact}) {
    for (const std::vector<Piece>& ring : *rings) {
      for (const Piece& piece : ring) add_beside(piece, radius, spots);
    }
    const std::vector<Spot> more = grid(*rings);
    spots.insert(spots.end(), more.begin(), more.end());
  }
  const WitnessSearch search(P, squared_radius, answer);
  for (const Spot& spot : spots) {
    look_for_interrupt();
    if (auto found = search.at(spot)) return found;
  }
  return std::nullopt;
}

}  // namespace minkref::inline disc
