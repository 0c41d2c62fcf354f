#include "reference/disc/features/rest_material.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "reference/disc/features/rest_measures.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {
namespace {

constexpr std::uint32_t unknown = DiagramGraph::none;

class RestRings {
 public:
  explicit RestRings(const RegionOutlines& outlines)
      : outlines_(outlines), parts_(outlines.regions().parts.hidden), arcs_of_(outlines) {
    const auto& halves = outlines.index().graph().halves;
    part_from_.assign(halves.size(), unknown);
    for (std::uint32_t k = 0; k < parts_.size(); ++k) part_from_[parts_[k].from] = k;
  }

  RestMaterial find() {
    for (const FeatureRegion& feature : outlines_.regions().features) {
      found_.features.push_back(rest_of(feature));
    }
    found_.overlaps = arcs_of_.overlaps();
    return std::move(found_);
  }

 private:
  FeatureRest rest_of(const FeatureRegion& feature) {
    FeatureRest rest{{}, 0};
    std::vector<std::uint32_t> corners;
    for (const PartRing& ring : feature.rings) {
      if (ring.parts.empty()) rest.rings.push_back({{}, ring.walk});
      corners.insert(corners.end(), ring.parts.begin(), ring.parts.end());
    }
    const auto first = static_cast<std::uint32_t>(found_.arcs.size());
    for (FreeArc& arc : arcs_of_.of(corners)) found_.arcs.push_back(std::move(arc));
    link(first);
    std::vector<char> is_done(found_.arcs.size() - first, 0);
    for (std::uint32_t start = first; start < found_.arcs.size(); ++start) {
      if (is_done[start - first] != 0) continue;
      RestRing ring{{}, 0};
      for (std::uint32_t arc = start; is_done[arc - first] == 0;) {
        is_done[arc - first] = 1;
        ring.pieces.push_back({true, arc});
        if (found_.arcs[arc].to.is_foot()) {
          const std::uint32_t part = part_behind(found_.arcs[arc].corner);
          ring.pieces.push_back({false, part});
          arc = at_foot_.at(part);
        } else {
          arc = behind_crossing(arc);
        }
      }
      rest.rings.push_back(std::move(ring));
    }
    for (const RestRing& ring : rest.rings) {
      if (is_around_rest(outlines_, found_, ring)) ++rest.components;
    }
    return rest;
  }

  /// Notes where free arcs start.
  void link(std::uint32_t first) {
    at_foot_.clear();
    at_crossing_.clear();
    for (std::uint32_t k = first; k < found_.arcs.size(); ++k) {
      const FreeArc& arc = found_.arcs[k];
      if (arc.from.is_foot()) at_foot_[arc.corner] = k;
      for (const std::uint32_t other : arc.from.with) at_crossing_[{arc.corner, other}] = k;
    }
  }
  /// The hidden part that starts at an arc's end.
  std::uint32_t part_behind(std::uint32_t corner) const {
    return part_from_[outlines_.index().graph().halves[outlines_.corners()[corner].half].twin];
  }
  std::uint32_t behind_crossing(std::uint32_t number) const {
    const FreeArc& arc = found_.arcs[number];
    for (const std::uint32_t other : arc.to.with) {
      const auto found = at_crossing_.find({other, arc.corner});
      if (found != at_crossing_.end()) return found->second;
    }
    throw std::logic_error("the boundary of the rest material ends");
  }

  const RegionOutlines& outlines_;
  const std::vector<BoundaryPart>& parts_;
  RestArcs arcs_of_;
  std::vector<std::uint32_t> part_from_;  ///< by half
  std::map<std::uint32_t, std::uint32_t> at_foot_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> at_crossing_;
  RestMaterial found_;
};

}  // namespace

RestMaterial rest_material(const RegionOutlines& outlines) {
  const FloatEnvironment standard;
  return RestRings(outlines).find();
}

}  // namespace minkref::inline disc
