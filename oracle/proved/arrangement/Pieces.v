(** The arrangement of a sum, as a program: the segments of the reduced convolution, cut at each
    other, and the pieces that have the sum on one side alone. Numbers are those of files. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions Points.
Open Scope Q_scope.

Definition qadd (p q : vertex) : vertex := (Qred (fst p + fst q), Qred (snd p + snd q)).
Definition dot (u v : vertex) : Q := fst u * fst v + snd u * snd v.
Definition same (p q : vertex) : bool := Qeq_bool (fst p) (fst q) && Qeq_bool (snd p) (snd q).
Definition is_before (p q : vertex) : bool :=
  less (fst p) (fst q) || Qeq_bool (fst p) (fst q) && less (snd p) (snd q).
Definition not_after (p q : vertex) : bool := negb (is_before q p).
Definition dir (e : edge) : vertex := sub (snd e) (fst e).
Definition null (e : edge) : bool := same (fst e) (snd e).
Definition same_edge (e f : edge) : bool := same (fst e) (fst f) && same (snd e) (snd f).

(** ** Lists in order *)
Section SortBy.
Context {A : Type} (le eq : A -> A -> bool).
Fixpoint merge (l : list A) : list A -> list A :=
  match l with
  | [] => fun k => k
  | x :: l' => fix inner (k : list A) : list A :=
      match k with
      | [] => l
      | y :: k' => if le x y then x :: merge l' k else y :: inner k'
      end
  end.
Fixpoint merge_pairs (ls : list (list A)) : list (list A) :=
  match ls with l :: k :: r => merge l k :: merge_pairs r | _ => ls end.
Fixpoint merge_all (fuel : nat) (ls : list (list A)) : list A :=
  match fuel, ls with
  | _, [] => []
  | _, [l] => l
  | O, _ => concat ls
  | S n, _ => merge_all n (merge_pairs ls)
  end.
Definition sort (l : list A) : list A := merge_all (length l) (map (fun x => [x]) l).
(** Neighbours that are equal: one of them *)
Fixpoint unique (l : list A) : list A :=
  match l with
  | x :: r => match r with y :: _ => if eq x y then unique r else x :: unique r | [] => [x] end
  | [] => []
  end.
Definition in_turn (l : list A) : list A := unique (sort l).
End SortBy.
Definition adjacent {A} (l : list A) : list (A * A) := combine l (tl l).

Definition vertices_once (l : list vertex) : list vertex := in_turn not_after same l.
Definition edge_le (e f : edge) : bool :=
  is_before (fst e) (fst f) || same (fst e) (fst f) && not_after (snd e) (snd f).
Definition edges_once (l : list edge) : list edge := in_turn edge_le same_edge l.

Definition passes_over (e : edge) (p : vertex) : bool :=
  (side (fst e) (snd e) p =? 0)%Z && not_after (fst e) p && not_after p (snd e).

(** ** The reduced convolution: each edge of one set at the vertices of the other that fit it *)
Definition from_left (e : edge) : edge :=
  if is_before (fst e) (snd e) then e else (snd e, fst e).
(** Points and segments have at most two edges. *)
Definition is_slim (E : list edge) : bool := Nat.leb (length E) 2.
(** From a vertex to the ends of all edges that it is on; along edges that start there *)
Definition arms (F : list edge) (v : vertex) : list vertex :=
  flat_map (fun f => if passes_over (from_left f) v then [sub (fst f) v; sub (snd f) v] else []) F.
Definition leaving (F : list edge) (v : vertex) : list vertex :=
  map dir (filter (fun f => same (fst f) v) F).
(** Left of such an edge is nothing but the set: the vertex is reflex, or straight. *)
Definition is_bare (arms : list vertex) (d : vertex) : bool :=
  forallb (fun w => (sg (qcross d w) <=? 0)%Z) arms.
Definition corner := (vertex * (list vertex * list vertex))%type.
Definition corner_at (F : list edge) (f : edge) : corner :=
  let v := fst f in let l := arms F v in
  (v, (l, if is_slim F then [] else filter (is_bare l) (leaving F v))).
Definition one_way (d k : vertex) : bool :=
  (sg (qcross d k) =? 0)%Z && (0 <? sg (dot d k))%Z.
(** An edge in the direction d has all edges there on its left; and the set is not all around *)
Definition fits (d : vertex) (c : corner) : bool :=
  forallb (fun w => (0 <=? sg (qcross d w))%Z) (fst (snd c)) && forallb (one_way d) (snd (snd c)).
Definition moved (e : edge) (v : vertex) : edge := from_left (qadd (fst e) v, qadd (snd e) v).
Definition translates (E F : list edge) : list edge :=
  let corners := map (corner_at F) F in let all := is_slim E in
  flat_map (fun e => let d := dir e in
    map (fun c => moved e (fst c)) (filter (fun c => all || fits d c) corners)) E.
Definition convolution (E F : list edge) : list edge :=
  edges_once (filter (fun e => negb (null e)) (translates E F ++ translates F E)).

(** ** Segments that are cut at each other: crossings, ends, where they overlap each other's ends *)
Definition far_apart (e f : edge) : bool :=
  less (fst (snd e)) (fst (fst f)) || less (fst (snd f)) (fst (fst e)).
Definition meet (e f : edge) : list vertex :=
  if far_apart e f then [] else
  let d := dir e in let k := dir f in
  let n := Qred (qcross d k) in
  if Qeq_bool n 0 then filter (passes_over e) [fst f; snd f]
  else
    let w := sub (fst f) (fst e) in
    let t := Qred (qcross w k / n) in let u := Qred (qcross w d / n) in
    if less t 0 || less 1 t || less u 0 || less 1 u then []
    else [qadd (fst e) (by_scale t d)].
Definition cut (all : list edge) (e : edge) : list edge :=
  adjacent (vertices_once (fst e :: snd e :: flat_map (meet e) all)).
Definition pieces (all : list edge) : list edge := edges_once (flat_map (cut all) all).

(** ** Points beside the middle of a piece, so near that no segment is between *)
Definition min (x y : Q) : Q := if Qle_bool x y then x else y.
Definition least (l : list Q) : Q :=
  fold_right (fun x m => if less 0 x then min x m else m) 1 l.
Definition middle (e : edge) : vertex :=
  (Qred ((fst (fst e) + fst (snd e)) / 2), Qred ((snd (fst e) + snd (snd e)) / 2)).
(** Left along an axis, for pieces from the left: up, or leftward if the piece is upright *)
Definition left_axis (e : edge) : vertex :=
  if Qeq_bool (fst (fst e)) (fst (snd e)) then (-1, 0) else (0, 1).
(** How far along an axis from m a segment is met that has points of as much as m across it; of a
    segment along the axis, how far its ends are *)
Definition met_along (along across : vertex -> Q) (m : vertex) (f : edge) : list Q :=
  let (a, b) := f in
  if Qeq_bool (across a) (across b) then [Qred (along a - along m); Qred (along b - along m)]
  else [Qred (along a - along m +
    (across m - across a) * ((along b - along a) / (across b - across a)))].
(** How far from m, in the direction n of an axis, up or leftward, a segment is met that runs from
    the left *)
Definition met_at (m n : vertex) (f : edge) : list Q :=
  if Qeq_bool (fst n) 0 then
    if less (fst m) (fst (fst f)) || less (fst (snd f)) (fst m) then [] else met_along snd fst m f
  else if apart_on_axis (snd m) (snd m) (snd (fst f)) (snd (snd f)) then []
  else map Qopp (met_along fst snd m f).
Definition at_distance (m n : vertex) (t : Q) : vertex := qadd m (by_scale t n).
Definition beside (all : list edge) (e : edge) : vertex * vertex :=
  let m := middle e in let n := left_axis e in
  let k := flat_map (met_at m n) all in
  (at_distance m n (least k / 2), at_distance m n (- (least (map Qopp k) / 2))).

(** ** The pieces with the set on one side alone, each with the set on its left *)
Definition boundary (is_in : vertex -> bool) (all : list edge) : list edge :=
  flat_map (fun e : edge => let (l, r) := beside all e in
    match is_in l, is_in r with
    | true, false => [e]
    | false, true => [(snd e, fst e)]
    | _, _ => []
    end) (pieces all).
Definition sum_boundary (E F : list edge) : list edge :=
  boundary (decide_point E F) (convolution E F).
