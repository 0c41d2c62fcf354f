// All scales at which the arrangement of a convolution changes, and the changes.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "reference/plane/dynamic/triple_events.hpp"

namespace minkref::inline plane {

/// Nodes of all edges with the events at which nodes appear, disappear and swap. Events of equal
/// scale form a group; groups are numbered from 0 by scale, and EdgeNode::from and to hold groups.
class ArrangementEvents {
 public:
  /// Pair, parallel and triple events within the *open* window. Exact. Operands must have passed
  /// `validate`, or be cut (simply_connected.hpp), and be neither empty nor both degenerate.
  ArrangementEvents(const PolygonSet& P, const PolygonSet& Q, const ScaleWindow& window,
                    ConvolutionType of = ConvolutionType::reduced);

  const ScaleWindow& window() const { return window_; }
  const std::vector<ConvolutionEdge>& edges() const { return pairs_.edges; }
  const std::vector<RationalEdge>& moving() const { return moving_; }
  const NodeTable& table() const { return table_; }
  const PairEvents& pairs() const { return pairs_; }
  const std::vector<TripleEvent>& triples() const { return triples_; }

  std::size_t groups() const { return approximate_.size(); }
  double approximate(std::uint32_t group) const { return approximate_[group]; }
  Rational exact(std::uint32_t group) const;
  /// An event defining the group's scale, if any; the two functions never both return one.
  const PairEvent* pair_event_at(std::uint32_t group) const;
  const TripleEvent* triple_event_at(std::uint32_t group) const;
  std::uint32_t group_of_triple(std::size_t triple) const { return group_of_triple_[triple]; }
  /// The group of a pairs() event; EdgeNode::always for an event not inside the window.
  std::uint32_t group_of_pair_event(std::size_t event) const {
    return group_of_rank_[pairs_.events[event].rank];
  }
  /// The pair and parallel events of a group. O(log events).
  std::span<const PairEvent> pair_events_of(std::uint32_t group) const;
  /// The count of groups before a scale; `at` tells whether the next group lies at the scale.
  struct Location {
    std::uint32_t before = 0;
    bool at = false;
  };
  Location locate(const Rational& scale) const;

 private:
  struct Source {
    enum class Kind : std::uint8_t { moment, triple } kind;
    std::uint32_t index;
  };
  void collect_nodes();
  void order();

  ScaleWindow window_;
  PairEvents pairs_;
  std::vector<RationalEdge> moving_;
  std::unique_ptr<Moments> moments_;
  NodeTable table_;
  std::vector<TripleEvent> triples_;
  std::vector<double> approximate_;  ///< of each group
  std::vector<Source> source_;
  std::vector<std::uint32_t> group_of_triple_, group_of_rank_;
};

}  // namespace minkref::inline plane
