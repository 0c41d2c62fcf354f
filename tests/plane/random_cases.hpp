// Tries laws on random operands; shrinks a failing case before showing it.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>

#include "tests/plane/random_polygons.hpp"

namespace minkref::testing {

struct Case {
  PolygonSet P, Q;
  Rational scale = 1;
};

inline std::string text(const Case& c) {
  return "{\"P\":" + text(c.P) + ",\"Q\":" + text(c.Q) + ",\"scale\":\"" + to_string(c.scale) +
         "\"}";
}

/// The fault, or nothing where the law holds. An exception breaks the law too.
using Law = std::function<std::string(const Case&)>;

inline std::string fault(const Law& law, const Case& c) {
  try {
    return law(c);
  } catch (const std::exception& e) {
    return std::string("throws: ") + e.what();
  }
}

/// All valid sets with one polygon, hole or vertex less.
inline std::vector<PolygonSet> smaller(const PolygonSet& set) {
  std::vector<PolygonSet> all;
  const auto add = [&](PolygonSet candidate) {
    if (!candidate.empty() && is_valid(candidate)) all.push_back(std::move(candidate));
  };
  if (!set.is_region()) return all;
  const auto at = [](auto& items, std::size_t i) {
    return items.begin() + static_cast<std::ptrdiff_t>(i);
  };
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    PolygonSet less = set;
    less.polygons.erase(at(less.polygons, i));
    add(std::move(less));
    for (std::size_t h = 0; h < set.polygons[i].holes.size(); ++h) {
      less = set;
      less.polygons[i].holes.erase(at(less.polygons[i].holes, h));
      add(std::move(less));
    }
  }
  for (std::size_t i = 0; i < set.polygons.size(); ++i) {
    for (std::size_t h = 0; h <= set.polygons[i].holes.size(); ++h) {
      const Polygon& polygon = set.polygons[i];
      const std::size_t n = h == 0 ? polygon.outer.size() : polygon.holes[h - 1].size();
      for (std::size_t v = 0; v < n && n > 3; ++v) {
        PolygonSet less = set;
        Polygon& p = less.polygons[i];
        Ring& ring = h == 0 ? p.outer : p.holes[h - 1];
        ring.erase(at(ring, v));
        add(std::move(less));
      }
    }
  }
  return all;
}

/// Greedy: takes the first smaller case that still breaks the law, until no such case exists.
inline Case shrunk(Case c, const Law& law, int budget = 3000) {
  const auto still_fails = [&](const Case& candidate) {
    return --budget > 0 && !fault(law, candidate).empty();
  };
  for (bool again = true; again && budget > 0;) {
    again = false;
    Case unscaled{c.P, c.Q, 1};
    if (c.scale != 1 && still_fails(unscaled)) {
      c = std::move(unscaled);
      again = true;
    }
    for (const PolygonSet& P : smaller(c.P)) {
      Case candidate{P, c.Q, c.scale};
      if (still_fails(candidate)) {
        c = std::move(candidate);
        again = true;
        break;
      }
    }
    for (const PolygonSet& Q : smaller(c.Q)) {
      Case candidate{c.P, Q, c.scale};
      if (still_fails(candidate)) {
        c = std::move(candidate);
        again = true;
        break;
      }
    }
  }
  return c;
}

inline Rational random_scale(Source& random) {
  static const Rational scales[] = {1,
                                    1,
                                    1,
                                    2,
                                    Rational(1, 2),
                                    Rational(1, 3),
                                    Rational(3, 2),
                                    3,
                                    Rational(7, 5),
                                    Rational(541, 186)};
  return scales[random.below(std::size(scales))];
}

inline Case random_case(Source& random) {
  return {random_region(random), random_region(random, 2), random_scale(random)};
}

/// Makers of cases. Sets with random boundaries; pieces of lattices; convex polygons of so many
/// points on a grid.
inline Case regions(Source& random) {
  return {random_region(random, 2), random_region(random, 2), random_scale(random)};
}
inline auto lattice_pieces(int most_cells_of_P, int most_cells_of_Q) {
  return [=](Source& random) -> Case {
    return {random_mesh_region(random, most_cells_of_P),
            random_mesh_region(random, most_cells_of_Q), random_scale(random)};
  };
}
inline auto convex_polygons(int points = 7, int size = 9) {
  return [=](Source& random) -> Case {
    return {random_convex_polygon(random, points, size),
            random_convex_polygon(random, points, size), random_scale(random)};
  };
}

/// A point or a short segment, and a set of at most so many cells, either of them as P.
inline auto thin_and_wide(int reach, int parts) {
  return [=](Source& random) -> Case {
    const Point a{random.between(-3, 3), random.between(-3, 3)};
    const Point b = a + Point{random.between(-reach, reach), random.between(1, reach)};
    const PolygonSet thin = random.coin() ? segment_set(a, b) : point_set(a.x, a.y);
    const PolygonSet wide = random_region(random, parts);
    return random.coin() ? Case{thin, wide, random_scale(random)}
                         : Case{wide, thin, random_scale(random)};
  };
}

/// Coincidences of lattice pieces missed by a hair: faces far thinner than doubles can tell.
inline auto shaken_lattice_pieces(Rational (*scale)(Source&)) {
  return [=](Source& random) -> Case {
    for (;;) {
      const int bits = std::array{20, 45, 56, 70, 110}[random.below(5)];
      const Case c{shaken(random, random_mesh_region(random, 3), bits),
                   shaken(random, random_mesh_region(random, 2), bits), scale(random)};
      if (is_valid(c.P) && is_valid(c.Q)) return c;
    }
  };
}

/// Tries the law on `count` cases; stops at the first failing case and shows it shrunk.
template <class Make>
void expect_law(Source& random, int count, Make&& make, const Law& law) {
  for (int i = 0; i < repetitions(count); ++i) {
    const Case drawn = make(random);
    if (fault(law, drawn).empty()) continue;
    const Case smallest = shrunk(drawn, law);
    ADD_FAILURE() << "repetition " << i << ": " << fault(law, smallest) << "\n" << text(smallest);
    return;
  }
}

inline void expect_law(Source& random, int count, const Law& law) {
  expect_law(random, count, random_case, law);
}

/// Empty iff both texts are equal.
inline std::string unequal(const PolygonSet& expected, const PolygonSet& actual) {
  if (expected == actual) return "";
  return "expected " + text(expected) + "\nactual " + text(actual);
}

}  // namespace minkref::testing
