(** Step `clear` of docs/certificates-paths.md: at none of the scales a place of a path collides. A
    cell is a list of bounds, linear functions of t and s, at the places p(s) + t d. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components.
Open Scope R_scope.

#[local] Instance anywhere : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.

(** ** The program *)
(** of_t t + of_s s + rest is not negative, or is positive. *)
Record bound := { of_t : number; of_s : number; rest : number; is_strict : bool }.
Definition bounds_of (i : scales) : list bound :=
  {| of_t := zero; of_s := one; rest := Fixed (- low i);
     is_strict := negb (low_in i) || Qle_bool (low i) 0 |} ::
  match high i with
  | None => []
  | Some b => [{| of_t := zero; of_s := Fixed (-1); rest := Fixed b;
                  is_strict := negb (high_in i) |}]
  end.
(** Multiples of bounds that add up to 0 > 0, or to a negative number *)
Fixpoint total (ms : list Q) (cell : list bound) : bound :=
  match ms, cell with
  | m :: ms', b :: cell' =>
      let sum := total ms' cell' in
      if Qeq_bool m 0 then sum
      else
        let plus (f : bound -> number) := reduced (nplus (ntimes (Fixed m) (f b)) (f sum)) in
        {| of_t := plus of_t; of_s := plus of_s; rest := plus rest;
           is_strict := is_strict b || is_strict sum |}
  | _, _ => {| of_t := zero; of_s := zero; rest := zero; is_strict := false |}
  end.
Definition is_contradiction (ms : list Q) (cell : list bound) : bool :=
  forallb (Qle_bool 0) ms &&
  let sum := total ms cell in
  equal (of_t sum) zero && equal (of_s sum) zero &&
  (lt (rest sum) zero || (is_strict sum && le (rest sum) zero)).

(** A place that moves, start + s speed; and what is t d beyond it, 0 <= t <= length + s growth *)
Definition moving_place := (corner * corner)%type.
Record leg := { direction : corner; length_ : number; growth : number }.
(** f of a normal n, with the hulls of a and b: where it is positive n holds them apart. *)
Definition opposite (n : corner) : corner := (nminus zero (fst n), nminus zero (snd n)).
Definition level (p : moving_place) (d n : corner) (a b : node) : bound :=
  {| of_t := reduced (qdot n d);
     of_s := reduced (nminus (qdot n (snd p)) (support (opposite n) (hull_of a)));
     rest := reduced (nminus (qdot n (fst p)) (support n (hull_of b))); is_strict := false |}.
Definition negative (b : bound) (strictly : bool) : bound :=
  {| of_t := nminus zero (of_t b); of_s := nminus zero (of_s b); rest := nminus zero (rest b);
     is_strict := strictly |}.

(** Takes a cell and two nodes off a stack. A normal leaves the part of the cell where it does not
    hold the nodes apart. *)
Inductive step := OpenPart | OpenObstacles | CutAt (t : Q) | Across (n : corner)
| NothingLeft (ms : list Q).
Definition is_allowed (c : touch) : bool := match c with Allowed => true | Forbidden => false end.
Definition beyond (t : Q) : bound :=
  {| of_t := one; of_s := zero; rest := Fixed (- t); is_strict := false |}.
Fixpoint follow_ways (c : touch) (p : moving_place) (d : corner) (code : list step)
    (stack : list (list bound * node * node)) : bool :=
  match code, stack with
  | [], [] => true
  | OpenPart :: r, (cell, Group _ k, b) :: more =>
      follow_ways c p d r (map (fun a => (cell, a, b)) k ++ more)
  | OpenObstacles :: r, (cell, a, Group _ k) :: more =>
      follow_ways c p d r (map (fun b => (cell, a, b)) k ++ more)
  | CutAt t :: r, (cell, a, b) :: more =>
      follow_ways c p d r
        ((negative (beyond t) false :: cell, a, b) :: (beyond t :: cell, a, b) :: more)
  | Across n :: r, (cell, a, b) :: more =>
      distinct n (zero, zero) && follow_ways c p d r
        ((negative (level p d n a b) (is_allowed c) :: cell, a, b) :: more)
  | NothingLeft ms :: r, (cell, _, _) :: more =>
      is_contradiction ms cell && follow_ways c p d r more
  | _, _ => false
  end.

(** A function of s is positive, or not negative, at all of the scales: at both ends, or at the
    first with its growth *)
Definition at_one (slope rest s : number) : number := reduced (nplus (ntimes slope s) rest).
Definition is_positive_on (i : scales) (strictly : bool) (slope rest : number) : bool :=
  let first := at_one slope rest (Fixed (low i)) in
  let last := match high i with None => slope | Some b => at_one slope rest (Fixed b) end in
  le zero first && le zero last &&
  (negb strictly ||
    (lt zero first || (lt zero last && (negb (low_in i) || Qle_bool (low i) 0))) &&
    (lt zero last || match high i with None => true | Some _ => negb (high_in i) end)).

(** A segment of places that move, from p to q *)
Definition starting_cell (i : scales) (l : leg) : list bound :=
  {| of_t := one; of_s := zero; rest := zero; is_strict := false |} ::
  {| of_t := Fixed (-1); of_s := growth l; rest := length_ l; is_strict := false |} :: bounds_of i.
Definition check_leg (c : touch) (i : scales) (part obstacles : node)
    (e : moving_place * moving_place) (l : leg * list step) : bool :=
  let '(p, q) := e in let '(l, code) := l in
  let along (f : moving_place -> corner) (by_ : number) :=
    same (f q) (qadd (f p) (ntimes by_ (fst (direction l)), ntimes by_ (snd (direction l)))) in
  along fst (length_ l) && along snd (growth l) &&
  is_positive_on i false (growth l) (length_ l) &&
  follow_ways c p (direction l) code [(starting_cell i l, part, obstacles)].

(** The part and the obstacles as pieces. With contact allowed both have an inside. *)
Definition check_sides (c : touch) (r o : rings corner) (of_r of_o : tiled) : bool :=
  check_operand one r of_r && check_operand one o of_o &&
  negb (is_allowed c && (thin r || thin o)).
Definition check_clear (c : touch) (i : scales) (r o : rings corner) (of_r of_o : tiled)
    (places : list moving_place) (legs : list (leg * list step)) : bool :=
  match places with [] => false | _ => true end && (is_empty r || is_empty o ||
  check_sides c r o of_r of_o &&
  all2 (check_leg c i (root of_r) (root of_o)) (segments_of places) legs).
Definition stays (v : vertex) : moving_place := (fixed v, (zero, zero)).
Definition check_free (c : touch) (i : scales) (r o : rings vertex) (path : list vertex)
    (of_r of_o : tiled) (legs : list (leg * list step)) : bool :=
  check_clear c i (fixed_rings r) (fixed_rings o) of_r of_o (map stays path) legs.
