#include "oracle/checker/space/solid.hpp"

#include "oracle/checker/space/solid_sum.hpp"
#include "oracle/checker/space/solid_tiling.hpp"
#include "oracle/checker/space/space.hpp"

namespace minkref::checker {
namespace {

constexpr const char* solid_form = "solid-certificate-v1";

}  // namespace

bool is_solid_certificate(const Value& certificate) { return has_form(certificate, solid_form); }

std::vector<std::string> check_solids(const Value& certificate,
                                      const std::function<Value(const std::string&)>& read_case,
                                      Budget& budget) {
  InSpace opened = open_in_space(certificate, solid_form, "proof", read_case);
  const auto parts = members(*opened.argument, "P Q sums");
  const Tiling tiling = checked_tiling(opened.bodies, *parts[0], *parts[1], budget);
  std::vector<SolidSum> sums;
  for (const Value& entry : items(*parts[2])) {
    within("sum " + std::to_string(sums.size()),
           [&] { sums.emplace_back(entry, tiling.lists, tiling.unit, budget); });
  }
  return check_claims(*opened.claims, sums,
                      "planes polygons volume digest components? cavities? tunnels?", budget);
}

}  // namespace minkref::checker
