// Exact coordinates between Python and C++, as numbers of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "bindings/core.hpp"
#include "formats/limits.hpp"
#include "reference/plane/location.hpp"

namespace minkref::python {

/// For the program's own values: numbers of any length, and any count.
ReadLimits no_limits();

/// Makes a set from a Python object (minkref/shapes.py). For validation its rings are turned as
/// they should run; otherwise they keep their direction. Throws BadInput, and errors from
/// shapes.py.
Set set_of_shape(const nanobind::object& shape, bool validated);

/// The exact text of a Python number (minkref/shapes.py); a text stays unchanged. `where` names the
/// place for a refusal.
std::string number_text(nanobind::handle value, const std::string& where);

/// "inside", "boundary" or "outside".
std::string word_of(Location location);

/// An exact area or volume (minkref/quantity.py).
nanobind::object quantity(const Rational& value);

/// The rings as stored, as pairs of fractions.Fraction.
nanobind::list exact_rings(const Set& set);

/// The double next to a coordinate. Throws LimitExceeded ("not-representable") if the double is
/// infinite.
double finite_double(const Rational& coordinate);

/// The rings as stored, an array of doubles (n, 2) each, of the doubles next to the coordinates.
nanobind::list arrays_of_doubles(const Set& set);

/// Python's repr of a set: if short, an expression that makes the set again.
std::string shown(const Set& set);

}  // namespace minkref::python
