(** The canonical form of docs/definitions.md: what has to be believed beside Definitions.v *)
From Coq Require Export Sorted.
From Proved Require Export Definitions.
Open Scope R_scope.

Definition polygon (A : Type) := (list A * list (list A))%type. (* an outer ring, and holes *)
Definition rings_of {A} (ps : list (polygon A)) : rings A :=
  flat_map (fun p => fst p :: snd p) ps.
Definition each_vertex {A B} (f : A -> B) (ps : list (polygon A)) : list (polygon B) :=
  map (fun p => (map f (fst p), map (map f) (snd p))) ps.
Definition figure (ps : list (polygon vertex)) : list (polygon point) := each_vertex point_of ps.

(** Vertices are compared by x, then y; rings as lists of vertices. *)
Definition before (p q : point) : Prop := fst p < fst q \/ (fst p = fst q /\ snd p < snd q).
Fixpoint ring_before (l k : list point) : Prop :=
  match l, k with
  | _, [] => False
  | [], _ :: _ => True
  | p :: l', q :: k' => before p q \/ (p = q /\ ring_before l' k')
  end.
(** Twice the area of a ring, positive where it runs counter-clockwise *)
Definition area (ring : list point) : R :=
  fold_right (fun e s => fst (fst e) * snd (snd e) - snd (fst e) * fst (snd e) + s) 0
    (ring_edges ring).

(** A simple ring without straight vertices: with each edge without its first end, no point is on
    two. *)
Definition beyond_start (e : point * point) (x : point) : Prop :=
  on_segment (fst e) (snd e) x /\ x <> fst e.
Definition is_ring (ring : list point) : Prop :=
  ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False)
    (ring_edges ring) /\
  forall e f, In (e, f) (ring_edges (ring_edges ring)) -> orient (fst e) (snd e) (snd f) <> 0.

(** An edge has C on its left and nothing of S on its right, at all its points but a few. *)
Definition divides (C S : point -> Prop) (e : point * point) : Prop :=
  exists few : list point, forall x, on_segment (fst e) (snd e) x -> In x few \/
    exists r, 0 < r /\ forall y, near r x y ->
      (0 < orient (fst e) (snd e) y -> C y) /\ (orient (fst e) (snd e) y < 0 -> ~ S y).

(** One polygon for each component of the interior; what is on no edge is inside, and no part of the
    boundary is on two edges. *)
Definition is_form (S : point -> Prop) (ps : list (polygon point)) : Prop := exists C,
  falls_into (interior S) C (length ps) /\
  (forall x, S x -> (forall a b, In (a, b) (all_edges (rings_of ps)) -> ~ on_segment a b x) ->
    interior S x) /\
  ForallOrdPairs (fun e f => forall x y, on_segment (fst e) (snd e) x ->
    on_segment (fst e) (snd e) y -> on_segment (fst f) (snd f) x ->
    on_segment (fst f) (snd f) y -> x = y) (all_edges (rings_of ps)) /\
  (forall i outer holes, nth_error ps i = Some (outer, holes) ->
    0 < area outer /\ (forall hole, In hole holes -> area hole < 0) /\
    forall ring, In ring (outer :: holes) -> is_ring ring /\
      forall e, In e (ring_edges ring) -> divides (C i) S e).

(** Each ring from its least vertex; holes in order, and polygons by their outer rings *)
Definition starts_least (ring : list point) : Prop :=
  match ring with [] => False | first :: rest => forall p, In p rest -> before first p end.
Definition in_order (ps : list (polygon point)) : Prop :=
  (forall ring, In ring (rings_of ps) -> starts_least ring) /\
  (forall p, In p ps -> Sorted ring_before (snd p)) /\ Sorted ring_before (map fst ps).
Definition is_canonical (S : point -> Prop) (ps : list (polygon point)) : Prop :=
  is_form S ps /\ in_order ps.
