(** From rational numbers to real ones. *)
From Coq Require Import Lra.
From Proved Require Import Definitions Order.
Open Scope R_scope.

#[global] Arguments Qred : simpl never.
#[global] Arguments Q2R : simpl never.
#[global] Arguments Qle_bool : simpl never.
#[global] Arguments Qeq_bool : simpl never.

Lemma Q2R_zero : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R; simpl; lra. Qed.
Lemma Q2R_red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma less_real x y : less x y = true -> Q2R x < Q2R y.
Proof.
  unfold less. intros H. apply Qlt_Rlt, Qnot_le_lt. intros K.
  apply Qle_bool_iff in K. rewrite K in H. discriminate.
Qed.
Lemma le_real x y : Qle_bool x y = true -> Q2R x <= Q2R y.
Proof. intros H. apply Qle_Rle, Qle_bool_iff, H. Qed.
Lemma eq_real x y : Qeq_bool x y = true -> Q2R x = Q2R y.
Proof. intros H. apply Qeq_eqR, Qeq_bool_iff, H. Qed.
