(** Cones from the origin over triangles that form a closed surface cover all of space: each edge is
    in two triangles, which lie on both sides of the plane through it and the origin. *)
From Coq Require Import Lra Lia Classical.
From Proved Require Import Definitions Space Curves.
Open Scope R_scope.

Definition cross_3 (u v : point3) : point3 :=
  let '(a, b, c) := u in let '(d, e, f) := v in (b * f - c * e, c * d - a * f, a * e - b * d).
(** Six times the volume of the tetrahedron on three vectors *)
Definition volume_of (u v w : point3) : R := dot_3 u (cross_3 v w).
Ltac coordinates := repeat match goal with p : point3 |- _ => destruct p as [[? ?] ?] end;
  unfold volume_of, cross_3, dot_3, add3, scale3 in *.

Lemma volume_cycle u v w : volume_of u v w = volume_of v w u.
Proof. coordinates. ring. Qed.
Lemma volume_swap u v w : volume_of v u w = - volume_of u v w.
Proof. coordinates. ring. Qed.

Lemma volume_dot u v w : volume_of u v w = dot_3 (cross_3 u v) w.
Proof. coordinates. ring. Qed.
Lemma volume_none u v : volume_of u v v = 0.
Proof. coordinates. ring. Qed.
Lemma volume_sum a b c : volume_of a b (add3 a (add3 b c)) = volume_of a b c /\
  volume_of b c (add3 a (add3 b c)) = volume_of a b c /\
  volume_of c a (add3 a (add3 b c)) = volume_of a b c.
Proof. coordinates. repeat split; ring. Qed.
(** A vector by its coordinates along three others *)
Lemma volume_along a b c u w : volume_of a b c * volume_of a u w
  = volume_of a b w * volume_of a u c + volume_of c a w * volume_of a u b.
Proof. coordinates. ring. Qed.

(** The curve x + (t, t^2, t^3) is in no plane for long. *)
Definition curve3 (x : point3) (t : R) : point3 := add3 x (t, t * t, t * t * t).
Definition coefficients3 (u x : point3) : list R :=
  let '(a, b, c) := u in [dot_3 u x; a; b; c].
Lemma curve3_dot u x t : dot_3 u (curve3 x t) = polynomial (coefficients3 u x) t.
Proof. unfold curve3, coefficients3. coordinates. simpl. ring. Qed.
Lemma curve3_positive u x : 0 < dot_3 u x -> soon (fun t => 0 < dot_3 u (curve3 x t)).
Proof.
  intros H. eapply soon_imp; [|apply (soon_positive (coefficients3 u x))].
  - intros t. rewrite curve3_dot. auto.
  - destruct u as [[a b] c]. simpl in *. auto.
Qed.
Lemma curve3_off u x : u <> (0, 0, 0) -> soon (fun t => dot_3 u (curve3 x t) <> 0).
Proof.
  intros N.
  assert (H : leads_positive (coefficients3 u x) \/ leads_positive (map Ropp (coefficients3 u x))).
  { destruct u as [[a b] c]. unfold coefficients3. set (o := dot_3 _ x). simpl.
    assert (M : a <> 0 \/ b <> 0 \/ c <> 0).
    { destruct (Req_dec a 0) as [->|]; auto. destruct (Req_dec b 0) as [->|]; auto.
      destruct (Req_dec c 0) as [->|]; auto. }
    destruct (Rtotal_order o 0) as [|[|]], (Rtotal_order a 0) as [|[|]],
      (Rtotal_order b 0) as [|[|]], (Rtotal_order c 0) as [|[|]]; lra. }
  destruct H as [H|H]; apply soon_positive in H; eapply soon_imp; try exact H; intros t;
    cbv beta; rewrite curve3_dot.
  - lra.
  - destruct u as [[a b] c]. simpl. intros K E. lra.
Qed.

Definition in_cone (a b c x : point3) : Prop :=
  0 <= volume_of a b x /\ 0 <= volume_of b c x /\ 0 <= volume_of c a x.
Lemma not_in_cone a b c x : ~ in_cone a b c x ->
  volume_of a b x < 0 \/ volume_of b c x < 0 \/ volume_of c a x < 0.
Proof. unfold in_cone. lra. Qed.

(** A point between two *)
Definition toward (z y : point3) (t : R) : point3 :=
  add3 (scale3 (1 - t, 1 - t, 1 - t) z) (scale3 (t, t, t) y).
Lemma toward_start z y : toward z y 0 = z.
Proof. unfold toward. coordinates. repeat f_equal; ring. Qed.
Lemma toward_end z y : toward z y 1 = y.
Proof. unfold toward. coordinates. repeat f_equal; ring. Qed.
Lemma volume_toward a b z y t :
  volume_of a b (toward z y t) = (1 - t) * volume_of a b z + t * volume_of a b y.
Proof. unfold toward. coordinates. ring. Qed.
Lemma toward_near a b z y m : 0 < volume_of a b (toward z y m) -> exists e, 0 < e /\
  forall t, Rabs (t - m) < e -> 0 < volume_of a b (toward z y t).
Proof.
  rewrite volume_toward. set (v := volume_of a b z). set (w := volume_of a b y). intros H.
  pose proof (Rabs_pos (w - v)) as D. exists (((1 - m) * v + m * w) / (1 + Rabs (w - v))).
  split; [apply Rdiv_lt_0_compat; lra|]. intros t T. rewrite volume_toward. fold v w.
  set (q := (1 - m) * v + m * w) in *.
  replace ((1 - t) * v + t * w) with (q + (t - m) * (w - v)) by (unfold q; ring).
  assert (K : Rabs (t - m) * (1 + Rabs (w - v)) < q).
  { apply Rmult_lt_compat_r with (r := 1 + Rabs (w - v)) in T; [|lra]. unfold Rdiv in T.
    rewrite Rmult_assoc, Rinv_l in T; lra. }
  pose proof (Rabs_pos (t - m)). pose proof (Rle_abs (- ((t - m) * (w - v)))) as A.
  rewrite Rabs_Ropp, Rabs_mult in A. nra.
Qed.

(** The triangle a b c, wherever it begins *)
Definition cyclic {A} (T : list (A * A * A)) (a b c : A) : Prop :=
  In (a, b, c) T \/ In (b, c, a) T \/ In (c, a, b) T.
Lemma cyclic_next {A} (T : list (A * A * A)) a b c : cyclic T a b c -> cyclic T b c a.
Proof. unfold cyclic. tauto. Qed.

Section Cover.
Variable T : list (point3 * point3 * point3).
Hypothesis some : T <> [].
Hypothesis outward : forall a b c, In (a, b, c) T -> 0 < volume_of a b c.
Hypothesis closed : forall a b c, cyclic T a b c -> exists d, cyclic T b a d.

Definition covered3 (x : point3) : Prop := exists a b c, In (a, b, c) T /\ in_cone a b c x.

Lemma cyclic_outward a b c : cyclic T a b c -> 0 < volume_of a b c.
Proof.
  intros [I|[I|I]]; apply outward in I; auto.
  - rewrite volume_cycle. auto.
  - rewrite <- volume_cycle. auto.
Qed.
Lemma cyclic_covered a b c x : cyclic T a b c -> in_cone a b c x -> covered3 x.
Proof.
  unfold in_cone. intros [I|[I|I]] H; [exists a, b, c|exists b, c, a|exists c, a, b];
    (split; [exact I|unfold in_cone; tauto]).
Qed.

(** A corner, as a vector, is not the origin. *)
Lemma corner_not_zero a b c : cyclic T a b c -> a <> (0, 0, 0).
Proof. intros I ->. apply cyclic_outward in I. revert I. coordinates. lra. Qed.

(** What is not covered is not covered nearby. *)
Lemma soon_uncovered y : ~ covered3 y -> soon (fun t => ~ covered3 (curve3 y t)).
Proof.
  intros N. eapply soon_imp with (P := fun t => forall s, In s T ->
    let '(a, b, c) := s in ~ in_cone a b c (curve3 y t)).
  - intros t H (a & b & c & I & K). exact (H _ I K).
  - apply soon_all. intros [[a b] c] I.
    assert (O : ~ in_cone a b c y) by (intros K; apply N; exists a, b, c; auto).
    assert (G : forall u v, volume_of u v y < 0 -> soon (fun t => volume_of u v (curve3 y t) < 0)).
    { intros u v H. eapply soon_imp; [|apply (curve3_positive (cross_3 v u) y)].
      - intros t K. cbv beta in K. rewrite <- volume_dot, volume_swap in K. lra.
      - rewrite <- volume_dot, volume_swap. lra. }
    apply not_in_cone in O. unfold in_cone.
    destruct O as [O|[O|O]]; apply G in O; (eapply soon_imp; [|exact O]); simpl; intros t; lra.
Qed.

(** A point on the wall a b of a cone: what is nearby is in this cone or in the next one. *)
Lemma wall_covered a b c z y m : cyclic T a b c -> volume_of a b (toward z y m) = 0 ->
  0 < volume_of b c (toward z y m) -> 0 < volume_of c a (toward z y m) ->
  exists e, 0 < e /\ forall t, Rabs (t - m) < e -> covered3 (toward z y t).
Proof.
  intros I Z B C. destruct (closed a b c I) as (d & J).
  pose proof (cyclic_outward _ _ _ I) as D. pose proof (cyclic_outward _ _ _ J) as D'.
  set (w := toward z y m) in *.
  assert (E1 : volume_of a b c * volume_of a d w = volume_of c a w * volume_of b a d).
  { pose proof (volume_along a b c d w) as E. rewrite Z in E.
    rewrite E, (volume_cycle a d b), (volume_cycle d b a). ring. }
  assert (E2 : volume_of a b c * volume_of d b w = volume_of b c w * volume_of b a d).
  { pose proof (volume_along b a c d w) as E.
    assert (S : volume_of b d a = - volume_of b a d)
      by (rewrite (volume_swap a b d), (volume_cycle b d a), (volume_cycle d a b); ring).
    rewrite (volume_swap a b w), (volume_swap a b c), (volume_swap d b w), (volume_swap b c w),
      Z, S in E. lra. }
  assert (A1 : 0 < volume_of a d w) by nra. assert (A2 : 0 < volume_of d b w) by nra.
  destruct (toward_near _ _ _ _ _ B) as (e1 & H1 & K1).
  destruct (toward_near _ _ _ _ _ C) as (e2 & H2 & K2).
  destruct (toward_near _ _ _ _ _ A1) as (e3 & H3 & K3).
  destruct (toward_near _ _ _ _ _ A2) as (e4 & H4 & K4).
  exists (Rmin (Rmin e1 e2) (Rmin e3 e4)). split; [repeat apply Rmin_glb_lt; auto|].
  intros t Ht.
  assert (L1 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_l _ _)) (Rmin_l _ _)).
  assert (L2 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_l _ _)) (Rmin_r _ _)).
  assert (L3 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_r _ _)) (Rmin_l _ _)).
  assert (L4 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_r _ _)) (Rmin_r _ _)).
  specialize (K1 t L1). specialize (K2 t L2). specialize (K3 t L3). specialize (K4 t L4).
  destruct (Rle_dec 0 (volume_of a b (toward z y t))) as [P|P].
  - apply (cyclic_covered a b c); auto. unfold in_cone. lra.
  - apply (cyclic_covered b a d); auto. unfold in_cone.
    rewrite (volume_swap a b). lra.
Qed.

(** A path that meets no ray through a corner: cones go on along it. *)
Section Path.
Variables z y : point3.
Hypothesis no_ray : forall a b c, cyclic T a b c -> volume_of a y z <> 0.

Lemma on_ray a b c m : cyclic T a b c -> m < 1 -> volume_of a b (toward z y m) = 0 ->
  volume_of c a (toward z y m) = 0 -> False.
Proof.
  intros I M Z1 Z2. set (w := toward z y m) in *.
  assert (E : volume_of a b c * volume_of a y w = 0).
  { replace 0 with (volume_of a b w * volume_of a y c + volume_of c a w * volume_of a y b)
      by (rewrite Z1, Z2; ring). apply volume_along. }
  pose proof (cyclic_outward _ _ _ I) as D. apply Rmult_integral in E. destruct E as [E|E]; [lra|].
  unfold w in E. rewrite volume_toward in E.
  rewrite volume_none in E.
  apply (no_ray a b c I). apply Rmult_eq_reg_l with (1 - m); lra.
Qed.
Lemma goes_on m : m < 1 -> covered3 (toward z y m) ->
  exists e, 0 < e /\ forall t, Rabs (t - m) < e -> covered3 (toward z y t).
Proof.
  intros M (a & b & c & I & H1 & H2 & H3).
  assert (J : cyclic T a b c) by (left; auto).
  pose proof (cyclic_next _ _ _ _ J) as J2. pose proof (cyclic_next _ _ _ _ J2) as J3.
  destruct (Req_dec (volume_of a b (toward z y m)) 0) as [Z1|Z1];
    destruct (Req_dec (volume_of b c (toward z y m)) 0) as [Z2|Z2];
    destruct (Req_dec (volume_of c a (toward z y m)) 0) as [Z3|Z3];
    try (exfalso; eauto using on_ray; fail).
  - apply (wall_covered a b c z y m); auto; lra.
  - apply (wall_covered b c a z y m); auto; lra.
  - apply (wall_covered c a b z y m); auto; lra.
  - destruct (toward_near a b z y m) as (e1 & P1 & K1); [lra|].
    destruct (toward_near b c z y m) as (e2 & P2 & K2); [lra|].
    destruct (toward_near c a z y m) as (e3 & P3 & K3); [lra|].
    exists (Rmin e1 (Rmin e2 e3)). split; [repeat apply Rmin_glb_lt; auto|]. intros t Ht.
    assert (L1 := Rlt_le_trans _ _ _ Ht (Rmin_l _ _)).
    assert (L2 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_r _ _)) (Rmin_l _ _)).
    assert (L3 := Rlt_le_trans _ _ _ (Rlt_le_trans _ _ _ Ht (Rmin_r _ _)) (Rmin_r _ _)).
    exists a, b, c. split; auto. specialize (K1 t L1). specialize (K2 t L2). specialize (K3 t L3).
    unfold in_cone. lra.
Qed.
Lemma stays_out m : ~ covered3 (toward z y m) ->
  exists e, 0 < e /\ forall t, Rabs (t - m) < e -> ~ covered3 (toward z y t).
Proof.
  intros N.
  assert (G : forall L, (forall s, In s L -> In s T) -> exists e, 0 < e /\
    forall t, Rabs (t - m) < e -> forall a b c, In (a, b, c) L -> ~ in_cone a b c (toward z y t)).
  { induction L as [|[[a b] c] L IH]; intros Sub.
    - exists 1. split; [lra|]. intros t _ a b c [].
    - destruct IH as (e & E & K); [intros s I; apply Sub; simpl; auto|].
      assert (O : ~ in_cone a b c (toward z y m)).
      { intros H. apply N. exists a, b, c. split; auto. apply Sub. simpl; auto. }
      assert (G : forall u v, volume_of u v (toward z y m) < 0 -> exists f, 0 < f /\
        forall t, Rabs (t - m) < f -> volume_of u v (toward z y t) < 0).
      { intros u v H. destruct (toward_near v u z y m) as (f & F & Kf);
          [rewrite volume_swap; lra|]. exists f. split; auto. intros t Ht.
        specialize (Kf t Ht). rewrite volume_swap in Kf. lra. }
      assert (F : exists f, 0 < f /\ forall t, Rabs (t - m) < f ->
        ~ in_cone a b c (toward z y t)).
      { apply not_in_cone in O. unfold in_cone.
        destruct O as [O|[O|O]]; destruct (G _ _ O) as (f & F & Kf); exists f; split; auto;
          intros t Ht; specialize (Kf t Ht); lra. }
      destruct F as (f & F & Kf). exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
      intros t Ht u v w [Q|I].
      + injection Q; intros <- <- <-. apply Kf. eapply Rlt_le_trans; [exact Ht|apply Rmin_r].
      + apply (K t); auto. eapply Rlt_le_trans; [exact Ht|apply Rmin_l]. }
  destruct (G T (fun s I => I)) as (e & E & K). exists e. split; auto.
  intros t Ht (a & b & c & I & H). exact (K t Ht a b c I H).
Qed.
Lemma path_covered : covered3 z -> covered3 y.
Proof.
  intros Z.
  pose proof (toward_start z y) as T0. pose proof (toward_end z y) as T1.
  apply NNPP. intros N.
  set (E := fun t => 0 <= t <= 1 /\ covered3 (toward z y t)).
  assert (E0 : E 0) by (split; [lra|rewrite T0; exact Z]).
  destruct (completeness E) as (m & Up & Least).
  { exists 1. intros t [Ht _]. lra. }
  { exists 0. exact E0. }
  assert (M0 : 0 <= m) by (apply Up, E0).
  assert (M1 : m <= 1) by (apply Least; intros t [Ht _]; lra).
  destruct (classic (covered3 (toward z y m))) as [C|C].
  - assert (M : m < 1).
    { destruct M1 as [M1|M1]; auto. exfalso. apply N. rewrite <- T1, <- M1. exact C. }
    destruct (goes_on m M C) as (e & He & K).
    set (t := Rmin (m + e / 2) 1).
    assert (Ht : m < t <= m + e / 2) by (unfold t; split; [apply Rmin_glb_lt; lra|apply Rmin_l]).
    assert (Et : E t).
    { split; [split; [lra|apply Rmin_r]|]. apply K. rewrite Rabs_right; lra. }
    specialize (Up t Et). lra.
  - destruct (stays_out m C) as (e & He & K).
    assert (B : is_upper_bound E (m - e / 2)).
    { intros t Et. pose proof (Up t Et) as L. destruct Et as [_ Ct].
      destruct (Rle_dec t (m - e / 2)); auto. exfalso. apply (K t); auto.
      rewrite Rabs_left1; lra. }
    specialize (Least _ B). lra.
Qed.
End Path.

(** A vector that is perpendicular to another one *)
Definition aside (a : point3) : point3 :=
  let '(p, q, r) := a in if Req_EM_T p 0 then if Req_EM_T q 0 then (1, 0, 0) else (- q, p, 0)
  else (- q, p, 0).
Lemma aside_spec a : dot_3 (aside a) a = 0 /\ aside a <> (0, 0, 0).
Proof.
  destruct a as [[p q] r]. unfold aside, dot_3.
  destruct (Req_EM_T p 0) as [->|P]; [destruct (Req_EM_T q 0) as [->|Q]|].
  - split; [ring|]. intros E. injection E. lra.
  - split; [ring|]. intros E. injection E. lra.
  - split; [ring|]. intros E. injection E. lra.
Qed.
Lemma aside_across a y : a <> (0, 0, 0) -> dot_3 (aside a) y <> 0 -> cross_3 a y <> (0, 0, 0).
Proof.
  destruct (aside_spec a) as [D _]. revert D. generalize (aside a). intros u D N H E. apply H.
  destruct u as [[u1 u2] u3], a as [[a1 a2] a3], y as [[y1 y2] y3].
  unfold dot_3, cross_3 in *. injection E; intros E3 E2 E1.
  assert (M : a1 <> 0 \/ a2 <> 0 \/ a3 <> 0).
  { destruct (Req_dec a1 0) as [->|]; auto. destruct (Req_dec a2 0) as [->|]; auto.
    destruct (Req_dec a3 0) as [->|]; auto. }
  destruct M as [M|[M|M]].
  - apply Rmult_eq_reg_l with a1; auto.
    replace (a1 * (u1 * y1 + u2 * y2 + u3 * y3)) with (y1 * (u1 * a1 + u2 * a2 + u3 * a3)
      + u2 * (a1 * y2 - a2 * y1) - u3 * (a3 * y1 - a1 * y3)) by ring.
    rewrite D, E2, E3. ring.
  - apply Rmult_eq_reg_l with a2; auto.
    replace (a2 * (u1 * y1 + u2 * y2 + u3 * y3)) with (y2 * (u1 * a1 + u2 * a2 + u3 * a3)
      - u1 * (a1 * y2 - a2 * y1) + u3 * (a2 * y3 - a3 * y2)) by ring.
    rewrite D, E1, E3. ring.
  - apply Rmult_eq_reg_l with a3; auto.
    replace (a3 * (u1 * y1 + u2 * y2 + u3 * y3)) with (y3 * (u1 * a1 + u2 * a2 + u3 * a3)
      + u1 * (a3 * y1 - a1 * y3) - u2 * (a2 * y3 - a3 * y2)) by ring.
    rewrite D, E1, E2. ring.
Qed.

Theorem cones_cover x : covered3 x.
Proof.
  apply NNPP. intros N.
  set (firsts := flat_map (fun s : point3 * point3 * point3 =>
    let '(a, b, c) := s in [a; b; c]) T).
  assert (F : forall a b c, cyclic T a b c -> In a firsts).
  { intros a b c [I|[I|I]]; apply in_flat_map;
      [exists (a, b, c)|exists (b, c, a)|exists (c, a, b)]; simpl; auto. }
  assert (Z : forall a, In a firsts -> a <> (0, 0, 0)).
  { intros a I. apply in_flat_map in I. destruct I as ([[u v] w] & I & J). simpl in J.
    destruct J as [<-|[<-|[<-|[]]]].
    - apply (corner_not_zero u v w). left; auto.
    - apply (corner_not_zero v w u). right; right; auto.
    - apply (corner_not_zero w u v). right; left; auto. }
  destruct (soon_exists _ (soon_and _ _ (soon_uncovered x N)
    (soon_all (fun a t => dot_3 (aside a) (curve3 x t) <> 0) firsts
      (fun a _ => curve3_off _ x (proj2 (aside_spec a)))))) as (t & _ & N' & Off).
  set (y := curve3 x t) in *.
  destruct T as [|[[a b] c] T'] eqn:ET; [destruct some; reflexivity|].
  assert (I : In (a, b, c) T) by (rewrite ET; simpl; auto). rewrite <- ET in *.
  pose proof (outward a b c I) as D.
  set (z0 := add3 a (add3 b c)).
  assert (P : forall u v, 0 < volume_of u v z0 -> soon (fun t => 0 < volume_of u v (curve3 z0 t))).
  { intros u v H. eapply soon_imp; [|apply (curve3_positive (cross_3 u v) z0)].
    - intros s K. rewrite volume_dot. exact K.
    - rewrite <- volume_dot. exact H. }
  destruct (volume_sum a b c) as (P1 & P2 & P3). fold z0 in P1, P2, P3.
  destruct (soon_exists _ (soon_and _ _
    (soon_all (fun a t => dot_3 (cross_3 a y) (curve3 z0 t) <> 0) firsts
      (fun a J => curve3_off _ z0 (aside_across a y (Z a J) (Off a J))))
    (soon_and _ _ (P a b ltac:(lra)) (soon_and _ _ (P b c ltac:(lra)) (P c a ltac:(lra))))))
    as (s & _ & Ray & Q1 & Q2 & Q3).
  set (z := curve3 z0 s) in *.
  apply N', (path_covered z y).
  - intros u v w J. rewrite volume_dot. apply Ray, (F u v w J).
  - exists a, b, c. split; auto. unfold in_cone. lra.
Qed.
End Cover.
