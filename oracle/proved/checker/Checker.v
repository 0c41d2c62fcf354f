(** The checker: a program on numbers that are rational, or move with the scale. It decides by the
    witness w whether R is sP + Q, and looks for nothing itself. That it is right is proved in
    Theorems.v and those that follow it; nothing is assumed of w. Each part names the rule of
    docs/certificates.md that it checks. *)
From Coq Require Import Bool Mergesort Orders.
From Proved Require Export Numbers.
From Proved Require Import Definitions Form Fans.
Open Scope Q_scope.
Open Scope number_scope.

Definition corner := (number * number)%type.
Definition qorient (a b p : corner) : number :=
  (fst b - fst a) * (snd p - snd a) - (snd b - snd a) * (fst p - fst a).
Definition qdot (n p : corner) : number := fst n * fst p + snd n * snd p.
Definition qadd (p q : corner) : corner := (fst p + fst q, snd p + snd q).
Definition qminus (p q : corner) : corner := (fst p - fst q, snd p - snd q).
Definition scaled (s : number) (p : corner) : corner := (reduced (s * fst p), reduced (s * snd p)).
Definition same (a b : corner) : bool := equal (fst a) (fst b) && equal (snd a) (snd b).
Definition distinct (a b : corner) : bool := differ (fst a) (fst b) || differ (snd a) (snd b).

Fixpoint all2 {A B} (f : A -> B -> bool) (l : list A) (k : list B) : bool :=
  match l, k with
  | [], [] => true
  | x :: l', y :: k' => f x y && all2 f l' k'
  | _, _ => false
  end.

(** ** Convex bodies: points, segments, and polygons whose fan of triangles turns left *)
Definition is_polygon (l : list corner) : bool :=
  match l with
  | _ :: _ :: _ :: _ => forallb (fun t => let '(a, b, c) := t in lt zero (qorient a b c)) (fan_of l)
  | _ => false
  end.
Definition is_body (l : list corner) : bool :=
  match l with [_] | [_; _] => true | _ => is_polygon l end.

Definition between (x a b : number) : bool :=
  (le a x && le x b) || (le b x && le x a).
Definition is_left (l : list corner) (p : corner) : bool :=
  forallb (fun e => le zero (qorient (fst e) (snd e) p)) (ring_edges l).
Definition holds (l : list corner) (p : corner) : bool :=
  match l with
  | [a] => same a p
  | [a; b] => equal zero (qorient a b p) && between (fst p) (fst a) (fst b)
              && between (snd p) (snd a) (snd b)
  | _ => is_left l p
  end.

(** The largest value of n on vertices *)
Definition support (n : corner) (l : list corner) : number :=
  match l with
  | [] => zero
  | p :: r => fold_right (fun v m => greater_of (qdot n v) m) (qdot n p) r
  end.

(** ** Edges that cancel: on each line, each point is the start of as many as it is the end of.
    A key is a point of a line, by its abscissa; keys are sorted by their codes. *)
Record key := { code : list Z; slope : number; offset : number; abscissa : number }.
Definition code_of (a : number) : list Z :=
  flat_map (fun q => [Qnum q; Z.pos (Qden q)]) (coefficients_of a).
Definition key_of (m c x : number) : key :=
  {| code := code_of m ++ code_of c ++ code_of x; slope := m; offset := c; abscissa := x |}.
(** The keys of an edge's ends; vertical edges are crossed by no vertical ray. *)
Definition keys (e : corner * corner) : option (list (key * key)) :=
  let '(a, b) := e in
  if equal (fst a) (fst b) then Some []
  else
    let m := over (snd b - snd a) (fst b - fst a) in
    let c := reduced (snd a - m * fst a) in
    if differ (fst a) (fst b) && equal (snd b) (m * fst b + c) then
      Some [(key_of m c (reduced (fst a)), key_of m c (reduced (fst b)))]
    else None.
Fixpoint all_keys (E : list (corner * corner)) : option (list (key * key)) :=
  match E with
  | [] => Some []
  | e :: r =>
      match keys e, all_keys r with Some k, Some l => Some (k ++ l) | _, _ => None end
  end.

Fixpoint comes_before (l k : list Z) : bool :=
  match l, k with
  | [], _ => true
  | _ :: _, [] => false
  | x :: l', y :: k' =>
      match Z.compare x y with Lt => true | Gt => false | Eq => comes_before l' k' end
  end.
Lemma comes_before_total : forall a b, comes_before a b = true \/ comes_before b a = true.
Proof.
  induction a as [|x a IH]; intros [|y b]; simpl; auto.
  rewrite (Z.compare_antisym x y). destruct (Z.compare x y); simpl; auto.
Qed.
Module Keys <: TotalLeBool.
  Definition t := key.
  Definition leb a b := comes_before (code a) (code b).
  Definition leb_total a b := comes_before_total (code a) (code b).
End Keys.
Module KeySort := Sort Keys.
Definition same_key (k l : key) : bool :=
  equal (slope k) (slope l) && equal (offset k) (offset l) && equal (abscissa k) (abscissa l).
Definition same_boundary (E F : list (corner * corner)) : bool :=
  match all_keys E, all_keys F with
  | Some e, Some f => all2 same_key (KeySort.sort (map fst e ++ map snd f))
                                    (KeySort.sort (map snd e ++ map fst f))
  | _, _ => false
  end.

(** ** Operands: rule `pieces`. Hulls of groups are given. *)
Inductive node := Piece (v : list corner) | Group (hull : list corner) (members : list node).
Definition hull_of (n : node) : list corner := match n with Piece v => v | Group h _ => h end.
Fixpoint leaves (n : node) : list (list corner) :=
  match n with Piece v => [v] | Group _ k => flat_map leaves k end.
Fixpoint is_tree (n : node) : bool :=
  match n with
  | Piece v => is_body v
  | Group h k => is_body h && forallb (fun c => is_tree c && forallb (holds h) (hull_of c)) k
  end.

Record tiled := { root : node; solids : list (list corner * list nat) }.

Fixpoint pick (l : list (list corner)) (ns : list nat) : option (list (list corner)) :=
  match ns with
  | [] => Some []
  | n :: r =>
      match nth_error l n, pick l r with Some v, Some k => Some (v :: k) | _, _ => None end
  end.
(** A solid is a leaf, or a polygon that is tiled by leaves. *)
Definition is_solid (ps : list (list corner)) (solid : list corner * list nat) : bool :=
  match pick ps (snd solid) with
  | None => false
  | Some [l] => is_body (fst solid) && all2 same (fst solid) l
  | Some k => is_polygon (fst solid) && forallb is_polygon k &&
              same_boundary (ring_edges (fst solid)) (flat_map ring_edges k)
  end.

Definition thin {A} (r : rings A) : bool := match r with [[_]] | [[_; _]] => true | _ => false end.
Definition no_null (E : list (corner * corner)) : bool :=
  forallb (fun e => distinct (fst e) (snd e)) E.
(** The tree o holds s times the set of the rings r. *)
Definition check_operand (s : number) (r : rings corner) (o : tiled) : bool :=
  is_tree (root o) && forallb (is_solid (leaves (root o))) (solids o) &&
  let k := map (map (scaled s)) r in
  if thin r then all2 (all2 same) k (leaves (root o))
  else forallb is_polygon (leaves (root o)) && no_null (all_edges k) &&
       same_boundary (all_edges k) (flat_map ring_edges (leaves (root o))).

(** ** Cells: rule `eq`, with its proofs `cov` and `sep` *)
Inductive token := OpenP | OpenQ | Normal (n : corner).
(** Takes pairs of nodes off a stack: a normal answers for all pieces below the pair on top. *)
Fixpoint follow_with (answers : corner -> node -> node -> bool) (code : list token)
    (stack : list (node * node)) : bool :=
  match code, stack with
  | [], [] => true
  | OpenP :: r, (Group _ k, b) :: rest => follow_with answers r (map (fun c => (c, b)) k ++ rest)
  | OpenQ :: r, (a, Group _ k) :: rest => follow_with answers r (map (fun c => (a, c)) k ++ rest)
  | Normal n :: r, (a, b) :: rest => answers n a b && follow_with answers r rest
  | _, _ => false
  end.
Definition farthest (n : corner) (a b : node) : number :=
  support n (hull_of a) + support n (hull_of b).
Definition separates (cell : list corner) (n : corner) (a b : node) : bool :=
  distinct n (zero, zero) && let m := farthest n a b in forallb (fun x => le m (qdot n x)) cell.
Definition follow (code : list token) (cell : list corner) (stack : list (node * node)) : bool :=
  follow_with (separates cell) code stack.

Inductive proof :=
| Covered (i j : nat) (parts : list corner) (* solids of P and Q; of each corner, its point of P *)
| Apart (code : list token).

Record witness := {
  of_P : tiled; of_Q : tiled; box : list corner; cells : list (list corner * proof) }.

Definition check_cell (w : witness) (c : list corner * proof) : bool :=
  is_polygon (fst c) &&
  match snd c with
  | Covered i j parts =>
      match nth_error (solids (of_P w)) i, nth_error (solids (of_Q w)) j with
      | Some a, Some b =>
          all2 (fun x p => holds (fst a) p && holds (fst b) (qminus x p)) (fst c) parts
      | _, _ => false
      end
  | Apart code => follow code (fst c) [(root (of_P w), root (of_Q w))]
  end.
Definition covered (c : list corner * proof) : bool :=
  match snd c with Covered _ _ _ => true | _ => false end.

(** The box has the sum of the two hulls on the left of each edge; cells tile it. *)
Definition outward (e : corner * corner) : corner :=
  (snd (snd e) - snd (fst e), fst (fst e) - fst (snd e)).
Definition check_box (w : witness) : bool :=
  is_polygon (box w) &&
  forallb (fun e => le (support (outward e) (hull_of (root (of_P w)))
                              + support (outward e) (hull_of (root (of_Q w))))
                             (qdot (outward e) (fst e))) (ring_edges (box w)) &&
  same_boundary (ring_edges (box w)) (flat_map (fun c => ring_edges (fst c)) (cells w)).

(** ** Claims *)
Definition is_empty {A} (r : rings A) : bool := match r with [] => true | _ => false end.

(** Claim `sum`: R is sP + Q. *)
Definition check_sum (s : number) (P Q R : rings corner) (w : witness) : bool :=
  if is_empty P || is_empty Q then is_empty R
  else
    lt zero s && negb (thin P && thin Q) &&
    check_operand s P (of_P w) && check_operand one Q (of_Q w) &&
    check_box w && forallb (check_cell w) (cells w) &&
    negb (thin R) && no_null (all_edges R) &&
    same_boundary (all_edges R) (flat_map ring_edges (map fst (filter covered (cells w)))).

(** Claim `point`: x = s p + q, p in leaf i of P and q in leaf j of Q. *)
Definition check_point (s : number) (P Q : rings corner) (x p q : corner) (of_P of_Q : tiled)
    (i j : nat) :
    bool :=
  check_operand one P of_P && check_operand one Q of_Q && same x (qadd (scaled s p) q) &&
  match nth_error (leaves (root of_P)) i, nth_error (leaves (root of_Q)) j with
  | Some a, Some b => holds a p && holds b q
  | _, _ => false
  end.

(** Claim `sum`, its components. The covered cells come component after component. In each, every
    cell but the first has an earlier one, by how far back it is, that lies on the other side of a
    piece of edge around a point m; and its rim is given, as rings, each edge with the number of a
    cell that is not covered and holds it. *)
Record component := {
  size : nat; links : list (nat * corner); rim : list (list corner * list nat) }.

Fixpoint split_by {A} (sizes : list nat) (l : list A) : list (list A) :=
  match sizes with
  | [] => []
  | n :: r => firstn n l :: split_by r (skipn n l)
  end.
Definition is_convex (l : list corner) : bool :=
  is_polygon l && no_null (ring_edges l) && forallb (is_left l) l.
(** The edge of a convex cell that m is inside of, as its direction *)
Definition side_of (cell : list corner) (m : corner) : option corner :=
  match filter (fun e => equal zero (qorient (fst e) (snd e) m)) (ring_edges cell) with
  | [e] => if is_left cell m then Some (qminus (snd e) (fst e)) else None
  | _ => None
  end.
Definition is_link (c d : list corner) (m : corner) : bool :=
  match side_of c m, side_of d m with
  | Some u, Some v =>
      equal zero (fst u * snd v - snd u * fst v) && lt (fst u * fst v + snd u * snd v) zero
  | _, _ => false
  end.
Fixpoint linked (before cells : list (list corner)) (links : list (nat * corner)) : bool :=
  match cells, links with
  | [], [] => true
  | c :: r, (n, m) :: k =>
      match nth_error before n with
      | Some d => is_link d c m && linked (c :: before) r k
      | None => false
      end
  | _, _ => false
  end.
Definition is_connected (cells : list (list corner)) (links : list (nat * corner)) : bool :=
  match cells with [] => false | c :: r => linked [c] r links end.
Definition on_rim (others : list (list corner)) (ring : list corner * list nat) : bool :=
  all2 (fun e n => match nth_error others n with
                   | Some c => is_left c (fst e) && is_left c (snd e)
                   | None => false
                   end) (ring_edges (fst ring)) (snd ring).
Definition is_class (cells : list (list corner)) (c : component) : bool :=
  forallb is_convex cells && is_connected cells (links c).
Definition has_rim (others cells : list (list corner)) (c : component) : bool :=
  forallb (on_rim others) (rim c) &&
  same_boundary (all_edges (map fst (rim c))) (flat_map ring_edges cells).
Definition check_component (others cells : list (list corner)) (c : component) : bool :=
  is_class cells c && has_rim others cells c.
Definition is_rectangle (l : list corner) : bool :=
  match l with
  | [a; b; c; d] =>
      equal (snd a) (snd b) && equal (snd c) (snd d) && equal (fst a) (fst d) &&
      equal (fst b) (fst c) && lt (fst a) (fst b) && lt (snd a) (snd d)
  | _ => false
  end.
Definition check_components (s : number) (P Q R : rings corner) (w : witness)
    (cs : list component) : bool :=
  check_sum s P Q R w &&
  (if is_empty P || is_empty Q then match cs with [] => true | _ => false end
   else
     let yes := map fst (filter covered (cells w)) in
     let no := map fst (filter (fun c => negb (covered c)) (cells w)) in
     let parts := split_by (map size cs) yes in
     is_rectangle (box w) && forallb is_convex no &&
     Nat.eqb (length (concat parts)) (length yes) &&
     all2 (check_component no) parts cs).

(** Claim `sum`, its holes. The other cells come class after class, first that of the outside: one
    of its first cell's corners is on a wall of the box. The box is larger than the covered cells
    and the holes. *)
Definition is_strictly_in (l : list corner) (p : corner) : bool :=
  forallb (fun e => lt zero (qorient (fst e) (snd e) p)) (ring_edges l).
Definition is_out (l : list corner) (p : corner) : bool :=
  existsb (fun e => le (qorient (fst e) (snd e) p) zero) (ring_edges l).
Definition reaches_wall (l : list corner) (cells : list (list corner)) : bool :=
  match cells with
  | c :: _ => existsb (is_out l) c
  | [] => false
  end.
Definition check_holes (s : number) (P Q R : rings corner) (w : witness) (cs : list component)
    (outside : component) (hs : list component) : bool :=
  check_components s P Q R w cs &&
  (if is_empty P || is_empty Q then match hs with [] => true | _ => false end
   else
     let yes := map fst (filter covered (cells w)) in
     let no := map fst (filter (fun c => negb (covered c)) (cells w)) in
     let parts := split_by (map size (outside :: hs)) no in
     Nat.eqb (length (concat parts)) (length no) &&
     match parts with
     | first :: holes =>
         is_class first outside && reaches_wall (box w) first &&
         all2 (check_component yes) holes hs &&
         forallb (forallb (is_strictly_in (box w))) (yes ++ concat holes)
     | [] => false
     end).

(** What stands in files does not move. *)
Definition fixed (v : vertex) : corner := (Fixed (fst v), Fixed (snd v)).
Definition fixed_rings (r : rings vertex) : rings corner := map (map fixed) r.
