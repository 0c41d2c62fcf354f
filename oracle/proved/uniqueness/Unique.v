(** One canonical form: the first steps. Components are determined by the set; so is where its
  edges run. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Bodies
  Overlaps Components.
From Proved Require Import OneForm Paths Decomposed Gaps.
Open Scope R_scope.

(** ** Components *)
Lemma same_components U C n D m : falls_into U C n -> falls_into U D m ->
  forall i, (i < n)%nat -> exists j, (j < m)%nat /\ forall x, C i x -> D j x.
Proof.
  intros (CU & CC) (DU & DD) i I. destruct (CC i I) as ((x0 & X0) & Op & Jo & Dis).
  assert (U0 : U x0) by (apply CU; exists i; auto).
  apply DU in U0. destruct U0 as (j & J & D0). exists j. split; auto. intros x X.
  apply (all_joined (C i) (D j) x0 x); auto. intros p P.
  assert (Up : U p) by (apply CU; exists i; auto). apply DU in Up. destruct Up as (k & K & Dk).
  destruct (DD k K) as (_ & OpK & _ & DisK). destruct (OpK p Dk) as (e & He & N).
  exists e. split; auto. intros q Q. specialize (N q Q). split; intros Y.
  - rewrite <- (DisK j q J N Y). exact Dk.
  - rewrite <- (DisK j p J Dk Y). exact N.
Qed.
Theorem components_unique U C n D m : falls_into U C n -> falls_into U D m ->
  forall i, (i < n)%nat -> exists j, (j < m)%nat /\ forall x, C i x <-> D j x.
Proof.
  intros FC FD i I. destruct (same_components U C n D m FC FD i I) as (j & J & H).
  destruct (same_components U D m C n FD FC j J) as (k & K & G).
  exists j. split; auto. intros x. split; auto. intros X.
  destruct FC as (_ & CC). destruct (CC i I) as ((x0 & X0) & _ & _ & Dis).
  replace i with k; auto. symmetry. apply (Dis k x0 K X0), G, H, X0.
Qed.

(** ** Where edges run *)
Lemma range_near u v w : ~ (u <= w <= v \/ v <= w <= u) -> exists e, 0 < e /\
  forall z, Rabs (z - w) < e -> ~ (u <= z <= v \/ v <= z <= u).
Proof.
  intros N. set (lo := Rmin u v). set (hi := Rmax u v).
  assert (R : forall z, (u <= z <= v \/ v <= z <= u) <-> lo <= z <= hi).
  { intros z. unfold lo, hi, Rmin, Rmax. destruct (Rle_dec u v); split; lra. }
  rewrite R in N. destruct (Rlt_dec w lo).
  - exists (lo - w). split; [lra|]. intros z Z. apply Rabs_def2 in Z. rewrite R. lra.
  - exists (w - hi). assert (hi < w) by (apply Rnot_le_lt; intros L; apply N; lra).
    split; [lra|]. intros z Z. apply Rabs_def2 in Z. rewrite R. lra.
Qed.
Lemma segment_range a b y : on_segment a b y -> orient a b y = 0 /\
  (fst a <= fst y <= fst b \/ fst b <= fst y <= fst a) /\
  (snd a <= snd y <= snd b \/ snd b <= snd y <= snd a).
Proof.
  intros (t & T & ->). cbn [fst snd]. split; [unfold orient; simpl; ring|]. split.
  - destruct (Rle_dec (fst a) (fst b)); [left|right]; nra.
  - destruct (Rle_dec (snd a) (snd b)); [left|right]; nra.
Qed.
Lemma segment_near a b x : ~ on_segment a b x -> exists e, 0 < e /\ forall y, near e x y -> ~
  on_segment a b y.
Proof.
  intros N. destruct (Rtotal_order (orient a b x) 0) as [O|[O|O]].
  - destruct (near_right a b x O) as (e & He & K). exists e. split; auto. intros y Y S.
    apply segment_range in S. specialize (K y Y). lra.
  - destruct (classic (fst a <= fst x <= fst b \/ fst b <= fst x <= fst a)) as [X|X].
    + destruct (classic (snd a <= snd x <= snd b \/ snd b <= snd x <= snd a)) as [Y|Y].
      * destruct N. apply segment_by_orient; auto.
      * destruct (range_near _ _ _ Y) as (e & He & K). exists e. split; auto. intros y [_ Z] S.
        apply segment_range in S. apply (K (snd y) Z). tauto.
    + destruct (range_near _ _ _ X) as (e & He & K). exists e. split; auto. intros y [Z _] S.
      apply segment_range in S. apply (K (fst y) Z). tauto.
  - destruct (near_left a b x O) as (e & He & K). exists e. split; auto. intros y Y S.
    apply segment_range in S. specialize (K y Y). lra.
Qed.
Lemma edges_near (E : edges_t) x : ~ on_some E x -> exists e, 0 < e /\ forall y, near e x y -> ~
  on_some E y.
Proof.
  induction E as [|[a b] E IH]; intros N; [exists 1; split; [lra|]; intros y _ (a & b & [] & _)|].
  destruct IH as (e & He & K). { intros (c & d & I & O). apply N. exists c, d. simpl. auto. }
  destruct (segment_near a b x) as (f & Hf & L). { intros O. apply N. exists a, b. simpl. auto. }
  exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
  destruct Y as [Y1 Y2]. intros (c & d & [Q|I] & O).
  - injection Q; intros; subst. apply (L y Y2 O).
  - apply (K y Y1). exists c, d. auto.
Qed.
Lemma near_segment e x y p : near e x y -> on_segment x y p -> near e x p.
Proof.
  intros [A B] (t & T & ->). unfold near; cbn [fst snd]. pose proof (Rabs_pos (fst y - fst x)).
  pose proof (Rabs_pos (snd y - snd x)). split.
  - replace (fst x + t * (fst y - fst x) - fst x) with (t * (fst y - fst x)) by ring.
    rewrite Rabs_mult, (Rabs_right t) by lra. nra.
  - replace (snd x + t * (snd y - snd x) - snd x) with (t * (snd y - snd x)) by ring.
    rewrite Rabs_mult, (Rabs_right t) by lra. nra.
Qed.

(** Off the edges of a form, a closed set is locally all or nothing. *)
Theorem off_edges S E x : is_closed S ->
  (forall y, S y -> ~ on_some E y -> interior S y) -> ~ on_some E x ->
  exists r, 0 < r /\ forall y, near r x y -> (S y <-> S x).
Proof.
  intros Cl In2 N. destruct (edges_near E x N) as (r & Hr & K). exists r. split; auto.
  assert (L : forall p, near r x p -> exists e, 0 < e /\ forall q, near e p q -> (S q <-> S p)).
  { intros p P. destruct (classic (S p)) as [Sp|Sp].
    - destruct (In2 p Sp (K p P)) as (e & He & A). exists e. split; auto. intros q Q. split; auto.
    - apply NNPP. intros B. apply Sp, Cl. intros e He. apply NNPP. intros C. apply B.
      exists e. split; auto. intros q Q. split; [|intros; contradiction]. intros Sq. exfalso. apply
        C. eauto. }
  intros y Y. split; intros H.
  - apply (all_along S y x); auto. intros p P. apply L.
    apply segment_swap in P. exact (near_segment r x y p Y P).
  - apply (all_along S x y); auto. intros p P. apply L. exact (near_segment r x y p Y P).
Qed.
(** So where an edge of one form divides the set, an edge of any other form runs. *)
Theorem edge_under_edge S E x (C : point -> Prop) a b : is_closed S ->
  (forall y, S y -> ~ on_some E y -> interior S y) -> (forall y, C y -> S y) -> a <> b -> orient a
    b x = 0 ->
  (exists r, 0 < r /\ forall y, near r x y ->
    (0 < orient a b y -> C y) /\ (orient a b y < 0 -> ~ S y)) -> on_some E x.
Proof.
  intros Cl In2 CS Ne O (r & Hr & K). apply NNPP. intros N.
  destruct (off_edges S E x Cl In2 N) as (f & Hf & L).
  destruct (left_close a b x (Rmin r f)) as (y & Y & Oy); auto; [apply Rmin_glb_lt; auto|].
  destruct (right_close a b x (Rmin r f)) as (z & Z & Oz); auto; [apply Rmin_glb_lt; auto|].
  apply near_min in Y. apply near_min in Z. destruct Y as [Y1 Y2], Z as [Z1 Z2].
  destruct (K y Y1) as [A _]. destruct (K z Z1) as [_ B].
  apply (B Oz), L; auto. apply (L y Y2), CS, A, Oy.
Qed.
