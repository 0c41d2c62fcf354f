// Convex pieces of a polyhedron. docs/certificates-solids.md, "Pieces"
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "oracle/checker/space/space.hpp"

namespace minkref::checker {

/// The convex hull of points, all of them corners.
struct Hull {
  std::vector<Whole> points;
  std::map<Whole, std::vector<Whole>> facets;  ///< counter-clockwise, by their normals
  std::set<std::pair<Whole, Whole>> edges;     ///< from the lesser end
  std::set<Whole> ways;                        ///< the edges' directions

  /// Throws NotVerified.
  Hull(std::vector<Whole> corners, Budget& budget);
  mpz_class support(const Whole& normal) const;
  bool holds(const Whole& point) const;
};

/// An operand's pieces as the certificate gives them.
struct PieceList {
  std::vector<Triple> points;  ///< the operand's vertices, then added points
  std::vector<Ring> hulls;
};
PieceList read_pieces(const Value& value, const Body& body);

std::vector<Hull> hulls_of(const PieceList& list, const std::vector<Whole>& points, Budget& budget);

/// Demands that the pieces' facets, minus the operand's faces, cancel. Throws NotVerified.
void check_tiling(const Body& body, const std::vector<Hull>& pieces, Budget& budget);

/// The corners, ascending, of a piece's corner, edge or facet.
using Feature = std::vector<Whole>;

/// An operand's scaled pieces, with their features.
class SolidPieces {
 public:
  SolidPieces(std::vector<Hull> hulls, Budget& budget);
  SolidPieces(SolidPieces&&) = default;
  SolidPieces(const SolidPieces&) = delete;  // edges refer to features

  const std::vector<Hull>& hulls() const { return hulls_; }
  std::vector<mpz_class> supports(const Whole& normal) const;
  /// Returns the features level along a normal, with their heights, above which no piece that holds
  /// the feature reaches.
  std::vector<std::pair<const Feature*, mpz_class>> tops(const Whole& normal, Budget& budget) const;
  /// An edge, with the corners of all pieces that hold it.
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
