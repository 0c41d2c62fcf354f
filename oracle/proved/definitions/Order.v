(** Order of rational numbers, of lists, and of pairs of natural numbers, decided *)
From Coq Require Import QArith List Mergesort Orders Bool Lia.

Definition less (x y : Q) : bool := negb (Qle_bool y x).
Fixpoint ascends {A} (is_before : A -> A -> bool) (l : list A) : bool :=
  match l with
  | x :: r => match r with y :: _ => is_before x y | nil => true end && ascends is_before r
  | nil => true
  end.

(** Pairs of natural numbers, sorted *)
Module Edges <: TotalLeBool.
  Definition t := (nat * nat)%type.
  Definition leb (e f : t) := Nat.leb (fst e) (fst f) && (negb (Nat.eqb (fst e) (fst f)) ||
    Nat.leb (snd e) (snd f)).
  Theorem leb_total : forall e f, leb e f = true \/ leb f e = true.
  Proof.
    intros [a b] [c d]. unfold leb; simpl.
    rewrite !andb_true_iff, !orb_true_iff, !negb_true_iff, !Nat.leb_le, !Nat.eqb_neq. lia.
  Qed.
End Edges.
Module EdgeSort := Sort Edges.
