#include "reference/plane/index/slice.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "reference/plane/boundary/canonical.hpp"
#include "reference/plane/index/piece_track.hpp"

namespace minkref::inline plane {
namespace {

struct BeforeAt {
  bool operator()(const Point& a, const Point& b) const {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

/// Directed segments between points, each once.
class Segments {
 public:
  void add(const Point& from, const Point& to) {
    const std::uint32_t i = number(from), j = number(to);
    if (i != j) segments_.emplace_back(i, j);
  }

  /// Closed walks that run along each segment once.
  PolygonSet rings() {
    std::sort(segments_.begin(), segments_.end());
    segments_.erase(std::unique(segments_.begin(), segments_.end()), segments_.end());
    std::vector<std::size_t> next(points_.size() + 1);
    for (const auto& [from, to] : segments_) ++next[from + 1];
    for (std::size_t k = 0; k < points_.size(); ++k) next[k + 1] += next[k];
    const std::vector<std::size_t> end(next.begin() + 1, next.end());
    PolygonSet result;
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const std::uint32_t start = segments_[k].first;
      while (next[start] < end[start]) {
        Ring ring;
        std::uint32_t at = start;
        do {
          ring.push_back(points_[at]);
          if (next[at] == end[at]) throw std::logic_error("the boundary of a slice is not closed");
          at = segments_[next[at]++].second;
        } while (at != start);
        result.polygons.push_back({std::move(ring), {}});
      }
    }
    return result;
  }

 private:
  std::uint32_t number(const Point& point) {
    const auto [place, fresh] =
        numbers_.try_emplace(point, static_cast<std::uint32_t>(points_.size()));
    if (fresh) points_.push_back(point);
    return place->second;
  }

  std::map<Point, std::uint32_t, BeforeAt> numbers_;
  std::vector<Point> points_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> segments_;
};

}  // namespace

Sum slice(const SweptBoundary& boundary, const Rational& scale) {
  const bool from_above = boundary.window.from && scale == *boundary.window.from;
  Segments segments;
  for (const ExposedPiece& piece : boundary.pieces) {
    const bool begun = from_above ? piece.lower <= scale : piece.lower < scale;
    if (!begun || (piece.upper && *piece.upper < scale)) continue;
    segments.add(track_of(boundary, piece.edge, piece.from).at(scale),
                 track_of(boundary, piece.edge, piece.to).at(scale));
  }
  Canonical found = canonicalize(segments.rings());
  return {std::move(found.region), found.components, found.holes, {}, std::nullopt};
}

}  // namespace minkref::inline plane
