(** What has to be believed: the theorems are about these notions, those of docs/certificates.md.
    Numbers of files are rational (Q), points real (R). *)
From Coq Require Export Reals QArith Qreals ZArith List.
Export ListNotations.
Open Scope R_scope.
Definition point := (R * R)%type.
Definition add (p q : point) : point := (fst p + fst q, snd p + snd q).
Definition scale (s : R) (p : point) : point := (s * fst p, s * snd p).

(** Twice the area of a b p: positive where p lies to the left of the line from a to b. *)
Definition orient (a b p : point) : R :=
  (fst b - fst a) * (snd p - snd a) - (snd b - snd a) * (fst p - fst a).
Definition on_segment (a b y : point) : Prop :=
  exists t, 0 <= t <= 1 /\ y = (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a)).

(** How the edge from a to b crosses the ray from y upwards: 1 where it comes from the right, -1
    where from the left, else 0. Of its ends the left one counts and the right one does not. *)
Definition crossing (a b y : point) : Z :=
  if Rle_dec (fst a) (fst y) then
    if Rlt_dec (fst y) (fst b) then if Rlt_dec (orient a b y) 0 then (-1)%Z else 0%Z else 0%Z
  else
    if Rle_dec (fst b) (fst y) then if Rlt_dec 0 (orient a b y) then 1%Z else 0%Z else 0%Z.

(** How often closed rings, given by their edges, wind around a point that is on none of them *)
Definition winding (edges : list (point * point)) (y : point) : Z :=
  fold_right (fun e n => (crossing (fst e) (snd e) y + n)%Z) 0%Z edges.
Definition near (e : R) (x y : point) : Prop :=
  Rabs (fst y - fst x) < e /\ Rabs (snd y - snd x) < e.

(** The closed set of the points around which rings wind a positive number of times *)
Definition region (edges : list (point * point)) (x : point) : Prop :=
  forall e, 0 < e -> exists y, near e x y /\
    (forall a b, In (a, b) edges -> ~ on_segment a b y) /\ (0 < winding edges y)%Z.

(** The edges of a ring of vertices, the last of which goes back to the first *)
Fixpoint path {A} (first previous : A) (rest : list A) : list (A * A) :=
  match rest with
  | [] => [(previous, first)]
  | next :: more => (previous, next) :: path first next more
  end.
Definition ring_edges {A} (ring : list A) : list (A * A) :=
  match ring with [] => [] | first :: rest => path first first rest end.

(** A set is given by its rings, outer ones and holes. One ring of one point is that point, one of
    two a segment; no ring is the empty set. *)
Definition rings (A : Type) := list (list A).
Definition all_edges {A} (r : rings A) : list (A * A) := flat_map ring_edges r.
Definition set_of (r : rings point) (x : point) : Prop :=
  match r with
  | [[a]] => x = a
  | [[a; b]] => on_segment a b x
  | _ => region (all_edges r) x
  end.

(** The Minkowski sum: all s p + q with p of P and q of Q *)
Definition in_sum (s : R) (P Q : rings point) (x : point) : Prop :=
  exists p q, set_of P p /\ set_of Q q /\ x = add (scale s p) q.
Definition is_sum (s : R) (P Q R : rings point) := forall x : point, set_of R x <-> in_sum s P Q x.

Definition vertex := (Q * Q)%type. (* as it stands in a file *)
Definition point_of (v : vertex) : point := (Q2R (fst v), Q2R (snd v)).
Definition points (r : rings vertex) : rings point := map (map point_of) r.

(** A set falls into n components: sets C 0, C 1, ..., none empty, no two with a common point, each
    open, and in each any two points are joined by a path of straight steps. *)
Definition interior (S : point -> Prop) x := exists e, 0 < e /\ forall y, near e x y -> S y.
Inductive joined (S : point -> Prop) (x : point) : point -> Prop :=
| here : joined S x x
| farther y z : joined S x y -> (forall p, on_segment y z p -> S p) -> joined S x z.
Definition falls_into (S : point -> Prop) (C : nat -> point -> Prop) (n : nat) : Prop :=
  (forall x, S x <-> exists i, (i < n)%nat /\ C i x) /\
  forall i, (i < n)%nat -> (exists x, C i x) /\ (forall x, C i x -> interior (C i) x) /\
    (forall x y, C i x -> C i y -> joined (C i) x y) /\
    (forall j x, (j < n)%nat -> C i x -> C j x -> i = j).
(** Components are those of the interior; holes the bounded ones of the complement, all but C 0. *)
Definition has_components (S : point -> Prop) n := exists C, falls_into (interior S) C n.
Definition bounded (S : point -> Prop) : Prop := exists r, forall x, S x -> near r (0, 0) x.
Definition has_holes (S : point -> Prop) (n : nat) : Prop := exists C,
  falls_into (fun x => ~ S x) C (1 + n) /\
  forall i, (i < 1 + n)%nat -> (bounded (C i) <-> i <> 0%nat).
