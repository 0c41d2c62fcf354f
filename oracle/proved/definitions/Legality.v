(** Legal operands in the plane, as docs/definitions.md has them: polygon sets, points, segments
    and the empty set. To be believed beside Definitions.v and Form.v for membership, which speaks
    of no other sets. *)
From Proved Require Export Definitions Form.
Open Scope R_scope.

(** A ring is a simple closed polyline of at least three vertices: with each edge without its first
    end, no point is on two. Straight vertices are legal. *)
Definition is_simple (ring : list point) : Prop :=
  (3 <= length ring)%nat /\
  (forall e, In e (ring_edges ring) -> fst e <> snd e) /\
  ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False)
    (ring_edges ring).
(** Rings may touch at single points, and never overlap along an edge. *)
Definition share_points_only (E : list (point * point)) : Prop :=
  ForallOrdPairs (fun e f => forall x y, on_segment (fst e) (snd e) x ->
    on_segment (fst e) (snd e) y -> on_segment (fst f) (snd f) x ->
    on_segment (fst f) (snd f) y -> x = y) E.
(** What is wound around, is wound around once. Where two rings cross, or a polygon is inside
    another, there is a 2, or a -1; so too where a hole is not inside its outer ring, or is inside
    another hole. *)
Definition once (E : list (point * point)) : Prop := forall y,
  (forall a b, In (a, b) E -> ~ on_segment a b y) -> winding E y = 0%Z \/ winding E y = 1%Z.

(** Outer rings run counter-clockwise and holes clockwise; interiors of polygons are disjoint. *)
Definition is_polygon_set (ps : list (polygon point)) : Prop :=
  (forall outer holes, In (outer, holes) ps ->
    is_simple outer /\ 0 < area outer /\
    (forall hole, In hole holes -> is_simple hole /\ area hole < 0) /\
    once (all_edges (outer :: holes))) /\
  share_points_only (all_edges (rings_of ps)) /\ once (all_edges (rings_of ps)).
Definition is_point (ps : list (polygon point)) : Prop := exists a, ps = [([a], [])].
Definition is_segment (ps : list (polygon point)) : Prop :=
  exists a b, a <> b /\ ps = [([a; b], [])].
(** The empty set is the polygon set without a polygon. *)
Definition is_legal (ps : list (polygon point)) : Prop :=
  is_point ps \/ is_segment ps \/ is_polygon_set ps.
