#include "reference/plane/moving/interior_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/moving/double_range.hpp"
#include "reference/plane/point_predicates.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline plane {
namespace {

using TriangleInDoubles = std::array<std::array<double, 2>, 3>;

struct ConvexPieces {
  std::vector<Triangle> exact;
  std::vector<TriangleInDoubles> doubles;
  BoxTree tree;
  double magnitude = 0;

  /// A segment or a point becomes a triangle without area, with two or three equal corners.
  explicit ConvexPieces(const PolygonSet& set) {
    if (has_area(set)) {
      exact = triangulate(set);
    } else {
      for (const Polygon& part : set.polygons) {
        exact.push_back({part.outer.front(), part.outer.back(), part.outer.back()});
      }
    }
    std::vector<Box> boxes;
    for (const Triangle& t : exact) {
      TriangleInDoubles d;
      Box box;
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = to_double(t[i].x), y = to_double(t[i].y);
        box.add({below(x), below(y), above(x), above(y)});
        magnitude = std::max({magnitude, std::abs(x), std::abs(y)});
        d[i] = {filter_double(t[i].x), filter_double(t[i].y)};
      }
      doubles.push_back(d);
      boxes.push_back(box);
    }
    tree = BoxTree(std::move(boxes));
  }
};

/// The doubles' verdict about the edges of `a`, with coordinate errors up to `error`: an edge has
/// all of `b` on its right, each edge has some of `b` on its left, or neither is certain.
enum class Told : std::uint8_t { separates, none_separates, nothing };

Told by_edges(const TriangleInDoubles& a, const TriangleInDoubles& b, double error) {
  bool each_open = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &p = a[i], &q = a[(i + 1) % 3];
    const double ux = q[0] - p[0], uy = q[1] - p[1];
    bool open = false, closed = true;
    for (const auto& r : b) {
      const double vx = r[0] - p[0], vy = r[1] - p[1];
      const double left = ux * vy, right = uy * vx;
      const double sum = std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy);
      const double bound =
          (std::abs(left) + std::abs(right)) * 0x1p-50 + 4 * error * sum + 16 * error * error;
      open = open || left - right > bound;
      closed = closed && left - right < -bound;
    }
    if (closed) return Told::separates;
    each_open = each_open && open;
  }
  return each_open ? Told::none_separates : Told::nothing;
}

/// Whether the interiors of two triangles meet, as far as doubles tell.
std::optional<bool> told(const TriangleInDoubles& a, const TriangleInDoubles& b, double error) {
  const Told first = by_edges(a, b, error);
  if (first == Told::separates) return false;
  const Told second = by_edges(b, a, error);
  if (second == Told::separates) return false;
  if (first == Told::nothing || second == Told::nothing) return std::nullopt;
  return true;
}

using FilteredTriangle = std::array<FilteredPoint, 3>;

/// Whether some edge line of `a` has all of `b` on its closed right side.
bool separates(const FilteredTriangle& a, const FilteredTriangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::all_of(b.begin(), b.end(), [&](const FilteredPoint& p) {
          return orientation(a[i], a[(i + 1) % 3], p) <= 0;
        })) {
      return true;
    }
  }
  return false;
}

/// Whether some edge line of `a` has all of `b` on its open right side, after a small move of `b`.
bool separates_after(const Point& move, const FilteredTriangle& a, const FilteredTriangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const FilteredPoint &from = a[i], &to = a[(i + 1) % 3];
    int nearest = -1;
    for (const FilteredPoint& p : b) nearest = std::max(nearest, orientation(from, to, p));
    if (nearest < 0) return true;
    const FilteredPoint moved(Point{from.exact().x + move.x, from.exact().y + move.y});
    if (nearest == 0 && orientation(from, to, moved) < 0) return true;
  }
  return false;
}

}  // namespace

struct InteriorTest::Impl {
  PolygonSet P, Q;
  ConvexPieces p, q;
  bool regions;

  Impl(const PolygonSet& P_, const PolygonSet& Q_)
      : P(P_), Q(Q_), p(P_), q(Q_), regions(has_area(P_) && has_area(Q_)) {}

  /// The greatest coordinate error of s a and of x - b.
  double error(double x, double y, double scale, double own) const {
    return own + 0x1p-48 * (p.magnitude * scale + q.magnitude + std::abs(x) + std::abs(y)) + 1e-300;
  }
  /// s a and x - b.
  std::pair<TriangleInDoubles, TriangleInDoubles> placed(std::uint32_t i, std::uint32_t j, double x,
                                                         double y, double scale) const {
    TriangleInDoubles a = p.doubles[i], b = q.doubles[j];
    for (auto& v : a) v = {v[0] * scale, v[1] * scale};
    for (auto& v : b) v = {x - v[0], y - v[1]};
    return {a, b};
  }

  /// Whether some s a and x - b meet: by doubles if they tell, else by `meet`.
  template <class Meet>
  bool some_pair(const Point& x, const Rational& scale, Meet&& meet) const {
    const FilteredPoint at(x);
    const Box box{below(at.x()), below(at.y()), above(at.x()), above(at.y())};
    const double s = to_double(scale), low = below(s), high = above(s);
    const double e = error(at.x(), at.y(), s, 0);
    const bool in_range = in_filter_range(s) && std::isfinite(e);  // so are all differences
    return p.tree.pairs_with(
        q.tree,
        [&](const Box& a, const Box& b) {
          if (!in_range) return scaled(a, low, high).overlaps(reflected(b, box));
          return a.xmin * s - e <= at.x() - b.xmin && a.xmax * s + e >= at.x() - b.xmax &&
                 a.ymin * s - e <= at.y() - b.ymin && a.ymax * s + e >= at.y() - b.ymax;
        },
        [&](std::uint32_t i, std::uint32_t j) {
          const auto [near_a, near_b] = placed(i, j, at.x(), at.y(), s);
          const auto known = in_range ? told(near_a, near_b, e) : std::nullopt;
          if (known) return *known;
          FilteredTriangle a, b;
          for (std::size_t k = 0; k < 3; ++k) {
            const Point &u = p.exact[i][k], &v = q.exact[j][k];
            a[k] = FilteredPoint(Point{u.x * scale, u.y * scale});
            b[k] = FilteredPoint(Point{x.x - v.x, x.y - v.y});
          }
          return meet(a, b);
        });
  }
};

InteriorTest::InteriorTest(const PolygonSet& P, const PolygonSet& Q)
    : impl_(std::make_unique<Impl>(P, Q)) {}
InteriorTest::~InteriorTest() = default;

bool InteriorTest::certainly_inside(double x, double y, double error, double scale) const {
  if (!impl_->regions || !in_filter_range(scale)) return false;
  const double e = impl_->error(x, y, scale, error);
  return impl_->p.tree.pairs_with(
      impl_->q.tree,
      [&](const Box& a, const Box& b) {
        return a.xmin * scale - e < x - b.xmin && a.xmax * scale + e > x - b.xmax &&
               a.ymin * scale - e < y - b.ymin && a.ymax * scale + e > y - b.ymax;
      },
      [&](std::uint32_t i, std::uint32_t j) {
        const auto [a, b] = impl_->placed(i, j, x, y, scale);
        return told(a, b, e).value_or(false);
      });
}

bool InteriorTest::inside(const Point& x, const Rational& scale) const {
  if (!impl_->regions) {
    return Membership(impl_->P, impl_->Q, scale).decide(x).contact == Contact::overlapping;
  }
  return impl_->some_pair(x, scale, [](const FilteredTriangle& a, const FilteredTriangle& b) {
    return !separates(a, b) && !separates(b, a);
  });
}

bool InteriorTest::in_sum_beside(const Point& x, const Point& towards,
                                 const Rational& scale) const {
  const Point back{-towards.x, -towards.y};
  return impl_->some_pair(x, scale, [&](const FilteredTriangle& a, const FilteredTriangle& b) {
    return !separates_after(towards, a, b) && !separates_after(back, b, a);
  });
}

}  // namespace minkref::inline plane
