#include "formats/cut_face.hpp"

#include <numeric>

#include "reference/space/face_triangles.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref {
std::optional<std::vector<Face>> triangles_of(const Face& face,
                                              const std::vector<SpacePoint>& vertices) {
  if (face.size() < 3) return std::nullopt;
  if (face.size() == 3) return std::vector<Face>{face};
  std::vector<SpacePoint> corners;
  for (const std::uint32_t vertex : face) corners.push_back(vertices[vertex]);
  Face own(face.size());
  std::iota(own.begin(), own.end(), 0U);
  const IntegerPoints whole = integer_points(corners);
  const auto triangles = face_triangles(own, VertexSigns(whole.points));
  if (!triangles) return std::nullopt;
  std::vector<Face> result;
  for (const auto& [a, b, c] : *triangles) result.push_back({face[a], face[b], face[c]});
  return result;
}

}  // namespace minkref
