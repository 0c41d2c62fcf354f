(** A program that decides whether a list of polygons is legal, as Legality.v says. Numbers are
    those of files. *)
From Coq Require Import QArith Bool.
From Proved Require Import Definitions Form Points Pieces.
Open Scope Q_scope.

(** Whether a test says yes of each two entries *)
Fixpoint each_pair {A} (test : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | x :: r => forallb (test x) r && each_pair test r end.

(** Two segments from the left have more than a point in common. *)
Definition overlap (e f : edge) : bool :=
  is_before (fst e) (snd f) && is_before (fst f) (snd e) &&
  (side (fst e) (snd e) (fst f) =? 0)%Z && (side (fst e) (snd e) (snd f) =? 0)%Z.
(** Two edges that do not overlap have no point in common, their first ends apart. *)
Definition part_ways (e f : edge) : bool :=
  forallb (fun p => same p (fst e) || same p (fst f)) (meet (from_left e) (from_left f)).

Definition twice_area (ring : list vertex) : Q :=
  fold_right (fun e s => Qred (qcross (fst e) (snd e) + s)) 0 (ring_edges ring).

(** Edges wind around nothing twice: straight above each piece of a rightward edge they wind once,
    above a leftward one not at all. Upright edges need no test. *)
Definition as_overhead (E : list edge) (e : edge) (p : edge) : bool :=
  (winding_of E (middle p) =? (if less (fst (fst e)) (fst (snd e)) then 1 else 0))%Z.
Definition goes_once (E : list edge) : bool :=
  let all := map from_left E in
  forallb (fun e => Qeq_bool (fst (fst e)) (fst (snd e)) ||
    forallb (as_overhead E e) (cut all (from_left e))) E.

Definition sound_ring (ring : list vertex) : bool :=
  (3 <=? length ring)%nat && forallb (fun e => negb (null e)) (ring_edges ring).
Definition decide_polygon_set (ps : list (polygon vertex)) : bool :=
  let E := all_edges (rings_of ps) in
  forallb sound_ring (rings_of ps) &&
  each_pair (fun e f => negb (overlap (from_left e) (from_left f))) E &&
  forallb (fun ring => each_pair part_ways (ring_edges ring)) (rings_of ps) &&
  forallb (fun p => less 0 (twice_area (fst p)) &&
    forallb (fun hole => less (twice_area hole) 0) (snd p)) ps &&
  forallb (fun p => goes_once (all_edges (fst p :: snd p))) ps &&
  match ps with [_] => true | _ => goes_once E end.

Definition decide_legal (ps : list (polygon vertex)) : bool :=
  match ps with
  | [([_], [])] => true
  | [([a; b], [])] => negb (same a b)
  | _ => decide_polygon_set ps
  end.
