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

(** A face spans a plane that no vertex is above, and one is below; each edge is there once, and
    once reversed. *)
Definition is_outer (m : mesh) (face : list nat) : bool :=
  let ring := corners m face in
  let n := area_vector ring in
  let h := level ring in
  forallb (fun v => Qle_bool (dot3 n v) h) (fst m) &&
  existsb (fun v => less (dot3 n v) h) (fst m) &&
  forallb (fun v => Qeq_bool (dot3 n v) h) ring &&
  forallb (fun i => Nat.ltb i (length (fst m))) face.
Definition is_closed (faces : list (list nat)) : bool :=
  let edges := flat_map ring_edges faces in
  let is_once a b :=
    Nat.eqb (length (filter (fun e => Nat.eqb (fst e) a && Nat.eqb (snd e) b) edges)) 1 in
  forallb (fun e => is_once (fst e) (snd e) && is_once (snd e) (fst e)) edges.
Definition is_convex_mesh (m : mesh) : bool :=
  match snd m with [] => false | _ => forallb (is_outer m) (snd m) && is_closed (snd m) end.

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
Definition is_facet (m : mesh) (face : list nat) : bool :=
  let ring := corners m face in
  let n := area_vector ring in
  let h := level ring in
  Nat.eqb (length face) (length (filter (fun v => Qle_bool h (dot3 n v)) (fst m))) &&
  match face with i :: r => forallb (Nat.ltb i) r | [] => false end &&
  forallb (fun t => let '((a, b), (_, c)) := t in
    less 0 (dot3 n (cross3 (minus3 b a) (minus3 c b))))
    (ring_edges (ring_edges ring)).
Definition is_canonical_mesh (m : mesh) : bool :=
  is_convex_mesh m && ascends is_before (fst m) && ascends is_lesser (snd m) &&
  forallb (is_facet m) (snd m) &&
  forallb (fun i => existsb (existsb (Nat.eqb i)) (snd m)) (seq 0 (length (fst m))).
Definition volume (m : mesh) : Q :=
  Qred (fold_right (fun f v => Qred (level (corners m f) + v)) 0 (snd m) / 6).
