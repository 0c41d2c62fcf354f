#include "reference/space/convex/word_surface.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <tuple>
#include <utility>

#include "reference/interrupt.hpp"
#include "reference/number/float_environment.hpp"
#include "reference/space/convex/pieces.hpp"

namespace minkref::inline space {
namespace {

/// Turns counts into sums over all earlier entries; the last entry becomes the total.
void add_up(std::vector<std::uint32_t>& counts) {
  std::uint32_t total = 0;
  for (std::uint32_t& count : counts) count = std::exchange(total, total + count);
}

/// Sorts keys by upper halves.
void sort_by_upper_half(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& spare) {
  constexpr std::size_t few = 256;
  constexpr unsigned digits = 11;
  if (keys.size() < few) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  spare.resize(keys.size());
  for (unsigned shift = 32; shift < 64; shift += digits) {
    look_for_interrupt();
    std::array<std::uint32_t, (1U << digits) + 1> first{};
    const auto digit = [&](std::uint64_t key) { return key >> shift & ((1U << digits) - 1); };
    for (const std::uint64_t key : keys) ++first[digit(key) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (const std::uint64_t key : keys) spare[first[digit(key)]++] = key;
    keys.swap(spare);
  }
}

}  // namespace

const std::vector<WordVector>& WordSurface::numerators() const {
  return std::get<std::vector<WordVector>>(coordinates_.numerators);
}

bool WordSurface::renew(const DynamicConvexSum& sum) {
  const FloatEnvironment standard;
  points_.clear();
  parents_.clear();
  facets_.clear();
  sum_coordinates(sum.P(), sum.Q(), sum.scaling(), sum.vertices(), coordinates_);
  const auto* words = std::get_if<std::vector<WordVector>>(&coordinates_.numerators);
  if (words == nullptr || !fit_in_words(*words)) return false;
  pairs_.clear();
  sum.vertices().for_each([&](std::uint32_t p, std::uint32_t q) { pairs_.push_back({p, q}); });
  list_pieces(sum);
  const auto& doubtful = certificate_.doubtful(*words, pieces_);
  merged_ = 0;
  is_united_ = !doubtful.empty();
  if (is_united_) merge(doubtful);
  certificate_.require(*words, rings());
  order_vertices();
  order_facets();
  return true;
}

/// Numbers all pairs, and thereby chains' sides and corners at P's facets; lists Q's facets.
void WordSurface::number_sides(const DynamicConvexSum& sum) {
  const ConvexPolyhedron &P = sum.P(), &Q = sum.Q();
  const SumVertices& vertices = sum.vertices();
  const Compatibility& state = sum.compatibility();
  std::uint32_t number = 0, of_whole = 0;
  for (std::uint32_t p = 0; p < P.vertices(); ++p) {
    of_whole += static_cast<std::uint32_t>(vertices.met(p).size());
  }
  whole_number_.assign(Q.vertices(), 0);
  for (std::uint32_t q = 0; q < Q.vertices(); ++q) {
    if (vertices.is_whole(q)) whole_number_[q] = of_whole++;
  }
  first_link_.resize(P.edges() + 1);
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    first_link_[e] = static_cast<std::uint32_t>(state.chains[e].size() + 1);
  }
  first_link_[P.edges()] = 0;
  add_up(first_link_);
  for (auto& ends : ends_) ends.resize(first_link_.back());
  corner_.resize(P.half_edges());
  first_facet_.assign(P.vertices() + 1, 0);
  for (const std::uint32_t p : state.vertex_of_P) ++first_facet_[p];
  add_up(first_facet_);
  facets_at_.resize(Q.facets());
  for (std::uint32_t g = 0; g < Q.facets(); ++g) {
    facets_at_[first_facet_[state.vertex_of_P[g]]++] = g;
  }
  number_of_.assign(Q.vertices(), 0);
  for (std::uint32_t p = 0, g = 0; p < P.vertices(); ++p) {
    look_for_interrupt();
    for (const std::uint32_t q : vertices.met(p)) number_of_[q] = number++;
    for (std::uint32_t h = P.first(p); h < P.first(p + 1); ++h) {
      const std::uint32_t e = P.edge(h), along = P.half_edge(e);
      std::uint32_t* end = ends_[along == h ? 0 : 1].data() + first_link_[e];
      *end++ = number_of_[state.vertex_of_Q[P.left(along)]];
      for (const std::uint32_t d : state.chains[e]) *end++ = number_of_[Q.target(d)];
      corner_[h] = number_of_[state.vertex_of_Q[P.left(h)]];
    }
    for (; g < first_facet_[p]; ++g) {
      for_vertices_of(Q, facets_at_[g], [&](std::uint32_t q) {
        pieces_.corners.push_back(vertices.is_whole(q) ? whole_number_[q] : number_of_[q]);
      });
      pieces_.close();
    }
  }
}

void WordSurface::list_pieces(const DynamicConvexSum& sum) {
  const ConvexPolyhedron& P = sum.P();
  pieces_.clear();
  number_sides(sum);
  for (std::uint32_t f = 0; f < P.facets(); ++f) {
    look_for_interrupt();
    const std::uint32_t start = P.start(f);
    std::uint32_t h = start;
    do pieces_.corners.push_back(corner_[h]);
    while ((h = P.next(h)) != start);
    pieces_.close();
  }
  for (std::uint32_t e = 0; e < P.edges(); ++e) {
    look_for_interrupt();
    for (std::uint32_t k = first_link_[e] + 1; k < first_link_[e + 1]; ++k) {
      const std::array<std::uint32_t, 4> ring{ends_[0][k - 1], ends_[0][k], ends_[1][k],
                                              ends_[1][k - 1]};
      pieces_.corners.insert(pieces_.corners.end(), ring.begin(), ring.end());
      pieces_.close();
    }
  }
}

std::uint32_t WordSurface::root(std::uint32_t piece) {
  while (group_[piece] != piece) piece = group_[piece] = group_[group_[piece]];
  return piece;
}

/// For pieces with area; the first three corners are on no line.
bool WordSurface::in_one_plane(std::uint32_t piece, std::uint32_t other) const {
  if (piece == other) return true;
  const std::vector<WordVector>& points = numerators();
  const WordVector& in_plane = points[pieces_[piece][0]];
  const auto corners = pieces_[other].first(3);
  return std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    return dot_sign(normals_[piece], points[v] - in_plane) == 0;
  });
}

/// Pieces of a facet meet along edges, or across pieces without area. Adjacent pieces without area
/// share a line, within a single facet or between two facets: so pieces with area beside the line
/// span two planes at most.
void WordSurface::unite_coplanar(const std::vector<RingCertificate::Doubt>& doubtful) {
  const std::vector<WordVector>& points = numerators();
  normals_.resize(pieces_.size());
  for (std::uint32_t r = 0; r < pieces_.size(); ++r) {
    if (is_doubtful_[r] == 0) continue;
    look_for_interrupt();
    const auto ring = pieces_[r];
    normals_[r] = cross(points[ring[1]] - points[ring[0]], points[ring[2]] - points[ring[0]]);
  }
  const auto is_flat = [&](std::uint32_t r) { return is_zero(normals_[r]); };
  for (const auto& [a, b, is_level] : doubtful) {
    look_for_interrupt();
    if (is_level && is_flat(a) == is_flat(b)) group_[root(a)] = root(b);
  }
  constexpr std::uint32_t none = UINT32_MAX;
  beside_.assign(pieces_.size(), {none, none});
  for (const auto& [a, b, is_level] : doubtful) {
    look_for_interrupt();
    if (is_flat(a) == is_flat(b)) continue;
    const std::uint32_t piece = is_flat(a) ? b : a;
    for (std::uint32_t& known : beside_[root(is_flat(a) ? a : b)]) {
      if (known == none) known = piece;
      if (!in_one_plane(known, piece)) continue;
      group_[root(piece)] = root(known);
      break;
    }
  }
}

/// The certificate would refuse overlooked coplanar pieces.
void WordSurface::merge(const std::vector<RingCertificate::Doubt>& doubtful) {
  group_.resize(pieces_.size());
  std::iota(group_.begin(), group_.end(), 0U);
  is_doubtful_.assign(pieces_.size(), 0);
  for (const auto& [a, b, is_level] : doubtful) is_doubtful_[a] = is_doubtful_[b] = 1;
  unite_coplanar(doubtful);
  // Lists all groups, sorted by root.
  first_piece_.assign(pieces_.size() + 1, 0);
  const auto for_pieces = [&](auto&& visit) {
    for (std::uint32_t r = 0; r < pieces_.size(); ++r) {
      if (is_doubtful_[r] == 0 || !is_zero(normals_[r])) visit(r);
    }
  };
  for_pieces([&](std::uint32_t r) { ++first_piece_[root(r)]; });
  add_up(first_piece_);
  piece_of_.resize(first_piece_.back());
  for_pieces([&](std::uint32_t r) { piece_of_[first_piece_[root(r)]++] = r; });
  const std::vector<WordVector>& points = numerators();
  is_used_.assign(points.size(), 0);
  united_.clear();
  std::uint32_t kept = 0;
  merged_ = 0;
  for (std::uint32_t r = 0, begin = 0; r < pieces_.size(); ++r) {
    look_for_interrupt();
    const std::uint32_t end = first_piece_[r];
    if (end == begin) continue;
    if (end - begin == 1) {
      const auto ring = pieces_[piece_of_[begin]];
      united_.corners.insert(united_.corners.end(), ring.begin(), ring.end());
    } else {
      merged_ += end - begin;
      Face corners;
      for (std::uint32_t k = begin; k < end; ++k) {
        for (const std::uint32_t v : pieces_[piece_of_[k]]) {
          if (is_used_[v] == 0) corners.push_back(v);
          is_used_[v] = 1;
        }
      }
      for (const std::uint32_t v : corners) is_used_[v] = 0;
      corners = corners_of_hull(points, normals_[piece_of_[begin]], std::move(corners));
      united_.corners.insert(united_.corners.end(), corners.begin(), corners.end());
    }
    united_.close();
    first_piece_[kept++] = end;
    begin = end;
  }
  first_piece_.resize(kept + 1);
  for (std::uint32_t k = kept; k > 0; --k) first_piece_[k] = first_piece_[k - 1];
  first_piece_[0] = 0;
}

void WordSurface::order_vertices() {
  const std::vector<WordVector>& points = numerators();
  is_used_.assign(points.size(), 0);
  for (const std::uint32_t v : rings().corners) is_used_[v] = 1;
  std::int64_t least = points[0][0], most = least;
  for (const WordVector& p : points) {
    least = std::min(least, p[0]);
    most = std::max(most, p[0]);
  }
  const int excess =
      std::max(0, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(most - least))) - 32);
  keys_.clear();
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (is_used_[v] == 0) continue;
    keys_.push_back(static_cast<std::uint64_t>(points[v][0] - least) >> excess << 32 | v);
  }
  sort_by_upper_half(keys_, spare_keys_);
  const auto number = [](std::uint64_t key) { return static_cast<std::uint32_t>(key); };
  for (std::size_t k = 0, end = 0; k < keys_.size(); k = end) {
    end = k + 1;
    while (end < keys_.size() && keys_[end] >> 32 == keys_[k] >> 32) ++end;
    if (end - k == 1) continue;
    std::sort(keys_.begin() + static_cast<std::ptrdiff_t>(k),
              keys_.begin() + static_cast<std::ptrdiff_t>(end),
              [&](std::uint64_t a, std::uint64_t b) {
                look_for_interrupt();
                return points[number(a)] < points[number(b)];
              });
  }
  rank_.resize(points.size());
  points_.resize(keys_.size());
  parents_.resize(keys_.size());
  for (std::uint32_t k = 0; k < keys_.size(); ++k) {
    const std::uint32_t v = number(keys_[k]);
    rank_[v] = k;
    points_[k] = points[v];
    parents_[k] = pairs_[v];
  }
}

/// Facets with the same least vertex differ at the second.
void WordSurface::order_facets() {
  const Rings& rings = this->rings();
  lowest_.resize(rings.size());
  first_of_.assign(points_.size() + 1, 0);
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    const std::uint32_t begin = rings.first[r], end = rings.first[r + 1];
    std::uint32_t lowest = begin;
    for (std::uint32_t k = begin + 1; k < end; ++k) {
      if (rank_[rings.corners[k]] < rank_[rings.corners[lowest]]) lowest = k;
    }
    lowest_[r] = lowest;
    ++first_of_[rank_[rings.corners[lowest]]];
  }
  add_up(first_of_);
  ring_of_.resize(rings.size());
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    ring_of_[first_of_[rank_[rings.corners[lowest_[r]]]]++] = r;
  }
  const auto second = [&](std::uint32_t r) {
    const std::uint32_t next = lowest_[r] + 1;
    return rank_[rings.corners[next == rings.first[r + 1] ? rings.first[r] : next]];
  };
  for (std::uint32_t v = 0, begin = 0; v < points_.size(); begin = first_of_[v++]) {
    look_for_interrupt();
    std::sort(ring_of_.begin() + begin, ring_of_.begin() + first_of_[v],
              [&](std::uint32_t a, std::uint32_t b) { return second(a) < second(b); });
  }
  facets_.corners.reserve(rings.corners.size());
  for (const std::uint32_t r : ring_of_) {
    const std::uint32_t begin = rings.first[r], end = rings.first[r + 1];
    for (std::uint32_t k = lowest_[r]; k < end; ++k) {
      facets_.corners.push_back(rank_[rings.corners[k]]);
    }
    for (std::uint32_t k = begin; k < lowest_[r]; ++k) {
      facets_.corners.push_back(rank_[rings.corners[k]]);
    }
    facets_.close();
  }
}

FacetParents WordSurface::facet_parents(std::uint32_t facet) const {
  FacetParents result;
  const std::uint32_t r = ring_of_[facet];
  const auto add = [&](std::uint32_t piece) {
    for (const std::uint32_t v : pieces_[piece]) {
      result.P.push_back(pairs_[v].p);
      result.Q.push_back(pairs_[v].q);
    }
  };
  if (!is_united_) {
    add(r);
  } else {
    for (std::uint32_t k = first_piece_[r]; k < first_piece_[r + 1]; ++k) add(piece_of_[k]);
  }
  for (auto* list : {&result.P, &result.Q}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  return result;
}

ConvexSum WordSurface::sum() const {
  ConvexSum result;
  result.vertex_parents = parents_;
  const IntegerVector& under = denominators();
  for (const WordVector& p : points_) {
    look_for_interrupt();
    result.surface.vertices.push_back(
        {Rational(p[0], under[0]), Rational(p[1], under[1]), Rational(p[2], under[2])});
  }
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    look_for_interrupt();
    const auto ring = facets_[f];
    result.surface.faces.emplace_back(ring.begin(), ring.end());
    result.facet_parents.push_back(facet_parents(f));
  }
  return result;
}

}  // namespace minkref::inline space
