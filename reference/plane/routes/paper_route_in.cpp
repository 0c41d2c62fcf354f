// The paper's route with arithmetics other than rational: their answers.
#include "reference/number/exact_value.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/boundary/face_boundary.hpp"
#include "reference/plane/kernel/arithmetic_name.hpp"
#include "reference/plane/routes/boundary_rings.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"
#include "reference/plane/routes/paper_route.hpp"
#include "reference/plane/routes/routes.hpp"

namespace minkref::inline plane {
namespace {

template <class T>
auto scaled_frame(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                  const Arithmetic<T>& arithmetic) {
  ScalarFrame<T> frame{
      {}, scalar_operand<T>(P, arithmetic), scalar_operand<T>(Q, arithmetic), arithmetic};
  const T s = arithmetic(scale);
  for (auto& ring : frame.P.rings) {
    for (auto& v : ring) v = Vector2<T>(T(v.x() * s), T(v.y() * s));
  }
  return frame;
}

template <class T, class Finish>
auto run(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
         const Arithmetic<T>& arithmetic, Statistics& statistics, Finish&& finish) {
  const ScalarFrame<T> frame = scaled_frame(P, Q, scale, arithmetic);
  statistics.kernel = frame.name();
  const auto built = convolution_arrangement(frame.kernel, frame.P, frame.Q, false, statistics);
  const auto inside =
      faces_of_sum(built.arrangement, P, Q, PlainFaceCollision<T>(frame.kernel, frame.P, frame.Q),
                   statistics.orientable_faces);
  (std::is_same_v<T, Rational> ? statistics.by_rational : statistics.by_float) +=
      frame.kernel.counts.by_rational;
  return finish(built, inside);
}

/// Every sign is certified, so the structure is right and the positions follow exactly from the
/// nodes' parents.
Canonical interval_route(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                         Statistics& statistics) {
  return run<Interval>(P, Q, scale, {}, statistics, [&](const auto& built, const auto& inside) {
    const auto exact_p = scalar_operand<Rational>(scaled(P, scale), {});
    const auto exact_q = scalar_operand<Rational>(Q, {});
    const auto exact =
        convolution_segments<PlainKernel<Rational>>(built.convolution.edges, exact_p, exact_q);
    const PlainKernel<Rational> kernel;
    const auto start = [&](std::uint32_t i) { return exact.vertices[exact.segments[i].from]; };
    const auto direction = [&](std::uint32_t i) {
      return Vector2<Rational>(exact.vertices[exact.segments[i].to] - start(i));
    };
    return canonical_form(face_boundary(built.arrangement, inside, [&](std::uint32_t n) -> Point {
      const auto& from = built.arrangement.provenance(n);
      if (from.vertex != Arrangement<PlainKernel<Interval>>::none) {
        const auto& v = exact.vertices[from.vertex];
        return {v.x(), v.y()};
      }
      const auto d = direction(from.first);
      const Vector2<Rational> w(start(from.second) - start(from.first));
      const auto v =
          kernel.node(start(from.first), d, kernel.intersection(w, d, direction(from.second)));
      return {v.x(), v.y()};
    }));
  });
}

template <class T>
Canonical rounding_route(const PolygonSet& P, const PolygonSet& Q, const Rational& scale,
                         const Arithmetic<T>& arithmetic, Statistics& statistics) {
  return run<T>(P, Q, scale, arithmetic, statistics, [&](const auto& built, const auto& inside) {
    return canonicalize(boundary_rings(built.arrangement, inside, [&](std::uint32_t n) -> Point {
      const auto& v = built.arrangement.node(n);
      return {exact_value(v.x()), exact_value(v.y())};
    }));
  });
}

}  // namespace

Canonical paper_route_in(const std::string& arithmetic, const PolygonSet& P, const PolygonSet& Q,
                         const Rational& scale, Statistics& statistics) {
  if (arithmetic == "interval") return interval_route(P, Q, scale, statistics);
  if (arithmetic == "double") return rounding_route<double>(P, Q, scale, {}, statistics);
  return rounding_route<Mpfr>(P, Q, scale, Arithmetic<Mpfr>(*mpfr_bits(arithmetic)), statistics);
}

}  // namespace minkref::inline plane
