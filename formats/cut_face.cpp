#include "formats/cut_face.hpp"

#include <cstddef>
#include <numeric>

#include "reference/space/area_vector.hpp"
#include "reference/space/integer_points.hpp"

namespace minkref {
namespace {

/// A face seen along the axis in which its normal is longest, on its own side.
class FlatFace {
 public:
  FlatFace(const Face& face, const std::vector<IntegerVector>& points) : points_(points) {
    const IntegerVector normal = area_vector(points, face);
    const std::size_t axis = longest_axis(normal);
    first_ = (axis + 1) % 3;
    second_ = (axis + 2) % 3;
    side_ = normal[axis].sign();
  }

  /// 1 where the three vertices turn as the face does.
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const IntegerVector &p = points_[a], &q = points_[b], &r = points_[c];
    const Integer area = (q[first_] - p[first_]) * (r[second_] - p[second_]) -
                         (q[second_] - p[second_]) * (r[first_] - p[first_]);
    return area.sign() * side_;
  }

  bool contains(const Face& triangle, std::uint32_t vertex) const {
    return turn(triangle[0], triangle[1], vertex) >= 0 &&
           turn(triangle[1], triangle[2], vertex) >= 0 &&
           turn(triangle[2], triangle[0], vertex) >= 0;
  }

 private:
  const std::vector<IntegerVector>& points_;
  std::size_t first_ = 0, second_ = 1;
  int side_ = 0;
};

class EarCutter {
 public:
  EarCutter(const Face& face, const std::vector<IntegerVector>& points)
      : flat_(face, points), left_(face) {
    for (std::size_t k = 0; k < left_.size(); ++k) convex_.push_back(is_convex(k));
  }

  std::optional<std::vector<Face>> run() {
    std::vector<Face> triangles;
    // The ear about the second vertex first: what is convex is cut as a fan from its first vertex.
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
    triangles.push_back(left_);
    return triangles;
  }

 private:
  std::size_t before(std::size_t k) const { return (k + left_.size() - 1) % left_.size(); }
  std::size_t after(std::size_t k) const { return (k + 1) % left_.size(); }
  Face corner(std::size_t k) const { return {left_[before(k)], left_[k], left_[after(k)]}; }
  bool is_convex(std::size_t k) const {
    return flat_.turn(left_[before(k)], left_[k], left_[after(k)]) > 0;
  }

  /// An ear holds no other vertex. Of those it might hold, the one farthest from its diagonal is
  /// not convex: only such have to be looked at.
  bool is_ear(std::size_t k) const {
    if (!convex_[k]) return false;
    const Face triangle = corner(k);
    for (std::size_t j = 0; j < left_.size(); ++j) {
      if (convex_[j] || j == before(k) || j == after(k)) continue;
      if (flat_.contains(triangle, left_[j])) return false;
    }
    return true;
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

std::optional<std::vector<Face>> triangles_of(const Face& face,
                                              const std::vector<SpacePoint>& vertices) {
  if (face.size() < 3) return std::nullopt;
  if (face.size() == 3) return std::vector<Face>{face};
  std::vector<SpacePoint> corners;
  for (const std::uint32_t vertex : face) corners.push_back(vertices[vertex]);
  Face own(face.size());
  std::iota(own.begin(), own.end(), 0U);
  const IntegerPoints whole = integer_points(corners);
  auto triangles = EarCutter(own, whole.points).run();
  if (!triangles) return std::nullopt;
  for (Face& triangle : *triangles) {
    for (std::uint32_t& corner : triangle) corner = face[corner];
  }
  return triangles;
}

}  // namespace minkref
