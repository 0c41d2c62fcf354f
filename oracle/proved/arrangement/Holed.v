(** The first class of cells outside of the set is the unbounded one; the others are holes. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Parted Disjoint Together Linked Coloured.
Open Scope R_scope.

(** ** Bounded cells *)
Lemma line_bounded a b l h : exists M, forall x, l <= x <= h -> Rabs (line_at a b x) <= M.
Proof.
  set (k := (snd b - snd a) / (fst b - fst a)).
  exists (Rabs (snd a) + (Rabs l + Rabs h + Rabs (fst a)) * Rabs k). intros x X.
  unfold line_at. fold k. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
  apply Rplus_le_compat_l, Rmult_le_compat_r; [apply Rabs_pos|].
  unfold Rabs. destruct (Rcase_abs (x - fst a)), (Rcase_abs l), (Rcase_abs h),
    (Rcase_abs (fst a)); lra.
Qed.
Lemma bounded_cell B x0 x1 c e f : In (x0, x1) (adjacent (walls B)) -> In c (slab B x0 x1) ->
  bottom c = Some e -> top c = Some f -> exists M, forall x, in_cell c x -> near M (0, 0) x.
Proof.
  intros A I E F. destruct (slab_cell B x0 x1 A c I) as ((Fr & To) & P & Q & _).
  destruct (P e E) as (_ & Ne & _). destruct (Q f F) as (_ & Nf & _).
  destruct (line_bounded (start e) (finish e) (Q2R x0) (Q2R x1)) as (M1 & K1).
  destruct (line_bounded (start f) (finish f) (Q2R x0) (Q2R x1)) as (M2 & K2).
  exists (1 + Rabs (Q2R x0) + Rabs (Q2R x1) + Rabs M1 + Rabs M2). intros x (X0 & X1 & L & H).
  specialize (X0 x0 Fr). specialize (X1 x1 To). specialize (L e E). specialize (H f F).
  assert (Lo : height_of e (fst x) <= snd x).
  { apply Rnot_lt_le. intros G. apply level_sign in G; auto. lra. }
  assert (Hi : snd x <= height_of f (fst x)).
  { apply Rnot_lt_le. intros G. apply level_sign in G; auto. lra. }
  specialize (K1 (fst x) (conj X0 X1)). specialize (K2 (fst x) (conj X0 X1)).
  fold (height_of e (fst x)) in K1. fold (height_of f (fst x)) in K2.
  pose proof (Rle_abs M1). pose proof (Rle_abs M2). pose proof (Rabs_pos (Q2R x0)).
  pose proof (Rabs_pos (Q2R x1)). pose proof (Rabs_pos M1). pose proof (Rabs_pos M2).
  pose proof (Rle_abs (Q2R x1)). pose proof (Rle_abs (- Q2R x0)) as Neg. rewrite Rabs_Ropp in Neg.
  pose proof (Rle_abs (height_of f (fst x))) as G1.
  pose proof (Rle_abs (- height_of e (fst x))) as G2. rewrite Rabs_Ropp in G2.
  split; apply Rabs_def1; cbn [fst snd]; lra.
Qed.

(** ** A row of cells from the left to the right *)
Section Row.
Variable B : list edge.
Let cells := concat (slabs B).
Variable N : cell -> Prop.
Hypothesis open_ : forall c d x, N c -> N d -> is_below x c d = true.
Hypothesis each : forall x0 x1, In (x0, x1) (adjacent (walls B)) -> exists c, In c (slab B x0 x1) /\
  N c.
Variable A : list cell.
Hypothesis takes : forall c d, In c A -> In d cells -> N d -> linked c d = true -> In d A.

Lemma in_slab x0 x1 c : In (x0, x1) (adjacent (walls B)) -> In c (slab B x0 x1) -> In c cells.
Proof.
  intros I J. unfold cells, slabs. cbn [concat]. rewrite concat_app. apply in_or_app. right.
  apply in_or_app. left. apply in_concat. exists (slab B x0 x1). split; auto.
  apply in_map_iff. exists (x0, x1). auto.
Qed.
Lemma open_linked c d x y : N c -> N d -> to c = Some x -> from d = Some y -> Q2R x = Q2R y ->
  linked c d = true.
Proof.
  intros C D T F E. unfold linked. apply orb_true_iff. left. unfold is_left_of. rewrite T, F.
  rewrite !open_ by auto. apply equal_real in E. rewrite E. reflexivity.
Qed.
Lemma row l : forall w, (forall p q, In (p, q) (adjacent (w :: l)) ->
    In (p, q) (adjacent (walls B))) ->
  (forall c, In c cells -> N c -> from c = Some w -> In c A) ->
  forall v, In v (w :: l) -> forall c, In c cells -> N c -> from c = Some v -> In c A.
Proof.
  induction l as [|u l IH]; intros w Ad H v V c I Nc F.
  - destruct V as [<-|[]]. auto.
  - destruct V as [<-|V]; [auto|]. apply (IH u) with (v := v); auto.
    + intros p q J. apply Ad. right. exact J.
    + clear c I Nc F. intros c I Nc F.
      assert (J : In (w, u) (adjacent (walls B))) by (apply Ad; left; reflexivity).
      destruct (each w u J) as (d & D & Nd). destruct (slab_sides B w u d D) as [Fd Td].
      apply (takes d c); auto; [|apply (open_linked d c u u); auto].
      apply H; auto. apply (in_slab w u d J D).
Qed.
End Row.

Section Holed.
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
Let K := parts B false.

Lemma bottomless_empty c : bottom c = None -> full c = false.
Proof. unfold full. intros ->. reflexivity. Qed.
Lemma topless_empty c : In c cells -> top c = None -> full c = false.
Proof.
  intros I T. destruct (full c) eqn:F; auto. exfalso.
  destruct (cell_centre S B sided low high from_low to_high c I) as (z & Z).
  (* high above the inner point *)
  assert (G : exists h, high < h /\ within_cell c (fst z, h)).
  { exists (Rmax (high + 1) (snd z)). pose proof (Rmax_l (high + 1) (snd z)).
    pose proof (Rmax_r (high + 1) (snd z)). split; [lra|]. destruct Z as (A & D & L & _).
    split; [exact A|split; [exact D|split]].
    - intros e E. specialize (L e E). destruct (cell_edges B c e I (or_introl E)) as (Ne & _).
      apply level_sign in L; auto. apply level_sign; auto. cbn [fst snd]. lra.
    - rewrite T. discriminate. }
  destruct G as (h & H & W).
  pose proof (proj2 (told S B steady_off alike sided low high from_low to_high c _ I W) F) as Sh.
  apply to_high in Sh. cbn [snd] in Sh. lra.
Qed.

Definition outermost : cell :=
  {| from := None; to := hd_error (walls B); bottom := None; top := None |}.
Lemma outermost_first : exists l, filter (fun c => Bool.eqb (full c) false) cells = outermost :: l.
Proof. eexists. unfold cells, slabs. cbn [concat app filter]. reflexivity. Qed.
Lemma outer_class : exists A k, K = A :: k /\ In outermost A.
Proof.
  destruct outermost_first as (l & E). unfold K, parts. fold cells. rewrite E. simpl.
  eexists. eexists. split; [reflexivity|left; reflexivity].
Qed.
Lemma class_takes A c d : In A K -> In c A -> In d cells -> full d = false -> linked c d = true ->
  In d A.
Proof.
  intros HA I J F L.
  destruct (classes_have (filter (fun c => Bool.eqb (full c) false) cells) d) as (C & HC & Jc).
  { apply filter_In. split; auto. rewrite F. reflexivity. }
  destruct (pairs_two _ K A C (fun P Q H c d Hc Hd => conj (eq_trans (linked_back c d)
    (proj1 (H d c Hd Hc))) (disjoint_back _ _ (proj2 (H d c Hd Hc))))
      (classes_disjoint B alike false)
    HA HC) as [E|E].
  - rewrite E. exact Jc.
  - destruct (E c d I Jc) as [L' _]. congruence.
Qed.
Lemma outer_row (N : cell -> Prop) A : (forall c d x, N c -> N d -> is_below x c d = true) ->
  (forall x0 x1, In (x0, x1) (adjacent (walls B)) -> exists c, In c (slab B x0 x1) /\ N c) ->
  (forall c, In c cells -> N c -> full c = false) -> N outermost ->
  In A K -> In outermost A -> forall c, In c cells -> N c -> In c A.
Proof.
  intros Op Ea Em No HA Io c I Nc.
  assert (Tk : forall c d, In c A -> In d cells -> N d -> linked c d = true -> In d A).
  { intros c' d' Hc Hd Nd L. apply (class_takes A c' d'); auto. }
  assert (Sub : forall w l, walls B = w :: l -> forall v, In v (walls B) -> from c = Some v ->
    In c A).
  { intros w l W v V F. apply (row B N Op Ea A Tk l w) with (v := v); auto.
    - intros p q J. rewrite W. exact J.
    - intros d Id Nd Fd. apply (Tk outermost d); auto.
      apply (open_linked N Op outermost d w w); auto. unfold outermost. rewrite W. reflexivity.
    - rewrite <- W. exact V. }
  destruct (walls B) as [|w l] eqn:W.
  - (* one cell, the plane *)
    unfold cells, slabs in I. rewrite W in I. simpl in I. destruct I as [<-|[]].
    unfold outermost in Io. rewrite W in Io. exact Io.
  - unfold cells in I. destruct (cell_where B c I) as [(x0 & x1 & J & Jc)|(Eb & Et & H)].
    + destruct (slab_sides B x0 x1 c Jc) as [F _]. apply (Sub w l eq_refl x0); auto.
      apply adjacent_in in J. rewrite W in J. tauto.
    + destruct H as [[F T]|[F T]].
      * replace c with outermost; auto. unfold outermost. destruct c as [cf ct cb cp].
        cbn [from to bottom top] in *. congruence.
      * rewrite W in F. destruct (rev (w :: l)) as [|v r] eqn:Rv.
        { apply (f_equal (@length Q)) in Rv. rewrite rev_length in Rv. discriminate. }
        apply (Sub w l eq_refl v); auto. apply in_rev. rewrite Rv. left. reflexivity.
Qed.
Lemma stack_ends x0 x1 l : forall below, (exists c r, stack x0 x1 below l = c :: r /\
  bottom c = below) /\ exists c, In c (stack x0 x1 below l) /\ top c = None.
Proof.
  induction l as [|e l IH]; intros below; simpl.
  - split; [eexists; eexists; split; reflexivity|]. eexists. split; [left; reflexivity|reflexivity].
  - split; [eexists; eexists; split; reflexivity|].
    destruct (IH (Some e)) as (_ & c & I & T). exists c. auto.
Qed.
Lemma outer_takes A c : In A K -> In outermost A -> In c cells -> bottom c = None \/ top c = None ->
  In c A.
Proof.
  intros HA Io I [H|H].
  - apply (outer_row (fun c => bottom c = None) A); auto.
    + intros d f x D _. unfold is_below. rewrite D. reflexivity.
    + intros x0 x1 _. destruct (stack_ends x0 x1 (by_height (Qred ((x0 + x1) / 2))
        (filter (spans x0 x1) B)) None) as ((d & r & E & D) & _).
      exists d. split; [|exact D]. unfold slab. rewrite E. left. reflexivity.
    + intros d _ D. apply bottomless_empty, D.
  - apply (outer_row (fun c => top c = None) A); auto.
    + intros d f x _ D. unfold is_below. rewrite D. destruct (bottom d); reflexivity.
    + intros x0 x1 _. destruct (stack_ends x0 x1 (by_height (Qred ((x0 + x1) / 2))
        (filter (spans x0 x1) B)) None) as (_ & d & J & D). exists d. auto.
    + exact topless_empty.
Qed.

Theorem has_holes_of_parts : has_holes S (pred (length (parts B false))).
Proof.
  fold K. destruct outer_class as (A & k & E & Io).
  assert (HA : In A K) by (rewrite E; left; reflexivity).
  exists (fun i => part_of (fun x => ~ S x) (nth i K [])). split.
  - replace (1 + pred (length K))%nat with (length K) by (rewrite E; reflexivity).
    apply (outside_falls S regular B steady_off long alike sided low high from_low to_high).
  - intros i L. replace (1 + pred (length K))%nat with (length K) in L by (rewrite E; reflexivity).
    split.
    + intros (r & Bd) ->. (* far to the left *)
      assert (G : exists x, x < - r /\ forall q, hd_error (walls B) = Some q -> x < Q2R q).
      { destruct (hd_error (walls B)) as [q|].
        - exists (Rmin (- r) (Q2R q) - 1). pose proof (Rmin_l (- r) (Q2R q)).
          pose proof (Rmin_r (- r) (Q2R q)). split; [lra|]. intros p P. injection P; intros <-. lra.
        - exists (- r - 1). split; [lra|discriminate]. }
      destruct G as (x & X & Xq).
      assert (W : within_cell outermost (x, 0)).
      { unfold outermost. split; [|split; [|split]]; cbn [from to bottom top fst]; try discriminate.
        exact Xq. }
      assert (Ic : In outermost cells) by (unfold cells, slabs; simpl; left; reflexivity).
      assert (Nx : ~ S (x, 0)).
      { intros Sx. apply (told S B steady_off alike sided low high from_low to_high outermost) in
          Sx;
          auto. discriminate Sx. }
      destruct (Bd (x, 0)) as [Nr _].
      { split; auto. exists outermost. rewrite E. split; [exact Io|apply within_in, W]. }
      cbn [fst] in Nr. apply Rabs_def2 in Nr. lra.
    + intros Ni. pose proof (nth_In K [] L) as HC. set (C := nth i K []) in *.
      assert (Away : forall c, In c C -> exists e f, bottom c = Some e /\ top c = Some f).
      { intros c Ic. destruct (class_coloured B false C HC c Ic) as [Icell _].
        destruct (bottom c) as [e|] eqn:Eb; [destruct (top c) as [f|] eqn:Et; [eauto|]|]; exfalso.
        - pose proof (outer_takes A c HA Io Icell (or_intror Et)) as J.
          assert (Lt : (0 < i)%nat) by lia.
          destruct (pairs_nth _ K [] (classes_disjoint B alike false) 0 i Lt L c c) as [_ D];
            [rewrite E; exact J|exact Ic|].
          destruct (cell_centre S B sided low high from_low to_high c Icell) as (z & Z).
          exact (D z Z Z).
        - pose proof (outer_takes A c HA Io Icell (or_introl Eb)) as J.
          assert (Lt : (0 < i)%nat) by lia.
          destruct (pairs_nth _ K [] (classes_disjoint B alike false) 0 i Lt L c c) as [_ D];
            [rewrite E; exact J|exact Ic|].
          destruct (cell_centre S B sided low high from_low to_high c Icell) as (z & Z).
          exact (D z Z Z). }
      assert (Bd : exists M, forall c, In c C -> forall x, in_cell c x -> near M (0, 0) x).
      { assert (Sub : forall c, In c C -> In c cells)
          by (intros c Ic; apply (class_coloured B false C HC c Ic)).
        clear - Away Sub. induction C as [|c C IH]; [exists 0; intros c []|].
        destruct IH as (M & HM); [intros d D; apply Away; right; auto|intros d D; apply Sub; right;
          auto|].
        destruct (Away c (or_introl eq_refl)) as (e & f & Eb & Et).
        destruct (cell_where B c (Sub c (or_introl eq_refl))) as [(x0 & x1 & J & Jc)|(Eb' & _)];
          [|congruence].
        destruct (bounded_cell B x0 x1 c e f J Jc Eb Et) as (M' & HM').
        exists (Rmax M M'). pose proof (Rmax_l M M'). pose proof (Rmax_r M M').
        intros d [<-|D] x X; [destruct (HM' x X)|destruct (HM d D x X)]; split; lra. }
      destruct Bd as (M & HM). exists M. intros x (_ & c & Ic & X). exact (HM c Ic x X).
Qed.
End Holed.
