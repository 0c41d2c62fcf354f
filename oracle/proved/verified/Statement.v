(** The answers of the programs in Answers.v, as statements. This page is to be read; Answered.v
    proves that they hold. In the words of Definitions.v, Form.v, Legality.v and Operations.v:
    points are real, sets are of the plane. Nothing is assumed: s, P and Q are any rational number
    and any two lists of polygons. *)
From Proved Require Export Definitions Form Legality Operations.
From Proved Require Import Answers.
Open Scope R_scope.

(** The operands are legal, and the scale is above 0. *)
Definition legal_pair (s : Q) (P Q : list (polygon vertex)) : Prop :=
  0 < Q2R s /\ is_legal (figure P) /\ is_legal (figure Q).
Definition set (ps : list (polygon vertex)) : rings point := rings_of (figure ps).

(** [decide_points] answers exactly such questions, and of each point it says yes exactly if the
    point is in the sum. *)
Definition decided_points_are_right : Prop := forall s P Q xs,
  (legal_pair s P Q <-> exists answers, decide_points s P Q xs = Some answers) /\
  forall answers, decide_points s P Q xs = Some answers ->
    Forall2 (fun x is_in => is_in = true <-> in_sum (Q2R s) (set P) (set Q) (point_of x))
      xs answers.

(** Where [verified_sum] answers, the question is legal; the polygons are the sum s P + Q, as a set
    of points of the real plane, in canonical form; the interior of the sum has one component for
    each of them, and the sum has so many holes. *)
Definition verified_sum_is_sound : Prop := forall s P Q R holes,
  verified_sum s P Q = Some (R, holes) ->
  legal_pair s P Q /\
  is_sum (Q2R s) (set P) (set Q) (set R) /\
  has_components (set_of (set R)) (length R) /\
  has_holes (set_of (set R)) holes /\
  is_canonical (set_of (set R)) (figure R).
(** And nothing else is: a list of polygons that is the sum in canonical form is the answer. *)
Definition verified_sum_is_the_only_one : Prop := forall s P Q R holes ps,
  verified_sum s P Q = Some (R, holes) ->
  is_sum (Q2R s) (set P) (set Q) (rings_of ps) -> is_canonical (set_of (rings_of ps)) ps ->
  ps = figure R.
(** [verified_sum] answers exactly the questions that are legal, but for two operands of which each
    is a point or a segment. *)
Definition is_point_or_segment (ps : list (polygon vertex)) : Prop :=
  is_point (figure ps) \/ is_segment (figure ps).
Definition verified_sum_is_complete : Prop := forall s P Q,
  (legal_pair s P Q /\ ~ (is_point_or_segment P /\ is_point_or_segment Q)) <->
  exists R holes, verified_sum s P Q = Some (R, holes).

(** A set and others, combined *)
Definition in_set (P : list (polygon vertex)) : point -> Prop := set_of (set P).
Definition combination (o : operation) (P : list (polygon vertex)) others : point -> Prop :=
  combined o (in_set P) (map in_set others).
(** [verified_combination] answers exactly if all are legal polygon sets; and the answer is right as
    that of [verified_sum] is. *)
Definition verified_combination_is_complete : Prop := forall o P others,
  (forall K, In K (P :: others) -> is_polygon_set (figure K)) <->
  exists R holes, verified_combination o P others = Some (R, holes).
Definition verified_combination_is_sound : Prop := forall o P others R holes,
  verified_combination o P others = Some (R, holes) ->
  (forall x, in_set R x <-> regularised (combination o P others) x) /\
  has_components (in_set R) (length R) /\ has_holes (in_set R) holes /\
  is_canonical (in_set R) (figure R).
(** And nothing else is. *)
Definition verified_combination_is_the_only_one : Prop := forall o P others R holes ps,
  verified_combination o P others = Some (R, holes) ->
  (forall x, set_of (rings_of ps) x <-> regularised (combination o P others) x) ->
  is_canonical (set_of (rings_of ps)) ps -> ps = figure R.
(** A union is closed as it is. *)
Definition verified_union_is_sound : Prop := forall P others R holes,
  verified_combination unite P others = Some (R, holes) ->
  forall x, in_set R x <-> in_set P x \/ exists Q, In Q others /\ in_set Q x.
