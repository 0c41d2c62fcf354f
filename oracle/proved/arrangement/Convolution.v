(** Off the (full) convolution the sum is locally all: what is in it is inside. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries.
Open Scope R_scope.

Definition off_convolution (E F : edges_t) (x : point) : Prop := forall a b c d, In (a, b) E ->
  In (c, d) F ->
  ~ on_segment a b (minus_ x c) /\ ~ on_segment a b (minus_ x d) /\
  ~ on_segment c d (minus_ x a) /\ ~ on_segment c d (minus_ x b).

(** The parallelogram of two edges holds a neighbourhood of each of its points that are on none of
  its sides. *)
Lemma parallelogram_inside a b c d p q : on_segment a b p -> on_segment c d q ->
  (forall x, x = add p q -> ~ on_segment a b (minus_ x c) /\ ~ on_segment a b (minus_ x d) /\
    ~ on_segment c d (minus_ x a) /\ ~ on_segment c d (minus_ x b)) ->
  interior (fun x => exists p q, on_segment a b p /\ on_segment c d q /\ x = add p q) (add p q).
Proof.
  intros (t & T & P) (u & U & Q) N. specialize (N _ eq_refl). destruct N as (N1 & N2 & N3 & N4).
  destruct a as [a1 a2], b as [b1 b2], c as [c1 c2], d as [d1 d2]. cbn [fst snd] in *. subst p q.
  unfold add, minus_ in *. cbn [fst snd] in *.
  set (v1 := b1 - a1) in *. set (v2 := b2 - a2) in *. set (w1 := d1 - c1) in *.
    set (w2 := d2 - c2) in *.
  assert (T0 : 0 < t). { destruct (Req_dec t 0) as [->|]; [|lra]. exfalso. apply N3. exists u.
    split; auto. cbn [fst snd]. fold w1 w2. f_equal; ring. }
  assert (T1 : t < 1). { destruct (Req_dec t 1) as [->|]; [|lra]. exfalso. apply N4. exists u.
    split; auto. cbn [fst snd]. fold w1 w2. unfold v1, v2. f_equal; ring. }
  assert (U0 : 0 < u). { destruct (Req_dec u 0) as [->|]; [|lra]. exfalso. apply N1. exists t.
    split; auto. cbn [fst snd]. fold v1 v2. f_equal; ring. }
  assert (U1 : u < 1). { destruct (Req_dec u 1) as [->|]; [|lra]. exfalso. apply N2. exists t.
    split; auto. cbn [fst snd]. fold v1 v2. unfold w1, w2. f_equal; ring. }
  set (D := v1 * w2 - v2 * w1). destruct (Req_dec D 0) as [Z|Z].
  - (* parallel: slide along until one is at an end *)
    exfalso.
    assert (V : v1 * v1 + v2 * v2 <> 0).
    { intros E. assert (v1 = 0) by nra. assert (v2 = 0) by nra. apply N3. exists u. split; [lra|].
      cbn [fst snd]. fold w1 w2. rewrite H, H0. f_equal; ring. }
    set (k := (w1 * v1 + w2 * v2) / (v1 * v1 + v2 * v2)).
    assert (W1 : w1 = k * v1). { unfold k. apply Rmult_eq_reg_r with (v1 * v1 + v2 * v2); auto.
      transitivity ((w1 * v1 + w2 * v2) * v1 - v2 * (v1 * w2 - v2 * w1)); [ring|].
      unfold D in Z. rewrite Z. field. auto. }
    assert (W2 : w2 = k * v2). { unfold k. apply Rmult_eq_reg_r with (v1 * v1 + v2 * v2); auto.
      transitivity ((w1 * v1 + w2 * v2) * v2 + v1 * (v1 * w2 - v2 * w1)); [ring|].
      unfold D in Z. rewrite Z. field. auto. }
    clearbody k.
    destruct (Req_dec k 0) as [K|K].
    { apply N1. exists t. split; [lra|]. cbn [fst snd]. fold v1 v2. rewrite W1, W2, K.
        f_equal; ring. }
    destruct (Rle_dec 0 (t + u * k)); [destruct (Rle_dec (t + u * k) 1)|].
    + apply N1. exists (t + u * k). split; [lra|]. cbn [fst snd]. fold v1 v2. rewrite W1, W2.
        f_equal; ring.
    + apply N4. exists ((t + u * k - 1) / k). assert (0 < k) by nra.
      assert (E : (t + u * k - 1) / k * k = t + u * k - 1) by (field; auto).
      set (s := (t + u * k - 1) / k) in *. split; [split; nra|]. cbn [fst snd]. fold w1 w2.
        rewrite W1, W2.
      f_equal; [replace (b1) with (a1 + v1) by (unfold v1;
        ring)|replace (b2) with (a2 + v2) by (unfold v2; ring)]; nra.
    + apply N3. exists (u + t / k). assert (k < 0) by nra.
      assert (E : t / k * k = t) by (field; auto). set (s := t / k) in *.
      split; [split; nra|]. cbn [fst snd]. fold w1 w2. rewrite W1, W2. f_equal; nra.
  - (* across: both parameters move a little *)
    set (m := (1 + Rabs v1 + Rabs v2 + Rabs w1 + Rabs w2) / Rabs D).
    pose proof (Rabs_pos v1). pose proof (Rabs_pos v2). pose proof (Rabs_pos w1).
      pose proof (Rabs_pos w2).
    assert (AD : 0 < Rabs D) by (apply Rabs_pos_lt, Z).
    assert (M : 0 < m) by (apply Rdiv_lt_0_compat; lra).
    set (g := Rmin (Rmin t (1 - t)) (Rmin u (1 - u))).
    assert (G : 0 < g) by (unfold g; repeat apply Rmin_glb_lt; lra).
    exists (g / m). split; [apply Rdiv_lt_0_compat; auto|]. intros [y1 y2] [Y1 Y2].
      cbn [fst snd] in *.
    set (e1 := y1 - (a1 + t * v1 + (c1 + u * w1))) in *.
      set (e2 := y2 - (a2 + t * v2 + (c2 + u * w2))) in *.
    assert (Small : forall r1 r2, Rabs r1 <= Rabs v1 + Rabs w1 -> Rabs r2 <= Rabs v2 + Rabs w2 ->
      Rabs ((e1 * r2 - e2 * r1) / D) < g).
    { intros r1 r2 R1 R2. unfold Rdiv. rewrite Rabs_mult, Rabs_inv.
      apply Rmult_lt_reg_r with (Rabs D); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      assert (B : Rabs (e1 * r2 - e2 * r1) <= Rabs e1 * Rabs r2 + Rabs e2 * Rabs r1).
      { unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult. lra. }
      set (f := g / m) in *. assert (Fm : f * (1 + Rabs v1 + Rabs v2 + Rabs w1 + Rabs w2) = g *
        Rabs D).
      { unfold f, m. field. split; lra. }
      pose proof (Rabs_pos e1). pose proof (Rabs_pos e2). pose proof (Rabs_pos r1).
        pose proof (Rabs_pos r2).
      assert (0 < f) by (unfold f; apply Rdiv_lt_0_compat; auto). nra. }
    pose proof (Small w1 w2 ltac:(lra) ltac:(lra)) as S1.
      pose proof (Small v1 v2 ltac:(lra) ltac:(lra)) as S2.
    set (dt := (e1 * w2 - e2 * w1) / D) in *. set (du' := (e1 * v2 - e2 * v1) / D) in *.
    pose proof (Rmin_l (Rmin t (1 - t)) (Rmin u (1 - u))).
      pose proof (Rmin_r (Rmin t (1 - t)) (Rmin u (1 - u))).
    pose proof (Rmin_l t (1 - t)). pose proof (Rmin_r t (1 - t)). pose proof (Rmin_l u (1 - u)).
    pose proof (Rmin_r u (1 - u)). fold g in H3, H4. apply Rabs_def2 in S1. apply Rabs_def2 in S2.
    exists (a1 + (t + dt) * v1, a2 + (t + dt) * v2), (c1 + (u - du') * w1, c2 + (u - du') * w2).
    split; [|split].
    + exists (t + dt). split; [lra|]. cbn [fst snd]. fold v1 v2. reflexivity.
    + exists (u - du'). split; [lra|]. cbn [fst snd]. fold w1 w2. reflexivity.
    + assert (X1 : dt * v1 - du' * w1 = e1) by (unfold dt, du'; field_simplify; auto; unfold D;
        field; exact Z).
      assert (X2 : dt * v2 - du' * w2 = e2) by (unfold dt, du'; field_simplify; auto; unfold D;
        field; exact Z).
      unfold add; cbn [fst snd]. unfold e1, e2 in X1, X2. f_equal; lra.
Qed.

Section Off.
Variables E F : edges_t.
Hypothesis E_closed : closed E.
Hypothesis F_closed : closed F.
Definition union_of_sums (x : point) : Prop :=
  by_vertex_of_E E F x \/ by_vertex_of_F E F x \/ by_edges E F x.

Lemma region_translate G x a : closed G -> ~ on_some G (minus_ x a) -> region G (minus_ x a) ->
  exists r, 0 < r /\ forall y, near r x y -> region G (minus_ y a).
Proof.
  intros C N R. destruct (winding_here G _ C N) as (e & He & K).
  destruct (edges_near G _ N) as (f & Hf & L). exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
  intros y Y. apply near_min in Y. destruct Y as [Y1 Y2].
  assert (T : forall r, near r x y -> near r (minus_ x a) (minus_ y a)).
  { intros r [A B]. unfold near, minus_; cbn [fst snd]. split.
    - replace (fst y - fst a - (fst x - fst a)) with (fst y - fst x) by ring. auto.
    - replace (snd y - snd a - (snd x - snd a)) with (snd y - snd x) by ring. auto. }
  apply region_off; auto. rewrite K by auto. apply region_off; auto.
Qed.
Theorem off_convolution_inside x : off_convolution E F x -> union_of_sums x ->
  interior union_of_sums x.
Proof.
  intros Off S. destruct S as [(a & b & I & R)|[(c & d & I & R)|(p & q & (a & b & I & P) & (c & d &
    J & Q) & X)]].
  - destruct (region_translate F x a) as (r & Hr & K); auto.
    { intros (c & d & J & O). destruct (Off a b c d I J) as (_ & _ & N & _). contradiction. }
    exists r. split; auto. intros y Y. left. exists a, b. auto.
  - destruct (region_translate E x c) as (r & Hr & K); auto.
    { intros (a & b & J & O). destruct (Off a b c d J I) as (N & _). contradiction. }
    exists r. split; auto. intros y Y. right; left. exists c, d. auto.
  - subst x. destruct (parallelogram_inside a b c d p q P Q) as (r & Hr & K).
    { intros x ->. apply (Off a b c d I J). }
    exists r. split; auto. intros y Y. destruct (K y Y) as (p' & q' & P' & Q' & ->).
    right; right. exists p', q'. split; [exists a, b; auto|split; [exists c, d; auto|reflexivity]].
Qed.

(** The sum is closed. *)
Lemma closed_finite {A} (L : list A) (H : A -> point -> Prop) : (forall i, In i L ->
  is_closed (H i)) ->
  is_closed (fun x => exists i, In i L /\ H i x).
Proof.
  intros C x Lim. apply NNPP. intros N.
  assert (G : exists e, 0 < e /\ forall y, near e x y -> ~ exists i, In i L /\ H i y).
  { clear Lim. induction L as [|i L IH]; [exists 1; split; [lra|]; intros y _ (i & [] & _)|].
    destruct IH as (e & He & K); [intros j J; apply C; simpl; auto|intros (j & J & Hj); apply N;
      exists j; simpl; auto|].
    assert (F1 : exists f, 0 < f /\ forall y, near f x y -> ~ H i y).
    { apply NNPP. intros B. apply N. exists i. split; [simpl; auto|]. apply C; [simpl; auto|].
      intros f Hf. apply NNPP. intros Q. apply B. exists f. split; auto. intros y Y Z. apply Q.
        eauto. }
    destruct F1 as (f & Hf & M). exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
    intros y Y. apply near_min in Y. destruct Y as [Y1 Y2].
      intros (j & [<-|J] & Hj); [apply (M y Y2 Hj)|].
    apply (K y Y1). eauto. }
  destruct G as (e & He & K). destruct (Lim e He) as (q & Q & Hq). exact (K q Q Hq).
Qed.
Lemma near_translate r x y a : near r x y -> near r (minus_ x a) (minus_ y a).
Proof.
  intros [A B]. unfold near, minus_; cbn [fst snd]. split.
  - replace (fst y - fst a - (fst x - fst a)) with (fst y - fst x) by ring. auto.
  - replace (snd y - snd a - (snd x - snd a)) with (snd y - snd x) by ring. auto.
Qed.
Lemma parallelogram_closed a b c d :
  is_closed (fun x => exists p q, on_segment a b p /\ on_segment c d q /\ x = add p q).
Proof.
  intros x Lim. apply NNPP. intros N.
  assert (Apart : forall p, on_segment a b p -> ~ on_segment c d (minus_ x p)).
  { intros p P Q. apply N. exists p, (minus_ x p). split; auto. split; auto. apply add_minus. }
  set (U := fun t => 0 <= t <= 1 /\ exists r, 0 < r /\ forall s y, 0 <= s <= t -> near r x y ->
    ~ on_segment c d (minus_ y (at_ a b s))).
  assert (Loc : forall t, 0 <= t <= 1 -> exists r k, 0 < r /\ 0 < k /\ forall s y,
    Rabs (s - t) < k ->
    near r x y -> ~ on_segment c d (minus_ y (at_ a b s))).
  { intros t T. destruct (segment_near c d (minus_ x (at_ a b t))) as (e & He & K);
      [apply Apart, at_on, T|].
    destruct (at_near a b t (e / 2)) as (k & Hk & M); [lra|]. exists (e / 2), k.
      split; [lra|split; [auto|]].
    intros s y S Y. apply K. apply near_near with (minus_ x (at_ a b s)).
    - apply near_minus, M, S.
    - apply near_translate, Y. }
  assert (U0 : U 0).
  { split; [lra|]. destruct (Loc 0 ltac:(lra)) as (r & k & Hr & Hk & M). exists r. split; auto.
    intros s y S Y. apply M; auto. replace s with 0 by lra. rewrite Rminus_0_r, Rabs_R0. auto. }
  destruct (completeness U) as (m & Up & Least); [exists 1; intros t [T _]; lra|exists 0;
    exact U0|].
  assert (M0 : 0 <= m) by (apply Up, U0).
  assert (M1 : m <= 1) by (apply Least; intros t [T _]; lra).
  destruct (Loc m (conj M0 M1)) as (r & k & Hr & Hk & M).
  assert (B : exists t, U t /\ m - k < t).
  { apply NNPP. intros B. assert (m <= m - k); [|lra]. apply Least. intros t T.
    destruct (Rle_dec t (m - k)); auto. exfalso. apply B. exists t. split; auto. lra. }
  destruct B as (t & [T (r' & Hr' & Kt)] & Lt). assert (tm : t <= m) by (apply Up; split; eauto).
  set (s := Rmin 1 (m + k / 2)). assert (S : m <= s <= 1 /\ s < m + k).
  { unfold s. pose proof (Rmin_l 1 (m + k / 2)). pose proof (Rmin_r 1 (m + k / 2)).
    split; [split; [apply Rmin_glb; lra|lra]|lra]. }
  assert (G : U s).
  { split; [lra|]. exists (Rmin r r'). split; [apply Rmin_glb_lt; auto|]. intros w y W Y.
    apply near_min in Y. destruct Y as [Y1 Y2]. destruct (Rle_dec w t); [apply Kt; auto; lra|].
    apply M; auto. apply Rabs_def1; lra. }
  assert (s = 1).
  { apply Up in G as G'. unfold s in *. unfold Rmin in *. destruct (Rle_dec 1 (m + k / 2)); lra. }
  rewrite H in G. destruct G as (_ & e & He & K). destruct (Lim e He) as (y & Y & (p & q & P & Q &
    Z)).
  destruct P as (w & W & Ew). apply (K w y W Y). fold (at_ a b w) in Ew. rewrite <- Ew.
  replace (minus_ y p) with q; auto. rewrite Z. unfold minus_, add. destruct q; cbn [fst snd].
    f_equal; ring.
Qed.
Theorem union_closed : is_closed union_of_sums.
Proof.
  intros x Lim. unfold union_of_sums in *.
  assert (C1 : is_closed (by_vertex_of_E E F)).
  { intros y L. destruct (closed_finite E (fun e z => region F (minus_ z (fst e)))) with (x := y)
      as ([a b] & I & R).
    - intros [a b] _ z Lz. apply region_closed. intros e He. destruct (Lz e He) as (q & Q & R).
      exists (minus_ q a). split; auto. apply near_translate, Q.
    - intros e He. destruct (L e He) as (q & Q & (a & b & I & R)). exists q. split; auto.
        exists (a, b). auto.
    - exists a, b. auto. }
  assert (C2 : is_closed (by_vertex_of_F E F)).
  { intros y L. destruct (closed_finite F (fun e z => region E (minus_ z (fst e)))) with (x := y)
      as ([a b] & I & R).
    - intros [a b] _ z Lz. apply region_closed. intros e He. destruct (Lz e He) as (q & Q & R).
      exists (minus_ q a). split; auto. apply near_translate, Q.
    - intros e He. destruct (L e He) as (q & Q & (a & b & I & R)). exists q. split; auto.
        exists (a, b). auto.
    - exists a, b. auto. }
  assert (C3 : is_closed (by_edges E F)).
  { intros y L. destruct (closed_finite (list_prod E F) (fun ef z => exists p q,
      on_segment (fst (fst ef)) (snd (fst ef)) p /\ on_segment (fst (snd ef)) (snd (snd ef)) q
        /\ z = add p q))
      with (x := y) as ([[a b] [c d]] & I & (p & q & P & Q & Z)).
    - intros [[a b] [c d]] _. apply parallelogram_closed.
    - intros e He. destruct (L e He) as (z & Z & (p & q & (a & b & I & P) & (c & d & J & Q) & X)).
      exists z. split; auto. exists ((a, b), (c, d)). split; [apply in_prod; auto|]. exists p, q.
        auto.
    - apply in_prod_iff in I. exists p, q. split; [exists a, b; tauto|split; [exists c, d;
        tauto|exact Z]]. }
  destruct (classic (by_vertex_of_E E F x)) as [|N1]; [auto|].
  destruct (classic (by_vertex_of_F E F x)) as [|N2]; [auto|].
  right; right. apply C3. intros e He.
  assert (N : forall H : point -> Prop, is_closed H -> ~ H x -> exists f, 0 < f /\ forall y,
    near f x y -> ~ H y).
  { intros H C Nx. apply NNPP. intros B. apply Nx, C. intros f Hf. apply NNPP. intros Q. apply B.
    exists f. split; auto. intros y Y Z. apply Q. eauto. }
  destruct (N _ C1 N1) as (f1 & H1 & K1). destruct (N _ C2 N2) as (f2 & H2 & K2).
  destruct (Lim (Rmin e (Rmin f1 f2))) as (y & Y & S); [repeat apply Rmin_glb_lt; auto|].
  apply near_min in Y. destruct Y as [Y Y']. apply near_min in Y'. destruct Y' as [Y1 Y2].
  exists y. split; auto. destruct S as [S|[S|S]]; auto; exfalso;
    [apply (K1 y Y1 S)|apply (K2 y Y2 S)].
Qed.
(** A1: off the convolution the sum is locally all or nothing. *)
Theorem off_convolution_constant x : off_convolution E F x ->
  exists r, 0 < r /\ forall y, near r x y -> (union_of_sums y <-> union_of_sums x).
Proof.
  intros Off. destruct (classic (union_of_sums x)) as [S|S].
  - destruct (off_convolution_inside x Off S) as (r & Hr & K). exists r. split; auto. intros y Y.
      split; auto.
  - apply NNPP. intros B. apply S, union_closed. intros r Hr. apply NNPP. intros Q. apply B.
    exists r. split; auto. intros y Y. split; [|intros; contradiction]. intros Sy. exfalso.
      apply Q. eauto.
Qed.
End Off.
