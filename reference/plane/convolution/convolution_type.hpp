// The two convolutions of two polygon sets (Behar & Lien 2012, Sec. 3).
#pragma once

#include <cstdint>

namespace minkref::inline plane {

/// The edges at strictly convex vertices, or those at reflex vertices too.
enum class ConvolutionType : std::uint8_t { reduced, full };

}  // namespace minkref::inline plane
