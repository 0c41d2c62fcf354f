// Refusals of operands, with the place at fault.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/near/edge_tree.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/number/message_number.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/left_rays.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {
namespace {

/// The limit for each edge; beyond it boxes are no help.
constexpr std::size_t most_pairs_by_boxes = 48;

std::string text(const Point& p) {
  return "(" + message_text(p.x) + ", " + message_text(p.y) + ")";
}

struct RingInSet {
  const Ring* ring;
  bool outer;
  std::size_t polygon;
};

class Validator {
 public:
  Validator(const PolygonSet& set, Lines lines) : set_(set), lines_(lines) {
    for (std::size_t p = 0; p < set.polygons.size(); ++p) {
      rings_.push_back({&set.polygons[p].outer, true, p});
      for (const Ring& hole : set.polygons[p].holes) rings_.push_back({&hole, false, p});
      is_without_area_ &= set.polygons[p].outer.size() < 3 && set.polygons[p].holes.empty();
    }
  }

  void run() {
    for (std::size_t r = 0; r < rings_.size(); ++r) check_vertices(r);
    if (is_lines(set_) && lines_ == Lines::refused) {
      throw BadInput("open-lines", "the operand consists of several segments or points",
                     "give one segment or one point, or a region; `minkref sum` takes lines");
    }
    if (!has_area(set_)) return;
    for (const RingInSet& ring : rings_) {
      filtered_.push_back(filtered_ring(*ring.ring));
      // Rounding is monotone: if rings overlap, the boxes of their doubles overlap.
      Box box;
      for (const FilteredPoint& p : filtered_.back()) box.add({p.x(), p.y(), p.x(), p.y()});
      boxes_.push_back(box);
    }
    for (std::size_t r = 0; r < rings_.size(); ++r) check_extent(r);
    check_contacts();
    for (std::size_t r = 0; r < rings_.size(); ++r) check_orientation(r);
    check_nesting();
  }

 private:
  struct Edge {
    std::size_t ring, index;
  };

  Place place(std::size_t ring, std::vector<std::size_t> vertices) const {
    Place result;
    result.ring = ring;
    for (const std::size_t v : vertices)
      result.coordinates.push_back(text((*rings_[ring].ring)[v]));
    result.vertices = std::move(vertices);
    return result;
  }
  Place place(std::size_t ring, std::vector<std::size_t> vertices, std::size_t other_ring,
              std::vector<std::size_t> other_vertices) const {
    Place result = place(ring, std::move(vertices));
    for (const std::size_t v : other_vertices) {
      result.coordinates.push_back(text((*rings_[other_ring].ring)[v]));
    }
    result.other_ring = other_ring;
    result.other_vertices = std::move(other_vertices);
    return result;
  }
  std::size_t size(std::size_t ring) const { return rings_[ring].ring->size(); }
  std::size_t following(Edge e) const { return (e.index + 1) % size(e.ring); }
  const FilteredPoint& start(Edge e) const { return filtered_[e.ring][e.index]; }
  const FilteredPoint& end(Edge e) const { return filtered_[e.ring][following(e)]; }

  void check_vertices(std::size_t r) const {
    const Ring& ring = *rings_[r].ring;
    if (ring.empty() || (ring.size() < 3 && !is_without_area_)) {
      std::vector<std::size_t> all(ring.size());
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
      throw BadInput("too-few-vertices", "a ring has " + std::to_string(ring.size()) + " vertices",
                     "give at least three, or points and segments alone as the operand",
                     place(r, std::move(all)));
    }
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) {
      const std::size_t next = (i + 1) % ring.size();
      if (ring[i] == ring[next]) {
        throw BadInput("zero-length-edge", "two consecutive vertices are equal",
                       "remove one of them", place(r, {i, next}));
      }
    }
  }

  /// Refuses a ring with all vertices on one line.
  void check_extent(std::size_t r) const {
    const FilteredRing& ring = filtered_[r];
    for (std::size_t i = 2; i < ring.size(); ++i) {
      if (orientation(ring[0], ring[1], ring[i]) != 0) return;
    }
    throw BadInput("zero-area", "all vertices of a ring lie on one line",
                   "remove the ring, or give a segment by its two ends", place(r, {0, 1, 2}));
  }

  void check_contacts() const {
    std::vector<Edge> edges;
    std::vector<Box> boxes;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t i = 0; i < size(r); ++i) {
        const Edge e{r, i};
        edges.push_back(e);
        Box box{start(e).x(), start(e).y(), start(e).x(), start(e).y()};
        box.add({end(e).x(), end(e).y(), end(e).x(), end(e).y()});
        boxes.push_back(box);  // rounding is monotone: exact overlaps remain overlaps
      }
    }
    // Reports the input's first fault. Edges are asked in input order, so that a ring with
    // crossings everywhere does not need all pairs.
    const BoxTree tree(boxes);
    std::size_t pairs_left = most_pairs_by_boxes * edges.size();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      std::optional<std::uint32_t> least;
      const bool are_too_many = tree.query(boxes[i], [&](std::uint32_t j) {
        if (j > i && (!least || j < *least) && refusal(edges[i], edges[j])) least = j;
        return pairs_left > 0 && --pairs_left == 0;
      });
      if (are_too_many) return check_near_contacts(edges);
      if (least) throw *refusal(edges[i], edges[*least]);
    }
  }

  /// A power of two that brings coordinates relative to a point into the range of doubles.
  Rational near_unit(const Point& origin) const {
    Rational most = 0;
    for (const FilteredRing& ring : filtered_) {
      for (const FilteredPoint& p : ring) {
        look_for_interrupt();
        most = std::max(
            {most, Rational(abs(p.exact().x - origin.x)), Rational(abs(p.exact().y - origin.y))});
      }
    }
    if (most == 0) return 1;
    const long exponent =
        static_cast<long>(msb(numerator(most))) - static_cast<long>(msb(denominator(most)));
    const Integer power = Integer(1) << static_cast<unsigned long>(std::labs(exponent));
    return exponent > 0 ? Rational(Integer(1), power) : Rational(power);
  }

  /// As check_contacts, for edges whose boxes overlap far more often than the edges meet, as in a
  /// star. Leaves out only pairs that lie apart.
  void check_near_contacts(const std::vector<Edge>& edges) const {
    std::vector<std::uint32_t> first_point;
    std::vector<NearPoint> points;
    const Point& origin = filtered_[0][0].exact();
    const Rational unit = near_unit(origin);
    for (const FilteredRing& ring : filtered_) {
      first_point.push_back(static_cast<std::uint32_t>(points.size()));
      for (const FilteredPoint& p : ring) {
        look_for_interrupt();
        const Enclosure x = enclose((p.exact().x - origin.x) * unit),
                        y = enclose((p.exact().y - origin.y) * unit);
        points.push_back({{x.lower, y.lower, 0}, std::max(x.upper - x.lower, y.upper - y.lower)});
      }
    }
    std::vector<EdgeTree::Edge> ends;
    for (const Edge& edge : edges) {
      const std::uint32_t first = first_point[edge.ring];
      ends.push_back({static_cast<std::uint32_t>(first + edge.index),
                      static_cast<std::uint32_t>(first + following(edge))});
    }
    std::optional<std::pair<std::uint32_t, std::uint32_t>> least;
    EdgeTree(std::move(points), ends).pairs([&](std::uint32_t i, std::uint32_t j) {
      if (least && *least < std::pair(i, j)) return;
      if (refusal(edges[i], edges[j])) least = {i, j};
    });
    if (least) throw *refusal(edges[least->first], edges[least->second]);
  }

  /// The fault in the way two edges meet, if any.
  std::optional<BadInput> refusal(Edge a, Edge b) const {
    const bool same = a.ring == b.ring;
    const auto self = [&](const char* problem) {
      return BadInput("self-intersection", problem,
                      "make the ring simple: split it where it meets itself, or move a vertex",
                      place(a.ring, {a.index, following(a), b.index, following(b)}));
    };
    const auto between = [&](const char* code, const char* problem, const char* mend) {
      return BadInput(code, problem, mend,
                      place(a.ring, {a.index, following(a)}, b.ring, {b.index, following(b)}));
    };
    const int b0 = orientation(start(a), end(a), start(b)),
              b1 = orientation(start(a), end(a), end(b));
    if (b0 == 0 && b1 == 0) {
      // One line: compares ranges.
      auto [alow, ahigh] = range(a);
      auto [blow, bhigh] = range(b);
      const FilteredPoint& low = compare_xy(*alow, *blow) > 0 ? *alow : *blow;
      const FilteredPoint& high = compare_xy(*ahigh, *bhigh) < 0 ? *ahigh : *bhigh;
      const int gap = compare_xy(low, high);
      if (gap < 0) {
        if (same) return self("two edges of a ring overlap");
        return between("overlapping-rings", "two rings overlap along an edge",
                       "rings may touch at single points only: move one, or unite two polygons, as "
                       "`minkref union` does");
      }
      if (gap > 0 || (same && adjacent(a, b))) return std::nullopt;
      if (same) return self("a ring touches itself");
      return crossing_at(a, b, low) ? std::optional(crossed(a, b)) : std::nullopt;
    }
    const int a0 = orientation(start(b), end(b), start(a)),
              a1 = orientation(start(b), end(b), end(a));
    if (b0 * b1 > 0 || a0 * a1 > 0) return std::nullopt;
    if (same) {
      if (adjacent(a, b)) return std::nullopt;  // the edges meet at their common vertex only
      return self(b0 * b1 < 0 && a0 * a1 < 0 ? "two edges of a ring cross"
                                             : "a ring touches itself");
    }
    if (b0 * b1 < 0 && a0 * a1 < 0) return crossed(a, b);
    const FilteredPoint& at = b0 == 0 ? start(b) : b1 == 0 ? end(b) : a0 == 0 ? start(a) : end(a);
    return crossing_at(a, b, at) ? std::optional(crossed(a, b)) : std::nullopt;
  }

  BadInput crossed(Edge a, Edge b) const {
    return {"crossing-rings", "two rings cross",
            "rings may touch at single points only: make one lie on one side of the other, or "
            "unite two polygons, as `minkref union` does",
            place(a.ring, {a.index, following(a)}, b.ring, {b.index, following(b)})};
  }

  bool adjacent(Edge a, Edge b) const { return following(a) == b.index || following(b) == a.index; }

  std::pair<const FilteredPoint*, const FilteredPoint*> range(Edge e) const {
    return compare_xy(start(e), end(e)) < 0 ? std::pair(&start(e), &end(e))
                                            : std::pair(&end(e), &start(e));
  }

  /// The far ends of the two rays along which a ring leaves a point of edge e.
  std::pair<const FilteredPoint*, const FilteredPoint*> rays(Edge e,
                                                             const FilteredPoint& at) const {
    const std::size_t n = size(e.ring);
    const FilteredRing& ring = filtered_[e.ring];
    if (compare_xy(at, start(e)) == 0) return {&ring[(e.index + n - 1) % n], &end(e)};
    if (compare_xy(at, end(e)) == 0) return {&start(e), &ring[(e.index + 2) % n]};
    return {&start(e), &end(e)};
  }

  /// Whether two rings that touch at a point pass through each other there: one ring's rays
  /// separate the other's.
  bool crossing_at(Edge a, Edge b, const FilteredPoint& at) const {
    const auto [a_in, a_out] = rays(a, at);
    const auto [b_in, b_out] = rays(b, at);
    const auto left_of_a = [&, from = a_out, to = a_in](const FilteredPoint& p) {
      const int wedge = orientation(at, *from, *to);
      const int after = orientation(at, *from, p), before = orientation(at, p, *to);
      if (wedge > 0) return after > 0 && before > 0;
      if (wedge < 0) return after > 0 || before > 0;
      return after > 0;
    };
    // Coincident rays mean overlapping edges: their own pair reports this fault.
    for (const FilteredPoint* p : {a_in, a_out}) {
      for (const FilteredPoint* q : {b_in, b_out}) {
        const bool one_side = compare_xy(at, *p) * compare_xy(at, *q) > 0;
        if (one_side && orientation(at, *p, *q) == 0) return false;
      }
    }
    return left_of_a(*b_in) != left_of_a(*b_out);
  }

  void check_orientation(std::size_t r) const {
    const int turn = sign(doubled_area(*rings_[r].ring));
    if (rings_[r].outer ? turn > 0 : turn < 0) return;
    throw BadInput(
        "wrong-orientation",
        rings_[r].outer ? "an outer ring runs clockwise" : "a hole runs counter-clockwise",
        "reverse the ring: outer rings run counter-clockwise, holes clockwise",
        place(r, {0, 1, 2}));
  }

  /// For rings that do not cross: whether `inner` lies inside `outer` (touching allowed).
  bool within(std::size_t inner, std::size_t outer) const {
    const FilteredRing& ring = filtered_[inner];
    for (const FilteredPoint& p : ring) {
      look_for_interrupt();
      const Location location = locate(filtered_[outer], p);
      if (location != Location::boundary) return location == Location::inside;
    }
    // All vertices touch: tests parts of edges between points where vertices of `outer` touch.
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i].exact(), &b = ring[(i + 1) % ring.size()].exact();
      const std::vector<Point> cuts = contacts(a, b, outer);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const FilteredPoint middle(
            Point{(cuts[k].x + cuts[k + 1].x) / 2, (cuts[k].y + cuts[k + 1].y) / 2});
        const Location location = locate(filtered_[outer], middle);
        if (location != Location::boundary) return location == Location::inside;
      }
    }
    return false;  // not reached: the rings would overlap
  }

  /// The ends of an edge and a ring's vertices on the edge, sorted along it.
  std::vector<Point> contacts(const Point& a, const Point& b, std::size_t other) const {
    std::vector<Point> found{a, b};
    for (const FilteredPoint& filtered : filtered_[other]) {
      look_for_interrupt();
      const Point& p = filtered.exact();
      const Rational along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      const Rational length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      const Rational off = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      if (off == 0 && along > 0 && along < length) found.push_back(p);
    }
    std::sort(found.begin(), found.end(),
              [](const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Rings do not cross, so one point of each tells what lies around the ring. From the least
  /// points on, a ray to the left meets an edge first: what lies on its near side is known, and
  /// must be the outside for an outer ring, the material of its own polygon for a hole. Rings that
  /// touch another at their least point, or that fail, are compared with all others.
  void check_nesting() const {
    if (rings_.size() == 1) return;
    std::vector<Edge> edges;
    std::vector<LeftRays::Edge> ends;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t i = 0; i < size(r); ++i) {
        edges.push_back({r, i});
        ends.push_back({&start(edges.back()), &end(edges.back())});
      }
    }
    LeftRays rays(std::move(ends));
    std::vector<bool> unsettled(rings_.size(), false);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const FilteredPoint& least =
          *std::min_element(filtered_[r].begin(), filtered_[r].end(),
                            [](const auto& a, const auto& b) { return compare_xy(a, b) < 0; });
      const LeftRays::Hit hit =
          rays.first(least, [&](std::uint32_t e) { return edges[e].ring != r; });
      unsettled[r] = hit.touches || !is_surrounded(r, hit, edges);
    }
    if (std::find(unsettled.begin(), unsettled.end(), true) == unsettled.end()) return;
    try {
      check_nesting_of(unsettled);
    } catch (const BadInput&) {
      check_nesting_of(std::vector<bool>(rings_.size(), true));  // the first fault of the input
      throw;
    }
  }

  /// Whether the near side of the edge that was met is what must lie around the ring. Sets lie left
  /// of their edges, so right of the ones that run down.
  bool is_surrounded(std::size_t r, const LeftRays::Hit& hit,
                     const std::vector<Edge>& edges) const {
    const bool in_material =
        hit.edge != no_entry && compare_y(end(edges[hit.edge]), start(edges[hit.edge])) < 0;
    if (rings_[r].outer) return !in_material;
    return in_material && rings_[edges[hit.edge].ring].polygon == rings_[r].polygon;
  }

  /// Compares these rings, in input order, with all others.
  void check_nesting_of(const std::vector<bool>& asked) const {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      if (!asked[r] || rings_[r].outer || within(r, outer_of(r))) continue;
      throw BadInput("hole-outside", "a hole does not lie inside its outer ring",
                     "give the hole to the polygon that it lies in",
                     place(r, {0}, outer_of(r), {}));
    }
    const BoxTree tree(boxes_);
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      std::vector<std::size_t> others;
      tree.query(boxes_[r], [&](std::uint32_t other) {
        // Holes and their outer ring: looked at already, and the most of the pairs.
        if (other > r && rings_[r].outer == rings_[other].outer && (asked[r] || asked[other])) {
          others.push_back(other);
        }
        return false;
      });
      std::sort(others.begin(), others.end());
      for (const std::size_t other : others) check_pair(r, other);
    }
  }

  void check_pair(std::size_t r, std::size_t other) const {
    if (rings_[r].outer) {
      check_apart(r, other);
      check_apart(other, r);
    } else if (rings_[r].polygon == rings_[other].polygon &&
               (within(r, other) || within(other, r))) {
      throw BadInput("overlapping-rings", "one hole lies inside another",
                     "remove the inner one, or make it a polygon of its own",
                     place(other, {0}, r, {0}));
    }
  }

  /// Requires that an outer ring within another lies inside a hole of that polygon.
  void check_apart(std::size_t inner, std::size_t outer) const {
    if (!within(inner, outer)) return;
    for (std::size_t h = outer + 1; h < rings_.size() && !rings_[h].outer; ++h) {
      if (boxes_[inner].overlaps(boxes_[h]) && within(inner, h)) return;
    }
    throw BadInput("overlapping-polygons", "two polygons overlap",
                   "unite them, as `minkref union` does, or cut a hole for the inner one",
                   place(inner, {0}, outer, {0}));
  }

  std::size_t outer_of(std::size_t r) const {
    while (!rings_[r].outer) --r;
    return r;
  }

  const PolygonSet& set_;
  Lines lines_;
  bool is_without_area_ = true;  ///< all rings are points and segments
  std::vector<RingInSet> rings_;
  std::vector<FilteredRing> filtered_;
  std::vector<Box> boxes_;
};

}  // namespace

void validate(const PolygonSet& set) { validate(set, Lines::refused); }

void validate(const PolygonSet& set, Lines lines) {
  const FloatEnvironment standard;
  Validator(set, lines).run();
}

}  // namespace minkref::inline plane
