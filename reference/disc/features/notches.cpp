#include "reference/disc/features/notches.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {

const Surd& BarLengths::radius(std::uint32_t number) {
  const auto found = radii_.find(number);
  if (found != radii_.end()) return found->second;
  if (number == 0) return radii_.emplace(0, Surd(0)).first->second;
  const DiagramEvents& diagram = index_.diagram();
  const DiagramEvent& event = diagram.events[index_.event_at(number - 1)];
  const Surd squared =
      equidistant_places<Surd>(diagram.curves, event.of)[event.branch].squared_radius;
  return radii_.emplace(number, sqrt(squared)).first->second;
}

int BarLengths::sign_of_sum(std::initializer_list<std::uint32_t> added,
                            std::initializer_list<std::uint32_t> subtracted, const Rational& rest) {
  const DiagramEvents& diagram = index_.diagram();
  const auto near = [&](std::uint32_t number) {
    if (number == 0) return Interval(0);
    return sqrt(diagram.events[index_.event_at(number - 1)].squared_radius);
  };
  Interval rounded(rest);
  for (const std::uint32_t number : added) rounded += near(number);
  for (const std::uint32_t number : subtracted) rounded -= near(number);
  if (const auto certain = certified_sign(rounded)) return *certain;
  Surd exact(rest);
  for (const std::uint32_t number : added) exact += radius(number);
  for (const std::uint32_t number : subtracted) exact -= radius(number);
  return sign(exact);
}

int BarLengths::compare(std::uint32_t a, std::uint32_t b) {
  const FeatureBar &x = codes_.bars[a], &y = codes_.bars[b];
  if (is_infinite(x) || is_infinite(y)) return (is_infinite(x) ? 1 : 0) - (is_infinite(y) ? 1 : 0);
  const auto by_number = [](std::uint32_t p, std::uint32_t q) {
    return p < q ? -1 : p > q ? 1 : 0;
  };
  if (x.birth == y.birth) return by_number(x.death, y.death);
  if (x.death == y.death) return by_number(y.birth, x.birth);
  return sign_of_sum({x.death, y.birth}, {x.birth, y.death}, 0);
}

bool BarLengths::is_longer(std::uint32_t bar, const Rational& length, const Rational& from,
                           const std::optional<Rational>& to) {
  const FeatureBar& own = codes_.bars[bar];
  if (!to) return is_infinite(own) || sign_of_sum({own.death}, {own.birth}, -length) > 0;
  if (*to - from <= length) return false;
  return own.death > index_.radii() || sign_of_sum({own.death}, {}, -(from + length)) > 0;
}

namespace {

struct FoundNotch {
  Notch notch;
  LeafDepth depth;
};

/// Between doubles, in P's coordinates.
Enclosure depth_in_doubles(const DiscIndex& index, const LeafDepth& depth) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (depth.is_infinite()) return {infinity, infinity};
  const Rational inverse = 1 / (index.diagram().factor * index.diagram().factor);
  return enclose(root_of(RootNumber(inverse) * depth.exact()));
}

}  // namespace

std::vector<Notch> notches(const Bridges& bridges, const MergeTree& tree, const Barcode& codes,
                           const NotchWindow& window) {
  const DiscIndex& index = bridges.index();
  const Rational half = index.diagram().factor / 2, from = window.alpha * half,
                 length = window.persistence * half;
  std::optional<Rational> to;
  if (window.alpha_to) to = *window.alpha_to * half;
  BarLengths lengths(index, codes);
  const bool is_limit = window.alpha == 0;
  const Rational squared = window.alpha * window.alpha / 4;
  const auto live =
      features_at(index, tree, codes, is_limit ? DiscIndex::Place{0, false} : index.place(squared));
  const BridgeRadius radius =
      is_limit ? BridgeRadius{DiagramGraph::none, 0, {}, 0} : bridges.of_square(squared);
  std::vector<FoundNotch> found;
  for (const LiveFeature& feature : live) {
    look_for_interrupt();
    if (!lengths.is_longer(feature.bar, length, from, to)) continue;
    std::optional<PocketMinimum> least;
    if (is_limit) {
      if (tree.is_reflex(feature.node)) least = PocketMinimum{feature.node, LeafDepth(), false};
    } else {
      least = pocket_minimum(bridges, tree, feature, radius);
    }
    if (!least) continue;
    const Enclosure depth = depth_in_doubles(index, least->depth);
    found.push_back(
        {{least->leaf, feature.node, feature.bar, depth, least->is_tie}, std::move(least->depth)});
  }
  std::sort(found.begin(), found.end(), [&](const FoundNotch& a, const FoundNotch& b) {
    if (&a == &b) return false;
    const int by_bar = lengths.compare(a.notch.bar, b.notch.bar);
    if (by_bar != 0) return by_bar > 0;
    const int by_depth = compare(a.depth, b.depth);
    return by_depth != 0 ? by_depth > 0 : a.notch.leaf < b.notch.leaf;
  });
  std::vector<Notch> rows;
  for (const FoundNotch& each : found) rows.push_back(each.notch);
  return rows;
}

}  // namespace minkref::inline disc
