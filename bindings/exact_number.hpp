// Exact numbers as fractions.Fraction of Python: what public values give out.
#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <tuple>
#include <utility>

#include "reference/number/rational.hpp"

/// An exact number in the signatures of users' methods (minkref/argument_types.py).
#define MINKREF_NUMBER "str | int | fractions.Fraction"

namespace minkref::python {

/// A number that crosses the border as a Fraction. Made without the interpreter lock; the Fraction
/// is made when the result of the call is.
struct ExactNumber {
  Rational value;
};

/// Three of them: a point, or an area along each axis.
using ExactTriple = std::tuple<ExactNumber, ExactNumber, ExactNumber>;

inline std::optional<ExactNumber> exact_number(const std::optional<Rational>& value) {
  return value ? std::optional(ExactNumber{*value}) : std::nullopt;
}

/// The Fraction of a number.
nanobind::object fraction_of(const Rational& value);

}  // namespace minkref::python

NAMESPACE_BEGIN(NB_NAMESPACE)
NAMESPACE_BEGIN(detail)

template <>
struct type_caster<minkref::python::ExactNumber> {
  NB_TYPE_CASTER(minkref::python::ExactNumber, const_name("fractions.Fraction"))

  bool from_python(handle, uint8_t, cleanup_list*) noexcept { return false; }
  static handle from_cpp(const minkref::python::ExactNumber& number, rv_policy,
                         cleanup_list*) noexcept {
    try {
      return minkref::python::fraction_of(number.value).release();
    } catch (const python_error& error) {
      const_cast<python_error&>(error).restore();
      return {};
    }
  }
};

NAMESPACE_END(detail)
NAMESPACE_END(NB_NAMESPACE)
