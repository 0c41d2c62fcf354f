#include "reference/plane/history/edges_on_lines.hpp"

#include <algorithm>
#include <utility>

namespace minkref::inline plane {
namespace {

using V = Vector2<Rational>;

/// The position a + s b along a line at a scale: value and speed.
using Germ = std::pair<Rational, Rational>;

/// `above`: just above the scale the faster is ahead, just below it the slower.
bool is_less(const Germ& x, const Germ& y, bool above) {
  if (x.first != y.first) return x.first < y.first;
  return above ? x.second < y.second : y.second < x.second;
}

}  // namespace

EdgesOnLines::EdgesOnLines(const std::vector<RationalEdge>& edges, const EdgeDirections& directions)
    : edges_(edges), directions_(directions), by_direction_(2 * directions.along.size()) {
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    by_direction_[directions.number(e)].push_back(e);
  }
}

EdgesOnLines::Lines& EdgesOnLines::lines(std::uint32_t direction) {
  const auto [known, fresh] = lines_.try_emplace(direction);
  Lines& result = known->second;
  if (!fresh) return result;
  const V& along = directions_.along[direction / 2];
  const auto across = [&](const V& v) { return Rational(along.x() * v.y() - along.y() * v.x()); };
  struct Placed {
    Rational p, q;
    std::uint32_t edge;
  };
  std::vector<Placed> placed;
  for (const std::uint32_t e : by_direction_[direction]) {
    placed.push_back({across(edges_[e].p), across(edges_[e].q), e});
  }
  std::sort(placed.begin(), placed.end(), [](const Placed& x, const Placed& y) {
    if (x.p != y.p) return x.p < y.p;
    return x.q != y.q ? x.q < y.q : x.edge < y.edge;
  });
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (k == 0 || placed[k].p != placed[k - 1].p || placed[k].q != placed[k - 1].q) {
      result.first.push_back(static_cast<std::uint32_t>(k));
    }
    result.line_of_edge[placed[k].edge] = static_cast<std::uint32_t>(result.first.size() - 1);
    result.edges.push_back(placed[k].edge);
  }
  result.first.push_back(static_cast<std::uint32_t>(placed.size()));
  return result;
}

std::span<const std::uint32_t> EdgesOnLines::with(std::uint32_t edge) {
  const Lines& known = lines(directions_.number(edge));
  const std::uint32_t line = known.line_of_edge.at(edge);
  return {known.edges.data() + known.first[line], known.edges.data() + known.first[line + 1]};
}

const SpansOnLine& EdgesOnLines::spans(std::uint32_t edge, std::span<const std::uint32_t> on_line) {
  Lines& known = lines(directions_.number(edge));
  const std::uint32_t line = known.line_of_edge.at(edge);
  if (const auto found = known.spans.find(line); found != known.spans.end()) return found->second;
  const V& along = directions_.along[directions_.line[edge]];
  const auto position = [&](const V& v) {
    return to_double(Rational(along.x() * v.x() + along.y() * v.y()));
  };
  std::vector<SpansOnLine::Span> spans;
  for (const std::uint32_t e : on_line) {
    const auto start = start_of(edges_[e]), end = end_of(edges_[e]);
    spans.push_back({position(start.p), position(start.q), position(end.p), position(end.q)});
  }
  return known.spans.try_emplace(line, spans).first->second;
}

void EdgesOnLines::along(const MovingLink& link, const std::vector<Track>& tracks,
                         const Rational& scale, bool above, const Point& point,
                         std::vector<std::uint32_t>& to) {
  const std::span<const std::uint32_t> edges = with(link.edge);
  if (edges.size() == 1) {
    to.push_back(link.edge);
    return;
  }
  const V& along = directions_.along[directions_.line[link.edge]];
  const auto position = [&](const auto& v) {
    return Rational(along.x() * v.x() + along.y() * v.y());
  };
  const auto of_track = [&](std::uint32_t track) {
    const Track& t = tracks[track];
    const Rational fast(along.x() * t.b.x + along.y() * t.b.y);
    return Germ{Rational(along.x() * t.a.x + along.y() * t.a.y + scale * fast), fast};
  };
  const auto of_vertex = [&](const MovingVertex<V>& v) {
    const Rational fast = position(v.p);
    return Germ{Rational(position(v.q) + scale * fast), fast};
  };
  const bool forward = directions_.forward[link.edge] != 0;
  const Germ low = of_track(forward ? link.from : link.to),
             high = of_track(forward ? link.to : link.from);
  const Rational here(along.x() * point.x + along.y() * point.y);
  std::vector<std::uint32_t> near;
  spans(link.edge, edges).holding(to_double(here), to_double(scale), [&](std::uint32_t k) {
    near.push_back(edges[k]);
  });
  std::sort(near.begin(), near.end());
  for (const std::uint32_t e : near) {
    look_for_interrupt();
    const Germ start = of_vertex(start_of(edges_[e])), end = of_vertex(end_of(edges_[e]));
    const Germ& first = forward ? start : end;
    const Germ& last = forward ? end : start;
    const Germ& from = is_less(low, first, above) ? first : low;
    const Germ& until = is_less(last, high, above) ? last : high;
    if (is_less(from, until, above) && from.first <= here && here <= until.first) to.push_back(e);
  }
}

}  // namespace minkref::inline plane
