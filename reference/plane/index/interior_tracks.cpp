#include "reference/plane/index/interior_tracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "reference/plane/lines.hpp"

namespace minkref::inline plane {
namespace {

constexpr std::size_t most_discs = 800;
constexpr int most_tries = 16;  // discs of one operand, for a stretch of scales
constexpr int most_halvings_of_a_track = 1;

PolygonSet region_or_nothing(const PolygonSet& set) { return has_area(set) ? set : PolygonSet{}; }

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
    : regions_(has_area(P) && has_area(Q)),
      to_P_(region_or_nothing(P)),
      to_Q_(region_or_nothing(Q)),
      of_P_(to_P_.inscribed_discs(most_discs)),
      of_Q_(to_Q_.inscribed_discs(most_discs)) {}

bool InteriorTracks::certainly_inside(const RoundedTrack& track, double from, double to,
                                      Hints& hints) const {
  if (!regions_) return false;
  struct Part {
    double from, to;
    int halvings;
  };
  std::array<Part, most_halvings_of_a_track + 2> left;
  std::size_t count = 0;
  left[count++] = {from, to, 0};
  while (count > 0) {
    const Part part = left[--count];
    if (clearance(track, part.from, part.to, hints) > 0) continue;
    if (part.halvings == most_halvings_of_a_track) return false;
    const double middle = std::sqrt(part.from) * std::sqrt(part.to);
    left[count++] = {middle, part.to, part.halvings + 1};
    left[count++] = {part.from, middle, part.halvings + 1};
  }
  return true;
}

/// A disc c + r of P, scaled, becomes s c + s r. The difference x - s c = x0 + s (x1 - c) forms a
/// segment: only its middle and half its length matter. For a disc of Q, seen from sP, over s, the
/// segment is x1 + (x0 - c) / s.
InteriorTracks::Stretch::Stretch(const RoundedTrack& track, double from, double to,
                                 bool is_seen_from_P) {
  const double low = is_seen_from_P ? 1 / to : from, high = is_seen_from_P ? 1 / from : to;
  middle = (low + high) / 2;
  half = (high - low) / 2 * (1 + 0x1p-40);
  least = low * (1 - 0x1p-40);
  const auto off = [&](double constant, double moving) {
    return (constant + high * moving) * (1 + 0x1p-40) + 2 * track.error * (1 + high);
  };
  slack = is_seen_from_P ? off(track.reach1, track.reach0) : off(track.reach0, track.reach1);
  x0 = is_seen_from_P ? track.x1 : track.x0;
  y0 = is_seen_from_P ? track.y1 : track.y0;
  x1 = is_seen_from_P ? track.x0 : track.x1;
  y1 = is_seen_from_P ? track.y0 : track.y1;
}

InteriorTracks::Reach InteriorTracks::reach_of(const Disc& disc, const Stretch& s,
                                               const SignedDistance& to_other) {
  const double ux = s.x1 - disc.x, uy = s.y1 - disc.y;
  const double away = to_other.below(s.x0 + s.middle * ux, s.y0 + s.middle * uy);
  const double lost = s.half * std::sqrt(ux * ux + uy * uy) * (1 + 0x1p-40) + s.slack;
  return {away, away - lost + s.least * disc.radius,
          away + lost + (s.least + 2 * s.half) * disc.radius};
}

double InteriorTracks::clearance(const RoundedTrack& track, double from, double to,
                                 Hints& hints) const {
  if (!regions_) return -HUGE_VAL;
  const auto best_of = [&](const Tree& tree, std::uint32_t& hint, const SignedDistance& to_other,
                           const Stretch& stretch) {
    return find(tree, hint, [&](const Disc& disc, double reach, bool& hopeless) {
      const Reach own = reach_of(disc, stretch, to_other);
      hopeless = own.away + stretch.middle * reach <= 0;
      return own.clearance;
    });
  };
  const Stretch of_P(track, from, to, false);
  const double by_P = best_of(of_P_, hints.of_P, to_Q_, of_P);
  if (by_P > 0) return by_P;
  const double by_Q = best_of(of_Q_, hints.of_Q, to_P_, Stretch(track, from, to, true));
  return by_Q > 0 ? by_Q : std::max(by_P, by_Q * of_P.middle);
}

InteriorTracks::Discs InteriorTracks::all_discs() const {
  Discs result;
  if (!regions_) return result;
  result.of_P.resize(of_P_.nodes().size());
  result.of_Q.resize(of_Q_.nodes().size());
  std::iota(result.of_P.begin(), result.of_P.end(), 0U);
  std::iota(result.of_Q.begin(), result.of_Q.end(), 0U);
  return result;
}

bool InteriorTracks::some_disc_holds(const RoundedTrack& track, double from, double to,
                                     const Discs& discs, Discs& hopeful) const {
  const auto try_all = [&](const Tree& tree, const SignedDistance& to_other, bool is_seen_from_P,
                           const std::vector<std::uint32_t>& among,
                           std::vector<std::uint32_t>& kept) {
    const Stretch stretch(track, from, to, is_seen_from_P);
    kept.clear();
    for (const std::uint32_t k : among) {
      const Reach own = reach_of(tree.nodes()[k].disc, stretch, to_other);
      if (own.clearance > 0) return true;
      if (own.most > 0) kept.push_back(k);
    }
    return false;
  };
  return regions_ && (try_all(of_P_, to_Q_, false, discs.of_P, hopeful.of_P) ||
                      try_all(of_Q_, to_P_, true, discs.of_Q, hopeful.of_Q));
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

}  // namespace minkref::inline plane
