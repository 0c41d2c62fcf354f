(** The inner points of a set fall into the classes of full cells, what is outside of it into the
    classes of the others. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Curves Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique Boundaries Convolution.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Parted Disjoint Together Linked.
Open Scope R_scope.

Lemma interior_open S x : interior S x -> interior (interior S) x.
Proof.
  intros (e & He & K). exists (e / 2). split; [lra|]. intros y Y. exists (e / 2). split; [lra|].
  intros z Z. apply K, (near_near e x y z Y Z).
Qed.
Lemma closed_off S x : is_closed S -> ~ S x -> interior (fun y => ~ S y) x.
Proof.
  intros C N. apply NNPP. intros M. apply N, C. intros e He. apply NNPP. intros L. apply M.
  exists e. split; auto. intros y Y Sy. apply L. eauto.
Qed.

Section Coloured.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.
Variable B : list edge.
Hypothesis steady_off : forall x, ~ over_some B x -> steady S x.
Hypothesis long : forall e, In e B -> start e <> finish e.
Hypothesis alike : forall e f x, In e B -> In f B -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Hypothesis sided : forall e x, In e B -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> S y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Variables low high : R.
Hypothesis from_low : forall y, S y -> low <= snd y.
Hypothesis to_high : forall y, S y -> snd y <= high.
Let cells := concat (slabs B).

Lemma cell_centre c : In c cells -> exists z, within_cell c z.
Proof.
  intros I. destruct (cell_where B c I) as [(x0 & x1 & A & J)|(Eb & Et & W)].
  - destruct (slab_cell_told S B sided low from_low x0 x1 A c J) as (z & Z & _). eauto.
  - destruct (outer_told S B high to_high c Eb Et W) as (z & Z & _). eauto.
Qed.
Lemma cell_clear c y : In c cells -> within_cell c y -> ~ over_some B y.
Proof.
  intros I Y. destruct (cell_where B c I) as [(x0 & x1 & A & J)|(Eb & Et & W)].
  - exact (slab_cell_clear B alike x0 x1 A c y J Y).
  - exact (outer_clear B c y Eb Et W Y).
Qed.
Lemma told c y : In c cells -> within_cell c y -> (S y <-> full c = true).
Proof.
  apply (cell_told S B steady_off alike sided low high from_low to_high).
Qed.
(** Near each point of an edge the set is on one side, and not on the other. *)
Lemma edge_both_ways e x r : In e B -> lies_on e x -> 0 < r ->
  (exists y, near r x y /\ S y) /\ (exists y, near r x y /\ ~ S y).
Proof.
  intros I O R. pose proof (long e I) as N.
  destruct (aside [start e; finish e] _ _ x (r / 2) N O) as (y & Oy & Ny & Out); [lra|].
  assert (Iy : inside e y).
  { apply inner_of_segment; auto; intros E; apply Out; simpl; auto. }
  destruct (sided e y I Iy) as (s & Hs & K).
  pose proof (inner_on_line _ _ _ Iy) as Z. split.
  - destruct (left_close _ _ y (Rmin s (r / 2)) N Z) as (z & Nz & L); [apply Rmin_glb_lt; lra|].
    apply near_min in Nz. exists z. split; [apply (near_near r x y z Ny); tauto|].
    apply (K z); tauto.
  - destruct (right_close _ _ y (Rmin s (r / 2)) N Z) as (z & Nz & L); [apply Rmin_glb_lt; lra|].
    apply near_min in Nz. exists z. split; [apply (near_near r x y z Ny); tauto|].
    apply (K z); tauto.
Qed.
(** A little to the side *)
Lemma aside_of y r : 0 < r -> exists z, near r y z /\ fst z <> fst y.
Proof.
  intros R. exists (fst y + r / 2, snd y). split; [split; apply Rabs_def1|]; cbn [fst snd]; lra.
Qed.
Lemma near_within x y r : near r x y -> exists s, 0 < s /\ forall z, near s y z -> near r x z.
Proof.
  intros [A D]. exists (Rmin (r - Rabs (fst y - fst x)) (r - Rabs (snd y - snd x))).
  split; [apply Rmin_glb_lt; lra|]. intros z Z. apply near_min in Z. destruct Z as [[Z _] [_ Z']].
  split.
  - replace (fst z - fst x) with ((fst z - fst y) + (fst y - fst x)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
  - replace (snd z - snd x) with ((snd z - snd y) + (snd y - snd x)) by ring.
    eapply Rle_lt_trans; [apply Rabs_triang|lra].
Qed.

Theorem inside_falls : falls_into (interior S) (fun i => part_of (interior S)
  (nth i (parts B true) [])) (length (parts B true)).
Proof.
  destruct regular as [Closed _].
  assert (In_S : forall y, interior S y -> S y) by (intros y (e & He & K); apply K, near_self, He).
  apply (parts_fall B alike cell_centre (interior S) true).
  - exact (interior_open S).
  - intros c y I Y. rewrite <- (told c y I Y). split; auto. intros Sy.
    destruct (steady_off y (cell_clear c y I Y)) as (r & R & K). exists r. split; auto.
    intros z Z. apply (K z Z), Sy.
  - intros x X. apply (full_cells S regular B steady_off long alike sided low high from_low
      to_high x), In_S, X.
  - intros x (r & R & K) (e & I & O). destruct (edge_both_ways e x r I O R) as [_ (y & Y & N)].
    apply N, K, Y.
  - intros m r R K. exists r. split; auto. intros y Y.
    destruct (Req_dec (fst y) (fst m)) as [E|E]; [|apply In_S, K; auto].
    apply Closed. intros e He. destruct (near_within m y r Y) as (s & Hs & W).
    destruct (aside_of y (Rmin e s)) as (z & Z & N); [apply Rmin_glb_lt; auto|].
    apply near_min in Z. exists z. split; [tauto|]. apply In_S, K; [apply W; tauto|congruence].
Qed.
Theorem outside_falls : falls_into (fun x => ~ S x) (fun i => part_of (fun x => ~ S x)
  (nth i (parts B false) [])) (length (parts B false)).
Proof.
  destruct regular as [Closed Reg].
  assert (Told : forall c y, In c cells -> within_cell c y -> (~ S y <-> full c = false)).
  { intros c y I Y. rewrite (told c y I Y). destruct (full c); split; congruence. }
  apply (parts_fall B alike cell_centre (fun x => ~ S x) false).
  - intros x X. apply closed_off; auto.
  - exact Told.
  - intros x X. destruct (closed_off S x Closed X) as (r & R & K).
    destruct (closed_finite (filter (fun c => negb (full c)) cells) in_cell) with (x := x)
      as (c & J & Y).
    + intros c _. apply in_cell_closed.
    + intros e He. destruct (aside_near B long x (Rmin e r)) as (y & Y & N & W);
        [apply Rmin_glb_lt; auto|]. apply near_min in Y. exists y. split; [tauto|].
      destruct (cells_cover B y N W) as (c & I & H). exists c. split; [|apply within_in, H].
      apply filter_In. split; auto. apply negb_true_iff, (Told c y I H), K. tauto.
    + apply filter_In in J. destruct J as [J F]. apply negb_true_iff in F. eauto.
  - intros x X (e & I & O). destruct (closed_off S x Closed X) as (r & R & K).
    destruct (edge_both_ways e x r I O R) as [(y & Y & Sy) _]. exact (K y Y Sy).
  - intros m r R K Sm. destruct (Reg m r Sm R) as (y & Y & (e & He & H)).
    destruct (near_within m y r Y) as (s & Hs & W).
    destruct (Req_dec (fst y) (fst m)) as [E|E].
    + destruct (aside_of y (Rmin e s)) as (z & Z & N); [apply Rmin_glb_lt; auto|].
      apply near_min in Z. apply (K z); [apply W; tauto|congruence|apply H; tauto].
    + apply (K y Y E), H, near_self, He.
Qed.
Theorem has_parts : has_components S (length (parts B true)).
Proof. eexists. exact inside_falls. Qed.
End Coloured.
