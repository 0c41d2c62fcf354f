// Polyhedra for tests.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "reference/space/convex/convex_sum.hpp"
#include "reference/space/convex/static_convex_sum.hpp"
#include "tests/number/random_numbers.hpp"

namespace minkref::bodies {

/// Runs a check with dice of seeds 1, 2, ..., up to the repetitions of `count`; a failure names the
/// seed, and a fatal failure ends the run.
template <typename Check>
void for_each_seed(unsigned count, Check&& check) {
  const unsigned last = testing::repetitions(count);
  for (unsigned seed = 1; seed <= last && !::testing::Test::HasFatalFailure(); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 dice(seed);
    check(dice);
  }
}

/// In canonical form.
inline Polyhedron canonical(const Polyhedron& surface) {
  return ConvexPolyhedron(surface).surface();
}

inline SpacePoint at(int x, int y, int z) { return {x, y, z}; }

inline Polyhedron box(int x, int y, int z) {
  return {{at(0, 0, 0), at(x, 0, 0), at(x, y, 0), at(0, y, 0), at(0, 0, z), at(x, 0, z),
           at(x, y, z), at(0, y, z)},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

/// A box whose top consists of four triangles with a common apex.
inline Polyhedron with_apex(Polyhedron box, const SpacePoint& apex) {
  box.vertices.push_back(apex);
  box.faces.erase(box.faces.begin() + 1);
  for (std::uint32_t k = 0; k < 4; ++k) box.faces.push_back({4 + k, 4 + (k + 1) % 4, 8});
  return box;
}

inline Polyhedron tetrahedron(SpacePoint a, SpacePoint b, SpacePoint c, SpacePoint d) {
  Polyhedron result{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  if (sextuple_volume(result) < 0) std::swap(result.vertices[0], result.vertices[1]);
  return result;
}

inline Polyhedron octahedron() {
  return {{at(1, 0, 0), at(-1, 0, 0), at(0, 1, 0), at(0, -1, 0), at(0, 0, 1), at(0, 0, -1)},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// With integer coordinates of at most `size`, and some volume.
inline Polyhedron random_tetrahedron(std::mt19937& dice, int size) {
  std::uniform_int_distribution<int> coordinate(-size, size);
  for (;;) {
    std::vector<SpacePoint> p;
    for (int k = 0; k < 4; ++k)
      p.push_back(at(coordinate(dice), coordinate(dice), coordinate(dice)));
    Polyhedron result = tetrahedron(p[0], p[1], p[2], p[3]);
    if (sextuple_volume(result) > 0) return result;
  }
}

inline const Scaling unit{1, 1, 1};

inline ConvexSum sum(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling = unit) {
  const ConvexPolyhedron p(P), q(Q);
  Contacts contacts(p, q);
  contacts.rescale(scaling);
  return surface_of(p, q, scaling, by_traversal(contacts));
}

/// The sum of a few tetrahedra: parallel edges and facets abound on a small grid.
inline Polyhedron random_body(std::mt19937& dice, int size) {
  Polyhedron result = random_tetrahedron(dice, size);
  for (int more = std::uniform_int_distribution<int>(0, 2)(dice); more > 0; --more) {
    result = sum(result, random_tetrahedron(dice, size)).surface;
  }
  return result;
}

inline Scaling random_scaling(std::mt19937& dice) {
  std::uniform_int_distribution<int> above(1, 6), below(1, 3);
  return {Rational(above(dice), below(dice)), Rational(above(dice), below(dice)),
          Rational(above(dice), below(dice))};
}

}  // namespace minkref::bodies
