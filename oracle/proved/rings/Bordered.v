(** A piece with a cell of a class at the point on its left has the class's component on its left.
  *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Along Cuts Lone Flanks Kept Frontier Stacks
  Slabbed Cells Parted Disjoint Together Linked Coloured Traced.
Open Scope R_scope.

Lemma side_not_right a b p : (0 <=? side a b p)%Z = true -> 0 <= orient (R2 a) (R2 b) (R2 p).
Proof.
  unfold side. fold (qturn a b p). rewrite <- qturn_real, Z.leb_le. intros H. apply Rnot_lt_le.
  intros L. pose proof (sg_neg (qturn a b p)) as N.
  destruct (Rlt_dec (Q2R (qturn a b p)) 0); [|contradiction]. apply Z.ltb_lt in N. lia.
Qed.
Lemma side_not_left a b p : (side a b p <=? 0)%Z = true -> orient (R2 a) (R2 b) (R2 p) <= 0.
Proof.
  unfold side. fold (qturn a b p). rewrite <- qturn_real, Z.leb_le. intros H. apply Rnot_lt_le.
  intros L. pose proof (sg_pos (qturn a b p)) as N.
  destruct (Rlt_dec 0 (Q2R (qturn a b p))); [|contradiction]. apply Z.ltb_lt in N. lia.
Qed.
Lemma holds_real c p : holds c p = true -> in_cell c (R2 p).
Proof.
  unfold holds. rewrite !andb_true_iff. intros [[[A D] L] H]. split; [|split; [|split]].
  - intros q E. rewrite E in A. apply le_real in A. exact A.
  - intros q E. rewrite E in D. apply le_real in D. exact D.
  - intros e E. rewrite E in L. exact (side_not_right _ _ _ L).
  - intros e E. rewrite E in H. exact (side_not_left _ _ _ H).
Qed.

Section Bordered.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.
Variable K : list (list cell).
Hypothesis falls : falls_into (interior S) (fun i => part_of (interior S) (nth i K [])) (length K).

Lemma steady_inside x : ~ over_some all x -> S x -> interior S x.
Proof.
  intros N Sx. destruct (constant x N) as (r & R & H). exists r. split; auto.
  intros y Y. apply (H y Y), Sx.
Qed.
Lemma part_steady A x : In A K -> ~ over_some all x -> steady (part_of (interior S) A) x.
Proof.
  intros HA N. destruct (In_nth K A [] HA) as (i & L & Ei).
  destruct falls as [Cover Each]. destruct (Each i L) as (_ & Open & _ & Dis).
  cbv beta in Open, Dis. rewrite Ei in Open.
  destruct (constant x N) as (r & R & H). destruct (classic (S x)) as [Sx|Sx].
  - destruct (classic (part_of (interior S) A x)) as [Px|Px].
    + destruct (Open x Px) as (s & Hs & O). exists s. split; auto. intros y Y.
      pose proof (O y Y). tauto.
    + destruct (proj1 (Cover x) (steady_inside x N Sx)) as (j & Lj & Pj).
      destruct (Each j Lj) as (_ & Open' & _). destruct (Open' x Pj) as (s & Hs & O).
      exists s. split; auto. intros y Y. split; [|contradiction]. intros Py. exfalso.
      assert (E : i = j).
      { apply (Dis j y Lj); [rewrite Ei; exact Py|exact (O y Y)]. }
      subst j. cbv beta in Pj. rewrite Ei in Pj. contradiction.
  - exists r. split; auto. intros y Y. split; intros ((e & He & I) & _); exfalso.
    + apply Sx, (H y Y), I, near_self, He.
    + apply Sx, I, near_self, He.
Qed.
Theorem piece_borders A e x : In A K -> In e B -> bounds all A e = true -> inside e x ->
  exists r, 0 < r /\ forall y, near r x y ->
    (0 < orient (start e) (finish e) y -> part_of (interior S) A y) /\
    (orient (start e) (finish e) y < 0 -> ~ S y).
Proof.
  intros HA I Bo X. unfold bounds in Bo. cbv zeta in Bo.
  apply existsb_exists in Bo. destruct Bo as (c & Ic & Hc).
  apply holds_real in Hc.
  destruct (kept_sided S is_in all all_forward decided constant e x I X) as (s & Hs & Sd).
  assert (Got : exists r, 0 < r /\ forall y, near r x y -> 0 < orient (start e) (finish e) y ->
    part_of (interior S) A y).
  { destruct (kept_from S is_in all all_forward decided e I)
      as (p & Ip & [(-> & Sl & _)|(-> & _ & Sr)]).
    - pose proof (piece_forward all all_forward p Ip) as Fw. apply is_before_real in Fw.
      unfold left_point in Hc. rewrite Fw in Hc.
      destruct (tested_clear all all_forward p Ip) as [Cl _].
      apply (left_all all all_forward p Ip _ (fun z => part_steady A z HA) x); auto.
      split; [apply steady_inside; auto|]. exists c. auto.
    - pose proof (piece_forward all all_forward p Ip) as Fw. unfold forward in Fw.
      assert (Nb : is_before (snd p) (fst p) = false).
      { apply not_true_iff_false. rewrite is_before_real. unfold before in *. lra. }
      unfold left_point in Hc. cbn [fst snd] in Hc. rewrite Nb in Hc.
      unfold turned_back in Hc. cbn [fst snd] in Hc. rewrite <- surjective_pairing in Hc.
      destruct (tested_clear all all_forward p Ip) as [_ Cr].
      assert (X' : inside p x).
      { destruct X as (w & W & E). exists (1 - w). split; [lra|]. rewrite E.
        unfold start, finish; cbn [fst snd]. f_equal; ring. }
      destruct (right_all all all_forward p Ip _ (fun z => part_steady A z HA) x) as (r & R & H);
        auto.
      { split; [apply steady_inside; auto|]. exists c. auto. }
      exists r. split; auto. intros y Y O. apply H; auto.
      change (start (snd p, fst p)) with (finish p) in O.
      change (finish (snd p, fst p)) with (start p) in O. rewrite orient_swap in O. lra. }
  destruct Got as (r & R & H). exists (Rmin r s). split; [apply Rmin_glb_lt; auto|].
  intros y Y. apply near_min in Y. split; [apply H; tauto|apply (Sd y); tauto].
Qed.
(** No kept piece ends inside another. *)
Lemma kept_no_end e f : In e B -> In f B -> ~ inside e (start f) /\ ~ inside e (finish f).
Proof.
  intros I J. destruct (kept_from S is_in all all_forward decided e I) as (p & Ip & Hp).
  destruct (kept_from S is_in all all_forward decided f J) as (q & Iq & Hq).
  destruct (no_cut_inside all all_forward p q Ip Iq) as [N1 N2].
  assert (Turn : forall x, inside e x -> inside p x).
  { intros x. destruct Hp as [(-> & _)|(-> & _)]; auto. unfold inside, start, finish.
    cbn [fst snd]. intros (w & W & E). exists (1 - w). split; [lra|]. rewrite E. f_equal; ring. }
  destruct Hq as [(-> & _)|(-> & _)]; split; intros H; apply Turn in H; auto.
Qed.
End Bordered.
