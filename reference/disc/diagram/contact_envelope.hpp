// For each rounded point of an offset curve, the feature of P that the point meets first as the
// radius grows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reference/disc/diagram/edge_lookup.hpp"

namespace minkref::inline disc {

/// A part of a patch that meets one feature first, between two points of the outer Voronoi diagram,
/// or perhaps the patch's ends.
struct FirstContact {
  std::uint32_t feature;
  Vector<double> first, last;  ///< the points of the diagram
};

/// Lower envelopes of the radii at which a patch's points meet the other features. These radii are
/// quadratic along an edge; about a vertex their inverses times 1 + t² are quadratic, t being the
/// tangent of half the angle. Rounded: results need proof, and so does completeness. `Real` is
/// double, or a type with more bits if doubles do not tell places apart.
template <class Real>
class ContactEnvelopes {
 public:
  /// `lookup` must outlive it.
  explicit ContactEnvelopes(const EdgeLookup& lookup);

  /// The contacts along the patch, in order. Points that meet nothing belong to no contact.
  std::vector<FirstContact> of(std::uint32_t patch) const;

 private:
  struct Quadratic {
    Real a, b, c;  ///< a u² + b u + c
    Real at(const Real& u) const { return (a * u + b) * u + c; }
  };
  struct Part {
    Real from, to;
    Quadratic value;  ///< less is nearer
    std::uint32_t feature;
  };
  using Parts = std::vector<Part>;
  struct Frame;
  struct Reach;
  struct Ahead;

  bool is_noise(const Part& part, const Part& beside) const;
  Frame frame_of(std::uint32_t patch) const;
  void add_point(const Frame& frame, std::uint32_t feature, const Vector<Real>& q,
                 Parts& parts) const;
  void add_line(const Frame& frame, std::uint32_t edge, Parts& parts) const;
  Reach within(const Frame& frame, const Real& reach) const;
  static void keep_where(const Quadratic& value, Parts& parts);
  static Parts lowest(const Parts& a, const Parts& b);
  static Parts envelope(const Parts& all, std::span<const std::size_t> starts);
  std::vector<FirstContact> found(const Frame& frame, Parts parts) const;

  const EdgeLookup& lookup_;
  const OffsetCurves& curves_;
  struct Edge {
    Vector<Real> start, along, normal;  ///< the normal has the length 1
    Real square;
  };
  std::vector<Edge> edges_;
};

}  // namespace minkref::inline disc
