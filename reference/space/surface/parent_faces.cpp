#include "reference/space/surface/parent_faces.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "reference/space/surface/parents.hpp"

namespace minkref::inline space {
namespace {

/// The face behind each triangle of an operand. A face gives two triangles fewer than vertices;
/// triangles on a polygon's back follow the triangles on the front.
std::vector<std::uint32_t> faces_of_triangles(const Polyhedron& body, const SpaceOperand& operand) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t f = 0; f < body.faces.size(); ++f) {
    result.insert(result.end(), body.faces[f].size() - 2, f);
  }
  if (body.faces.size() == 1) result.insert(result.end(), result.size(), 0);
  if (result.size() != operand.triangles.size()) {
    throw std::logic_error("a face was not cut into two triangles less than it has vertices");
  }
  return result;
}

struct NamedFaces {
  const Polyhedron& body;
  const SpaceOperand& operand;
  std::vector<std::uint32_t> face_of;

  NamedFaces(const Polyhedron& of, const SpaceOperand& cut)
      : body(of), operand(cut), face_of(faces_of_triangles(of, cut)) {}

  Face triangle(std::uint32_t number) const { return body.faces[face_of[number]]; }
  Face edge(std::uint32_t number) const {
    const auto [from, to] = std::minmax(operand.edges[number].from, operand.edges[number].to);
    return {from, to};
  }
};

FacePair pair_of(const ConvolutionFacet& facet, const NamedFaces& P, const NamedFaces& Q) {
  switch (facet.kind) {
    case FacetKind::fv:
      return {P.triangle(facet.of_P), {facet.of_Q}};
    case FacetKind::vf:
      return {{facet.of_P}, Q.triangle(facet.of_Q)};
    case FacetKind::ee:
      break;
  }
  return {P.edge(facet.of_P), Q.edge(facet.of_Q)};
}

/// A face's region, with the walks as rings.
PlaneRegion region_of(const SurfaceEdges& surface, const SurfaceFace& face) {
  PlaneRegion result{surface.planes[face.plane], {{Polygon{}}}};
  const std::size_t axis = viewing_axis(result.plane.normal);
  Polygon& polygon = result.region.polygons[0];
  for (const std::uint32_t first : face.walks) {
    Ring ring;
    for (const std::uint32_t h : surface.walk(first)) {
      ring.push_back(seen(surface.points[surface.half_edges[h].from].exact, axis));
    }
    if (is_mirrored(result.plane)) std::reverse(ring.begin(), ring.end());
    if (first == face.walks[0]) {
      polygon.outer = std::move(ring);
    } else {
      polygon.holes.push_back(std::move(ring));
    }
  }
  return result;
}

}  // namespace

std::vector<std::vector<FacePair>> parent_faces(const SurfaceEdges& surface, const Polyhedron& P,
                                                const Polyhedron& Q, const Scaling& scaling) {
  std::vector<std::vector<FacePair>> result(surface.faces.size());
  if (surface.faces.empty()) return result;
  const auto [first, second, denominator] = space_operands(P, Q, scaling);
  const Convolution convolution = convolution_facets(first, second);

  std::vector<std::uint32_t> order(surface.faces.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return surface.faces[a].plane < surface.faces[b].plane;
  });
  PolyhedralSet regions;
  for (const std::uint32_t f : order) regions.faces.push_back(region_of(surface, surface.faces[f]));
  const auto found = parents(regions, convolution.facets, denominator);
  const NamedFaces of_P(P, first), of_Q(Q, second);
  for (std::size_t k = 0; k < order.size(); ++k) {
    std::vector<FacePair>& pairs = result[order[k]];
    for (const std::uint32_t f : found[k]) {
      pairs.push_back(pair_of(convolution.facets[f], of_P, of_Q));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
  return result;
}

}  // namespace minkref::inline space
