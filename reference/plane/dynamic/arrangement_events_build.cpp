// Finding all events.
#include <algorithm>
#include <cmath>

#include "reference/interrupt.hpp"
#include "reference/plane/critical/event_scale.hpp"
#include "reference/plane/critical/parallel_pair.hpp"
#include "reference/plane/dynamic/arrangement_events.hpp"
#include "reference/plane/kernel/exact_frame.hpp"

namespace minkref::inline plane {
namespace {

struct Lifetime {
  std::uint32_t from = EdgeNode::always, to = EdgeNode::always;
  bool outside = false;  ///< of the window
};

/// The scales at which a vertex on the line of an edge lies on the edge.
ScaleInterval<PlainKernel<Rational>> scales_on_edge(const RationalEdge& edge,
                                                    const PositionAlong<Rational>& position) {
  const HalfLine<Rational> after_start{position.slope, position.value};
  const HalfLine<Rational> before_end =
      edge.is_s() ? HalfLine<Rational>{position.den - position.slope, -position.value}
                  : HalfLine<Rational>{-position.slope, position.den - position.value};
  return intersection_of_half_lines<PlainKernel<Rational>>({}, std::array{after_start, before_end});
}

/// When each meeting pair begins and ceases to meet, as moments of events.
std::vector<Lifetime> lifetimes_of(const PairEvents& pairs, const std::vector<RationalEdge>& moving,
                                   const ScaleWindow& window,
                                   const std::vector<std::uint32_t>& moment_of_rank) {
  const auto& meeting = pairs.meeting;
  std::vector<std::uint32_t> first_of(pairs.edges.size() + 1, 0);
  for (const MeetingPair& pair : meeting) ++first_of[pair.a + 1];
  for (std::size_t e = 0; e < pairs.edges.size(); ++e) first_of[e + 1] += first_of[e];
  std::vector<Lifetime> lifetimes(meeting.size());
  for (const PairEvent& event : pairs.events) {
    const auto begin = meeting.begin() + first_of[event.a],
               end = meeting.begin() + first_of[event.a + 1];
    const auto pair = std::lower_bound(
        begin, end, event.b, [](const MeetingPair& p, std::uint32_t b) { return p.b < b; });
    look_for_interrupt();
    Lifetime& lifetime = lifetimes[static_cast<std::size_t>(pair - meeting.begin())];
    const std::uint32_t moment = moment_of_rank[event.rank];
    const bool at_start = moment == EdgeNode::always && window.from && event.rank == 0 &&
                          event_scale(PlainKernel<Rational>{}, moving[event.a], moving[event.b],
                                      event) == *window.from;
    switch (event.change) {
      case Change::birth:
        lifetime.from = moment;
        if (moment == EdgeNode::always && !at_start) lifetime.outside = true;
        break;
      case Change::death:
        lifetime.to = moment;
        if (moment == EdgeNode::always && at_start) lifetime.outside = true;
        break;
      case Change::touch:
      case Change::overlap:
        lifetime.from = lifetime.to = moment;
        if (moment == EdgeNode::always) lifetime.outside = true;
        break;
    }
  }
  return lifetimes;
}

}  // namespace

ArrangementEvents::ArrangementEvents(const PolygonSet& P, const PolygonSet& Q,
                                     const ScaleWindow& window, ConvolutionType of)
    : window_(window),
      pairs_(pair_events(P, Q, window, EventKind::both, Form::corrected, true, of)),
      moving_(moving_edges<Vector2<Rational>>(pairs_.edges, scalar_operand<Rational>(P, {}),
                                              scalar_operand<Rational>(Q, {}))),
      moments_(std::make_unique<Moments>(pairs_, moving_)) {
  collect_nodes();
  triples_ = triple_events(P, Q, pairs_.edges, table_, *moments_, window_);
  order();
}

void ArrangementEvents::collect_nodes() {
  // Moments of the pair and parallel events; events at the ends of the window lie outside.
  const auto& events = pairs_.events;
  std::vector<std::uint32_t> moment_of_rank(pairs_.distinct, EdgeNode::always);
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (i > 0 && events[i].rank == events[i - 1].rank) continue;
    const bool first = events[i].rank == 0, last = events[i].rank + 1 == pairs_.distinct;
    if ((first && window_.from) || (last && window_.to)) {
      const RationalEdge &a = moving_[events[i].a], &b = moving_[events[i].b];
      const Rational scale = event_scale(PlainKernel<Rational>{}, a, b, events[i]);
      if (window_.from && scale == *window_.from) continue;
      if (window_.to && scale == *window_.to) continue;
    }
    moment_of_rank[events[i].rank] = moments_->add_events(i);
  }
  group_of_rank_ = moment_of_rank;

  const auto& meeting = pairs_.meeting;
  const std::vector<Lifetime> lifetimes = lifetimes_of(pairs_, moving_, window_, moment_of_rank);

  // Counts, then places, the nodes of each edge.
  struct Placed {
    std::uint32_t edge;
    EdgeNode node;
  };
  std::vector<Placed> ends;  // end points of edges on other edges
  for (std::size_t i = 0; i < meeting.size(); ++i) {
    look_for_interrupt();
    const MeetingPair& pair = meeting[i];
    if (pair.kind == MeetingPair::Kind::crossing || lifetimes[i].outside) continue;
    for (const auto& [edge, other] : {std::pair{pair.a, pair.b}, std::pair{pair.b, pair.a}}) {
      for (const auto kind : {EdgeNode::Kind::start_of_other, EdgeNode::Kind::end_of_other}) {
        EdgeNode node{other, kind, lifetimes[i].from, lifetimes[i].to};
        const auto position = node_position(PlainKernel<Rational>{}, moving_, edge, node);
        if (pair.kind == MeetingPair::Kind::one_line_at_a_scale) {
          const Rational scale = moments_->exact(node.from);
          const Rational along = position.slope * scale + position.value;
          const Rational length =
              moving_[edge].is_s() ? Rational(position.den * scale) : position.den;
          if (sign(along) < 0 || along > length) continue;
        } else {
          const auto interval = scales_on_edge(moving_[edge], position);
          if (interval.empty) continue;
          node.from = node.to = EdgeNode::always;
          if (interval.lower) {
            const Rational& lower = interval.lower->scale;
            if (window_.to && lower >= *window_.to) continue;
            if (!window_.from || lower > *window_.from) node.from = moments_->add_scale(lower);
          }
          if (interval.upper) {
            const Rational& upper = interval.upper->scale;
            if (window_.from && upper <= *window_.from) continue;
            if (!window_.to || upper < *window_.to) node.to = moments_->add_scale(upper);
          }
        }
        ends.push_back({edge, node});
      }
    }
  }
  table_.first.assign(pairs_.edges.size() + 1, 0);
  const auto count = [&](std::uint32_t edge) { ++table_.first[edge + 1]; };
  for (std::size_t i = 0; i < meeting.size(); ++i) {
    if (meeting[i].kind != MeetingPair::Kind::crossing || lifetimes[i].outside) continue;
    count(meeting[i].a);
    count(meeting[i].b);
  }
  for (const Placed& end : ends) count(end.edge);
  for (std::size_t e = 0; e < pairs_.edges.size(); ++e) table_.first[e + 1] += table_.first[e];
  table_.nodes.resize(table_.first.back());
  std::vector<std::uint32_t> place(table_.first.begin(), table_.first.end() - 1);
  for (std::size_t i = 0; i < meeting.size(); ++i) {
    if (meeting[i].kind != MeetingPair::Kind::crossing || lifetimes[i].outside) continue;
    const auto& [a, b, kind] = meeting[i];
    table_.nodes[place[a]++] = {b, EdgeNode::Kind::crossing, lifetimes[i].from, lifetimes[i].to};
    table_.nodes[place[b]++] = {a, EdgeNode::Kind::crossing, lifetimes[i].from, lifetimes[i].to};
  }
  for (const Placed& end : ends) table_.nodes[place[end.edge]++] = end.node;
}

void ArrangementEvents::order() {
  struct Item {
    double approximate;
    Source source;
  };
  std::vector<Item> items;
  items.reserve(moments_->size() + triples_.size());
  for (std::uint32_t m = 0; m < moments_->size(); ++m) {
    items.push_back({moments_->approximate(m), {Source::Kind::moment, m}});
  }
  for (std::uint32_t t = 0; t < triples_.size(); ++t) {
    items.push_back({triples_[t].approximate, {Source::Kind::triple, t}});
  }
  std::sort(items.begin(), items.end(), [](const Item& x, const Item& y) {
    look_for_interrupt();
    return x.approximate < y.approximate;
  });
  std::vector<std::uint32_t> group_of_moment(moments_->size());
  group_of_triple_.resize(triples_.size());
  const auto exact_of = [&](const Source& source) {
    return source.kind == Source::Kind::moment
               ? moments_->exact(source.index)
               : triple_scale(triples_[source.index], moving_, table_);
  };
  const auto assign = [&](const Item& item) {
    const auto group = static_cast<std::uint32_t>(approximate_.size() - 1);
    (item.source.kind == Source::Kind::moment ? group_of_moment
                                              : group_of_triple_)[item.source.index] = group;
  };
  const auto open = [&](const Item& item) {
    approximate_.push_back(item.approximate);
    source_.push_back(item.source);
  };
  for (std::size_t first = 0; first < items.size();) {
    std::size_t last = first + 1;
    while (last < items.size() &&
           !(items[last].approximate - items[last - 1].approximate >
             (items[last].approximate + items[last - 1].approximate) * 2 * filter_bound)) {
      ++last;
    }
    if (last - first == 1) {
      open(items[first]);
      assign(items[first]);
    } else {
      std::vector<std::pair<Rational, Item>> run;
      for (std::size_t i = first; i < last; ++i) {
        look_for_interrupt();
        run.emplace_back(exact_of(items[i].source), items[i]);
      }
      std::stable_sort(run.begin(), run.end(), [](const auto& x, const auto& y) {
        look_for_interrupt();
        return x.first < y.first;
      });
      for (std::size_t i = 0; i < run.size(); ++i) {
        if (i == 0 || run[i - 1].first != run[i].first) open(run[i].second);
        assign(run[i].second);
      }
    }
    first = last;
  }
  const auto to_group = [&](std::uint32_t& moment) {
    if (moment != EdgeNode::always) moment = group_of_moment[moment];
  };
  for (EdgeNode& node : table_.nodes) {
    to_group(node.from);
    to_group(node.to);
  }
  for (std::uint32_t& moment : group_of_rank_) to_group(moment);
}

}  // namespace minkref::inline plane
