#include "reference/scalespace/patch_cells.hpp"

#include <algorithm>
#include <cmath>

#include "reference/scalespace/in_parallel.hpp"

namespace minkref {
namespace {

constexpr double band_ratio = 4;    // of the scales of a band, which is then halved
constexpr double many_times = 256;  // a scale at which one operand is that much smaller is extreme
constexpr int most_halvings = 4;

constexpr int bits_of_a_cut = 12;

/// A scale near this one that few bits hold, as cells are cut at.
double short_scale(double scale) {
  if (!(scale > 0) || !std::isfinite(scale)) return scale;
  int exponent = 0;
  const double mantissa = std::frexp(scale, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits_of_a_cut)), exponent - bits_of_a_cut);
}

/// The scales at which the operands are about as large.
double middle_scale(const std::vector<RoundedEdge>& edges) {
  double of_P = 0, of_Q = 0;
  for (const RoundedEdge& e : edges) {
    double& own = e.is_s ? of_P : of_Q;
    own = std::max({own, std::fabs(e.dx), std::fabs(e.dy)});
  }
  const double ratio = of_Q / of_P;
  return ratio > 0x1p-500 && ratio < 0x1p500 ? ratio : 1;
}

/// Bands of scales of about the same ratio; those next to 0 and to infinity may be longer.
std::vector<PatchCell> bands(double from, double to, double middle) {
  const double least = from > 0 ? from : std::min(middle / many_times, to / many_times);
  const double most = std::isfinite(to) ? to : std::max(middle * many_times, least * many_times);
  std::vector<PatchCell> result;
  if (from < least) result.push_back({from, least, 0, 1});
  const int count =
      std::max(1, static_cast<int>(std::ceil(std::log(most / least) / std::log(band_ratio))));
  double low = least;
  for (int k = 1; k <= count; ++k) {
    const double high =
        k == count
            ? most
            : std::max(low, std::min(most, short_scale(least *
                                                       std::pow(most / least,
                                                                static_cast<double>(k) / count))));
    result.push_back({low, high, 0, 1});
    low = high;
  }
  if (to > most) result.push_back({most, to, 0, 1});
  return result;
}

class Search {
 public:
  Search(const InteriorTracks& tracks, const std::vector<RoundedEdge>& edges,
         const std::vector<PatchCell>& bands, std::vector<std::vector<PatchCell>>& result)
      : tracks_(tracks), edges_(edges), bands_(bands), result_(result) {}

  void operator()(std::size_t edge) {
    edge_ = &edges_[edge];
    hints_ = {};
    for (const PatchCell& band : bands_) {
      look(band, 0, band.low > 0 && std::isfinite(band.high), result_[edge]);
    }
  }

 private:
  void look(const PatchCell& cell, int halvings, bool may_be_inside, std::vector<PatchCell>& kept) {
    if (may_be_inside) {
      const auto [track, reach] = middle_of(cell);
      const double clearance = tracks_.clearance(track, cell.low, cell.high, hints_);
      if (clearance > 0) return;
      // What halving may win is at most what the cell reaches to, twice.
      const double moved = (cell.high - cell.low) * std::hypot(track.x1, track.y1);
      if (halvings < most_halvings && clearance + reach + moved > 0) {
        PatchCell first = cell, second = cell;
        if (moved > reach) {
          first.high = second.low = cut_between(cell.low, cell.high);
        } else {
          first.to = second.from = (cell.from + cell.to) / 2;
        }
        const std::size_t before = kept.size();
        look(first, halvings + 1, true, kept);
        const bool all_of_first = kept.size() == before + 1 && same(kept.back(), first);
        look(second, halvings + 1, true, kept);
        if (all_of_first && kept.size() == before + 2 && same(kept.back(), second)) {
          kept.resize(before);
          kept.push_back(cell);
        }
        return;
      }
    }
    kept.push_back(cell);
  }

  static bool same(const PatchCell& a, const PatchCell& b) {
    return a.low == b.low && a.high == b.high && a.from == b.from && a.to == b.to;
  }

  /// The track of the middle of a cell, and how far from it points of the cell may be.
  std::pair<RoundedTrack, double> middle_of(const PatchCell& cell) const {
    const RoundedEdge& e = *edge_;
    const double t = (cell.from + cell.to) / 2,
                 half = (cell.to - cell.from) / 2 * std::hypot(e.dx, e.dy) * (1 + 0x1p-40);
    RoundedTrack track{e.qx, e.qy, e.px, e.py, 0, 0, 0};
    (e.is_s ? track.x1 : track.x0) += t * e.dx;
    (e.is_s ? track.y1 : track.y0) += t * e.dy;
    (e.is_s ? track.reach1 : track.reach0) = half;
    track.error = 0x1p-48 * std::max({std::fabs(e.px), std::fabs(e.py), std::fabs(e.qx),
                                      std::fabs(e.qy), std::fabs(e.dx), std::fabs(e.dy)});
    return {track, 2 * half * (e.is_s ? cell.high : 1)};
  }

  const InteriorTracks& tracks_;
  const std::vector<RoundedEdge>& edges_;
  const std::vector<PatchCell>& bands_;
  std::vector<std::vector<PatchCell>>& result_;
  const RoundedEdge* edge_ = nullptr;
  InteriorTracks::Hints hints_;
};

}  // namespace

double cut_between(double low, double high) {
  return std::clamp(short_scale(std::sqrt(low) * std::sqrt(high)), low, high);
}

RoundedEdge rounded(const RationalEdge& e) {
  return {to_double(e.p.x()),
          to_double(e.p.y()),
          to_double(e.q.x()),
          to_double(e.q.y()),
          to_double(e.d.x()),
          to_double(e.d.y()),
          e.is_s()};
}

PatchCells patch_cells(const InteriorTracks& tracks, const std::vector<RoundedEdge>& edges,
                       double from, double to, const BuildControl& control) {
  const std::vector<PatchCell> all_bands = bands(from, to, middle_scale(edges));
  std::vector<std::vector<PatchCell>> found(edges.size());
  in_parallel(edges.size(), control, BuildProgress::Stage::cells,
              [&](unsigned) { return Search(tracks, edges, all_bands, found); });
  PatchCells result;
  for (const auto& cells : found) {
    result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
    result.cells.insert(result.cells.end(), cells.begin(), cells.end());
  }
  result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
  return result;
}

}  // namespace minkref
