(** Two closed segments have a point in common iff their boxes do and each lies on both sides of
  the other's line. *)
From Coq Require Import Lra Lia Psatz.
From Proved Require Import Definitions Crossings Bodies Local.
From Proved Require Import Paths Gaps Unique.
Open Scope R_scope.

Definition over_lap (a b c d : R) : Prop := Rmin a b <= Rmax c d /\ Rmin c d <= Rmax a b.
Definition straddle (a b c d : point) : Prop := orient a b c * orient a b d <= 0.
Lemma min_max a b : Rmin a b <= a <= Rmax a b /\ Rmin a b <= b <= Rmax a b.
Proof. unfold Rmin, Rmax. destruct (Rle_dec a b); lra. Qed.
Lemma within a b z : (a <= z <= b \/ b <= z <= a) <-> Rmin a b <= z <= Rmax a b.
Proof. unfold Rmin, Rmax. destruct (Rle_dec a b); split; lra. Qed.

Lemma mean_zero t x y : 0 <= t <= 1 -> (1 - t) * x + t * y = 0 -> x * y <= 0.
Proof.
  intros T E. destruct (Rle_dec x 0), (Rle_dec y 0); try nra.
Qed.
Lemma meets_overlap a b c d p : on_segment a b p -> on_segment c d p ->
  over_lap (fst a) (fst b) (fst c) (fst d) /\ over_lap (snd a) (snd b) (snd c) (snd d) /\
  straddle a b c d /\ straddle c d a b.
Proof.
  intros S T. pose proof (segment_range _ _ _ S) as (O1 & X1 & Y1).
  pose proof (segment_range _ _ _ T) as (O2 & X2 & Y2).
  rewrite within in X1, Y1, X2, Y2. unfold over_lap.
  split; [lra|split; [lra|]]. unfold straddle. split.
  - destruct T as (t & T & E). apply (mean_zero t); auto.
    transitivity (orient a b p); auto. rewrite E. unfold orient; cbn [fst snd]. ring.
  - destruct S as (t & U & E). apply (mean_zero t); auto.
    transitivity (orient c d p); auto. rewrite E. unfold orient; cbn [fst snd]. ring.
Qed.

Lemma at_between a b s t u : Rmin s u <= t <= Rmax s u -> on_segment (at_ a b s) (at_ a b u) (at_ a
  b t).
Proof.
  intros T. destruct (Req_dec s u) as [->|N].
  - replace t with u by (unfold Rmin, Rmax in T; destruct (Rle_dec u u); lra). apply
    on_segment_start.
  - exists ((t - s) / (u - s)). split.
    + assert (K : (t - s) / (u - s) * (u - s) = t - s) by (field; lra).
      set (k := (t - s) / (u - s)) in *. unfold Rmin, Rmax in T. destruct (Rle_dec s u); nra.
    + unfold at_; cbn [fst snd]. f_equal; field; lra.
Qed.
(** On one line: overlap of the boxes is enough. *)
Lemma collinear_meet a b c d : orient a b c = 0 -> orient a b d = 0 -> orient c d a = 0 ->
  over_lap (fst a) (fst b) (fst c) (fst d) -> over_lap (snd a) (snd b) (snd c) (snd d) ->
  exists p, on_segment a b p /\ on_segment c d p.
Proof.
  intros O1 O2 O3 X Y.
  assert (Line : forall k (f : point -> R), (forall p q t, f (at_ p q t) = f p + t * (f q - f p)) ->
    f b - f a = k -> k <> 0 -> (forall p, orient a b p = 0 -> p = at_ a b ((f p - f a) / k)) ->
    over_lap (f a) (f b) (f c) (f d) -> exists p, on_segment a b p /\ on_segment c d p).
  { intros k f Lin K Nz On [L1 L2]. set (tc := (f c - f a) / k). set (td := (f d - f a) / k).
    assert (Ec : f c = f a + tc * k) by (unfold tc; field; auto).
    assert (Ed : f d = f a + td * k) by (unfold td; field; auto).
    set (t := Rmax 0 (Rmin tc td)).
    assert (T : 0 <= t <= 1 /\ Rmin tc td <= t <= Rmax tc td).
    { rewrite Ec, Ed in L1, L2. replace (f b) with (f a + k) in L1, L2 by lra.
      unfold t, Rmin, Rmax in *.
      destruct (Rle_dec tc td), (Rle_dec (f a) (f a + k)), (Rle_dec (f a + tc * k) (f a + td * k));
        repeat match goal with |- context [Rle_dec ?x ?y] => destruct (Rle_dec x y) end; nra. }
    exists (at_ a b t). split; [apply at_on; tauto|].
    rewrite (On c O1), (On d O2). fold tc td. apply at_between. tauto. }
  destruct (Req_dec (fst b - fst a) 0) as [Z1|Z1]; [destruct (Req_dec (snd b - snd a) 0) as
    [Z2|Z2]|].
  - exists a. split; [apply on_segment_start|]. apply segment_by_orient; auto; apply within.
    + destruct X as [X1 X2]. replace (fst b) with (fst a) in * by lra.
      unfold Rmin at 1 in X1. unfold Rmax at 1 in X2. destruct (Rle_dec (fst a) (fst a)); lra.
    + destruct Y as [X1 X2]. replace (snd b) with (snd a) in * by lra.
      unfold Rmin at 1 in X1. unfold Rmax at 1 in X2. destruct (Rle_dec (snd a) (snd a)); lra.
  - apply (Line (snd b - snd a) snd); auto. intros p O. unfold orient, at_ in *.
    destruct p as [p1 p2]; cbn [fst snd] in *. f_equal; [|field; auto].
    rewrite Z1 in *. assert (p1 - fst a = 0) by nra. lra.
  - apply (Line (fst b - fst a) fst); auto. intros p O. unfold orient, at_ in *.
    destruct p as [p1 p2]; cbn [fst snd] in *. f_equal; [field; auto|].
    apply Rmult_eq_reg_l with (fst b - fst a); auto. field_simplify; auto. lra.
Qed.
Theorem segments_meet a b c d :
  (exists p, on_segment a b p /\ on_segment c d p) <->
  over_lap (fst a) (fst b) (fst c) (fst d) /\ over_lap (snd a) (snd b) (snd c) (snd d) /\
  straddle a b c d /\ straddle c d a b.
Proof.
  split; [intros (p & S & T); exact (meets_overlap a b c d p S T)|].
  intros (X & Y & S & T). unfold straddle in *.
  set (D := (fst b - fst a) * (snd d - snd c) - (snd b - snd a) * (fst d - fst c)).
  assert (E1 : orient a b d - orient a b c = D) by (unfold orient, D; ring).
  assert (E2 : orient c d b - orient c d a = - D) by (unfold orient, D; ring).
  destruct (Req_dec D 0) as [Z|Z].
  - assert (orient a b c = 0) by nra. assert (orient c d a = 0) by nra.
    apply collinear_meet; auto; lra.
  - set (t := orient c d a / D). set (u := - orient a b c / D).
    assert (Et : t * D = orient c d a) by (unfold t; field; auto).
    assert (Eu : u * D = - orient a b c) by (unfold u; field; auto).
    assert (P : 0 < D * D) by nra.
    assert (T1 : 0 <= t <= 1).
    { replace (orient c d a) with (t * D) in T by auto. replace (orient c d b) with ((t - 1) * D)
      in T by lra.
      split; apply Rnot_lt_le; intros L; assert (t * (t - 1) * (D * D) <= 0) by lra; assert (0 < t
        * (t - 1)) by nra; nra. }
    assert (U1 : 0 <= u <= 1).
    { replace (orient a b c) with (- u * D) in S by lra. replace (orient a b d) with ((1 - u) * D)
      in S by lra.
      split; apply Rnot_lt_le; intros L; assert (u * (u - 1) * (D * D) <= 0) by lra; assert (0 < u
        * (u - 1)) by nra; nra. }
    exists (at_ a b t). split; [apply at_on; auto|]. exists u. split; auto.
    unfold at_, t, u, orient. fold D. f_equal; cbn [fst snd]; apply Rmult_eq_reg_r with D; auto;
      field_simplify; auto; unfold D; ring.
Qed.
