// A walk of a convex sum through scalings, timed beside the static routes.
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_convex.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/space/convex/convex_sum.hpp"
#include "reference/space/convex/static_convex_sum.hpp"
#include "reference/space/convex/sum_coordinates.hpp"
#include "reference/space/convex/word_surface.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// Seconds of each step.
struct Times {
  std::vector<double> updates, coordinates, traversals;
  std::vector<double> surfaces, brute_force;  // at every so many steps
};

class TimedWalk {
 public:
  TimedWalk(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& from)
      : P_(P), Q_(Q), dynamic_(P, Q, from), contacts_(P, Q) {
    sum_coordinates(P, Q, from, dynamic_.vertices(), points_);
    make_surface();
  }

  void step(const Scaling& to, bool all) {
    const Stopwatch update;
    counts_ += dynamic_.update(to);
    times_.updates.push_back(update.seconds());
    const Stopwatch coordinates;
    sum_coordinates(P_, Q_, to, dynamic_.vertices(), points_);
    times_.coordinates.push_back(coordinates.seconds());
    pairs_.push_back(dynamic_.vertices().size());
    ee_pairs_.push_back(dynamic_.ee_pairs());
    times_.traversals.push_back(from_scratch(to, by_traversal));
    if (!all) return;
    const Stopwatch surface;
    const std::size_t facets = make_surface();
    times_.surfaces.push_back(surface.seconds());
    facets_.push_back(facets);
    merged_.push_back(surface_.merged());
    times_.brute_force.push_back(from_scratch(to, by_brute_force));
  }

  Fields fields() const {
    Fields fields = fields_of(counts_);
    fields["update_seconds"] = times_.updates;
    fields["coordinate_seconds"] = times_.coordinates;
    fields["traversal_seconds"] = times_.traversals;
    fields["surface_seconds"] = times_.surfaces;
    fields["brute_force_seconds"] = times_.brute_force;
    fields["vertex_pairs"] = pairs_;
    fields["ee_pairs"] = ee_pairs_;
    fields["surface_facets"] = facets_;
    fields["merged_pieces"] = merged_;
    fields["differences"] = differences_;
    return fields;
  }

 private:
  /// How many facets there are.
  std::size_t make_surface() {
    if (surface_.renew(dynamic_)) return surface_.facets().size();
    return surface_of(dynamic_).surface.faces.size();
  }

  /// Seconds of the route, with coordinates. The route has to find the state after the update.
  double from_scratch(const Scaling& at, Compatibility (*route)(const Contacts&)) {
    const Stopwatch watch;
    contacts_.rescale(at);
    const Compatibility found = route(contacts_);
    const SumVertices vertices(P_, Q_, found);
    sum_coordinates(P_, Q_, at, vertices, fresh_points_);
    const double seconds = watch.seconds();
    if (found != dynamic_.compatibility()) ++differences_;
    return seconds;
  }

  const ConvexPolyhedron& P_;
  const ConvexPolyhedron& Q_;
  DynamicConvexSum dynamic_;
  Contacts contacts_;
  HomogeneousPoints points_, fresh_points_;
  WordSurface surface_;
  Times times_;
  UpdateCounts counts_;
  std::vector<std::uint64_t> pairs_, ee_pairs_, facets_, merged_;
  std::uint64_t differences_ = 0;
};

Fields timed_walk(const ConvexBody& P, const ConvexBody& Q,
                  const std::vector<ExactSpacePoint>& scalings, std::size_t all_every) {
  std::vector<Scaling> list;
  for (const ExactSpacePoint& scaling : scalings) list.push_back(to_scaling(scaling));
  TimedWalk walk(*P.value, *Q.value, list.at(0));
  {
    const Computing unlocked;
    for (std::size_t k = 1; k < list.size(); ++k) {
      walk.step(list[k], all_every > 0 && k % all_every == 0);
    }
  }
  return walk.fields();
}

}  // namespace

void bind_timed_convex_walk(nb::module_& module) {
  module.def("timed_convex_walk", &timed_walk, "P"_a, "Q"_a, "scalings"_a, "all_every"_a = 0,
             "Walks through the scalings and times each step: the update, the coordinates of all "
             "vertices, the static route traversal; at every so many steps also the surface in "
             "canonical form and the route brute-force. `differences` counts the static states "
             "that are not that after the update.");
}

}  // namespace minkref::python
