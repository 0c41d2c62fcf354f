(** Where the program answers, its polygons are the canonical form of the set, with as many
    components and holes as it says. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Legality Components Paths Decomposed Convolution.
From Proved Require Import Points Legal Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks
  Kept Frontier Slabbed Cells Extent Reduced Parted Linked Coloured Holed Traced Formed Arranged.
Open Scope R_scope.
Opaque parts outlines convolution boundary are_outlines.

Lemma falls_same (S T : point -> Prop) C n : (forall x, S x <-> T x) -> falls_into S C n ->
  falls_into T C n.
Proof. intros H (A & K). split; [|exact K]. intros x. rewrite <- H. apply A. Qed.
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

(** Of any set that segments and a program tell *)
Theorem traced_set_is_right is_in all S R holes : is_arranged is_in all S ->
  traced_set is_in all = Some (R, holes) ->
  (forall x, set_of (rings_of (figure R)) x <-> S x) /\
  has_components (set_of (rings_of (figure R))) (length R) /\
  has_holes (set_of (rings_of (figure R))) holes /\
  is_canonical (set_of (rings_of (figure R))) (figure R).
Proof.
  intros Arr. unfold traced_set. cbv zeta. set (B := boundary is_in all).
  destruct (are_outlines all B (outlines all B)) eqn:Tested; [|discriminate].
  intros Answer. injection Answer; intros <- <-. clear Answer.
  destruct (kept_pieces_bound _ _ _ Arr) as (St & Sd & Lg & Al).
  destruct (parts_of_the_set _ _ _ Arr) as (Comp & Hol).
  destruct Arr as (Rg & (low & high & H) & Fw & Const & Dec). fold B in St, Sd, Lg, Al, Comp, Hol.
  pose proof (inside_falls S Rg B St Lg Al Sd low high
    (fun y Y => proj1 (H y Y)) (fun y Y => proj2 (H y Y))) as Falls.
  pose proof (outlines_classes all B) as Classed.
  assert (Len : length (parts B true) = length (outlines all B))
    by (rewrite (Permutation_length Classed); apply map_length).
  pose proof (set_is_set S Rg is_in all Fw Dec Const Lg Al high (fun y Y => proj2 (H y Y)) _ Tested)
    as Set_.
  split; [exact Set_|split; [|split]].
  - rewrite map_length, <- Len. exact (components_same _ _ _ (fun x => iff_sym (Set_ x)) Comp).
  - exact (holes_same _ _ _ (fun x => iff_sym (Set_ x)) Hol).
  - exact (rings_canonical S Rg is_in all Fw Dec Const Lg Al high (fun y Y => proj2 (H y Y))
      (parts B true) Falls _ Tested Classed).
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
  intros s P Q R holes L LP LQ N.
  exact (traced_set_is_right _ _ _ R holes (sum_is_arranged s P Q L LP LQ N)).
Qed.
