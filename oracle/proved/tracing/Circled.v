(** How often rings around an open set wind: a ring winds equally often around all of the set, and
    once less around what is beyond; and all rings together once around the set. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Curves Local Across Overlaps Components
  Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Coloured Upright Traced Permuted Bounding Areas.
Open Scope R_scope.

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

Section Circled.
Variable C : point -> Prop.
Hypothesis C_open : forall x, C x -> interior C x.
Hypothesis C_joined : forall x y, C x -> C y -> joined C x y.
Variable centre : point.
Hypothesis C_centre : C centre.
Variable high : R.
Hypothesis to_high : forall y, C y -> snd y <= high.
Variable E : list edge.
Variable few : list point.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis sided : forall e x, In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Hypothesis avoids : forall e x, In e E -> lies_on e x -> ~ C x.
Hypothesis steady_off : forall x, ~ over_some E x -> ~ In x few -> steady C x.
Hypothesis apart : ForallOrdPairs no_common E.

(** ** All pieces together *)
Section Together.
Hypothesis closes : closed (map R2e E).
Let W := winding (map R2e E).
Theorem wound_once : W centre = 1%Z.
Proof.
  assert (N : ~ over_some E centre) by (intros (e & I & O); exact (avoids e _ I O C_centre)).
  destruct (wound_near E closes centre N) as (r & R & K). destruct (C_open centre C_centre) as
    (s & Hs & Op).
  assert (P : 0 < Rmin r s) by (apply Rmin_glb_lt; auto).
  destruct (generic_line E few (fst centre - Rmin r s) (fst centre + Rmin r s)) as
    (X & Bx & Ge & Fe); [lra|].
  set (x := (X, snd centre)).
  assert (Nx : near (Rmin r s) centre x).
  { split; cbn [x fst snd]; [apply Rabs_def1; lra|]. rewrite Rminus_diag_eq, Rabs_R0; auto. }
  apply near_min in Nx. destruct Nx as [Nr Ns]. pose proof (Op x Ns) as Cx.
  destruct (K x Nr) as [Off Wx]. fold W in Wx. rewrite <- Wx.
  destruct (wound_on_line E long apart closes X Ge C high to_high sided) with (t := snd centre)
    as [[_ U]|[U _]]; auto; [|contradiction].
  intros t No. apply steady_off; auto. intros I. apply (Fe _ I). reflexivity.
Qed.
End Together.

(** ** One ring *)
Section Ring.
Variable l : list edge.
Hypothesis within : forall e, In e l -> In e E.
Hypothesis l_apart : ForallOrdPairs no_common l.
Hypothesis some_piece : l <> [].
Hypothesis closes : closed (map R2e l).
Let W := winding (map R2e l).
Let c := W centre.

Lemma around_set y : C y -> W y = c.
Proof.
  intros Y. symmetry. apply (joined_constant C W centre y (C_joined centre y C_centre Y)).
  intros p P. destruct (wound_near l closes p) as (r & R & K).
  - intros (e & I & O). exact (avoids e p (within e I) O P).
  - exists r. split; auto. intros q Q. apply (K q Q).
Qed.
Lemma l_long e : In e l -> start e <> finish e.
Proof. intros I. apply long, within, I. Qed.
(** Right of a piece *)
Lemma ring_right e x r n : In e l -> inside e x -> 0 < r ->
  (forall y, near r x y -> (0 < orient (start e) (finish e) y -> W y = (n + 1)%Z) /\
    (orient (start e) (finish e) y < 0 -> W y = n)) -> n = (c - 1)%Z.
Proof.
  intros I X R K. destruct (sided e x (within e I) X) as (s & S & L).
  destruct (left_close _ _ x (Rmin r s) (l_long e I) (inner_on_line _ _ _ X)) as (y & Y & O);
    [apply Rmin_glb_lt; auto|]. apply near_min in Y.
  pose proof (around_set y (proj1 (L y (proj2 Y)) O)).
  pose proof (proj1 (K y (proj1 Y)) O). lia.
Qed.
Definition ring_value (y : point) : Prop := W y = c \/ W y = (c - 1)%Z.
Lemma value_even X : (forall e, In e l -> X <> fst (start e) /\ X <> fst (finish e)) ->
  forall t, exists r, 0 < r /\ ((over_some l (X, t) -> forall y, near r (X, t) y ->
    ~ over_some l y -> ring_value y) /\ forall y z, near r (X, t) y -> near r (X, t) z ->
  ~ over_some l y -> ~ over_some l z -> ring_value y -> ring_value z).
Proof.
  intros Ge t. destruct (classic (over_some l (X, t))) as [(e & I & O)|No].
  - destruct (line_across l l_apart closes X Ge e t I O) as (r & n & R & K).
    destruct (wound_beside l l_apart closes e (X, t) I (line_inside l X Ge e t I O)
      (fun f J => line_inside l X Ge f t J)) as (r' & n' & R' & K').
    pose proof (ring_right e (X, t) r' n' I (line_inside l X Ge e t I O) R' K') as Q.
    exists (Rmin r r'). split; [apply Rmin_glb_lt; auto|].
    assert (G : forall y, near (Rmin r r') (X, t) y -> ~ over_some l y -> ring_value y).
    { intros y Y Ny. apply near_min in Y. destruct (K' y (proj2 Y)) as [A B].
      destruct (K y (proj1 Y) Ny) as [[O' _]|[O' _]]; unfold ring_value, W;
        [left; rewrite A|right; rewrite B]; auto; lia. }
    split; [auto|]. intros y z Y Z Ny Nz _. auto.
  - destruct (wound_near l closes _ No) as (r & R & K). exists r. split; auto.
    split; [intros O; contradiction|]. intros y z Y Z _ _. unfold ring_value, W.
    rewrite (proj2 (K y Y)), (proj2 (K z Z)). auto.
Qed.
Lemma value_line X t u : (forall e, In e l -> X <> fst (start e) /\ X <> fst (finish e)) ->
  all_near l X ring_value t -> all_near l X ring_value u.
Proof.
  intros Ge. apply (even_line l l_long). intros v. destruct (value_even X Ge v) as (r & R & _ & K).
  exists r. auto.
Qed.
(** A point inside a piece, and no end of another, and what is right of it *)
Lemma inside_alone e : In e l -> exists x, inside e x /\
  forall f, In f l -> lies_on f x -> inside f x.
Proof.
  intros I. destruct (one_not_in (map start l ++ map finish l) _ _ (l_long e I)) as (x & X & N).
  exists x. split; [exact X|]. intros f J O. apply inner_of_segment; auto; intros ->; apply N,
    in_or_app; [left|right]; apply in_map, J.
Qed.
Lemma beyond : exists y, ~ over_some l y /\ W y = (c - 1)%Z.
Proof.
  assert (Some_ : exists e, In e l).
  { clear - some_piece. destruct l as [|e k]; [destruct (some_piece eq_refl)|].
    exists e. simpl. auto. }
  destruct Some_ as (e & I).
  destruct (inside_alone e I) as (x & X & Only).
  destruct (wound_beside l l_apart closes e x I X Only) as (r & n & R & K).
  pose proof (ring_right e x r n I X R K) as Q.
  destruct (right_close _ _ x r (l_long e I) (inner_on_line _ _ _ X) R) as (y & Y & O).
  destruct (near_within x y r Y) as (s & S & In_r). destruct (near_right _ _ y O) as (t & Ht & L).
  destruct (aside_near l l_long y (Rmin s t)) as (z & Z & N & _); [apply Rmin_glb_lt; auto|].
  apply near_min in Z. exists z. split; auto. rewrite <- Q.
  apply (K z (In_r z (proj1 Z))), L, Z.
Qed.
Lemma sloping : exists e, In e l /\ fst (start e) <> fst (finish e).
Proof.
  apply NNPP. intros N.
  assert (Z : forall k, (forall e, In e k -> In e l) -> forall y, winding (map R2e k) y = 0%Z).
  { induction k as [|e k IH]; intros Sub y; [reflexivity|].
    change (crossing (start e) (finish e) y + winding (map R2e k) y = 0)%Z.
    rewrite crossing_vertical, IH; auto.
    - intros f I. apply Sub. simpl. auto.
    - apply NNPP. intros D. apply N. exists e. split; auto. apply Sub. simpl. auto. }
  destruct beyond as (y & _ & V). unfold c, W in V.
  rewrite !(Z l (fun e I => I)) in V. discriminate V.
Qed.
Lemma ring_far X : exists h, forall t, h < t -> forall y, near (1 / 2) (X, t) y -> W y = 0%Z.
Proof.
  destruct (winding_above (map R2e l)) as (h & H). exists (h + 1). intros t T y [_ Y].
  cbn [snd] in Y. apply Rabs_def2 in Y. apply H. lra.
Qed.
Theorem ring_kind : c = 0%Z \/ c = 1%Z.
Proof.
  destruct sloping as (e & I & N).
  assert (L : Rmin (fst (start e)) (fst (finish e)) < Rmax (fst (start e)) (fst (finish e))).
  { unfold Rmin, Rmax. destruct (Rle_dec (fst (start e)) (fst (finish e))); lra. }
  destruct (generic_line l [] _ _ L) as (X & B & Ge & _).
  assert (O : lies_on e (X, line_at (start e) (finish e) X)).
  { apply inside_on, inside_line; auto. revert B. unfold Rmin, Rmax.
    destruct (Rle_dec (fst (start e)) (fst (finish e))); lra. }
  set (u := line_at (start e) (finish e) X) in *. destruct (ring_far X) as (h & H).
  assert (P : all_near l X ring_value u).
  { destruct (value_even X Ge u) as (r & R & K & _). exists r. split; auto. apply K.
    exists e. auto. }
  destruct (value_line X u (h + 1) Ge P) as (r & R & K).
  destruct (aside_near l l_long (X, h + 1) (Rmin r (1 / 2))) as (y & Y & Ny & _);
    [apply Rmin_glb_lt; lra|]. apply near_min in Y. destruct (K y (proj1 Y) Ny) as [V|V];
    rewrite (H (h + 1) ltac:(lra) y (proj2 Y)) in V; [left|right]; lia.
Qed.
Theorem ring_values y : ~ over_some l y -> ring_value y.
Proof.
  intros N. destruct (wound_near l closes y N) as (r & R & K).
  destruct (generic_line l [] (fst y - r) (fst y + r)) as (X & B & Ge & _); [lra|].
  destruct (ring_far X) as (h & H).
  assert (P : all_near l X ring_value (h + 1)).
  { exists (1 / 2). split; [lra|]. intros z Z _. unfold ring_value.
    rewrite (H (h + 1) ltac:(lra) z Z). destruct ring_kind; lia. }
  assert (Nx : near r y (X, snd y)).
  { split; cbn [fst snd]; [apply Rabs_def1; lra|]. rewrite Rminus_diag_eq, Rabs_R0; auto. }
  destruct (K _ Nx) as [Off V]. unfold ring_value. fold W in V. rewrite <- V.
  destruct (value_line X (h + 1) (snd y) Ge P) as (s & S & L).
  apply (L (X, snd y)); auto. apply near_self, S.
Qed.
(** A ring with the set inside of it, or outside *)
Theorem ring_sign :
  (c = 1%Z /\ (forall y, ~ over_some l y -> (0 <= W y)%Z) /\
    exists y, ~ over_some l y /\ (0 < W y)%Z) \/
  (c = 0%Z /\ (forall y, ~ over_some l y -> (W y <= 0)%Z) /\
    exists y, ~ over_some l y /\ (W y < 0)%Z).
Proof.
  destruct ring_kind as [Z|Z]; [right|left]; (split; [exact Z|split]).
  - intros y N. destruct (ring_values y N); lia.
  - destruct beyond as (y & N & V). exists y. split; auto. lia.
  - intros y N. destruct (ring_values y N); lia.
  - exists centre. split; [intros (e & I & O); exact (avoids e _ (within e I) O C_centre)|].
    fold c. lia.
Qed.
End Ring.
End Circled.
