(** The axioms that the theorems rest on. *)
From Proved Require Import Theorems Counting Holes Canonical Signs Passages Hulls.
Print Assumptions sum_is_right.
Print Assumptions point_is_right.
Print Assumptions components_are_right.
Print Assumptions holes_are_right.
Print Assumptions form_is_right.
Print Assumptions sign_is_right.
Print Assumptions passage_is_right.
Print Assumptions body_is_right.
