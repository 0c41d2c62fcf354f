(** Up an upright line that meets no end of a piece: what holds near one of its points off closed
    pieces holds near all, where it passes from one side of each piece to the other. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Legal Member Pieces Slabs Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Traced Permuted Bounding Areas.
Open Scope R_scope.

Section Line.
Variable G : list edge.
Hypothesis long : forall e, In e G -> start e <> finish e.
Hypothesis apart : ForallOrdPairs no_common G.
Let W := winding (map R2e G).
Hypothesis closes : closed (map R2e G).

Lemma over_pieces y : over_some G y <-> on_some (map R2e G) y.
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
  destruct (winding_here (map R2e G) y closes) as (s & Hs & L); [rewrite <- over_pieces; exact N|].
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
End Line.
Lemma generic_line G (few : list point) lo hi : lo < hi -> exists X, lo < X < hi /\
  (forall e, In e G -> X <> fst (start e) /\ X <> fst (finish e)) /\
  forall p : point, In p few -> fst p <> X.
Proof.
  intros H. destruct (free_between ((map (fun e => fst (start e)) G ++
    map (fun e => fst (finish e)) G) ++ map (fun p : point => fst p) few) lo hi H) as (X & D & N).
  exists X. split; auto. split.
  - intros e I. split; intros ->; apply N, in_or_app; left; apply in_or_app; [left|right];
      [exact (in_map (fun e => fst (start e)) _ _ I)|
       exact (in_map (fun e => fst (finish e)) _ _ I)].
  - intros p I <-. apply N, in_or_app. right. exact (in_map (fun p : point => fst p) _ _ I).
Qed.
