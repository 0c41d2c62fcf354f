(** Union, intersection and difference as a program: the edges of all sets, and what is said of a
    point that is on none of them. Numbers are those of files. *)
From Coq Require Import QArith Bool.
From Proved Require Import Definitions Form Operations Points Pieces Traced.

Definition agree (o : operation) (first : bool) (others : list bool) : bool :=
  match o with
  | unite => first || existsb (fun b => b) others
  | intersect => first && forallb (fun b => b) others
  | subtract => first && negb (existsb (fun b => b) others)
  end.
Definition winds_around (y : vertex) (E : list edge) : bool := (0 <? winding_of E y)%Z.
Definition decide_combined (o : operation) (E : list edge) (others : list (list edge))
    (y : vertex) : bool :=
  agree o (winds_around y E) (map (winds_around y) others).
Definition all_segments (sets : list (list edge)) : list edge := map from_left (concat sets).

(** A set and others; they need have no order, and may overlap each other in any way. *)
Definition exact_combination (o : operation) (P : rings vertex) (others : list (rings vertex)) :
    option (list (polygon vertex) * nat) :=
  let E := all_edges P in let Fs := map all_edges others in
  traced_set (decide_combined o E Fs) (all_segments (E :: Fs)).
