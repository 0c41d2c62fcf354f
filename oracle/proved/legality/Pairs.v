(** Pairs of edges: whether they overlap, and whether they have a point in common beyond their
    starts. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Legality Local Across Overlaps Paths Decomposed Gaps
  Unique Rounds.
From Proved Require Import Points Member Pieces Along Cuts.
From Proved Require Import Validity.
Open Scope R_scope.

Lemma each_pair_right {A} (test : A -> A -> bool) (R : A -> A -> Prop) l :
  (forall x y, In x l -> In y l -> test x y = true <-> R x y) ->
  each_pair test l = true <-> ForallOrdPairs R l.
Proof.
  induction l as [|x l IH]; intros H; simpl; [split; auto; constructor|].
  rewrite andb_true_iff, IH by (intros; apply H; simpl; auto). rewrite forallb_forall. split.
  - intros [F P]. constructor; auto. apply Forall_forall. intros y Y.
    apply H; simpl; auto.
  - intros P. inversion P as [|? ? F Q]; subst. rewrite Forall_forall in F. split; auto.
    intros y Y. apply H; simpl; auto.
Qed.
Lemma pairs_map {A B} (f : A -> B) (R : B -> B -> Prop) l :
  ForallOrdPairs R (map f l) <-> ForallOrdPairs (fun x y => R (f x) (f y)) l.
Proof.
  induction l as [|x l IH]; simpl; [split; constructor|].
  split; intros P; inversion P as [|? ? F Q]; subst; constructor; try apply IH; auto;
    rewrite Forall_forall in *.
  - intros y Y. apply F, in_map, Y.
  - intros y Y. apply in_map_iff in Y. destruct Y as (z & <- & Z). auto.
Qed.
Lemma pairs_app {A} (R : A -> A -> Prop) l r : ForallOrdPairs R (l ++ r) ->
  ForallOrdPairs R l /\ ForallOrdPairs R r.
Proof.
  induction l as [|x l IH]; simpl; intros P; [split; auto; constructor|].
  inversion P as [|? ? F Q]; subst. destruct (IH Q) as [L K]. split; auto. constructor; auto.
  rewrite Forall_forall in *. auto with datatypes.
Qed.

(** ** Two edges with more than a point in common *)
Definition one_common (e f : edge) : Prop := forall x y, lies_on e x -> lies_on e y ->
  lies_on f x -> lies_on f y -> x = y.
(** A segment on the line of another, by places along it *)
Lemma along_line e f : forward e -> forward f -> orient (start e) (finish e) (start f) = 0 ->
  orient (start e) (finish e) (finish f) = 0 -> exists c d, c < d /\
  start f = at_ (start e) (finish e) c /\ finish f = at_ (start e) (finish e) d /\
  (forall s, lies_on f (at_ (start e) (finish e) s) <-> c <= s <= d) /\
  (forall s, lies_on e (at_ (start e) (finish e) s) <-> 0 <= s <= 1) /\
  (before (start e) (finish f) <-> 0 < d) /\ (before (start f) (finish e) <-> c < 1).
Proof.
  intros Fe Ff Oc Od. pose proof (before_different _ _ Fe) as N. fold (start e) (finish e) in N.
  unfold forward in Fe, Ff. fold (start e) (finish e) in Fe. fold (start f) (finish f) in Ff.
  destruct (on_line _ _ _ N Oc) as (c & C). destruct (on_line _ _ _ N Od) as (d & D).
  pose proof (before_at (start e) (finish e) 0 d Fe) as P.
  pose proof (before_at (start e) (finish e) c 1 Fe) as Q. rewrite at_0 in P. rewrite at_1 in Q.
  unfold lies_on. fold (start f) (finish f) (start e) (finish e).
  rewrite C, D in Ff |- *. apply before_at in Ff; auto. exists c, d.
  split; [exact Ff|split; [reflexivity|split; [reflexivity|split; [|split; [|split]]]]]; auto.
  - intros s. split; [|apply part_on]. intros O. apply part_range in O; [|lra].
    destruct O as (w & W & E). apply at_same in E; auto. lra.
  - intros s. split; [|apply at_on]. intros (w & W & E).
    change (at_ (start e) (finish e) s = at_ (start e) (finish e) w) in E.
    apply at_same in E; auto. lra.
Qed.
Lemma parallel_lines e f x : lies_on e x -> lies_on f x -> slant e f = 0 ->
  orient (start e) (finish e) (start f) = 0 /\ orient (start e) (finish e) (finish f) = 0.
Proof.
  intros Ex Fx Z.
  split; apply (one_line e f x Ex Fx Z); [apply on_segment_start|apply on_segment_end].
Qed.
Lemma overlap_real e f : overlap e f = true <-> before (start e) (finish f) /\
  before (start f) (finish e) /\ orient (start e) (finish e) (start f) = 0 /\
  orient (start e) (finish e) (finish f) = 0.
Proof. unfold overlap. rewrite !andb_true_iff, !side_zero, !is_before_real. tauto. Qed.
Lemma overlap_right e f : forward e -> forward f -> overlap e f = false <-> one_common e f.
Proof.
  intros Fe Ff. rewrite <- not_true_iff_false, overlap_real. split.
  - intros H x y Ex Ey Fx Fy. apply NNPP. intros D. apply H.
    destruct (parallel_lines e f x Ex Fx (two_shared e f x y Ex Fx Ey Fy D)) as (Oc & Od).
    destruct (along_line e f Fe Ff Oc Od) as (c & d & L & _ & _ & Of & Oe & -> & ->).
    destruct (on_at e x Ex) as (s & S & ->), (on_at e y Ey) as (t & T & ->).
    apply Of in Fx, Fy. assert (s <> t) by (intros ->; auto). repeat split; auto; lra.
  - intros H (A & B & Oc & Od).
    destruct (along_line e f Fe Ff Oc Od) as (c & d & L & _ & _ & Of & Oe & A' & B').
    apply A' in A. apply B' in B. set (s := Rmax 0 c). set (t := Rmin 1 d).
    assert (St : s < t /\ 0 <= s /\ c <= s /\ t <= 1 /\ t <= d).
    { unfold s, t, Rmax, Rmin. destruct (Rle_dec 0 c), (Rle_dec 1 d); lra. }
    assert (G : at_ (start e) (finish e) s = at_ (start e) (finish e) t).
    { apply H; try apply Oe; try apply Of; lra. }
    apply at_same in G; [lra|]. exact (before_different _ _ Fe).
Qed.

(** ** Two edges, each without its start *)
Lemma one_common_lefts e f : one_common (from_left e) (from_left f) <-> one_common e f.
Proof.
  unfold one_common. split; intros H x y; specialize (H x y); rewrite !from_left_on in *; auto.
Qed.
(** Two segments with one common point: the program finds it. *)
Lemma meet_found e f x : forward e -> forward f -> one_common e f -> lies_on e x -> lies_on f x ->
  exists p, In p (meet e f) /\ R2 p = x.
Proof.
  intros Fe Ff One Ex Fx. destruct (Req_dec (slant e f) 0) as [Z|Z].
  2: { exact (meet_has _ _ Fe Ff x Ex Fx Z). }
  apply overlap_right in One; auto. apply not_true_iff_false in One. rewrite overlap_real in One.
  destruct (parallel_lines e f x Ex Fx Z) as (Oc & Od).
  destruct (along_line e f Fe Ff Oc Od) as (c & d & L & C & D & Of & Oe & A & B).
  destruct (on_at e x Ex) as (s & S & Xs). subst x. apply Of in Fx.
  assert (K : s = c \/ s = d).
  { destruct (Rlt_dec 0 d); [|right; lra]. destruct (Rlt_dec c 1); [|left; lra].
    destruct One. repeat split; auto; [apply A|apply B]; auto. }
  destruct K as [-> | ->]; rewrite <- ?C, <- ?D in *; eexists; (split; [|reflexivity]);
    apply meet_ends; auto.
Qed.
Lemma part_ways_right e f : null e = false -> null f = false -> one_common e f ->
  part_ways e f = true <->
  forall x, beyond_start (R2e e) x -> beyond_start (R2e f) x -> False.
Proof.
  intros Ne Nf One. unfold part_ways. rewrite forallb_forall.
  pose proof (from_left_forward e Ne) as Fe. pose proof (from_left_forward f Nf) as Ff.
  assert (Fold : forall p, same p (fst e) || same p (fst f) = true <->
    R2 p = start e \/ R2 p = start f).
  { intros p. rewrite orb_true_iff, !same_real. reflexivity. }
  split.
  - intros H x [Ex Xe] [Fx Xf].
    destruct (meet_found (from_left e) (from_left f) x) as (p & Ip & <-); auto.
    + apply one_common_lefts, One.
    + apply from_left_on. exact Ex.
    + apply from_left_on. exact Fx.
    + apply H, Fold in Ip. destruct Ip; auto.
  - intros H p Ip. apply meet_from in Ip; auto. destruct Ip as (Ep & Fp & _).
    apply Fold. apply NNPP. intros K. rewrite from_left_on in Ep, Fp. apply (H (R2 p)); split; auto.
Qed.
