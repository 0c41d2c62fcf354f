(** Closed pieces along an upright line that meets no end of one: what they wind changes by one at
    each piece. So they wind once around a set that they bound, and not around what is beside it. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Legal Member Pieces Slabs Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells.
Open Scope R_scope.

Section Line.
Variable G : list edge.
Hypothesis long : forall e, In e G -> start e <> finish e.
Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Let W := winding (map R2e G).
Hypothesis closes : closed (map R2e G).

Lemma over_real y : over_some G y <-> on_some (map R2e G) y.
Proof.
  unfold over_some, on_some. split.
  - intros (e & I & O). exists (start e), (finish e). split; [exact (in_map R2e _ _ I)|exact O].
  - intros (a & b & I & O). apply in_map_iff in I. destruct I as (e & Q & I).
    unfold R2e in Q. injection Q; intros <- <-. exists e. auto.
Qed.
Lemma wound_near y : ~ over_some G y -> exists r, 0 < r /\ forall z, near r y z ->
  ~ over_some G z /\ W z = W y.
Proof.
  intros N. destruct (over_near G y N) as (r & Hr & K).
  destruct (winding_here (map R2e G) y closes) as (s & Hs & L); [rewrite <- over_real; exact N|].
  exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros z Z. apply near_min in Z.
  split; [apply K|apply L]; tauto.
Qed.
(** On both sides of a point inside one piece alone *)
Lemma wound_beside e x : In e G -> inside e x ->
  (forall f, In f G -> lies_on f x -> inside f x) ->
  exists r n, 0 < r /\ forall y, near r x y ->
    (0 < orient (start e) (finish e) y -> W y = (n + 1)%Z) /\
    (orient (start e) (finish e) y < 0 -> W y = n).
Proof.
  intros I X Only. destruct (in_split _ _ I) as (l & k & Sp).
  assert (Off : forall f, In f (map R2e l ++ map R2e k) -> ~ on_segment (fst f) (snd f) x).
  { intros f J O. rewrite <- map_app in J. apply in_map_iff in J. destruct J as (g & <- & J).
    assert (Ig : In g G) by (rewrite Sp; apply in_app_or in J; apply in_or_app; simpl; tauto).
    pose proof (Only g Ig O) as Xg. rewrite Sp in apart.
    destruct (Rounds.pairs_at _ _ _ _ apart) as [Pl Pr].
    apply in_app_or in J. destruct J as [J|J]; [apply (Pl g J x)|apply (Pr g J x)]; auto. }
  assert (Hd : held x (map R2e G) [R2e e]).
  { rewrite Sp, map_app. cbn [map]. apply held_only; auto. }
  destruct (winding_across (map R2e G) [R2e e] x closes Hd) as (r & n & R & K).
  exists r, n. split; auto. intros y Y.
  assert (V : orient (start e) (finish e) y <> 0 ->
    W y = (n + Across.is_left_of (start e) (finish e) y)%Z).
  { intros O. unfold W. rewrite (K y Y); [simpl; unfold start, finish; lia|].
    intros f [<-|[]]. exact O. }
  split; intros O; rewrite V by lra; unfold Across.is_left_of;
    destruct (Rlt_dec 0 (orient (start e) (finish e) y)); try lra; lia.
Qed.

Variable X : R.
Hypothesis generic : forall e, In e G -> X <> fst (start e) /\ X <> fst (finish e).
Lemma line_inside e t : In e G -> lies_on e (X, t) -> inside e (X, t).
Proof.
  intros I O. destruct (generic e I) as [A B].
  apply inner_of_segment; auto; intros Z; [apply A|apply B]; exact (f_equal fst Z).
Qed.
Lemma line_across e t : In e G -> lies_on e (X, t) -> exists r n, 0 < r /\
  forall y, near r (X, t) y -> ~ over_some G y ->
    (0 < orient (start e) (finish e) y /\ W y = (n + 1)%Z) \/
    (orient (start e) (finish e) y < 0 /\ W y = n).
Proof.
  intros I O. destruct (wound_beside e (X, t) I (line_inside e t I O)
    (fun f J => line_inside f t J)) as (r & n & R & K).
  destruct (generic e I) as [A B]. pose proof (proj1 (proj2 (segment_range _ _ _ O))) as Ra.
  cbn [fst] in Ra. fold (start e) (finish e) in Ra.
  set (s := Rmin (Rabs (X - fst (start e))) (Rabs (X - fst (finish e)))).
  assert (S : 0 < s) by (apply Rmin_glb_lt; apply Rabs_pos_lt; lra).
  exists (Rmin r s), n. split; [apply Rmin_glb_lt; auto|]. intros y Y N. apply near_min in Y.
  destruct Y as [Y1 [Y2 _]]. destruct (K y Y1) as [K1 K2]. cbn [fst] in Y2.
  assert (Z : fst (start e) < fst y < fst (finish e) \/ fst (finish e) < fst y < fst (start e)).
  { unfold s in Y2. pose proof (Rmin_l (Rabs (X - fst (start e))) (Rabs (X - fst (finish e)))).
    pose proof (Rmin_r (Rabs (X - fst (start e))) (Rabs (X - fst (finish e)))).
    revert Y2 H H0. generalize (Rmin (Rabs (X - fst (start e))) (Rabs (X - fst (finish e)))).
    intros q Y2 H H0. apply Rabs_def2 in Y2.
    unfold Rabs in H, H0. destruct (Rcase_abs (X - fst (start e))),
      (Rcase_abs (X - fst (finish e))); lra. }
  destruct (Rtotal_order (orient (start e) (finish e) y) 0) as [H|[H|H]]; auto.
  exfalso. apply N. exists e. split; auto. apply inside_on. unfold inside.
  assert (Ne : fst (start e) <> fst (finish e)) by lra.
  rewrite (surjective_pairing y). apply inside_line; auto.
  rewrite orient_line in H by exact Ne. apply Rmult_integral in H. lra.
Qed.

Section Even.
Variable T : point -> Prop.
Definition all_near (t : R) : Prop := exists r, 0 < r /\ forall y, near r (X, t) y ->
  ~ over_some G y -> T y.
(** Near each point of the line it holds everywhere or nowhere. *)
Hypothesis even : forall t, exists r, 0 < r /\ forall y z, near r (X, t) y -> near r (X, t) z ->
  ~ over_some G y -> ~ over_some G z -> T y -> T z.
Lemma even_line t u : all_near t -> all_near u.
Proof.
  intros H. apply (all_between all_near t u H). clear H. intros w _. generalize w. clear t u w.
  intros u. destruct (even u) as (r & R & K). exists (r / 2). split; [lra|]. intros v V.
  assert (Near : forall a, Rabs (a - u) < r / 2 -> near (r / 2) (X, u) (X, a)).
  { intros a A. split; cbn [fst snd]; auto. rewrite Rminus_diag_eq, Rabs_R0; auto. lra. }
  assert (Go : forall a b, Rabs (a - u) < r / 2 -> Rabs (b - u) < r / 2 -> all_near a ->
    all_near b).
  { intros a b A Bu (s & S & L).
    destruct (aside_near G long (X, a) (Rmin s (r / 2))) as (y & Y & N & _);
      [apply Rmin_glb_lt; lra|]. apply near_min in Y. destruct Y as [Y1 Y2].
    exists (r / 2). split; [lra|]. intros z Z Nz. apply (K y z); auto.
    - exact (near_near r _ _ y (Near a A) Y2).
    - exact (near_near r _ _ z (Near b Bu) Z). }
  assert (U : Rabs (u - u) < r / 2) by (rewrite Rminus_diag_eq, Rabs_R0; auto; lra).
  split; apply Go; auto.
Qed.
End Even.

(** A set with the pieces along it, on their left *)
Variable S : point -> Prop.
Variable high : R.
Hypothesis to_high : forall y, S y -> snd y <= high.
Hypothesis sided : forall e x, In e G -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> S y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Hypothesis steady_off : forall t, ~ over_some G (X, t) -> steady S (X, t).
Theorem wound_on_line t : ~ over_some G (X, t) ->
  (S (X, t) /\ W (X, t) = 1%Z) \/ (~ S (X, t) /\ W (X, t) = 0%Z).
Proof.
  intros N. set (T := fun y => (S y /\ W y = 1%Z) \/ (~ S y /\ W y = 0%Z)).
  assert (Ev : forall t, exists r, 0 < r /\ forall y z, near r (X, t) y -> near r (X, t) z ->
    ~ over_some G y -> ~ over_some G z -> T y -> T z).
  { clear t N. intros t. destruct (classic (over_some G (X, t))) as [(e & I & O)|No].
    - destruct (line_across e t I O) as (r1 & n & R1 & K1).
      destruct (sided e (X, t) I (line_inside e t I O)) as (r2 & R2 & K2).
      exists (Rmin r1 r2). split; [apply Rmin_glb_lt; auto|]. intros y z Y Z Ny Nz.
      apply near_min in Y. apply near_min in Z.
      destruct (K1 y (proj1 Y) Ny) as [[Y1 Y2]|[Y1 Y2]],
        (K1 z (proj1 Z) Nz) as [[Z1 Z2]|[Z1 Z2]];
        pose proof (K2 y (proj2 Y)); pose proof (K2 z (proj2 Z)); unfold T, W in *;
        intros [[U1 U2]|[U1 U2]]; try tauto; [left|right|left|right];
        (split; [tauto|lia]).
    - destruct (wound_near _ No) as (r1 & R1 & K1). destruct (steady_off t No) as (r2 & R2 & K2).
      exists (Rmin r1 r2). split; [apply Rmin_glb_lt; auto|]. intros y z Y Z _ _.
      apply near_min in Y. apply near_min in Z. unfold T.
      rewrite (proj2 (K1 y (proj1 Y))), (proj2 (K1 z (proj1 Z))), (K2 y (proj2 Y)),
        (K2 z (proj2 Z)). auto. }
  destruct (winding_above (map R2e G)) as (h & H). set (m := Rmax h high + 1).
  assert (Far : all_near T m).
  { exists (1 / 2). split; [lra|]. intros y [_ Y] _. cbn [snd] in Y. apply Rabs_def2 in Y.
    pose proof (Rmax_l h high). pose proof (Rmax_r h high). unfold m in Y. right. split.
    - intros Sy. apply to_high in Sy. lra.
    - apply H. lra. }
  destruct (even_line T Ev m t Far) as (q & Q & L). exact (L (X, t) (near_self q _ Q) N).
Qed.
End Line.
