#include "reference/plane/dynamic/dynamic_arrangement.hpp"

#include <algorithm>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/dynamic/passing_edges.hpp"

namespace minkref::inline plane {
DynamicArrangement::DynamicArrangement(std::shared_ptr<const BoundaryStates> states)
    : states_(std::move(states)),
      timeline_(states_->timeline()),
      cycles_(timeline_.events->moving()),
      lists_(timeline_),
      where_(timeline_.sub_edges.size(), no_entry) {
  const FloatEnvironment standard;
  for (const std::uint32_t s : states_->begin_with(0)) {
    where_[s] = static_cast<std::uint32_t>(sub_edges_.size());
    sub_edges_.push_back(s);
  }
  place_nodes_in_doubles();
  scale_ = timeline_.events->window().from.value_or(0);
}

StepReport DynamicArrangement::move_to(const Rational& scale) {
  const FloatEnvironment standard;
  const ScaleWindow& window = timeline_.events->window();
  if (sign(scale) <= 0 || (window.from && scale <= *window.from) ||
      (window.to && scale >= *window.to)) {
    throw BadInput("outside-window", "the scale " + to_string(scale) + " is outside the window",
                   "choose a window that contains it");
  }
  const auto location = timeline_.events->locate(scale);
  const std::uint32_t place = lists_.place();
  const std::uint32_t target = 2 * location.before + (location.at ? 1 : 0);
  const std::size_t before = lists_.size();
  const ChangeCounts counts = lists_.move_to(target);
  scale_ = scale;
  StepReport report;
  report.insertions = counts.insertions;
  report.deletions = counts.deletions;
  report.swaps = counts.swaps;
  if (place != target) {
    report.groups = (std::max(place, target) + 1) / 2 - std::min(place, target) / 2;
  }
  report.updated = before - std::min<std::size_t>(before, report.deletions);
  return report;
}

void DynamicArrangement::move_boundary(std::uint32_t interval) {
  const auto add = [&](std::uint32_t s) {
    if (where_[s] != no_entry) return;
    where_[s] = static_cast<std::uint32_t>(sub_edges_.size());
    sub_edges_.push_back(s);
  };
  const auto remove = [&](std::uint32_t s) {
    if (where_[s] == no_entry) return;
    where_[sub_edges_.back()] = where_[s];
    sub_edges_[where_[s]] = sub_edges_.back();
    sub_edges_.pop_back();
    where_[s] = no_entry;
  };
  // Only groups that touch the boundary matter; group g lies between intervals g and g + 1.
  const auto& groups = states_->groups();
  const auto [low, high] = std::minmax(interval_, interval);
  const auto crossed = std::lower_bound(groups.begin(), groups.end(), high) -
                       std::lower_bound(groups.begin(), groups.end(), low);
  if (static_cast<std::size_t>(crossed) > where_.size() / 16) {  // a glance at all is faster
    for (const std::uint32_t s : sub_edges_) where_[s] = no_entry;
    sub_edges_.clear();
    for (const std::uint32_t s : states_->sub_edges_in(interval)) add(s);
  } else if (interval_ < interval) {
    auto g = std::lower_bound(groups.begin(), groups.end(), interval_);
    for (; g != groups.end() && *g < interval; ++g) {
      for (const std::uint32_t s : states_->end_with(*g)) remove(s);
      for (const std::uint32_t s : states_->begin_with(*g + 1)) add(s);
    }
  } else {
    auto g = std::lower_bound(groups.begin(), groups.end(), interval_);
    while (g != groups.begin() && *(g - 1) >= interval) {
      --g;
      for (const std::uint32_t s : states_->begin_with(*g + 1)) remove(s);
      for (const std::uint32_t s : states_->end_with(*g)) add(s);
    }
  }
  interval_ = interval;
}

Point DynamicArrangement::position(std::uint32_t edge, std::uint32_t node) const {
  return timeline_.track(edge, node).at(scale_);
}

std::vector<SideNumbers> DynamicArrangement::winding_numbers(std::uint32_t edge) const {
  const WindingHistory& winding = timeline_.winding;
  std::vector<SideNumbers> numbers{winding.base(edge, group())};
  for (const std::uint32_t n : nodes(edge)) {
    // At a group's scale the faces equal the faces below, except where parallel edges overlap.
    const bool arrives = at_event() && timeline_.events->table().nodes[n].from == group();
    numbers.push_back(arrives ? numbers.back() : numbers.back() + winding.steps[n]);
  }
  if (at_event()) pass_parallel_edges(edge, numbers);
  return numbers;
}

/// Adds the changes by parallel edges lying on an edge at the group's scale.
void DynamicArrangement::pass_parallel_edges(std::uint32_t edge,
                                             std::vector<SideNumbers>& numbers) const {
  const ArrangementEvents& events = *timeline_.events;
  const auto along = nodes(edge);
  for (const PairEvent& event : events.pair_events_of(group())) {
    if (!event.parallel || event.change != Change::overlap) continue;
    if (event.a != edge && event.b != edge) continue;
    const std::uint32_t other = event.a == edge ? event.b : event.a;
    const RationalEdge &e = events.moving()[edge], &f = events.moving()[other];
    const SideNumbers change = change_by_passing(e, f, events.edges()[other].sign).first;
    Point from = position(edge, start_of_edge);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Point to = position(edge, i < along.size() ? along[i] : end_of_edge);
      const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
      if (runs_along(e, f, middle, scale_)) numbers[i] = numbers[i] + change;
      from = to;
    }
  }
}

void DynamicArrangement::place_nodes_in_doubles() {
  const auto& moving = timeline_.events->moving();
  for (const RationalEdge& e : moving) {
    lines_.push_back({to_double(e.p.x()), to_double(e.p.y()), to_double(e.q.x()),
                      to_double(e.q.y()), to_double(e.d.x()), to_double(e.d.y())});
  }
  const NodeTable& table = timeline_.events->table();
  motions_.reserve(table.nodes.size());
  for (std::uint32_t edge = 0; edge < lines_.size(); ++edge) {
    look_for_interrupt();
    const Line& a = lines_[edge];
    for (std::uint32_t n = table.begin(edge); n < table.end(edge); ++n) {
      const EdgeNode& node = table.nodes[n];
      const Line& b = lines_[node.other];
      // As in crossing_position and vertex_position (edge_nodes.hpp).
      double px = b.px - a.px, py = b.py - a.py, qx = b.qx - a.qx, qy = b.qy - a.qy;
      if (node.kind == EdgeNode::Kind::crossing) {
        const double den = a.dx * b.dy - a.dy * b.dx;
        motions_.push_back({(px * b.dy - py * b.dx) / den, (qx * b.dy - qy * b.dx) / den});
        continue;
      }
      if (node.kind == EdgeNode::Kind::end_of_other) {
        (moving[node.other].is_s() ? px : qx) += b.dx;
        (moving[node.other].is_s() ? py : qy) += b.dy;
      }
      const double den = a.dx * a.dx + a.dy * a.dy;
      motions_.push_back({(px * a.dx + py * a.dy) / den, (qx * a.dx + qy * a.dy) / den});
    }
  }
}

void DynamicArrangement::positions(std::vector<double>& xy) const {
  const FloatEnvironment standard;
  const double s = to_double(scale_);
  xy.resize(2 * lists_.size());
  double* out = xy.data();
  const Motion* const motions = motions_.data();
  for (std::uint32_t e = 0; e < lines_.size(); ++e) {
    const auto along_edge = lists_.along(e);
    if (along_edge.empty()) continue;
    const Line line = lines_[e];
    const double x = line.px * s + line.qx, y = line.py * s + line.qy;
    for (const std::uint32_t n : along_edge) {
      const double along = motions[n].slope * s + motions[n].value;
      *out++ = x + along * line.dx;
      *out++ = y + along * line.dy;
    }
  }
}

BoundaryGraph DynamicArrangement::boundary() {
  const FloatEnvironment standard;
  move_boundary(group());
  const bool at_boundary_event = at_event() && states_->touches_boundary(group());
  BoundaryState state = at_boundary_event
                            ? states_->at(group(), states_->at_group(group()), sub_edges_)
                            : states_->between(sub_edges_);
  return boundary_graph(states_->tracks(), std::move(state), cycles_, scale_);
}

}  // namespace minkref::inline plane
