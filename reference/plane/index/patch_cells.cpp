#include "reference/plane/index/patch_cells.hpp"

#include <algorithm>
#include <cmath>

#include "reference/build/stage.hpp"
#include "reference/interrupt.hpp"

namespace minkref::inline plane {
namespace {

constexpr double band_ratio = 4;    // a band's scales; bands are then halved
constexpr double many_times = 256;  // a scale with an operand smaller by this factor is extreme
constexpr int most_halvings_by_tracks = 4, most_halvings_by_solids = 6;
constexpr int looks_ahead = 3;

constexpr int bits_of_a_cut = 12;

/// A nearby scale with few bits, for cell cuts.
double short_scale(double scale) {
  if (!(scale > 0) || !std::isfinite(scale)) return scale;
  int exponent = 0;
  const double mantissa = std::frexp(scale, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, bits_of_a_cut)), exponent - bits_of_a_cut);
}

/// The scale at which the operands are about equally large.
double middle_scale(const std::vector<RoundedEdge>& edges) {
  double of_P = 0, of_Q = 0;
  for (const RoundedEdge& e : edges) {
    double& own = e.is_s ? of_P : of_Q;
    own = std::max({own, std::fabs(e.dx), std::fabs(e.dy)});
  }
  const double ratio = of_Q / of_P;
  return ratio > 0x1p-500 && ratio < 0x1p500 ? ratio : 1;
}

/// Bands of scales with about equal ratios; bands next to 0 and infinity may be longer.
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

class CellSearch {
 public:
  CellSearch(const InteriorTracks& tracks, const InteriorSolids& solids,
             const std::vector<RoundedEdge>& edges, const std::vector<PatchCell>& bands,
             std::vector<std::vector<PatchCell>>& result)
      : tracks_(tracks), solids_(solids), edges_(edges), bands_(bands), result_(result) {}

  void operator()(std::size_t edge) {
    edge_ = &edges_[edge];
    hints_ = {};
    solid_ = 0;
    for (const PatchCell& band : bands_) {
      look(band, 0, band.low > 0 && std::isfinite(band.high), result_[edge]);
    }
  }

 private:
  void look(const PatchCell& cell, int halvings, bool may_be_inside, std::vector<PatchCell>& kept) {
    look_for_interrupt();
    if (may_be_inside) {
      const auto [track, reach] = middle_of(*edge_, cell);
      const double clearance = tracks_.clearance(track, cell.low, cell.high, hints_);
      if (clearance > 0 || solids_.chosen_holds(swept_quad(*edge_, cell), solid_)) return;
      // Halving gains at most twice the cell's reach from its middle: its length plus its motion.
      const double moved = (cell.high - cell.low) * std::hypot(track.x1, track.y1);
      if ((halvings < most_halvings_by_tracks && clearance + reach + moved > 0) ||
          (halvings < most_halvings_by_solids && some_point_is_inside(cell))) {
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

  /// Tests the cell's middle and corners.
  bool some_point_is_inside(const PatchCell& cell) {
    const double s = std::sqrt(cell.low) * std::sqrt(cell.high), t = (cell.from + cell.to) / 2;
    const auto inside = [&](double scale, double along) {
      return solids_.chosen_holds(swept_quad(*edge_, {scale, scale, along, along}), solid_);
    };
    return inside(s, t) || inside(cell.low, cell.from) || inside(cell.low, cell.to) ||
           inside(cell.high, cell.from) || inside(cell.high, cell.to);
  }

  static bool same(const PatchCell& a, const PatchCell& b) {
    return a.low == b.low && a.high == b.high && a.from == b.from && a.to == b.to;
  }

  const InteriorTracks& tracks_;
  const InteriorSolids& solids_;
  const std::vector<RoundedEdge>& edges_;
  const std::vector<PatchCell>& bands_;
  std::vector<std::vector<PatchCell>>& result_;
  const RoundedEdge* edge_ = nullptr;
  InteriorTracks::Hints hints_;
  std::uint32_t solid_ = 0;
};

/// Numbers from 0 to 1, evenly spread for any first n.
double far_apart(std::size_t k, double step = 0.6180339887498949) {
  return std::fmod(static_cast<double>(k) * step, 1);
}

/// Small parts of patches, far from each other, that discs do not prove inside.
std::vector<SweptQuad> small_parts(const InteriorTracks& tracks,
                                   const std::vector<RoundedEdge>& edges,
                                   const std::vector<PatchCell>& bands) {
  constexpr std::size_t most = 4096;
  constexpr double length = 0.0625;
  std::vector<SweptQuad> result;
  InteriorTracks::Hints hints;
  for (std::size_t k = 0; k < most; ++k) {
    look_for_interrupt();
    const RoundedEdge& e = edges[k * edges.size() / most];
    const PatchCell& band = bands[k % bands.size()];
    if (!(band.low > 0) || !std::isfinite(band.high)) continue;
    const double ratio = band.high / band.low, up = far_apart(k, 0.7548776662466927),
                 low = band.low * std::pow(ratio, up * (1 - length));
    const double from = far_apart(k) * (1 - length);
    const PatchCell part{low, low * std::pow(ratio, length), from, from + length};
    if (tracks.clearance(middle_of(e, part).first, part.low, part.high, hints) > 0) continue;
    result.push_back(swept_quad(e, part));
  }
  return result;
}

/// Small cells that remain on the patches of some edges.
std::vector<SweptQuad> cells_left(const std::vector<RoundedEdge>& edges,
                                  std::vector<std::vector<PatchCell>>& found, CellSearch search) {
  constexpr std::size_t some = 256;
  std::vector<SweptQuad> result;
  for (std::size_t k = 0; k < std::min(edges.size(), some); ++k) {
    const auto e = static_cast<std::size_t>(far_apart(k) * static_cast<double>(edges.size()));
    search(e);
    for (const PatchCell& cell : found[e]) {
      if (cell.low > 0 && std::isfinite(cell.high)) result.push_back(swept_quad(edges[e], cell));
    }
    found[e].clear();
  }
  return result;
}

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

std::pair<RoundedTrack, double> middle_of(const RoundedEdge& e, const PatchCell& cell) {
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

SweptQuad swept_quad(const RoundedEdge& e, const PatchCell& cell) {
  SweptQuad result;
  result.low = cell.low;
  result.high = cell.high;
  for (std::size_t k = 0; k < 4; ++k) {
    const double s = k < 2 ? cell.low : cell.high,
                 t = (k % 2 == 0 ? cell.from : cell.to) * (e.is_s ? s : 1);
    result.x[k] = s * e.px + e.qx + t * e.dx;
    result.y[k] = s * e.py + e.qy + t * e.dy;
  }
  return result;
}

PatchCells patch_cells(const InteriorTracks& tracks, InteriorSolids& solids,
                       const std::vector<RoundedEdge>& edges, double from, double to,
                       const BuildControl& control) {
  const std::vector<PatchCell> all_bands = bands(from, to, middle_scale(edges));
  std::vector<std::vector<PatchCell>> found(edges.size());
  if (!edges.empty()) {
    std::vector<SweptQuad> samples = small_parts(tracks, edges, all_bands);
    for (int k = 0; solids.choose(samples) * 8 > samples.size() && k < looks_ahead; ++k) {
      control.look_now();
      samples = cells_left(edges, found, CellSearch(tracks, solids, edges, all_bands, found));
    }
  }
  in_parallel(edges.size(), control, BuildProgress::Stage::cells,
              [&](unsigned) { return CellSearch(tracks, solids, edges, all_bands, found); });
  PatchCells result;
  for (const auto& cells : found) {
    result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
    result.cells.insert(result.cells.end(), cells.begin(), cells.end());
  }
  result.first.push_back(static_cast<std::uint32_t>(result.cells.size()));
  return result;
}

}  // namespace minkref::inline plane
