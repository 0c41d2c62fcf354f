// Parts of patches that certainly lie inside the interiors' sum, by pairs of convex pieces.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/plane/arrangement/box_tree.hpp"
#include "reference/plane/index/convex_pieces.hpp"

namespace minkref::inline plane {

/// Four points (x, s) as doubles: two at scale `low`, two at scale `high`. A coordinate's error is
/// at most 2^-44 of the coordinates of s P and of Q.
struct SweptQuad {
  std::array<double, 4> x{}, y{};
  double low = 0, high = 0;
};

/// The sums s A ⊕ B of convex A and B at all scales form a convex solid in (x, s): its sides are
/// flat, n x <= s h_A(n) + h_B(n) for the normals n of A's and B's sides. The solid holds a quad,
/// with its whole convex hull, if it holds the quad's four corners.
class InteriorSolids {
 public:
  /// For regions; for points and segments nothing is certain.
  InteriorSolids(const PolygonSet& P, const PolygonSet& Q);

  /// A pair of pieces.
  struct Pair {
    std::uint32_t of_P = 0, of_Q = 0;
    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  /// Chooses a few more pairs that hold as many samples as possible, best pairs first; leaves out
  /// pairs that hold next to none. Returns roughly the count of held samples.
  std::size_t choose(const std::vector<SweptQuad>& samples);

  /// True only if the quad certainly lies inside int(sP) ⊕ int(Q): some chosen pair holds the quad;
  /// the hint comes first. Some 10 ns a pair.
  bool chosen_holds(const SweptQuad& quad, std::uint32_t& hint) const;

  /// As chosen_holds for all pairs of pieces, up to a number of tries; the hint comes first.
  bool some_pair_holds(const SweptQuad& quad, int most_tries, Pair& hint) const;

 private:
  /// An operand's convex pieces.
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
  /// The least distance to sides, consumed entirely by rounding.
  double room_for(const SweptQuad& quad) const;
  double area(Pair pair, double scale) const;
  /// The largest among some pairs that hold the quad.
  std::optional<Pair> largest_pair(const SweptQuad& quad) const;
  template <class Look>
  bool each_candidate(const SweptQuad& quad, int most, Look&& look) const;

  Pieces P_, Q_;
  std::vector<Pair> chosen_;
};

}  // namespace minkref::inline plane
