(** The axioms that the theorems rest on. *)
From Proved Require Import Theorems Counting Holes Canonical Signs Passages Moves Events Outside
  Changes Hulls Decomposed Gaps Boundaries Rearranged Alike
  Decided Arranged Exact Judged Answered Lines Boundary Walls Facets Free Valid Trapped.
Print Assumptions form_is_right.
Print Assumptions one_point_is_right.
Print Assumptions outside_is_right.
Print Assumptions sign_is_right.
Print Assumptions passage_is_right.
Print Assumptions interval_is_right.
Print Assumptions event_is_right.
Print Assumptions body_is_right.
Print Assumptions free_is_right.
Print Assumptions hit_is_right.
Print Assumptions valid_is_right.
Print Assumptions escapes_is_right.
Print Assumptions trapped_is_right.
Print Assumptions trap_is_right.
(* What sets determine *)
Print Assumptions sum_is_union.
Print Assumptions membership_is_decided.
Print Assumptions kept_pieces_bound.
Print Assumptions cells_are_the_sum.
Print Assumptions parts_are_counted.
Print Assumptions legality_is_decided.
Print Assumptions exact_sum_is_right.
Print Assumptions decided_points_are_right_holds.
Print Assumptions verified_sum_is_sound_holds.
Print Assumptions verified_sum_is_the_only_one_holds.
Print Assumptions verified_sum_is_complete_holds.
Print Assumptions verified_combination_is_sound_holds.
Print Assumptions verified_combination_is_complete_holds.
Print Assumptions verified_combination_is_the_only_one_holds.
Print Assumptions verified_union_is_sound_holds.
Print Assumptions gap_separation.
Print Assumptions forms_agree.
Print Assumptions one_canonical_form_holds.
Print Assumptions rings_give_closed_sets_holds.
Print Assumptions another_form_is_another_set_holds.
Print Assumptions one_form_of_a_sum_holds.
Print Assumptions one_form_but_for_order_holds.
Print Assumptions one_figure_of_an_interval_holds.
Print Assumptions boundary_events_are_events_holds.
(* The paper's theory *)
Print Assumptions observation_1_holds.
Print Assumptions observation_1_printed_fails.
Print Assumptions crossings_move_linearly_holds.
Print Assumptions interval_of_a_pair_holds.
Print Assumptions interval_printed_fails.
Print Assumptions reflex_vertices_contribute_nothing_holds.
Print Assumptions incompatible_vertices_contribute_nothing_holds.
Print Assumptions boundary_in_reduced_convolution_holds.
Print Assumptions triangle_is_walled.
Print Assumptions theorem_1_second_half_fails.
Print Assumptions all_facets_may_change_and_no_edges_holds.
