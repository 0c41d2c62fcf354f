(** Two rings that bound one component and run together somewhere have the same next edge there. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside Leaving
  Rounds.
Open Scope R_scope.

(** ** Two ways out of which none comes before the other *)
Definition same_way (v x y : point) : Prop := exists l, 0 < l /\ y = at_ v x l.
Lemma orient_at v x y l : orient v (at_ v x l) y = l * orient v x y.
Proof. unfold orient, at_; cbn [fst snd]; ring. Qed.
Lemma at_orient v x y l : orient v x (at_ v y l) = l * orient v x y.
Proof. unfold orient, at_; cbn [fst snd]; ring. Qed.
Definition ahead (v u h : point) : Prop :=
  orient v u h <> 0 \/ exists l, 0 < l /\ h = at_ v u (- l).
Lemma one_way v u h k : ahead v u h -> ahead v u k -> ~ between v u h k -> ~ between v u k h ->
  same_way v h k.
Proof.
  intros H K B1 B2. unfold between in B1, B2. rewrite (orient_back v k h) in B2.
  assert (G : orient v h k = 0 -> 0 < orient v u h * orient v u k -> same_way v h k).
  { intros W P. assert (N : orient v u h <> 0) by (intros Q; rewrite Q in P; lra).
    exists (orient v u k / orient v u h). split.
    - replace (_ / _) with (orient v u h * orient v u k / (orient v u h * orient v u h)) by (field;
        auto). apply Rdiv_lt_0_compat; auto. nra.
    - assert (X1 : (fst k - fst v) * orient v u h = orient v u k * (fst h - fst v) -
        orient v h k * (fst u - fst v)) by (unfold orient; ring).
      assert (X2 : (snd k - snd v) * orient v u h = orient v u k * (snd h - snd v) -
        orient v h k * (snd u - snd v)) by (unfold orient; ring).
      rewrite W in X1, X2. destruct k as [k1 k2]. unfold at_. cbn [fst snd] in *.
      f_equal; apply (Rmult_eq_reg_r (orient v u h)); auto; field_simplify; auto; lra. }
  destruct (Rtotal_order (orient v u h) 0) as [Oh|[Oh|Oh]],
    (Rtotal_order (orient v u k) 0) as [Ok|[Ok|Ok]].
  - apply G; [|nra]. destruct (Rtotal_order (orient v h k) 0) as [W|[W|W]]; auto; exfalso;
      [apply B2|apply B1]; right; lra.
  - exfalso. destruct K as [K|(l & L & ->)]; [contradiction|]. apply B2. right.
    split; [lra|split; [lra|]]. rewrite at_orient, (orient_back v h u). nra.
  - exfalso. apply B2. left. split; auto.
  - exfalso. destruct H as [H|(l & L & ->)]; [contradiction|]. apply B1. right.
    split; [lra|split; [lra|]]. rewrite orient_at. nra.
  - destruct H as [H|(l & L & ->)]; [contradiction|]. destruct K as [K|(m & M & ->)];
      [contradiction|]. exists (m / l). split; [apply Rdiv_lt_0_compat; auto|].
    unfold at_; cbn [fst snd]. f_equal; field; lra.
  - exfalso. destruct H as [H|(l & L & ->)]; [contradiction|]. apply B2. left. split; auto. left.
    rewrite orient_at. nra.
  - exfalso. apply B1. left. split; auto.
  - exfalso. destruct K as [K|(l & L & ->)]; [contradiction|]. apply B1. left. split; auto. left.
    rewrite at_orient, (orient_back v h u). nra.
  - apply G; [|nra]. destruct (Rtotal_order (orient v h k) 0) as [W|[W|W]]; auto; exfalso;
      [apply B2|apply B1]; left; split; auto; left; lra.
Qed.

Lemma leaves_ahead R e v h : is_ring R -> beyond_start e v -> leaves R e v h ->
  ahead v (fst e) (snd h).
Proof.
  intros Rg ((t & T & Ev) & N) [[-> M]|[-> J]].
  - right. assert (t <> 0).
    { intros ->. apply N. rewrite Ev. destruct (fst e). cbn [fst snd]. f_equal; ring. }
    assert (t <> 1).
    { intros ->. apply M. rewrite Ev. destruct (snd e). cbn [fst snd]. f_equal; ring. }
    exists ((1 - t) / t). split; [apply Rdiv_lt_0_compat; lra|]. rewrite Ev.
    destruct (snd e) as [b1 b2]. unfold at_; cbn [fst snd]. f_equal; field; auto.
  - left. destruct (around R e h Rg J) as (_ & _ & Eh & _ & O & _). intros Z. apply O.
    rewrite orient_swap in Z. unfold orient in *. lra.
Qed.

(** ** The next edge *)
Definition bounds (S C : point -> Prop) (R : list point) : Prop :=
  is_ring R /\ forall e, In e (ring_edges R) -> divides C S e.
(** Edges on one line, in one direction, with more than a point in common *)
Definition together (e f : point * point) : Prop := exists m n, m < n /\ m < 1 /\ 0 < n /\
  fst f = at_ (fst e) (snd e) m /\ snd f = at_ (fst e) (snd e) n.

Lemma at_apart a b t u : a <> b -> at_ a b t = at_ a b u -> t = u.
Proof.
  intros N X. unfold at_ in X. injection X; intros X2 X1.
  pose proof (edge_long a b N) as L. cbv zeta in L.
  assert (Y1 : t * (fst b - fst a) - u * (fst b - fst a) = 0) by lra.
  assert (Y2 : t * (snd b - snd a) - u * (snd b - snd a) = 0) by lra.
  assert (Z : (t - u) * ((fst b - fst a) * (fst b - fst a) + (snd b - snd a) * (snd b - snd a))
    = 0).
  { replace (_ * _) with ((fst b - fst a) * (t * (fst b - fst a) - u * (fst b - fst a)) +
      (snd b - snd a) * (t * (snd b - snd a) - u * (snd b - snd a))) by ring.
    rewrite Y1, Y2. ring. }
  apply Rmult_integral in Z. destruct Z; lra.
Qed.
Section Part.
Variables S C : point -> Prop.
Variable E : edges_t.
Hypothesis part : is_part S C E.

Lemma pass_alike R Q e f v h k : bounds S C R -> bounds S C Q -> In e (ring_edges R) ->
  In f (ring_edges Q) -> beyond_start e v -> beyond_start f v -> same_way v (fst e) (fst f) ->
  leaves R e v h -> leaves Q f v k -> same_way v (snd h) (snd k).
Proof.
  intros (RR & RD) (QR & QD) Ie If Be Bf (l & L & U) Lh Lk.
  assert (Avoid : forall P, is_ring P -> (forall e, In e (ring_edges P) -> divides C S e) ->
    forall a b p, In (a, b) (ring_edges P) -> on_segment a b p -> ~ C p).
  { intros P PR PD a b p I O. apply (edge_avoids S C E part C a b); auto.
    exact (ring_edge_long P a b PR I). }
  destruct (way_round C R e v h RR Ie Be Lh (Avoid R RR RD)) as (Ih & Oh & Nh & Wh).
  destruct (way_round C Q f v k QR If Bf Lk (Avoid Q QR QD)) as (Ik & Ok & Nk & Wk).
  assert (None : forall e h k, In e (ring_edges R) \/ In e (ring_edges Q) -> beyond_start e v ->
    In h (ring_edges R) \/ In h (ring_edges Q) -> on_segment (fst h) (snd h) v -> v <> snd h ->
    In k (ring_edges R) \/ In k (ring_edges Q) -> on_segment (fst k) (snd k) v -> v <> snd k ->
    joined (outside_it C v) (snd h) (fst e) -> ~ between v (fst e) (snd k) (snd h)).
  { assert (Long : forall e, In e (ring_edges R) \/ In e (ring_edges Q) -> fst e <> snd e)
      by (intros g [G|G]; [apply (ring_long R)|apply (ring_long Q)]; auto).
    assert (Div : forall e, In e (ring_edges R) \/ In e (ring_edges Q) ->
      divides C S (fst e, snd e)) by (intros [a b] [G|G]; auto).
    intros x y z Ix [Ox Nx] Iy Oy Ny Iz Oz Nz W.
    apply (none_between S C E part v (snd y) (fst x) (snd x)) with (k1 := fst z); auto.
    intros p Op. apply (edge_avoids S C E part C (fst y) (snd y)); auto.
    destruct Op as (t & T & ->). apply segment_in; auto. apply on_segment_end. }
  apply (one_way v (fst e)).
  - exact (leaves_ahead R e v h RR Be Lh).
  - assert (A : ahead v (fst f) (snd k)) by exact (leaves_ahead Q f v k QR Bf Lk).
    rewrite U in A. destruct A as [A|(m & M & A)].
    + left. intros Z. apply A. rewrite orient_at, Z. ring.
    + right. exists (m * l). split; [apply Rmult_lt_0_compat; auto|]. rewrite A.
      unfold at_; cbn [fst snd]. f_equal; ring.
  - intros B. apply (None f k h); auto. rewrite U. unfold between in *. rewrite !orient_at.
    destruct B as [[B1 [B2|B2]]|(B1 & B2 & B3)].
    + left. split; [nra|left; auto].
    + left. split; [nra|right; nra].
    + right. split; [nra|split; [nra|auto]].
  - apply (None e h k); auto.
Qed.

Lemma same_end R Q e e' f f' : bounds S C R -> bounds S C Q ->
  In (e, e') (ring_edges (ring_edges R)) -> In (f, f') (ring_edges (ring_edges Q)) ->
  together e f -> snd e = snd f /\ same_way (snd e) (snd e') (snd f').
Proof.
  intros BR BQ Ie If (m & n & MN & M1 & N0 & F1 & F2).
  destruct (around R e e' (proj1 BR) Ie) as (Je & _ & _ & _ & Te & _).
  destruct (around Q f f' (proj1 BQ) If) as (Jf & _ & _ & _ & Tf & _).
  pose proof (ring_long R e (proj1 BR) Je) as Le. pose proof (ring_long Q f (proj1 BQ) Jf) as Lf.
  set (a := fst e) in *. set (b := snd e) in *.
  assert (Way : forall t, m < t -> 0 < t -> same_way (at_ a b t) (fst e) (fst f)).
  { intros t T1 T2. exists ((t - m) / t). split; [apply Rdiv_lt_0_compat; lra|]. rewrite F1.
    fold a. unfold at_; cbn [fst snd]. f_equal; field; lra. }
  pose proof (fun t u => at_apart a b t u Le) as Apart.
  assert (On_f : forall t, m <= t <= n -> on_segment (fst f) (snd f) (at_ a b t)).
  { intros t T. exists ((t - m) / (n - m)). split.
    - assert (P : 0 < / (n - m)) by (apply Rinv_0_lt_compat; lra). unfold Rdiv.
      split; [apply Rmult_le_pos; lra|]. apply (Rmult_le_reg_r (n - m)); [lra|].
      rewrite Rmult_assoc, Rinv_l; lra.
    - rewrite F1, F2. unfold at_; cbn [fst snd]. f_equal; field; lra. }
  assert (Beyond : forall t, 0 < t <= 1 -> m < t <= n -> beyond_start e (at_ a b t) /\
    beyond_start f (at_ a b t)).
  { intros t T1 T2. split; split.
    - apply at_on. lra.
    - intros X. assert (t = 0); [apply Apart; rewrite at_0; exact X|lra].
    - apply On_f. lra.
    - rewrite F1. intros X. apply Apart in X. lra. }
  assert (End : forall t, at_ a b t = b -> t = 1).
  { intros t X. apply Apart. rewrite at_1. exact X. }
  destruct (Rtotal_order n 1) as [N1|[N1|N1]].
  - exfalso. destruct (Beyond n) as (B1 & B2); [lra|lra|].
    destruct (pass_alike R Q e f (at_ a b n) e f' BR BQ Je Jf B1 B2 (Way n ltac:(lra) N0))
      as (l & L & X).
    + left. split; auto. fold b. intros X. apply End in X. lra.
    + right. auto.
    + apply Tf. rewrite X, F1, F2. fold b. unfold orient, at_; cbn [fst snd]. ring.
  - rewrite N1, at_1 in F2. split; [auto|]. destruct (Beyond 1) as (B1 & B2); [lra|lra|].
    rewrite at_1 in B1, B2. pose proof (Way 1 M1 Rlt_0_1) as W. rewrite at_1 in W.
    apply (pass_alike R Q e f b e' f' BR BQ Je Jf B1 B2 W); right; auto.
  - exfalso. destruct (Beyond 1) as (B1 & B2); [lra|lra|]. pose proof (Way 1 M1 Rlt_0_1) as W.
    rewrite at_1 in B1, B2, W.
    destruct (pass_alike R Q e f b e' f BR BQ Je Jf B1 B2 W) as (l & L & X).
    + right. auto.
    + left. split; auto. rewrite F2. intros X. symmetry in X. apply End in X. lra.
    + apply Te. assert (O : l * orient a b (snd e') = 0).
      { replace (l * _) with (orient a b (at_ b (snd e') l))
          by (unfold orient, at_; cbn [fst snd]; ring).
        rewrite <- X, F2. unfold orient, at_; cbn [fst snd]. ring. }
      apply Rmult_integral in O. destruct O; [lra|auto].
Qed.

Theorem same_next R Q e e' f f' : bounds S C R -> bounds S C Q ->
  In (e, e') (ring_edges (ring_edges R)) -> In (f, f') (ring_edges (ring_edges Q)) ->
  together e f -> e' = f'.
Proof.
  intros BR BQ Ie If T. destruct (same_end R Q e e' f f' BR BQ Ie If T) as (X & l & L & Y).
  destruct (around R e e' (proj1 BR) Ie) as (_ & Je & He & _).
  destruct (around Q f f' (proj1 BQ) If) as (_ & Jf & Hf & _).
  destruct (ring_next _ _ Je) as (e2 & I2). destruct (ring_next _ _ Jf) as (f2 & K2).
  assert (T' : together e' f').
  { exists 0, l. repeat split; try lra; rewrite <- He.
    - rewrite at_0. congruence.
    - exact Y. }
  destruct (same_end R Q e' e2 f' f2 BR BQ I2 K2 T') as (Z & _).
  destruct e', f'. cbn [fst snd] in *. congruence.
Qed.
End Part.
