(** Section 3 of the paper: the boundary of a sum is in the reduced convolution. *)
From Coq Require Import Lra Psatz.
From Proved Require Import Definitions Paper Wedges.
Open Scope R_scope.

Theorem reflex_vertices_contribute_nothing_holds : reflex_vertices_contribute_nothing.
Proof.
  intros S T p q i o d Hs C D L. destruct (reflex_right i o d C D) as (v & W & V).
  apply opposite_ways with v; [exact (corner_way S p i o v Hs W)|].
  apply (left_way T q d); auto. rewrite cross_opposite. lra.
Qed.
Theorem incompatible_vertices_contribute_nothing_holds : incompatible_vertices_contribute_nothing.
Proof.
  intros S T p q i o d Hs C L N. destruct (convex_or_right i o d C) as [H|(v & W & V)]; [tauto|].
  apply opposite_ways with v; [exact (corner_way S p i o v Hs W)|].
  apply (left_way T q d); auto. rewrite cross_opposite. lra.
Qed.

Lemma diff_zero a b : a <> b -> diff b a <> (0, 0).
Proof.
  intros N E. apply N. unfold diff in E. injection E as E1 E2. destruct a, b; cbn [fst snd] in *.
  f_equal; lra.
Qed.
Lemma add_swap p q : add p q = add q p.
Proof. unfold add. f_equal; ring. Qed.
Lemma wedge_opposite i o v : wedge i o (opposite (opposite v)) <-> wedge i o v.
Proof. unfold wedge. rewrite !cross_opposite, !Ropp_involutive. tauto. Qed.
(** Ends of an edge, and the points between *)
Lemma inside_of a b s : a <> b -> 0 < s < 1 ->
  add a (scale s (diff b a)) <> a /\ add a (scale s (diff b a)) <> b.
Proof.
  intros N S. destruct a as [a1 a2], b as [b1 b2]. unfold add, scale, diff; cbn [fst snd].
  assert (Z : b1 - a1 <> 0 \/ b2 - a2 <> 0).
  { destruct (Req_dec (b1 - a1) 0); auto. destruct (Req_dec (b2 - a2) 0); auto.
    destruct N. f_equal; lra. }
  split; intros E; injection E as E1 E2; destruct Z as [Z|Z]; apply Z; nra.
Qed.
Lemma on_part a b s : 0 <= s <= 1 -> on_segment a b (add a (scale s (diff b a))).
Proof. intros S. exists s. split; auto. Qed.
Lemma part_zero a b : add a (scale 0 (diff b a)) = a.
Proof. unfold add, scale, diff; destruct a; cbn [fst snd]. f_equal; ring. Qed.
Lemma part_one a b : add a (scale 1 (diff b a)) = b.
Proof. unfold add, scale, diff; destruct b; cbn [fst snd]. f_equal; ring. Qed.

Section Sum.
Variables P Q : point -> Prop.
Variables E F : list (point * point).
Hypothesis WP : walled P E.
Hypothesis WQ : walled Q F.
Variable x : point.
Hypothesis on_boundary : ~ interior (sum_of P Q) x.

Lemma no_opposite p q v : x = add p q -> inner_way P p v -> inner_way Q q (opposite v) -> False.
Proof. intros X H K. apply on_boundary. rewrite X. exact (opposite_ways P Q p q v H K). Qed.
Lemma edge_left_P a b s : In (a, b) E -> 0 < s < 1 ->
  has_left P (add a (scale s (diff b a))) (diff b a).
Proof.
  intros I S. destruct WP as (_ & L & V). destruct (V a b I) as (N & _).
  destruct (inside_of a b s N S). apply L; auto. apply on_part. lra.
Qed.
Lemma edge_left_Q a b s : In (a, b) F -> 0 < s < 1 ->
  has_left Q (add a (scale s (diff b a))) (diff b a).
Proof.
  intros I S. destruct WQ as (_ & L & V). destruct (V a b I) as (N & _).
  destruct (inside_of a b s N S). apply L; auto. apply on_part. lra.
Qed.
Lemma nonzero_P a b : In (a, b) E -> diff b a <> (0, 0).
Proof. intros I. apply diff_zero, (proj2 (proj2 WP) a b I). Qed.
Lemma nonzero_Q a b : In (a, b) F -> diff b a <> (0, 0).
Proof. intros I. apply diff_zero, (proj2 (proj2 WQ) a b I). Qed.

(** ** A vertex of one and a point inside an edge of the other *)
Lemma vertex_of_P p i o q d : x = add p q -> corner P p i o -> has_left Q q d -> d <> (0, 0) ->
  0 < cross i o /\ 0 <= cross i d /\ 0 <= cross d o.
Proof.
  intros X C L D. destruct (Rtotal_order 0 (cross i o)) as [K|[K|K]].
  - destruct (convex_or_right i o d K) as [H|(v & W & V)]; auto. exfalso.
    apply (no_opposite p q v X (corner_way P p i o v C W)), (left_way Q q d); auto.
    rewrite cross_opposite. lra.
  - destruct C as [C _]. congruence.
  - exfalso. apply on_boundary. rewrite X.
    exact (reflex_vertices_contribute_nothing_holds P Q p q i o d C K D L).
Qed.
Lemma vertex_of_Q q i o p d : x = add p q -> corner Q q i o -> has_left P p d -> d <> (0, 0) ->
  0 < cross i o /\ 0 <= cross i d /\ 0 <= cross d o.
Proof.
  intros X C L D. assert (G : forall v, wedge i o v -> cross d v < 0 -> False).
  { intros v W V. apply (no_opposite p q (opposite v) X).
    - apply (left_way P p d); auto. rewrite cross_opposite. lra.
    - apply (corner_way Q q i o); auto. apply wedge_opposite, W. }
  destruct (Rtotal_order 0 (cross i o)) as [K|[K|K]].
  - destruct (convex_or_right i o d K) as [H|(v & W & V)]; auto. destruct (G v W V).
  - destruct C as [C _]. congruence.
  - destruct (reflex_right i o d K D) as (v & W & V). destruct (G v W V).
Qed.

(** ** Two vertices of which one is reflex *)
Definition reduced := in_reduced_convolution E F x.
Lemma by_edge_of_P a b c v d y : In (a, b) E -> In (c, v) F -> In (v, d) F ->
  0 < cross (diff v c) (diff d v) -> 0 <= cross (diff v c) (diff b a) ->
  0 < cross (diff b a) (diff d v) -> on_segment a b y -> x = add y v -> reduced.
Proof.
  intros I J K C L1 L2 S X. left. exists a, b, c, v, d, y. repeat split; auto.
  destruct L1 as [L1|L1]; [left; exact L1|right]. apply same_as_first with (diff d v); auto.
Qed.
Lemma by_edge_of_Q a v b c d y : In (a, v) E -> In (v, b) E -> In (c, d) F ->
  0 < cross (diff v a) (diff b v) -> 0 < cross (diff v a) (diff d c) ->
  0 <= cross (diff d c) (diff b v) -> on_segment c d y -> x = add v y -> reduced.
Proof.
  intros I J K C L1 L2 S X. right. exists a, v, b, c, d, y. repeat split; auto.
  destruct L2 as [L2|L2]; [left; exact L2|right]. apply same_as_last with (diff v a); auto.
Qed.
Lemma starts_on a b : on_segment a b a.
Proof. exists 0. split; [lra|destruct a; cbn [fst snd]; f_equal; ring]. Qed.
Lemma ends_on a b : on_segment a b b.
Proof. exists 1. split; [lra|destruct b; cbn [fst snd]; f_equal; ring]. Qed.
Lemma both_along i o k : cross i o <> 0 -> k <> (0, 0) -> cross i k = 0 -> cross o k = 0 -> False.
Proof.
  intros C K A B. apply (not_both_zero i o k C K A). rewrite cross_swap, B. ring.
Qed.

Lemma reflex_vertex a v b c w d : In (a, v) E -> In (v, b) E -> In (c, w) F -> In (w, d) F ->
  corner P v (diff v a) (diff b v) -> corner Q w (diff w c) (diff d w) -> x = add v w ->
  cross (diff v a) (diff b v) < 0 \/ cross (diff w c) (diff d w) < 0 -> reduced.
Proof.
  set (i := diff v a). set (o := diff b v). set (j := diff w c). set (k := diff d w).
  intros Ia Ib Jc Jd CP CQ X R.
  assert (Ni : i <> (0, 0)) by (apply nonzero_P, Ia).
  assert (No : o <> (0, 0)) by (apply nonzero_P, Ib).
  assert (Nj : j <> (0, 0)) by (apply nonzero_Q, Jc).
  assert (Nk : k <> (0, 0)) by (apply nonzero_Q, Jd).
  assert (G : forall u, wedge i o u -> wedge j k (opposite u) -> False).
  { intros u W1 W2. apply (no_opposite v w u X (corner_way P v i o u CP W1)).
    exact (corner_way Q w j k _ CQ W2). }
  assert (ZP : cross i o <> 0) by apply CP. assert (ZQ : cross j k <> 0) by apply CQ.
  destruct (Rlt_dec 0 (cross j k)) as [Ck|Ck]; [|destruct (Rlt_dec 0 (cross i o)) as [Co|Co]].
  - (* the vertex of P is reflex *)
    assert (Co : cross i o < 0) by lra.
    destruct (convex_reflex j k i o Ck Co) as [[[A1 A2] [B1 B2]]|(u & W1 & W2)].
    2: { destruct (G (opposite u)); auto. apply wedge_opposite, W1. }
    destruct A2 as [A2|A2].
    + apply (by_edge_of_P a v c w d v); auto using ends_on.
    + destruct B2 as [B2|B2]; [apply (by_edge_of_P v b c w d v); auto using starts_on|].
      destruct (both_along i o k); auto.
  - (* that of Q *)
    assert (Cr : cross j k < 0) by lra.
    destruct (convex_reflex i o j k Co Cr) as [[[A1 A2] [B1 B2]]|(u & W1 & W2)].
    2: { destruct (G u); auto. }
    destruct A1 as [A1|A1]; [apply (by_edge_of_Q a v b c w w); auto using ends_on|].
    destruct B1 as [B1|B1]; [apply (by_edge_of_Q a v b w d w); auto using starts_on|].
    exfalso. apply (not_both_zero j k i); auto; rewrite cross_swap; lra.
  - (* both *)
    exfalso. assert (Co' : cross i o < 0) by lra. assert (Cr : cross j k < 0) by lra.
    destruct (reflex_right i o j Co' Nj) as (u & W & V). apply (G u W). right. split; auto.
    left. rewrite cross_opposite. lra.
Qed.

(** ** Two parallel edges: slide along both, to the start of that of P or the end of that of Q. *)
Lemma slide a b c d l s t m : l <> 0 -> diff d c = scale l (diff b a) ->
  add (add a (scale s (diff b a))) (add c (scale t (diff d c))) =
  add (add a (scale (s - m) (diff b a))) (add c (scale (t + m / l) (diff d c))).
Proof.
  intros L ->. unfold add, scale; cbn [fst snd]. f_equal; field; auto.
Qed.
Lemma parallel_edges a b c d p q : In (a, b) E -> In (c, d) F -> on_segment a b p ->
  on_segment c d q -> same_way (diff b a) (diff d c) -> x = add p q -> reduced.
Proof.
  intros I J (s & S & ->) (t & T & ->) (l & L & W) X.
  change (x = add (add a (scale s (diff b a))) (add c (scale t (diff d c)))) in X.
  destruct (proj2 (proj2 WP) a b I) as (Nab & (e & Ie & Ce) & (z & Iz & Cz)).
  destruct (proj2 (proj2 WQ) c d J) as (Ncd & (f & If & Cf) & (g & Ig & Cg)).
  pose proof (nonzero_P a b I) as Db. pose proof (nonzero_Q c d J) as Dd.
  destruct (Rle_dec (l * (1 - t)) s) as [M|M].
  - (* to the end d *)
    rewrite (slide a b c d l s t (l * (1 - t))) in X by (auto; lra).
    replace (t + l * (1 - t) / l) with 1 in X by (field; lra). rewrite part_one in X.
    set (u := s - l * (1 - t)) in *. assert (U : 0 <= u <= 1) by (unfold u; nra).
    destruct (Rlt_dec 0 (cross (diff d c) (diff f d))) as [C|C].
    + apply (by_edge_of_P a b c d f (add a (scale u (diff b a)))); auto.
      * rewrite W, cross_scaled, cross_self. lra.
      * apply Rmult_lt_reg_l with l; auto. rewrite <- cross_scaled, <- W. lra.
      * apply on_part, U.
    + assert (R : cross (diff d c) (diff f d) < 0) by (destruct Cf as [Z _]; lra).
      destruct (Req_dec u 0) as [Z|Z]; [|destruct (Req_dec u 1) as [Y|Y]].
      * rewrite Z, part_zero in X. apply (reflex_vertex z a b c d f); auto.
      * rewrite Y, part_one in X. apply (reflex_vertex a b e c d f); auto.
      * exfalso. assert (H : has_left P (add a (scale u (diff b a))) (diff b a))
          by (apply edge_left_P; auto; lra).
        destruct (vertex_of_Q d _ _ _ _ X Cf H Db). lra.
  - (* to the start a *)
    rewrite (slide a b c d l s t s) in X by (auto; lra).
    replace (s - s) with 0 in X by ring. rewrite part_zero in X.
    set (u := t + s / l) in *.
    assert (Ul : l * u = l * t + s) by (unfold u; field; lra).
    assert (U : 0 <= u < 1) by nra.
    destruct (Rlt_dec 0 (cross (diff a z) (diff b a))) as [C|C].
    + apply (by_edge_of_Q z a b c d (add c (scale u (diff d c)))); auto.
      * rewrite W, cross_scale. apply Rmult_lt_0_compat; auto.
      * rewrite W, cross_scaled, cross_self. lra.
      * apply on_part. lra.
    + assert (R : cross (diff a z) (diff b a) < 0) by (destruct Cz as [Z _]; lra).
      destruct (Req_dec u 0) as [Z|Z].
      * rewrite Z, part_zero in X. apply (reflex_vertex z a b g c d); auto.
      * exfalso. assert (H : has_left Q (add c (scale u (diff d c))) (diff d c))
          by (apply edge_left_Q; auto; lra).
        destruct (vertex_of_P a _ _ _ _ X Cz H Dd). lra.
Qed.

(** ** Two vertices *)
Lemma same_back i d : same_way i d -> same_way d i.
Proof.
  intros (k & K & ->). exists (/ k). split; [apply Rinv_0_lt_compat, K|].
  unfold scale; destruct i; cbn [fst snd]. f_equal; field; lra.
Qed.
Lemma two_vertices a v b c w d : In (a, v) E -> In (v, b) E -> In (c, w) F -> In (w, d) F ->
  corner P v (diff v a) (diff b v) -> corner Q w (diff w c) (diff d w) -> x = add v w -> reduced.
Proof.
  intros Ia Ib Jc Jd CP CQ X.
  assert (ZP : cross (diff v a) (diff b v) <> 0) by apply CP.
  assert (ZQ : cross (diff w c) (diff d w) <> 0) by apply CQ.
  destruct (Rlt_dec 0 (cross (diff v a) (diff b v))) as [Co|Co];
    [|apply (reflex_vertex a v b c w d); auto; lra].
  destruct (Rlt_dec 0 (cross (diff w c) (diff d w))) as [Ck|Ck];
    [|apply (reflex_vertex a v b c w d); auto; lra].
  pose proof (nonzero_P _ _ Ia) as Ni. pose proof (nonzero_P _ _ Ib) as No.
  pose proof (nonzero_Q _ _ Jc) as Nj. pose proof (nonzero_Q _ _ Jd) as Nk.
  destruct (convex_convex _ _ _ _ Co Ck) as [[A B]|[[A B]|[[A B]|[[A B]|(u & W1 & W2)]]]].
  - destruct A as [A|A]; [apply (by_edge_of_Q a v b c w w); auto using ends_on|].
    apply (parallel_edges a v c w v w); auto using ends_on.
    apply same_as_first with (diff b v); auto.
    destruct B as [B|B]; auto. destruct (not_both_zero _ _ _ ZP Nj); auto.
  - destruct A as [A|A]; [apply (by_edge_of_Q a v b w d w); auto using starts_on|].
    apply (parallel_edges a v w d v w); auto using ends_on, starts_on.
    apply same_as_first with (diff b v); auto.
    destruct B as [B|B]; auto. destruct (not_both_zero _ _ _ ZP Nk); auto.
  - destruct B as [B|B]; [apply (by_edge_of_P a v c w d v); auto using ends_on|].
    apply (parallel_edges a v w d v w); auto using ends_on, starts_on. apply same_back.
    apply same_as_last with (diff w c); auto.
    destruct A as [A|A]; auto. destruct (not_both_zero _ _ _ ZQ Ni); auto.
  - destruct B as [B|B]; [apply (by_edge_of_P v b c w d v); auto using starts_on|].
    apply (parallel_edges v b w d v w); auto using starts_on. apply same_back.
    apply same_as_last with (diff w c); auto.
    destruct A as [A|A]; auto. destruct (not_both_zero _ _ _ ZQ No); auto.
  - exfalso. apply (no_opposite v w u X (corner_way P v _ _ u CP W1)).
    exact (corner_way Q w _ _ _ CQ W2).
Qed.

(** ** A point of an edge is an end of it, or inside. *)
Lemma place_on a b p : on_segment a b p ->
  p = a \/ p = b \/ exists s, 0 < s < 1 /\ p = add a (scale s (diff b a)).
Proof.
  intros (s & S & ->). change (add a (scale s (diff b a)) = a \/ add a (scale s (diff b a)) = b \/
    exists t, 0 < t < 1 /\ add a (scale s (diff b a)) = add a (scale t (diff b a))).
  destruct (Req_dec s 0) as [->|Z]; [left; apply part_zero|].
  destruct (Req_dec s 1) as [->|Y]; [right; left; apply part_one|].
  right; right. exists s. split; auto. lra.
Qed.
Lemma at_vertex_P p a b : In (a, b) E -> p = a \/ p = b -> exists c d, In (c, p) E /\ In (p, d) E /\
  corner P p (diff p c) (diff d p).
Proof.
  intros I H. destruct (proj2 (proj2 WP) a b I) as (_ & (e & Ie & Ce) & (z & Iz & Cz)).
  destruct H; subst; [exists z, b|exists a, e]; auto.
Qed.
Lemma at_vertex_Q p a b : In (a, b) F -> p = a \/ p = b -> exists c d, In (c, p) F /\ In (p, d) F /\
  corner Q p (diff p c) (diff d p).
Proof.
  intros I H. destruct (proj2 (proj2 WQ) a b I) as (_ & (e & Ie & Ce) & (z & Iz & Cz)).
  destruct H; subst; [exists z, b|exists a, e]; auto.
Qed.
Lemma vertex_and_edge p q a b c d s : In (a, p) E -> In (p, b) E ->
  corner P p (diff p a) (diff b p) -> In (c, d) F -> 0 < s < 1 ->
  q = add c (scale s (diff d c)) -> x = add p q -> reduced.
Proof.
  intros Ia Ib CP J S -> X. pose proof (nonzero_Q c d J) as D.
  destruct (vertex_of_P _ _ _ _ _ X CP (edge_left_Q c d s J S) D) as (C & A & B).
  assert (O : on_segment c d (add c (scale s (diff d c)))) by (apply on_part; lra).
  destruct A as [A|A].
  - exact (by_edge_of_Q a p b c d _ Ia Ib J C A B O X).
  - apply (parallel_edges a p c d p (add c (scale s (diff d c)))); auto using ends_on.
    apply same_as_first with (diff b p); auto. destruct B as [B|B]; auto.
    destruct (not_both_zero (diff p a) (diff b p) (diff d c)); auto; lra.
Qed.
Lemma edge_and_vertex p q a b c d s : In (c, q) F -> In (q, d) F ->
  corner Q q (diff q c) (diff d q) -> In (a, b) E -> 0 < s < 1 ->
  p = add a (scale s (diff b a)) -> x = add p q -> reduced.
Proof.
  intros Jc Jd CQ I S -> X. pose proof (nonzero_P a b I) as D.
  destruct (vertex_of_Q _ _ _ _ _ X CQ (edge_left_P a b s I S) D) as (C & A & B).
  assert (O : on_segment a b (add a (scale s (diff b a)))) by (apply on_part; lra).
  destruct B as [B|B].
  - exact (by_edge_of_P a b c q d _ I Jc Jd C A B O X).
  - apply (parallel_edges a b q d (add a (scale s (diff b a))) q); auto using starts_on.
    apply same_back, same_as_last with (diff q c); auto. destruct A as [A|A]; auto.
    destruct (not_both_zero (diff q c) (diff d q) (diff b a)); auto; lra.
Qed.
Lemma two_edges p q a b c d s t : In (a, b) E -> In (c, d) F -> 0 < s < 1 -> 0 < t < 1 ->
  p = add a (scale s (diff b a)) -> q = add c (scale t (diff d c)) -> x = add p q -> reduced.
Proof.
  intros I J S T -> -> X. pose proof (edge_left_P a b s I S) as LP.
  pose proof (edge_left_Q c d t J T) as LQ.
  pose proof (nonzero_P a b I) as Db. pose proof (nonzero_Q c d J) as Dd.
  set (u := diff b a) in *. set (v := diff d c) in *.
  assert (G : forall w, 0 < cross u w -> cross v w < 0 -> False).
  { intros w W1 W2. apply (no_opposite _ _ w X (left_way P _ u w LP W1)).
    apply (left_way Q _ v); auto. rewrite cross_opposite. lra. }
  destruct (Req_dec (cross u v) 0) as [Z|Z].
  2: { destruct (crossing_way u v Z) as (w & W1 & W2). destruct (G w W1 W2). }
  apply (parallel_edges a b c d (add a (scale s u)) (add c (scale t v))); auto;
    try (apply on_part; lra).
  (* the same way, as the left normal of u is not on the right of v *)
  fold u v. specialize (G (- snd u, fst u)).
  assert (N : 0 < fst u * fst u + snd u * snd u).
  { destruct (Req_dec (fst u) 0) as [Z1|Z1]; destruct (Req_dec (snd u) 0) as [Z2|Z2]; try nra.
    destruct Db. destruct u as [u1 u2]; cbn [fst snd] in *. congruence. }
  set (k := (fst u * fst v + snd u * snd v) / (fst u * fst u + snd u * snd u)).
  assert (K : v = scale k u).
  { unfold cross in Z. clear - N Z. destruct u as [u1 u2], v as [v1 v2]. cbn [fst snd] in *.
    assert (Kd : k * (u1 * u1 + u2 * u2) = u1 * v1 + u2 * v2) by (unfold k; field; lra).
    unfold scale; cbn [fst snd]. f_equal; apply Rmult_eq_reg_r with (u1 * u1 + u2 * u2); try lra;
      apply Rminus_diag_uniq.
    - replace (k * u1 * (u1 * u1 + u2 * u2)) with (u1 * (k * (u1 * u1 + u2 * u2))) by ring.
      rewrite Kd. transitivity (- u2 * (u1 * v2 - u2 * v1)); [ring|rewrite Z; ring].
    - replace (k * u2 * (u1 * u1 + u2 * u2)) with (u2 * (k * (u1 * u1 + u2 * u2))) by ring.
      rewrite Kd. transitivity (u1 * (u1 * v2 - u2 * v1)); [ring|rewrite Z; ring]. }
  exists k. split; auto. destruct (Rtotal_order 0 k) as [H|[H|H]]; auto; exfalso.
  - apply Dd. rewrite K, <- H. unfold scale. f_equal; ring.
  - apply G; unfold cross; cbn [fst snd]; [nra|]. rewrite K. unfold scale; cbn [fst snd]. nra.
Qed.

Lemma boundary_here p q : P p -> Q q -> x = add p q -> reduced.
Proof.
  intros Hp Hq X.
  destruct (proj1 WP p Hp) as [In1|(a & b & I & Op)].
  { destruct on_boundary. rewrite X. apply interior_sum_left; auto. }
  destruct (proj1 WQ q Hq) as [In2|(c & d & J & Oq)].
  { destruct on_boundary. rewrite X. apply interior_sum_right; auto. }
  apply place_on in Op. apply place_on in Oq.
  assert (DP : (p = a \/ p = b) \/ exists s, 0 < s < 1 /\ p = add a (scale s (diff b a))) by tauto.
  assert (DQ : (q = c \/ q = d) \/ exists s, 0 < s < 1 /\ q = add c (scale s (diff d c))) by tauto.
  destruct DP as [VP|(s & S & Ep)], DQ as [VQ|(t & T & Eq)].
  - destruct (at_vertex_P p a b I VP) as (e & f & I1 & I2 & CP).
    destruct (at_vertex_Q q c d J VQ) as (g & h & J1 & J2 & CQ).
    exact (two_vertices e p f g q h I1 I2 J1 J2 CP CQ X).
  - destruct (at_vertex_P p a b I VP) as (e & f & I1 & I2 & CP).
    exact (vertex_and_edge p q e f c d t I1 I2 CP J T Eq X).
  - destruct (at_vertex_Q q c d J VQ) as (g & h & J1 & J2 & CQ).
    exact (edge_and_vertex p q a b g h s J1 J2 CQ I S Ep X).
  - exact (two_edges p q a b c d s t I J S T Ep Eq X).
Qed.
End Sum.

Theorem boundary_in_reduced_convolution_holds : boundary_in_reduced_convolution.
Proof.
  intros P Q E F WP WQ x (p & q & Hp & Hq & X) N.
  exact (boundary_here P Q E F WP WQ x N p q Hp Hq X).
Qed.
