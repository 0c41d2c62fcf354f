(** The full cells of the slabs are the set. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Curves Local Across Overlaps Components
  OneForm
  Paths Decomposed Gaps Unique Convolution.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed.
Open Scope R_scope.

Lemma first_least {A} (R : A -> A -> Prop) l x y : StronglySorted R l -> hd_error l = Some x ->
  In y l -> y = x \/ R x y.
Proof.
  intros O E I. destruct l as [|z r]; [destruct I|]. injection E; intros ->.
  apply StronglySorted_inv in O. destruct O as [_ O]. rewrite Forall_forall in O.
  destruct I as [<-|I]; auto.
Qed.
Lemma last_greatest {A} (R : A -> A -> Prop) l x y : StronglySorted R l ->
  hd_error (rev l) = Some x -> In y l -> y = x \/ R y x.
Proof.
  intros O. induction O as [|z r O IH H]; [discriminate|]. simpl. intros E I.
  rewrite Forall_forall in H. destruct (rev r) as [|w k] eqn:Q.
  - simpl in E. injection E; intros ->. assert (r = []) as ->.
    { rewrite <- (rev_involutive r), Q. reflexivity. }
    destruct I as [<-|[]]. auto.
  - simpl in E. injection E; intros ->. destruct I as [<-|I]; [right|apply IH; auto].
    apply H, in_rev. rewrite Q. simpl. auto.
Qed.
Lemma in_cell_closed c : is_closed (in_cell c).
Proof.
  assert (Left : forall a b, is_closed (fun x => 0 <= orient a b x)).
  { intros a b x H. apply Rnot_lt_le. intros L. destruct (near_right a b x L) as (e & He & K).
    destruct (H e He) as (y & Y & O). specialize (K y Y). lra. }
  assert (Right : forall a b, is_closed (fun x => orient a b x <= 0)).
  { intros a b x H. apply Rnot_lt_le. intros L. destruct (near_left a b x L) as (e & He & K).
    destruct (H e He) as (y & Y & O). specialize (K y Y). lra. }
  assert (Weak : forall (H K : point -> Prop), (forall x, H x -> K x) -> is_closed K -> forall x,
    (forall e, 0 < e -> exists y, near e x y /\ H y) -> K x).
  { intros H K I C x L. apply C. intros e He. destruct (L e He) as (y & Y & Hy). eauto. }
  intros x Lim. repeat split.
  - intros q E. apply (Weak (in_cell c) (fun x => Q2R q <= fst x)); auto.
    + intros y Y. apply Y, E.
    + intros y L. apply Rnot_lt_le. intros G. destruct (L (Q2R q - fst y)) as (z & [Z _] & O);
        [lra|]. apply Rabs_def2 in Z. lra.
  - intros q E. apply (Weak (in_cell c) (fun x => fst x <= Q2R q)); auto.
    + intros y Y. apply Y, E.
    + intros y L. apply Rnot_lt_le. intros G. destruct (L (fst y - Q2R q)) as (z & [Z _] & O);
        [lra|]. apply Rabs_def2 in Z. lra.
  - intros e E. apply (Weak (in_cell c) (fun x => 0 <= level e x)); auto; [|apply Left].
    intros y Y. apply Y, E.
  - intros e E. apply (Weak (in_cell c) (fun x => level e x <= 0)); auto; [|apply Right].
    intros y Y. apply Y, E.
Qed.

Section Cells.
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

(** Where a cell is: in a slab, or left or right of all walls *)
Lemma cell_where c : In c (concat (slabs B)) ->
  (exists x0 x1, In (x0, x1) (adjacent (walls B)) /\ In c (slab B x0 x1)) \/
  (bottom c = None /\ top c = None /\
    ((from c = None /\ to c = hd_error (walls B)) \/
     (from c = hd_error (rev (walls B)) /\ to c = None))).
Proof.
  unfold slabs. cbn [concat]. rewrite concat_app. intros I. apply in_app_or in I.
  destruct I as [[<-|[]]|I].
  { right. cbn [from to bottom top]. auto. }
  apply in_app_or in I. destruct I as [I|I].
  - left. apply in_concat in I. destruct I as (k & K & I). apply in_map_iff in K.
    destruct K as ([x0 x1] & <- & K). exists x0, x1. auto.
  - right. destruct (hd_error (rev (walls B))) as [x|]; [|destruct I].
    simpl in I. destruct I as [<-|[]]. cbn [from to bottom top]. auto.
Qed.
Lemma walls_sorted : StronglySorted (fun x y => Qle_bool y x = false) (walls B).
Proof.
  apply unique_strict; [apply numbers_total|apply numbers_transitive|apply numbers_equal|].
  apply sort_ordered; [apply numbers_total|apply numbers_transitive].
Qed.
Lemma outer_clear c y : bottom c = None -> top c = None ->
  (from c = None /\ to c = hd_error (walls B)) \/
    (from c = hd_error (rev (walls B)) /\ to c = None) -> within_cell c y -> ~ over_some B y.
Proof.
  intros _ _ W (A & D & _ & _) (e & I & O). destruct (between_walls B e y I O) as
    (p & q & P & Q & L & H). pose proof walls_sorted as Or.
  assert (Lt : forall u v, u = v \/ Qle_bool u v = false -> Q2R v <= Q2R u).
  { intros u v [->|F]; [lra|]. apply not_true_iff_false in F. rewrite le_real in F. lra. }
  destruct W as [[_ T]|[F _]].
  - destruct (walls B) as [|x r] eqn:Eq; [destruct P|].
    pose proof (D x T) as Y. destruct (first_least _ _ x p Or eq_refl P) as [E|E].
    + subst. lra.
    + pose proof (Lt p x (or_intror E)). lra.
  - assert (G : exists x, hd_error (rev (walls B)) = Some x).
    { destruct (rev (walls B)) as [|x r] eqn:Eq; [|exists x; reflexivity].
      apply in_rev in P. rewrite Eq in P. destruct P. }
    destruct G as (x & G). pose proof (A x (eq_trans F G)) as Y.
    destruct (last_greatest _ _ x q Or G Q) as [E|E].
    + subst. lra.
    + pose proof (Lt x q (or_intror E)). lra.
Qed.
Lemma outer_told c : bottom c = None -> top c = None ->
  (from c = None /\ to c = hd_error (walls B)) \/
    (from c = hd_error (rev (walls B)) /\ to c = None) ->
  exists z, within_cell c z /\ ~ S z.
Proof.
  intros Eb Et W.
  assert (G : exists x, (forall q, from c = Some q -> Q2R q < x) /\
    (forall q, to c = Some q -> x < Q2R q)).
  { destruct W as [[F T]|[F T]]; rewrite F, T.
    - destruct (hd_error (walls B)) as [q|].
      + exists (Q2R q - 1). split; [discriminate|]. intros p E. injection E; intros <-. lra.
      + exists 0. split; discriminate.
    - destruct (hd_error (rev (walls B))) as [q|].
      + exists (Q2R q + 1). split; [|discriminate]. intros p E. injection E; intros <-. lra.
      + exists 0. split; discriminate. }
  destruct G as (x & G1 & G2). exists (x, high + 1). split.
  - split; [exact G1|split; [exact G2|rewrite Eb, Et; split; discriminate]].
  - intros H. apply to_high in H. cbn [snd] in H. lra.
Qed.

(** In an open cell is all of the set or nothing, as the program says. *)
Theorem cell_told c y : In c (concat (slabs B)) -> within_cell c y -> (S y <-> full c = true).
Proof.
  intros I Y. destruct (cell_where c I) as [(x0 & x1 & A & J)|(Eb & Et & W)].
  - destruct (slab_cell_told S B sided low from_low x0 x1 A c J) as (z & Z & H).
    rewrite <- H. apply (steady_within S B steady_off c); auto.
    intros p P. apply (slab_cell_clear B alike x0 x1 A c p J P).
  - destruct (outer_told c Eb Et W) as (z & Z & H). unfold full. rewrite Eb.
    assert (E : S y <-> S z).
    { apply (steady_within S B steady_off c); auto. intros p P. apply (outer_clear c p Eb Et W P). }
    rewrite E. split; [tauto|discriminate].
Qed.
(** The open cells leave out the edges and the walls. *)
Theorem cells_cover y : ~ over_some B y -> (forall w, In w (walls B) -> fst y <> Q2R w) ->
  exists c, In c (concat (slabs B)) /\ within_cell c y.
Proof.
  intros N Off. unfold slabs. cbn [concat]. rewrite concat_app.
  destruct (classic (exists w, In w (walls B) /\ Q2R w < fst y)) as [(u & U & Lu)|NL].
  2: { exists {| from := None; to := hd_error (walls B); bottom := None; top := None |}.
    split; [apply in_or_app; left; simpl; auto|]. repeat split; cbn [from to bottom top];
      try discriminate. intros q E. destruct (walls B) as [|x r]; [discriminate|].
    injection E; intros <-. destruct (Rlt_dec (fst y) (Q2R x)); auto. exfalso.
    pose proof (Off x (or_introl eq_refl)). apply NL. exists x. split; [left; auto|lra]. }
  destruct (classic (exists w, In w (walls B) /\ fst y < Q2R w)) as [(v & V & Lv)|NH].
  - destruct (begins_between Qle_bool Qeq_bool numbers_total numbers_transitive numbers_equal
      (fun w => fst y < Q2R w) (flat_map (fun e : edge => [fst (fst e); fst (snd e)]) B) u v)
      as (p & q & A & Np & Hq); auto.
    + intros a b L H. apply le_real in L. lra.
    + lra.
    + destruct (adjacent_in _ _ _ A) as [P _]. pose proof (Off p P).
      destruct (slab_cover B p q y) as (c & I & W); auto; [lra|].
      exists c. split; auto. apply in_or_app. right. apply in_or_app. left.
      apply in_concat. exists (slab B p q). split; auto.
      apply in_map_iff. exists (p, q). auto.
  - assert (Rv : exists x, hd_error (rev (walls B)) = Some x /\ In x (walls B)).
    { destruct (rev (walls B)) as [|x r] eqn:Q.
      - apply in_rev in U. rewrite Q in U. destruct U.
      - exists x. split; auto. apply in_rev. rewrite Q. simpl. auto. }
    destruct Rv as (x & Ex & Ix). rewrite Ex.
    exists {| from := Some x; to := None; bottom := None; top := None |}.
    split; [apply in_or_app; right; apply in_or_app; right; simpl; auto|].
    repeat split; cbn [from to bottom top]; try discriminate.
    intros q E. injection E; intros <-.
    destruct (Rlt_dec (Q2R x) (fst y)); auto. exfalso.
    pose proof (Off x Ix). apply NH. exists x. split; [exact Ix|lra].
Qed.
(** Near each point are others, on no edge and no wall. *)
Lemma aside_near x r : 0 < r -> exists y, near r x y /\ ~ over_some B y /\
  forall w, In w (walls B) -> fst y <> Q2R w.
Proof.
  intros R.
  assert (Es : soon (fun t => forall e, In e B ->
    orient (start e) (finish e) (curve x (0, 0) t) <> 0)).
  { apply soon_all. intros e I. apply curve_off, long, I. }
  assert (Ws : soon (fun t => forall w, In w (walls B) ->
    orient (Q2R w, 0) (Q2R w, 1) (curve x (0, 0) t) <> 0)).
  { apply soon_all. intros w I. apply curve_off. intros E. injection E. lra. }
  destruct (soon_exists _ (soon_and _ _ (curve_near r x (0, 0) R) (soon_and _ _ Es Ws))) as
    (t & _ & H1 & H2 & H3).
  exists (curve x (0, 0) t). split; [auto|split].
  - intros (e & I & O). apply (H2 e I). apply segment_range in O. exact (proj1 O).
  - intros w I E. apply (H3 w I). unfold orient. cbn [fst snd]. rewrite E. ring.
Qed.

Theorem full_cells x : (exists c, In c (concat (slabs B)) /\ full c = true /\ in_cell c x) <-> S x.
Proof.
  destruct regular as [Closed Reg]. split.
  - intros (c & I & F & X).
    assert (Z : exists z, within_cell c z).
    { destruct (cell_where c I) as [(x0 & x1 & A & J)|(Eb & _)].
      - destruct (slab_cell_told S B sided low from_low x0 x1 A c J) as (z & Z & _). eauto.
      - unfold full in F. rewrite Eb in F. discriminate. }
    destruct Z as (z & Z). apply Closed. intros e He.
    destruct (at_near x z 0 e He) as (d & Hd & K). rewrite at_0 in K.
    set (t := Rmin 1 (d / 2)). assert (T : 0 < t <= 1 /\ t < d).
    { unfold t. pose proof (Rmin_l 1 (d / 2)). pose proof (Rmin_r 1 (d / 2)).
      assert (0 < Rmin 1 (d / 2)) by (apply Rmin_glb_lt; lra). lra. }
    exists (at_ x z t). split.
    + apply K. rewrite Rminus_0_r, Rabs_right; lra.
    + apply (cell_told c); auto. apply toward_inside; tauto.
  - intros Sx. destruct (closed_finite (filter full (concat (slabs B))) in_cell) with (x := x)
      as (c & J & X).
    + intros c _. apply in_cell_closed.
    + intros e He. destruct (Reg x (e / 2) Sx ltac:(lra)) as (p & P & (r & R & K)).
      destruct (aside_near p (Rmin r (e / 2))) as (y & Y & N & W); [apply Rmin_glb_lt; lra|].
      apply near_min in Y. destruct Y as [Y1 Y2].
      exists y. split; [exact (near_near e x p y P Y2)|].
      destruct (cells_cover y N W) as (c & I & H). exists c.
      split; [|apply within_in, H]. apply filter_In. split; auto.
      apply (cell_told c y I H), K, Y1.
    + exists c. apply filter_In in J. tauto.
Qed.
End Cells.
