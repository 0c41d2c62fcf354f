(** Close beside an edge, on its left, all belongs to the component that the edge bounds: a thin
    wedge from each point of the edge. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries.
Open Scope R_scope.

(** The point v + t (p - v) + s n, and the direction to the left of an edge *)
Definition beside (v p n : point) (t s : R) : point :=
  (fst v + t * (fst p - fst v) + s * fst n, snd v + t * (snd p - snd v) + s * snd n).
Definition left_way (a b : point) : point := (snd a - snd b, fst b - fst a).
Definition across (n v x : point) : R :=
  fst n * (snd x - snd v) - snd n * (fst x - fst v).
Lemma orient_beside v p n t s x :
  orient v (beside v p n t s) x = t * orient v p x + s * across n v x.
Proof. unfold orient, beside, across; cbn [fst snd]; ring. Qed.
Lemma orient_back v x y : orient v x y = - orient v y x.
Proof. unfold orient; ring. Qed.

Lemma beside_near v p n e : 0 < e -> exists d, 0 < d /\ forall t s, 0 < t < d -> 0 < s < d ->
  near e v (beside v p n t s).
Proof.
  intros He. set (k := 1 + Rabs (fst p - fst v) + Rabs (snd p - snd v) + Rabs (fst n) +
    Rabs (snd n)).
  pose proof (Rabs_pos (fst p - fst v)). pose proof (Rabs_pos (snd p - snd v)).
  pose proof (Rabs_pos (fst n)). pose proof (Rabs_pos (snd n)).
  assert (K : 0 < k) by (unfold k; lra).
  exists (e / k). split; [apply Rdiv_lt_0_compat; auto|]. intros t s T S.
  assert (M : (e / k) * k = e) by (field; lra). set (d := e / k) in *.
  assert (A : forall x y, Rabs x + Rabs y + 1 <= k -> Rabs (t * x + s * y) < e).
  { intros x y L. eapply Rle_lt_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
    rewrite (Rabs_right t), (Rabs_right s) by lra. pose proof (Rabs_pos x). pose proof (Rabs_pos y).
    nra. }
  unfold near, beside; cbn [fst snd]. split.
  - replace (_ - _) with (t * (fst p - fst v) + s * fst n) by ring. apply A. unfold k. lra.
  - replace (_ - _) with (t * (snd p - snd v) + s * snd n) by ring. apply A. unfold k. lra.
Qed.

(** Close beside a ray no edge runs. *)
Lemma wedge_off_edge c d v p n : across n v p <> 0 -> exists e, 0 < e /\ forall t s, 0 < t < e ->
  0 < s < e * t -> ~ on_segment c d (beside v p n t s).
Proof.
  intros N. destruct (classic (on_segment c d v)) as [(u & U & Ev)|O].
  2: { destruct (segment_near c d v O) as (e & He & K). destruct (beside_near v p n e He) as
      (f & Hf & L). exists (Rmin 1 f). pose proof (Rmin_l 1 f). pose proof (Rmin_r 1 f).
    split; [apply Rmin_glb_lt; lra|]. intros t s T S. apply K, L; [lra|]. split; [lra|]. nra. }
  set (A := (fst d - fst c) * (snd p - snd v) - (snd d - snd c) * (fst p - fst v)).
  set (B := (fst d - fst c) * snd n - (snd d - snd c) * fst n).
  assert (On : forall t s, on_segment c d (beside v p n t s) -> t * A + s * B = 0 /\
    exists k, t * across n v p = k * B).
  { intros t s (w & W & E). unfold beside in E. injection E; intros E2 E1.
    rewrite Ev in E1, E2. cbn [fst snd] in E1, E2.
    assert (F1 : t * (fst p - fst v) + s * fst n = (w - u) * (fst d - fst c))
      by (rewrite Ev; cbn [fst snd]; lra).
    assert (F2 : t * (snd p - snd v) + s * snd n = (w - u) * (snd d - snd c))
      by (rewrite Ev; cbn [fst snd]; lra).
    split.
    - unfold A, B. replace (_ + _) with ((fst d - fst c) * (t * (snd p - snd v) + s * snd n) -
        (snd d - snd c) * (t * (fst p - fst v) + s * fst n)) by ring. rewrite F1, F2. ring.
    - exists (- (w - u)). unfold across, B.
      replace (t * _) with (fst n * (t * (snd p - snd v) + s * snd n) -
        snd n * (t * (fst p - fst v) + s * fst n)) by ring. rewrite F1, F2. ring. }
  pose proof (Rabs_pos B). destruct (Req_dec A 0) as [Z|Z].
  - exists 1. split; [lra|]. intros t s T S O. destruct (On t s O) as (E & k & F).
    assert (B = 0) by (rewrite Z in E; nra). apply N. rewrite H0 in F. nra.
  - assert (PA : 0 < Rabs A) by (apply Rabs_pos_lt, Z).
    exists (Rabs A / (1 + Rabs B)). split; [apply Rdiv_lt_0_compat; lra|].
    intros t s T S O. destruct (On t s O) as (E & _).
    assert (M : Rabs A / (1 + Rabs B) * (1 + Rabs B) = Rabs A) by (field; lra).
    set (e := Rabs A / (1 + Rabs B)) in *.
    assert (F : t * Rabs A = s * Rabs B).
    { rewrite <- (Rabs_right t) by lra. rewrite <- (Rabs_right s) by lra. rewrite <- !Rabs_mult.
      replace (t * A) with (- (s * B)) by lra. apply Rabs_Ropp. }
    nra.
Qed.
Lemma wedge_off (E : edges_t) v p n : across n v p <> 0 -> exists e, 0 < e /\ e <= 1 /\
  forall t s, 0 < t < e -> 0 < s < e * t -> ~ on_some E (beside v p n t s).
Proof.
  intros N. induction E as [|[c d] E (e & He & H1 & K)].
  - exists 1. split; [lra|split; [lra|]]. intros t s _ _ (a & b & [] & _).
  - destruct (wedge_off_edge c d v p n N) as (f & Hf & L). exists (Rmin e f).
    pose proof (Rmin_l e f). pose proof (Rmin_r e f).
    split; [apply Rmin_glb_lt; auto|split; [lra|]].
    intros t s T S (a & b & [I|I] & O).
    + injection I; intros; subst. apply (L t s); auto; [lra|]. nra.
    + apply (K t s); [lra| |exists a, b; auto]. nra.
Qed.

(** A component is open, joined, in the set; off some edges it does not begin or end. *)
Definition is_part (S : point -> Prop) (C : point -> Prop) (E : edges_t) : Prop :=
  (forall x, C x -> interior C x) /\ (forall x y, C x -> C y -> joined C x y) /\
  (forall x, C x -> S x) /\
  forall x, ~ on_some E x -> exists r, 0 < r /\ forall y, near r x y -> (C y <-> C x).

Lemma mean_positive x y w : 0 < x -> 0 < y -> 0 <= w <= 1 -> 0 < x + w * (y - x).
Proof. intros. nra. Qed.
Lemma segment_in a b p q t : on_segment a b p -> on_segment a b q -> 0 <= t <= 1 ->
  on_segment a b (at_ p q t).
Proof.
  intros (u & U & ->) (w & W & ->) T. exists (u + t * (w - u)). split; [nra|].
  unfold at_; cbn [fst snd]. f_equal; ring.
Qed.
Lemma left_of_edge a b v p t s : orient a b v = 0 -> orient a b p = 0 ->
  orient a b (beside v p (left_way a b) t s)
    = s * ((fst b - fst a) * (fst b - fst a) + (snd b - snd a) * (snd b - snd a)).
Proof.
  intros V P.
  replace (orient a b (beside v p (left_way a b) t s)) with ((1 - t) * orient a b v +
    t * orient a b p + s * ((fst b - fst a) * (fst b - fst a) + (snd b - snd a) * (snd b - snd a)))
    by (unfold orient, beside, left_way; cbn [fst snd]; ring). rewrite V, P. ring.
Qed.

Section Part.
Variables S C : point -> Prop.
Variable E : edges_t.
Hypothesis part : is_part S C E.

(** Edges with nothing of the set on their right are not in the part. *)
Lemma edge_avoids D a b x : a <> b -> divides D S (a, b) -> on_segment a b x -> ~ C x.
Proof.
  intros N (few & H) O Cx. destruct part as (Op & _ & In_S & _).
  destruct (Op x Cx) as (r & R & K). destruct (aside few a b x (r / 2) N O ltac:(lra)) as
    (y & Oy & Ny & Out).
  destruct (H y Oy) as [F|(f & Hf & L)]; [exact (Out F)|].
  destruct (right_close a b y (Rmin (r / 2) f)) as (z & Z & Oz); auto.
  { apply segment_range in Oy. tauto. } { apply Rmin_glb_lt; lra. }
  apply near_min in Z. destruct Z as [Z1 Z2]. apply (proj2 (L z Z2) Oz), In_S, K.
  exact (near_near r x y z Ny Z1).
Qed.

(** Close beside an edge, on its left, all belongs to the part that the edge bounds. *)
Lemma wedge a b v p : a <> b -> divides C S (a, b) -> on_segment a b v -> on_segment a b p ->
  p <> v -> exists e, 0 < e /\ forall t s, 0 < t < e -> 0 < s < e * t ->
    C (beside v p (left_way a b) t s).
Proof.
  intros N (few & H) Ov Op Nv. destruct part as (_ & _ & _ & Steady).
  pose proof (edge_long a b N) as Long. cbv zeta in Long.
  pose proof (proj1 (segment_range a b v Ov)) as Zv.
  pose proof (proj1 (segment_range a b p Op)) as Zp.
  assert (Ac : across (left_way a b) v p <> 0).
  { destruct Ov as (u & U & Ev), Op as (w & W & Ep). rewrite Ev, Ep. unfold across, left_way.
    cbn [fst snd]. intros Q. assert (w <> u) by (intros ->; apply Nv; congruence).
    assert (Q' : (u - w) * ((fst b - fst a) * (fst b - fst a) + (snd b - snd a) * (snd b - snd a))
      = 0) by lra. apply Rmult_integral in Q'. destruct Q'; [apply H0; lra|lra]. }
  destruct (wedge_off E v p (left_way a b) Ac) as (e & He & H1 & K). exists e. split; auto.
  intros t s T Hs.
  (* some point of the wedge is in the part *)
  assert (Far : v <> at_ v p e).
  { intros Q. apply Nv. unfold at_ in Q. destruct v as [v1 v2], p as [p1 p2]. cbn [fst snd] in Q.
    injection Q; intros. f_equal; nra. }
  destruct (one_not_in few v (at_ v p e) Far) as (x & (u & U & Ex) & Out).
  set (t1 := u * e). assert (T1 : 0 < t1 < e) by (unfold t1; nra).
  assert (Ex' : x = at_ v p t1) by (rewrite Ex; unfold at_, t1; cbn [fst snd]; f_equal; ring).
  assert (Ox : on_segment a b x) by (rewrite Ex'; apply segment_in; auto; lra).
  destruct (H x Ox) as [F|(r & R & L)]; [destruct (Out F)|].
  destruct (beside_near x x (left_way a b) r R) as (d & D & Near).
  set (s1 := Rmin (e * t1) d / 2). assert (S1 : 0 < s1 /\ s1 < e * t1 /\ s1 < d).
  { unfold s1. pose proof (Rmin_l (e * t1) d). pose proof (Rmin_r (e * t1) d).
    assert (0 < Rmin (e * t1) d) by (apply Rmin_glb_lt; nra). lra. }
  assert (Q : beside v p (left_way a b) t1 s1 = beside x x (left_way a b) (d / 2) s1).
  { rewrite Ex'. unfold beside, at_; cbn [fst snd]. f_equal; ring. }
  assert (C1 : C (beside v p (left_way a b) t1 s1)).
  { apply (L (beside v p (left_way a b) t1 s1)).
    - rewrite Q. apply Near; lra.
    - rewrite left_of_edge by auto. nra. }
  apply (all_along C (beside v p (left_way a b) t1 s1)); auto.
  intros y (w & W & Ey). apply Steady.
  replace y with (beside v p (left_way a b) (t1 + w * (t - t1)) (s1 + w * (s - s1)))
    by (rewrite Ey; unfold beside; cbn [fst snd]; f_equal; ring).
  pose proof (mean_positive t1 t w). pose proof (mean_positive (e - t1) (e - t) w).
  pose proof (mean_positive s1 s w). pose proof (mean_positive (e * t1 - s1) (e * t - s) w).
  apply K; split; lra.
Qed.
Lemma soon_wedge a b v p : a <> b -> divides C S (a, b) -> on_segment a b v -> on_segment a b p ->
  p <> v -> soon (fun s => exists r, 0 < r /\ forall t, 0 < t <= r ->
    C (beside v p (left_way a b) t (t * s))).
Proof.
  intros N D Ov Op Nv. destruct (wedge a b v p N D Ov Op Nv) as (e & He & K). exists e.
  split; auto. intros s Hs. exists (e / 2). split; [lra|]. intros t T. apply K; [lra|]. nra.
Qed.
End Part.
