#include "reference/disc/region/offset_passages.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reference/build/stage.hpp"
#include "reference/disc/distance/near_edges.hpp"
#include "reference/error.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {
namespace {

using At = PatchPlace::At;

struct PlaceOfPatch {
  std::uint32_t patch;
  PatchPlace place;
};

struct RidgePart {
  std::uint32_t patch, by;  ///< by: an edge
  PatchPlace from, to;
};

/// Findings on passages, from the points of patches with the distance ρ.
struct Findings {
  std::vector<PlaceOfPatch> lone;    ///< all about them on the patch is nearer
  std::vector<PlaceOfPatch> marked;  ///< on parts that nothing blocks: their ends, and what touches
  std::vector<RidgePart> ridges;

  void add(Findings&& other) {
    const auto move = [](auto& from, auto& to) {
      std::move(from.begin(), from.end(), std::back_inserter(to));
    };
    move(other.lone, lone);
    move(other.marked, marked);
    move(other.ridges, ridges);
  }
};

/// One patch: the open parts that edges block, taken away, leave points and parts.
class PatchLeft {
 public:
  PatchLeft(const PatchesAt& at, std::uint32_t patch, OffsetCounts& counts)
      : at_(at), patch_(patch), counts_(counts) {}

  void block(std::uint32_t by) {
    if (at_.curves().patches[patch_].edge != OffsetPatch::none) {
      if (auto ridge = at_.ridge(patch_, by)) {
        ridges_.emplace_back(by, std::move(*ridge));
        return;
      }
    }
    for (BlockedPart& part : at_.blocked(patch_, by, counts_)) {
      if (order(part.low, part.high) < 0) {
        blocked_.push_back(std::move(part));
      } else {
        touches_.push_back(std::move(part.low));
      }
    }
  }

  Findings left() {
    std::sort(blocked_.begin(), blocked_.end(),
              [&](const BlockedPart& a, const BlockedPart& b) { return order(a.low, b.low) < 0; });
    PatchPlace reach = At::start;
    for (const BlockedPart& part : blocked_) {
      leave(reach, part.low);
      if (order(reach, part.high) < 0) reach = part.high;
    }
    leave(reach, At::end);
    return std::move(found_);
  }

 private:
  int order(const PatchPlace& a, const PatchPlace& b) { return at_.compare(patch_, a, b, counts_); }

  /// Leaves a closed part, if any.
  void leave(const PatchPlace& from, const PatchPlace& to) {
    const int way = order(from, to);
    if (way > 0) return;
    if (way == 0) {
      found_.lone.push_back({patch_, from});
      return;
    }
    found_.marked.push_back({patch_, from});
    found_.marked.push_back({patch_, to});
    for (const PatchPlace& touch : touches_) {
      if (order(from, touch) <= 0 && order(touch, to) <= 0)
        found_.marked.push_back({patch_, touch});
    }
    for (const auto& [by, part] : ridges_) {
      const PatchPlace& low = order(part.low, from) < 0 ? from : part.low;
      const PatchPlace& high = order(part.high, to) > 0 ? to : part.high;
      if (order(low, high) > 0) continue;
      found_.marked.push_back({patch_, low});
      found_.marked.push_back({patch_, high});
      if (order(low, high) < 0) found_.ridges.push_back({patch_, by, low, high});
    }
  }

  const PatchesAt& at_;
  std::uint32_t patch_;
  OffsetCounts& counts_;
  std::vector<BlockedPart> blocked_;
  std::vector<PatchPlace> touches_;
  std::vector<std::pair<std::uint32_t, BlockedPart>> ridges_;
  Findings found_;
};

Findings look_along_patches(const PatchesAt& at, const NearEdges& near,
                            const BuildOptions& options) {
  const std::size_t count = at.curves().patches.size();
  const BuildControl control(options, "the tight passages");
  std::vector<Findings> of_patch(count);
  std::vector<OffsetCounts> of_thread(control.threads());
  in_parallel(count, control, BuildProgress::Stage::patches, [&](unsigned thread) {
    return [&, thread](std::size_t number) {
      const auto k = static_cast<std::uint32_t>(number);
      if (near.is_inside(k)) return;
      std::vector<std::uint32_t> edges;
      near.find(k, edges);
      PatchLeft patch(at, k, of_thread[thread]);
      for (const std::uint32_t edge : edges) patch.block(edge);
      of_patch[k] = patch.left();
    };
  });
  Findings found;
  for (Findings& some : of_patch) found.add(std::move(some));
  return found;
}

int order_of_points(const RootPoint& a, const RootPoint& b) {
  const int way = compare(a.x, b.x);
  return way != 0 ? way : compare(a.y, b.y);
}

void unite_contacts(std::vector<std::uint32_t>& contacts, const std::vector<std::uint32_t>& more) {
  std::vector<std::uint32_t> all;
  std::set_union(contacts.begin(), contacts.end(), more.begin(), more.end(),
                 std::back_inserter(all));
  contacts = std::move(all);
}

void sort_and_unite(std::vector<OffsetPassage>& passages) {
  std::sort(passages.begin(), passages.end(), [](const OffsetPassage& a, const OffsetPassage& b) {
    const int way = order_of_points(a.points.front(), b.points.front());
    return way != 0 ? way < 0 : order_of_points(a.points.back(), b.points.back()) < 0;
  });
  std::vector<OffsetPassage> found;
  for (OffsetPassage& each : passages) {
    if (!found.empty() && are_same(found.back().points.front(), each.points.front()) &&
        are_same(found.back().points.back(), each.points.back())) {
      unite_contacts(found.back().contacts, each.contacts);
    } else {
      found.push_back(std::move(each));
    }
  }
  passages = std::move(found);
}

/// The edge's feature at the distance ρ from x: the line, or the circle about an end.
template <class N>
std::uint32_t contact_with(const PatchesAt& at, const EdgeNumbers<N>& numbers, std::uint32_t number,
                           const Vector<N>& x) {
  const OffsetEdge& edge = at.curves().edges[number];
  if (sign_of_distance(numbers, x, N(at.squared_radius())) != 0) return OffsetPatch::none;
  const N foot = dot(numbers.along, x - numbers.start);
  if (sign(foot) <= 0) return edge.start_feature;
  return sign(foot - numbers.squared_length) >= 0 ? edge.end_feature : edge.feature;
}

class PassagesOfDisc {
 public:
  PassagesOfDisc(const PatchesAt& at, const BuildOptions& options)
      : at_(at), near_(at), found_(look_along_patches(at, near_, options)) {}

  std::vector<OffsetPassage> all() {
    std::vector<OffsetPassage> passages = segments();
    for (OffsetPassage& point : points()) passages.push_back(std::move(point));
    sort_and_unite(passages);
    return passages;
  }

 private:
  /// The lone points of patches, unless part of another patch contains them: then the points at the
  /// distance ρ go on there.
  std::vector<OffsetPassage> points() {
    std::vector<plane::Box> boxes;
    if (found_.lone.empty()) return {};
    for (const PlaceOfPatch& mark : found_.marked) {
      boxes.push_back(box_of(at_.position(mark.patch, mark.place)));
    }
    const plane::BoxTree marks(std::move(boxes));
    std::vector<OffsetPassage> points;
    for (const PlaceOfPatch& lone : found_.lone) {
      const RootPoint x = at_.point(lone.patch, lone.place);
      const bool goes_on =
          marks.query(box_of(at_.position(lone.patch, lone.place)), [&](std::uint32_t k) {
            return are_same(x, at_.point(found_.marked[k].patch, found_.marked[k].place));
          });
      if (!goes_on) points.push_back({{x}, contacts(lone, x)});
    }
    sort_and_unite(points);
    return points;
  }

  std::vector<std::uint32_t> contacts(const PlaceOfPatch& place, const RootPoint& x) {
    std::vector<std::uint32_t> edges, found;
    near_.find(place.patch, edges);
    const Vector<Interval> rounded = at_.position(place.patch, place.place);
    for (const std::uint32_t k : edges) {
      std::uint32_t contact = OffsetPatch::none;
      try {
        contact = contact_with(at_, at_.edge(k), k, rounded);
      } catch (const UndecidedSign&) {
        const EdgeNumbers<RootNumber> exact(at_.curves().edges[k], at_.squared_radius());
        contact = contact_with(at_, exact, k, x);
      }
      if (contact != OffsetPatch::none) found.push_back(contact);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Finds each segment from both sides. Joins segments that go straight on.
  std::vector<OffsetPassage> segments() {
    std::vector<OffsetPassage> parts;
    for (const RidgePart& part : found_.ridges) {
      RootPoint a = at_.point(part.patch, part.from), b = at_.point(part.patch, part.to);
      if (order_of_points(a, b) > 0) std::swap(a, b);
      std::vector<std::uint32_t> features{at_.curves().patches[part.patch].feature,
                                          at_.curves().edges[part.by].feature};
      std::sort(features.begin(), features.end());
      parts.push_back({{std::move(a), std::move(b)}, std::move(features)});
    }
    sort_and_unite(parts);
    std::vector<OffsetPassage> segments;
    std::vector<bool> is_joined(parts.size(), false);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (is_joined[k]) continue;
      OffsetPassage whole = std::move(parts[k]);
      for (std::size_t next = k + 1; next < parts.size(); ++next) {
        if (is_joined[next] || !goes_on_straight(whole, parts[next])) continue;
        is_joined[next] = true;
        whole.points.back() = parts[next].points.back();
        unite_contacts(whole.contacts, parts[next].contacts);
      }
      segments.push_back(std::move(whole));
    }
    return segments;
  }

  /// Whether both share a point, and a line of P beside which both run.
  bool goes_on_straight(const OffsetPassage& a, const OffsetPassage& b) const {
    std::vector<std::uint32_t> shared;
    std::set_intersection(a.contacts.begin(), a.contacts.end(), b.contacts.begin(),
                          b.contacts.end(), std::back_inserter(shared));
    return !shared.empty() && are_same(a.points.back(), b.points.front());
  }

  const PatchesAt& at_;
  NearEdges near_;
  Findings found_;
};

}  // namespace

std::vector<OffsetPassage> offset_passages(const PatchesAt& at, const BuildOptions& options) {
  const FloatEnvironment standard;
  return PassagesOfDisc(at, options).all();
}

}  // namespace minkref::inline disc
