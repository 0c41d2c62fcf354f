#include "reference/space/edges/convolution_facets.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <unordered_map>

#include "reference/interrupt.hpp"

namespace minkref::inline space {
namespace {

class ConvolutionBuild {
 public:
  ConvolutionBuild(const SpaceOperand& P, const SpaceOperand& Q) : P_(P), Q_(Q) {
    result_.shift = P.shift;
  }

  Convolution run() {
    triangles_at_vertices(P_, Q_, true);
    triangles_at_vertices(Q_, P_, false);
    edges_at_edges();
    return std::move(result_);
  }

 private:
  using Corner = ConvolutionFacet::Corner;

  /// The sign of normal · direction, with both moved along with P: either the normal or the
  /// direction belongs to P.
  int rises(const FilteredVector& normal, const FilteredVector& direction, bool normal_of_P) {
    const int sign = filtered_sign(result_.signs, [&]<class T>(std::type_identity<T>) {
      return dot(normal.as<T>(), direction.as<T>());
    });
    if (sign != 0) return sign;
    for (const Integer& n : normal.exact) {
      for (const Integer& d : direction.exact) {
        const int tie = n.sign() * d.sign();
        if (tie == 0) continue;
        return normal_of_P ? -tie : tie;
      }
    }
    return 0;
  }

  void triangles_at_vertices(const SpaceOperand& flat, const SpaceOperand& other, bool flat_is_P) {
    const auto is_farthest = [&](std::uint32_t v, const FilteredVector& normal) {
      for (const std::uint32_t e : other.edges_at[v]) {
        const SpaceOperand::Edge& edge = other.edges[e];
        const int rise = rises(normal, edge.direction, flat_is_P);
        if ((edge.from == v ? rise : -rise) >= 0) return false;
      }
      return true;
    };
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t) {
      look_for_interrupt_now();
      const SpaceOperand::Triangle& triangle = flat.triangles[t];
      for (std::uint32_t v = 0; v < other.points.size(); ++v) {
        if (!is_farthest(v, triangle.normal)) continue;
        ConvolutionFacet facet;
        facet.kind = flat_is_P ? FacetKind::fv : FacetKind::vf;
        facet.size = 3;
        facet.of_P = flat_is_P ? t : v;
        facet.of_Q = flat_is_P ? v : t;
        facet.normal = triangle.normal;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t corner = triangle.corners[k];
          facet.names[k] = flat_is_P ? Corner{corner, v} : Corner{v, corner};
          facet.sides[k] = side(flat_is_P, triangle.edges[k], v);
        }
        add(std::move(facet));
      }
    }
  }

  void edges_at_edges() {
    for (std::uint32_t e = 0; e < P_.edges.size(); ++e) {
      look_for_interrupt_now();
      if (!P_.edges[e].convex) continue;
      for (std::uint32_t f = 0; f < Q_.edges.size(); ++f) {
        if (Q_.edges[f].convex) add_parallelogram(e, f);
      }
    }
  }

  /// The arcs of the two edges on the Gaussian map cross: with P's edge going from left to right,
  /// Q's comes from the left or from the right.
  void add_parallelogram(std::uint32_t e, std::uint32_t f) {
    const SpaceOperand::Edge& p = P_.edges[e];
    const SpaceOperand::Edge& q = Q_.edges[f];
    int side = 0;  // of the normal: that of cross(p, q), or its reverse
    const auto agrees = [&](int sign) {
      if (side == 0) side = sign;
      return sign != 0 && sign == side;
    };
    if (p.left != none) {
      if (!agrees(rises(P_.triangles[p.left].normal, q.direction, true))) return;
      if (!agrees(-rises(P_.triangles[p.right].normal, q.direction, true))) return;
    }
    if (q.left != none) {
      if (!agrees(-rises(Q_.triangles[q.left].normal, p.direction, false))) return;
      if (!agrees(rises(Q_.triangles[q.right].normal, p.direction, false))) return;
    }
    ConvolutionFacet facet;
    facet.kind = FacetKind::ee;
    facet.size = 4;
    facet.of_P = e;
    facet.of_Q = f;
    const IntegerVector across = cross(p.direction.exact, q.direction.exact);
    if (is_zero(across)) return;
    const bool along_cross = side > 0;
    facet.normal = FilteredVector(along_cross ? across : IntegerVector{} - across, 2 * P_.shift);
    const Corner start{p.from, q.from}, end{p.to, q.to};
    const Corner along_P{p.to, q.from}, along_Q{p.from, q.to};
    const std::uint32_t P_first = this->side(true, e, q.from), P_last = this->side(true, e, q.to);
    const std::uint32_t Q_first = this->side(false, f, p.from), Q_last = this->side(false, f, p.to);
    if (along_cross) {
      facet.names = {start, along_P, end, along_Q};
      facet.sides = {P_first, Q_last, P_last, Q_first};
    } else {
      facet.names = {start, along_Q, end, along_P};
      facet.sides = {Q_first, P_last, Q_last, P_first};
    }
    add(std::move(facet));
  }

  std::uint32_t side(bool edge_of_P, std::uint32_t edge, std::uint32_t vertex) {
    const std::uint64_t key =
        (std::uint64_t{edge} << 33) | (std::uint64_t{vertex} << 1) | std::uint64_t{edge_of_P};
    const auto [found, fresh] =
        numbers_.emplace(key, static_cast<std::uint32_t>(result_.sides.size()));
    if (fresh) {
      const SpaceOperand::Edge& e = (edge_of_P ? P_ : Q_).edges[edge];
      if (edge_of_P) {
        result_.sides.push_back({{e.from, vertex}, {e.to, vertex}, {}});
      } else {
        result_.sides.push_back({{vertex, e.from}, {vertex, e.to}, {}});
      }
    }
    return found->second;
  }

  void add(ConvolutionFacet facet) {
    const auto number = static_cast<std::uint32_t>(result_.facets.size());
    for (std::uint8_t k = 0; k < facet.size; ++k) {
      const Corner& name = facet.names[k];
      facet.corners[k] =
          FilteredVector(P_.points[name.of_P].exact + Q_.points[name.of_Q].exact, P_.shift);
      facet.box.add(box_around(facet.corners[k].rounded));
      result_.sides[facet.sides[k]].uses.push_back({number, k});
    }
    facet.offset = FilteredInteger(dot(facet.normal.exact, facet.corners[0].exact), 3 * P_.shift);
    result_.facets.push_back(std::move(facet));
  }

  const SpaceOperand &P_, &Q_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  Convolution result_;
};

/// Replaces triangles, face by face and vertex by vertex.
class PieceReplacement {
 public:
  PieceReplacement(Convolution& convolution, const FlatPieces& pieces, const SpaceOperand& body,
                   const SpaceOperand& other, bool of_P)
      : convolution_(convolution), pieces_(pieces), body_(body), other_(other), of_P_(of_P) {}

  void run() {
    const FacetKind kind = of_P_ ? FacetKind::fv : FacetKind::vf;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<ConvolutionFacet>> faces;
    std::vector<bool> replaced(convolution_.facets.size());
    for (std::size_t k = 0; k < replaced.size(); ++k) {
      ConvolutionFacet& facet = convolution_.facets[k];
      if (facet.kind != kind) continue;
      const std::uint32_t face = pieces_.face_of[of_P_ ? facet.of_P : facet.of_Q];
      if (face == none) continue;
      replaced[k] = true;
      faces[{face, of_P_ ? facet.of_Q : facet.of_P}].push_back(facet);
    }
    for (FacetSide& side : convolution_.sides) {
      std::erase_if(side.uses, [&](const FacetSide::Use& use) { return replaced[use.facet]; });
    }
    leave_out(convolution_, replaced);
    for (const auto& [at, triangles] : faces) {
      look_for_interrupt_now();
      sides_.clear();
      for (const ConvolutionFacet& triangle : triangles) {
        const std::uint32_t own = of_P_ ? triangle.of_P : triangle.of_Q;
        for (std::size_t k = 0; k < 3; ++k) {
          sides_[body_.triangles[own].edges[k]] = triangle.sides[k];
        }
      }
      for (const FlatPiece& piece : pieces_.pieces[at.first].pieces)
        add(piece, triangles.front(), at.second);
    }
  }

 private:
  using Corner = ConvolutionFacet::Corner;

  void add(const FlatPiece& piece, const ConvolutionFacet& triangle, std::uint32_t vertex) {
    const long shift = convolution_.shift;
    const IntegerVector& move = other_.points[vertex].exact;
    const auto number = static_cast<std::uint32_t>(convolution_.facets.size());
    ConvolutionFacet facet;
    facet.kind = triangle.kind;
    facet.size = piece.size;
    facet.of_P = triangle.of_P;
    facet.of_Q = triangle.of_Q;
    facet.normal = triangle.normal;
    facet.offset = triangle.offset;
    auto lines = std::make_shared<ConvolutionFacet::Piece>();
    for (std::size_t k = 0; k < piece.size; ++k) {
      const FlatPiece::Corner& corner = piece.corners[k];
      facet.names[k] = corner.vertex == none ? Corner{none, convolution_.unnamed++}
                                             : name(corner.vertex, vertex);
      facet.corners[k].exact = corner.point + corner.weight * move;
      facet.corners[k].rounded = rounded_point(facet.corners[k].exact, corner.weight, shift);
      facet.box.add(box_around(facet.corners[k].rounded));
      lines->weights[k] = corner.weight;
      lines->starts[k] = FilteredVector(piece.sides[k].start.exact + move, shift);
      lines->alongs[k] = piece.sides[k].along;
    }
    facet.piece = std::move(lines);
    for (std::uint8_t k = 0; k < piece.size; ++k) {
      const std::uint32_t edge = piece.sides[k].edge;
      const auto known = sides_.find(edge);
      const bool is_shared = edge != none && !convolution_.sides[known->second].uses.empty();
      if (is_shared) {
        facet.sides[k] = known->second;
        continue;
      }
      facet.sides[k] = static_cast<std::uint32_t>(convolution_.sides.size());
      convolution_.sides.push_back(
          {facet.names[k], facet.names[(k + 1U) % piece.size], {{number, k}}});
    }
    convolution_.facets.push_back(std::move(facet));
  }

  Corner name(std::uint32_t own, std::uint32_t vertex) const {
    return of_P_ ? Corner{own, vertex} : Corner{vertex, own};
  }

  Convolution& convolution_;
  const FlatPieces& pieces_;
  const SpaceOperand &body_, &other_;
  bool of_P_;
  std::unordered_map<std::uint32_t, std::uint32_t> sides_;  ///< by edge
};

}  // namespace

Convolution convolution_facets(const SpaceOperand& P, const SpaceOperand& Q) {
  return ConvolutionBuild(P, Q).run();
}

void put_pieces(Convolution& convolution, const FlatPieces& pieces, const SpaceOperand& body,
                const SpaceOperand& other, bool of_P) {
  if (pieces.pieces.empty()) return;
  PieceReplacement(convolution, pieces, body, other, of_P).run();
}

void leave_out(Convolution& convolution, const std::vector<bool>& facets) {
  std::vector<std::uint32_t> number(facets.size(), none);
  std::uint32_t left = 0;
  for (std::uint32_t k = 0; k < facets.size(); ++k) {
    if (facets[k]) continue;
    number[k] = left;
    if (left != k) convolution.facets[left] = std::move(convolution.facets[k]);
    ++left;
  }
  convolution.facets.resize(left);
  for (FacetSide& side : convolution.sides) {
    for (FacetSide::Use& use : side.uses) use.facet = number[use.facet];
    if (std::any_of(side.uses.begin(), side.uses.end(),
                    [](const FacetSide::Use& use) { return use.facet == none; })) {
      side.uses.clear();
    }
  }
}

}  // namespace minkref::inline space
