#include "reference/motion/clearance/clear_scales.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "reference/motion/fits_and_traps.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline motion {
namespace {

/// A cut of the scales, just below a number or just above.
struct RootCut {
  RootNumber scale;
  bool above;
};
int compare(const RootCut& a, const RootCut& b) {
  const int order = minkref::compare(a.scale, b.scale);
  return order != 0 ? order : static_cast<int>(a.above) - static_cast<int>(b.above);
}

struct CutRange {
  RootCut from;
  std::optional<RootCut> to;
};
CutRange cuts_of(const RootRange& range) {
  CutRange cuts{{range.from, !range.from_in}, std::nullopt};
  if (range.to) cuts.to = RootCut{*range.to, range.to_in};
  return cuts;
}
CutRange cuts_of(const ScaleRange& range) {
  CutRange cuts{{range.from.scale, range.from.above}, std::nullopt};
  if (range.to) cuts.to = RootCut{range.to->scale, range.to->above};
  return cuts;
}
RootRange range_of(const CutRange& cuts) {
  RootRange range{cuts.from.scale, !cuts.from.above, std::nullopt, false};
  if (cuts.to) {
    range.to = cuts.to->scale;
    range.to_in = cuts.to->above;
  }
  return range;
}

/// The rest of `within`, both sorted by their beginnings.
std::vector<RootRange> without(const std::vector<ScaleRange>& within,
                               const std::vector<CutRange>& taken) {
  std::vector<RootRange> left;
  for (const ScaleRange& range : within) {
    CutRange rest = cuts_of(range);
    bool is_left = true;
    for (const CutRange& each : taken) {
      if (rest.to && compare(each.from, *rest.to) >= 0) break;
      if (each.to && compare(*each.to, rest.from) <= 0) continue;
      if (compare(rest.from, each.from) < 0) left.push_back(range_of({rest.from, each.from}));
      is_left = each.to && (!rest.to || compare(*each.to, *rest.to) < 0);
      if (!is_left) break;
      rest.from = *each.to;
    }
    if (is_left) left.push_back(range_of(rest));
  }
  return left;
}

/// How far along the segment of the path the features are as near as they are to be.
RootNumber place_along(const PolygonSet& part, const PolygonSet& obstacles,
                       const std::vector<Point>& path, const NearFeatures& features,
                       const RootNumber& scale) {
  if (!features.on_segment) return 0;
  const auto vertex = [](const PolygonSet& set, const VertexId& id) -> const Point& {
    std::uint32_t ring = 0;
    for (const Polygon& polygon : set.polygons) {
      if (ring++ == id.ring) return polygon.outer[id.index];
      for (const Ring& hole : polygon.holes) {
        if (ring++ == id.ring) return hole[id.index];
      }
    }
    throw std::logic_error("a feature without a ring");
  };
  const Point &a = vertex(part, features.part.id), &v = vertex(obstacles, features.obstacle.id),
              &x = path[features.place], &next = path[features.place + 1];
  const Rational dx = next.x - x.x, dy = next.y - x.y, length = dx * dx + dy * dy;
  const Rational from_start = dx * (v.x - x.x) + dy * (v.y - x.y), slope = dx * a.x + dy * a.y;
  return (RootNumber(from_start) - RootNumber(slope) * scale) / RootNumber(length);
}

class Answer {
 public:
  Answer(const PolygonSet& part, const PolygonSet& obstacles, const std::vector<Point>& path,
         const Rational& clearance, ContactRule rule)
      : part_(part),
        obstacles_(obstacles),
        path_(path),
        near_(near_scales(part, obstacles, path, clearance, rule == ContactRule::forbidden)) {}

  ClearScales left_of(const std::vector<ScaleRange>& within) {
    std::vector<CutRange> all, taken;
    for (const NearRange& range : near_) all.push_back(cuts_of(range.scales));
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return compare(all[a].from, all[b].from) < 0; });
    for (const std::size_t k : order) taken.push_back(all[k]);
    ClearScales result{without(within, taken), {}};
    for (const RootRange& range : result.clear) {
      add_bound(range.from, false, result);
      if (range.to) add_bound(*range.to, true, result);
    }
    return result;
  }

 private:
  /// Takes the first features along the path; none at an end of the window.
  void add_bound(const RootNumber& scale, bool blocks, ClearScales& result) const {
    std::optional<ClearBound> best;
    for (const NearRange& range : near_) {
      if (!range.features) continue;
      const bool has_end = blocks
                               ? minkref::compare(range.scales.from, scale) == 0
                               : range.scales.to && minkref::compare(*range.scales.to, scale) == 0;
      if (!has_end) continue;
      const NearFeatures& features = *range.features;
      ClearBound one{scale, blocks, features,
                     place_along(part_, obstacles_, path_, features, scale)};
      if (!best || features.place < best->features.place ||
          (features.place == best->features.place && minkref::compare(one.t, best->t) < 0)) {
        best = std::move(one);
      }
    }
    if (best) result.bounds.push_back(*std::move(best));
  }

  const PolygonSet& part_;
  const PolygonSet& obstacles_;
  const std::vector<Point>& path_;
  std::vector<NearRange> near_;
};

void refuse_bad_clearance(const Rational& clearance) {
  if (clearance > 0) return;
  throw BadInput("bad-clearance", "the clearance is not above 0", "give a positive number, as 1/2");
}

}  // namespace

ClearScales clear_scales(const PolygonSet& part, const PolygonSet& obstacles,
                         const std::vector<Point>& path, const Rational& clearance,
                         ContactRule rule, const ScaleWindow& window) {
  const FloatEnvironment standard;
  refuse_bad_clearance(clearance);
  const ValidScales apart = valid_scales(part, obstacles, path, ContactRule::allowed, window);
  return Answer(part, obstacles, path, clearance, rule).left_of(apart.valid);
}

ClearScales scales_clear_at(const PolygonSet& part, const PolygonSet& container, const Point& at,
                            const Rational& clearance, ContactRule rule) {
  const FloatEnvironment standard;
  refuse_bad_clearance(clearance);
  const FreeScales inside = scales_that_fit_at(part, container, at);
  return Answer(part, container, {at}, clearance, rule).left_of(inside.scales);
}

}  // namespace minkref::inline motion
