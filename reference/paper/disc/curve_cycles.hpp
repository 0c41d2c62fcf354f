// Half-edge cycles around segments and arcs, in any arithmetic.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/paper/disc/placed_curves.hpp"

namespace minkref::inline disc {

/// Piece k is the half-edges 2 k, from its first node, and 2 k + 1, back. A cycle has one face on
/// its left. As exact as T; a cycle closes whatever the coordinates say.
template <class T>
class CurveCycles {
 public:
  explicit CurveCycles(const PlacedCurves<T>& placed) : placed_(placed) {
    sort_about_nodes();
    cycles_.assign(half_edges(), UINT32_MAX);
    for (std::uint32_t first = 0; first < half_edges(); ++first) {
      if (cycles_[first] != UINT32_MAX) continue;
      first_of_cycle_.push_back(first);
      for (std::uint32_t h = first; cycles_[h] == UINT32_MAX; h = next(h))
        cycles_[h] = cycles() - 1;
    }
  }

  const PlacedCurves<T>& placed() const { return placed_; }
  const CutCurve& curve(std::uint32_t h) const { return placed_.curves()[h / 2]; }
  std::uint32_t half_edges() const {
    return static_cast<std::uint32_t>(2 * placed_.curves().size());
  }
  std::uint32_t source(std::uint32_t h) const { return h % 2 == 0 ? curve(h).from : curve(h).to; }
  /// The next half-edge clockwise about the source.
  std::uint32_t clockwise(std::uint32_t h) const { return clockwise_[h]; }
  std::uint32_t next(std::uint32_t h) const { return clockwise_[h ^ 1U]; }
  std::uint32_t cycle(std::uint32_t h) const { return cycles_[h]; }
  std::uint32_t cycles() const { return static_cast<std::uint32_t>(first_of_cycle_.size()); }
  /// Whether a feature runs as the half-edge does.
  static bool runs_with(std::uint32_t h, const CutCurve::Cover& cover) {
    return cover.along == (h % 2 == 0);
  }
  template <class Visit>
  void for_each_half_edge(std::uint32_t cycle, Visit&& visit) const {
    std::uint32_t h = first_of_cycle_[cycle];
    do {
      visit(h);
      h = next(h);
    } while (h != first_of_cycle_[cycle]);
  }

 private:
  struct Leaving {
    std::uint32_t h;
    Vector<T> way;
    int bend;  ///< to the left (1), to the right (-1) or not
  };

  Leaving leaving(std::uint32_t h) const {
    const CutCurve& own = curve(h);
    const CutCurve::Cover& cover = own.covers[0];
    const MovingFeature<T>& feature = placed_.feature(cover.feature);
    const bool ahead = runs_with(h, cover);
    Vector<T> way = feature.is_arc ? turned(Vector<T>(placed_.place(source(h)) - feature.centre()))
                                   : feature.along;
    if (!ahead) way = {T(-way.x), T(-way.y)};
    return {h, way, !feature.is_arc ? 0 : ahead ? 1 : -1};
  }

  static int turn(const Leaving& a, const Leaving& b) { return sign(T(cross(a.way, b.way))); }

  /// Counter-clockwise from the first one.
  static void sort(std::vector<Leaving>& all) {
    const Leaving from = all[0];
    const auto part = [&](const Leaving& each) {
      if (each.h == from.h) return 0;
      const int turned_by = turn(from, each);
      if (turned_by != 0) return turned_by > 0 ? 1 : 3;
      return sign(T(dot(from.way, each.way))) > 0 ? 0 : 2;
    };
    std::vector<std::pair<int, Leaving>> parted;
    for (const Leaving& each : all) parted.emplace_back(part(each), each);
    std::sort(parted.begin(), parted.end(), [](const auto& a, const auto& b) {
      if (a.first != b.first) return a.first < b.first;
      if (a.second.h == b.second.h) return false;
      const int turned_by = a.first % 2 == 0 ? 0 : turn(a.second, b.second);
      return turned_by != 0 ? turned_by > 0 : a.second.bend < b.second.bend;
    });
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = parted[k].second;
  }

  void sort_about_nodes() {
    clockwise_.resize(half_edges());
    std::vector<std::vector<std::uint32_t>> leaving_of(placed_.nodes());
    for (std::uint32_t h = 0; h < half_edges(); ++h) leaving_of[source(h)].push_back(h);
    std::vector<Leaving> around;
    for (const std::vector<std::uint32_t>& some : leaving_of) {
      look_for_interrupt();
      if (some.empty()) continue;
      around.clear();
      for (const std::uint32_t h : some) around.push_back(leaving(h));
      if (around.size() > 2) sort(around);
      for (std::size_t k = 0; k < around.size(); ++k) {
        clockwise_[around[(k + 1) % around.size()].h] = around[k].h;
      }
    }
  }

  const PlacedCurves<T>& placed_;
  std::vector<std::uint32_t> clockwise_, cycles_, first_of_cycle_;
};

}  // namespace minkref::inline disc
