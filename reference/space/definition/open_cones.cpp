#include "reference/space/definition/open_cones.hpp"

#include <algorithm>
#include <set>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

IntegerVector opposite(const IntegerVector& v) { return {-v[0], -v[1], -v[2]}; }

bool enters(const IntegerVector& ray, const Cone& cone) {
  return std::all_of(cone.begin(), cone.end(),
                     [&](const IntegerVector& normal) { return dot(normal, ray).sign() < 0; });
}

bool enters_one(const IntegerVector& ray, const std::vector<Cone>& cones) {
  look_for_interrupt();
  return std::any_of(cones.begin(), cones.end(),
                     [&](const Cone& cone) { return enters(ray, cone); });
}

/// One normal from each opposite pair.
std::vector<IntegerVector> planes_of(const std::vector<Cone>& cones) {
  std::set<IntegerVector> normals;
  for (const Cone& cone : cones) {
    for (const IntegerVector& normal : cone) {
      normals.insert(std::max(normal, opposite(normal)));
    }
  }
  return {normals.begin(), normals.end()};
}

}  // namespace

// The set that no open sector covers is closed, and ends at planes that bound sectors.
bool cover_all_about(const IntegerVector& axis, const std::vector<Cone>& cones) {
  const std::vector<IntegerVector> planes = planes_of(cones);
  return !planes.empty() &&
         std::all_of(planes.begin(), planes.end(), [&](const IntegerVector& normal) {
           const IntegerVector ray = cross(axis, normal);
           return enters_one(ray, cones) && enters_one(opposite(ray), cones);
         });
}

// The set that no open cone covers is a closed union of faces of the planes' arrangement, and
// contains the least faces: rays where two planes meet, unless all planes coincide.
bool cover_all(const std::vector<Cone>& cones) {
  const std::vector<IntegerVector> planes = planes_of(cones);
  if (planes.size() < 2) return false;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const IntegerVector ray = cross(planes[i], planes[j]);
      if (!enters_one(ray, cones) || !enters_one(opposite(ray), cones)) return false;
    }
  }
  return true;
}

}  // namespace minkref::inline space
