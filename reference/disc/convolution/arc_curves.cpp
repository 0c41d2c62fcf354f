#include "reference/disc/convolution/arc_curves.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "reference/plane/lines.hpp"
#include "reference/plane/routes/simply_connected.hpp"

namespace minkref::inline disc {
namespace {

Direction outward(const Direction& along) { return {along.y, -along.x}; }
Direction opposite(const Direction& d) { return {-d.x, -d.y}; }
bool equal(const Direction& a, const Direction& b) { return a.x == b.x && a.y == b.y; }

/// Counter-clockwise from (1, 0).
bool has_less_angle(const Direction& a, const Direction& b) {
  const auto half = [](const Direction& d) { return d.y > 0 || (d.y == 0 && d.x > 0) ? 0 : 1; };
  const int of_a = half(a), of_b = half(b);
  return of_a != of_b ? of_a < of_b : cross(a, b) > 0;
}

struct DirectionLess {
  bool operator()(const Direction& a, const Direction& b) const { return has_less_angle(a, b); }
};

int quadrant_of(const Direction& d) {
  if (d.y >= 0 && d.x > 0) return 0;
  if (d.x <= 0 && d.y > 0) return 1;
  return d.y <= 0 && d.x < 0 ? 2 : 3;
}

/// A patch among the offset curves of P: its place along the carrier, and its direction.
struct PatchRange {
  std::uint32_t patch;
  int way;
  Rational low, high;     // of a line
  Direction first, last;  // of a circle
};

struct ConvolvedArc {
  Direction first, last;
  int sign;
};

struct ConvolvedEdge {
  Rational low, high;
  std::uint32_t low_circle, high_circle;
  int way;
};

class ConvolutionCurves {
 public:
  ConvolutionCurves(const Rational& squared_radius, bool is_region) : is_region_(is_region) {
    found_.squared_radius = squared_radius;
  }

  void add(const Ring& ring) {
    const std::size_t n = ring.size();
    if (n == 1) {
      full_.push_back(circle_about(ring[0]));
      return;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const Point &before = ring[(k + n - 1) % n], &own = ring[k], &next = ring[(k + 1) % n];
      add_edge(own, next);
      add_turn(own, from_to(before, own), from_to(own, next));
    }
  }

  void add_patches(const OffsetCurves& offset) {
    for (std::uint32_t k = 0; k < offset.patches.size(); ++k) {
      const OffsetPatch& patch = offset.patches[k];
      if (patch.edge == OffsetPatch::none) {
        const Direction first = primitive(patch.first), last = primitive(patch.last);
        ranges_[circle_about(patch.centre)].push_back({k, 1, 0, 0, first, last});
        continue;
      }
      const OffsetEdge& edge = offset.edges[patch.edge];
      const auto [line, way] = line_of(edge.start, edge.along);
      Rational low = along(line, edge.start), high = along(line, edge.end);
      if (way < 0) std::swap(low, high);
      ranges_[line].push_back({k, way, low, high, {}, {}});
    }
  }

  ArcCurves finish() {
    for (std::uint32_t k = 0; k < found_.carriers.size(); ++k) {
      if (found_.carriers[k].is_circle) {
        add_spans_of_circle(k);
      } else {
        add_spans_of_line(k);
      }
    }
    return std::move(found_);
  }

 private:
  std::uint32_t circle_about(const Point& p) {
    const auto [at, is_new] =
        circles_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(found_.carriers.size()));
    if (is_new) {
      ArcCarrier circle;
      circle.is_circle = true;
      circle.centre = p;
      circle.near_point = numbers<Interval>(p);
      found_.carriers.push_back(std::move(circle));
    }
    return at->second;
  }

  /// And whether the edge runs along its way (1) or back (-1).
  std::pair<std::uint32_t, int> line_of(const Point& start, const Direction& edge) {
    Direction way = primitive(edge);
    const int side = way.x > 0 || (way.x == 0 && way.y > 0) ? 1 : -1;
    if (side < 0) way = opposite(way);
    ArcCarrier line;
    line.way = way;
    line.squared_length = dot(way, way);
    line.squared_reach = found_.squared_radius * line.squared_length;
    line.level = way.y * start.x - way.x * start.y;
    line.side = side;
    if (const RootNumber reach = sqrt(RootNumber(line.squared_reach));
        reach.field()->roots() == 0) {
      line.level += side * reach.coefficients()[0];
      line.side = 0;
    }
    const auto [at, is_new] = lines_.try_emplace(
        {way.x, way.y, line.level, line.side}, static_cast<std::uint32_t>(found_.carriers.size()));
    if (is_new) {
      line.way_number =
          ways_.try_emplace({way.x, way.y}, static_cast<std::uint32_t>(ways_.size())).first->second;
      line.near_way = numbers<Interval>(way);
      line.near_point = numbers<Interval>(line.normal());
      line.near_level = Interval(line.level);
      line.near_reach = sqrt(Interval(line.squared_reach));
      line.near_squared_length = Interval(line.squared_length);
      found_.carriers.push_back(std::move(line));
    }
    return {at->second, side};
  }

  Rational along(std::uint32_t line, const Point& p) const {
    return dot(found_.carriers[line].way, {p.x, p.y});
  }

  void add_edge(const Point& from, const Point& to) {
    const auto [line, way] = line_of(from, from_to(from, to));
    ConvolvedEdge edge{along(line, from), along(line, to), circle_about(from), circle_about(to),
                       way};
    if (way < 0) {
      std::swap(edge.low, edge.high);
      std::swap(edge.low_circle, edge.high_circle);
    }
    edges_[line].push_back(std::move(edge));
  }

  void add_turn(const Point& at, const Direction& in, const Direction& out) {
    const Rational turn = cross(in, out);
    if (turn == 0 && dot(in, out) > 0) return;
    if (turn == 0 && is_region_) {
      throw std::logic_error("the boundary of a region turns back at one of its points");
    }
    const Direction from = primitive(outward(in)), to = primitive(outward(out));
    auto& arcs = arcs_[circle_about(at)];
    if (turn >= 0) {
      arcs.push_back({from, to, 1});
    } else {
      arcs.push_back({to, from, -1});
    }
  }

  std::uint32_t joint(std::uint32_t circle, const Direction& normal) {
    const auto [at, is_new] = joints_.try_emplace({circle, normal.x, normal.y},
                                                  static_cast<std::uint32_t>(found_.joints.size()));
    if (is_new) found_.joints.push_back({circle, normal});
    return at->second;
  }

  void add_spans_of_circle(std::uint32_t number) {
    std::vector<Direction> cuts{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const std::vector<ConvolvedArc>& arcs = arcs_[number];
    for (const ConvolvedArc& arc : arcs) {
      cuts.push_back(arc.first);
      cuts.push_back(arc.last);
    }
    for (const PatchRange& range : ranges_[number]) {
      cuts.push_back(range.first);
      cuts.push_back(range.last);
    }
    std::sort(cuts.begin(), cuts.end(), DirectionLess());
    cuts.erase(std::unique(cuts.begin(), cuts.end(), equal), cuts.end());
    const auto full = static_cast<int>(std::count(full_.begin(), full_.end(), number));
    std::vector<int> change(cuts.size() + 1, 0);
    change[0] = full;
    const auto place = [&](const Direction& d) {
      return std::lower_bound(cuts.begin(), cuts.end(), d, DirectionLess()) - cuts.begin();
    };
    for (const ConvolvedArc& arc : arcs) {
      const auto first = static_cast<std::size_t>(place(arc.first)),
                 last = static_cast<std::size_t>(place(arc.last));
      if (last < first) change[0] += arc.sign;
      change[first] += arc.sign;
      change[last] -= arc.sign;
    }
    int multiplicity = 0;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      multiplicity += change[k];
      if (multiplicity == 0) continue;
      const Direction &first = cuts[k], &last = cuts[(k + 1) % cuts.size()];
      ArcSpan span{number,
                   joint(number, first),
                   joint(number, last),
                   multiplicity,
                   patch_of_arc(number, first, multiplicity),
                   0,
                   0,
                   first,
                   last,
                   quadrant_of(first),
                   {},
                   {},
                   numbers<Interval>(first),
                   numbers<Interval>(last)};
      found_.spans.push_back(std::move(span));
    }
  }

  void add_spans_of_line(std::uint32_t number) {
    const std::vector<ConvolvedEdge>& edges = edges_[number];
    const Direction normal = found_.carriers[number].normal();
    std::map<Rational, std::pair<int, std::uint32_t>> cuts;  // what changes there, and a joint
    for (const ConvolvedEdge& edge : edges) {
      const Direction out = edge.way > 0 ? normal : opposite(normal);
      cuts.try_emplace(edge.low, 0, joint(edge.low_circle, out)).first->second.first += edge.way;
      cuts.try_emplace(edge.high, 0, joint(edge.high_circle, out)).first->second.first -= edge.way;
    }
    std::vector<PatchRange>& ranges = ranges_[number];
    std::sort(ranges.begin(), ranges.end(), [](const PatchRange& a, const PatchRange& b) {
      return a.way != b.way ? a.way < b.way : a.low < b.low;
    });
    int multiplicity = 0;
    for (auto cut = cuts.begin(); cut != cuts.end(); ++cut) {
      multiplicity += cut->second.first;
      if (multiplicity == 0) continue;
      const auto next = std::next(cut);
      ArcSpan span{number,
                   cut->second.second,
                   next->second.second,
                   multiplicity,
                   patch_of_edge(ranges, cut->first, next->first, multiplicity),
                   cut->first,
                   next->first,
                   {},
                   {},
                   0,
                   Interval(cut->first),
                   Interval(next->first),
                   {},
                   {}};
      found_.spans.push_back(std::move(span));
    }
  }

  std::uint32_t patch_of_arc(std::uint32_t circle, const Direction& from, int multiplicity) {
    if (multiplicity < 0) return OffsetPatch::none;
    for (const PatchRange& range : ranges_[circle]) {
      // A patch spans at most a right angle.
      if (cross(range.first, from) >= 0 && cross(from, range.last) > 0) return range.patch;
    }
    return OffsetPatch::none;
  }

  static std::uint32_t patch_of_edge(const std::vector<PatchRange>& ranges, const Rational& low,
                                     const Rational& high, int multiplicity) {
    const int way = multiplicity > 0 ? 1 : -1;
    const auto after = std::upper_bound(
        ranges.begin(), ranges.end(), std::pair(way, &low),
        [](const auto& value, const PatchRange& range) {
          return value.first != range.way ? value.first < range.way : *value.second < range.low;
        });
    if (after == ranges.begin()) return OffsetPatch::none;
    const PatchRange& last = *std::prev(after);
    return last.way == way && high <= last.high ? last.patch : OffsetPatch::none;
  }

  ArcCurves found_;
  bool is_region_;
  std::map<std::pair<Rational, Rational>, std::uint32_t> circles_, ways_;
  std::map<std::tuple<Rational, Rational, Rational, int>, std::uint32_t> lines_;
  std::map<std::tuple<std::uint32_t, Rational, Rational>, std::uint32_t> joints_;
  std::map<std::uint32_t, std::vector<ConvolvedArc>> arcs_;    // by circle
  std::map<std::uint32_t, std::vector<ConvolvedEdge>> edges_;  // by line
  std::map<std::uint32_t, std::vector<PatchRange>> ranges_;    // by carrier
  std::vector<std::uint32_t> full_;                            // circles about points
};

}  // namespace

ArcCurves arc_curves(const PolygonSet& P, const Rational& squared_radius,
                     const OffsetCurves& offset) {
  ConvolutionCurves curves(squared_radius, has_area(P));
  for (const Polygon& polygon : plane::cut_to_simply_connected(P).polygons) {
    curves.add(polygon.outer);
  }
  curves.add_patches(offset);
  return curves.finish();
}

}  // namespace minkref::inline disc
