#include "reference/space/edges/collision.hpp"

#include <algorithm>
#include <vector>

#include "reference/number/error_free.hpp"

namespace minkref::inline space {
namespace {

std::vector<SpaceBox> element_boxes(const SpaceOperand& body) {
  std::vector<SpaceBox> boxes;
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) boxes.push_back(body.box_of(t));
  if (body.is_segment()) {
    SpaceBox box;
    for (const FilteredVector& point : body.points) box.add(box_around(point.rounded));
    boxes.push_back(box);
  }
  return boxes;
}

/// A triangle's corners, or the segment's ends.
class Element {
 public:
  Element(const SpaceOperand& body, std::uint32_t number) : body_(body), number_(number) {}
  bool is_triangle() const { return !body_.is_segment(); }
  std::size_t size() const { return is_triangle() ? 3 : 2; }
  const FilteredVector& corner(std::size_t k) const {
    if (!is_triangle()) return body_.points[k];
    return body_.points[body_.triangles[number_].corners[k % 3]];
  }
  const FilteredVector& normal() const { return body_.triangles[number_].normal; }
  /// The edge count; edge k runs from corner(k) to corner(k + 1).
  std::size_t edges() const { return is_triangle() ? 3 : 1; }

 private:
  const SpaceOperand& body_;
  std::uint32_t number_;
};

/// The plane of the points x for which x - q lies in the plane of a triangle with a corner p, and
/// so on: through p + q.
template <class T>
FormIn<T> form_through(const std::array<T, 3>& normal, const FilteredVector& p,
                       const FilteredVector& q) {
  return {normal, dot(normal, p.as<T>() + q.as<T>())};
}

}  // namespace

CollisionTrees::CollisionTrees(const SpaceOperand& P_, const SpaceOperand& Q_, InteriorCells cells_)
    : P(P_), Q(Q_), tree_P(element_boxes(P)), tree_Q(element_boxes(Q)), cells(std::move(cells_)) {
  for (const FilteredVector& point : P.points) box_P.add(box_around(point.rounded));
  for (const FilteredVector& point : Q.points) box_Q.add(box_around(point.rounded));
}

bool Collision::contains(const NudgedPoint& x) {
  ++tests;
  if (trees_.cells.contain({&x.rounded(), 1})) {
    ++covered;
    return true;
  }
  return surfaces_cross(x) || vertex_inside(x, P_, trees_.tree_P, trees_.box_P, Q_) ||
         vertex_inside(x, Q_, trees_.tree_Q, trees_.box_Q, P_);
}

bool Collision::surfaces_cross(const NudgedPoint& x) {
  for (std::size_t k = 0; k < known_; ++k) {
    if (meet(x, recent_[k].of_P, recent_[k].of_Q)) return true;
  }
  const SpaceBox at = box_around(x.rounded());
  // Where a bound equals x the step from x decides: facets in the piece's own plane drop out.
  const auto overlap = [&](const SpaceBox& p, const SpaceBox& q) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double low = at.low[k], high = at.high[k];
      const double most = p.high[k] + q.high[k], least = p.low[k] + q.low[k];
      if (low > most || high < least) return false;
      if (low == most) {
        const double left = error_free::sum_residual(p.high[k], q.high[k], most);
        if (left < 0 || (left == 0 && x.step(k) > 0)) return false;
      }
      if (high == least) {
        const double left = error_free::sum_residual(p.low[k], q.low[k], least);
        if (left > 0 || (left == 0 && x.step(k) < 0)) return false;
      }
    }
    return true;
  };
  return trees_.tree_P.pairs_with(trees_.tree_Q, overlap, [&](std::uint32_t i, std::uint32_t j) {
    if (!meet(x, i, j)) return false;
    recent_[next_] = {i, j};
    next_ = (next_ + 1) % recent_.size();
    known_ = std::min(known_ + 1, recent_.size());
    return true;
  });
}

/// Two triangles in general position meet iff an edge of one pierces the other.
bool Collision::meet(const NudgedPoint& x, std::uint32_t of_P, std::uint32_t of_Q) {
  const Element p(P_, of_P), q(Q_, of_Q);
  std::array<int, 3> height_of_P{}, height_of_Q{};  // over the plane of the other, up to reversal
  const auto same = [](const std::array<int, 3>& heights, std::size_t count) {
    return std::all_of(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](int h) { return h == heights[0]; });
  };
  if (p.is_triangle()) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      height_of_Q[j] = x.side(signs, [&]<class T>(std::type_identity<T>) {
        return form_through<T>(p.normal().as<T>(), p.corner(0), q.corner(j));
      });
    }
    if (same(height_of_Q, q.size())) return false;
  }
  if (q.is_triangle()) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      height_of_P[i] = x.side(signs, [&]<class T>(std::type_identity<T>) {
        return form_through<T>(q.normal().as<T>(), p.corner(i), q.corner(0));
      });
    }
    if (same(height_of_P, p.size())) return false;
  }
  constexpr int unknown = 7;
  std::array<std::array<int, 3>, 3> turns;  // of edge i of P about edge j of Q
  for (auto& row : turns) row.fill(unknown);
  const auto turn = [&](std::size_t i, std::size_t j) {
    if (turns[i][j] == unknown) {
      turns[i][j] = x.side(signs, [&]<class T>(std::type_identity<T>) {
        const std::array<T, 3> along_P = p.corner(i + 1).as<T>() - p.corner(i).as<T>();
        const std::array<T, 3> along_Q = q.corner(j + 1).as<T>() - q.corner(j).as<T>();
        return form_through<T>(cross(along_P, along_Q), p.corner(i), q.corner(j));
      });
    }
    return turns[i][j];
  };
  if (q.is_triangle()) {
    for (std::size_t i = 0; i < p.edges(); ++i) {
      if (height_of_P[i] != height_of_P[(i + 1) % p.size()] && turn(i, 0) == turn(i, 1) &&
          turn(i, 1) == turn(i, 2)) {
        return true;
      }
    }
  }
  if (p.is_triangle()) {
    for (std::size_t j = 0; j < q.edges(); ++j) {
      if (height_of_Q[j] != height_of_Q[(j + 1) % q.size()] && turn(0, j) == turn(1, j) &&
          turn(1, j) == turn(2, j)) {
        return true;
      }
    }
  }
  return false;
}

/// Whether x - v lies inside a body, for some v among one vertex per shell of the other body.
bool Collision::vertex_inside(const NudgedPoint& x, const SpaceOperand& body,
                              const SpaceBoxTree& triangles, const SpaceBox& box,
                              const SpaceOperand& other) {
  if (body.triangles.empty()) return false;
  for (const std::uint32_t v : other.shell_vertices) {
    const SpaceBox at = box_around(x.rounded() - other.points[v].rounded);
    if (at.overlaps(box) && inside(x, body, triangles, other.points[v])) return true;
  }
  return false;
}

/// Whether the surface's winding number about x - v is positive, counted from the triangles above
/// along the third axis.
bool Collision::inside(const NudgedPoint& x, const SpaceOperand& body,
                       const SpaceBoxTree& triangles, const FilteredVector& vertex) {
  SpaceBox column = box_around(x.rounded() - vertex.rounded);
  column.high[2] = SpaceBox::infinity;
  int winding = 0;
  triangles.query(column, [&](std::uint32_t t) {
    const SpaceOperand::Triangle& triangle = body.triangles[t];
    const int facing = triangle.normal.exact[2].sign();
    if (facing == 0) return false;
    const auto corner = [&](std::size_t k) -> const FilteredVector& {
      return body.points[triangle.corners[k % 3]];
    };
    bool over = x.side(signs, [&]<class T>(std::type_identity<T>) {
      return form_through<T>(triangle.normal.as<T>(), corner(0), vertex);
    }) != facing;
    for (std::size_t k = 0; over && k < 3; ++k) {
      over = x.side(signs, [&]<class T>(std::type_identity<T>) {
        const std::array<T, 3> along = corner(k + 1).as<T>() - corner(k).as<T>();
        return form_through<T>({-along[1], along[0], T(0)}, corner(k), vertex);
      }) == facing;
    }
    if (over) winding += facing;
    return false;
  });
  return winding > 0;
}

}  // namespace minkref::inline space
