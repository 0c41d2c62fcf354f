// The sum of convex polyhedra kept up to date under non-uniform scaling: where to start.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/number/float_environment.hpp"
#include "reference/space/convex/compatibility.hpp"
#include "reference/space/convex/index_set.hpp"
#include "reference/space/convex/sum_vertices.hpp"

namespace minkref::inline space {

/// Counts for one update: errors found and work done (Behar & Lien 2012, Sec. 6).
struct UpdateCounts {
  std::uint64_t fv_errors = 0;  ///< facets of P whose vertex of Q changed
  std::uint64_t vf_errors = 0;  ///< facets of Q whose vertex of P changed
  /// Edges walked to the new vertices: from the old vertex, or from a neighbouring facet's vertex
  /// if that vertex is higher.
  std::uint64_t descent_steps = 0;
  std::uint64_t ee_errors = 0;  ///< ee-pairs that are no more
  std::uint64_t ee_pairs_added = 0;
  std::uint64_t chains_walked = 0;
  /// Chains that the proof, not an error, found wrong: beside no facet of P, and along no way of a
  /// facet of Q, that changed its vertex.
  std::uint64_t chains_mended_by_proof = 0;
  /// Chains mended by proof that neither lost nor gained an edge from a facet of Q with a changed
  /// vertex. Theorem 1, with both operands' facets, excludes such chains.
  std::uint64_t chains_without_error = 0;
  std::uint64_t facets_examined = 0;  ///< those whose slack was used up
  std::uint64_t chains_examined = 0;
  std::uint64_t signs = 0;        ///< predicates evaluated
  std::uint64_t exact_signs = 0;  ///< those that doubles did not settle

  UpdateCounts& operator+=(const UpdateCounts& other);
};

/// `S P ⊕ Q` for changing S, as pairs of facets and vertices, in generic position
/// (compatibility.hpp); surface_of (convex_sum.hpp) gives the polyhedron. P and Q have to outlive
/// the object.
///
/// The state after any sequence of updates is a function of the last scaling alone. Every update
/// proves the pairs that it keeps: a facet's vertex is right if no edge there rises, a chain is
/// right if both ends and all signs are right. An update skips a check only if the scaling's drift
/// since the last check stays below the limit that every examined product allows.
class DynamicConvexSum {
 public:
  /// From scratch by `traversal` (static_convex_sum.hpp). Throws BadInput ("bad-scale"). The last
  /// argument lives while the members are made.
  DynamicConvexSum(const ConvexPolyhedron& P, const ConvexPolyhedron& Q, const Scaling& at,
                   const FloatEnvironment& standard = {});

  /// Mends the pairs that the new scaling makes wrong. Throws BadInput ("bad-scale") and keeps the
  /// state, as does an interrupt; std::logic_error would be a fault of ours and leave the state
  /// useless.
  UpdateCounts update(const Scaling& to);

  const ConvexPolyhedron& P() const { return contacts_.P(); }
  const ConvexPolyhedron& Q() const { return contacts_.Q(); }
  const Scaling& scaling() const { return scaling_.exact; }
  const Compatibility& compatibility() const { return state_; }
  /// All pairs (p, q) that sum to a facet's corner.
  const SumVertices& vertices() const { return vertices_; }
  std::uint64_t ee_pairs() const { return ee_pairs_; }

 private:
  void add_drift(double step);
  /// The deadline of a facet or chain that has this slack now, rounded down.
  double until(double slack) const { return std::nextafter(drift_ + slack, 0); }
  void mend_facets_of_P(UpdateCounts& counts);
  void mend_facets_of_Q(UpdateCounts& counts);
  void mend_chains(UpdateCounts& counts);
  void mend_chain(std::uint32_t edge, UpdateCounts& counts);
  bool is_chain_right(std::uint32_t edge);
  std::uint64_t common_edges(const std::vector<std::uint32_t>& chain,
                             const std::vector<std::uint32_t>& other);
  bool beside_moved_facet(const std::vector<std::uint32_t>& chain) const;
  void renew_vertices();
  void undo(const RoundedScaling& before);

  Contacts contacts_;
  RoundedScaling scaling_;
  Compatibility state_;
  SumVertices vertices_;
  std::uint64_t ee_pairs_ = 0;
  // A facet or chain stays right while `drift_` is below the deadline.
  double drift_ = 0;
  std::vector<double> deadline_P_, deadline_Q_, deadline_chain_;
  std::vector<std::vector<double>> deadline_links_;  // of a chain, whose own is the least of these
  // State during an update.
  IndexSet suspects_;                     // edges of P beside an error
  IndexSet moved_;                        // facets of Q with one
  IndexSet changed_at_P_, changed_at_Q_;  // vertices
  IndexSet in_chain_;                     // edges of Q
  std::vector<std::uint32_t> chain_before_, chain_after_, way_;
  // Earlier values for everything changed so far during the update.
  struct Before {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> vertex_of_Q, vertex_of_P;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> chains;  // edges, and links of each
    std::vector<std::uint32_t> links;
  } changed_;
};

}  // namespace minkref::inline space
