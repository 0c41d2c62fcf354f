#include "oracle/checker/space/solid.hpp"

#include <array>

#include "oracle/checker/space/solid_pieces.hpp"
#include "oracle/checker/space/solid_sum.hpp"
#include "oracle/checker/space/space.hpp"

namespace minkref::checker {
namespace {

constexpr const char* solid_form = "solid-certificate-v1";
constexpr std::size_t most_pairs = 20'000;  // of pieces

}  // namespace

bool is_solid_certificate(const Value& certificate) { return has_form(certificate, solid_form); }

std::vector<std::string> check_solids(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget) {
  InSpace opened = open_in_space(certificate, solid_form, "proof", read_case);
  const auto parts = members(*opened.argument, "P Q sums");
  PieceList first = read_pieces(*parts[0], opened.bodies[0]);
  const std::array<PieceList, 2> lists{std::move(first), read_pieces(*parts[1], opened.bodies[1])};
  demand(lists[0].hulls.size() * lists[1].hulls.size() <= most_pairs,
         "there are too many pairs of pieces", Code::out_of_budget);
  mpz_class unit = 1;
  for (const PieceList& list : lists) add_denominators(list.points, unit, budget);
  const mpq_class whole(unit);
  for (std::size_t k = 0; k < 2; ++k) {
    Body& body = opened.bodies[k];
    for (const Triple& point : lists[k].points) {
      body.points.push_back(times({whole, whole, whole}, point));
    }
    within("the pieces of " + body.name,
           [&] { check_tiling(body, hulls_of(lists[k], body.points, budget), budget); });
  }
  std::vector<SolidSum> sums;
  for (const Value& entry : items(*parts[2])) {
    within("sum " + std::to_string(sums.size()),
           [&] { sums.emplace_back(entry, lists, unit, budget); });
  }
  return check_claims(*opened.claims, sums, "planes polygons volume digest", budget);
}

}  // namespace minkref::checker
