(** From rational numbers, with which the checker computes, to real ones. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Checker.
Open Scope R_scope.

#[global] Arguments Qred : simpl never.
#[global] Arguments Q2R : simpl never.
#[global] Arguments qdot : simpl never.
#[global] Arguments support : simpl never.
#[global] Arguments Qle_bool : simpl never.
#[global] Arguments Qeq_bool : simpl never.

Definition real_edge (e : vertex * vertex) : point * point := (real (fst e), real (snd e)).

Lemma Q2R_zero : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma real_orient a b p : Q2R (qorient a b p) = orient (real a) (real b) (real p).
Proof. unfold qorient, orient, real; simpl. rewrite !Q2R_minus, !Q2R_mult, !Q2R_minus. auto. Qed.
Lemma real_dot n p : Q2R (qdot n p) = dot (real n) (real p).
Proof. unfold qdot, dot, real; simpl. rewrite Q2R_plus, !Q2R_mult. reflexivity. Qed.
Lemma real_add p q : real (qadd p q) = add (real p) (real q).
Proof. unfold real, add, qadd; simpl. rewrite !Q2R_plus. reflexivity. Qed.
Lemma real_minus p q : real (qminus p q) = minus (real p) (real q).
Proof. unfold real, minus, qminus; simpl. rewrite !Q2R_minus. reflexivity. Qed.
Lemma real_scaled s p : real (scaled s p) = scale (Q2R s) (real p).
Proof. unfold real, scaled, scale; simpl. rewrite !Q2R_red, !Q2R_mult. reflexivity. Qed.

Lemma less_real x y : less x y = true -> Q2R x < Q2R y.
Proof.
  unfold less. intros H. apply Qlt_Rlt, Qnot_le_lt. intros K.
  apply Qle_bool_iff in K. rewrite K in H. discriminate.
Qed.
Lemma le_real x y : Qle_bool x y = true -> Q2R x <= Q2R y.
Proof. intros H. apply Qle_Rle, Qle_bool_iff, H. Qed.
Lemma eq_real x y : Qeq_bool x y = true -> Q2R x = Q2R y.
Proof. intros H. apply Qeq_eqR, Qeq_bool_iff, H. Qed.
Lemma same_real a b : same a b = true -> real a = real b.
Proof.
  unfold same, real. intros H. apply andb_prop in H. destruct H as [H1 H2].
  rewrite (eq_real _ _ H1), (eq_real _ _ H2). reflexivity.
Qed.
Lemma different_real a b : same a b = false -> real a <> real b.
Proof.
  unfold same, real. intros H K. injection K; intros K2 K1.
  apply eqR_Qeq, Qeq_bool_iff in K1. apply eqR_Qeq, Qeq_bool_iff in K2.
  rewrite K1, K2 in H. discriminate.
Qed.

Lemma greater_real x y :
  Q2R x <= Q2R (greater_of x y) /\ Q2R y <= Q2R (greater_of x y).
Proof.
  unfold greater_of. destruct (Qle_bool x y) eqn:E.
  - apply le_real in E. lra.
  - assert (H : less y x = true) by (unfold less; rewrite E; auto). apply less_real in H. lra.
Qed.
Lemma support_real n l v : In v l -> dot (real n) (real v) <= Q2R (support n l).
Proof.
  destruct l as [|p r]; unfold support; simpl; [tauto|]. rewrite <- real_dot.
  set (m := fold_right (fun v m => greater_of (qdot n v) m) (qdot n p)).
  assert (H : Q2R (qdot n p) <= Q2R (m r) /\ (In v r -> Q2R (qdot n v) <= Q2R (m r))).
  { induction r as [|w r IH]; simpl.
    - split; [lra|tauto].
    - destruct IH as [I1 I2]. destruct (greater_real (qdot n w) (m r)) as [M1 M2].
      unfold m in *. simpl in *. split; [lra|].
      intros [->|I]; [lra|]. specialize (I2 I). lra. }
  destruct H as [H1 H2]. intros [->|I]; auto.
Qed.

Lemma all2_equal {A} (f : A -> A -> bool) : (forall x y, f x y = true -> x = y) ->
  forall l k, all2 f l k = true -> l = k.
Proof.
  intros H. induction l as [|x l IH]; intros [|y k]; simpl; try discriminate; auto.
  intros K. apply andb_prop in K. destruct K as [K1 K2]. rewrite (H x y K1), (IH k K2). reflexivity.
Qed.
Lemma all2_partner {A B} (f : A -> B -> bool) l : forall k, all2 f l k = true ->
  forall x, In x l -> exists y, f x y = true.
Proof.
  induction l as [|a l IH]; intros [|b k]; simpl; try discriminate; [tauto|].
  rewrite andb_true_iff. intros [H1 H2] x [<-|I]; eauto.
Qed.
Lemma all2_map {A B} (f : A -> A -> bool) (g : A -> B) :
  (forall x y, f x y = true -> g x = g y) ->
  forall l k, all2 f l k = true -> map g l = map g k.
Proof.
  intros H. induction l as [|x l IH]; intros [|y k]; simpl; try discriminate; auto.
  intros K. apply andb_prop in K. destruct K as [K1 K2]. rewrite (H x y K1), (IH k K2). reflexivity.
Qed.

(** Rings and fans of what a function makes of vertices *)
Definition both {A B} (f : A -> B) (e : A * A) : B * B := (f (fst e), f (snd e)).
Definition each {A B} (f : A -> B) (t : A * A * A) : B * B * B :=
  let '(a, b, c) := t in (f a, f b, f c).
Lemma path_map {A B} (f : A -> B) l : forall a b,
  path (f a) (f b) (map f l) = map (both f) (path a b l).
Proof. induction l; intros; simpl; [reflexivity|rewrite IHl; reflexivity]. Qed.
Lemma ring_edges_map {A B} (f : A -> B) l : ring_edges (map f l) = map (both f) (ring_edges l).
Proof. destruct l; simpl; [reflexivity|apply path_map]. Qed.
Lemma fan_map {A B} (f : A -> B) l : forall a b,
  fan (f a) (f b) (map f l) = map (each f) (fan a b l).
Proof. induction l; intros; simpl; [reflexivity|rewrite IHl; reflexivity]. Qed.
Lemma fan_of_map {A B} (f : A -> B) l : fan_of (map f l) = map (each f) (fan_of l).
Proof. destruct l as [|a [|b r]]; simpl; try reflexivity. apply fan_map. Qed.
