#include "reference/disc/convolution/arc_convolution.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "reference/disc/convolution/arc_winding.hpp"
#include "reference/disc/region/disjoint_sets.hpp"

namespace minkref::inline disc {
namespace {

/// Finds the sum's boundary within an arrangement, and names it by the offset curves of P.
class ConvolutionBoundary {
 public:
  ConvolutionBoundary(const ArcArrangement& arrangement, const ArcFaces& faces,
                      ArcConvolution& result)
      : arrangement_(arrangement), faces_(faces), result_(result), at_(*result.offset.at) {}

  void run() {
    find_components();
    std::vector<bool> done(arrangement_.half_edges(), false);
    for (std::uint32_t first = 0; first < arrangement_.half_edges(); ++first) {
      if (done[first] || !is_boundary(first)) continue;
      std::vector<std::uint32_t> walk;
      for (std::uint32_t h = first; !done[h]; h = next(h)) {
        done[h] = true;
        walk.push_back(h);
      }
      add_ring(std::move(walk));
    }
  }

 private:
  int winding(std::uint32_t half_edge) const {
    return faces_.winding[faces_.of_cycle[arrangement_.cycle(half_edge)]];
  }
  /// The sum on the left, its complement on the right.
  bool is_boundary(std::uint32_t half_edge) const {
    return winding(half_edge) > 0 && winding(half_edge ^ 1U) == 0;
  }

  void find_components() {
    DisjointSets joined(faces_.winding.size());
    for (std::uint32_t h = 0; h < arrangement_.half_edges(); h += 2) {
      if (winding(h) > 0 && winding(h + 1) > 0) {
        joined.join(faces_.of_cycle[arrangement_.cycle(h)],
                    faces_.of_cycle[arrangement_.cycle(h + 1)]);
      }
    }
    std::map<std::uint32_t, std::uint32_t> numbers;
    std::size_t outside = 0;
    for (std::uint32_t face = 0; face < faces_.winding.size(); ++face) {
      if (faces_.winding[face] > 0) {
        const auto number = static_cast<std::uint32_t>(numbers.size());
        component_of_face_.push_back(numbers.try_emplace(joined.root(face), number).first->second);
      } else {
        component_of_face_.push_back(OffsetPatch::none);
        ++outside;
      }
    }
    result_.components = numbers.size();
    result_.holes = outside - 1;
  }

  /// Round the same wedge of the interior.
  std::uint32_t next(std::uint32_t half_edge) const {
    std::uint32_t h = arrangement_.clockwise(half_edge ^ 1U);
    while (!is_boundary(h)) h = arrangement_.clockwise(h);
    return h;
  }

  /// Whether both half-edges join into one piece: parts of the same patch, with no boundary
  /// between.
  bool goes_on(std::uint32_t half_edge, std::uint32_t following) const {
    if (patch(half_edge) != patch(following)) return false;
    const std::uint32_t other = half_edge ^ 1U;
    std::uint32_t h = arrangement_.clockwise(other);
    for (; h != other; h = arrangement_.clockwise(h)) {
      if (h != following && (is_boundary(h) || is_boundary(h ^ 1U))) return false;
    }
    return true;
  }

  std::uint32_t patch(std::uint32_t half_edge) const {
    const ArcSpan& span = arrangement_.span(half_edge);
    if (span.patch == OffsetPatch::none || (half_edge % 2 == 0) != (span.multiplicity > 0)) {
      throw std::logic_error("a curve that is no offset curve of P bounds the sum");
    }
    return span.patch;
  }

  void add_ring(std::vector<std::uint32_t> walk) {
    const std::size_t n = walk.size();
    std::size_t start = 0;
    while (start < n && goes_on(walk[(start + n - 1) % n], walk[start])) ++start;
    if (start == n) throw std::logic_error("a ring of a single patch");
    std::rotate(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(start), walk.end());
    std::vector<std::uint32_t> ring;
    for (std::size_t k = 0; k < n;) {
      std::size_t last = k;
      while (last + 1 < n && goes_on(walk[last], walk[last + 1])) ++last;
      ring.push_back(static_cast<std::uint32_t>(result_.offset.pieces.size()));
      result_.offset.pieces.push_back(
          {patch(walk[k]), place(walk[k], false), place(walk[last], true)});
      result_.component_of.push_back(
          component_of_face_[faces_.of_cycle[arrangement_.cycle(walk[k])]]);
      k = last + 1;
    }
    result_.offset.rings.push_back(std::move(ring));
  }

  /// The place on the patch where a half-edge starts or ends.
  PatchPlace place(std::uint32_t half_edge, bool is_end) const {
    const OffsetPatch& own = at_.curves().patches[patch(half_edge)];
    const ArcPiece& piece = arrangement_.pieces()[half_edge / 2];
    const ArcSpan& span = arrangement_.span(half_edge);
    const bool is_to = is_end == (half_edge % 2 == 0);
    if (is_to ? piece.has_last : piece.has_first) {
      if (own.edge == OffsetPatch::none) {
        const Direction& d = is_to ? span.last : span.first;
        if (cross(d, own.first) == 0) return PatchPlace::At::start;
        if (cross(d, own.last) == 0) return PatchPlace::At::end;
      } else {
        const OffsetEdge& edge = at_.curves().edges[own.edge];
        const Direction& way = arrangement_.curves().carriers[span.carrier].way;
        const Rational& t = is_to ? span.high : span.low;
        if (t == dot(way, {edge.start.x, edge.start.y})) return PatchPlace::At::start;
        if (t == dot(way, {edge.end.x, edge.end.y})) return PatchPlace::At::end;
      }
    }
    const std::uint32_t node = is_to ? piece.to : piece.from;
    PatchPlace found(PatchPlace::At::inside);
    found.position = arrangement_.nodes().position(node);
    found.near = key(own, found.position);
    const RootPoint& x = arrangement_.nodes().exact(node);
    found.exact = std::make_shared<const PatchPlace::Exact>(PatchPlace::Exact{key(own, x), x});
    return found;
  }

  template <class N>
  N key(const OffsetPatch& patch, const Vector<N>& x) const {
    if (patch.edge == OffsetPatch::none) {
      return dot(numbers<N>(turned(middle_of(patch))), x - numbers<N>(patch.centre));
    }
    const OffsetEdge& edge = at_.curves().edges[patch.edge];
    return dot(numbers<N>(edge.along), x - numbers<N>(edge.start)) / N(edge.squared_length);
  }

  const ArcArrangement& arrangement_;
  const ArcFaces& faces_;
  ArcConvolution& result_;
  const PatchesAt& at_;
  std::vector<std::uint32_t> component_of_face_;
};

}  // namespace

ArcConvolution arc_convolution(const PolygonSet& P, const Rational& squared_radius) {
  ArcConvolution result;
  result.offset.at = std::make_shared<const PatchesAt>(offset_curves(P), squared_radius);
  const ArcCurves curves = arc_curves(P, squared_radius, result.offset.at->curves());
  const ArcArrangement arrangement(curves, result.offset.counts);
  ConvolutionBoundary(arrangement, arc_faces(arrangement), result).run();
  return result;
}

}  // namespace minkref::inline disc
