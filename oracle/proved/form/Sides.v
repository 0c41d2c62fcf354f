(** Edges as rows of stretches between cells: a covered cell on the left of each, one that is not
    covered on its right. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Numbers Values
  Figures Corners Cancellation Bodies Scaling Trees Theorems Components Classes Across.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

Definition shifted (x d : point) (t : R) : point := (fst x + t * fst d, snd x + t * snd d).

Lemma orient_shifted a b x d t :
  orient a b (shifted x d t) = orient a b x + t * along (minus b a) d.
Proof. unfold orient, shifted, along, minus; simpl; ring. Qed.
Lemma orient_along a b x y : orient a b y = orient a b x + along (minus b a) (minus y x).
Proof. unfold orient, along, minus; simpl; ring. Qed.
Lemma square_positive d : d <> (0, 0) -> 0 < dot d d.
Proof.
  intros N. destruct d as [d1 d2]. unfold dot; simpl.
  destruct (Req_dec d1 0), (Req_dec d2 0); try nra. exfalso. apply N. f_equal; auto.
Qed.
Lemma along_aligned d w z : along w d = 0 -> 0 < dot w d -> 0 < along d z -> 0 < along w z.
Proof.
  intros A D Z.
  assert (E : dot d d * along w z = dot w d * along d z + along w d * dot d z)
    by (unfold dot, along; ring).
  rewrite A in E. assert (0 < dot d d).
  { apply square_positive. intros ->. unfold dot in D; simpl in D. lra. }
  nra.
Qed.
Lemma small_step x d r : 0 < r -> exists t0, 0 < t0 /\ forall t, Rabs t <= t0 ->
  near r x (shifted x d t).
Proof.
  intros R. pose proof (Rabs_pos (fst d)). pose proof (Rabs_pos (snd d)).
  exists (r / (1 + Rabs (fst d) + Rabs (snd d))).
  assert (P : 0 < r / (1 + Rabs (fst d) + Rabs (snd d))) by (apply Rdiv_lt_0_compat; lra).
  assert (E : r / (1 + Rabs (fst d) + Rabs (snd d)) * (1 + Rabs (fst d) + Rabs (snd d)) = r)
    by (field; lra).
  set (t0 := r / (1 + Rabs (fst d) + Rabs (snd d))) in *. clearbody t0.
  split; auto. intros t T. pose proof (Rabs_pos t). unfold near, shifted; cbn [fst snd]. split.
  - replace (fst x + t * fst d - fst x) with (t * fst d) by ring. rewrite Rabs_mult. nra.
  - replace (snd x + t * snd d - snd x) with (t * snd d) by ring. rewrite Rabs_mult. nra.
Qed.

(** C is on the left of the line through a and b near x, and nothing of S on its right. *)
Definition sided (C S : point -> Prop) (a b x : point) : Prop :=
  exists r, 0 < r /\ forall y, near r x y ->
    (0 < orient a b y -> C y) /\ (orient a b y < 0 -> ~ S y).
Definition on_stretch (C S : point -> Prop) (a b u v : point) : Prop :=
  orient a b v = 0 /\ 0 < dot (minus v u) (minus b a) /\
  forall x, inner u v x -> sided C S a b x.
Inductive row (C S : point -> Prop) (a b : point) : point -> list point -> Prop :=
| row_end : row C S a b b []
| row_stretch u v l : on_stretch C S a b u v -> row C S a b v l -> row C S a b u (v :: l).

(** ** Points of a row *)
Lemma on_line_shifted a b u v : a <> b -> orient a b u = 0 -> orient a b v = 0 ->
  v = shifted u (minus b a) (dot (minus v u) (minus b a) / dot (minus b a) (minus b a)).
Proof.
  intros N U V. set (d := minus b a) in *.
  assert (P : 0 < dot d d).
  { apply square_positive. intros E. apply N. unfold d, minus in E. injection E; intros.
    destruct a, b; simpl in *. f_equal; lra. }
  assert (A : along d (minus v u) = 0)
    by (pose proof (orient_along a b u v) as O; fold d in O; lra).
  destruct u as [u1 u2], v as [v1 v2], d as [d1 d2]. unfold shifted, dot, along, minus in *.
  cbn [fst snd] in *. set (q := (_ + _) / (_ + _)).
  assert (Q : q * (d1 * d1 + d2 * d2) = (v1 - u1) * d1 + (v2 - u2) * d2)
    by (unfold q; field; lra).
  f_equal; apply Rmult_eq_reg_r with (d1 * d1 + d2 * d2); try lra; apply Rminus_diag_uniq.
  - replace (_ - _) with (- d2 * (d1 * (v2 - u2) - d2 * (v1 - u1))
      + d1 * ((v1 - u1) * d1 + (v2 - u2) * d2 - q * (d1 * d1 + d2 * d2))) by ring.
    rewrite A, Q. ring.
  - replace (_ - _) with (d1 * (d1 * (v2 - u2) - d2 * (v1 - u1))
      + d2 * ((v1 - u1) * d1 + (v2 - u2) * d2 - q * (d1 * d1 + d2 * d2))) by ring.
    rewrite A, Q. ring.
Qed.
Lemma stretch_step C S a b u v : orient a b u = 0 -> on_stretch C S a b u v -> exists t, 0 < t /\
  v = shifted u (minus b a) t.
Proof.
  intros U (V & D & _). assert (N : a <> b).
  { intros ->. unfold minus, dot in D. cbn [fst snd] in D. lra. }
  exists (dot (minus v u) (minus b a) / dot (minus b a) (minus b a)). split.
  - apply Rdiv_lt_0_compat; auto. apply square_positive. intros E. apply N.
    unfold minus in E. injection E; intros. destruct a, b; simpl in *. f_equal; lra.
  - apply on_line_shifted; auto.
Qed.
Lemma shifted_twice x d s t : shifted (shifted x d s) d t = shifted x d (s + t).
Proof. unfold shifted; simpl. f_equal; ring. Qed.
Lemma shifted_none x d : shifted x d 0 = x.
Proof. destruct x. unfold shifted; simpl. f_equal; ring. Qed.
Lemma shifted_same x d s t : d <> (0, 0) -> shifted x d s = shifted x d t -> s = t.
Proof.
  intros N E. unfold shifted in E. injection E; intros E2 E1. destruct d as [d1 d2]; simpl in *.
  destruct (Req_dec d1 0) as [->|N1].
  - destruct (Req_dec d2 0) as [->|N2]; [destruct N; reflexivity|].
    apply Rmult_eq_reg_r with d2; auto. lra.
  - apply Rmult_eq_reg_r with d1; auto. lra.
Qed.
Lemma row_length C S a b u l : row C S a b u l -> orient a b u = 0 -> exists t, 0 <= t /\
  b = shifted u (minus b a) t.
Proof.
  induction 1 as [|u v l P K IH]; intros U.
  - exists 0. split; [lra|]. rewrite shifted_none. reflexivity.
  - destruct (stretch_step C S a b u v U P) as (s & Hs & E).
    destruct IH as (t & Ht & F); [apply P|]. exists (s + t). split; [lra|].
    rewrite <- shifted_twice, <- E. exact F.
Qed.
Lemma minus_none a b : minus b a = (0, 0) -> a = b.
Proof.
  intros E. unfold minus in E. injection E; intros. destruct a, b; simpl in *. f_equal; lra.
Qed.

(** Each point of a row but the first is in a stretch: its end, or inside it. *)
Lemma row_cover C S a b u l : row C S a b u l -> orient a b u = 0 -> forall x,
  on_segment u b x -> x = u \/ exists p v, In v l /\ on_stretch C S a b p v /\
    orient a b p = 0 /\ x <> p /\ (x = v \/ (inner p v x /\ x <> b)).
Proof.
  induction 1 as [|u v l P K IH]; intros U x X.
  - left. destruct X as (t & T & ->). destruct b. simpl. f_equal; ring.
  - destruct (stretch_step C S a b u v U P) as (s & Hs & E).
    destruct (row_length C S a b v l K (proj1 P)) as (t & Ht & F).
    set (d := minus b a) in *.
    assert (D : d <> (0, 0)).
    { intros D. destruct P as (_ & P & _). fold d in P. rewrite D in P. unfold dot in P.
      simpl in P. lra. }
    assert (B : b = shifted u d (s + t)) by (rewrite <- shifted_twice, <- E; exact F).
    destruct X as (m & M & X). set (k := m * (s + t)).
    assert (X' : x = shifted u d k).
    { rewrite X. unfold shifted, k. f_equal.
      - replace (fst b - fst u) with ((s + t) * fst d) by (rewrite B; simpl; ring). ring.
      - replace (snd b - snd u) with ((s + t) * snd d) by (rewrite B; simpl; ring). ring. }
    assert (K0 : 0 <= k <= s + t) by (unfold k; nra).
    destruct (Req_dec k 0) as [Z|Z]; [left; rewrite X', Z, shifted_none; reflexivity|].
    right. destruct (Rle_dec k s) as [L|L].
    + exists u, v. split; [simpl; auto|split; [exact P|split; [exact U|split]]].
      { intros Q. rewrite X' in Q. rewrite <- (shifted_none u d) in Q at 2.
        apply shifted_same in Q; auto. }
      destruct (Req_dec k s) as [->|N]; [left; congruence|right]. split.
      * exists (k / s). split.
        { split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with s; [lra|].
          unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
        rewrite X', E. unfold shifted; simpl. f_equal; field; lra.
      * intros Q. assert (Q' : shifted u d k = shifted u d (s + t)) by congruence.
        apply shifted_same in Q'; auto. lra.
    + destruct (IH (proj1 P) x) as [->|(p & q & I & G)].
      * exists ((k - s) / t). assert (0 < t) by lra. split.
        { split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]|].
          apply Rmult_le_reg_r with t; [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
        rewrite X', E. unfold shifted; cbn [fst snd].
        pose proof (f_equal fst B) as B1. pose proof (f_equal snd B) as B2.
        cbn [fst snd shifted] in B1, B2. rewrite B1, B2. f_equal; field; lra.
      * exists u, v. split; [simpl; auto|split; [exact P|split; [exact U|split; [|left; auto]]]].
        intros Q. rewrite E in Q. rewrite <- (shifted_none u d) in Q at 2.
        apply shifted_same in Q; auto. lra.
      * exists p, q. split; [simpl; auto|exact G].
Qed.

(** ** What the checker finds of a stretch *)
Lemma real_qmiddle u v : real (qmiddle u v) = ((fst (real u) + fst (real v)) / 2,
  (snd (real u) + snd (real v)) / 2).
Proof.
  unfold real, qmiddle; simpl. rewrite !value_reduced, !value_times, !value_plus.
  rewrite value_half. f_equal; field.
Qed.
Lemma has_side_near cell u v d x : has_side cell u v d = true -> inner (real u) (real v) x ->
  exists r, 0 < r /\ forall y, near r x y -> 0 < along (real d) (minus y x) -> strict cell y.
Proof.
  unfold has_side. rewrite !andb_true_iff. intros [[Hu Hv] H] (t & T & X).
  apply is_left_real in Hu. apply is_left_real in Hv.
  destruct (side_of cell (qmiddle u v)) as [w|] eqn:W; [|discriminate].
  unfold is_along in H. apply andb_prop in H. destruct H as [H1 H2].
  apply equal_value in H1. symmetry in H1. apply lt_value in H2.
  rewrite value_minus, !value_times, value_zero in H1.
  rewrite value_plus, !value_times, value_zero in H2.
  unfold side_of in W.
  destruct (filter _ (ring_edges cell)) as [|[a b] [|? ?]] eqn:F; try discriminate.
  destruct (is_left cell (qmiddle u v)) eqn:L; [|discriminate]. injection W; intros <-.
  cbn [fst snd] in *.
  pose proof L as L'. apply is_left_real in L.
  assert (M : forall p q, orient p q (real (qmiddle u v))
    = (orient p q (real u) + orient p q (real v)) / 2).
  { intros p q. rewrite real_qmiddle. unfold orient; simpl. field. }
  assert (Ox : forall p q, orient p q x
    = (1 - t) * orient p q (real u) + t * orient p q (real v)).
  { intros p q. rewrite X. unfold orient; simpl. ring. }
  assert (G : forall p q, In (p, q) (ring_edges cell) ->
    ((p, q) = (a, b) /\ orient (real p) (real q) x = 0) \/ 0 < orient (real p) (real q) x).
  { intros p q I. specialize (Hu p q I). specialize (Hv p q I).
    destruct (equal zero (qorient p q (qmiddle u v))) eqn:E.
    - left. split.
      + assert (J : In (p, q) [(a, b)]) by (rewrite <- F; apply filter_In; auto).
        destruct J as [J|[]]. auto.
      + apply equal_value in E. symmetry in E. rewrite real_orient, value_zero, M in E. rewrite Ox.
        replace (orient (real p) (real q) (real u)) with 0 by lra.
        replace (orient (real p) (real q) (real v)) with 0 by lra. ring.
    - right. specialize (L p q I). rewrite M in L.
      assert (N : orient (real p) (real q) (real (qmiddle u v)) <> 0).
      { intros Z. rewrite <- real_orient in Z.
        pose proof (not_equal_value _ _ (is_left_le cell _ L' p q I) E) as K.
        rewrite value_zero in K. lra. }
      rewrite M in N. rewrite Ox.
      set (f := orient (real p) (real q) (real u)) in *.
      set (g := orient (real p) (real q) (real v)) in *.
      destruct (Rlt_dec 0 f); [|assert (0 < g) by lra]; nra. }
  clear F L L' Hu Hv. unfold strict. induction (ring_edges cell) as [|[p q] E IH].
  - exists 1. split; [lra|]. intros y _ _ ? ? [].
  - destruct IH as (r & Hr & K); [intros; apply G; simpl; auto|].
    destruct (G p q (or_introl eq_refl)) as [[S Z]|S].
    + injection S; intros -> ->. exists r. split; auto. intros y Y A p' q' [I|I].
      * injection I; intros <- <-. rewrite (orient_along _ _ x y), Z, Rplus_0_l.
        apply (along_aligned (real d)); auto; rewrite <- real_minus; unfold along, dot, real;
          cbn [fst snd]; lra.
      * apply (K y); auto.
    + destruct (near_left _ _ _ S) as (f & Hf & N). exists (Rmin r f).
      split; [apply Rmin_glb_lt; auto|]. intros y Y A p' q' [I|I]; apply near_min in Y.
      * injection I; intros <- <-. apply (N y (proj2 Y)).
      * apply (K y (proj1 Y) A); auto.
Qed.

Section Cells.
Variable yes no : list (list corner).
Hypothesis yes_polygons : forall l, In l yes -> is_polygon l = true.
Hypothesis no_convex : forall l, In l no -> is_convex l = true.
Hypothesis once : forall y, (sumz (crossing_of y) (all_triangles no)
  + sumz (crossing_of y) (all_triangles yes) <= 1)%Z.

Lemma inside_other l x : In l no -> strict l x -> ~ covered_set yes x.
Proof.
  intros I X (a & b & c & J & K).
  destruct (left_is_open l x X) as (e & He & N).
  destruct (soon_exists _ (soon_and _ _ (curve_near e x (minus (middle a b c) x) He)
    (curve_inside a b c x (yes_positive yes yes_polygons _ _ _ J) K))) as (t & _ & K1 & K2).
  apply (no_overlap (all_triangles yes) (all_triangles no)) with a b c
    (curve x (minus (middle a b c) x) t); auto.
  - apply yes_positive, yes_polygons.
  - apply no_positive, no_convex.
  - intros y. specialize (once y). lia.
  - destruct (left_polygon l _ (convex_polygon _ (no_convex l I)) (N _ K1)) as (u & v & w & G & H).
    exists u, v, w. split; auto. eapply triangle_of_cell; eauto.
Qed.

Variable part : list (list corner).
Variable c : component.
Hypothesis part_in_yes : forall l, In l part -> In l yes.
Hypothesis one_class : is_class part c = true.

Lemma check_row a b l : forall u, check_side part no a b u l = true ->
  orient (real a) (real b) (real u) = 0 ->
  row (class yes part) (covered_set yes) (real a) (real b) (real u) (map real (map snd l)).
Proof.
  induction l as [|[[i j] v] l IH]; intros u H U; simpl in H.
  - apply same_real in H. rewrite H. apply row_end.
  - rewrite !andb_true_iff in H. destruct H as [[[H1 H2] H3] H4].
    destruct (nth_error part i) as [d|] eqn:Ed; [|discriminate].
    destruct (nth_error no j) as [o|] eqn:Eo; [|discriminate].
    apply nth_error_In in Ed. apply nth_error_In in Eo.
    apply andb_prop in H3. destruct H3 as [Hd Ho]. cbn [map snd].
    apply equal_value in H1. symmetry in H1. rewrite real_orient, value_zero in H1.
    apply row_stretch; [|apply IH; auto].
    unfold is_along in H2. apply andb_prop in H2. destruct H2 as [_ H2]. apply lt_value in H2.
    split; [exact H1|split].
    + rewrite value_zero, value_plus, !value_times in H2. rewrite <- !real_minus.
      unfold dot, real; cbn [fst snd]. lra.
    + intros x X.
      destruct (has_side_near d u v _ x Hd X) as (r & Hr & Kd).
      destruct (has_side_near o u v _ x Ho X) as (s & Hs & Ko).
      assert (Z : orient (real a) (real b) x = 0).
      { destruct X as (t & _ & ->).
        replace (orient _ _ _) with ((1 - t) * orient (real a) (real b) (real u)
          + t * orient (real a) (real b) (real v)) by (unfold orient; simpl; ring).
        rewrite U, H1. ring. }
      exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
      rewrite (orient_along _ _ x y), Z, Rplus_0_l. split; intros A.
      * assert (Sd : strict d y) by (apply Kd; [apply Y|rewrite real_minus; exact A]).
        apply (left_in_class yes part c one_class d); auto; [apply strict_left, Sd|].
        apply (strict_in_interior yes part c part_in_yes one_class d); auto.
      * apply (inside_other o); auto. apply Ko; [apply Y|]. rewrite real_minus.
        unfold along, minus in *; cbn [fst snd] in *. lra.
Qed.
End Cells.
End Here.
