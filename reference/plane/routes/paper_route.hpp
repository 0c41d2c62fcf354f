// The sum from the reduced convolution: orientable loops, nesting, collision detection (Behar &
// Lien 2012, Sec. 3).
#pragma once

#include <vector>

#include "reference/interrupt.hpp"
#include "reference/plane/arrangement/arrangement.hpp"
#include "reference/plane/arrangement/exact_arrangement.hpp"
#include "reference/plane/arrangement/interior_point.hpp"
#include "reference/plane/lines.hpp"
#include "reference/plane/routes/collision.hpp"
#include "reference/plane/routes/convolution_arrangement.hpp"

namespace minkref::inline plane {

/// Whether every segment along a face's boundary runs against the face. The sum lies left of each
/// convolution edge, so only such a face can lie outside the sum.
template <class K>
bool orientable(const Arrangement<K>& arrangement, std::uint32_t face) {
  bool result = true;
  arrangement.for_each_half_edge(face, [&](std::uint32_t h) {
    for (auto cover = arrangement.covers_begin(h); result && cover != arrangement.covers_end(h);
         ++cover) {
      result = !arrangement.runs_with(h, *cover);
    }
  });
  return result;
}

/// Membership of an interior point of a face, found and decided as exactly as the kernel can.
template <class Grid>
class FaceCollision {
 public:
  using K = GridKernel<Grid>;
  FaceCollision(const K& kernel, const Operand<typename K::Vector>& P,
                const Operand<typename K::Vector>& Q)
      : kernel_(kernel), P_(P), Q_(Q), collision_(kernel, P, Q) {}

  bool operator()(const Arrangement<K>& arrangement, std::uint32_t face) {
    if (const auto x = interior_point_in_doubles(kernel_, arrangement, face)) {
      return collision_.meets(*x);
    }
    const Point x = exact_interior_point(kernel_, arrangement, face);
    const auto rational = [](const Operand<typename K::Vector>& operand) {
      Operand<Vector2<Rational>> result;
      result.is_outer = operand.is_outer;
      for (const auto& ring : operand.rings) {
        auto& to = result.rings.emplace_back();
        for (const auto& v : ring) {
          to.emplace_back(Rational(grid_integer(v.x())), Rational(grid_integer(v.y())));
        }
      }
      return result;
    };
    const auto P = rational(P_), Q = rational(Q_);
    const PlainKernel<Rational> exact;
    return Collision<PlainKernel<Rational>>(exact, P, Q).meets(Vector2<Rational>(x.x, x.y));
  }

 private:
  const K& kernel_;
  const Operand<typename K::Vector>& P_;
  const Operand<typename K::Vector>& Q_;
  Collision<K> collision_;
};

template <class T>
class PlainFaceCollision {
 public:
  using K = PlainKernel<T>;
  PlainFaceCollision(const K& kernel, const Operand<typename K::Vector>& P,
                     const Operand<typename K::Vector>& Q)
      : kernel_(kernel), collision_(kernel, P, Q) {}
  bool operator()(const Arrangement<K>& arrangement, std::uint32_t face) {
    return collision_.meets(interior_point(kernel_, arrangement, face));
  }

 private:
  const K& kernel_;
  Collision<K> collision_;
};

/// The collision detection that fits a frame.
template <class Grid>
FaceCollision<Grid> face_collision(const GridFrame<Grid>& frame) {
  return {frame.kernel, frame.P, frame.Q};
}
template <class T>
PlainFaceCollision<T> face_collision(const ScalarFrame<T>& frame) {
  return {frame.kernel, frame.P, frame.Q};
}

/// Whether a face of the reduced convolution's arrangement belongs to the sum. `meets(arrangement,
/// face)` decides by collision detection, and is asked only about faces that could lie outside.
/// With `connected` operands, a face with boundary inside it cannot lie outside (proper nesting: a
/// connected set's complement has connected boundaries).
template <class K, class Meets>
bool face_in_sum(const Arrangement<K>& arrangement, std::uint32_t face, bool connected,
                 Meets&& meets, std::size_t& asked) {
  if (face == 0) return false;
  if (connected && arrangement.cycles(face).size() > 1) return true;
  if (!orientable(arrangement, face)) return true;
  ++asked;
  return meets(arrangement, face);
}

/// face_in_sum for every face.
template <class K, class Meets>
std::vector<bool> faces_of_sum(const Arrangement<K>& arrangement, bool connected, Meets&& meets,
                               std::size_t& asked) {
  std::vector<bool> inside;
  inside.reserve(arrangement.face_count());
  for (std::uint32_t face = 0; face < arrangement.face_count(); ++face) {
    look_for_interrupt();
    inside.push_back(face_in_sum(arrangement, face, connected, meets, asked));
  }
  return inside;
}

/// The same for two operands. Beside an edge of two without area there may be no sum, on either
/// side: there collision detection decides each face.
template <class K, class Meets>
std::vector<bool> faces_of_sum(const Arrangement<K>& arrangement, const PolygonSet& P,
                               const PolygonSet& Q, Meets&& meets, std::size_t& asked) {
  if (!is_thin(P) || !is_thin(Q)) {
    return faces_of_sum(arrangement, connected(P) && connected(Q), meets, asked);
  }
  std::vector<bool> inside{false};
  for (std::uint32_t face = 1; face < arrangement.face_count(); ++face) {
    look_for_interrupt();
    inside.push_back(meets(arrangement, face));
  }
  return inside;
}

}  // namespace minkref::inline plane
