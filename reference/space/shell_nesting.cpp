// Each shell's side relative to the other shells: by one exact ray from each shell.
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/space/polyhedron_place.hpp"
#include "reference/space/self_crossing.hpp"

namespace minkref::inline space {
namespace {

/// How often a shell surrounds a point, and one triangle of the shell.
struct Around {
  int times = 0;
  std::uint32_t triangle = 0;
};

/// A ray along an axis that leaves a triangle from an inner point, on the outer side.
class OutwardRay {
 public:
  /// The point is a + b t + c t^2 over 1 + t + t^2, of the corners a, b, c.
  OutwardRay(const SearchedSurface& surface, std::uint32_t from, int t)
      : surface_(surface), from_(from), over_(1 + t + t * t) {
    const IntegerVector &a = corner(from, 0), &b = corner(from, 1), &c = corner(from, 2);
    for (std::size_t k = 0; k < 3; ++k) start_[k] = a[k] + b[k] * t + c[k] * (t * t);
    const IntegerVector normal = cross(b - a, c - a);
    axis_ = longest_axis(normal);
    way_ = normal[axis_].sign();
  }

  /// The shells around the ray's start, just off the triangle; empty if the ray meets an edge, or
  /// starts on another triangle.
  std::optional<std::map<std::uint32_t, Around>> shells() const {
    std::map<std::uint32_t, Around> result;
    const bool unclear = surface_.tree.query(box(), [&](std::uint32_t t) {
      if (t == from_) return false;
      const std::optional<int> passed = passes(t);
      if (!passed) return true;
      if (*passed != 0) {
        Around& around = result[surface_.triangles[t].shell];
        around.times += *passed;
        around.triangle = t;
      }
      return false;
    });
    if (unclear) return std::nullopt;
    return result;
  }

 private:
  const IntegerVector& corner(std::uint32_t t, std::size_t k) const {
    return surface_.signs.points()[surface_.triangles[t].corners[k % 3]];
  }

  SpaceBox box() const {
    SpaceBox result;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = surface_.signs.enclosed(start_[k], over_);
      result.low[k] = low;
      result.high[k] = high;
    }
    (way_ > 0 ? result.high : result.low)[axis_] = way_ * SpaceBox::infinity;
    return result;
  }

  /// Whether the ray passes through a triangle: 1 outwards, -1 inwards, 0 not.
  std::optional<int> passes(std::uint32_t t) const {
    const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    bool left = false, right = false, on = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const IntegerVector &p = corner(t, k), &q = corner(t, k + 1);
      const Integer area =
          (q[i] - p[i]) * (start_[j] - over_ * p[j]) - (q[j] - p[j]) * (start_[i] - over_ * p[i]);
      left = left || area > 0;
      right = right || area < 0;
      on = on || area.is_zero();
    }
    if (left && right) return 0;
    if (on) return std::nullopt;
    const IntegerVector& a = corner(t, 0);
    const IntegerVector normal = cross(corner(t, 1) - a, corner(t, 2) - a);
    const IntegerVector off{start_[0] - over_ * a[0], start_[1] - over_ * a[1],
                            start_[2] - over_ * a[2]};
    const int side = dot(normal, off).sign(), out = way_ * normal[axis_].sign();
    if (side == 0) return std::nullopt;
    return side * out < 0 ? out : 0;
  }

  const SearchedSurface& surface_;
  std::uint32_t from_;
  Integer over_;
  IntegerVector start_;  ///< over `over_`
  std::size_t axis_ = 0;
  int way_ = 0;
};

/// The shells around a point just off a triangle, on its outer side. A line meets the curve of the
/// points that are tried at most twice, and few lines have to be missed: two for each edge above
/// the triangle.
std::map<std::uint32_t, Around> shells_off(const SearchedSurface& surface, std::uint32_t from) {
  for (int t = 1;; ++t) {
    look_for_interrupt();
    if (const auto found = OutwardRay(surface, from, t).shells()) return *found;
  }
}

[[noreturn]] void refuse_shell(const SearchedSurface& surface, std::uint32_t from,
                               const std::map<std::uint32_t, Around>& found, bool in_material) {
  Place place = place_in(surface.polyhedron, surface.triangles[from].face, {});
  if (!in_material) {
    throw BadInput("wrong-orientation", "the shell of this face is inside out, and in no material",
                   "turn all its faces: seen from outside every face runs counter-clockwise",
                   std::move(place));
  }
  const auto holder = std::find_if(found.begin(), found.end(),
                                   [](const auto& shell) { return shell.second.times > 0; });
  place.other_face = surface.triangles[holder->second.triangle].face;
  throw BadInput("shell-nesting", "the shell of this face lies in the material of another shell",
                 "turn all its faces, which makes it a cavity, or leave it out", std::move(place));
}

}  // namespace

void refuse_wrong_nesting(const SearchedSurface& surface) {
  std::uint32_t seen = 0;  // shells are numbered in the order of their first triangles
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (surface.triangles[t].shell < seen) continue;
    ++seen;
    const std::map<std::uint32_t, Around> found = shells_off(surface, t);
    int times = 0;
    for (const auto& [other, around] : found) times += around.times;
    if (times != 0) refuse_shell(surface, t, found, times > 0);
  }
}

}  // namespace minkref::inline space
