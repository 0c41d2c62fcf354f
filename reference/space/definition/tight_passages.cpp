#include "reference/space/definition/tight_passages.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/plane/boundary/canonical.hpp"
#include "reference/space/definition/body_search.hpp"
#include "reference/space/definition/exposed_facets.hpp"
#include "reference/space/definition/open_cones.hpp"
#include "reference/space/definition/open_intervals.hpp"
#include "reference/space/definition/summed_pieces.hpp"

namespace minkref::inline space {
namespace {

using Bodies = std::vector<std::uint32_t>;

struct Before {
  bool operator()(const SpacePoint& a, const SpacePoint& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};
constexpr Before before;

/// Coplanar facets, split by the side on which their bodies lie.
struct PlaneFacets {
  struct Facet {
    std::uint32_t body;
    const SumFacet* facet;
  };
  std::vector<Facet> with_body_below, with_body_above;
};

/// Segments of one line.
struct LineName {
  IntegerVector direction;
  SpacePoint moment;  ///< of a point of it, about the origin
  friend bool operator<(const LineName& a, const LineName& b) {
    if (!(a.direction == b.direction)) return a.direction < b.direction;
    return before(a.moment, b.moment);
  }
};
using PointPair = std::pair<SpacePoint, SpacePoint>;

class PassageSearch {
 public:
  explicit PassageSearch(const std::vector<SumBody>& bodies) : bodies_(bodies), search_(bodies) {}

  TightPassagesInSpace run() {
    find_open_facets();
    find_sheets();
    for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
      for (const SumFacet* facet : open_facets_[b]) {
        look_for_interrupt_now();
        look_across(b, *facet);
        for (const SolidCorner& corner : facet->ring) look_at(corner);
      }
    }
    join_lines();
    result_.points.assign(points_.begin(), points_.end());
    return std::move(result_);
  }

 private:
  Bodies near(const CornerRing& corners) const {
    Bodies found;
    search_.near(CornerBox(corners), [&](std::uint32_t b) { found.push_back(b); });
    return found;
  }

  /// Finds the facets that no other body's interior contains.
  void find_open_facets() {
    open_facets_.resize(bodies_.size());
    for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
      for (const SumFacet& facet : bodies_[b].facets) {
        look_for_interrupt();
        const Bodies others = near(facet.ring);
        const bool covered = std::any_of(others.begin(), others.end(), [&](std::uint32_t c) {
          return c != b && std::all_of(facet.ring.begin(), facet.ring.end(),
                                       [&](auto& corner) { return is_inside(corner, bodies_[c]); });
        });
        if (!covered) open_facets_[b].push_back(&facet);
      }
    }
  }

  void find_sheets() {
    std::map<OrientedPlane, PlaneFacets> planes;
    for (std::uint32_t b = 0; b < bodies_.size(); ++b) {
      for (const SumFacet* facet : open_facets_[b]) {
        const OrientedPlane& plane = facet->plane.plane();
        if (plane.normal < IntegerVector{0, 0, 0}) {
          planes[reversed(plane)].with_body_above.push_back({b, facet});
        } else {
          planes[plane].with_body_below.push_back({b, facet});
        }
      }
    }
    for (const auto& [plane, facets] : planes) {
      PolygonSet parts;
      for (const auto& below : facets.with_body_below) {
        for (const auto& above : facets.with_body_above) {
          look_for_interrupt();
          for (const CornerRing& ring : between(below, above)) {
            Ring flat;
            for (const SolidCorner& corner : ring) {
              flat.push_back(seen(exact_point(corner), viewing_axis(plane.normal)));
            }
            parts.polygons.push_back({std::move(flat), {}});
          }
        }
      }
      if (parts.polygons.empty()) continue;
      orient(parts);
      result_.sheets.push_back({plane, canonicalize(parts).region});
    }
  }

  /// The overlap of two coplanar facets with bodies on opposite sides, less the parts that other
  /// bodies cross.
  std::vector<CornerRing> between(const PlaneFacets::Facet& below,
                                  const PlaneFacets::Facet& above) {
    CornerRing shared = below.facet->ring;
    if (!CornerBox(shared).overlaps(bodies_[above.body])) return {};
    for (const SumFacet& facet : bodies_[above.body].facets) {
      if (&facet == above.facet) continue;
      const RingSides sides = sides_of(shared, facet.plane);
      if (!sides.below) return {};
      if (sides.above) shared = halves(shared, sides, facet.plane).below;
    }
    std::vector<CornerRing> parts{shared};
    for (const std::uint32_t b : near(shared)) {
      const bool crosses = std::none_of(bodies_[b].facets.begin(), bodies_[b].facets.end(),
                                        [&](const SumFacet& facet) {
                                          const RingSides sides = sides_of(shared, facet.plane);
                                          return !sides.above && !sides.below;
                                        });
      if (!crosses) continue;
      std::vector<CornerRing> rest;
      for (const CornerRing& part : parts) {
        for (CornerRing& outer : parts_outside(part, bodies_[b])) rest.push_back(std::move(outer));
      }
      parts = std::move(rest);
    }
    return parts;
  }

  /// Looks along the segments where a facet crosses other bodies' facets.
  void look_across(std::uint32_t own, const SumFacet& facet) {
    const Bodies others = near(facet.ring);
    for (const std::uint32_t b : others) {
      if (b == own) continue;
      for (const SumFacet* other : open_facets_[b]) {
        look_for_interrupt();
        auto segment = crossing(facet.ring, other->plane);
        if (segment && clip(*segment, bodies_[b])) look_along(*segment);
      }
    }
  }

  void look_along(const CornerSegment& segment) {
    const Bodies others = near({segment.from, segment.to});
    for (const CornerSegment& left : left_open(segment, bodies_, others)) {
      if (left.is_point()) {
        look_at(left.from);
      } else {
        for (const CornerSegment& piece : cut_at_bodies(left, bodies_, others)) look_about(piece);
      }
    }
  }

  /// A segment along which the same bodies meet.
  void look_about(const CornerSegment& piece) {
    const SolidCorner middle = middle_of(piece);
    const IntegerVector direction = direction_of(piece);
    if (!cover_all_about(direction, cones_at(middle))) return;
    const SpacePoint from = exact_point(piece.from), to = exact_point(piece.to);
    const IntegerVector& d = direction;
    const LineName name{d,
                        {from.y * d[2] - from.z * d[1], from.z * d[0] - from.x * d[2],
                         from.x * d[1] - from.y * d[0]}};
    lines_[name].push_back(before(from, to) ? PointPair(from, to) : PointPair(to, from));
  }

  void look_at(const SolidCorner& corner) {
    const SpacePoint point = exact_point(corner);
    if (!looked_at_.insert(point).second) return;
    const std::vector<Cone> cones = cones_at(corner);
    const bool inside = std::any_of(cones.begin(), cones.end(), [](auto& c) { return c.empty(); });
    if (!inside && cover_all(cones)) points_.insert(point);
  }

  /// The cones of all bodies that contain the point; a body with the point inside gives an empty
  /// cone.
  std::vector<Cone> cones_at(const SolidCorner& corner) const {
    std::vector<Cone> cones;
    for (const std::uint32_t b : near({corner})) {
      Cone cone;
      bool outside = false;
      for (const SumFacet& facet : bodies_[b].facets) {
        const int side = facet.plane.side(corner);
        outside = outside || side > 0;
        if (side == 0) cone.push_back(facet.plane.plane().normal);
      }
      if (!outside) cones.push_back(std::move(cone));
    }
    return cones;
  }

  /// Joins overlapping or consecutive segments on each line.
  void join_lines() {
    for (auto& [name, segments] : lines_) {
      std::sort(segments.begin(), segments.end(),
                [](const PointPair& a, const PointPair& b) { return before(a.first, b.first); });
      std::vector<PointPair> joined;
      for (const PointPair& segment : segments) {
        if (joined.empty() || before(joined.back().second, segment.first)) {
          joined.push_back(segment);
        } else if (before(joined.back().second, segment.second)) {
          joined.back().second = segment.second;
        }
      }
      result_.lines.insert(result_.lines.end(), joined.begin(), joined.end());
    }
    std::sort(result_.lines.begin(), result_.lines.end(),
              [](const PointPair& a, const PointPair& b) {
                if (!(a.first == b.first)) return before(a.first, b.first);
                return before(a.second, b.second);
              });
  }

  const std::vector<SumBody>& bodies_;
  BodySearch search_;
  std::vector<std::vector<const SumFacet*>> open_facets_;
  std::set<SpacePoint, Before> looked_at_, points_;
  std::map<LineName, std::vector<PointPair>> lines_;
  TightPassagesInSpace result_;
};

}  // namespace

std::string canonical_json(const TightPassagesInSpace& passages) {
  const auto point = [](const SpacePoint& p) {
    return "[\"" + to_string(p.x) + "\",\"" + to_string(p.y) + "\",\"" + to_string(p.z) + "\"]";
  };
  std::string text = R"({"lines":[)";
  for (const auto& [from, to] : passages.lines) {
    text += text.back() == '[' ? "[" : ",[";
    text += point(from) + ',' + point(to) + ']';
  }
  text += R"(],"points":[)";
  for (const SpacePoint& p : passages.points) {
    if (text.back() != '[') text += ',';
    text += point(p);
  }
  const std::string sheets = canonical_json(PolyhedralSet{passages.sheets});
  constexpr std::size_t name = std::char_traits<char>::length(R"({"planes":)");
  return text + R"(],"sheets":)" + sheets.substr(name);
}

TightPassagesInSpace tight_passages_in_space(const Polyhedron& P, const Polyhedron& Q,
                                             const Scaling& scaling) {
  const FloatEnvironment standard;
  return PassageSearch(summed_pieces(P, Q, scaling, most_pairs_for_passages, true)).run();
}

}  // namespace minkref::inline space
