#include "reference/plane/index/rings_at_scale.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/number/float_environment.hpp"
#include "reference/plane/history/boundary_regions.hpp"
#include "reference/plane/routes/routes.hpp"
#include "reference/plane/scaling.hpp"

namespace minkref::inline plane {
namespace {

/// Writes some integers for each point: `take(point, numbers)` appends them.
template <class Rings, class Take>
void write_integers(const PointRings& from, Rings& to, Take&& take) {
  std::vector<Integer> numbers;
  for (const Point& point : from.points) take(point, numbers);
  IntegerWords words = integer_words(numbers);
  static_cast<RingShape&>(to) = from;
  to.words = words.words;
  to.numbers = std::move(words.data);
}

Operand<Vector2<Rational>> vectors(const PolygonSet& set) {
  return operand<Vector2<Rational>>(set,
                                    [](const Point& p) { return Vector2<Rational>(p.x, p.y); });
}

}  // namespace

PointRings rings_at_scale(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                          Statistics& statistics) {
  const FloatEnvironment standard;
  PointRings result;
  if (P.empty() || Q.empty()) return result;
  const PolygonSet sP = scaled(P, scale);
  const BoundaryOnConvolution boundary = paper_route_on_convolution(sP, Q, statistics);
  const auto& links = boundary.graph.edges;
  // Directions matter only, of convolution edges below the boundary.
  std::vector<std::uint32_t> used = boundary.below;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<ConvolutionEdge> edges;
  for (const std::uint32_t edge : used) edges.push_back(boundary.convolution[edge]);
  const std::vector<RationalEdge> moving = moving_edges(edges, vectors(sP), vectors(Q));
  BoundaryState state;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto edge = std::lower_bound(used.begin(), used.end(), boundary.below[k]) - used.begin();
    state.links.push_back(
        {links[k].first, links[k].second, static_cast<std::uint32_t>(edge), 0, 0});
  }
  std::vector<Track> still;
  for (const Point& point : boundary.graph.points) still.push_back({point, {}});
  CycleFinder finder(moving);
  const BoundaryRegions regions = boundary_regions(still, std::move(state), finder, 1);
  for (const BoundaryRing& ring : boundary_rings(regions, finder)) {
    for (const std::uint32_t vertex : ring.vertices) {
      result.points.push_back(boundary.graph.points[vertex]);
    }
    for (const std::uint32_t edge : ring.edges) result.edges.push_back(used[edge]);
    result.ring_ends.push_back(static_cast<std::uint32_t>(result.points.size()));
    result.rings.push_back({ring.is_hole, ring.hole, ring.component});
  }
  return result;
}

void write_rings(const PointRings& from, RoundedRings& to) {
  static_cast<RingShape&>(to) = from;
  to.x.clear();
  to.y.clear();
  double largest = 0;
  for (const Point& point : from.points) {
    to.x.push_back(to_double(point.x));
    to.y.push_back(to_double(point.y));
    largest = std::max({largest, std::fabs(to.x.back()), std::fabs(to.y.back())});
  }
  to.error = 0x1p-53 * largest + 0x1p-1074;  // half a unit in the last place
}

void write_rings(const PointRings& from, HomogeneousRings& to) {
  write_integers(from, to, [](const Point& p, std::vector<Integer>& numbers) {
    const Integer a = denominator(p.x), b = denominator(p.y), w = lcm(a, b);
    numbers.push_back(numerator(p.x) * (w / a));
    numbers.push_back(numerator(p.y) * (w / b));
    numbers.push_back(w);
  });
}

void write_rings(const PointRings& from, RationalRings& to) {
  write_integers(from, to, [](const Point& p, std::vector<Integer>& numbers) {
    for (const Rational* value : {&p.x, &p.y}) {
      numbers.push_back(numerator(*value));
      numbers.push_back(denominator(*value));
    }
  });
}

}  // namespace minkref::inline plane
