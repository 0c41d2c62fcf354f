#include "reference/plane/dynamic/dynamic_arrangement.hpp"

#include <algorithm>

#include "reference/error.hpp"
#include "reference/no_entry.hpp"
#include "reference/number/float_environment.hpp"

namespace minkref::inline plane {
namespace {}

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

void DynamicArrangement::place_nodes_in_doubles() {
  const auto& moving = timeline_.events->moving();
  for (const RationalEdge& e : moving) {
    lines_.push_back({to_double(e.p.x()), to_double(e.p.y()), to_double(e.q.x()),
                      to_double(e.q.y()), to_double(e.d.x()), to_double(e.d.y())});
  }
  const NodeTable& table = timeline_.events->table();
  motions_.reserve(table.nodes.size());
  for (std::uint32_t edge = 0; edge < lines_.size(); ++edge) {
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
