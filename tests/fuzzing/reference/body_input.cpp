#include "tests/fuzzing/reference/body_input.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "formats/mesh_formats.hpp"
#include "tests/fuzzing/reference/input_tally.hpp"

namespace minkref::fuzzing {
namespace {

void scale_by(Scaling& scaling, std::size_t axis, const Rational& factor) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (axis == k || axis == 3) scaling[k] *= factor;
  }
}

/// The factor of the axis that makes a facet of one body parallel to an edge of the other; 0 or
/// negative if no factor does. `weighted`: the normals are Q's (contact.hpp).
Rational parallel_factor(const Scaling& scaling, std::size_t axis, const IntegerVector& normal,
                         const IntegerVector& edge, bool weighted) {
  Rational others = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational product(normal[k] * edge[k]);
    if (k != axis)
      others += weighted ? Rational(product * scaling[k]) : Rational(product / scaling[k]);
  }
  const Rational own(normal[axis] * edge[axis]);
  if (own == 0 || others == 0) return 0;
  return weighted ? Rational(-others / own) : Rational(-own / others);
}

}  // namespace

std::vector<LatticePoint> next_points(Bytes& bytes, const std::vector<LatticePoint>& other) {
  static constexpr std::array<std::int64_t, 4> reaches{1, 2, 5, 127};
  const unsigned head = bytes.next();
  const std::int64_t reach = reaches[head & 3U];
  std::vector<LatticePoint> points(4 + (head >> 2U) % 7);
  for (LatticePoint& p : points) {
    for (std::int64_t& c : p) c = bytes.next() % (2 * reach + 1) - reach;
  }
  const unsigned relation = head >> 6U;
  for (const auto& [x, y, z] : other) {
    if (relation == 2) points.push_back({x, y, z});
    if (relation == 3) points.push_back({-x, -y, -z});
  }
  if (hull_of_points(points).empty()) {
    points.insert(points.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  }
  return points;
}

Scaling next_magnitude(Bytes& bytes) {
  Scaling factors{1, 1, 1};
  const unsigned head = bytes.next();
  if (head < 128) return factors;
  const std::size_t axis = head & 3U;
  if (head < 160) {
    scale_by(factors, axis, Rational(1 + (head >> 2U & 7U), 3));
  } else {
    scale_by(factors, axis, power_of_two(bytes.next_signed()));
  }
  return factors;
}

Scaling next_scaling(Bytes& bytes, Scaling from, const ConvexPolyhedron& P,
                     const ConvexPolyhedron& Q) {
  const unsigned head = bytes.next();
  const std::size_t axis = head >> 3U & 3U;
  switch (head & 7U) {
    case 0:
      return {1, 1, 1};
    case 1:
    case 2: {
      const unsigned ratio = bytes.next();
      scale_by(from, axis, Rational(1 + (ratio & 15U), 1 + (ratio >> 4U)));
      return from;
    }
    case 3: {  // by next to nothing
      const long step = bytes.next_signed();
      scale_by(from, axis, 1 + step * power_of_two(-static_cast<long>(8 + (head >> 5U) * 8)));
      return from;
    }
    case 4:
      from[axis % 3] = power_of_two(bytes.next_signed());
      return from;
    default:
      break;
  }
  const bool weighted = (head & 1U) != 0;
  const ConvexPolyhedron &normals = weighted ? Q : P, &edges = weighted ? P : Q;
  const std::uint32_t facet = bytes.next() % normals.facets();
  const std::uint32_t half_edge = bytes.next() % edges.half_edges();
  const Rational factor =
      parallel_factor(from, axis % 3, normals.normal(facet), edges.vector(half_edge), weighted);
  if (factor > 0) from[axis % 3] = factor;
  return from;
}

void broken(const std::string& law, const BodyPair& pair, const std::string& what) {
  std::fprintf(stderr, "broken law: %s\n%s\nP.json: %sQ.json: %s", law.c_str(), what.c_str(),
               write_mesh_json(pair.P).c_str(), write_mesh_json(pair.Q).c_str());
  for (const Scaling& s : pair.scalings) {
    std::fprintf(stderr, "scaling: %s %s %s\n", to_string(s[0]).c_str(), to_string(s[1]).c_str(),
                 to_string(s[2]).c_str());
  }
  tally().print();
  std::abort();
}

void expect_same(const std::string& law, const BodyPair& pair, const Polyhedron& expected,
                 const Polyhedron& actual) {
  if (expected == actual) return;
  broken(law, pair, write_mesh_json(expected) + "against\n" + write_mesh_json(actual));
}

int check_bodies(const std::uint8_t* data, std::size_t size,
                 const std::function<void(BodyPair&, Bytes&, Dice&)>& check) {
  ++tally().inputs;
  ++tally().valid;
  Bytes bytes({data, size});
  Dice dice(std::string_view(reinterpret_cast<const char*>(data), size));
  BodyPair pair;
  try {
    check(pair, bytes, dice);
  } catch (const std::exception& e) {
    broken("nothing is thrown on convex bodies", pair, e.what());
  }
  return 0;
}

}  // namespace minkref::fuzzing
