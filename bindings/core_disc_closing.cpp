// Closings and openings by a disc, for Python.
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/core_build.hpp"
#include "bindings/core_features.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/features/region_drawing.hpp"
#include "reference/disc/features/rest_measures.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using PointText = std::pair<std::string, std::string>;
using StepRow = std::tuple<std::string, double, double, double, double, double, double>;
/// The centre, and both feet of its bridge.
using ArcRow = std::tuple<PointText, PointText, PointText>;

/// Discs that just fit outside P reach nothing, so the closed sum gives the closing.
DiscIndex index_to_close(const PolygonSet& set, const Rational& squared, bool inward,
                         unsigned threads) {
  DiscIndex index(diagram_events(set, build_on(threads)));
  if (!inward) index.fill_fits(squared);
  return index;
}

/// A set's closing: P's, or, within a box, the outside's.
class ClosedByDisc {
 public:
  ClosedByDisc(const PolygonSet& P, const Rational& squared, bool inward, unsigned threads)
      : area_(area(P)),
        inward_(inward),
        set_(set_to_close(P, inward)),
        index_(index_to_close(set_, squared, inward, threads)),
        bridges_(index_),
        regions_(feature_regions(index_, squared)),
        outlines_(bridges_, regions_),
        rest_(rest_material(outlines_)),
        closing_(disc_closing(outlines_, rest_)) {
    if (inward) drop_box();
  }

  std::size_t components() const { return inward_ ? closing_.holes : closing_.components; }
  std::size_t holes() const { return inward_ ? closing_.components - 1 : closing_.holes; }
  std::size_t arcs() const {
    std::size_t count = 0;
    for (const ClosingRing& ring : closing_.rings) {
      count += static_cast<std::size_t>(std::count_if(
          ring.pieces.begin(), ring.pieces.end(), [](const auto& piece) { return piece.is_arc; }));
    }
    return count;
  }

  std::pair<double, double> measured_area() const {
    const Interval found = area_with_rest(outlines_, rest_, area_, inward_ ? -1 : 1);
    return {found.lower(), found.upper()};
  }

  std::vector<std::vector<StepRow>> rings() const {
    std::vector<std::vector<StepRow>> rows;
    for (const ClosingRing& ring : closing_.rings) {
      auto& row = rows.emplace_back();
      for (const DrawnStep& step : drawn_closing(outlines_, rest_, ring)) {
        row.emplace_back(step.is_arc ? "arc" : "line", step.x0, step.y0, step.x1, step.y1, step.cx,
                         step.cy);
      }
    }
    return rows;
  }

  std::vector<ArcRow> exact_arcs() const {
    std::vector<ArcRow> rows;
    for (const ClosingRing& ring : closing_.rings) {
      for (const ClosingPiece& piece : ring.pieces) {
        if (!piece.is_arc) continue;
        const CornerBridge& corner = outlines_.corners()[rest_.arcs[piece.number].corner];
        rows.emplace_back(text_of(*corner.corner), text_of(corner.chord.from),
                          text_of(corner.chord.to));
      }
    }
    return rows;
  }

  double seconds = 0;

 private:
  /// Drops the ring of the box, which no disc reaches.
  void drop_box() {
    const Ring& outer = set_.polygons.front().outer;
    const Rational& least = outer.front().x;  // canonical rings start at the least vertex
    std::erase_if(closing_.rings, [&](const ClosingRing& ring) {
      if (!ring.pieces.empty()) return false;
      const auto vertices = walk_vertices(index_, ring.walk);
      return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t vertex) {
        return index_.diagram().vertex(vertex).x == least;
      });
    });
  }
  PointText text_of(const RootPoint& point) const {
    const RootPoint at = placed(outlines_, point);
    return {expression(at.x), expression(at.y)};
  }

  Rational area_;
  bool inward_;
  PolygonSet set_;
  DiscIndex index_;
  Bridges bridges_;
  FeatureRegions regions_;
  RegionOutlines outlines_;
  RestMaterial rest_;
  DiscClosing closing_;
};

ClosedByDisc* closed_by_disc(const Set& P, const std::string& squared, bool inward,
                             unsigned threads) {
  const Stopwatch watch;
  auto* found = new ClosedByDisc(P.value, parse_rational(squared), inward, threads);
  found->seconds = watch.seconds();
  return found;
}

}  // namespace

void bind_disc_closing(nb::module_& module) {
  nb::class_<ClosedByDisc>(module, "ClosedByDisc", "A closing or an opening by a disc.")
      .def_prop_ro("components", &ClosedByDisc::components, "Of the interior.")
      .def_prop_ro("holes", &ClosedByDisc::holes, "Bounded components of the complement.")
      .def_prop_ro("arcs", &ClosedByDisc::arcs, Released(), "Of the boundary.")
      .def_prop_ro("seconds", [](const ClosedByDisc& found) { return found.seconds; })
      .def("area", &ClosedByDisc::measured_area, Released(), "Between two doubles.")
      .def("rings", &ClosedByDisc::rings, Released(),
           "Rings of (kind, x and y of the start, of the end, of an arc's centre), nearest "
           "doubles. Arcs run counter-clockwise. A closing lies on the right, an opening on the "
           "left.")
      .def("exact_arcs", &ClosedByDisc::exact_arcs, Released(),
           "The arcs of all rings in order, as expressions: the centre, and the two points of the "
           "circle that bound the arc or the longer one of which it is a part.");
  module.def(
      "closed_by_disc", closed_by_disc, "P"_a, "squared_radius"_a, "inward"_a, "threads"_a = 1,
      Released(),
      "The closing of P by a disc; `inward`: the opening. P has an area, and is valid. Discs "
      "that just fit belong to an opening, and reach nothing of a closing. Raises BadInput, "
      "LimitExceeded.");
}

}  // namespace minkref::python
