#include "reference/plane/lines.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/point_predicates.hpp"

namespace minkref::inline plane {
namespace {

/// A line: whether it is vertical, its slope, and where it meets an axis.
using LineName = std::tuple<bool, Rational, Rational>;

bool before(const Point& a, const Point& b) { return compare_xy(a, b) < 0; }

LineName line_through(const Point& a, const Point& b) {
  if (a.x == b.x) return {true, 0, a.x};
  const Rational slope = (b.y - a.y) / (b.x - a.x);
  return {false, slope, a.y - slope * a.x};
}

Rational cross(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

BoxTree tree_of(const std::vector<BareSegment>& segments) {
  std::vector<Box> boxes;
  for (const BareSegment& segment : segments) {
    const FilteredPoint from(segment.from), to(segment.to);
    Box box{from.x(), from.y(), from.x(), from.y()};
    box.add({to.x(), to.y(), to.x(), to.y()});
    boxes.push_back(box);  // rounding is monotone: exact overlaps remain overlaps
  }
  return BoxTree(std::move(boxes));
}

/// Maximal segments of one line, from segments along it.
void join_along(std::vector<BareSegment>& along, std::vector<BareSegment>& found) {
  std::sort(along.begin(), along.end(),
            [](const auto& a, const auto& b) { return before(a.from, b.from); });
  for (std::size_t k = 0; k < along.size(); ++k) {
    look_for_interrupt();
    if (k == 0 || before(found.back().to, along[k].from)) {
      found.push_back(std::move(along[k]));
    } else if (before(found.back().to, along[k].to)) {
      found.back().to = std::move(along[k].to);
    }
  }
}

bool is_on(const BareSegment& segment, const Point& p) {
  return !before(p, segment.from) && !before(segment.to, p) &&
         cross(segment.from, segment.to, p) == 0;
}

/// Notes where two maximal segments meet, on each.
void add_contact(const BareSegment& a, const BareSegment& b, std::vector<Point>& of_a,
                 std::vector<Point>& of_b) {
  const Rational from_b = cross(a.from, a.to, b.from), to_b = cross(a.from, a.to, b.to);
  const Rational from_a = cross(b.from, b.to, a.from), to_a = cross(b.from, b.to, a.to);
  if (sign(from_b) * sign(to_b) > 0 || sign(from_a) * sign(to_a) > 0) return;
  if (from_b == to_b) return;  // parallel: maximal ones are apart
  const Rational t = from_b / (from_b - to_b);
  const Point at{b.from.x + t * (b.to.x - b.from.x), b.from.y + t * (b.to.y - b.from.y)};
  of_a.push_back(at);
  of_b.push_back(at);
}

}  // namespace

bool is_thin(const PolygonSet& set) {
  return !set.empty() && (set.polygons[0].outer.size() == 1 || set.polygons[0].outer.size() == 2);
}

bool has_area(const PolygonSet& set) { return !set.empty() && !is_thin(set); }

bool is_lines(const PolygonSet& set) { return set.polygons.size() > 1 && is_thin(set); }

std::vector<BareSegment> joined(std::vector<BareSegment> segments) {
  std::map<LineName, std::vector<BareSegment>> lines;
  std::vector<BareSegment> found, points;
  for (BareSegment& segment : segments) {
    look_for_interrupt();
    if (segment.from == segment.to) {
      points.push_back(std::move(segment));
    } else {
      lines[line_through(segment.from, segment.to)].push_back(std::move(segment));
    }
  }
  for (auto& [line, along] : lines) join_along(along, found);
  const BoxTree tree = tree_of(found);
  const std::size_t whole = found.size();
  for (BareSegment& point : points) {
    const FilteredPoint at(point.from);
    const bool is_covered = tree.query({at.x(), at.y(), at.x(), at.y()}, [&](std::uint32_t k) {
      return k < whole && is_on(found[k], point.from);
    });
    if (!is_covered) found.push_back(std::move(point));
  }
  std::sort(found.begin(), found.end(), [](const BareSegment& a, const BareSegment& b) {
    const int first = compare_xy(a.from, b.from);
    return first != 0 ? first < 0 : before(a.to, b.to);
  });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<BareSegment> cut_at_contacts(const std::vector<BareSegment>& segments) {
  std::vector<std::vector<Point>> cuts(segments.size());
  tree_of(segments).pairs([&](std::uint32_t i, std::uint32_t j) {
    look_for_interrupt();
    add_contact(segments[i], segments[j], cuts[i], cuts[j]);
  });
  std::vector<BareSegment> parts;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    std::vector<Point>& at = cuts[k];
    at.push_back(segments[k].from);
    at.push_back(segments[k].to);
    std::sort(at.begin(), at.end(), before);
    at.erase(std::unique(at.begin(), at.end()), at.end());
    if (at.size() == 1) parts.push_back({at[0], at[0]});
    for (std::size_t i = 1; i < at.size(); ++i) parts.push_back({at[i - 1], at[i]});
  }
  return parts;
}

std::vector<BareSegment> segments_of(const PolygonSet& lines) {
  std::vector<BareSegment> segments;
  for (const Polygon& part : lines.polygons) {
    const Point &a = part.outer.front(), &b = part.outer.back();
    segments.push_back(before(b, a) ? BareSegment{b, a} : BareSegment{a, b});
  }
  return segments;
}

PolygonSet lines_of(const std::vector<BareSegment>& segments) {
  PolygonSet lines;
  for (const BareSegment& each : segments) {
    Ring ends{each.from};
    if (each.to != each.from) ends.push_back(each.to);
    lines.polygons.push_back({std::move(ends), {}});
  }
  return lines;
}

PolygonSet joined_lines(const PolygonSet& set) {
  return is_lines(set) ? lines_of(joined(segments_of(set))) : set;
}

PolygonSet cut_lines(const PolygonSet& set) {
  return is_lines(set) ? lines_of(cut_at_contacts(joined(segments_of(set)))) : set;
}

}  // namespace minkref::inline plane
