(** Each ring that is traced around a class passes the program's tests of a ring. *)
From Coq Require Import Lra Lia Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique Rounds Next.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Kept Frontier Linked
  Coloured Traced Rows Sooner Permuted Cycles Passing Bounding Outlined Straight.
Open Scope R_scope.

Section Closed.
Variable E : list edge.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis apart : ForallOrdPairs no_common E.
Hypothesis nexts : forall a b, In a E -> next_piece E a = Some b -> In b E /\ finish a = start b.

(** What comes next does not turn back. *)
Lemma next_follows a b : In a E -> next_piece E a = Some b -> follows a b.
Proof.
  intros Ia N. destruct (nexts a b Ia N) as [Ib V]. split; auto. intros Z.
  assert (Na : way_of a <> (0, 0)).
  { intros Q. apply (long a Ia). symmetry. apply difference_zero, Q. }
  assert (Nb : way_of b <> (0, 0)).
  { intros Q. apply (long b Ib). symmetry. apply difference_zero, Q. }
  destruct (parallel (way_of a) (way_of b) Na Z) as (m & Q & _).
  destruct (Rtotal_order m 0) as [M|[M|M]].
  - exfalso. apply (long a Ia). assert (Eq : a = b); [|rewrite V, Eq; auto].
    set (t := Rmin 1 (- m) / 2). assert (T : 0 < t <= 1 / 2 /\ t < - m).
    { unfold t. pose proof (Rmin_l 1 (- m)). pose proof (Rmin_r 1 (- m)).
      assert (0 < Rmin 1 (- m)) by (apply Rmin_glb_lt; lra). lra. }
    assert (K : t / - m * - m = t) by (field; lra).
    assert (P : 0 < t / - m < 1).
    { split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_lt_reg_r (- m)); lra. }
    apply (apart_equal E apart a b (at_ (finish a) (start a) t) Ia Ib).
    + exists (1 - t). split; [lra|]. unfold at_; cbn [fst snd]. f_equal; ring.
    + exists (t / - m). split; [exact P|]. rewrite <- V. apply along_both; [lra|].
      rewrite V at 1. change (way_of b = scale (- m) (minus_ (start a) (finish a))). rewrite Q.
      unfold way_of, scale, minus_; cbn [fst snd]. f_equal; ring.
  - exfalso. apply Nb. rewrite Q, M. unfold scale. f_equal; ring.
  - rewrite Q. pose proof (edge_long (0, 0) (way_of a) (not_eq_sym Na)) as L. cbv zeta in L.
    cbn [fst snd] in L. unfold along, scale; cbn [fst snd].
    replace (_ + _) with (m * ((fst (way_of a) - 0) * (fst (way_of a) - 0) +
      (snd (way_of a) - 0) * (snd (way_of a) - 0))) by ring. apply Rmult_lt_0_compat; auto.
Qed.

(** ** Turned rings *)
Definition after (a b : edge) : Prop := next_piece E a = Some b.
Definition goes_round (l : list edge) : Prop :=
  linked after l /\ (l <> [] -> after (last l nothing) (hd nothing l)).
Lemma linked_more l a b : linked after (l ++ [a]) -> after a b -> linked after (l ++ [a; b]).
Proof.
  induction l as [|c [|d l] IH]; intros L N.
  - split; [exact N|exact I].
  - split; [apply L|]. split; [exact N|exact I].
  - split; [apply L|]. apply IH; auto. apply L.
Qed.
Lemma last_app (l : list edge) a : last (l ++ [a]) nothing = a.
Proof. apply last_last. Qed.
Lemma turned_once e r : goes_round (e :: r) -> goes_round (r ++ [e]).
Proof.
  intros [L C]. specialize (C ltac:(discriminate)). cbn [hd] in C.
  destruct r as [|f r]; [split; [exact I|]; intros _; exact C|].
  destruct L as [L1 L2]. destruct (@exists_last _ (f :: r)) as (k & z & Q); [discriminate|].
  split.
  - rewrite Q, <- app_assoc. apply linked_more; [rewrite <- Q; exact L2|].
    change (last (e :: f :: r) nothing) with (last (f :: r) nothing) in C.
    rewrite Q, last_app in C. exact C.
  - intros _. rewrite last_app. exact L1.
Qed.
Lemma turned_round n v : forall l, goes_round l -> goes_round (turn_to n v l).
Proof.
  induction n as [|n IH]; intros [|e r] G; simpl; auto. destruct (same (fst e) v); auto.
  apply IH, turned_once, G.
Qed.
Lemma run_round e l z : run E e l z -> linked after l /\ hd nothing l = e /\ last l nothing = z.
Proof.
  induction 1 as [e|e f l z N R (L & H & La)]; [repeat split|].
  destruct l as [|g l]; [inversion R|]. cbn [hd] in H. subst g.
  split; [split; [exact N|exact L]|]. split; auto.
Qed.

Section Ring.
Variable l : list edge.
Hypothesis cycle : is_cycle E l.
Hypothesis inE : forall e, In e l -> In e E.
Hypothesis ends_once : forall a b, In a l -> In b l -> finish a = finish b -> a = b.

Lemma comes_from a : In a l -> exists b, In b l /\ next_piece E b = Some a.
Proof.
  intros I. destruct cycle as (e & z & R & Z & _).
  destruct (run_before E _ _ _ R a I) as [->|G]; auto. exists z. split; auto.
  exact (run_last E _ _ _ R).
Qed.
Lemma starts_differ a b : In a l -> In b l -> start a = start b -> a = b.
Proof.
  intros I J Q. destruct (comes_from a I) as (c & Ic & Nc). destruct (comes_from b J) as
    (d & Id & Nd). assert (X : c = d).
  { apply ends_once; auto. rewrite (proj2 (nexts c a (inE c Ic) Nc)).
    rewrite (proj2 (nexts d b (inE d Id) Nd)). exact Q. }
  subst d. congruence.
Qed.
Theorem ring_passes : is_closed_ring (in_rows (from_least l)) = true /\
  begins_least (in_rows (from_least l)) = true.
Proof.
  assert (D : NoDup l) by (destruct cycle as (_ & _ & _ & _ & D); exact D).
  assert (Ne : l <> []).
  { destruct cycle as (e & z & R & _). intros Q. pose proof (run_first E _ _ _ R) as F.
    rewrite Q in F. destruct F. }
  split; [|exact (begins_least_holds l D Ne starts_differ)].
  pose proof (from_least_members l) as P.
  assert (In_l : forall e, In e (from_least l) -> In e l)
    by (intros e; apply (Permutation_in _ P)).
  assert (G : goes_round (from_least l)).
  { destruct cycle as (e & z & R & Z & _). destruct (run_round e l z R) as (L & H & La).
    destruct l as [|f r]; [destruct (Ne eq_refl)|]. apply turned_round. split; auto.
    intros _. rewrite H, La. exact Z. }
  destruct (from_least_head l Ne) as (f & r & Q & Low).
  assert (Li : forall k, (forall e, In e k -> In e l) -> linked after k -> linked follows k).
  { induction k as [|a [|b k] IH]; intros Sub L; auto.
    split; [apply next_follows; [apply inE, Sub; simpl; auto|apply L]|].
    apply IH; [intros; apply Sub; simpl; auto|apply L]. }
  assert (If : In f l) by (apply In_l; rewrite Q; simpl; auto).
  assert (Tu : turns (last (from_least l) nothing) (hd nothing (from_least l))).
  { assert (Nl : from_least l <> []) by (rewrite Q; discriminate).
    pose proof (proj2 G Nl) as Nz.
    assert (Iz : In (last (from_least l) nothing) l) by (apply In_l, last_in, Nl).
    set (z := last (from_least l) nothing) in *. rewrite Q in *. cbn [hd] in *.
    destruct (nexts z f (inE z Iz) Nz) as [_ V]. split; auto. intros Zero.
    destruct (next_follows z f (inE z Iz) Nz) as [_ Al]. specialize (Al Zero).
    (* the piece after f begins where f ends *)
    assert (Nf : exists g, In g l /\ finish f = start g).
    { destruct cycle as (e & y & R & Y & _).
      destruct (run_split E e l y f R If) as [->|(l1 & l2 & g & -> & _ & Ng & R2)].
      - exists e. split; [exact (run_first E _ _ _ R)|]. apply (nexts y e (inE y If) Y).
      - exists g. split; [apply in_or_app; right; exact (run_first E _ _ _ R2)|].
        apply (nexts f g (inE f If) Ng). }
    destruct Nf as (g & Ig & Vg). pose proof (Low g Ig) as B1. pose proof (Low z Iz) as B2.
    rewrite <- Vg in B1. rewrite <- V in B1, B2.
    unfold along, turn_of, way_of, minus_, before in *. cbn [fst snd] in *.
    rewrite <- V in *. clear - B1 B2 Zero Al.
    destruct (start z) as [a1 a2], (finish z) as [b1 b2], (finish f) as [c1 c2].
    cbn [fst snd] in *.
    destruct (Rtotal_order a1 b1) as [X|[X|X]]; [apply B2; auto| |].
    - subst b1. destruct (Rtotal_order a2 b2) as [Y|[Y|Y]]; [apply B2; auto|subst; lra|].
      assert (W : (b2 - a2) * (c1 - a1) = 0) by lra. apply Rmult_integral in W.
      apply B1. right. split; [lra|]. apply Rnot_le_lt. intros Le.
      assert (0 <= (a2 - b2) * (c2 - b2)) by (apply Rmult_le_pos; lra). lra.
    - destruct (Rtotal_order c1 b1) as [Y|[Y|Y]]; [apply B1; auto| |].
      + assert (W : (b1 - a1) * (c2 - b2) = 0) by (rewrite Y in Zero; lra).
        apply Rmult_integral in W. assert (W' : c2 - b2 = 0) by lra.
        rewrite Y, W' in Al. lra.
      + assert (W : (b1 - a1) * (c2 - b2) = (b2 - a2) * (c1 - b1)) by lra.
        assert (K : (b1 - a1) * ((b1 - a1) * (c1 - b1) + (b2 - a2) * (c2 - b2)) =
          (c1 - b1) * ((b1 - a1) * (b1 - a1) + (b2 - a2) * (b2 - a2))).
        { transitivity ((b1 - a1) * (b1 - a1) * (c1 - b1) + (b2 - a2) *
            ((b1 - a1) * (c2 - b2))); [ring|]. rewrite W. ring. }
        assert (0 <= (c1 - b1) * ((b1 - a1) * (b1 - a1) + (b2 - a2) * (b2 - a2))).
        { apply Rmult_le_pos; [lra|]. apply Rplus_le_le_0_compat; apply Rle_0_sqr. }
        assert (0 < (a1 - b1) * ((b1 - a1) * (c1 - b1) + (b2 - a2) * (c2 - b2)))
          by (apply Rmult_lt_0_compat; lra). lra. }
  destruct (rows_of_ring (from_least l)) as [St Be]; auto.
  { apply Li; auto. apply G. }
  unfold is_closed_ring. rewrite St, Be, (passed_once_holds l D ends_once).
  destruct (in_rows_pieces (from_least l)) as [Sum _].
  destruct (in_rows (from_least l)); [rewrite Q in Sum; discriminate Sum|reflexivity].
Qed.
End Ring.
End Closed.
