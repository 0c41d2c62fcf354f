(** A set has one canonical form, as statements. This page is to be read; that they hold is proved
    in Alike.v, Rearranged.v and Changes.v. In the words of Definitions.v, Form.v and Moving.v:
    points are real, sets are of the plane. *)
From Proved Require Export Definitions Form Moving.
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

(** Without an order, two forms are the same polygons but for the order, and where rings start. *)
Definition one_form_but_for_order : Prop := forall S ps qs, is_closed S ->
  is_form S ps -> is_form S qs ->
  exists rs, Permutation ps rs /\ Forall2 same_polygon rs qs.

(** No boundary event between two scales: one figure, each of whose points moves along a line, is
    the sum with its touching points at all of them. Numbers need not be rational, and holes may
    come and go. *)
Definition moved (s : R) (track : point * point) : point :=
  add (scale s (snd track)) (fst track).
Definition one_moving_figure (from to : R) (P Q : rings vertex) : Prop :=
  exists (ps : list (polygon (point * point))) (touching : list (point * point)),
    forall s, from < s < to -> exists holes,
      is_state s P Q (each_vertex (moved s) ps) (map (moved s) touching) holes.
(** What the checker takes for a boundary event is one: no such figure goes through. *)
Definition boundary_events_are_events : Prop := forall from s to P Q before there after,
  is_event from s to P Q before there after true ->
  ~ one_moving_figure (Q2R from) (Q2R to) P Q.
(** And between two scales without an event one figure moves. *)
Definition one_figure_of_an_interval : Prop := forall from to P Q m n,
  is_interval from to P Q m -> is_interval from to P Q n -> same_figure (tracks m) (tracks n).
