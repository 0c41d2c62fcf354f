(** From a point near v that is not in a component to one that is, counter-clockwise around v, some
    piece with the component on its left leaves v in between. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique Beside Leaving.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier
  Slabbed Cells.
Open Scope R_scope.

(** What does not begin on a way that it is not on at the start of, is nowhere on it. *)
Lemma all_onward (H : point -> Prop) y z : H y ->
  (forall t, 0 <= t <= 1 -> exists d, 0 < d /\
    ((forall u, Rabs (u - t) < d -> (H (at_ y z u) <-> H (at_ y z t))) \/
     (forall u, t <= u < t + d -> H (at_ y z u)))) -> H z.
Proof.
  intros Hy L. set (E := fun t => 0 <= t <= 1 /\ forall u, 0 <= u <= t -> H (at_ y z u)).
  assert (E0 : E 0) by (split; [lra|]; intros u U; replace u with 0 by lra; rewrite at_0; exact Hy).
  destruct (completeness E) as (m & Up & Least);
    [exists 1; intros t [T _]; lra|exists 0; exact E0|].
  assert (M0 : 0 <= m) by (apply Up, E0).
  assert (M1 : m <= 1) by (apply Least; intros t [T _]; lra).
  destruct (L m (conj M0 M1)) as (d & Hd & K).
  assert (B : exists t, E t /\ m - d < t).
  { apply NNPP. intros B. assert (m <= m - d); [|lra]. apply Least. intros t T.
    destruct (Rle_dec t (m - d)); auto. exfalso. apply B. exists t. split; auto. lra. }
  destruct B as (t & [T Ht] & Lt). assert (tm : t <= m) by (apply Up; split; auto).
  assert (F : forall u, 0 <= u < m + d -> H (at_ y z u)).
  { intros u U. destruct (Rle_dec u t) as [C|C]; [apply Ht; lra|]. destruct K as [K|K].
    - assert (Hm : H (at_ y z m)).
      { apply (K t); [apply Rabs_def1; lra|]. apply Ht. lra. }
      apply (K u); auto. apply Rabs_def1; lra.
    - destruct (Rlt_dec u m) as [V|V]; [|apply K; lra].
      assert (B : exists w, E w /\ u < w).
      { apply NNPP. intros B. assert (m <= u); [|lra]. apply Least. intros w W.
        destruct (Rle_dec w u); auto. exfalso. apply B. exists w. split; auto. lra. }
      destruct B as (w & [_ Hw] & Lw). apply Hw. lra. }
  destruct (Rle_dec 1 m) as [G|G]; [rewrite <- (at_1 y z); apply F; lra|].
  exfalso. set (s := Rmin 1 (m + d / 2)).
  assert (S : m < s /\ s <= 1 /\ s < m + d) by (unfold s; pose proof (Rmin_l 1 (m + d / 2));
    pose proof (Rmin_r 1 (m + d / 2)); split; [apply Rmin_glb_lt; lra|lra]).
  assert (G' : E s). { split; [lra|]. intros u U. apply F; lra. }
  apply Up in G'. lra.
Qed.

Section Turns.
Variable C : point -> Prop.
Hypothesis C_open : forall x, C x -> interior C x.
(* the pieces with C on their left, and where others end *)
Variable E : list edge.
Variable few : list point.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis sided : forall e x, In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Hypothesis steady_off : forall x, ~ over_some E x -> ~ In x few -> steady C x.
Variable v : point.
Hypothesis v_end : forall e, In e E -> ~ inside e v.

(** So near v that what is there is on pieces that begin or end at v *)
Definition close (r : R) : Prop := 0 < r /\ forall x, near r v x -> x <> v -> ~ In x few /\
  forall e, In e E -> lies_on e x -> inside e x /\ (start e = v \/ finish e = v).
Lemma point_far (p : point) : exists r, 0 < r /\ forall x, near r v x -> x <> v -> x <> p.
Proof.
  destruct (classic (p = v)) as [->|N]; [exists 1; split; [lra|auto]|].
  destruct (segment_near p p v) as (r & R & K).
  { intros (t & _ & Q). apply N. rewrite Q. destruct p; cbn [fst snd]; f_equal; ring. }
  exists r. split; auto. intros x X _ ->. apply (K p X), on_segment_start.
Qed.
Lemma some_close : exists r, close r.
Proof.
  assert (F : exists r, 0 < r /\ forall x, near r v x -> x <> v -> ~ In x few).
  { clear. induction few as [|p l (r & R & K)]; [exists 1; split; [lra|]; intros x _ _ []|].
    destruct (point_far p) as (s & Hs & L). exists (Rmin r s). split; [apply Rmin_glb_lt; auto|].
    intros x X N. apply near_min in X. intros [->|I]; [apply (L x); tauto|apply (K x); tauto]. }
  assert (G : exists r, 0 < r /\ forall x, near r v x -> x <> v -> forall e, In e E ->
    lies_on e x -> inside e x /\ (start e = v \/ finish e = v)).
  { assert (Sub : forall l, (forall e, In e l -> In e E) -> exists r, 0 < r /\ forall x,
      near r v x -> x <> v -> forall e, In e l -> lies_on e x ->
      inside e x /\ (start e = v \/ finish e = v)).
    { clear F. induction l as [|e l IH]; intros Sb; [exists 1; split; [lra|]; intros x _ _ e []|].
      destruct IH as (r & R & K); [intros; apply Sb; simpl; auto|].
      assert (Ie : In e E) by (apply Sb; simpl; auto).
      assert (H : exists s, 0 < s /\ forall x, near s v x -> x <> v -> lies_on e x ->
        inside e x /\ (start e = v \/ finish e = v)).
      { destruct (classic (lies_on e v)) as [O|O].
        - assert (En : start e = v \/ finish e = v).
          { destruct (classic (start e = v)); auto. right. apply NNPP. intros N.
            apply (v_end e Ie), inner_of_segment; auto. }
          destruct (point_far (start e)) as (s & Hs & L), (point_far (finish e)) as (t & Ht & M).
          exists (Rmin s t). split; [apply Rmin_glb_lt; auto|]. intros x X N Ox.
          apply near_min in X. split; auto. apply inner_of_segment; auto; intros Q;
            [apply (L x)|apply (M x)]; tauto.
        - destruct (segment_near (start e) (finish e) v O) as (s & Hs & L). exists s. split; auto.
          intros x X _ Ox. destruct (L x X Ox). }
      destruct H as (s & Hs & L). exists (Rmin r s). split; [apply Rmin_glb_lt; auto|].
      intros x X N f I Of. apply near_min in X. destruct I as [<-|I]; [apply L; tauto|].
      apply (K x); tauto. }
    apply Sub. auto. }
  destruct F as (r & R & F), G as (s & Hs & G). exists (Rmin r s).
  split; [apply Rmin_glb_lt; auto|]. intros x X N. apply near_min in X.
  split; [apply F; tauto|]. intros e I O. apply (G x); tauto.
Qed.

Lemma turns_out e x : In e E -> inside e x -> ~ C x.
Proof.
  intros I X Cx. destruct (sided e x I X) as (r & R & K). destruct (C_open x Cx) as (s & Hs & L).
  destruct (right_close (start e) (finish e) x (Rmin r s)) as (z & Z & O); auto.
  { apply inner_on_line, X. } { apply Rmin_glb_lt; auto. }
  apply near_min in Z. apply (proj2 (K z (proj1 Z)) O), L. tauto.
Qed.

(** Less than half a turn *)
Theorem met_turning r y z : close r -> near r v y -> near r v z -> 0 < orient v y z ->
  ~ over_some E y -> ~ over_some E z -> ~ C y -> C z ->
  exists e, In e E /\ start e = v /\ 0 < orient v y (finish e) /\ 0 < orient v (finish e) z.
Proof.
  intros (R & Close) Y Z T Ny Nz Cy Cz. apply NNPP. intros None.
  assert (H : ~ C z); [|contradiction]. apply (all_onward (fun p => ~ C p) y z); auto.
  intros t Ht. set (p := at_ y z t).
  assert (Np : near r v p) by (apply (near_between r v y z); auto; apply at_on; auto).
  assert (Vy : orient v y p = t * orient v y z) by (unfold p, orient, at_; cbn [fst snd]; ring).
  assert (Vz : orient v p z = (1 - t) * orient v y z)
    by (unfold p, orient, at_; cbn [fst snd]; ring).
  assert (Pv : p <> v).
  { intros Q. rewrite Q in Vy, Vz. unfold orient in Vy, Vz, T. nra. }
  destruct (Close p Np Pv) as (Few & Ends).
  destruct (classic (over_some E p)) as [(e & Ie & Oe)|Off].
  2: { destruct (steady_off p Off Few) as (s & Hs & K).
    destruct (at_near y z t s Hs) as (d & D & N).
    exists d. split; auto. left. intros u U. specialize (K _ (N u U)). fold p. tauto. }
  destruct (Ends e Ie Oe) as (Ins & St). destruct (sided e p Ie Ins) as (s & Hs & K).
  destruct (at_near y z t s Hs) as (d & D & N).
  assert (T01 : 0 < t < 1).
  { split; apply Rnot_le_lt; intros L.
    - apply Ny. exists e. split; auto. replace y with p; auto. unfold p.
      replace t with 0 by lra. apply at_0.
    - apply Nz. exists e. split; auto. replace z with p; auto. unfold p.
      replace t with 1 by lra. apply at_1. }
  destruct Ins as (w & W & Ep). change (p = at_ (start e) (finish e) w) in Ep.
  destruct St as [St|St].
  - exfalso. apply None. exists e. split; auto. split; auto.
    assert (Q1 : orient v y p = w * orient v y (finish e)).
    { rewrite Ep, St. unfold orient, at_; cbn [fst snd]; ring. }
    assert (Q2 : orient v p z = w * orient v (finish e) z).
    { rewrite Ep, St. unfold orient, at_; cbn [fst snd]; ring. }
    rewrite Vy in Q1. rewrite Vz in Q2. split; nra.
  - exists d. split; auto. right. intros u U. destruct (Req_dec u t) as [->|Ne].
    + apply (turns_out e p Ie). exists w. split; auto.
    + apply (K (at_ y z u)); [apply N, Rabs_def1; lra|]. fold p in Vy.
      assert (Q : (1 - w) * orient (start e) (finish e) (at_ y z u) = - (u - t) * orient v y z).
      { assert (P1 : forall x, (1 - w) * orient (start e) (finish e) x = - orient v p x).
        { intros x. rewrite Ep, St. unfold orient, at_; cbn [fst snd].
          rewrite <- St. ring. }
        rewrite P1. unfold p, orient, at_; cbn [fst snd]; ring. }
      nra.
Qed.
End Turns.
