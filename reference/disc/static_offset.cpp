#include "reference/disc/static_offset.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "reference/interrupt.hpp"

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;
using Features = std::vector<std::uint32_t>;

/// A closed part of a patch that nothing blocks; `before` and `after`: what blocks beyond its ends,
/// by the features that are there.
struct FreePart {
  std::uint32_t patch;
  PatchPlace from, to;
  Features before, after;
};

/// What is left of a patch, in order. Parts of a single point are among it.
std::vector<FreePart> free_parts(std::uint32_t patch, std::vector<BlockedPart> blocked) {
  std::sort(blocked.begin(), blocked.end(),
            [](const BlockedPart& a, const BlockedPart& b) { return a.low.compare(b.low) < 0; });
  std::vector<FreePart> found;
  PatchPlace reach = At::start;
  Features before;
  bool is_open = true;  // whether the patch is free at its start
  std::size_t k = 0;
  for (; k < blocked.size() && blocked[k].low.at() == At::before; ++k) {
    const int order = is_open ? 1 : blocked[k].high.compare(reach);
    if (order > 0) {
      reach = blocked[k].high;
      before = blocked[k].high_features;
    } else if (order == 0) {
      before.insert(before.end(), blocked[k].high_features.begin(), blocked[k].high_features.end());
    }
    is_open = false;
  }
  while (k < blocked.size()) {
    if (blocked[k].low.compare(reach) >= 0) {
      FreePart part{patch, reach, blocked[k].low, before, {}};
      for (std::size_t l = k; l < blocked.size(); ++l) {
        if (blocked[l].low.compare(part.to) != 0) break;
        part.after.insert(part.after.end(), blocked[l].low_features.begin(),
                          blocked[l].low_features.end());
      }
      found.push_back(std::move(part));
      reach = blocked[k].high;
      before = blocked[k].high_features;
      ++k;
      continue;
    }
    const int order = blocked[k].high.compare(reach);
    if (order > 0) before = blocked[k].high_features;
    if (order > 0) reach = blocked[k].high;
    if (order == 0) {
      before.insert(before.end(), blocked[k].high_features.begin(), blocked[k].high_features.end());
    }
    ++k;
  }
  if (reach.at() != At::beyond) found.push_back({patch, reach, At::end, before, {}});
  return found;
}

class Linker {
 public:
  Linker(const OffsetCurves& curves, const PatchesAt& at, std::vector<FreePart> parts)
      : curves_(curves), at_(at), parts_(std::move(parts)) {
    for (std::uint32_t k = 0; k < parts_.size(); ++k) {
      const FreePart& part = parts_[k];
      if (part.from.at() == At::start) starts_[part.patch] = k;
      for (const std::uint32_t feature : std::set(part.before.begin(), part.before.end())) {
        after_[{feature, feature_of(part)}].push_back(k);
      }
    }
  }

  /// The part that the boundary goes on with.
  std::uint32_t next(std::uint32_t k) const {
    const FreePart& part = parts_[k];
    if (part.to.at() == At::end) {
      const std::uint32_t patch = curves_.patches[part.patch].next;
      const auto found = starts_.find(patch);
      if (patch != OffsetPatch::none && found != starts_.end()) return found->second;
    }
    std::vector<std::uint32_t> found;
    for (const std::uint32_t feature : std::set(part.after.begin(), part.after.end())) {
      const auto here = after_.find({feature_of(part), feature});
      if (here != after_.end()) found.insert(found.end(), here->second.begin(), here->second.end());
    }
    if (found.empty()) {
      throw std::logic_error("an offset curve does not go on at the end of patch " +
                             std::to_string(part.patch));
    }
    if (found.size() == 1) return found[0];
    const RootPoint x = at_.point(part.patch, part.to);
    return *std::min_element(found.begin(), found.end(), [&](std::uint32_t a, std::uint32_t b) {
      return at_.turns_before(part.patch, x, parts_[a].patch, parts_[b].patch);
    });
  }

  const std::vector<FreePart>& parts() const { return parts_; }

 private:
  std::uint32_t feature_of(const FreePart& part) const {
    return curves_.patches[part.patch].feature;
  }

  const OffsetCurves& curves_;
  const PatchesAt& at_;
  std::vector<FreePart> parts_;
  std::map<std::uint32_t, std::uint32_t> starts_;  ///< by patch
  /// By the feature that ends and the one that goes on.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> after_;
};

bool is_point(const FreePart& part) { return part.from.compare(part.to) == 0; }

}  // namespace

StaticOffset static_offset(const PolygonSet& P, const Rational& squared_radius) {
  StaticOffset result{offset_curves(P), squared_radius, {}, {}};
  const OffsetCurves& curves = result.curves;
  const PatchesAt at(curves, squared_radius);
  std::vector<FreePart> parts;
  for (std::uint32_t k = 0; k < curves.patches.size(); ++k) {
    look_for_interrupt();
    std::vector<BlockedPart> blocked;
    for (std::uint32_t e = 0; e < curves.edges.size(); ++e) {
      if (e == curves.patches[k].edge) continue;
      for (BlockedPart& part : at.blocked(k, curves.edges[e])) blocked.push_back(std::move(part));
    }
    for (FreePart& part : free_parts(k, std::move(blocked))) {
      parts.push_back(std::move(part));
    }
  }
  const Linker linker(curves, at, std::move(parts));
  std::vector<bool> seen(linker.parts().size(), false);
  for (std::uint32_t first = 0; first < linker.parts().size(); ++first) {
    if (seen[first] || is_point(linker.parts()[first])) continue;
    std::vector<std::uint32_t> ring;
    std::uint32_t k = first;
    for (; !seen[k]; k = linker.next(k)) {
      seen[k] = true;
      const FreePart& part = linker.parts()[k];
      if (is_point(part)) continue;  // a joint
      ring.push_back(static_cast<std::uint32_t>(result.pieces.size()));
      result.pieces.push_back({part.patch, part.from, part.to});
    }
    if (k != first) throw std::logic_error("an offset curve does not close up");
    result.rings.push_back(std::move(ring));
  }
  return result;
}

}  // namespace minkref::inline disc
