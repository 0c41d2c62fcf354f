#include "reference/space/edges/collision.hpp"

#include <algorithm>
#include <vector>

#include "reference/number/error_free.hpp"

namespace minkref::inline space {
namespace {

/// A triangle with its edges, a flat face's piece with whole edges that may reach beyond, or a
/// single edge.
class Element {
 public:
  Element(const CollisionElements& surface, std::uint32_t number)
      : body_(surface.body), item_(surface.items[number]) {}
  bool is_piece() const { return item_.piece != nullptr; }
  bool is_triangle() const { return !is_piece() && !item_.is_edge; }
  bool has_face() const { return !item_.is_edge; }
  /// Counts sides; two for a single edge.
  std::size_t size() const { return is_piece() ? item_.piece->size : is_triangle() ? 3 : 2; }
  /// Requires a triangle or a single edge.
  const FilteredVector& corner(std::size_t k) const {
    if (!is_triangle()) return body_.points[k == 0 ? edge(0).from : edge(0).to];
    return body_.points[body_.triangles[item_.number].corners[k % 3]];
  }
  const FilteredVector& normal() const { return body_.triangles[item_.number].normal; }
  /// Counts edges; edge k of a triangle runs from corner(k) to corner(k + 1).
  std::size_t edges() const { return is_triangle() ? 3 : is_piece() ? 2 : 1; }
  const SpaceOperand::Edge& edge(std::size_t k) const {
    if (is_triangle()) return body_.edges[body_.triangles[item_.number].edges[k]];
    return body_.edges[is_piece() ? item_.piece->edges[k] : item_.number];
  }
  const FilteredVector& end(const SpaceOperand::Edge& edge, bool first) const {
    return body_.points[first ? edge.from : edge.to];
  }
  /// A point on a side's line, and the direction.
  const FilteredVector& start(std::size_t side) const {
    return is_piece() ? item_.piece->sides[side].start : corner(side);
  }
  template <class T>
  std::array<T, 3> along(std::size_t side) const {
    if (is_piece()) return item_.piece->sides[side].along.as<T>();
    return corner(side + 1).as<T>() - corner(side).as<T>();
  }

 private:
  const SpaceOperand& body_;
  const CollisionElements::Item& item_;
};

/// The plane of the points x for which x - q lies in the plane of a triangle with a corner p, and
/// so on: through p + q.
template <class T>
FormIn<T> form_through(const std::array<T, 3>& normal, const FilteredVector& p,
                       const FilteredVector& q) {
  return {normal, dot(normal, p.as<T>() + q.as<T>())};
}

/// Whether an edge pierces the face.
bool pierces(const NudgedPoint& x, SignCounts& signs, const Element& through, const Element& face) {
  if (!face.has_face()) return false;
  const auto height = [&](const FilteredVector& point) {
    return x.side(signs, [&]<class T>(std::type_identity<T>) {
      return form_through<T>(face.normal().as<T>(), face.start(0), point);
    });
  };
  for (std::size_t k = 0; k < through.edges(); ++k) {
    const SpaceOperand::Edge& edge = through.edge(k);
    const FilteredVector& from = through.end(edge, true);
    if (height(from) == height(through.end(edge, false))) continue;
    const auto turn = [&](std::size_t side) {
      return x.side(signs, [&]<class T>(std::type_identity<T>) {
        return form_through<T>(cross(face.along<T>(side), edge.direction.as<T>()), face.start(side),
                               from);
      });
    };
    const int first = turn(0);
    bool all = true;
    for (std::size_t side = 1; all && side < face.size(); ++side) all = turn(side) == first;
    if (all) return true;
  }
  return false;
}

}  // namespace

CollisionElements::CollisionElements(const SpaceOperand& body_, FlatPieces pieces_)
    : body(body_), pieces(std::move(pieces_)) {
  std::vector<SpaceBox> boxes;
  const auto add = [&](const Item& item, const SpaceBox& box) {
    items.push_back(item);
    boxes.push_back(box);
  };
  const auto in_pieces = [&](std::uint32_t t) {
    return !pieces.face_of.empty() && pieces.face_of[t] != space::none;
  };
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    if (!in_pieces(t)) add({nullptr, t, false}, body.box_of(t));
  }
  for (std::uint32_t t = 0; t < body.triangles.size(); ++t) {
    if (!in_pieces(t)) continue;
    auto& face = pieces.pieces[pieces.face_of[t]];
    if (face.triangle != t) continue;
    for (const FlatPiece& piece : face.pieces) {
      SpaceBox box;
      for (std::size_t k = 0; k < piece.size; ++k) {
        const FlatPiece::Corner& corner = piece.corners[k];
        box.add(box_around(rounded_point(corner.point, corner.weight, body.shift)));
      }
      add({&piece, t, false}, box);
    }
  }
  const auto add_edge = [&](std::uint32_t e) {
    SpaceBox box = box_around(body.points[body.edges[e].from].rounded);
    box.add(box_around(body.points[body.edges[e].to].rounded));
    add({nullptr, e, true}, box);
  };
  for (const auto& face : pieces.pieces) {
    for (const std::uint32_t e : face.bare_edges) add_edge(e);
  }
  if (body.is_segment()) add_edge(0);
  tree = SpaceBoxTree(std::move(boxes));
}

CollisionTrees::CollisionTrees(const SpaceOperand& P_, const SpaceOperand& Q_, InteriorCells cells_,
                               FlatPieces pieces_of_P, FlatPieces pieces_of_Q)
    : P(P_),
      Q(Q_),
      of_P(P, std::move(pieces_of_P)),
      of_Q(Q, std::move(pieces_of_Q)),
      cells(std::move(cells_)) {
  for (const FilteredVector& point : P.points) box_P.add(box_around(point.rounded));
  for (const FilteredVector& point : Q.points) box_Q.add(box_around(point.rounded));
}

bool Collision::contains(const NudgedPoint& x) {
  ++tests;
  if (trees_.cells.contain({&x.rounded(), 1})) {
    ++covered;
    return true;
  }
  return surfaces_cross(x) || vertex_inside(x, trees_.of_P, trees_.box_P, Q_) ||
         vertex_inside(x, trees_.of_Q, trees_.box_Q, P_);
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
  return trees_.of_P.tree.pairs_with(trees_.of_Q.tree, overlap,
                                     [&](std::uint32_t i, std::uint32_t j) {
                                       if (!meet(x, i, j)) return false;
                                       recent_[next_] = {i, j};
                                       next_ = (next_ + 1) % recent_.size();
                                       known_ = std::min(known_ + 1, recent_.size());
                                       return true;
                                     });
}

/// Two triangles in general position meet iff an edge of one pierces the other.
bool Collision::meet(const NudgedPoint& x, std::uint32_t of_P, std::uint32_t of_Q) {
  const Element p(trees_.of_P, of_P), q(trees_.of_Q, of_Q);
  if (p.is_piece() || q.is_piece()) {
    return pierces(x, signs, q, p) || pierces(x, signs, p, q);
  }
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
bool Collision::vertex_inside(const NudgedPoint& x, const CollisionElements& body,
                              const SpaceBox& box, const SpaceOperand& other) {
  if (body.body.triangles.empty()) return false;
  for (const std::uint32_t v : other.shell_vertices) {
    const SpaceBox at = box_around(x.rounded() - other.points[v].rounded);
    if (at.overlaps(box) && inside(x, body, other.points[v])) return true;
  }
  return false;
}

/// Whether the surface's winding number about x - v is positive, counted from the faces above along
/// the third axis.
bool Collision::inside(const NudgedPoint& x, const CollisionElements& body,
                       const FilteredVector& vertex) {
  SpaceBox column = box_around(x.rounded() - vertex.rounded);
  column.high[2] = SpaceBox::infinity;
  int winding = 0;
  body.tree.query(column, [&](std::uint32_t number) {
    const Element face(body, number);
    if (!face.has_face()) return false;
    const int facing = face.normal().exact[2].sign();
    if (facing == 0) return false;
    bool over = x.side(signs, [&]<class T>(std::type_identity<T>) {
      return form_through<T>(face.normal().as<T>(), face.start(0), vertex);
    }) != facing;
    for (std::size_t k = 0; over && k < face.size(); ++k) {
      over = x.side(signs, [&]<class T>(std::type_identity<T>) {
        const std::array<T, 3> along = face.along<T>(k);
        return form_through<T>({-along[1], along[0], T(0)}, face.start(k), vertex);
      }) == facing;
    }
    if (over) winding += facing;
    return false;
  });
  return winding > 0;
}

}  // namespace minkref::inline space
