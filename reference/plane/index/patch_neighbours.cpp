#include "reference/plane/index/patch_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/build/stage.hpp"
#include "reference/plane/critical/pair_filter.hpp"
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
  std::uint32_t s_count = 0;        ///< of these
  double from = 0, to = infinity;
  double length = 0, size = 0;  ///< the greatest coordinates, of directions and of points

  Subject(const InteriorTracks& own_tracks, InteriorSolids& own_solids,
          const std::vector<RationalEdge>& given, const ScaleWindow& window,
          const BuildControl& control)
      : tracks(own_tracks), solids(own_solids) {
    if (window.from) from = to_double(*window.from) * (1 - 0x1p-50);
    if (window.to) to = to_double(*window.to) * (1 + 0x1p-50);
    for (const RationalEdge& e : given) edges.push_back(rounded(e));
    cells = patch_cells(tracks, solids, edges, from, to, control);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      if (cells.of(e).empty()) continue;
      live.push_back(e);
      const RoundedEdge& r = edges[e];
      s_count += r.is_s ? 1 : 0;
      length = std::max({length, std::fabs(r.dx), std::fabs(r.dy)});
      size = std::max({size, std::fabs(r.px), std::fabs(r.py), std::fabs(r.qx), std::fabs(r.qy)});
    }
  }

  PairFilter filter() const {
    EdgeColumns s, t;
    for (const std::uint32_t k : live) {
      const RoundedEdge& e = edges[k];
      (e.is_s ? s : t).add(e.px, e.py, e.qx, e.qy, e.dx, e.dy);
    }
    return {std::move(s), std::move(t)};
  }
};

/// One thread's pairs a < b.
struct Found {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept;
  std::uint64_t meeting = 0, inside = 0;
};

class NeighbourSearch {
 public:
  NeighbourSearch(const Subject& subject, const PairFilter& filter, const BuildControl& control,
                  Found& found)
      : subject_(subject),
        filter_(filter),
        control_(control),
        error_(filter.error()),
        found_(found),
        candidates_(subject.live.size() + 1) {}

  /// Finds all pairs of a live edge with later edges.
  void operator()(std::size_t index) {
    const auto a = static_cast<std::uint32_t>(index);
    const std::uint32_t s_count = subject_.s_count;
    const bool is_s = a < s_count;
    const std::uint32_t own = is_s ? a : a - s_count;
    hints_ = {};
    if (is_s) {
      const std::size_t n = filter_.candidates(true, own, true, own + 1, candidates_.data());
      for (std::size_t k = 0; k < n; ++k) look(subject_.live[a], subject_.live[candidates_[k]]);
    }
    const std::size_t n =
        filter_.candidates(is_s, own, false, is_s ? 0 : own + 1, candidates_.data());
    for (std::size_t k = 0; k < n; ++k) {
      look(subject_.live[a], subject_.live[s_count + candidates_[k]]);
    }
  }

 private:
  /// slope s + value >= 0 somewhere in [low, high], both coefficients shifted by the error.
  void restrict_to(double slope, double value, double& low, double& high) const {
    if (slope > error_) {
      low = std::max(low, (-value - error_) / (slope + error_));
    } else if (slope < -error_) {
      high = std::min(high, (value + error_) / (-slope - error_));
    }
  }

  void look(std::uint32_t i, std::uint32_t j) {
    control_.look();
    const RoundedEdge &a = subject_.edges[i], &b = subject_.edges[j];
    const double turn = a.dx * b.dy - a.dy * b.dx, right = turn < 0 ? -1 : 1, c = right * turn;
    if (c > 64 * error_) {
      const double px = b.px - a.px, py = b.py - a.py, qx = b.qx - a.qx, qy = b.qy - a.qy;
      const double a_slope = right * (px * b.dy - py * b.dx),
                   a_value = right * (qx * b.dy - qy * b.dx),
                   b_slope = right * (px * a.dy - py * a.dx),
                   b_value = right * (qx * a.dy - qy * a.dx);
      double low = subject_.from, high = subject_.to;
      restrict_to(a_slope, a_value, low, high);
      restrict_to(a.is_s ? c - a_slope : -a_slope, a.is_s ? -a_value : c - a_value, low, high);
      restrict_to(b_slope, b_value, low, high);
      restrict_to(b.is_s ? c - b_slope : -b_slope, b.is_s ? -b_value : c - b_value, low, high);
      low *= 1 - 0x1p-45;
      high *= 1 + 0x1p-45;
      if (low > high) return;
      ++found_.meeting;
      if (low > 0 && high < infinity) {
        if (!passes_cell(i, a_slope, a_value, c, low, high) ||
            !passes_cell(j, b_slope, b_value, c, low, high)) {
          ++found_.inside;
          return;
        }
        const double slope = a_slope / c, value = a_value / c;
        const double ratio = std::max(std::fabs(slope), std::fabs(value));
        const RoundedTrack track{a.qx + value * a.dx, a.qy + value * a.dy, a.px + slope * a.dx,
                                 a.py + slope * a.dy,
                                 subject_.length * (error_ * (2 + 2 * ratio) / c) +
                                     0x1p-48 * (subject_.size + ratio * subject_.length)};
        if (subject_.tracks.certainly_inside(track, low, high, hints_)) {
          ++found_.inside;
          return;
        }
      }
    } else {
      if (are_apart(a, b)) return;
      ++found_.meeting;
    }
    found_.kept.emplace_back(i, j);
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
  const PairFilter& filter_;
  const BuildControl& control_;
  double error_;
  Found& found_;
  InteriorTracks::Hints hints_;
  std::vector<std::uint32_t> candidates_;
};

PatchNeighbours listed(std::vector<Found>& all, std::size_t count) {
  PatchNeighbours result;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (Found& found : all) {
    result.meeting += found.meeting;
    result.inside += found.inside;
    pairs.insert(pairs.end(), found.kept.begin(), found.kept.end());
    found.kept = {};
  }
  if (all.size() > 1) std::sort(pairs.begin(), pairs.end());
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
                                 const BuildControl& control) {
  Subject subject(tracks, solids, edges, window, control);
  const PairFilter filter = subject.filter();
  std::vector<Found> found(control.threads());
  in_parallel(subject.live.size(), control, BuildProgress::Stage::pairs, [&](unsigned thread) {
    return NeighbourSearch(subject, filter, control, found[thread]);
  });
  PatchNeighbours result = listed(found, edges.size());
  result.cells = std::move(subject.cells);
  return result;
}

}  // namespace minkref::inline plane
