// The paper's own update for Python.
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unique_ptr.h>

#include <memory>
#include <tuple>
#include <utility>

#include "bindings/core.hpp"
#include "bindings/core_readings.hpp"
#include "bindings/core_timed_sum.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/paper/plane/paper_update.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

/// A count, and the seconds spent.
using Found = std::pair<std::size_t, double>;

class Update {
 public:
  Update(const Set& P, const Set& Q, const std::string& scale, const std::string& arithmetic,
         const Words& readings, unsigned threads) {
    refuse_large_convolution(P.value, Q.value);
    const Stopwatch watch;
    update_ = PaperUpdate::make(P.value, Q.value, parse_rational(scale), arithmetic,
                                readings_of<Readings>(readings), memory_limit(), threads);
    seconds = watch.seconds();
  }

  Fields move_to(const std::string& scale) {
    const Rational to = parse_rational(scale);
    const Stopwatch watch;
    const PaperUpdate::Step step = update_->move_to(to);
    const double taken = watch.seconds();
    const nb::gil_scoped_acquire held;
    Fields fields;
    fields["insertions"] = step.insertions;
    fields["deletions"] = step.deletions;
    fields["updated"] = step.updated;
    fields["seconds"] = taken;
    return fields;
  }

  Found place_intersections() {
    const Stopwatch watch;
    const std::size_t count = update_->place_intersections();
    return {count, watch.seconds()};
  }

  Found search_intersections(const std::string& scale) const {
    const Rational at = parse_rational(scale);
    const Stopwatch watch;
    const std::size_t count = update_->search_intersections(at);
    return {count, watch.seconds()};
  }

  TimedSum sum() {
    const Stopwatch watch;
    Sum sum = update_->sum();
    return {{std::move(sum.region), true},
            sum.components,
            sum.holes,
            watch.seconds(),
            std::move(sum.statistics),
            {}};
  }

  std::vector<std::tuple<std::string, std::uint32_t, std::uint32_t, bool>> events() const {
    std::vector<std::tuple<std::string, std::uint32_t, std::uint32_t, bool>> rows;
    for (const auto& event : update_->events()) {
      rows.emplace_back(to_string(event.scale), event.a, event.b, event.insertion);
    }
    return rows;
  }

  Fields counts() const {
    const PaperUpdate::Counts counts = update_->counts();
    Fields fields;
    fields["edges"] = counts.edges;
    fields["pairs"] = counts.pairs;
    fields["regions"] = counts.regions;
    fields["undecided"] = counts.undecided;
    return fields;
  }

  double seconds = 0;

 private:
  std::unique_ptr<PaperUpdate> update_;
};

}  // namespace

void bind_paper_update(nb::module_& module) {
  nb::class_<Update>(module, "PaperUpdate",
                     "The paper's program of Section 4: sP + Q followed from one scale to another "
                     "in one arithmetic, each formula as read.")
      .def(nb::init<const Set&, const Set&, const std::string&, const std::string&, const Words&,
                    unsigned>(),
           "P"_a, "Q"_a, "scale"_a = "1", "arithmetic"_a = "rational", "readings"_a = Words{},
           "threads"_a = 1, Released(),
           "Finds the critical regions of all pairs of edges, and the arrangement at the first "
           "scale. `arithmetic`: rational, interval, double, mpfr:BITS. `readings`: as "
           "`paper_readings` lists them; those left out are the printed ones. `threads`: that look "
           "for the regions; the answers do not depend on it. O(N^2) for N edges.")
      .def("move_to", &Update::move_to, "scale"_a, Released(),
           "Steps through the events to this scale: insertions, deletions, intersections updated, "
           "seconds.")
      .def("place_intersections", &Update::place_intersections, Released(),
           "Places all intersections on the list where the walk stands: how many, seconds.")
      .def("search_intersections", &Update::search_intersections, "scale"_a, Released(),
           "Finds the intersections at a scale without the list, from all pairs of edges in the "
           "same arithmetic: how many, those of edges with a common vertex included, and seconds.")
      .def("sum", &Update::sum, Released(),
           "The sum where it stands, as this arithmetic answers, in canonical form.")
      .def("events", &Update::events, Released(),
           "(scale, edge, edge, whether they begin to meet), ascending; the scales of the "
           "arithmetic, exactly.")
      .def("counts", &Update::counts,
           "Edges, pairs looked at, pairs that meet at some scale, pairs left out for NaN.")
      .def_ro("seconds", &Update::seconds, "That finding the regions took.");
  bind_reading_check<Readings>(module, "check_paper_reading");
  module.def(
      "paper_readings", [] { return rows_of(reading_names()); },
      "The choices of a PaperUpdate: name, values (the printed one first), the corrected one, "
      "section of the paper.");
}

}  // namespace minkref::python
