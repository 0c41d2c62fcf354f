(** The corners of the checker as points *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Rational Values
  Checker.
Open Scope R_scope.

#[global] Arguments qdot : simpl never.
#[global] Arguments support : simpl never.

Section Here.
Context {now : scale_here}.

Definition real (v : corner) : point := (value (fst v), value (snd v)).
Definition real_edge (e : corner * corner) : point * point := (real (fst e), real (snd e)).

Lemma real_orient a b p : value (qorient a b p) = orient (real a) (real b) (real p).
Proof. unfold qorient, orient, real; simpl. rewrite !value_minus, !value_times, !value_minus.
auto. Qed.
Lemma real_dot n p : value (qdot n p) = dot (real n) (real p).
Proof. unfold qdot, dot, real; simpl. rewrite value_plus, !value_times. reflexivity. Qed.
Lemma real_add p q : real (qadd p q) = add (real p) (real q).
Proof. unfold real, add, qadd; simpl. rewrite !value_plus. reflexivity. Qed.
Lemma real_minus p q : real (qminus p q) = minus (real p) (real q).
Proof. unfold real, minus, qminus; simpl. rewrite !value_minus. reflexivity. Qed.
Lemma real_scaled s p : real (scaled s p) = scale (value s) (real p).
Proof. unfold real, scaled, scale; simpl. rewrite !value_reduced, !value_times. reflexivity. Qed.

Lemma same_real a b : same a b = true -> real a = real b.
Proof.
  unfold same, real. intros H. apply andb_prop in H. destruct H as [H1 H2].
  rewrite (equal_value _ _ H1), (equal_value _ _ H2). reflexivity.
Qed.
Lemma distinct_real a b : distinct a b = true -> real a <> real b.
Proof.
  unfold distinct, real. intros H K. injection K; intros K2 K1.
  apply orb_prop in H. destruct H as [H|H]; apply differ_value in H; auto.
Qed.
Lemma support_real n l v : In v l -> dot (real n) (real v) <= value (support n l).
Proof.
  destruct l as [|p r]; unfold support; simpl; [tauto|]. rewrite <- real_dot.
  set (m := fold_right (fun v m => greater_of (qdot n v) m) (qdot n p)).
  assert (H : value (qdot n p) <= value (m r) /\ (In v r -> value (qdot n v) <= value (m r))).
  { induction r as [|w r IH]; simpl.
    - split; [lra|tauto].
    - destruct IH as [I1 I2]. destruct (greater_value (qdot n w) (m r)) as [M1 M2].
      unfold m in *. simpl in *. split; [lra|].
      intros [->|I]; [lra|]. specialize (I2 I). lra. }
  destruct H as [H1 H2]. intros [->|I]; auto.
Qed.

End Here.

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
