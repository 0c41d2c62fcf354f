(** Pieces that close up wind once around what is in the set, and not around the rest. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Curves Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique.
From Proved Require Import Points Legal Member Pieces Slabs Along Cuts Lone Flanks Frontier Slabbed
  Cells Coloured.
Open Scope R_scope.

Section Wound.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.
Variable G : list edge.
Hypothesis steady_off : forall x, ~ over_some G x -> steady S x.
Hypothesis long : forall e, In e G -> start e <> finish e.
Hypothesis sided : forall e x, In e G -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> S y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Variable high : R.
Hypothesis to_high : forall y, S y -> snd y <= high.
Let E := map R2e G.
Hypothesis closes : closed E.

Lemma over_real y : over_some G y <-> on_some E y.
Proof.
  unfold over_some, on_some, E. split.
  - intros (e & I & O). exists (start e), (finish e). split; [exact (in_map R2e _ _ I)|exact O].
  - intros (a & b & I & O). apply in_map_iff in I. destruct I as (e & Q & I).
    unfold R2e in Q. injection Q; intros <- <-. exists e. auto.
Qed.
Definition right_there (y : point) : Prop :=
  (S y /\ winding E y = 1%Z) \/ (~ S y /\ winding E y = 0%Z).
(** All near a point off the pieces is as the point. *)
Lemma alike_near y : ~ over_some G y -> exists r, 0 < r /\ forall z, near r y z ->
  ~ over_some G z /\ (S z <-> S y) /\ winding E z = winding E y.
Proof.
  intros N. destruct (over_near G y N) as (r1 & R1 & K1).
    destruct (steady_off y N) as (r2 & R2 & K2).
  destruct (winding_here E y closes) as (r3 & R3 & K3); [rewrite <- over_real; exact N|].
  exists (Rmin r1 (Rmin r2 r3)). split; [repeat apply Rmin_glb_lt; auto|].
  intros z Z. apply near_min in Z. destruct Z as [Z1 Z]. apply near_min in Z. destruct Z as [Z2 Z3].
  split; [apply K1, Z1|split; [apply K2, Z2|apply K3, Z3]].
Qed.
(** Near a point inside a piece, that no other piece passes, both change together. *)
Lemma across_piece e x : In e G -> inside e x ->
  (forall f, In f G -> lies_on f x -> inside f x) ->
  exists r n, 0 < r /\ forall y, near r x y -> ~ over_some G y ->
    (S y /\ winding E y = (n + 1)%Z) \/ (~ S y /\ winding E y = n).
Proof.
  intros I X Only. destruct (in_split _ _ I) as (l & k & Sp).
  assert (Off : forall f, In f (map R2e l ++ map R2e k) -> ~ on_segment (fst f) (snd f) x).
  { intros f J O. rewrite <- map_app in J. apply in_map_iff in J. destruct J as (g & <- & J).
    assert (Ig : In g G) by (rewrite Sp; apply in_app_or in J; apply in_or_app; simpl; tauto).
    pose proof (Only g Ig O) as Xg. rewrite Sp in apart.
    destruct (Rounds.pairs_at _ _ _ _ apart) as [Pl Pr].
    apply in_app_or in J. destruct J as [J|J]; [apply (Pl g J x)|apply (Pr g J x)]; auto. }
  assert (Hd : held x E [R2e e]).
  { unfold E. rewrite Sp, map_app. cbn [map]. apply held_only; auto. }
  destruct (winding_across E [R2e e] x closes Hd) as (r1 & n & R1 & K1).
  destruct (sided e x I X) as (r2 & R2 & K2).
  exists (Rmin r1 r2), n. split; [apply Rmin_glb_lt; auto|]. intros y Y N.
  destruct (near_within x y _ Y) as (s & Hs & W).
  destruct (alike_near y N) as (t & Ht & A).
  (* a point beside the line of the piece *)
  assert (P : exists z, near (Rmin s t) y z /\ orient (start e) (finish e) z <> 0).
  { destruct (Req_dec (orient (start e) (finish e) y) 0) as [Z|Z].
    - destruct (left_close _ _ y (Rmin s t) (long e I) Z) as (z & Nz & L);
        [apply Rmin_glb_lt; auto|]. exists z. split; auto. lra.
    - exists y. split; auto. apply near_self, Rmin_glb_lt; auto. }
  destruct P as (z & Z & O). apply near_min in Z. destruct Z as [Zs Zt].
  destruct (A z Zt) as (_ & As & Aw). rewrite <- As, <- Aw.
  pose proof (W z Zs) as Zx. apply near_min in Zx. destruct Zx as [Zx1 Zx2].
  assert (V : winding E z = (n + Across.is_left_of (start e) (finish e) z)%Z).
  { rewrite (K1 z Zx1); [simpl; unfold start, finish; lia|]. intros f [<-|[]]. exact O. }
  rewrite V. unfold Across.is_left_of. destruct (Rlt_dec 0 (orient (start e)
    (finish e) z)) as [L|L].
  - left. split; [apply (K2 z Zx2), L|reflexivity].
  - right. split; [apply (K2 z Zx2); lra|lia].
Qed.

(** Up a line that meets no end of a piece *)
Lemma up_the_line X : (forall w, In w (walls G) -> X <> Q2R w) -> forall t,
  exists r, 0 < r /\ forall y, near r (X, t) y -> ~ over_some G y -> right_there y.
Proof.
  intros Off t.
  set (P := fun t => exists r, 0 < r /\ forall y, near r (X, t) y -> ~ over_some G y ->
    right_there y). change (P t).
  destruct (winding_above E) as (h & H).
  set (m := Rmax (Rmax h high) t + 1).
  assert (Hm : h < m - 1 / 2 /\ high < m - 1 / 2 /\ t < m).
  { unfold m. pose proof (Rmax_l (Rmax h high) t). pose proof (Rmax_r (Rmax h high) t).
    pose proof (Rmax_l h high). pose proof (Rmax_r h high). lra. }
  apply (all_between P m t).
  - exists (1 / 2). split; [lra|]. intros y [_ Y] _. cbn [snd] in Y. apply Rabs_def2 in Y. right.
    split; [|apply H; lra]. intros Sy. apply to_high in Sy. lra.
  - intros u _.
    assert (C : exists r n, 0 < r /\ forall y, near r (X, u) y -> ~ over_some G y ->
      (S y /\ winding E y = (n + 1)%Z) \/ (~ S y /\ winding E y = n)).
    { destruct (classic (over_some G (X, u))) as [(e & I & O)|N].
      - assert (Ins : forall f, In f G -> lies_on f (X, u) -> inside f (X, u)).
        { intros f J Of. destruct (wall_at G f J) as (p & q & Pp & Qq & Ep & Eq).
          apply inner_of_segment; auto; intros Z.
          - apply (Off p Pp). rewrite Ep. exact (f_equal fst Z).
          - apply (Off q Qq). rewrite Eq. exact (f_equal fst Z). }
        apply (across_piece e (X, u) I (Ins e I O) Ins).
      - destruct (alike_near _ N) as (r & R & K).
        destruct (classic (S (X, u))) as [Su|Su].
        + exists r, (winding E (X, u) - 1)%Z. split; auto. intros y Y _.
          destruct (K y Y) as (_ & A & W). left. split; [apply A, Su|lia].
        + exists r, (winding E (X, u)). split; auto. intros y Y _.
          destruct (K y Y) as (_ & A & W). right. split; [rewrite A; exact Su|exact W]. }
    destruct C as (r & n & R & C). exists (r / 2). split; [lra|]. intros v V.
    assert (Nv : near (r / 2) (X, u) (X, v)).
    { split; cbn [fst snd]; auto. rewrite Rminus_diag_eq, Rabs_R0; auto. lra. }
    assert (Zero : forall w, near (r / 2) (X, u) (X, w) -> P w -> n = 0%Z).
    { intros w W (s & Hs & K).
      destruct (aside_near G long (X, w) (Rmin s (r / 2))) as (y & Y & N & _);
        [apply Rmin_glb_lt; lra|]. apply near_min in Y. destruct Y as [Y1 Y2].
      destruct (C y (near_near r _ _ y W Y2) N) as [[C1 C2]|[C1 C2]],
        (K y Y1 N) as [[K1 K2]|[K1 K2]]; try contradiction; lia. }
    assert (Back : n = 0%Z -> forall w, near (r / 2) (X, u) (X, w) -> P w).
    { intros -> w W. exists (r / 2). split; [lra|]. intros y Y N.
      destruct (C y (near_near r _ _ y W Y) N) as [[C1 C2]|[C1 C2]]; [left|right]; split; auto. }
    split; intros K; apply Back; auto.
    + apply (Zero v Nv K).
    + apply near_self. lra.
    + apply (Zero u); auto. apply near_self. lra.
Qed.
Theorem winds_right y : ~ over_some G y -> right_there y.
Proof.
  intros N. destruct (alike_near y N) as (r & R & A).
  destruct (aside_near G long y r R) as (z & Z & Nz & W).
  destruct (A z Z) as (_ & As & Aw).
  destruct (up_the_line (fst z) W (snd z)) as (s & Hs & K). rewrite <- surjective_pairing in K.
  destruct (K z (near_self s z Hs) Nz) as [[K1 K2]|[K1 K2]]; [left|right].
  - rewrite <- Aw. tauto.
  - rewrite <- Aw. tauto.
Qed.
Theorem region_of_pieces x : region E x <-> S x.
Proof.
  destruct regular as [Closed Reg]. split.
  - intros H. apply Closed. intros e He. destruct (H e He) as (y & Y & O & W).
    exists y. split; auto. destruct (winds_right y) as [[K _]|[_ K]]; auto; [|lia].
    rewrite over_real. intros (a & b & I & S1). exact (O a b I S1).
  - intros Sx e He. destruct (Reg x (e / 2) Sx ltac:(lra)) as (p & P & (r & R & K)).
    destruct (aside_near G long p (Rmin r (e / 2))) as (y & Y & N & _); [apply Rmin_glb_lt; lra|].
    apply near_min in Y. destruct Y as [Y1 Y2]. exists y. split; [exact (near_near e x p y P Y2)|].
    split.
    + intros a b I O. apply N, over_real. exists a, b. auto.
    + destruct (winds_right y N) as [[_ W]|[W _]]; [lia|]. destruct (W (K y Y1)).
Qed.
End Wound.
