(** A sum is bounded, and the closure of its interior if one of the two sets has an area. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Components OneForm Paths Decomposed
  Gaps Unique Legal Convolution Frontier.
Open Scope R_scope.

Lemma crossing_below a b y : snd y < snd a -> snd y < snd b ->
  crossing a b y = (reached b y - reached a y)%Z.
Proof.
  intros A B.
  assert (E : orient a b y = (fst b - fst y) * (snd y - snd a) + (fst y - fst a) * (snd y - snd b))
    by (unfold orient; ring).
  unfold crossing, reached. rewrite E. split_decisions; try lra; try reflexivity; exfalso; nra.
Qed.
Lemma winding_below E : closed E -> exists h, forall y, snd y < h -> winding E y = 0%Z.
Proof.
  intros C.
  assert (G : exists h, forall y, snd y < h -> winding E y =
    (sumz (fun v => reached v y) (map snd E) - sumz (fun v => reached v y) (map fst E))%Z).
  { clear C. induction E as [|[a b] E (h & H)]; [exists 0; reflexivity|].
    exists (Rmin h (Rmin (snd a) (snd b))). intros y Y.
    pose proof (Rmin_l h (Rmin (snd a) (snd b))). pose proof (Rmin_r h (Rmin (snd a) (snd b))).
    pose proof (Rmin_l (snd a) (snd b)). pose proof (Rmin_r (snd a) (snd b)).
    rewrite winding_cons, H, crossing_below by lra. unfold sumz. simpl. lia. }
  destruct G as (h & H). exists h. intros y Y. rewrite (H y Y), (sumz_perm _ _ _ C). lia.
Qed.
Lemma region_above E : closed E -> exists h, forall y, region E y -> h <= snd y.
Proof.
  intros C. destruct (winding_below E C) as (h & H). exists h. intros y R.
  apply Rnot_lt_le. intros L. destruct (R (h - snd y) ltac:(lra)) as (q & [_ Q] & _ & W).
  rewrite (H q) in W; [lia|]. apply Rabs_def2 in Q. lra.
Qed.
Lemma region_inside E p r : closed E -> region E p -> 0 < r -> exists q, near r p q /\
  interior (region E) q.
Proof.
  intros C Rp Hr. destruct (Rp r Hr) as (q & Q & O & W). exists q. split; auto.
  assert (N : ~ on_some E q) by (intros (a & b & I & S); exact (O a b I S)).
  destruct (winding_here E q C N) as (e & He & K). destruct (edges_near E q N) as (f & Hf & L).
  exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
  apply region_off; auto; [apply L; tauto|]. rewrite K; tauto.
Qed.
Definition sum_set (S T : point -> Prop) (x : point) : Prop :=
  exists p q, S p /\ T q /\ x = add p q.
Lemma sum_swap S T x : sum_set S T x <-> sum_set T S x.
Proof.
  split; intros (p & q & P & Q & ->); exists q, p; repeat split; auto; unfold add; f_equal; ring.
Qed.
Lemma interior_same (S T : point -> Prop) x : (forall y, S y <-> T y) -> interior S x ->
  interior T x.
Proof. intros H (e & He & K). exists e. split; auto. intros y Y. apply H, K, Y. Qed.
(** A set with an area and any other *)
Lemma sum_near_inside E (T : point -> Prop) x r : closed E -> sum_set (region E) T x -> 0 < r ->
  exists y, near r x y /\ interior (sum_set (region E) T) y.
Proof.
  intros C (p & q & P & Q & X) Hr.
  destruct (region_inside E p r C P Hr) as (p' & Np & e & He & K). exists (add p' q). split.
  - rewrite X. destruct Np as [A B]. unfold near, add; cbn [fst snd]. split.
    + replace (fst p' + fst q - (fst p + fst q)) with (fst p' - fst p) by ring. exact A.
    + replace (snd p' + snd q - (snd p + snd q)) with (snd p' - snd p) by ring. exact B.
  - exists e. split; auto. intros y Y. exists (minus_ y q), q. split; [|split; auto].
    + apply K. apply (near_translate _ _ _ q) in Y. replace p' with (minus_ (add p' q) q); auto.
      unfold minus_, add; destruct p'; cbn [fst snd]. f_equal; ring.
    + unfold add, minus_; destruct y; cbn [fst snd]. f_equal; ring.
Qed.
(** One of the two has an area: it is what its edges wind around. *)
Definition has_area (E : edges_t) (S : point -> Prop) : Prop := forall p, S p <-> region E p.
Lemma sum_regular E F S T : drawn E S -> drawn F T -> has_area E S \/ has_area F T ->
  is_regular (sum_set S T).
Proof.
  intros D G A. split.
  - intros x Lim. apply (drawn_sum_is_union E F S T x D G).
    apply (union_closed E F). intros e He. destruct (Lim e He) as (y & Y & Sy).
    exists y. split; auto. apply (drawn_sum_is_union E F S T y D G), Sy.
  - intros x r Sx Hr. destruct A as [A|A].
    + assert (H : forall y, sum_set S T y <-> sum_set (region E) T y).
      { intros y. split; intros (p & q & P & Q & Y); exists p, q; repeat split; auto; apply A, P. }
      apply H in Sx. destruct (sum_near_inside E T x r (proj1 D) Sx Hr) as (y & Y & I).
      exists y. split; auto. apply (interior_same _ _ y (fun z => iff_sym (H z)) I).
    + assert (H : forall y, sum_set S T y <-> sum_set (region F) S y).
      { intros y. rewrite sum_swap.
        split; intros (p & q & P & Q & Y); exists p, q; repeat split; auto; apply A, P. }
      apply H in Sx. destruct (sum_near_inside F S x r (proj1 G) Sx Hr) as (y & Y & I).
      exists y. split; auto. apply (interior_same _ _ y (fun z => iff_sym (H z)) I).
Qed.
Lemma drawn_bounded E S : drawn E S -> exists low high, forall x, S x -> low <= snd x <= high.
Proof.
  intros (C & [(H & _)|(H & _)]).
  - destruct (region_above E C) as (l & L). destruct (region_below E) as (h & U).
    exists l, h. intros x X. apply H in X. split; auto.
  - assert (G : exists low high, forall a b, In (a, b) E ->
      low <= snd a <= high /\ low <= snd b <= high).
    { clear H C. induction E as [|[a b] E (l & h & H)]; [exists 0, 0; intros a b []|].
      exists (Rmin l (Rmin (snd a) (snd b))), (Rmax h (Rmax (snd a) (snd b))).
      pose proof (Rmin_l l (Rmin (snd a) (snd b))). pose proof (Rmin_r l (Rmin (snd a) (snd b))).
      pose proof (Rmin_l (snd a) (snd b)). pose proof (Rmin_r (snd a) (snd b)).
      pose proof (Rmax_l h (Rmax (snd a) (snd b))). pose proof (Rmax_r h (Rmax (snd a) (snd b))).
      pose proof (Rmax_l (snd a) (snd b)). pose proof (Rmax_r (snd a) (snd b)).
      intros c d [Q|I]; [injection Q; intros; subst; lra|]. specialize (H c d I). lra. }
    destruct G as (l & h & G). exists l, h. intros x X. apply H in X.
    destruct X as (a & b & I & O). apply segment_range in O. specialize (G a b I). lra.
Qed.
