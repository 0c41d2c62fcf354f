(** The frontier of a closed set that is the closure of its interior, and begins and ends only where
    segments run: it is on the pieces that the program keeps. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Along Cuts Lone Flanks Kept.
Open Scope R_scope.

(** Near a point all is in the set, or nothing. *)
Definition steady (S : point -> Prop) (x : point) : Prop :=
  exists r, 0 < r /\ forall y, near r x y -> (S y <-> S x).
Lemma steady_along S y z : (forall p, on_segment y z p -> steady S p) -> (S y <-> S z).
Proof.
  intros H. split; intros Hy.
  - exact (all_along S y z Hy H).
  - apply (all_along S z y Hy). intros p P. apply H, segment_swap, P.
Qed.
(** A set with all of the points that its interior comes near to, and no others *)
Definition is_regular (S : point -> Prop) : Prop := is_closed S /\
  forall x r, S x -> 0 < r -> exists y, near r x y /\ interior S y.

(** What a program says of the points that are on no segment *)
Definition decides (is_in : vertex -> bool) (all : list edge) (S : point -> Prop) : Prop :=
  forall v, ~ over_some all (R2 v) -> (is_in v = true <-> S (R2 v)).

Section Set_.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.

Lemma isolated x r : 0 < r -> (forall y, near r x y -> y <> x -> steady S y) -> steady S x.
Proof.
  intros R H. destruct regular as [Closed Reg].
  set (z := (fst x + r / 2, snd x)). set (w := (fst x, snd x + r / 2)).
  assert (Nz : near r x z) by (split; apply Rabs_def1; simpl; lra).
  assert (Nw : near r x w) by (split; apply Rabs_def1; simpl; lra).
  assert (Walk : forall y v, near r x y -> near r x v -> ~ on_segment y v x -> (S y <-> S v)).
  { intros y v Y V N. apply steady_along. intros p P. apply H.
    - exact (near_between r x y v p Y V P).
    - intros ->. contradiction. }
  assert (Zw : S w <-> S z).
  { apply Walk; auto. intros (t & T & E). apply (f_equal fst) in E as E1.
    apply (f_equal snd) in E as E2. unfold z, w in *; cbn [fst snd] in *.
    assert (t * (r / 2) = 0) by lra. assert ((1 - t) * (r / 2) = 0) by lra. nra. }
  assert (All : forall y, near r x y -> y <> x -> (S y <-> S z)).
  { intros y Y N. destruct (classic (on_segment y z x)) as [(t & T & E)|Q]; [|apply Walk; auto].
    rewrite <- Zw. apply Walk; auto. intros (u & U & F). apply N.
    apply (f_equal snd) in E as E2. apply (f_equal fst) in E as E1.
    apply (f_equal fst) in F as F1. apply (f_equal snd) in F as F2.
    unfold z, w in *; cbn [fst snd] in *. apply point_eq.
    - assert (Z : (1 - u) * (fst x - fst y) = 0) by lra. apply Rmult_integral in Z.
      destruct Z as [Z|Z]; [|lra]. assert (u = 1) by lra. subst u. lra.
    - assert (Z : (1 - t) * (snd x - snd y) = 0) by lra. apply Rmult_integral in Z.
      destruct Z as [Z|Z]; [|lra]. assert (t = 1) by lra. subst t. lra. }
  exists r. split; auto. intros y Y. destruct (classic (S z)) as [Sz|Sz].
  - assert (Sx : S x).
    { apply Closed. intros e He. set (k := Rmin e r / 2).
      assert (K : 0 < k /\ k < e /\ k < r).
      { unfold k. pose proof (Rmin_l e r). pose proof (Rmin_r e r).
        assert (0 < Rmin e r) by (apply Rmin_glb_lt; auto). lra. }
      exists (fst x + k, snd x). split; [split; apply Rabs_def1; simpl; lra|].
      apply All; auto.
      - split; apply Rabs_def1; simpl; lra.
      - intros E. apply (f_equal fst) in E. simpl in E. lra. }
    destruct (classic (y = x)) as [->|N]; [tauto|]. specialize (All y Y N). tauto.
  - assert (Sx : ~ S x).
    { intros Sx. destruct (Reg x r Sx R) as (p & P & (e & He & Q)).
      destruct (classic (p = x)) as [->|N].
      2: { apply Sz, (All p P N), Q, near_self, He. }
      set (k := Rmin e r / 2). assert (K : 0 < k /\ k < e /\ k < r).
      { unfold k. pose proof (Rmin_l e r). pose proof (Rmin_r e r).
        assert (0 < Rmin e r) by (apply Rmin_glb_lt; auto). lra. }
      apply Sz, (All (fst x + k, snd x)).
      - split; apply Rabs_def1; simpl; lra.
      - intros E. apply (f_equal fst) in E. simpl in E. lra.
      - apply Q. split; apply Rabs_def1; simpl; lra. }
    destruct (classic (y = x)) as [->|N]; [tauto|]. specialize (All y Y N). tauto.
Qed.

(** Where both sides of a line are alike, nothing begins at it. *)
Lemma both_in a b x r : a <> b -> 0 < r -> (forall y, near r x y -> orient a b y <> 0 -> S y) ->
  steady S x.
Proof.
  intros N R H. destruct regular as [Closed _].
  assert (G : forall y, near r x y -> S y).
  { intros y Y. destruct (Req_dec (orient a b y) 0) as [Z|Z]; auto.
    apply Closed. intros e He. assert (D : exists d, 0 < d /\ forall q, near d y q -> near r x q).
    { destruct Y as [Y1 Y2]. exists (Rmin (r - Rabs (fst y - fst x)) (r - Rabs (snd y - snd x))).
      split; [apply Rmin_glb_lt; lra|]. intros q Q. apply near_min in Q.
      destruct Q as [[Q1 _] [_ Q2]]. split.
      - replace (fst q - fst x) with ((fst q - fst y) + (fst y - fst x)) by ring.
        eapply Rle_lt_trans; [apply Rabs_triang|lra].
      - replace (snd q - snd x) with ((snd q - snd y) + (snd y - snd x)) by ring.
        eapply Rle_lt_trans; [apply Rabs_triang|lra]. }
    destruct D as (d & Hd & D). destruct (left_close a b y (Rmin e d) N Z) as (q & Q & L).
    { apply Rmin_glb_lt; auto. }
    apply near_min in Q. exists q. split; [tauto|]. apply H; [apply D; tauto|lra]. }
  exists r. split; auto. intros y Y. pose proof (G y Y). pose proof (G x (near_self r x R)). tauto.
Qed.
Lemma both_out a b x r : a <> b -> 0 < r -> (forall y, near r x y -> orient a b y <> 0 -> ~ S y) ->
  steady S x.
Proof.
  intros N R H. destruct regular as [_ Reg].
  assert (G : forall y, near (r / 2) x y -> ~ S y).
  { intros y Y Sy. destruct (Reg y (r / 2) Sy ltac:(lra)) as (p & P & (e & He & Q)).
    assert (Xp : near r x p) by exact (near_near r x y p Y P).
    assert (D : exists d, 0 < d /\ forall q, near d p q -> near r x q).
    { destruct Xp as [Y1 Y2]. exists (Rmin (r - Rabs (fst p - fst x)) (r - Rabs (snd p - snd x))).
      split; [apply Rmin_glb_lt; lra|]. intros q O. apply near_min in O.
      destruct O as [[Q1 _] [_ Q2]]. split.
      - replace (fst q - fst x) with ((fst q - fst p) + (fst p - fst x)) by ring.
        eapply Rle_lt_trans; [apply Rabs_triang|lra].
      - replace (snd q - snd x) with ((snd q - snd p) + (snd p - snd x)) by ring.
        eapply Rle_lt_trans; [apply Rabs_triang|lra]. }
    destruct D as (d & Hd & D). destruct (Req_dec (orient a b p) 0) as [Z|Z].
    - destruct (left_close a b p (Rmin e d) N Z) as (q & O & L); [apply Rmin_glb_lt; auto|].
      apply near_min in O. apply (H q); [apply D; tauto|lra|apply Q; tauto].
    - apply (H p Xp Z), Q, near_self, He. }
  exists (r / 2). split; [lra|]. intros y Y. pose proof (G y Y).
  pose proof (G x (near_self (r / 2) x ltac:(lra))). tauto.
Qed.

(** ** The pieces that are kept *)
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.

Lemma constant_out x : ~ over_some all x -> steady (fun y => ~ S y) x.
Proof.
  intros N. destruct (constant x N) as (r & R & H). exists r. split; auto.
  intros y Y. rewrite (H y Y). tauto.
Qed.
Lemma decided_out v : ~ over_some all (R2 v) -> (is_in v = false <-> ~ S (R2 v)).
Proof. intros N. rewrite <- (decided v N), not_true_iff_false. reflexivity. Qed.
Lemma kept_from e : In e B -> exists p, In p (pieces all) /\
  ((e = p /\ S (R2 (fst (beside all p))) /\ ~ S (R2 (snd (beside all p)))) \/
   (e = (snd p, fst p) /\ ~ S (R2 (fst (beside all p))) /\ S (R2 (snd (beside all p))))).
Proof.
  intros I. apply in_flat_map in I. destruct I as (p & Ip & I). exists p. split; auto.
  destruct (tested_clear all all_forward p Ip) as [L R].
  destruct (beside all p) as [l r]. cbn [fst snd] in *.
  rewrite <- (decided_out l L), <- (decided_out r R), <- (decided l L), <- (decided r R).
  destruct (is_in l), (is_in r); try destruct I as [<-|[]]; try destruct I; auto.
Qed.
Theorem kept_sided e x : In e B -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> S y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Proof.
  intros I X. destruct (kept_from e I) as (p & Ip & [(-> & L & R)|(-> & L & R)]).
  - destruct (left_all all all_forward p Ip S constant x L X) as (r & Hr & K).
    destruct (right_all all all_forward p Ip _ constant_out x R X) as (s & Hs & M).
    exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
    split; intros O; [apply K|apply M]; tauto.
  - assert (X' : inside p x).
    { destruct X as (w & W & E). exists (1 - w). split; [lra|]. rewrite E.
      unfold start, finish; cbn [fst snd]. f_equal; ring. }
    destruct (left_all all all_forward p Ip _ constant_out x L X') as (r & Hr & K).
    destruct (right_all all all_forward p Ip S constant x R X') as (s & Hs & M).
    exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
    change (start (snd p, fst p)) with (finish p). change (finish (snd p, fst p)) with (start p).
    rewrite orient_swap. split; intros O; [apply M|apply K]; try tauto; lra.
Qed.
Lemma kept_on p e x : e = p \/ e = (snd p, fst p) -> lies_on p x -> lies_on e x.
Proof. intros [->| ->] O; auto. apply segment_swap, O. Qed.
Lemma unkept p x : In p (pieces all) -> inside p x -> ~ over_some B x -> steady S x.
Proof.
  intros I X N.
  assert (K : forall e, (let (l, r) := beside all p in match is_in l, is_in r with
      | true, false => [p] | false, true => [(snd p, fst p)] | _, _ => [] end) = [e] ->
      (e = p \/ e = (snd p, fst p)) -> False).
  { intros e E H. apply N. exists e. split.
    - apply in_flat_map. exists p. split; auto. rewrite E. simpl. auto.
    - apply (kept_on p e x H), inside_on, X. }
  pose proof (before_different _ _ (piece_forward all all_forward p I)) as D.
  destruct (tested_clear all all_forward p I) as [Cl Cr].
  destruct (beside all p) as [l r] eqn:Bs. cbn [fst snd] in Cl, Cr.
  destruct (is_in l) eqn:L, (is_in r) eqn:R; try (destruct (K _ eq_refl); auto; fail);
    (apply (decided l Cl) in L || apply (decided_out l Cl) in L);
    (apply (decided r Cr) in R || apply (decided_out r Cr) in R);
    replace l with (fst (beside all p)) in L by (rewrite Bs; reflexivity);
    replace r with (snd (beside all p)) in R by (rewrite Bs; reflexivity).
  - destruct (left_all all all_forward p I S constant x L X) as (u & Hu & U).
    destruct (right_all all all_forward p I S constant x R X) as (v & Hv & V).
    apply (both_in _ _ x (Rmin u v) D); [apply Rmin_glb_lt; auto|]. intros y Y O.
    apply near_min in Y. destruct (Rtotal_order (orient (start p) (finish p) y) 0) as [H|[H|H]];
      [apply V; tauto|contradiction|apply U; tauto].
  - destruct (left_all all all_forward p I _ constant_out x L X) as (u & Hu & U).
    destruct (right_all all all_forward p I _ constant_out x R X) as (v & Hv & V).
    apply (both_out _ _ x (Rmin u v) D); [apply Rmin_glb_lt; auto|]. intros y Y O.
    apply near_min in Y. destruct (Rtotal_order (orient (start p) (finish p) y) 0) as [H|[H|H]];
      [apply V; tauto|contradiction|apply U; tauto].
Qed.

(** The set begins and ends on kept pieces only. *)
Theorem steady_off_kept x : ~ over_some B x -> steady S x.
Proof.
  intros N. destruct (over_near B x N) as (r & Hr & R).
  destruct (near_all (pieces all) (fun p y => (y = start p -> y = x) /\ (y = finish p -> y = x)) x)
    as (s & Hs & Q).
  { assert (G : forall z, exists s, 0 < s /\ forall y, near s x y -> y = z -> y = x).
    { intros z. destruct (classic (z = x)) as [->|Z]; [exists 1; split; [lra|auto]|].
      destruct (segment_near z z x) as (s & Hs & M).
      - intros (t & _ & E). apply Z. rewrite E. destruct z; cbn [fst snd]. f_equal; ring.
      - exists s. split; auto. intros y Y ->. destruct (M z Y). apply on_segment_start. }
    intros p _. destruct (G (start p)) as (s & Hs & U). destruct (G (finish p)) as (t & Ht & V).
    exists (Rmin s t). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
    split; [apply U|apply V]; tauto. }
  apply (isolated x (Rmin r s)); [apply Rmin_glb_lt; auto|]. intros y Y Ny. apply near_min in Y.
  destruct Y as [Y1 Y2]. destruct (classic (over_some all y)) as [(f & If & O)|O]; auto.
  destruct (piece_cover all all_forward f y If O) as (p & Ip & Op).
  apply (unkept p y Ip); auto. destruct (Q y Y2 p Ip) as [A1 A2].
  apply inner_of_segment; auto.
Qed.
End Set_.
