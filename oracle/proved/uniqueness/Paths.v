(** What is constant near every point of a way is constant along it; ways as closed rings; edges
  cut in two. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Across Overlaps.
Open Scope R_scope.

Definition at_ (y z : point) (t : R) : point :=
  (fst y + t * (fst z - fst y), snd y + t * (snd z - snd y)).
Lemma at_0 y z : at_ y z 0 = y.
Proof. unfold at_. destruct y; simpl; f_equal; ring. Qed.
Lemma at_1 y z : at_ y z 1 = z.
Proof. unfold at_. destruct y, z; simpl; f_equal; ring. Qed.
Lemma at_on y z t : 0 <= t <= 1 -> on_segment y z (at_ y z t).
Proof. intros T. exists t. split; auto. Qed.
Lemma at_near y z t e : 0 < e -> exists d, 0 < d /\ forall u, Rabs (u - t) < d ->
  near e (at_ y z t) (at_ y z u).
Proof.
  intros E. set (k := 1 + Rabs (fst z - fst y) + Rabs (snd z - snd y)).
  pose proof (Rabs_pos (fst z - fst y)) as A. pose proof (Rabs_pos (snd z - snd y)) as B.
  assert (K : 0 < k) by (unfold k; lra).
  exists (e / k). split; [apply Rdiv_lt_0_compat; auto|]. intros u U.
  assert (M : Rabs (u - t) * k < e).
  { apply Rmult_lt_reg_r with (/ k); [apply Rinv_0_lt_compat; auto|].
    rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in U. lra. }
  pose proof (Rabs_pos (u - t)).
  unfold near, at_; cbn [fst snd]. split.
  - replace (fst y + u * (fst z - fst y) - (fst y + t * (fst z - fst y)))
      with ((u - t) * (fst z - fst y)) by ring. rewrite Rabs_mult. unfold k in M. nra.
  - replace (snd y + u * (snd z - snd y) - (snd y + t * (snd z - snd y)))
      with ((u - t) * (snd z - snd y)) by ring. rewrite Rabs_mult. unfold k in M. nra.
Qed.

(** What holds at the start of a way, and near each of its points nowhere or everywhere, holds at
  its end. *)
Lemma all_along (H : point -> Prop) y z : H y ->
  (forall p, on_segment y z p -> exists e, 0 < e /\ forall q, near e p q -> (H q <-> H p)) -> H z.
Proof.
  intros Hy L. set (E := fun t => 0 <= t <= 1 /\ forall u, 0 <= u <= t -> H (at_ y z u)).
  assert (E0 : E 0) by (split; [lra|]; intros u U; replace u with 0 by lra; rewrite at_0; exact Hy).
  destruct (completeness E) as (m & Up & Least); [exists 1; intros t [T _]; lra|exists 0; exact
    E0|].
  assert (M0 : 0 <= m) by (apply Up, E0).
  assert (M1 : m <= 1) by (apply Least; intros t [T _]; lra).
  destruct (L (at_ y z m) (at_on y z m (conj M0 M1))) as (e & He & K).
  destruct (at_near y z m e He) as (d & Hd & N).
  assert (B : exists t, E t /\ m - d < t).
  { apply NNPP. intros B. assert (m <= m - d); [|lra]. apply Least. intros t T.
    destruct (Rle_dec t (m - d)); auto. exfalso. apply B. exists t. split; auto. lra. }
  destruct B as (t & [T Ht] & Lt). assert (tm : t <= m) by (apply Up; split; auto).
  assert (Hm : H (at_ y z m)).
  { apply (K (at_ y z t)); [apply N, Rabs_def1; lra|]. apply Ht. lra. }
  assert (F : forall u, Rabs (u - m) < d -> H (at_ y z u)) by (intros u U; apply (K _ (N u U)), Hm).
  destruct (Req_dec m 1) as [->|Ne]; [rewrite <- (at_1 y z); exact Hm|].
  exfalso. set (s := Rmin 1 (m + d / 2)).
  assert (S : m < s /\ s <= 1 /\ s < m + d) by (unfold s; pose proof (Rmin_l 1 (m + d / 2));
    pose proof (Rmin_r 1 (m + d / 2)); split; [apply Rmin_glb_lt; lra|lra]).
  assert (G : E s). { split; [lra|]. intros u U. destruct (Rle_dec u t) as [C|C]; [apply Ht; lra|].
    apply F, Rabs_def1; lra. }
  apply Up in G. lra.
Qed.
Lemma all_joined (S H : point -> Prop) x y : joined S x y -> H x ->
  (forall p, S p -> exists e, 0 < e /\ forall q, near e p q -> (H q <-> H p)) -> H y.
Proof. intros J Hx L. induction J as [|y z J IH K]; auto. apply (all_along H y z); auto. Qed.

Lemma constant_on_segment (f : point -> Z) y z :
  (forall p, on_segment y z p -> exists e, 0 < e /\ forall q, near e p q -> f q = f p) -> f y = f z.
Proof.
  intros L. symmetry. apply (all_along (fun q => f q = f y) y z eq_refl).
  intros p O. destruct (L p O) as (e & E & N). exists e. split; auto. intros q Q.
  rewrite (N q Q). tauto.
Qed.

Lemma joined_constant (S : point -> Prop) (f : point -> Z) x y : joined S x y ->
  (forall p, S p -> exists e, 0 < e /\ forall q, near e p q -> f q = f p) -> f x = f y.
Proof.
  intros J H. induction J as [|y z J IH K]; auto. rewrite IH. apply constant_on_segment. auto.
Qed.

(** A way as edges that close up with one from its end to its start *)
Lemma joined_edges (S : point -> Prop) x y : joined S x y -> exists E,
  (forall a b p, In (a, b) E -> on_segment a b p -> S p) /\
  Permutation (y :: map fst E) (x :: map snd E).
Proof.
  induction 1 as [|y z J (E & H & P) K].
  - exists []. split; [intros a b p []|reflexivity].
  - exists ((y, z) :: E). split.
    + intros a b p [Q|I] O; [injection Q; intros; subst; auto|eauto].
    + simpl. apply Permutation_trans with (z :: x :: map snd E); [apply perm_skip, P|apply
      perm_swap].
Qed.

Lemma crossing_cut a b m y : on_segment a b m ->
  crossing a b y = (crossing a m y + crossing m b y)%Z.
Proof.
  intros (t & T & E). destruct a as [a1 a2], b as [b1 b2], m as [m1 m2]. cbn [fst snd] in E.
  injection E; intros E2 E1.
  set (D := orient (a1, a2) (b1, b2) y).
  assert (O1 : orient (a1, a2) (m1, m2) y = t * D) by (unfold D, orient; simpl; subst; ring).
  assert (O2 : orient (m1, m2) (b1, b2) y = (1 - t) * D) by (unfold D, orient; simpl; subst; ring).
  unfold crossing. rewrite O1, O2. fold D. cbn [fst snd].
  assert (X : t * (b1 - a1) = m1 - a1) by lra. clear E E1 E2 O1 O2.
  destruct (Req_dec t 0) as [->|T0]; [assert (m1 = a1) by lra; subst m1|
    destruct (Req_dec t 1) as [->|T1]; [assert (m1 = b1) by lra; subst m1|]];
    split_decisions; try reflexivity; exfalso; nra.
Qed.
