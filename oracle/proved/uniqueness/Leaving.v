(** At a point that a ring passes, the ring leaves by the first way out counter-clockwise from where
    it came: no other edge with the component on its left leaves between. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside.
Open Scope R_scope.

(** Counter-clockwise from the direction of u, that of k comes before that of h. *)
Definition between (v u k h : point) : Prop :=
  (0 < orient v u k /\ (0 < orient v k h \/ orient v u h < 0)) \/
  (orient v u k <= 0 /\ orient v u h < 0 /\ 0 < orient v k h).

Section Turn.
Variables S C : point -> Prop.
Variable E : edges_t.
Hypothesis part : is_part S C E.
Variables v u h k : point.
(* v is passed from u to h: a way from h back to u avoids the part and v. *)
Variables e1 e2 : point.
Hypothesis e_long : e1 <> e2.
Hypothesis e_divides : divides C S (e1, e2).
Hypothesis e_v : on_segment e1 e2 v.
Hypothesis v_new : v <> e1.
Variables k1 k2 : point.
Hypothesis k_long : k1 <> k2.
Hypothesis k_divides : divides C S (k1, k2).
Hypothesis k_v : on_segment k1 k2 v.
Hypothesis v_left : v <> k2.
Hypothesis h_new : h <> v.
Hypothesis h_out : forall p, on_segment v h p -> ~ C p.
Hypothesis way_back : joined (outside_it C v) h e1.

Lemma soon_linear x y : 0 < x -> soon (fun s => 0 < x + s * y).
Proof.
  intros H. eapply soon_imp; [|apply (soon_positive [x; y])]; simpl; auto. intros t. rewrite
    Rmult_0_r, Rplus_0_r. auto.
Qed.
(** How far x lies across an edge is how far it lies along it, a quarter of a turn on. *)
Definition dot_at (v x y : point) : R :=
  (fst x - fst v) * (fst y - fst v) + (snd x - snd v) * (snd y - snd v).
Lemma dot_self x y : x <> y -> 0 < dot_at x y y.
Proof. intros N. pose proof (edge_long x y N) as L. exact L. Qed.
Lemma e_start : exists t, 0 < t /\ forall x, t * across (left_way e1 e2) v x = dot_at v e1 x.
Proof.
  destruct e_v as (t & T & Q). exists t. split.
  - assert (t <> 0); [|lra]. intros ->. apply v_new. rewrite Q. destruct e1; cbn [fst snd].
    f_equal; ring.
  - intros x. unfold across, left_way, dot_at. rewrite Q; cbn [fst snd]. ring.
Qed.
Lemma k_end : exists t, 0 < t /\ forall x, t * across (left_way k1 k2) v x = - dot_at v k2 x.
Proof.
  destruct k_v as (t & T & Q). exists (1 - t). split.
  - assert (t <> 1); [|lra]. intros ->. apply v_left. rewrite Q. destruct k2; cbn [fst snd].
    f_equal; ring.
  - intros x. unfold across, left_way, dot_at. rewrite Q; cbn [fst snd]. ring.
Qed.
Theorem none_between : ~ between v e1 k2 h.
Proof.
  intros B. set (n := left_way e1 e2). set (m := left_way k1 k2).
  destruct e_start as (c & Hc & Dt). destruct k_end as (w & W & Dw). fold n in Dt. fold m in Dw.
  assert (Sn : 0 < across n v e1) by (pose proof (Dt e1); pose proof (dot_self v e1 v_new); nra).
  assert (Sm : across m v k2 < 0) by (pose proof (Dw k2); pose proof (dot_self v k2 v_left); nra).
  assert (Oe : on_segment e1 e2 e1) by apply on_segment_start.
  assert (Ok : on_segment k1 k2 k2) by apply on_segment_end.
  pose proof (soon_wedge S C E part e1 e2 v e1 e_long e_divides e_v Oe (not_eq_sym v_new)) as Wa.
  pose proof (soon_wedge S C E part k1 k2 v k2 k_long k_divides k_v Ok (not_eq_sym v_left)) as Wb.
  fold n in Wa. fold m in Wb.
  assert (v_out : ~ C v) by (apply (edge_avoids S C E part C e1 e2); auto).
  assert (e_out : forall p, on_segment v e1 p -> p <> v -> ~ C p).
  { intros p (t & T & ->) _. apply (edge_avoids S C E part C e1 e2); auto.
    apply segment_in; auto. }
  assert (Seg : forall q l r s, 0 < r -> (forall t, 0 < t <= r -> C (beside v q l t (t * s))) ->
    forall p, on_segment v (beside v q l r (r * s)) p -> p <> v -> C p).
  { intros q l r s R H p (t & T & ->) Np.
    assert (t <> 0).
    { intros ->. apply Np. destruct v; unfold beside; cbn [fst snd]. f_equal; ring. }
    replace (_, _) with (beside v q l (t * r) (t * r * s))
      by (unfold beside; cbn [fst snd]; f_equal; ring). apply H. nra. }
  (* a wedge beside the edge in, and one beside k, as thin as needed *)
  assert (Pick : forall P, soon P -> exists a b r q s, 0 < s /\ 0 < r /\ 0 < q /\ P s /\
    a = beside v e1 n r (r * s) /\ b = beside v k2 m q (q * s) /\
    (forall p, on_segment v a p -> p <> v -> C p) /\ (forall p, on_segment v b p -> p <> v -> C p)
    /\ joined C a b).
  { intros P HP. destruct (soon_exists _ (soon_and _ _ HP (soon_and _ _ Wa Wb))) as
      (s & Hs & Ps & (r & R & Ka) & (q & Q & Kb)).
    exists (beside v e1 n r (r * s)), (beside v k2 m q (q * s)), r, q, s.
    do 4 (split; auto). do 2 (split; [reflexivity|]). split; [eauto|split; [eauto|]].
    destruct part as (_ & J & _). apply J; [apply Ka|apply Kb]; lra. }
  assert (Orient : forall r q s, orient v (beside v e1 n r (r * s)) (beside v k2 m q (q * s)) =
    r * q * (orient v e1 k2 + s * (across n v k2 - across m v e1 +
      s * (fst n * snd m - snd n * fst m))))
    by (intros; unfold orient, across, beside; cbn [fst snd]; ring).
  assert (Oa : forall r s x, orient v (beside v e1 n r (r * s)) x
    = r * (orient v e1 x + s * across n v x)) by (intros; rewrite orient_beside; ring).
  assert (Ob : forall q s x, orient v (beside v k2 m q (q * s)) x
    = q * (orient v k2 x + s * across m v x)) by (intros; rewrite orient_beside; ring).
  assert (Zero : forall x, orient v x x = 0) by (intros; unfold orient; ring).
  destruct B as [[B1 B2]|(B1 & B2 & B3)].
  - (* less than half a turn: the edge in is in the gap, h is not *)
    assert (HP : soon (fun s => (0 < orient v e1 k2 + s * (across n v k2 - across m v e1 +
        s * (fst n * snd m - snd n * fst m))) /\ (0 < orient v e1 k2 + s * - across m v e1) /\
        ((0 < orient v k2 h + s * across m v h) \/ (0 < - orient v e1 h + s * - across n v h)))).
    { apply soon_and; [|apply soon_and; [apply soon_linear, B1|]].
      - eapply soon_imp; [|apply (soon_positive [orient v e1 k2; across n v k2 - across m v e1;
          fst n * snd m - snd n * fst m])]; simpl; auto.
        intros t. rewrite Rmult_0_r, Rplus_0_r. auto.
      - destruct B2 as [B2|B2].
        + eapply soon_imp; [|apply (soon_linear _ (across m v h) B2)]. simpl. auto.
        + eapply soon_imp; [|apply (soon_linear (- orient v e1 h) (- across n v h))]; [|lra].
          simpl. auto. }
    destruct (Pick _ HP) as
      (a & b & r & q & s & Hs & R & Q & (P1 & P2 & P3) & Ea & Eb & Ta & Tb & J).
    assert (Turn : 0 < orient v a b).
    { rewrite Ea, Eb, Orient. apply Rmult_lt_0_compat; nra. }
    refine (gap_separation C v a b v_out Turn Ta Tb J e1 h e_out _ _ h_new _ _ _
      (joined_back _ _ _ way_back)); auto.
    + rewrite Ea, Oa, Zero. apply Rmult_lt_0_compat; nra.
    + rewrite orient_back, Eb, Ob, (orient_back v k2). nra.
    + rewrite (orient_back v h), Ea, Eb, Oa, Ob. intros [X Y]. destruct P3; nra.
  - (* half a turn or more: the other way round *)
    assert (Lead : leads_positive [- orient v e1 k2; across m v e1 - across n v k2;
      fst m * snd n - snd m * fst n]).
    { destruct B1 as [B1|B1]; [left; lra|right; split; [lra|left]].
      assert (D : dot_at v e1 k2 < 0).
      { assert (Id : dot_at v e1 k2 * orient v e1 h = dot_at v e1 e1 * orient v k2 h +
          orient v e1 k2 * dot_at v e1 h) by (unfold dot_at, orient; ring).
        pose proof (dot_self v e1 v_new). rewrite B1 in Id. nra. }
      assert (D' : dot_at v k2 e1 = dot_at v e1 k2) by (unfold dot_at; ring).
      pose proof (Dt k2). pose proof (Dw e1). rewrite D' in *.
      assert (across n v k2 < 0) by nra. assert (0 < across m v e1) by nra. lra. }
    assert (HP : soon (fun s => (0 < - orient v e1 k2 + s * (across m v e1 - across n v k2 +
        s * (fst m * snd n - snd m * fst n))) /\ (0 < orient v k2 h + s * across m v h) /\
        (0 < - orient v e1 h + s * - across n v h))).
    { apply soon_and; [|apply soon_and; apply soon_linear; lra].
      eapply soon_imp; [|apply (soon_positive _ Lead)]. simpl. intros x.
      rewrite Rmult_0_r, Rplus_0_r. auto. }
    destruct (Pick _ HP) as
      (a & b & r & q & s & Hs & R & Q & (P1 & P2 & P3) & Ea & Eb & Ta & Tb & J).
    assert (Turn : 0 < orient v b a).
    { rewrite orient_back, Ea, Eb, Orient.
      set (o := orient v e1 k2 + _). assert (o < 0) by (unfold o; lra).
      assert (0 < r * q) by nra. nra. }
    refine (gap_separation C v b a v_out Turn Tb Ta (joined_back _ _ _ J) h e1 _ e_out h_new
      _ _ _ _ way_back); auto.
    + rewrite Eb, Ob. apply Rmult_lt_0_compat; lra.
    + rewrite orient_back, Ea, Oa. nra.
    + rewrite (orient_back v e1), Ea, Oa, Zero. intros [_ Y]. assert (0 < r * s) by nra. nra.
Qed.
End Turn.
