#include "reference/space/convex/convex_polyhedron.hpp"

#include <algorithm>
#include <climits>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/area_vector.hpp"
#include "reference/space/convex/convexity.hpp"

namespace minkref::inline space {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

/// The least exponent of two above all magnitudes.
long most_bits(const std::vector<IntegerVector>& vectors) {
  long most = 0;
  for (const IntegerVector& v : vectors) {
    for (const Integer& c : v) {
      most = std::max(most, bits(c));
    }
  }
  return most;
}

/// The difference in bits between the longest and the shortest nonzero coordinate.
long spread(const std::vector<IntegerVector>& vectors) {
  long least = LONG_MAX;
  for (const IntegerVector& v : vectors) {
    for (const Integer& c : v) {
      if (!c.is_zero()) least = std::min(least, bits(c));
    }
  }
  return most_bits(vectors) - least;
}

/// Nearest doubles of the vectors over 2^exponent.
std::vector<DoubleVector> rounded(const std::vector<IntegerVector>& vectors, long exponent) {
  const Integer unit = Integer(1) << exponent;
  std::vector<DoubleVector> result;
  result.reserve(vectors.size());
  for (const IntegerVector& v : vectors) {
    result.push_back({to_double(Rational(v[0], unit)), to_double(Rational(v[1], unit)),
                      to_double(Rational(v[2], unit))});
  }
  return result;
}

/// A convex surface does not cross itself. If the convexity test fails, faults that `validate`
/// finds are reported before non-convexity.
std::vector<Face> convex_facets(const Polyhedron& surface,
                                const std::vector<IntegerVector>& points) {
  try {
    return certified_convex_facets(surface, points);
  } catch (const BadInput&) {
    validate(surface);
    throw;
  }
}

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(const Polyhedron& surface) {
  const FloatEnvironment standard;
  if (!surface.is_solid()) {
    throw BadInput("not-solid", "the operand has no volume",
                   "give a convex polyhedron by its faces");
  }
  validate_mesh(surface);
  IntegerPoints given = integer_points(surface.vertices);
  const std::vector<Face> facets = convex_facets(surface, given.points);

  // Vertices come in lexicographic order, facets by their rings, which start at the least vertex.
  std::vector<bool> kept(given.points.size());
  for (const Face& facet : facets) {
    for (const std::uint32_t v : facet) kept[v] = true;
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < kept.size(); ++v) {
    if (kept[v]) order.push_back(v);
  }
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return given.points[a] < given.points[b]; });
  std::vector<std::uint32_t> number(given.points.size(), none);
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    number[order[k]] = k;
    points_.push_back(std::move(given.points[order[k]]));
  }
  std::vector<Face> rings = facets;
  for (Face& ring : rings) {
    for (std::uint32_t& v : ring) v = number[v];
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  }
  std::sort(rings.begin(), rings.end());

  // Flat vertices may have asked for a larger denominator than is needed now.
  Integer common = given.denominator;
  for (const IntegerVector& p : points_) {
    for (const Integer& c : p) common = gcd(common, c);
  }
  denominator_ = given.denominator / common;
  for (IntegerVector& p : points_) {
    for (Integer& c : p) c /= common;
  }
  point_bits_ = most_bits(points_);
  if (point_bits_ < 64) {
    for (const IntegerVector& v : points_) {
      words_.push_back({static_cast<std::int64_t>(v[0]), static_cast<std::int64_t>(v[1]),
                        static_cast<std::int64_t>(v[2])});
    }
  }
  link(rings);
  traverse();
  for (const Face& ring : rings) {
    normals_.push_back(primitive(area_vector(points_, ring)));
    most_corners_ = std::max(most_corners_, ring.size());
  }
  std::vector<IntegerVector> vectors;
  for (std::uint32_t h = 0; h < half_edges(); ++h) vectors.push_back(vector(h));
  vectors_ = rounded(vectors, most_bits(vectors));
  rounded_points_ = rounded(points_, most_bits(vectors));
  rounded_normals_ = rounded(normals_, most_bits(normals_));
  moderate_ = spread(vectors) < 200 && spread(normals_) < 200;
}

/// Numbers the half-edges around their origins.
void ConvexPolyhedron::link(const std::vector<Face>& rings) {
  struct Corner {
    std::uint32_t origin, target, before, facet;
    auto key() const { return std::pair(origin, target); }
  };
  std::vector<Corner> corners;
  for (std::uint32_t f = 0; f < rings.size(); ++f) {
    const Face& ring = rings[f];
    for (std::size_t k = 0, n = ring.size(); k < n; ++k) {
      corners.push_back({ring[k], ring[(k + 1) % n], ring[(k + n - 1) % n], f});
    }
  }
  const auto less = [](const Corner& a, const Corner& b) { return a.key() < b.key(); };
  std::sort(corners.begin(), corners.end(), less);
  const auto find = [&](std::uint32_t origin, std::uint32_t target) {
    const Corner wanted{origin, target, 0, 0};
    return static_cast<std::uint32_t>(
        std::lower_bound(corners.begin(), corners.end(), wanted, less) - corners.begin());
  };
  // Counter-clockwise around a vertex, the facet on a half-edge's left comes next; this facet's
  // other edge at the vertex precedes the half-edge in the ring.
  std::vector<std::uint32_t> place(corners.size());
  std::uint32_t at = 0;
  for (std::uint32_t k = 0; k < corners.size();) {
    first_.push_back(k);
    const std::uint32_t vertex = corners[k].origin;
    for (std::uint32_t c = k;;) {
      place[c] = at++;
      c = find(vertex, corners[c].before);
      if (c == k) break;
    }
    k = at;
  }
  first_.push_back(at);
  for (auto* list : {&target_, &twin_, &facet_, &next_}) list->resize(corners.size());
  start_.assign(rings.size(), none);
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    look_for_interrupt();
    const Corner& corner = corners[c];
    const std::uint32_t h = place[c];
    target_[h] = corner.target;
    facet_[h] = corner.facet;
    twin_[h] = place[find(corner.target, corner.origin)];
    next_[place[find(corner.before, corner.origin)]] = h;
    if (corner.origin == rings[corner.facet][0]) start_[corner.facet] = h;
  }
  edge_.resize(corners.size());
  for (std::uint32_t h = 0; h < half_edges(); ++h) {
    if (origin(h) > target(h)) continue;
    edge_[h] = edge_[twin(h)] = edges();
    edge_half_.push_back(h);
  }
}

/// Breadth first: neighbours in the list lie near each other.
void ConvexPolyhedron::traverse() {
  std::vector<bool> met(start_.size());
  traversal_.push_back({0, 0});
  met[0] = true;
  for (std::size_t k = 0; k < traversal_.size(); ++k) {
    const std::uint32_t facet = traversal_[k].facet;
    std::uint32_t h = start_[facet];
    do {
      const std::uint32_t beyond = right(h);
      if (!met[beyond]) traversal_.push_back({beyond, facet});
      met[beyond] = true;
    } while ((h = next(h)) != start_[facet]);
  }
}

IntegerVector ConvexPolyhedron::vector(std::uint32_t half_edge) const {
  return points_[target(half_edge)] - points_[origin(half_edge)];
}

Polyhedron ConvexPolyhedron::surface() const {
  Polyhedron result;
  for (const IntegerVector& p : points_) {
    result.vertices.push_back(
        {Rational(p[0], denominator_), Rational(p[1], denominator_), Rational(p[2], denominator_)});
  }
  for (const std::uint32_t start : start_) {
    look_for_interrupt();
    Face& ring = result.faces.emplace_back();
    std::uint32_t h = start;
    do {
      ring.push_back(origin(h));
      h = next(h);
    } while (h != start);
  }
  return result;
}

}  // namespace minkref::inline space
