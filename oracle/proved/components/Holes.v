(** The number of holes: [holes_are_right]. The classes of cells that are not covered, but that of
    the outside, are the bounded components of the complement. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Numbers Values
  Checker Corners Cancellation Bodies Scaling Trees Theorems Components Classes Counting.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

Lemma strictly_in_real l p : is_strictly_in l p = true -> strict l (real p).
Proof.
  unfold is_strictly_in, strict. rewrite forallb_forall. intros H a b I. specialize (H _ I).
  apply lt_value in H. cbn [fst snd] in H. rewrite real_orient, value_zero in H. exact H.
Qed.
Lemma is_out_real l p : is_out l p = true -> ~ strict l (real p).
Proof.
  unfold is_out. rewrite existsb_exists. intros ([a b] & I & H) S. specialize (S a b I).
  apply le_value in H. cbn [fst snd] in H. rewrite real_orient, value_zero in H. lra.
Qed.
Lemma strict_union l ls x : (forall k, In k ls -> is_polygon k = true) ->
  (forall k v, In k ls -> In v k -> strict l (real v)) -> union_of (all_triangles ls) x ->
  strict l x.
Proof.
  intros O H (a & b & c & I & K). pose proof (all_positive ls O _ _ _ I) as D.
  apply in_flat_map in I. destruct I as (k & Ik & I).
  apply triangle_corners in I. destruct I as (u & v & z & Iu & Iv & Iz & -> & -> & ->).
  destruct (triangle_combination _ _ _ x D K) as (i & j & m & Hi & Hj & Hm & S & -> & _).
  intros p q E.
  pose proof (H k u Ik Iu p q E) as Hu. pose proof (H k v Ik Iv p q E) as Hv.
  pose proof (H k z Ik Iz p q E) as Hz.
  replace (orient (real p) (real q) (combination i j m (real u) (real v) (real z))) with
    (i * orient (real p) (real q) (real u) + j * orient (real p) (real q) (real v)
     + m * orient (real p) (real q) (real z)).
  - assert (0 < i \/ 0 < j \/ 0 < m) by lra. nra.
  - replace m with (1 - i - j) by lra. unfold orient, combination; simpl. ring.
Qed.

(** ** A rectangle: what is outside hangs together. *)
Lemma rectangle_walls l : is_rectangle l = true -> exists x0 y0 x1 y1, x0 < x1 /\ y0 < y1 /\
  (forall p, strict l p <-> x0 < fst p < x1 /\ y0 < snd p < y1) /\
  (forall p, left_of l p <-> x0 <= fst p <= x1 /\ y0 <= snd p <= y1).
Proof.
  destruct l as [|a [|b [|c [|d [|? ?]]]]]; try discriminate. unfold is_rectangle.
  rewrite !andb_true_iff. intros [[[[[B T] L] R] W] H].
  apply equal_value in B. apply equal_value in T. apply equal_value in L. apply equal_value in R.
  apply lt_value in W. apply lt_value in H.
  exists (value (fst a)), (value (snd a)), (value (fst b)), (value (snd d)).
  set (x0 := value (fst a)) in *. set (y0 := value (snd a)) in *.
  set (x1 := value (fst b)) in *. set (y1 := value (snd d)) in *.
  assert (E : forall p, orient (real a) (real b) p = (x1 - x0) * (snd p - y0) /\
    orient (real b) (real c) p = (y1 - y0) * (x1 - fst p) /\
    orient (real c) (real d) p = (x1 - x0) * (y1 - snd p) /\
    orient (real d) (real a) p = (y1 - y0) * (fst p - x0)).
  { intros p. unfold orient, real; cbn [fst snd]. fold x0 y0 x1 y1.
    rewrite <- B, T, <- R, <- L. fold x0 y0 x1 y1. repeat split; ring. }
  split; [exact W|split; [exact H|split]]; intros p; destruct (E p) as (E1 & E2 & E3 & E4).
  all: split; [intros S; pose proof (S a b) as S1; pose proof (S b c) as S2;
    pose proof (S c d) as S3; pose proof (S d a) as S4; simpl in S1, S2, S3, S4;
    rewrite E1 in S1; rewrite E2 in S2; rewrite E3 in S3; rewrite E4 in S4;
    specialize (S1 ltac:(auto)); specialize (S2 ltac:(auto)); specialize (S3 ltac:(auto 6));
    specialize (S4 ltac:(auto 6)); nra
  | intros [[X0 X1] [Y0 Y1]] u v I; simpl in I;
    repeat destruct I as [I|I]; try (injection I; intros; subst u v;
      rewrite ?E1, ?E2, ?E3, ?E4; nra); destruct I].
Qed.
Lemma outside_joined x0 y0 x1 y1 (F : point -> Prop) : x0 < x1 -> y0 < y1 ->
  (forall p, ~ (x0 < fst p < x1 /\ y0 < snd p < y1) -> F p) ->
  forall p q, ~ (x0 < fst p < x1 /\ y0 < snd p < y1) ->
    ~ (x0 < fst q < x1 /\ y0 < snd q < y1) -> joined F p q.
Proof.
  intros W H Free.
  assert (Step : forall a b, (fst a <= x0 /\ fst b <= x0) \/ (x1 <= fst a /\ x1 <= fst b) \/
    (snd a <= y0 /\ snd b <= y0) \/ (y1 <= snd a /\ y1 <= snd b) -> joined F a b).
  { intros a b C. apply joined_step. intros p (t & T & ->). apply Free. cbn [fst snd].
    intros [[A1 A2] [A3 A4]]. destruct C as [C|[C|[C|C]]]; nra. }
  assert (Corner : forall p, ~ (x0 < fst p < x1 /\ y0 < snd p < y1) -> joined F p (x0, y0)).
  { intros p N.
    assert (C : fst p <= x0 \/ x1 <= fst p \/ snd p <= y0 \/ y1 <= snd p) by lra.
    destruct C as [C|[C|[C|C]]].
    - apply Step. simpl. lra.
    - apply joined_join with (x1, y0); apply Step; simpl; lra.
    - apply Step. simpl. lra.
    - apply joined_join with (x0, y1); apply Step; simpl; lra. }
  intros p q Hp Hq. apply joined_join with (x0, y0); [|apply joined_back]; auto.
Qed.

Section Holes.
Variable box : list corner.
Variable yes : list (list corner). (* covered cells *)
Variable outer : list (list corner). (* the class of the outside *)
Variable parts : list (list (list corner)). (* the other classes of cells that are not covered *)
Definition no : list (list corner) := outer ++ concat parts.
Hypothesis rectangle : is_rectangle box = true.
Hypothesis box_cells : forall x, left_of box x ->
  covered_set yes x \/ covered_set no x.
Hypothesis yes_convex : forall l, In l yes -> is_convex l = true.
Hypothesis no_convex : forall l, In l no -> is_convex l = true.
Hypothesis once : forall y, (sumz (crossing_of y) (all_triangles yes)
  + sumz (crossing_of y) (all_triangles no) <= 1)%Z.
Variable outside : component.
Hypothesis one_class : is_class outer outside = true.
Hypothesis at_wall : reaches_wall box outer = true.
Hypothesis checked : forall i part, nth_error parts i = Some part ->
  exists c, check_component yes part c = true.
Hypothesis larger : forall l v, In l (yes ++ concat parts) -> In v l -> strict box (real v).

Definition hole := part_set no parts.
Definition free (x : point) : Prop := ~ covered_set yes x /\ forall i, ~ hole i x.

Lemma yes_polygon l : In l yes -> is_polygon l = true.
Proof. intros I. apply convex_polygon, yes_convex, I. Qed.
Lemma no_polygon l : In l no -> is_polygon l = true.
Proof. intros I. apply convex_polygon, no_convex, I. Qed.
Lemma parts_polygon l : In l (concat parts) -> is_polygon l = true.
Proof. intros I. apply no_polygon, in_or_app. auto. Qed.
Lemma whole : exists rest, no = rest ++ concat parts.
Proof. exists outer. reflexivity. Qed.
Lemma yes_strict x : covered_set yes x -> strict box x.
Proof.
  apply strict_union; [exact yes_polygon|]. intros k v I J. apply (larger k); auto.
  apply in_or_app; auto.
Qed.
Lemma parts_strict x : union_of (all_triangles (concat parts)) x -> strict box x.
Proof.
  apply strict_union; [exact parts_polygon|]. intros k v I J. apply (larger k); auto.
  apply in_or_app; auto.
Qed.

(** Of the points inside the box those that are not covered are inside the other cells. *)
Lemma not_covered_near x : ~ covered_set yes x -> exists e, 0 < e /\ forall y, near e x y ->
  ~ covered_set yes y.
Proof.
  intros N. destruct (union_decided (all_triangles yes) x) as [U|U]; [contradiction|].
  exact (near_outside_all _ x (all_positive yes yes_polygon) U).
Qed.
Lemma inside_others x : strict box x -> ~ covered_set yes x -> interior (covered_set no) x.
Proof.
  intros B N. destruct (not_covered_near x N) as (e & He & K).
  destruct (left_is_open box x B) as (f & Hf & L). exists (Rmin e f).
  split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
  destruct (box_cells y (L y (proj2 Y))) as [C|C]; auto. destruct (K y (proj1 Y) C).
Qed.
Lemma not_covered x : interior (covered_set no) x -> ~ covered_set yes x.
Proof.
  intros X U. apply union_of_all in U; [|exact yes_polygon]. destruct U as (l & I & B).
  rewrite polygon_body in B by (apply yes_polygon, I).
  apply (not_in_others no yes no_polygon yes_convex once l x I); auto.
  apply convex_union_left; auto.
Qed.
Lemma hole_not_covered i x : hole i x -> ~ covered_set yes x.
Proof. intros (part & _ & X & _). apply not_covered, X. Qed.
Lemma hole_by_cells i part x : nth_error parts i = Some part ->
  union_of (all_triangles part) x -> ~ covered_set yes x -> hole i x.
Proof.
  intros E U N. exists part. split; auto. split; auto. apply inside_others; auto.
  apply parts_strict. apply union_of_all; [exact parts_polygon|].
  assert (Sub : forall l, In l part -> In l (concat parts)).
  { intros l I. apply in_concat. exists part. split; auto. eapply nth_error_In; eauto. }
  apply union_of_all in U; [|intros l I; apply parts_polygon, Sub, I].
  destruct U as (l & I & B). exists l. auto.
Qed.
Lemma hole_in_cells i x : hole i x -> union_of (all_triangles (concat parts)) x.
Proof.
  intros (part & E & _ & U).
  assert (Sub : forall l, In l part -> In l (concat parts)).
  { intros l I. apply in_concat. exists part. split; auto. eapply nth_error_In; eauto. }
  apply union_of_all in U; [|intros l I; apply parts_polygon, Sub, I].
  destruct U as (l & I & B). apply union_of_all; [exact parts_polygon|]. exists l. auto.
Qed.
Lemma cells_in_hole x : union_of (all_triangles (concat parts)) x -> ~ covered_set yes x ->
  exists i, hole i x.
Proof.
  intros U N. apply union_of_all in U; [|exact parts_polygon]. destruct U as (l & I & B).
  apply in_concat in I. destruct I as (part & I & J). apply In_nth_error in I.
  destruct I as (i & E). exists i. apply (hole_by_cells i part); auto.
  apply union_of_all; [|exists l; auto]. intros k K. apply parts_polygon, in_concat.
  exists part. split; auto. eapply nth_error_In; eauto.
Qed.
Lemma complement_falls x : ~ covered_set yes x -> free x \/ exists i, hole i x.
Proof.
  intros N. destruct (union_decided (all_triangles (concat parts)) x) as [U|U].
  - right. apply cells_in_hole; auto.
  - left. split; auto. intros i H. apply hole_in_cells in H. destruct H as (a & b & c & I & K).
    exact (U a b c I K).
Qed.

(** ** The outside *)
Lemma free_open x : free x -> interior free x.
Proof.
  intros [N H]. destruct (not_covered_near x N) as (e & He & K).
  destruct (union_decided (all_triangles (concat parts)) x) as [U|U].
  - destruct (cells_in_hole x U N) as (i & X). destruct (H i X).
  - destruct (near_outside_all _ x (all_positive _ parts_polygon) U) as (f & Hf & L).
    exists (Rmin e f). split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
    split; [apply K, Y|]. intros i X. apply (L y (proj2 Y)), (hole_in_cells i), X.
Qed.
Lemma far_is_free x : ~ strict box x -> free x.
Proof.
  intros N. split; [intros X; apply N, yes_strict, X|]. intros i X.
  apply N, parts_strict, (hole_in_cells i), X.
Qed.
Lemma outer_in_no l : In l outer -> In l no.
Proof. intros I. apply in_or_app. auto. Qed.
Lemma outer_convex l : In l outer -> is_convex l = true.
Proof. intros I. apply no_convex, outer_in_no, I. Qed.
Lemma outer_is_free x : class no outer x -> free x.
Proof.
  intros [X U]. split; [apply not_covered, X|]. intros i Hx.
  destruct (part_set_open no yes parts no_polygon yes_convex once checked i x Hx)
    as (e & He & K).
  destruct Hx as (part & E & _ & _). destruct U as (a & b & c & I & T).
  assert (Oo : positive (all_triangles outer))
    by (apply all_positive; intros l J; apply no_polygon, outer_in_no, J).
  assert (Op : positive (all_triangles part)).
  { apply all_positive. intros l J. apply parts_polygon, in_concat. exists part.
    split; auto. eapply nth_error_In; eauto. }
  destruct (soon_exists _ (soon_and _ _ (curve_near e x (minus (middle a b c) x) He)
    (curve_inside a b c x (Oo _ _ _ I) T))) as (t & _ & K1 & K2).
  destruct (K _ K1) as (part' & E' & _ & U'). replace part' with part in U' by congruence.
  apply (no_overlap (all_triangles outer) (all_triangles part) Oo Op) with a b c
    (curve x (minus (middle a b c) x) t); auto.
  intros y. pose proof (two_parts (outer :: parts) y no_polygon 0 (S i) outer part (O_S i)
    eq_refl E) as Sum.
  specialize (once y). unfold no in once. simpl in Sum.
  assert (0 <= sumz (crossing_of y) (all_triangles yes))%Z
    by (apply count_positive, yes_polygon). lia.
Qed.
Lemma outer_middle l m : In l outer -> strict l m -> free m.
Proof.
  intros I M. apply outer_is_free. apply (left_in_class no outer outside one_class l); auto.
  - apply strict_left, M.
  - apply (strict_in_interior no outer outside outer_in_no one_class l); auto.
Qed.
Lemma to_middle l x m : In l outer -> left_of l x -> free x -> strict l m -> joined free x m.
Proof.
  intros I L X M. apply joined_step. intros p (t & T & ->).
  destruct (Req_EM_T t 0) as [->|N].
  - replace (fst x + 0 * (fst m - fst x), snd x + 0 * (snd m - snd x)) with x
      by (destruct x; simpl; f_equal; ring). exact X.
  - apply (outer_middle l); auto. apply strict_on_segment; auto; lra.
Qed.
Lemma middles_joined l k m n : In l outer -> In k outer -> strict l m -> strict k n ->
  joined free m n.
Proof.
  intros Il Ik M N. apply (joined_in (class no outer)); [exact outer_is_free|].
  assert (C : forall j p, In j outer -> strict j p -> class no outer p).
  { intros j p I P. apply (left_in_class no outer outside one_class j); auto.
    - apply strict_left, P.
    - apply (strict_in_interior no outer outside outer_in_no one_class j); auto. }
  apply (class_joined no outer outside outer_in_no one_class); eauto.
Qed.
Lemma gate : exists l v, In l outer /\ left_of l v /\ ~ strict box v.
Proof.
  unfold reaches_wall in at_wall. pose proof outer_convex as O.
  destruct outer as [|l r]; [discriminate|]. apply existsb_exists in at_wall.
  destruct at_wall as (v & I & N). exists l, (real v).
  split; [simpl; auto|split; [apply convex_corner; auto; apply O; simpl; auto|]].
  apply is_out_real, N.
Qed.
Lemma free_joined x y : free x -> free y -> joined free x y.
Proof.
  destruct gate as (l & v & I & L & V).
  destruct (convex_has_inside l (outer_convex l I)) as (m & M).
  destruct (rectangle_walls box rectangle) as (x0 & y0 & x1 & y1 & W & H & S & B).
  assert (G : forall z, free z -> joined free z v).
  { intros z Z.
    assert (D : strict box z \/ ~ strict box z).
    { rewrite S. destruct (Rlt_dec x0 (fst z)), (Rlt_dec (fst z) x1), (Rlt_dec y0 (snd z)),
        (Rlt_dec (snd z) y1); tauto. }
    destruct D as [D|D].
    - destruct Z as [N Z']. pose proof (conj N Z' : free z) as Z.
      destruct (box_cells z (strict_left _ _ D)) as [U|U]; [contradiction|].
      apply union_of_all in U; [|exact no_polygon]. destruct U as (k & Ik & U).
      apply in_app_or in Ik. destruct Ik as [Ik|Ik].
      + destruct (convex_has_inside k (outer_convex k Ik)) as (n & Hn).
        assert (Lk : left_of k z).
        { apply convex_union_left; [apply outer_convex, Ik|].
          rewrite <- polygon_body; auto. apply no_polygon, outer_in_no, Ik. }
        apply joined_join with n; [apply (to_middle k); auto|].
        apply joined_join with m; [apply (middles_joined k l); auto|].
        apply joined_back, (to_middle l); auto. apply far_is_free, V.
      + exfalso. destruct (cells_in_hole z) as (i & X); auto; [|exact (Z' i X)].
        apply union_of_all; [exact parts_polygon|]. exists k; auto.
    - rewrite S in D, V. apply (outside_joined x0 y0 x1 y1); auto.
      intros p P. apply far_is_free. rewrite S. exact P. }
  intros X Y. apply joined_join with v; [|apply joined_back]; auto.
Qed.

Theorem complement_has_holes (T : point -> Prop) : (forall x, T x <-> covered_set yes x) ->
  has_holes T (length parts).
Proof.
  intros Same. exists (fun i => match i with O => free | S j => hole j end).
  assert (NS : forall x, ~ T x <-> ~ covered_set yes x) by (intros x; rewrite Same; tauto).
  destruct (rectangle_walls box rectangle) as (x0 & y0 & x1 & y1 & W & H & St & B).
  split; [split|].
  - intros x. rewrite NS. split.
    + intros N. destruct (complement_falls x N) as [X|(i & X)].
      * exists 0%nat. split; [lia|exact X].
      * exists (S i). split; [|exact X]. apply part_number in X. lia.
    + intros ([|i] & _ & X); [apply X|apply (hole_not_covered i), X].
  - intros [|i] I.
    + split; [|split; [exact free_open|split; [exact free_joined|]]].
      * destruct gate as (l & v & _ & _ & V). exists v. apply far_is_free, V.
      * intros [|j] x _ X Y; auto. destruct (proj2 X j Y).
    + assert (I' : (i < length parts)%nat) by lia. split; [|split; [|split]].
      * apply (part_set_not_empty no yes parts); auto; [exact no_polygon|exact whole].
      * exact (part_set_open no yes parts no_polygon yes_convex once checked i).
      * exact (part_set_joined no yes parts no_polygon once whole checked i).
      * intros [|j] x _ X Y; [destruct (proj2 Y i X)|]. f_equal.
        exact (two_part_sets no yes parts no_polygon yes_convex once whole checked i j x X Y).
  - intros [|i] I; split; intros K; try congruence.
    + destruct K as (r & K). exfalso.
      pose proof (Rle_abs r). pose proof (Rle_abs x1). pose proof (Rabs_pos r).
      destruct (K (Rabs r + Rabs x1 + 1, 0)) as [K1 _].
      * apply far_is_free. rewrite St. simpl. lra.
      * simpl in K1. rewrite Rminus_0_r in K1. apply Rabs_def2 in K1.
        pose proof (Rabs_pos x1). lra.
    + exists (Rabs x0 + Rabs x1 + Rabs y0 + Rabs y1 + 1). intros x X.
      apply (hole_in_cells i), parts_strict, St in X. destruct X as [[X0 X1] [Y0 Y1]].
      assert (A : forall u, - Rabs u <= u <= Rabs u).
      { intros u. pose proof (Rle_abs u). pose proof (Rle_abs (- u)).
        rewrite Rabs_Ropp in *. lra. }
      pose proof (A x0). pose proof (A x1). pose proof (A y0). pose proof (A y1).
      split; simpl; rewrite Rminus_0_r; apply Rabs_def1; lra.
Qed.
End Holes.

(** A set without points: its complement has one component. *)
Lemma nothing_has_holes (T : point -> Prop) : (forall x, ~ T x) -> has_holes T 0.
Proof.
  intros N. exists (fun _ _ => True). split; [split|].
  - intros x. split; [intros _; exists 0%nat; split; [lia|auto]|intros _; apply N].
  - intros [|i] I; [|lia]. split; [exists (0, 0); auto|split; [|split]].
    + intros x _. exists 1. split; [lra|auto].
    + intros x y _ _. apply joined_step. auto.
    + intros [|j] x J _ _; [auto|lia].
  - intros [|i] I; [|lia]. split; [|congruence]. intros (r & K).
    pose proof (Rle_abs r). destruct (K (Rabs r, 0) Logic.I) as [K1 _]. simpl in K1.
    rewrite Rminus_0_r, Rabs_Rabsolu in K1. lra.
Qed.

Theorem holes_are_right : forall (s : number) (P Q R : rings corner) (w : witness)
    (cs : list component)
    (outside : component) (hs : list component),
  check_holes s P Q R w cs outside hs = true ->
  is_sum (value s) (outline P) (outline Q) (outline R) /\
    has_components (set_of (outline R)) (length cs) /\ has_holes (set_of (outline R)) (length hs).
Proof.
  intros s P Q R w cs o hs H. unfold check_holes in H. apply andb_prop in H. destruct H as [HC H].
  destruct (components_are_right s P Q R w cs HC) as [IS CO]. split; [auto|split; [auto|]].
  assert (HS : check_sum s P Q R w = true)
    by (unfold check_components in HC; apply andb_prop in HC; tauto).
  destruct (is_empty P || is_empty Q) eqn:Em.
  - destruct hs; [|discriminate]. rewrite (empty_sum s P Q R w Em HS).
    apply nothing_has_holes, empty_set.
  - destruct (sum_parts s P Q R w Em HS) as (OC & HB & Same).
    destruct (component_parts s P Q R w cs Em HC) as (HR & HN & Whole & _ & Chk).
    change (map fst (filter covered (cells w))) with (covered_cells w) in H.
    change (map fst (filter (fun c => negb (covered c)) (cells w))) with (other_cells w) in H.
    apply andb_prop in H. destruct H as [HL H]. apply split_by_whole in HL.
    destruct (split_by (map size (o :: hs)) (other_cells w)) as [|first holes] eqn:E;
      [discriminate|].
    rewrite !andb_true_iff in H. destruct H as [[[H1 H2] H3] H4]. simpl in HL.
    rewrite <- (all2_length _ _ _ H3).
    assert (YC : forall l, In l (covered_cells w) -> is_convex l = true).
    { intros l I. rewrite <- Whole in I. apply in_concat in I. destruct I as (part & I & J).
      apply In_nth_error in I. destruct I as (i & Ei). destruct (Chk i part Ei) as (c & Hc).
      apply andb_prop in Hc. apply (class_convex part c); tauto. }
    apply (complement_has_holes (box w) (covered_cells w) first holes) with (outside := o);
      unfold no; rewrite ?HL; auto.
    + intros x L. unfold check_box in HB. rewrite !andb_true_iff in HB.
      destruct (box_in_cells w) with (x := x) as (c & I & B); [tauto|exact OC|exact L|].
      unfold covered_set. destruct (covered c) eqn:Ec; [left|right].
      * apply union_of_all; [intros l; apply (covered_are_polygons w OC)|].
        exists (fst c). split; auto. apply in_map, filter_In. auto.
      * apply union_of_all; [intros l J; apply convex_polygon, HN, J|].
        exists (fst c). split; auto. apply in_map. apply filter_In. rewrite Ec. auto.
    + intros y. pose proof (cells_once w HB HR y). lia.
    + intros i part Ei. eapply all2_nth; eauto.
    + intros l v I J. rewrite forallb_forall in H4. specialize (H4 l I).
      rewrite forallb_forall in H4. apply strictly_in_real, H4, J.
Qed.
End Here.
