(** The points that the program tests, left and right of a piece, tell what is all along it. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Segments Member Decided Pieces Sorting Along Cuts Lone Flanks.
Open Scope R_scope.

Section Piece.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Variable e : edge.
Hypothesis piece : In e (pieces all).
Let a := start e.
Let b := finish e.
Let m := R2 (middle e).
Let n := R2 (left_axis e).

Lemma axis_real : n = if Qeq_bool (fst (fst e)) (fst (snd e)) then (-1, 0) else (0, 1).
Proof.
  unfold n, left_axis. destruct (Qeq_bool _ _); unfold point_of, Q2R; simpl; f_equal; lra.
Qed.
Lemma axis_either : n = (0, 1) \/ n = (-1, 0).
Proof. rewrite axis_real. destruct (Qeq_bool _ _); auto. Qed.
Lemma axis_left : 0 < turn_of (minus_ b a) n.
Proof.
  pose proof (piece_forward all all_forward e piece) as B. unfold forward in B.
  fold (start e) (finish e) in B. fold a b in B. rewrite axis_real.
  destruct (Qeq_bool (fst (fst e)) (fst (snd e))) eqn:Q.
  - apply equal_real in Q. change (fst a = fst b) in Q. destruct B as [B|[_ B]]; [lra|].
    unfold turn_of, minus_; cbn [fst snd]. lra.
  - apply not_true_iff_false in Q. rewrite equal_real in Q. change (~ (fst a = fst b)) in Q.
    destruct B as [B|[B _]]; [|contradiction].
    unfold turn_of, minus_; cbn [fst snd]. lra.
Qed.
Lemma half_real x : Q2R (x / 2) = Q2R x / 2.
Proof.
  rewrite Q2R_div; [|intros H; discriminate H]. f_equal. unfold Q2R; simpl. lra.
Qed.
Lemma middle_real : m = at_ a b (1 / 2).
Proof.
  unfold m, middle, at_, point_of. cbn [fst snd]. rewrite !Q2R_red, !half_real, !Q2R_plus.
  unfold a, b, start, finish, point_of; cbn [fst snd]. f_equal; field.
Qed.
Lemma middle_inside : inner a b m.
Proof. exists (1 / 2). split; [lra|]. exact middle_real. Qed.
Lemma steps_left t : orient a b (step_to m n t) = t * turn_of (minus_ b a) n.
Proof.
  pose proof (inner_on_line _ _ _ middle_inside) as Z.
  transitivity (orient a b m + t * turn_of (minus_ b a) n); [|rewrite Z; ring].
  unfold orient, step_to, turn_of, minus_; cbn [fst snd]. ring.
Qed.
Lemma all_lone f x : In f all -> inner a b x -> lies_on f x -> forall y, lies_on f y ->
  orient a b y = 0.
Proof.
  intros If X Fx y Fy. pose proof (piece_forward all all_forward e piece) as B.
  apply (one_line e f x (inside_on e x X) Fx); auto.
  apply (two_shared e f a b).
  - apply on_segment_start.
  - apply (piece_lone all all_forward e f x piece If X Fx), on_segment_start.
  - apply on_segment_end.
  - apply (piece_lone all all_forward e f x piece If X Fx), on_segment_end.
  - apply before_different, B.
Qed.

(** No segment is met on the way to the point that is tested. *)
Let found := flat_map (met_at (middle e) (left_axis e)) all.
Lemma way_clear t : t <> 0 -> 2 * t <= Q2R (least found) ->
  - Q2R (least (map Qopp found)) <= 2 * t -> ~ over_some all (step_to m n t).
Proof.
  intros T H L (f & If & O). destruct (met_from _ _ f t axis_either (all_forward f If) T O)
    as [Fm|(v & Iv & V)].
  - pose proof (all_lone f m If middle_inside Fm _ O) as Z. rewrite steps_left in Z.
    pose proof axis_left. apply Rmult_integral in Z. destruct Z; lra.
  - assert (Jv : In v found) by (apply in_flat_map; exists f; auto).
    destruct V as [V|V].
    + pose proof (least_below found v Jv). lra.
    + pose proof (least_below (map Qopp found) (- v)%Q (in_map Qopp _ _ Jv)) as M.
      rewrite Q2R_opp in M. lra.
Qed.

Lemma tested_clear : ~ over_some all (R2 (fst (beside all e))) /\
  ~ over_some all (R2 (snd (beside all e))).
Proof.
  unfold beside. cbn [fst snd]. fold found. rewrite !at_distance_real, Q2R_opp, !half_real.
  fold m n. pose proof (least_positive found). pose proof (least_positive (map Qopp found)).
  split; apply way_clear; lra.
Qed.

Variable T : point -> Prop.
Hypothesis constant : forall x, ~ over_some all x ->
  exists r, 0 < r /\ forall y, near r x y -> (T y <-> T x).
Lemma step_between t p : t <> 0 -> on_segment m (step_to m n t) p -> p <> m ->
  exists w, 0 < w <= 1 /\ p = step_to m n (w * t).
Proof.
  intros Ht (w & W & E) N. exists w. split.
  - destruct (Req_dec w 0) as [->|]; [|lra]. destruct N. rewrite E.
    apply point_eq; cbn [fst snd]; ring.
  - rewrite E. unfold step_to; cbn [fst snd]. f_equal; ring.
Qed.
Theorem left_all x : T (R2 (fst (beside all e))) -> inside e x ->
  exists r, 0 < r /\ forall y, near r x y -> 0 < orient a b y -> T y.
Proof.
  unfold beside. cbn [fst]. fold found. rewrite at_distance_real, half_real. fold m n.
  set (t := Q2R (least found) / 2). intros Tl X.
  pose proof (least_positive found) as P. pose proof (least_positive (map Qopp found)) as P'.
  pose proof axis_left as A.
  apply (side_all all T constant a b) with (m := m) (l := step_to m n t); auto.
  - apply before_different, (piece_forward all all_forward e piece).
  - exact all_lone.
  - exact middle_inside.
  - rewrite steps_left. unfold t. apply Rmult_lt_0_compat; lra.
  - intros p O N. destruct (step_between t p) as (w & W & ->); auto; [unfold t; lra|].
    assert (0 < w * t <= t) by (unfold t; nra). apply way_clear; unfold t in *; lra.
Qed.
Theorem right_all x : T (R2 (snd (beside all e))) -> inside e x ->
  exists r, 0 < r /\ forall y, near r x y -> orient a b y < 0 -> T y.
Proof.
  unfold beside. cbn [snd]. fold found. rewrite at_distance_real, Q2R_opp, half_real. fold m n.
  set (t := - (Q2R (least (map Qopp found)) / 2)). intros Tl X.
  pose proof (least_positive found) as P. pose proof (least_positive (map Qopp found)) as P'.
  pose proof axis_left as A.
  assert (Back : forall y, inner a b y -> inner b a y).
  { intros y (w & W & E). exists (1 - w). split; [lra|]. rewrite E. f_equal; ring. }
  assert (Forth : forall y, inner b a y -> inner a b y).
  { intros y (w & W & E). exists (1 - w). split; [lra|]. rewrite E. f_equal; ring. }
  destruct (side_all all T constant b a) with (m := m) (l := step_to m n t) (x := x)
    as (r & Hr & R); auto.
  - intros E. apply (before_different _ _ (piece_forward all all_forward e piece)). auto.
  - intros f y If Y Fy z Fz. rewrite orient_swap, (all_lone f y If (Forth y Y) Fy z Fz). ring.
  - apply Back, middle_inside.
  - rewrite orient_swap, steps_left. unfold t. nra.
  - intros p O N. destruct (step_between t p) as (w & W & ->); auto; [unfold t; lra|].
    assert (t <= w * t < 0) by (unfold t; nra). apply way_clear; unfold t in *; lra.
  - exists r. split; auto. intros y Y L. apply R; auto. rewrite orient_swap. lra.
Qed.
End Piece.
