(** Two canonical forms of one closed set are equal: polygon by polygon, ring by ring. *)
From Coq Require Import Lra Lia Psatz Permutation Classical Sorted.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Differing Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside Rounds
  Next Shared Under.
Open Scope R_scope.

(** ** Lists in order *)
Lemma ring_before_not l : ~ ring_before l l.
Proof. induction l as [|p l IH]; simpl; auto. intros [H|[_ H]]; auto. exact (before_not p H). Qed.
Lemma ring_before_transitive : forall l k m, ring_before l k -> ring_before k m -> ring_before l m.
Proof.
  induction l as [|p l IH]; intros [|q k] [|r m]; simpl; auto; try tauto.
  intros [H|[-> H]] [K|[-> K]]; auto.
  - left. exact (before_transitive _ _ _ H K).
  - right. split; auto. exact (IH k m H K).
Qed.
Lemma sorted_equal {A} (T : A -> A -> Prop) : (forall x, ~ T x x) ->
  (forall x y z, T x y -> T y z -> T x z) -> forall l k, Sorted T l -> Sorted T k ->
  (forall x, In x l <-> In x k) -> l = k.
Proof.
  intros No More l k Sl Sk. apply Sorted_StronglySorted in Sl; [|exact More].
  apply Sorted_StronglySorted in Sk; [|exact More]. revert k Sk.
  induction Sl as [|a l Sl IH Fa]; intros k Sk H.
  - destruct k as [|b k]; auto. destruct (proj2 (H b) (or_introl eq_refl)).
  - destruct Sk as [|b k Sk Fb]; [destruct (proj1 (H a) (or_introl eq_refl))|].
    rewrite Forall_forall in Fa, Fb. assert (a = b).
    { destruct (proj1 (H a) (or_introl eq_refl)) as [E|E]; auto.
      destruct (proj2 (H b) (or_introl eq_refl)) as [F|F]; auto.
      destruct (No a). exact (More _ _ _ (Fa b F) (Fb a E)). }
    subst b. f_equal. apply IH; auto. intros x. split; intros I.
    + destruct (proj1 (H x) (or_intror I)) as [<-|]; auto. destruct (No a (Fa a I)).
    + destruct (proj2 (H x) (or_intror I)) as [<-|]; auto. destruct (No a (Fb a I)).
Qed.
Lemma sorted_by {A B} (f : A -> B) (T : B -> B -> Prop) l : Sorted T (map f l) ->
  Sorted (fun a b => T (f a) (f b)) l.
Proof.
  induction l as [|a l IH]; simpl; intros H; inversion H; subst; constructor; auto.
  destruct l as [|b l]; constructor. simpl in H3. inversion H3. auto.
Qed.


(** ** Polygon by polygon, ring by ring *)
Section Two.
Variable S : point -> Prop.
Hypothesis is_closed_set : is_closed S.

Lemma rings_in ps qs C D i j outer holes outer' holes' ring : is_form S ps -> is_form S qs ->
  in_order ps -> in_order qs -> parts S ps C -> parts S qs D ->
  nth_error ps i = Some (outer, holes) -> nth_error qs j = Some (outer', holes') ->
  (forall x, C i x <-> D j x) -> In ring (outer :: holes) -> In ring (outer' :: holes').
Proof.
  intros FP FQ OP OQ PC PD N N' Same I.
  destruct (ring_meets S ps qs C D i j outer holes outer' holes' ring is_closed_set FP FQ PC PD N
    N' Same I) as (ring' & I' & H).
  assert (ring = ring'); [|congruence]. apply least_first; auto.
  - destruct PD as (_ & _ & B). apply ring_vertices, (B j _ _ N'). auto.
  - exact (proj1 OP ring (ring_of_form _ _ _ _ _ N I)).
  - exact (proj1 OQ ring' (ring_of_form _ _ _ _ _ N' I')).
Qed.

Lemma polygon_in ps qs p : is_canonical S ps -> is_canonical S qs -> In p ps -> In p qs.
Proof.
  intros (FP & OP) (FQ & OQ) I. destruct (form_parts S ps is_closed_set FP) as (C & PC).
  destruct (form_parts S qs is_closed_set FQ) as (D & PD).
  pose proof (In_nth_error ps p I) as (i & N). destruct p as (outer & holes).
  assert (Li : (i < length ps)%nat) by (apply nth_error_Some; congruence).
  destruct (components_unique _ _ _ _ _ (proj1 PC) (proj1 PD) i Li) as (j & Lj & Same).
  destruct (nth_error qs j) as [(outer', holes')|] eqn:N'.
  2: { apply nth_error_Some in Lj. congruence. }
  assert (H : forall ring, In ring (outer :: holes) <-> In ring (outer' :: holes')).
  { intros ring. split; intros J.
    - apply (rings_in ps qs C D i j outer holes); auto.
    - apply (rings_in qs ps D C j i outer' holes'); auto. intros x. symmetry. apply Same. }
  destruct PC as (_ & _ & HC). destruct (HC i outer holes N) as (A & Ah & _).
  destruct PD as (_ & _ & HD). destruct (HD j outer' holes' N') as (A' & Ah' & _).
  assert (outer = outer').
  { destruct (proj1 (H outer) (or_introl eq_refl)) as [E|E]; auto.
    specialize (Ah' outer E). lra. }
  subst outer'. assert (holes = holes').
  { apply (sorted_equal ring_before ring_before_not ring_before_transitive).
    - apply (proj1 (proj2 OP) (outer, holes)). eauto using nth_error_In.
    - apply (proj1 (proj2 OQ) (outer, holes')). eauto using nth_error_In.
    - intros x. split; intros J.
      + destruct (proj1 (H x) (or_intror J)) as [<-|]; auto. specialize (Ah outer J). lra.
      + destruct (proj2 (H x) (or_intror J)) as [<-|]; auto. specialize (Ah' outer J). lra. }
  subst holes'. exact (nth_error_In _ _ N').
Qed.
Theorem canonical_once ps qs : is_canonical S ps -> is_canonical S qs -> ps = qs.
Proof.
  intros P Q. apply (sorted_equal (fun p q => ring_before (fst p) (fst q))).
  - intros p. apply ring_before_not.
  - intros p q r. apply ring_before_transitive.
  - apply sorted_by, P.
  - apply sorted_by, Q.
  - intros p. split; apply polygon_in; auto.
Qed.
End Two.

(** ** The statements of OneForm.v *)
Theorem one_canonical_form_holds : one_canonical_form.
Proof. intros S ps qs Cl P Q. exact (canonical_once S Cl ps qs P Q). Qed.
Lemma segment_is_closed a b : is_closed (on_segment a b).
Proof.
  intros x H. apply NNPP. intros N. destruct (segment_near a b x N) as (e & He & K).
  destruct (H e He) as (y & Y & O). exact (K y Y O).
Qed.
Theorem rings_give_closed_sets_holds : rings_give_closed_sets.
Proof.
  intros [|[|a [|b [|c l]]] [|k r]]; try apply region_is_closed.
  - intros x H. assert (O : on_segment a a x).
    { apply segment_is_closed. intros e He. destruct (H e He) as (y & Y & ->). exists a.
      split; auto. apply on_segment_start. }
    destruct O as (t & _ & O). simpl. rewrite O. destruct a; cbn [fst snd]. f_equal; ring.
  - apply segment_is_closed.
Qed.

(** What is said of a set is said of the same set in other words. *)
Lemma form_same S T ps : same_set S T -> is_form S ps -> is_form T ps.
Proof.
  intros H (C & (U & K) & In2 & P & D).
  assert (In : forall x, interior S x <-> interior T x)
    by (intros x; split; intros (e & He & G); exists e; split; auto; intros y Y; apply H, G, Y).
  exists C. split; [|split; [|split; auto]].
  - split; auto. intros x. rewrite <- In. apply U.
  - intros x X Off. apply In, In2; auto. apply H, X.
  - intros i outer holes N. destruct (D i outer holes N) as (A & B & G). split; auto. split; auto.
    intros ring I. destruct (G ring I) as (Rg & Dv). split; auto. intros e Ie.
    destruct (Dv e Ie) as (few & F). exists few. intros x X. destruct (F x X) as [L|(r & R & L)];
      auto. right. exists r. split; auto. intros y Y. destruct (L y Y) as (L1 & L2). split; auto.
    intros Z Ty. apply (L2 Z), H, Ty.
Qed.
Theorem another_form_is_another_set_holds : another_form_is_another_set.
Proof.
  intros ps qs P Q. split; [intros ->; split; auto|]. intros H.
  apply (one_canonical_form_holds (set_of (rings_of qs))); auto.
  - apply rings_give_closed_sets_holds.
  - destruct P as (F & O). split; auto. apply (form_same (set_of (rings_of ps))); auto.
Qed.
Theorem one_form_of_a_sum_holds : one_form_of_a_sum.
Proof.
  intros s P Q ps qs SP CP SQ CQ. apply (another_form_is_another_set_holds ps qs CP CQ).
  intros x. rewrite (SP x). symmetry. apply SQ.
Qed.
