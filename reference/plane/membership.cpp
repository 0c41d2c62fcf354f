#include <algorithm>
#include <array>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/overlap_filter.hpp"
#include "reference/plane/routes/simply_connected.hpp"
#include "reference/plane/witness.hpp"

namespace minkref::inline plane {
namespace {

/// A triangle, or a degenerate operand's segment or point.
using Piece = std::vector<FilteredPoint>;

std::vector<Piece> pieces_of(const PolygonSet& set) {
  std::vector<Piece> pieces;
  if (!has_area(set)) {
    for (const Polygon& part : set.polygons) pieces.push_back(filtered_ring(part.outer));
  }
  for (const Triangle& t : triangulate(set))
    pieces.push_back(filtered_ring(Ring(t.begin(), t.end())));
  return pieces;
}

Box box_of(const Piece& piece) {
  Box box;
  for (const FilteredPoint& p : piece)
    box.add({below(p.x()), below(p.y()), above(p.x()), above(p.y())});
  return box;
}

BoxTree tree_of(const std::vector<Piece>& pieces) {
  std::vector<Box> boxes;
  for (const Piece& piece : pieces) boxes.push_back(box_of(piece));
  return BoxTree(std::move(boxes));
}

/// The point reflection x - u keeps the orientation.
Piece reflected(const Piece& piece, const Point& x) {
  Piece result;
  for (const FilteredPoint& u : piece)
    result.emplace_back(Point{x.x - u.exact().x, x.y - u.exact().y});
  return result;
}

/// The contact of two convex pieces, judged by the edge lines of `a` alone.
Contact by_edges(const Piece& a, const Piece& b) {
  Contact contact = Contact::overlapping;
  for (std::size_t i = 0; a.size() > 1 && i < a.size(); ++i) {
    int most = -1;
    for (const FilteredPoint& p : b)
      most = std::max(most, orientation(a[i], a[(i + 1) % a.size()], p));
    if (most < 0) return Contact::empty;
    if (most == 0) contact = Contact::touching;
  }
  return contact;
}

/// Whether two pieces are points or segments on one line, or two points.
bool on_one_line(const Piece& a, const Piece& b) {
  if (a.size() > 2 || b.size() > 2) return false;
  if (a.size() == 1 && b.size() == 1) return true;
  const auto holds = [](const Piece& line, const Piece& other) {
    return std::all_of(other.begin(), other.end(), [&](const FilteredPoint& p) {
      return orientation(line[0], line[1], p) == 0;
    });
  };
  return a.size() == 2 ? holds(a, b) : holds(b, a);
}

/// By x, then y: the order of points along a line.
bool before(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Two pieces on a line share all between both ends; nothing if the first end comes after the
/// second.
std::array<Point, 2> shared_ends(const Piece& a, const Piece& b) {
  const auto [low, high] = std::minmax(a.front().exact(), a.back().exact(), before);
  const auto [least, most] = std::minmax(b.front().exact(), b.back().exact(), before);
  return {std::max(low, least, before), std::min(high, most, before)};
}

/// For convex pieces in the plane, separation by an edge line of either decides, but for two on one
/// line.
Contact meet(const Piece& a, const Piece& b) {
  if (on_one_line(a, b)) {
    const auto [low, high] = shared_ends(a, b);
    return before(high, low) ? Contact::empty : Contact::touching;
  }
  return std::min(by_edges(a, b), by_edges(b, a));
}

/// The part of a convex polygon on the left of the line through a and b, closed.
std::vector<Point> clipped(const std::vector<Point>& polygon, const Point& a, const Point& b) {
  const auto height = [&](const Point& p) -> Rational {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  };
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const Rational hp = height(p), hq = height(q);
    if (sign(hp) >= 0) result.push_back(p);
    if (sign(hp) * sign(hq) < 0) {
      const Rational t = hp / (hp - hq);
      result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return result;
}

/// The mean of the intersection's vertices: an interior point, if an interior exists.
Point common_point(const Piece& a, const Piece& b) {
  if (on_one_line(a, b)) {
    const auto [low, high] = shared_ends(a, b);
    return {(low.x + high.x) / 2, (low.y + high.y) / 2};
  }
  std::vector<Point> common;
  for (const FilteredPoint& p : a) common.push_back(p.exact());
  for (std::size_t i = 0; b.size() > 1 && i < b.size(); ++i) {
    common = clipped(common, b[i].exact(), b[(i + 1) % b.size()].exact());
  }
  if (b.size() == 1) return b[0].exact();
  if (b.size() == 2) {
    // Both directions leave the line of b; its ends are cut by the mean of what lies between them.
    common = {b[0].exact(), b[1].exact()};
    for (std::size_t i = 0; a.size() > 1 && i < a.size(); ++i) {
      common = clipped(common, a[i].exact(), a[(i + 1) % a.size()].exact());
    }
  }
  Point mean{0, 0};
  for (const Point& p : common) mean = {mean.x + p.x, mean.y + p.y};
  const Rational n = common.size();
  return {mean.x / n, mean.y / n};
}

/// Whether a point's or segment's relative interior meets a region's interior; cuts the segment at
/// the boundary.
bool meets_interior(const Piece& piece, const PolygonSet& region) {
  if (piece.size() == 1) return locate(region, piece[0].exact()) == Location::inside;
  const Point &a = piece[0].exact(), &b = piece[1].exact();
  const Rational dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  std::vector<Rational> cuts{Rational(0), Rational(1)};
  const auto add_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &c = ring[i], &d = ring[(i + 1) % ring.size()];
      const Rational ex = d.x - c.x, ey = d.y - c.y, det = dx * ey - dy * ex;
      // Extra cuts do no harm: the crossing with the edge's line, or the foot of the edge's start.
      cuts.push_back(sign(det) != 0 ? Rational(((c.x - a.x) * ey - (c.y - a.y) * ex) / det)
                                    : Rational(((c.x - a.x) * dx + (c.y - a.y) * dy) / square));
    }
  };
  for (const Polygon& polygon : region.polygons) {
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (cuts[i] < 0 || cuts[i + 1] > 1 || cuts[i] == cuts[i + 1]) continue;
    const Rational t = (cuts[i] + cuts[i + 1]) / 2;
    if (locate(region, {a.x + t * dx, a.y + t * dy}) == Location::inside) return true;
  }
  return false;
}

PolygonSet reflected(const PolygonSet& set, const Point& x) {
  return translated(scaled(set, -1), x);
}

}  // namespace

struct Membership::Impl {
  PolygonSet P, Q;
  Rational scale;
  std::vector<Piece> p, q;
  std::vector<NearTriangle> near_p, near_q;  ///< none for a point or a segment
  BoxTree p_tree, q_tree;

  static Box box_around(const FilteredPoint& at) {
    return {below(at.x()), below(at.y()), above(at.x()), above(at.y())};
  }

  /// Whether doubles find two triangles whose interiors meet.
  bool certainly_overlap(const Point& x) const {
    if (near_p.empty()) return false;
    const FilteredPoint at(x);
    const Box box = box_around(at);
    return p_tree.pairs_with(
        q_tree, [&](const Box& a, const Box& b) { return a.overlaps(minkref::reflected(b, box)); },
        [&](std::uint32_t i, std::uint32_t j) {
          return minkref::certainly_overlap(near_p[i], near_q[j], at);
        });
  }

  Witness decide(const Point& x) const {
    Witness result;
    result.point = x;
    const Box box = box_around(FilteredPoint(x));
    std::optional<std::pair<std::uint32_t, std::uint32_t>> found;
    p_tree.pairs_with(
        q_tree, [&](const Box& a, const Box& b) { return a.overlaps(minkref::reflected(b, box)); },
        [&](std::uint32_t i, std::uint32_t j) {
          const Contact contact = meet(p[i], reflected(q[j], x));
          if (contact > result.contact) {
            result.contact = contact;
            found = {i, j};
          }
          return contact == Contact::overlapping;
        });
    if (!found) return result;
    const Point point = common_point(p[found->first], reflected(q[found->second], x));
    result.p = Point{point.x / scale, point.y / scale};
    result.q = Point{x.x - point.x, x.y - point.y};
    // A point or segment along an inner edge of the triangulation only touches triangles.
    if (!has_area(P)) {
      const PolygonSet region = reflected(Q, x);
      result.contact =
          contact_of(p, [&](const Piece& each) { return meets_interior(each, region); });
    } else if (!has_area(Q)) {
      result.contact =
          contact_of(q, [&](const Piece& each) { return meets_interior(reflected(each, x), P); });
    }
    return result;
  }

  /// For points and segments that touch a region or more.
  template <class Meets>
  static Contact contact_of(const std::vector<Piece>& thin, Meets&& meets) {
    return std::any_of(thin.begin(), thin.end(), meets) ? Contact::overlapping : Contact::touching;
  }
};

Membership::Membership(const PolygonSet& P, const PolygonSet& Q, const Rational& scale)
    : impl_(std::make_unique<Impl>()) {
  const FloatEnvironment standard;
  if (sign(scale) <= 0) {
    throw BadInput("bad-scale", "the scale " + to_string(scale) + " is not greater than zero",
                   "give a scale s > 0");
  }
  impl_->P = scaled(P, scale);
  impl_->Q = Q;
  impl_->scale = scale;
  impl_->p = pieces_of(impl_->P);
  impl_->q = pieces_of(Q);
  if (has_area(impl_->P) && has_area(Q)) {
    for (const Piece& triangle : impl_->p) impl_->near_p.emplace_back(triangle);
    for (const Piece& triangle : impl_->q) impl_->near_q.emplace_back(triangle);
  }
  impl_->p_tree = tree_of(impl_->p);
  impl_->q_tree = tree_of(impl_->q);
}
Membership::~Membership() = default;
Membership::Membership(Membership&&) noexcept = default;

Witness Membership::decide(const Point& x) const {
  const FloatEnvironment standard;
  return impl_->decide(x);
}

Contact Membership::contact(const Point& x) const {
  const FloatEnvironment standard;
  return impl_->certainly_overlap(x) ? Contact::overlapping : impl_->decide(x).contact;
}

Witness decide(const PolygonSet& P, const PolygonSet& Q, const Rational& scale, const Point& x) {
  const FloatEnvironment standard;
  return Membership(P, Q, scale).decide(x);
}

}  // namespace minkref::inline plane
