#include "oracle/checker/space/solid_point.hpp"

#include <algorithm>
#include <array>

#include "oracle/checker/space/solid_tiling.hpp"
#include "oracle/checker/space/space.hpp"

namespace minkref::checker {
namespace {

constexpr const char* form = "solid-point-certificate-v1";

bool is_of_kind(const Value& claim, const std::string& kind) {
  return std::any_of(claim.members.begin(), claim.members.end(), [&](const Member& member) {
    return member.name == "claim" && member.value.kind == Value::Kind::text &&
           member.value.text == kind;
  });
}

Triple scaling_of(const Value& value) {
  const Triple factors = triple(value);
  require(*std::min_element(factors.begin(), factors.end()) > 0,
          "a factor of the scaling is not positive");
  return factors;
}

Triple product(const Triple& factors, const Triple& point) {
  return {mpq_class(factors[0] * point[0]), mpq_class(factors[1] * point[1]),
          mpq_class(factors[2] * point[2])};
}

mpq_class along(const Triple& normal, const Whole& point) {
  return mpq_class(normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2]);
}

mpq_class support(const Hull& hull, const Triple& normal) {
  mpq_class most = along(normal, hull.points[0]);
  for (const Whole& p : hull.points) most = std::max(most, along(normal, p));
  return most;
}

/// Whether the hull, whose points are in units, holds a point.
bool holds(const Hull& hull, const Triple& point, const mpq_class& unit) {
  return std::all_of(hull.facets.begin(), hull.facets.end(), [&](const auto& facet) {
    const mpz_class level = dot(facet.first, facet.second[0]);
    return mpq_class(unit * along(point, facet.first)) <= level;
  });
}

std::string told(const std::string& claim, const Triple& point, const Triple& scaling) {
  return claim + ": (" + to_text(point) + ") at (" + to_text(scaling) + ")";
}

/// S p + q, with p in a piece of P and q in a piece of Q.
std::string check_point(const Value& claim, const Tiling& tiling, Budget& budget) {
  const auto parts = members(claim, "claim scaling point p q pieces");
  const Triple scaling = scaling_of(*parts[1]), point = triple(*parts[2]);
  const std::array<Triple, 2> of{triple(*parts[3]), triple(*parts[4])};
  const Triple scaled = product(scaling, of[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    demand(mpq_class(scaled[k] + of[1][k]) == point[k], "S p + q is another point");
  }
  const auto& nodes = items(*parts[5], 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const Hull& piece = tiling.pieces[k][index(nodes[k], tiling.pieces[k].size())];
    budget.spend(piece.facets.size());
    demand(holds(piece, of[k], mpq_class(tiling.unit)), "p or q is not in its piece");
  }
  return told("point", point, scaling);
}

/// For each pair of pieces a normal, along which the point is farther than the pair's sum.
std::string check_outside(const Value& claim, const Tiling& tiling, Budget& budget) {
  const auto parts = members(claim, "claim scaling point normals code");
  const Triple scaling = scaling_of(*parts[1]), point = triple(*parts[2]);
  std::vector<Whole> normals;
  for (const Value& normal : items(*parts[3])) {
    const auto& three = items(normal, 3);
    normals.push_back({integer(three[0]), integer(three[1]), integer(three[2])});
    require(!is_zero(normals.back()), "a normal is 0");
  }
  const auto& [first, second] = tiling.pieces;
  items(*parts[4], first.size() * second.size());
  const Ring code = indices(*parts[4], normals.size());
  require(all_used({code}, normals.size()), "a normal is not used");
  auto entry = code.begin();
  for (const Hull& A : first) {
    for (const Hull& B : second) {
      budget.spend(A.points.size() + B.points.size());
      const Whole& n = normals[*entry++];
      const Triple exact{n[0], n[1], n[2]};
      const mpq_class most = support(A, product(scaling, exact)) + mpq_class(B.support(n));
      demand(mpq_class(mpq_class(tiling.unit) * along(point, n)) > most,
             "a normal does not hold the point apart");
    }
  }
  return told("outside", point, scaling);
}

}  // namespace

bool is_solid_point_certificate(const Value& certificate) { return has_form(certificate, form); }

std::vector<std::string> check_solid_points(
    const Value& certificate, const std::function<Value(const std::string&)>& read_case,
    Budget& budget) {
  InSpace opened = open_in_space(certificate, form, "proof", read_case);
  const auto parts = members(*opened.argument, "P Q");
  const Tiling tiling = checked_tiling(opened.bodies, *parts[0], *parts[1], budget);
  require_different(*opened.claims);
  std::vector<std::string> said;
  for (const Value& claim : items(*opened.claims)) {
    within("claim " + std::to_string(said.size()), [&] {
      budget.spend(64);
      const bool is_point = is_of_kind(claim, "point");
      require(is_point || is_of_kind(claim, "outside"), "there is no such claim");
      said.push_back((is_point ? check_point : check_outside)(claim, tiling, budget));
    });
  }
  require(!said.empty(), "nothing is claimed");
  return said;
}

}  // namespace minkref::checker
