// Convex pieces of a polyhedron. docs/certificates-solids.md, "Pieces"
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/checker/space/space.hpp"

namespace minkref::checker {

/// The convex hull of points, each of which is one of its corners.
struct Hull {
  std::vector<Whole> points;
  std::map<Whole, std::vector<Whole>> facets;  ///< counter-clockwise, by their normals
  std::set<std::pair<Whole, Whole>> edges;     ///< from the lesser end
  std::set<Whole> ways;                        ///< their directions

  /// Throws NotVerified.
  Hull(std::vector<Whole> corners, Budget& budget);
  mpz_class support(const Whole& normal) const;
  bool holds(const Whole& point) const;
};

/// The pieces of an operand as a certificate gives them.
struct PieceList {
  std::vector<Triple> points;  ///< the vertices of the operand, and what is added to them
  std::vector<Ring> hulls;
};
PieceList read_pieces(const Value& value, const Body& body);

std::vector<Hull> hulls_of(const PieceList& list, const std::vector<Whole>& points, Budget& budget);

/// Demands that the facets of the pieces, less the operand's faces, cancel. Throws NotVerified.
void check_tiling(const Body& body, const std::vector<Hull>& pieces, Budget& budget);

/// The corners of a corner, an edge or a facet of a piece, ascending.
using Feature = std::vector<Whole>;

/// The pieces of an operand, scaled, with their features.
class SolidPieces {
 public:
  SolidPieces(std::vector<Hull> hulls, Budget& budget);
  SolidPieces(SolidPieces&&) = default;
  SolidPieces(const SolidPieces&) = delete;  // edges refer to features

  const std::vector<Hull>& hulls() const { return hulls_; }
  std::vector<mpz_class> supports(const Whole& normal) const;
  /// The features that are level along a normal, with their heights, such that no piece that holds
  /// one reaches above it.
  std::vector<std::pair<const Feature*, mpz_class>> tops(const Whole& normal, Budget& budget) const;
  /// Edges, with the corners of the pieces that hold them.
  struct Edge {
    const Feature* ends;
    std::set<Whole> around;
    bool is_top(const Whole& normal, mpz_class& height) const;
  };
  const std::vector<Edge>& edges() const { return edges_; }
  std::set<Whole> normals() const;  ///< of facets

 private:
  std::vector<Hull> hulls_;
  std::map<Feature, std::vector<std::uint32_t>> holders_;
  std::vector<Edge> edges_;
};

}  // namespace minkref::checker
