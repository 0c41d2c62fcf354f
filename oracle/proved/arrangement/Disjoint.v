(** No two cells have an inner point in common; cells that are linked share a piece of a wall. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Paths Decomposed Gaps
  Unique.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Parted.
Open Scope R_scope.

Definition disjoint (c d : cell) : Prop := forall y, within_cell c y -> within_cell d y -> False.
Lemma disjoint_back c d : disjoint c d -> disjoint d c.
Proof. intros H y Y Z. exact (H y Z Y). Qed.

Section Disjoint.
Variable B : list edge.
Hypothesis alike : forall e f x, In e B -> In f B -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.

Section Slab.
Variables x0 x1 : Q.
Hypothesis here : In (x0, x1) (adjacent (walls B)).
Let m := Q2R (Qred ((x0 + x1) / 2)).
Lemma stack_disjoint l : forall below, (forall e, In e l -> over_slab B x0 x1 e) ->
  StronglySorted (fun e f => height_of e m < height_of f m) l ->
  (forall e, below = Some e -> over_slab B x0 x1 e) ->
  (forall e, below = Some e -> forall f, In f l -> height_of e m < height_of f m) ->
  ForallOrdPairs disjoint (stack x0 x1 below l).
Proof.
  induction l as [|e l IH]; intros below Ov St Bl Lt; simpl; [repeat constructor|].
  pose proof (StronglySorted_inv St) as [S1 S2]. rewrite Forall_forall in S2.
  assert (Le : forall f, Some e = Some f -> forall g, In g l -> height_of f m < height_of g m).
  { intros f E. injection E; intros <-. exact S2. }
  constructor.
  - apply Forall_forall. intros d I y Y Z.
    destruct (stack_cell x0 x1 (fun e => height_of e m) l (Some e) S1 Le d I) as
      ((A & D) & P & Q & _ & G).
    destruct Y as (Y0 & Y1 & _ & Y3), Z as (_ & _ & Z2 & _). cbn [from to bottom top] in *.
    specialize (Y0 x0 eq_refl). specialize (Y1 x1 eq_refl). specialize (Y3 e eq_refl).
    pose proof (Ov e (or_introl eq_refl)) as Oe.
    destruct (G e (or_introl eq_refl)) as [(b & Eb & H)|(f & Ef & H)].
    + specialize (Z2 b Eb).
      assert (Ob : over_slab B x0 x1 b).
      { destruct (P b Eb) as [E|E]; [injection E; intros <-; exact Oe|apply Ov; simpl; auto]. }
      pose proof (not_crossing B alike x0 x1 e b m (fst y) Oe Ob (mid_between B x0 x1 here)
        (conj Y0 Y1) H) as L.
      apply level_sign in Y3; [|apply Oe]. apply level_sign in Z2; [|apply Ob]. lra.
    + pose proof (S2 f (Q f Ef)). lra.
  - apply IH; auto.
    + intros f I. apply Ov. simpl. auto.
    + intros f E. injection E; intros <-. apply Ov. simpl. auto.
Qed.
Lemma slab_disjoint : ForallOrdPairs disjoint (slab B x0 x1).
Proof.
  apply stack_disjoint; try discriminate.
  - intros e I. apply (stacked_over B x0 x1 e I).
  - pose proof (by_height_sorted (Qred ((x0 + x1) / 2)) (filter (spans x0 x1) B)) as S.
    assert (O : forall e, In e (by_height (Qred ((x0 + x1) / 2)) (filter (spans x0 x1) B)) ->
      over_slab B x0 x1 e) by (intros e I; apply (stacked_over B x0 x1 e I)).
    induction S as [|e l S IH H]; constructor.
    + apply IH. intros f I. apply O. simpl. auto.
    + rewrite Forall_forall in *. intros f I. specialize (H f I).
      rewrite (heights_mid B x0 x1 e), (heights_mid B x0 x1 f) in H; auto; apply O; simpl; auto.
Qed.
End Slab.

Lemma slab_sides x0 x1 c : In c (slab B x0 x1) -> from c = Some x0 /\ to c = Some x1.
Proof.
  intros I. destruct (stack_cell x0 x1 (fun e => Q2R (height (Qred ((x0 + x1) / 2)) e))
    (by_height (Qred ((x0 + x1) / 2)) (filter (spans x0 x1) B)) None (by_height_sorted _ _)
    ltac:(discriminate) c I) as (A & _). exact A.
Qed.
(** The neighbours of a sorted list, from left to right *)
Lemma adjacent_pairs l : StronglySorted (fun x y => Qle_bool y x = false) l ->
  ForallOrdPairs (fun p q : Q * Q => Q2R (snd p) <= Q2R (fst q)) (adjacent l).
Proof.
  intros S. induction S as [|x l S IH H]; [constructor|].
  destruct l as [|y r]; [constructor|]. change (adjacent (x :: y :: r)) with
    ((x, y) :: adjacent (y :: r)). constructor; [|exact IH].
  apply Forall_forall. intros [p q] I. cbn [fst snd].
  apply adjacent_in in I. destruct I as [[<-|I] _]; [lra|].
  apply StronglySorted_inv in S. destruct S as [_ S]. rewrite Forall_forall in S.
  specialize (S p I). apply not_true_iff_false in S. rewrite le_real in S. lra.
Qed.
Lemma pairs_map {A C} (f : A -> C) (R : C -> C -> Prop) l :
  ForallOrdPairs (fun a b => R (f a) (f b)) l -> ForallOrdPairs R (map f l).
Proof.
  intros F. induction F as [|x l H F IH]; simpl; constructor; auto.
  rewrite Forall_forall in *. intros y I. apply in_map_iff in I. destruct I as (z & <- & I). auto.
Qed.
Lemma pairs_weaken {A} (R S : A -> A -> Prop) l : (forall a b, In a l -> In b l -> R a b ->
  S a b) ->
  ForallOrdPairs R l -> ForallOrdPairs S l.
Proof.
  intros H F. induction F as [|x l K F IH]; constructor.
  - rewrite Forall_forall in *. intros y I. apply H; simpl; auto.
  - apply IH. intros a b I J. apply H; simpl; auto.
Qed.
Lemma wall_sides x y p q : hd_error (walls B) = Some x -> hd_error (rev (walls B)) = Some y ->
  In (p, q) (adjacent (walls B)) -> Q2R x <= Q2R p /\ Q2R q <= Q2R y.
Proof.
  intros X Y I. apply adjacent_in in I. destruct I as [P Q]. pose proof (walls_sorted B) as S.
  split.
  - destruct (first_least _ _ x p S X P) as [->|E]; [lra|].
    apply not_true_iff_false in E. rewrite le_real in E. lra.
  - destruct (last_greatest _ _ y q S Y Q) as [->|E]; [lra|].
    apply not_true_iff_false in E. rewrite le_real in E. lra.
Qed.
Theorem cells_disjoint : ForallOrdPairs disjoint (concat (slabs B)).
Proof.
  unfold slabs. cbn [concat].
  assert (Ends : forall x, hd_error (walls B) = Some x -> exists y,
    hd_error (rev (walls B)) = Some y /\ Q2R x <= Q2R y).
  { intros x E. assert (Ix : In x (walls B)) by (destruct (walls B); [discriminate|];
      injection E; intros ->; simpl; auto).
    destruct (rev (walls B)) as [|y r] eqn:Rv.
    - apply in_rev in Ix. rewrite Rv in Ix. destruct Ix.
    - exists y. split; auto. pose proof (walls_sorted B) as S.
      destruct (last_greatest _ _ y x S) as [->|L]; auto; [rewrite Rv; reflexivity|lra|].
      apply not_true_iff_false in L. rewrite le_real in L. lra. }
  assert (None_in : hd_error (walls B) = None -> walls B = [])
    by (destruct (walls B); [reflexivity|discriminate]).
  apply pairs_join; [repeat constructor| |].
  - rewrite concat_app. apply pairs_join.
    + apply pairs_concat.
      * intros l I. apply in_map_iff in I. destruct I as ([p q] & <- & I). apply slab_disjoint, I.
      * apply pairs_map.
        apply (pairs_weaken (fun p q : Q * Q => Q2R (snd p) <= Q2R (fst q)));
          [|apply adjacent_pairs, walls_sorted].
        intros p q _ _ L c d C D y Y Z. destruct (slab_sides _ _ _ C) as [_ T].
        destruct (slab_sides _ _ _ D) as [F _]. apply Y in T. apply Z in F. lra.
    + destruct (hd_error (rev (walls B))); repeat constructor.
    + intros c d C D y Y Z. destruct (hd_error (rev (walls B))) as [w|] eqn:W; [|destruct D].
      destruct D as [<-|[]]. apply in_concat in C. destruct C as (l & L & C).
      apply in_map_iff in L. destruct L as ([p q] & <- & L).
      destruct (slab_sides _ _ _ C) as [_ T]. apply Y in T.
      pose proof (proj1 Z w eq_refl) as F. cbn [fst snd] in *.
      destruct (hd_error (walls B)) as [x|] eqn:X.
      * destruct (wall_sides x w p q X W L). lra.
      * rewrite (None_in eq_refl) in L. destruct L.
  - intros c d [<-|[]] D y Y Z. destruct Y as (_ & Y & _). cbn [to] in Y.
    rewrite concat_app in D. apply in_app_or in D. destruct D as [D|D].
    + apply in_concat in D. destruct D as (l & L & D). apply in_map_iff in L.
      destruct L as ([p q] & <- & L). destruct (slab_sides _ _ _ D) as [F _]. apply Z in F.
      destruct (hd_error (walls B)) as [x|] eqn:X.
      * destruct (Ends x eq_refl) as (w & W & _). destruct (wall_sides x w p q X W L).
        specialize (Y x eq_refl). cbn [fst snd] in *. lra.
      * rewrite (None_in eq_refl) in L. destruct L.
    + destruct (hd_error (rev (walls B))) as [w|] eqn:W; [|destruct D].
      destruct D as [<-|[]]. pose proof (proj1 Z w eq_refl) as F.
      destruct (hd_error (walls B)) as [x|] eqn:X.
      * destruct (Ends x eq_refl) as (w' & W' & L). injection W'; intros ->.
        specialize (Y x eq_refl). lra.
      * rewrite (None_in eq_refl) in W. discriminate.
Qed.
End Disjoint.
