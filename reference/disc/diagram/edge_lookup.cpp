#include "reference/disc/diagram/edge_lookup.hpp"

#include <algorithm>

namespace minkref::inline disc {

EdgeLookup::EdgeLookup(const OffsetCurves& curves) : curves_(curves) {
  std::vector<plane::Box> boxes;
  for (const OffsetEdge& edge : curves.edges) {
    edges_.emplace_back(edge, Rational(1));
    boxes.push_back(box_of(edges_.back()));
    around_.add(boxes.back());
  }
  if (!boxes.empty()) {
    size_ = std::max(around_.xmax - around_.xmin, around_.ymax - around_.ymin);
  }
  tree_ = plane::BoxTree(std::move(boxes));

  std::set<std::pair<std::uint32_t, std::uint32_t>> ends;
  std::set<std::uint32_t> looked_at;
  for (const OffsetEdge& edge : curves.edges) ends.insert({edge.feature, edge.end_feature});
  for (std::uint32_t k = 0; k < curves.edges.size(); ++k) {
    const OffsetEdge& edge = curves.edges[k];
    const std::pair start{edge.feature, edge.start_feature};
    if (ends.contains(start)) within_.insert(start);
    if (!looked_at.insert(edge.start_feature).second) continue;
    tree_.query(box_of(edges_[k].start), [&](std::uint32_t number) {
      const OffsetEdge& other = curves.edges[number];
      const Direction way = from_to(other.start, edge.start);
      if (cross(other.along, way) != 0) return false;
      const Rational foot = disc::dot(other.along, way);
      if (foot > 0 && foot < other.squared_length) {
        within_.insert({other.feature, edge.start_feature});
        touched_.emplace_back(number, edge.start_feature);
      }
      return false;
    });
  }
}

}  // namespace minkref::inline disc
