(** The checker: a program on rational numbers. It decides by the witness w whether R is sP + Q, and
    looks for nothing itself. That it is right is proved in Theorems.v; nothing is assumed of w.
    Each part names the rule of docs/certificates.md that it checks. *)
From Coq Require Import Bool Mergesort Orders.
From Proved Require Export Order.
From Proved Require Import Definitions Form Fans.
Open Scope Q_scope.

Definition qorient (a b p : vertex) : Q :=
  (fst b - fst a) * (snd p - snd a) - (snd b - snd a) * (fst p - fst a).
Definition qdot (n p : vertex) : Q := fst n * fst p + snd n * snd p.
Definition qadd (p q : vertex) : vertex := (fst p + fst q, snd p + snd q).
Definition qminus (p q : vertex) : vertex := (fst p - fst q, snd p - snd q).
Definition scaled (s : Q) (p : vertex) : vertex := (Qred (s * fst p), Qred (s * snd p)).
Definition same (a b : vertex) : bool := Qeq_bool (fst a) (fst b) && Qeq_bool (snd a) (snd b).
Definition greater_of (x y : Q) : Q := if Qle_bool x y then y else x.

Fixpoint all2 {A B} (f : A -> B -> bool) (l : list A) (k : list B) : bool :=
  match l, k with
  | [], [] => true
  | x :: l', y :: k' => f x y && all2 f l' k'
  | _, _ => false
  end.

(** ** Convex bodies: points, segments, and polygons whose fan of triangles turns left *)
Definition is_polygon (l : list vertex) : bool :=
  match l with
  | _ :: _ :: _ :: _ => forallb (fun t => let '(a, b, c) := t in less 0 (qorient a b c)) (fan_of l)
  | _ => false
  end.
Definition is_body (l : list vertex) : bool :=
  match l with [_] | [_; _] => true | _ => is_polygon l end.

Definition between (x a b : Q) : bool :=
  (Qle_bool a x && Qle_bool x b) || (Qle_bool b x && Qle_bool x a).
Definition is_left (l : list vertex) (p : vertex) : bool :=
  forallb (fun e => Qle_bool 0 (qorient (fst e) (snd e) p)) (ring_edges l).
Definition holds (l : list vertex) (p : vertex) : bool :=
  match l with
  | [a] => same a p
  | [a; b] => Qeq_bool (qorient a b p) 0 && between (fst p) (fst a) (fst b)
              && between (snd p) (snd a) (snd b)
  | _ => is_left l p
  end.

(** The largest value of n on vertices *)
Definition support (n : vertex) (l : list vertex) : Q :=
  match l with
  | [] => 0
  | p :: r => fold_right (fun v m => greater_of (qdot n v) m) (qdot n p) r
  end.

(** ** Edges that cancel: on each line, each point is the start of as many as it is the end of *)
Definition key (m c x : Q) : list Z :=
  [Qnum m; Z.pos (Qden m); Qnum c; Z.pos (Qden c); Qnum x; Z.pos (Qden x)].
(** The line and the abscissa of each end; vertical edges are crossed by no vertical ray. *)
Definition keys (e : vertex * vertex) : list (list Z * list Z) :=
  let '(a, b) := e in
  if Qeq_bool (fst a) (fst b) then []
  else
    let m := Qred ((snd b - snd a) / (fst b - fst a)) in
    let c := Qred (snd a - m * fst a) in
    [(key m c (Qred (fst a)), key m c (Qred (fst b)))].

Fixpoint comes_before (l k : list Z) : bool :=
  match l, k with
  | [], _ => true
  | _ :: _, [] => false
  | x :: l', y :: k' =>
      match Z.compare x y with Lt => true | Gt => false | Eq => comes_before l' k' end
  end.
Module Keys <: TotalLeBool.
  Definition t := list Z.
  Definition leb := comes_before.
  Theorem leb_total : forall a b, leb a b = true \/ leb b a = true.
  Proof.
    induction a as [|x a IH]; intros [|y b]; simpl; auto.
    rewrite (Z.compare_antisym x y). destruct (Z.compare x y); simpl; auto.
  Qed.
End Keys.
Module KeySort := Sort Keys.
Definition same_boundary (E F : list (vertex * vertex)) : bool :=
  let e := flat_map keys E in
  let f := flat_map keys F in
  all2 (all2 Z.eqb) (KeySort.sort (map fst e ++ map snd f))
                    (KeySort.sort (map snd e ++ map fst f)).

(** ** Operands: rule `pieces`. Hulls of groups are given. *)
Inductive node := Piece (v : list vertex) | Group (hull : list vertex) (members : list node).
Definition hull_of (n : node) : list vertex := match n with Piece v => v | Group h _ => h end.
Fixpoint leaves (n : node) : list (list vertex) :=
  match n with Piece v => [v] | Group _ k => flat_map leaves k end.
Fixpoint is_tree (n : node) : bool :=
  match n with
  | Piece v => is_body v
  | Group h k => is_body h && forallb (fun c => is_tree c && forallb (holds h) (hull_of c)) k
  end.

Record tiled := { root : node; solids : list (list vertex * list nat) }.

Fixpoint pick (l : list (list vertex)) (ns : list nat) : option (list (list vertex)) :=
  match ns with
  | [] => Some []
  | n :: r =>
      match nth_error l n, pick l r with Some v, Some k => Some (v :: k) | _, _ => None end
  end.
(** A solid is a leaf, or a polygon that is tiled by leaves. *)
Definition is_solid (ps : list (list vertex)) (solid : list vertex * list nat) : bool :=
  match pick ps (snd solid) with
  | None => false
  | Some [l] => is_body (fst solid) && all2 same (fst solid) l
  | Some k => is_polygon (fst solid) && forallb is_polygon k &&
              same_boundary (ring_edges (fst solid)) (flat_map ring_edges k)
  end.

Definition thin (r : rings) : bool := match r with [[_]] | [[_; _]] => true | _ => false end.
Definition edges_of (r : rings) : list (vertex * vertex) := flat_map ring_edges r.
Definition no_null (E : list (vertex * vertex)) : bool :=
  forallb (fun e => negb (same (fst e) (snd e))) E.
(** The tree o holds s times the set of the rings r. *)
Definition check_operand (s : Q) (r : rings) (o : tiled) : bool :=
  is_tree (root o) && forallb (is_solid (leaves (root o))) (solids o) &&
  let k := map (map (scaled s)) r in
  if thin r then all2 (all2 same) k (leaves (root o))
  else forallb is_polygon (leaves (root o)) && no_null (edges_of k) &&
       same_boundary (edges_of k) (flat_map ring_edges (leaves (root o))).

(** ** Cells: rule `eq`, with its proofs `cov` and `sep` *)
Inductive token := OpenP | OpenQ | Normal (n : vertex).
Fixpoint follow (code : list token) (cell : list vertex) (stack : list (node * node)) : bool :=
  match code, stack with
  | [], [] => true
  | OpenP :: r, (Group _ k, b) :: rest => follow r cell (map (fun c => (c, b)) k ++ rest)
  | OpenQ :: r, (a, Group _ k) :: rest => follow r cell (map (fun c => (a, c)) k ++ rest)
  | Normal n :: r, (a, b) :: rest =>
      negb (Qeq_bool (fst n) 0 && Qeq_bool (snd n) 0) &&
      (let m := support n (hull_of a) + support n (hull_of b) in
       forallb (fun x => Qle_bool m (qdot n x)) cell) &&
      follow r cell rest
  | _, _ => false
  end.

Inductive proof :=
| Covered (i j : nat) (parts : list vertex) (* solids of P and Q; of each corner, its point of P *)
| Apart (code : list token).

Record witness := {
  of_P : tiled; of_Q : tiled; box : list vertex; cells : list (list vertex * proof) }.

Definition check_cell (w : witness) (c : list vertex * proof) : bool :=
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
Definition covered (c : list vertex * proof) : bool :=
  match snd c with Covered _ _ _ => true | _ => false end.

(** The box has the sum of the two hulls on the left of each edge; cells tile it. *)
Definition outward (e : vertex * vertex) : vertex :=
  (snd (snd e) - snd (fst e), fst (fst e) - fst (snd e)).
Definition check_box (w : witness) : bool :=
  is_polygon (box w) &&
  forallb (fun e => Qle_bool (support (outward e) (hull_of (root (of_P w)))
                              + support (outward e) (hull_of (root (of_Q w))))
                             (qdot (outward e) (fst e))) (ring_edges (box w)) &&
  same_boundary (ring_edges (box w)) (flat_map (fun c => ring_edges (fst c)) (cells w)).

(** ** Claims *)
Definition is_empty (r : rings) : bool := match r with [] => true | _ => false end.

(** Claim `sum`: R is sP + Q. *)
Definition check_sum (s : Q) (P Q R : rings) (w : witness) : bool :=
  if is_empty P || is_empty Q then is_empty R
  else
    less 0 s && negb (thin P && thin Q) &&
    check_operand s P (of_P w) && check_operand 1 Q (of_Q w) &&
    check_box w && forallb (check_cell w) (cells w) &&
    negb (thin R) && no_null (edges_of R) &&
    same_boundary (edges_of R) (flat_map ring_edges (map fst (filter covered (cells w)))).

(** Claim `point`: x = s p + q, p in leaf i of P and q in leaf j of Q. *)
Definition check_point (s : Q) (P Q : rings) (x p q : vertex) (of_P of_Q : tiled) (i j : nat) :
    bool :=
  check_operand 1 P of_P && check_operand 1 Q of_Q && same x (qadd (scaled s p) q) &&
  match nth_error (leaves (root of_P)) i, nth_error (leaves (root of_Q)) j with
  | Some a, Some b => holds a p && holds b q
  | _, _ => false
  end.

(** Claim `sum`, its components. The covered cells come component after component. In each, every
    cell but the first has an earlier one, by how far back it is, that lies on the other side of a
    piece of edge around a point m; and its rim is given, as rings, each edge with the number of a
    cell that is not covered and holds it. *)
Record component := {
  size : nat; links : list (nat * vertex); rim : list (list vertex * list nat) }.

Fixpoint split_by {A} (sizes : list nat) (l : list A) : list (list A) :=
  match sizes with
  | [] => []
  | n :: r => firstn n l :: split_by r (skipn n l)
  end.
Definition is_convex (l : list vertex) : bool :=
  is_polygon l && no_null (ring_edges l) && forallb (is_left l) l.
(** The edge of a convex cell that m is inside of, as its direction *)
Definition side_of (cell : list vertex) (m : vertex) : option vertex :=
  match filter (fun e => Qeq_bool (qorient (fst e) (snd e) m) 0) (ring_edges cell) with
  | [e] => if is_left cell m then Some (qminus (snd e) (fst e)) else None
  | _ => None
  end.
Definition is_link (c d : list vertex) (m : vertex) : bool :=
  match side_of c m, side_of d m with
  | Some u, Some v =>
      Qeq_bool (fst u * snd v - snd u * fst v) 0 && less (fst u * fst v + snd u * snd v) 0
  | _, _ => false
  end.
Fixpoint linked (before cells : list (list vertex)) (links : list (nat * vertex)) : bool :=
  match cells, links with
  | [], [] => true
  | c :: r, (n, m) :: k =>
      match nth_error before n with
      | Some d => is_link d c m && linked (c :: before) r k
      | None => false
      end
  | _, _ => false
  end.
Definition is_connected (cells : list (list vertex)) (links : list (nat * vertex)) : bool :=
  match cells with [] => false | c :: r => linked [c] r links end.
Definition on_rim (others : list (list vertex)) (ring : list vertex * list nat) : bool :=
  all2 (fun e n => match nth_error others n with
                   | Some c => is_left c (fst e) && is_left c (snd e)
                   | None => false
                   end) (ring_edges (fst ring)) (snd ring).
Definition is_class (cells : list (list vertex)) (c : component) : bool :=
  forallb is_convex cells && is_connected cells (links c).
Definition has_rim (others cells : list (list vertex)) (c : component) : bool :=
  forallb (on_rim others) (rim c) &&
  same_boundary (edges_of (map fst (rim c))) (flat_map ring_edges cells).
Definition check_component (others cells : list (list vertex)) (c : component) : bool :=
  is_class cells c && has_rim others cells c.
Definition is_rectangle (l : list vertex) : bool :=
  match l with
  | [a; b; c; d] =>
      Qeq_bool (snd a) (snd b) && Qeq_bool (snd c) (snd d) && Qeq_bool (fst a) (fst d) &&
      Qeq_bool (fst b) (fst c) && less (fst a) (fst b) && less (snd a) (snd d)
  | _ => false
  end.
Definition check_components (s : Q) (P Q R : rings) (w : witness) (cs : list component) : bool :=
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
Definition is_strictly_in (l : list vertex) (p : vertex) : bool :=
  forallb (fun e => less 0 (qorient (fst e) (snd e) p)) (ring_edges l).
Definition reaches_wall (l : list vertex) (cells : list (list vertex)) : bool :=
  match cells with
  | c :: _ => existsb (fun v => negb (is_strictly_in l v)) c
  | [] => false
  end.
Definition check_holes (s : Q) (P Q R : rings) (w : witness) (cs : list component)
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

(** Claim `sum`, its canonical form: rings in order, without straight vertices. Each edge of polygon
    i is a row of stretches, each with the numbers of a cell of class i on its left and of one that
    is not covered on its right; the ends of the stretches of a ring differ. *)
Definition qbefore (p q : vertex) : bool :=
  less (fst p) (fst q) || (Qeq_bool (fst p) (fst q) && less (snd p) (snd q)).
Fixpoint qring_before (l k : list vertex) : bool :=
  match l, k with
  | _, [] => false
  | [], _ :: _ => true
  | p :: l', q :: k' => qbefore p q || (same p q && qring_before l' k')
  end.
Definition qarea (ring : list vertex) : Q :=
  fold_right (fun e s => Qred (fst (fst e) * snd (snd e) - snd (fst e) * fst (snd e) + s)) 0
    (ring_edges ring).
Module Vertices <: TotalLeBool.
  Definition t := vertex.
  Definition leb (p q : vertex) : bool :=
    less (fst p) (fst q) || (Qeq_bool (fst p) (fst q) && Qle_bool (snd p) (snd q)).
  Theorem leb_total : forall p q, leb p q = true \/ leb q p = true.
  Proof.
    intros p q. unfold leb, less. destruct (Q_dec (fst p) (fst q)) as [[L|L]|E].
    - left. apply orb_true_iff. left. apply negb_true_iff, not_true_iff_false.
      rewrite Qle_bool_iff. apply Qlt_not_le, L.
    - right. apply orb_true_iff. left. apply negb_true_iff, not_true_iff_false.
      rewrite Qle_bool_iff. apply Qlt_not_le, L.
    - rewrite !orb_true_iff, !andb_true_iff, !Qeq_bool_iff, !Qle_bool_iff.
      destruct (Qlt_le_dec (snd p) (snd q)) as [L|L].
      + left. right. split; [exact E|apply Qlt_le_weak, L].
      + right. right. split; [symmetry; exact E|exact L].
  Qed.
End Vertices.
Module VertexSort := Sort Vertices.

Definition qmiddle (u v : vertex) : vertex :=
  (Qred ((fst u + fst v) * (1 # 2)), Qred ((snd u + snd v) * (1 # 2))).
Definition is_along (u v : vertex) : bool :=
  Qeq_bool (fst u * snd v - snd u * fst v) 0 && less 0 (fst u * fst v + snd u * snd v).
Definition has_side (cell : list vertex) (u v d : vertex) : bool :=
  is_left cell u && is_left cell v &&
  match side_of cell (qmiddle u v) with Some w => is_along w d | None => false end.
Definition stretch := (nat * nat * vertex)%type. (* left cell, right cell, end *)
Fixpoint check_side (cells others : list (list vertex)) (a b u : vertex) (l : list stretch) :
    bool :=
  match l with
  | [] => same u b
  | (i, j, v) :: r =>
      Qeq_bool (qorient a b v) 0 && is_along (qminus b a) (qminus v u) &&
      match nth_error cells i, nth_error others j with
      | Some c, Some d => has_side c u v (qminus b a) && has_side d u v (qminus a b)
      | _, _ => false
      end && check_side cells others a b v r
  end.
Definition ends (stretches : list (list stretch)) : list vertex := map snd (concat stretches).
Definition check_ring (cells others : list (list vertex)) (ring : list vertex)
    (stretches : list (list stretch)) : bool :=
  match ring with first :: rest => forallb (qbefore first) rest | [] => false end &&
  forallb (fun t => let '((a, b), (_, c)) := t in negb (Qeq_bool (qorient a b c) 0))
    (ring_edges (ring_edges ring)) &&
  all2 (fun e l => check_side cells others (fst e) (snd e) (fst e) l) (ring_edges ring) stretches &&
  ascends qbefore (VertexSort.sort (ends stretches)).
Definition check_polygon (others cells : list (list vertex)) (p : polygon)
    (stretches : list (list (list stretch))) : bool :=
  less 0 (qarea (fst p)) && forallb (fun h => less (qarea h) 0) (snd p) &&
  ascends qring_before (snd p) && all2 (check_ring cells others) (fst p :: snd p) stretches.
Fixpoint all3 {A B C} (f : A -> B -> C -> bool) (l : list A) (k : list B) (m : list C) : bool :=
  match l, k, m with
  | [], [], [] => true
  | x :: l', y :: k', z :: m' => f x y z && all3 f l' k' m'
  | _, _, _ => false
  end.
Definition check_form (s : Q) (P Q : rings) (ps : list polygon) (w : witness)
    (cs : list component) (outside : component) (hs : list component)
    (stretches : list (list (list (list stretch)))) : bool :=
  check_holes s P Q (rings_of ps) w cs outside hs &&
  (if is_empty P || is_empty Q then true
   else
     let yes := map fst (filter covered (cells w)) in
     let no := map fst (filter (fun c => negb (covered c)) (cells w)) in
     all3 (check_polygon no) (split_by (map size cs) yes) ps stretches &&
     ascends qring_before (map fst ps)).
