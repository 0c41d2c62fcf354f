// Open lines: several segments and points as one operand, in the form of a PolygonSet. Each is a
// polygon of its own with one or two vertices; they may meet in any way.
#pragma once

#include <vector>

#include "reference/plane/polygon_set.hpp"

namespace minkref::inline plane {

/// Whether a set has an area: it is not empty, and has no points and segments.
bool has_area(const PolygonSet& set);
/// Whether a set consists of points and segments, at least one.
bool is_thin(const PolygonSet& set);
/// Whether it has several.
bool is_lines(const PolygonSet& set);

/// Whether an operand may be open lines.
enum class Lines { refused, allowed };

/// As `validate`, and several points and segments pass if they are allowed. Without them:
/// "open-lines".
void validate(const PolygonSet& set, Lines lines);

/// From one point to another, which does not come before it (x, then y); or a point.
struct BareSegment {
  Point from, to;
  friend bool operator==(const BareSegment&, const BareSegment&) = default;
};

/// Joins collinear segments that overlap or touch, and drops points on segments: the maximal
/// segments and the points alone, sorted. Equal sets give equal lists. Exact. O(n log n + k) for k
/// points near segments.
std::vector<BareSegment> joined(std::vector<BareSegment> segments);

/// Cuts maximal segments wherever two of them meet, so that two parts share ends only. Exact.
/// O((n + k) log n) for k pairs of overlapping boxes.
std::vector<BareSegment> cut_at_contacts(const std::vector<BareSegment>& segments);

/// The segments and points of a set without area, as written.
std::vector<BareSegment> segments_of(const PolygonSet& lines);
PolygonSet lines_of(const std::vector<BareSegment>& segments);

/// The set's maximal segments and points; a set with an area stays.
PolygonSet joined_lines(const PolygonSet& set);
/// The same cut at all contacts.
PolygonSet cut_lines(const PolygonSet& set);

}  // namespace minkref::inline plane
