// Places that a disc just fits into, numbered below its radius.
#include <stdexcept>

#include "reference/disc/index/disc_index.hpp"
#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

/// The edge in front of a flat half; the half's feature may be another edge on the same line.
std::uint32_t middle_side(const DiagramEvents& diagram, const BoundaryWalk& walk,
                          const DiagramHalf& half) {
  for (std::uint32_t side = half.from_side;; side = side + 1 == walk.last ? walk.first : side + 1) {
    if (!diagram.walks.sides[side].is_arc) return side;
    if (side == half.to_side) break;
  }
  throw std::logic_error("a flat ridge lies in front of no edge");
}

}  // namespace

bool DiscIndex::fill_fits(const Rational& squared_radius) {
  const FloatEnvironment standard;
  const Place at = place(squared_radius);
  if (!at.at_event) return false;
  const std::uint32_t number = at.gap;
  std::vector<char> leads_on(graph_.events, 0), is_to_cut(graph_.halves.size(), 0);
  for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
    if (low_[k] != number || high_[k] == number) continue;
    leads_on[is_rising_[k] != 0 ? graph_.halves[k].from : graph_.halves[k].to] = 1;
  }
  const auto is_level = [&](std::uint32_t k) { return low_[k] == number && high_[k] == number; };
  const auto& features = diagram_.curves.features;
  const auto is_between_edges = [&](const DiagramHalf& half) {
    return features[half.feature].edge != OffsetPatch::none &&
           features[graph_.halves[half.twin].feature].edge != OffsetPatch::none;
  };
  // Where rings touch, nodes at one place may be joined by a half without length.
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
      look_for_interrupt();
      const DiagramHalf& half = graph_.halves[k];
      if (!is_level(k) || is_between_edges(half) || leads_on[half.from] == 0) continue;
      is_new |= leads_on[half.to] == 0;
      leads_on[half.to] = 1;
    }
  }
  bool is_found = false;
  for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
    const DiagramHalf& half = graph_.halves[k];
    if (!is_level(k) || !is_between_edges(half)) continue;
    is_found = true;
    is_to_cut[k] = leads_on[half.from] & leads_on[half.to];
  }
  for (std::uint32_t node = 0; node < graph_.events; ++node) {
    if (numbers_[node] != number || leads_on[node] != 0) continue;
    is_found = true;
    --numbers_[node];
  }
  if (!is_found) return false;
  cut_flats(is_to_cut);
  order_ends();
  ways_.clear();
  count_sides();
  spans_.clear();
  part_gaps();
  return true;
}

/// Puts a node of the number 0 into each half to cut, and into its twin.
void DiscIndex::cut_flats(const std::vector<char>& is_to_cut) {
  const std::vector<DiagramHalf> halves = std::move(graph_.halves);
  const std::vector<CornerMotion> motions = std::move(motions_);
  auto nodes = static_cast<std::uint32_t>(graph_.events + graph_.gaps + graph_.reflex_vertices);
  std::vector<std::uint32_t> first_of, middle_of(halves.size(), 0);
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < halves.size(); ++k) {
    first_of.push_back(count);
    count += is_to_cut[k] != 0 ? 2 : 1;
    if (is_to_cut[k] == 0) continue;
    middle_of[k] = halves[k].twin < k ? middle_of[halves[k].twin] : nodes++;
  }
  graph_.halves.clear();
  motions_.clear();
  const auto add = [&](const DiagramHalf& half, std::uint32_t old) {
    graph_.halves.push_back(half);
    motions_.push_back(motions[old]);
  };
  for (std::size_t number = 0; number < graph_.walks.size(); ++number) {
    DiagramGraph::Walk& walk = graph_.walks[number];
    const DiagramGraph::Walk old = walk;
    walk.first = static_cast<std::uint32_t>(graph_.halves.size());
    for (std::uint32_t k = old.first; k < old.last; ++k) {
      DiagramHalf half = halves[k], rest = half;
      const std::uint32_t twin = first_of[half.twin];
      half.twin = twin + (is_to_cut[k] != 0 ? 1 : 0);
      if (is_to_cut[k] == 0) {
        add(half, k);
        continue;
      }
      half.to = rest.from = middle_of[k];
      half.to_side = rest.from_side = middle_side(diagram_, diagram_.walks.walks[number], half);
      rest.twin = twin;
      add(half, k);
      add(rest, k);
    }
    walk.last = static_cast<std::uint32_t>(graph_.halves.size());
  }
  for (DiagramGraph::Leftmost& leftmost : graph_.leftmost) {
    if (leftmost.half != DiagramGraph::none) leftmost.half = first_of[leftmost.half];
  }
  graph_.reflex_vertices = nodes - graph_.events - graph_.gaps;
}

}  // namespace minkref::inline disc
