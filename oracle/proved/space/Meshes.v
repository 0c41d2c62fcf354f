(** Meshes: planes of faces in whole numbers, fans of triangles; what lies below the planes of all
    facets is the hull of the vertices. *)
From Coq Require Import Lra Lia Bool Permutation.
From Proved Require Import Definitions Space Fans Corners Rational Cones Means.

(** A facet as a fan of triangles that turn left *)
Open Scope Q_scope.
Definition is_fan (m : mesh) (face : list nat) : bool :=
  let ring := corners m face in
  let n := area_vector ring in
  match face with
  | _ :: _ :: _ :: _ =>
      forallb (fun t => let '(a, b, c) := t in
        less 0 (dot3 n (cross3 (minus3 b a) (minus3 c a)))) (fan_of ring)
  | _ => false
  end.

Open Scope R_scope.
(** Whole numbers *)
Lemma real_whole n d : Q2R (Qmake n d) = IZR n * / IZR (Zpos d).
Proof. reflexivity. Qed.
Lemma pos_real p : 0 < IZR (Zpos p).
Proof. apply IZR_lt. lia. Qed.
Lemma over_one_real v : let '(x, y, z, w) := over_one v in
  real3 v = (IZR x * / IZR (Zpos w), IZR y * / IZR (Zpos w), IZR z * / IZR (Zpos w)).
Proof.
  destruct v as [[[a p] [b q]] [c r]]. unfold over_one. cbn [Qnum Qden].
  destruct (Pos.eqb p q && Pos.eqb q r) eqn:E.
  - apply andb_prop in E. destruct E as [E1 E2]. apply Pos.eqb_eq in E1. apply Pos.eqb_eq in E2.
    subst q r. reflexivity.
  - unfold real3. rewrite !real_whole. pose proof (pos_real p). pose proof (pos_real q).
    pose proof (pos_real r).
    rewrite !mult_IZR, !Pos2Z.inj_mul, !mult_IZR. apply triples_equal; field; lra.
Qed.
Lemma plane_real ring : let '(a, b, c, h) := plane_of ring in exists k, 0 < k /\
  (IZR a, IZR b, IZR c) = scale3 (k, k, k) (real3 (area_vector ring)) /\
  IZR h = k * Q2R (level ring).
Proof.
  unfold plane_of. destruct (area_vector ring) as [[[a p] [b q]] [c r]].
  destruct (level ring) as [h s]. cbn [Qnum Qden].
  pose proof (pos_real p). pose proof (pos_real q). pose proof (pos_real r).
  pose proof (pos_real s).
  exists (IZR (Zpos p) * IZR (Zpos q) * IZR (Zpos r) * IZR (Zpos s)).
  split; [repeat apply Rmult_lt_0_compat; auto|]. unfold real3, scale3.
  rewrite !real_whole, !mult_IZR, !Pos2Z.inj_mul, !mult_IZR. split.
  - apply triples_equal; field; lra.
  - field. lra.
Qed.
Lemma side_real ring v : exists k, 0 < k /\ IZR (side (plane_of ring) (over_one v))
  = k * (dot_3 (real3 (area_vector ring)) (real3 v) - Q2R (level ring)).
Proof.
  pose proof (over_one_real v) as V. pose proof (plane_real ring) as L.
  destruct (over_one v) as [[[x y] z] w]. destruct (plane_of ring) as [[[a b] c] h].
  destruct L as (k & K & N & Hh). pose proof (pos_real w) as W. exists (k * IZR (Zpos w)).
  split; [apply Rmult_lt_0_compat; auto|]. unfold side.
  rewrite minus_IZR, !plus_IZR, !mult_IZR, Hh, V.
  destruct (real3 (area_vector ring)) as [[n1 n2] n3]. unfold scale3 in N.
  injection N; intros -> -> ->. unfold dot_3. field. lra.
Qed.
Lemma side_below ring v : (side (plane_of ring) (over_one v) <=? 0)%Z = true ->
  dot_3 (real3 (area_vector ring)) (real3 v) <= Q2R (level ring).
Proof.
  intros H. apply Z.leb_le, IZR_le in H. destruct (side_real ring v) as (k & K & E).
  rewrite E in H. apply Rnot_lt_le. intros L. nra.
Qed.
Lemma side_strict ring v : (side (plane_of ring) (over_one v) <? 0)%Z = true ->
  dot_3 (real3 (area_vector ring)) (real3 v) < Q2R (level ring).
Proof.
  intros H. apply Z.ltb_lt, IZR_lt in H. destruct (side_real ring v) as (k & K & E).
  rewrite E in H. apply Rnot_le_lt. intros L. nra.
Qed.
Lemma side_on ring v : (side (plane_of ring) (over_one v) =? 0)%Z = true ->
  dot_3 (real3 (area_vector ring)) (real3 v) = Q2R (level ring).
Proof.
  intros H. apply Z.eqb_eq in H. destruct (side_real ring v) as (k & K & E).
  rewrite H in E. symmetry in E. apply Rmult_integral in E. destruct E as [E|E]; lra.
Qed.
(** ** Fans of closed meshes are closed. *)
Lemma fan_has_edge {A} r : forall (a b x y : A), r <> [] ->
  In (x, y) ((a, b) :: path a b r) -> exists z, cyclic (fan a b r) x y z.
Proof.
  induction r as [|c r IH]; intros a b x y N I; [contradiction|].
  assert (First : cyclic (fan a b (c :: r)) a b c) by (left; simpl; auto).
  destruct I as [E|[E|I]].
  - injection E; intros <- <-. exists c. exact First.
  - injection E; intros <- <-. exists a. apply cyclic_next. exact First.
  - destruct r as [|d r].
    + destruct I as [E|[]]. injection E; intros <- <-. exists b.
      apply cyclic_next, cyclic_next. exact First.
    + destruct (IH a c x y) as (z & H); [discriminate|right; exact I|]. exists z.
      unfold cyclic in *. simpl in *. tauto.
Qed.
Lemma fan_edge {A} r : forall (a b x y z : A), cyclic (fan a b r) x y z ->
  In (x, y) ((a, b) :: path a b r) \/ exists w, cyclic (fan a b r) y x w.
Proof.
  induction r as [|c r IH]; intros a b x y z H; [unfold cyclic in H; simpl in H; tauto|].
  assert (First : cyclic (fan a b (c :: r)) a b c) by (left; simpl; auto).
  assert (Step : forall u v w, cyclic (fan a c r) u v w -> cyclic (fan a b (c :: r)) u v w)
    by (unfold cyclic; simpl; tauto).
  assert (Last : In (c, a) (path a b (c :: r)) \/ exists w, cyclic (fan a b (c :: r)) a c w).
  { destruct r as [|d r]; [left; simpl; auto|]. right. exists d. apply Step. left. simpl; auto. }
  assert (G : (x, y, z) = (a, b, c) \/ (y, z, x) = (a, b, c) \/ (z, x, y) = (a, b, c) \/
    cyclic (fan a c r) x y z).
  { unfold cyclic in *. simpl in H. intuition congruence. }
  destruct G as [E|[E|[E|G]]].
  - injection E; intros -> -> ->. left. simpl; auto.
  - injection E; intros -> -> ->. destruct Last as [L|L]; [left; right; exact L|right; exact L].
  - injection E; intros -> -> ->. left. simpl; auto.
  - destruct (IH a c x y z G) as [[E|I]|(w & K)].
    + injection E; intros <- <-. right. exists b. apply cyclic_next, cyclic_next. exact First.
    + left. right. simpl. right. exact I.
    + right. exists w. apply Step, K.
Qed.
Lemma fan_in_ring {A} (l : list A) x y : (2 < length l)%nat -> In (x, y) (ring_edges l) ->
  exists z, cyclic (fan_of l) x y z.
Proof.
  destruct l as [|a [|b [|c r]]]; simpl length; try lia. intros _ I.
  apply (fan_has_edge (c :: r)); [discriminate|exact I].
Qed.
Lemma ring_of_fan {A} (l : list A) x y z : cyclic (fan_of l) x y z ->
  In (x, y) (ring_edges l) \/ exists w, cyclic (fan_of l) y x w.
Proof.
  destruct l as [|a [|b r]]; try (unfold cyclic; simpl; tauto). apply fan_edge.
Qed.

(** ** What lies below the planes of all facets is in the hull. *)
(** The plane of a face, as its normal and its height *)
Definition normal_of (m : mesh) (face : list nat) : point3 := real3 (area_vector (corners m face)).
Definition height_of (m : mesh) (face : list nat) : R := Q2R (level (corners m face)).
Definition below_all (m : mesh) (x : point3) : Prop := forall face, In face (snd m) ->
  dot_3 (normal_of m face) x <= height_of m face.

Section Mesh.
Variable m : mesh.
Hypothesis convex : is_convex_mesh m = true.
Hypothesis fans : forallb (is_fan m) (snd m) = true.
Let place (i : nat) : point3 := real3 (nth i (fst m) (0, 0, 0)%Q).

Lemma outer_face face : In face (snd m) -> is_outer (map over_one (fst m)) m face = true.
Proof.
  unfold is_convex_mesh in convex. destruct (snd m) as [|f r] eqn:E; [discriminate|].
  apply andb_prop in convex. destruct convex as [H _]. rewrite forallb_forall in H. apply H.
Qed.
Lemma face_index face i : In face (snd m) -> In i face -> In (nth i (fst m) (0, 0, 0)%Q) (fst m).
Proof.
  intros F I. apply outer_face in F. unfold is_outer in F. rewrite !andb_true_iff in F.
  destruct F as [_ F]. rewrite forallb_forall in F. apply nth_In, Nat.ltb_lt, F, I.
Qed.
Lemma face_plane face : In face (snd m) ->
  (forall v, In v (fst m) -> dot_3 (normal_of m face) (real3 v) <= height_of m face) /\
  (exists v, In v (fst m) /\ dot_3 (normal_of m face) (real3 v) < height_of m face) /\
  (forall i, In i face -> dot_3 (normal_of m face) (place i) = height_of m face).
Proof.
  intros F. apply outer_face in F. unfold is_outer in F. rewrite !andb_true_iff in F.
  destruct F as [[[F1 F2] F3] _]. rewrite forallb_forall in F1, F3. unfold normal_of, height_of.
  split; [|split].
  - intros v I. apply side_below, F1, in_map, I.
  - apply existsb_exists in F2. destruct F2 as (u & I & V). apply in_map_iff in I.
    destruct I as (v & <- & I). exists v. split; auto. apply side_strict, V.
  - intros i I. unfold place. apply side_on, F3.
    unfold corners. apply (in_map (fun i => nth i (fst m) (0, 0, 0)%Q)), I.
Qed.
Lemma face_length face : In face (snd m) -> (2 < length face)%nat.
Proof.
  intros F. rewrite forallb_forall in fans. specialize (fans face F). unfold is_fan in fans.
  destruct face as [|a [|b [|c r]]]; try discriminate. simpl. lia.
Qed.

Definition all_fans : list (nat * nat * nat) := flat_map fan_of (snd m).
Lemma cyclic_in_face a b c : cyclic all_fans a b c -> exists face, In face (snd m) /\
  cyclic (fan_of face) a b c.
Proof.
  unfold cyclic, all_fans.
  intros [H|[H|H]]; apply in_flat_map in H; destruct H as (f & F & H); exists f; auto.
Qed.
Lemma cyclic_of_face face a b c : In face (snd m) -> cyclic (fan_of face) a b c ->
  cyclic all_fans a b c.
Proof.
  intros F. unfold cyclic, all_fans.
  intros [H|[H|H]]; [left|right; left|right; right]; apply in_flat_map; exists face; auto.
Qed.
Lemma fans_closed a b c : cyclic all_fans a b c -> exists d, cyclic all_fans b a d.
Proof.
  intros H. apply cyclic_in_face in H. destruct H as (f & F & H).
  destruct (ring_of_fan f a b c H) as [I|(w & K)].
  - assert (Cl : is_closed (snd m) = true).
    { pose proof convex as C. unfold is_convex_mesh in C.
      destruct (snd m); [discriminate|]. apply andb_prop in C. apply C. }
    unfold is_closed in Cl. apply andb_prop in Cl. destruct Cl as [_ Cl].
    set (edges := flat_map ring_edges (snd m)) in *.
    assert (J : In (a, b) edges) by (apply in_flat_map; exists f; auto).
    set (back := map (fun e : nat * nat => (snd e, fst e)) edges) in *.
    assert (Same : EdgeSort.sort edges = EdgeSort.sort back).
    { assert (Len : length (EdgeSort.sort edges) = length (EdgeSort.sort back)).
      { rewrite <- (Permutation_length (EdgeSort.Permuted_sort edges)),
          <- (Permutation_length (EdgeSort.Permuted_sort back)). symmetry. apply map_length. }
      revert Cl Len. generalize (EdgeSort.sort edges), (EdgeSort.sort back). clear.
      induction l as [|[u v] l IH]; intros [|[w x] k] H L; try discriminate; auto.
      simpl in H, L. apply andb_prop in H. destruct H as [H1 H2]. unfold same_edge in H1.
      cbn [fst snd] in H1. apply andb_prop in H1. destruct H1 as [E1 E2].
      apply Nat.eqb_eq in E1. apply Nat.eqb_eq in E2. subst. f_equal. apply IH; auto. }
    assert (K1 : In (b, a) edges).
    { apply (Permutation_in _ (Permutation_sym (EdgeSort.Permuted_sort edges))). rewrite Same.
      apply (Permutation_in _ (EdgeSort.Permuted_sort back)).
      apply (in_map (fun e : nat * nat => (snd e, fst e)) edges (a, b) J). }
    apply in_flat_map in K1. destruct K1 as (g & G & K1).
    destruct (fan_in_ring g b a (face_length g G) K1) as (d & D). exists d.
    apply (cyclic_of_face g); auto.
  - exists w. apply (cyclic_of_face f); auto.
Qed.
Lemma fan_outward face a b c o : In face (snd m) -> In (a, b, c) (fan_of face) ->
  dot_3 (normal_of m face) o < height_of m face ->
  0 < volume_of (minus_3 (place a) o) (minus_3 (place b) o) (minus_3 (place c) o).
Proof.
  intros F I O. destruct (face_plane face F) as (_ & _ & P).
  destruct (fan_corners face a b c I) as (Ia & Ib & Ic).
  assert (M : forall n u v, dot_3 n (minus_3 u v) = dot_3 n u - dot_3 n v)
    by (clear; intros n u v; unfold minus_3; coordinates; ring).
  apply (det_of_face (normal_of m face)).
  - rewrite M, (P b Ib), (P a Ia). ring.
  - rewrite M, (P c Ic), (P a Ia). ring.
  - rewrite forallb_forall in fans. pose proof (fans face F) as G. unfold is_fan in G.
    destruct face as [|x [|y [|z r]]]; try discriminate G. rewrite forallb_forall in G.
    unfold corners in G. rewrite fan_of_map in G.
    specialize (G (each (fun i => nth i (fst m) (0, 0, 0)%Q) (a, b, c)) (in_map _ _ _ I)).
    unfold each in G. apply less_real in G.
    rewrite Q2R_zero, real3_dot, real3_cross, !real3_minus in G. exact G.
  - rewrite (P a Ia). exact O.
Qed.

Theorem below_all_in_hull x : below_all m x -> hull (fst m) x.
Proof.
  intros B.
  assert (F0 : exists face, In face (snd m)).
  { unfold is_convex_mesh in convex. destruct (snd m) as [|f r]; [discriminate|].
    exists f. simpl; auto. }
  destruct F0 as (f0 & F0).
  assert (NV : fst m <> []).
  { pose proof (face_length f0 F0) as L. destruct f0 as [|i f0]; [simpl in L; lia|].
    pose proof (face_index _ i F0 (or_introl eq_refl)) as I. intros E. rewrite E in I. destruct I. }
  destruct (inside_exists (fst m) NV) as (o & Ho & In_).
  assert (Out : forall face, In face (snd m) -> dot_3 (normal_of m face) o < height_of m face).
  { intros face F. destruct (face_plane face F) as (P1 & P2 & _). apply In_; auto. }
  set (vector := fun i => minus_3 (place i) o).
  set (T := map (each vector) all_fans).
  assert (Cyc : forall u v w, cyclic T u v w -> exists a b c, u = vector a /\ v = vector b /\
    w = vector c /\ cyclic all_fans a b c).
  { unfold cyclic, T. intros u v w [H|[H|H]]; apply in_map_iff in H;
      destruct H as ([[a b] c] & E & I); unfold each in E; injection E; intros <- <- <-.
    - exists a, b, c. auto.
    - exists c, a, b. auto 8.
    - exists b, c, a. auto 8. }
  assert (Back : forall a b c, cyclic all_fans a b c -> cyclic T (vector a) (vector b) (vector c)).
  { unfold cyclic, T. intros a b c H.
    destruct H as [H|[H|H]]; [left|right; left|right; right];
      apply (in_map (each vector)) in H; exact H. }
  destruct (cones_cover T) with (x := minus_3 x o) as (u & v & w & I & K).
  - unfold T, all_fans. intros E. apply map_eq_nil in E.
    pose proof (face_length f0 F0) as L. destruct f0 as [|a [|b [|c r]]]; simpl in L; try lia.
    assert (J : In (a, b, c) (flat_map fan_of (snd m)))
      by (apply in_flat_map; exists (a :: b :: c :: r); split; [auto|simpl; auto]).
    rewrite E in J. destruct J.
  - intros u v w I. apply in_map_iff in I. destruct I as ([[a b] c] & E & I).
    unfold each in E. injection E; intros <- <- <-.
    apply in_flat_map in I. destruct I as (face & F & I).
    apply (fan_outward face); auto.
  - intros u v w H. destruct (Cyc u v w H) as (a & b & c & -> & -> & _ & J).
    destruct (fans_closed a b c J) as (d & D). exists (vector d). apply Back, D.
  - apply in_map_iff in I. destruct I as ([[a b] c] & E & I). unfold each in E.
    injection E; intros <- <- <-. apply in_flat_map in I. destruct I as (face & F & I).
    destruct (fan_corners face a b c I) as (Ia & Ib & Ic).
    destruct (face_plane face F) as (_ & _ & P).
    apply (cone_in_hull (fst m) (normal_of m face) (place a) (place b) (place c) o); auto.
    + apply vertex_in_hull, (face_index face a F Ia).
    + apply vertex_in_hull, (face_index face b F Ib).
    + apply vertex_in_hull, (face_index face c F Ic).
    + rewrite (P a Ia), (P b Ib). reflexivity.
    + rewrite (P a Ia), (P c Ic). reflexivity.
    + rewrite (P a Ia). auto.
    + apply (fan_outward face); auto.
    + rewrite (P a Ia). apply B, F.
Qed.
Theorem mesh_is_bounded : is_bounded m.
Proof.
  intros x. split; [|apply below_all_in_hull]. intros (ws & L & W & S & ->) face F.
  fold (normal_of m face) (height_of m face).
  destruct (face_plane face F) as (P & _). rewrite <- (Rmult_1_l (height_of m face)), <- S.
  apply dot_mean; [|rewrite map_length; auto|auto].
  intros p I. apply in_map_iff in I. destruct I as (v & <- & I). apply P, I.
Qed.
End Mesh.
