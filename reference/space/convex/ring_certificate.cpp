#include "reference/space/convex/ring_certificate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

[[noreturn]] void refuse_rings(const char* fault) {
  throw std::logic_error(std::string("a convex sum is not closed and strictly convex: ") + fault);
}

double extent_of(double x, double y, double z) {
  return std::fabs(x) + std::fabs(y) + std::fabs(z);
}

WordVector weighted_sum(std::int64_t a, const WordVector& p, std::int64_t b, const WordVector& q) {
  return {a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2]};
}

/// Whether a ring is a parallelogram, or has no area.
bool is_parallelogram(const std::vector<WordVector>& points, std::span<const std::uint32_t> ring) {
  if (ring.size() != 4) return false;
  const WordVector &a = points[ring[0]], &b = points[ring[1]], &c = points[ring[2]],
                   &d = points[ring[3]];
  return a[0] + c[0] == b[0] + d[0] && a[1] + c[1] == b[1] + d[1] && a[2] + c[2] == b[2] + d[2];
}

}  // namespace

WideVector RingCertificate::exact_normal(std::uint32_t ring) const {
  const auto corners = (*rings_)[ring];
  const WordVector& a = (*points_)[corners[0]];
  return cross((*points_)[corners[1]] - a, (*points_)[corners[2]] - a);
}

/// Whether doubles prove that the vector points below a ring's plane. The product of a coordinate's
/// error and the vector, and six roundings more, stay below half of the bound.
bool RingCertificate::is_below(std::uint32_t ring, const WordVector& along) const {
  const Normal& n = normals_[ring];
  const auto x = static_cast<double>(along[0]), y = static_cast<double>(along[1]),
             z = static_cast<double>(along[2]);
  return n.x * x + n.y * y + n.z * z < -0x1p-48 * n.size * extent_of(x, y, z);
}

int RingCertificate::side(std::uint32_t ring, const WordVector& along) const {
  return is_below(ring, along) ? -1 : dot_sign(exact_normal(ring), along);
}

void RingCertificate::look_at(const std::vector<WordVector>& points, const Rings& rings) {
  points_ = &points;
  rings_ = &rings;
  normals_.resize(rings.size());
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const auto corners = rings[r];
    const WordVector& o = points[corners[0]];
    const WordVector a = points[corners[1]] - o, b = points[corners[2]] - o;
    const auto ax = static_cast<double>(a[0]), ay = static_cast<double>(a[1]),
               az = static_cast<double>(a[2]), bx = static_cast<double>(b[0]),
               by = static_cast<double>(b[1]), bz = static_cast<double>(b[2]);
    normals_[r] = {ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx,
                   extent_of(ax, ay, az) * extent_of(bx, by, bz)};
  }
}

/// Visits each edge once, with the two rings and the places of the edge's starts within `corners`.
template <class Visit>
void RingCertificate::for_each_edge(Visit visit) {
  const Rings& rings = *rings_;
  first_end_.assign(points_->size() + 1, 0);
  const auto for_ends = [&](auto&& at) {
    for (std::uint32_t r = 0; r < rings.size(); ++r) {
      const std::uint32_t begin = rings.first[r], end = rings.first[r + 1];
      std::uint32_t from = rings.corners[begin];
      for (std::uint32_t k = begin; k < end; ++k) {
        const std::uint32_t to = rings.corners[k + 1 == end ? begin : k + 1];
        at(from, to, r, k);
        from = to;
      }
    }
  };
  for_ends([&](std::uint32_t from, std::uint32_t to, std::uint32_t, std::uint32_t) {
    ++first_end_[std::min(from, to)];
  });
  std::uint32_t total = 0;
  for (std::uint32_t& first : first_end_) first = std::exchange(total, total + first);
  ends_.resize(total);
  for_ends([&](std::uint32_t from, std::uint32_t to, std::uint32_t ring, std::uint32_t corner) {
    const std::uint64_t key = 2 * std::uint64_t{std::max(from, to)} + (from < to ? 0 : 1);
    ends_[first_end_[std::min(from, to)]++] = {key, ring, corner};
  });
  // Now each vertex has the next one's first end.
  const auto less = [](const End& a, const End& b) { return a.key < b.key; };
  for (std::uint32_t v = 0, begin = 0; v < points_->size(); begin = first_end_[v++]) {
    look_for_interrupt();
    const std::uint32_t end = first_end_[v];
    if (end - begin > 16) {
      std::sort(ends_.begin() + begin, ends_.begin() + end, less);
    } else {
      for (std::uint32_t k = begin + 1; k < end; ++k) {
        const End moved = ends_[k];
        std::uint32_t to = k;
        for (; to > begin && moved.key < ends_[to - 1].key; --to) ends_[to] = ends_[to - 1];
        ends_[to] = moved;
      }
    }
    if ((end - begin) % 2 != 0) refuse_rings("an edge is not in two facets");
    for (std::uint32_t k = begin; k < end; k += 2) {
      const End &up = ends_[k], &down = ends_[k + 1];
      if (up.key % 2 != 0 || up.key + 1 != down.key) refuse_rings("an edge is not in two facets");
      visit(up, down);
    }
  }
}

/// To the second corner of b's ring after the start of b's edge, off the edge.
WordVector RingCertificate::across(const End& a, const End& b) const {
  const Rings& rings = *rings_;
  const std::uint32_t begin = rings.first[b.ring], end = rings.first[b.ring + 1];
  const std::uint32_t next = b.corner + 2;
  return (*points_)[rings.corners[next < end ? next : next - end + begin]] -
         (*points_)[rings.corners[a.corner]];
}

auto RingCertificate::doubtful(const std::vector<WordVector>& points, const Rings& rings)
    -> const std::vector<Doubt>& {
  look_at(points, rings);
  doubtful_.clear();
  for_each_edge([&](const End& a, const End& b) {
    const WordVector along = across(a, b);
    if (is_below(a.ring, along)) return;
    doubtful_.push_back({a.ring, b.ring, dot_sign(exact_normal(a.ring), along) == 0});
  });
  proven_ = doubtful_.empty();
  return doubtful_;
}

void RingCertificate::require(const std::vector<WordVector>& points, const Rings& rings) {
  const bool seen = proven_ && points_ == &points && rings_ == &rings;
  proven_ = false;
  if (!seen) {
    look_at(points, rings);
    for_each_edge([&](const End& a, const End& b) {
      if (side(a.ring, across(a, b)) >= 0)
        refuse_rings("a facet is not below its neighbour's plane");
    });
  }
  for (std::uint32_t r = 0; r < rings.size(); ++r) check_ring(r);
  check_winding();
}

/// Each edge's rings span two planes: so triangles and parallelograms have an area, and strictly
/// convex corners.
void RingCertificate::check_ring(std::uint32_t ring) const {
  const std::vector<WordVector>& points = *points_;
  const auto corners = (*rings_)[ring];
  const std::size_t n = corners.size();
  if (n == 3 || is_parallelogram(points, corners)) return;
  if (n < 3) refuse_rings("a facet has two corners");
  const WideVector normal = exact_normal(ring);
  if (is_zero(normal)) refuse_rings("a facet has a flat corner");
  const std::size_t axis = longest_axis(normal), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const bool is_upward = normal[axis] > 0;
  const auto is_down = [&](const WordVector& d) { return d[u] < 0 || (d[u] == 0 && d[v] < 0); };
  std::size_t lowest = 0;
  WordVector before = points[corners[0]] - points[corners[n - 1]];
  for (std::size_t k = 0; k < n; ++k) {
    look_for_interrupt();
    const WordVector &here = points[corners[k]], after = points[corners[(k + 1) % n]] - here;
    if (dot_sign(normal, here - points[corners[0]]) != 0) refuse_rings("a facet is not flat");
    const Int128 turn = cross(before, after)[axis];
    if (is_upward ? turn <= 0 : turn >= 0) refuse_rings("a facet is not convex at a corner");
    lowest += is_down(before) && !is_down(after) ? 1 : 0;
    before = after;
  }
  if (lowest != 1) refuse_rings("a facet runs around more than once");
}

/// As in convexity.cpp: o is the mean of the first triangle and a point below, and x lies inside
/// the triangle; both are scaled by 28. Seen along the ray from o to x, a ring that the ray meets
/// has no line through x with all corners on one side.
void RingCertificate::check_winding() {
  const std::vector<WordVector>& points = *points_;
  const auto first = (*rings_)[0];
  const WordVector &a = points[first[0]], &b = points[first[1]], &c = points[first[2]];
  std::uint32_t below = 0;
  while (below < points.size() && side(0, points[below] - a) >= 0) ++below;
  if (below == points.size()) refuse_rings("no vertex is below a facet");
  WordVector o, ray;
  for (std::size_t k = 0; k < 3; ++k) {
    o[k] = 7 * (a[k] + b[k] + c[k] + points[below][k]);
    ray[k] = 4 * a[k] + 8 * b[k] + 16 * c[k] - o[k];
  }
  const std::size_t k = longest_axis(ray), i = (k + 1) % 3, j = (k + 2) % 3;
  const auto ri = static_cast<double>(ray[i]), rj = static_cast<double>(ray[j]),
             rk = static_cast<double>(ray[k]);
  flags_.resize(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const WordVector seen = weighted_sum(28, points[v], -1, o);
    const auto x = static_cast<double>(seen[i]), y = static_cast<double>(seen[j]),
               z = static_cast<double>(seen[k]);
    const double along = x * rk - z * ri, across = y * rk - z * rj;
    // Five roundings of each product.
    const double off_along = 0x1p-50 * (std::fabs(x * rk) + std::fabs(z * ri)),
                 off_across = 0x1p-50 * (std::fabs(y * rk) + std::fabs(z * rj));
    flags_[v] =
        static_cast<std::uint8_t>((along > off_along ? 1 : 0) | (along < -off_along ? 2 : 0) |
                                  (across > off_across ? 4 : 0) | (across < -off_across ? 8 : 0));
  }
  std::size_t met = 0;
  for (std::uint32_t r = 0; r < rings_->size(); ++r) {
    look_for_interrupt();
    const auto corners = (*rings_)[r];
    if (side(r, weighted_sum(1, o, -28, points[corners[0]])) >= 0) {
      refuse_rings("a point between the vertices is not below a facet");
    }
    std::uint8_t apart = 15;
    for (const std::uint32_t v : corners) apart &= flags_[v];
    if (apart == 0 && is_met(r, o, ray)) ++met;
  }
  if (met != 1) refuse_rings("the surface runs around its middle more than once");
}

bool RingCertificate::is_met(std::uint32_t ring, const WordVector& from,
                             const WordVector& ray) const {
  if (dot_sign(exact_normal(ring), ray) <= 0) return false;
  const auto corners = (*rings_)[ring];
  int low = 0, high = 0;
  const auto seen = [&](std::uint32_t v) { return weighted_sum(28, (*points_)[v], -1, from); };
  WordVector before = seen(corners.back());
  for (const std::uint32_t v : corners) {
    const WordVector here = seen(v);
    const int side = dot_sign(cross(before, here), ray);
    low = std::min(low, side);
    high = std::max(high, side);
    before = here;
  }
  return low == 0 || high == 0;
}

}  // namespace minkref::inline space
