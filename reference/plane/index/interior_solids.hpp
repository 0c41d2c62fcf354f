// Which parts of patches are certainly in the sum of the interiors, by pairs of convex pieces.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/index/convex_pieces.hpp"

namespace minkref::inline plane {

/// Four points (x, s), in doubles: two at scale `low`, two at scale `high`. Each coordinate is off
/// by at most 2^-44 of the coordinates of s P and of Q.
struct SweptQuad {
  std::array<double, 4> x{}, y{};
  double low = 0, high = 0;
};

/// The sums s A ⊕ B of convex A and B at all scales make a convex solid in (x, s): its sides are
/// flat, n x <= s h_A(n) + h_B(n) for the normals n of the sides of A and B. A quad, and all of its
/// convex hull, lies within if its four corners do.
class InteriorSolids {
 public:
  /// For regions; for points and segments nothing is certain.
  InteriorSolids(const PolygonSet& P, const PolygonSet& Q);

  /// A pair of pieces.
  struct Pair {
    std::uint32_t of_P = 0, of_Q = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  /// Chooses few pairs more that hold as many of these as may be, those that hold most first; pairs
  /// that hold next to none are of no use. Gives about how many they hold.
  std::size_t choose(const std::vector<SweptQuad>& samples);

  /// True only if the quad is certainly in int(sP) ⊕ int(Q): one of the chosen pairs holds it; the
  /// hint is tried first. Some 10 ns a pair.
  bool chosen_holds(const SweptQuad& quad, std::uint32_t& hint) const;

  /// The same for all pairs of pieces, up to a number of tries; the hint is tried first.
  bool some_pair_holds(const SweptQuad& quad, int most_tries, Pair& hint) const;

 private:
  /// The convex pieces of an operand.
  struct Pieces {
    std::vector<ConvexPiece> all;
    std::vector<Box> boxes;
    std::vector<double> areas;  ///< twice
    BoxTree tree;
    std::vector<std::uint32_t> first;  ///< sides of piece k: first[k] .. first[k + 1]
    std::vector<std::array<double, 2>> normals;
    std::vector<double> own;     ///< of a side the product with its normal
    std::vector<double> others;  ///< and the reach of each piece of the other operand, side by side
    double size = 0;             ///< the greatest coordinate of the operand

    explicit Pieces(const PolygonSet& set);
    void measure(const std::vector<ConvexPiece>& other);
  };

  bool holds(Pair pair, const SweptQuad& quad, double room) const;
  /// The least distance to sides, of which rounding takes all.
  double room_for(const SweptQuad& quad) const;
  double area(Pair pair, double scale) const;
  /// The largest of some pairs that hold the quad.
  std::optional<Pair> largest_pair(const SweptQuad& quad) const;
  template <class Look>
  bool each_candidate(const SweptQuad& quad, int most, Look&& look) const;

  Pieces P_, Q_;
  std::vector<Pair> chosen_;
};

}  // namespace minkref::inline plane
