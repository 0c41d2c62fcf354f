(** Classes of cells fall into components, and the number of those of the interior:
    [components_are_right]. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Numbers Values
  Checker Corners Cancellation Bodies Scaling Trees Theorems Components Classes.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

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

(** Classes of cells of yes, each with its rim: no point of them is in two. *)
Section Parts.
Variable yes no : list (list corner).
Variable parts : list (list (list corner)).
Hypothesis yes_polygons : forall l, In l yes -> is_polygon l = true.
Hypothesis no_convex : forall l, In l no -> is_convex l = true.
Hypothesis once : forall y, (sumz (crossing_of y) (all_triangles no)
  + sumz (crossing_of y) (all_triangles yes) <= 1)%Z.
Hypothesis whole : exists rest, yes = rest ++ concat parts.
Hypothesis checked : forall i part, nth_error parts i = Some part ->
  exists c, check_component no part c = true.

Definition part_set (i : nat) (x : point) : Prop :=
  exists part, nth_error parts i = Some part /\ class yes part x.

Lemma part_in_yes i part : nth_error parts i = Some part -> forall l, In l part -> In l yes.
Proof.
  intros E l I. destruct whole as (rest & ->). apply in_or_app. right.
  apply in_concat. exists part. split; auto. eapply nth_error_In; eauto.
Qed.
Lemma part_number i x : part_set i x -> (i < length parts)%nat.
Proof. intros (part & E & _). apply nth_error_Some. congruence. Qed.
Lemma two_part_sets i j x : part_set i x -> part_set j x -> i = j.
Proof.
  intros (a & Ea & X & Ua) (b & Eb & _ & Ub).
  destruct (Nat.eq_dec i j) as [|N]; auto. exfalso.
  destruct (checked i a Ea) as (c & Hc). destruct (checked j b Eb) as (d & Hd).
  unfold check_component in Hc, Hd. apply andb_prop in Hc. apply andb_prop in Hd.
  apply (class_by_winding yes no yes_polygons no_convex once a c (proj1 Hc) (proj2 Hc) x X) in Ua.
  apply (class_by_winding yes no yes_polygons no_convex once b d (proj1 Hd) (proj2 Hd) x X) in Ub.
  rewrite (rim_turns no a c (proj2 Hc)) in Ua. rewrite (rim_turns no b d (proj2 Hd)) in Ub.
  destruct whole as (rest & W). pose proof yes_polygons as Yes. rewrite W in Yes.
  assert (Hr : forall l, In l rest -> is_polygon l = true)
    by (intros l I; apply Yes, in_or_app; auto).
  assert (Hp : forall l, In l (concat parts) -> is_polygon l = true)
    by (intros l I; apply Yes, in_or_app; auto).
  pose proof (two_parts parts x Hp i j a b N Ea Eb) as T.
  pose proof (count_positive rest x Hr). specialize (once x).
  rewrite W, all_triangles_app, sumz_app in once.
  assert (0 <= sumz (crossing_of x) (all_triangles no))%Z; [|lia].
  apply count_positive. intros l K. apply convex_polygon, no_convex, K.
Qed.
Lemma part_set_open i x : part_set i x -> interior (part_set i) x.
Proof.
  intros (part & E & X). destruct (checked i part E) as (c & Hc).
  unfold check_component in Hc. apply andb_prop in Hc.
  apply (interior_same (class yes part)).
  - intros y. split; [intros Y; exists part; auto|].
    intros (part' & E2 & Y). replace part with part' by congruence. exact Y.
  - apply (class_open yes no yes_polygons no_convex once part c (proj1 Hc) (proj2 Hc) x X).
Qed.
Lemma joined_in (S T : point -> Prop) x y : (forall p, S p -> T p) -> joined S x y ->
  joined T x y.
Proof. intros H J. induction J; [apply here|]. eapply farther; eauto. Qed.
Lemma part_set_joined i x y : part_set i x -> part_set i y -> joined (part_set i) x y.
Proof.
  intros (part & E & X) (part' & E' & Y). replace part' with part in Y by congruence.
  destruct (checked i part E) as (c & Hc). apply andb_prop in Hc.
  apply (joined_in (class yes part)); [intros p L; exists part; auto|].
  apply (class_joined yes part c (part_in_yes i part E) (proj1 Hc)); auto.
Qed.
Lemma part_set_not_empty i : (i < length parts)%nat -> exists x, part_set i x.
Proof.
  intros I. apply nth_error_Some in I. destruct (nth_error parts i) as [part|] eqn:E; [|congruence].
  destruct (checked i part E) as (c & Hc). apply andb_prop in Hc.
  destruct (class_not_empty yes part c (part_in_yes i part E) (proj1 Hc)) as (x & X).
  exists x, part. auto.
Qed.
End Parts.

(** The cells of a witness: the box counts each point once at most. *)
Definition other_cells (w : witness) : list (list corner) :=
  map fst (filter (fun c => negb (covered c)) (cells w)).
Lemma cells_once w : check_box w = true -> is_rectangle (box w) = true ->
  forall y, (sumz (crossing_of y) (all_triangles (other_cells w))
    + sumz (crossing_of y) (all_triangles (covered_cells w)) <= 1)%Z.
Proof.
  intros HB HR y. unfold check_box in HB. rewrite !andb_true_iff in HB. destruct HB as [_ HB].
  pose proof (rectangle_once _ HR y) as One.
  rewrite (same_boundary_same_turns _ _ HB y) in One. clear - One.
  replace (flat_map (fun c => ring_edges (fst c)) (cells w))
    with (flat_map ring_edges (map fst (cells w))) in One
    by (rewrite !flat_map_concat_map, map_map; reflexivity).
  rewrite turns_of_polygons in One. unfold other_cells, covered_cells. revert One.
  unfold all_triangles. generalize (cells w). intros l.
  assert (E : sumz (crossing_of y) (flat_map triangles (map fst l))
    = (sumz (crossing_of y)
         (flat_map triangles (map fst (filter (fun c => negb (covered c)) l)))
       + sumz (crossing_of y) (flat_map triangles (map fst (filter covered l))))%Z).
  { induction l as [|c l IH]; simpl; auto. rewrite sumz_app, IH.
    destruct (covered c); simpl; rewrite sumz_app; lia. }
  lia.
Qed.

(** What [check_components] has found where no operand is empty *)
Definition parts_of (w : witness) (cs : list component) : list (list (list corner)) :=
  split_by (map size cs) (covered_cells w).
Lemma component_parts s P Q R w cs : is_empty P || is_empty Q = false ->
  check_components s P Q R w cs = true ->
  is_rectangle (box w) = true /\ (forall l, In l (other_cells w) -> is_convex l = true) /\
  concat (parts_of w cs) = covered_cells w /\ length (parts_of w cs) = length cs /\
  (forall i part, nth_error (parts_of w cs) i = Some part ->
    exists c, check_component (other_cells w) part c = true).
Proof.
  intros Em H. unfold check_components in H. rewrite Em, !andb_true_iff, forallb_forall in H.
  destruct H as [_ [[[HR HN] HL] HA]].
  split; [exact HR|split; [exact HN|split; [apply split_by_whole, HL|split]]].
  - apply (all2_length _ _ _ HA).
  - intros i part E. eapply all2_nth; eauto.
Qed.

Lemma parts_fall s P Q R w cs : is_empty P || is_empty Q = false ->
  check_components s P Q R w cs = true ->
  falls_into (interior (set_of (outline R))) (part_set (covered_cells w) (parts_of w cs))
    (length cs).
Proof.
  intros Em H. assert (HS : check_sum s P Q R w = true)
    by (unfold check_components in H; apply andb_prop in H; tauto).
  destruct (sum_parts s P Q R w Em HS) as (OC & HB & Same).
  destruct (component_parts s P Q R w cs Em H) as (HR & HN & Whole & Len & Chk).
  assert (Yes : forall l, In l (covered_cells w) -> is_polygon l = true)
    by (intros l; apply (covered_are_polygons w OC)).
  pose proof (cells_once w HB HR) as Once.
  assert (W : exists rest, covered_cells w = rest ++ concat (parts_of w cs))
    by (exists []; auto).
  rewrite <- Len. split.
  - intros x. split.
    + intros X. apply (interior_same _ _ x Same) in X.
      assert (U := interior_in _ x X). unfold covered_set in U.
      apply union_of_all in U; auto. destruct U as (l & I & B).
      rewrite <- Whole in I. apply in_concat in I. destruct I as (part & I & J).
      apply In_nth_error in I. destruct I as (i & E).
      assert (PS : part_set (covered_cells w) (parts_of w cs) i x).
      { exists part. split; auto. split; auto. apply union_of_all.
        - intros k K. apply Yes. eapply part_in_yes; eauto.
        - exists l; auto. }
      exists i. split; auto. eapply part_number; eauto.
    + intros (i & _ & part & _ & X & _).
      apply (interior_same _ _ x (fun y => iff_sym (Same y)) X).
  - intros i I. split; [|split; [|split]].
    + eapply part_set_not_empty; eauto.
    + intros x. eapply part_set_open; eauto.
    + intros x y. eapply part_set_joined; eauto.
    + intros j x _. eapply two_part_sets; eauto.
Qed.

Lemma nothing_falls (S : point -> Prop) : (forall x, ~ S x) ->
  falls_into (interior S) (fun _ _ => False) 0.
Proof.
  intros N. split; [|intros i I; lia]. intros x. split; [|intros (i & I & _); lia].
  intros (e & He & K). exfalso. apply (N x), K, near_self, He.
Qed.
Lemma empty_sum s P Q R w : is_empty P || is_empty Q = true -> check_sum s P Q R w = true -> R = [].
Proof. unfold check_sum. intros ->. destruct R; [auto|discriminate]. Qed.

Theorem components_are_right : forall (s : number) (P Q R : rings corner) (w : witness)
    (cs : list component),
  check_components s P Q R w cs = true ->
  is_sum (value s) (outline P) (outline Q) (outline R) /\
    has_components (set_of (outline R)) (length cs).
Proof.
  intros s P Q R w cs H. assert (HS : check_sum s P Q R w = true)
    by (unfold check_components in H; apply andb_prop in H; tauto).
  split; [apply (sum_is_right s P Q R w HS)|].
  destruct (is_empty P || is_empty Q) eqn:Em.
  - unfold check_components in H. rewrite Em in H. apply andb_prop in H. destruct H as [_ H].
    destruct cs; [|discriminate]. exists (fun _ _ => False).
    rewrite (empty_sum s P Q R w Em HS). apply nothing_falls, empty_set.
  - eexists. apply (parts_fall s P Q R w cs Em H).
Qed.
End Here.
