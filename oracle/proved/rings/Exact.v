(** Where the program answers, its polygons are the canonical form of the sum, with as many
    components and holes as it says. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Legality Components Paths Decomposed Convolution.
From Proved Require Import Points Legal Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks
  Kept Frontier Slabbed Cells Extent Reduced Parted Linked Coloured Holed Traced Formed Arranged.
Open Scope R_scope.
Opaque parts outlines convolution boundary are_outlines.

Lemma components_same (S T : point -> Prop) n : (forall x, S x <-> T x) -> has_components S n ->
  has_components T n.
Proof.
  intros H (C & HC). exists C. refine (falls_same _ _ C _ _ HC). intros x.
  split; apply interior_same; intros y; [apply H|apply iff_sym, H].
Qed.
Lemma holes_same (S T : point -> Prop) n : (forall x, S x <-> T x) -> has_holes S n ->
  has_holes T n.
Proof.
  intros H (C & HC & Bd). exists C. split; [|exact Bd]. refine (falls_same _ _ C _ _ HC).
  intros x. rewrite (H x). reflexivity.
Qed.
Lemma outlines_classes all B : Permutation (parts B true) (map fst (outlines all B)).
Proof.
  Transparent outlines. unfold outlines. set (le := fun o k => list_le (outer_corners o)
    (outer_corners k)).
  apply Permutation_trans with (map fst (map (outline all B) (parts B true))).
  - rewrite map_map. cbn [fst outline]. rewrite map_id. reflexivity.
  - apply Permutation_map, Permutation_sym, sort_members.
Qed.

Lemma some_pair {A C} (a b : A) (c d : C) : Some (a, c) = Some (b, d) -> b = a /\ d = c.
Proof. intros E. injection E; auto. Qed.
Lemma answered E F R holes : traced_sum E F = Some (R, holes) ->
  are_outlines (convolution E F) (sum_boundary E F)
    (outlines (convolution E F) (sum_boundary E F)) = true /\
  R = map polygon_of (outlines (convolution E F) (sum_boundary E F)) /\
  holes = pred (length (parts (sum_boundary E F) false)).
Proof.
  unfold traced_sum. cbv zeta.
  change (boundary (decide_point E F) (convolution E F)) with (sum_boundary E F).
  destruct (are_outlines _ _ _); [|discriminate]. intros Answer. apply some_pair in Answer.
  split; [reflexivity|exact Answer].
Qed.

(** For any two sets that are drawn, one of them with an area *)
Theorem traced_sum_is_right E F S T R holes : drawn (map R2e E) S -> drawn (map R2e F) T ->
  has_area (map R2e E) S \/ has_area (map R2e F) T ->
  (is_slim E = false -> bordered (map R2e E) S) /\ (is_slim F = false -> bordered (map R2e F) T) ->
  traced_sum E F = Some (R, holes) ->
  (forall x, set_of (rings_of (figure R)) x <-> sum_set S T x) /\
  has_components (sum_set S T) (length R) /\ has_holes (sum_set S T) holes /\
  is_canonical (set_of (rings_of (figure R))) (figure R).
Proof.
  intros DE DF Ar Ki Answer. destruct (answered E F R holes Answer) as (Tested & -> & ->).
  destruct (kept_pieces_bound E F S T DE DF Ar Ki) as (St & Sd & Lg & Al).
  destruct (set_bounded E F S T DE DF) as (low & high & H).
  pose proof (sum_regular _ _ S T DE DF Ar) as Rg.
  destruct (parts_of_the_sum E F S T DE DF Ar Ki) as (Comp & Hol).
  assert (Dec : forall v, decide_point E F v = true <-> sum_set S T (R2 v)).
  { intros v. rewrite (sum_is_union_here E F S T DE DF).
    apply decide_point_is_right; [apply DE|apply DF]. }
  pose proof (convolution_forward E F) as Fw.
  pose proof (sum_steady E F S T DE DF Ar Ki) as Const.
  pose proof (inside_falls (sum_set S T) Rg (sum_boundary E F) St Lg Al Sd low high
    (fun y Y => proj1 (H y Y)) (fun y Y => proj2 (H y Y))) as Falls.
  pose proof (outlines_classes (convolution E F) (sum_boundary E F)) as Classed.
  assert (Len : length (parts (sum_boundary E F) true) =
    length (outlines (convolution E F) (sum_boundary E F)))
    by (rewrite (Permutation_length Classed); apply map_length).
  split; [|split; [|split]].
  - intros x. exact (set_is_set (sum_set S T) Rg (decide_point E F) Dec (convolution E F) Fw Const
      Lg Al high (fun y Y => proj2 (H y Y)) _ Tested x).
  - rewrite map_length, <- Len. exact Comp.
  - exact Hol.
  - exact (rings_canonical (sum_set S T) Rg (decide_point E F) Dec (convolution E F) Fw Const
      Lg Al high (fun y Y => proj2 (H y Y)) (parts (sum_boundary E F) true) Falls _ Tested Classed).
Qed.

Theorem exact_sum_is_right : forall (s : Q) (P Q R : list (polygon vertex)) (holes : nat),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  exact_sum s (rings_of P) (rings_of Q) = Some (R, holes) ->
  is_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) (rings_of (figure R)) /\
  has_components (set_of (rings_of (figure R))) (length R) /\
  has_holes (set_of (rings_of (figure R))) holes /\
  is_canonical (set_of (rings_of (figure R))) (figure R).
Proof.
  intros s P Q R holes L LP LQ N Answer.
  destruct (traced_sum_is_right _ _ _ _ R holes (P_drawn_here s P L LP) (Q_drawn_here Q LQ)
    (area_here s P Q L LP LQ N) (kinds_here s P Q L LP LQ) Answer) as (Set_ & Comp & Hol & Can).
  split; [|split; [|split; [|exact Can]]].
  - intros x. rewrite (Set_ x). apply sum_here, L.
  - apply (components_same _ _ _ (fun x => iff_sym (Set_ x)) Comp).
  - apply (holes_same _ _ _ (fun x => iff_sym (Set_ x)) Hol).
Qed.
