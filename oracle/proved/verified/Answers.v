(** Programs that answer about the sum of two sets, and about sets that are combined, from the sets
    alone, whatever they are given: first they decide whether the operands are legal. Their claims
    stand in Statement.v. *)
From Coq Require Import QArith Bool.
From Proved Require Import Definitions Form Operations Points Validity Traced Combined.
Open Scope Q_scope.

Definition are_legal (s : Q) (P K : list (polygon vertex)) : bool :=
  less 0 s && decide_legal P && decide_legal K.
(** Whether each point is in s P + Q; None: the operands are not legal, or s is not above 0 *)
Definition decide_points (s : Q) (P K : list (polygon vertex)) (xs : list vertex) :
    option (list bool) :=
  if are_legal s P K then Some (map (decide_membership s (rings_of P) (rings_of K)) xs) else None.

(** Legal operands that are a point or a segment *)
Definition thin (ps : list (polygon vertex)) : bool :=
  match ps with [([_], [])] | [([_; _], [])] => true | _ => false end.
(** The sum s P + Q and how many holes it has; None: the operands are not legal, or both are
    thin. What is traced never fails the test of Traced.v (Always.v). *)
Definition verified_sum (s : Q) (P K : list (polygon vertex)) :
    option (list (polygon vertex) * nat) :=
  if are_legal s P K && negb (thin P && thin K) then exact_sum s (rings_of P) (rings_of K)
  else None.

(** The union, intersection or difference, and how many holes it has; None: an operand is no legal
    polygon set *)
Definition verified_combination (o : operation) (P : list (polygon vertex))
    (others : list (list (polygon vertex))) : option (list (polygon vertex) * nat) :=
  if forallb decide_polygon_set (P :: others)
  then exact_combination o (rings_of P) (map rings_of others) else None.
