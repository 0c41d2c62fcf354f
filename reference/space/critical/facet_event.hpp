// At which scales two facets of the convolution start, change and stop to meet (Sec. 5.1, 5.2).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/number/rational.hpp"
#include "reference/space/critical/crossing_line.hpp"
#include "reference/space/critical/event_scale.hpp"
#include "reference/space/critical/exact_corners.hpp"

namespace minkref::inline space {

/// How facets touch: one facet's corner meets the other facet, perhaps on the border; sides of both
/// meet; or parallel facets reach one plane, and share an area.
enum class ContactKind : std::uint8_t { vertex, edge, parallel };
/// The change as s grows: facets start to meet, stop, meet at this scale only, or meet along a
/// segment one of whose ends passes from one side to another.
enum class ContactChange : std::uint8_t { birth, death, touch, pass };

/// A pair's event. For a vertex the corner `of_first` of the first facet, `of_second` of the
/// second, or both if they coincide; for an edge the sides of both facets, each named by the first
/// corner; for parallel facets one corner of each that lies inside the other facet, if any.
struct FacetEvent {
  static constexpr std::uint8_t no_corner = UINT8_MAX;
  ContactKind kind;
  ContactChange change;
  std::uint8_t of_first = no_corner, of_second = no_corner;
  EventScale s;
};

inline constexpr std::size_t most_sides = 8;  ///< of two facets

/// The pairs (s, t) for which the point t on the crossing line of two facets' planes at the scale s
/// lies in both facets: a convex polygon, since (s, x) with x in a facet at s is a convex set. The
/// polygon's corners are the events. Exact: signs by doubles with bounds, else by integers.
class ContactRegion {
 public:
  /// The facets must not be parallel; all arguments must outlive the region.
  ContactRegion(const MovingConvolution& convolution, const MovingFacet& first,
                const MovingFacet& second, SignCounts& signs);

  /// Events with s > 0, ascending, within a window if given.
  std::vector<FacetEvent> events(const ScaleWindow* window = nullptr);

  /// Whether the facets share a point at a scale above 0.
  bool meet_at(const Rational& s);

 private:
  struct Corner {
    std::size_t i, j;    ///< of the constraints that are zero there
    std::uint8_t zeros;  ///< which constraints are
    EventScale s;
  };

  template <class Evaluate>
  int sign_of(Evaluate&& evaluate);
  int turn(std::size_t i, std::size_t j);
  template <class Direction>
  int height_at(const EventScale& s, const ConvolutionFacet::Corner& from,
                const ConvolutionFacet::Corner& to, Direction&& direction);
  bool corner_is_inside(std::size_t i, std::size_t j, const EventScale& s, unsigned& zeros);
  bool sides_cross(std::size_t i, std::size_t j, const EventScale& s, unsigned& zeros);
  std::array<ContactRow, most_sides>& rows();
  std::optional<Corner> corner_of(std::size_t i, std::size_t j);
  FacetEvent event_at(const Corner& corner);
  template <class T>
  MovingHeight<T> contact(std::size_t i, std::size_t j) const;
  bool is_level(std::size_t i, std::size_t j) const;
  std::size_t corner_between(std::size_t i, std::size_t j) const;
  bool are_opposite(std::size_t i, std::size_t j) const;
  bool have_no_scale(std::size_t i, std::size_t j) const;
  template <class Vertex>
  bool have_common(std::size_t i, std::size_t j, Vertex&& vertex) const;
  bool grows_from(const Corner& corner, int direction);

  const MovingConvolution& convolution_;
  const MovingFacet &first_, &second_;
  SignCounts& signs_;
  const ScaleWindow* window_ = nullptr;
  std::size_t count_;
  std::optional<CrossingLine> line_;  ///< with rows and turns once these are asked for
  std::array<ContactRow, most_sides> rows_;
  std::array<std::array<int, most_sides>, most_sides> turns_;
};

}  // namespace minkref::inline space
