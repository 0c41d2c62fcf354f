// Sums of convex bodies: updates against what is found from scratch, the surface against the
// definition, and laws.
#include <span>
#include <string>

#include "reference/space/convex/incompatibility.hpp"
#include "reference/space/convex/segment_sum.hpp"
#include "reference/space/convex/static_convex_sum.hpp"
#include "tests/fuzzing/reference/body_input.hpp"

namespace minkref::fuzzing {
namespace {

constexpr int most_steps = 48;
const Scaling unit{1, 1, 1};

Polyhedron sum_of(const Polyhedron& P, const Polyhedron& Q, const Scaling& scaling) {
  const ConvexPolyhedron p(P), q(Q);
  Contacts contacts(p, q);
  contacts.rescale(scaling);
  return surface_of(p, q, scaling, by_traversal(contacts)).surface;
}

/// Checks one update, whose state depends only on the scaling.
void check_update(const BodyPair& pair, DynamicConvexSum& moving, Contacts& contacts, Dice& dice) {
  const Scaling& to = pair.scalings.back();
  const UpdateCounts counts = moving.update(to);
  contacts.rescale(to);
  const Compatibility found = by_traversal(contacts);
  if (moving.compatibility() != found) broken("an update has the pairs of the traversal", pair);
  if (dice.one_in(6) && by_brute_force(contacts) != found) {
    broken("the traversal has the pairs of all pairs compared", pair);
  }
  const SumVertices vertices(moving.P(), moving.Q(), found);
  if (moving.vertices().pairs() != vertices.pairs() ||
      moving.vertices().size() != vertices.size()) {
    broken("an update has the vertices of its pairs", pair);
  }
  std::uint64_t ee_pairs = 0;
  for (const auto& chain : found.chains) ee_pairs += chain.size();
  if (moving.ee_pairs() != ee_pairs) broken("an update counts its ee-pairs", pair);
  if (counts.chains_without_error != 0) {
    broken("no chain is wrong without an error of a facet (Theorem 1)", pair);
  }
}

/// The numbers of the points farthest along a normal, and their height.
struct Farthest {
  Integer height;
  std::vector<std::uint32_t> points;

  Farthest(std::span<const IntegerVector> all, const IntegerVector& normal) {
    for (std::uint32_t v = 0; v < all.size(); ++v) {
      const Integer here = dot(all[v], normal);
      if (points.empty() || here > height) {
        height = here;
        points.clear();
      }
      if (here == height) points.push_back(v);
    }
  }
};

/// Checks by definition: every vertex is a sum, and no sum lies above a facet's plane, whose
/// parents are the farthest faces of both operands.
void check_surface(const BodyPair& pair, const DynamicConvexSum& moving, const ConvexSum& sum) {
  const ConvexPolyhedron body(sum.surface);
  expect_same("a surface is its own canonical form", pair, sum.surface, body.surface());
  // All coordinates over a common denominator.
  const Polyhedron P = scaled(moving.P().surface(), moving.scaling()), Q = moving.Q().surface();
  std::vector<SpacePoint> vertices = P.vertices;
  for (const Polyhedron* other : {&Q, &sum.surface}) {
    vertices.insert(vertices.end(), other->vertices.begin(), other->vertices.end());
  }
  const IntegerPoints whole = integer_points(vertices);
  const std::span<const IntegerVector> all(whole.points);
  const auto of_P = all.first(P.vertices.size());
  const auto of_Q = all.subspan(P.vertices.size(), Q.vertices.size());
  const auto sums = all.last(sum.surface.vertices.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const auto [p, q] = sum.vertex_parents[v];
    if (sums[v] != of_P[p] + of_Q[q]) {
      broken("a vertex is the sum of its parents", pair, "vertex " + std::to_string(v));
    }
  }
  for (std::uint32_t f = 0; f < body.facets(); ++f) {
    const IntegerVector& normal = body.normal(f);
    const Farthest p(of_P, normal), q(of_Q, normal);
    const std::string which = "facet " + std::to_string(f);
    if (dot(sums[sum.surface.faces[f][0]], normal) != p.height + q.height) {
      broken("a facet is as far out as the operands together", pair, which);
    }
    if (sum.facet_parents[f] != FacetParents{p.points, q.points}) {
      broken("the parents of a facet are the faces farthest along its normal", pair, which);
    }
  }
}

/// The degree of incompatibility, corrected, leads to a farthest vertex.
void check_descent(const BodyPair& pair, const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                   const Scaling& scaling, Dice& dice) {
  const auto facet = static_cast<std::uint32_t>(dice.below(P.facets()));
  const auto from = static_cast<std::uint32_t>(dice.below(Q.vertices()));
  const auto to = descend(P, facet, Q, from, scaling, Form::corrected);
  const Polyhedron scaled_P = scaled(P.surface(), scaling);
  const IntegerVector normal =
      normal_of(integer_points(scaled_P.vertices).points, scaled_P.faces[facet]);
  const std::vector<IntegerVector> points = integer_points(Q.surface().vertices).points;
  if (!to || dot(points[*to], normal) != Farthest(points, normal).height) {
    broken("the descent ends at a vertex farthest along the normal", pair,
           "facet " + std::to_string(facet) + " from vertex " + std::to_string(from));
  }
}

SpacePoint minus(const SpacePoint& a, const SpacePoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

void check_law(const BodyPair& pair, const ConvexPolyhedron& P, const Polyhedron& sum, Dice& dice) {
  const Scaling& s = pair.scalings.back();
  switch (dice.below(6)) {
    case 0:
      return expect_same("exchange of operands", pair, sum,
                         sum_of(pair.Q, scaled(pair.P, s), unit));
    case 1: {
      const SpacePoint by{Rational(dice.between(-9, 9), 7), power_of_two(dice.between(0, 70)), -3};
      return expect_same("translation of Q", pair, translated(sum, by),
                         sum_of(pair.P, translated(pair.Q, by), s));
    }
    case 2: {
      const Scaling both{Rational(3, 7), power_of_two(dice.between(-80, 80)), 5};
      return expect_same("scaling of both", pair, scaled(sum, both),
                         sum_of(scaled(pair.P, both), scaled(pair.Q, both), s));
    }
    case 3:
      return expect_same("faces cut into triangles", pair, sum,
                         sum_of(triangulated(pair.P), triangulated(pair.Q), s));
    case 4: {
      // An edge or a diagonal of P, parallel to some facets of P.
      const Polyhedron surface = P.surface();
      const SpacePoint &a = surface.vertices[0], &b = dice.of(surface.vertices);
      if (a == b) return;
      const SpacePoint origin{0, 0, 0}, to = minus(b, a);
      const Polyhedron longer =
          sum_with_segment(ConvexPolyhedron(pair.Q), unit, origin, to).surface;
      return expect_same("a segment added to the sum or to Q", pair,
                         sum_with_segment(ConvexPolyhedron(sum), unit, origin, to).surface,
                         sum_of(pair.P, longer, s));
    }
    default:
      return check_descent(pair, P, ConvexPolyhedron(pair.Q), s, dice);
  }
}

/// A surface costs as much as dozens of updates: one question about one, half the time none.
void check_one(const BodyPair& pair, const DynamicConvexSum& moving, Dice& dice) {
  switch (dice.below(4)) {
    case 0:
      return check_surface(pair, moving, surface_of(moving));
    case 1:
      return check_law(pair, moving.P(), surface_of(moving).surface, dice);
    default:
      return;
  }
}

void check(BodyPair& pair, Bytes& bytes, Dice& dice) {
  const std::vector<LatticePoint> of_P = next_points(bytes, {}), of_Q = next_points(bytes, of_P);
  pair.P = scaled(hull_of_points(of_P), next_magnitude(bytes));
  pair.Q = scaled(hull_of_points(of_Q), next_magnitude(bytes));
  const ConvexPolyhedron P(pair.P), Q(pair.Q);
  pair.scalings.push_back(unit);
  DynamicConvexSum moving(P, Q, unit);
  Contacts contacts(P, Q);
  const Compatibility at_unit = moving.compatibility();
  for (int step = 0; step == 0 || (step < most_steps && !bytes.empty()); ++step) {
    pair.scalings.push_back(next_scaling(bytes, pair.scalings.back(), P, Q));
    check_update(pair, moving, contacts, dice);
  }
  check_one(pair, moving, dice);
  moving.update(unit);
  if (moving.compatibility() != at_unit) broken("back at a scaling all is as it was", pair);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_bodies(data, size, minkref::fuzzing::check);
}
