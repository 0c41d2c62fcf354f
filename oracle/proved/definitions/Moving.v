(** The claims `interval` and `event` of docs/certificates.md: what has to be believed of them,
    beside Definitions.v and Form.v *)
From Coq Require Export Permutation.
From Proved Require Export Definitions Form.
Open Scope R_scope.

(** A vertex that moves: (x0 + s x1, y0 + s y1) at the scale s, as it stands in a file *)
Definition mover := (Q * Q * (Q * Q))%type.
Definition track (m : mover) : point * point :=
  let '(x0, x1, (y0, y1)) := m in ((Q2R x0, Q2R y0), (Q2R x1, Q2R y1)).
Definition at_scale (s : R) (m : mover) : point := add (scale s (snd (track m))) (fst (track m)).

(** How many things of a list have a property *)
Inductive counts {A} (H : A -> Prop) : list A -> nat -> Prop :=
| counts_none : counts H [] 0
| counts_one a l n : H a -> counts H l n -> counts H (a :: l) (S n)
| counts_not a l n : ~ H a -> counts H l n -> counts H (a :: l) n.

(** The touching points: each as often as rings pass it once more *)
Definition passes (x : point) (ring : list point) : Prop :=
  exists e, In e (ring_edges ring) /\ on_segment (fst e) (snd e) x.
Definition touch_in (rs : rings point) (T : list point) : Prop := forall x, exists n,
  counts (passes x) rs n /\ counts (eq x) T (pred n).

(** The sum at a scale: polygons in canonical form but for the order, touching points, and how many
    holes it has; components are as many as polygons. *)
Definition is_state (s : R) (P Q : rings vertex) (ps : list (polygon point)) (T : list point)
    (holes : nat) : Prop :=
  is_sum s (points P) (points Q) (rings_of ps) /\
  has_components (set_of (rings_of ps)) (length ps) /\
  has_holes (set_of (rings_of ps)) holes /\
  is_form (set_of (rings_of ps)) ps /\ touch_in (rings_of ps) T.

(** No event of the boundary between two scales: one figure that moves, with its touching points *)
Definition moving := (list (polygon mover) * list mover * nat)%type.
Definition at_ (s : R) (m : moving) : list (polygon point) * list point * nat :=
  let '(ps, T, holes) := m in (each_vertex (at_scale s) ps, map (at_scale s) T, holes).
Definition is_interval (from to : Q) (P Q : rings vertex) (m : moving) : Prop :=
  Q2R from < Q2R to /\ forall s, Q2R from < s < Q2R to ->
    let '(ps, T, holes) := at_ s m in is_state s P Q ps T holes.

(** The same polygons and touching points but for the order, and where rings start *)
Definition turned {A} (l k : list A) : Prop := exists a b, l = a ++ b /\ k = b ++ a.
Definition same_polygon {A} (p q : polygon A) : Prop := turned (fst p) (fst q) /\
  exists holes, Permutation (snd p) holes /\ Forall2 turned holes (snd q).
Definition same_figure {A} (f g : list (polygon A) * list A) : Prop :=
  (exists ps, Permutation (fst f) ps /\ Forall2 same_polygon ps (fst g)) /\
  Permutation (snd f) (snd g).

(** An event at the scale s: the boundary is not one moving figure before, at and after it; or
    components or holes are not as many at all three. *)
Definition state := (list (polygon point) * list point * nat)%type.
Definition tracks (m : moving) := (each_vertex track (fst (fst m)), map track (snd (fst m))).
Definition boundary_changes (s : R) (before : moving) (at_s : state) (after : moving) : Prop :=
  ~ same_figure (tracks before) (tracks after) \/ ~ same_figure (fst (at_ s before)) (fst at_s).
Definition topology_changes (before : moving) (at_s : state) (after : moving) : Prop :=
  let numbers {A} (m : list (polygon A) * list A * nat) := (length (fst (fst m)), snd m) in
  ~ (numbers before = numbers at_s /\ numbers at_s = numbers after).
Definition is_event (from s to : Q) (P Q : rings vertex) (before : moving) (at_s : state)
    (after : moving) (of_boundary : bool) : Prop :=
  is_interval from s P Q before /\ is_interval s to P Q after /\
  (let '(ps, T, holes) := at_s in is_state (Q2R s) P Q ps T holes /\ in_order ps) /\
  if of_boundary then boundary_changes (Q2R s) before at_s after
  else topology_changes before at_s after.
