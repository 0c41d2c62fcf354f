(** The program's test of a point is right both ways: in_sum says yes iff the point is in the sum.
  *)
From Coq Require Import Lra Lia Psatz Permutation Classical Bool QArith Qreals Qreduction ZArith.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Canonical.
From Proved Require Import Paths Decomposed Gaps Unique Segments Legal Points.
Open Scope R_scope.

Notation R2 := point_of.
Definition R2e (e : vertex * vertex) : point * point := (R2 (fst e), R2 (snd e)).

(** ** Numbers *)
Lemma Q2R_red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma le_decides x y : Qle_bool x y = if Rle_dec (Q2R x) (Q2R y) then true else false.
Proof.
  destruct (Rle_dec (Q2R x) (Q2R y)) as [L|L].
  - apply Qle_bool_iff, Rle_Qle, L.
  - apply not_true_iff_false. rewrite Qle_bool_iff. intros K. apply L, Qle_Rle, K.
Qed.
Lemma less_decides x y : less x y = if Rlt_dec (Q2R x) (Q2R y) then true else false.
Proof.
  unfold less. rewrite le_decides.
  destruct (Rle_dec (Q2R y) (Q2R x)), (Rlt_dec (Q2R x) (Q2R y)); auto; lra.
Qed.
Lemma sg_neg q : (sg q <? 0)%Z = if Rlt_dec (Q2R q) 0 then true else false.
Proof.
  replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra).
  destruct (Rlt_dec (Q2R q) (Q2R 0)) as [L|L].
  - apply Rlt_Qlt in L. unfold Qlt in L. simpl in L. unfold sg. apply Z.ltb_lt. lia.
  - apply Z.ltb_ge. apply Rnot_lt_le, Rle_Qle in L. unfold Qle in L. simpl in L. unfold sg. lia.
Qed.
Lemma sg_pos q : (0 <? sg q)%Z = if Rlt_dec 0 (Q2R q) then true else false.
Proof.
  replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra).
  destruct (Rlt_dec (Q2R 0) (Q2R q)) as [L|L].
  - apply Rlt_Qlt in L. unfold Qlt in L. simpl in L. unfold sg. apply Z.ltb_lt. lia.
  - apply Z.ltb_ge. apply Rnot_lt_le, Rle_Qle in L. unfold Qle in L. simpl in L. unfold sg. lia.
Qed.
Lemma sg_product p q : (sg p * sg q <=? 0)%Z = true <-> Q2R p * Q2R q <= 0.
Proof.
  rewrite <- Q2R_mult. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra).
  unfold sg. rewrite <- Z.sgn_mul, Z.leb_le. split; intros H.
  - apply Qle_Rle. unfold Qle. simpl. lia.
  - apply Rle_Qle in H. unfold Qle in H. simpl in H. lia.
Qed.
Definition qturn a b p : Q := Points.qcross (difference b a) (difference p a).
Lemma qturn_real a b p : Q2R (qturn a b p) = orient (R2 a) (R2 b) (R2 p).
Proof.
  unfold qturn, Points.qcross, difference, orient, point_of. cbn [fst snd].
  rewrite Q2R_minus, !Q2R_mult, !Q2R_minus. ring.
Qed.
Lemma sub_real x p : R2 (sub x p) = minus_ (R2 x) (R2 p).
Proof. unfold sub, minus_, point_of. cbn [fst snd]. rewrite !Q2R_red, !Q2R_minus. reflexivity.
  Qed.

(** ** Winding numbers *)
Lemma crossing_real y a b : crossing_of y (a, b) = crossing (R2 a) (R2 b) (R2 y).
Proof.
  unfold crossing_of, crossing, side. fold (qturn a b y).
  rewrite !le_decides, less_decides, sg_neg, sg_pos, qturn_real.
  change (fst (R2 a)) with (Q2R (fst a)). change (fst (R2 b)) with (Q2R (fst b)).
  change (fst (R2 y)) with (Q2R (fst y)).
  destruct (Rle_dec (Q2R (fst a)) (Q2R (fst y))), (Rlt_dec (Q2R (fst y)) (Q2R (fst b))),
    (Rle_dec (Q2R (fst b)) (Q2R (fst y))), (Rlt_dec (orient (R2 a) (R2 b) (R2 y)) 0),
    (Rlt_dec 0 (orient (R2 a) (R2 b) (R2 y))); reflexivity.
Qed.
Lemma winding_real E y : winding_of E y = winding (map R2e E) (R2 y).
Proof.
  induction E as [|[a b] E IH]; [reflexivity|]. cbn [map]. unfold R2e at 1. cbn [fst snd].
  rewrite winding_cons, <- IH, <- crossing_real. reflexivity.
Qed.

(** ** Segments *)
Lemma disjoint_intervals a b c d : apart_on_axis a b c d = false <->
  over_lap (Q2R a) (Q2R b) (Q2R c) (Q2R d).
Proof.
  unfold apart_on_axis, over_lap, Rmin, Rmax. rewrite !less_decides.
  destruct (Rle_dec (Q2R a) (Q2R b)), (Rle_dec (Q2R c) (Q2R d));
    repeat match goal with |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y) end; simpl;
    (split; [intros H|intros [K1 K2]]); try discriminate; try reflexivity; try (split; lra);
    exfalso; lra.
Qed.
Theorem cross_real e f : have_common e f = true <->
  exists p, on_segment (R2 (fst e)) (R2 (snd e)) p /\ on_segment (R2 (fst f)) (R2 (snd f)) p.
Proof.
  rewrite segments_meet. unfold have_common, straddle, side.
  fold (qturn (fst e) (snd e) (fst f)) (qturn (fst e) (snd e) (snd f))
    (qturn (fst f) (snd f) (fst e)) (qturn (fst f) (snd f) (snd e)).
  rewrite <- !qturn_real. unfold point_of. cbn [fst snd]. rewrite <- !disjoint_intervals.
  destruct (apart_on_axis (fst (fst e)) _ _ _); [split; [discriminate|intros (K & _);
    discriminate]|].
  destruct (apart_on_axis (snd (fst e)) _ _ _); [split; [discriminate|intros (_ & K & _);
    discriminate]|].
  rewrite andb_true_iff, !sg_product. tauto.
Qed.

(** ** Points *)
Theorem decide_point_is_right E F c : let P := map R2e E in let Q := map R2e F in
  closed P -> closed Q -> decide_point E F c = true <->
    by_vertex_of_E P Q (R2 c) \/ by_vertex_of_F P Q (R2 c) \/ by_edges P Q (R2 c).
Proof.
  intros P Q CP CQ.
  unfold decide_point. rewrite !orb_true_iff, !existsb_exists.
  (* edges that have a point in common *)
  assert (Edges : (exists f, In f F /\ (let g := (sub c (fst f), sub c (snd f)) in
      existsb (fun e => have_common e g) E) = true) <-> by_edges P Q (R2 c)).
  { split.
    - intros (f & I & K). cbv zeta in K. apply existsb_exists in K. destruct K as (e & J & K).
      apply cross_real in K. destruct K as (p & Hp & Hq). cbn [fst snd] in Hq.
      rewrite !sub_real in Hq. exists p, (minus_ (R2 c) p). split; [|split].
      + exists (R2 (fst e)), (R2 (snd e)). split; auto. apply (in_map R2e) in J. exact J.
      + exists (R2 (fst f)), (R2 (snd f)). split; [apply (in_map R2e) in I; exact I|].
        destruct Hq as (t & T & ->). exists t. split; [exact T|].
        generalize (R2 c) (R2 (fst f)) (R2 (snd f)). intros [c1 c2] [f1 f2] [g1 g2].
        unfold minus_; cbn [fst snd]. f_equal; ring.
      + apply add_minus.
    - intros (p & q & (a & b & I & Hp) & (u & w & J & Hq) & X).
      apply in_map_iff in I. apply in_map_iff in J.
      destruct I as (e & Ee & I). destruct J as (f & Ef & J). exists f. split; auto. cbv zeta.
      apply existsb_exists. exists e. split; auto. apply cross_real. exists p.
      unfold R2e in Ee, Ef. injection Ee; intros <- <-. injection Ef; intros <- <-.
      split; auto. cbn [fst snd]. rewrite !sub_real.
      assert (Y : p = minus_ (R2 c) q).
      { rewrite X. unfold minus_, add. destruct p; cbn [fst snd]. f_equal; ring. }
      clear Hp. rewrite Y. clear Y X. destruct Hq as (t & T & ->). exists t. split; [exact T|].
      generalize (R2 c) (R2 (fst f)) (R2 (snd f)). intros [c1 c2] [f1 f2] [g1 g2].
      unfold minus_; cbn [fst snd]. f_equal; ring. }
  (* a vertex of one in the other, where it is on none of its edges *)
  assert (W : forall G H, closed (map R2e H) ->
    (forall z, on_some (map R2e G) z -> on_some (map R2e H) (minus_ (R2 c) z) ->
      by_edges P Q (R2 c)) -> ~ by_edges P Q (R2 c) ->
    ((exists e, In e G /\ (0 <? winding_of H (sub c (fst e)))%Z = true) <->
     exists a b, In (a, b) (map R2e G) /\ region (map R2e H) (minus_ (R2 c) a))).
  { intros G H CH Use N.
    assert (Off : forall e, In e G -> ~ on_some (map R2e H) (minus_ (R2 c) (R2 (fst e)))).
    { intros e I O. apply N, (Use (R2 (fst e))); auto. exists (R2 (fst e)), (R2 (snd e)). split.
      - apply (in_map R2e) in I. exact I.
      - apply on_segment_start. }
    split.
    - intros (e & I & K). exists (R2 (fst e)), (R2 (snd e)).
      split; [apply (in_map R2e) in I; exact I|]. apply region_off; [exact CH|apply (Off e I)|].
      apply Z.ltb_lt in K. rewrite winding_real, sub_real in K. exact K.
    - intros (a & b & I & R). apply in_map_iff in I. destruct I as (e & Ee & I).
      unfold R2e in Ee. injection Ee; intros <- <-. exists e. split; auto.
      apply Z.ltb_lt. rewrite winding_real, sub_real.
      apply region_off in R; [exact R|exact CH|apply (Off e I)]. }
  unfold by_vertex_of_E, by_vertex_of_F. destruct (classic (by_edges P Q (R2 c))) as [B|B].
  - split; [auto|]. intros _. left. left. apply Edges, B.
  - rewrite Edges, (W E F CQ), (W F E CP); auto; [fold P Q; tauto| |].
    + intros z Z1 Z2. exists (minus_ (R2 c) z), z. split; [exact Z2|split; [exact Z1|]].
      unfold add, minus_; destruct (R2 c); cbn [fst snd]; f_equal; ring.
    + intros z Z1 Z2. exists z, (minus_ (R2 c) z).
      split; [exact Z1|split; [exact Z2|apply add_minus]].
Qed.
