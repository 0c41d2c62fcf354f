(** The sum of two operands as a program: no pieces of the operands, no certificate. Each test of a
    point is [decide_point], which is proved right for the sets that are taken (Tested.v); what goes
    on between these tests is not proved yet.
    1. the segments of the convolution; 2. cut where they meet; 3. a piece is kept if the sum is on
    one side of it and not on the other; 4. slabs between the ends of what is kept, cells, classes
    of cells; 5. rings of each class; 6. canonical form. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions Form Points Taken.
Open Scope Q_scope.

(** ** Vectors *)
Definition vplus (p q : vertex) : vertex := (Qred (fst p + fst q), Qred (snd p + snd q)).
Definition vdot (u v : vertex) : Q := fst u * fst v + snd u * snd v.
Definition back (u : vertex) : vertex := (- fst u, - snd u).
Definition same_point (p q : vertex) : bool := Qeq_bool (fst p) (fst q) && Qeq_bool (snd p) (snd q).
Definition earlier (p q : vertex) : bool := (* by x, then y *)
  less (fst p) (fst q) || Qeq_bool (fst p) (fst q) && less (snd p) (snd q).
Definition not_later (p q : vertex) : bool := negb (earlier q p).
Definition direction (e : edge) : vertex := sub (snd e) (fst e).
Definition is_same (e f : edge) : bool := same_point (fst e) (fst f) && same_point (snd e) (snd f).
Definition by_ends (e f : edge) : bool :=
  earlier (fst e) (fst f) || same_point (fst e) (fst f) && not_later (snd e) (snd f).

(** ** Lists, sorted by any test *)
Section Sort.
Context {A : Type} (le : A -> A -> bool).
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
  | _, [] => [] | _, [l] => l | O, _ => concat ls
  | S n, _ => merge_all n (merge_pairs ls)
  end.
Definition sort (l : list A) : list A := merge_all (length l) (map (fun x => [x]) l).
Fixpoint one_of_equals (l : list A) : list A := (* of what is sorted *)
  match l with
  | x :: r => match r with
              | y :: _ => if le y x then one_of_equals r else x :: one_of_equals r
              | [] => [x]
              end
  | [] => []
  end.
Definition sorted_once (l : list A) : list A := one_of_equals (sort l).
End Sort.

(** ** 1. The convolution: each edge at each vertex of the other operand. [reduce] leaves out
    vertices that are reflex, and those in whose turn the edge does not lie, with closed ends. *)
Definition in_turn (d : vertex) (corner : edge * edge) : bool :=
  let i := direction (fst corner) in let o := direction (snd corner) in
  (0 <=? sg (qcross i o))%Z && (0 <=? sg (qcross i d))%Z && (0 <=? sg (qcross d o))%Z.
Definition turns_at (r : rings vertex) : list (edge * edge) :=
  flat_map (fun ring => ring_edges (ring_edges ring)) r.
Definition upward (e : edge) : edge := if earlier (fst e) (snd e) then e else (snd e, fst e).
Definition edges_at (reduce : bool) (E : list edge) (C : list (edge * edge)) : list edge :=
  flat_map (fun e => let d := direction e in
    flat_map (fun c => if negb reduce || in_turn d c then
      let v := snd (fst c) in [upward (vplus (fst e) v, vplus (snd e) v)] else []) C) E.
Definition convolution (reduce : bool) (P K : rings vertex) : list edge :=
  sorted_once by_ends (filter (fun e => negb (is_null e))
    (edges_at reduce (all_edges P) (turns_at K) ++ edges_at reduce (all_edges K) (turns_at P))).

(** ** 2. Pieces: each segment, cut at its common points with all others *)
Definition is_past (e f : edge) : bool := (* both upward *)
  less (fst (snd e)) (fst (fst f)) || less (fst (snd f)) (fst (fst e)).
Definition is_on (e : edge) (p : vertex) : bool :=
  (side (fst e) (snd e) p =? 0)%Z && not_later (fst e) p && not_later p (snd e).
Definition meeting (e f : edge) : list vertex :=
  if is_past e f then [] else
  let d := direction e in let k := direction f in
  let n := Qred (qcross d k) in
  if Qeq_bool n 0 then filter (is_on e) [fst f; snd f]
  else
    let w := sub (fst f) (fst e) in
    let t := Qred (qcross w k / n) in let u := Qred (qcross w d / n) in
    if less t 0 || less 1 t || less u 0 || less 1 u then []
    else [vplus (fst e) (by_scale t d)].
Definition cut (all : list edge) (e : edge) : list edge :=
  let ps := sorted_once not_later (fst e :: snd e :: flat_map (meeting e) all) in
  combine ps (tl ps).
Definition pieces (all : list edge) : list edge := sorted_once by_ends (flat_map (cut all) all).

(** ** 3. Points beside the middle of a piece, so near that no segment lies between *)
Definition least_above_zero (l : list Q) : Q :=
  fold_right (fun x m => if less 0 x then smaller x m else m) 1 l.
Definition rises (all : list edge) (m : vertex) : list Q := (* from m upwards *)
  flat_map (fun e : edge => let (a, b) := e in
    if less (fst m) (fst a) || less (fst b) (fst m) then []
    else if Qeq_bool (fst a) (fst b) then [Qred (snd a - snd m); Qred (snd b - snd m)]
    else [Qred (snd a - snd m + (fst m - fst a) * (snd b - snd a) / (fst b - fst a))]) all.
Definition mirrored (e : edge) : edge := (* x and y change places *)
  upward ((snd (fst e), fst (fst e)), (snd (snd e), fst (snd e))).
Definition middle (e : edge) : vertex :=
  (Qred ((fst (fst e) + fst (snd e)) / 2), Qred ((snd (fst e) + snd (snd e)) / 2)).
Definition beside (all mirror : list edge) (e : edge) : vertex * vertex := (* left, right *)
  let m := middle e in
  let k := if is_vertical e then rises mirror (snd m, fst m) else rises all m in
  let up := Qred (least_above_zero k / 2) in
  let down := Qred (least_above_zero (map Qopp k) / 2) in
  if is_vertical e then ((Qred (fst m - down), snd m), (Qred (fst m + up), snd m))
  else ((fst m, Qred (snd m + up)), (fst m, Qred (snd m - down))).
(** What is kept has the sum on its left. *)
Definition boundary_of (EP EQ all : list edge) : list edge :=
  let mirror := map mirrored all in
  flat_map (fun e : edge => let (l, r) := beside all mirror e in
    match decide_point EP EQ l, decide_point EP EQ r with
    | true, false => [e] | false, true => [(snd e, fst e)] | _, _ => []
    end) (pieces all).

(** ** 4. Slabs between the ends, cells from piece to piece; None: no end *)
Record slab_cell :=
  { starts : option Q; stops : option Q; floor : option edge; roof : option edge }.
Definition goes_right (e : edge) : bool := less (fst (fst e)) (fst (snd e)).
Definition height (x : Q) (e : edge) : Q :=
  let (a, b) := e in
  if Qeq_bool x (fst a) then snd a else if Qeq_bool x (fst b) then snd b else
  Qred (snd a + (x - fst a) * (snd b - snd a) / (fst b - fst a)).
Fixpoint stack (x0 x1 : Q) (below : option edge) (l : list edge) : list slab_cell :=
  let cell_to up := {| starts := Some x0; stops := Some x1; floor := below; roof := up |} in
  match l with
  | [] => [cell_to None]
  | e :: r => cell_to (Some e) :: stack x0 x1 (Some e) r
  end.
Definition slab (B : list edge) (x0 x1 : Q) : list slab_cell :=
  let m := Qred ((x0 + x1) / 2) in
  let l := map (fun e => (height m e, e)) (filter (spans x0 x1) B) in
  stack x0 x1 None (map snd (sort (fun p q => Qle_bool (fst p) (fst q)) l)).
Definition slabs (B : list edge) : list (list slab_cell) :=
  let xs := sorted_once Qle_bool (map (fun e => fst (fst e)) B) in
  [{| starts := None; stops := hd_error xs; floor := None; roof := None |}] ::
  map (fun p => slab B (fst p) (snd p)) (combine xs (tl xs)) ++
  [[{| starts := hd_error (rev xs); stops := None; floor := None; roof := None |}]].
Definition is_full (c : slab_cell) : bool :=
  match floor c with Some e => goes_right e | None => false end.
(** Cells of one kind on both sides of the wall at x share a length of it. *)
Definition below_roof (x : Q) (c d : slab_cell) : bool :=
  match floor c, roof d with Some e, Some f => less (height x e) (height x f) | _, _ => true end.
Definition share_wall (x : Q) (c d : slab_cell) : bool :=
  Bool.eqb (is_full c) (is_full d) && below_roof x c d && below_roof x d c &&
  below_roof x c c && below_roof x d d.
Fixpoint numbered (n : nat) (ls : list (list slab_cell)) : list (list (nat * slab_cell)) :=
  match ls with
  | [] => []
  | l :: r => combine (seq n (length l)) l :: numbered (n + length l) r
  end.
Definition shared_walls (ls : list (list (nat * slab_cell))) : list (nat * nat) :=
  flat_map (fun p => flat_map (fun c => match stops (snd c) with
      | Some x => flat_map (fun d =>
          if share_wall x (snd c) (snd d) then [(fst c, fst d)] else []) (snd p)
      | None => [] end) (fst p)) (combine ls (tl ls)).
(** Each cell with its label: a shared wall makes two labels one. *)
Definition labelled := (nat * (nat * slab_cell))%type.
Definition label_of (n : nat) (l : list labelled) : nat :=
  match find (fun p => Nat.eqb (fst (snd p)) n) l with Some p => fst p | None => n end.
Definition merged (l : list labelled) (k : nat * nat) : list labelled :=
  let a := label_of (fst k) l in let b := label_of (snd k) l in
  if Nat.eqb a b then l else map (fun p => if Nat.eqb (fst p) b then (a, snd p) else p) l.
Definition classes_of (ls : list (list slab_cell)) : list labelled :=
  let ns := numbered 0 ls in
  fold_left merged (shared_walls ns) (map (fun c => (fst c, c)) (concat ns)).
Fixpoint numbers_once (l : list nat) : list nat :=
  match l with
  | [] => []
  | x :: r => if existsb (Nat.eqb x) r then numbers_once r else x :: numbers_once r
  end.
Definition is_wall_of (e : edge) (c : slab_cell) : bool := (* full, and on the left of e *)
  is_full c &&
  if is_vertical e then
    let (a, b) := e in
    let up := earlier a b in
    match (if up then stops c else starts c), floor c, roof c with
    | Some x, Some f, Some g => Qeq_bool x (fst a) &&
        Qle_bool (height x f) (snd (if up then a else b)) &&
        Qle_bool (snd (if up then b else a)) (height x g)
    | _, _, _ => false
    end
  else match (if goes_right e then floor c else roof c) with
       | Some f => is_same e f | None => false end.
Definition class_at (cs : list labelled) (e : edge) : option nat :=
  match find (fun p => is_wall_of e (snd (snd p))) cs with
  | Some p => Some (fst p) | None => None
  end.

(** ** 5. Rings: on with the first edge of the class counter-clockwise from the way back *)
Definition half_of (r u : vertex) : Z := (* 0: the turn from r to u is at most half; 1: more *)
  match sg (qcross r u) with
  | 1%Z => 0%Z | 0%Z => if (sg (vdot r u) <? 0)%Z then 0%Z else 1%Z | _ => 1%Z
  end.
Definition turns_sooner (r u w : vertex) : bool :=
  (half_of r u <? half_of r w)%Z || (half_of r u =? half_of r w)%Z && (0 <? sg (qcross u w))%Z.
Fixpoint first_turn (r : vertex) (l : list edge) : option edge :=
  match l with
  | [] => None
  | e :: k => match first_turn r k with
              | Some f => if turns_sooner r (direction e) (direction f) then Some e else Some f
              | None => Some e
              end
  end.
Definition next_edge (E : list edge) (e : edge) : option edge :=
  first_turn (back (direction e)) (filter (fun f => same_point (fst f) (snd e)) E).
Fixpoint trace (fuel : nat) (E : list edge) (start e : edge) : list edge :=
  match fuel with
  | O => [e]
  | S n => match next_edge E e with
           | Some f => if is_same f start then [e] else e :: trace n E start f
           | None => [e]
           end
  end.
Fixpoint traces (fuel : nat) (E left : list edge) : list (list edge) :=
  match fuel, left with
  | S n, e :: _ =>
      let ring := trace (length E) E e e in
      ring :: traces n E (filter (fun f => negb (existsb (is_same f) ring)) left)
  | _, _ => []
  end.

(** ** 6. Canonical form *)
Definition bends (ring : list edge) : list vertex :=
  flat_map (fun p => if (sg (qcross (direction (fst p)) (direction (snd p))) =? 0)%Z then []
    else [fst (snd p)]) (ring_edges ring).
Fixpoint turned_to (fuel : nat) (least : vertex) (l : list vertex) : list vertex :=
  match fuel, l with
  | S n, p :: r => if same_point p least then l else turned_to n least (r ++ [p])
  | _, _ => l
  end.
Definition from_least (l : list vertex) : list vertex :=
  match l with
  | [] => []
  | p :: r => turned_to (length l) (fold_right (fun q m => if earlier q m then q else m) p r) l
  end.
Definition area_of (l : list vertex) : Q :=
  fold_right (fun e s => Qred (qcross (fst e) (snd e) + s)) 0 (ring_edges l).
Fixpoint ring_not_later (l k : list vertex) : bool :=
  match l, k with
  | [], _ => true | _, [] => false
  | p :: l', q :: k' => earlier p q || same_point p q && ring_not_later l' k'
  end.
Definition polygon_of (r : rings vertex) : polygon vertex :=
  (concat (filter (fun l => less 0 (area_of l)) r),
   sort ring_not_later (filter (fun l => less (area_of l) 0) r)).
(** The polygons that a boundary is of, and how many holes *)
Definition outline_of (B : list edge) : list (polygon vertex) * nat :=
  let cs := classes_of (slabs B) in
  let labels full := numbers_once (map fst (filter (fun p => Bool.eqb (is_full (snd (snd p))) full)
    cs)) in
  let tagged := map (fun e => (class_at cs e, e)) B in
  let polygons := map (fun k =>
    let E := map snd (filter (fun p =>
      match fst p with Some n => Nat.eqb n k | None => false end) tagged) in
    polygon_of (map (fun r => from_least (bends r)) (traces (length E) E E))) (labels true) in
  (sort (fun p q => ring_not_later (fst p) (fst q)) polygons, (length (labels false) - 1)%nat).
(** s P + Q; None: these sets are not taken *)
Definition program_of_sums (reduce : bool) (s : Q) (P K : rings vertex) :
    option (list (polygon vertex) * nat) :=
  if less 0 s && is_taken P && is_taken K then
    let scaled := map (map (by_scale s)) P in
    Some (match P, K with
          | [], _ | _, [] => ([], 0%nat)
          | _, _ => outline_of (boundary_of (all_edges scaled) (all_edges K)
              (convolution reduce scaled K))
          end)
  else None.
