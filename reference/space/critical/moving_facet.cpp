#include "reference/space/critical/moving_facet.hpp"

namespace minkref::inline space {
namespace {

/// A side of a facet is an edge of P or of Q.
FilteredVector from_corner(const SpaceOperand& P, const SpaceOperand& Q,
                           const ConvolutionFacet::Corner& a, const ConvolutionFacet::Corner& b) {
  const bool is_of_P = a.of_P != b.of_P;
  const SpaceOperand& body = is_of_P ? P : Q;
  const std::uint32_t from = is_of_P ? a.of_P : a.of_Q, to = is_of_P ? b.of_P : b.of_Q;
  return {body.points[to].exact - body.points[from].exact, body.shift};
}

}  // namespace

MovingConvolution::MovingConvolution(const SpaceOperand& P_, const SpaceOperand& Q_)
    : P(P_), Q(Q_) {
  for (const ConvolutionFacet& facet : convolution_facets(P, Q).facets) {
    MovingFacet moving{facet.kind,  facet.size,   facet.of_P, facet.of_Q,
                       facet.names, facet.normal, {}};
    for (std::size_t k = 0; k < facet.size; ++k) {
      moving.along[k] = from_corner(P, Q, facet.names[k], facet.names[(k + 1) % facet.size]);
    }
    facets.push_back(std::move(moving));
  }
}

}  // namespace minkref::inline space
