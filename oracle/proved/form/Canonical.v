(** The canonical form of a sum: [form_is_right]. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Numbers
  Rational Values Figures Corners Cancellation Bodies Scaling Trees Theorems Components Classes
  Counting Holes Across Sides Overlaps Differing.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** ** Lists *)
Lemma all3_nth {A B C} (f : A -> B -> C -> bool) l : forall k m i y, all3 f l k m = true ->
  nth_error k i = Some y -> exists x z, nth_error l i = Some x /\ f x y z = true.
Proof.
  induction l as [|a l IH]; intros [|b k] [|c m] [|i] y H E; try discriminate; simpl in H, E;
    apply andb_prop in H.
  - injection E; intros <-. exists a, c. split; [reflexivity|tauto].
  - destruct (IH k m i y) as (x & z & X & Z); [tauto|exact E|]. exists x, z. auto.
Qed.
Lemma all3_length {A B C} (f : A -> B -> C -> bool) l : forall k m, all3 f l k m = true ->
  length l = length k.
Proof.
  induction l as [|a l IH]; intros [|b k] [|c m] H; try discriminate; auto.
  simpl in *. apply andb_prop in H. f_equal. apply (IH k m), H.
Qed.
Lemma ordered_pairs {A} (R : A -> A -> Prop) l :
  (forall a x b y c, l = a ++ x :: b ++ y :: c -> R x y) -> ForallOrdPairs R l.
Proof.
  induction l as [|x l IH]; intros H; [apply FOP_nil|]. apply FOP_cons.
  - apply Forall_forall. intros y I. apply in_split in I. destruct I as (b & c & ->).
    apply (H [] x b y c). reflexivity.
  - apply IH. intros a y b z c ->. apply (H (x :: a) y b z c). reflexivity.
Qed.
Lemma pairs_of_part {A} (R : A -> A -> Prop) a l c : ForallOrdPairs R (a ++ l ++ c) ->
  ForallOrdPairs R l.
Proof.
  intros H. assert (G : ForallOrdPairs R (l ++ c)).
  { induction a as [|x a IH]; simpl in H; auto. inversion H; auto. }
  clear H. induction l as [|x l IH]; [apply FOP_nil|]. simpl in G.
  inversion G as [|y k F K]; subst. apply FOP_cons; auto. apply Forall_app in F. tauto.
Qed.
Lemma rings_closed (rs : list (list point)) : Permutation (map fst (flat_map ring_edges rs))
  (map snd (flat_map ring_edges rs)).
Proof.
  induction rs as [|l rs IH]; simpl; auto. rewrite !map_app.
  apply Permutation_app; auto. apply ring_closed.
Qed.
Lemma real_edges_flat r : real_edges r = flat_map ring_edges (map (map real) r).
Proof. reflexivity. Qed.

Lemma area_real ring : value (qarea ring) = area (map real ring).
Proof.
  unfold qarea, area. rewrite ring_edges_map. induction (ring_edges ring) as [|[a b] E IH].
  - apply value_zero.
  - cbn [fold_right map both fst snd].
    rewrite value_reduced, value_plus, value_minus, !value_times, IH.
    reflexivity.
Qed.

Section Polygons.
Variable yes no : list (list corner).
Variable part : list (list corner).
Variable c : component.
Hypothesis yes_polygons : forall l, In l yes -> is_polygon l = true.
Hypothesis no_convex : forall l, In l no -> is_convex l = true.
Hypothesis once : forall y, (sumz (crossing_of y) (all_triangles no)
  + sumz (crossing_of y) (all_triangles yes) <= 1)%Z.
Hypothesis part_in_yes : forall l, In l part -> In l yes.
Hypothesis one_class : is_class part c = true.

Definition row_of (e : point * point) (l : list point) : Prop :=
  row (class yes part) (covered_set yes) (fst e) (snd e) (fst e) l.
Lemma ring_rows ring stretches : check_ring part no ring stretches = true -> exists lists,
  Forall2 row_of (ring_edges (map real ring)) lists /\ NoDup (concat lists) /\
  concat lists = map real (ends stretches).
Proof.
  unfold check_ring. rewrite !andb_true_iff. intros [[_ H] N].
  assert (Ends : concat (map (fun l : list stretch => map real (map snd l)) stretches)
    = map real (ends stretches)).
  { unfold ends. rewrite map_map, concat_map. f_equal. apply map_ext. intros l.
    rewrite map_map. reflexivity. }
  exists (map (fun l : list stretch => map real (map snd l)) stretches).
  split; [|split; [rewrite Ends; apply all_differ_real, N|exact Ends]].
  - clear Ends. rewrite ring_edges_map. revert stretches H N.
    induction (ring_edges ring) as [|[a b] E IH];
      intros [|l stretches] H N; try discriminate; [apply Forall2_nil|].
    simpl in H. apply andb_prop in H. destruct H as [H1 H2]. cbn [map]. apply Forall2_cons.
    + unfold row_of, both. cbn [fst snd].
      apply (check_row yes no yes_polygons no_convex once part c part_in_yes one_class); auto.
      apply orient_start.
    + clear N. revert stretches H2. clear - yes_polygons no_convex once part_in_yes one_class.
      induction E as [|[a b] E IH]; intros [|l stretches] H; try discriminate; [apply Forall2_nil|].
      simpl in H. apply andb_prop in H. destruct H as [H1 H2]. cbn [map]. apply Forall2_cons; auto.
      unfold row_of, both. cbn [fst snd].
      apply (check_row yes no yes_polygons no_convex once part c part_in_yes one_class); auto.
      apply orient_start.
Qed.
Lemma rows_weaken es ls : Forall2 row_of es ls -> Forall2 (is_row (covered_set yes)) es ls.
Proof.
  induction 1 as [|e l es ls R F IH]; [apply Forall2_nil|]. apply Forall2_cons; auto.
  apply (row_weaken (class yes part)); auto. intros x [X _]. apply interior_in, X.
Qed.
Lemma ring_is_ring ring stretches : check_ring part no ring stretches = true ->
  (forall e, In e (ring_edges (map real ring)) -> fst e <> snd e) ->
  ForallOrdPairs apart (ring_edges (map real ring)) -> is_ring (map real ring).
Proof.
  intros H D A. destruct (ring_rows ring stretches H) as (lists & F & N & _).
  unfold check_ring in H. rewrite !andb_true_iff in H. destruct H as [[H2 _] _]. split.
  - apply (rows_apart (covered_set yes)) with (lists := lists); auto.
    apply rows_weaken, F.
  - intros e f I. rewrite !ring_edges_map in I. apply in_map_iff in I.
    destruct I as ([[a b] [b' d]] & E & I). unfold both in E. cbn [fst snd] in E.
    injection E; intros <- <-. cbn [fst snd]. rewrite forallb_forall in H2. specialize (H2 _ I).
    apply differ_value in H2. rewrite real_orient, value_zero in H2. auto.
Qed.
Lemma row_divides (C T : point -> Prop) e l : (forall x, class yes part x -> C x) ->
  (forall x, T x -> covered_set yes x) -> row_of e l -> divides C T e.
Proof.
  intros HC HT R. exists (fst e :: l). intros x X.
  destruct (row_cover _ _ _ _ _ _ R (orient_start _ _) x X) as [->|(p & v & I & P & _ & _ & Q)];
    [simpl; auto|].
  destruct Q as [->|[Q _]]; [left; simpl; auto|right].
  destruct P as (_ & _ & P). destruct (P x Q) as (r & Hr & K). exists r. split; auto.
  intros y Y. destruct (K y Y) as [K1 K2]. split; [auto|]. intros O X'. apply (K2 O), HT, X'.
Qed.
Lemma row_found e edges lists : Forall2 row_of edges lists -> In e edges -> exists l, row_of e l.
Proof. induction 1; intros []; subst; eauto. Qed.
End Polygons.

(** ** What is found of a figure *)
Definition real_polygons (ps : list (polygon corner)) : list (polygon point) :=
  each_vertex real ps.
Lemma real_each {A} (place : A -> corner) ps :
  real_polygons (each_vertex place ps) = each_vertex (fun v => real (place v)) ps.
Proof.
  unfold real_polygons, each_vertex. rewrite map_map. apply map_ext. intros [o h].
  cbn [fst snd]. apply f_equal2; [rewrite map_map; reflexivity|].
  rewrite map_map. apply map_ext. intros l. rewrite map_map. reflexivity.
Qed.
Lemma outline_of ps : outline (rings_of ps) = rings_of (real_polygons ps).
Proof.
  unfold outline, rings_of, real_polygons, each_vertex.
  rewrite !flat_map_concat_map, concat_map, !map_map.
  reflexivity.
Qed.
Lemma real_polygon_at ps : forall i outer holes,
  nth_error (real_polygons ps) i = Some (outer, holes) -> exists o h,
  nth_error ps i = Some (o, h) /\ outer = map real o /\ holes = map (map real) h.
Proof.
  induction ps as [|[o h] ps IH]; intros [|i] outer holes E; try discriminate E; simpl in *.
  - injection E; intros <- <-. exists o, h. auto.
  - apply IH, E.
Qed.
Lemma result_turns s P Q R w : is_empty P || is_empty Q = false -> check_sum s P Q R w = true ->
  thin R = false /\ (forall e, In e (real_edges R) -> fst e <> snd e) /\
  forall y, winding (real_edges R) y = sumz (crossing_of y) (all_triangles (covered_cells w)).
Proof.
  intros Em H. unfold check_sum in H. rewrite Em, !andb_true_iff in H.
  destruct H as [[[_ TR] NR] BR]. apply negb_true_iff in TR. split; auto.
  rewrite real_edges_of. split.
  - intros [a b] I. apply (no_null_different _ NR a b I).
  - intros y. rewrite <- turns_of_polygons. apply (same_boundary_same_turns _ _ BR).
Qed.

Section Figure.
Variable s : number.
Variables P Q : rings corner.
Variable ps : list (polygon corner).
Variable d : derivation.
Hypothesis checked : check_figure s P Q ps d = true.
Hypothesis not_empty : is_empty P || is_empty Q = false.
Let w := region_of d.
Let cs := components_of d.
Let R := rings_of ps.
Let yes := covered_cells w.
Let no := other_cells w.

Lemma figure_holes : check_holes s P Q R w cs (outside_of d) (holes_of d) = true.
Proof. unfold check_figure in checked. apply andb_prop in checked. apply checked. Qed.
Lemma figure_components : check_components s P Q R w cs = true.
Proof. pose proof figure_holes as H. unfold check_holes in H. apply andb_prop in H. apply H. Qed.
Lemma figure_sum : check_sum s P Q R w = true.
Proof.
  pose proof figure_components as H. unfold check_components in H. apply andb_prop in H. apply H.
Qed.
Lemma figure_polygons : all3 (check_polygon no) (parts_of w cs) ps (rows_of d) = true.
Proof.
  unfold check_figure in checked. apply andb_prop in checked. destruct checked as [_ H].
  rewrite not_empty in H. exact H.
Qed.
Lemma figure_yes l : In l yes -> is_polygon l = true.
Proof.
  destruct (sum_parts s P Q R w not_empty figure_sum) as (OC & _ & _).
  apply (covered_are_polygons w OC).
Qed.
Lemma figure_no l : In l no -> is_convex l = true.
Proof.
  destruct (component_parts s P Q R w cs not_empty figure_components) as (_ & HN & _). apply HN.
Qed.
Lemma figure_once y : (sumz (crossing_of y) (all_triangles no)
  + sumz (crossing_of y) (all_triangles yes) <= 1)%Z.
Proof.
  destruct (sum_parts s P Q R w not_empty figure_sum) as (_ & HB & _).
  destruct (component_parts s P Q R w cs not_empty figure_components) as (HR & _).
  apply (cells_once w HB HR).
Qed.
Lemma figure_class i part : nth_error (parts_of w cs) i = Some part ->
  (exists c, is_class part c = true) /\ forall l, In l part -> In l yes.
Proof.
  intros E.
  destruct (component_parts s P Q R w cs not_empty figure_components) as (_ & _ & W & _ & Chk).
  destruct (Chk i part E) as (c & Hc). unfold check_component in Hc. apply andb_prop in Hc.
  split; [exists c; tauto|]. intros l I.
  assert (V : exists rest, yes = rest ++ concat (parts_of w cs)) by (exists []; symmetry; exact W).
  exact (part_in_yes yes no (parts_of w cs) figure_yes figure_once V i part E l I).
Qed.
Lemma figure_polygon i outer holes : nth_error ps i = Some (outer, holes) ->
  exists part k, nth_error (parts_of w cs) i = Some part /\
    check_polygon no part (outer, holes) k = true.
Proof.
  intros E. destruct (all3_nth _ _ _ _ _ _ figure_polygons E) as (part & k & Ep & Hk).
  exists part, k. auto.
Qed.
Lemma figure_ring i outer holes ring : nth_error ps i = Some (outer, holes) ->
  In ring (outer :: holes) -> exists part k lists, nth_error (parts_of w cs) i = Some part /\
    check_ring part no ring k = true /\
    Forall2 (row_of yes part) (ring_edges (map real ring)) lists.
Proof.
  intros E I. destruct (figure_polygon i outer holes E) as (part & k & Ep & Hk).
  destruct (figure_class i part Ep) as ((c & Hc) & Sub).
  unfold check_polygon in Hk. rewrite !andb_true_iff in Hk. destruct Hk as [_ Hk].
  destruct (all2_partner _ _ _ Hk ring I) as (kr & Hr).
  destruct (ring_rows yes no part c figure_yes figure_no figure_once Sub Hc ring kr Hr)
    as (lists & F & _).
  exists part, kr, lists. auto.
Qed.
Lemma figure_null e : In e (real_edges R) -> fst e <> snd e.
Proof. destruct (result_turns s P Q R w not_empty figure_sum) as (_ & NN & _). apply NN. Qed.
Lemma figure_apart : ForallOrdPairs apart (real_edges R).
Proof.
  destruct (result_turns s P Q R w not_empty figure_sum) as (TR & NN & Turns).
  assert (Edge : forall e, In e (real_edges R) -> exists i outer holes ring,
    nth_error ps i = Some (outer, holes) /\ In ring (outer :: holes) /\
    In e (ring_edges (map real ring))).
  { intros e I. rewrite real_edges_flat in I. apply in_flat_map in I. destruct I as (r & I & J).
    apply in_map_iff in I. destruct I as (ring & <- & I).
    unfold R, rings_of in I. apply in_flat_map in I. destruct I as ([outer holes] & I & K).
    apply In_nth_error in I. destruct I as (i & E). exists i, outer, holes, ring. auto. }
  assert (Rows : forall e, In e (real_edges R) -> exists l, is_row (covered_set yes) e l).
  { intros e I. destruct (Edge e I) as (i & outer & holes & ring & E & J & K).
    destruct (figure_ring i outer holes ring E J) as (part & k & lists & _ & _ & F).
    destruct (row_found yes part e _ _ F K) as (l & L). exists l.
    apply (row_weaken (class yes part)); auto. intros x [X _]. apply interior_in, X. }
  assert (Closed : Permutation (map fst (real_edges R)) (map snd (real_edges R)))
    by (rewrite real_edges_flat; apply rings_closed).
  assert (Bounds : forall y, (0 <= winding (real_edges R) y <= 1)%Z).
  { intros y. rewrite Turns. fold yes. pose proof (count_positive yes y figure_yes).
    assert (0 <= sumz (crossing_of y) (all_triangles no))%Z
      by (apply count_positive; intros l I; apply convex_polygon, figure_no, I).
    pose proof (figure_once y). lia. }
  apply ordered_pairs. intros a e b f k E.
  exact (edges_apart (covered_set yes) (real_edges R) Closed Rows NN Bounds a e b f k E).
Qed.

Lemma figure_form : is_form (set_of (outline R)) (real_polygons ps).
Proof.
  pose proof (parts_fall s P Q R w cs not_empty figure_components) as Fall.
  destruct (sum_parts s P Q R w not_empty figure_sum) as (OC & HB & Same).
  destruct (component_parts s P Q R w cs not_empty figure_components) as (_ & _ & _ & Len & _).
  destruct (result_turns s P Q R w not_empty figure_sum) as (TR & NN & Turns).
  exists (part_set yes (parts_of w cs)).
  replace (length (real_polygons ps)) with (length ps) by (symmetry; apply map_length).
  rewrite <- (all3_length _ _ _ _ figure_polygons), Len.
  rewrite <- outline_of. change (all_edges (outline (rings_of ps))) with (real_edges R).
  split; [exact Fall|split; [|split; [exact figure_apart|]]].
  - intros x X Off. rewrite (set_of_fat R x TR) in X.
    assert (Near := Off). rewrite real_edges_flat in Near.
    destruct (rings_near _ x Near) as (e & He & K). rewrite <- real_edges_flat in K.
    destruct (X e He) as (y & Y & _ & Wy). exists e. split; auto. intros z Z.
    apply Same. apply counted_union; [apply all_positive, figure_yes|].
    fold yes. rewrite <- Turns, (K z Z), <- (K y Y). lia.
  - intros i outer' holes' E'.
    destruct (real_polygon_at ps i outer' holes' E') as (outer & holes & E & -> & ->).
    destruct (figure_polygon i outer holes E) as (? & k & _ & Hk).
    unfold check_polygon in Hk. rewrite !andb_true_iff in Hk. cbn [fst snd] in Hk.
    destruct Hk as [[A1 A2] _]. split; [|split].
    + rewrite <- area_real, <- value_zero. apply lt_value, A1.
    + intros hole' I'. apply in_map_iff in I'. destruct I' as (hole & <- & I).
      rewrite forallb_forall in A2. specialize (A2 hole I).
      rewrite <- area_real, <- value_zero. apply lt_value, A2.
    + intros ring' I'.
      assert (I : exists ring, ring' = map real ring /\ In ring (outer :: holes)).
      { destruct I' as [<-|I']; [exists outer; simpl; auto|]. apply in_map_iff in I'.
        destruct I' as (hole & <- & I). exists hole. simpl; auto. }
      destruct I as (ring & -> & I).
      destruct (figure_ring i outer holes ring E I) as (part & k' & lists & Ep & Hr & F).
      destruct (figure_class i part Ep) as ((c & Hc) & Sub).
      assert (J : exists a b, real_edges R = a ++ ring_edges (map real ring) ++ b).
      { assert (K : In ring R).
        { unfold R, rings_of. apply in_flat_map. exists (outer, holes).
          split; [eapply nth_error_In; eauto|exact I]. }
        apply in_split in K. destruct K as (r1 & r2 & ->).
        rewrite real_edges_flat, map_app, flat_map_app. simpl. eauto. }
      destruct J as (a & b & J). split.
      { apply (ring_is_ring yes no part c figure_yes figure_no figure_once Sub Hc ring k' Hr).
        - intros e L. apply NN. rewrite J. apply in_or_app. right. apply in_or_app. auto.
        - pose proof figure_apart as Ap. rewrite J in Ap. apply pairs_of_part in Ap. exact Ap. }
      intros e L. destruct (row_found yes part e _ _ F L) as (l & Rl).
      apply (row_divides yes part) with (l := l); auto.
      { intros y Y. exists part. auto. }
      { intros y Y. apply Same, Y. }
Qed.
End Figure.

Theorem figure_is_right : forall (s : number) (P Q : rings corner) (ps : list (polygon corner))
    (d : derivation), check_figure s P Q ps d = true ->
  is_sum (value s) (outline P) (outline Q) (rings_of (real_polygons ps)) /\
  has_components (set_of (rings_of (real_polygons ps))) (length ps) /\
  has_holes (set_of (rings_of (real_polygons ps))) (length (holes_of d)) /\
  is_form (set_of (rings_of (real_polygons ps))) (real_polygons ps).
Proof.
  intros s P Q ps d H. rewrite <- outline_of.
  pose proof (figure_holes s P Q ps d H) as HH.
  destruct (holes_are_right _ _ _ _ _ _ _ _ HH) as (IS & _ & HO).
  assert (G : is_form (set_of (outline (rings_of ps))) (real_polygons ps)).
  2: { split; [exact IS|split; [|split; [exact HO|exact G]]]. destruct G as (C & F & _).
       unfold real_polygons, each_vertex in F. rewrite map_length in F. exists C. exact F. }
  destruct (is_empty P || is_empty Q) eqn:Em; [|apply (figure_form s P Q ps d H Em)].
  pose proof (empty_sum s P Q _ _ Em (figure_sum s P Q ps d H)) as Z.
  destruct ps as [|p ps]; [|discriminate].
  exists (fun _ _ => False). split; [apply nothing_falls, empty_set|]. simpl.
  split; [intros x X; destruct (empty_set x X)|].
  split; [apply FOP_nil|intros [|i] ? ? E; discriminate].
Qed.

(** ** Order *)
Lemma order_is_right ps : check_order ps = true -> in_order (real_polygons ps).
Proof.
  unfold check_order. rewrite !andb_true_iff, !forallb_forall. intros [[H1 H2] H3]. repeat split.
  - intros r I. rewrite <- outline_of in I. apply in_map_iff in I. destruct I as (ring & <- & I).
    specialize (H1 ring I). destruct ring as [|first rest]; [discriminate|]. simpl in *.
    intros p J. apply in_map_iff in J. destruct J as (v & <- & J).
    rewrite forallb_forall in H1. apply qbefore_real, H1, J.
  - intros p I. apply in_map_iff in I. destruct I as (q & <- & I).
    apply (ascends_sorted _ _ _ qring_before_real (snd q) (H2 q I)).
  - unfold real_polygons, each_vertex. rewrite map_map. cbn [fst].
    rewrite <- (map_map fst (map real)).
    apply (ascends_sorted _ _ _ qring_before_real _ H3).
Qed.
End Here.

(** ** The theorem *)
#[local] Instance anywhere : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.
Lemma polygons_fixed ps : real_polygons (fixed_polygons ps) = figure ps.
Proof. apply real_each. Qed.

Theorem form_is_right : forall (s : Q) (P Q : rings vertex) (ps : list (polygon vertex))
    (d : derivation), check_form s P Q ps d = true ->
  is_sum (Q2R s) (points P) (points Q) (rings_of (figure ps)) /\
  has_components (set_of (rings_of (figure ps))) (length ps) /\
  has_holes (set_of (rings_of (figure ps))) (length (holes_of d)) /\
  is_canonical (set_of (rings_of (figure ps))) (figure ps).
Proof.
  intros s P Q ps d H. unfold check_form in H. apply andb_prop in H. destruct H as [H O].
  apply figure_is_right in H. apply order_is_right in O.
  rewrite !outline_fixed, !polygons_fixed in *. destruct H as (IS & CO & HO & FO).
  unfold fixed_polygons, each_vertex in CO. rewrite map_length in CO.
  split; [exact IS|split; [exact CO|split; [exact HO|split; [exact FO|exact O]]]].
Qed.
Theorem one_point_is_right : forall (s : Q) (P Q : rings vertex) (x p q : vertex)
    (of_P of_Q : tiled) (i j : nat), check_one_point s P Q x p q of_P of_Q i j = true ->
  set_of (points P) (point_of p) /\ set_of (points Q) (point_of q) /\
  point_of x = add (scale (Q2R s) (point_of p)) (point_of q).
Proof.
  intros s P Q x p q oP oQ i j H. apply point_is_right in H.
  rewrite !outline_fixed in H. exact H.
Qed.
