#include "reference/plane/index/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/moving/double_range.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline plane {
namespace {

using Corner = std::array<double, 2>;
using Corners = std::vector<Corner>;

constexpr double sure = 0x1p-46;  // relative to all sizes; more than rounding
constexpr double shrinkage = 0x1p-24;

double left_of(const Corner& a, const Corner& b, const Corner& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
double length(const Corner& a, const Corner& b) { return std::hypot(b[0] - a[0], b[1] - a[1]); }

double twice_area(const Corners& corners) {
  double result = 0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    result += left_of(corners[0], corners[k - 1], corners[k]);
  }
  return result;
}

/// The part on the left of the line from a to b.
Corners cut(const Corners& corners, const Corner& a, const Corner& b) {
  Corners result;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &u = corners[k], &v = corners[k + 1 == corners.size() ? 0 : k + 1];
    const double at_u = left_of(a, b, u), at_v = left_of(a, b, v);
    if (at_u >= 0) result.push_back(u);
    if ((at_u < 0 && at_v > 0) || (at_u > 0 && at_v < 0)) {
      const double share = at_u / (at_u - at_v);
      result.push_back({u[0] + share * (v[0] - u[0]), u[1] + share * (v[1] - u[1])});
    }
  }
  return result;
}

/// Removes corners, least area first, until all turns are certain and few corners remain. A convex
/// polygon stays convex without some of its corners.
void cut_down(Corners& corners, std::size_t most, double size) {
  const double doubt = sure * size;
  while (corners.size() >= 3) {
    const std::size_t n = corners.size();
    std::size_t least = 0;
    double least_share = HUGE_VAL;
    bool certain = true;
    for (std::size_t k = 0; k < n; ++k) {
      const Corner &a = corners[(k + n - 1) % n], &b = corners[k], &c = corners[(k + 1) % n];
      const double turn = left_of(a, b, c);
      certain = certain && turn > doubt * (std::fabs(b[0] - a[0]) + std::fabs(b[1] - a[1]) +
                                           std::fabs(c[0] - a[0]) + std::fabs(c[1] - a[1]));
      if (turn < least_share) {
        least_share = turn;
        least = k;
      }
    }
    if (certain && n <= most) return;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(least));
  }
  corners.clear();
}

/// Whether a point is within, give or take `doubt`; surely within for a negative `doubt`.
bool is_within(const Corner& p, const Corners& corners, double doubt) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Corner &u = corners[k], &v = corners[k + 1 == corners.size() ? 0 : k + 1];
    if (left_of(u, v, p) < -doubt * (std::fabs(v[0] - u[0]) + std::fabs(v[1] - u[1]))) return false;
  }
  return true;
}

class Growth {
 public:
  explicit Growth(const PolygonSet& region) {
    const auto add = [&](const Ring& ring) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        edges_.push_back({rounded(ring[k]), rounded(ring[(k + 1) % ring.size()])});
      }
    };
    for (const Polygon& polygon : region.polygons) {
      add(polygon.outer);
      for (const Ring& hole : polygon.holes) add(hole);
    }
    for (const auto& [a, b] : edges_) {
      size_ = std::max({size_, std::fabs(a[0]), std::fabs(a[1])});
      is_finite_ = is_finite_ && std::isfinite(a[0]) && std::isfinite(a[1]);
    }
    is_finite_ = is_finite_ && in_filter_range(size_ * size_);
  }

  double size() const { return size_; }
  bool is_finite() const { return is_finite_; }
  static Corner rounded(const Point& p) { return {filter_double(p.x), filter_double(p.y)}; }

  /// Grows around a point of the region; empty if nothing is certain.
  Corners around(const Corner& seed, std::size_t most_corners) {
    by_distance_.clear();
    for (std::uint32_t k = 0; k < edges_.size(); ++k) {
      const auto& [a, b] = edges_[k];
      const Corner near = nearest(seed, a, b);
      by_distance_.emplace_back(length(seed, near), k);
    }
    std::sort(by_distance_.begin(), by_distance_.end());
    const double reach = 2 * size_;
    Corners corners{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    for (const auto& [distance, k] : by_distance_) {
      look_for_interrupt();
      if (!is_apart(corners, edges_[k], 0)) grow_up_to(seed, edges_[k], corners);
    }
    for (Corner& c : corners) {
      c = {c[0] + shrinkage * (seed[0] - c[0]), c[1] + shrinkage * (seed[1] - c[1])};
    }
    cut_down(corners, most_corners, size_);
    if (corners.empty() || !is_within(seed, corners, -sure * size_)) return {};
    const bool certain = std::all_of(edges_.begin(), edges_.end(), [&](const auto& edge) {
      return is_apart(corners, edge, 4 * sure * size_);
    });
    return certain ? corners : Corners{};
  }

 private:
  using Edge = std::array<Corner, 2>;

  static Corner nearest(const Corner& seed, const Corner& a, const Corner& b) {
    const double x = b[0] - a[0], y = b[1] - a[1],
                 t = ((seed[0] - a[0]) * x + (seed[1] - a[1]) * y) / (x * x + y * y);
    if (!(t > 0)) return a;
    if (t >= 1) return b;
    return {a[0] + t * x, a[1] + t * y};
  }

  /// Whether a side, or the line of the edge, separates them, with this much room.
  static bool is_apart(const Corners& corners, const Edge& edge, double room) {
    const Corner &a = edge[0], &b = edge[1];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner &u = corners[k], &v = corners[k + 1 == corners.size() ? 0 : k + 1];
      const double most = -room * (std::fabs(v[0] - u[0]) + std::fabs(v[1] - u[1]));
      if (left_of(u, v, a) <= most && left_of(u, v, b) <= most) return true;
    }
    if (a == b) return false;  // a line of its own it has not
    const double least = room * (std::fabs(b[0] - a[0]) + std::fabs(b[1] - a[1]));
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Corner& c) { return left_of(a, b, c) >= least; }) ||
           std::all_of(corners.begin(), corners.end(),
                       [&](const Corner& c) { return left_of(a, b, c) <= -least; });
  }

  /// Cuts by the edge's line, or across the way to the nearest point of the edge's part within the
  /// polygon: whichever leaves more.
  static void grow_up_to(const Corner& seed, const Edge& edge, Corners& corners) {
    const Corner &a = edge[0], &b = edge[1];
    Corners by_line, across;
    if (left_of(a, b, seed) > 0) by_line = cut(corners, a, b);
    double from = 0, to = 1;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner &u = corners[k], &v = corners[k + 1 == corners.size() ? 0 : k + 1];
      const double at_a = left_of(u, v, a), at_b = left_of(u, v, b);
      if (at_a < 0 && at_b > 0) from = std::max(from, at_a / (at_a - at_b));
      if (at_a > 0 && at_b < 0) to = std::min(to, at_a / (at_a - at_b));
    }
    if (from >= to) return;
    const auto at = [&](double t) -> Corner {
      return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
    };
    const Corner near = nearest(seed, at(from), at(to));
    const double x = near[0] - seed[0], y = near[1] - seed[1];
    across = cut(corners, near, {near[0] - y, near[1] + x});
    corners = twice_area(by_line) > twice_area(across) ? by_line : across;
  }

  std::vector<Edge> edges_;
  double size_ = 0;
  bool is_finite_ = true;
  std::vector<std::pair<double, std::uint32_t>> by_distance_;
};

/// The middle of a triangle's inscribed circle.
Corner middle_of(const Corners& t) {
  const double a = length(t[1], t[2]), b = length(t[2], t[0]), c = length(t[0], t[1]),
               sum = a + b + c;
  return {(a * t[0][0] + b * t[1][0] + c * t[2][0]) / sum,
          (a * t[0][1] + b * t[1][1] + c * t[2][1]) / sum};
}

}  // namespace

double ConvexPiece::area() const { return twice_area(corners) / 2; }

double ConvexPiece::reach(double x, double y) const {
  double most = -HUGE_VAL;
  for (const auto& c : corners) most = std::max(most, x * c[0] + y * c[1]);
  return most;
}

std::vector<ConvexPiece> convex_pieces(const PolygonSet& region, std::size_t most_corners,
                                       std::size_t most_pieces) {
  std::vector<ConvexPiece> result;
  Growth growth(region);
  if (!growth.is_finite()) return result;
  std::vector<std::pair<double, Corners>> triangles;
  for (const Triangle& t : triangulate(region)) {
    Corners corners{Growth::rounded(t[0]), Growth::rounded(t[1]), Growth::rounded(t[2])};
    triangles.emplace_back(-twice_area(corners), std::move(corners));
  }
  std::sort(triangles.begin(), triangles.end());
  const double size = growth.size();
  const auto lies_in = [](const ConvexPiece& piece, const Corner& c, double doubt) {
    return is_within(c, piece.corners, doubt);
  };
  for (const bool fill : {false, true}) {
    for (const auto& candidate : triangles) {
      look_for_interrupt_now();
      if (result.size() == most_pieces) return result;
      const Corners& t = candidate.second;
      const Corner seed = middle_of(t);
      const auto holds = [&](const ConvexPiece& piece) {
        if (!fill) return lies_in(piece, seed, 0);
        return std::all_of(t.begin(), t.end(), [&](const Corner& c) {
          return lies_in(piece, c, 4 * shrinkage * size);
        });
      };
      if (std::any_of(result.rbegin(), result.rend(), holds)) continue;
      if (!is_within(seed, t, -sure * size)) continue;
      Corners corners = growth.around(seed, most_corners);
      if (!corners.empty()) result.push_back({std::move(corners)});
    }
  }
  return result;
}

}  // namespace minkref::inline plane
