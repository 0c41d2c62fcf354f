(** The program of Points.v decides whether a point is in s P + Q: for legal sets it says yes
    exactly where it is. *)
From Coq Require Import Lra Permutation.
From Proved Require Import Definitions Corners Scaling Decomposed Legal Points Member.
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
Lemma has_edges_scaled s E : 0 < s -> has_edges E -> has_edges (map (both (scale s)) E).
Proof.
  intros S H p (a & b & I & O). apply in_map_iff in I. destruct I as ([c d] & Q & I).
  unfold both in Q; cbn [fst snd] in Q. injection Q; intros <- <-.
  rewrite <- (scale_forth s p S) in *. apply on_segment_scale in O; auto.
  apply region_scale_iff; auto. apply H. exists c, d. auto.
Qed.

Theorem membership_is_decided : forall (s : Q) (P Q : rings vertex) (x : vertex),
  0 < Q2R s -> is_legal (points P) -> is_legal (points Q) ->
  decide_membership s P Q x = true <-> in_sum (Q2R s) (points P) (points Q) (point_of x).
Proof.
  intros s P Q x S LP LQ. unfold decide_membership.
  rewrite decide_point_is_right; rewrite ?scaled_edges_real, ?edges_of_points;
    auto using closed_scaled, has_edges_scaled, legal_closed, legal_edges_in.
  unfold in_sum. split.
  - intros (p & q & Hp & Hq & X). exists (scale (/ Q2R s) p), q.
    rewrite !legal_region, scale_forth by auto. split; [|split; auto].
    apply (region_scale_iff (Q2R s)); auto. rewrite scale_forth by auto. exact Hp.
  - intros (p & q & Hp & Hq & X). exists (scale (Q2R s) p), q.
    rewrite legal_region in Hp by auto. rewrite legal_region in Hq by auto.
    split; [|split; auto]. apply region_scale_iff; auto.
Qed.
