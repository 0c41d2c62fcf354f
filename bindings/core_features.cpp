// Features of a growing disc for Python.
#include "bindings/core_features.hpp"

#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bindings/core.hpp"
#include "bindings/diagram_row.hpp"
#include "bindings/stopwatch.hpp"
#include "bindings/vector_caster.hpp"
#include "reference/disc/features/merge_text.hpp"
#include "reference/disc/features/near_bridges.hpp"
#include "reference/disc/features/notches.hpp"
#include "reference/disc/features/tracks.hpp"
#include "reference/number/radicals/polynomial.hpp"
#include "reference/number/radicals/root_text.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace minkref::python {
namespace {

using Bounds = std::pair<double, double>;
using Numbers = std::vector<std::uint32_t>;

/// A diameter's half, squared.
Rational squared_radius(const std::string& alpha) {
  const Rational value = parse_rational(alpha);
  if (value <= 0) throw BadInput("bad-alpha", "alpha is " + alpha, "give a number above 0");
  return value * value / 4;
}

std::optional<std::uint32_t> known(std::uint32_t number) {
  if (number == MergeTree::none) return std::nullopt;
  return number;
}

Point as_given(const DiagramEvents& diagram, const Point& in_frame) {
  return {in_frame.x / diagram.factor + diagram.origin.x,
          in_frame.y / diagram.factor + diagram.origin.y};
}

/// The vertex, and the primitive direction of the edge that leaves it with the wedge on its right.
using EndRow = std::array<std::string, 4>;
/// Kind, number of the radius, parent, children, places (numbers of events), the end of a reflex
/// leaf, tie.
using NodeRow = std::tuple<std::string, std::uint32_t, std::optional<std::uint32_t>, Numbers,
                           std::vector<Numbers>, std::optional<EndRow>, bool>;

std::vector<NodeRow> node_rows(const BoundFeatures& self) {
  std::vector<NodeRow> rows;
  for (std::uint32_t k = 0; k < self.tree.nodes.size(); ++k) {
    const MergeNode& node = self.tree.nodes[k];
    std::optional<EndRow> end;
    std::vector<Numbers> places = node.places;
    if (self.tree.is_reflex(k)) {
      const ReflexEnd& own = self.tree.ends[k];
      const Point at = as_given(self.index.diagram(), own.vertex);
      end =
          EndRow{to_string(at.x), to_string(at.y), to_string(own.along.x), to_string(own.along.y)};
    }
    if (self.tree.is_reflex(k) || node.kind == MergeNode::Kind::outside) places.clear();
    rows.emplace_back(name(node.kind), node.radius, known(node.parent), node.children, places, end,
                      self.codes.is_tie[k] != 0);
  }
  return rows;
}

/// Number, square (if rational), polynomial of the square, bounds.
using RadiusRow =
    std::tuple<std::uint32_t, std::optional<std::string>, std::vector<std::string>, Bounds>;

/// The radii of the tree's nodes, between 0 and infinity.
std::vector<RadiusRow> radius_rows(const BoundFeatures& self) {
  std::set<std::uint32_t> numbers;
  for (const MergeNode& node : self.tree.nodes) numbers.insert(node.radius);
  std::vector<RadiusRow> rows;
  for (const std::uint32_t number : numbers) {
    if (number == 0 || number > self.index.radii()) continue;
    look_for_interrupt();
    const SquareRow square = square_row(self.squared(number));
    rows.emplace_back(number, square.rational, square.polynomial, square.radius);
  }
  return rows;
}

/// Leaf, birth, death (None: infinity), node at which it ends, essential, tie. Radii by number.
using BarRow = std::tuple<std::uint32_t, std::uint32_t, std::optional<std::uint32_t>, std::uint32_t,
                          bool, bool>;

std::vector<BarRow> bar_rows(const BoundFeatures& self) {
  std::vector<BarRow> rows;
  for (const FeatureBar& bar : self.codes.bars) {
    std::optional<std::uint32_t> death = bar.death;
    if (bar.death > self.index.radii()) death.reset();
    rows.emplace_back(bar.leaf, bar.birth, death, bar.end, bar.is_essential, bar.is_tie);
  }
  return rows;
}

/// Number of the radius from which a part goes on, and its features on the left and right there.
using StretchRow = std::tuple<std::uint32_t, FeatureName, FeatureName>;
/// Both ends, numbers of their radii (None: infinity), and the stretches from the first end on.
using TrackRow = std::tuple<PartEnd, PartEnd, std::uint32_t, std::optional<std::uint32_t>,
                            std::vector<StretchRow>>;

std::vector<TrackRow> track_rows(const BoundFeatures& self, std::size_t first, std::size_t count) {
  const DiscIndex& index = self.index;
  const DiagramEvents& diagram = index.diagram();
  const DiagramGraph& graph = index.graph();
  const auto& sides = diagram.walks.sides;
  std::vector<TrackRow> rows;
  for (std::size_t k = first; k < self.tracks.size() && k - first < count; ++k) {
    look_for_interrupt();
    const Numbers& halves = self.tracks[k].halves;
    const DiagramHalf &low = graph.halves[halves.front()], &high = graph.halves[halves.back()];
    std::vector<StretchRow> stretches;
    for (const std::uint32_t number : halves) {
      const DiagramHalf& half = graph.halves[number];
      stretches.emplace_back(
          index.low(number), side_name(diagram, half.from, half.from_side, Past::goes_on),
          side_name(diagram, half.from, graph.halves[half.twin].to_side, Past::ends));
    }
    std::optional<std::uint32_t> death = index.high(halves.back());
    if (*death > index.radii()) death.reset();
    rows.emplace_back(part_end(diagram, graph, low.from, sides[low.from_side].from),
                      part_end(diagram, graph, high.to, sides[high.to_side].to),
                      index.low(halves.front()), death, std::move(stretches));
  }
  return rows;
}

/// The exact point, and the nearest doubles.
using PlaceOfRoots = std::tuple<std::string, std::string, double, double>;

/// Both feet with their features, the left one first, the place as far from both.
using BridgeRow = std::tuple<PlaceOfRoots, FeatureName, PlaceOfRoots, FeatureName, PlaceOfRoots>;
/// The leaf, its squared depth (exact; None: infinite), bounds of the depth, tie.
using PocketRow = std::tuple<std::uint32_t, std::optional<std::string>, Bounds, bool>;
/// Tree node, bar, reflex leaves, deepest leaf, bridges.
using FeatureRow = std::tuple<std::uint32_t, std::uint32_t, Numbers, std::optional<PocketRow>,
                              std::vector<BridgeRow>>;

class LevelRows {
 public:
  LevelRows(const BoundFeatures& self, const Rational& squared)
      : self_(self),
        diagram_(self.index.diagram()),
        radius_(self.bridges.of_square(squared)),
        live_(features_at(self.index, self.tree, self.codes, self.index.place(squared))) {}

  std::vector<FeatureRow> rows() const {
    std::vector<FeatureRow> all;
    for (const LiveFeature& feature : live_) {
      std::vector<BridgeRow> bridges;
      for (const std::uint32_t half : feature.bridges) bridges.push_back(bridge(half));
      std::sort(bridges.begin(), bridges.end());
      all.emplace_back(feature.node, feature.bar, feature.leaves, pocket(feature),
                       std::move(bridges));
    }
    return all;
  }

 private:
  RootPoint as_given(const RootPoint& at) const {
    return RootNumber(Rational(1 / diagram_.factor)) * at + numbers<RootNumber>(diagram_.origin);
  }
  PlaceOfRoots place(const RootPoint& in_frame) const {
    const RootPoint at = as_given(in_frame);
    return {expression(at.x), expression(at.y), nearest_double(at.x), nearest_double(at.y)};
  }

  /// A half's own feature, named at the foot.
  FeatureName foot_name(const DiagramHalf& half, const RootPoint& foot) const {
    const OffsetCurves& curves = diagram_.curves;
    if (curves.features[half.feature].edge == OffsetPatch::none) {
      return vertex_name(diagram_, half.feature);
    }
    const auto& sides = diagram_.walks.sides;
    const BoundaryWalk& walk =
        *std::find_if(diagram_.walks.walks.begin(), diagram_.walks.walks.end(),
                      [&](const BoundaryWalk& each) { return half.from_side < each.last; });
    std::uint32_t side = half.from_side;
    while (side != half.to_side && is_beyond(sides[side], foot)) {
      side = side + 1 == walk.last ? walk.first : side + 1;
    }
    return edge_row(edge_name(diagram_, sides[side].edge, foot));
  }
  bool is_beyond(const BoundarySide& side, const RootPoint& foot) const {
    const OffsetCurves& curves = diagram_.curves;
    const auto to = numbers<RootNumber>(curves.features[side.to].centre);
    return sign(dot(numbers<RootNumber>(curves.edges[side.edge].along), foot - to)) > 0;
  }

  BridgeRow bridge(std::uint32_t number) const {
    look_for_interrupt();
    const DiagramHalf& half = self_.index.graph().halves[number];
    const DiagramHalf& twin = self_.index.graph().halves[half.twin];
    const auto [from, to] = self_.bridges.chord<RootNumber>(number, radius_);
    return {place(from), foot_name(half, from), place(to), foot_name(twin, to),
            place(self_.bridges.place<RootNumber>(number, radius_))};
  }

  std::optional<PocketRow> pocket(const LiveFeature& feature) const {
    const auto found = pocket_minimum(self_.bridges, self_.tree, feature, radius_);
    if (!found) return std::nullopt;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (found->depth.is_infinite()) {
      return PocketRow{found->leaf, std::nullopt, {infinity, infinity}, found->is_tie};
    }
    const Rational inverse = 1 / (diagram_.factor * diagram_.factor);
    const RootNumber squared = RootNumber(inverse) * found->depth.exact();
    const Enclosure depth = enclose(root_of(squared));
    return PocketRow{found->leaf, expression(squared), {depth.lower, depth.upper}, found->is_tie};
  }

  const BoundFeatures& self_;
  const DiagramEvents& diagram_;
  BridgeRadius radius_;
  std::vector<LiveFeature> live_;
};

/// The vertex, the bar, bounds of the depth, tie.
using NotchRow = std::tuple<std::string, std::string, std::uint32_t, Bounds, bool>;

std::vector<NotchRow> notch_rows(const BoundFeatures& self, const std::string& alpha,
                                 const std::string& persistence,
                                 const std::optional<std::string>& alpha_to) {
  if (persistence == "inf") return {};
  NotchWindow window{parse_rational(alpha), parse_rational(persistence), std::nullopt};
  if (alpha_to) window.alpha_to = parse_rational(*alpha_to);
  if (window.alpha < 0) throw BadInput("bad-alpha", "alpha is " + alpha, "give 0 or more");
  if (window.persistence < 0) {
    throw BadInput("bad-persistence", "the persistence is " + persistence, "give 0 or more");
  }
  if (window.alpha_to && *window.alpha_to < window.alpha) {
    throw BadInput("empty-range", "alpha goes from " + alpha + " to " + *alpha_to,
                   "give the smaller one first");
  }
  std::vector<NotchRow> rows;
  for (const Notch& notch : notches(self.bridges, self.tree, self.codes, window)) {
    const Point at = as_given(self.index.diagram(), self.tree.ends[notch.leaf].vertex);
    rows.emplace_back(to_string(at.x), to_string(at.y), notch.bar,
                      Bounds{notch.depth.lower, notch.depth.upper}, notch.is_tie);
  }
  return rows;
}

/// Rows of seven doubles, and rows of the feature's node and its bar.
nb::object near_arrays(const BoundFeatures& self, double alpha) {
  if (!(alpha > 0) || !std::isfinite(alpha)) {
    throw BadInput("bad-alpha", "alpha is " + std::to_string(alpha), "give a number above 0");
  }
  static_assert(sizeof(NearBridge) == 8 * sizeof(double));
  auto* all = new std::vector<NearBridge>;
  const nb::capsule owner(
      all, [](void* p) noexcept { delete static_cast<std::vector<NearBridge>*>(p); });
  {
    const Computing computing;
    self.near.at(alpha / 2, *all);
  }
  const double* places = all->empty() ? nullptr : &all->front().from_x;
  const std::uint32_t* owners = all->empty() ? nullptr : &all->front().feature;
  using Places = nb::ndarray<nb::numpy, const double>;
  using Owners = nb::ndarray<nb::numpy, const std::uint32_t>;
  return nb::make_tuple(Places(places, {all->size(), 7}, owner, {8, 1}),
                        Owners(owners, {all->size(), 2}, owner, {16, 1}));
}

void bind_tree(nb::class_<BoundFeatures>& bound) {
  bound.def_ro("seconds", &BoundFeatures::seconds, "Of the build.")
      .def_prop_ro("exact_signs",
                   [](const BoundFeatures& self) { return self.index.diagram().exact_signs; })
      .def_prop_ro("radii", [](const BoundFeatures& self) { return self.index.radii(); })
      .def("nodes", &node_rows, Released(),
           "(kind, number of the radius, parent or None, children, places as lists of events, (x, "
           "y, dx, dy) of a reflex end, tie): the merge tree, children before parents. 0 is the "
           "radius of reflex ends; the number after that of all radii is infinity.")
      .def(
          "radius",
          [](const BoundFeatures& self, std::uint32_t number) -> Bounds {
            if (number == 0) return {0, 0};
            return square_row(self.squared(number)).radius;
          },
          "number"_a, Released(), "Bounds of a radius of events, from number 1 on.")
      .def("radius_rows", &radius_rows, Released(),
           "(number, squared radius or None, polynomial, bounds of the radius) of the tree's "
           "nodes, between 0 and infinity.")
      .def(
          "event",
          [](const BoundFeatures& self, std::uint32_t event) {
            return diagram_row(self.index.diagram(), self.index.diagram().events.at(event));
          },
          "event"_a, Released(), "As DiagramEvents.rows has it.")
      .def_prop_ro(
          "feature_of", [](const BoundFeatures& self) { return self.tree.feature_of; }, Released(),
          "By node of the diagram, as DiscIndex.drawing numbers them: the tree node just above the "
          "node's radius.")
      .def("bars", &bar_rows, Released(),
           "(leaf, birth, death or None, node at which it ends, essential, tie), in the order of "
           "the leaves; radii by number.")
      .def_prop_ro("track_count", [](const BoundFeatures& self) { return self.tracks.size(); })
      .def("tracks", &track_rows, "first"_a, "count"_a, Released(),
           "(end, end, number of the radius, that of the other end or None, [(number, feature, "
           "feature)]): lives of bridges. Ends as DiscIndex.graph has them.")
      .def(
          "canonical_json",
          [](const BoundFeatures& self) { return canonical_json(self.index, self.tree); },
          Released(), "The merge tree's canonical form.");
}

}  // namespace

void bind_features(nb::module_& module) {
  nb::class_<BoundFeatures> bound(module, "Features", "Features of a set under a growing disc.");
  bind_tree(bound);
  bind_feature_regions(module, bound);
  bind_disc_closing(module);
  bound
      .def(
          "at",
          [](const BoundFeatures& self, const std::string& alpha) {
            return LevelRows(self, squared_radius(alpha)).rows();
          },
          "alpha"_a, Released(),
          "(tree node, bar, reflex leaves, (leaf, squared depth or None, bounds of the depth, tie) "
          "of the deepest or None, bridges) of each feature at a diameter. A bridge: (foot, "
          "feature, foot, feature, centre of the disc), each point (x, y, nearest doubles).")
      .def("near", &near_arrays, "alpha"_a,
           nb::sig("def near(self, alpha: float) -> tuple[typing.Any, typing.Any]"),
           "All bridges at a diameter in doubles: rows of both ends, the disc's centre and a bound "
           "of the error of each coordinate; and rows of the feature's tree node and its bar. At "
           "an event's own diameter those just below.")
      .def("notches", &notch_rows, "alpha"_a, "persistence"_a, "alpha_to"_a = nb::none(),
           Released(),
           "(x, y, bar, bounds of the depth, tie): the deepest reflex vertex of each feature whose "
           "bar is longer, in the order of cuts.");
  module.def(
      "features",
      [](const Set& P, unsigned threads,
         const std::optional<std::vector<PlaceRow>>& places) -> BoundFeatures* {
        const Stopwatch watch;
        auto found = std::make_unique<BoundFeatures>(diagram_of(P.value, threads, places));
        found->seconds = watch.seconds();
        return found.release();
      },
      "P"_a, "threads"_a = 1, "places"_a = nb::none(), Released(),
      "The merge tree, barcode and bridges of a set under a growing disc. `places`: as for "
      "disc_index. Raises BadInput, LimitExceeded.");
}

}  // namespace minkref::python
