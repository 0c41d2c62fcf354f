(** What the checker proves: [sum_is_right] and [point_is_right]. Their statements use the notions
    of Definitions.v alone. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Values Checker
  Corners Cancellation Bodies Scaling Trees.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

Lemma add_commutes p q : add p q = add q p.
Proof. unfold add; f_equal; ring. Qed.

(** ** What is covered is in the sum (rule `eq`, `cov`). *)
Lemma covered_in_sum cell hp hq parts :
  is_polygon cell = true -> is_body hp = true -> is_body hq = true ->
  all2 (fun x p => holds hp p && holds hq (qminus x p)) cell parts = true ->
  forall x, body cell x -> exists p q, body hp p /\ body hq q /\ x = add p q.
Proof.
  intros O Op Oq H x X. rewrite polygon_body in X by auto. destruct X as (a & b & c & I & K).
  pose proof (polygon_positive _ O _ _ _ I) as D.
  apply triangle_corners in I. destruct I as (u & v & z & Iu & Iv & Iz & -> & -> & ->).
  assert (G : forall y, In y cell -> exists p, inside hp (real p) /\
      inside hq (minus (real y) (real p))).
  { intros y J. destruct (all2_partner _ _ _ H y J) as (p & E).
    apply andb_prop in E. destruct E as [E1 E2]. exists p. split; [apply holds_real, E1|].
    rewrite <- real_minus. apply holds_real, E2. }
  destruct (G u Iu) as (pu & Pu & Qu). destruct (G v Iv) as (pv & Pv & Qv).
  destruct (G z Iz) as (pz & Pz & Qz).
  destruct (triangle_combination _ _ _ x D K) as (l & m & n & L & M & N & S & -> & _).
  exists (combination l m n (real pu) (real pv) (real pz)),
    (combination l m n (minus (real u) (real pu)) (minus (real v) (real pv))
       (minus (real z) (real pz))).
  split; [|split].
  - apply inside_body; auto. apply inside_combination; auto.
  - apply inside_body; auto. apply inside_combination; auto.
  - unfold combination, add, minus; simpl. f_equal; ring.
Qed.

(** ** The box holds the sum (rule `eq`, the box). *)
Lemma sum_in_box w la lb p q :
  is_tree (root (of_P w)) = true -> is_tree (root (of_Q w)) = true -> check_box w = true ->
  In la (leaves (root (of_P w))) -> In lb (leaves (root (of_Q w))) ->
  body la p -> body lb q -> left_of (box w) (add p q).
Proof.
  intros Wa Wb H Ia Ib Ka Kb u v I. unfold check_box in H. rewrite !andb_true_iff in H.
  destruct H as [[_ H] _]. rewrite forallb_forall in H. specialize (H _ I). cbn [fst snd] in H.
  set (n := outward (u, v)) in *.
  destruct (tree_le _ Wa) as [_ Na]. destruct (tree_le _ Wb) as [_ Nb].
  destruct (Na la Ia) as [Ola Da]. destruct (Nb lb Ib) as [Olb Db].
  apply le_value in H. rewrite value_plus, real_dot in H.
  assert (S1 : dot (real n) p <= value (support n (hull_of (root (of_P w))))).
  { apply (body_le la); auto. apply Da. intros z Z. apply support_real, Z. }
  assert (S2 : dot (real n) q <= value (support n (hull_of (root (of_Q w))))).
  { apply (body_le lb); auto. apply Db. intros z Z. apply support_real, Z. }
  assert (E : orient (real u) (real v) (add p q)
      = dot (real n) (real u) - dot (real n) p - dot (real n) q).
  { unfold orient, dot, add, n, outward, real; cbn [fst snd]. rewrite !value_minus. ring. }
  rewrite E. lra.
Qed.

(** ** What is in the sum is covered (rule `eq`, `sep`). *)
Definition covered_cells (w : witness) : list (list corner) := map fst (filter covered (cells w)).

Section NothingIsMissed.
Variable w : witness.
Hypothesis box_tiled : is_polygon (box w) = true /\
  same_boundary (ring_edges (box w)) (flat_map (fun c => ring_edges (fst c)) (cells w)) = true.
Hypothesis polygons : forall c, In c (cells w) -> is_polygon (fst c) = true.

Lemma covered_are_polygons l : In l (covered_cells w) -> is_polygon l = true.
Proof.
  intros I. apply in_map_iff in I. destruct I as (c & <- & I). apply filter_In in I.
  apply polygons, I.
Qed.
Lemma box_in_cells x : left_of (box w) x -> exists c, In c (cells w) /\ body (fst c) x.
Proof.
  intros L. destruct box_tiled as [B T].
  assert (O : forall l, In l (map fst (cells w)) -> is_polygon l = true).
  { intros l I. apply in_map_iff in I. destruct I as (c & <- & I). auto. }
  assert (X : union_of (all_triangles (map fst (cells w))) x).
  { apply (same_count_same_union (triangles (box w)) (all_triangles (map fst (cells w)))).
    - apply polygon_positive, B.
    - apply all_positive, O.
    - intros y. rewrite <- turns_of_polygon, <- turns_of_polygons.
      rewrite (same_boundary_same_turns _ _ T y). f_equal.
      rewrite !flat_map_concat_map, map_map. reflexivity.
    - apply left_polygon; auto. }
  apply union_of_all in X; auto. destruct X as (l & I & X). apply in_map_iff in I.
  destruct I as (c & <- & I). exists c; auto.
Qed.

(** A polygon la and any body lb, apart from all cells that are not covered *)
Lemma sum_is_covered la lb : is_polygon la = true -> is_body lb = true ->
  (forall c, In c (cells w) -> covered c = false -> separated (fst c) la lb) ->
  (forall p q, body la p -> body lb q -> left_of (box w) (add p q)) ->
  forall p q, body la p -> body lb q ->
    union_of (all_triangles (covered_cells w)) (add p q).
Proof.
  intros Oa Ob Sep Box p q Ka Kb.
  set (C := all_triangles (covered_cells w)).
  assert (OkC : positive C) by (apply all_positive, covered_are_polygons).
  destruct (union_decided C (add p q)) as [L|L]; auto. exfalso.
  rewrite polygon_body in Ka by auto. destruct Ka as (a1 & a2 & a3 & It & Kt).
  pose proof (polygon_positive _ Oa _ _ _ It) as D.
  set (d := minus (middle a1 a2 a3) p).
  destruct (soon_exists _ (soon_and _ _ (curve_inside a1 a2 a3 p D Kt)
    (curve_outside_all C (add p q) d OkC L))) as (t & _ & In1 & Out).
  fold d in In1. set (p' := curve p d t) in *.
  replace (curve (add p q) d t) with (add p' q) in Out
    by (unfold p', curve, add; simpl; f_equal; ring).
  assert (Kp : body la p').
  { rewrite polygon_body by auto. exists a1, a2, a3. split; auto.
    destruct In1 as (?&?&?). unfold closed_triangle. lra. }
  destruct (box_in_cells (add p' q) (Box p' q Kp Kb)) as (c & I & X).
  pose proof (polygons c I) as Ok. destruct (covered c) eqn:E.
  - apply Out, union_of_all; [apply covered_are_polygons|]. exists (fst c). split; auto.
    apply in_map, filter_In. auto.
  - destruct (Sep c I E) as (n & ma & mb & Nz & Ma & Mb & Mc).
    assert (K1 : dot n p' < ma).
    { pose proof (triangle_corners _ _ _ _ It) as (v1 & v2 & v3 & J1 & J2 & J3 & -> & -> & ->).
      apply (triangle_lt n ma _ _ _ p' D In1 Nz); auto. }
    assert (K2 : dot n q <= mb) by (apply (body_le lb); auto).
    assert (K3 : ma + mb <= dot n (add p' q)).
    { apply (body_ge (fst c)); auto. apply polygon_is_body, Ok. }
    unfold dot, add in *; simpl in *. lra.
Qed.
End NothingIsMissed.

(** ** The sum *)
Lemma fat_leaves s r o : check_operand s r o = true -> thin r = false ->
  forall l, In l (leaves (root o)) -> is_polygon l = true.
Proof.
  unfold check_operand. intros H T. rewrite T, !andb_true_iff, !forallb_forall in H. tauto.
Qed.
Lemma operand_tree s r o : check_operand s r o = true -> is_tree (root o) = true.
Proof. unfold check_operand. rewrite !andb_true_iff. tauto. Qed.
Lemma operand_solids s r o : check_operand s r o = true ->
  forall d, In d (solids o) -> is_solid (leaves (root o)) d = true.
Proof. unfold check_operand. rewrite !andb_true_iff, !forallb_forall. tauto. Qed.

(** Covered cells are in the sum. *)
Lemma cell_in_sum s P Q w c x : 0 < value s -> check_operand s P (of_P w) = true ->
  check_operand one Q (of_Q w) = true -> check_cell w c = true -> covered c = true ->
  body (fst c) x -> in_sum (value s) (outline P) (outline Q) x.
Proof.
  intros S HP HQ Hc Cc Kx. assert (Z : 0 < value one) by (rewrite value_one; lra).
  pose proof (operand_is_leaves _ _ _ S HP) as SP.
  pose proof (operand_is_leaves _ _ _ Z HQ) as SQ.
  unfold check_cell in Hc. apply andb_prop in Hc. destruct Hc as [Oc Hc].
  unfold covered in Cc. destruct (snd c) as [i j parts|code]; [|discriminate].
  destruct (nth_error (solids (of_P w)) i) as [a|] eqn:Ea; [|discriminate].
  destruct (nth_error (solids (of_Q w)) j) as [b|] eqn:Eb; [|discriminate].
  destruct (solid_in_leaves _ a (operand_solids _ _ _ HP a (nth_error_In _ _ Ea)))
    as [Oa La].
  destruct (solid_in_leaves _ b (operand_solids _ _ _ HQ b (nth_error_In _ _ Eb)))
    as [Ob Lb].
  destruct (covered_in_sum _ _ _ _ Oc Oa Ob Hc x Kx) as (p & q & Kp & Kq & ->).
  exists (scale (/ value s) p), q. split; [|split].
  - apply SP. rewrite scale_forth by auto. apply La, Kp.
  - apply SQ. rewrite scale_one. apply Lb, Kq.
  - rewrite scale_forth; auto.
Qed.

Lemma empty_set x : ~ set_of [] x.
Proof.
  intros H. destruct (H 1 Rlt_0_1) as (y & _ & _ & W). simpl in W. lia.
Qed.

(** What [check_sum] has found where no operand is empty *)
Lemma sum_parts s P Q R w : is_empty P || is_empty Q = false -> check_sum s P Q R w = true ->
  (forall c, In c (cells w) -> is_polygon (fst c) = true) /\ check_box w = true /\
  (forall x, set_of (outline R) x <-> union_of (all_triangles (covered_cells w)) x).
Proof.
  intros Em H. unfold check_sum in H. rewrite Em, !andb_true_iff in H.
  destruct H as ((((((((S & Th) & HP) & HQ) & HB) & HC) & TR) & NR) & BR).
  rewrite forallb_forall in HC.
  assert (OC : forall c, In c (cells w) -> is_polygon (fst c) = true).
  { intros c I. specialize (HC c I). unfold check_cell in HC. apply andb_prop in HC. tauto. }
  split; [exact OC|split; [exact HB|]]. intros x.
  apply negb_true_iff in TR. rewrite (set_of_fat R x TR), real_edges_of. apply region_is_union.
  - apply all_positive. intros l. apply covered_are_polygons; auto.
  - apply no_null_different, NR.
  - intros y. rewrite <- turns_of_polygons. apply (same_boundary_same_turns _ _ BR).
Qed.

Theorem sum_is_right : forall (s : number) (P Q R : rings corner) (w : witness),
  check_sum s P Q R w = true -> is_sum (value s) (outline P) (outline Q) (outline R).
Proof.
  intros s P Q R w H x. pose proof H as H0. unfold in_sum. unfold check_sum in H.
  destruct (is_empty P || is_empty Q) eqn:Em.
  - destruct R; try discriminate. split; intros K; [destruct (empty_set x K)|].
    destruct K as (p & q & Kp & Kq & _). apply orb_prop in Em.
    destruct Em as [Em|Em]; [destruct P|destruct Q]; try discriminate;
      [destruct (empty_set p Kp)|destruct (empty_set q Kq)].
  - pose proof Em as Em0. clear Em. rewrite !andb_true_iff in H.
    destruct H as ((((((((S & Th) & HP) & HQ) & HB) & HC) & TR) & NR) & BR).
    apply lt_value in S. rewrite value_zero in S.
    assert (Z : 0 < value one) by (rewrite value_one; lra).
    pose proof (operand_is_leaves _ _ _ S HP) as SP.
    pose proof (operand_is_leaves _ _ _ Z HQ) as SQ.
    pose proof (operand_tree _ _ _ HP) as WP. pose proof (operand_tree _ _ _ HQ) as WQ.
    rewrite forallb_forall in HC.
    assert (OC : forall c, In c (cells w) -> is_polygon (fst c) = true).
    { intros c I. specialize (HC c I). unfold check_cell in HC. apply andb_prop in HC. tauto. }
    assert (BT := HB). unfold check_box in BT. rewrite !andb_true_iff in BT.
    assert (Sep : forall c, In c (cells w) -> covered c = false -> forall la lb,
        In la (leaves (root (of_P w))) -> In lb (leaves (root (of_Q w))) ->
        separated (fst c) la lb).
    { intros c I E la lb Ia Ib. specialize (HC c I). unfold check_cell in HC.
      apply andb_prop in HC. destruct HC as [_ HC]. unfold covered in E.
      destruct (snd c) as [|code]; [discriminate|].
      apply (follow_separates _ _ _ HC) with (a := root (of_P w)) (b := root (of_Q w)); simpl; auto.
      intros a b [K|[]]. injection K; intros; subst; auto. }
    destruct (sum_parts s P Q R w Em0 H0) as (_ & _ & Res). specialize (Res x).
    rewrite Res. split.
    + intros U. apply union_of_all in U; [|intros l; apply covered_are_polygons; auto].
      destruct U as (l & I & Kx). apply in_map_iff in I. destruct I as (c & <- & I).
      apply filter_In in I. destruct I as [I Cc].
      exact (cell_in_sum s P Q w c x S HP HQ (HC c I) Cc Kx).
    + intros (p & q & Hp & Hq & ->). apply SP in Hp. apply SQ in Hq. rewrite scale_one in Hq.
      destruct Hp as (la & Ia & Ka). destruct Hq as (lb & Ib & Kb).
      pose proof (leaves_are_bodies _ WP la Ia) as Ola.
      pose proof (leaves_are_bodies _ WQ lb Ib) as Olb.
      assert (Box : forall p q, body la p -> body lb q -> left_of (box w) (add p q)).
      { intros. eapply sum_in_box with (la := la) (lb := lb); eauto. }
      destruct (thin P) eqn:TP; [destruct (thin Q) eqn:TQ; [discriminate|]|].
      * rewrite add_commutes. apply (sum_is_covered w) with (la := lb) (lb := la); auto; try tauto.
        { exact (fat_leaves _ _ _ HQ TQ lb Ib). }
        { intros c I E. apply separated_swap, Sep; auto. }
        { intros p' q' Kp' Kq'. rewrite add_commutes. auto. }
      * apply (sum_is_covered w) with (la := la) (lb := lb); auto; try tauto.
        exact (fat_leaves _ _ _ HP TP la Ia).
Qed.

(** ** Single points *)
Theorem point_is_right : forall (s : number) (P Q : rings corner) (x p q : corner)
    (of_P of_Q : tiled)
    (i j : nat),
  check_point s P Q x p q of_P of_Q i j = true ->
  set_of (outline P) (real p) /\ set_of (outline Q) (real q) /\
    real x = add (scale (value s) (real p)) (real q).
Proof.
  intros s P Q x p q oP oQ i j H. unfold check_point in H. rewrite !andb_true_iff in H.
  destruct H as [[[HP HQ] E] H].
  assert (Z : 0 < value one) by (rewrite value_one; lra).
  destruct (nth_error (leaves (root oP)) i) as [a|] eqn:Ea; [|discriminate].
  destruct (nth_error (leaves (root oQ)) j) as [b|] eqn:Eb; [|discriminate].
  apply nth_error_In in Ea. apply nth_error_In in Eb.
  apply andb_prop in H. destruct H as [Ha Hb].
  apply same_real in E. rewrite real_add, real_scaled in E. split; [|split]; auto.
  - apply (operand_is_leaves one P oP Z HP). exists a. split; auto. rewrite scale_one.
    apply inside_body; [|apply holds_real, Ha].
    apply (leaves_are_bodies _ (operand_tree _ _ _ HP) a Ea).
  - apply (operand_is_leaves one Q oQ Z HQ). exists b. split; auto. rewrite scale_one.
    apply inside_body; [|apply holds_real, Hb].
    apply (leaves_are_bodies _ (operand_tree _ _ _ HQ) b Eb).
Qed.

End Here.
