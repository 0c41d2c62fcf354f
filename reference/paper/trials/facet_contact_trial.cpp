#include "reference/paper/trials/facet_contact_trial.hpp"

#include <algorithm>
#include <vector>

#include "reference/error.hpp"
#include "reference/interrupt.hpp"
#include "reference/paper/space/facet_contacts.hpp"
#include "reference/paper/space/moving_facets_in.hpp"
#include "reference/paper/trials/misplaced.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/space/critical/moving_facet.hpp"
#include "reference/space/critical/parallel_facets.hpp"

namespace minkref {
namespace {

constexpr std::size_t most_facets = 3000;

/// Whether the answer has this contact's scale at another contact of the facets.
template <class T>
bool another_has(const std::vector<PaperContact<Rational>>& truth,
                 const std::vector<PaperContact<T>>& answer, std::size_t k) {
  for (std::size_t l = 0; l < truth.size(); ++l) {
    if (answer[l].scale && truth[l].scale && *truth[l].scale == *truth[k].scale) return true;
  }
  return false;
}

template <class T>
void compare(const std::vector<PaperContact<Rational>>& truth,
             const std::vector<PaperContact<T>>& answer, long bits, FacetContactTrial& result) {
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const bool solved = !truth[k].solutions.empty();
    const bool root = solved && truth[k].solutions[0].kind == Solution::root;
    for (const ScaleSolution<T>& found : answer[k].solutions) {
      if (!solved) break;  // no such system in truth
      result.roots += root;
      result.false_inconsistent += root && found.kind == Solution::inconsistent;
      result.false_identity += root && found.kind == Solution::identity;
      result.invented_roots += !root && found.kind == Solution::root;
    }
    const bool event = truth[k].scale.has_value(), answered = answer[k].scale.has_value();
    result.events += event;
    if (event && !answered && !another_has(truth, answer, k)) {
      ++result.missed;
      result.parallel_faces += answer[k].singular == Singular::parallel_faces;
      result.parallel_sides += answer[k].singular == Singular::parallel_sides;
      result.side_along_plane += answer[k].singular == Singular::side_along_plane;
    }
    result.invented += !event && answered;
    result.misplaced += event && answered && misplaced(*truth[k].scale, *answer[k].scale, bits);
  }
}

Integer largest(const SpaceOperand& body) {
  Integer most = 0;
  for (const auto& point : body.points) {
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, Integer(abs(point.exact[k])));
  }
  return most;
}

void count_parallel(const MovingConvolution& convolution, const MovingFacet& a,
                    const MovingFacet& b, FacetContactTrial& result) {
  ++result.pairs;
  if (!is_zero(cross(a.normal.exact, b.normal.exact))) return;
  ++(are_coplanar(convolution, a, b) ? result.coplanar_pairs : result.parallel_pairs);
}

}  // namespace

FacetContactTrial facet_contact_trial(const Polyhedron& P, const Polyhedron& Q,
                                      const std::string& arithmetic,
                                      const FacetReadings& readings) {
  FacetContactTrial result;
  if (P.empty() || Q.empty()) return result;
  const SpaceOperands operands = space_operands(P, Q, {1, 1, 1});
  const MovingConvolution convolution(operands.P, operands.Q);
  if (convolution.facets.size() > most_facets) {
    throw LimitExceeded(
        "too-many-facets",
        "the convolution has " + std::to_string(convolution.facets.size()) +
            " facets, and the paper's way looks at all pairs",
        "give operands whose convolution has at most " + std::to_string(most_facets));
  }
  const FacetReadings corrected = corrected_facet_readings();
  const Rational nothing = 0;
  const auto exact = facets_in<Rational>(convolution, {});
  with_arithmetic(arithmetic, [&]<class T>(const Arithmetic<T>& in) {
    const auto facets = facets_in<T>(convolution, in);
    const long bits = precision(in);
    const T zero = in(readings.tolerance * Rational(largest(operands.P) + largest(operands.Q)));
    for (std::size_t i = 0; i < facets.size(); ++i) {
      for (std::size_t j = i + 1; j < facets.size(); ++j) {
        look_for_interrupt();
        count_parallel(convolution, convolution.facets[i], convolution.facets[j], result);
        const auto truth = FacetContacts<Rational>(exact[i], exact[j], corrected, nothing).all();
        try {
          compare(truth, FacetContacts<T>(facets[i], facets[j], readings, zero).all(), bits,
                  result);
        } catch (const UndecidedSign&) {
          ++result.undecided_pairs;
        }
      }
    }
    return 0;
  });
  return result;
}

}  // namespace minkref
