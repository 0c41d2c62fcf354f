#include "formats/containment.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

#include "reference/interrupt.hpp"
#include "reference/plane/left_rays.hpp"
#include "reference/plane/location.hpp"

namespace minkref {
namespace {

struct RationalBox {
  Rational left, right, bottom, top;
};

RationalBox rational_box_of(const Ring& ring) {
  RationalBox box{ring[0].x, ring[0].x, ring[0].y, ring[0].y};
  for (const Point& p : ring) {
    if (p.x < box.left) box.left = p.x;
    if (p.x > box.right) box.right = p.x;
    if (p.y < box.bottom) box.bottom = p.y;
    if (p.y > box.top) box.top = p.y;
  }
  return box;
}

bool within(const RationalBox& inner, const RationalBox& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.bottom >= outer.bottom &&
         inner.top <= outer.top;
}

/// Whether `p` is strictly outside: the ray to the right crosses the ring an even number of times,
/// and the ring does not pass through `p`.
bool strictly_outside(const Point& p, const Ring& ring) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a.y == p.y && b.y == p.y) {
      if ((a.x <= p.x) != (b.x <= p.x) || a.x == p.x || b.x == p.x) return false;
      continue;
    }
    if ((a.y < p.y && b.y < p.y) || (a.y > p.y && b.y > p.y)) continue;
    const int side = sign(Rational((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)));
    if (side == 0) return false;
    if ((a.y > p.y) != (b.y > p.y) && (side > 0) == (b.y > a.y)) inside = !inside;
  }
  return !inside;
}

/// The vertex of `ring` inside the edge from `a` to `b` that is the nearest to `a`, or else `b`.
Point first_contact(const Point& a, const Point& b, const Ring& ring) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  Point found = b;
  Rational least = dx * dx + dy * dy;
  for (const Point& p : ring) {
    if (dx * (p.y - a.y) != dy * (p.x - a.x)) continue;
    const Rational along = dx * (p.x - a.x) + dy * (p.y - a.y);
    if (sign(along) <= 0 || along >= least) continue;
    found = p;
    least = along;
  }
  return found;
}

/// Fewer outer rings are all looked at.
constexpr std::size_t fewest_for_rays = 32;

/// Outer rings around holes, by the edge that a ray from each ring's least point meets first. None
/// where rings touch there, or are nested as no valid set has them.
class OutersByRays {
 public:
  OutersByRays(const std::vector<const Ring*>& outers, const std::vector<const Ring*>& holes)
      : outers_(outers.size()) {
    for (const std::vector<const Ring*>* rings : {&outers, &holes}) {
      for (const Ring* ring : *rings) {
        look_for_interrupt();
        rings_.push_back(filtered_ring(*ring));
        runs_left_.push_back(sign(doubled_area(*ring)) > 0);
      }
    }
  }

  /// For each hole the number of its outer ring.
  std::vector<std::optional<std::size_t>> found() {
    std::vector<LeftRays::Edge> ends;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      const FilteredRing& ring = rings_[r];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        ends.push_back({&ring[i], &ring[(i + 1) % ring.size()]});
        ring_of_.push_back(r);
      }
    }
    LeftRays rays(ends);
    around_.resize(rings_.size());
    for (const std::size_t r : from_the_left()) {
      const auto of_others = [&](std::uint32_t e) { return ring_of_[e] != r; };
      const LeftRays::Hit hit = rays.first(least(r), of_others);
      if (hit.touches || hit.edge == no_entry) continue;
      const std::size_t met = ring_of_[hit.edge];
      const bool runs_down = compare_y(*ends[hit.edge].to, *ends[hit.edge].from) < 0;
      if (runs_down != runs_left_[met]) {
        around_[r] = around_[met];
      } else if (met < outers_) {
        around_[r] = met;
      }
    }
    return {around_.begin() + static_cast<std::ptrdiff_t>(outers_), around_.end()};
  }

 private:
  const FilteredPoint& least(std::size_t r) const {
    return *std::min_element(rings_[r].begin(), rings_[r].end(),
                             [](const auto& a, const auto& b) { return compare_xy(a, b) < 0; });
  }
  std::vector<std::size_t> from_the_left() const {
    std::vector<const FilteredPoint*> points;
    for (std::size_t r = 0; r < rings_.size(); ++r) points.push_back(&least(r));
    std::vector<std::size_t> order(rings_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return compare_xy(*points[a], *points[b]) < 0;
    });
    return order;
  }

  std::size_t outers_;
  std::vector<FilteredRing> rings_;
  std::vector<bool> runs_left_;  ///< counter-clockwise, whatever the ring is
  std::vector<std::size_t> ring_of_;
  std::vector<std::optional<std::size_t>> around_;  ///< the outer ring whose set is around a ring
};

}  // namespace

bool lies_inside(const Ring& inner, const Ring& outer, std::size_t& steps) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const Point& a = inner[i];
    const Point& b = inner[i + 1 == inner.size() ? 0 : i + 1];
    look_for_interrupt();
    steps += 2 * outer.size();
    if (strictly_outside(a, outer)) return false;
    if (strictly_outside({(a.x + b.x) / 2, (a.y + b.y) / 2}, outer)) return false;
  }
  // The rings may touch at each of these points, but not between two contacts.
  const Point contact = first_contact(inner[0], inner[1], outer);
  steps += 2 * outer.size();
  return !strictly_outside({(inner[0].x + contact.x) / 2, (inner[0].y + contact.y) / 2}, outer);
}

std::vector<std::size_t> containing_outers(const std::vector<const Ring*>& outers,
                                           const std::vector<const Ring*>& holes,
                                           const std::vector<Place>& places, const Input& input) {
  if (outers.size() == 1) return std::vector<std::size_t>(holes.size(), 0);
  std::vector<RationalBox> boxes;
  for (const Ring* outer : outers) boxes.push_back(rational_box_of(*outer));
  std::vector<std::size_t> found;
  std::size_t steps = 0;
  const auto inside = [&](const Ring& inner, const RationalBox& box, std::size_t outer,
                          const Place& place) {
    steps += 1;
    const std::size_t work = 2 * (inner.size() + 1) * outers[outer]->size();
    if (!within(box, boxes[outer])) return false;
    if (steps + work > input.limits().containment_steps) {
      input.exceed(
          "too-much-work", "too many tests are needed to find the outer ring of each hole",
          "give the polygons in a format that lists holes under their outer ring, or raise "
          "the limit on containment steps",
          place);
    }
    return lies_inside(inner, *outers[outer], steps);
  };
  std::vector<std::optional<std::size_t>> by_rays(holes.size());
  if (outers.size() >= fewest_for_rays) by_rays = OutersByRays(outers, holes).found();
  for (std::size_t h = 0; h < holes.size(); ++h) {
    if (by_rays[h]) {
      found.push_back(*by_rays[h]);
      continue;
    }
    const RationalBox box = rational_box_of(*holes[h]);
    std::optional<std::size_t> smallest;
    for (std::size_t o = 0; o < outers.size(); ++o) {
      look_for_interrupt();
      if (!inside(*holes[h], box, o, places[h])) continue;
      if (!smallest || inside(*outers[o], boxes[o], *smallest, places[h])) smallest = o;
    }
    if (!smallest) {
      input.refuse("hole-outside", "the hole lies in no outer ring",
                   "move the hole into an outer ring, or mark the ring `out`", places[h]);
    }
    found.push_back(*smallest);
  }
  return found;
}

}  // namespace minkref
