(** Sections 4.1 and 4.2 of the paper: lines that meet, edges that meet *)
From Coq Require Import Lra Psatz.
From Proved Require Import Definitions Paper.
Open Scope R_scope.

Theorem observation_1_holds : observation_1.
Proof.
  intros [a b] [v1 v2] [c d] [w1 w2] t r N.
  unfold cross, diff, along, add, scale in *; cbn [fst snd] in *. split.
  - intros E. injection E as E1 E2.
    split; apply Rmult_eq_reg_r with (v1 * w2 - v2 * w1); auto; field_simplify; auto; nra.
  - intros [-> ->]. f_equal; field; auto.
Qed.
Theorem observation_1_printed_fails : ~ observation_1_printed.
Proof.
  intros H. specialize (H (0, 0) (1, 1) (1, 0) (0, 1) 1 1).
  unfold cross, diff, along, add, scale in H; cbn [fst snd] in H.
  assert (E : 1 = (1 * (0 - 1) - 1 * (0 - 1)) / (1 * 1 - 1 * 0)) by (apply H; [lra|f_equal; lra]).
  field_simplify in E. lra.
Qed.

(** ** Moving edges *)
Definition size (e : moving_edge) (s : R) : R := if grows e then s else 1.
Lemma way_scaled e s : way_at e s = scale (size e s) (way e).
Proof.
  unfold way_at, size. destruct (grows e); auto. unfold scale. destruct (way e); simpl.
  f_equal; ring.
Qed.
Lemma size_positive e s : 0 < s -> 0 < size e s.
Proof. intros S. unfold size. destruct (grows e); lra. Qed.
(** In units of the ways' own lengths *)
Lemma on_line_plain e s t : on_line e s t = along (begin_at e s) (way e) (size e s * t).
Proof.
  unfold on_line. rewrite way_scaled. unfold along, add, scale. cbn [fst snd]. f_equal; ring.
Qed.
Definition off_by (a b : moving_edge) (s : R) : point := diff (begin_at a s) (begin_at b s).
Definition near_part (a b : moving_edge) (s : R) : R :=
  cross (way b) (off_by a b s) / cross (way a) (way b).

Lemma lines_meet a b s t r : cross (way a) (way b) <> 0 ->
  (on_line a s t = on_line b s r <-> size a s * t = near_part a b s /\
   size b s * r = cross (way a) (off_by a b s) / cross (way a) (way b)).
Proof. intros N. rewrite !on_line_plain. apply observation_1_holds, N. Qed.

Theorem crossings_move_linearly_holds : crossings_move_linearly.
Proof.
  intros a b N. exists (fun s => along (begin_at a s) (way a) (near_part a b s)). split.
  - intros s t r _ E. apply (lines_meet a b s t r N) in E. destruct E as [E _].
    rewrite on_line_plain, E. reflexivity.
  - intros s. unfold near_part, off_by, begin_at in *.
    destruct a as [[a1 a2] [a3 a4] [v1 v2] ga], b as [[b1 b2] [b3 b4] [w1 w2] gb].
    unfold cross, diff, along, add, scale in *; cbn [fst snd begin drift way] in *.
    f_equal; field; auto.
Qed.

Lemma on_edge e s x : on_segment (on_line e s 0) (on_line e s 1) x <->
  exists t, 0 <= t <= 1 /\ x = on_line e s t.
Proof.
  unfold on_segment, on_line, along, add, scale; cbn [fst snd].
  split; intros (t & T & ->); exists t; split; auto; f_equal; ring.
Qed.
(** The four conditions, of which each is linear in s: the lines' common point is on both edges. *)
Lemma within_edge n c k : 0 < c -> 0 < k ->
  ((exists t, 0 <= t <= 1 /\ k * t = n / c) <-> 0 <= n /\ 0 <= c * k - n).
Proof.
  intros C K. assert (E : n = n / c * c) by (field; lra). split.
  - intros (t & T & Et). assert (F : n = k * t * c) by (rewrite Et; exact E).
    assert (P : 0 < c * k) by (apply Rmult_lt_0_compat; auto). rewrite F. split.
    + replace (k * t * c) with (c * k * t) by ring. apply Rmult_le_pos; lra.
    + replace (c * k - k * t * c) with (c * k * (1 - t)) by ring. apply Rmult_le_pos; lra.
  - intros [H1 H2]. exists (n / c / k). split; [|field; lra].
    assert (F : n = n / c / k * (c * k)) by (field; lra). set (t := n / c / k) in *.
    assert (P : 0 < c * k) by (apply Rmult_lt_0_compat; auto). nra.
Qed.
Lemma meets_by_four a b s : 0 < cross (way a) (way b) -> 0 < s ->
  (meet a b s <->
   (0 <= cross (way b) (off_by a b s) /\
    0 <= cross (way a) (way b) * size a s - cross (way b) (off_by a b s)) /\
   (0 <= cross (way a) (off_by a b s) /\
    0 <= cross (way a) (way b) * size b s - cross (way a) (off_by a b s))).
Proof.
  intros C S. pose proof (size_positive a s S) as Sa. pose proof (size_positive b s S) as Sb.
  rewrite <- !within_edge by auto. unfold meet. assert (N : cross (way a) (way b) <> 0) by lra.
  split.
  - intros (x & Ha & Hb). apply on_edge in Ha. apply on_edge in Hb.
    destruct Ha as (t & T & ->). destruct Hb as (r & U & E).
    apply (lines_meet a b s t r N) in E. destruct E as [E1 E2]. split; [exists t|exists r]; auto.
  - intros [(t & T & E1) (r & U & E2)]. exists (on_line a s t). split; apply on_edge.
    + exists t; auto.
    + exists r. split; auto. apply (lines_meet a b s t r N). split; auto.
Qed.
Lemma meet_swap a b s : meet a b s <-> meet b a s.
Proof. unfold meet. split; intros (x & H1 & H2); exists x; auto. Qed.

(** A function m s + n of the scale *)
Definition linear (f : R -> R) : Prop := exists m n, forall s, f s = m * s + n.
Lemma linear_cross u a b : linear (fun s => cross u (off_by a b s)).
Proof.
  exists (cross u (diff (drift a) (drift b))), (cross u (diff (begin a) (begin b))). intros s.
  unfold off_by, begin_at, cross, diff, add, scale; cbn [fst snd]. ring.
Qed.
Lemma linear_rest c e f : linear f -> linear (fun s => c * size e s - f s).
Proof.
  intros (m & n & H). unfold size. destruct (grows e).
  - exists (c - m), (- n). intros s. rewrite H. ring.
  - exists (- m), (c - n). intros s. rewrite H. ring.
Qed.
Theorem interval_of_a_pair_holds : interval_of_a_pair.
Proof.
  assert (G : forall a b, 0 < cross (way a) (way b) -> exists f : list (R * R),
    length f = 4%nat /\
    forall s, 0 < s -> (meet a b s <-> forall m n, In (m, n) f -> 0 <= m * s + n)).
  { intros a b C. destruct (linear_cross (way b) a b) as (m1 & n1 & H1).
    destruct (linear_cross (way a) a b) as (m2 & n2 & H2).
    destruct (linear_rest (cross (way a) (way b)) a _ (linear_cross (way b) a b))
      as (m3 & n3 & H3).
    destruct (linear_rest (cross (way a) (way b)) b _ (linear_cross (way a) a b))
      as (m4 & n4 & H4).
    exists [(m1, n1); (m2, n2); (m3, n3); (m4, n4)]. split; auto. intros s S.
    rewrite (meets_by_four a b s C S), H3, H4, H1, H2. split.
    - intros [[K1 K2] [K3 K4]] m n [E|[E|[E|[E|[]]]]]; injection E; intros; subst; auto.
    - intros K. repeat split; apply K; simpl; auto. }
  intros a b N. destruct (Rtotal_order 0 (cross (way a) (way b))) as [C|[C|C]].
  - apply G, C.
  - congruence.
  - destruct (G b a) as (f & L & H).
    { unfold cross in *. lra. }
    exists f. split; auto. intros s S. rewrite meet_swap. apply H, S.
Qed.

(** ** The printed interval: an upright edge of length 8 from (3 - s, 1 - s), and a level one from
    (0, 0) to (1, 0), both T-edges. They meet from 2 to 3, and it says never. *)
Theorem interval_printed_fails : ~ interval_printed.
Proof.
  intros H. set (a := t_edge (0, 0) (1, 0) (0, 0)). set (b := t_edge (3, 1) (3, 9) (-1, -1)).
  assert (F : forall t s r, on_line a s t = on_line b s r <-> t = 3 - s /\ 1 - s + 8 * r = 0).
  { intros t s r. unfold on_line, along, begin_at, way_at, add, scale, a, b, t_edge, diff.
    cbn [fst snd begin drift way grows]. split.
    - intros E. injection E as E1 E2. lra.
    - intros [-> E]. f_equal; lra. }
  assert (K : forall t s, passes a b t s <-> t = 3 - s).
  { intros t s. unfold passes. split; [intros (r & E); apply F in E; tauto|].
    intros ->. exists ((s - 1) / 8). apply F. split; [reflexivity|field]. }
  assert (L : forall r s, passes b a r s <-> 1 - s + 8 * r = 0).
  { intros r s. unfold passes. split.
    - intros (t & E). symmetry in E. apply F in E. tauto.
    - intros E. exists (3 - s). symmetry. apply F. auto. }
  assert (M : meet a b (5 / 2)).
  { exists (on_line a (5 / 2) (1 / 2)). split; apply on_edge.
    - exists (1 / 2). split; [lra|reflexivity].
    - exists (3 / 16). split; [lra|]. apply F. split; lra. }
  apply (H a b 3 2 1 9) in M; [|..|lra].
  - unfold Rmax, Rmin in M. destruct (Rle_dec 3 1), (Rle_dec 2 9); lra.
  - unfold a, b, t_edge, cross, diff; cbn [fst snd way]. lra.
  - intros s _. rewrite K. split; lra.
  - intros s _. rewrite K. split; lra.
  - intros s _. rewrite L. split; lra.
  - intros s _. rewrite L. split; lra.
Qed.
