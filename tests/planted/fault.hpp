// The faults that the patches beside it put into the reference, and the switch: the environment
// variable MINKREF_FAULT names the one that is on. No build for use has any of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace minkref {

// In the order of the table in reports/evidence/planted_faults.md.
#define MINKREF_FAULTS(X)         \
  X(turn_ends_alike)              \
  X(reflex_vertices_kept)         \
  X(straight_vertices_kept)       \
  X(last_edge_forgotten)          \
  X(hole_orientation_ignored)     \
  X(end_on_segment_missed)        \
  X(overlap_cut_on_one_side)      \
  X(concurrent_crossings_apart)   \
  X(filter_bound_too_small)       \
  X(grid_too_narrow)              \
  X(orientability_ignored)        \
  X(collision_skipped)            \
  X(nesting_of_disconnected)      \
  X(containment_forgotten)        \
  X(winding_unsigned)             \
  X(slits_forgotten)              \
  X(triangle_forgotten)           \
  X(pinch_not_split)              \
  X(pinch_paired_across)          \
  X(collinear_vertex_kept)        \
  X(hole_in_first_polygon)        \
  X(holes_as_rings)               \
  X(length_of_other_edge)         \
  X(printed_interval)             \
  X(first_lower_bound_only)       \
  X(touching_pairs_dropped)       \
  X(parallel_overlap_dropped)     \
  X(containment_on_line_missed)   \
  X(triple_of_s_edges_skipped)    \
  X(swap_on_one_edge_only)        \
  X(equal_scales_apart)           \
  X(near_scales_together)         \
  X(order_not_updated)            \
  X(stale_position)               \
  X(status_guessed)               \
  X(tight_taken_for_boundary)     \
  X(right_side_forgotten)         \
  X(boundary_piece_at_event_lost) \
  X(smallest_part_goes_on)        \
  X(touch_overlooked)             \
  X(only_both_sides_compared)     \
  X(parents_of_one_edge)          \
  X(place_as_it_comes)            \
  X(tight_points_missed)          \
  X(tight_unproved)               \
  X(wedges_forgotten)             \
  X(polylines_cut)                \
  X(touching_is_apart)            \
  X(ties_in_space_alike)          \
  X(parallelogram_upside_down)    \
  X(facet_along_line_missed)      \
  X(border_taken_for_inside)      \
  X(upper_side_dropped)           \
  X(shared_piece_lost)            \
  X(sectors_untested)             \
  X(narrow_sector_by_normals)     \
  X(looked_beyond_the_end)        \
  X(into_before_along)            \
  X(edges_of_Q_untested)          \
  X(contained_one_way)            \
  X(first_shell_only)             \
  X(touching_facets_apart)        \
  X(there_and_back_kept)          \
  X(cells_of_corners_only)        \
  X(cells_reached_by_boxes)       \
  X(cubes_of_one_cell)            \
  X(middle_cell_misplaced)        \
  X(pair_of_pieces_forgotten)     \
  X(covered_by_each_other)        \
  X(opposite_facet_kept)          \
  X(merged_by_one_side)           \
  X(slits_missed)                 \
  X(odd_crossings_missed)         \
  X(sectors_exchanged)            \
  X(own_rounding_unbounded)       \
  X(underflow_taken_for_exact)    \
  X(edges_moved_inwards)          \
  X(blocked_end_dropped)          \
  X(arc_blocked_once)             \
  X(ridge_left_free)              \
  X(touch_not_cut)                \
  X(facing_polygons_apart)        \
  X(other_wedge_at_corner)        \
  X(winding_off_by_one)           \
  X(reflex_arc_forwards)          \
  X(event_on_other_branch)        \
  X(joint_missed)                 \
  X(second_place_missed)          \
  X(branches_alike)               \
  X(corner_taken_for_tight)       \
  X(tight_segment_missed)

enum class Fault : std::uint8_t {
#define MINKREF_FAULT_NAME(name) name,
  MINKREF_FAULTS(MINKREF_FAULT_NAME)
#undef MINKREF_FAULT_NAME
};

/// The number of the fault asked for; as many as there are: none.
inline std::size_t fault_asked_for() {
  constexpr auto names = std::to_array<std::string_view>({
#define MINKREF_FAULT_NAME(name) #name,
      MINKREF_FAULTS(MINKREF_FAULT_NAME)
#undef MINKREF_FAULT_NAME
  });
  const char* text = std::getenv("MINKREF_FAULT");
  if (text == nullptr || *text == '\0') return names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == text) return i;
  }
  std::fprintf(stderr, "MINKREF_FAULT=%s: there is no such fault\n", text);
  std::exit(2);
}

inline bool planted(Fault fault) {
  static const std::size_t number = fault_asked_for();
  return static_cast<std::size_t>(fault) == number;
}

}  // namespace minkref
