// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between exact polygons and CGAL's. Only compilation units for CGAL methods include
// this.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/version.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <type_traits>

#include "oracle/cgal/method.hpp"

namespace minkref::cgal_oracle {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;
using ExactNumber = std::decay_t<decltype(CGAL::exact(std::declval<Kernel::FT>()))>;

/// Converts a number. A double that holds the value exactly spares the kernel a rational.
inline Kernel::FT to_cgal(const mpq_class& value) {
  const double approximate = value.get_d();
  // GMP takes no infinity.
  if (std::isfinite(approximate) && value == approximate) return Kernel::FT(approximate);
  if constexpr (std::is_constructible_v<ExactNumber, const __mpq_struct*>) {
    return Kernel::FT(ExactNumber(value.get_mpq_t()));
  } else {  // CGAL built on a rational type other than GMP's
    std::istringstream text(value.get_str());
    ExactNumber number;
    text >> number;
    return Kernel::FT(number);
  }
}

/// CGAL's exact type depends on its version and configuration.
template <class Number>
mpq_class rational(const Number& number) {
  if constexpr (requires { mpq_class(number.backend().data()); }) {  // Boost over GMP
    return mpq_class(number.backend().data());
  } else if constexpr (requires { mpq_class(number.mpq()); }) {  // CGAL::Gmpq
    return mpq_class(number.mpq());
  } else {
    std::ostringstream text;
    text << number;
    mpq_class result(text.str(), 10);
    result.canonicalize();
    return result;
  }
}

inline mpq_class from_cgal(const Kernel::FT& value) { return rational(CGAL::exact(value)); }

inline CgalRing to_cgal(const Ring& ring) {
  CgalRing result;
  for (const Point& p : ring) result.push_back(Kernel::Point_2(to_cgal(p.x), to_cgal(p.y)));
  return result;
}

inline Ring from_cgal(const CgalRing& ring) {
  Ring result;
  for (const auto& p : ring) result.push_back({from_cgal(p.x()), from_cgal(p.y())});
  return result;
}

inline CgalPolygon to_cgal(const Polygon& polygon) {
  CgalPolygon result(to_cgal(polygon.outer));
  for (const Ring& hole : polygon.holes) result.add_hole(to_cgal(hole));
  return result;
}

inline Polygon from_cgal(const CgalPolygon& polygon) {
  Polygon result{from_cgal(polygon.outer_boundary()), {}};
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
    result.holes.push_back(from_cgal(*hole));
  }
  return result;
}

template <class A, class B, class Call>
Sum timed(const A& p, const B& q, Call&& call) {
  const auto start = std::chrono::steady_clock::now();
  const CgalPolygon sum = call(p, q);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return {from_cgal(sum), taken.count()};
}

/// Calls a method that takes only simple polygons.
template <class Call>
Sum sum_of_simple(const Polygon& p, const Polygon& q, Call&& call) {
  return timed(to_cgal(p.outer), to_cgal(q.outer), call);
}

/// Calls the overload that a CGAL user would call: Polygon_2 without holes, Polygon_with_holes_2
/// with holes.
template <class Call>
Sum sum_of_any(const Polygon& p, const Polygon& q, Call&& call) {
  if (p.holes.empty() && q.holes.empty()) return sum_of_simple(p, q, call);
  if (p.holes.empty()) return timed(to_cgal(p.outer), to_cgal(q), call);
  if (q.holes.empty()) return timed(to_cgal(p), to_cgal(q.outer), call);
  return timed(to_cgal(p), to_cgal(q), call);
}

}  // namespace minkref::cgal_oracle
