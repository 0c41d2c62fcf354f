#include "reference/plane/index/interior_solids.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <tuple>

#include "reference/interrupt.hpp"
#include "reference/plane/lines.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t most_corners = 12;
constexpr std::size_t most_pieces = 256;    // of an operand
constexpr std::size_t most_samples = 1024;  // to choose by
constexpr std::size_t most_chosen = 192, most_chosen_at_once = 64,
                      most_chosen_of_use = 256;  // one holds at least that part of the samples
constexpr int tries_to_choose = 2000;            // to find a pair to choose
constexpr double doubt = 0x1p-40;

double size_of(const PolygonSet& set) {
  double size = 0;
  for (const Polygon& polygon : set.polygons) {
    for (const Point& p : polygon.outer) {
      size = std::max({size, std::fabs(to_double(p.x)), std::fabs(to_double(p.y))});
    }
  }
  return size;
}

Box box_of(const ConvexPiece& piece) {
  Box box;
  for (const auto& [x, y] : piece.corners) box.add({x, y, x, y});
  return box;
}

inline bool on_inner_side(double x, double y, double of_P, double of_Q, double margin,
                          const SweptQuad& q) {
  const double at_low = q.low * of_P + of_Q - margin;
  if (!(x * q.x[0] + y * q.y[0] < at_low && x * q.x[1] + y * q.y[1] < at_low)) return false;
  const double at_high = q.high * of_P + of_Q - margin;
  return x * q.x[2] + y * q.y[2] < at_high && x * q.x[3] + y * q.y[3] < at_high;
}

/// The extent of points at a scale.
struct Extent {
  double xmin, xmax, ymin, ymax, scale;

  bool within(const Box& of_P, const Box& of_Q) const {
    return scale * of_P.xmin + of_Q.xmin < xmin && xmax < scale * of_P.xmax + of_Q.xmax &&
           scale * of_P.ymin + of_Q.ymin < ymin && ymax < scale * of_P.ymax + of_Q.ymax;
  }
};

struct Extents {
  Extent low, high;

  explicit Extents(const SweptQuad& q)
      : low{std::min(q.x[0], q.x[1]), std::max(q.x[0], q.x[1]), std::min(q.y[0], q.y[1]),
            std::max(q.y[0], q.y[1]), q.low},
        high{std::min(q.x[2], q.x[3]), std::max(q.x[2], q.x[3]), std::min(q.y[2], q.y[3]),
             std::max(q.y[2], q.y[3]), q.high} {}
  bool within(const Box& of_P, const Box& of_Q) const {
    return low.within(of_P, of_Q) && high.within(of_P, of_Q);
  }
};

}  // namespace

InteriorSolids::Pieces::Pieces(const PolygonSet& set) : size(size_of(set)) {
  if (has_area(set)) all = convex_pieces(set, most_corners, most_pieces);
  for (const ConvexPiece& piece : all) {
    boxes.push_back(box_of(piece));
    areas.push_back(2 * piece.area());
    first.push_back(static_cast<std::uint32_t>(normals.size()));
    const auto& corners = piece.corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &a = corners[k], &b = corners[k + 1 == corners.size() ? 0 : k + 1];
      normals.push_back({b[1] - a[1], a[0] - b[0]});
      own.push_back(normals.back()[0] * a[0] + normals.back()[1] * a[1]);
    }
  }
  first.push_back(static_cast<std::uint32_t>(normals.size()));
  tree = BoxTree(boxes);
}

void InteriorSolids::Pieces::measure(const std::vector<ConvexPiece>& other) {
  others.reserve(normals.size() * other.size());
  for (const ConvexPiece& piece : other) {
    for (const auto& [x, y] : normals) others.push_back(piece.reach(x, y));
  }
}

InteriorSolids::InteriorSolids(const PolygonSet& P, const PolygonSet& Q) : P_(P), Q_(Q) {
  P_.measure(Q_.all);
  Q_.measure(P_.all);
}

double InteriorSolids::room_for(const SweptQuad& quad) const {
  return doubt * (quad.high * P_.size + Q_.size);
}

/// Calls look(pair) for pairs whose boxes hold the quad until look returns true, or `most` times.
template <class Look>
bool InteriorSolids::each_candidate(const SweptQuad& quad, int most, Look&& look) const {
  const Extents extents(quad);
  bool found = false;
  P_.tree.pairs_with(
      Q_.tree, [&](const Box& a, const Box& b) { return extents.within(a, b); },
      [&](std::uint32_t i, std::uint32_t j) {
        found = look(Pair{i, j});
        return found || --most <= 0;
      });
  return found;
}

bool InteriorSolids::holds(Pair pair, const SweptQuad& quad, double room) const {
  const auto margin = [&](const std::array<double, 2>& normal) {
    return (std::fabs(normal[0]) + std::fabs(normal[1])) * room + 1e-280;
  };
  const double* reach = P_.others.data() + pair.of_Q * P_.normals.size();
  for (std::uint32_t k = P_.first[pair.of_P]; k < P_.first[pair.of_P + 1]; ++k) {
    const auto& n = P_.normals[k];
    if (!on_inner_side(n[0], n[1], P_.own[k], reach[k], margin(n), quad)) return false;
  }
  reach = Q_.others.data() + pair.of_P * Q_.normals.size();
  for (std::uint32_t k = Q_.first[pair.of_Q]; k < Q_.first[pair.of_Q + 1]; ++k) {
    const auto& n = Q_.normals[k];
    if (!on_inner_side(n[0], n[1], reach[k], Q_.own[k], margin(n), quad)) return false;
  }
  return true;
}

/// Twice, at the scale.
double InteriorSolids::area(Pair pair, double scale) const {
  double mixed = 0;  // of the pieces, twice
  const double* reach = P_.others.data() + pair.of_Q * P_.normals.size();
  for (std::uint32_t k = P_.first[pair.of_P]; k < P_.first[pair.of_P + 1]; ++k) mixed += reach[k];
  return scale * (scale * P_.areas[pair.of_P] + mixed) + Q_.areas[pair.of_Q];
}

std::optional<InteriorSolids::Pair> InteriorSolids::largest_pair(const SweptQuad& quad) const {
  const double room = room_for(quad);
  std::optional<Pair> result;
  double largest = 0;
  each_candidate(quad, tries_to_choose, [&](Pair pair) {
    const double own = area(pair, quad.low);
    if (own > largest && holds(pair, quad, room)) {
      result = pair;
      largest = own;
    }
    return false;
  });
  return result;
}

std::size_t InteriorSolids::choose(const std::vector<SweptQuad>& samples) {
  if (P_.all.empty() || Q_.all.empty() || samples.empty()) return 0;
  const std::size_t count = std::min(samples.size(), most_samples);
  const auto sample = [&](std::size_t k) -> const SweptQuad& {
    return samples[k * samples.size() / count];
  };
  std::vector<Extents> extents;
  for (std::size_t k = 0; k < count; ++k) extents.emplace_back(sample(k));
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < count; ++k) {
    look_for_interrupt();
    if (const auto pair = largest_pair(sample(k))) pairs.push_back(*pair);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  using Held = std::bitset<most_samples>;
  std::vector<Held> held(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    look_for_interrupt();
    const Box &a = P_.boxes[pairs[i].of_P], &b = Q_.boxes[pairs[i].of_Q];
    for (std::size_t k = 0; k < count; ++k) {
      held[i][k] = extents[k].within(a, b) && holds(pairs[i], sample(k), room_for(sample(k)));
    }
  }
  Held left;
  left.set();
  std::size_t held_in_all = 0;
  const std::size_t most_now = std::min(chosen_.size() + most_chosen_at_once, most_chosen);
  while (chosen_.size() < most_now) {
    std::size_t best = 0, most = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const std::size_t own = (held[i] & left).count();
      if (own > most) {
        most = own;
        best = i;
      }
    }
    if (most == 0 || most * most_chosen_of_use < count) break;
    held_in_all += most;
    left &= ~held[best];
    chosen_.push_back(pairs[best]);
  }
  return held_in_all * samples.size() / count;
}

bool InteriorSolids::chosen_holds(const SweptQuad& quad, std::uint32_t& hint) const {
  if (chosen_.empty()) return false;
  const double room = room_for(quad);
  const Extents extents(quad);
  const auto is_held = [&](Pair pair) {
    return extents.within(P_.boxes[pair.of_P], Q_.boxes[pair.of_Q]) && holds(pair, quad, room);
  };
  if (hint < chosen_.size() && is_held(chosen_[hint])) return true;
  for (std::uint32_t k = 0; k < chosen_.size(); ++k) {
    if (!is_held(chosen_[k])) continue;
    hint = k;
    return true;
  }
  return false;
}

bool InteriorSolids::some_pair_holds(const SweptQuad& quad, int most_tries, Pair& hint) const {
  if (P_.all.empty() || Q_.all.empty()) return false;
  const double room = room_for(quad);
  if (holds(hint, quad, room)) return true;
  return each_candidate(quad, most_tries, [&](Pair pair) {
    if (!holds(pair, quad, room)) return false;
    hint = pair;
    return true;
  });
}

}  // namespace minkref::inline plane
