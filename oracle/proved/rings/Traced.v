(** Rings around the classes of full cells, as a program: from the end of a piece on with the first
    piece of the class counter-clockwise from the way back. The rings are tested, so that nothing
    has to be known of how they are found. *)
From Coq Require Import QArith Qreduction Bool.
From Proved Require Import Definitions Form Points Pieces Slabs.
Open Scope Q_scope.

(** ** Pieces of a class: those with its cells on their left *)
Definition holds (c : cell) (p : vertex) : bool :=
  let level e := side (fst (from_left e)) (snd (from_left e)) p in
  match from c with Some q => Qle_bool q (fst p) | None => true end &&
  match to c with Some q => Qle_bool (fst p) q | None => true end &&
  match bottom c with Some e => (0 <=? level e)%Z | None => true end &&
  match top c with Some e => (level e <=? 0)%Z | None => true end.
Definition turned_back (e : edge) : edge := (snd e, fst e).
Definition left_point (all : list edge) (e : edge) : vertex :=
  if is_before (fst e) (snd e) then fst (beside all e) else snd (beside all (turned_back e)).
Definition bounds (all : list edge) (A : list cell) (e : edge) : bool :=
  let p := left_point all e in existsb (fun c => holds c p) A.

(** ** Tracing *)
Definition back (u : vertex) : vertex := (- fst u, - snd u).
Definition half (r u : vertex) : Z := (* 0: the turn from r to u is at most half; 1: more *)
  match sg (qcross r u) with
  | 1%Z => 0%Z
  | 0%Z => if (sg (dot r u) <? 0)%Z then 0%Z else 1%Z
  | _ => 1%Z
  end.
Definition sooner (r u w : vertex) : bool :=
  (half r u <? half r w)%Z || (half r u =? half r w)%Z && (0 <? sg (qcross u w))%Z.
Fixpoint first_from (r : vertex) (l : list edge) : option edge :=
  match l with
  | [] => None
  | e :: k => match first_from r k with
              | Some f => if sooner r (dir e) (dir f) then Some e else Some f
              | None => Some e
              end
  end.
Definition next_piece (E : list edge) (e : edge) : option edge :=
  first_from (back (dir e)) (filter (fun f => same (fst f) (snd e)) E).
Fixpoint trace (fuel : nat) (E : list edge) (begin e : edge) : list edge :=
  match fuel with
  | O => [e]
  | S n => match next_piece E e with
           | Some f => if same_edge f begin then [e] else e :: trace n E begin f
           | None => [e]
           end
  end.
Fixpoint traces (fuel : nat) (E left : list edge) : list (list edge) :=
  match fuel, left with
  | S n, e :: _ =>
      let ring := trace (length E) E e e in
      ring :: traces n E (filter (fun f => negb (existsb (same_edge f) ring)) left)
  | _, _ => []
  end.

(** ** Rings from their least vertex, as rows of pieces along one line *)
Definition row := list edge.
Definition edge_of (r : row) : edge :=
  match r with [] => ((0, 0), (0, 0)) | e :: _ => (fst e, snd (last r e)) end.
Definition corners_of (ring : list row) : list vertex := map (fun r => fst (edge_of r)) ring.
Fixpoint turn_to (fuel : nat) (least : vertex) (l : list edge) : list edge :=
  match fuel, l with
  | S n, e :: r => if same (fst e) least then l else turn_to n least (r ++ [e])
  | _, _ => l
  end.
Definition from_least (l : list edge) : list edge :=
  match l with
  | [] => []
  | e :: r => turn_to (length l)
      (fold_right (fun f m => if is_before (fst f) m then fst f else m) (fst e) r) l
  end.
Fixpoint in_rows (l : list edge) : list row :=
  match l with
  | [] => []
  | e :: r => match in_rows r with
              | (f :: k) :: rows =>
                  if (sg (qcross (dir e) (dir f)) =? 0)%Z then (e :: f :: k) :: rows
                  else [e] :: (f :: k) :: rows
              | rows => [e] :: rows
              end
  end.
Definition twice_area (l : list vertex) : Q :=
  fold_right (fun e s => Qred (qcross (fst e) (snd e) + s)) 0 (ring_edges l).
Fixpoint list_le (l k : list vertex) : bool :=
  match l, k with
  | [], _ => true
  | _, [] => false
  | p :: l', q :: k' => is_before p q || same p q && list_le l' k'
  end.
(** A class, its outer rings (one), and its holes *)
Definition outlined := (list cell * (list (list row) * list (list row)))%type.
Definition outline (all B : list edge) (A : list cell) : outlined :=
  let E := filter (bounds all A) B in
  let rings := map (fun l => in_rows (from_least l)) (traces (length E) E E) in
  (A, (filter (fun r => less 0 (twice_area (corners_of r))) rings,
    sort (fun r k => list_le (corners_of r) (corners_of k))
      (filter (fun r => less (twice_area (corners_of r)) 0) rings))).
Definition outer_corners (o : outlined) : list vertex := flat_map corners_of (fst (snd o)).
Definition outlines (all B : list edge) : list outlined :=
  sort (fun o k => list_le (outer_corners o) (outer_corners k)) (map (outline all B)
    (parts B true)).

(** ** The test *)
Fixpoint each_pair {A} (test : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | x :: r => forallb (test x) r && each_pair test r end.
Definition exact_number (x y : Q) : bool := (Qnum x =? Qnum y)%Z && (Qden x =? Qden y)%positive.
Definition exact_vertex (p q : vertex) : bool :=
  exact_number (fst p) (fst q) && exact_number (snd p) (snd q).
Definition exact_edge (e f : edge) : bool :=
  exact_vertex (fst e) (fst f) && exact_vertex (snd e) (snd f).
Definition goes_on (e f : edge) : bool :=
  same (snd e) (fst f) && (sg (qcross (dir e) (dir f)) =? 0)%Z && (0 <? sg (dot (dir e) (dir f)))%Z.
Fixpoint is_straight (r : row) : bool :=
  match r with
  | [] => false
  | e :: k => match k with f :: _ => goes_on e f && is_straight k | [] => true end
  end.
Definition bends (r k : row) : bool :=
  same (snd (edge_of r)) (fst (edge_of k)) &&
  negb (sg (qcross (dir (edge_of r)) (dir (edge_of k))) =? 0)%Z.
Definition is_closed_ring (ring : list row) : bool :=
  match ring with [] => false | _ => true end && forallb is_straight ring &&
  forallb (fun p => bends (fst p) (snd p)) (ring_edges ring) &&
  each_pair (fun e f => negb (same (snd e) (snd f))) (concat ring).
Definition begins_least (ring : list row) : bool :=
  match corners_of ring with [] => false | p :: r => forallb (is_before p) r end.
Fixpoint list_less (l k : list vertex) : bool :=
  match l, k with
  | _, [] => false
  | [], _ :: _ => true
  | p :: l', q :: k' => is_before p q || same p q && list_less l' k'
  end.
Fixpoint ascending {A} (test : A -> A -> bool) (l : list A) : bool :=
  match l with
  | x :: r => match r with y :: _ => test x y && ascending test r | [] => true end
  | [] => true
  end.
Definition rings_of_outline (o : outlined) : list (list row) := fst (snd o) ++ snd (snd o).
Definition is_outline (all : list edge) (o : outlined) : bool :=
  match fst (snd o) with [r] => less 0 (twice_area (corners_of r)) | _ => false end &&
  forallb (fun r => less (twice_area (corners_of r)) 0) (snd (snd o)) &&
  forallb (fun r => is_closed_ring r && begins_least r) (rings_of_outline o) &&
  forallb (bounds all (fst o)) (concat (concat (rings_of_outline o))) &&
  ascending (fun r k => list_less (corners_of r) (corners_of k)) (snd (snd o)).
Definition all_pieces (os : list outlined) : list edge :=
  concat (concat (flat_map rings_of_outline os)).
Definition are_outlines (all B : list edge) (os : list outlined) : bool :=
  forallb (is_outline all) os &&
  each_pair (fun e f => negb (same_edge e f) && negb (same_edge e (turned_back f)))
    (all_pieces os) &&
  forallb (fun e => existsb (exact_edge e) B) (all_pieces os) &&
  forallb (fun e => existsb (exact_edge e) (all_pieces os)) B &&
  ascending (fun o k => list_less (outer_corners o) (outer_corners k)) os.

(** ** A set of which a program tells the points off some segments, in canonical form, and how many
    holes it has; None: what was traced is no form. *)
Definition polygon_of (o : outlined) : polygon vertex :=
  (outer_corners o, map corners_of (snd (snd o))).
Definition traced_set (is_in : vertex -> bool) (all : list edge) :
    option (list (polygon vertex) * nat) :=
  let B := boundary is_in all in
  let os := outlines all B in
  if are_outlines all B os then Some (map polygon_of os, pred (length (parts B false))) else None.
Definition exact_sum (s : Q) (P K : rings vertex) : option (list (polygon vertex) * nat) :=
  let E := all_edges (map (map (by_scale s)) P) in let F := all_edges K in
  traced_set (decide_point E F) (convolution E F).
