(** A program that tests two sets, and answers of points whether they are in the sum; or says that
    it does not take the sets. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions Points.
Open Scope Q_scope.
Definition is_vertical (e : edge) : bool := Qeq_bool (fst (fst e)) (fst (snd e)).
Definition is_level (e : edge) : bool := Qeq_bool (snd (fst e)) (snd (snd e)).
Definition smaller (x y : Q) : Q := if Qle_bool x y then x else y.
Definition greater (x y : Q) : Q := if Qle_bool x y then y else x.
(** Two intervals, given by their ends in any order, have no more than a point in common. *)
Definition touch_on_axis (a b c d : Q) : bool :=
  Qle_bool (smaller (greater a b) (greater c d)) (greater (smaller a b) (smaller c d)).
(** Two segments of some length have no more than a point in common. *)
Definition touch_at_most (e f : edge) : bool :=
  let (a, b) := e in let (c, d) := f in
  negb (Qeq_bool (qcross (sub b a) (sub d c)) 0) || negb (side a b c =? 0)%Z ||
  negb (is_vertical e) && touch_on_axis (fst a) (fst b) (fst c) (fst d) ||
  negb (is_level e) && touch_on_axis (snd a) (snd b) (snd c) (snd d).
Fixpoint all_pairs {A} (test : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | e :: r => forallb (test e) r && all_pairs test r end.

(** Between two abscissas: edges from wall to wall *)
Definition spans (x0 x1 : Q) (e : edge) : bool :=
  less (fst (fst e)) (fst (snd e)) && Qle_bool (fst (fst e)) x0 && Qle_bool x1 (fst (snd e)) ||
  less (fst (snd e)) (fst (fst e)) && Qle_bool (fst (snd e)) x0 && Qle_bool x1 (fst (fst e)).
Definition is_beside (x0 x1 : Q) (e : edge) : bool :=
  Qle_bool (fst (fst e)) x0 && Qle_bool (fst (snd e)) x0 ||
  Qle_bool x1 (fst (fst e)) && Qle_bool x1 (fst (snd e)).
Definition height_at (x : Q) (e : edge) : Q :=
  let (a, b) := e in
  Qred (snd a + (x - fst a) * (snd b - snd a) / (fst b - fst a)).
Definition heights (x0 x1 : Q) (e : edge) : edge * (Q * Q) := (e, (height_at x0 e, height_at x1 e)).
Definition middle_of (e : edge * (Q * Q)) : Q := fst (snd e) + snd (snd e).
(** One is above the other from wall to wall, but for one end. *)
Definition are_ordered (e f : edge * (Q * Q)) : bool :=
  let d0 := fst (snd e) - fst (snd f) in let d1 := snd (snd e) - snd (snd f) in
  Qle_bool 0 (d0 * d1) && negb (Qeq_bool (d0 + d1) 0).
Definition turn_of (e : edge) : Z := if less (fst (snd e)) (fst (fst e)) then 1%Z else (-1)%Z.
Definition turns_above (e : edge * (Q * Q)) (S : list (edge * (Q * Q))) : Z :=
  fold_right (fun f n => ((if less (middle_of e) (middle_of f) then turn_of (fst f) else 0) + n)%Z)
    0%Z S.
(** From above the edges run left and right in turn. *)
Definition alternate (x0 x1 : Q) (E : list edge) : bool :=
  let S := map (heights x0 x1) (filter (spans x0 x1) E) in
  forallb (fun e => spans x0 x1 e || is_beside x0 x1 e) E &&
  all_pairs are_ordered S &&
  forallb (fun e => (turns_above e S =? if (turn_of (fst e) =? 1)%Z then 0 else 1)%Z) S.
Fixpoint ascending (x : Q) (l : list Q) : list Q := (* x put into l *)
  match l with
  | [] => [x]
  | y :: r => if less x y then x :: l else if Qeq_bool x y then l else y :: ascending x r
  end.
Definition abscissas (E : list edge) : list Q := fold_right (fun e => ascending (fst (fst e))) [] E.
Definition within_walls (l h : Q) (e : edge) : bool :=
  Qle_bool l (fst (fst e)) && Qle_bool (fst (fst e)) h &&
  Qle_bool l (fst (snd e)) && Qle_bool (fst (snd e)) h.
Definition wind_once (E : list edge) : bool :=
  match abscissas E with
  | [] => match E with [] => true | _ => false end
  | x :: r => forallb (within_walls x (last r x)) E &&
      forallb (fun w => alternate (fst w) (snd w) E) (combine (x :: r) r)
  end.
Definition is_null (e : edge) : bool := is_vertical e && is_level e.
Definition is_set (r : rings vertex) : bool :=
  let E := all_edges r in
  forallb (fun ring => 3 <=? length ring)%nat r && forallb (fun e => negb (is_null e)) E &&
  all_pairs touch_at_most E && wind_once E.
Definition is_taken (r : rings vertex) : bool :=
  match r with [[_]] => true | [[a; b]] => negb (is_null (a, b)) | _ => is_set r end.
(** Of each point whether it is in s P + Q; None: these sets are not taken *)
Definition decide_points (s : Q) (P K : rings vertex) (xs : list vertex) : option (list bool) :=
  if less 0 s && is_taken P && is_taken K then Some (map (decide_membership s P K) xs) else None.
