#include "reference/space/face_triangles.hpp"

#include <cstddef>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/flat_face.hpp"
#include "reference/space/monotone_triangles.hpp"

namespace minkref::inline space {
namespace {

constexpr std::size_t most_corners_by_ears = 32;

class EarCutter {
 public:
  EarCutter(const Face& face, const VertexSigns& signs) : flat_(face, signs), left_(face) {
    for (std::size_t k = 0; k < left_.size(); ++k) convex_.push_back(is_convex(k));
  }

  std::optional<std::vector<TriangleCorners>> run() {
    std::vector<TriangleCorners> triangles;
    // The ear about the second vertex comes first: a convex face becomes a fan from the first
    // vertex.
    std::size_t at = 1;
    while (left_.size() > 3) {
      std::size_t tried = 0;
      while (tried < left_.size() && !is_ear(at % left_.size())) ++tried, ++at;
      if (tried == left_.size()) return std::nullopt;
      at %= left_.size();
      triangles.push_back(corner(at));
      remove(at);
    }
    if (flat_.turn(left_[0], left_[1], left_[2]) <= 0) return std::nullopt;
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t before(std::size_t k) const { return (k + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t k) const { return (k + 1) % left_.size(); }
  TriangleCorners corner(std::size_t k) const {
    return {left_[before(k)], left_[k], left_[after(k)]};
  }
  bool is_convex(std::size_t k) const {
    return flat_.turn(left_[before(k)], left_[k], left_[after(k)]) > 0;
  }

  /// An ear holds no other vertex. If a triangle holds any, the vertex farthest from the diagonal
  /// is not convex: only vertices that are not convex need a look.
  bool is_ear(std::size_t k) const {
    if (!convex_[k]) return false;
    const TriangleCorners triangle = corner(k);
    for (std::size_t j = 0; j < left_.size(); ++j) {
      if (convex_[j] || j == before(k) || j == after(k)) continue;
      look_for_interrupt();
      if (contains(triangle, left_[j])) return false;
    }
    return true;
  }

  bool contains(const TriangleCorners& triangle, std::uint32_t vertex) const {
    return flat_.turn(triangle[0], triangle[1], vertex) >= 0 &&
           flat_.turn(triangle[1], triangle[2], vertex) >= 0 &&
           flat_.turn(triangle[2], triangle[0], vertex) >= 0;
  }

  void remove(std::size_t k) {
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
    convex_.erase(convex_.begin() + static_cast<std::ptrdiff_t>(k));
    for (const std::size_t neighbour : {before(k % left_.size()), k % left_.size()}) {
      convex_[neighbour] = is_convex(neighbour);
    }
  }

  FlatFace flat_;
  Face left_;
  std::vector<bool> convex_;
};

}  // namespace

std::optional<std::vector<TriangleCorners>> face_triangles(const Face& face,
                                                           const VertexSigns& signs) {
  const FloatEnvironment standard;
  if (face.size() == 3) return std::vector<TriangleCorners>{{face[0], face[1], face[2]}};
  if (face.size() > most_corners_by_ears) return monotone_triangles(face, signs);
  return EarCutter(face, signs).run();
}

}  // namespace minkref::inline space
