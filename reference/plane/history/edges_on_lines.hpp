// Finds convolution edges on a common line at every scale, and their parts along the boundary.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "reference/plane/critical/edge_directions.hpp"
#include "reference/plane/history/boundary_history.hpp"
#include "reference/plane/history/spans_on_line.hpp"

namespace minkref::inline plane {

/// Looks for edges with equal direction on one line when first asked, direction by direction.
/// Exact. Not for several threads at once.
class EdgesOnLines {
 public:
  /// Both must outlive it.
  EdgesOnLines(const std::vector<RationalEdge>& edges, const EdgeDirections& directions);

  /// The edges on the line of an edge at every scale that point the same way, itself included;
  /// ascending. O(n log n) for the first of n edges in a direction, then O(log n).
  std::span<const std::uint32_t> with(std::uint32_t edge);

  /// Adds to `to` the edges that run along a link just below a scale (or just above) and come to a
  /// point of the link: their common part has a length there, and tends to the point. Ascending.
  /// After the first call O(log n) per edge that may come near the point, if n edges share the
  /// line.
  void along(const MovingLink& link, const std::vector<Track>& tracks, const Rational& scale,
             bool above, const Point& point, std::vector<std::uint32_t>& to);

 private:
  /// A direction's edges, sorted by position across it.
  struct Lines {
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> first;  ///< of each line, and the end
    std::unordered_map<std::uint32_t, std::uint32_t> line_of_edge;
    std::unordered_map<std::uint32_t, SpansOnLine> spans;  ///< by line, where asked for
  };
  Lines& lines(std::uint32_t direction);
  const SpansOnLine& spans(std::uint32_t edge, std::span<const std::uint32_t> on_line);

  const std::vector<RationalEdge>& edges_;
  const EdgeDirections& directions_;
  std::vector<std::vector<std::uint32_t>> by_direction_;
  std::unordered_map<std::uint32_t, Lines> lines_;
};

}  // namespace minkref::inline plane
