(** The program that traces a sum always answers. *)
From Coq Require Import Lra Bool QArith Qreals Permutation.
From Proved Require Import Definitions Form Legality Components Paths Decomposed Convolution.
From Proved Require Import Points Legal Member Decided Pieces Slabs Along Cuts Lone Flanks
  Kept Frontier Slabbed Cells Extent Reduced Linked Coloured Traced Arranged Exact Outer Accepted.
Open Scope R_scope.
Opaque parts outlines convolution boundary are_outlines.

(** For any two sets that are drawn, one of them with an area *)
Theorem traced_sum_answers E F S T : drawn (map R2e E) S -> drawn (map R2e F) T ->
  has_area (map R2e E) S \/ has_area (map R2e F) T ->
  (is_slim E = false -> bordered (map R2e E) S) /\ (is_slim F = false -> bordered (map R2e F) T) ->
  exists R holes, traced_sum E F = Some (R, holes).
Proof.
  intros DE DF Ar Ki.
  destruct (kept_pieces_bound E F S T DE DF Ar Ki) as (St & Sd & Lg & Al).
  destruct (set_bounded E F S T DE DF) as (low & high & H).
  pose proof (sum_regular _ _ S T DE DF Ar) as Rg.
  assert (Dec : forall v, decide_point E F v = true <-> sum_set S T (R2 v)).
  { intros v. rewrite (sum_is_union_here E F S T DE DF).
    apply decide_point_is_right; [apply DE|apply DF]. }
  pose proof (convolution_forward E F) as Fw.
  pose proof (sum_steady E F S T DE DF Ar Ki) as Const.
  pose proof (inside_falls (sum_set S T) Rg (sum_boundary E F) St Lg Al Sd low high
    (fun y Y => proj1 (H y Y)) (fun y Y => proj2 (H y Y))) as Falls.
  assert (Pass : are_outlines (convolution E F) (sum_boundary E F)
    (outlines (convolution E F) (sum_boundary E F)) = true).
  { apply (outlines_pass (sum_set S T) (decide_point E F) Dec (convolution E F) Fw Const St Falls).
    - intros A I. destruct (one_outer_ring (sum_set S T) (decide_point E F) Dec (convolution E F)
        Fw Const St (parts (sum_boundary E F) true) Falls A I high
        (fun y Y => proj2 (H y Y))) as (r & Q & _). eauto.
    - intros A I. exact (all_rings_kept (sum_set S T) (decide_point E F) Dec (convolution E F)
        Fw Const St (parts (sum_boundary E F) true) Falls A I). }
  unfold traced_sum. cbv zeta.
  change (boundary (decide_point E F) (convolution E F)) with (sum_boundary E F).
  rewrite Pass. eauto.
Qed.

Theorem exact_sum_answers : forall (s : Q) (P Q : list (polygon vertex)),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  exists R holes, exact_sum s (rings_of P) (rings_of Q) = Some (R, holes).
Proof.
  intros s P Q L LP LQ N.
  exact (traced_sum_answers _ _ _ _ (P_drawn_here s P L LP) (Q_drawn_here Q LQ)
    (area_here s P Q L LP LQ N) (kinds_here s P Q L LP LQ)).
Qed.
