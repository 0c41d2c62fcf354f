(** What has to be believed beside Definitions.v for union, intersection and difference: of points
    first, then of sets, as docs/definitions.md has them. *)
From Proved Require Export Definitions.
Open Scope R_scope.

Inductive operation := unite | intersect | subtract.
(** The points in a set or one of others; in it and all others; in it and none of the others *)
Definition combined (o : operation) (S : point -> Prop) (others : list (point -> Prop))
    (x : point) : Prop :=
  match o with
  | unite => S x \/ exists T, In T others /\ T x
  | intersect => S x /\ forall T, In T others -> T x
  | subtract => S x /\ forall T, In T others -> ~ T x
  end.
(** All points that a set comes near to. Sets are combined to the closure of the interior. *)
Definition closure (S : point -> Prop) (x : point) : Prop :=
  forall e, 0 < e -> exists y, near e x y /\ S y.
Definition regularised (S : point -> Prop) : point -> Prop := closure (interior S).
