(** Rings that wind around no point a negative number of times, and around some, have an area above
    0: areas as sums of slices, slices as sums of winding numbers. *)
From Coq Require Import Lra Lia Psatz ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Curves Local Across Overlaps Components
  Paths Decomposed Unique Stacks.
Open Scope R_scope.

(** ** Functions that climb between the numbers of a list *)
Lemma climbs (f : R -> R) L : (forall x y, x < y -> (forall w, In w L -> ~ x < w < y) ->
  f x <= f y) -> forall x y, x <= y -> f x <= f y.
Proof.
  induction L as [|v L IH]; intros H x y XY.
  - destruct (Rle_lt_or_eq_dec x y XY) as [Lt| ->]; [apply H; auto; intros w []|lra].
  - apply IH; auto. clear x y XY. intros x y XY N. destruct (classic (x < v < y)) as [V|V].
    + apply Rle_trans with (f v); apply H; try lra; intros w [<-|I] W; try lra;
        apply (N w I); lra.
    + apply H; auto. intros w [<-|I]; auto.
Qed.
(** Numbers that are not in a list, with their neighbours *)
Lemma free_between L : forall lo hi, lo < hi -> exists x, lo < x < hi /\ ~ In x L.
Proof.
  assert (G : forall lo hi, lo < hi -> exists l h, lo <= l /\ l < h /\ h <= hi /\
    forall x, l < x < h -> ~ In x L).
  { induction L as [|v L IH]; intros lo hi H; [exists lo, hi; simpl; intuition lra|].
    destruct (IH lo hi H) as (l & h & H1 & H2 & H3 & K).
    destruct (Rle_dec v ((l + h) / 2)) as [V|V].
    - exists ((l + h) / 2), h. repeat split; try lra. intros x X [E|I]; [lra|].
      apply (K x); auto. lra.
    - exists l, ((l + h) / 2). repeat split; try lra. intros x X [E|I]; [lra|].
      apply (K x); auto. lra. }
  intros lo hi H. destruct (G lo hi H) as (l & h & H1 & H2 & H3 & K). exists ((l + h) / 2).
  split; [lra|]. apply K. lra.
Qed.
Lemma free_near L x : ~ In x L -> exists d, 0 < d /\ forall w, In w L -> ~ x - d < w < x + d.
Proof.
  induction L as [|v L IH]; intros N; [exists 1; split; [lra|intros w []]|].
  destruct IH as (d & D & K); [simpl in N; tauto|]. exists (Rmin d (Rabs (v - x))).
  assert (V : v - x <> 0) by (intros V; apply N; left; lra).
  split; [apply Rmin_glb_lt; [auto|apply Rabs_pos_lt, V]|].
  pose proof (Rmin_l d (Rabs (v - x))). pose proof (Rmin_r d (Rabs (v - x))).
  intros w [<-|I] W; [|apply (K w I); lra]. unfold Rabs in *. destruct (Rcase_abs (v - x)); lra.
Qed.
Lemma bounds_of L : exists lo hi, lo <= hi /\ forall x, In x L -> lo <= x <= hi.
Proof.
  induction L as [|v L (lo & hi & H & K)]; [exists 0, 0; split; [lra|intros x []]|].
  exists (Rmin lo v), (Rmax hi v). pose proof (Rmin_l lo v). pose proof (Rmin_r lo v).
  pose proof (Rmax_l hi v). pose proof (Rmax_r hi v).
  split; [lra|]. intros x [<-|I]; [lra|]. specialize (K x I). lra.
Qed.

(** ** Sums of real numbers *)
Definition sumr {A} (f : A -> R) (l : list A) : R := fold_right (fun a s => f a + s) 0 l.
Lemma sumr_ext {A} (f g : A -> R) l : (forall a, In a l -> f a = g a) -> sumr f l = sumr g l.
Proof. induction l; simpl; intros H; [auto|]. rewrite H, IHl; auto. Qed.
Lemma sumr_minus {A} (f g : A -> R) l : sumr (fun a => f a - g a) l = sumr f l - sumr g l.
Proof. induction l; simpl; [ring|]. rewrite IHl. ring. Qed.
Lemma sumr_times {A} k (f : A -> R) l : sumr (fun a => k * f a) l = k * sumr f l.
Proof. induction l; simpl; [ring|]. rewrite IHl. ring. Qed.
Lemma sumr_perm {A} (f : A -> R) l k : Permutation l k -> sumr f l = sumr f k.
Proof. induction 1; simpl; lra. Qed.
Lemma sumr_map {A C} (f : C -> R) (g : A -> C) l : sumr f (map g l) = sumr (fun a => f (g a)) l.
Proof. induction l; simpl; congruence. Qed.

(** ** One edge: which way it runs over an abscissa, and how high *)
Definition way_over (m : R) (e : point * point) : Z :=
  if Rle_dec (fst (fst e)) m then if Rlt_dec m (fst (snd e)) then (-1)%Z else 0%Z
  else if Rle_dec (fst (snd e)) m then 1%Z else 0%Z.
Definition level_at (m : R) (e : point * point) : R := line_at (fst e) (snd e) m.
Lemma crossing_over a b y : crossing a b y =
  if Rlt_dec (snd y) (level_at (fst y) (a, b)) then way_over (fst y) (a, b) else 0%Z.
Proof.
  unfold crossing, way_over, level_at; cbn [fst snd].
  destruct (Req_dec (fst a) (fst b)) as [E|N].
  - rewrite E. split_decisions; auto; lra.
  - rewrite (orient_line a b y N). set (h := line_at a b (fst y)).
    split_decisions; auto; exfalso; nra.
Qed.
Lemma ways_cancel E m : closed E -> sumz (way_over m) E = 0%Z.
Proof.
  intros C. set (left := fun p : point => if Rle_dec (fst p) m then 1%Z else 0%Z).
  assert (G : sumz (way_over m) E = (sumz left (map snd E) - sumz left (map fst E))%Z).
  { clear C. induction E as [|[a b] E IH]; [reflexivity|].
    change (way_over m (a, b) + sumz (way_over m) E =
      (left b + sumz left (map snd E)) - (left a + sumz left (map fst E)))%Z.
    rewrite IH. unfold way_over, left; cbn [fst snd]. split_decisions; try lia; lra. }
  rewrite G, (sumz_perm _ _ _ C). lia.
Qed.

(** ** A slice: what closed edges bound over one abscissa *)
Section Slice.
Variable E : edges_t.
Hypothesis closes : closed E.
Variable m : R.
Let levels := map (level_at m) E.
Definition slice : R := sumr (fun e => IZR (way_over m e) * level_at m e) E.
Definition slice_to (y : R) : R := sumr (fun e => IZR (way_over m e) * Rmin (level_at m e) y) E.

Lemma slice_grows y0 y1 : y0 < y1 -> (forall w, In w levels -> ~ y0 < w < y1) ->
  slice_to y1 - slice_to y0 = (y1 - y0) * IZR (winding E (m, (y0 + y1) / 2)%R).
Proof.
  intros Y N. unfold slice_to, levels in *. clear closes levels.
  assert (C : y0 < (y0 + y1) / 2 < y1) by lra. set (c := (y0 + y1) / 2) in *. clearbody c.
  induction E as [|[a b] D IH]; [simpl; ring|].
  change (winding ((a, b) :: D) (m, c)) with (crossing a b (m, c) + winding D (m, c))%Z.
  rewrite plus_IZR, Rmult_plus_distr_l, <- IH by (intros w I; apply N; simpl; auto).
  specialize (N (level_at m (a, b)) (or_introl eq_refl)). rewrite crossing_over.
  cbn [fst snd sumr fold_right]. set (h := level_at m (a, b)) in *.
  set (s := way_over m (a, b)).
  assert (K : IZR s * Rmin h y1 - IZR s * Rmin h y0 = (y1 - y0) *
    IZR (if Rlt_dec c h then s else 0%Z)).
  { destruct (Rlt_dec c h).
    - rewrite (Rmin_right h y1), (Rmin_right h y0) by lra. ring.
    - rewrite (Rmin_left h y1), (Rmin_left h y0) by lra. ring. }
  rewrite <- K. unfold sumr. ring.
Qed.
Lemma slice_low y : (forall w, In w levels -> y <= w) -> slice_to y = 0.
Proof.
  intros K. transitivity (sumr (fun e => y * IZR (way_over m e)) E).
  - apply sumr_ext. intros e I. specialize (K _ (in_map (level_at m) _ _ I)).
    rewrite Rmin_right by lra. ring.
  - rewrite sumr_times. transitivity (y * IZR (sumz (way_over m) E)).
    + f_equal. clear. induction E as [|e D IH]; [reflexivity|]. simpl. rewrite IH, <- plus_IZR.
      reflexivity.
    + rewrite (ways_cancel E m closes). ring.
Qed.
Lemma slice_high y : (forall w, In w levels -> w <= y) -> slice_to y = slice.
Proof.
  intros K. unfold slice_to, slice. apply sumr_ext. intros e I.
  specialize (K _ (in_map (level_at m) _ _ I)). rewrite Rmin_left by lra. reflexivity.
Qed.
Hypothesis rising : forall y, ~ In y levels -> (0 <= winding E (m, y))%Z.
Lemma slice_climbs y0 y1 : y0 <= y1 -> slice_to y0 <= slice_to y1.
Proof.
  apply (climbs slice_to levels). clear y0 y1. intros y0 y1 Y N.
  pose proof (slice_grows y0 y1 Y N) as G. assert (W : 0 <= IZR (winding E (m, (y0 + y1) / 2)%R)).
  { apply IZR_le, rising. intros I. apply (N _ I). lra. }
  nra.
Qed.
Lemma slice_above y0 y1 : y0 <= y1 -> slice_to y1 - slice_to y0 <= slice.
Proof.
  intros Y. destruct (bounds_of (y0 :: y1 :: levels)) as (lo & hi & L & K).
  pose proof (slice_low lo (fun w I => proj1 (K w (or_intror (or_intror I))))).
  pose proof (slice_high hi (fun w I => proj2 (K w (or_intror (or_intror I))))).
  pose proof (K y0 (or_introl eq_refl)). pose proof (K y1 (or_intror (or_introl eq_refl))).
  pose proof (slice_climbs lo y0 ltac:(lra)). pose proof (slice_climbs y1 hi ltac:(lra)). lra.
Qed.
Lemma slice_not_negative : 0 <= slice.
Proof. pose proof (slice_above 0 0 ltac:(lra)). lra. Qed.
Lemma slice_positive y : ~ In y levels -> (0 < winding E (m, y))%Z -> 0 < slice.
Proof.
  intros N W. destruct (free_near levels y N) as (d & D & F).
  pose proof (slice_grows (y - d) (y + d) ltac:(lra) F) as G.
  replace ((y - d + (y + d)) / 2) with y in G by field. apply IZR_lt in W.
  pose proof (slice_above (y - d) (y + d) ltac:(lra)). nra.
Qed.
End Slice.

(** ** Areas up to an abscissa *)
Definition under (e : point * point) : R :=
  (fst (fst e) - fst (snd e)) * (snd (fst e) + snd (snd e)).
Definition part_to (e : point * point) (x : R) : R := x * (level_at x e + level_at 0 e).
Definition under_to (x : R) (e : point * point) : R :=
  part_to e (Rmin (fst (fst e)) x) - part_to e (Rmin (fst (snd e)) x).
Lemma under_whole (e : point * point) x : fst (fst e) <= x -> fst (snd e) <= x ->
  under_to x e = under e.
Proof.
  intros A B. unfold under_to. rewrite !Rmin_left by auto. destruct e as [a b]; cbn [fst snd] in *.
  unfold under; cbn [fst snd]. destruct (Req_dec (fst a) (fst b)) as [Q|N]; [rewrite Q; ring|].
  unfold part_to, level_at, line_at; cbn [fst snd]. field. lra.
Qed.
Lemma under_none (e : point * point) x : x <= fst (fst e) -> x <= fst (snd e) -> under_to x e = 0.
Proof. intros A B. unfold under_to. rewrite !Rmin_right by auto. ring. Qed.
Lemma under_grows (e : point * point) x0 x1 : x0 < x1 -> ~ x0 < fst (fst e) < x1 ->
  ~ x0 < fst (snd e) < x1 ->
  under_to x1 e - under_to x0 e = 2 * (x1 - x0) *
    (IZR (way_over ((x0 + x1) / 2)%R e) * level_at ((x0 + x1) / 2) e).
Proof.
  intros X A B. assert (P : forall u, ~ x0 < u < x1 -> u <= x0 \/ x1 <= u) by (intros; lra).
  assert (D : part_to e x1 - part_to e x0 = 2 * (x1 - x0) * level_at ((x0 + x1) / 2) e).
  { destruct e as [[a1 a2] [b1 b2]]. unfold part_to, level_at, line_at; cbn [fst snd].
    set (k := (b2 - a2) / (b1 - a1)). clearbody k. field. }
  unfold under_to, way_over. revert D. generalize (level_at ((x0 + x1) / 2) e). intros l D.
  assert (C : x0 < (x0 + x1) / 2 < x1) by lra. set (c := (x0 + x1) / 2) in *. clearbody c.
  set (f := part_to e) in *. set (u := fst (fst e)) in *. set (v := fst (snd e)) in *.
  clearbody f u v. destruct (P _ A) as [A'|A'], (P _ B) as [B'|B']; clear P A B.
  - rewrite (Rmin_left u x1), (Rmin_left u x0), (Rmin_left v x1), (Rmin_left v x0) by lra.
    split_decisions; try lra; ring.
  - rewrite (Rmin_left u x1), (Rmin_left u x0), (Rmin_right v x1), (Rmin_right v x0) by lra.
    split_decisions; lra.
  - rewrite (Rmin_right u x1), (Rmin_right u x0), (Rmin_left v x1), (Rmin_left v x0) by lra.
    split_decisions; lra.
  - rewrite (Rmin_right u x1), (Rmin_right u x0), (Rmin_right v x1), (Rmin_right v x0) by lra.
    split_decisions; try lra; ring.
Qed.

Section Area.
Variable E : edges_t.
Hypothesis closes : closed E.
Hypothesis rising : forall y, ~ on_some E y -> (0 <= winding E y)%Z.
Let walls := map (fun e : point * point => fst (fst e)) E ++
  map (fun e : point * point => fst (snd e)) E.
Definition area_to (x : R) : R := sumr (under_to x) E.

Lemma wall_of e : In e E -> In (fst (fst e)) walls /\ In (fst (snd e)) walls.
Proof.
  intros I. split; apply in_or_app; [left|right];
    [exact (in_map (fun e : point * point => fst (fst e)) _ _ I)|
     exact (in_map (fun e : point * point => fst (snd e)) _ _ I)].
Qed.
Lemma off_levels m y : ~ In m walls -> ~ In y (map (level_at m) E) -> ~ on_some E (m, y).
Proof.
  intros M Y (a & b & I & O). apply segment_range in O. destruct O as (O & X & _).
  destruct (wall_of _ I) as [Wa Wb]. cbn [fst snd] in *.
  assert (Na : fst a <> m) by (intros Q; apply M; rewrite <- Q; exact Wa).
  assert (Nb : fst b <> m) by (intros Q; apply M; rewrite <- Q; exact Wb).
  rewrite orient_line in O by lra. cbn [fst snd] in O. apply Rmult_integral in O.
  destruct O as [O|O]; [lra|]. apply Y. replace y with (level_at m (a, b)).
  - exact (in_map (level_at m) _ _ I).
  - unfold level_at; cbn [fst snd]. lra.
Qed.
Lemma slice_rising m : ~ In m walls -> forall y, ~ In y (map (level_at m) E) ->
  (0 <= winding E (m, y))%Z.
Proof. intros M y Y. apply rising, off_levels; auto. Qed.
Lemma area_grows x0 x1 : x0 < x1 -> (forall w, In w walls -> ~ x0 < w < x1) ->
  area_to x1 - area_to x0 = 2 * (x1 - x0) * slice E ((x0 + x1) / 2).
Proof.
  intros X N. unfold area_to, slice. rewrite <- sumr_minus, <- sumr_times.
  apply sumr_ext. intros e I. destruct (wall_of e I). apply under_grows; auto.
Qed.
Lemma area_climbs x0 x1 : x0 <= x1 -> area_to x0 <= area_to x1.
Proof.
  apply (climbs area_to walls). clear x0 x1. intros x0 x1 X N.
  pose proof (area_grows x0 x1 X N) as G. assert (S : 0 <= slice E ((x0 + x1) / 2)).
  { apply (slice_not_negative E closes), slice_rising. intros I. apply (N _ I). lra. }
  nra.
Qed.
Theorem area_positive y : ~ on_some E y -> (0 < winding E y)%Z -> 0 < sumr under E.
Proof.
  intros N W. destruct (winding_here E y closes N) as (r & R & K).
  destruct (free_between walls (fst y - r) (fst y + r)) as (m & M & Fm); [lra|].
  destruct (free_between (map (level_at m) E) (snd y - r) (snd y + r)) as (t & T & Ft); [lra|].
  assert (P : 0 < slice E m).
  { apply (slice_positive E closes m (slice_rising m Fm) t Ft). rewrite K; auto.
    split; apply Rabs_def1; cbn [fst snd]; lra. }
  destruct (free_near walls m Fm) as (d & D & F).
  pose proof (area_grows (m - d) (m + d) ltac:(lra) F) as G.
  replace ((m - d + (m + d)) / 2) with m in G by field.
  destruct (bounds_of ((m - d) :: (m + d) :: walls)) as (lo & hi & L & B).
  pose proof (B _ (or_introl eq_refl)). pose proof (B _ (or_intror (or_introl eq_refl))).
  pose proof (area_climbs lo (m - d) ltac:(lra)).
  pose proof (area_climbs (m + d) hi ltac:(lra)).
  assert (Lo : area_to lo = 0).
  { unfold area_to. transitivity (sumr (fun _ : point * point => 0 * 0) E).
    - apply sumr_ext. intros e I. destruct (wall_of e I) as [A C].
      rewrite under_none; [lra| |]; apply B; simpl; auto.
    - rewrite sumr_times. ring. }
  assert (Hi : area_to hi = sumr under E).
  { apply sumr_ext. intros e I. destruct (wall_of e I) as [A C].
    apply under_whole; apply B; simpl; auto. }
  nra.
Qed.
End Area.

(** ** Rings *)
Lemma area_under ring : area ring = sumr under (ring_edges ring).
Proof.
  set (f := fun p : point => fst p * snd p).
  assert (G : forall E : edges_t, fold_right (fun e s => fst (fst e) * snd (snd e) -
    snd (fst e) * fst (snd e) + s) 0 E = sumr under E + sumr f (map snd E) - sumr f (map fst E)).
  { induction E as [|[a b] E IH]; [simpl; ring|]. cbn [fold_right map sumr fst snd] in *.
    rewrite IH. unfold sumr, under, f; cbn [fst snd]. ring. }
  unfold area. rewrite G, (sumr_perm f _ _ (ring_closed ring)). ring.
Qed.
Theorem area_above ring : (forall y, ~ on_some (ring_edges ring) y ->
    (0 <= winding (ring_edges ring) y)%Z) ->
  (exists y, ~ on_some (ring_edges ring) y /\ (0 < winding (ring_edges ring) y)%Z) ->
  0 < area ring.
Proof.
  intros H (y & N & W). rewrite area_under. exact (area_positive _ (ring_closed ring) H y N W).
Qed.
Theorem area_below ring : (forall y, ~ on_some (ring_edges ring) y ->
    (winding (ring_edges ring) y <= 0)%Z) ->
  (exists y, ~ on_some (ring_edges ring) y /\ (winding (ring_edges ring) y < 0)%Z) ->
  area ring < 0.
Proof.
  intros H (y & N & W). rewrite area_under. pose proof (ring_closed ring) as Cl.
  set (E := ring_edges ring) in *. clearbody E.
  set (swap := fun e : point * point => (snd e, fst e)).
  assert (Wi : forall E y, winding (map swap E) y = (- winding E y)%Z).
  { clear. induction E as [|[a b] E IH]; intros y; [reflexivity|].
    change (crossing b a y + winding (map swap E) y = - (crossing a b y + winding E y))%Z.
    rewrite IH, crossing_reversed. ring. }
  assert (On : forall y, on_some (map swap E) y -> on_some E y).
  { intros z (a & b & I & O). apply in_map_iff in I. destruct I as ([c d] & Q & I).
    unfold swap in Q. injection Q; intros <- <-. exists c, d. split; auto. apply segment_swap, O. }
  assert (Of : forall y, on_some E y -> on_some (map swap E) y).
  { intros z (a & b & I & O). exists b, a. split; [exact (in_map swap _ _ I)|].
    apply segment_swap, O. }
  assert (P : 0 < sumr under (map swap E)).
  { apply (area_positive (map swap E)) with (y := y).
    - unfold closed. rewrite !map_map. cbn [swap fst snd]. apply Permutation_sym, Cl.
    - intros z Z. rewrite Wi. assert (Nz : ~ on_some E z) by (intros O; apply Z, Of, O).
      specialize (H z Nz). lia.
    - intros O. apply N, On, O.
    - rewrite Wi. lia. }
  rewrite sumr_map in P. assert (S : sumr (fun e => under (swap e)) E = - 1 * sumr under E).
  { rewrite <- sumr_times. apply sumr_ext. intros [a b] _. unfold under, swap; cbn [fst snd].
    ring. }
  lra.
Qed.
