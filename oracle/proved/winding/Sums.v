(** Sums of integers over lists. *)
From Coq Require Import ZArith Lia List Permutation.
Import ListNotations.

Definition sumz {A} (f : A -> Z) (l : list A) : Z := fold_right (fun a s => (f a + s)%Z) 0%Z l.

Lemma sumz_app {A} (f : A -> Z) l k : sumz f (l ++ k) = (sumz f l + sumz f k)%Z.
Proof. induction l; simpl; [reflexivity|rewrite IHl; ring]. Qed.
Lemma sumz_perm {A} (f : A -> Z) l k : Permutation l k -> sumz f l = sumz f k.
Proof. induction 1; simpl; lia. Qed.
Lemma sumz_ext {A} (f g : A -> Z) l : (forall a, In a l -> f a = g a) -> sumz f l = sumz g l.
Proof. induction l; simpl; intros; [reflexivity|rewrite H, IHl; auto]. Qed.
Lemma sumz_ge0 {A} (f : A -> Z) l : (forall a, In a l -> (0 <= f a)%Z) -> (0 <= sumz f l)%Z.
Proof. induction l; simpl; intros; [lia|]. pose proof (H a).
  pose proof (fun b K => H b (or_intror K)). intuition lia. Qed.
Lemma sumz_ge1 {A} (f : A -> Z) l a :
  (forall a, In a l -> (0 <= f a)%Z) -> In a l -> (1 <= f a)%Z -> (1 <= sumz f l)%Z.
Proof.
  intros H I K. apply in_split in I. destruct I as (l1 & l2 & ->).
  rewrite sumz_app. simpl.
  assert (0 <= sumz f l1)%Z by (apply sumz_ge0; intros; apply H, in_or_app; auto).
  assert (0 <= sumz f l2)%Z by (apply sumz_ge0; intros; apply H, in_or_app; simpl; auto). lia.
Qed.
Lemma sumz_pos {A} (f : A -> Z) l : (1 <= sumz f l)%Z -> exists a, In a l /\ (1 <= f a)%Z.
Proof.
  induction l; simpl; intros; [lia|]. destruct (Z_le_dec 1 (f a)); [exists a; auto|].
  destruct IHl as (b & I & K); [lia|exists b; auto].
Qed.

