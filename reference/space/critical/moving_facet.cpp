#include "reference/space/critical/moving_facet.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace minkref::inline space {
namespace {

/// Coordinates below 2^b have differences below 2^(b + 1); the cross products lie below 2^(2b + 3),
/// and scalar products of cross products with differences below 2^(3b + 6).
constexpr unsigned most_bits = 40;

std::optional<std::vector<WordVector>> words_of(const SpaceOperand& body) {
  std::vector<WordVector> points;
  for (const auto& point : body.points) {
    WordVector& words = points.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Integer& c = point.exact[k];
      if (!c.is_zero() && mpz_sizeinbase(c.backend().data(), 2) > most_bits) return std::nullopt;
      words[k] = static_cast<std::int64_t>(c);
    }
  }
  return points;
}

unsigned longest(const std::vector<WordVector>& points) {
  std::uint64_t most = 0;
  for (const WordVector& point : points) {
    for (const std::int64_t c : point) most |= static_cast<std::uint64_t>(std::abs(c));
  }
  return static_cast<unsigned>(std::bit_width(most));
}

/// Every side comes from an edge of P or an edge of Q.
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
  auto of_P = words_of(P), of_Q = words_of(Q);
  if (of_P && of_Q) {
    const unsigned bits = std::max(longest(*of_P), longest(*of_Q));
    words = Words{std::move(*of_P), std::move(*of_Q), bits};
  }
}

bool stays_aside(const MovingConvolution& convolution, const MovingFacet& flat,
                 const MovingFacet& other, const BoundedDouble& from, const BoundedDouble& to) {
  const BoundedVector& n = flat.normal.rounded;
  const auto &P = convolution.P.points, &Q = convolution.Q.points;
  const BoundedVector &p = P[flat.names[0].of_P].rounded, &q = Q[flat.names[0].of_Q].rounded;
  int side = 0;
  for (std::size_t k = 0; k < other.size; ++k) {
    const BoundedDouble slope = dot(n, P[other.names[k].of_P].rounded - p),
                        start = dot(n, Q[other.names[k].of_Q].rounded - q);
    for (const BoundedDouble& s : {from, to}) {
      const int at = (slope * s + start).certain_sign();
      if (at == 0 || at == BoundedDouble::undecided || (side != 0 && at != side)) return false;
      side = at;
    }
  }
  return true;
}

}  // namespace minkref::inline space
