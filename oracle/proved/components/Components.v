(** Components of the sum: classes of covered cells that share pieces of edges are the components of
    its interior. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Numbers Values
  Checker Corners Cancellation Bodies Scaling Trees Theorems.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** ** Convex cells *)
Definition strict (l : list corner) (x : point) : Prop :=
  forall a b, In (a, b) (ring_edges l) -> 0 < orient (real a) (real b) x.

Lemma strict_left l x : strict l x -> left_of l x.
Proof. intros H a b I. specialize (H a b I). lra. Qed.
Lemma polygon_inside l x : is_polygon l = true -> inside l x = left_of l x.
Proof. destruct l as [|a [|b [|c r]]]; try discriminate. reflexivity. Qed.
Lemma convex_polygon l : is_convex l = true -> is_polygon l = true.
Proof. unfold is_convex. rewrite !andb_true_iff. tauto. Qed.
Lemma convex_corner l v : is_convex l = true -> In v l -> left_of l (real v).
Proof.
  unfold is_convex. rewrite !andb_true_iff, forallb_forall. intros [_ H] I.
  apply is_left_real, H, I.
Qed.
Lemma convex_union_left l x : is_convex l = true -> union_of (triangles l) x -> left_of l x.
Proof.
  intros O (a & b & c & I & K). pose proof (convex_polygon _ O) as P.
  pose proof (polygon_positive l P _ _ _ I) as D.
  apply triangle_corners in I. destruct I as (u & v & z & Iu & Iv & Iz & -> & -> & ->).
  destruct (triangle_combination _ _ _ x D K) as (i & j & k & Hi & Hj & Hk & S & -> & _).
  rewrite <- polygon_inside by auto.
  apply inside_combination; auto; rewrite polygon_inside by auto; apply convex_corner; auto.
Qed.
Lemma convex_has_inside l : is_convex l = true -> exists m, strict l m.
Proof.
  intros O. pose proof (convex_polygon _ O) as P. destruct l as [|a [|b [|c r]]]; try discriminate.
  assert (D : 0 < orient (real a) (real b) (real c)).
  { apply (polygon_positive _ P). unfold triangles. simpl. auto. }
  exists (middle (real a) (real b) (real c)). intros u v I.
  assert (Ha := convex_corner _ a O (or_introl eq_refl) u v I).
  assert (Hb := convex_corner _ b O (or_intror (or_introl eq_refl)) u v I).
  assert (Hc := convex_corner _ c O (or_intror (or_intror (or_introl eq_refl))) u v I).
  assert (N : real u <> real v).
  { unfold is_convex in O. rewrite !andb_true_iff in O. destruct O as [[_ O] _].
    apply (no_null_different _ O). apply in_map_iff. exists (u, v). split; auto. }
  revert Ha Hb Hc D N. generalize (real u), (real v), (real a), (real b), (real c).
  clear. intros p q a b c Ha Hb Hc D N.
  set (Oa := orient p q a) in *. set (Ob := orient p q b) in *. set (Oc := orient p q c) in *.
  assert (E : orient p q (middle a b c) = (Oa + Ob + Oc) / 3)
    by (unfold Oa, Ob, Oc, orient, middle; simpl; field).
  assert (E1 : (fst q - fst p) * orient a b c
      = (fst b - fst a) * (Oc - Oa) - (fst c - fst a) * (Ob - Oa))
    by (unfold Oa, Ob, Oc, orient; ring).
  assert (E2 : (snd q - snd p) * orient a b c
      = (snd b - snd a) * (Oc - Oa) - (snd c - snd a) * (Ob - Oa))
    by (unfold Oa, Ob, Oc, orient; ring).
  destruct (Rlt_dec 0 (Oa + Ob + Oc)) as [L|L]; [lra|]. exfalso.
  assert (Z1 : Oa = 0) by lra. assert (Z2 : Ob = 0) by lra. assert (Z3 : Oc = 0) by lra.
  rewrite Z1, Z2, Z3 in E1, E2.
  apply N. destruct p as [p1 p2], q as [q1 q2]. simpl in *.
  assert (F1 : (q1 - p1) * orient a b c = 0) by (rewrite E1; ring).
  assert (F2 : (q2 - p2) * orient a b c = 0) by (rewrite E2; ring).
  apply Rmult_integral in F1. apply Rmult_integral in F2. f_equal; lra.
Qed.

Lemma left_is_open l x : strict l x -> exists e, 0 < e /\ forall y, near e x y -> left_of l y.
Proof.
  unfold strict, left_of. intros H. induction (ring_edges l) as [|[a b] E IH].
  - exists 1. split; [lra|]. intros y _ a b [].
  - destruct IH as (e & He & K); [intros; apply H; simpl; auto|].
    destruct (near_left (real a) (real b) x) as (f & Hf & L); [apply H; simpl; auto|].
    exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros y Y u v [I|I].
    + injection I; intros; subst. apply near_min in Y. specialize (L y (proj2 Y)). lra.
    + apply (K y); auto. apply near_min in Y. tauto.
Qed.
Lemma orient_on_segment a b x m t :
  orient a b (fst x + t * (fst m - fst x), snd x + t * (snd m - snd x))
    = (1 - t) * orient a b x + t * orient a b m.
Proof. unfold orient; simpl; ring. Qed.
Lemma strict_on_segment l x m t : left_of l x -> strict l m -> 0 < t <= 1 ->
  strict l (fst x + t * (fst m - fst x), snd x + t * (snd m - snd x)).
Proof.
  intros Hx Hm T a b I. rewrite orient_on_segment. specialize (Hx a b I). specialize (Hm a b I).
    nra.
Qed.
Lemma left_on_segment l a b x : left_of l a -> left_of l b -> on_segment a b x -> left_of l x.
Proof.
  intros Ha Hb (t & T & ->) u v I. rewrite orient_on_segment.
  specialize (Ha u v I). specialize (Hb u v I). nra.
Qed.

(** ** A box is counted once. *)
Lemma rectangle_once l : is_rectangle l = true -> forall y, (turns (ring_edges l) y <= 1)%Z.
Proof.
  destruct l as [|a [|b [|c [|d [|? ?]]]]]; try discriminate. unfold is_rectangle.
  rewrite !andb_true_iff. intros [[[[[_ _] L] B] W] _] y.
  apply equal_value in L. apply equal_value in B. apply lt_value in W.
  unfold turns. simpl. unfold real_edge. cbn [fst snd].
  rewrite (crossing_vertical (real b) (real c)) by exact B.
  rewrite (crossing_vertical (real d) (real a)) by (symmetry; exact L).
  assert (S : forall p q, (crossing p q y <= 1)%Z)
    by (intros; unfold crossing; split_decisions; lia).
  assert (T : (crossing (real a) (real b) y <= 0)%Z).
  { unfold crossing, real; cbn [fst snd]. split_decisions; try lia. exfalso. lra. }
  specialize (S (real c) (real d)). lia.
Qed.

(** ** Two families that are counted once at most do not overlap. *)
Lemma near_self e x : 0 < e -> near e x x.
Proof. intros H. split; rewrite Rminus_diag_eq, Rabs_R0; auto. Qed.
Lemma near_near e x y z : near (e / 2) x y -> near (e / 2) y z -> near e x z.
Proof.
  intros [A B] [C D]. split.
  - replace (fst z - fst x) with ((fst y - fst x) + (fst z - fst y)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
  - replace (snd z - snd x) with ((snd y - snd x) + (snd z - snd y)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
Qed.
Lemma open_triangle_open a b c x : open_triangle a b c x ->
  exists e, 0 < e /\ forall y, near e x y -> open_triangle a b c y.
Proof.
  intros (H1 & H2 & H3).
  destruct (near_left _ _ _ H1) as (e1 & P1 & K1). destruct (near_left _ _ _ H2) as (e2 & P2 & K2).
  destruct (near_left _ _ _ H3) as (e3 & P3 & K3). exists (Rmin e1 (Rmin e2 e3)).
  split; [repeat apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y. destruct Y as [Y1 Y].
  apply near_min in Y. destruct Y as [Y2 Y3]. unfold open_triangle. auto.
Qed.
Lemma no_overlap A B : positive A -> positive B ->
  (forall y, (sumz (crossing_of y) A + sumz (crossing_of y) B <= 1)%Z) ->
  forall a b c y, In (a, b, c) A -> open_triangle a b c y -> union_of B y -> False.
Proof.
  intros OA OB H a b c y Ia Ka (u & v & w & Ib & Kb).
  destruct (open_triangle_open a b c y Ka) as (e & He & N).
  destruct (soon_exists _ (soon_and _ _ (curve_near e y (minus (middle u v w) y) He)
    (curve_inside u v w y (OB _ _ _ Ib) Kb))) as (t & _ & K1 & K2).
  pose proof (union_counted A _ a b c OA Ia (N _ K1)).
  pose proof (union_counted B _ u v w OB Ib K2).
  specialize (H (curve y (minus (middle u v w) y) t)). lia.
Qed.

(** ** Paths *)
Lemma joined_step (S : point -> Prop) x y : (forall p, on_segment x y p -> S p) -> joined S x y.
Proof. intros H. eapply farther; [apply here|exact H]. Qed.
Lemma joined_join (S : point -> Prop) x y z : joined S x y -> joined S y z -> joined S x z.
Proof. intros H K. induction K; auto. eapply farther; eauto. Qed.
Lemma joined_back (S : point -> Prop) x y : joined S x y -> joined S y x.
Proof.
  induction 1; [apply here|]. eapply joined_join; [|exact IHjoined]. apply joined_step.
  intros p I. apply H0, segment_swap, I.
Qed.
End Here.
