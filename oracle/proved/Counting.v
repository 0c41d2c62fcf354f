(** The number of components: [components_are_right]. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Checker Rational
  Cancellation Bodies Scaling Trees Theorems Components Classes.
Open Scope R_scope.

Lemma split_by_rest {A} sizes : forall l : list A, exists rest, l = concat (split_by sizes l) ++
  rest.
Proof.
  induction sizes as [|n r IH]; intros l; simpl.
  - exists l. reflexivity.
  - destruct (IH (skipn n l)) as (rest & E). exists rest.
    rewrite <- app_assoc, <- E, firstn_skipn. reflexivity.
Qed.
Lemma split_by_whole {A} sizes (l : list A) :
  Nat.eqb (length (concat (split_by sizes l))) (length l) = true -> concat (split_by sizes l) = l.
Proof.
  intros H. apply Nat.eqb_eq in H. destruct (split_by_rest sizes l) as (rest & E).
  assert (L : length rest = 0%nat).
  { apply (f_equal (@length A)) in E. rewrite app_length in E. lia. }
  destruct rest; [|discriminate]. rewrite app_nil_r in E. auto.
Qed.
Lemma all2_length {A B} (f : A -> B -> bool) l : forall k, all2 f l k = true ->
  length l = length k.
Proof.
  induction l as [|x l IH]; intros [|y k]; simpl; try discriminate; auto.
  rewrite andb_true_iff. intros [_ H]. f_equal. auto.
Qed.
Lemma all2_nth {A B} (f : A -> B -> bool) l : forall k i x, all2 f l k = true ->
  nth_error l i = Some x -> exists y, f x y = true.
Proof. intros k i x H E. apply (all2_partner f l k H). eapply nth_error_In; eauto. Qed.

Lemma count_positive ls y : (forall l, In l ls -> is_polygon l = true) ->
  (0 <= sumz (crossing_of y) (all_triangles ls))%Z.
Proof.
  intros H. apply sumz_ge0. intros t I. eapply triangle_counts; [apply all_positive, H|exact I].
Qed.
Lemma all_triangles_app ls ks : all_triangles (ls ++ ks) = all_triangles ls ++ all_triangles ks.
Proof. unfold all_triangles. apply flat_map_app. Qed.
Lemma two_parts parts y : (forall l, In l (concat parts) -> is_polygon l = true) ->
  forall i j a b, i <> j -> nth_error parts i = Some a -> nth_error parts j = Some b ->
  (sumz (crossing_of y) (all_triangles a) + sumz (crossing_of y) (all_triangles b)
    <= sumz (crossing_of y) (all_triangles (concat parts)))%Z.
Proof.
  assert (One : forall parts, (forall l, In l (concat parts) -> is_polygon l = true) ->
    forall i a, nth_error parts i = Some a -> (sumz (crossing_of y) (all_triangles a)
      <= sumz (crossing_of y) (all_triangles (concat parts)))%Z).
  { clear. induction parts as [|p r IH]; intros H [|i] a E; try discriminate; simpl in *;
      rewrite all_triangles_app, sumz_app.
    - injection E; intros ->. pose proof (count_positive (concat r) y).
      assert (0 <= sumz (crossing_of y) (all_triangles (concat r)))%Z; [|lia].
      apply H0. intros l I. apply H, in_or_app; auto.
    - assert (0 <= sumz (crossing_of y) (all_triangles p))%Z
        by (apply count_positive; intros l I; apply H, in_or_app; auto).
      assert (forall l, In l (concat r) -> is_polygon l = true)
        by (intros l I; apply H, in_or_app; auto).
      specialize (IH H1 i a E). lia. }
  induction parts as [|p r IH]; intros H i j a b N Ea Eb; [destruct i; discriminate|].
  assert (Hp : forall l, In l p -> is_polygon l = true)
    by (intros l I; apply H; simpl; apply in_or_app; auto).
  assert (Hr : forall l, In l (concat r) -> is_polygon l = true)
    by (intros l I; apply H; simpl; apply in_or_app; auto).
  simpl. rewrite all_triangles_app, sumz_app. pose proof (count_positive p y Hp).
  destruct i as [|i], j as [|j]; simpl in Ea, Eb; try congruence.
  - injection Ea; intros ->. pose proof (One r Hr j b Eb). lia.
  - injection Eb; intros ->. pose proof (One r Hr i a Ea). lia.
  - assert (N' : i <> j) by congruence. specialize (IH Hr i j a b N' Ea Eb). lia.
Qed.

Lemma interior_same (S T : point -> Prop) x : (forall y, S y <-> T y) -> interior S x ->
  interior T x.
Proof. intros H (e & He & N). exists e. split; auto. intros y Y. apply H, N, Y. Qed.

Theorem components_are_right : forall (s : Q) (P Q R : rings) (w : witness) (cs : list component),
  check_components s P Q R w cs = true ->
  is_sum s P Q R /\ has_components (set_of R) (length cs).
Proof.
  intros s P Q R w cs H. unfold check_components in H. apply andb_prop in H. destruct H as [HS H].
  split; [apply (sum_is_right s P Q R w HS)|].
  destruct (is_empty P || is_empty Q) eqn:Em.
  - destruct cs; [|discriminate]. exists (fun _ _ => False). split; [|intros i I; simpl in I; lia].
    intros x. split; [|intros (i & I & _); simpl in I; lia]. intros (e & He & N).
    exfalso. unfold check_sum in HS. rewrite Em in HS. destruct R; [|discriminate].
    apply (empty_set x), N, near_self, He.
  - destruct (sum_parts s P Q R w Em HS) as (OC & HB & Res).
    rewrite !andb_true_iff, forallb_forall in H. destruct H as [[[HR HN] HL] HA].
    set (yes := map fst (filter covered (cells w))) in *.
    set (no := map fst (filter (fun c => negb (covered c)) (cells w))) in *.
    set (parts := split_by (map size cs) yes) in *.
    assert (Whole : concat parts = yes) by (apply split_by_whole, HL).
    assert (Yes : forall l, In l yes -> is_polygon l = true)
      by (intros l; apply (covered_are_polygons w OC)).
    assert (Once : forall y, (sumz (crossing_of y) (all_triangles no)
        + sumz (crossing_of y) (all_triangles yes) <= 1)%Z).
    { intros y. unfold check_box in HB. rewrite !andb_true_iff in HB. destruct HB as [_ HB].
      pose proof (rectangle_once _ HR y) as One.
      rewrite (same_boundary_same_turns _ _ HB y) in One. clear - One.
      replace (flat_map (fun c => ring_edges (fst c)) (cells w))
        with (flat_map ring_edges (map fst (cells w))) in One
        by (rewrite !flat_map_concat_map, map_map; reflexivity).
      rewrite turns_of_polygons in One. unfold yes, no. revert One.
      unfold all_triangles. generalize (cells w). intros l.
      assert (E : sumz (crossing_of y) (flat_map triangles (map fst l))
        = (sumz (crossing_of y)
             (flat_map triangles (map fst (filter (fun c => negb (covered c)) l)))
           + sumz (crossing_of y) (flat_map triangles (map fst (filter covered l))))%Z).
      { induction l as [|c l IH]; simpl; auto. rewrite sumz_app, IH.
        destruct (covered c); simpl; rewrite sumz_app; lia. }
      lia. }
    assert (In_yes : forall i part, nth_error parts i = Some part ->
        forall l, In l part -> In l yes).
    { intros i part E l I. rewrite <- Whole. apply in_concat. exists part.
      split; auto. eapply nth_error_In; eauto. }
    assert (Len : length parts = length cs) by (apply (all2_length _ _ _ HA)).
    assert (Chk : forall i part, nth_error parts i = Some part ->
        exists c, check_component no part c = true)
      by (intros i part E; eapply all2_nth; eauto).
    assert (Same : forall x, set_of R x <-> covered_set yes x) by exact Res.
    exists (fun i x => exists part, nth_error parts i = Some part /\ class yes part x). split.
    + intros x. split.
      * intros X. apply (interior_same _ _ x Same) in X.
        assert (U := interior_in yes x X). unfold covered_set in U.
        apply union_of_all in U; auto. destruct U as (l & I & B).
        rewrite <- Whole in I. apply in_concat in I. destruct I as (part & I & J).
        apply In_nth_error in I. destruct I as (i & E). exists i. split.
        { rewrite <- Len. apply nth_error_Some. congruence. }
        exists part. split; auto. split; auto. apply union_of_all.
        { intros k K. apply Yes, (In_yes i part E k K). }
        exists l; auto.
      * intros (i & _ & part & _ & X & _).
        apply (interior_same _ _ x (fun y => iff_sym (Same y)) X).
    + intros i I. rewrite <- Len in I. apply nth_error_Some in I.
      destruct (nth_error parts i) as [part|] eqn:E; [|congruence]. clear I.
      destruct (Chk i part E) as (c & Hc). pose proof (In_yes i part E) as Sub.
      split; [|split; [|split]].
      * destruct (class_not_empty yes no part c Sub Hc) as (x & X). exists x, part. auto.
      * intros x (part' & E' & X). injection E'; intros <-.
        apply (interior_same (class yes part)).
        { intros y. split; [intros Y; exists part; auto|].
          intros (part' & E2 & Y). injection E2; intros <-. exact Y. }
        apply (class_open yes no Yes HN Once part c Hc x X).
      * intros x y (part1 & E1 & X) (part2 & E2 & Y).
        injection E1; intros <-. injection E2; intros <-.
        assert (J := class_joined yes no part c Sub Hc x y X Y). clear - J.
          induction J as [|y z J IH K].
        { apply here. }
        eapply farther; [exact IH|]. intros p L. exists part. auto.
      * intros j x _ (part1 & E1 & X1 & U1) (part2 & E2 & _ & U2).
        injection E1; intros <-. destruct (Nat.eq_dec i j) as [|N]; auto. exfalso.
        destruct (Chk j part2 E2) as (c2 & Hc2). pose proof (In_yes j part2 E2) as Sub2.
        apply (class_by_winding yes no Yes HN Once part c Hc x X1) in U1.
        apply (class_by_winding yes no Yes HN Once part2 c2 Hc2 x X1) in U2.
        rewrite (rim_turns no part c Hc) in U1. rewrite (rim_turns no part2 c2 Hc2) in U2.
        assert (YesW : forall l, In l (concat parts) -> is_polygon l = true)
          by (rewrite Whole; exact Yes).
        pose proof (two_parts parts x YesW i j part part2 N E E2) as T.
        rewrite Whole in T. specialize (Once x).
        assert (0 <= sumz (crossing_of x) (all_triangles no))%Z; [|lia].
        apply count_positive. intros l K. apply convex_polygon, HN, K.
Qed.
