#include "reference/scene/edge_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/no_entry.hpp"
#include "reference/number/bounded_double.hpp"

namespace minkref::inline scene {
namespace {

/// The coordinate that a filtered point's double stands for.
BoundedDouble bounded(double nearest) {
  return {nearest, std::abs(nearest) * 0x1p-53 + std::numeric_limits<double>::denorm_min()};
}

BoundedDouble cross(const BoundedDouble& ux, const BoundedDouble& uy, const BoundedDouble& vx,
                    const BoundedDouble& vy) {
  return ux * vy - uy * vx;
}

void set_share(EdgeContact& contact, const BoundedDouble& share) {
  contact.t = share.value;
  contact.error = share.error;
}

}  // namespace

/// A sum's edge beside the edge.
struct ContactEdge::SumEdge {
  const PlacedSum& sum;
  std::uint32_t neighbour, edge;
  const FilteredPoint& start() const { return sum.start(edge); }
  const FilteredPoint& end() const { return sum.end(edge); }
};

void ContactEdge::set(const FilteredPoint& from, const FilteredPoint& to, const Box& box) {
  from_ = &from;
  to_ = &to;
  box_ = box;
  exact_.clear();
  by_x_ = std::abs(to.x() - from.x()) >= std::abs(to.y() - from.y());
  way_ = by_x_ ? compare_x(to, from) : compare_y(to, from);
  if (way_ != 0) return;
  by_x_ = !by_x_;
  way_ = by_x_ ? compare_x(to, from) : compare_y(to, from);
}

int ContactEdge::order(const FilteredPoint& a, const FilteredPoint& b) const {
  return way_ * (by_x_ ? compare_x(a, b) : compare_y(a, b));
}

ContactEdge::Part ContactEdge::part(const FilteredPoint& on_line) const {
  const int after_start = order(on_line, *from_);
  if (after_start <= 0) return after_start == 0 ? at_start : ahead;
  const int after_end = order(on_line, *to_);
  return after_end < 0 ? inside : after_end == 0 ? at_end : behind;
}

EndContacts ContactEdge::meet(const PlacedSum& sum, std::uint32_t neighbour,
                              std::vector<EdgeContact>& contacts) const {
  EndContacts ends;
  sum.near(box_, [&](std::uint32_t edge) {
    const SumEdge other{sum, neighbour, edge};
    const int p = orientation(*from_, *to_, other.start());
    const int q = sum.is_point(edge) ? p : orientation(*from_, *to_, other.end());
    if (p == 0 && q == 0) {
      meet_along(other, ends, contacts);
    } else if (p == 0) {
      meet_at_vertex(other, true, q, ends, contacts);
    } else if (q == 0) {
      meet_at_vertex(other, false, p, ends, contacts);
    } else if (p != q) {
      meet_across(other, p, ends, contacts);
    }
  });
  return ends;
}

void ContactEdge::touch(const PlacedSum& sum, std::uint32_t vertex, EdgeContact contact,
                        std::vector<EdgeContact>& contacts) const {
  const auto measure = [&](const FilteredPoint& p) { return bounded(by_x_ ? p.x() : p.y()); };
  const BoundedDouble first = measure(*from_);
  set_share(contact, (measure(sum.points[vertex]) - first) / (measure(*to_) - first));
  contact.vertex = vertex;
  contacts.push_back(contact);
}

void ContactEdge::touch_end(const SumEdge& other, bool starts, int right, int along,
                            std::vector<EdgeContact>& contacts) const {
  EdgeContact contact;
  contact.neighbour = other.neighbour;
  contact.edge = other.edge;
  contact.right = static_cast<std::int8_t>(right);
  contact.along = static_cast<std::int8_t>(along);
  const SceneSum::Edge& edge = other.sum.sum->edges[other.edge];
  touch(other.sum, starts ? edge.from : edge.to, contact, contacts);
}

void ContactEdge::meet_along(const SumEdge& other, EndContacts& ends,
                             std::vector<EdgeContact>& contacts) const {
  const Part p = part(other.start()), q = part(other.end());
  const Part low = std::min(p, q), high = std::max(p, q);
  const bool same_way = p == q ? order(other.start(), other.end()) < 0 : p < q;
  ends.start = ends.start || (low <= at_start && high >= at_start);
  ends.end = ends.end || (low <= at_end && high >= at_end);
  if (other.sum.is_point(other.edge)) {
    if (p == inside) touch_end(other, true, 0, 0, contacts);
    return;
  }
  const bool shares = low <= inside && high >= inside;
  if (!shares) return;
  if (low <= at_start) ++ends.along;
  if (p == inside) touch_end(other, true, 0, same_way ? 1 : -1, contacts);
  if (q == inside) touch_end(other, false, 0, same_way ? -1 : 1, contacts);
}

void ContactEdge::meet_at_vertex(const SumEdge& other, bool starts, int side, EndContacts& ends,
                                 std::vector<EdgeContact>& contacts) const {
  const Part at = part(starts ? other.start() : other.end());
  ends.start = ends.start || at == at_start;
  ends.end = ends.end || at == at_end;
  if (at != inside) return;
  const bool boundary = other.sum.is_boundary(other.edge);
  // The edge passes from the line, which counts as the left, to `side`, or comes from there.
  const int right = !boundary || side > 0 ? 0 : starts ? 1 : -1;
  // Another edge starts at a ring's vertex, and reports it.
  if (!boundary || starts || right != 0) touch_end(other, starts, right, 0, contacts);
}

void ContactEdge::meet_across(const SumEdge& other, int side, EndContacts& ends,
                              std::vector<EdgeContact>& contacts) const {
  const FilteredPoint &p = other.start(), &q = other.end();
  const int a = orientation(p, q, *from_), b = orientation(p, q, *to_);
  ends.start = ends.start || a == 0;
  ends.end = ends.end || b == 0;
  if (a * b >= 0) return;
  EdgeContact contact;
  contact.neighbour = other.neighbour;
  contact.edge = other.edge;
  contact.vertex = no_entry;
  contact.right = static_cast<std::int8_t>(other.sum.is_boundary(other.edge) ? side : 0);
  const BoundedDouble px = bounded(p.x()), py = bounded(p.y()), ax = bounded(from_->x()),
                      ay = bounded(from_->y());
  const BoundedDouble vx = bounded(q.x()) - px, vy = bounded(q.y()) - py;
  set_share(contact, cross(px - ax, py - ay, vx, vy) /
                         cross(bounded(to_->x()) - ax, bounded(to_->y()) - ay, vx, vy));
  contacts.push_back(contact);
}

int ContactEdge::winding_beside(const PlacedSum& sum) const {
  const FilteredPoint& at = *from_;
  const int rise = compare_y(*to_, at);
  // A level edge to the right has its right side below.
  const bool above_start = rise != 0 ? rise > 0 : compare_x(*to_, at) < 0;
  Box level = box_of(at);
  level.xmax = std::numeric_limits<double>::infinity();
  int winding = 0;
  sum.near(level, [&](std::uint32_t edge) {
    if (!sum.is_boundary(edge)) return;
    const FilteredPoint &p = sum.start(edge), &q = sum.end(edge);
    const int yp = compare_y(p, at), yq = compare_y(q, at);
    const bool p_below = above_start ? yp <= 0 : yp < 0, q_below = above_start ? yq <= 0 : yq < 0;
    if (p_below == q_below) return;
    int side = orientation(p, q, at);
    if (side == 0) side = turn(p, q, at, *to_);
    if (side == 0) side = (rise > 0) == p_below ? -1 : 1;  // along the edge: beside it on the right
    if (p_below && side > 0) ++winding;
    if (q_below && side < 0) --winding;
  });
  return winding;
}

int ContactEdge::certain_order(const EdgeContact& a, const EdgeContact& b) {
  const double difference = b.t - a.t;
  const double bound = (a.error + b.error) * 1.01 + std::abs(difference) * 0x1p-50 + 0x1p-1000;
  return difference > bound ? -1 : difference < -bound ? 1 : 0;
}

int ContactEdge::exact_order(const EdgeContact& a, const PlacedSum& sum_a, const EdgeContact& b,
                             const PlacedSum& sum_b) {
  if (a.neighbour == b.neighbour && a.vertex != no_entry && a.vertex == b.vertex) return 0;
  const Rational &s = exact(a, sum_a), &t = exact(b, sum_b);
  return s < t ? -1 : t < s ? 1 : 0;
}

const Rational& ContactEdge::exact(const EdgeContact& contact, const PlacedSum& sum) {
  if (contact.exact >= 0) return exact_[static_cast<std::size_t>(contact.exact)];
  contact.exact = static_cast<std::int32_t>(exact_.size());
  const Point &a = from_->exact(), &b = to_->exact();
  if (contact.vertex != no_entry) {
    const Point& p = sum.points[contact.vertex].exact();
    exact_.push_back(by_x_ ? (p.x - a.x) / (b.x - a.x) : (p.y - a.y) / (b.y - a.y));
    return exact_.back();
  }
  const Point &p = sum.start(contact.edge).exact(), &q = sum.end(contact.edge).exact();
  const Rational vx = q.x - p.x, vy = q.y - p.y;
  exact_.push_back(((p.x - a.x) * vy - (p.y - a.y) * vx) / ((b.x - a.x) * vy - (b.y - a.y) * vx));
  return exact_.back();
}

FilteredPoint ContactEdge::point(const EdgeContact& contact, const PlacedSum& sum) {
  if (contact.vertex != no_entry) return sum.points[contact.vertex];
  const Rational& t = exact(contact, sum);
  const Point &a = from_->exact(), &b = to_->exact();
  return FilteredPoint({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

}  // namespace minkref::inline scene
