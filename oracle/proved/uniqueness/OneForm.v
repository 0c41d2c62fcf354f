(** A set has one canonical form, as statements. This page is to be read; that they hold is proved
    in Alike.v. In the words of Definitions.v and Form.v: points are real, sets are of the plane. *)
From Proved Require Export Definitions Form.
Open Scope R_scope.

(** A set with all points that it comes as near to as one likes *)
Definition is_closed (S : point -> Prop) : Prop :=
  forall x, (forall e, 0 < e -> exists y, near e x y /\ S y) -> S x.
Definition same_set (S T : point -> Prop) : Prop := forall x, S x <-> T x.

(** Two canonical forms of one closed set are equal, as lists of polygons. *)
Definition one_canonical_form : Prop := forall S ps qs, is_closed S ->
  is_canonical S ps -> is_canonical S qs -> ps = qs.
(** Sets given by rings are closed. *)
Definition rings_give_closed_sets : Prop := forall r, is_closed (set_of r).

(** So a list of polygons in canonical form tells its set from all others: lists that differ are
    sets that differ. *)
Definition canonical (ps : list (polygon point)) : Prop := is_canonical (set_of (rings_of ps)) ps.
Definition another_form_is_another_set : Prop := forall ps qs, canonical ps -> canonical qs ->
  (ps = qs <-> same_set (set_of (rings_of ps)) (set_of (rings_of qs))).
(** And a sum has one canonical form. *)
Definition one_form_of_a_sum : Prop := forall s P Q ps qs,
  is_sum s P Q (rings_of ps) -> canonical ps -> is_sum s P Q (rings_of qs) -> canonical qs ->
  ps = qs.
