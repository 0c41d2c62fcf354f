(** The first piece counter-clockwise from a way, as the program finds it: none comes before it. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Local Across Overlaps Paths Decomposed Gaps Unique
  Beside Leaving.
From Proved Require Import Points Member Decided Pieces Slabs Sorting Along Cuts Traced.
Open Scope R_scope.

Local Notation T u w := (turn_of (R2 u) (R2 w)).
Definition along (d k : point) : R := fst d * fst k + snd d * snd k.
Definition at_most_half (r u : point) : Prop :=
  0 < turn_of r u \/ (turn_of r u = 0 /\ along r u < 0).
Lemma sign_cases q : (sg q = 1%Z /\ 0 < Q2R q) \/ (sg q = 0%Z /\ Q2R q = 0) \/
  (sg q = (-1)%Z /\ Q2R q < 0).
Proof.
  pose proof (sg_pos q) as P. pose proof (sg_neg q) as N.
  assert (S : sg q = 1%Z \/ sg q = 0%Z \/ sg q = (-1)%Z).
  { unfold sg. destruct (Z.sgn_spec (Qnum q)) as [[_ ->]|[[_ ->]|[_ ->]]]; auto. }
  destruct S as [S|[S|S]]; rewrite S in *; simpl in P, N;
    destruct (Rlt_dec 0 (Q2R q)), (Rlt_dec (Q2R q) 0); try discriminate; auto.
  right; left. split; auto. lra.
Qed.
Lemma half_real r u : (half r u = 0%Z /\ at_most_half (R2 r) (R2 u)) \/
  (half r u = 1%Z /\ ~ at_most_half (R2 r) (R2 u)).
Proof.
  unfold half, at_most_half, along. rewrite <- qcross_real.
  destruct (sign_cases (qcross r u)) as [[-> L]|[[-> L]|[-> L]]].
  - left. auto.
  - rewrite <- dot_real. rewrite sg_neg. destruct (Rlt_dec (Q2R (dot r u)) 0); [left|right]; auto.
    split; auto. lra.
  - right. split; auto. lra.
Qed.
Lemma sooner_real r u w : sooner r u w = true <->
  (at_most_half (R2 r) (R2 u) /\ ~ at_most_half (R2 r) (R2 w)) \/
  ((at_most_half (R2 r) (R2 u) <-> at_most_half (R2 r) (R2 w)) /\ 0 < T u w).
Proof.
  unfold sooner. rewrite orb_true_iff, andb_true_iff, Z.ltb_lt, Z.eqb_eq, sg_pos, qcross_real.
  destruct (half_real r u) as [[-> U]|[-> U]], (half_real r w) as [[-> W]|[-> W]];
    destruct (Rlt_dec 0 (T u w)); intuition (try lia; try discriminate; auto).
Qed.

(** Ways along r or back *)
Lemma parallel (r u : point) : r <> (0, 0) -> turn_of r u = 0 -> exists m, u = scale m r /\
  (along r u < 0 <-> m < 0).
Proof.
  intros N Z. pose proof (edge_long (0, 0) r (not_eq_sym N)) as L.
  cbv zeta in L. cbn [fst snd] in L.
  set (D := fst r * fst r + snd r * snd r). assert (HD : 0 < D) by (unfold D; lra).
  unfold turn_of in Z. exists (along r u / D).
  assert (K : along r u / D * D = along r u) by (field; lra).
  set (m := along r u / D) in *. clearbody m. split.
  - apply point_eq; unfold scale; cbn [fst snd]; apply Rmult_eq_reg_r with D; try lra.
    + transitivity (fst r * (m * D)); [rewrite K; unfold along, D|ring].
      transitivity (fst u * (fst r * fst r) + snd r * (snd r * fst u)); [ring|].
      replace (snd r * fst u) with (fst r * snd u) by lra. ring.
    + transitivity (snd r * (m * D)); [rewrite K; unfold along, D|ring].
      transitivity (fst r * (fst r * snd u) + snd u * (snd r * snd r)); [ring|].
      replace (fst r * snd u) with (snd r * fst u) by lra. ring.
  - rewrite <- K. split; intros; nra.
Qed.
Lemma scaled_turns (m : R) (r w : point) : turn_of (scale m r) w = m * turn_of r w /\
  turn_of w (scale m r) = - m * turn_of r w.
Proof. unfold turn_of, scale; cbn [fst snd]. split; ring. Qed.
Lemma four_turns (r u w x : point) :
  turn_of r u * turn_of w x - turn_of r w * turn_of u x + turn_of r x * turn_of u w = 0.
Proof. unfold turn_of. ring. Qed.
Definition vector_between (r k b : point) : Prop :=
  (0 < turn_of r k /\ (0 < turn_of k b \/ turn_of r b < 0)) \/
  (turn_of r k <= 0 /\ turn_of r b < 0 /\ 0 < turn_of k b).
Lemma half_cases r u : r <> (0, 0) -> (0 < turn_of r u /\ at_most_half r u) \/
  (turn_of r u < 0 /\ ~ at_most_half r u) \/
  (exists m, m < 0 /\ u = scale m r /\ at_most_half r u) \/
  (exists m, 0 <= m /\ u = scale m r /\ ~ at_most_half r u).
Proof.
  intros N. unfold at_most_half. destruct (Rtotal_order (turn_of r u) 0) as [L|[Z|L]].
  - right; left. split; auto. lra.
  - destruct (parallel r u N Z) as (m & E & S). right; right.
    destruct (Rlt_dec m 0) as [M|M]; [left|right]; exists m.
    + split; [exact M|split; [exact E|]]. right. split; [exact Z|apply S, M].
    + split; [lra|split; [exact E|]]. intros [H|[_ H]]; [lra|]. apply M, S, H.
  - left. auto.
Qed.
Lemma sooner_transitive r u w x : R2 r <> (0, 0) -> sooner r u w = true -> sooner r w x = true ->
  sooner r u x = true.
Proof.
  rewrite !sooner_real. generalize (R2 r) (R2 u) (R2 w) (R2 x). clear. intros r u w x N H K.
  destruct H as [[H1 H2]|[H1 H2]], K as [[K1 K2]|[K1 K2]]; try tauto.
  right. split; [tauto|]. pose proof (four_turns r u w x) as F.
  destruct (half_cases r w N) as [[W Hw]|[[W Hw]|[(m & M & -> & Hw)|(m & M & -> & Hw)]]].
  - assert (U : at_most_half r u) by tauto. assert (X : at_most_half r x) by tauto.
    destruct U as [U|[U U']].
    2: { exfalso. destruct (parallel r u N U) as (m & -> & S). apply S in U'.
      rewrite (proj1 (scaled_turns m r w)) in H2. nra. }
    assert (X' : 0 <= turn_of r x) by (destruct X as [X|[X _]]; lra).
    assert (0 < turn_of r u * turn_of w x) by (apply Rmult_lt_0_compat; auto).
    assert (0 <= turn_of r x * turn_of u w) by (apply Rmult_le_pos; lra).
    assert (0 < turn_of r w * turn_of u x) by lra. apply (Rmult_lt_reg_l (turn_of r w)); lra.
  - assert (U : ~ at_most_half r u) by tauto. assert (X : ~ at_most_half r x) by tauto.
    destruct (half_cases r u N) as [[P Q]|[[P _]|[(m & M & -> & Q)|(m & M & -> & Q)]]];
      try contradiction.
    2: { rewrite (proj1 (scaled_turns m r w)) in H2. nra. }
    assert (X' : turn_of r x <= 0).
    { apply Rnot_lt_le. intros L. apply X. left. exact L. }
    assert (0 < - turn_of r w * turn_of u x); [|nra].
    assert (turn_of r u * turn_of w x < 0) by nra.
    assert (turn_of r x * turn_of u w <= 0) by nra. lra.
  - exfalso. rewrite (proj1 (scaled_turns m r x)) in K2. destruct K1 as [K1 _]. specialize (K1 Hw).
    destruct K1 as [K1|[K1 _]]; [nra|rewrite K1 in K2; lra].
  - exfalso. rewrite (proj1 (scaled_turns m r x)) in K2.
    assert (turn_of r x <= 0); [|nra]. apply Rnot_lt_le. intros L. apply Hw, K1. left. exact L.
Qed.
Lemma not_sooner_self r u : sooner r u u = false.
Proof.
  apply not_true_iff_false. rewrite sooner_real. intros [[H K]|[_ H]]; [tauto|].
  unfold turn_of in H. lra.
Qed.
Lemma first_is_first r l e : R2 r <> (0, 0) -> first_from r l = Some e -> In e l /\
  forall f, In f l -> sooner r (dir f) (dir e) = false.
Proof.
  intros N. revert e. induction l as [|d l IH]; intros e; cbn [first_from]; [discriminate|].
  destruct (first_from r l) as [f|] eqn:F.
  - destruct (IH f eq_refl) as [I K]. destruct (sooner r (dir d) (dir f)) eqn:S; intros Q;
      injection Q; intros <-.
    + split; [simpl; auto|]. intros g [<-|J]; [apply not_sooner_self|].
      apply not_true_iff_false. intros G.
      pose proof (sooner_transitive r _ _ _ N G S). rewrite (K g J) in *. discriminate.
    + split; [simpl; auto|]. intros g [<-|J]; auto.
  - intros Q; injection Q; intros <-. split; [simpl; auto|].
    destruct l as [|g l]; [|cbn [first_from] in F; destruct (first_from r l);
      [destruct (sooner _ _ _)|]; discriminate].
    intros g [<-|[]]. apply not_sooner_self.
Qed.
Lemma first_exists r l e : In e l -> exists f, first_from r l = Some f.
Proof.
  destruct l as [|d l]; [intros []|]. intros _. cbn [first_from].
  destruct (first_from r l) as [f|]; [destruct (sooner _ _ _)|]; eauto.
Qed.

(** What comes no later than something between is between. *)
Lemma sooner_between r k h b : R2 r <> (0, 0) -> R2 h <> (0, 0) -> sooner r k h = false ->
  vector_between (R2 r) (R2 k) b -> vector_between (R2 r) (R2 h) b.
Proof.
  intros N Nh S. apply not_true_iff_false in S. rewrite sooner_real in S. revert N Nh S.
  generalize (R2 r) (R2 k) (R2 h). clear. intros r k h N Nh S B.
  assert (S1 : at_most_half r k -> at_most_half r h) by (intros; apply NNPP; tauto).
  assert (S2 : (at_most_half r k <-> at_most_half r h) -> turn_of k h <= 0)
    by (intros; apply Rnot_lt_le; tauto).
  clear S. pose proof (four_turns r k h b) as F. unfold vector_between in *.
  destruct (half_cases r k N) as [[K Hk]|[[K Hk]|[(m & M & -> & Hk)|(m & M & -> & Hk)]]].
  - specialize (S1 Hk). assert (X : turn_of k h <= 0) by tauto. clear S2.
    destruct (half_cases r h N) as [[P Q]|[[P Q]|[(m & M & -> & Q)|(m & M & -> & Q)]]];
      try contradiction.
    2: { exfalso. rewrite (proj2 (scaled_turns m r k)) in X. nra. }
    left. split; auto. destruct (Rlt_dec (turn_of r b) 0) as [D|D]; [auto|left].
    destruct B as [[_ [B|B]]|(B & _)]; try lra.
    assert (0 < turn_of r h * turn_of k b) by nra.
    assert (turn_of r b * turn_of k h <= 0) by nra. nra.
  - destruct B as [[B _]|(_ & D & B)]; [lra|].
    destruct (half_cases r h N) as [[P Q]|[[P Q]|[(m & M & -> & Q)|(m & M & -> & Q)]]].
    + left. auto.
    + right. assert (X : turn_of k h <= 0) by (apply S2; tauto). split; [lra|]. split; auto.
      assert (0 < - turn_of r h * turn_of k b) by nra.
      assert (0 <= turn_of r b * turn_of k h) by nra. nra.
    + right. rewrite (proj1 (scaled_turns m r b)), (proj2 (scaled_turns m r r)).
      replace (turn_of r r) with 0 by (unfold turn_of; ring). split; [lra|split; [auto|nra]].
    + exfalso. assert (X : turn_of k (scale m r) <= 0) by (apply S2; tauto).
      rewrite (proj2 (scaled_turns m r k)) in X. assert (m <> 0); [|nra]. intros ->. apply Nh.
      unfold scale. f_equal; ring.
  - specialize (S1 Hk). rewrite (proj1 (scaled_turns m r b)), (proj2 (scaled_turns m r r)) in B.
    replace (turn_of r r) with 0 in B by (unfold turn_of; ring).
    destruct B as [[B _]|(_ & D & B)]; [lra|].
    destruct S1 as [S1|[S1 S1']]; [left; auto|]. destruct (parallel r h N S1) as (l & -> & L).
    apply L in S1'. right. rewrite (proj1 (scaled_turns l r b)). split; [lra|split; [auto|nra]].
  - exfalso. rewrite (proj1 (scaled_turns m r b)), (proj2 (scaled_turns m r r)) in B.
    replace (turn_of r r) with 0 in B by (unfold turn_of; ring).
    destruct B as [[B _]|(_ & D & B)]; [lra|nra].
Qed.
Lemma not_both_between (a h b : point) : vector_between a h b -> vector_between b h a -> False.
Proof.
  unfold vector_between. replace (turn_of h b) with (- turn_of b h) by (unfold turn_of; ring).
  replace (turn_of h a) with (- turn_of a h) by (unfold turn_of; ring).
  replace (turn_of b a) with (- turn_of a b) by (unfold turn_of; ring). lra.
Qed.
