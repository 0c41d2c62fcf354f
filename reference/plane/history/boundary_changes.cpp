#include "reference/plane/history/boundary_changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline plane {
namespace {

bool is_before(const Point& p, const Point& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

template <class T>
void sort_and_drop_duplicates(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Whether a point lies on a closed segment. Exact.
bool holds(const Point& from, const Point& to, const Point& p) {
  const auto outside = [](const Rational& a, const Rational& b, const Rational& x) {
    return (x < a && x < b) || (x > a && x > b);
  };
  if (outside(from.x, to.x, p.x) || outside(from.y, to.y, p.y)) return false;
  return (to.x - from.x) * (p.y - from.y) == (to.y - from.y) * (p.x - from.x);
}

/// Around points in doubles, with some doubt in each coordinate.
Box box_with_doubt(const std::array<double, 2>& low, const std::array<double, 2>& high,
                   const std::array<double, 2>& doubt) {
  const Box box{low[0] - doubt[0], low[1] - doubt[1], high[0] + doubt[0], high[1] + doubt[1]};
  const bool is_known = std::isfinite(box.xmin) && std::isfinite(box.ymin) &&
                        std::isfinite(box.xmax) && std::isfinite(box.ymax);
  constexpr double most = std::numeric_limits<double>::max();
  return is_known ? box : Box{-most, -most, most, most};
}

constexpr double doubt_of(double size) { return size * 0x1p-48 + 1e-300; }

/// Sub-edges just below and just above a scale, with boxes at the scale.
class SubEdgesAtScale {
 public:
  void add(std::uint32_t sub_edge, bool above, const Box& box) {
    sub_edges_.emplace_back(sub_edge, above);
    boxes_.push_back(box);
  }

  /// Calls report(sub-edge, above) if the box may hold the place. O(log n) for each among many
  /// places if few boxes overlap.
  template <class Report>
  void at(const Box& place, Report&& report) {
    const auto show = [&](std::uint32_t k) {
      look_for_interrupt();
      report(sub_edges_[k].first, sub_edges_[k].second);
      return false;
    };
    if (++asked_ < places_before_a_tree) {
      for (std::uint32_t k = 0; k < boxes_.size(); ++k) {
        if (boxes_[k].overlaps(place)) show(k);
      }
      return;
    }
    if (tree_.size() == 0) tree_ = BoxTree(boxes_);
    tree_.query(place, show);
  }

 private:
  static constexpr unsigned places_before_a_tree = 17;  // fewer cost less than the tree
  std::vector<std::pair<std::uint32_t, bool>> sub_edges_;
  std::vector<Box> boxes_;
  BoxTree tree_;
  unsigned asked_ = 0;
};

/// An arriving side and a leaving side with the same direction form no corner.
void drop_straight(std::vector<std::uint32_t>& sides) {
  sort_and_drop_duplicates(sides);
  if (sides.size() == 2 && sides[0] / 2 == sides[1] / 2) sides.clear();
}

}  // namespace

BoundaryChanges::BoundaryChanges(const BoundaryHistory& history)
    : history_(history),
      lines_(history.moving(), history.directions()),
      first_(history.tracks().size() + 1, 0) {
  for (const MovingLink& link : history.sub_edges()) {
    ++first_[link.from + 1];
    ++first_[link.to + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  of_track_.resize(first_.back());
  std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
  for (const Track& t : history.tracks()) {
    in_doubles_.push_back({to_double(t.a.x), to_double(t.a.y), to_double(t.b.x), to_double(t.b.y)});
  }
  for (std::uint32_t k = 0; k < history.sub_edges().size(); ++k) {
    of_track_[place[history.sub_edges()[k].from]++] = k;
    of_track_[place[history.sub_edges()[k].to]++] = k;
  }
}

std::uint32_t BoundaryChanges::side(std::uint32_t edge, bool leaves) const {
  return 2 * history_.directions().number(edge) + (leaves ? 1 : 0);
}

BoundaryChanges::Sides BoundaryChanges::between(std::uint32_t track, std::uint32_t interval) const {
  Sides sides;
  for (const std::uint32_t k : of_track(track)) {
    const MovingLink& link = history_.sub_edges()[k];
    if (link.first <= interval && interval <= link.last) {
      sides.push_back(side(link.edge, link.from == track));
    }
  }
  drop_straight(sides);
  return sides;
}

BoundaryChanges::Sides BoundaryChanges::at_scale(std::span<const std::uint32_t> tracks,
                                                 std::uint32_t point, std::uint32_t group,
                                                 const BoundaryAtGroup& here) const {
  Sides sides;
  for (const std::uint32_t track : tracks) {
    for (const std::uint32_t k : of_track(track)) {
      const MovingLink& link = history_.sub_edges()[k];
      if (link.first > group || link.last <= group || here.is_interrupted(k)) continue;
      sides.push_back(side(link.edge, link.from == track));
    }
  }
  for (const BoundaryLink& piece : here.pieces) {
    if (piece.from == piece.to) continue;
    if (piece.from == point) sides.push_back(side(piece.edge, true));
    if (piece.to == point) sides.push_back(side(piece.edge, false));
  }
  drop_straight(sides);
  return sides;
}

/// Excludes a single corner that moves through the scale, and points where the boundary goes
/// straight on.
bool BoundaryChanges::is_place(std::span<const std::uint32_t> tracks, std::uint32_t point,
                               std::uint32_t group, const BoundaryAtGroup& here) const {
  Sides corner;
  bool is_met = false;
  for (const std::uint32_t track : tracks) {
    const Sides below = between(track, group), above = between(track, group + 1);
    if (below != above) return true;
    if (below.empty()) continue;
    if (is_met) return true;
    is_met = true;
    corner = below;
  }
  return at_scale(tracks, point, group, here) != corner;
}

/// Around a sub-edge at a scale, as doubles tell.
Box BoundaryChanges::box_at(std::uint32_t sub_edge, double scale) const {
  const MovingLink& link = history_.sub_edges()[sub_edge];
  const std::array<double, 4>&u = in_doubles_[link.from], &v = in_doubles_[link.to];
  std::array<double, 2> low, high, doubt;
  for (std::size_t k = 0; k < 2; ++k) {
    const double a = u[k] + scale * u[k + 2], b = v[k] + scale * v[k + 2];
    low[k] = std::min(a, b);
    high[k] = std::max(a, b);
    doubt[k] = doubt_of(std::abs(u[k]) + std::abs(scale * u[k + 2]) + std::abs(v[k]) +
                        std::abs(scale * v[k + 2]));
  }
  return box_with_doubt(low, high, doubt);
}

void BoundaryChanges::add_parents(std::uint32_t sub_edge, const Rational& scale, bool above,
                                  std::span<const std::uint32_t> tracks, const Point& place,
                                  std::vector<std::uint32_t>& parents) {
  const MovingLink& link = history_.sub_edges()[sub_edge];
  const auto ends_here = [&](std::uint32_t track) {
    return std::find(tracks.begin(), tracks.end(), track) != tracks.end();
  };
  if (!ends_here(link.from) && !ends_here(link.to) &&
      !holds(history_.tracks()[link.from].at(scale), history_.tracks()[link.to].at(scale), place)) {
    return;
  }
  lines_.along(link, history_.tracks(), scale, above, place, parents);
}

std::optional<BoundaryChange> BoundaryChanges::at(std::uint32_t group, const BoundaryAtGroup& here,
                                                  std::span<const std::uint32_t> below,
                                                  std::span<const std::uint32_t> above) {
  const auto &ended = history_.end_with(group), &begun = history_.begin_with(group + 1);
  // Points, named by their representative tracks, with all tracks there.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> met;
  const auto meet = [&](std::uint32_t track) {
    met.emplace_back(here.standing_for(track), track);
    met.emplace_back(met.back().first, met.back().first);
  };
  for (const auto& [track, point] : here.merged) meet(track);
  for (const BoundaryLink& piece : here.pieces) {
    meet(piece.from);
    meet(piece.to);
  }
  for (const auto* list : {&ended, &begun}) {
    for (const std::uint32_t k : *list) {
      meet(history_.sub_edges()[k].from);
      meet(history_.sub_edges()[k].to);
    }
  }
  sort_and_drop_duplicates(met);

  std::optional<BoundaryChange> change;
  const Rational scale = history_.scale(group);
  SubEdgesAtScale passing;
  const auto add = [&, near_scale = to_double(scale)](std::span<const std::uint32_t> list,
                                                      bool side) {
    for (const std::uint32_t s : list) passing.add(s, side, box_at(s, near_scale));
  };
  std::vector<std::uint32_t> tracks;
  for (std::size_t k = 0; k < met.size();) {
    const std::uint32_t point = met[k].first;
    for (tracks.clear(); k < met.size() && met[k].first == point; ++k) {
      tracks.push_back(met[k].second);
    }
    if (!is_place(tracks, point, group, here)) continue;
    const Point place = history_.tracks()[point].at(scale);
    if (!change) {
      change.emplace(BoundaryChange{place, {}});
      add(ended, false);
      add(below, false);
      add(begun, true);
      add(above, true);
    }
    if (is_before(place, change->place)) change->place = place;
    for (const std::uint32_t track : tracks) {
      for (const std::uint32_t sub_edge : of_track(track)) {
        const MovingLink& link = history_.sub_edges()[sub_edge];
        for (const bool side : {false, true}) {
          const std::uint32_t interval = group + (side ? 1 : 0);
          if (link.first > interval || interval > link.last) continue;
          add_parents(sub_edge, scale, side, tracks, place, change->edges);
        }
      }
    }
    // Adds sides through the place without an end there.
    const std::array<double, 2> at{to_double(place.x), to_double(place.y)};
    passing.at(box_with_doubt(at, at, {doubt_of(std::abs(at[0])), doubt_of(std::abs(at[1]))}),
               [&](std::uint32_t s, bool side) {
                 add_parents(s, scale, side, tracks, place, change->edges);
               });
  }
  if (change) sort_and_drop_duplicates(change->edges);
  return change;
}

}  // namespace minkref::inline plane
