// The proof of a sum: cells that tile a box, each covered by two pieces or apart from all.
#pragma once

#include <memory>

#include "certify/plane/cell_complex.hpp"
#include "reference/plane/sum.hpp"

namespace minkref::certify {

/// A line or corner as a certificate numbers them: 0 to 3 are the walls of the box.
struct Element {
  enum class Kind : std::uint8_t { P, Q, up, meet } kind = Kind::meet;
  std::uint32_t a = 0, b = 0, c = 0;  ///< meet: two lines; up: a corner; else as in LineSource
};

struct CellProof {
  bool covered = false;
  std::uint32_t A = 0, B = 0;      ///< for a covered cell
  std::vector<std::int64_t> code;  ///< for other cells (separation.hpp); normals by number
};

/// A point or segment that the sum of the interiors misses.
struct ContactProof {
  std::vector<std::uint32_t> corners;
  std::vector<std::int64_t> code;
};

struct SumProof {
  std::vector<Rational> scales;  ///< one scale; or two, and the proof holds between
  std::array<Rational, 4> box;
  std::vector<Element> elements;
  std::vector<std::vector<std::uint32_t>> cells;  ///< elements
  std::vector<std::pair<Integer, Integer>> normals;
  std::vector<CellProof> proofs;
  std::vector<ContactProof> contacts;
  /// For each polygon of the canonical form its rings, for each ring the elements along it.
  std::vector<std::vector<std::vector<std::uint32_t>>> polygons;
  std::vector<std::vector<std::uint32_t>> passages;  ///< elements along each
  std::vector<Ring> passage_points;                  ///< where those are
  /// The canonical form's moving vertices, by polygon and ring; over two scales only.
  std::vector<std::vector<std::vector<MovingPoint>>> vertices;
  /// Points that the rings pass more than once, as often as they come again; as they move over two
  /// scales, else with no slope.
  std::vector<MovingPoint> touching;
};

class ConvolutionLines;

/// Both operands, ready for proofs at any scale.
class Prover {
 public:
  /// Takes operands that have passed `validate`. Throws BadInput as minkowski_sum does.
  Prover(const PolygonSet& P, const PolygonSet& Q);
  ~Prover();

  const PolygonSet& P() const { return set_P_; }
  const PolygonSet& Q() const { return set_Q_; }
  const PieceTree& pieces_of_P() const { return P_; }
  const PieceTree& pieces_of_Q() const { return Q_; }

  /// A box with integer walls that holds the sums at all scales up to the largest, with room
  /// around.
  std::array<Rational, 4> box(const Rational& largest) const;

  /// Proves a sum that the reference found at a scale, with its tight passages if the sum has them.
  /// Throws std::logic_error if the set given is not the sum. Exact.
  SumProof prove(const Sum& sum, const Rational& scale, const std::array<Rational, 4>& box);

  /// The same for all scales between two around `scale`, as far apart as this proof goes within
  /// [from, to]; nothing if it holds at `scale` only.
  std::optional<SumProof> prove_around(const Sum& sum, const Rational& scale,
                                       const std::array<Rational, 4>& box, const Rational& from,
                                       const Rational& to);

 private:
  PolygonSet set_P_, set_Q_;
  NormalTable normals_;
  PieceTree P_, Q_;
  std::unique_ptr<ConvolutionLines> convolution_;
};

}  // namespace minkref::certify
