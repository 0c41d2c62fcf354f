#include "reference/space/edges/carrier.hpp"

#include <algorithm>

#include "reference/interrupt.hpp"

namespace minkref::inline space {

void CarrierCutting::begin(CarrierLine line) {
  line_.emplace(std::move(line));
  whole_side_ = nullptr;
  start_covered_ = end_covered_ = false;
  cuts_.clear();
  covers_.clear();
  pieces_.clear();
}

/// Whether cells cover the carrier, which then lies wholly within the sum's interior.
bool CarrierCutting::is_covered() const {
  const std::array ends{line_->point_at(from_.t), line_->point_at(to_.t)};
  return cells_.contain(ends);
}

Cut CarrierCutting::cut_at(const ConvolutionFacet& facet, int side) {
  Cut cut{{&facet, side}, 0, {}};
  const auto [num, den] = line_->parameter<BoundedDouble>(cut.plane);
  cut.t = num / den;
  return cut;
}

int CarrierCutting::compare(const Cut& a, const Cut& b) {
  const int certain = (a.t - b.t).certain_sign();
  if (certain != BoundedDouble::undecided) {
    ++signs.by_float;
    return certain;
  }
  if (a.plane.facet == b.plane.facet && a.plane.side == b.plane.side && a.end == b.end) return 0;
  if (a.plane.facet != nullptr && b.plane.facet != nullptr && a.plane.side != CutterPlane::own &&
      b.plane.side != CutterPlane::own && side_of(a) == side_of(b)) {
    return 0;  // within both facets' planes the line meets their common side once
  }
  ++signs.by_integer;
  const auto exact = [&](const Cut& cut) -> std::pair<Integer, Integer> {
    if (cut.plane.facet == nullptr) return {Integer(cut.end), Integer(1)};
    return line_->parameter<Integer>(cut.plane);
  };
  const auto [a_num, a_den] = exact(a);
  const auto [b_num, b_den] = exact(b);
  return Integer(a_num * b_den - b_num * a_den).sign() * a_den.sign() * b_den.sign();
}

/// The side behind a cut.
std::uint32_t CarrierCutting::side_of(const Cut& cut) {
  return cut.plane.facet->sides[static_cast<std::size_t>(cut.plane.side)];
}

/// Clips the line, which lies in the facet's plane, to the facet; returns false if nothing remains.
/// `border`: the side along which the line runs, or CutterPlane::own.
bool CarrierCutting::clip(const ConvolutionFacet& facet, Cut& from, Cut& to, int& border) {
  border = CutterPlane::own;
  bool has_from = false, has_to = false;
  for (int k = 0; k < facet.size; ++k) {
    const CutterPlane plane{&facet, k};
    const int slope = filtered_sign(
        signs, [&]<class T>(std::type_identity<T>) { return line_->parameter<T>(plane).second; });
    if (slope == 0) {
      const int depth = filtered_sign(
          signs, [&]<class T>(std::type_identity<T>) { return line_->parameter<T>(plane).first; });
      if (depth > 0) return false;
      if (depth == 0) border = k;
      continue;
    }
    const Cut cut = cut_at(facet, k);
    if (slope > 0 && (!has_from || compare(cut, from) > 0)) from = cut;
    if (slope < 0 && (!has_to || compare(cut, to) < 0)) to = cut;
    (slope > 0 ? has_from : has_to) = true;
  }
  return compare(from, to) <= 0;
}

/// How a facet lies along a line through one of its sides. The side runs counter-clockwise seen
/// from above: the facet lies on the side's left.
AlongFacet CarrierCutting::along_border(std::uint32_t facet, std::size_t side) {
  const ConvolutionFacet& f = facets_[facet];
  const int same = filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
    return dot(f.along<T>(side), line_->as<T>().direction);
  });
  return {facet, same < 0, same > 0};
}

/// Whether all facets ending at the side share a plane, and no further facet runs along the side's
/// line. Sectors between coplanar half-planes span half a turn or a whole turn: such a side, like a
/// face's diagonal, bears no edge, and shares no piece with a side bearing an edge.
bool CarrierCutting::lies_in_one_plane(const FacetSide& side,
                                       const std::vector<std::uint32_t>& candidates) {
  const ConvolutionFacet& flat = facets_[side.uses.front().facet];
  const auto shares_plane = [&](const ConvolutionFacet& facet) {
    return CarrierLine::parallel(flat, facet, signs);
  };
  if (!std::all_of(side.uses.begin(), side.uses.end(),
                   [&](const auto& use) { return shares_plane(facets_[use.facet]); })) {
    return false;
  }
  return std::all_of(candidates.begin(), candidates.end(), [&](std::uint32_t c) {
    look_for_interrupt();
    return line_->slope(facets_[c], signs) != 0 || shares_plane(facets_[c]);
  });
}

const std::vector<CarrierPiece>& CarrierCutting::cut_side(std::uint32_t number) {
  const FacetSide& side = convolution_.sides[number];
  pieces_.clear();
  if (side.uses.empty()) return pieces_;
  const FacetSide::Use& use = side.uses.front();
  begin(CarrierLine(facets_[use.facet], use.side));
  whole_side_ = &side;
  from_ = {{}, 0, BoundedDouble(0)};
  to_ = {{}, 1, BoundedDouble(1)};
  if (is_covered()) return pieces_;
  // A facet that touches the side also touches each facet at the side.
  const auto fewest = std::min_element(
      side.uses.begin(), side.uses.end(),
      [&](const auto& a, const auto& b) { return near_[a.facet].size() < near_[b.facet].size(); });
  if (lies_in_one_plane(side, near_[fewest->facet])) return pieces_;
  for (const auto& [facet, k] : side.uses) covers_.push_back({along_border(facet, k), start, end});
  for (const std::uint32_t c : near_[fewest->facet]) {
    const bool used = std::any_of(side.uses.begin(), side.uses.end(),
                                  [&](const auto& u) { return u.facet == c; });
    if (!used) look_at(c);
  }
  make_pieces();
  std::erase_if(pieces_, [&](const CarrierPiece& piece) {
    for (const AlongFacet& along : piece.facets) {
      if (along.ahead && along.behind) continue;
      const ConvolutionFacet& facet = facets_[along.facet];
      for (std::size_t k = 0; k < facet.size; ++k) {
        if (facet.sides[k] >= number) continue;
        const CutterPlane plane{&facet, static_cast<int>(k)};
        const bool holds = filtered_sign(signs,
                                         [&]<class T>(std::type_identity<T>) {
                                           return line_->parameter<T>(plane).second;
                                         }) == 0 &&
                           filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
                             return line_->parameter<T>(plane).first;
                           }) == 0;
        if (holds) return true;
      }
    }
    return false;
  });
  return pieces_;
}

bool CarrierCutting::spans_crossing(std::uint32_t a, std::uint32_t b) {
  const auto on_both_sides = [&](const ConvolutionFacet& flat, const ConvolutionFacet& other) {
    bool above = false, below = false;
    for (std::size_t k = 0; k < other.size; ++k) {
      if (flat.has_corner(other.names[k])) continue;
      const int side = filtered_sign(
          signs, [&]<class T>(std::type_identity<T>) { return flat.height<T>(other, k); });
      above = above || side > 0;
      below = below || side < 0;
    }
    return above && below;
  };
  const ConvolutionFacet &f = facets_[a], &g = facets_[b];
  if (!on_both_sides(f, g) || !on_both_sides(g, f)) return false;
  begin(CarrierLine(f, g, convolution_.shift));
  Cut from, to, other_from, other_to;
  int border = CutterPlane::own;
  if (!clip(f, from, to, border) || border != CutterPlane::own) return false;
  if (!clip(g, other_from, other_to, border) || border != CutterPlane::own) return false;
  from_ = compare(from, other_from) >= 0 ? from : other_from;
  to_ = compare(to, other_to) <= 0 ? to : other_to;
  return compare(from_, to_) < 0;
}

const std::vector<CarrierPiece>& CarrierCutting::cut_crossing(std::uint32_t a, std::uint32_t b) {
  pieces_.clear();
  if (!spans_crossing(a, b) || is_covered()) return pieces_;
  covers_.push_back({{a, true, true}, start, end});
  covers_.push_back({{b, true, true}, start, end});
  const bool a_has_fewer = near_[a].size() < near_[b].size();
  const auto &fewer = near_[a_has_fewer ? a : b], &more = near_[a_has_fewer ? b : a];
  auto from = more.begin();
  for (const std::uint32_t c : fewer) {
    from = std::lower_bound(from, more.end(), c);
    if (from == more.end()) break;
    if (*from == c) look_at(c);
  }
  make_pieces();
  std::erase_if(pieces_, [&](const CarrierPiece& piece) {
    if (std::any_of(piece.facets.begin(), piece.facets.end(),
                    [](const AlongFacet& along) { return !along.ahead || !along.behind; })) {
      return true;
    }
    const std::uint32_t first = piece.facets.front().facet;
    const auto second =
        std::find_if(piece.facets.begin() + 1, piece.facets.end(), [&](auto& along) {
          return !CarrierLine::parallel(facets_[first], facets_[along.facet], signs);
        });
    return first != std::min(a, b) || second->facet != std::max(a, b);
  });
  return pieces_;
}

void CarrierCutting::look_at(std::uint32_t number) {
  look_for_interrupt();
  const ConvolutionFacet& facet = facets_[number];
  const int slope = line_->slope(facet, signs);
  if (slope != 0) return add_transversal(number, slope);
  const int depth = filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
    return line_->parameter<T>(CutterPlane{&facet, CutterPlane::own}).first;
  });
  if (depth == 0) add_flat(number);
}

/// Returns 1, 0 or -1 as the line meets the facet's plane inside the facet, on the border or
/// outside.
int CarrierCutting::within(const ConvolutionFacet& facet, int slope) {
  int result = 1;
  for (std::size_t k = 0; k < facet.size; ++k) {
    const int turn = filtered_sign(signs, [&]<class T>(std::type_identity<T>) {
      const LineIn<T>& line = line_->as<T>();
      return dot(line.direction,
                 cross(facet.along<T>(k), line.origin - line.weight * facet.start<T>(k)));
    });
    if (turn * slope < 0) return -1;
    if (turn == 0) result = 0;
  }
  return result;
}

/// Whether the line, across a facet, meets the facet's border at an end of the carrier, by name: an
/// end of a side in a common corner, an end of a crossing on a common side.
bool CarrierCutting::ends_at_border(const ConvolutionFacet& facet) const {
  if (whole_side_ != nullptr) {
    return facet.has_corner(whole_side_->from) || facet.has_corner(whole_side_->to);
  }
  const auto *first = facet.sides.begin(), *last = first + facet.size;
  return std::find(first, last, side_of(from_)) != last ||
         std::find(first, last, side_of(to_)) != last;
}

void CarrierCutting::add_transversal(std::uint32_t number, int slope) {
  const ConvolutionFacet& facet = facets_[number];
  if (ends_at_border(facet)) return;  // no cut within, and nothing next to an end is below it
  const Cut cut = cut_at(facet, CutterPlane::own);
  const int after_start = compare(cut, from_);
  if (after_start < 0) return;
  const int after_end = compare(cut, to_);
  if (after_end > 0) return;
  const int inside = within(facet, slope);
  if (inside < 0) return;
  const bool covers_before = inside > 0 && slope > 0, covers_after = inside > 0 && slope < 0;
  if (after_start == 0) {
    start_covered_ = start_covered_ || covers_after;
  } else if (after_end == 0) {
    end_covered_ = end_covered_ || covers_before;
  } else {
    cuts_.push_back({cut, covers_before, covers_after, 0});
  }
}

void CarrierCutting::add_flat(std::uint32_t number) {
  Cut from, to;
  int border = CutterPlane::own;
  if (!clip(facets_[number], from, to, border)) return;
  if (compare(to, from_) <= 0 || compare(from, to_) >= 0) return;
  const auto place = [&](const Cut& cut) {
    if (compare(cut, from_) <= 0) return start;
    if (compare(cut, to_) >= 0) return end;
    cuts_.push_back({cut, false, false, 0});
    return static_cast<std::uint32_t>(cuts_.size() - 1);
  };
  const std::uint32_t first = place(from);
  if (compare(from, to) == 0) return;
  const std::uint32_t last = place(to);
  const AlongFacet along = border == CutterPlane::own
                               ? AlongFacet{number, true, true}
                               : along_border(number, static_cast<std::size_t>(border));
  covers_.push_back({along, first, last});
}

/// Gives cuts at the same point the same position, from 1.
void CarrierCutting::sort_cuts() {
  std::vector<std::uint32_t> order(cuts_.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return compare(cuts_[a].cut, cuts_[b].cut) < 0;
  });
  std::uint32_t position = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k == 0 || compare(cuts_[order[k - 1]].cut, cuts_[order[k]].cut) != 0) ++position;
    cuts_[order[k]].position = position;
  }
}

void CarrierCutting::make_pieces() {
  sort_cuts();
  std::uint32_t last = 0;
  for (const MarkedCut& cut : cuts_) last = std::max(last, cut.position);
  std::vector<const MarkedCut*> at(last + 1, nullptr);
  std::vector<bool> covered(last + 1, false);
  covered.front() = start_covered_;
  covered.back() = covered.back() || end_covered_;
  for (const MarkedCut& cut : cuts_) {
    at[cut.position] = &cut;
    if (cut.covers_before) covered[cut.position - 1] = true;
    if (cut.covers_after) covered[cut.position] = true;
  }
  std::vector<std::vector<AlongFacet>> along(last + 1);
  for (const Cover& cover : covers_) {
    const std::uint32_t first = cover.from == start ? 0 : cuts_[cover.from].position;
    const std::uint32_t beyond = cover.to == end ? last + 1 : cuts_[cover.to].position;
    for (std::uint32_t k = first; k < beyond; ++k) {
      if (!covered[k]) along[k].push_back(cover.along);
    }
  }
  for (std::uint32_t k = 0; k <= last; ++k) {
    if (covered[k]) continue;
    CarrierPiece piece{k == 0 ? from_ : at[k]->cut, k == last ? to_ : at[k + 1]->cut,
                       std::move(along[k])};
    std::sort(piece.facets.begin(), piece.facets.end(),
              [](const AlongFacet& a, const AlongFacet& b) { return a.facet < b.facet; });
    pieces_.push_back(std::move(piece));
  }
}

}  // namespace minkref::inline space
