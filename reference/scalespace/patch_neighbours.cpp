#include "reference/scalespace/patch_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/plane/critical/pair_filter.hpp"
#include "reference/scalespace/interior_tracks.hpp"

namespace minkref {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct RoundedEdge {
  double px, py, qx, qy, dx, dy;
  bool is_s;
};

RoundedEdge rounded(const RationalEdge& e) {
  return {to_double(e.p.x()),
          to_double(e.p.y()),
          to_double(e.q.x()),
          to_double(e.q.y()),
          to_double(e.d.x()),
          to_double(e.d.y()),
          e.is_s()};
}

class Search {
 public:
  Search(const PolygonSet& P, const PolygonSet& Q, const std::vector<RationalEdge>& edges,
         const ScaleWindow& window)
      : tracks_(P, Q) {
    if (window.from) from_ = to_double(*window.from) * (1 - 0x1p-50);
    if (window.to) to_ = to_double(*window.to) * (1 + 0x1p-50);
    for (const RationalEdge& e : edges) {
      edges_.push_back(rounded(e));
      const RoundedEdge& r = edges_.back();
      length_ = std::max({length_, std::fabs(r.dx), std::fabs(r.dy)});
      size_ = std::max({size_, std::fabs(r.px), std::fabs(r.py), std::fabs(r.qx), std::fabs(r.qy)});
    }
  }

  PatchNeighbours run() {
    const auto count = static_cast<std::uint32_t>(edges_.size());
    const auto s_count = static_cast<std::uint32_t>(
        std::count_if(edges_.begin(), edges_.end(), [](const auto& e) { return e.is_s; }));
    EdgeColumns s, t;
    for (const RoundedEdge& e : edges_) (e.is_s ? s : t).add(e.px, e.py, e.qx, e.qy, e.dx, e.dy);
    const PairFilter filter(std::move(s), std::move(t));
    error_ = filter.error();
    std::vector<std::uint32_t> found(count + 1);
    for (std::uint32_t a = 0; a < count; ++a) {
      const bool is_s = a < s_count;
      const std::uint32_t own = is_s ? a : a - s_count;
      if (is_s) {
        const std::size_t n = filter.candidates(true, own, true, own + 1, found.data());
        for (std::size_t k = 0; k < n; ++k) look(a, found[k]);
      }
      const std::size_t n = filter.candidates(is_s, own, false, is_s ? 0 : own + 1, found.data());
      for (std::size_t k = 0; k < n; ++k) look(a, s_count + found[k]);
    }
    return listed(count);
  }

 private:
  /// slope s + value >= 0 somewhere in [low, high], both coefficients off by the error.
  void restrict_to(double slope, double value, double& low, double& high) const {
    if (slope > error_) {
      low = std::max(low, (-value - error_) / (slope + error_));
    } else if (slope < -error_) {
      high = std::min(high, (value + error_) / (-slope - error_));
    }
  }

  void look(std::uint32_t i, std::uint32_t j) {
    const RoundedEdge &a = edges_[i], &b = edges_[j];
    const double turn = a.dx * b.dy - a.dy * b.dx, right = turn < 0 ? -1 : 1, c = right * turn;
    if (c > 64 * error_) {
      const double px = b.px - a.px, py = b.py - a.py, qx = b.qx - a.qx, qy = b.qy - a.qy;
      const double a_slope = right * (px * b.dy - py * b.dx),
                   a_value = right * (qx * b.dy - qy * b.dx),
                   b_slope = right * (px * a.dy - py * a.dx),
                   b_value = right * (qx * a.dy - qy * a.dx);
      double low = from_, high = to_;
      restrict_to(a_slope, a_value, low, high);
      restrict_to(a.is_s ? c - a_slope : -a_slope, a.is_s ? -a_value : c - a_value, low, high);
      restrict_to(b_slope, b_value, low, high);
      restrict_to(b.is_s ? c - b_slope : -b_slope, b.is_s ? -b_value : c - b_value, low, high);
      low *= 1 - 0x1p-45;
      high *= 1 + 0x1p-45;
      if (low > high) return;
      ++meeting_;
      if (low > 0 && high < infinity) {
        const double slope = a_slope / c, value = a_value / c;
        const double ratio = std::max(std::fabs(slope), std::fabs(value));
        const RoundedTrack track{
            a.qx + value * a.dx, a.qy + value * a.dy, a.px + slope * a.dx, a.py + slope * a.dy,
            length_ * (error_ * (2 + 2 * ratio) / c) + 0x1p-48 * (size_ + ratio * length_)};
        if (tracks_.certainly_inside(track, low, high, hints_)) {
          ++inside_;
          return;
        }
      }
    } else {
      ++meeting_;
    }
    kept_.emplace_back(i, j);
  }

  PatchNeighbours listed(std::uint32_t count) const {
    PatchNeighbours result;
    result.meeting = meeting_;
    result.inside = inside_;
    result.first.resize(count + 1);
    for (const auto& [a, b] : kept_) {
      ++result.first[a + 1];
      ++result.first[b + 1];
    }
    for (std::uint32_t e = 0; e < count; ++e) result.first[e + 1] += result.first[e];
    result.others.resize(2 * kept_.size());
    std::vector<std::uint32_t> next = result.first;
    for (const auto& [a, b] : kept_) {
      result.others[next[a]++] = b;
      result.others[next[b]++] = a;
    }
    return result;
  }

  InteriorTracks tracks_;
  InteriorTracks::Hints hints_;
  std::vector<RoundedEdge> edges_;
  double from_ = 0, to_ = infinity;
  double error_ = 0, length_ = 0, size_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept_;
  std::uint64_t meeting_ = 0, inside_ = 0;
};

}  // namespace

PatchNeighbours patch_neighbours(const PolygonSet& P, const PolygonSet& Q,
                                 const std::vector<RationalEdge>& edges,
                                 const ScaleWindow& window) {
  return Search(P, Q, edges, window).run();
}

}  // namespace minkref
