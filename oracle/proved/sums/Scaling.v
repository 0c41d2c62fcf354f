(** A set that is scaled by s > 0 is the set of the scaled rings. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Values Checker
  Corners.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

Lemma orient_scale s a b y : orient (scale s a) (scale s b) (scale s y) = s * s * orient a b y.
Proof. unfold orient, scale; simpl; ring. Qed.
Lemma crossing_scale s a b y : 0 < s -> crossing (scale s a) (scale s b) (scale s y) = crossing a b
  y.
Proof.
  intros S. unfold crossing. rewrite orient_scale. unfold scale; simpl.
  assert (SS : 0 < s * s) by nra.
  assert (L : forall u v, s * u < s * v -> u < v) by (intros; apply Rmult_lt_reg_l with s; auto).
  assert (L' : forall u v, s * u <= s * v -> u <= v) by (intros; apply Rmult_le_reg_l with s; auto).
  assert (M : forall u v, u < v -> s * u < s * v) by (intros; apply Rmult_lt_compat_l; auto).
  assert (M' : forall u v, u <= v -> s * u <= s * v) by (intros; apply Rmult_le_compat_l; lra).
  repeat match goal with
  | |- context [Rle_dec (s * ?u) (s * ?v)] =>
      destruct (Rle_dec (s * u) (s * v)), (Rle_dec u v); try (exfalso; auto; fail); auto
  | |- context [Rlt_dec (s * ?u) (s * ?v)] =>
      destruct (Rlt_dec (s * u) (s * v)), (Rlt_dec u v); try (exfalso; auto; fail); auto
  end;
  destruct (Rlt_dec (s * s * orient a b y) 0), (Rlt_dec (orient a b y) 0),
    (Rlt_dec 0 (s * s * orient a b y)), (Rlt_dec 0 (orient a b y)); auto; exfalso; nra.
Qed.
Lemma scale_back s x : 0 < s -> scale (/ s) (scale s x) = x.
Proof. intros. destruct x. unfold scale; simpl. f_equal; field; lra. Qed.
Lemma scale_forth s x : 0 < s -> scale s (scale (/ s) x) = x.
Proof. intros. destruct x. unfold scale; simpl. f_equal; field; lra. Qed.
Lemma scale_one x : scale (value one) x = x.
Proof. rewrite value_one. destruct x. unfold scale; simpl. f_equal; ring. Qed.

Lemma on_segment_scale s a b y : 0 < s ->
  (on_segment (scale s a) (scale s b) (scale s y) <-> on_segment a b y).
Proof.
  intros S. split; intros (t & T & K); exists t; split; auto.
  - rewrite <- (scale_back s y S), K. unfold scale; simpl. f_equal; field; lra.
  - rewrite K. unfold scale; simpl. f_equal; ring.
Qed.
Lemma near_scale s e x y : 0 < s -> near (e / s) x y -> near e (scale s x) (scale s y).
Proof.
  intros S [Y1 Y2].
  assert (G : forall u v, Rabs (u - v) < e / s -> Rabs (s * u - s * v) < e).
  { intros u v H. rewrite <- Rmult_minus_distr_l, Rabs_mult, (Rabs_right s) by lra.
    apply Rmult_lt_compat_l with (r := s) in H; auto.
    replace (s * (e / s)) with e in H by (field; lra). exact H. }
  split; unfold scale; simpl; apply G; auto.
Qed.

Lemma region_scale s E x : 0 < s -> region E x -> region (map (both (scale s)) E) (scale s x).
Proof.
  intros S H e He.
  destruct (H (e / s)) as (y & Y & N & W); [apply Rdiv_lt_0_compat; auto|].
  exists (scale s y). repeat apply conj.
  - apply near_scale; auto.
  - apply near_scale; auto.
  - intros a b I K. apply in_map_iff in I. destruct I as ([u v] & E1 & I).
    unfold both in E1. simpl in E1. injection E1; intros; subst.
    apply on_segment_scale in K; auto. exact (N u v I K).
  - replace (winding (map (both (scale s)) E) (scale s y)) with (winding E y); auto.
    clear - S. induction E as [|[u v] E IH]; simpl; auto. rewrite IH. f_equal.
    symmetry. apply crossing_scale; auto.
Qed.
Theorem region_scale_iff s E x : 0 < s ->
  region (map (both (scale s)) E) (scale s x) <-> region E x.
Proof.
  intros S. split; [|apply region_scale, S]. intros H.
  apply (region_scale (/ s)) in H; [|apply Rinv_0_lt_compat, S].
  rewrite scale_back in H by auto. rewrite map_map in H.
  replace (map (fun e => both (scale (/ s)) (both (scale s) e)) E) with E in H; auto. clear H.
  induction E as [|[u v] E IH]; simpl; auto. rewrite <- IH. f_equal.
  unfold both; simpl. rewrite !scale_back; auto.
Qed.

(** The edges of the rings that the checker has scaled *)
Definition outline (r : rings corner) : rings point := map (map real) r.
Definition real_edges (r : rings corner) : list (point * point) := all_edges (outline r).
Lemma real_edges_of r : real_edges r = map real_edge (all_edges r).
Proof.
  unfold real_edges, outline, all_edges. induction r as [|l r IH]; simpl; auto.
  rewrite map_app, <- IH, ring_edges_map. reflexivity.
Qed.
Lemma scaled_edges s r :
  map real_edge (all_edges (map (map (scaled s)) r)) = map (both (scale (value s))) (real_edges r).
Proof.
  rewrite <- real_edges_of. unfold real_edges, outline, all_edges.
  induction r as [|l r IH]; simpl; auto.
  rewrite map_app, <- IH. f_equal. rewrite <- ring_edges_map, !map_map. f_equal.
  apply map_ext. intros a. apply real_scaled.
Qed.

(** What does not move *)
Lemma outline_fixed r : outline (fixed_rings r) = points r.
Proof.
  unfold outline, fixed_rings, points. rewrite map_map. apply map_ext. intros l.
  rewrite map_map. reflexivity.
Qed.
End Here.
