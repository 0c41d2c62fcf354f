(** The inside of a sum, close to a vertex of one set and an edge of the other: where the edge has
    its set on its left, and points of the other set, close to the vertex, are right of the edge. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Legality Sums Corners Scaling Crossings Local Across
  Overlaps Components Canonical Paths Decomposed Gaps Unique Rounds Convolution.
From Proved Require Import Segments Legal Along Cuts Lone Flanks Frontier Extent.
Open Scope R_scope.

(** ** A set on the left of its edges, but near finitely many points *)
Definition left_at (S : point -> Prop) (a b p : point) : Prop :=
  exists r, 0 < r /\ forall y, near r p y -> 0 < orient a b y -> S y.
Definition left_sides (E : edges_t) (S : point -> Prop) : Prop :=
  forall a b, In (a, b) E -> exists L, forall p, inner a b p -> ~ In p L -> left_at S a b p.
Lemma legal_left_sides E S : has_area E S -> closed E -> (forall e, In e E -> fst e <> snd e) ->
  share_points_only E -> once E -> left_sides E S.
Proof.
  intros A Cl NN Sh On a b I. pose proof (NN _ I) as Nab. cbn [fst snd] in Nab.
  apply in_split in I. destruct I as (l & r & ->).
  destruct (pairs_at _ _ _ _ Sh) as [Sl Sr]. cbn [fst snd] in Sl, Sr.
  destruct (shared_list a b (l ++ r)) as (L & HL).
  { intros f J x y X Y Fx Fy. apply in_app_or in J.
    destruct J as [J|J]; [apply (Sl f J)|apply (Sr f J)]; auto. }
  exists L. intros x Ix Lx.
  assert (Off : forall f, In f (l ++ r) -> ~ on_segment (fst f) (snd f) x).
  { intros f J Fx. apply Lx, (HL f x J); auto. apply inner_on_segment, Ix. }
  pose proof (held_only x (a, b) l r Off Ix) as Hd.
  destruct (winding_across _ _ _ Cl Hd) as (g & n & G & W).
  destruct (edges_near (l ++ r) x) as (h & Hh & Far).
  { intros (c & d & J & O). apply (Off (c, d) J O). }
  set (k := Rmin g h). assert (K : 0 < k) by (unfold k; apply Rmin_glb_lt; lra).
  assert (Use : forall y, near k x y -> orient a b y <> 0 ->
    ~ on_some (l ++ (a, b) :: r) y /\ winding (l ++ (a, b) :: r) y = (n + is_left_of a b y)%Z).
  { intros y Y Oy. unfold k in Y. apply near_min in Y. destruct Y as [Y1 Y2]. split.
    - intros (c & d & J & O). apply in_app_or in J. destruct J as [J|[J|J]].
      + apply (Far y Y2). exists c, d. split; auto with datatypes.
      + injection J; intros; subst. apply Oy. destruct (segment_range _ _ _ O). auto.
      + apply (Far y Y2). exists c, d. split; auto with datatypes.
    - rewrite (W y Y1); [simpl; lia|]. intros f [<-|[]]. exact Oy. }
  destruct (right_close a b x k Nab (inner_on_line _ _ _ Ix) K) as (z & Z & Lz).
  destruct (Use z Z ltac:(lra)) as [Fz Wz]. exists k. split; auto. intros y Y Ly.
  destruct (Use y Y ltac:(lra)) as [Fy Wy]. apply A, region_off; auto.
  unfold is_left_of in Wy, Wz. destruct (Rlt_dec 0 (orient a b y)); [|lra].
  destruct (Rlt_dec 0 (orient a b z)); [lra|].
  destruct (On y (off_all _ _ Fy)) as [V|V], (On z (off_all _ _ Fz)) as [V'|V']; lia.
Qed.
Lemma left_sides_scaled s E S : 0 < s -> left_sides E S ->
  left_sides (map (both (scale s)) E) (fun p => S (scale (/ s) p)).
Proof.
  intros L H a b I. apply in_map_iff in I. destruct I as ([c d] & Q & I).
  unfold both in Q; cbn [fst snd] in Q. injection Q; intros <- <-. clear Q.
  destruct (H c d I) as (K & HK). exists (map (scale s) K). intros p (t & T & E1) N.
  assert (Ep : p = scale s (at_ c d t)).
  { rewrite E1. unfold scale, at_; cbn [fst snd]. f_equal; ring. }
  destruct (HK (at_ c d t)) as (r & Hr & R).
  - exists t. auto.
  - intros J. apply N. rewrite Ep. apply in_map, J.
  - exists (s * r). split; [nra|]. rewrite Ep. intros y [Y1 Y2] O.
    assert (M : forall u v, Rabs (u - s * v) < s * r -> Rabs (/ s * u - v) < r).
    { intros u v M. apply Rmult_lt_reg_l with s; auto. rewrite <- (Rabs_right s) at 1 by lra.
      rewrite <- Rabs_mult. replace (s * (/ s * u - v)) with (u - s * v) by (field; lra). exact M. }
    apply R.
    + split; unfold scale; cbn [fst snd]; apply M; assumption.
    + replace (orient c d (scale (/ s) y)) with (/ s * / s * orient (scale s c) (scale s d) y)
        by (unfold orient, scale; cbn [fst snd]; field; lra).
      pose proof (Rinv_0_lt_compat s L). apply Rmult_lt_0_compat; auto. nra.
Qed.

(** ** A point of the other set on the right *)
Definition right_near (T : point -> Prop) (d v : point) : Prop :=
  forall r, 0 < r -> exists q, near r v q /\ T q /\ turn_of d (minus_ q v) < 0.
Lemma opposite_inside (S T : point -> Prop) a b p v : orient a b p = 0 -> left_at S a b p ->
  right_near T (minus_ b a) v -> interior (sum_set S T) (add p v).
Proof.
  intros Z (r & Hr & H) K. destruct (K (r / 2) ltac:(lra)) as (q & Q & Tq & O).
  set (w := minus_ (add p v) q).
  assert (Ow : 0 < orient a b w).
  { replace (orient a b w) with (orient a b p - turn_of (minus_ b a) (minus_ q v))
      by (unfold w, orient, turn_of, minus_, add; cbn [fst snd]; ring). lra. }
  assert (Nw : near (r / 2) p w).
  { destruct Q as [Q1 Q2]. unfold w, near, minus_, add; cbn [fst snd]. split.
    - replace (fst p + fst v - fst q - fst p) with (- (fst q - fst v)) by ring.
      rewrite Rabs_Ropp. exact Q1.
    - replace (snd p + snd v - snd q - snd p) with (- (snd q - snd v)) by ring.
      rewrite Rabs_Ropp. exact Q2. }
  destruct (near_left a b w Ow) as (e & He & Left). exists (Rmin e (r / 2)).
  split; [apply Rmin_glb_lt; lra|]. intros z Nz. apply near_min in Nz. destruct Nz as [N1 N2].
  apply (near_translate _ _ _ q) in N1. apply (near_translate _ _ _ q) in N2. fold w in N1, N2.
  exists (minus_ z q), q. split; [|split; [exact Tq|]].
  - apply H; [exact (near_near r p w _ Nw N2)|apply Left, N1].
  - unfold add, minus_; destruct z; cbn [fst snd]. f_equal; ring.
Qed.
(** Along an edge *)
Lemma arm_right (T : point -> Prop) d v w : (forall t, 0 <= t <= 1 -> T (at_ v w t)) ->
  turn_of d (minus_ w v) < 0 -> right_near T d v.
Proof.
  intros H O r R. destruct (at_near v w 0 r R) as (k & K & N). rewrite at_0 in N.
  set (t := Rmin 1 (k / 2)). assert (T0 : 0 < t <= 1 /\ t < k).
  { unfold t. pose proof (Rmin_l 1 (k / 2)). pose proof (Rmin_r 1 (k / 2)).
    assert (0 < Rmin 1 (k / 2)) by (apply Rmin_glb_lt; lra). lra. }
  exists (at_ v w t). split; [|split].
  - apply N. rewrite Rminus_0_r, Rabs_right; lra.
  - apply H. lra.
  - replace (turn_of d (minus_ (at_ v w t) v)) with (t * turn_of d (minus_ w v))
      by (unfold turn_of, minus_, at_; cbn [fst snd]; ring). nra.
Qed.
(** Left of an edge that has no other on its left: this half of all that is near is in the set. *)
Lemma half_disc F (T : point -> Prop) v b : closed F -> has_area F T -> left_sides F T ->
  In (v, b) F -> v <> b ->
  (forall c d, In (c, d) F -> on_segment c d v -> orient v b c <= 0 /\ orient v b d <= 0) ->
  left_at T v b v.
Proof.
  intros C A L I N B.
  destruct (near_all F (fun e y => 0 < orient v b y -> ~ on_segment (fst e) (snd e) y) v)
    as (h & Hh & Far).
  { intros [c d] J. cbn [fst snd]. destruct (classic (on_segment c d v)) as [O|O].
    - destruct (B c d J O). exists 1. split; [lra|]. intros y _ P (t & T' & ->). revert P.
      replace (orient v b _) with ((1 - t) * orient v b c + t * orient v b d)
        by (unfold orient; cbn [fst snd]; ring). nra.
    - destruct (segment_near c d v O) as (e & He & K). exists e. split; auto. }
  destruct (L v b I) as (M & HM).
  destruct (at_near v b 0 (h / 2)) as (k & Hk & Near); [lra|]. rewrite at_0 in Near.
  set (t := Rmin 1 (k / 2)). assert (T0 : 0 < t <= 1 /\ t < k).
  { unfold t. pose proof (Rmin_l 1 (k / 2)). pose proof (Rmin_r 1 (k / 2)).
    assert (0 < Rmin 1 (k / 2)) by (apply Rmin_glb_lt; lra). lra. }
  assert (Nt : v <> at_ v b t).
  { rewrite <- (at_0 v b) at 1. intros Q. apply (at_same v b 0 t N) in Q. lra. }
  destruct (one_not_in M v (at_ v b t) Nt) as (x & (w & W & Ew) & Nx).
  assert (Ex : x = at_ v b (w * t)).
  { rewrite Ew. unfold at_; cbn [fst snd]. f_equal; ring. }
  assert (Ix : inner v b x) by (exists (w * t); split; [nra|exact Ex]).
  destruct (HM x Ix Nx) as (r & Hr & R).
  assert (Vx : near (h / 2) v x) by (rewrite Ex; apply Near; rewrite Rminus_0_r, Rabs_right; nra).
  destruct (left_close v b x (Rmin r (h / 2)) N (inner_on_line _ _ _ Ix)) as (y0 & Y0 & O0).
  { apply Rmin_glb_lt; lra. }
  apply near_min in Y0. destruct Y0 as [Y1 Y2].
  assert (V0 : near h v y0) by exact (near_near h v x y0 Vx Y2).
  exists h. split; auto. intros y Y O. apply A. apply (all_along (region F) y0 y).
  - apply A, (R y0 Y1 O0).
  - intros p P. assert (Hp : near h v p) by exact (near_between h v y0 y p V0 Y P).
    assert (Op : 0 < orient v b p).
    { destruct P as (u & U & ->).
      replace (orient v b _) with ((1 - u) * orient v b y0 + u * orient v b y)
        by (unfold orient; cbn [fst snd]; ring). nra. }
    assert (Off : ~ on_some F p). { intros (c & d & J & Q). exact (Far p Hp (c, d) J Op Q). }
    destruct (edges_near F p Off) as (e & He & Ne).
    destruct (winding_here F p C Off) as (f & Hf & Wf).
    exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros q Q. apply near_min in Q.
    rewrite !region_off by (auto; apply Ne; tauto). rewrite Wf by tauto. tauto.
Qed.
Definition along (d k : point) : Prop :=
  turn_of d k = 0 /\ 0 < fst d * fst k + snd d * snd k.
Lemma half_right (T : point -> Prop) d v b : left_at T v b v -> d <> (0, 0) -> v <> b ->
  ~ along d (minus_ b v) -> right_near T d v.
Proof.
  intros (h & Hh & H) Nd N W r R. set (o := minus_ b v) in *.
  assert (Po : 0 < fst o * fst o + snd o * snd o) by exact (edge_long v b N).
  assert (Pd : 0 < fst d * fst d + snd d * snd d).
  { assert (D : (0, 0) <> d) by auto. pose proof (edge_long (0, 0) d D) as P.
    cbv zeta in P. cbn [fst snd] in P. rewrite !Rminus_0_r in P. exact P. }
  assert (U : exists u, 0 < turn_of o u /\ turn_of d u < 0).
  { unfold along in W. destruct (Rtotal_order (turn_of d o) 0) as [L|[L|L]].
    - exists (fst d + fst o, snd d + snd o). unfold turn_of in *; cbn [fst snd]. lra.
    - exists (- snd o, fst o). unfold turn_of in *; cbn [fst snd]. split; [lra|].
      destruct (Rtotal_order (fst d * fst o + snd d * snd o) 0) as [G|[G|G]];
        [lra| |destruct W; split; auto].
      exfalso. assert (Z : (fst d * fst d + snd d * snd d) * (fst o * fst o + snd o * snd o) = 0).
      { transitivity ((fst d * snd o - snd d * fst o) * (fst d * snd o - snd d * fst o) +
          (fst d * fst o + snd d * snd o) * (fst d * fst o + snd d * snd o)); [ring|].
        rewrite L, G. ring. }
      apply Rmult_integral in Z. lra.
    - exists (- fst d - fst o, - snd d - snd o). unfold turn_of in *; cbn [fst snd]. lra. }
  destruct U as (u & U1 & U2).
  destruct (at_near v (add v u) 0 (Rmin h r)) as (k & K & Near); [apply Rmin_glb_lt; auto|].
  rewrite at_0 in Near. set (q := at_ v (add v u) (k / 2)).
  assert (Q : near (Rmin h r) v q) by (apply Near; rewrite Rminus_0_r, Rabs_right; lra).
  apply near_min in Q. exists q. split; [tauto|split].
  - apply H; [tauto|]. replace (orient v b q) with (k / 2 * turn_of o u)
      by (unfold q, orient, turn_of, o, minus_, at_, add; cbn [fst snd]; ring). nra.
  - replace (turn_of d (minus_ q v)) with (k / 2 * turn_of d u)
      by (unfold q, turn_of, minus_, at_, add; cbn [fst snd]; ring). nra.
Qed.
