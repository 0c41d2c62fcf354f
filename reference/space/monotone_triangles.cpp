#include "reference/space/monotone_triangles.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/space/flat_face.hpp"

namespace minkref::inline space {
namespace {

using Corner = std::uint32_t;  // its place in the face

/// A face as a ring of corners: ordered from left to right, turning counter-clockwise.
class CornerRing {
 public:
  CornerRing(const Face& face, const VertexSigns& signs) : face_(face), flat_(face, signs) {}

  Corner size() const { return static_cast<Corner>(face_.size()); }
  Corner after(Corner k) const { return k + 1 == size() ? 0 : k + 1; }
  Corner before(Corner k) const { return k == 0 ? size() - 1 : k - 1; }
  std::uint32_t vertex(Corner k) const { return face_[k]; }
  bool is_before(Corner a, Corner b) const { return flat_.is_before(face_[a], face_[b]); }
  int turn(Corner a, Corner b, Corner c) const { return flat_.turn(face_[a], face_[b], face_[c]); }
  Integer seen_area(Corner a, Corner b, Corner c) const {
    return flat_.seen_area(face_[a], face_[b], face_[c]);
  }

 private:
  const Face& face_;
  FlatFace flat_;
};

/// Orders edges that run to the right, named after the first corner, from below upwards; and places
/// points among them.
struct BelowEachOther {
  const CornerRing* ring;
  struct Place {
    Corner corner;
  };
  using is_transparent = void;

  bool operator()(Corner a, Corner b) const {
    if (a == b) return false;
    const Corner a_end = ring->after(a), b_end = ring->after(b);
    if (ring->is_before(a, b)) {
      const int side = ring->turn(a, a_end, b);
      return (side != 0 ? side : ring->turn(a, a_end, b_end)) > 0;
    }
    const int side = ring->turn(b, b_end, a);
    return (side != 0 ? side : ring->turn(b, b_end, a_end)) < 0;
  }
  bool operator()(Corner a, Place p) const { return ring->turn(a, ring->after(a), p.corner) > 0; }
  bool operator()(Place p, Corner a) const { return ring->turn(a, ring->after(a), p.corner) < 0; }
};

/// The sweep. The lower edge names a region between two edges; the region's helper is the last
/// corner seen there.
class MonotoneCutting {
 public:
  explicit MonotoneCutting(const CornerRing& ring)
      : ring_(ring), edges_(BelowEachOther{&ring}), helper_(ring.size()), merges_(ring.size()) {}

  /// Returns false if the face proves not to be simple.
  bool run() {
    std::vector<Corner> order(ring_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](Corner a, Corner b) { return ring_.is_before(a, b); });
    for (const Corner v : order) {
      look_for_interrupt();
      if (!pass(v)) return false;
    }
    return true;
  }

  std::vector<std::pair<Corner, Corner>> diagonals;

 private:
  bool pass(Corner v) {
    const Corner from = ring_.before(v), to = ring_.after(v);
    const bool goes_on = ring_.is_before(v, to), comes = ring_.is_before(from, v);
    const bool is_convex = ring_.turn(from, v, to) > 0;
    merges_[v] = comes && !goes_on && !is_convex;
    if (comes && !close(v, from)) return false;
    const bool is_tip = comes != goes_on;  // both edges on one side
    if (goes_on && !comes && is_convex) return open(v);
    if (is_tip && is_convex) return true;
    // The corner borders the region above the next lower edge, unless the corner starts that edge.
    if (comes && goes_on) return open(v);
    const auto above = edges_.lower_bound(BelowEachOther::Place{v});
    if (above == edges_.begin()) return false;
    Corner& helper = helper_[*std::prev(above)];
    if (merges_[helper] || (goes_on && !comes)) diagonals.emplace_back(v, helper);
    helper = v;
    return !goes_on || open(v);
  }

  bool open(Corner v) {
    helper_[v] = v;
    return edges_.insert(v).second;
  }
  bool close(Corner v, Corner edge) {
    if (edges_.erase(edge) == 0) return false;
    if (merges_[helper_[edge]]) diagonals.emplace_back(v, helper_[edge]);
    return true;
  }

  const CornerRing& ring_;
  std::set<Corner, BelowEachOther> edges_;
  std::vector<Corner> helper_;
  std::vector<bool> merges_;  ///< corners at which two regions become one
};

/// The pieces between the diagonals. At each corner the spokes are the edge to the next corner and
/// the diagonals, counter-clockwise.
class DiagonalPieces {
 public:
  using Diagonals = std::vector<std::pair<Corner, Corner>>;

  DiagonalPieces(const CornerRing& ring, const Diagonals& diagonals)
      : ring_(ring), spokes_(ring.size()), places_(2 * diagonals.size()) {
    for (Corner v = 0; v < ring.size(); ++v) spokes_[v].push_back({ring.after(v), border});
    for (std::size_t d = 0; d < diagonals.size(); ++d) {
      spokes_[diagonals[d].first].push_back({diagonals[d].second, 2 * d});
      spokes_[diagonals[d].second].push_back({diagonals[d].first, 2 * d + 1});
    }
    for (Corner v = 0; v < ring.size(); ++v) {
      sort_spokes(v);
      for (std::size_t k = 1; k < spokes_[v].size(); ++k) places_[spokes_[v][k].end] = k;
    }
  }

  std::vector<std::vector<Corner>> pieces() const {
    std::vector<std::vector<bool>> seen;
    for (const auto& list : spokes_) seen.emplace_back(list.size());
    std::vector<std::vector<Corner>> result;
    for (Corner start = 0; start < ring_.size(); ++start) {
      for (std::size_t first = 0; first < spokes_[start].size(); ++first) {
        if (seen[start][first]) continue;
        std::vector<Corner>& piece = result.emplace_back();
        Corner v = start;
        for (std::size_t k = first; !seen[v][k];) {
          look_for_interrupt();
          seen[v][k] = true;
          piece.push_back(v);
          const Spoke& spoke = spokes_[v][k];
          v = spoke.to;
          // The next one clockwise; the edge from the corner before would be the last of all.
          k = (spoke.end == border ? spokes_[v].size() : places_[spoke.end ^ 1U]) - 1;
        }
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t border = SIZE_MAX;
  struct Spoke {
    Corner to;
    std::size_t end;  ///< of a diagonal, twice its number, and 1 at its other end; or `border`
  };

  void sort_spokes(Corner v) {
    std::vector<Spoke>& list = spokes_[v];
    const Corner first = list[0].to;
    const auto half = [&](Corner to) {
      const int turn = ring_.turn(v, first, to);
      return turn > 0 ? 0 : turn == 0 ? 1 : 2;
    };
    std::sort(list.begin() + 1, list.end(), [&](const Spoke& a, const Spoke& b) {
      const int of_a = half(a.to), of_b = half(b.to);
      return of_a != of_b ? of_a < of_b : ring_.turn(v, a.to, b.to) > 0;
    });
  }

  const CornerRing& ring_;
  std::vector<std::vector<Spoke>> spokes_;
  std::vector<std::size_t> places_;  ///< of each end of a diagonal, among the spokes there
};

/// Cuts monotone pieces, from left to right, with a stack of corners that wait until a later corner
/// sees them.
class PieceCutter {
 public:
  explicit PieceCutter(const CornerRing& ring) : ring_(ring) {}

  /// Returns false if a triangle's area is not positive.
  bool cut(const std::vector<Corner>& piece) {
    struct Step {
      Corner corner;
      bool is_below;  // on the lower chain
    };
    std::vector<Step> steps;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      steps.push_back({piece[k], ring_.is_before(piece[k], piece[(k + 1) % piece.size()])});
    }
    std::sort(steps.begin(), steps.end(),
              [&](const Step& a, const Step& b) { return ring_.is_before(a.corner, b.corner); });
    std::vector<Step> stack;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      look_for_interrupt();
      const Step step = steps[k];
      if (k > 1 && (k + 1 == steps.size() || step.is_below != stack.back().is_below)) {
        const Step last = stack.back();
        for (std::size_t j = 0; j + 1 < stack.size(); ++j) {
          if (!add(stack[j].corner, stack[j + 1].corner, step.corner)) return false;
        }
        stack = {last};
      }
      while (stack.size() > 1) {
        const Corner a = stack[stack.size() - 2].corner, b = stack.back().corner;
        const int turn = ring_.turn(a, b, step.corner);
        if (step.is_below ? turn <= 0 : turn >= 0) break;
        if (!add(a, b, step.corner)) return false;
        stack.pop_back();
      }
      stack.push_back(step);
    }
    return true;
  }

  std::vector<std::array<Corner, 3>> triangles;

 private:
  bool add(Corner a, Corner b, Corner c) {
    const int turn = ring_.turn(a, b, c);
    if (turn > 0) triangles.push_back({a, b, c});
    if (turn < 0) triangles.push_back({b, a, c});
    return turn != 0;
  }

  const CornerRing& ring_;
};

}  // namespace

std::optional<std::vector<TriangleCorners>> monotone_triangles(const Face& face,
                                                               const VertexSigns& signs) {
  const CornerRing ring(face, signs);
  MonotoneCutting cutting(ring);
  if (!cutting.run()) return std::nullopt;
  PieceCutter cutter(ring);
  for (const auto& piece : DiagonalPieces(ring, cutting.diagonals).pieces()) {
    if (!cutter.cut(piece)) return std::nullopt;
  }
  // Each turns as the face does: where there are as many as a face has and areas add up, none
  // covers another.
  if (cutter.triangles.size() + 2 != face.size()) return std::nullopt;
  Integer left = 0;
  std::vector<TriangleCorners> result;
  result.reserve(cutter.triangles.size());
  for (Corner k = 2; k < ring.size(); ++k) left += ring.seen_area(0, k - 1, k);
  for (const auto& [a, b, c] : cutter.triangles) {
    left -= ring.seen_area(a, b, c);
    result.push_back({ring.vertex(a), ring.vertex(b), ring.vertex(c)});
  }
  if (!left.is_zero()) return std::nullopt;
  return result;
}

}  // namespace minkref::inline space
