(** Claim `outside`: a point that is not in the sum. *)
From Coq Require Import Lra Bool.
From Proved Require Import Definitions Fans Numbers Values Checker Corners Bodies Scaling Trees
  Theorems.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** ** The checker *)
(** For each pair of pieces a normal, as in [separates], but strictly *)
Definition holds_apart (x n : corner) (a b : node) : bool := lt (farthest n a b) (qdot n x).
Definition check_outside (s : number) (P Q : rings corner) (x : corner) (of_P of_Q : tiled)
    (code : list token) : bool :=
  (is_empty P || is_empty Q) ||
  (lt zero s && check_operand s P of_P && check_operand one Q of_Q &&
   follow_with (holds_apart x) code [(root of_P, root of_Q)]).

(** ** It is right. *)
Lemma apart_missed x n a b la lb p q : holds_apart x n a b = true -> is_tree a = true ->
  is_tree b = true -> In la (leaves a) -> In lb (leaves b) -> body la p -> body lb q ->
  real x <> add p q.
Proof.
  unfold holds_apart, farthest. intros H Wa Wb Ia Ib Kp Kq X.
  apply lt_value in H. rewrite value_plus, real_dot, X in H.
  destruct (tree_le a Wa) as [_ Ka]. destruct (tree_le b Wb) as [_ Kb].
  assert (A : dot (real n) p <= value (support n (hull_of a))).
  { apply (body_le la); [apply (Ka la Ia)|auto|]. apply (proj2 (Ka la Ia)).
    intros v V. apply support_real, V. }
  assert (B : dot (real n) q <= value (support n (hull_of b))).
  { apply (body_le lb); [apply (Kb lb Ib)|auto|]. apply (proj2 (Kb lb Ib)).
    intros v V. apply support_real, V. }
  unfold dot, add in *; cbn [fst snd] in *. lra.
Qed.
Lemma outside_holds s P Q x oP oQ code : check_outside s P Q x oP oQ code = true ->
  ~ in_sum (value s) (outline P) (outline Q) (real x).
Proof.
  unfold check_outside. intros H (p & q & Hp & Hq & E). apply orb_prop in H. destruct H as [Em|H].
  - apply orb_prop in Em. destruct Em as [Em|Em]; [destruct P|destruct Q]; try discriminate;
      [destruct (empty_set p Hp)|destruct (empty_set q Hq)].
  - rewrite !andb_true_iff in H. destruct H as [[[S HP] HQ] F].
    apply lt_value in S. rewrite value_zero in S. assert (Z : 0 < value one)
      by (rewrite value_one; lra).
    apply (operand_is_leaves _ _ _ S HP) in Hp. apply (operand_is_leaves _ _ _ Z HQ) in Hq.
    rewrite scale_one in Hq. destruct Hp as (la & Ia & Ka). destruct Hq as (lb & Ib & Kb).
    destruct (follow_answers _ _ _ F) with (a := root oP) (b := root oQ) (la := la) (lb := lb)
      as (n & a & b & A & Wa & Wb & Ja & Jb); simpl; auto.
    + intros a b [J|[]]. injection J; intros; subst. split; eapply operand_tree; eauto.
    + exact (apart_missed x n a b la lb _ _ A Wa Wb Ja Jb Ka Kb E).
Qed.
End Here.

#[local] Instance anywhere : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.
Definition check_one_outside (s : Q) (P Q : rings vertex) (x : vertex) (of_P of_Q : tiled)
    (code : list token) : bool :=
  check_outside (Fixed s) (fixed_rings P) (fixed_rings Q) (fixed x) of_P of_Q code.
Theorem outside_is_right : forall (s : Q) (P Q : rings vertex) (x : vertex) (of_P of_Q : tiled)
    (code : list token), check_one_outside s P Q x of_P of_Q code = true ->
  ~ in_sum (Q2R s) (points P) (points Q) (point_of x).
Proof.
  intros s P Q x oP oQ code H. apply outside_holds in H. rewrite !outline_fixed in H. exact H.
Qed.
