#include "reference/disc/index/disc_index.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "reference/number/float_environment.hpp"

namespace minkref::inline disc {

namespace {

constexpr double rounding = CornerMotion::rounding;
constexpr double rounded_up = 1 + 0x1p-40;
constexpr double least = 0x1p-1070;       // more than what is lost below the range of doubles
constexpr std::uint32_t most_spans = 64;  // of gaps

}  // namespace

DiscIndex::DiscIndex(DiagramEvents diagram)
    : diagram_(std::move(diagram)), graph_(diagram_graph(diagram_)) {
  const FloatEnvironment standard;
  number_radii();
  part_gaps();
  count_sides();
  place_joints();
  for (std::uint32_t k = 0; k < graph_.halves.size(); ++k) {
    const std::uint32_t twin = graph_.halves[k].twin;
    motions_.push_back(twin < k ? motions_[twin] : corner_motion(diagram_, graph_, k));
  }
  scale_ = to_double(Rational(1 / diagram_.factor));
  x_ = to_double(diagram_.origin.x);
  y_ = to_double(diagram_.origin.y);
  origin_error_ = 0x1p-52 * (std::abs(x_) + std::abs(y_));
}

/// Numbers the radii; events come ordered by radius.
void DiscIndex::number_radii() {
  for (std::uint32_t k = 0; k < diagram_.events.size(); ++k) {
    const Interval& squared = diagram_.events[k].squared_radius;
    bool is_new = radii_.empty() || radii_.back().squared.upper() < squared.lower();
    if (!is_new) {
      const DiagramEvent& last = diagram_.events[radii_.back().event];
      is_new = compare(diagram_.exact(last).squared_radius,
                       diagram_.exact(diagram_.events[k]).squared_radius) < 0;
    }
    if (is_new) radii_.push_back({k, squared});
    numbers_.push_back(radii());
  }
  order_ends();
}

void DiscIndex::order_ends() {
  low_.clear();
  high_.clear();
  is_rising_.clear();
  for (const DiagramHalf& half : graph_.halves) {
    const std::uint32_t from = radius_number(half.from), to = radius_number(half.to);
    low_.push_back(std::min(from, to));
    high_.push_back(std::max(from, to));
    is_rising_.push_back(from < to);
  }
}

/// Into so many spans that each has about as many halves as its gaps, and all together not too
/// many.
void DiscIndex::part_gaps() {
  const std::uint32_t gaps = radii() + 1;
  gaps_of_span_ = (gaps + most_spans - 1) / most_spans;
  spans_.resize((gaps + gaps_of_span_ - 1) / gaps_of_span_);
  for (std::uint32_t number = 0; number < spans_.size(); ++number) {
    Span& span = spans_[number];
    const std::uint32_t first = number * gaps_of_span_, last = first + gaps_of_span_;
    for (const DiagramGraph::Walk& walk : graph_.walks) {
      span.bounds.push_back(static_cast<std::uint32_t>(span.halves.size()));
      for (std::uint32_t k = walk.first; k < walk.last; ++k) {
        if (low_[k] < last && first < high_[k]) span.halves.push_back({k, low_[k], high_[k]});
      }
    }
    span.bounds.push_back(static_cast<std::uint32_t>(span.halves.size()));
  }
}

/// Counts how far each half goes along the sides of its walk.
void DiscIndex::count_sides() {
  for (std::size_t number = 0; number < graph_.walks.size(); ++number) {
    const DiagramGraph::Walk& walk = graph_.walks[number];
    const BoundaryWalk& own = diagram_.walks.walks[number];
    const std::uint32_t total = own.last - own.first;
    const auto onwards = [&](std::uint32_t from, std::uint32_t to) {
      return to >= from ? to - from : to + total - from;
    };
    std::uint32_t passed = 0;
    for (std::uint32_t k = walk.first; k < walk.last; ++k) {
      const DiagramHalf &half = graph_.halves[k],
                        &before = graph_.halves[k == walk.first ? walk.last - 1 : k - 1];
      const std::uint32_t start = passed + onwards(before.to_side, half.from_side);
      passed = start + onwards(half.from_side, half.to_side);
      ways_.push_back({half.twin, half.to_side, start, passed});
    }
    if (walk.first != walk.last && passed != total) {
      throw std::logic_error("the diagram does not go once around a walk");
    }
  }
}

void DiscIndex::place_joints() {
  const std::vector<BoundarySide>& sides = diagram_.walks.sides;
  for (const BoundaryWalk& walk : diagram_.walks.walks) {
    for (std::uint32_t k = walk.first; k < walk.last; ++k) {
      const BoundarySide &side = sides[k], &next = sides[k + 1 == walk.last ? walk.first : k + 1];
      joints_before_.push_back(static_cast<std::uint32_t>(joints_.size()));
      if (side.ends_at_reflex || side.is_arc == next.is_arc) continue;
      const std::uint32_t edge = side.is_arc ? side.next : side.edge;
      joints_.push_back(joint_motion(diagram_.vertex(side.to), diagram_.curves.edges[edge].normal));
    }
  }
  joints_before_.push_back(static_cast<std::uint32_t>(joints_.size()));
}

DiscIndex::Place DiscIndex::place(const Rational& squared_radius) const {
  const FloatEnvironment standard;
  const Rational squared = squared_radius * diagram_.factor * diagram_.factor;
  const Interval near(squared);
  const auto first = std::partition_point(radii_.begin(), radii_.end(), [&](const Radius& radius) {
    return radius.squared.upper() < near.lower();
  });
  auto found = first;
  bool at_event = false;
  for (; found != radii_.end() && found->squared.lower() <= near.upper() && !at_event; ++found) {
    const int order = compare(diagram_.exact(diagram_.events[found->event]).squared_radius,
                              RootNumber(squared_radius));
    if (order > 0) break;
    at_event = order == 0;
  }
  return {static_cast<std::uint32_t>(found - radii_.begin()), at_event};
}

std::uint32_t DiscIndex::sides_between(std::uint32_t walk, std::uint32_t entry,
                                       std::uint32_t exit) const {
  const BoundaryWalk& own = diagram_.walks.walks[walk];
  return ways_[exit].start + 1 - ways_[entry].end + (exit <= entry ? own.last - own.first : 0);
}

void DiscIndex::boundary(std::uint32_t gap, IndexBoundary& found) const {
  const FloatEnvironment standard;
  found.clear();
  const auto walks = static_cast<std::uint32_t>(graph_.walks.size());
  // The corners, ordered along the walks: each starts or ends a part of the boundary.
  thread_local std::vector<std::uint32_t> there, place, bounds, walk_of;
  const std::size_t halves = low_.size();
  const Span& span = spans_[gap / gaps_of_span_];
  there.resize(halves + 1);
  place.resize(halves);
  bounds.resize(walks + 1);
  std::uint32_t count = 0;
  std::uint32_t* const next = there.data();
  for (std::uint32_t walk = 0; walk < walks; ++walk) {
    bounds[walk] = count;
    for (std::uint32_t n = span.bounds[walk]; n < span.bounds[walk + 1]; ++n) {
      const Span::Half& half = span.halves[n];
      next[count] = half.number;
      count +=
          static_cast<std::uint32_t>(half.low <= gap) & static_cast<std::uint32_t>(gap < half.high);
    }
  }
  bounds[walks] = count;
  for (std::uint32_t k = 0; k < count; ++k) place[there[k]] = k;
  walk_of.resize(count);
  for (std::uint32_t walk = 0; walk < walks; ++walk) {
    std::fill(walk_of.begin() + bounds[walk], walk_of.begin() + bounds[walk + 1], walk);
  }
  thread_local std::vector<char> is_done;
  is_done.assign(count, 0);
  for (std::uint32_t start = 0; start < count; ++start) {
    if (is_done[start] != 0 || is_rising_[there[start]] == 0) continue;
    IndexRing ring{static_cast<std::uint32_t>(found.corners.size()), 0, walk_of[start]};
    for (std::uint32_t entry = start; is_done[entry] == 0;) {
      is_done[entry] = 1;
      const std::uint32_t walk = walk_of[entry],
                          exit = entry + 1 == bounds[walk + 1] ? bounds[walk] : entry + 1;
      const std::uint32_t half = there[entry], last = there[exit];
      found.corners.push_back({half, walk, ways_[half].to_side, sides_between(walk, half, last)});
      entry = place[ways_[last].twin];
    }
    ring.last_corner = static_cast<std::uint32_t>(found.corners.size());
    found.rings.push_back(ring);
  }
  // Walks without corners: wholly free, or not at all.
  for (std::uint32_t walk = 0; walk < walks; ++walk) {
    const DiagramGraph::Walk& own = graph_.walks[walk];
    if (bounds[walk] != bounds[walk + 1]) continue;
    if (own.first != own.last && low_[own.first] <= gap) continue;
    const auto at = static_cast<std::uint32_t>(found.corners.size());
    found.rings.push_back({at, at, walk});
  }
}

FrameRadius DiscIndex::in_frame(const Rational& squared_radius) const {
  const FloatEnvironment standard;
  const Rational squared = squared_radius * diagram_.factor * diagram_.factor;
  const TwoDoubles near = two_doubles(root_of(RootNumber(squared)));
  return {squared, near, 0x1p-99 * near.high + least};
}

FrameRadius DiscIndex::frame_radius(const Rational& radius) const {
  const FloatEnvironment standard;
  const Rational exact = radius * diagram_.factor;
  const double high = to_double(exact);
  if (!std::isfinite(high)) return {exact * exact, {high, 0}, high};
  const double low = to_double(Rational(exact - from_double(high)));
  return {exact * exact, {high, low}, 0x1p-99 * high + least};
}

BoundedPoint DiscIndex::rounded_corner(std::uint32_t half, const TwoDoubles& radius,
                                       double off) const {
  return corner_of(motions_[half], radius, off);
}

BoundedPoint DiscIndex::corner(std::uint32_t half, const FrameRadius& radius) const {
  const FloatEnvironment standard;
  const BoundedPoint found = corner_of(motions_[half], radius.near, radius.off);
  return found.error <= radius.widest_error() ? found : corner_from_roots(half, radius);
}

BoundedPoint DiscIndex::corner_from_roots(std::uint32_t half, const FrameRadius& radius) const {
  const RootPoint exact = corner_at(diagram_, graph_, half, radius.squared);
  const double x = nearest_double(exact.x), y = nearest_double(exact.y);
  return {x, y, 0x1p-53 * std::max(std::abs(x), std::abs(y)) + least};
}

/// Calls do(first, last) for the joints at the ends of so many consecutive sides; the walk may go
/// on from the last side to the first.
template <class Do>
void DiscIndex::for_joints(std::uint32_t walk, std::uint32_t side, std::uint32_t sides,
                           Do&& act) const {
  const BoundaryWalk& own = diagram_.walks.walks[walk];
  const std::uint32_t end = side + sides, stop = std::min(end, own.last);
  act(joints_before_[side], joints_before_[stop]);
  if (end > stop) act(joints_before_[own.first], joints_before_[own.first + (end - stop)]);
}

BoundedPoint DiscIndex::as_given(const BoundedPoint& in_frame) const {
  const double x = in_frame.x * scale_, y = in_frame.y * scale_;
  const double error =
      in_frame.error * scale_ + origin_error_ + 0x1p-52 * (std::abs(x) + std::abs(y)) + least;
  return {x + x_, y + y_, error * rounded_up};
}

void DiscIndex::vertices(const IndexBoundary& boundary, double radius,
                         std::vector<BoundedPoint>& found,
                         std::vector<std::uint32_t>& starts) const {
  const FloatEnvironment standard;
  starts.clear();
  const auto for_all = [&](auto&& start_ring, auto&& add_corner, auto&& add_joints) {
    for (const IndexRing& ring : boundary.rings) {
      start_ring();
      if (ring.first_corner == ring.last_corner) {
        const BoundaryWalk& walk = diagram_.walks.walks[ring.walk];
        add_joints(joints_before_[walk.first], joints_before_[walk.last]);
      }
      for (std::uint32_t k = ring.first_corner; k < ring.last_corner; ++k) {
        const IndexCorner& corner = boundary.corners[k];
        add_corner(corner.half);
        for_joints(corner.walk, corner.first_side, corner.sides - 1, add_joints);
      }
    }
  };
  std::size_t count = boundary.corners.size();
  for_all([] {}, [](std::uint32_t) {},
          [&](std::uint32_t first, std::uint32_t last) { count += last - first; });
  found.resize(count);

  const Rational exact = from_double(radius);
  const FrameRadius in_frame = this->in_frame(exact * exact);
  const double joint_error = rounding * radius + least;
  BoundedPoint* next = found.data();
  for_all([&] { starts.push_back(static_cast<std::uint32_t>(next - found.data())); },
          [&](std::uint32_t half) { *next++ = as_given(corner(half, in_frame)); },
          [&](std::uint32_t first, std::uint32_t last) {
            for (const JointMotion* joint = &joints_[first]; first < last; ++first, ++joint) {
              *next++ = {joint->ax + radius * joint->bx, joint->ay + radius * joint->by,
                         (joint->error + joint_error) * rounded_up};
            }
          });
}

}  // namespace minkref::inline disc
