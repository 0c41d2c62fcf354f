(** Points of a line in order; the program's order and its vectors, on real points. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith.
From Proved Require Import Definitions Form Local Across Overlaps Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Decided Pieces.
Open Scope R_scope.

(** ** Points of the line through a and b *)
Lemma point_eq (p q : point) : fst p = fst q -> snd p = snd q -> p = q.
Proof. destruct p, q; simpl; intros; subst; reflexivity. Qed.
Lemma before_different a b : before a b -> a <> b.
Proof. intros [H|[_ H]] ->; lra. Qed.
Lemma before_at a b s t : before a b -> (before (at_ a b s) (at_ a b t) <-> s < t).
Proof.
  intros B. unfold before, at_; cbn [fst snd]. destruct B as [B|[B C]].
  - split; [|intros; left; nra]. intros [H|[H K]]; [nra|]. assert (s = t) by nra. subst. lra.
  - rewrite <- B. split; [intros [H|[_ H]]; nra|intros; right; split; nra].
Qed.
Lemma at_same a b s t : a <> b -> at_ a b s = at_ a b t -> s = t.
Proof.
  intros N E. unfold at_ in E. injection E; intros E2 E1.
  destruct (Req_dec s t) as [|D]; auto. exfalso. apply N. apply point_eq; nra.
Qed.
Lemma on_line a b p : a <> b -> orient a b p = 0 -> exists t, p = at_ a b t.
Proof.
  intros N O. pose proof (edge_long a b N) as L. cbv zeta in L.
  set (D := (fst b - fst a) * (fst b - fst a) + (snd b - snd a) * (snd b - snd a)) in *.
  set (k := ((fst p - fst a) * (fst b - fst a) + (snd p - snd a) * (snd b - snd a)) / D).
  assert (K : k * D = (fst p - fst a) * (fst b - fst a) + (snd p - snd a) * (snd b - snd a))
    by (unfold k; field; lra).
  exists k. apply point_eq; unfold at_; cbn [fst snd]; apply Rmult_eq_reg_r with D; try lra;
    apply Rminus_diag_uniq.
  - transitivity ((fst p - fst a) * D - (fst b - fst a) * (k * D)); [ring|]. rewrite K.
    transitivity (- (snd b - snd a) * orient a b p); [unfold D, orient; ring|rewrite O; ring].
  - transitivity ((snd p - snd a) * D - (snd b - snd a) * (k * D)); [ring|]. rewrite K.
    transitivity ((fst b - fst a) * orient a b p); [unfold D, orient; ring|rewrite O; ring].
Qed.
Lemma at_orient a b t : orient a b (at_ a b t) = 0.
Proof. unfold orient, at_; cbn [fst snd]. ring. Qed.
Lemma at_at a b s t w : at_ (at_ a b s) (at_ a b t) w = at_ a b (s + w * (t - s)).
Proof. unfold at_; cbn [fst snd]. f_equal; ring. Qed.
Lemma part_range a b s t x : s <= t -> on_segment (at_ a b s) (at_ a b t) x ->
  exists w, s <= w <= t /\ x = at_ a b w.
Proof.
  intros L (w & W & E). exists (s + w * (t - s)). split; [nra|]. rewrite <- at_at. exact E.
Qed.
Lemma part_inner a b s t x : s < t -> inner (at_ a b s) (at_ a b t) x ->
  exists w, s < w < t /\ x = at_ a b w.
Proof.
  intros L (w & W & E). exists (s + w * (t - s)). split; [nra|]. rewrite <- at_at. exact E.
Qed.
Lemma inner_part a b s t w : s < w < t -> inner (at_ a b s) (at_ a b t) (at_ a b w).
Proof.
  intros W. exists ((w - s) / (t - s)). assert (K : (w - s) / (t - s) * (t - s) = w - s)
    by (field; lra). set (k := (w - s) / (t - s)) in *. split; [split; nra|].
  change (at_ a b w = at_ (at_ a b s) (at_ a b t) k). rewrite at_at. f_equal. lra.
Qed.
Lemma part_on a b s t w : s <= w <= t -> on_segment (at_ a b s) (at_ a b t) (at_ a b w).
Proof.
  intros W. apply Segments.at_between. unfold Rmin, Rmax. destruct (Rle_dec s t); lra.
Qed.

(** ** The program's order *)
Lemma equal_real x y : Qeq_bool x y = true <-> Q2R x = Q2R y.
Proof. rewrite Qeq_bool_iff. split; [apply Qeq_eqR|apply eqR_Qeq]. Qed.
Lemma less_real x y : less x y = true <-> Q2R x < Q2R y.
Proof. rewrite less_decides. destruct (Rlt_dec (Q2R x) (Q2R y)); split; auto; discriminate. Qed.
Lemma le_real x y : Qle_bool x y = true <-> Q2R x <= Q2R y.
Proof. rewrite le_decides. destruct (Rle_dec (Q2R x) (Q2R y)); split; auto; discriminate. Qed.
Lemma same_real p q : same p q = true <-> R2 p = R2 q.
Proof.
  unfold same, point_of. rewrite andb_true_iff, !equal_real. split; [intros [-> ->]; auto|].
  intros E; injection E; auto.
Qed.
Lemma is_before_real p q : is_before p q = true <-> before (R2 p) (R2 q).
Proof.
  unfold is_before, before, point_of; cbn [fst snd].
  rewrite orb_true_iff, andb_true_iff, !less_real, equal_real. tauto.
Qed.
Lemma not_after_real p q : not_after p q = true <-> ~ before (R2 q) (R2 p).
Proof. unfold not_after. rewrite negb_true_iff, <- is_before_real, not_true_iff_false. tauto. Qed.
Lemma not_after_total p q : not_after p q = true \/ not_after q p = true.
Proof.
  rewrite !not_after_real. unfold before. destruct (R2 p) as [a b], (R2 q) as [c d]; simpl. lra.
Qed.
Lemma not_after_transitive p q r :
  not_after p q = true -> not_after q r = true -> not_after p r = true.
Proof.
  rewrite !not_after_real. unfold before.
  destruct (R2 p) as [a b], (R2 q) as [c d], (R2 r) as [e f]; simpl. lra.
Qed.
Lemma not_after_same p q : not_after p q = true -> not_after q p = true -> same p q = true.
Proof.
  rewrite !not_after_real, same_real. unfold before.
  destruct (R2 p) as [a b], (R2 q) as [c d]; simpl. intros. apply point_eq; simpl; lra.
Qed.

(** ** Its vectors *)
Lemma qadd_real p q : R2 (qadd p q) = add (R2 p) (R2 q).
Proof. unfold qadd, add, point_of. cbn [fst snd]. rewrite !Q2R_red, !Q2R_plus. reflexivity. Qed.
Definition turn_of (d k : point) : R := fst d * snd k - snd d * fst k.
Lemma qcross_real d k : Q2R (qcross d k) = turn_of (R2 d) (R2 k).
Proof. unfold qcross, turn_of, point_of; cbn [fst snd]. rewrite Q2R_minus, !Q2R_mult. reflexivity.
  Qed.
Lemma dot_real d k : Q2R (Pieces.dot d k) = fst (R2 d) * fst (R2 k) + snd (R2 d) * snd (R2 k).
Proof. unfold Pieces.dot, point_of; cbn [fst snd]. rewrite Q2R_plus, !Q2R_mult. reflexivity. Qed.
Lemma zero_real : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma one_real : Q2R 1 = 1.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma side_zero a b p : (side a b p =? 0)%Z = true <-> orient (R2 a) (R2 b) (R2 p) = 0.
Proof.
  unfold side. fold (qturn a b p). rewrite <- qturn_real. unfold sg. rewrite Z.eqb_eq.
  rewrite <- zero_real. generalize (qturn a b p). intros q. split; intros H.
  - apply Qeq_eqR. unfold Qeq. simpl. lia.
  - apply eqR_Qeq in H. unfold Qeq in H. simpl in H. lia.
Qed.

(** ** Segments from the left *)
Definition forward (e : edge) : Prop := before (R2 (fst e)) (R2 (snd e)).
Lemma from_left_forward e : null e = false -> forward (from_left e).
Proof.
  unfold null, from_left, forward. intros N. destruct (is_before (fst e) (snd e)) eqn:B.
  - apply is_before_real, B.
  - cbn [fst snd]. apply not_true_iff_false in N. rewrite same_real in N.
    apply not_true_iff_false in B. rewrite is_before_real in B. unfold before in *.
    destruct (R2 (fst e)) as [a b], (R2 (snd e)) as [c d]; simpl in *.
    destruct (Rlt_dec c a); auto. right. split; [lra|].
    destruct (Rlt_dec d b); auto. destruct N. f_equal; lra.
Qed.
Definition lies_on (e : edge) (x : point) : Prop := on_segment (R2 (fst e)) (R2 (snd e)) x.
Lemma from_left_on e x : lies_on (from_left e) x <-> lies_on e x.
Proof.
  unfold from_left, lies_on. destruct (is_before (fst e) (snd e)); [tauto|].
  cbn [fst snd]. split; apply segment_swap.
Qed.
Lemma passes_over_real e p : forward e -> passes_over e p = true <-> lies_on e (R2 p).
Proof.
  unfold passes_over, lies_on, forward. rewrite !andb_true_iff, side_zero, !not_after_real.
  generalize (R2 (fst e)) (R2 (snd e)) (R2 p). intros a b x B. split.
  - intros [[O L] H]. destruct (on_line a b x (before_different a b B) O) as (t & ->).
    apply at_on.
    pose proof (before_at a b t 0 B) as P. pose proof (before_at a b 1 t B) as Q.
    rewrite at_0 in P. rewrite at_1 in Q. rewrite P in L. rewrite Q in H. lra.
  - intros (t & T & E). change (x = at_ a b t) in E. subst x. rewrite at_orient.
    pose proof (before_at a b t 0 B) as P. pose proof (before_at a b 1 t B) as Q.
    rewrite at_0 in P. rewrite at_1 in Q. rewrite P, Q. split; [split; [reflexivity|]|]; lra.
Qed.
