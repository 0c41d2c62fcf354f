#include "reference/plane/sum.hpp"

#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/boundary_graph.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/route_names.hpp"
#include "reference/plane/routes/routes.hpp"

namespace minkref::inline plane {
namespace {

void refuse_bad_scale(const Rational& scale) {
  if (sign(scale) > 0) return;
  throw BadInput("bad-scale", "the scale " + to_string(scale) + " is not greater than zero",
                 "give a scale s > 0");
}

BoundaryGraph exact_route(const PolygonSet& P, const PolygonSet& Q, Route route, Sum& sum) {
  std::vector<TightPassage>* passages = sum.tight_passages ? &*sum.tight_passages : nullptr;
  if (passages != nullptr && route != Route::paper) *passages = tight_passages(P, Q, 1);
  switch (route) {
    case Route::paper:
      return paper_route(P, Q, sum.statistics, passages);
    case Route::winding:
      return winding_route(P, Q, sum.statistics);
    case Route::definition:
      return definition_route(P, Q, sum.statistics);
  }
  throw Error("minkowski_sum: no such route");
}

}  // namespace

const std::vector<RouteName>& route_names() {
  static const std::vector<RouteName> names{
      {Route::paper, "paper",
       "reduced convolution, orientable loops, nesting, collision detection"},
      {Route::winding, "winding", "winding number of the full convolution of slit operands"},
      {Route::definition, "definition", "union of the sums of all pairs of triangles"},
  };
  return names;
}

Route route_named(std::string_view name) {
  const auto& all = route_names();
  std::string choice;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return all[i].route;
    choice += i == 0 ? "choose " : i + 1 < all.size() ? ", " : " or ";
    choice += all[i].name;
  }
  throw BadInput("unknown-route", "there is no route \"" + std::string(name) + "\"", choice);
}

void refuse_bad_operands(const PolygonSet& P, const PolygonSet& Q, const Rational& scale) {
  refuse_bad_scale(scale);
  if (is_thin(P) && is_thin(Q)) {
    throw BadInput("degenerate-operands", "both operands are points or segments",
                   "make one of them a polygon set (or the empty set)");
  }
}

Sum minkowski_sum(const PolygonSet& P, const PolygonSet& Q, const Rational& scale, Route route,
                  const std::string& arithmetic, Passages passages) {
  const FloatEnvironment standard;
  refuse_bad_scale(scale);
  Sum sum;
  // Two operands without area have no tight passages: sum_remnants finds what lies beside.
  const bool are_thin = is_thin(P) && is_thin(Q);
  if (passages == Passages::find && arithmetic == "rational" && !are_thin) {
    sum.tight_passages.emplace();
  }
  if (P.empty() || Q.empty()) return sum;
  Canonical canonical;
  if (arithmetic == "rational") {
    canonical = canonical_form(exact_route(scaled(P, scale), Q, route, sum));
    if (!canonical.well_formed)
      throw std::logic_error("minkowski_sum: the boundary is not well formed");
  } else if (route == Route::paper) {
    canonical = paper_route_in(arithmetic, P, Q, scale, sum.statistics);
  } else {
    throw BadInput("route-and-arithmetic",
                   "arithmetic " + arithmetic + " is offered for the paper's route only",
                   "leave the route away, or use rational arithmetic");
  }
  sum.region = std::move(canonical.region);
  sum.components = canonical.components;
  sum.holes = canonical.holes;
  return sum;
}

Rational area(const Sum& sum) { return area(sum.region); }

}  // namespace minkref::inline plane
