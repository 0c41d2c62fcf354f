// Exact coordinates between Python and C++, as numbers of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "bindings/core.hpp"
#include "formats/limits.hpp"

namespace minkref::python {

/// For what the program itself holds: numbers of any length, and as many as there are.
ReadLimits no_limits();

/// A set of what Python hands in (minkref/shapes.py). Where it is to be validated its rings are
/// turned as they should run; else they stay as given. Throws BadInput, and what shapes.py raises.
Set set_of_shape(const nanobind::object& shape, bool validated);

/// The exact text of a number of Python (minkref/shapes.py); a text as it is. `where` it stands,
/// for the refusal.
std::string number_text(nanobind::handle value, const std::string& where);

/// The rings as stored, of pairs of fractions.Fraction.
nanobind::list exact_rings(const Set& set);

/// The double next to a coordinate. Throws LimitExceeded ("not-representable") where that is
/// infinite.
double finite_double(const Rational& coordinate);

/// The rings as stored, an array of doubles (n, 2) each, of the doubles next to the coordinates.
nanobind::list arrays_of_doubles(const Set& set);

/// The text by which Python shows a set: one that makes it again where it is short.
std::string shown(const Set& set);

}  // namespace minkref::python
