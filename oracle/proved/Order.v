(** Order of rational numbers and of lists, decided *)
From Coq Require Import QArith List.

Definition less (x y : Q) : bool := negb (Qle_bool y x).
Fixpoint ascends {A} (is_before : A -> A -> bool) (l : list A) : bool :=
  match l with
  | x :: r => match r with y :: _ => is_before x y | nil => true end && ascends is_before r
  | nil => true
  end.
