(** Points that a piece of the part and one of the obstacles share, by half-planes: they collide. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components
  Paths Clear Bounds Free Collisions.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** Half-planes *)
Definition on_side (c : touch) (v : R) : Prop :=
  match c with Allowed => 0 < v | Forbidden => 0 <= v end.
Definition plane_value (l : half_plane) (p : point) : R := dot (real (fst l)) p + value (snd l).
Lemma from_point_value n a p : plane_value (from_point n a) p = dot (real n) (minus p (real a)).
Proof.
  unfold plane_value, from_point; cbn [fst snd]. rewrite value_minus, real_dot, value_zero.
  unfold dot, minus; cbn [fst snd]. ring.
Qed.
Lemma turned_left_orient a b p :
  dot (real (turned_left (qminus b a))) (minus p (real a)) = orient (real a) (real b) p.
Proof.
  unfold turned_left, qminus, real, dot, minus, orient; cbn [fst snd].
  rewrite !value_minus, value_zero. ring.
Qed.
Lemma across_values n a b p : (forall l, In l (across n a b) -> 0 <= plane_value l p) ->
  0 <= dot (real n) (minus p (real a)) /\ dot (real n) (minus p (real b)) <= 0.
Proof.
  intros H. pose proof (H _ (or_introl eq_refl)) as H1.
  pose proof (H _ (or_intror (or_introl eq_refl))) as H2.
  rewrite from_point_value in H1, H2. rewrite real_opposite in H2. lra.
Qed.
Lemma segment_by_planes a b p : real a <> real b ->
  (forall l, In l (across (qminus b a) a b ++ across (turned_left (qminus b a)) a b) ->
    0 <= plane_value l p) -> on_segment (real a) (real b) p.
Proof.
  intros N H. destruct (across_values (qminus b a) a b p) as [A1 A2];
    [intros l I; apply H, in_or_app; auto|].
  destruct (across_values (turned_left (qminus b a)) a b p) as [B1 B2];
    [intros l I; apply H, in_or_app; auto|].
  rewrite turned_left_orient in B1.
  assert (E : dot (real (turned_left (qminus b a))) (minus p (real b))
    = orient (real a) (real b) p).
  { rewrite <- turned_left_orient. unfold turned_left, qminus, real, dot, minus; cbn [fst snd].
    rewrite !value_minus, value_zero. ring. }
  rewrite E in B2. rewrite real_minus in A1, A2. destruct (real a) as [a1 a2], (real b) as [b1 b2],
    p as [p1 p2]. unfold dot, minus, orient in *; cbn [fst snd] in *.
  set (d1 := b1 - a1) in *. set (d2 := b2 - a2) in *.
  assert (D : 0 < d1 * d1 + d2 * d2).
  { assert (M : d1 <> 0 \/ d2 <> 0).
    { destruct (Req_dec d1 0), (Req_dec d2 0); auto. exfalso. apply N. unfold d1, d2 in *.
      f_equal; lra. }
    destruct M; nra. }
  assert (O : d1 * (p2 - a2) = d2 * (p1 - a1)) by lra.
  set (D' := d1 * d1 + d2 * d2) in *. set (u := (d1 * (p1 - a1) + d2 * (p2 - a2)) / D').
  assert (U : u * D' = d1 * (p1 - a1) + d2 * (p2 - a2)) by (unfold u; field; lra).
  assert (B : d1 * (p1 - b1) + d2 * (p2 - b2) = d1 * (p1 - a1) + d2 * (p2 - a2) - D')
    by (unfold D', d1, d2; ring).
  exists u. split; [split; apply Rmult_le_reg_r with D'; lra|]. cbn [fst snd]. fold d1 d2.
  f_equal; apply Rmult_eq_reg_r with D'; try lra.
  - replace ((a1 + u * d1) * D') with (a1 * D' + d1 * (u * D')) by ring. rewrite U.
    replace (d1 * (d1 * (p1 - a1) + d2 * (p2 - a2)))
      with (d1 * d1 * (p1 - a1) + d2 * (d1 * (p2 - a2))) by ring. rewrite O. unfold D'. ring.
  - replace ((a2 + u * d2) * D') with (a2 * D' + d2 * (u * D')) by ring. rewrite U.
    replace (d2 * (d1 * (p1 - a1) + d2 * (p2 - a2)))
      with (d1 * (d2 * (p1 - a1)) + d2 * d2 * (p2 - a2)) by ring. rewrite <- O. unfold D'. ring.
Qed.
Lemma point_by_planes a p : (forall l, In l (across (one, zero) a a ++ across (zero, one) a a) ->
  0 <= plane_value l p) -> p = real a.
Proof.
  intros H. destruct (across_values (one, zero) a a p) as [A1 A2];
    [intros l I; apply H, in_or_app; auto|].
  destruct (across_values (zero, one) a a p) as [B1 B2]; [intros l I; apply H, in_or_app; auto|].
  assert (E1 : real (one, zero) = (1, 0))
    by (unfold real; cbn [fst snd]; rewrite value_one, value_zero; reflexivity).
  assert (E2 : real (zero, one) = (0, 1))
    by (unfold real; cbn [fst snd]; rewrite value_one, value_zero; reflexivity).
  rewrite E1 in A1, A2. rewrite E2 in B1, B2. unfold dot, minus in *; cbn [fst snd] in *.
  destruct p, (real a). simpl in *. f_equal; lra.
Qed.
Lemma polygon_planes l : is_polygon l = true ->
  half_planes l = map (fun e => from_point (turned_left (qminus (snd e) (fst e))) (fst e))
    (ring_edges l).
Proof. destruct l as [|a [|b [|c r]]]; try discriminate. reflexivity. Qed.
Lemma planes_body l p : is_body l = true ->
  (forall h, In h (half_planes l) -> 0 <= plane_value h p) -> body l p.
Proof.
  intros O H. destruct l as [|a [|b [|c r]]]; try discriminate.
  - apply point_by_planes, H.
  - simpl in H. unfold body. destruct (distinct a b) eqn:D.
    + apply segment_by_planes; [apply distinct_real, D|exact H].
    + rewrite (point_by_planes a p H). exists 0. split; [lra|]. destruct (real a). simpl.
      f_equal; ring.
  - change (is_polygon (a :: b :: c :: r) = true) in O. rewrite polygon_body by auto.
    apply left_polygon; auto. intros u v I. rewrite <- turned_left_orient, <- from_point_value.
    apply H. rewrite polygon_planes by auto. apply in_map_iff. exists (u, v). auto.
Qed.
Lemma planes_strict l p : is_polygon l = true ->
  (forall h, In h (half_planes l) -> 0 < plane_value h p) -> strict l p.
Proof.
  intros O H u v I. rewrite <- turned_left_orient, <- from_point_value.
  apply H. rewrite polygon_planes by auto. apply in_map_iff. exists (u, v). auto.
Qed.

(** ** Shared points *)
Definition have_shared (c : touch) (s : R) (a b : list corner) (x y : point) : Prop :=
  (c = Allowed -> is_polygon a = true /\ is_polygon b = true) /\
  (forall h, In h (half_planes b) -> on_side c (plane_value h y)) /\
  (forall h, In h (half_planes a) ->
    on_side c (dot (real (fst h)) (minus y x) + s * value (snd h))).
Lemma shares_holds c i a b x y s : shares c i a b x y = true -> in_scales i s ->
  have_shared c s a b (place_at s x) (place_at s y).
Proof.
  unfold shares. rewrite !andb_true_iff, !forallb_forall. intros [[Pol Hb] Ha] Si.
  assert (G : forall strictly slope rest_ v, is_positive_on i strictly slope rest_ = true ->
    strictly = is_allowed c -> value slope * s + value rest_ = v -> on_side c v).
  { intros strictly slope rest_ v H -> E. destruct (positive_on _ _ _ _ s H Si) as [G1 G2].
    rewrite E in *. destruct c; simpl; auto. }
  split; [intros ->; apply andb_prop, Pol|split]; intros h I.
  - apply (G _ _ _ _ (Hb h I) eq_refl). rewrite value_plus, !real_dot. unfold plane_value, place_at.
    unfold dot, add, scale; cbn [fst snd]. ring.
  - apply (G _ _ _ _ (Ha h I) eq_refl). rewrite value_plus, !real_dot. cbn [fst snd].
    rewrite !real_minus.
    unfold place_at, dot, add, minus, scale; cbn [fst snd]. ring.
Qed.
Lemma shared_between c s a b x y x' y' u : have_shared c s a b x y -> have_shared c s a b x' y' ->
  0 <= u <= 1 -> have_shared c s a b (at_ x x' u) (at_ y y' u).
Proof.
  intros (P & B & A) (_ & B' & A') U.
  assert (G : forall v w, on_side c v -> on_side c w -> on_side c ((1 - u) * v + u * w)).
  { intros v w. destruct c; simpl; [|nra]. intros V W.
    destruct (Req_dec u 0) as [->|]; [lra|]. assert (0 < u * w) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= (1 - u) * v) by (apply Rmult_le_pos; lra). lra. }
  split; [exact P|split]; intros h I.
  - specialize (G _ _ (B h I) (B' h I)). unfold plane_value, dot, at_ in *; cbn [fst snd] in *.
    match goal with H : on_side c ?v |- on_side c ?w => replace w with v by ring; exact H end.
  - specialize (G _ _ (A h I) (A' h I)). unfold dot, minus, at_ in *; cbn [fst snd] in *.
    match goal with H : on_side c ?v |- on_side c ?w => replace w with v by ring; exact H end.
Qed.
Lemma shared_collides c s r o of_r of_o a b x y : 0 < s -> check_sides c r o of_r of_o = true ->
  In a (solids of_r) -> In b (solids of_o) -> have_shared c s (fst a) (fst b) x y ->
  collides c s (outline r) (outline o) x.
Proof.
  intros S H Ia Ib (Pol & B & A). unfold check_sides in H. rewrite !andb_true_iff in H.
  destruct H as [[Hr Ho] _].
  destruct (solid_in_leaves _ a (operand_solids _ _ _ Hr a Ia)) as [Oa La].
  destruct (solid_in_leaves _ b (operand_solids _ _ _ Ho b Ib)) as [Ob Lb].
  assert (In_r : forall p, body (fst a) p -> set_of (outline r) p)
    by (intros p K; apply (set_leaves r of_r p Hr), La, K).
  assert (In_o : forall p, body (fst b) p -> set_of (outline o) p)
    by (intros p K; apply (set_leaves o of_o p Ho), Lb, K).
  set (p := scale (/ s) (minus y x)).
  assert (V : forall h, dot (real (fst h)) (minus y x) + s * value (snd h) = s * plane_value h p).
  { intros h. unfold plane_value, p, dot, scale, minus; cbn [fst snd]. field. lra. }
  assert (Back : forall z, z = add x (scale s (scale (/ s) (minus z x)))).
  { intros z. rewrite scale_forth by auto. destruct z. unfold add, minus; cbn [fst snd].
    f_equal; ring. }
  destruct c; simpl in *.
  - destruct (Pol eq_refl) as [Pa Pb]. exists y.
    assert (Sa : strict (fst a) p).
    { apply planes_strict; auto. intros h I. specialize (A h I). rewrite V in A.
      apply Rmult_lt_reg_l with s; lra. }
    assert (Sb : strict (fst b) y) by (apply planes_strict; auto).
    assert (Whole : forall l z, is_polygon l = true -> left_of l z -> body l z)
      by (intros l z O L; rewrite polygon_body by auto; apply left_polygon; auto).
    destruct (left_is_open _ _ Sa) as (e & He & Ne).
    destruct (left_is_open _ _ Sb) as (f & Hf & Nf).
    split.
    + exists (s * e). split; [apply Rmult_lt_0_compat; auto|]. intros z Z.
      exists (scale (/ s) (minus z x)). split; [|apply Back]. apply In_r, Whole, Ne; auto.
      unfold p. apply near_scale; [apply Rinv_0_lt_compat, S|].
      replace (e / / s) with (s * e) by (field; lra). destruct Z as [Z1 Z2].
      unfold near, minus; cbn [fst snd]. split.
      * replace (fst z - fst x - (fst y - fst x)) with (fst z - fst y) by ring. exact Z1.
      * replace (snd z - snd x - (snd y - snd x)) with (snd z - snd y) by ring. exact Z2.
    + exists f. split; auto.
  - exists y. split.
    + exists p. split; [|apply Back]. apply In_r, planes_body; auto. intros h I.
      specialize (A h I). rewrite V in A. apply Rmult_le_reg_l with s; lra.
    + apply In_o, planes_body; auto.
Qed.
