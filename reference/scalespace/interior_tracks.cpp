#include "reference/scalespace/interior_tracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace minkref {
namespace {

constexpr std::size_t most_discs = 96;
constexpr int most_tries = 8;  // discs of one operand, for a stretch of scales
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
    if (settled(track, stretch.from, stretch.to, hints)) continue;
    if (stretch.halvings == most_halvings) return false;
    const double middle = std::sqrt(stretch.from) * std::sqrt(stretch.to);
    left[count++] = {middle, stretch.to, stretch.halvings + 1};
    left[count++] = {stretch.from, middle, stretch.halvings + 1};
  }
  return true;
}

bool InteriorTracks::settled(const RoundedTrack& track, double from, double to,
                             Hints& hints) const {
  // A disc c + r of P, scaled, is at s c + s r. What matters is x - s c = x0 + s (x1 - c), a
  // segment: its middle, and half its length.
  const double middle = (from + to) / 2, half = (to - from) / 2;
  const double slack = track.error * (1 + to);
  const auto of_P = [&](const Disc& disc, double& away) {
    const double ux = track.x1 - disc.x, uy = track.y1 - disc.y;
    away = to_Q_.below(track.x0 + middle * ux, track.y0 + middle * uy);
    return away - half * std::sqrt(ux * ux + uy * uy) * (1 + 0x1p-40) - slack +
           from * disc.radius * (1 - 0x1p-40);
  };
  if (find(of_P_, hints.of_P, [&](const Disc& disc, double reach, bool& hopeless) {
        double away;
        const double clearance = of_P(disc, away);
        hopeless = away + middle * reach <= 0;
        return clearance;
      })) {
    return true;
  }
  // Seen from sP, over s: x1 + (x0 - c) / s, again a segment.
  const double high = 1 / from, low = 1 / to, centre = (high + low) / 2,
               spread = (high - low) / 2 * (1 + 0x1p-40);
  const double relative_slack = track.error * (1 + high);
  return find(of_Q_, hints.of_Q, [&](const Disc& disc, double reach, bool& hopeless) {
    const double ux = track.x0 - disc.x, uy = track.y0 - disc.y;
    const double away = to_P_.below(track.x1 + centre * ux, track.y1 + centre * uy);
    hopeless = away + centre * reach <= 0;
    return away - spread * std::sqrt(ux * ux + uy * uy) * (1 + 0x1p-40) - relative_slack +
           low * disc.radius * (1 - 0x1p-40);
  });
}

/// Whether some disc has a positive clearance, among the first tries.
template <class Clearance>
bool InteriorTracks::find(const Tree& tree, std::uint32_t& hint, Clearance clearance) {
  const std::vector<Node>& nodes = tree.nodes();
  if (nodes.empty()) return false;
  bool hopeless = false;
  if (clearance(nodes[hint].disc, nodes[hint].reach, hopeless) > 0) return true;
  std::array<std::uint32_t, 64> stack;  // the tree is balanced
  std::size_t count = 0;
  stack[count++] = 0;
  for (int tries = 0; count > 0 && tries < most_tries; ++tries) {
    const std::uint32_t at = stack[--count];
    const Node& node = nodes[at];
    if (clearance(node.disc, node.reach, hopeless) > 0) {
      hint = at;
      return true;
    }
    if (hopeless) continue;
    if (node.right != 0) stack[count++] = node.right;
    if (node.left != 0) stack[count++] = node.left;
  }
  return false;
}

}  // namespace minkref
