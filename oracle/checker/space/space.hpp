// Code shared by the forms of certificates in space: vectors, rings, operands, claims.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "oracle/checker/budget.hpp"
#include "oracle/checker/following.hpp"
#include "oracle/checker/json_value.hpp"
#include "oracle/checker/reading.hpp"

namespace minkref::checker {

using Whole = std::array<mpz_class, 3>;
using Triple = std::array<mpq_class, 3>;
using Ring = std::vector<std::uint32_t>;

Whole plus(const Whole& u, const Whole& v);
Whole minus(const Whole& u, const Whole& v);
Whole negative(const Whole& v);
Whole cross(const Whole& u, const Whole& v);
mpz_class dot(const Whole& u, const Whole& v);
bool is_zero(const Whole& v);
/// Returns the shortest whole vector in this direction; zero for zero.
Whole primitive(const Whole& v);
/// Positive if the way a b c turns left, seen against the normal.
int turn(const Whole& a, const Whole& b, const Whole& c, const Whole& normal);
/// Twice the area, pointing to the side from which the ring runs counter-clockwise.
Whole area_vector(const std::vector<Whole>& ring);
/// Returns the hull's corners of points in a plane, counter-clockwise seen against the normal:
/// lexicographic order gives a sweep.
std::vector<Whole> hull_in_plane(std::vector<Whole> points, const Whole& normal);
std::vector<Whole> corners_of(const Ring& ring, const std::vector<Whole>& points);

/// Whether a ring has at least three indices, and none twice.
bool is_ring(const Ring& ring);
/// Whether all numbers below `end` occur.
bool all_used(const std::vector<Ring>& rings, std::size_t end);

Triple triple(const Value& value);
/// Multiplies; the products must be whole numbers.
Whole times(const Triple& factors, const Triple& point);
std::string to_text(const Triple& point);  ///< `x, y, z`
/// Writes the hashed text of faces and vertices.
std::string canonical_json(const std::vector<Ring>& faces, const std::vector<Triple>& vertices);

/// A polyhedron with vertices and faces in file order.
struct Body {
  std::string name;
  std::vector<Triple> exact;
  std::vector<Whole> points;  ///< in units that make coordinates whole
  std::vector<Ring> faces;
};

/// A certificate in space: operands with verified digest, the argument to follow, and the claims.
struct InSpace {
  std::array<Body, 2> bodies;
  const Value* argument;
  const Value* claims;
};

/// Opens a certificate; `argument` names the form's member for the argument. Throws NotVerified.
InSpace open_in_space(const Value& certificate, const std::string& form,
                      const std::string& argument,
                      const std::function<Value(const std::string&)>& read_case);

/// Makes `unit` also clear the denominators of these points.
void add_denominators(const std::vector<Triple>& points, mpz_class& unit, Budget& budget);

/// Checks claims about sums and returns a line for each; `names`: further members of a claim.
template <class Sums>
std::vector<std::string> check_claims(const Value& claims, const Sums& sums,
                                      const std::string& names, Budget& budget) {
  std::set<Triple> scalings;
  for (const auto& sum : sums) scalings.insert(sum.scaling());
  require(scalings.size() == sums.size(), "two sums are at one scaling");
  require_different(claims);
  std::vector<std::string> said;
  std::set<std::uint32_t> used;
  for (const Value& claim : items(claims)) {
    within("claim " + std::to_string(said.size()), [&] {
      budget.spend(64);
      const auto parts = members(claim, "claim sum scaling " + names);
      require(parts[0]->kind == Value::Kind::text && parts[0]->text == "sum",
              "there is no such claim");
      const std::uint32_t of = index(*parts[1], sums.size());
      used.insert(of);
      said.push_back(sums[of].check_claim(parts));
    });
  }
  require(!said.empty() && used.size() == sums.size(), "nothing is claimed, or a sum is not used");
  return said;
}

}  // namespace minkref::checker
