// Events of pairs and triples of edges, by the fast search, against the paper's way over rationals,
// against orientation signs at single scales, and against the nodes of the dynamic sum.
#include <algorithm>
#include <set>
#include <tuple>

#include "reference/plane/dynamic/arrangement_events.hpp"
#include "tests/fuzzing/reference/edge_meetings.hpp"
#include "tests/fuzzing/reference/pair_input.hpp"

namespace minkref::fuzzing {

const Bounds bounds{.vertices = 10, .product = 30};

namespace {

using Edges = std::vector<RationalEdge>;

constexpr std::size_t most_scales_looked_at = 4;

std::string names(std::initializer_list<std::size_t> edges) {
  std::string text = "edges";
  for (const std::size_t e : edges) text += " " + std::to_string(e);
  return text;
}

/// Scale, a, b, change.
using Row = std::tuple<Rational, std::uint32_t, std::uint32_t, Change>;

/// Checks non-parallel pairs: the listed events are the ends of the meeting intervals.
void check_intervals(const Case& pair, const Edges& edges, const PairEvents& found,
                     const std::vector<Rational>& scales) {
  std::vector<Row> listed, expected;
  for (const PairEvent& e : found.events) {
    if (!e.parallel) listed.emplace_back(scales.at(e.rank), e.a, e.b, e.change);
  }
  for (std::uint32_t a = 0; a < edges.size(); ++a) {
    for (std::uint32_t b = a + 1; b < edges.size(); ++b) {
      if (are_parallel(edges[a], edges[b])) continue;
      const MeetingScales range = meeting_scales(edges[a], edges[b]);
      if (range.empty) continue;
      if (range.is_point()) {
        expected.emplace_back(*range.lower, a, b, Change::touch);
        continue;
      }
      if (range.lower) expected.emplace_back(*range.lower, a, b, Change::birth);
      if (range.upper) expected.emplace_back(*range.upper, a, b, Change::death);
    }
  }
  std::sort(listed.begin(), listed.end());
  std::sort(expected.begin(), expected.end());
  if (listed == expected) return;
  const auto [x, y] = std::mismatch(listed.begin(), listed.end(), expected.begin(), expected.end());
  const Row& first = x != listed.end() ? *x : *y;
  broken("pair events are the ends of the intervals", pair,
         to_string(std::get<0>(first)) + " " + names({std::get<1>(first), std::get<2>(first)}));
}

/// Whether a pair of edges meets at a scale, according to the pair's events; none without events.
std::optional<bool> told(const std::vector<const PairEvent*>& events,
                         const std::vector<Rational>& scales, const Rational& s) {
  if (events.empty()) return std::nullopt;
  bool meets = true;
  for (const PairEvent* e : events) {
    const Rational& at = scales[e->rank];
    if (e->change == Change::birth) meets = meets && at <= s;
    if (e->change == Change::death) meets = meets && s <= at;
    if (e->change == Change::touch || e->change == Change::overlap) meets = meets && s == at;
  }
  return meets;
}

/// Checks at and between some event scales which pairs meet, including parallel pairs.
void check_meetings(const Case& pair, const Edges& edges, const PairEvents& found,
                    const std::vector<Rational>& scales, Dice& dice) {
  std::vector<Rational> chosen{scale_of(pair)};
  for (std::size_t i = 0; i < most_scales_looked_at && !scales.empty(); ++i) {
    const std::size_t k = dice.below(scales.size());
    chosen.push_back(scales[k]);
    chosen.push_back(k + 1 < scales.size() ? (scales[k] + scales[k + 1]) / 2 : 2 * scales[k]);
  }
  const std::size_t n = edges.size();
  std::vector<std::vector<const PairEvent*>> of_pair(n * n);
  for (const PairEvent& e : found.events) of_pair[e.a * n + e.b].push_back(&e);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      std::optional<bool> always;
      for (const Rational& s : chosen) {
        const bool meets = do_meet(edges[a], edges[b], s);
        std::optional<bool> expected = told(of_pair[a * n + b], scales, s);
        if (!expected) expected = always ? always : meets;
        always = expected;
        if (meets != *expected) {
          broken("edges meet where their events say", pair, to_string(s) + " " + names({a, b}));
        }
      }
    }
  }
}

/// A crossing stays on its edge from the interval's beginning to its end.
void check_nodes(const Case& pair, const ArrangementEvents& events) {
  const Edges& edges = events.moving();
  const auto is_bound = [&](std::uint32_t group, const std::optional<Rational>& bound) {
    if (group == EdgeNode::always) return !bound;
    return bound && events.exact(group) == *bound;
  };
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (std::uint32_t n = events.table().begin(e); n < events.table().end(e); ++n) {
      const EdgeNode& node = events.table().nodes[n];
      if (node.kind != EdgeNode::Kind::crossing) continue;
      const MeetingScales range = meeting_scales(edges[e], edges[node.other]);
      if (range.empty || !is_bound(node.from, range.lower) || !is_bound(node.to, range.upper)) {
        broken("a node lives while its edges meet", pair, names({e, node.other}));
      }
    }
  }
}

/// Scale, edges, and the edge that sees the other two swap.
using Swap = std::tuple<Rational, std::uint32_t, std::uint32_t, std::uint32_t, std::uint8_t>;

/// Checks triples of edges, no two parallel: the triple events are the scales at which their lines
/// share a point and two edges meet the third just below and just above.
void check_triples(const Case& pair, const ArrangementEvents& events) {
  const Edges& edges = events.moving();
  const auto n = static_cast<std::uint32_t>(edges.size());
  const auto parallel = [&](std::uint32_t a, std::uint32_t b) {
    return are_parallel(edges[a], edges[b]);
  };
  std::vector<MeetingScales> ranges(std::size_t{n} * n);
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      ranges[a * n + b] = parallel(a, b) ? MeetingScales{} : meeting_scales(edges[a], edges[b]);
      ranges[b * n + a] = ranges[a * n + b];
    }
  }
  std::set<Swap> expected, listed;
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = b + 1; c < n; ++c) {
        const MeetingScales &ab = ranges[a * n + b], &ac = ranges[a * n + c],
                            &bc = ranges[b * n + c];
        if (int(ab.empty) + int(ac.empty) + int(bc.empty) > 1) continue;
        if (parallel(a, b) || parallel(a, c) || parallel(b, c)) continue;
        const auto s = concurrent_scale(edges[a], edges[b], edges[c]);
        if (!s) continue;
        const bool in_ab = ab.has_inside(*s), in_ac = ac.has_inside(*s), in_bc = bc.has_inside(*s);
        const int swaps =
            (in_ab && in_ac ? 1 : 0) | (in_ab && in_bc ? 2 : 0) | (in_ac && in_bc ? 4 : 0);
        if (swaps != 0) expected.emplace(*s, a, b, c, static_cast<std::uint8_t>(swaps));
      }
    }
  }
  for (std::size_t t = 0; t < events.triples().size(); ++t) {
    const TripleEvent& e = events.triples()[t];
    if (parallel(e.a, e.b) || parallel(e.a, e.c) || parallel(e.b, e.c)) continue;
    listed.emplace(events.exact(events.group_of_triple(t)), e.a, e.b, e.c, e.swaps);
  }
  if (listed == expected) return;
  const auto [x, y] = std::mismatch(listed.begin(), listed.end(), expected.begin(), expected.end());
  const auto& [s, a, b, c, swaps] = x != listed.end() ? *x : *y;
  broken("triple events are where lines of three edges pass through one point", pair,
         to_string(s) + " " + names({a, b, c}) + " swaps " + std::to_string(swaps) + ", " +
             std::to_string(listed.size()) + " listed, " + std::to_string(expected.size()) +
             " expected");
}

/// A window's events are the events of all scales inside the window.
void check_window(const Case& pair, const PairEvents& found, const std::vector<Rational>& scales) {
  const ScaleWindow window{pair.interval->from, pair.interval->to};
  const PairEvents part = pair_events(pair.P, pair.Q, window);
  const std::vector<Rational> part_scales = critical_scales(part, pair.P, pair.Q);
  std::vector<Row> expected, listed;
  for (const PairEvent& e : found.events) {
    const Rational& s = scales[e.rank];
    if ((window.from && s < *window.from) || (window.to && s > *window.to)) continue;
    expected.emplace_back(s, e.a, e.b, e.change);
  }
  for (const PairEvent& e : part.events) {
    listed.emplace_back(part_scales.at(e.rank), e.a, e.b, e.change);
  }
  if (listed != expected) broken("a window has the pair events of all scales", pair);
}

void check(const Case& pair, Dice& dice) {
  if (pair.P.empty() || pair.Q.empty()) return;
  const ArrangementEvents events(pair.P, pair.Q, {});
  const PairEvents found = pair_events(pair.P, pair.Q);
  const std::vector<Rational> scales = critical_scales(found, pair.P, pair.Q);
  if (scales.size() != found.distinct ||
      std::adjacent_find(scales.begin(), scales.end(), std::greater_equal<>()) != scales.end()) {
    broken("scales ascend, one for each rank", pair);
  }
  check_intervals(pair, events.moving(), found, scales);
  check_meetings(pair, events.moving(), found, scales, dice);
  check_nodes(pair, events);
  check_triples(pair, events);
  if (pair.interval) check_window(pair, found, scales);
}

}  // namespace
}  // namespace minkref::fuzzing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minkref::fuzzing::check_pair(data, size, minkref::fuzzing::check);
}
