// Where to cut P: the pocket minimum of each feature that lasts long enough.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <vector>

#include "reference/disc/features/feature_level.hpp"

namespace minkref::inline disc {

/// Diameters alpha = 2 ρ, in P's coordinates.
struct NotchWindow {
  Rational alpha;                    ///< 0: the limit, at which each reflex end is a feature
  Rational persistence;              ///< bars must be longer, in alpha
  std::optional<Rational> alpha_to;  ///< of the bars only the part up to here counts, from alpha on
};

struct Notch {
  std::uint32_t leaf;  ///< tree node
  std::uint32_t feature, bar;
  Enclosure depth;  ///< between doubles, as P is written; 0 at alpha 0; infinite without bridges
  bool is_tie;      ///< of several vertices equally deep in the feature the least one
};

/// The notches, the longest bar first (an essential bar, or one that ends at infinity, is longest),
/// then the deepest, then by place. Without `alpha_to`, these bars are longer than any persistence.
/// Exact. O(n log n) comparisons, and O(l b) for the l reflex ends and b bridges of each feature.
/// Throws LimitExceeded ("too-many-roots") as LeafDepth does, and for lengths.
std::vector<Notch> notches(const Bridges& bridges, const MergeTree& tree, const Barcode& codes,
                           const NotchWindow& window);

/// Compares bars' lengths, exactly.
class BarLengths {
 public:
  BarLengths(const DiscIndex& index, const Barcode& codes) : index_(index), codes_(codes) {}

  /// The sign of a's length less b's.
  int compare(std::uint32_t a, std::uint32_t b);
  /// Whether a bar, from a least radius on up to a greatest, is longer than some number; radii
  /// within the frame.
  bool is_longer(std::uint32_t bar, const Rational& length, const Rational& from,
                 const std::optional<Rational>& to);

 private:
  bool is_infinite(const FeatureBar& bar) const {
    return bar.is_essential || bar.death > index_.radii();
  }
  const Surd& radius(std::uint32_t number);
  /// Adds events' radii to a rational number, subtracts others, and returns the sum's sign.
  int sign_of_sum(std::initializer_list<std::uint32_t> added,
                  std::initializer_list<std::uint32_t> subtracted, const Rational& rest);

  const DiscIndex& index_;
  const Barcode& codes_;
  std::map<std::uint32_t, Surd> radii_;
};

}  // namespace minkref::inline disc
