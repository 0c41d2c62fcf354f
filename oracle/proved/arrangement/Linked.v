(** What is inside of cells of one colour falls into the classes of these cells. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Fans Curves Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique Beside.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Parted Disjoint Together.
Open Scope R_scope.

Section Linked.
Variable B : list edge.
Hypothesis alike : forall e f x, In e B -> In f B -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Let cells := concat (slabs B).
Hypothesis centre : forall c, In c cells -> exists z, within_cell c z.
Variable U : point -> Prop.
Variable b : bool.
Hypothesis U_open : forall x, U x -> interior U x.
Hypothesis U_told : forall c y, In c cells -> within_cell c y -> (U y <-> full c = b).
Hypothesis U_in : forall x, U x -> exists c, In c cells /\ full c = b /\ in_cell c x.
Hypothesis U_clear : forall x, U x -> ~ over_some B x.
Hypothesis U_wall : forall m r, 0 < r -> (forall y, near r m y -> fst y <> fst m -> U y) -> U m.

(** ** Linked cells are joined through a point of their wall. *)
Definition lows (c : cell) (w : R) : list R :=
  match bottom c with Some e => [height_of e w] | None => [] end.
Definition highs (c : cell) (w : R) : list R :=
  match top c with Some e => [height_of e w] | None => [] end.
Lemma lows_below c d p : In c cells -> In d cells -> is_below p c d = true ->
  forall l h, In l (lows c (Q2R p)) -> In h (highs d (Q2R p)) -> l < h.
Proof.
  intros I J H l h L K. unfold lows in L. unfold highs in K. unfold is_below in H.
  destruct (bottom c) as [e|] eqn:E; [|destruct L]. destruct (top d) as [f|] eqn:F; [|destruct K].
  destruct L as [<-|[]], K as [<-|[]]. apply less_real in H.
  destruct (cell_edges B c e I (or_introl E)) as (Ne & _).
  destruct (cell_edges B d f J (or_intror F)) as (Nf & _).
  rewrite !height_real in H by auto. exact H.
Qed.
Lemma levels_near c w y : In c cells -> (forall l, In l (lows c w) -> l < y) ->
  (forall h, In h (highs c w) -> y < h) -> exists r, 0 < r /\ forall z, near r (w, y) z ->
  (forall e, bottom c = Some e -> 0 < level e z) /\ (forall e, top c = Some e -> level e z < 0).
Proof.
  intros I L H.
  assert (G : exists r, 0 < r /\ forall z, near r (w, y) z ->
    forall e, bottom c = Some e -> 0 < level e z).
  { destruct (bottom c) as [e|] eqn:E; [|exists 1; split; [lra|discriminate]].
    destruct (cell_edges B c e I (or_introl E)) as (Ne & _).
    destruct (near_left (start (from_left e)) (finish (from_left e)) (w, y)) as (r & Hr & K).
    - apply level_sign; auto. cbn [fst snd]. apply L. unfold lows. rewrite E. simpl. auto.
    - exists r. split; auto. intros z Z f F. injection F; intros <-. apply K, Z. }
  assert (G' : exists r, 0 < r /\ forall z, near r (w, y) z ->
    forall e, top c = Some e -> level e z < 0).
  { destruct (top c) as [e|] eqn:E; [|exists 1; split; [lra|discriminate]].
    destruct (cell_edges B c e I (or_intror E)) as (Ne & _).
    destruct (near_right (start (from_left e)) (finish (from_left e)) (w, y)) as (r & Hr & K).
    - apply level_sign; auto. cbn [fst snd]. apply H. unfold highs. rewrite E. simpl. auto.
    - exists r. split; auto. intros z Z f F. injection F; intros <-. apply K, Z. }
  destruct G as (r & R & K), G' as (s & Hs & K'). exists (Rmin r s).
  split; [apply Rmin_glb_lt; auto|]. intros z Z. apply near_min in Z.
    split; [apply K|apply K']; tauto.
Qed.
Lemma side_gap c p : In c cells -> to c = Some p -> exists s, 0 < s /\
  forall q, from c = Some q -> Q2R q <= Q2R p - s.
Proof.
  intros I T. destruct (centre c I) as (z & (A & D & _)). specialize (D p T).
  destruct (from c) as [q|]; [|exists 1; split; [lra|discriminate]]. specialize (A q eq_refl).
  exists (Q2R p - Q2R q). split; [lra|]. intros r E. injection E; intros <-. lra.
Qed.
Lemma side_gap' c p : In c cells -> from c = Some p -> exists s, 0 < s /\
  forall q, to c = Some q -> Q2R p + s <= Q2R q.
Proof.
  intros I T. destruct (centre c I) as (z & (A & D & _)). specialize (A p T).
  destruct (to c) as [q|]; [|exists 1; split; [lra|discriminate]]. specialize (D q eq_refl).
  exists (Q2R q - Q2R p). split; [lra|]. intros r E. injection E; intros <-. lra.
Qed.
Lemma left_passage c d : In c cells -> In d cells -> full c = b -> full d = b ->
  is_left_of c d = true -> exists m, U m /\ in_cell c m /\ in_cell d m.
Proof.
  intros I J Fc Fd H. unfold is_left_of in H. destruct (to c) as [p|] eqn:T; [|discriminate].
  destruct (from d) as [q|] eqn:F; [|discriminate]. rewrite !andb_true_iff in H.
  destruct H as [[[[Q H1] H2] H3] H4]. apply equal_real in Q.
  destruct (between_lists (lows c (Q2R p) ++ lows d (Q2R p)) (highs c (Q2R p) ++ highs d (Q2R p)))
    as (y & L & M).
  { intros l h Il Ih. apply in_app_or in Il. apply in_app_or in Ih. destruct Il as [Il|Il], Ih as
      [Ih|Ih]; [apply (lows_below c c p)|apply (lows_below c d p)|apply (lows_below d c p)|
      apply (lows_below d d p)]; auto. }
  set (m := (Q2R p, y)). exists m.
  destruct (levels_near c (Q2R p) y I) as (r & R & K);
    [intros; apply L, in_or_app; auto|intros; apply M, in_or_app; auto|].
  destruct (levels_near d (Q2R p) y J) as (r' & R' & K');
    [intros; apply L, in_or_app; auto|intros; apply M, in_or_app; auto|].
  destruct (side_gap c p I T) as (s & Hs & S). destruct (side_gap' d q J F) as (s' & Hs' & S').
  split; [|split].
  - apply (U_wall m (Rmin (Rmin r s) (Rmin r' s'))); [repeat apply Rmin_glb_lt; auto|].
    intros z Z N. apply near_min in Z. destruct Z as [Z1 Z2]. apply near_min in Z1.
    apply near_min in Z2. destruct Z1 as [Z1 [Zx _]], Z2 as [Z2 [Zx' _]].
    apply Rabs_def2 in Zx, Zx'. unfold m in Zx, Zx', N; cbn [fst] in Zx, Zx', N.
    destruct (Rlt_dec (fst z) (Q2R p)).
    + apply (U_told c z I); auto. destruct (K z Z1) as [K1 K2]. split; [|split; [|split]]; auto.
      * intros w E. specialize (S w E). lra.
      * intros w E. rewrite T in E. injection E; intros <-. lra.
    + apply (U_told d z J); auto. destruct (K' z Z2) as [K1 K2]. split; [|split; [|split]]; auto.
      * intros w E. rewrite F in E. injection E; intros <-. lra.
      * intros w E. specialize (S' w E). lra.
  - destruct (K m (near_self r m R)) as [K1 K2]. split; [|split; [|split]].
    + intros w E. specialize (S w E). unfold m; cbn [fst]. lra.
    + intros w E. rewrite T in E. injection E; intros <-. unfold m; cbn [fst]. lra.
    + intros e E. specialize (K1 e E). lra.
    + intros e E. specialize (K2 e E). lra.
  - destruct (K' m (near_self r' m R')) as [K1 K2]. split; [|split; [|split]].
    + intros w E. rewrite F in E. injection E; intros <-. unfold m; cbn [fst]. lra.
    + intros w E. specialize (S' w E). unfold m; cbn [fst]. lra.
    + intros e E. specialize (K1 e E). lra.
    + intros e E. specialize (K2 e E). lra.
Qed.
Lemma passage c d : In c cells -> In d cells -> full c = b -> full d = b ->
  linked c d = true -> exists m, U m /\ in_cell c m /\ in_cell d m.
Proof.
  intros I J Fc Fd H. unfold linked in H. apply orb_true_iff in H. destruct H as [H|H].
  - apply left_passage; auto.
  - destruct (left_passage d c J I Fd Fc H) as (m & Um & D & C). eauto.
Qed.

(** ** The part of U that belongs to cells of a list *)
Definition part_of (A : list cell) (x : point) : Prop :=
  U x /\ exists c, In c A /\ in_cell c x.
Definition coloured (A : list cell) : Prop := forall c, In c A -> In c cells /\ full c = b.
Lemma to_inside A c x z : coloured A -> In c A -> U x -> in_cell c x -> within_cell c z ->
  joined (part_of A) x z.
Proof.
  intros Co I Ux X Z. apply joined_step. intros p (t & T & E). change (p = at_ x z t) in E.
  destruct (Req_dec t 0) as [->|N].
  - rewrite E, at_0. split; eauto.
  - assert (W : within_cell c p) by (rewrite E; apply toward_inside; auto; lra).
    destruct (Co c I) as [Ic Fc]. split; [apply (U_told c p Ic W), Fc|].
    exists c. split; auto. apply within_in, W.
Qed.
Lemma chain_joined A c d : coloured A -> In c A -> chained A c d -> forall y z,
  within_cell c y -> within_cell d z -> joined (part_of A) y z.
Proof.
  intros Co I K. induction K as [|d e K IH J L]; intros y z Y Z.
  - destruct (Co c I) as [Ic Fc]. apply (to_inside A c); auto; [apply (U_told c y Ic Y), Fc|].
    apply within_in, Y.
  - assert (D : In d A) by (destruct K; auto). destruct (Co d D) as [Id Fd].
    destruct (Co e J) as [Ie Fe]. destruct (passage d e Id Ie Fd Fe L) as (m & Um & Md & Me).
    destruct (centre d Id) as (w & W). apply joined_join with w; [apply IH; auto|].
    apply joined_join with m; [apply joined_back, (to_inside A d); auto|].
    apply (to_inside A e); auto.
Qed.

(** ** The classes *)
Let K := parts B b.
Lemma class_coloured A : In A K -> coloured A.
Proof.
  intros I c J. apply (classes_from _ A c I) in J. apply filter_In in J. destruct J as [J F].
  split; [exact J|apply eqb_prop, F].
Qed.
Lemma classes_disjoint : ForallOrdPairs (fun A C => forall c d, In c A -> In d C ->
  linked c d = false /\ disjoint c d) K.
Proof.
  apply classes_apart; [exact disjoint_back|]. apply pairs_filter, cells_disjoint, alike.
Qed.
Lemma class_of_two A C c d x : In A K -> In C K -> In c A -> In d C -> U x -> in_cell c x ->
  in_cell d x -> A = C.
Proof.
  intros HA HC I J Ux X Y.
  destruct (pairs_two _ K A C (fun P Q H c d Hc Hd => conj (eq_trans (linked_back c d)
    (proj1 (H d c Hd Hc))) (disjoint_back _ _ (proj2 (H d c Hd Hc)))) classes_disjoint HA HC) as
      [E|E];
    auto.
  exfalso. destruct (E c d I J) as [L D].
  destruct (meeting_cells B centre U U_open U_clear c d x Ux) as [(y & Wc & Wd)|L']; auto.
  - apply (class_coloured A HA c I).
  - apply (class_coloured C HC d J).
  - exact (D y Wc Wd).
  - congruence.
Qed.
Theorem parts_fall : falls_into U (fun i => part_of (nth i K [])) (length K).
Proof.
  assert (At : forall A, In A K -> exists i, (i < length K)%nat /\ nth i K [] = A)
    by (intros A I; apply (In_nth K A [] I)).
  split.
  - intros x. split.
    + intros Ux. destruct (U_in x Ux) as (c & I & F & X).
      destruct (classes_have (filter (fun c => Bool.eqb (full c) b) cells) c) as (A & HA & J).
      { apply filter_In. split; auto. rewrite F. apply eqb_reflx. }
      destruct (At A HA) as (i & L & E). exists i. split; auto. rewrite E. split; eauto.
    + intros (i & _ & (Ux & _)). exact Ux.
  - intros i L. pose proof (nth_In K [] L) as HA. set (A := nth i K []) in *.
    pose proof (class_coloured A HA) as Co. split; [|split; [|split]].
    + destruct (classes_some _ A HA) as (c & I). destruct (Co c I) as [Ic Fc].
      destruct (centre c Ic) as (z & Z). exists z. split; [apply (U_told c z Ic Z), Fc|].
      exists c. split; auto. apply within_in, Z.
    + intros x (Ux & c & I & X). destruct (U_open x Ux) as (r & R & Ball).
      destruct (near_all cells (fun d y => in_cell d y -> in_cell d x) x) as (s & Hs & Far).
      { intros d _. destruct (classic (in_cell d x)) as [D|D]; [exists 1; split; [lra|auto]|].
        apply NNPP. intros N. apply D, in_cell_closed. intros e He. apply NNPP. intros M.
        apply N. exists e. split; auto. intros y Y Dy. destruct M. eauto. }
      exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
      assert (Uy : U y) by (apply Ball; tauto). split; auto.
      destruct (U_in y Uy) as (d & Id & Fd & D).
      destruct (classes_have (filter (fun c => Bool.eqb (full c) b) cells) d) as (C & HC & J).
      { apply filter_In. split; auto. rewrite Fd. apply eqb_reflx. }
      exists d. split; auto. rewrite (class_of_two A C c d x); auto. apply (Far y (proj2 Y) d Id D).
    + intros x y (Ux & c & I & X) (Uy & d & J & Y). destruct (Co c I) as [Ic _].
      destruct (Co d J) as [Id _]. destruct (centre c Ic) as (z & Z).
      destruct (centre d Id) as (w & W). apply joined_join with z; [apply (to_inside A c); auto|].
      apply joined_join with w.
      * apply (chain_joined A c d); auto. exact (classes_chained _ A c d HA I J).
      * apply joined_back, (to_inside A d); auto.
    + intros j x Lj (Ux & c & I & X) (_ & d & J & Y). pose proof (nth_In K [] Lj) as HC.
      pose proof (class_of_two A (nth j K []) c d x HA HC I J Ux X Y) as E.
      destruct (Nat.lt_trichotomy i j) as [Lt|[Eq|Gt]]; auto; exfalso.
      * destruct (pairs_nth _ K [] classes_disjoint i j Lt Lj c c I) as [_ D].
        { rewrite <- E. exact I. }
        destruct (centre c (proj1 (Co c I))) as (z & Z). exact (D z Z Z).
      * destruct (pairs_nth _ K [] classes_disjoint j i Gt L c c) as [_ D].
        { rewrite <- E. exact I. } { exact I. }
        destruct (centre c (proj1 (Co c I))) as (z & Z). exact (D z Z Z).
Qed.
End Linked.
