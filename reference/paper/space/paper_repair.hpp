// The paper's repair of a convex sum after a scaling (Sec. 6), with one arithmetic, each sentence
// as read.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/paper/space/repair_readings.hpp"
#include "reference/space/convex/compatibility.hpp"
#include "reference/space/convex/sum_vertices.hpp"

namespace minkref::inline space {

/// A facet with an incompatible vertex of the other body, and the descent from this vertex.
struct FacetError {
  bool of_P = true;  ///< an fv-error; otherwise a facet of Q and a vertex of P
  std::uint32_t facet = 0;
  std::uint32_t vertex = 0;  ///< before

  struct Step {
    std::uint32_t vertex, witness;  ///< from, and the other end of the edge that is the witness
    Rational squared_degree;        ///< IC squared, as the arithmetic has it
  };
  std::vector<Step> steps;
  /// The compatible vertex found. None: the descent came to a vertex again and so never ends; the
  /// facet keeps its former vertex.
  std::optional<std::uint32_t> end;
};

/// An edge of P with a new search for its compatible edges.
struct ChainRepair {
  std::uint32_t edge = 0;
  std::vector<std::uint32_t> before, after;  ///< half-edges of Q, as in Compatibility
  /// No edge led on before the vertex of the other facet was reached, or all edges did.
  bool stuck = false;
};

struct RepairReport {
  std::vector<FacetError> errors;
  std::vector<ChainRepair> chains;  ///< chains that changed or got stuck
  std::uint64_t chains_walked = 0;
  std::uint64_t ee_errors = 0;  ///< pairs of edges that were found to be no more
};

/// The interface of a PaperRepair, whatever its arithmetic.
class PaperRepair {
 public:
  /// Starts from the exact pairs at the first scaling. `arithmetic`: "rational", "interval",
  /// "double", "mpfr:BITS". Exact with exact arithmetic and corrected readings; otherwise the
  /// paper's text decides the result. P and Q have to outlive it. Throws BadInput for bad scalings
  /// and arithmetics.
  static std::unique_ptr<PaperRepair> make(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                                           const Scaling& first, const std::string& arithmetic,
                                           const RepairReadings& readings);
  virtual ~PaperRepair() = default;

  /// Looks for errors at the new scaling and repairs them. Throws BadInput ("bad-scale"), with the
  /// state unchanged; UndecidedSign where the arithmetic cannot tell a sign, with a useless state
  /// afterwards. O(m + n + ee-pairs), and the descents.
  virtual RepairReport update(const Scaling& to) = 0;

  /// The pairs claimed as compatible. Links of a chain need not hang together.
  virtual const Compatibility& compatibility() const = 0;
  virtual const Scaling& scaling() const = 0;

  /// s_i p_i + q_i for pairs of vertices: the exact values of this arithmetic's results.
  virtual std::vector<SpacePoint> coordinates(
      const std::vector<SumVertices::Pair>& pairs) const = 0;
};

/// A claimed facet as pairs of vertices, counter-clockwise seen from outside for a true facet.
struct ClaimedFacet {
  enum class Kind : std::uint8_t { fv, vf, ee };
  Kind kind;
  std::vector<SumVertices::Pair> ring;
};

/// All facets of these pairs, each by itself. O(k).
std::vector<ClaimedFacet> claimed_facets(const ConvexPolyhedron& P, const ConvexPolyhedron& Q,
                                         const Compatibility& compatibility);

}  // namespace minkref::inline space
