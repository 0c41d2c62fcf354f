// For each point of an offset curve, in doubles, which feature of P it meets first as the radius
// grows.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "reference/disc/offset_patch.hpp"
#include "reference/plane/arrangement/box_tree.hpp"

namespace minkref::inline disc {

struct Spot {
  double x, y;
};

/// A part of a patch on which one feature is met first, between two points of the outer Voronoi
/// diagram, or perhaps the ends of the patch.
struct FirstContact {
  std::uint32_t feature;
  double from, to;   ///< along the patch
  Spot first, last;  ///< the points of the diagram
  double first_radius, last_radius;
  bool has_least;  ///< the radius has a least value inside, or about at an end
  Spot least;
  double least_radius;
};

/// Lower envelopes of the radii at which the points of a patch meet the other features. These are
/// quadratic along an edge, and about a vertex so are their inverses times 1 + t², t being the
/// tangent of half the angle. Rounded: what is made of it has to be proven.
class ContactEnvelopes {
 public:
  /// `curves` must outlive it.
  explicit ContactEnvelopes(const OffsetCurves& curves);

  /// In order along the patch. Points that meet nothing are in none.
  std::vector<FirstContact> of(std::uint32_t patch) const;

  const plane::BoxTree& edges() const { return tree_; }
  /// Whether a vertex is on an edge of a line, or where one edge goes on straight as another.
  bool is_within(std::uint32_t line, std::uint32_t vertex) const {
    return within_.contains({line, vertex});
  }

 private:
  struct Quadratic {
    double a, b, c;  ///< a u² + b u + c
    double at(double u) const { return (a * u + b) * u + c; }
  };
  struct Part {
    double from, to;
    Quadratic value;  ///< less is nearer
    std::uint32_t feature;
  };
  using Parts = std::vector<Part>;
  struct Frame;

  void find_vertices_within();
  bool is_noise(const Part& part, const Part& beside) const;
  Frame frame_of(std::uint32_t patch) const;
  void add_point(const Frame& frame, std::uint32_t feature, const Spot& q, Parts& parts) const;
  void add_line(const Frame& frame, std::uint32_t edge, Parts& parts) const;
  static void keep_where(const Quadratic& value, Parts& parts);
  static Parts lowest(const Parts& a, const Parts& b);
  static Parts envelope(const std::vector<Parts>& all, std::size_t from, std::size_t to);
  std::vector<FirstContact> found(const Frame& frame, const Parts& all) const;

  const OffsetCurves& curves_;
  struct Edge {
    Spot start, along, normal;  ///< the normal has the length 1
    double square;
  };
  std::vector<Edge> edges_;
  plane::BoxTree tree_;
  double size_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> within_;
};

}  // namespace minkref::inline disc
