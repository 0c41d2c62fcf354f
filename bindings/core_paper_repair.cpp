// The paper's own repair of a convex sum for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_convex.hpp"
#include "bindings/core_readings.hpp"
#include "bindings/core_space.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/paper/space/paper_repair.hpp"
#include "reference/space/convex/static_convex_sum.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using PairRow = std::pair<std::uint32_t, std::uint32_t>;
using StepRow = std::tuple<std::uint32_t, std::uint32_t, std::string>;
using ChainRow = std::vector<PairRow>;

class Repair {
 public:
  Repair(const ConvexBody& P, const ConvexBody& Q, const ExactSpacePoint& scaling,
         const std::string& arithmetic, const Words& readings)
      : P_(P.value),
        Q_(Q.value),
        repair_(PaperRepair::make(*P_, *Q_, to_scaling(scaling), arithmetic,
                                  readings_of<RepairReadings>(readings))) {}

  Fields update(const ExactSpacePoint& scaling) {
    const Scaling to = to_scaling(scaling);
    RepairReport report;
    double seconds = 0;
    {
      const Computing computing;
      const Stopwatch watch;
      report = repair_->update(to);
      seconds = watch.seconds();
    }
    nb::list errors, chains;
    std::uint64_t of_P = 0, steps = 0, without_end = 0, stuck = 0;
    for (const FacetError& error : report.errors) {
      of_P += error.of_P;
      steps += error.steps.size();
      without_end += !error.end;
      std::vector<StepRow> way;
      for (const auto& [vertex, witness, degree] : error.steps) {
        way.emplace_back(vertex, witness, to_string(degree));
      }
      nb::dict fields;
      fields["kind"] = error.of_P ? "fv" : "vf";
      fields["facet"] = error.facet;
      fields["vertex"] = error.vertex;
      fields["steps"] = way;
      fields["end"] = error.end;
      errors.append(fields);
    }
    for (const ChainRepair& chain : report.chains) {
      stuck += chain.stuck;
      nb::dict fields;
      fields["edge"] = ends(*P_, P_->half_edge(chain.edge));
      fields["before"] = ends_of(chain.before);
      fields["after"] = ends_of(chain.after);
      fields["stuck"] = chain.stuck;
      chains.append(fields);
    }
    Fields fields;
    fields["fv_errors"] = of_P;
    fields["vf_errors"] = report.errors.size() - of_P;
    fields["ee_errors"] = report.ee_errors;
    fields["descent_steps"] = steps;
    fields["chains_walked"] = report.chains_walked;
    fields["without_end"] = without_end;
    fields["chains_stuck"] = stuck;
    fields["errors"] = errors;
    fields["chains"] = chains;
    fields["seconds"] = seconds;
    return fields;
  }

  std::vector<std::pair<std::string, ChainRow>> facets() const {
    static constexpr const char* names[] = {"fv", "vf", "ee"};
    std::vector<std::pair<std::string, ChainRow>> rows;
    for (const ClaimedFacet& facet : claimed_facets(*P_, *Q_, repair_->compatibility())) {
      ChainRow ring;
      for (const auto& [p, q] : facet.ring) ring.emplace_back(p, q);
      rows.emplace_back(names[static_cast<std::size_t>(facet.kind)], std::move(ring));
    }
    return rows;
  }

  std::vector<ExactSpacePoint> coordinates(const std::vector<PairRow>& pairs) const {
    std::vector<SumVertices::Pair> asked;
    for (const auto& [p, q] : pairs) {
      if (p >= P_->vertices() || q >= Q_->vertices()) throw nb::index_error("no such vertex");
      asked.push_back({p, q});
    }
    std::vector<ExactSpacePoint> rows;
    for (const SpacePoint& point : repair_->coordinates(asked)) rows.push_back(to_strings(point));
    return rows;
  }

  bool has_exact_pairs() const {
    Contacts contacts(*P_, *Q_);
    contacts.rescale(repair_->scaling());
    return by_traversal(contacts) == repair_->compatibility();
  }

 private:
  static PairRow ends(const ConvexPolyhedron& body, std::uint32_t half_edge) {
    return {body.origin(half_edge), body.target(half_edge)};
  }
  ChainRow ends_of(const std::vector<std::uint32_t>& half_edges) const {
    ChainRow rows;
    for (const std::uint32_t h : half_edges) rows.push_back(ends(*Q_, h));
    return rows;
  }

  Body P_, Q_;
  std::unique_ptr<PaperRepair> repair_;
};

}  // namespace

void bind_paper_repair(nb::module_& module) {
  nb::class_<Repair>(module, "PaperRepair",
                     "The paper's repair of S P + Q (Section 6) from scaling to scaling in one "
                     "arithmetic, each sentence as read.")
      .def(nb::init<const ConvexBody&, const ConvexBody&, const ExactSpacePoint&,
                    const std::string&, const Words&>(),
           "P"_a, "Q"_a, "scaling"_a, "arithmetic"_a = "rational", "readings"_a = Words{},
           Released(),
           "The pairs at the first scaling are the exact ones. `arithmetic`: rational, interval, "
           "double, mpfr:BITS. `readings`: as `repair_readings` lists them; those left out are the "
           "printed ones.")
      .def("update", &Repair::update, "scaling"_a,
           "Looks for errors and repairs them. `errors`: of facets, with the steps (vertex, other "
           "end of the witness, squared degree) and the end of each descent, None for one without "
           "end; `chains`: edges of P with their compatible edges of Q, by vertices; counts; "
           "seconds.")
      .def("facets", &Repair::facets, Released(),
           "The facets claimed: fv, vf or ee, and the ring, pairs of a vertex of P and one of Q.")
      .def("coordinates", &Repair::coordinates, "pairs"_a, Released(),
           "Of sums of two vertices, as the arithmetic has them.")
      .def("has_exact_pairs", &Repair::has_exact_pairs, Released(),
           "Whether all compatible pairs are those that the exact static route finds.");
  bind_reading_check<RepairReadings>(module, "check_repair_reading");
  module.def(
      "repair_readings", [] { return rows_of(repair_reading_names()); },
      "The choices of a PaperRepair: name, values (the printed one first), the corrected one, "
      "section of the paper.");
}

}  // namespace minkref::python
