// Faults that a test build can put into the reference, to see which check catches each
// (reports/faults). Other builds do not have them.
#pragma once

#include <cstdint>

namespace minkref {

// X(name, the fault).
#define MINKREF_FAULTS_IN_PLANE(X)                                                            \
  X(turn_ends_alike, "both sides of the convolution take the turn [in, out)")                 \
  X(reflex_vertices_kept, "the reduced convolution takes reflex vertices")                    \
  X(straight_vertices_kept,                                                                   \
    "the convolution takes straight vertices, at edges of their direction")                   \
  X(last_edge_forgotten, "the last edge of each ring has no part in the convolution")         \
  X(hole_orientation_ignored, "holes are walked counter-clockwise")                           \
  X(end_on_segment_missed, "an end point on another segment is no node of the arrangement")   \
  X(overlap_cut_on_one_side, "of two overlapping segments only the first is cut")             \
  X(concurrent_crossings_apart, "crossings at one point of a segment are distinct nodes")     \
  X(filter_bound_too_small, "the sign of a turn is what doubles say")                         \
  X(grid_too_narrow, "64-bit integers where 256 bits are needed")                             \
  X(orientability_ignored, "every face but the unbounded one lies in the sum")                \
  X(collision_skipped, "every orientable face lies outside of the sum")                       \
  X(nesting_of_disconnected,                                                                  \
    "faces with boundary inside lie in the sum also for operands in pieces")                  \
  X(containment_forgotten, "P inside x - Q is not seen")                                      \
  X(winding_unsigned, "reflex pairs count +1 in the winding number")                          \
  X(slits_forgotten, "holes are not joined to their outer ring by slits")                     \
  X(triangle_forgotten, "the last triangle of an operand has no part in its definition")      \
  X(pinch_not_split, "a walk is not split at a repeated vertex")                              \
  X(pinch_paired_across, "at a pinch, edges are paired across the exterior")                  \
  X(collinear_vertex_kept, "vertices on a straight edge stay in the canonical form")          \
  X(hole_in_first_polygon, "a hole belongs to the first component")                           \
  X(holes_as_rings, "holes are counted as rings, not as components of the complement")        \
  X(length_of_other_edge, "the ends of a pair of edges are taken at each other's scale")      \
  X(printed_interval, "the paper's printed interval for the corrected one")                   \
  X(first_lower_bound_only, "of two lower bounds of an interval the first counts")            \
  X(touching_pairs_dropped, "edges that meet at one scale only have no event")                \
  X(parallel_overlap_dropped, "parallel edges that come to overlap have no event")            \
  X(containment_on_line_missed, "of edges on one line, one within the other has no event")    \
  X(triple_of_s_edges_skipped, "three S-edges have no triple event")                          \
  X(swap_on_one_edge_only, "a triple event swaps nodes along the first of its edges only")    \
  X(equal_scales_apart, "events of one scale are groups of their own")                        \
  X(near_scales_together, "events that doubles cannot tell apart are one group")              \
  X(order_not_updated, "a step down does not undo swaps")                                     \
  X(stale_position, "nodes stay where they are until the next event")                         \
  X(status_guessed, "a new sub-edge has the status of the one before it")                     \
  X(tight_taken_for_boundary, "a sub-edge in contact on both sides counts as boundary")       \
  X(right_side_forgotten, "no face is asked what is on its right, where a passage may hide")  \
  X(boundary_piece_at_event_lost, "pieces of the boundary at the scale of an event are lost") \
  X(smallest_part_goes_on, "where a hole splits, its smallest part keeps its name")           \
  X(touch_overlooked, "a hole in several parts at one scale only is no event")                \
  X(only_both_sides_compared,                                                                 \
    "the boundary below a scale is compared with that above, not with that at the scale")     \
  X(parents_of_one_edge, "of edges on one line only one is a parent of a boundary event")     \
  X(place_as_it_comes, "a boundary event is at the last of its places that is looked at")     \
  X(tight_points_missed, "tight points on no tight segment are missed")                       \
  X(tight_unproved, "any sub-edge with edges both ways is tight")                             \
  X(wedges_forgotten, "tight passages from the rings as given, not wedge by wedge")           \
  X(polylines_cut, "a tight polyline ends at each of its points")                             \
  X(touching_is_apart, "a point of contact does not belong to the sum")

#define MINKREF_FAULTS_IN_SPACE(X)                                                                \
  X(ties_in_space_alike, "ties of a normal and a direction are decided alike for P and Q")        \
  X(parallelogram_upside_down, "the parallelogram of two edges e and f faces along e x f always") \
  X(facet_along_line_missed, "a facet that lies along a line has no part in its pieces")          \
  X(border_taken_for_inside,                                                                      \
    "a line that meets the border of a facet is taken to cross its inside")                       \
  X(upper_side_dropped, "where a facet crosses a line, the piece above it is dropped")            \
  X(shared_piece_lost, "a piece that lies on several sides belongs to none of them")              \
  X(sectors_untested, "any candidate sector about a piece is outside")                            \
  X(narrow_sector_by_normals, "the direction into a narrow sector is the sum of two normals")     \
  X(looked_beyond_the_end, "of a piece cut at its start the point is taken beyond its end")       \
  X(into_before_along, "the point beside a piece goes into the sector first, then along")         \
  X(edges_of_Q_untested, "whether an edge of x - Q pierces a triangle of P is not looked at")     \
  X(contained_one_way, "in space P inside x - Q is not seen, but x - Q inside P is")              \
  X(first_shell_only,                                                                             \
    "of several shells only the first is looked for inside of the other operand")                 \
  X(touching_facets_apart, "a facet that only touches the plane of another is apart from it")     \
  X(there_and_back_kept, "edges there and back within a face of a sum do not cancel")             \
  X(cells_of_corners_only, "a triangle touches the cells of its corners only")                    \
  X(cells_reached_by_boxes, "a cell that the box of a triangle meets has a point of the operand") \
  X(cubes_of_one_cell, "one cell inside of an operand is enough to cover a cell of the sum")      \
  X(middle_cell_misplaced, "two cells cover the lower cell of the sum, not that in the middle")   \
  X(pair_of_pieces_forgotten, "the last pair of convex pieces has no part in the union")          \
  X(covered_by_each_other, "of equal facets of two sums of pieces each covers the other")         \
  X(opposite_facet_kept, "a facet is not covered by a body on the other side of its plane")       \
  X(merged_by_one_side, "convex pieces are merged where one lies below the planes of the other")  \
  X(slits_missed, "an edge in the inside of a face is no slit")                                   \
  X(odd_crossings_missed, "an edge in which three planes cross, and no region ends, is missed")   \
  X(sectors_exchanged, "shells are joined across interior and outside the wrong way round")       \
  X(own_rounding_unbounded, "the bound of a double leaves out the rounding of the double itself") \
  X(underflow_taken_for_exact, "a double is exact where the bounds of what it is made of vanish")

#define MINKREF_FAULTS_WITH_DISC(X)                                                              \
  X(edges_moved_inwards, "edges are moved to the side of the set, not away from it")             \
  X(blocked_end_dropped,                                                                         \
    "a curve is free from the end of the last blocked part on, however far others go")           \
  X(arc_blocked_once,                                                                            \
    "a blocked part over the start and the end of an arc is that at its end only")               \
  X(ridge_left_free, "edges that face each other at the diameter leave a gap of no width")       \
  X(touch_not_cut, "a curve is not cut where another touches it")                                \
  X(facing_polygons_apart, "polygons that face each other at the diameter are not joined")       \
  X(other_wedge_at_corner, "at a point a ring goes on across the wedge that it bounds")          \
  X(winding_off_by_one, "what the convolution with a disc winds around once is outside")         \
  X(reflex_arc_forwards, "the arc about a reflex vertex runs the way of a convex one")           \
  X(event_on_other_branch, "the place of an event in roots is the other one of its features")    \
  X(joint_missed, "a place in front of an end of an edge has the end only")                      \
  X(second_place_missed, "two points and a line have one place that is as far from all")         \
  X(branches_alike, "both points of a line and a circle are one branch")                         \
  X(corner_taken_for_tight, "a lone point of a curve is tight even where another curve goes on") \
  X(tight_segment_missed, "what edges that face each other leave is no tight segment")

#define MINKREF_FAULTS_IN_REFERENCE(X) \
  MINKREF_FAULTS_IN_PLANE(X) MINKREF_FAULTS_IN_SPACE(X) MINKREF_FAULTS_WITH_DISC(X)

enum class Fault : std::uint8_t {
#define MINKREF_FAULT_NAME(name, what) name,
  MINKREF_FAULTS_IN_REFERENCE(MINKREF_FAULT_NAME)
#undef MINKREF_FAULT_NAME
};

#ifdef MINKREF_FAULTS
/// Whether the environment variable MINKREF_FAULT names this fault.
bool planted(Fault fault);
#else
constexpr bool planted(Fault) { return false; }
#endif

}  // namespace minkref
