(** The program's test that what edges wind around, they wind around once. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Fans Curves Unions Local Across
  Overlaps Components Paths Decomposed Gaps Unique Boundaries Beside Rounds.
From Proved Require Import Points Member Decided Pieces Sorting Along Cuts Lone Kept.
From Proved Require Import Validity Overhead.
Open Scope R_scope.

Lemma inner_between a b x y q : inner a b x -> inner a b y -> on_segment x y q -> inner a b q.
Proof.
  intros (s & S & X) (t & T & Y) (u & U & Q). change (x = at_ a b s) in X.
  change (y = at_ a b t) in Y. change (q = at_ x y u) in Q. rewrite X, Y, at_at in Q.
  pose proof (mean_positive s t u). pose proof (mean_positive (1 - s) (1 - t) u).
  exists (s + u * (t - s)). split; [lra|exact Q].
Qed.
Lemma inner_abscissa a b x : inner a b x -> fst a <> fst b ->
  fst a < fst x < fst b \/ fst b < fst x < fst a.
Proof.
  intros (t & T & ->) N. cbn [fst]. destruct (Rtotal_order (fst a) (fst b)) as [H|[H|H]];
    [left|contradiction|right]; nra.
Qed.
(** Near a point there is one with the same ordinate and none of some abscissas. *)
Lemma other_abscissa (xs : list R) y r : 0 < r -> exists z, near r y z /\ ~ In (fst z) xs.
Proof.
  intros R. destruct (aside (map (fun x => (x, snd y)) xs) y (fst y + 1, snd y) y r)
    as (z & O & N & Out); auto.
  - intros E. apply (f_equal fst) in E. simpl in E. lra.
  - apply on_segment_start.
  - exists z. split; auto. intros I. apply Out. apply in_map_iff. exists (fst z). split; auto.
    destruct O as (t & T & ->). cbn [fst snd]. f_equal. ring.
Qed.

Section Once.
Variable E : list edge.
Hypothesis E_closed : closed (map R2e E).
Hypothesis E_long : forall e, In e E -> null e = false.
Hypothesis E_share : share_points_only (map R2e E).
Let all := map from_left E.

Lemma lefts_forward e : In e all -> forward e.
Proof.
  intros I. apply in_map_iff in I. destruct I as (f & <- & I). apply from_left_forward, E_long, I.
Qed.
Lemma left_in e : In e E -> In (from_left e) all.
Proof. apply in_map. Qed.
(** Inside a piece its edge is alone. *)
Lemma alone l e r p x : E = l ++ e :: r -> In p (cut all (from_left e)) -> inside p x ->
  forall f, In f (map R2e (l ++ r)) -> ~ on_segment (fst f) (snd f) x.
Proof.
  intros Q Ip X f' If' O. apply in_map_iff in If'. destruct If' as (f & <- & If).
  assert (Ie : In e E) by (rewrite Q; apply in_or_app; simpl; auto).
  assert (Jf : In f E) by (rewrite Q; apply in_app_or in If; apply in_or_app; simpl; tauto).
  assert (G : forall y, lies_on p y -> lies_on e y /\ lies_on f y).
  { intros y Y. split; apply from_left_on.
    - apply (cut_within all lefts_forward _ p); auto using left_in.
    - apply (cut_lone all lefts_forward (from_left e) p _ x); auto using left_in.
      apply from_left_on, O. }
  destruct (G _ (on_segment_start _ _)) as [A1 B1]. destruct (G _ (on_segment_end _ _)) as [A2 B2].
  pose proof (before_different _ _ (cut_forward all lefts_forward _ p (left_in e Ie) Ip)) as N.
  apply N. assert (S : share_points_only (map R2e l ++ R2e e :: map R2e r))
    by (rewrite Q, map_app in E_share; exact E_share).
  destruct (pairs_split _ _ _ _ S (R2e f)) as [K|K].
  - rewrite <- map_app. apply in_map, If.
  - apply K; auto.
  - apply K; auto.
Qed.
Lemma inside_edge e p x : In e E -> In p (cut all (from_left e)) -> inside p x ->
  inner (start e) (finish e) x.
Proof.
  intros Ie Ip X.
  destruct (cut_at all lefts_forward _ p (left_in e Ie) Ip) as (s & t & S & T & P & Q & _).
  unfold inside in X. rewrite P, Q in X. apply part_inner in X; [|lra].
  destruct X as (w & W & ->). unfold from_left. destruct (is_before (fst e) (snd e)).
  - exists w. split; [lra|reflexivity].
  - exists (1 - w). split; [lra|]. unfold at_, start, finish; cbn [fst snd]. f_equal; ring.
Qed.
Lemma winding_inside l e r p x : E = l ++ e :: r -> In p (cut all (from_left e)) -> inside p x ->
  winding (map R2e E) x = winding (map R2e (l ++ r)) x.
Proof.
  intros Q Ip X. assert (Ie : In e E) by (rewrite Q; apply in_or_app; simpl; auto).
  pose proof (inner_on_line _ _ _ (inside_edge e p x Ie Ip X)) as O.
  rewrite Q, !map_app. cbn [map]. rewrite winding_without, <- map_app.
  unfold R2e at 2 3. cbn [fst snd]. rewrite crossing_on by exact O. lia.
Qed.
Lemma near_piece l e r p x : E = l ++ e :: r -> In p (cut all (from_left e)) ->
  fst (start e) <> fst (finish e) -> inside p x -> exists s, 0 < s /\ forall y, near s x y ->
    winding (map R2e (l ++ r)) y = winding (map R2e (l ++ r)) x.
Proof.
  intros Q Ip N X. assert (Ie : In e E) by (rewrite Q; apply in_or_app; simpl; auto).
  pose proof (inner_abscissa _ _ _ (inside_edge e p x Ie Ip X) N) as A.
  rewrite map_app. apply (winding_near_edge _ (R2e e)).
  - rewrite Q, map_app in E_closed. exact E_closed.
  - unfold R2e, start in *. cbn [fst snd]. lra.
  - unfold R2e, finish in *. cbn [fst snd]. lra.
  - rewrite <- map_app. exact (alone l e r p x Q Ip X).
Qed.
Lemma all_along_piece l e r p x y : E = l ++ e :: r -> In p (cut all (from_left e)) ->
  fst (start e) <> fst (finish e) -> inside p x -> inside p y ->
  winding (map R2e (l ++ r)) x = winding (map R2e (l ++ r)) y.
Proof.
  intros Q Ip N X Y. apply constant_on_segment. intros q O.
  apply (near_piece l e r p q Q Ip N). exact (inner_between _ _ x y q X Y O).
Qed.
Lemma overhead_real e p : as_overhead E e p = true <->
  winding (map R2e E) (R2 (middle p)) =
    if Rlt_dec (fst (start e)) (fst (finish e)) then 1%Z else 0%Z.
Proof.
  unfold as_overhead. rewrite Z.eqb_eq, winding_real, less_decides. unfold start, finish, point_of.
  cbn [fst snd]. destruct (Rlt_dec _ _); tauto.
Qed.
Lemma goes_real : goes_once E = true <-> forall e p, In e E -> fst (start e) <> fst (finish e) ->
  In p (cut all (from_left e)) -> winding (map R2e E) (R2 (middle p)) =
    if Rlt_dec (fst (start e)) (fst (finish e)) then 1%Z else 0%Z.
Proof.
  unfold goes_once. fold all. rewrite forallb_forall. split.
  - intros H e p I N P. specialize (H e I). apply orb_true_iff in H. destruct H as [H|H].
    + apply equal_real in H. destruct N. exact H.
    + rewrite forallb_forall in H. apply overhead_real, H, P.
  - intros H e I. apply orb_true_iff. destruct (Req_dec (fst (start e)) (fst (finish e))) as [V|V].
    + left. apply equal_real. exact V.
    + right. apply forallb_forall. intros p P. apply overhead_real, H; auto.
Qed.

Lemma goes_once_enough : goes_once E = true -> once (map R2e E).
Proof.
  intros H y Off. rewrite goes_real in H.
  assert (Y : exists z, winding (map R2e E) z = winding (map R2e E) y /\
    forall e v, In e E -> In v (cut_points all (from_left e)) -> fst (R2 v) <> fst z).
  { destruct (winding_near _ _ E_closed Off) as (r & R & K).
    destruct (other_abscissa (flat_map (fun e => map (fun v => fst (R2 v))
      (cut_points all (from_left e))) E) y r R) as (z & Z & Out).
    exists z. split; [apply K, Z|]. intros e v Ie Iv Eq. apply Out. apply in_flat_map.
    exists e. split; auto. apply in_map_iff. exists v. auto. }
  destruct Y as (z & <- & Out). clear Off y.
  destruct (lowest_above (map R2e E) z) as [N|(e' & I & C & M)]; [left; apply winding_none, N|].
  apply in_map_iff in I. destruct I as (e & <- & Ie).
  unfold R2e at 1 2 in C. cbn [fst snd] in C. fold (start e) (finish e) in C.
  set (x := (fst z, height_at (start e) (finish e) (fst z))).
  assert (Co : comes (start e) (finish e) (fst z) <> 0%Z).
  { intros Co. apply C. destruct z as [z1 z2]. rewrite crossing_below. cbn [fst] in Co.
    rewrite Co. destruct (Rlt_dec _ _); reflexivity. }
  assert (Nv : fst (start e) <> fst (finish e)).
  { intros V. apply C, crossing_vertical, V. }
  pose proof (comes_on _ _ _ Co) as Ox. fold x in Ox.
  destruct (cut_cover all lefts_forward (from_left e) x (left_in e Ie)) as (p & Ip & Op).
  { apply from_left_on, Ox. }
  assert (X : inside p x).
  { apply inner_of_segment; auto; intros Eq.
    - apply (Out e (fst p) Ie).
      + destruct p as [a b]. apply adjacent_in in Ip. apply Ip.
      + change (R2 (fst p)) with (start p). rewrite <- Eq. reflexivity.
    - apply (Out e (snd p) Ie).
      + destruct p as [a b]. apply adjacent_in in Ip. apply Ip.
      + change (R2 (snd p)) with (finish p). rewrite <- Eq. reflexivity. }
  destruct (in_split _ _ Ie) as (l & r & Q).
  pose proof (H e p Ie Nv Ip) as T.
  rewrite (winding_inside l e r p _ Q Ip (middle_inside p)),
    <- (all_along_piece l e r p x _ Q Ip Nv X (middle_inside p)) in T.
  assert (W : winding (map R2e E) z =
    (winding (map R2e (l ++ r)) x + comes (start e) (finish e) (fst z))%Z).
  { rewrite Q, !map_app. cbn [map]. apply (winding_up_to _ (R2e e)).
    - exact C.
    - intros f F. apply M. rewrite Q, map_app. exact F.
    - rewrite <- map_app. exact (alone l e r p x Q Ip X). }
  pose proof (eq_trans W (f_equal (fun n => n + comes _ _ (fst z))%Z T)) as G.
  cbv beta in G. rewrite G. revert Co. unfold comes. clear - Nv.
  destruct (Rlt_dec (fst (start e)) (fst (finish e))); split_decisions; intros K; auto;
    try (destruct (K eq_refl)); exfalso; lra.
Qed.
Lemma goes_once_needed : once (map R2e E) -> goes_once E = true.
Proof.
  intros H. apply goes_real. intros e p Ie N Ip. set (m := R2 (middle p)).
  pose proof (middle_inside p) as X. fold m in X. change (inside p m) in X.
  destruct (in_split _ _ Ie) as (l & r & Q).
  pose proof (inside_edge e p m Ie Ip X) as Im. pose proof (inner_on_line _ _ _ Im) as O.
  pose proof (inner_abscissa _ _ _ Im N) as A.
  rewrite (winding_inside l e r p m Q Ip X).
  destruct (near_piece l e r p m Q Ip N X) as (s & S & K).
  destruct (edges_near (map R2e (l ++ r)) m) as (t & T & F).
  { intros (a & b & I & Om). exact (alone l e r p m Q Ip X _ I Om). }
  set (d := Rmin s t / 2). assert (D : 0 < d /\ d < s /\ d < t).
  { unfold d. pose proof (Rmin_l s t). pose proof (Rmin_r s t).
    assert (0 < Rmin s t) by (apply Rmin_glb_lt; auto). lra. }
  assert (Use : forall u, u = d \/ u = - d -> let y := (fst m, snd m + u) in
    winding (map R2e E) y = (winding (map R2e (l ++ r)) m +
      crossing (start e) (finish e) y)%Z /\
    (winding (map R2e E) y = 0%Z \/ winding (map R2e E) y = 1%Z) /\
    orient (start e) (finish e) y = (fst (finish e) - fst (start e)) * u).
  { intros u U y.
    assert (Y : forall g, d < g -> near g m y).
    { intros g G. split; apply Rabs_def1; unfold y; cbn [fst snd]; lra. }
    assert (Oy : orient (start e) (finish e) y = (fst (finish e) - fst (start e)) * u).
    { transitivity (orient (start e) (finish e) m + (fst (finish e) - fst (start e)) * u);
        [unfold orient, y; cbn [fst snd]; ring|]. rewrite O. ring. }
    split; [|split; [|exact Oy]].
    - rewrite <- (K y) by (apply Y; lra). rewrite Q, !map_app. cbn [map].
      rewrite winding_without. reflexivity.
    - apply H. intros a b I Os. rewrite Q, map_app in I. apply in_app_or in I.
      assert (Fy : ~ on_some (map R2e (l ++ r)) y) by (apply F, Y; lra).
      destruct I as [I|[I|I]].
      + apply Fy. exists a, b. rewrite map_app. split; auto with datatypes.
      + injection I; intros; subst a b. apply segment_range in Os. destruct Os as [Os _].
        fold (start e) (finish e) in Os. rewrite Oy in Os. apply Rmult_integral in Os. lra.
      + apply Fy. exists a, b. rewrite map_app. split; auto with datatypes. }
  destruct (Use d (or_introl eq_refl)) as (W1 & V1 & O1).
  destruct (Use (- d) (or_intror eq_refl)) as (W2 & V2 & O2).
  rewrite W1 in V1. rewrite W2 in V2. clear W1 W2 Use K F. revert V1 V2. unfold crossing.
  rewrite O1, O2. cbn [fst snd].
  destruct (Rlt_dec (fst (start e)) (fst (finish e))) as [L|L].
  - assert (0 < (fst (finish e) - fst (start e)) * d) by nra.
    assert ((fst (finish e) - fst (start e)) * - d < 0) by nra.
    split_decisions; try lia; exfalso; lra.
  - assert ((fst (finish e) - fst (start e)) * d < 0) by nra.
    assert (0 < (fst (finish e) - fst (start e)) * - d) by nra.
    split_decisions; try lia; exfalso; lra.
Qed.
Theorem goes_once_is_right : goes_once E = true <-> once (map R2e E).
Proof. split; [apply goes_once_enough|apply goes_once_needed]. Qed.
End Once.
