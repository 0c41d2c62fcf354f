(** A set whose frontier is on edges that do not cross: in each open cell of their slabs is all of
  it
    or nothing, as the edge below says. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Paths Decomposed Gaps
  Unique Beside.
From Proved Require Import Points Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks Kept
  Frontier Stacks.
Open Scope R_scope.

(** The points of a cell, and those inside it *)
Definition in_cell (c : cell) (x : point) : Prop :=
  (forall q, from c = Some q -> Q2R q <= fst x) /\ (forall q, to c = Some q -> fst x <= Q2R q) /\
  (forall e, bottom c = Some e -> 0 <= level e x) /\ (forall e, top c = Some e -> level e x <= 0).
Definition within_cell (c : cell) (x : point) : Prop :=
  (forall q, from c = Some q -> Q2R q < fst x) /\ (forall q, to c = Some q -> fst x < Q2R q) /\
  (forall e, bottom c = Some e -> 0 < level e x) /\ (forall e, top c = Some e -> level e x < 0).
Lemma level_segment e x y t : level e (at_ x y t) = (1 - t) * level e x + t * level e y.
Proof. unfold level, orient, at_; cbn [fst snd]. ring. Qed.
Lemma toward_inside c x y t : in_cell c x -> within_cell c y -> 0 < t <= 1 ->
  within_cell c (at_ x y t).
Proof.
  intros (A & B & C & D) (A' & B' & C' & D') T.
  assert (F : fst (at_ x y t) = (1 - t) * fst x + t * fst y) by (unfold at_; cbn [fst snd]; ring).
  repeat split.
  - intros q E. specialize (A q E). specialize (A' q E). rewrite F. nra.
  - intros q E. specialize (B q E). specialize (B' q E). rewrite F. nra.
  - intros e E. specialize (C e E). specialize (C' e E). rewrite level_segment. nra.
  - intros e E. specialize (D e E). specialize (D' e E). rewrite level_segment. nra.
Qed.
Lemma within_in c x : within_cell c x -> in_cell c x.
Proof.
  intros (A & B & C & D). repeat split; intros q E.
  - specialize (A q E). lra.
  - specialize (B q E). lra.
  - specialize (C q E). lra.
  - specialize (D q E). lra.
Qed.
Lemma within_segment c x y p : within_cell c x -> within_cell c y -> on_segment x y p ->
  within_cell c p.
Proof.
  intros X Y (t & T & E). change (p = at_ x y t) in E. destruct (Req_dec t 0) as [->|N].
  - rewrite E, at_0. exact X.
  - rewrite E. apply toward_inside; [apply within_in, X|exact Y|lra].
Qed.

Section Slabbed.
Variable S : point -> Prop.
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

Lemma steady_within c y z : (forall p, within_cell c p -> ~ over_some B p) -> within_cell c y ->
  within_cell c z -> (S y <-> S z).
Proof.
  intros H Y Z. apply steady_along. intros p P. apply steady_off, H.
  exact (within_segment c y z p Y Z P).
Qed.

(** ** Walls *)
Lemma numbers_total x y : Qle_bool x y = true \/ Qle_bool y x = true.
Proof. rewrite !le_real. lra. Qed.
Lemma numbers_transitive x y z : Qle_bool x y = true -> Qle_bool y z = true ->
  Qle_bool x z = true.
Proof. rewrite !le_real. lra. Qed.
Lemma numbers_equal x y : Qle_bool x y = true -> Qle_bool y x = true -> Qeq_bool x y = true.
Proof. rewrite !le_real, equal_real. lra. Qed.
Lemma wall_at e : In e B -> exists p q, In p (walls B) /\ In q (walls B) /\
  Q2R p = fst (start e) /\ Q2R q = fst (finish e).
Proof.
  intros I.
  assert (G : forall x, In x (flat_map (fun e : edge => [fst (fst e); fst (snd e)]) B) ->
    exists p, In p (walls B) /\ Q2R p = Q2R x).
  { intros x X. destruct (in_turn_has Qle_bool Qeq_bool (fun x y => Q2R x = Q2R y)
      (flat_map (fun e : edge => [fst (fst e); fst (snd e)]) B) x) as (p & P & E); eauto.
    - intros u v w -> ->. reflexivity.
    - intros u v. apply equal_real. }
  destruct (G (fst (fst e))) as (p & P & Ep). { apply in_flat_map. exists e. simpl. auto. }
  destruct (G (fst (snd e))) as (q & Q & Eq). { apply in_flat_map. exists e. simpl. auto. }
  exists p, q. auto.
Qed.
Lemma between_walls e y : In e B -> lies_on e y -> exists p q, In p (walls B) /\ In q (walls B) /\
  Q2R p <= fst y <= Q2R q.
Proof.
  intros I O. destruct (wall_at e I) as (p & q & P & Q & Ep & Eq).
  apply segment_range in O. fold (start e) (finish e) in O. destruct O as (_ & [O|O] & _).
  - exists p, q. rewrite Ep, Eq. auto.
  - exists q, p. rewrite Ep, Eq. auto.
Qed.

(** ** A slab *)
Section Slab.
Variables x0 x1 : Q.
Hypothesis here : In (x0, x1) (adjacent (walls B)).
Let l := by_height (Qred ((x0 + x1) / 2)) (filter (spans x0 x1) B).
Let m := Q2R (Qred ((x0 + x1) / 2)).
Lemma wall_order : Q2R x0 < Q2R x1 /\ forall w, In w (walls B) ->
  Q2R w <= Q2R x0 \/ Q2R x1 <= Q2R w.
Proof.
  destruct (neighbours _ _ numbers_total numbers_transitive numbers_equal _ _ _ here) as [L K].
  apply not_true_iff_false in L. rewrite le_real in L. split; [lra|].
  intros w W. destruct (K w W) as [H|H]; apply le_real in H; auto.
Qed.
Lemma mid_between : Q2R x0 < m < Q2R x1.
Proof.
  pose proof (proj1 wall_order). unfold m. rewrite Q2R_red, half_real, Q2R_plus. lra.
Qed.
(** An edge over the slab *)
Definition over_slab (e : edge) : Prop := In e B /\ slopes e /\
  forall x, Q2R x0 < x < Q2R x1 -> inside e (x, height_of e x).
Lemma inside_line a b x y : fst a < x < fst b \/ fst b < x < fst a -> fst a <> fst b ->
  y = line_at a b x -> inner a b (x, y).
Proof.
  intros X N ->. exists ((x - fst a) / (fst b - fst a)).
  assert (K : (x - fst a) / (fst b - fst a) * (fst b - fst a) = x - fst a) by (field; lra).
  unfold line_at. set (k := (x - fst a) / (fst b - fst a)) in *. split; [destruct X; split; nra|].
  f_equal; [lra|]. replace (x - fst a) with (k * (fst b - fst a)) by auto. field. lra.
Qed.
Lemma spans_over e : In e B -> spans x0 x1 e = true -> over_slab e.
Proof.
  intros I H. unfold spans in H. rewrite !andb_true_iff, !le_real, negb_true_iff,
    vertical_real in H.
  destruct H as [[L R] N]. split; [exact I|split; [exact N|]]. intros x X.
  apply inside_line; auto.
  destruct (from_left_cases e N) as [(_ & D & E)|(_ & D & E)]; rewrite E in L, R;
    cbn [fst snd] in L, R.
  - left. change (Q2R (fst (fst e))) with (fst (start e)) in L.
    change (Q2R (fst (snd e))) with (fst (finish e)) in R. lra.
  - right. change (Q2R (fst (snd e))) with (fst (finish e)) in L.
    change (Q2R (fst (fst e))) with (fst (start e)) in R. lra.
Qed.
Lemma over_spans e y : In e B -> lies_on e y -> Q2R x0 < fst y < Q2R x1 -> spans x0 x1 e = true.
Proof.
  intros I O Y. destruct (wall_at e I) as (p & q & P & Q & Ep & Eq). destruct wall_order as [_ K].
  pose proof (K p P) as Kp. pose proof (K q Q) as Kq. rewrite Ep in Kp. rewrite Eq in Kq.
  apply segment_range in O. fold (start e) (finish e) in O. destruct O as (_ & O & _).
  assert (N : slopes e) by (unfold slopes; lra).
  unfold spans. rewrite !andb_true_iff, !le_real, negb_true_iff, vertical_real.
  destruct (from_left_cases e N) as [(_ & D & E)|(_ & D & E)]; rewrite E; cbn [fst snd].
  - change (Q2R (fst (fst e))) with (fst (start e)).
    change (Q2R (fst (snd e))) with (fst (finish e)). split; [split|exact N]; lra.
  - change (Q2R (fst (fst e))) with (fst (start e)).
    change (Q2R (fst (snd e))) with (fst (finish e)). split; [split|exact N]; lra.
Qed.
Lemma stacked_over e : In e l -> over_slab e.
Proof.
  intros I. apply by_height_from, filter_In in I. apply spans_over; tauto.
Qed.
(** Edges over a slab do not cross in it. *)
Lemma no_crossing e f x y : over_slab e -> over_slab f -> Q2R x0 < x < Q2R x1 ->
  Q2R x0 < y < Q2R x1 -> height_of e x < height_of f x -> height_of e y < height_of f y.
Proof.
  intros (Ie & Ne & He) (If & Nf & Hf) X Y L. apply Rnot_le_lt. intros G.
  set (d := fun x => height_of f x - height_of e x).
  assert (Lin : forall t, d (x + t * (y - x)) = (1 - t) * d x + t * d y)
    by (intros t; unfold d, height_of, line_at; ring).
  assert (D1 : 0 < d x) by (unfold d; lra). assert (D2 : d y <= 0) by (unfold d; lra).
  set (t := d x / (d x - d y)).
  assert (T : t * (d x - d y) = d x) by (unfold t; field; lra).
  assert (T' : 0 < t <= 1) by (split; apply Rnot_le_lt || apply Rnot_lt_le; intros H; nra).
  set (z := x + t * (y - x)). assert (Z : Q2R x0 < z < Q2R x1) by (unfold z; nra).
  assert (E : height_of e z = height_of f z).
  { assert (H : d z = 0) by (unfold z; rewrite Lin; lra). unfold d in H. lra. }
  assert (O : lies_on f (x, height_of e x)).
  { apply (alike e f (z, height_of e z)); auto; [rewrite E; auto|].
    apply inside_on, He, X. }
  apply on_height in O; auto. cbn [fst snd] in O. lra.
Qed.
Lemma not_crossing e f x y : over_slab e -> over_slab f -> Q2R x0 < x < Q2R x1 ->
  Q2R x0 < y < Q2R x1 -> height_of e x <= height_of f x -> height_of e y <= height_of f y.
Proof.
  intros He Hf X Y L. apply Rnot_lt_le. intros G.
  pose proof (no_crossing f e y x Hf He Y X G). lra.
Qed.
Lemma heights_mid e : over_slab e -> Q2R (height (Qred ((x0 + x1) / 2)) e) = height_of e m.
Proof. intros (_ & N & _). apply height_real, N. Qed.

Lemma slab_cell c : In c (slab B x0 x1) ->
  (from c = Some x0 /\ to c = Some x1) /\
  (forall e, bottom c = Some e -> over_slab e) /\ (forall f, top c = Some f -> over_slab f) /\
  (forall e f, bottom c = Some e -> top c = Some f -> height_of e m < height_of f m) /\
  (forall g, over_slab g -> (exists e, bottom c = Some e /\ height_of g m <= height_of e m) \/
    (exists f, top c = Some f /\ height_of f m <= height_of g m)).
Proof.
  intros I. destruct (stack_cell x0 x1 (fun e => Q2R (height (Qred ((x0 + x1) / 2)) e)) l None
    (by_height_sorted _ _) ltac:(discriminate) c I) as (A & P & Q & D & G).
  split; [exact A|].
  assert (P' : forall e, bottom c = Some e -> over_slab e).
  { intros e E. destruct (P e E) as [F|F]; [discriminate|]. apply stacked_over, F. }
  assert (Q' : forall f, top c = Some f -> over_slab f) by (intros f E; apply stacked_over, Q, E).
  split; [exact P'|split; [exact Q'|split]].
  - intros e f E F. specialize (D e f E F). cbv beta in D.
    rewrite (heights_mid e (P' e E)), (heights_mid f (Q' f F)) in D. exact D.
  - intros g (Ig & Ng & Hg).
    assert (J : In g (filter (spans x0 x1) B)).
    { apply filter_In. split; auto. apply (over_spans g (m, height_of g m)); auto.
      - apply inside_on, Hg, mid_between.
      - apply mid_between. }
    destruct (by_height_has (Qred ((x0 + x1) / 2)) _ g J) as (g' & J' & E).
    assert (O' : over_slab g') by (apply stacked_over, J').
    rewrite (heights_mid g') in E by exact O'. rewrite (height_real _ g Ng) in E. fold m in E.
    rewrite <- E, <- (heights_mid g' O').
    destruct (G g' (or_intror J')) as [(e & Ee & H)|(f & Ef & H)]; [left; exists e|right; exists f];
      (split; [auto|]); cbv beta in H.
    + rewrite (heights_mid e (P' e Ee)) in H. exact H.
    + rewrite (heights_mid f (Q' f Ef)) in H. exact H.
Qed.
(** No edge passes through an open cell. *)
Lemma slab_cell_clear c y : In c (slab B x0 x1) -> within_cell c y -> ~ over_some B y.
Proof.
  intros I (A & D & F & G) (g & Ig & O).
  destruct (slab_cell c I) as ((A' & D') & P & Q & _ & K).
  pose proof (A _ A') as Y0. pose proof (D _ D') as Y1.
  pose proof (spans_over g Ig (over_spans g y Ig O (conj Y0 Y1))) as Hg.
  pose proof (on_height g y (proj1 (proj2 Hg)) O) as Hy.
  destruct (K g Hg) as [(e & E & H)|(f & E & H)].
  - pose proof (not_crossing g e m (fst y) Hg (P e E) mid_between (conj Y0 Y1) H) as L.
    pose proof (F e E) as L'. apply level_sign in L'; [lra|apply (P e E)].
  - pose proof (not_crossing f g m (fst y) (Q f E) Hg mid_between (conj Y0 Y1) H) as L.
    pose proof (G f E) as L'. apply level_sign in L'; [lra|apply (Q f E)].
Qed.
(** A point inside a cell where the set is as the edge below says *)
Lemma slab_cell_told c : In c (slab B x0 x1) -> exists z, within_cell c z /\ (S z <->
  full c = true).
Proof.
  intros I. destruct (slab_cell c I) as ((A & D) & P & Q & Or & _).
  pose proof mid_between as M.
  assert (In_it : forall h, (forall e, bottom c = Some e -> height_of e m < h) ->
    (forall f, top c = Some f -> h < height_of f m) -> within_cell c (m, h)).
  { intros h L H. repeat split; cbn [fst snd].
    - intros q E. rewrite A in E. injection E; intros <-. lra.
    - intros q E. rewrite D in E. injection E; intros <-. lra.
    - intros e E. apply level_sign; [apply (P e E)|]. cbn [fst snd]. auto.
    - intros f E. apply level_sign; [apply (Q f E)|]. cbn [fst snd]. auto. }
  unfold full. destruct (bottom c) as [e|] eqn:E.
  - destruct (P e eq_refl) as (Ie & Ne & He). pose proof (He m M) as X.
    destruct (sided e _ Ie X) as (r & Hr & R).
    assert (Top : exists k, 0 < k /\ forall f, top c = Some f -> height_of e m + k < height_of f m).
    { destruct (top c) as [f|] eqn:F.
      - exists ((height_of f m - height_of e m) / 2). pose proof (Or e f eq_refl eq_refl).
        split; [lra|]. intros g G. injection G; intros <-. lra.
      - exists 1. split; [lra|]. discriminate. }
    destruct Top as (k & K & Top). set (d := Rmin (r / 2) k).
    assert (Dd : 0 < d /\ d < r /\ d <= k).
    { unfold d. pose proof (Rmin_l (r / 2) k). pose proof (Rmin_r (r / 2) k).
      assert (0 < Rmin (r / 2) k) by (apply Rmin_glb_lt; lra). lra. }
    exists (m, height_of e m + d). split.
    + apply In_it; [intros f G; injection G; intros <-; lra|]. intros f F. specialize (Top f F).
        lra.
    + destruct (R (m, height_of e m + d)) as [R1 R2].
      { split; apply Rabs_def1; cbn [fst snd]; lra. }
      rewrite orient_line in R1, R2 by exact Ne. cbn [fst snd] in R1, R2.
      fold (height_of e m) in R1, R2.
      destruct (from_left_cases e Ne) as [(F & L & _)|(F & L & _)]; rewrite F.
      * assert (S (m, height_of e m + d)) by (apply R1; nra). tauto.
      * assert (~ S (m, height_of e m + d)) by (apply R2; nra). split; [tauto|discriminate].
  - set (h := match top c with Some f => Rmin low (height_of f m) - 1 | None => low - 1 end).
    exists (m, h). split.
    + apply In_it; [discriminate|]. intros f F. unfold h. rewrite F.
      pose proof (Rmin_r low (height_of f m)). lra.
    + split; [|discriminate]. intros Sm. apply from_low in Sm. cbn [snd] in Sm. unfold h in Sm.
      destruct (top c) as [f|]; [pose proof (Rmin_l low (height_of f m))|]; lra.
Qed.
Lemma slab_cover y : Q2R x0 < fst y < Q2R x1 -> ~ over_some B y ->
  exists c, In c (slab B x0 x1) /\ within_cell c y.
Proof.
  intros Y N. destruct (stack_cover x0 x1 y l None) as (c & I & A & D & F & G).
  - discriminate.
  - intros e J Z. destruct (stacked_over e J) as (Ie & Ne & He). apply N. exists e. split; auto.
    destruct (level_sign e y Ne) as [L1 L2].
    assert (H : snd y = height_of e (fst y)).
    { destruct (Rtotal_order (snd y) (height_of e (fst y))) as [H|[H|H]]; auto.
      - apply L2 in H. lra.
      - apply L1 in H. lra. }
    replace y with (fst y, height_of e (fst y)).
    + apply inside_on, He, Y.
    + rewrite <- H. destruct y; reflexivity.
  - exists c. split; [exact I|]. repeat split; auto.
    + intros q E. rewrite A in E. injection E; intros <-. tauto.
    + intros q E. rewrite D in E. injection E; intros <-. tauto.
Qed.
End Slab.
End Slabbed.
