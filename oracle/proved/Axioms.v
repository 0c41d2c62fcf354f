(** The axioms that the theorems rest on. *)
From Proved Require Import Theorems.
Print Assumptions sum_is_right.
Print Assumptions point_is_right.
