(** Triangles are sets with walls, so there are such sets. *)
From Coq Require Import Lra.
From Proved Require Import Definitions Paper Wedges.
Open Scope R_scope.

Definition triangle (a b c x : point) : Prop :=
  0 <= orient a b x /\ 0 <= orient b c x /\ 0 <= orient c a x.
Lemma orient_cross a b x : orient a b x = cross (diff b a) (diff x a).
Proof. unfold orient, cross, diff; cbn [fst snd]. ring. Qed.
Lemma orient_end a b x : orient a b x = cross (diff b a) (diff x b).
Proof. unfold orient, cross, diff; cbn [fst snd]. ring. Qed.
Lemma orient_near a b x : 0 < orient a b x ->
  exists r, 0 < r /\ forall y, near r x y -> 0 < orient a b y.
Proof.
  rewrite orient_cross. intros O. destruct (side_near _ _ _ O) as (r & R & H).
  exists r. split; [exact R|]. intros y Y. rewrite orient_cross. auto.
Qed.
(** What is on the line of an edge, and not outside of the other two, is on the edge. *)
Lemma on_wall a b c x : 0 < orient a b c -> orient a b x = 0 -> 0 <= orient b c x ->
  0 <= orient c a x -> on_segment a b x.
Proof.
  intros O Z B C. exists (orient c a x / orient a b c).
  assert (Sum : orient b c x + orient c a x = orient a b c).
  { assert (E : orient a b x + orient b c x + orient c a x = orient a b c)
      by (unfold orient; ring). lra. }
  assert (K : orient c a x / orient a b c * orient a b c = orient c a x) by (field; lra).
  split.
  - set (t := orient c a x / orient a b c) in *. split; apply Rmult_le_reg_r with (orient a b c);
      lra.
  - destruct a as [a1 a2], b as [b1 b2], c as [c1 c2], x as [x1 x2].
    unfold orient in *; cbn [fst snd] in *.
    f_equal; apply Rmult_eq_reg_r with ((b1 - a1) * (c2 - a2) - (b2 - a2) * (c1 - a1)); try lra;
      field_simplify; try lra.
    + apply Rminus_diag_uniq.
      transitivity ((c1 - a1) * ((b1 - a1) * (x2 - a2) - (b2 - a2) * (x1 - a1))); [ring|].
      rewrite Z. ring.
    + apply Rminus_diag_uniq.
      transitivity ((c2 - a2) * ((b1 - a1) * (x2 - a2) - (b2 - a2) * (x1 - a1))); [ring|].
      rewrite Z. ring.
Qed.
Lemma left_wall a b c p : 0 < orient a b c -> on_segment a b p -> p <> a -> p <> b ->
  exists r, 0 < r /\ forall y, near r p y -> 0 < cross (diff b a) (diff y p) -> triangle a b c y.
Proof.
  intros O (t & T & ->) Na Nb.
  set (p := (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a))).
  assert (T0 : t <> 0).
  { intros ->. apply Na. destruct a; cbn [fst snd]. f_equal; ring. }
  assert (T1 : t <> 1).
  { intros ->. apply Nb. destruct b; cbn [fst snd]. f_equal; ring. }
  assert (B : 0 < orient b c p).
  { replace (orient b c p) with ((1 - t) * orient a b c) by (unfold p, orient; simpl; ring).
    apply Rmult_lt_0_compat; lra. }
  assert (C : 0 < orient c a p).
  { replace (orient c a p) with (t * orient a b c) by (unfold p, orient; simpl; ring).
    apply Rmult_lt_0_compat; lra. }
  destruct (both_near _ _ p (orient_near b c p B) (orient_near c a p C)) as (r & R & H).
  exists r. split; auto. intros y Y L. destruct (H y Y) as [H1 H2]. unfold triangle.
  assert (E : orient a b y = cross (diff b a) (diff y p))
    by (unfold p, orient, cross, diff; cbn [fst snd]; ring).
  lra.
Qed.
Lemma corner_wall a b c : 0 < orient a b c -> corner (triangle a b c) b (diff b a) (diff c b).
Proof.
  intros O. assert (C : cross (diff b a) (diff c b) = orient a b c)
    by (rewrite orient_end; reflexivity).
  split; [lra|]. destruct (orient_near c a b) as (r & R & H).
  { replace (orient c a b) with (orient a b c) by (unfold orient; ring). exact O. }
  exists r. split; auto. intros y Y W. specialize (H y Y). unfold triangle.
  rewrite (orient_end a b y), (orient_cross b c y). destruct W as [(_ & W1 & W2)|(W & _)]; lra.
Qed.
Lemma turned_triangle a b c x : triangle a b c x <-> triangle b c a x.
Proof. unfold triangle. tauto. Qed.
Lemma corner_same (S T : point -> Prop) p i o : (forall x, S x <-> T x) -> corner S p i o ->
  corner T p i o.
Proof.
  intros E (N & r & R & H). split; auto. exists r. split; auto. intros y Y W. apply E, H; auto.
Qed.

Theorem triangle_is_walled a b c : 0 < orient a b c ->
  walled (triangle a b c) [(a, b); (b, c); (c, a)].
Proof.
  intros O. assert (O2 : 0 < orient b c a) by (replace (orient b c a) with (orient a b c)
    by (unfold orient; ring); exact O).
  assert (O3 : 0 < orient c a b) by (replace (orient c a b) with (orient a b c)
    by (unfold orient; ring); exact O).
  assert (E2 : forall x, triangle b c a x <-> triangle a b c x)
    by (intros x; unfold triangle; tauto).
  assert (E3 : forall x, triangle c a b x <-> triangle a b c x)
    by (intros x; unfold triangle; tauto).
  pose proof (corner_wall a b c O) as Cb.
  pose proof (corner_same _ _ _ _ _ E2 (corner_wall b c a O2)) as Cc.
  pose proof (corner_same _ _ _ _ _ E3 (corner_wall c a b O3)) as Ca.
  assert (D : forall u v w, 0 < orient u v w -> u <> v).
  { intros u v w K ->. unfold orient in K. lra. }
  split; [|split].
  - intros p (A & B & C). destruct (Req_dec (orient a b p) 0) as [Z|Z].
    { right. exists a, b. split; [simpl; auto|]. apply (on_wall a b c); auto. }
    destruct (Req_dec (orient b c p) 0) as [Y|Y].
    { right. exists b, c. split; [simpl; auto|]. apply (on_wall b c a); auto. }
    destruct (Req_dec (orient c a p) 0) as [X|X].
    { right. exists c, a. split; [simpl; auto|]. apply (on_wall c a b); auto. }
    left. destruct (orient_near a b p) as (r & R & H); [lra|].
    destruct (orient_near b c p) as (s & S & K); [lra|].
    destruct (orient_near c a p) as (t & T & L); [lra|].
    destruct (both_near _ _ p (ex_intro _ s (conj S K)) (ex_intro _ t (conj T L))) as (u & U & M).
    destruct (both_near _ _ p (ex_intro _ r (conj R H)) (ex_intro _ u (conj U M))) as (v & V & N).
    exists v. split; auto. intros y Ny. destruct (N y Ny) as (N1 & N2 & N3).
    unfold triangle. lra.
  - intros u v p I S Nu Nv.
    destruct I as [I|[I|[I|[]]]]; injection I; intros; subst.
    + apply (left_wall u v c); auto.
    + destruct (left_wall u v a p O2 S Nu Nv) as (r & R & H). exists r. split; auto.
      intros y Y L. apply E2, H; auto.
    + destruct (left_wall u v b p O3 S Nu Nv) as (r & R & H). exists r. split; auto.
      intros y Y L. apply E3, H; auto.
  - intros u v I. destruct I as [I|[I|[I|[]]]]; injection I; intros; subst;
      (split; [eauto|split]).
    + exists c. split; simpl; auto.
    + exists c. split; simpl; auto.
    + exists a. split; simpl; auto.
    + exists a. split; simpl; auto.
    + exists b. split; simpl; auto.
    + exists b. split; simpl; auto.
Qed.
