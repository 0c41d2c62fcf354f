(** The axioms that the theorems rest on. *)
From Proved Require Import Theorems Counting Holes Canonical Signs Passages Moves Events Outside
  Hulls.
Print Assumptions form_is_right.
Print Assumptions one_point_is_right.
Print Assumptions outside_is_right.
Print Assumptions sign_is_right.
Print Assumptions passage_is_right.
Print Assumptions interval_is_right.
Print Assumptions event_is_right.
Print Assumptions body_is_right.
