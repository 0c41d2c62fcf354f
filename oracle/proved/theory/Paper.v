(** Behar & Lien 2012, Sections 3, 4 and 6, as statements: those that hold, in their right form, and
    those that do not, as they are printed. This page is to be read; that they are so is proved in
    the files beside it. In the words of Definitions.v: points are real, sets are of the plane. *)
From Proved Require Export Definitions.
Open Scope R_scope.

Definition diff (p q : point) : point := (fst p - fst q, snd p - snd q).
(** Positive where v points to the left of u *)
Definition cross (u v : point) : R := fst u * snd v - snd u * fst v.
Definition along (a v : point) (t : R) : point := add a (scale t v).

(** ** Section 4.1, Observation 1: where two lines meet *)
Definition observation_1 : Prop := forall a0 v b0 w t r, cross v w <> 0 ->
  (along a0 v t = along b0 w r <->
   t = cross w (diff a0 b0) / cross v w /\ r = cross v (diff a0 b0) / cross v w).
(** As printed, with u = a0 - b0: (v.y u.x - v.x u.x) / (v.x w.y - v.y w.x) *)
Definition observation_1_printed : Prop := forall a0 v b0 w t r, cross v w <> 0 ->
  along a0 v t = along b0 w r ->
  let u := diff a0 b0 in t = (snd v * fst u - fst v * fst u) / cross v w.

(** ** Sections 4.1 and 4.2: edges of the convolution at a scale s. An S-edge grows with the scale,
    a T-edge is only moved. *)
Record moving_edge := { begin : point; drift : point; way : point; grows : bool }.
Definition s_edge (p0 p1 q : point) : moving_edge :=
  {| begin := q; drift := p0; way := diff p1 p0; grows := true |}.
Definition t_edge (q0 q1 p : point) : moving_edge :=
  {| begin := q0; drift := p; way := diff q1 q0; grows := false |}.
Definition begin_at (e : moving_edge) (s : R) : point := add (begin e) (scale s (drift e)).
Definition way_at (e : moving_edge) (s : R) : point :=
  if grows e then scale s (way e) else way e.
Definition on_line (e : moving_edge) (s t : R) : point := along (begin_at e s) (way_at e s) t.

(** The point in which two edges' lines meet moves along a line at a constant rate:
    x(s) = x(1) + (s - 1) (x(2) - x(1)). *)
Definition crossings_move_linearly : Prop := forall a b, cross (way a) (way b) <> 0 ->
  exists x : R -> point,
    (forall s t r, 0 < s -> on_line a s t = on_line b s r -> on_line a s t = x s) /\
    forall s, x s = add (x 1) (scale (s - 1) (diff (x 2) (x 1))).

(** ** Section 4.2.3: the scales at which two edges meet: where four linear functions of s are not
    negative *)
Definition meet (a b : moving_edge) (s : R) : Prop := exists x,
  on_segment (on_line a s 0) (on_line a s 1) x /\ on_segment (on_line b s 0) (on_line b s 1) x.
Definition interval_of_a_pair : Prop := forall a b, cross (way a) (way b) <> 0 ->
  exists f : list (R * R), length f = 4%nat /\
    forall s, 0 < s -> (meet a b s <-> forall m n, In (m, n) f -> 0 <= m * s + n).
(** As printed: from max(B_a0, B_b0) to min(B_a1, B_b1), where B is the scale at which the lines
    meet in that end of an edge *)
Definition passes (a b : moving_edge) (t s : R) : Prop := exists r, on_line a s t = on_line b s r.
Definition interval_printed : Prop := forall a b Ba0 Ba1 Bb0 Bb1, cross (way a) (way b) <> 0 ->
  (forall s, 0 < s -> (passes a b 0 s <-> s = Ba0)) ->
  (forall s, 0 < s -> (passes a b 1 s <-> s = Ba1)) ->
  (forall s, 0 < s -> (passes b a 0 s <-> s = Bb0)) ->
  (forall s, 0 < s -> (passes b a 1 s <-> s = Bb1)) ->
  forall s, 0 < s -> (meet a b s <-> Rmax Ba0 Bb0 <= s <= Rmin Ba1 Bb1).

(** ** Section 3: the boundary of a sum *)
Definition sum_of (P Q : point -> Prop) (x : point) : Prop := exists p q, P p /\ Q q /\ x = add p q.
(** What is left of an edge of direction d at p, close to it, is in the set. *)
Definition has_left (S : point -> Prop) (p d : point) : Prop :=
  exists r, 0 < r /\ forall y, near r p y -> 0 < cross d (diff y p) -> S y.
(** A vertex between edges of directions i and o: the wedge on their left, close to it, is in the
    set. The vertex is convex where o is to the left of i, reflex where to the right. *)
Definition wedge (i o v : point) : Prop :=
  (0 < cross i o /\ 0 < cross i v /\ 0 < cross o v) \/
  (cross i o < 0 /\ (0 < cross i v \/ 0 < cross o v)).
Definition corner (S : point -> Prop) (p i o : point) : Prop := cross i o <> 0 /\
  exists r, 0 < r /\ forall y, near r p y -> wedge i o (diff y p) -> S y.
(** A set with these edges, which it has on their left: each end of an edge is a vertex, none is
    straight, and what is on no edge is inside. Polygons whose rings do not touch are meant. *)
Definition walled (S : point -> Prop) (E : list (point * point)) : Prop :=
  (forall p, S p -> interior S p \/ exists a b, In (a, b) E /\ on_segment a b p) /\
  (forall a b p, In (a, b) E -> on_segment a b p -> p <> a -> p <> b -> has_left S p (diff b a)) /\
  (forall a b, In (a, b) E -> a <> b /\
    (exists c, In (b, c) E /\ corner S b (diff b a) (diff c b)) /\
    (exists c, In (c, a) E /\ corner S a (diff a c) (diff b a))).

Definition reflex_vertices_contribute_nothing : Prop := forall S T p q i o d,
  corner S p i o -> cross i o < 0 -> d <> (0, 0) -> has_left T q d ->
  interior (sum_of S T) (add p q).
Definition incompatible_vertices_contribute_nothing : Prop := forall S T p q i o d,
  corner S p i o -> 0 < cross i o -> has_left T q d -> ~ (0 <= cross i d /\ 0 <= cross d o) ->
  interior (sum_of S T) (add p q).

(** The reduced convolution: edges of P at convex vertices of Q whose turn [i, o) has their
    direction, and edges of Q at convex vertices of P, with the turn (i, o] *)
Definition same_way (u v : point) : Prop := exists k, 0 < k /\ v = scale k u.
Definition from_first (i o d : point) : Prop :=
  0 < cross i o /\ 0 < cross d o /\ (0 < cross i d \/ same_way i d).
Definition to_last (i o d : point) : Prop :=
  0 < cross i o /\ 0 < cross i d /\ (0 < cross d o \/ same_way o d).
Definition in_reduced_convolution (E F : list (point * point)) (x : point) : Prop :=
  (exists a b c v d y, In (a, b) E /\ In (c, v) F /\ In (v, d) F /\
    from_first (diff v c) (diff d v) (diff b a) /\ on_segment a b y /\ x = add y v) \/
  (exists a v b c d y, In (a, v) E /\ In (v, b) E /\ In (c, d) F /\
    to_last (diff v a) (diff b v) (diff d c) /\ on_segment c d y /\ x = add v y).
Definition boundary_in_reduced_convolution : Prop := forall P Q E F,
  walled P E -> walled Q F -> forall x, sum_of P Q x -> ~ interior (sum_of P Q) x ->
  in_reduced_convolution E F x.

(** ** Section 6, Theorem 1: tetrahedra with whole coordinates, of which the first is scaled by a
    factor for each axis. Corners are numbered from 0; facet i is opposite corner i. *)
Definition spot := (Z * Z * Z)%type.
Definition tetrahedron := (spot * spot * (spot * spot))%type.
Definition number_of (T : tetrahedron) (i : nat) : spot :=
  let '(a, b, (c, d)) := T in nth i [a; b; c; d] a.
Definition apart (a b : spot) : spot :=
  let '(a1, a2, a3) := a in let '(b1, b2, b3) := b in (b1 - a1, b2 - a2, b3 - a3)%Z.
Definition inner (a b : spot) : Z :=
  let '(a1, a2, a3) := a in let '(b1, b2, b3) := b in (a1 * b1 + a2 * b2 + a3 * b3)%Z.
Definition normal_to (u v : spot) : spot :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in
  (u2 * v3 - u3 * v2, u3 * v1 - u1 * v3, u1 * v2 - u2 * v1)%Z.
Definition turned_round (n : spot) : spot := let '(a, b, c) := n in (- a, - b, - c)%Z.
Definition scaled_by (s : spot) (T : tetrahedron) : tetrahedron :=
  let f a := let '(s1, s2, s3) := s in let '(a1, a2, a3) := a in (s1 * a1, s2 * a2, s3 * a3)%Z in
  let '(a, b, (c, d)) := T in (f a, f b, (f c, f d)).
Definition corners4 : list nat := [0; 1; 2; 3]%nat.
(** The corners of a list, and no others, are farthest along n. *)
Definition farthest_are (T : tetrahedron) (n : spot) (l : list nat) : bool :=
  forallb (fun i => forallb (fun j => if existsb (Nat.eqb j) l
    then Z.eqb (inner n (number_of T i)) (inner n (number_of T j))
    else Z.ltb (inner n (number_of T j)) (inner n (number_of T i))) corners4) l.
Definition facet_of (i : nat) : list nat := filter (fun j => negb (Nat.eqb i j)) corners4.
(** The outward normal of a facet: of the two that are normal to it *)
Definition is_outward (T : tetrahedron) (i : nat) (n : spot) : bool :=
  farthest_are T n (facet_of i).
Definition two_normals (u v : spot) : list spot := [normal_to u v; turned_round (normal_to u v)].
Definition facet_normals (T : tetrahedron) (i : nat) : list spot :=
  match facet_of i with
  | a :: b :: c :: _ => two_normals (apart (number_of T a) (number_of T b))
                                    (apart (number_of T a) (number_of T c))
  | _ => []
  end.
(** Facet i of A has the corner j of B, and no other, farthest along its outward normal. *)
Definition facet_fits (A B : tetrahedron) (i j : nat) : bool :=
  existsb (fun n => is_outward A i n && farthest_are B n [j]) (facet_normals A i).
(** The edges i j of A and k l of B are farthest along one normal: one of the two normal to both. *)
Definition edges_fit (A B : tetrahedron) (i j k l : nat) : bool :=
  existsb (fun n => farthest_are A n [i; j] && farthest_are B n [k; l])
    (two_normals (apart (number_of A i) (number_of A j)) (apart (number_of B k) (number_of B l))).
Definition one_each : spot := (1, 1, 1)%Z.
(** Where a facet gets another corner, a pair of edges changes. *)
Definition theorem_1_second_half : Prop := forall P Q s, (exists i j k, j <> k /\
    facet_fits (scaled_by one_each P) Q i j = true /\ facet_fits (scaled_by s P) Q i k = true) ->
  exists i j k l, (In i corners4 /\ In j corners4 /\ In k corners4 /\ In l corners4) /\
    edges_fit (scaled_by one_each P) Q i j k l <> edges_fit (scaled_by s P) Q i j k l.
(** It is false even where all facets of both get other corners. *)
Definition all_facets_may_change_and_no_edges : Prop := exists P Q s,
  (forall i, In i corners4 -> exists j k, j <> k /\
    facet_fits (scaled_by one_each P) Q i j = true /\ facet_fits (scaled_by s P) Q i k = true) /\
  (forall i, In i corners4 -> exists j k, j <> k /\
    facet_fits Q (scaled_by one_each P) i j = true /\ facet_fits Q (scaled_by s P) i k = true) /\
  forall i j k l, In i corners4 -> In j corners4 -> In k corners4 -> In l corners4 ->
    edges_fit (scaled_by one_each P) Q i j k l = edges_fit (scaled_by s P) Q i j k l.
