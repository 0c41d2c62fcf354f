#include "reference/disc/features/boundary_parts.hpp"

#include "reference/error.hpp"

namespace minkref::inline disc {
namespace {

class PartFinder {
 public:
  PartFinder(const DiscIndex& index, std::uint32_t level)
      : index_(index), graph_(index.graph()), level_(level) {
    starts_.assign(graph_.halves.size(), DiagramGraph::none);
  }

  BoundaryParts find() {
    for (std::uint32_t walk = 0; walk < graph_.walks.size(); ++walk) add_walk(walk);
    found_.hidden_rings = rings(found_.hidden);
    found_.visible_rings = rings(found_.visible);
    for (std::uint32_t walk = 0; walk < graph_.walks.size(); ++walk) {
      if (is_cut_[walk] != 0) continue;
      const DiagramGraph::Walk& own = graph_.walks[walk];
      const bool is_hidden = own.first != own.last && index_.low(own.first) <= level_;
      (is_hidden ? found_.hidden_rings : found_.visible_rings).push_back({{}, walk});
    }
    return std::move(found_);
  }

 private:
  void add_walk(std::uint32_t number) {
    const DiagramGraph::Walk& walk = graph_.walks[number];
    std::vector<std::uint32_t> corners;
    for (std::uint32_t k = walk.first; k < walk.last; ++k) {
      if (index_.low(k) <= level_ && level_ < index_.high(k)) corners.push_back(k);
    }
    is_cut_.push_back(corners.empty() ? 0 : 1);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % corners.size()];
      auto& parts = index_.rises(from) ? found_.visible : found_.hidden;
      starts_[from] = static_cast<std::uint32_t>(parts.size());
      parts.push_back({number, from, to, between(number, from, to)});
    }
  }

  /// The vertices passed between two halves' feet.
  std::vector<std::uint32_t> between(std::uint32_t number, std::uint32_t from,
                                     std::uint32_t to) const {
    const DiagramGraph::Walk& walk = graph_.walks[number];
    const BoundaryWalk& own = index_.diagram().walks.walks[number];
    std::vector<std::uint32_t> found;
    std::uint32_t side = graph_.halves[from].to_side;
    const auto go_to = [&](std::uint32_t end) {
      for (; side != end; side = side + 1 == own.last ? own.first : side + 1) {
        const BoundarySide& passed = index_.diagram().walks.sides[side];
        if (!passed.is_arc) found.push_back(passed.to);
      }
    };
    for (std::uint32_t k = from; k != to;) {
      k = k + 1 == walk.last ? walk.first : k + 1;
      go_to(graph_.halves[k].from_side);
      if (k != to) go_to(graph_.halves[k].to_side);
    }
    return found;
  }

  std::vector<PartRing> rings(const std::vector<BoundaryPart>& parts) const {
    std::vector<PartRing> found;
    std::vector<char> is_done(parts.size(), 0);
    for (std::uint32_t start = 0; start < parts.size(); ++start) {
      if (is_done[start] != 0) continue;
      PartRing ring{{}, parts[start].walk};
      for (std::uint32_t k = start; is_done[k] == 0;) {
        is_done[k] = 1;
        ring.parts.push_back(k);
        k = starts_[graph_.halves[parts[k].to].twin];
      }
      found.push_back(std::move(ring));
    }
    return found;
  }

  const DiscIndex& index_;
  const DiagramGraph& graph_;
  std::uint32_t level_;
  std::vector<std::uint32_t> starts_;  ///< by half: the part that starts there
  std::vector<char> is_cut_;           ///< by walk
  BoundaryParts found_;
};

}  // namespace

FeatureRadius feature_radius(const DiscIndex& index,
                             const std::optional<Rational>& squared_radius) {
  if (!squared_radius) return {index.radii(), false, std::nullopt};
  if (*squared_radius <= 0) {
    throw BadInput("bad-radius", "the square of the radius is " + to_string(*squared_radius),
                   "give a radius above 0");
  }
  const DiscIndex::Place place = index.place(*squared_radius);
  return {place.gap - (place.at_event ? 1U : 0U), place.at_event,
          index.in_frame(*squared_radius).squared};
}

BoundaryParts boundary_parts(const DiscIndex& index, std::uint32_t level) {
  return PartFinder(index, level).find();
}

std::vector<std::uint32_t> walk_vertices(const DiscIndex& index, std::uint32_t walk) {
  const BoundaryWalks& walks = index.diagram().walks;
  std::vector<std::uint32_t> found;
  for (std::uint32_t side = walks.walks[walk].first; side < walks.walks[walk].last; ++side) {
    if (!walks.sides[side].is_arc) found.push_back(walks.sides[side].to);
  }
  return found;
}

}  // namespace minkref::inline disc
