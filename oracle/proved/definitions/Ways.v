(** The claims of docs/certificates-paths.md: what has to be believed of them, beside Definitions.v
    and the segments of a path in Predicates.v *)
From Proved Require Export Definitions Predicates.
Open Scope R_scope.

(** The part r at the place x and the scale s is x + s r. With contact allowed it collides with the
    obstacles o if interiors have a common point; with contact forbidden, if the sets have one. *)
Inductive touch := Allowed | Forbidden.
Definition part_at (s : R) (r : rings point) (x z : point) : Prop :=
  exists p, set_of r p /\ z = add x (scale s p).
Definition collides (c : touch) (s : R) (r o : rings point) (x : point) : Prop :=
  match c with
  | Allowed => exists z, interior (part_at s r x) z /\ interior (set_of o) z
  | Forbidden => exists z, part_at s r x z /\ set_of o z
  end.
Definition free (c : touch) (s : R) (r o : rings point) (x : point) := ~ collides c s r o x.

(** Scales, as they stand in a file: all real numbers above 0 between two, with or without the ends;
    None for no end *)
Record scales := { low : Q; high : option Q; low_in : bool; high_in : bool }.
Definition in_scales (i : scales) (s : R) : Prop := 0 < s /\
  (Q2R (low i) < s \/ (low_in i = true /\ s = Q2R (low i))) /\
  match high i with
  | None => True
  | Some b => s < Q2R b \/ (high_in i = true /\ s = Q2R b)
  end.
Definition in_some (l : list scales) (s : R) : Prop := exists i, In i l /\ in_scales i s.

(** The places of a path: those of its segments, or its only place *)
Definition on_path (path : list point) (x : point) : Prop :=
  exists a b, In (a, b) (segments_of path) /\ on_segment a b x.

(** Claims of a part, obstacles and a path, with a contact: at each of the scales no place of the
    path collides, or one does. *)
Section Claims.
Variables (c : touch) (r o : rings vertex) (path : list vertex).
Definition free_at (s : R) := free c s (points r) (points o).
Definition is_free (i : scales) : Prop := path <> [] /\
  forall s, in_scales i s -> forall x, on_path (map point_of path) x -> free_at s x.
Definition is_hit (i : scales) : Prop :=
  forall s, in_scales i s -> exists x, on_path (map point_of path) x /\
    collides c s (points r) (points o) x.
(** Of the scales i those of the list are valid: no place of the path collides. *)
Definition is_valid (i : scales) (l : list scales) : Prop := path <> [] /\
  forall s, in_some l s <-> in_scales i s /\
    forall x, on_path (map point_of path) x -> free_at s x.
End Claims.

(** Claims of a place x: it is free, and the free places that are joined with it have no bound, or
    have one; and of the scales i those of the list trap the part. *)
Section Places.
Variables (c : touch) (r o : rings vertex) (x : vertex).
Definition reached (s : R) : point -> Prop := joined (free_at c r o s) (point_of x).
Definition goes_far (s : R) := free_at c r o s (point_of x) /\ ~ bounded (reached s).
Definition is_kept (s : R) := free_at c r o s (point_of x) /\ bounded (reached s).
Definition escapes (i : scales) : Prop := forall s, in_scales i s -> goes_far s.
Definition is_trapped (i : scales) : Prop := forall s, in_scales i s -> is_kept s.
Definition is_trap (i : scales) (l : list scales) : Prop :=
  forall s, in_some l s <-> in_scales i s /\ is_kept s.
End Places.
