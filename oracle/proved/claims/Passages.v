(** Claim `passage`: points and segments inside the sum that the sum of the interiors misses. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Sums Crossings Fans Curves Unions Local Numbers
  Values Figures Corners Cancellation Bodies Scaling Trees Theorems Components Classes Holes
  Across Sides Overlaps.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** ** The checker *)
(** A contact, rule `eq`: a normal for each pair of pieces; and for a segment the numbers of the
    covered cells on its left and its right. Around a single point all cells are covered. *)
Record contact := { normals : list token; on_left : nat; on_right : nat }.
Definition is_off (a : corner) (cell : list corner) : bool :=
  is_convex cell && existsb (fun e => lt (qorient (fst e) (snd e) a) zero) (ring_edges cell).
Definition check_contact (w : witness) (e : corner * corner) (c : contact) : bool :=
  let '(a, b) := e in
  follow (normals c) [a; b] [(root (of_P w), root (of_Q w))] &&
  if same a b then
    is_strictly_in (box w) a &&
    forallb (is_off a) (map fst (filter (fun c => negb (covered c)) (cells w)))
  else distinct a b &&
    let yes := map fst (filter covered (cells w)) in
    match nth_error yes (on_left c), nth_error yes (on_right c) with
    | Some l, Some r => has_side l a b (qminus b a) && has_side r a b (qminus a b)
    | _, _ => false
    end.
Definition check_passage (s : number) (P Q : rings corner) (w : witness) (path : list corner)
    (contacts : list contact) : bool :=
  lt zero s && negb (thin P) && negb (thin Q) &&
  check_operand s P (of_P w) && check_operand one Q (of_Q w) &&
  check_box w && forallb (check_cell w) (cells w) &&
  negb (match path with [] => true | _ => false end) &&
  all2 (check_contact w) (segments_of path) contacts.

(** ** It is right. *)
Lemma is_off_real a cell : is_off a cell = true -> ~ left_of cell (real a).
Proof.
  unfold is_off. rewrite andb_true_iff, existsb_exists. intros [_ ([u v] & I & H)] L.
  specialize (L u v I). apply lt_value in H. cbn [fst snd] in H.
  rewrite real_orient, value_zero in H. lra.
Qed.

(** What is on a contact is not in the sum of the interiors. *)
Lemma contact_missed s P Q w code a b x : 0 < value s -> thin P = false ->
  check_operand s P (of_P w) = true -> check_operand one Q (of_Q w) = true ->
  follow code [a; b] [(root (of_P w), root (of_Q w))] = true ->
  on_segment (real a) (real b) x -> ~ in_interiors (value s) (outline P) (outline Q) x.
Proof.
  intros S Th HP HQ F X (p & q & Hp & Hq & E).
  assert (Z : 0 < value one) by (rewrite value_one; lra).
  assert (Kp : set_of (outline P) p) by (destruct Hp as (e & He & N); apply N, near_self, He).
  apply (operand_is_leaves _ _ _ S HP) in Kp. destruct Kp as (la & Ia & Ka).
  pose proof (fat_leaves _ _ _ HP Th la Ia) as Oa.
  pose proof Ka as Kt. rewrite polygon_body in Kt by auto. destruct Kt as (a1 & a2 & a3 & It & Kt).
  pose proof (polygon_positive _ Oa _ _ _ It) as D.
  set (sp := scale (value s) p) in *. set (d := minus (middle a1 a2 a3) sp).
  destruct Hq as (e & He & Nq).
  destruct (soon_exists _ (soon_and _ _ (curve_inside a1 a2 a3 sp D Kt) (curve_near e sp d He)))
    as (t & _ & In1 & Near). fold d in In1. set (p' := curve sp d t) in *.
  set (q' := minus x p').
  assert (Q' : set_of (outline Q) q').
  { apply Nq. destruct Near as [N1 N2]. unfold q'. rewrite E.
    split; unfold minus, add; cbn [fst snd].
    - replace (fst sp + fst q - fst p' - fst q) with (- (fst p' - fst sp)) by ring.
      rewrite Rabs_Ropp. exact N1.
    - replace (snd sp + snd q - snd p' - snd q) with (- (snd p' - snd sp)) by ring.
      rewrite Rabs_Ropp. exact N2. }
  apply (operand_is_leaves _ _ _ Z HQ) in Q'. destruct Q' as (lb & Ib & Kb).
  rewrite scale_one in Kb.
  pose proof (operand_tree _ _ _ HP) as WP. pose proof (operand_tree _ _ _ HQ) as WQ.
  destruct (follow_separates _ _ _ F) with (a := root (of_P w)) (b := root (of_Q w)) (la := la)
    (lb := lb) as (n & ma & mb & Nz & Ma & Mb & Mc); simpl; auto.
  { intros a' b' [K|[]]. injection K; intros; subst; auto. }
  assert (K1 : dot n p' < ma).
  { pose proof (triangle_corners _ _ _ _ It) as (v1 & v2 & v3 & J1 & J2 & J3 & E1 & E2 & E3).
    apply (triangle_lt n ma _ _ _ p' D In1 Nz); [rewrite E1|rewrite E2|rewrite E3]; auto. }
  assert (K2 : dot n q' <= mb).
  { apply (body_le lb); auto. apply (leaves_are_bodies _ WQ lb Ib). }
  assert (K3 : ma + mb <= dot n x).
  { destruct X as (u & U & ->). pose proof (Mc a (or_introl eq_refl)) as Ca.
    pose proof (Mc b (or_intror (or_introl eq_refl))) as Cb. unfold dot in *; cbn [fst snd]. nra. }
  assert (K4 : dot n x = dot n p' + dot n q')
    by (unfold q', dot, minus; cbn [fst snd]; ring).
  lra.
Qed.

(** What is between two covered cells is inside. *)
Lemma between_inside (S : point -> Prop) l r a b x :
  is_polygon l = true -> is_polygon r = true -> (forall y, body l y -> S y) ->
  (forall y, body r y -> S y) -> has_side l a b (qminus b a) = true ->
  has_side r a b (qminus a b) = true -> real a <> real b -> inner (real a) (real b) x ->
  interior S x.
Proof.
  intros Ol Or Sl Sr Hl Hr N X.
  destruct (has_side_near l a b _ x Hl X) as (e & He & Kl).
  destruct (has_side_near r a b _ x Hr X) as (f & Hf & Kr).
  pose proof (inner_on_line _ _ _ X) as Z.
  assert (G : forall y, near (Rmin e f) x y -> 0 < orient (real a) (real b) y ->
    union_of (triangles l) y).
  { intros y Y O. apply near_min in Y. apply left_polygon; auto. apply strict_left, Kl; [apply Y|].
    rewrite real_minus. rewrite (orient_along _ _ x y), Z in O. lra. }
  assert (M : 0 < Rmin e f) by (apply Rmin_glb_lt; auto).
  exists (Rmin e f / 2). split; [lra|]. intros y Y.
  assert (Y2 : near (Rmin e f) x y) by (destruct Y; split; lra).
  destruct (Rtotal_order (orient (real a) (real b) y) 0) as [O|[O|O]].
  - apply Sr. rewrite polygon_body by auto. apply near_min in Y2. apply left_polygon; auto.
    apply strict_left, Kr; [apply Y2|]. rewrite real_minus. rewrite (orient_along _ _ x y), Z in O.
    unfold along, minus in *; cbn [fst snd] in *. lra.
  - apply Sl. rewrite polygon_body by auto.
    destruct (union_decided (triangles l) y) as [U|U]; auto. exfalso.
    destruct (near_outside_all _ y (polygon_positive l Ol) U) as (g & Hg & K).
    destruct (left_close (real a) (real b) y (Rmin g (Rmin e f / 2)) N O) as (z & Zn & L).
    { apply Rmin_glb_lt; lra. }
    apply near_min in Zn. apply (K z (proj1 Zn)), G; auto.
    apply (near_near _ x y z); [exact Y|apply Zn].
  - apply Sl. rewrite polygon_body by auto. auto.
Qed.

Lemma segments_map path : segments_of (map real path) = map (both real) (segments_of path).
Proof.
  destruct path as [|a [|b r]]; try reflexivity. unfold segments_of. cbn [map]. revert a b.
  induction r as [|c r IH]; intros a b; [reflexivity|]. cbn [map segments] in *.
  f_equal. apply IH.
Qed.
Lemma passage_holds : forall (s : number) (P Q : rings corner) (w : witness) (path : list corner)
    (contacts : list contact),
  check_passage s P Q w path contacts = true ->
    is_passage (value s) (outline P) (outline Q) (map real path).
Proof.
  intros s P Q w path contacts H. unfold check_passage in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[[[[S TP] TQ] HP] HQ] HB] HC] Path] H].
  apply lt_value in S. rewrite value_zero in S. apply negb_true_iff in TP.
  rewrite forallb_forall in HC.
  assert (OC : forall c, In c (cells w) -> is_polygon (fst c) = true).
  { intros c I. specialize (HC c I). unfold check_cell in HC. apply andb_prop in HC. tauto. }
  split; [intros E; destruct path; discriminate|]. intros a' b' I' x X.
  rewrite segments_map in I'. apply in_map_iff in I'. destruct I' as ([a b] & E & I).
  injection E; intros <- <-. clear E. cbn [fst snd] in *.
  destruct (all2_partner _ _ _ H (a, b) I) as (c & K). unfold check_contact in K.
  apply andb_prop in K. destruct K as [F K].
  split; [exact (contact_missed s P Q w _ a b x S TP HP HQ F X)|]. intros In_.
  assert (Cov : forall l, In l (map fst (filter covered (cells w))) ->
    is_polygon l = true /\ forall y, body l y -> in_sum (value s) (outline P) (outline Q) y).
  { intros l J. apply in_map_iff in J. destruct J as (d & <- & J). apply filter_In in J.
    destruct J as [J Cd]. split; auto. intros y Y.
    exact (cell_in_sum s P Q w d y S HP HQ (HC d J) Cd Y). }
  destruct (same a b) eqn:Sab.
  - (* a single point *)
    apply same_real in Sab. apply andb_prop in K. destruct K as [K1 K2].
    assert (Ex : x = real a).
    { destruct X as (t & T & ->). rewrite <- Sab. destruct (real a). simpl. f_equal; ring. }
    subst x. apply strictly_in_real in K1. rewrite forallb_forall in K2.
    set (others := map fst (filter (fun c => negb (covered c)) (cells w))) in *.
    assert (Conv : forall l, In l others -> is_convex l = true)
      by (intros l J; specialize (K2 l J); unfold is_off in K2; apply andb_prop in K2; tauto).
    assert (Pol : forall l, In l others -> is_polygon l = true)
      by (intros l J; apply convex_polygon, Conv, J).
    destruct (left_is_open (box w) (real a) K1) as (e & He & L).
    destruct (union_decided (all_triangles others) (real a)) as [U|U].
    + exfalso. apply union_of_all in U; auto. destruct U as (l & J & B).
      rewrite polygon_body in B by auto.
      apply (is_off_real a l (K2 l J)), convex_union_left; auto.
    + destruct (near_outside_all _ _ (all_positive others Pol) U) as (f & Hf & N).
      exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
      unfold check_box in HB. rewrite !andb_true_iff in HB.
      destruct (box_in_cells w) with (x := y) as (d & J & B); [tauto|exact OC|apply L, Y|].
      destruct (covered d) eqn:Cd.
      * exact (cell_in_sum s P Q w d y S HP HQ (HC d J) Cd B).
      * exfalso. apply (N y (proj2 Y)), union_of_all; auto. exists (fst d). split; auto.
        apply in_map, filter_In. rewrite Cd. auto.
  - (* a segment *)
    apply andb_prop in K. destruct K as [Dab K]. apply distinct_real in Dab.
    destruct In_ as [E|[Na Nb]]; [contradiction|].
    destruct (nth_error _ (on_left c)) as [l|] eqn:El; [|discriminate].
    destruct (nth_error _ (on_right c)) as [r|] eqn:Er; [|discriminate].
    apply nth_error_In in El. apply nth_error_In in Er. apply andb_prop in K.
    destruct (Cov l El) as [Ol Sl]. destruct (Cov r Er) as [Or_ Sr].
    apply (between_inside _ l r a b); auto; [tauto|tauto|]. apply inner_of_segment; auto.
Qed.
End Here.

#[local] Instance anywhere : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.
Definition check_one_passage (s : Q) (P Q : rings vertex) (w : witness) (path : list vertex)
    (contacts : list contact) : bool :=
  check_passage (Fixed s) (fixed_rings P) (fixed_rings Q) w (map fixed path) contacts.
Theorem passage_is_right : forall (s : Q) (P Q : rings vertex) (w : witness) (path : list vertex)
    (contacts : list contact), check_one_passage s P Q w path contacts = true ->
  is_passage (Q2R s) (points P) (points Q) (map point_of path).
Proof.
  intros s P Q w path contacts H. apply passage_holds in H.
  rewrite !outline_fixed, map_map in H. exact H.
Qed.
