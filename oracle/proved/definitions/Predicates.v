(** The claims `sign` and `passage` of docs/certificates.md: what has to be believed of them, beside
    Definitions.v *)
From Proved Require Export Definitions.
Open Scope R_scope.

(** Vertex i of sP plus vertex j of Q, in the order of the file; None for none of it *)
Definition index := (option nat * option nat)%type.
Definition vertex_of (r : rings vertex) (i : option nat) : vertex :=
  match i with Some n => nth n (concat r) (0, 0)%Q | None => (0, 0)%Q end.
Definition place (s : R) (P Q : rings vertex) (ij : index) : point :=
  add (scale s (point_of (vertex_of P (fst ij)))) (point_of (vertex_of Q (snd ij))).

(** Whether three points turn left; whether three lines, each through two points a b, meet in a
    point or are parallel: the determinant of their coefficients is zero. *)
Inductive predicate :=
| Orientation (a b c : index)
| Concurrent (a b c d e f : index).
Definition line (a b : point) : R * R * R :=
  (snd a - snd b, fst b - fst a, fst a * snd b - snd a * fst b).
Definition determinant (u v w : R * R * R) : R :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in let '(w1, w2, w3) := w in
  u1 * (v2 * w3 - v3 * w2) + u2 * (v3 * w1 - v1 * w3) + u3 * (v1 * w2 - v2 * w1).
Definition value_of (s : R) (P Q : rings vertex) (p : predicate) : R :=
  let at_ := place s P Q in
  match p with
  | Orientation a b c => orient (at_ a) (at_ b) (at_ c)
  | Concurrent a b c d e f =>
      determinant (line (at_ a) (at_ b)) (line (at_ c) (at_ d)) (line (at_ e) (at_ f))
  end.
Definition has_sign (z : Z) (v : R) : Prop :=
  (z = 1%Z /\ 0 < v) \/ (z = (-1)%Z /\ v < 0) \/ (z = 0%Z /\ v = 0).
(** At all scales between two, or at one if they are equal *)
Definition is_sign (from to : Q) (P Q : rings vertex) (p : predicate) (z : Z) : Prop :=
  Q2R from <= Q2R to /\ forall s, Q2R from < s < Q2R to \/ Q2R from = s /\ s = Q2R to ->
    has_sign z (value_of s P Q p).

(** A passage: what is on it is not in the sum of the interiors, though its only point, or what is
    inside its segments, is inside the sum. *)
Definition in_interiors (s : R) (P Q : rings point) (x : point) : Prop :=
  exists p q, interior (set_of P) p /\ interior (set_of Q) q /\ x = add (scale s p) q.
Fixpoint segments {A} (path : list A) : list (A * A) :=
  match path with
  | a :: rest => match rest with b :: _ => (a, b) :: segments rest | [] => [] end
  | [] => []
  end.
Definition segments_of {A} (path : list A) : list (A * A) :=
  match path with [a] => [(a, a)] | _ => segments path end.
Definition is_passage (s : R) (P Q : rings point) (path : list point) : Prop := path <> [] /\
  forall a b, In (a, b) (segments_of path) -> forall x, on_segment a b x ->
    ~ in_interiors s P Q x /\
    (a = b \/ (x <> a /\ x <> b) -> interior (in_sum s P Q) x).
