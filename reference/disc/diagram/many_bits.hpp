// Floating-point numbers with a fixed number of bits, for places that doubles do not tell apart.
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace minkref::inline disc {

/// At least so many. Rounded: they decide nothing.
template <unsigned bits>
using ManyBits =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<
                                      bits * 301 / 1000 + 1, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

}  // namespace minkref::inline disc
