(** The checker, its second part: figures, which are sums in canonical form. *)
From Coq Require Import Bool Mergesort Orders.
From Proved Require Export Checker.
From Proved Require Import Definitions Form Fans.
Open Scope Q_scope.
Open Scope number_scope.

(** Claim `sum`, its canonical form: rings without straight vertices, in order. Each edge of polygon
    i is a row of stretches, each with the numbers of a cell of class i on its left and of one that
    is not covered on its right; the ends of the stretches of a ring differ. *)
Definition qbefore (p q : corner) : bool :=
  lt (fst p) (fst q) || (equal (fst p) (fst q) && lt (snd p) (snd q)).
Fixpoint qring_before (l k : list corner) : bool :=
  match l, k with
  | _, [] => false
  | [], _ :: _ => true
  | p :: l', q :: k' => qbefore p q || (same p q && qring_before l' k')
  end.
Definition qarea (ring : list corner) : number :=
  fold_right (fun e s => reduced (fst (fst e) * snd (snd e) - snd (fst e) * fst (snd e) + s)) zero
    (ring_edges ring).

(** Points that differ. Where none moves their order tells; else each is compared with all others,
    by their least abscissae, until one's is greater than its own greatest. *)
Definition sooner (p q : vertex) : bool :=
  less (fst p) (fst q) || (Qeq_bool (fst p) (fst q) && less (snd p) (snd q)).
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
Definition fixed_vertex (p : corner) : list vertex :=
  match p with (Fixed x, Fixed y) => [(x, y)] | _ => [] end.
(** The least and the greatest abscissa of a point that moves in a straight line *)
Definition span := (Q * Q * corner)%type.
Definition span_of (p : corner) : list span :=
  match fst p with
  | Fixed x => [(x, x, p)]
  | Moving [a] => [(a, a, p)]
  | Moving [a; b] => if Qle_bool a b then [(a, b, p)] else [(b, a, p)]
  | _ => []
  end.
Module Spans <: TotalLeBool.
  Definition t := span.
  Definition leb (p q : span) : bool := Qle_bool (fst (fst p)) (fst (fst q)).
  Theorem leb_total : forall p q, leb p q = true \/ leb q p = true.
  Proof.
    intros p q. unfold leb. rewrite !Qle_bool_iff.
    destruct (Qlt_le_dec (fst (fst p)) (fst (fst q))) as [L|L]; auto. left. apply Qlt_le_weak, L.
  Qed.
End Spans.
Module SpanSort := Sort Spans.
(** Points that never meet differ always in one coordinate, or across the way from one to the other
    at the second scale. *)
Definition keep_apart (p q : corner) : bool :=
  distinct p q ||
  (let n := (Fixed (last (difference (snd q) (snd p)) 0%Q),
             Fixed (Qopp (last (difference (fst q) (fst p)) 0%Q))) in
   differ (qdot n p) (qdot n q)).
Fixpoint is_clear (p : span) (l : list span) : bool :=
  match l with
  | [] => true
  | q :: r => if less (snd (fst p)) (fst (fst q)) then true
              else keep_apart (snd p) (snd q) && is_clear p r
  end.
Fixpoint are_clear (l : list span) : bool :=
  match l with [] => true | p :: r => is_clear p r && are_clear r end.
Definition all_differ (l : list corner) : bool :=
  let vertices := flat_map fixed_vertex l in
  if Nat.eqb (length vertices) (length l) then ascends sooner (VertexSort.sort vertices)
  else
    let spans := flat_map span_of l in
    Nat.eqb (length spans) (length l) &&
    let sorted := SpanSort.sort spans in ascends Spans.leb sorted && are_clear sorted.

Definition qmiddle (u v : corner) : corner :=
  (reduced (half * (fst u + fst v)), reduced (half * (snd u + snd v))).
Definition is_along (u v : corner) : bool :=
  equal zero (fst u * snd v - snd u * fst v) && lt zero (fst u * fst v + snd u * snd v).
Definition has_side (cell : list corner) (u v d : corner) : bool :=
  is_left cell u && is_left cell v &&
  match side_of cell (qmiddle u v) with Some w => is_along w d | None => false end.
Definition stretch := (nat * nat * corner)%type. (* left cell, right cell, end *)
Fixpoint check_side (cells others : list (list corner)) (a b u : corner) (l : list stretch) :
    bool :=
  match l with
  | [] => same u b
  | (i, j, v) :: r =>
      equal zero (qorient a b v) && is_along (qminus b a) (qminus v u) &&
      match nth_error cells i, nth_error others j with
      | Some c, Some d => has_side c u v (qminus b a) && has_side d u v (qminus a b)
      | _, _ => false
      end && check_side cells others a b v r
  end.
Definition ends (stretches : list (list stretch)) : list corner := map snd (concat stretches).
Definition check_ring (cells others : list (list corner)) (ring : list corner)
    (stretches : list (list stretch)) : bool :=
  forallb (fun t => let '((a, b), (_, c)) := t in differ zero (qorient a b c))
    (ring_edges (ring_edges ring)) &&
  all2 (fun e l => check_side cells others (fst e) (snd e) (fst e) l) (ring_edges ring) stretches &&
  all_differ (ends stretches).
Definition check_polygon (others cells : list (list corner)) (p : polygon corner)
    (stretches : list (list (list stretch))) : bool :=
  lt zero (qarea (fst p)) && forallb (fun h => lt (qarea h) zero) (snd p) &&
  all2 (check_ring cells others) (fst p :: snd p) stretches.
Fixpoint all3 {A B C} (f : A -> B -> C -> bool) (l : list A) (k : list B) (m : list C) : bool :=
  match l, k, m with
  | [], [], [] => true
  | x :: l', y :: k', z :: m' => f x y z && all3 f l' k' m'
  | _, _, _ => false
  end.

(** What the checker is given beside the sum *)
Record derivation := {
  region_of : witness; components_of : list component; outside_of : component;
  holes_of : list component; rows_of : list (list (list (list stretch))) }.
Definition check_figure (s : number) (P Q : rings corner) (ps : list (polygon corner))
    (d : derivation) : bool :=
  let w := region_of d in
  check_holes s P Q (rings_of ps) w (components_of d) (outside_of d) (holes_of d) &&
  (if is_empty P || is_empty Q then true
   else
     let yes := map fst (filter covered (cells w)) in
     let no := map fst (filter (fun c => negb (covered c)) (cells w)) in
     all3 (check_polygon no) (split_by (map size (components_of d)) yes) ps (rows_of d)).
Definition is_least (ring : list corner) : bool :=
  match ring with first :: rest => forallb (qbefore first) rest | [] => false end.
Definition check_order (ps : list (polygon corner)) : bool :=
  forallb is_least (rings_of ps) && forallb (fun p => ascends qring_before (snd p)) ps &&
  ascends qring_before (map fst ps).

(** ** Sets as they stand in files *)
Definition fixed_polygons (ps : list (polygon vertex)) : list (polygon corner) :=
  each_vertex fixed ps.
Definition check_form (s : Q) (P Q : rings vertex) (ps : list (polygon vertex))
    (d : derivation) : bool :=
  check_figure (Fixed s) (fixed_rings P) (fixed_rings Q) (fixed_polygons ps) d &&
  check_order (fixed_polygons ps).
Definition check_one_point (s : Q) (P Q : rings vertex) (x p q : vertex) (of_P of_Q : tiled)
    (i j : nat) : bool :=
  check_point (Fixed s) (fixed_rings P) (fixed_rings Q) (fixed x) (fixed p) (fixed q) of_P of_Q i j.
