#include "reference/scalespace/interior_tracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace minkref {
namespace {

constexpr std::size_t most_discs = 200;
constexpr int most_tries = 16;  // discs of one operand, for a stretch of scales
constexpr int most_halvings = 1;

PolygonSet region_or_nothing(const PolygonSet& set) { return set.is_region() ? set : PolygonSet{}; }

}  // namespace

InteriorTracks::Tree::Tree(std::vector<Disc> discs) {
  if (!discs.empty()) build(discs.begin(), discs.end());
}

std::uint32_t InteriorTracks::Tree::build(std::vector<Disc>::iterator first,
                                          std::vector<Disc>::iterator last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  std::iter_swap(first, std::max_element(first, last, [](const Disc& a, const Disc& b) {
                   return a.radius < b.radius;
                 }));
  Node node{*first, 0, 0, 0};
  double left = node.disc.x, right = left, bottom = node.disc.y, top = bottom;
  for (auto d = first; d != last; ++d) {
    node.reach =
        std::max(node.reach, std::hypot(d->x - node.disc.x, d->y - node.disc.y) + d->radius);
    left = std::min(left, d->x);
    right = std::max(right, d->x);
    bottom = std::min(bottom, d->y);
    top = std::max(top, d->y);
  }
  const bool by_x = right - left > top - bottom;
  std::sort(first + 1, last,
            [&](const Disc& a, const Disc& b) { return by_x ? a.x < b.x : a.y < b.y; });
  const auto middle = first + 1 + (last - first - 1) / 2;
  if (first + 1 < middle) node.left = build(first + 1, middle);
  if (middle < last) node.right = build(middle, last);
  nodes_[index] = node;
  return index;
}

InteriorTracks::InteriorTracks(const PolygonSet& P, const PolygonSet& Q)
    : regions_(P.is_region() && Q.is_region()),
      to_P_(region_or_nothing(P)),
      to_Q_(region_or_nothing(Q)),
      of_P_(to_P_.inscribed_discs(most_discs)),
      of_Q_(to_Q_.inscribed_discs(most_discs)) {}

bool InteriorTracks::certainly_inside(const RoundedTrack& track, double from, double to,
                                      Hints& hints) const {
  if (!regions_) return false;
  struct Stretch {
    double from, to;
    int halvings;
  };
  std::array<Stretch, most_halvings + 2> left;
  std::size_t count = 0;
  left[count++] = {from, to, 0};
  while (count > 0) {
    const Stretch stretch = left[--count];
    if (clearance(track, stretch.from, stretch.to, hints) > 0) continue;
    if (stretch.halvings == most_halvings) return false;
    const double middle = std::sqrt(stretch.from) * std::sqrt(stretch.to);
    left[count++] = {middle, stretch.to, stretch.halvings + 1};
    left[count++] = {stretch.from, middle, stretch.halvings + 1};
  }
  return true;
}

double InteriorTracks::clearance(const RoundedTrack& track, double from, double to,
                                 Hints& hints) const {
  if (!regions_) return -HUGE_VAL;
  // A disc c + r of P, scaled, is at s c + s r. What matters is x - s c = x0 + s (x1 - c), a
  // segment: its middle, and half its length.
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double slack =
      (track.reach0 + to * track.reach1) * (1 + 0x1p-40) + 2 * track.error * (1 + to);
  const auto of_P = [&](const Disc& disc, double& away) {
    const double ux = track.x1 - disc.x, uy = track.y1 - disc.y;
    away = to_Q_.below(track.x0 + middle * ux, track.y0 + middle * uy);
    return away - half * std::sqrt(ux * ux + uy * uy) * (1 + 0x1p-40) - slack +
           from * disc.radius * (1 - 0x1p-40);
  };
  const double by_P = find(of_P_, hints.of_P, [&](const Disc& disc, double reach, bool& hopeless) {
    double away;
    const double own = of_P(disc, away);
    hopeless = away + middle * reach <= 0;
    return own;
  });
  if (by_P > 0) return by_P;
  // Seen from sP, over s: x1 + (x0 - c) / s, again a segment.
  const double high = 1 / from, low = 1 / to, centre = (high + low) / 2,
               spread = (high - low) / 2 * (1 + 0x1p-40);
  const double relative_slack =
      (track.reach1 + high * track.reach0) * (1 + 0x1p-40) + 2 * track.error * (1 + high);
  const double by_Q = find(of_Q_, hints.of_Q, [&](const Disc& disc, double reach, bool& hopeless) {
    const double ux = track.x0 - disc.x, uy = track.y0 - disc.y;
    const double away = to_P_.below(track.x1 + centre * ux, track.y1 + centre * uy);
    hopeless = away + centre * reach <= 0;
    return away - spread * std::sqrt(ux * ux + uy * uy) * (1 + 0x1p-40) - relative_slack +
           low * disc.radius * (1 - 0x1p-40);
  });
  return by_Q > 0 ? by_Q : std::max(by_P, by_Q * middle);
}

/// The first positive clearance of a disc, among the first tries; else the greatest.
template <class Clearance>
double InteriorTracks::find(const Tree& tree, std::uint32_t& hint, Clearance clearance) {
  const std::vector<Node>& nodes = tree.nodes();
  if (nodes.empty()) return -HUGE_VAL;
  bool hopeless = false;
  double best = clearance(nodes[hint].disc, nodes[hint].reach, hopeless);
  if (best > 0) return best;
  std::array<std::uint32_t, 64> stack;  // the tree is balanced
  std::size_t count = 0;
  stack[count++] = 0;
  for (int tries = 0; count > 0 && tries < most_tries; ++tries) {
    const std::uint32_t at = stack[--count];
    const Node& node = nodes[at];
    const double own = clearance(node.disc, node.reach, hopeless);
    if (own > best) {
      best = own;
      hint = at;
      if (own > 0) return own;
    }
    if (hopeless) continue;
    if (node.right != 0) stack[count++] = node.right;
    if (node.left != 0) stack[count++] = node.left;
  }
  return best;
}

}  // namespace minkref
