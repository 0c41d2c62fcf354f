// The static Minkowski sum sP + Q by three routes that share as little as possible.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "reference/plane/polygon_set.hpp"
#include "reference/plane/tight_passages.hpp"

namespace minkref::inline plane {

enum class Route {
  paper,       ///< reduced convolution, orientable loops, nesting, collision detection (Sec. 3)
  winding,     ///< full signed convolution of operands cut to be simply connected
  definition,  ///< union of the sums of all pairs of triangles
};

/// Whether minkowski_sum also finds the tight passages. The paper's route already has their
/// arrangement; the other routes have to build it.
enum class Passages { leave, find };

/// How signs were decided (all counts since the call began).
struct Statistics {
  std::uint64_t by_float = 0;     ///< certified by the float filter
  std::uint64_t by_integer = 0;   ///< handed on, decided by exact integers of fixed width
  std::uint64_t by_rational = 0;  ///< decided by rationals
  std::string kernel;  ///< "grid64", "grid256", "rational", "double", "mpfr:53", "interval"
  std::size_t s_edges = 0, t_edges = 0;  ///< of the convolution used
  std::size_t nodes = 0, faces = 0;      ///< of its arrangement
  std::size_t orientable_faces = 0;      ///< faces that collision detection had to decide
};

struct Sum {
  PolygonSet region;  ///< canonical form (docs/definitions.md)
  std::size_t components = 0;
  std::size_t holes = 0;  ///< bounded components of the complement
  Statistics statistics;
  /// Set if asked for and the arithmetic is "rational": only exact passages mean anything.
  std::optional<std::vector<TightPassage>> tight_passages;
};

/// `sP + Q` at a rational scale s > 0 (docs/definitions.md, "Sum"). `arithmetic`: "rational"
/// (exact, the default: grid integers behind a float filter, or rationals), "interval" (throws
/// UndecidedSign where it cannot certify), "double" or "mpfr:BITS" (these arithmetics' answers;
/// may be wrong; route paper only). Operands must have passed `validate`, with Lines::allowed for
/// open lines. Two operands without area give the region alone; thin_sum.hpp has the rest. Throws
/// BadInput for s <= 0. Cost: paper O((N + k) log N), N the size of the reduced convolution.
Sum minkowski_sum(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                  Route route = Route::paper, const std::string& arithmetic = "rational",
                  Passages passages = Passages::leave);

/// The refusals of tight_passages: a scale <= 0, two operands without area.
void refuse_bad_operands(const PolygonSet& P, const PolygonSet& Q, const Rational& scale);

/// The area of a sum, exact; costs far more than its digits suggest (denominators multiply).
Rational area(const Sum& sum);

}  // namespace minkref::inline plane
