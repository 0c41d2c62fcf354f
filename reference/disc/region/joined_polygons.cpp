#include "reference/disc/region/joined_polygons.hpp"

#include <algorithm>

#include "reference/disc/region/disjoint_sets.hpp"
#include "reference/error.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {
namespace {

/// Whether two edges that do not cross are nearer than a number's root (-1), as near (0) or farther
/// (1): the least distance starts at an end.
template <class N>
int sign_between(const EdgeNumbers<N>& a, const EdgeNumbers<N>& b, const N& square) {
  return std::min({sign_of_distance(a, b.start, square), sign_of_distance(a, b.end, square),
                   sign_of_distance(b, a.start, square), sign_of_distance(b, a.end, square)});
}

/// Two edges right across from each other along more than a point.
bool are_facing(const OffsetEdge& a, const OffsetEdge& b) {
  if (cross(a.along, b.along) != 0 || dot(a.along, b.along) >= 0) return false;
  const Rational from = dot(a.along, from_to(a.start, b.end)),
                 to = dot(a.along, from_to(a.start, b.start));
  return dot(a.normal, from_to(a.start, b.start)) > 0 && from < a.squared_length && to > 0;
}

}  // namespace

std::vector<std::uint32_t> joined_polygons(const PatchesAt& at, std::size_t polygons) {
  DisjointSets joined(polygons);
  const std::vector<OffsetEdge>& edges = at.curves().edges;
  if (polygons > 1) {
    std::vector<plane::Box> boxes;
    for (std::uint32_t k = 0; k < edges.size(); ++k) {
      boxes.push_back(box_of(at.edge(k)));
    }
    const plane::BoxTree tree(boxes);
    const double reach = plane::above(2 * at.radius().upper());
    const Rational square = 4 * at.squared_radius();
    const auto order = [&](std::uint32_t k, std::uint32_t l) {
      try {
        return sign_between(at.edge(k), at.edge(l), Interval(square));
      } catch (const UndecidedSign&) {
        return sign_between(EdgeNumbers<RootNumber>(edges[k], at.squared_radius()),
                            EdgeNumbers<RootNumber>(edges[l], at.squared_radius()),
                            RootNumber(square));
      }
    };
    for (std::uint32_t k = 0; k < edges.size(); ++k) {
      tree.query(grown(boxes[k], reach), [&](std::uint32_t l) {
        if (l <= k || joined.root(edges[k].polygon) == joined.root(edges[l].polygon)) return false;
        const int found = order(k, l);
        if (found < 0 || (found == 0 && are_facing(edges[k], edges[l]))) {
          joined.join(edges[k].polygon, edges[l].polygon);
        }
        return false;
      });
    }
  }
  std::vector<std::uint32_t> roots;
  for (std::uint32_t k = 0; k < polygons; ++k) roots.push_back(joined.root(k));
  return roots;
}

}  // namespace minkref::inline disc
