#include "reference/space/convex/pieces.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/convex/convexity.hpp"

namespace minkref::inline space {
namespace {

using Pair = SumVertices::Pair;

FacetParents parents_of(const std::vector<Pair>& pairs, const Face& corners) {
  FacetParents result;
  for (const std::uint32_t k : corners) {
    result.P.push_back(pairs[k].p);
    result.Q.push_back(pairs[k].q);
  }
  for (auto* list : {&result.P, &result.Q}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return result;
}

/// Merges each plane's rings into one, and their parents.
template <class Point>
std::pair<std::vector<Face>, std::vector<FacetParents>> merged(const Pieces<Point>& pieces) {
  const std::vector<Face>& rings = pieces.rings;
  std::vector<decltype(direction(pieces.normals[0]))> directions;
  directions.reserve(rings.size());
  for (const auto& normal : pieces.normals) directions.push_back(direction(normal));
  std::vector<std::uint32_t> order(rings.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto compared = [&](std::uint32_t a, std::uint32_t b) {
    look_for_interrupt();
    return compare(directions[a], directions[b]);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return compared(a, b) < 0; });
  std::pair<std::vector<Face>, std::vector<FacetParents>> result;
  for (std::size_t k = 0, end = 0; k < order.size(); k = end) {
    look_for_interrupt();
    Face corners;
    for (end = k; end < order.size() && compared(order[end], order[k]) == 0; ++end) {
      corners.insert(corners.end(), rings[order[end]].begin(), rings[order[end]].end());
    }
    result.second.push_back(parents_of(pieces.pairs, corners));
    if (end - k > 1) corners = corners_of_hull(pieces.points, pieces.normals[order[k]], corners);
    result.first.push_back(std::move(corners));
  }
  return result;
}

/// Numbers the used vertices lexicographically and sorts the facets.
template <class Point>
void make_canonical(ConvexSum& sum, std::vector<Face> rings, std::vector<FacetParents> parents,
                    const Pieces<Point>& pieces, std::vector<Point>& points) {
  std::vector<std::uint32_t> used;
  for (const Face& ring : rings) used.insert(used.end(), ring.begin(), ring.end());
  std::sort(used.begin(), used.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(pieces.points[a], a) < std::tie(pieces.points[b], b);
  });
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<std::uint32_t> number(pieces.pairs.size());
  const IntegerVector& under = pieces.denominators;
  for (std::uint32_t k = 0; k < used.size(); ++k) {
    look_for_interrupt();
    number[used[k]] = k;
    const Point& p = pieces.points[used[k]];
    points.push_back(p);
    sum.vertex_parents.push_back(pieces.pairs[used[k]]);
    sum.surface.vertices.push_back(
        {Rational(p[0], under[0]), Rational(p[1], under[1]), Rational(p[2], under[2])});
  }
  for (Face& ring : rings) {
    for (std::uint32_t& v : ring) v = number[v];
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  }
  std::vector<std::uint32_t> order(rings.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return rings[a] < rings[b]; });
  for (const std::uint32_t k : order) {
    sum.surface.faces.push_back(std::move(rings[k]));
    sum.facet_parents.push_back(std::move(parents[k]));
  }
}

/// Scaling an axis keeps every property asked here, so the points may stay over their denominators.
template <class Point>
void certify(const Polyhedron& surface, const std::vector<Point>& points) {
  try {
    require_strictly_convex(surface, points);
  } catch (const BadInput& fault) {
    throw std::logic_error("a convex sum is not closed and strictly convex: " + fault.problem());
  }
}

template <class Point>
ConvexSum canonical_sum(const Pieces<Point>& pieces) {
  auto [rings, parents] = merged(pieces);
  ConvexSum result;
  std::vector<Point> points;
  make_canonical(result, std::move(rings), std::move(parents), pieces, points);
  certify(result.surface, points);
  return result;
}

}  // namespace

ConvexSum united(const Pieces<WordVector>& pieces) {
  const FloatEnvironment standard;
  return canonical_sum(pieces);
}
ConvexSum united(const Pieces<IntegerVector>& pieces) {
  const FloatEnvironment standard;
  return canonical_sum(pieces);
}

}  // namespace minkref::inline space
