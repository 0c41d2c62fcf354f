(** Rings that pass the test are the canonical form of the set. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Components OneForm
  Paths Decomposed Gaps Unique Rounds.
From Proved Require Import Points Decided Member Pieces Slabs Along Cuts Lone Flanks Frontier
  Slabbed Parted Disjoint Linked Coloured Upright Wound Traced Bordered Rows
  Ringed Transfer.
Open Scope R_scope.

Section Formed.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.
Hypothesis long : forall e, In e B -> start e <> finish e.
Hypothesis alike : forall e f x, In e B -> In f B -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Variable high : R.
Hypothesis to_high : forall y, S y -> snd y <= high.
Variable K : list (list cell).
Hypothesis falls : falls_into (interior S) (fun i => part_of (interior S) (nth i K [])) (length K).
Variable os : list outlined.
Hypothesis tested : are_outlines all B os = true.
Hypothesis classed : Permutation K (map fst os).

Let rings := flat_map rings_of_outline os.
Let rows := concat rings.
Let G := all_pieces os.
Let ps := figure (map polygon_of os).
Lemma test_parts : (forall o, In o os -> is_outline all o = true) /\
  each_pair (fun e f => negb (same_edge e f) && negb (same_edge e (turned_back f))) G = true /\
  (forall e, In e G <-> In e B) /\
  ascending (fun o k => list_less (outer_corners o) (outer_corners k)) os = true.
Proof.
  unfold are_outlines in tested. rewrite !andb_true_iff, !forallb_forall in tested.
  destruct tested as [[[[T1 T2] T3] T4] T5].
  split; [exact T1|split; [exact T2|split; [|exact T5]]]. intros e. split; intros I.
  - specialize (T3 e I). apply existsb_exists in T3. destruct T3 as (f & J & E).
    apply exact_same in E. subst. exact J.
  - specialize (T4 e I). apply existsb_exists in T4. destruct T4 as (f & J & E).
    apply exact_same in E. subst. exact J.
Qed.
Lemma outline_parts o : In o os -> (exists r, fst (snd o) = [r]
  /\ 0 < area (map R2 (corners_of r))) /\
  (forall r, In r (snd (snd o)) -> area (map R2 (corners_of r)) < 0) /\
  (forall r, In r (rings_of_outline o) -> is_closed_ring r = true /\ begins_least r = true) /\
  (forall e, In e (concat (concat (rings_of_outline o))) -> bounds all (fst o) e = true) /\
  ascending (fun r k => list_less (corners_of r) (corners_of k)) (snd (snd o)) = true.
Proof.
  intros I. pose proof (proj1 test_parts o I) as T. unfold is_outline in T.
  rewrite !andb_true_iff, !forallb_forall in T. destruct T as [[[[T1 T2] T3] T4] T5].
  split; [|split; [|split; [|split; [exact T4|exact T5]]]].
  - destruct (fst (snd o)) as [|r [|]]; try discriminate. exists r. split; auto.
    apply less_real in T1. rewrite zero_real, twice_area_real in T1. exact T1.
  - intros r J. specialize (T2 r J). apply less_real in T2.
    rewrite zero_real, twice_area_real in T2. exact T2.
  - intros r J. specialize (T3 r J). apply andb_true_iff in T3. exact T3.
Qed.
Lemma closed_parts ring : In ring rings -> ring <> [] /\
  (forall r, In r ring -> is_straight r = true) /\
  (forall r k, In (r, k) (ring_edges ring) -> bends r k = true) /\
  each_pair (fun e f => negb (same (snd e) (snd f))) (concat ring) = true /\
  begins_least ring = true.
Proof.
  intros I. apply in_flat_map in I. destruct I as (o & Io & I).
  destruct (outline_parts o Io) as (_ & _ & H & _). destruct (H ring I) as [C L].
  unfold is_closed_ring in C. rewrite !andb_true_iff, !forallb_forall in C.
  destruct C as [[[N St] Be] Ep]. split; [destruct ring; [discriminate|intros Q; discriminate Q]|].
  split; [exact St|split; [|split; auto]]. intros r k J. exact (Be (r, k) J).
Qed.
Lemma row_ring r : In r rows -> exists ring, In ring rings /\ In r ring.
Proof. intros I. apply in_concat in I. exact I. Qed.
Lemma rows_straight r : In r rows -> is_straight r = true.
Proof.
  intros I. destruct (row_ring r I) as (ring & J & I'). apply (closed_parts ring J), I'.
Qed.
Lemma G_long e : In e G -> start e <> finish e.
Proof. intros I. apply long, test_parts, I. Qed.
Lemma G_alike e f x : In e G -> In f G -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Proof. intros I J. apply alike; apply test_parts; auto. Qed.
Lemma G_no_end e f : In e G -> In f G -> ~ inside e (start f) /\ ~ inside e (finish f).
Proof.
  intros I J. apply (kept_no_end S is_in all all_forward decided); apply test_parts; auto.
Qed.
Lemma G_apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Proof. apply (tested_apart G G_long G_alike), test_parts. Qed.
Lemma G_over x : over_some G x <-> over_some B x.
Proof. split; intros (e & I & O); exists e; split; auto; apply test_parts, I. Qed.
Lemma G_rows : G = concat rows.
Proof. reflexivity. Qed.
Lemma all_rows_long r : In r rows -> forall e, In e r -> start e <> finish e.
Proof. intros I e J. apply G_long. rewrite G_rows. apply in_concat. exists r. auto. Qed.

(** ** The rings as points *)
Lemma ring_points ring : In ring rings ->
  ring_edges (map R2 (corners_of ring)) = map real_edge ring.
Proof.
  intros I. destruct (closed_parts ring I) as (_ & St & Be & _). apply corners_edges.
  intros r k J. pose proof (Be r k J) as H. unfold bends in H. apply andb_true_iff in H.
  apply same_real, H.
Qed.
Lemma rings_real : rings_of ps = map (fun ring => map R2 (corners_of ring)) rings.
Proof.
  unfold ps, rings. assert (H := fun o I => proj1 (outline_parts o I)). clear - H.
  induction os as [|o l IH]; [reflexivity|]. simpl.
  rewrite map_app, <- IH by (intros k I; apply H; simpl; auto).
  destruct (H o (or_introl eq_refl)) as (r & E & _).
  unfold rings_of_outline, outer_corners. rewrite E. simpl. rewrite app_nil_r, map_map. reflexivity.
Qed.
Lemma edges_real : all_edges (rings_of ps) = map real_edge rows.
Proof.
  rewrite rings_real. unfold all_edges, rows. pose proof ring_points as H.
  induction rings as [|ring l IH]; [reflexivity|]. simpl.
  rewrite map_app, H by (simpl; auto). f_equal. apply IH. intros r I. apply H. simpl. auto.
Qed.
Lemma edges_over x : on_some (all_edges (rings_of ps)) x <-> over_some B x.
Proof.
  rewrite edges_real, (rows_cover rows x rows_straight G_long), <- G_over. reflexivity.
Qed.
Lemma edges_closed_up : closed (all_edges (rings_of ps)).
Proof. apply Legal.rings_are_closed. Qed.
Lemma G_closed : closed (map R2e G).
Proof.
  rewrite G_rows. apply rows_close; [exact rows_straight|exact G_long|].
  rewrite <- edges_real. exact edges_closed_up.
Qed.
Lemma set_steady_off x : ~ over_some B x -> steady S x.
Proof. apply (steady_off_kept S regular is_in all all_forward decided constant). Qed.
Lemma region_is_set x : region (all_edges (rings_of ps)) x <-> S x.
Proof.
  assert (W : forall y, winding (all_edges (rings_of ps)) y = winding (map R2e G) y).
  { intros y. rewrite edges_real. exact (rows_wind rows y rows_straight G_long). }
  assert (O : forall y, on_some (all_edges (rings_of ps)) y <-> on_some (map R2e G) y).
  { intros y. rewrite edges_over, <- G_over, (over_real G y). reflexivity. }
  assert (R : forall y, region (map R2e G) y <-> S y).
  { intros y. apply (region_of_pieces S regular G) with (high := high); auto.
    - intros z N. apply set_steady_off. rewrite <- G_over. exact N.
    - exact G_long.
    - intros e z I X. apply (kept_sided S is_in all all_forward decided constant e z); auto.
      apply test_parts, I.
    - exact G_apart.
    - exact G_closed. }
  rewrite <- R. split; apply region_same; auto; intros y; symmetry; first [apply W|apply O].
Qed.
(** A ring that bends everywhere has three corners at least. *)
Lemma three_corners ring : In ring rings -> (3 <= length (corners_of ring))%nat.
Proof.
  intros I. destruct (closed_parts ring I) as (N & St & Be & _). unfold corners_of.
  rewrite map_length.
  assert (Sub : forall r, In r ring -> In r rows).
  { intros r J. apply in_concat. exists ring. auto. }
  assert (Real : forall r k, In (r, k) (ring_edges ring) -> In r ring -> In k ring ->
    finish (edge_of r) = start (edge_of k) /\
    orient (start (edge_of r)) (finish (edge_of r)) (finish (edge_of k)) <> 0).
  { intros r k J Ir Ik. apply (bends_real rows); auto. }
  destruct ring as [|r [|k [|m l]]]; simpl; try lia; exfalso.
  - apply N. reflexivity.
  - destruct (Real r r) as [E O]; simpl; auto. apply O. rewrite E. unfold orient; ring.
  - destruct (Real r k) as [E O]; simpl; auto. destruct (Real k r) as [E' _]; simpl; auto.
    apply O. rewrite E'. unfold orient; ring.
Qed.
Lemma set_is_set x : set_of (rings_of ps) x <-> S x.
Proof.
  rewrite <- region_is_set. rewrite rings_real. pose proof three_corners as H.
  destruct rings as [|ring l]; [reflexivity|].
  specialize (H ring (or_introl eq_refl)). simpl.
  destruct (corners_of ring) as [|a [|b [|c r]]]; simpl in H; try lia.
  destruct l; reflexivity.
Qed.

(** ** The form *)
Lemma edge_divides o ring e : In o os -> In ring (rings_of_outline o) ->
  In e (map real_edge ring) -> divides (part_of (interior S) (fst o)) S e.
Proof.
  intros Io Ir Ie. apply in_map_iff in Ie. destruct Ie as (r & <- & J).
  assert (Irings : In ring rings) by (apply in_flat_map; exists o; auto).
  assert (Irow : In r rows) by (apply in_concat; exists ring; auto).
  exists (map start G ++ map finish G). intros x X.
  destruct (row_is_edge r (rows_straight r Irow) (all_rows_long r Irow)) as
    (Ne & On & _ & _ & _ & k & Hk & Way).
  destruct (proj1 (On x) X) as (p & P & Op).
  assert (Gp : In p G) by (rewrite G_rows; apply in_concat; exists r; auto).
  destruct (classic (x = start p)) as [->|N1].
  { left. apply in_or_app. left. apply in_map, Gp. }
  destruct (classic (x = finish p)) as [->|N2].
  { left. apply in_or_app. right. apply in_map, Gp. }
  right. assert (Xp : inside p x) by (apply inner_of_segment; auto).
  assert (HA : In (fst o) K).
  { apply (Permutation_in _ (Permutation_sym classed)), in_map, Io. }
  destruct (piece_borders S is_in all all_forward decided constant K falls (fst o) p x HA) as
    (s & Hs & Sd); auto.
  { apply test_parts, Gp. }
  { apply (outline_parts o Io). apply in_concat. exists r. split; auto. apply in_concat.
    exists ring. auto. }
  (* the row and its piece are one line, one way *)
  exists s. split; auto. intros y Y. unfold real_edge. cbn [fst snd].
  assert (Line : exists j, 0 < j /\ forall z,
    orient (start p) (finish p) z = j * orient (start (edge_of r)) (finish (edge_of r)) z).
  { assert (Ap : on_segment (start (edge_of r)) (finish (edge_of r)) (start p)).
    { apply On. exists p. split; auto. apply on_segment_start. }
    assert (Af : on_segment (start (edge_of r)) (finish (edge_of r)) (finish p)).
    { apply On. exists p. split; auto. apply on_segment_end. }
    destruct (on_at (edge_of r) _ Ap) as (u & U & Eu). destruct (on_at (edge_of r) _ Af) as
      (v & V & Ev).
    assert (Lt : u < v) by (apply (row_ways r (rows_straight r Irow)
      (all_rows_long r Irow) p u v P Eu Ev)).
    exists (v - u). split; [lra|]. intros z. rewrite Eu, Ev. unfold orient, at_; cbn [fst snd].
      ring. }
  destruct Line as (j & Hj & Line). destruct (Sd y Y) as [S1 S2]. rewrite Line in S1, S2.
  split; intros O; [apply S1|apply S2]; nra.
Qed.
Lemma ring_is_ring ring : In ring rings -> is_ring (map R2 (corners_of ring)).
Proof.
  intros I. destruct (closed_parts ring I) as (_ & _ & Be & Ep & _).
  assert (Sub : forall r, In r ring -> In r rows).
  { intros r J. apply in_concat. exists ring. auto. }
  split.
  - rewrite (ring_points ring I).
    apply (ring_once G G_long G_alike G_no_end G_apart rows (eq_sym G_rows) rows_straight ring Sub);
      [|exact Ep].
    apply (pairs_part _ _ (map (@concat edge) rings) (in_map (@concat edge) _ _ I)).
    rewrite <- (concat_twice rings). exact G_apart.
  - intros e f J. rewrite (ring_points ring I), Corners.ring_edges_map in J.
    apply in_map_iff in J. destruct J as ([r k] & Q & J). unfold Corners.both in Q.
    cbn [fst snd] in Q. injection Q; intros <- <-.
    assert (Both : In r ring /\ In k ring).
    { split; [rewrite <- (ring_first ring); exact (in_map fst _ _ J)|].
      apply (Permutation_in (l := map snd (ring_edges ring))).
      - apply Permutation_sym. rewrite <- (ring_first ring) at 1. apply ring_closed.
      - exact (in_map snd _ _ J). }
    destruct Both as [Ir Ik].
    apply (bends_real rows r k); auto.
Qed.
Theorem rings_form : is_form S ps.
Proof.
  exists (fun i => part_of (interior S) (nth i (map fst os) [])).
  assert (Len : length ps = length (map fst os)).
  { unfold ps, figure, each_vertex. rewrite !map_length. reflexivity. }
  rewrite Len. split; [|split; [|split]].
  - apply (falls_permuted _ (fun A => part_of (interior S) A) K _ classed falls).
  - intros x Sx N. destruct (set_steady_off x) as (r & R & H).
    + rewrite <- edges_over. intros (a & b & I & O). exact (N a b I O).
    + exists r. split; auto. intros y Y. apply (H y Y), Sx.
  - rewrite edges_real.
    apply (rows_share_points G G_long G_apart rows (eq_sym G_rows) rows_straight).
  - intros i outer holes E. unfold ps, figure, each_vertex in E. rewrite map_map in E.
    rewrite nth_error_map in E. destruct (nth_error os i) as [o|] eqn:Eo; [|discriminate].
    simpl in E. injection E; intros Eh Eu. pose proof (nth_error_In os i Eo) as Io.
    destruct (outline_parts o Io) as ((r & Er & Ar) & Hh & _).
    assert (Outer : outer = map R2 (corners_of r)).
    { rewrite <- Eu. unfold outer_corners. rewrite Er. simpl. rewrite app_nil_r. reflexivity. }
    assert (Nth : nth i (map fst os) [] = fst o).
    { apply nth_error_nth. exact (map_nth_error fst i os Eo). }
    split; [rewrite Outer; exact Ar|split].
    + intros hole Ih. rewrite <- Eh, map_map in Ih. apply in_map_iff in Ih.
      destruct Ih as (k & <- & Ik). apply Hh, Ik.
    + intros ring Ir.
      assert (G' : exists k, In k (rings_of_outline o) /\ ring = map R2 (corners_of k)).
      { destruct Ir as [<-|Ir].
        - exists r. split; [|exact Outer]. unfold rings_of_outline. rewrite Er. left. reflexivity.
        - rewrite <- Eh, map_map in Ir. apply in_map_iff in Ir. destruct Ir as (k & <- & Ik).
          exists k. split; auto. unfold rings_of_outline. apply in_or_app. auto. }
      destruct G' as (k & Ik & ->).
      assert (Irings : In k rings) by (apply in_flat_map; exists o; auto).
      split; [apply ring_is_ring, Irings|]. intros e Ie. rewrite (ring_points k Irings) in Ie.
      rewrite Nth. exact (edge_divides o k e Io Ik Ie).
Qed.
Lemma rings_in_order : in_order ps.
Proof.
  split; [|split].
  - intros ring I. rewrite rings_real in I. apply in_map_iff in I. destruct I as (k & <- & Ik).
    destruct (closed_parts k Ik) as (_ & _ & _ & _ & L). unfold begins_least in L.
    destruct (corners_of k) as [|p r]; [discriminate|]. simpl. intros q J.
    apply in_map_iff in J. destruct J as (v & <- & J). rewrite forallb_forall in L.
    apply is_before_real, L, J.
  - intros p I. unfold ps, figure, each_vertex in I. apply in_map_iff in I.
    destruct I as (q & <- & I). apply in_map_iff in I. destruct I as (o & <- & Io).
    destruct (outline_parts o Io) as (_ & _ & _ & _ & A). cbn [snd polygon_of].
    rewrite map_map. apply sorted_map. apply (ascending_sorted _ _ _ (fun r k => list_less_real _
      _) A).
  - destruct test_parts as (_ & _ & _ & A). unfold ps, figure, each_vertex. rewrite !map_map.
    apply sorted_map. apply (ascending_sorted _ _ _ (fun o k => list_less_real _ _) A).
Qed.
Theorem rings_canonical : is_canonical (set_of (rings_of ps)) ps.
Proof.
  split; [|exact rings_in_order]. apply (form_same S); [|exact rings_form].
  intros x. symmetry. apply set_is_set.
Qed.
End Formed.
