#include "reference/plane/index/patch_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/build/stage.hpp"
#include "reference/plane/critical/moving_pairs.hpp"
#include "reference/plane/index/patch_cells.hpp"

namespace minkref::inline plane {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The data that all threads look at.
struct Subject {
  const InteriorTracks& tracks;
  InteriorSolids& solids;
  std::vector<RoundedEdge> edges;
  PatchCells cells;
  std::vector<std::uint32_t> live;  ///< edges that have a cell
  std::vector<char> wanted;         ///< of these; empty: all
  double from = 0, to = infinity;
  double length = 0, size = 0;  ///< the greatest coordinates, of directions and of points

  Subject(const InteriorTracks& own_tracks, InteriorSolids& own_solids,
          const std::vector<RationalEdge>& given, const ScaleWindow& window,
          const BuildControl& control, const std::vector<Kept>& kept)
      : tracks(own_tracks), solids(own_solids) {
    if (window.from) from = to_double(*window.from) * (1 - 0x1p-50);
    if (window.to) to = to_double(*window.to) * (1 + 0x1p-50);
    for (const RationalEdge& e : given) edges.push_back(rounded(e));
    cells = kept.empty() ? patch_cells(tracks, solids, edges, from, to, control)
                         : cells_beside(kept, control);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (cells.of(e).empty()) continue;
      live.push_back(e);
      if (!kept.empty()) wanted.push_back(kept[e] == Kept::no ? 1 : 0);
      const RoundedEdge& r = edges[e];
      length = std::max({length, std::fabs(r.dx), std::fabs(r.dy)});
      size = std::max({size, std::fabs(r.px), std::fabs(r.py), std::fabs(r.qx), std::fabs(r.qy)});
    }
  }

  /// A kept edge that is not inside gets its whole patch as a cell.
  PatchCells cells_beside(const std::vector<Kept>& kept, const BuildControl& control) {
    std::vector<RoundedEdge> asked;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (kept[e] == Kept::no) asked.push_back(edges[e]);
    }
    const PatchCells found = patch_cells(tracks, solids, asked, from, to, control);
    PatchCells result;
    std::uint32_t next = 0;
    for (const Kept of : kept) {
      result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
      if (of == Kept::live) result.cells.push_back({from, to, 0, 1});
      if (of != Kept::no) continue;
      const auto own = found.of(next++);
      result.cells.insert(result.cells.end(), own.begin(), own.end());
    }
    result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
    return result;
  }

  std::vector<RoundedEdge> live_edges() const {
    std::vector<RoundedEdge> result;
    for (const std::uint32_t k : live) result.push_back(edges[k]);
    return result;
  }
};

/// One thread's pairs a < b.
struct Found {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept;
  std::uint64_t meeting = 0, inside = 0, looked_at = 0;
};

class NeighbourSearch {
 public:
  NeighbourSearch(const Subject& subject, const MovingPairs& pairs, const BuildControl& control,
                  Found& found)
      : subject_(subject), pairs_(pairs), control_(control), error_(pairs.error()), found_(found) {}

  /// Finds all pairs of a block's live edges with each other and with later ones.
  void operator()(std::size_t block) {
    hints_ = {};
    pairs_.of_block(
        static_cast<std::uint32_t>(block), room_,
        [&](std::uint32_t a, std::uint32_t b) { look(subject_.live[a], subject_.live[b]); });
  }

 private:
  void look(std::uint32_t i, std::uint32_t j) {
    control_.look();
    ++found_.looked_at;
    const RoundedEdge &a = subject_.edges[i], &b = subject_.edges[j];
    const PairRange range = pair_range(a, b, subject_.from, subject_.to, error_);
    if (range.is_empty()) return;
    if (range.is_parallel) {
      if (are_apart(a, b)) return;
      ++found_.meeting;
    } else {
      ++found_.meeting;
      if (range.low > 0 && range.high < infinity && meets_inside(i, j, range)) {
        ++found_.inside;
        return;
      }
    }
    found_.kept.emplace_back(i, j);
  }

  /// Whether two edges certainly meet inside the sum only.
  bool meets_inside(std::uint32_t i, std::uint32_t j, const PairRange& range) {
    const auto [c, a_slope, a_value, b_slope, b_value, low, high, is_parallel] = range;
    if (!passes_cell(i, a_slope, a_value, c, low, high) ||
        !passes_cell(j, b_slope, b_value, c, low, high)) {
      return true;
    }
    const RoundedEdge& a = subject_.edges[i];
    const double slope = a_slope / c, value = a_value / c;
    const double ratio = std::max(std::fabs(slope), std::fabs(value));
    const RoundedTrack track{a.qx + value * a.dx, a.qy + value * a.dy, a.px + slope * a.dx,
                             a.py + slope * a.dy,
                             subject_.length * (error_ * (2 + 2 * ratio) / c) +
                                 0x1p-48 * (subject_.size + ratio * subject_.length)};
    return subject_.tracks.certainly_inside(track, low, high, hints_);
  }

  /// slope s + value > 0 throughout the window, by far more than the errors of both.
  bool is_positive(double slope, double value) const {
    const double doubt = 256 * error_;
    const auto positive_at = [&](double s) { return slope * s + value > doubt * (1 + s); };
    return positive_at(subject_.from) &&
           (subject_.to < infinity ? positive_at(subject_.to) : slope > doubt);
  }

  /// Whether edges of nearly one direction certainly never meet: `b` stays on one side of the line
  /// of `a`, or before its start or behind its end. A turn as small as here moves the far end of
  /// `b` by less than the doubt.
  bool are_apart(const RoundedEdge& a, const RoundedEdge& b) const {
    const double px = b.px - a.px, py = b.py - a.py, qx = b.qx - a.qx, qy = b.qy - a.qy;
    const double side = px * a.dy - py * a.dx, side_value = qx * a.dy - qy * a.dx;
    if (is_positive(side, side_value) || is_positive(-side, -side_value)) return true;
    const double start = px * a.dx + py * a.dy, start_value = qx * a.dx + qy * a.dy;
    const double length = a.dx * a.dx + a.dy * a.dy, step = b.dx * a.dx + b.dy * a.dy;
    const double end = b.is_s ? start + step : start, end_value = start_value + (b.is_s ? 0 : step);
    if (is_positive(-start, -start_value) && is_positive(-end, -end_value)) return true;
    const auto beyond = [&](double slope, double value) {
      return a.is_s ? is_positive(slope - length, value) : is_positive(slope, value - length);
    };
    return beyond(start, start_value) && beyond(end, end_value);
  }

  /// Whether the other edge's line may pass a cell of this edge: at (slope s + value) / c along the
  /// edge, over s for an S-edge.
  bool passes_cell(std::uint32_t edge, double slope, double value, double c, double low,
                   double high) const {
    const bool is_s = subject_.edges[edge].is_s;
    const auto along = [&](double s) { return (slope * s + value) / (is_s ? c * s : c); };
    const double doubt = 4 * error_ * (1 + high) / (is_s ? c * low : c) + 0x1p-40;
    for (const PatchCell& cell : subject_.cells.of(edge)) {
      const double begin = std::max(low, cell.low), end = std::min(high, cell.high);
      if (begin > end) continue;
      const double u = along(begin), v = along(end);  // monotone between the two
      if (std::min(u, v) <= cell.to + doubt && std::max(u, v) >= cell.from - doubt) return true;
    }
    return false;
  }

  const Subject& subject_;
  const MovingPairs& pairs_;
  const BuildControl& control_;
  double error_;
  Found& found_;
  InteriorTracks::Hints hints_;
  std::vector<std::uint32_t> room_;
};

PatchNeighbours listed(std::vector<Found>& all, std::size_t count) {
  PatchNeighbours result;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (Found& found : all) {
    result.meeting += found.meeting;
    result.inside += found.inside;
    result.looked_at += found.looked_at;
    pairs.insert(pairs.end(), found.kept.begin(), found.kept.end());
    found.kept = {};
  }
  std::sort(pairs.begin(), pairs.end());
  result.first.resize(count + 1);
  for (const auto& [a, b] : pairs) {
    ++result.first[a + 1];
    ++result.first[b + 1];
  }
  for (std::size_t e = 0; e < count; ++e) result.first[e + 1] += result.first[e];
  result.others.resize(2 * pairs.size());
  std::vector<std::uint32_t> next = result.first;
  for (const auto& [a, b] : pairs) {
    result.others[next[a]++] = b;
    result.others[next[b]++] = a;
  }
  return result;
}

}  // namespace

PatchNeighbours patch_neighbours(const InteriorTracks& tracks, InteriorSolids& solids,
                                 const std::vector<RationalEdge>& edges, const ScaleWindow& window,
                                 const BuildControl& control, const std::vector<Kept>& kept) {
  Subject subject(tracks, solids, edges, window, control, kept);
  const MovingPairs pairs(subject.live_edges(), subject.from, subject.to, subject.wanted);
  std::vector<Found> found(control.threads());
  in_parallel(pairs.blocks(), control, BuildProgress::Stage::pairs, [&](unsigned thread) {
    return NeighbourSearch(subject, pairs, control, found[thread]);
  });
  PatchNeighbours result = listed(found, edges.size());
  result.cells = std::move(subject.cells);
  return result;
}

}  // namespace minkref::inline plane
