(** Slabs between the abscissas where pieces of a boundary end, and their cells, as a program. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions Points Pieces.
Open Scope Q_scope.

Definition rightward (e : edge) : bool := less (fst (fst e)) (fst (snd e)).
Definition vertical (e : edge) : bool := Qeq_bool (fst (fst e)) (fst (snd e)).
(** The height of an edge that is not vertical, or of its line, at the abscissa x *)
Definition height (x : Q) (e : edge) : Q :=
  let (a, b) := e in
  if Qeq_bool x (fst a) then snd a else if Qeq_bool x (fst b) then snd b else
  Qred (snd a + (x - fst a) * (snd b - snd a) / (fst b - fst a)).

(** Between two abscissas, above an edge and below another; None: there is no end. *)
Record cell := { from : option Q; to : option Q; bottom : option edge; top : option edge }.
Definition spans (x0 x1 : Q) (e : edge) : bool :=
  let f := from_left e in
  Qle_bool (fst (fst f)) x0 && Qle_bool x1 (fst (snd f)) && negb (vertical e).
Fixpoint stack (x0 x1 : Q) (below : option edge) (l : list edge) : list cell :=
  match l with
  | [] => [{| from := Some x0; to := Some x1; bottom := below; top := None |}]
  | e :: r =>
      {| from := Some x0; to := Some x1; bottom := below; top := Some e |} ::
      stack x0 x1 (Some e) r
  end.
Definition by_height (m : Q) (l : list edge) : list edge :=
  map snd (in_turn (fun p q => Qle_bool (fst p) (fst q)) (fun p q => Qeq_bool (fst p) (fst q))
    (map (fun e => (height m e, e)) l)).
Definition slab (B : list edge) (x0 x1 : Q) : list cell :=
  stack x0 x1 None (by_height (Qred ((x0 + x1) / 2)) (filter (spans x0 x1) B)).
Definition walls (B : list edge) : list Q :=
  in_turn Qle_bool Qeq_bool (flat_map (fun e : edge => [fst (fst e); fst (snd e)]) B).
Definition slabs (B : list edge) : list (list cell) :=
  let xs := walls B in
  [{| from := None; to := hd_error xs; bottom := None; top := None |}] ::
  map (fun p => slab B (fst p) (snd p)) (adjacent xs) ++
  match hd_error (rev xs) with
  | Some x => [[{| from := Some x; to := None; bottom := None; top := None |}]]
  | None => []
  end.
(** The sum is on the left of the pieces. *)
Definition full (c : cell) : bool := match bottom c with Some e => rightward e | None => false end.

(** ** Cells that hang together: they share a piece of a wall. *)
Definition is_below (x : Q) (c d : cell) : bool := (* the bottom of c is below the top of d *)
  match bottom c, top d with Some e, Some f => less (height x e) (height x f) | _, _ => true end.
Definition is_left_of (c d : cell) : bool :=
  match to c, from d with
  | Some x, Some y =>
      Qeq_bool x y && is_below x c d && is_below x d c && is_below x c c && is_below x d d
  | _, _ => false
  end.
Definition linked (c d : cell) : bool := is_left_of c d || is_left_of d c.
Fixpoint classes (l : list cell) : list (list cell) :=
  match l with
  | [] => []
  | c :: r =>
      let k := classes r in
      (c :: concat (filter (existsb (linked c)) k)) ::
      filter (fun A => negb (existsb (linked c) A)) k
  end.
(** Components of the set, and parts of what is outside *)
Definition parts (B : list edge) (inside : bool) : list (list cell) :=
  classes (filter (fun c => Bool.eqb (full c) inside) (concat (slabs B))).

(** ** A sum at a scale: the cells of its boundary, and how many components and holes it has *)
Definition sum_pieces (s : Q) (P K : rings vertex) : list edge :=
  sum_boundary (all_edges (map (map (by_scale s)) P)) (all_edges K).
Definition sum_cells (s : Q) (P K : rings vertex) : list cell := concat (slabs (sum_pieces s P K)).
Definition count_parts (s : Q) (P K : rings vertex) : nat * nat :=
  let B := sum_pieces s P K in (length (parts B true), pred (length (parts B false))).
