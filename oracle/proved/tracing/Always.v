(** The program that traces a set always answers. *)
From Coq Require Import Lra Bool QArith Qreals Permutation.
From Proved Require Import Definitions Form Legality Components Paths Decomposed Convolution.
From Proved Require Import Points Legal Member Decided Pieces Slabs Along Cuts Lone Flanks Kept
  Frontier Slabbed Cells Extent Reduced Linked Coloured Traced Arranged Exact Outer Accepted.
Open Scope R_scope.
Opaque parts outlines convolution boundary are_outlines.

(** For any set that segments and a program tell *)
Theorem traced_set_answers is_in all S : is_arranged is_in all S ->
  exists R holes, traced_set is_in all = Some (R, holes).
Proof.
  intros Arr. destruct (kept_pieces_bound _ _ _ Arr) as (St & Sd & Lg & Al).
  destruct Arr as (Rg & (low & high & H) & Fw & Const & Dec).
  set (B := boundary is_in all) in *.
  pose proof (inside_falls S Rg B St Lg Al Sd low high
    (fun y Y => proj1 (H y Y)) (fun y Y => proj2 (H y Y))) as Falls.
  assert (Pass : are_outlines all B (outlines all B) = true).
  { apply (outlines_pass S is_in all Fw Dec Const St Falls).
    - intros A I. destruct (one_outer_ring S is_in all Fw Dec Const St (parts B true) Falls A I high
        (fun y Y => proj2 (H y Y))) as (r & Q & _). eauto.
    - intros A I. exact (all_rings_kept S is_in all Fw Dec Const St (parts B true) Falls A I). }
  unfold traced_set. cbv zeta. fold B. rewrite Pass. eauto.
Qed.

Theorem exact_sum_answers : forall (s : Q) (P Q : list (polygon vertex)),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  exists R holes, exact_sum s (rings_of P) (rings_of Q) = Some (R, holes).
Proof.
  intros s P Q L LP LQ N.
  exact (traced_set_answers _ _ _ (sum_is_arranged s P Q L LP LQ N)).
Qed.
