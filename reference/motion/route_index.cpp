#include <algorithm>

#include "reference/motion/path_cuts.hpp"
#include "reference/motion/path_edges.hpp"
#include "reference/motion/routes.hpp"
#include "reference/plane/index/scale_index.hpp"
#include "reference/plane/location.hpp"
#include "reference/plane/moving/interior_test.hpp"

namespace minkref::inline motion {
namespace {

void add_rings(const PolygonSet& set, std::vector<Segment>& segments) {
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      segments.push_back({ring[i], ring[(i + 1) % ring.size()]});
    }
  };
  for (const Polygon& polygon : set.polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
}

bool on_passage(const Point& p, const std::vector<TightPassage>& passages) {
  for (const TightPassage& passage : passages) {
    for (std::size_t i = 0; i < passage.points.size(); ++i) {
      const Point &a = passage.points[i],
                  &b = passage.points[std::min(i + 1, passage.points.size() - 1)];
      const Point u{a.x - p.x, a.y - p.y}, v{b.x - p.x, b.y - p.y};
      if (u.x * v.y == u.y * v.x && u.x * v.x + u.y * v.y <= 0) return true;
    }
  }
  return false;
}

/// The sums of an index, for the question whether the path meets them.
class IndexedSums {
 public:
  IndexedSums(const PathProblem& problem, PolygonSet turned)
      : problem_(problem),
        turned_(std::move(turned)),
        index_(turned_, problem.obstacles, problem.window),
        inside_(turned_, problem.obstacles) {}

  const ScaleIndex& index() const { return index_; }

  bool meet_path(const Rational& scale) const {
    const PolygonSet region = index_.sum(scale).region;
    std::vector<Segment> segments;
    add_rings(region, segments);
    PathCuts points = path_cuts(problem_.path, segments);
    if (problem_.rule == ContactRule::forbidden) {
      const auto meets = [&](const Point& p) { return locate(region, p) != Location::outside; };
      return std::any_of(points.between.begin(), points.between.end(), meets) ||
             std::any_of(points.cuts.begin(), points.cuts.end(), meets);
    }
    const auto is_in_region = [&](const Point& p) { return locate(region, p) == Location::inside; };
    if (std::none_of(points.between.begin(), points.between.end(), is_in_region) &&
        std::none_of(points.cuts.begin(), points.cuts.end(), is_in_region)) {
      return false;
    }
    // Inside the closed sum; still valid if the points lie along tight passages only.
    const auto collides = [&](const Point& p) {
      return is_in_region(p) && inside_.inside(p, scale);
    };
    if (std::any_of(points.between.begin(), points.between.end(), collides)) return true;
    const std::vector<TightPassage> passages = tight_passages(turned_, problem_.obstacles, scale);
    for (const TightPassage& passage : passages) {
      for (std::size_t i = 0; i < passage.points.size(); ++i) {
        const std::size_t next = std::min(i + 1, passage.points.size() - 1);
        segments.push_back({passage.points[i], passage.points[next]});
      }
    }
    points = path_cuts(problem_.path, segments);
    const auto is_off = [&](const Point& p) { return is_in_region(p) && !on_passage(p, passages); };
    return std::any_of(points.between.begin(), points.between.end(), is_off) ||
           std::any_of(points.cuts.begin(), points.cuts.end(), is_off);
  }

 private:
  const PathProblem& problem_;
  PolygonSet turned_;
  ScaleIndex index_;
  InteriorTest inside_;
};

/// The scales at which the sums' boundary starts or stops meeting the path: the index's events, and
/// scales from the ends of its links.
std::vector<Rational> meetings_with(const ScaleIndex& index, const std::vector<Point>& path) {
  std::vector<Rational> scales;
  for (std::uint32_t k = 0; k < index.events(); ++k) scales.push_back(index.event(k));
  const std::size_t events = scales.size();
  for (const IndexLink& link : index.columns().links) {
    PathEdge edge{index.track(link.from), index.track(link.to), {}};
    const Rational from = link.first == 0 ? Rational(0) : scales[link.first - 1];
    std::optional<Rational> to;
    if (link.last < events) to = scales[link.last];
    const Rational middle = to ? Rational((from + *to) / 2) : Rational(from + 1);
    const Point a = edge.from.at(middle), b = edge.to.at(middle);
    edge.along = {b.x - a.x, b.y - a.y};
    const std::size_t before = scales.size();
    add_meeting_scales(edge, path, scales);
    scales.erase(std::remove_if(scales.begin() + static_cast<std::ptrdiff_t>(before), scales.end(),
                                [&](const Rational& s) { return s < from || (to && s > *to); }),
                 scales.end());
  }
  return scales;
}

}  // namespace

ScaleSet collisions_by_index(const PathProblem& problem, PathStatistics& statistics) {
  const IndexedSums sums(problem, half_turned(problem.part));
  std::vector<Rational> critical = meetings_with(sums.index(), problem.path);
  // An opening at a single scale leaves no trace on the closed sums' boundary.
  if (problem.rule == ContactRule::allowed) {
    for (const PathEdge& edge : contact_edges(problem.part, problem.obstacles)) {
      add_meeting_scales(edge, problem.path, critical);
    }
  }
  return decided_at(std::move(critical), problem.window, [&](const Rational& scale) {
    ++statistics.critical_scales;
    return sums.meet_path(scale);
  });
}

}  // namespace minkref::inline motion
