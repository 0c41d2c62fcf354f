#include "reference/space/self_crossing.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/polyhedron_place.hpp"
#include "reference/space/triangle_contact.hpp"

namespace minkref::inline space {
namespace {

[[noreturn]] void refuse_contact(const SearchedSurface& surface, const SurfaceTriangle& first,
                                 const SurfaceTriangle& second, TriangleContact contact) {
  std::array<Rational, 3> common = common_point(first, second, surface.signs);
  for (Rational& c : common) c /= surface.denominator;
  const std::string at = "at " + short_text(SpacePoint{common[0], common[1], common[2]});
  const auto [face, other] = std::minmax(first.face, second.face);
  Place place = place_in(surface.polyhedron, face, {});
  place.other_face = other;
  if (contact == TriangleContact::crossing) {
    throw BadInput("self-intersection", "the surface passes through itself " + at,
                   "cut both faces where they meet and remove what is inside, or move one",
                   std::move(place));
  }
  throw BadInput("overlapping-faces", "two faces cover the same part of a plane " + at,
                 "remove that part of both, so that what is on its two sides is one, or move one",
                 std::move(place));
}

}  // namespace

void refuse_crossing_faces(const SearchedSurface& surface) {
  const FloatEnvironment standard;
  const std::vector<SurfaceTriangle>& triangles = surface.triangles;
  surface.tree.pairs([&](std::uint32_t i, std::uint32_t j) {
    if (triangles[i].face == triangles[j].face) return false;
    const TriangleContact contact = contact_of(triangles, surface.signs, i, j);
    if (contact != TriangleContact::none)
      refuse_contact(surface, triangles[i], triangles[j], contact);
    return false;
  });
}

}  // namespace minkref::inline space
