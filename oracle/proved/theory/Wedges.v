(** Sets near a point: ways that lead inside. A sum has a point inside where opposite ways do. *)
From Coq Require Import Lra Psatz.
From Proved Require Import Definitions Paper.
Open Scope R_scope.

(** The segment from p along v is inside the set, as far as it is short. *)
Definition inner_way (S : point -> Prop) (p v : point) : Prop :=
  exists e, 0 < e /\ forall t, 0 < t < e -> interior S (add p (scale t v)).
Definition opposite (v : point) : point := scale (-1) v.

Lemma cross_opposite u v : cross u (opposite v) = - cross u v.
Proof. unfold cross, opposite, scale; cbn [fst snd]. ring. Qed.
Lemma cross_swap u v : cross u v = - cross v u.
Proof. unfold cross. ring. Qed.
Lemma cross_add u v w : cross u (add v w) = cross u v + cross u w.
Proof. unfold cross, add; cbn [fst snd]. ring. Qed.
Lemma cross_scale u k v : cross u (scale k v) = k * cross u v.
Proof. unfold cross, scale; cbn [fst snd]. ring. Qed.
Lemma cross_self u : cross u u = 0.
Proof. unfold cross. ring. Qed.
Lemma cross_scaled k u v : cross (scale k u) v = k * cross u v.
Proof. unfold cross, scale; cbn [fst snd]. ring. Qed.

Lemma near_trans x e f y z : near e x y -> near f y z -> near (e + f) x z.
Proof.
  intros [A B] [C D]. split.
  - replace (fst z - fst x) with ((fst y - fst x) + (fst z - fst y)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
  - replace (snd z - snd x) with ((snd y - snd x) + (snd z - snd y)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
Qed.
Lemma near_step p v r : 0 < r -> exists e, 0 < e /\ forall t, 0 < t < e ->
  near r p (add p (scale t v)).
Proof.
  intros R. set (m := 1 + Rabs (fst v) + Rabs (snd v)).
  pose proof (Rabs_pos (fst v)) as A. pose proof (Rabs_pos (snd v)) as B.
  assert (M : 0 < m) by (unfold m; lra).
  exists (r / m). split; [apply Rdiv_lt_0_compat; auto|]. intros t T.
  assert (K : t * m < r).
  { apply Rmult_lt_reg_r with (/ m); [apply Rinv_0_lt_compat; auto|].
    rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in T. lra. }
  unfold near, add, scale; cbn [fst snd]. split.
  - replace (fst p + t * fst v - fst p) with (t * fst v) by ring.
    rewrite Rabs_mult, (Rabs_right t) by lra. unfold m in K. nra.
  - replace (snd p + t * snd v - snd p) with (t * snd v) by ring.
    rewrite Rabs_mult, (Rabs_right t) by lra. unfold m in K. nra.
Qed.
(** The side of a line on which a point lies keeps close to the point. *)
Lemma side_near d x p : 0 < cross d (diff x p) -> exists r, 0 < r /\
  forall y, near r x y -> 0 < cross d (diff y p).
Proof.
  intros C. set (m := 1 + Rabs (fst d) + Rabs (snd d)).
  pose proof (Rabs_pos (fst d)) as A. pose proof (Rabs_pos (snd d)) as B.
  assert (M : 0 < m) by (unfold m; lra). set (g := cross d (diff x p)) in *.
  exists (g / m). split; [apply Rdiv_lt_0_compat; auto|]. intros y [N1 N2].
  assert (E : cross d (diff y p) = g + (fst d * (snd y - snd x) - snd d * (fst y - fst x)))
    by (unfold g, cross, diff; cbn [fst snd]; ring).
  rewrite E. set (e1 := fst y - fst x) in *. set (e2 := snd y - snd x) in *.
  assert (B1 : Rabs (fst d * e2 - snd d * e1) <= Rabs (fst d) * Rabs e2 + Rabs (snd d) * Rabs e1).
  { unfold Rminus. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp, !Rabs_mult. lra. }
  assert (X : (Rabs (fst d) + Rabs (snd d)) * (g / m) < g).
  { assert (D : 0 < g / m) by (apply Rdiv_lt_0_compat; auto).
    replace g with (m * (g / m)) at 2 by (field; lra). unfold m at 2. nra. }
  pose proof (Rabs_pos e1). pose proof (Rabs_pos e2).
  assert (Y : Rabs (fst d * e2 - snd d * e1) < g) by nra.
  apply Rabs_def2 in Y. lra.
Qed.
Lemma both_near (H K : point -> Prop) x : (exists r, 0 < r /\ forall y, near r x y -> H y) ->
  (exists r, 0 < r /\ forall y, near r x y -> K y) ->
  exists r, 0 < r /\ forall y, near r x y -> H y /\ K y.
Proof.
  intros (r & R & A) (s & S & B). exists (Rmin r s). split; [apply Rmin_glb_lt; auto|].
  intros y [N1 N2]. pose proof (Rmin_l r s). pose proof (Rmin_r r s).
  split; [apply A|apply B]; split; lra.
Qed.
Lemma wedge_near i o x p : wedge i o (diff x p) -> exists r, 0 < r /\
  forall y, near r x y -> wedge i o (diff y p).
Proof.
  intros [(C & A & B)|(C & [A|B])].
  - destruct (both_near _ _ x (side_near i x p A) (side_near o x p B)) as (r & R & H).
    exists r. split; auto. intros y Y. left. destruct (H y Y). auto.
  - destruct (side_near i x p A) as (r & R & H). exists r. split; auto.
    intros y Y. right. auto.
  - destruct (side_near o x p B) as (r & R & H). exists r. split; auto.
    intros y Y. right. auto.
Qed.
Lemma wedge_scale i o t v : 0 < t -> wedge i o v -> wedge i o (scale t v).
Proof.
  intros T. unfold wedge. rewrite !cross_scale. intros [(C & A & B)|(C & [A|B])].
  - left. repeat split; auto; apply Rmult_lt_0_compat; auto.
  - right. split; auto. left. apply Rmult_lt_0_compat; auto.
  - right. split; auto. right. apply Rmult_lt_0_compat; auto.
Qed.
Lemma diff_add p v : diff (add p v) p = v.
Proof. unfold diff, add; destruct v; cbn [fst snd]; f_equal; ring. Qed.

(** What holds of an open cone that the set has near p *)
Lemma cone_way (S H : point -> Prop) p v :
  (exists r, 0 < r /\ forall y, near r p y -> H (diff y p) -> S y) ->
  (forall t, 0 < t -> H (scale t v)) ->
  (forall x, H (diff x p) -> exists r, 0 < r /\ forall y, near r x y -> H (diff y p)) ->
  inner_way S p v.
Proof.
  intros (r & R & Hs) Hv Open. destruct (near_step p v (r / 2)) as (e & E & N); [lra|].
  exists e. split; auto. intros t T. set (x := add p (scale t v)).
  destruct (Open x) as (g & G & K).
  { unfold x. rewrite diff_add. apply Hv. lra. }
  exists (Rmin g (r / 2)). split; [apply Rmin_glb_lt; lra|]. intros y [N1 N2].
  pose proof (Rmin_l g (r / 2)). pose proof (Rmin_r g (r / 2)).
  apply Hs; [|apply K; split; lra]. specialize (N t T). fold x in N.
  replace r with (r / 2 + r / 2) by lra. apply near_trans with x; auto. split; lra.
Qed.
Lemma corner_way S p i o v : corner S p i o -> wedge i o v -> inner_way S p v.
Proof.
  intros (_ & Hs) W. apply (cone_way S (wedge i o) p v Hs).
  - intros t T. apply wedge_scale; auto.
  - intros x. apply wedge_near.
Qed.
Lemma left_way S p d v : has_left S p d -> 0 < cross d v -> inner_way S p v.
Proof.
  intros Hs W. apply (cone_way S (fun u => 0 < cross d u) p v Hs).
  - intros t T. rewrite cross_scale. apply Rmult_lt_0_compat; auto.
  - intros x. apply side_near.
Qed.
Lemma interior_is_in S x : interior S x -> S x.
Proof.
  intros (e & E & H). apply H. unfold near. rewrite !Rminus_diag_eq, Rabs_R0 by auto. auto.
Qed.

Theorem opposite_ways S T p q v : inner_way S p v -> inner_way T q (opposite v) ->
  interior (sum_of S T) (add p q).
Proof.
  intros (e & E & Hs) (f & F & Ht). set (t := Rmin e f / 2).
  pose proof (Rmin_l e f). pose proof (Rmin_r e f).
  assert (M : 0 < Rmin e f) by (apply Rmin_glb_lt; auto).
  destruct (Hs t) as (r & R & Hr); [unfold t; lra|].
  assert (Qt : T (add q (scale t (opposite v)))).
  { apply interior_is_in, Ht. unfold t; lra. }
  exists r. split; auto. intros y [N1 N2].
  exists (diff y (add q (scale t (opposite v)))), (add q (scale t (opposite v))).
  split; [|split; auto].
  - apply Hr. unfold opposite, near, diff, add, scale in *; cbn [fst snd] in *. split.
    + replace (fst y - (fst q + t * (-1 * fst v)) - (fst p + t * fst v))
        with (fst y - (fst p + fst q)) by ring. auto.
    + replace (snd y - (snd q + t * (-1 * snd v)) - (snd p + t * snd v))
        with (snd y - (snd p + snd q)) by ring. auto.
  - unfold diff, add; destruct y; cbn [fst snd]. f_equal; ring.
Qed.
Lemma interior_sum_left (S T : point -> Prop) p q : interior S p -> T q ->
  interior (sum_of S T) (add p q).
Proof.
  intros (e & E & H) Q. exists e. split; auto. intros y [N1 N2]. exists (diff y q), q.
  split; [|split; auto].
  - apply H. unfold near, diff, add in *; cbn [fst snd] in *. split.
    + replace (fst y - fst q - fst p) with (fst y - (fst p + fst q)) by ring. auto.
    + replace (snd y - snd q - snd p) with (snd y - (snd p + snd q)) by ring. auto.
  - unfold diff, add; destruct y; cbn [fst snd]. f_equal; ring.
Qed.
Lemma interior_sum_right (S T : point -> Prop) p q : S p -> interior T q ->
  interior (sum_of S T) (add p q).
Proof.
  intros P (e & E & H). exists e. split; auto. intros y [N1 N2]. exists p, (diff y p).
  split; [auto|split].
  - apply H. unfold near, diff, add in *; cbn [fst snd] in *. split.
    + replace (fst y - fst p - fst q) with (fst y - (fst p + fst q)) by ring. auto.
    + replace (snd y - snd p - snd q) with (snd y - (snd p + snd q)) by ring. auto.
  - unfold diff, add; destruct y; cbn [fst snd]. f_equal; ring.
Qed.

(** ** Directions: which wedges have opposite ways *)
Lemma small x y : 0 < x -> exists k, 0 < k /\ 0 < x + k * y.
Proof.
  intros X. exists (x / (2 * (1 + Rabs y))). pose proof (Rabs_pos y) as A.
  assert (D : 0 < 2 * (1 + Rabs y)) by lra. split; [apply Rdiv_lt_0_compat; auto|].
  set (k := x / (2 * (1 + Rabs y))). assert (K : k * (2 * (1 + Rabs y)) = x)
    by (unfold k; field; lra).
  assert (P : 0 < k) by (apply Rdiv_lt_0_compat; auto).
  pose proof (Rcase_abs y) as [Y|Y]; [rewrite (Rabs_left y Y) in *|rewrite (Rabs_right y Y) in *];
    nra.
Qed.
(** A line that is not along d has ways on its left that are on the right of d. *)
Lemma crossing_way u d : cross u d <> 0 -> exists v, 0 < cross u v /\ cross d v < 0.
Proof.
  intros N. destruct (Rtotal_order 0 (cross u d)) as [C|[C|C]]; [|congruence|].
  - exists (add u d). rewrite !cross_add, !cross_self, (cross_swap d u). lra.
  - exists (opposite (add u d)). rewrite !cross_opposite, !cross_add, !cross_self, (cross_swap d u).
    lra.
Qed.
Lemma in_turn i o d : 0 < cross i o ->
  scale (cross i o) d = add (scale (cross d o) i) (scale (cross i d) o).
Proof. intros _. unfold cross, scale, add; destruct d; cbn [fst snd]. f_equal; ring. Qed.
Lemma scale_back c d u : 0 < c -> scale c d = u -> d = scale (/ c) u.
Proof.
  intros C <-. unfold scale; destruct d; cbn [fst snd]. f_equal; field; lra.
Qed.
Lemma same_as_first i o d : 0 < cross i o -> 0 < cross d o -> cross i d = 0 -> same_way i d.
Proof.
  intros C D Z. exists (cross d o / cross i o). split; [apply Rdiv_lt_0_compat; auto|].
  pose proof (in_turn i o d C) as E. rewrite Z in E. apply scale_back in E; auto.
  eapply eq_trans; [exact E|]. unfold scale, add; cbn [fst snd]. f_equal; field; lra.
Qed.
Lemma same_as_last i o d : 0 < cross i o -> 0 < cross i d -> cross d o = 0 -> same_way o d.
Proof.
  intros C D Z. exists (cross i d / cross i o). split; [apply Rdiv_lt_0_compat; auto|].
  pose proof (in_turn i o d C) as E. rewrite Z in E. apply scale_back in E; auto.
  eapply eq_trans; [exact E|]. unfold scale, add; cbn [fst snd]. f_equal; field; lra.
Qed.
Lemma not_both_zero i o d : cross i o <> 0 -> d <> (0, 0) -> cross i d = 0 -> cross d o = 0 ->
  False.
Proof.
  unfold cross. destruct i as [i1 i2], o as [o1 o2], d as [d1 d2]; cbn [fst snd].
  intros C D A B. apply D. f_equal.
  - apply Rmult_eq_reg_r with (i1 * o2 - i2 * o1); auto.
    replace (d1 * (i1 * o2 - i2 * o1)) with (i1 * (d1 * o2 - d2 * o1) + o1 * (i1 * d2 - i2 * d1))
      by ring. rewrite A, B. ring.
  - apply Rmult_eq_reg_r with (i1 * o2 - i2 * o1); auto.
    replace (d2 * (i1 * o2 - i2 * o1)) with (i2 * (d1 * o2 - d2 * o1) + o2 * (i1 * d2 - i2 * d1))
      by ring. rewrite A, B. ring.
Qed.

(** A convex vertex and an edge: d is in the closed turn, or the wedge reaches to its right. *)
Lemma convex_or_right i o d : 0 < cross i o ->
  (0 <= cross i d /\ 0 <= cross d o) \/ exists v, wedge i o v /\ cross d v < 0.
Proof.
  intros C. destruct (Rle_dec 0 (cross i d)) as [A|A].
  - destruct (Rle_dec 0 (cross d o)) as [B|B]; auto. right.
    destruct (small (- cross d o) (cross d i)) as (k & K & L); [lra|].
    exists (add o (scale (- k) i)). unfold wedge. rewrite !cross_add, !cross_scale, !cross_self.
    rewrite (cross_swap o i). split; [left; repeat split; nra|lra].
  - right. destruct (small (- cross i d) (- cross d o)) as (k & K & L); [lra|].
    exists (add (opposite i) (scale k o)). unfold wedge.
    rewrite !cross_add, !cross_scale, !cross_opposite, !cross_self, (cross_swap o i),
      (cross_swap d i). split; [left; repeat split; nra|lra].
Qed.
(** A reflex vertex and an edge *)
Lemma reflex_right i o d : cross i o < 0 -> d <> (0, 0) -> exists v, wedge i o v /\ cross d v < 0.
Proof.
  intros C D. destruct (Req_dec (cross i d) 0) as [Z|Z].
  - assert (Y : cross o d <> 0).
    { intros Y. apply (not_both_zero i o d); auto; [lra|]. rewrite cross_swap, Y. ring. }
    destruct (crossing_way o d Y) as (v & V1 & V2). exists v. split; auto. right. auto.
  - destruct (crossing_way i d Z) as (v & V1 & V2). exists v. split; auto. right. auto.
Qed.
(** Two convex vertices *)
Lemma convex_convex i o j k : 0 < cross i o -> 0 < cross j k ->
  (0 <= cross i j /\ 0 <= cross j o) \/ (0 <= cross i k /\ 0 <= cross k o) \/
  (0 <= cross j i /\ 0 <= cross i k) \/ (0 <= cross j o /\ 0 <= cross o k) \/
  exists v, wedge i o v /\ wedge j k (opposite v).
Proof.
  intros IO JK. rewrite (cross_swap j o), (cross_swap k o), (cross_swap j i).
  set (a := cross i j). set (b := cross i k). set (c := cross o j). set (e := cross o k).
  assert (V : forall v, 0 < cross i v -> 0 < cross o v -> cross j v < 0 -> cross k v < 0 ->
    exists v, wedge i o v /\ wedge j k (opposite v)).
  { intros v V1 V2 V3 V4. exists v. unfold wedge. rewrite !cross_opposite. split; left; lra. }
  assert (Ej : cross j i = - a) by apply cross_swap.
  assert (Ek : cross k i = - b) by apply cross_swap.
  assert (Oj : cross j o = - c) by apply cross_swap.
  assert (Ok : cross k o = - e) by apply cross_swap.
  assert (OI : cross o i = - cross i o) by apply cross_swap.
  assert (KJ : cross k j = - cross j k) by apply cross_swap.
  assert (V1 : a <= 0 -> 0 <= c -> b <= 0 -> 0 <= e -> a < 0 \/ 0 < c -> b < 0 \/ 0 < e ->
    exists v, wedge i o v /\ wedge j k (opposite v)).
  { intros. apply (V (add o (opposite i))); rewrite cross_add, cross_opposite, ?cross_self,
      ?OI, ?Ej, ?Ek, ?Oj, ?Ok; lra. }
  assert (V2 : 0 <= a -> 0 < c -> 0 <= e -> exists v, wedge i o v /\ wedge j k (opposite v)).
  { intros. apply (V (add o j)); rewrite cross_add, ?cross_self, ?Oj, ?Ok, ?KJ; fold a c; lra. }
  assert (V3 : b < 0 -> e <= 0 -> a <= 0 -> exists v, wedge i o v /\ wedge j k (opposite v)).
  { intros. apply (V (opposite (add k i))); rewrite cross_opposite, cross_add, ?cross_self,
      ?OI, ?Ej, ?Ek; fold b e; lra. }
  assert (V4 : 0 <= a -> b <= 0 -> 0 <= c -> e <= 0 -> 0 < a \/ b < 0 -> 0 < c \/ e < 0 ->
    exists v, wedge i o v /\ wedge j k (opposite v)).
  { intros. apply (V (add j (opposite k))); rewrite cross_add, cross_opposite, ?cross_self, ?KJ;
      fold a b c e; lra. }
  destruct (Rlt_dec a 0), (Rlt_dec b 0), (Rlt_dec 0 c), (Rlt_dec 0 e);
    try (left; lra); try (right; left; lra); try (do 2 right; left; lra);
    try (do 3 right; left; lra); do 4 right;
    try (apply V2; lra); try (apply V3; lra); try (apply V1; lra); try (apply V4; lra).
Qed.
Lemma convex_reflex i o j k : 0 < cross i o -> cross j k < 0 ->
  ((0 <= cross i j /\ 0 <= cross j o) /\ (0 <= cross i k /\ 0 <= cross k o)) \/
  exists v, wedge i o v /\ wedge j k (opposite v).
Proof.
  intros IO JK. destruct (convex_or_right i o j IO) as [H|(v & W & R)].
  - destruct (convex_or_right i o k IO) as [K|(v & W & R)]; auto.
    right. exists v. split; auto. right. rewrite !cross_opposite. split; auto. right. lra.
  - right. exists v. split; auto. right. rewrite !cross_opposite. split; auto. left. lra.
Qed.
