(** The program of Points.v decides whether a point is in s P + Q: for legal sets it says yes
    exactly where it is. *)
From Coq Require Import Lra Permutation.
From Proved Require Import Definitions Form Legality Sums Corners Scaling Decomposed Gaps Legal
  Points Member.
Open Scope R_scope.

Lemma all_edges_map {A B} (f : A -> B) r :
  all_edges (map (map f) r) = map (both f) (all_edges r).
Proof.
  unfold all_edges. induction r as [|l r IH]; simpl; auto.
  rewrite map_app, IH, ring_edges_map. reflexivity.
Qed.
Lemma edges_of_points r : map R2e (all_edges r) = all_edges (points r).
Proof. symmetry. apply all_edges_map. Qed.
Lemma by_scale_real s v : point_of (by_scale s v) = scale (Q2R s) (point_of v).
Proof.
  unfold by_scale, point_of, scale; cbn [fst snd]. rewrite !Q2R_red, !Q2R_mult. reflexivity.
Qed.
Lemma scaled_edges_real s r : map R2e (all_edges (map (map (by_scale s)) r)) =
  map (both (scale (Q2R s))) (all_edges (points r)).
Proof.
  rewrite <- edges_of_points, all_edges_map, !map_map. apply map_ext. intros [a b].
  unfold R2e, both; cbn [fst snd]. rewrite !by_scale_real. reflexivity.
Qed.
Lemma closed_scaled s E : closed E -> closed (map (both (scale s)) E).
Proof.
  unfold closed. rewrite !map_map. intros C.
  replace (map (fun e => fst (both (scale s) e)) E) with (map (scale s) (map fst E))
    by (rewrite map_map; reflexivity).
  replace (map (fun e => snd (both (scale s) e)) E) with (map (scale s) (map snd E))
    by (rewrite map_map; reflexivity).
  apply Permutation_map, C.
Qed.
Lemma drawn_scaled s E S : 0 < s -> drawn E S ->
  drawn (map (both (scale s)) E) (fun p => S (scale (/ s) p)).
Proof.
  intros L (C & K). split; [apply closed_scaled, C|].
  assert (On : forall p, on_some (map (both (scale s)) E) p <-> on_some E (scale (/ s) p)).
  { intros p. split.
    - intros (a & b & I & O). apply in_map_iff in I. destruct I as ([c d] & Q & I).
      unfold both in Q; cbn [fst snd] in Q. injection Q; intros <- <-. exists c, d. split; auto.
      apply (on_segment_scale s); auto. rewrite scale_forth; auto.
    - intros (c & d & I & O). exists (scale s c), (scale s d).
      split; [apply (in_map (both (scale s))) in I; exact I|].
      rewrite <- (scale_forth s p L). apply on_segment_scale; auto. }
  assert (In_ : forall p, region (map (both (scale s)) E) p <-> region E (scale (/ s) p)).
  { intros p. rewrite <- (scale_forth s p L) at 1. apply region_scale_iff, L. }
  destruct K as [(K & H)|(K & W)]; [left|right]; (split; [intros p|]).
  - rewrite K, In_. tauto.
  - intros p O. apply In_, H, On, O.
  - rewrite K, On. tauto.
  - intros y. rewrite <- (scale_forth s y L). generalize (scale (/ s) y). intros z.
    rewrite <- (W z). clear - L. induction E as [|[a b] E IH]; [reflexivity|]. cbn [map].
    unfold both at 1; cbn [fst snd]. rewrite !winding_cons, IH, crossing_scale; auto.
Qed.
Lemma rings_of_figure ps : points (rings_of ps) = rings_of (figure ps).
Proof.
  unfold points, rings_of, figure, each_vertex. induction ps as [|[o h] ps IH]; [reflexivity|].
  simpl. rewrite map_app, IH. reflexivity.
Qed.

(** For any two sets that are drawn so *)
Lemma decide_membership_is_right s (P Q : rings vertex) x : 0 < Q2R s ->
  drawn (all_edges (points P)) (set_of (points P)) ->
  drawn (all_edges (points Q)) (set_of (points Q)) ->
  decide_membership s P Q x = true <-> in_sum (Q2R s) (points P) (points Q) (point_of x).
Proof.
  intros S LP LQ. unfold decide_membership.
  apply (drawn_scaled _ _ _ S) in LP. rewrite decide_point_is_right;
    rewrite ?scaled_edges_real, ?edges_of_points; [|apply LP|apply LQ].
  rewrite <- (drawn_sum_is_union _ _ _ _ _ LP LQ). unfold in_sum. split.
  - intros (p & q & Hp & Hq & X). exists (scale (/ Q2R s) p), q.
    rewrite scale_forth by auto. auto.
  - intros (p & q & Hp & Hq & X). exists (scale (Q2R s) p), q.
    rewrite scale_back by auto. auto.
Qed.
Theorem membership_is_decided : forall (s : Q) (P Q : list (polygon vertex)) (x : vertex),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  decide_membership s (rings_of P) (rings_of Q) x = true <->
  in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) (point_of x).
Proof.
  intros s P Q x S LP LQ. apply decide_membership_is_right; auto;
    rewrite rings_of_figure; apply legal_is_drawn; auto.
Qed.
