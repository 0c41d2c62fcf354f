(** Convex polyhedra, docs/certificates-convex.md: what has to be believed of their sums *)
From Coq Require Import Bool.
From Proved Require Export Definitions Order.

Definition point3 := (R * R * R)%type.
Definition add3 (p q : point3) : point3 :=
  let '(a, b, c) := p in let '(d, e, f) := q in (a + d, b + e, c + f)%R.
Definition scale3 (s p : point3) : point3 :=
  let '(a, b, c) := s in let '(d, e, f) := p in (a * d, b * e, c * f)%R.

(** The convex hull: all means of points with weights that are not negative *)
Fixpoint mean (ws : list R) (ps : list point3) : point3 :=
  match ws, ps with
  | w :: ws', p :: ps' => add3 (scale3 (w, w, w) p) (mean ws' ps')
  | _, _ => (0, 0, 0)%R
  end.
Definition vertex3 := (Q * Q * Q)%type.
Definition real3 (v : vertex3) : point3 := let '(x, y, z) := v in (Q2R x, Q2R y, Q2R z).
Definition hull (vs : list vertex3) (x : point3) : Prop := exists ws, length ws = length vs /\
  (forall w, In w ws -> (0 <= w)%R) /\ fold_right Rplus 0%R ws = 1%R /\ x = mean ws (map real3 vs).
Definition is_body_sum (S : vertex3) (P Q R : list vertex3) : Prop := forall x, hull R x <->
  exists p q, hull P p /\ hull Q q /\ x = add3 (scale3 (real3 S) p) q.

(** Meshes: vertices, and faces as rings of their numbers *)
Open Scope Q_scope.
Definition mesh := (list vertex3 * list (list nat))%type.
Definition dot3 (u v : vertex3) : Q :=
  let '(a, b, c) := u in let '(d, e, f) := v in a * d + b * e + c * f.
Definition cross3 (u v : vertex3) : vertex3 :=
  let '(a, b, c) := u in let '(d, e, f) := v in
  (Qred (b * f - c * e), Qred (c * d - a * f), Qred (a * e - b * d)).
Definition plus3 (u v : vertex3) : vertex3 :=
  let '(a, b, c) := u in let '(d, e, f) := v in (Qred (a + d), Qred (b + e), Qred (c + f)).
Definition minus3 (u v : vertex3) : vertex3 :=
  let '(a, b, c) := u in let '(d, e, f) := v in (Qred (a - d), Qred (b - e), Qred (c - f)).
Definition corners (m : mesh) (face : list nat) : list vertex3 :=
  map (fun i => nth i (fst m) (0, 0, 0)) face.
Definition area_vector (ring : list vertex3) : vertex3 :=
  fold_right (fun e n => plus3 (cross3 (fst e) (snd e)) n) (0, 0, 0) (ring_edges ring).
Definition level (ring : list vertex3) : Q :=
  Qred (dot3 (area_vector ring) (hd (0, 0, 0) ring)).

(** The faces bound the hull: it is what is below the planes of all. *)
Definition dot_3 (u v : point3) : R :=
  let '(a, b, c) := u in let '(d, e, f) := v in (a * d + b * e + c * f)%R.
Definition is_bounded (m : mesh) : Prop := forall x, hull (fst m) x <->
  forall face, In face (snd m) ->
    (dot_3 (real3 (area_vector (corners m face))) x <= Q2R (level (corners m face)))%R.

(** Whole numbers x y z w for the point (x, y, z) / w; a b c h for the plane a x + b y + c z = h of
    a
    face; and which side of it a point is on: above where this is positive. *)
Definition over_one (v : vertex3) : Z * Z * Z * positive :=
  let '(a, b, c) := v in
  let p := Qden a in let q := Qden b in let r := Qden c in
  if Pos.eqb p q && Pos.eqb q r then (Qnum a, Qnum b, Qnum c, p)
  else (Qnum a * Z.pos (q * r), Qnum b * Z.pos (p * r), Qnum c * Z.pos (p * q),
        (p * q * r)%positive)%Z.
Definition plane_of (ring : list vertex3) : Z * Z * Z * Z :=
  let '(a, b, c) := area_vector ring in
  let h := level ring in
  let p := Qden a in let q := Qden b in let r := Qden c in let s := Qden h in
  (Qnum a * Z.pos (q * r * s), Qnum b * Z.pos (p * r * s), Qnum c * Z.pos (p * q * s),
   Qnum h * Z.pos (p * q * r))%Z.
Definition side (plane : Z * Z * Z * Z) (v : Z * Z * Z * positive) : Z :=
  let '(a, b, c, h) := plane in
  let '(x, y, z, w) := v in (a * x + b * y + c * z - h * Z.pos w)%Z.

(** A face spans a plane that no vertex is above, and one is below; each edge is there once, and
    once reversed. vs are the vertices, over one denominator each. *)
Definition is_outer (vs : list (Z * Z * Z * positive)) (m : mesh) (face : list nat) : bool :=
  let plane := plane_of (corners m face) in
  forallb (fun v => side plane v <=? 0)%Z vs && existsb (fun v => side plane v <? 0)%Z vs &&
  forallb (fun v => side plane (over_one v) =? 0)%Z (corners m face) &&
  (let n := length (fst m) in forallb (fun i => Nat.ltb i n) face).
Definition same_edge (e f : nat * nat) := Nat.eqb (fst e) (fst f) && Nat.eqb (snd e) (snd f).
Definition is_closed (faces : list (list nat)) : bool :=
  let edges := flat_map ring_edges faces in
  let sorted := EdgeSort.sort edges in
  ascends (fun e f => negb (Edges.leb f e)) sorted &&
  forallb (fun p => same_edge (fst p) (snd p))
    (combine sorted (EdgeSort.sort (map (fun e => (snd e, fst e)) edges))).
Definition is_convex_mesh (m : mesh) : bool :=
  match snd m with [] => false | _ => forallb (is_outer (map over_one (fst m)) m)
    (snd m) && is_closed (snd m) end.

(** The canonical form: a facet has all vertices that are not below its plane, and turns left at
    each, from its least one; vertices and facets are in order, and each vertex is in a facet. *)
Definition is_before (u v : vertex3) : bool :=
  let '(a, b, c) := u in let '(d, e, f) := v in
  less a d || Qeq_bool a d && (less b e || Qeq_bool b e && less c f).
Fixpoint is_lesser (l k : list nat) : bool :=
  match l, k with
  | i :: l', j :: k' => Nat.ltb i j || Nat.eqb i j && is_lesser l' k'
  | [], _ :: _ => true
  | _, [] => false
  end.
Definition is_facet (vs : list (Z * Z * Z * positive)) (m : mesh) (face : list nat) : bool :=
  let ring := corners m face in
  let n := area_vector ring in
  let plane := plane_of ring in
  Nat.eqb (length face) (length (filter (fun v => 0 <=? side plane v)%Z vs)) &&
  match face with i :: r => forallb (Nat.ltb i) r | [] => false end &&
  forallb (fun t => let '((a, b), (_, c)) := t in
    less 0 (dot3 n (cross3 (minus3 b a) (minus3 c b))))
    (ring_edges (ring_edges ring)).
Definition is_canonical_mesh (m : mesh) : bool :=
  is_convex_mesh m && ascends is_before (fst m) && ascends is_lesser (snd m) &&
  forallb (is_facet (map over_one (fst m)) m) (snd m) &&
  forallb (fun i => existsb (existsb (Nat.eqb i)) (snd m)) (seq 0 (length (fst m))).
Definition volume (m : mesh) : Q :=
  Qred (fold_right (fun f v => Qred (level (corners m f) + v)) 0 (snd m) / 6).
