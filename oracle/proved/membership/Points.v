(** A program that decides whether a point is in a sum, from the sets alone: no piece, no witness.
    Numbers are those of files. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions.
Open Scope Q_scope.

Definition edge := (vertex * vertex)%type.
Definition less (x y : Q) : bool := negb (Qle_bool y x).
Definition sub (p q : vertex) : vertex := (Qred (fst p - fst q), Qred (snd p - snd q)).
Definition sg (q : Q) : Z := Z.sgn (Qnum q).
Definition qcross (u v : vertex) : Q := fst u * snd v - snd u * fst v.
(** A sign does not change when numbers are reduced. *)
Definition difference (p q : vertex) : vertex := (fst p - fst q, snd p - snd q).
Definition side (a b p : vertex) : Z := sg (qcross (difference b a) (difference p a)).

(** As [Definitions.crossing] and [winding] *)
Definition crossing_of (y : vertex) (e : edge) : Z :=
  let (a, b) := e in
  if Qle_bool (fst a) (fst y) then
    if less (fst y) (fst b) then if (side a b y <? 0)%Z then (-1)%Z else 0%Z else 0%Z
  else if Qle_bool (fst b) (fst y) then if (0 <? side a b y)%Z then 1%Z else 0%Z else 0%Z.
Definition winding_of (E : list edge) (y : vertex) : Z :=
  fold_right (fun e n => (crossing_of y e + n)%Z) 0%Z E.
(** Two intervals, given by their ends in any order, have no point in common. *)
Definition apart_on_axis (a b c d : Q) : bool :=
  if less a c then less a d && less b c && less b d
  else less c a && less c b && less d a && less d b.
(** Two segments have a point in common. *)
Definition have_common (e f : edge) : bool :=
  if apart_on_axis (fst (fst e)) (fst (snd e)) (fst (fst f)) (fst (snd f)) then false else
  if apart_on_axis (snd (fst e)) (snd (snd e)) (snd (fst f)) (snd (snd f)) then false else
  (side (fst e) (snd e) (fst f) * side (fst e) (snd e) (snd f) <=? 0)%Z &&
  (side (fst f) (snd f) (fst e) * side (fst f) (snd f) (snd e) <=? 0)%Z.
(** c is in P + Q iff P and c - Q have a point in common: edges meet, or a vertex of one is inside
    the other. *)
Definition decide_point (EP EQ : list edge) (c : vertex) : bool :=
  existsb (fun f => let g := (sub c (fst f), sub c (snd f)) in
    existsb (fun e => have_common e g) EP) EQ ||
  existsb (fun e => (0 <? winding_of EQ (sub c (fst e)))%Z) EP ||
  existsb (fun f => (0 <? winding_of EP (sub c (fst f)))%Z) EQ.
(** At a scale: of each vertex of P its multiple *)
Definition by_scale (s : Q) (v : vertex) : vertex := (Qred (s * fst v), Qred (s * snd v)).
Definition decide_membership (s : Q) (P Q : rings vertex) (x : vertex) : bool :=
  decide_point (all_edges (map (map (by_scale s)) P)) (all_edges Q) x.
