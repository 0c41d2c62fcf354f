(** Pieces: segments that are cut at each other cover what they did; whoever meets a piece inside
    holds all of it. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Local Across Overlaps Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Decided Pieces Sorting Along.
Open Scope R_scope.

Definition start (e : edge) : point := R2 (fst e).
Definition finish (e : edge) : point := R2 (snd e).
Definition slant (e f : edge) : R :=
  turn_of (minus_ (finish e) (start e)) (minus_ (finish f) (start f)).
Lemma dir_real e : R2 (dir e) = minus_ (finish e) (start e).
Proof. apply sub_real. Qed.
Lemma on_at e x : lies_on e x -> exists t, 0 <= t <= 1 /\ x = at_ (start e) (finish e) t.
Proof. exact (fun H => H). Qed.

(** ** Two segments *)
Lemma where_met a b c d s u : at_ a b s = at_ c d u ->
  turn_of (minus_ c a) (minus_ d c) = s * turn_of (minus_ b a) (minus_ d c) /\
  turn_of (minus_ c a) (minus_ b a) = u * turn_of (minus_ b a) (minus_ d c).
Proof.
  destruct a as [a1 a2], b as [b1 b2], c as [c1 c2], d as [d1 d2].
  unfold at_, turn_of, minus_; cbn [fst snd]. intros E. injection E; intros E2 E1.
  assert (F1 : c1 - a1 = s * (b1 - a1) - u * (d1 - c1)) by lra.
  assert (F2 : c2 - a2 = s * (b2 - a2) - u * (d2 - c2)) by lra.
  rewrite F1, F2. split; ring.
Qed.
Lemma met_there a b c d n : n <> 0 -> n = turn_of (minus_ b a) (minus_ d c) ->
  at_ a b (turn_of (minus_ c a) (minus_ d c) / n) =
  at_ c d (turn_of (minus_ c a) (minus_ b a) / n).
Proof.
  intros N E. destruct a as [a1 a2], b as [b1 b2], c as [c1 c2], d as [d1 d2].
  unfold at_, turn_of, minus_ in *; cbn [fst snd] in *.
  apply point_eq; cbn [fst snd]; apply Rmult_eq_reg_r with n; auto; field_simplify; auto;
    rewrite E; ring.
Qed.
Section Two.
Variables e f : edge.
Hypothesis E : forward e.
Hypothesis F : forward f.

Lemma not_far x : lies_on e x -> lies_on f x -> far_apart e f = false.
Proof.
  intros A B. apply segment_range in A. apply segment_range in B.
  unfold far_apart. apply orb_false_iff.
  assert (L : forall g, forward g -> Q2R (fst (fst g)) <= Q2R (fst (snd g))).
  { intros g [H|[H _]]; unfold point_of in H; cbn [fst snd] in H; lra. }
  pose proof (L e E). pose proof (L f F). unfold point_of in A, B; cbn [fst snd] in A, B.
  split; apply not_true_iff_false; rewrite less_real; lra.
Qed.
Lemma slant_real : Q2R (Qred (qcross (dir e) (dir f))) = slant e f.
Proof. rewrite Q2R_red, qcross_real, !dir_real. reflexivity. Qed.
Lemma slant_zero : Qeq_bool (Qred (qcross (dir e) (dir f))) 0 = true <-> slant e f = 0.
Proof. rewrite equal_real, slant_real, zero_real. tauto. Qed.
Lemma met_real t : R2 (qadd (fst e) (by_scale t (dir e))) = at_ (start e) (finish e) (Q2R t).
Proof. rewrite qadd_real, by_scale_real, dir_real. reflexivity. Qed.
Lemma share_real g : slant e f <> 0 ->
  Q2R (Qred (qcross (sub (fst f) (fst e)) (dir g) / Qred (qcross (dir e) (dir f)))) =
  turn_of (minus_ (start f) (start e)) (minus_ (finish g) (start g)) / slant e f.
Proof.
  intros N. rewrite Q2R_red, Q2R_div, slant_real, qcross_real, sub_real, dir_real; auto.
  intros Z. apply N. apply Qeq_eqR in Z. rewrite slant_real, zero_real in Z. exact Z.
Qed.

Lemma meet_has x : lies_on e x -> lies_on f x -> slant e f <> 0 ->
  exists p, In p (meet e f) /\ R2 p = x.
Proof.
  intros A B N. unfold meet. rewrite (not_far x A B).
  destruct (Qeq_bool (Qred (qcross (dir e) (dir f))) 0) eqn:Z.
  { apply slant_zero in Z. contradiction. }
  destruct (on_at e x A) as (s & S & A'), (on_at f x B) as (u & U & B').
  assert (W := eq_trans (eq_sym A') B'). apply where_met in W.
  destruct W as [W1 W2].
  set (t' := Qred (qcross (sub (fst f) (fst e)) (dir f) / _)).
  set (u' := Qred (qcross (sub (fst f) (fst e)) (dir e) / _)).
  assert (T : Q2R t' = s).
  { unfold t'. rewrite share_real by auto. rewrite W1. unfold slant in *. field. exact N. }
  assert (U' : Q2R u' = u).
  { unfold u'. rewrite share_real by auto. rewrite W2. unfold slant in *. field. exact N. }
  assert (L : forall x y, Q2R y <= Q2R x -> less x y = false).
  { intros y z H. apply not_true_iff_false. rewrite less_real. lra. }
  rewrite !L by (rewrite ?T, ?U', ?zero_real, ?one_real; lra). cbn [orb].
  eexists. split; [left; reflexivity|]. rewrite met_real, T, A'. reflexivity.
Qed.
Lemma meet_ends v : slant e f = 0 -> v = fst f \/ v = snd f -> lies_on e (R2 v) ->
  In v (meet e f).
Proof.
  intros N V A. unfold meet. rewrite (not_far (R2 v) A).
  2: { destruct V as [->| ->]; [apply on_segment_start|apply on_segment_end]. }
  apply slant_zero in N. rewrite N. apply filter_In. split.
  - destruct V as [->| ->]; simpl; auto.
  - apply passes_over_real; auto.
Qed.
Lemma meet_from p : In p (meet e f) -> lies_on e (R2 p) /\ lies_on f (R2 p) /\
  (slant e f <> 0 \/ R2 p = start f \/ R2 p = finish f).
Proof.
  unfold meet. destruct (far_apart e f); [intros []|].
  destruct (Qeq_bool (Qred (qcross (dir e) (dir f))) 0) eqn:Z.
  - intros I. apply filter_In in I. destruct I as [I O]. apply passes_over_real in O; auto.
    split; auto. destruct I as [<-|[<-|[]]].
    + split; [apply on_segment_start|]. right. left. reflexivity.
    + split; [apply on_segment_end|]. right. right. reflexivity.
  - assert (N : slant e f <> 0).
    { intros N. apply slant_zero in N. congruence. }
    set (t := Qred (qcross (sub (fst f) (fst e)) (dir f) / _)).
    set (u := Qred (qcross (sub (fst f) (fst e)) (dir e) / _)).
    destruct (less t 0 || less 1 t || less u 0 || less 1 u) eqn:O; [intros []|].
    rewrite !orb_false_iff in O. destruct O as [[[O1 O2] O3] O4].
    assert (L : forall x y, less x y = false -> Q2R y <= Q2R x).
    { intros y z H. apply not_true_iff_false in H. rewrite less_real in H. lra. }
    apply L in O1, O2, O3, O4. rewrite zero_real, one_real in *.
    intros [<-|[]]. rewrite met_real. split; [apply at_on; lra|]. split; auto.
    assert (T : Q2R t = turn_of (minus_ (start f) (start e)) (minus_ (finish f) (start f)) /
      slant e f) by (apply share_real, N).
    assert (U : Q2R u = turn_of (minus_ (start f) (start e)) (minus_ (finish e) (start e)) /
      slant e f) by (apply share_real, N).
    rewrite T, (met_there _ _ _ _ _ N eq_refl), <- U. apply at_on. lra.
Qed.
(** Two segments with two points in common, or parallel ones with one, are on one line. *)
Lemma one_line x : lies_on e x -> lies_on f x -> slant e f = 0 -> forall y, lies_on f y ->
  orient (start e) (finish e) y = 0.
Proof.
  intros A B Z. destruct (on_at e x A) as (s & _ & A'), (on_at f x B) as (u & _ & B').
  clear A B. rename A' into A, B' into B. rewrite A in B. intros y (w & _ & Y).
    change (y = at_ (start f) (finish f) w) in Y. subst y.
  revert B Z. unfold slant. generalize (start e) (finish e) (start f) (finish f).
  intros [a1 a2] [b1 b2] [c1 c2] [d1 d2]. unfold at_, turn_of, minus_, orient; cbn [fst snd].
  intros B Z. injection B; intros B2 B1.
  assert (F1 : c1 - a1 = s * (b1 - a1) - u * (d1 - c1)) by lra.
  assert (F2 : c2 - a2 = s * (b2 - a2) - u * (d2 - c2)) by lra.
  replace (c2 + w * (d2 - c2) - a2) with (s * (b2 - a2) + (w - u) * (d2 - c2)) by lra.
  replace (c1 + w * (d1 - c1) - a1) with (s * (b1 - a1) + (w - u) * (d1 - c1)) by lra.
  transitivity ((w - u) * ((b1 - a1) * (d2 - c2) - (b2 - a2) * (d1 - c1))); [ring|].
  rewrite Z. ring.
Qed.
Lemma two_shared x y : lies_on e x -> lies_on f x -> lies_on e y -> lies_on f y -> x <> y ->
  slant e f = 0.
Proof.
  intros A B A' B' N. 
  destruct (on_at e x A) as (s & _ & S), (on_at f x B) as (u & _ & U),
    (on_at e y A') as (s' & _ & S'), (on_at f y B') as (u' & _ & U').
  pose proof (where_met _ _ _ _ _ _ (eq_trans (eq_sym S) U)) as [W _].
  pose proof (where_met _ _ _ _ _ _ (eq_trans (eq_sym S') U')) as [W' _]. rewrite W in W'.
  destruct (Req_dec (slant e f) 0) as [|D]; auto. exfalso. apply N. rewrite S, S'. f_equal.
  unfold slant in D. apply Rmult_eq_reg_r in W'; auto.
Qed.
End Two.
