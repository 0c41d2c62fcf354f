#include "reference/disc/distance/near_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace minkref::inline disc {
namespace {

constexpr int most_halvings = 4;
// Times the radius: quarter circles stay nearer to their chords.
constexpr double sagitta = 0.3;
// Error of a squared distance over the square of the largest coordinate: some hundred roundings.
constexpr double slack = 0x1p-44;

NearPoint enclosed(const Vector<Interval>& p) {
  const plane::Box box = box_of(p);
  return {{box.xmin, box.ymin, 0},
          plane::above(std::max(box.xmax - box.xmin, box.ymax - box.ymin))};
}

}  // namespace

NearEdges::NearEdges(const PatchesAt& at) : at_(at), radius_(at.radius().upper()) {
  std::vector<NearPoint> ends;
  std::vector<EdgeTree::Edge> edges;
  double most = radius_;
  for (std::uint32_t k = 0; k < at.curves().edges.size(); ++k) {
    const EdgeNumbers<Interval>& edge = at.edge(k);
    const plane::Box box = box_of(edge);
    edges.push_back({2 * k, 2 * k + 1});
    ends.push_back(enclosed(edge.start));
    ends.push_back(enclosed(edge.end));
    for (const double c : {box.xmin, box.ymin, box.xmax, box.ymax}) {
      most = std::max(most, std::abs(c));
    }
    const Spot start{approximate(edge.start.x), approximate(edge.start.y)},
        along{approximate(edge.along.x), approximate(edge.along.y)};
    const double square = along.x * along.x + along.y * along.y;
    edges_.push_back({start, along, square > 0 ? 1 / square : 0});  // a point alone has no length
  }
  tree_ = EdgeTree(std::move(ends), edges);
  squared_limit_ = at.radius().lower() * at.radius().lower() - slack * most * most;
}

void NearEdges::find(std::uint32_t patch, std::vector<std::uint32_t>& found) const {
  const OffsetPatch& own = at_.curves().patches[patch];
  const double bulge = own.edge == OffsetPatch::none ? sagitta * radius_ : 0;
  const NearPoint from = enclosed(at_.position(patch, PatchPlace::At::start)),
                  to = enclosed(at_.position(patch, PatchPlace::At::end));
  tree_.near(from, to, plane::above(radius_ + bulge), [&](std::uint32_t k) {
    found.push_back(k);
    return false;
  });
}

double NearEdges::squared_distance(std::uint32_t edge, const Spot& x) const {
  const Edge& e = edges_[edge];
  const double wx = x.x - e.start.x, wy = x.y - e.start.y;
  const double t = std::clamp((wx * e.along.x + wy * e.along.y) * e.inverse_square, 0.0, 1.0);
  const double dx = wx - t * e.along.x, dy = wy - t * e.along.y;
  return dx * dx + dy * dy;
}

bool NearEdges::is_inside(std::uint32_t patch) const {
  const OffsetPatch& own = at_.curves().patches[patch];
  const auto spot = [](const Vector<Interval>& p) -> Spot {
    return {approximate(p.x), approximate(p.y)};
  };
  if (own.edge != OffsetPatch::none) {
    return is_inside(patch,
                     {spot(at_.position(patch, PatchPlace::At::start)),
                      spot(at_.position(patch, PatchPlace::At::end))},
                     most_halvings);
  }
  const auto unit = [](const Direction& d) -> Spot {
    const double x = to_double(d.x), y = to_double(d.y), length = std::hypot(x, y);
    return {x / length, y / length};
  };
  return is_inside(patch, {unit(own.first), unit(own.last)}, most_halvings);
}

bool NearEdges::is_inside(std::uint32_t patch, const Part& part, int depth) const {
  const OffsetPatch& own = at_.curves().patches[patch];
  const bool is_arc = own.edge == OffsetPatch::none;
  std::array<Spot, 3> hull;
  Spot middle;
  Part left = part, right = part;
  if (is_arc) {
    const Spot centre{to_double(own.centre.x), to_double(own.centre.y)};
    const auto at = [&](const Spot& d, double far) -> Spot {
      return {centre.x + far * d.x, centre.y + far * d.y};
    };
    Spot d{part.first.x + part.last.x, part.first.y + part.last.y};
    const double length = std::hypot(d.x, d.y);
    d = {d.x / length, d.y / length};
    // The tangents at both ends meet beyond the middle, at the cosine of half the angle.
    hull = {at(part.first, radius_), at(part.last, radius_), at(d, radius_ * 2 / length)};
    middle = at(d, radius_);
    left.last = right.first = d;
  } else {
    middle = {(part.first.x + part.last.x) / 2, (part.first.y + part.last.y) / 2};
    hull = {part.first, part.last, middle};
    left.last = right.first = middle;
  }
  bool is_near = false;
  const NearPoint centre{{middle.x, middle.y, 0}, 0};
  const bool is_covered = tree_.near(centre, centre, radius_, [&](std::uint32_t k) {
    if (squared_distance(k, middle) >= squared_limit_) return false;
    is_near = true;
    return std::all_of(hull.begin(), hull.end(),
                       [&](const Spot& x) { return squared_distance(k, x) < squared_limit_; });
  });
  if (is_covered) return true;
  return is_near && depth > 0 && is_inside(patch, left, depth - 1) &&
         is_inside(patch, right, depth - 1);
}

}  // namespace minkref::inline disc
