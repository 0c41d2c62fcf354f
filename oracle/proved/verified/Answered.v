(** The statements of Statement.v hold. *)
From Coq Require Import Lra Lia Bool QArith Qreals.
From Proved Require Import Definitions Form Legality Operations OneForm Alike Points Member Along
  Decided Arranged Traced Exact Always Combined Combining Validity Judged Answers Statement.
Open Scope R_scope.

Lemma pair_decided s P Q : are_legal s P Q = true <-> legal_pair s P Q.
Proof.
  unfold are_legal, legal_pair. rewrite !andb_true_iff, !legality_is_decided, less_real, zero_real.
  tauto.
Qed.
Lemma thin_decided ps : is_thin (figure ps) -> thin ps = true.
Proof.
  destruct ps as [|[[|a [|b [|c o]]] [|h hs]] [|q qs]]; auto;
    intros [(x & E)|(x & y & _ & E)]; discriminate E.
Qed.

Lemma thin_is ps : thin ps = true -> is_legal (figure ps) -> is_thin (figure ps).
Proof.
  destruct ps as [|[[|a [|b [|c o]]] [|h hs]] [|q qs]]; try discriminate; intros _ L.
  - left. exists (point_of a). reflexivity.
  - destruct L as [L|[L|(L & _)]]; [left; exact L|right; exact L|exfalso].
    destruct (L _ [] (or_introl eq_refl)) as ((Three & _) & _). simpl in Three. lia.
Qed.

Theorem decided_points_are_right_holds : decided_points_are_right.
Proof.
  intros s P Q xs. unfold decide_points. destruct (are_legal s P Q) eqn:L.
  - apply pair_decided in L. split; [split; eauto|].
    intros answers E. injection E; intros <-. destruct L as (S & LP & LQ). clear E.
    induction xs as [|x xs IH]; cbn [map]; constructor; auto. unfold set.
    rewrite <- !rings_of_figure. apply membership_is_decided; auto.
  - split; [split|]; [|intros (answers & E); discriminate E|intros answers E; discriminate E].
    intros K. apply pair_decided in K. rewrite K in L. discriminate L.
Qed.

Theorem verified_sum_is_sound_holds : verified_sum_is_sound.
Proof.
  intros s P Q R holes. unfold verified_sum. destruct (are_legal s P Q) eqn:L; [|discriminate].
  apply pair_decided in L. destruct (thin P && thin Q) eqn:N; [discriminate|]. cbn [andb negb].
  intros Answer. split; [exact L|]. destruct L as (S & LP & LQ). unfold set.
  rewrite <- (rings_of_figure P), <- (rings_of_figure Q).
  apply exact_sum_is_right; auto. intros [TP TQ].
  rewrite (thin_decided P TP), (thin_decided Q TQ) in N. discriminate N.
Qed.

Theorem verified_sum_is_the_only_one_holds : verified_sum_is_the_only_one.
Proof.
  intros s P Q R holes ps Answer Sum Can.
  destruct (verified_sum_is_sound_holds s P Q R holes Answer) as (_ & Sum' & _ & _ & Can').
  exact (one_form_of_a_sum_holds _ _ _ _ _ Sum Can Sum' Can').
Qed.

Theorem verified_sum_is_complete_holds : verified_sum_is_complete.
Proof.
  intros s P Q. unfold verified_sum, is_point_or_segment.
  fold (is_thin (figure P)) (is_thin (figure Q)). split.
  - intros [L N]. rewrite (proj2 (pair_decided s P Q) L). destruct L as (S & LP & LQ).
    destruct (thin P && thin Q) eqn:T; [|apply exact_sum_answers; auto].
    apply andb_true_iff in T. destruct N. split; apply thin_is; tauto.
  - intros (R & holes & Answer). destruct (are_legal s P Q) eqn:L; [|discriminate].
    split; [apply pair_decided, L|]. intros [TP TQ].
    rewrite (thin_decided P TP), (thin_decided Q TQ) in Answer. discriminate Answer.
Qed.

Lemma combined_decided P others : forallb decide_polygon_set (P :: others) = true <->
  forall K, In K (P :: others) -> is_polygon_set (figure K).
Proof.
  rewrite forallb_forall. split; intros H K I; apply polygon_sets_are_decided, H, I.
Qed.
Lemma combination_is o P others : exact_combination o (rings_of P) (map rings_of others) =
  let edges K := all_edges (rings_of K) in
  traced_set (decide_combined o (edges P) (map edges others))
    (all_segments (map edges (P :: others))).
Proof. unfold exact_combination. cbv zeta. rewrite map_map. reflexivity. Qed.

Theorem verified_combination_is_complete_holds : verified_combination_is_complete.
Proof.
  intros o P others. unfold verified_combination. split.
  - intros L. rewrite (proj2 (combined_decided P others) L), combination_is.
    exact (traced_set_answers _ _ _ (combination_is_arranged o P others L)).
  - intros (R & holes & Answer). destruct (forallb _ (P :: others)) eqn:L; [|discriminate].
    exact (proj1 (combined_decided P others) L).
Qed.

Theorem verified_combination_is_sound_holds : verified_combination_is_sound.
Proof.
  intros o P others R holes. unfold verified_combination.
  destruct (forallb _ (P :: others)) eqn:L; [|discriminate].
  pose proof (proj1 (combined_decided P others) L) as Legal_. clear L.
  rewrite combination_is. intros Answer.
  exact (traced_set_is_right _ _ _ R holes (combination_is_arranged o P others Legal_) Answer).
Qed.

Theorem verified_combination_is_the_only_one_holds : verified_combination_is_the_only_one.
Proof.
  intros o P others R holes ps Answer Set_ Can.
  destruct (verified_combination_is_sound_holds o P others R holes Answer) as (Set' & _ & _ & Can').
  apply (another_form_is_another_set_holds ps (figure R) Can Can').
  intros x. rewrite (Set_ x), <- (Set' x). reflexivity.
Qed.

Theorem verified_union_is_sound_holds : verified_union_is_sound.
Proof.
  intros P others R holes Answer x.
  assert (L := proj2 (verified_combination_is_complete_holds unite P others)
    (ex_intro _ R (ex_intro _ holes Answer))).
  rewrite (proj1 (verified_combination_is_sound_holds _ _ _ _ _ Answer) x).
  rewrite (union_as_it_is unite P others L x eq_refl).
  simpl. apply or_iff_compat_l. split.
  - intros (T & I & K). apply in_map_iff in I. destruct I as (Q & <- & I). exists Q. auto.
  - intros (Q & I & K). exists (in_set Q). split; [apply in_map, I|exact K].
Qed.
