(** Convex bodies: points, segments and polygons. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Values Checker
  Corners Cancellation.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** The triangles of a polygon, and of several *)
Definition triangles (l : list corner) : list triangle := fan_of (map real l).
Definition all_triangles (ls : list (list corner)) : list triangle := flat_map triangles ls.

(** The set that a list of vertices stands for *)
Definition body (l : list corner) (x : point) : Prop :=
  match l with
  | [a] => x = real a
  | [a; b] => on_segment (real a) (real b) x
  | _ => union_of (triangles l) x
  end.

Lemma polygon_body l x : is_polygon l = true -> body l x = union_of (triangles l) x.
Proof. destruct l as [|a [|b [|c r]]]; try discriminate. reflexivity. Qed.
Lemma polygon_is_body l : is_polygon l = true -> is_body l = true.
Proof. destruct l as [|a [|b [|c r]]]; try discriminate. auto. Qed.
Lemma polygon_positive l : is_polygon l = true -> positive (triangles l).
Proof.
  unfold triangles. intros H a b c I. rewrite fan_of_map in I. apply in_map_iff in I.
  destruct I as ([[x y] z] & E & I). injection E; intros; subst.
  destruct l as [|p [|q [|r l]]]; try discriminate. unfold is_polygon in H.
  rewrite forallb_forall in H. specialize (H _ I). simpl in H. apply lt_value in H.
  rewrite real_orient, value_zero in H. exact H.
Qed.
Lemma triangle_corners l a b c : In (a, b, c) (triangles l) -> exists x y z,
  In x l /\ In y l /\ In z l /\ a = real x /\ b = real y /\ c = real z.
Proof.
  unfold triangles. rewrite fan_of_map, in_map_iff. intros ([[x y] z] & E & I).
  injection E; intros; subst. apply fan_corners in I. exists x, y, z; intuition.
Qed.
Lemma union_of_all ls x : (forall l, In l ls -> is_polygon l = true) ->
  (union_of (all_triangles ls) x <-> exists l, In l ls /\ body l x).
Proof.
  intros O. unfold union_of, all_triangles. split.
  - intros (a & b & c & I & K). apply in_flat_map in I. destruct I as (l & I & J).
    exists l. split; auto. rewrite polygon_body by auto. exists a, b, c; auto.
  - intros (l & I & B). rewrite polygon_body in B by auto. destruct B as (a & b & c & J & K).
    exists a, b, c. split; auto. apply in_flat_map. exists l; auto.
Qed.
Lemma all_positive ls : (forall l, In l ls -> is_polygon l = true) -> positive (all_triangles ls).
Proof.
  intros H a b c I. apply in_flat_map in I. destruct I as (l & I & J).
  exact (polygon_positive l (H l I) a b c J).
Qed.

(** A polygon's edges wind as its triangles do. *)
Lemma turns_of_polygon l y : turns (ring_edges l) y = sumz (crossing_of y) (triangles l).
Proof.
  unfold turns, triangles. change (map real_edge (ring_edges l)) with
    (map (both real) (ring_edges l)). rewrite <- ring_edges_map.
  change (winding (ring_edges (map real l)) y)
    with (sumz (edge_crossing y) (ring_edges (map real l))).
  rewrite (ring_sum (edge_crossing y)).
  - apply sumz_ext. intros [[a b] c] _. reflexivity.
  - intros a b. apply crossing_reversed.
Qed.
Lemma turns_of_polygons ls y :
  turns (flat_map ring_edges ls) y = sumz (crossing_of y) (all_triangles ls).
Proof.
  unfold all_triangles. induction ls as [|l ls IH]; simpl; [reflexivity|].
  rewrite sumz_app, <- IH, <- turns_of_polygon. unfold turns.
  change (winding (map real_edge (ring_edges l ++ flat_map ring_edges ls)) y)
    with (sumz (edge_crossing y) (map real_edge (ring_edges l ++ flat_map ring_edges ls))).
  rewrite map_app, sumz_app. reflexivity.
Qed.

(** ** The checker's test [holds], on real points; convexity *)
Definition left_of (l : list corner) (x : point) : Prop :=
  forall a b, In (a, b) (ring_edges l) -> 0 <= orient (real a) (real b) x.
Definition inside (l : list corner) (x : point) : Prop :=
  match l with
  | [a] => x = real a
  | [a; b] => on_segment (real a) (real b) x
  | _ => left_of l x
  end.

Lemma is_left_real l p : is_left l p = true -> left_of l (real p).
Proof.
  unfold is_left. rewrite forallb_forall. intros H a b I. specialize (H _ I).
  apply le_value in H. simpl in H. rewrite real_orient, value_zero in H. exact H.
Qed.
Lemma is_left_le l p : is_left l p = true ->
  forall a b, In (a, b) (ring_edges l) -> le zero (qorient a b p) = true.
Proof. unfold is_left. rewrite forallb_forall. intros H a b I. apply (H (a, b) I). Qed.
Lemma between_real x a b : between x a b = true ->
  value a <= value x <= value b \/ value b <= value x <= value a.
Proof.
  unfold between. rewrite orb_true_iff, !andb_true_iff.
  intros [[H1 H2]|[H1 H2]]; apply le_value in H1; apply le_value in H2; auto.
Qed.
Lemma fraction_between u v w : u <= v <= w \/ w <= v <= u -> u <> w ->
  exists t, 0 <= t <= 1 /\ v = u + t * (w - u).
Proof.
  intros H N. exists ((v - u) / (w - u)). split; [|field; lra].
  destruct (Rlt_dec u w) as [L|L].
  - assert (0 < / (w - u)) by (apply Rinv_0_lt_compat; lra). split.
    + apply Rmult_le_pos; lra.
    + apply Rmult_le_reg_r with (w - u); [lra|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l; lra.
  - assert (0 < / (u - w)) by (apply Rinv_0_lt_compat; lra).
    replace ((v - u) / (w - u)) with ((u - v) / (u - w)) by (field; lra). split.
    + apply Rmult_le_pos; lra.
    + apply Rmult_le_reg_r with (u - w); [lra|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma segment_by_orient a b x : orient a b x = 0 ->
  fst a <= fst x <= fst b \/ fst b <= fst x <= fst a ->
  snd a <= snd x <= snd b \/ snd b <= snd x <= snd a -> on_segment a b x.
Proof.
  intros O X Y. destruct a as [a1 a2], b as [b1 b2], x as [x1 x2].
  unfold orient, on_segment in *; cbn [fst snd] in *.
  destruct (Req_dec a1 b1) as [E|N].
  - destruct (Req_dec a2 b2) as [F|M].
    + exists 0. split; [lra|]. f_equal; lra.
    + destruct (fraction_between a2 x2 b2 Y M) as (t & T & ->). exists t. split; auto.
      rewrite <- E. f_equal. replace (a1 - a1) with 0 by ring. lra.
  - destruct (fraction_between a1 x1 b1 X N) as (t & T & Ht). exists t. split; auto.
    f_equal; [exact Ht|]. apply Rmult_eq_reg_l with (b1 - a1); [|lra]. subst x1. lra.
Qed.
Lemma holds_real l p : holds l p = true -> inside l (real p).
Proof.
  destruct l as [|a [|b [|c r]]]; unfold holds, inside.
  - apply is_left_real.
  - intros H. symmetry. apply same_real, H.
  - rewrite !andb_true_iff. intros [[O X] Y]. apply segment_by_orient.
    + apply equal_value in O. rewrite real_orient, value_zero in O. symmetry. exact O.
    + apply between_real, X.
    + apply between_real, Y.
  - apply is_left_real.
Qed.

Lemma left_polygon l x : is_polygon l = true -> left_of l x -> union_of (triangles l) x.
Proof.
  intros O H. destruct l as [|a [|b [|c r]]]; try discriminate.
  unfold triangles. cbn [map fan_of].
  destruct (left_in_fan (map real (c :: r)) (real a) (real b) x) as (u & v & w & I & K).
  - discriminate.
  - apply H. simpl; auto.
  - intros u v I. rewrite path_map in I. apply in_map_iff in I. destruct I as ([p q] & E & I).
    injection E; intros; subst. apply H. simpl. right. exact I.
  - exists u, v, w. auto.
Qed.
Lemma inside_body l x : is_body l = true -> inside l x -> body l x.
Proof.
  intros O. destruct l as [|a [|b [|c r]]]; try discriminate; auto. apply (left_polygon _ _ O).
Qed.
Lemma inside_combination l i j k a b c : 0 <= i -> 0 <= j -> 0 <= k -> i + j + k = 1 ->
  inside l a -> inside l b -> inside l c -> inside l (combination i j k a b c).
Proof.
  intros I J K S.
  assert (G : left_of l a -> left_of l b -> left_of l c -> left_of l (combination i j k a b c)).
  { intros Ha Hb Hc u v E.
    replace (orient (real u) (real v) (combination i j k a b c)) with
      (i * orient (real u) (real v) a + j * orient (real u) (real v) b
       + k * orient (real u) (real v) c).
    - specialize (Ha u v E). specialize (Hb u v E). specialize (Hc u v E). nra.
    - replace k with (1 - i - j) by lra. unfold orient, combination; simpl. ring. }
  destruct l as [|u [|v [|w r]]]; auto; unfold inside.
  - intros -> -> ->. destruct (real u) as [u1 u2]. unfold combination; simpl.
    replace k with (1 - i - j) by lra. f_equal; ring.
  - intros (t1 & T1 & ->) (t2 & T2 & ->) (t3 & T3 & ->). exists (i * t1 + j * t2 + k * t3).
    split; [nra|]. unfold combination; simpl. replace k with (1 - i - j) by lra. f_equal; ring.
Qed.

(** ** Linear functions are largest at vertices. *)
Lemma body_le l n M x : is_body l = true -> body l x ->
  (forall v, In v l -> dot n (real v) <= M) -> dot n x <= M.
Proof.
  intros O B H. destruct l as [|a [|b [|c r]]]; try discriminate.
  - simpl in B. subst. apply H; simpl; auto.
  - destruct B as (t & T & ->).
    assert (Ha : dot n (real a) <= M) by (apply H; simpl; auto).
    assert (Hb : dot n (real b) <= M) by (apply H; simpl; auto).
    unfold dot in *; cbn [fst snd] in *. nra.
  - destruct B as (u & v & w & I & K). pose proof (polygon_positive _ O _ _ _ I).
    apply triangle_corners in I. destruct I as (p & q & z & Ip & Iq & Iz & -> & -> & ->).
    eapply triangle_le; eauto.
Qed.
Lemma body_ge l n M x : is_body l = true -> body l x ->
  (forall v, In v l -> M <= dot n (real v)) -> M <= dot n x.
Proof.
  intros O K H. set (m := (- fst n, - snd n)).
  assert (E : forall p, dot m p = - dot n p) by (intros; unfold dot, m; simpl; ring).
  assert (dot m x <= - M); [|rewrite E in *; lra].
  apply (body_le l); auto. intros v I. rewrite E. specialize (H v I). lra.
Qed.
End Here.
