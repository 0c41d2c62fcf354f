(** The canonical form of a sum: [form_is_right]. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Checker Rational
  Cancellation Bodies Scaling Trees Theorems Components Classes Counting Holes Across Sides
  Overlaps.
Open Scope R_scope.

(** ** Order *)
Lemma qbefore_real p q : qbefore p q = true -> before (real p) (real q).
Proof.
  unfold qbefore, before. rewrite orb_true_iff, andb_true_iff. intros [H|[H1 H2]].
  - left. apply less_real in H. exact H.
  - right. split; [apply eq_real, H1|apply less_real, H2].
Qed.
Lemma qring_before_real l : forall k, qring_before l k = true ->
  ring_before (map real l) (map real k).
Proof.
  induction l as [|p l IH]; intros [|q k] H; try discriminate; simpl; auto.
  simpl in H. apply orb_prop in H. destruct H as [H|H]; [left; apply qbefore_real, H|right].
  apply andb_prop in H. split; [apply same_real; tauto|apply IH; tauto].
Qed.
Lemma ascends_sorted {A B} (f : A -> A -> bool) (g : A -> B) (R : B -> B -> Prop) :
  (forall x y, f x y = true -> R (g x) (g y)) -> forall l, ascends f l = true ->
  Sorted R (map g l).
Proof.
  intros H. induction l as [|x l IH]; simpl; intros K; [apply Sorted_nil|].
  apply andb_prop in K. destruct K as [K1 K2]. apply Sorted_cons; auto.
  destruct l as [|y l]; simpl; [apply HdRel_nil|apply HdRel_cons, H, K1].
Qed.
Lemma before_transitive p q r : before p q -> before q r -> before p r.
Proof. unfold before. lra. Qed.
Lemma ascending_differ l : Sorted before l -> NoDup l.
Proof.
  intros H. apply Sorted_StronglySorted in H; [|exact before_transitive].
  induction H as [|p l H IH F]; [apply NoDup_nil|]. apply NoDup_cons; auto.
  intros I. rewrite Forall_forall in F. specialize (F p I). unfold before in F. lra.
Qed.
Lemma sorted_differ l : ascends qbefore (VertexSort.sort l) = true -> NoDup (map real l).
Proof.
  intros H. apply (ascends_sorted _ real before qbefore_real) in H.
  apply ascending_differ in H. eapply Permutation_NoDup; [|exact H].
  apply Permutation_map, Permutation_sym, VertexSort.Permuted_sort.
Qed.

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
Proof. unfold real_edges. rewrite !flat_map_concat_map, map_map. reflexivity. Qed.

Lemma area_real ring : Q2R (qarea ring) = area (map real ring).
Proof.
  unfold qarea, area. rewrite ring_edges_map. induction (ring_edges ring) as [|[a b] E IH].
  - apply Q2R_zero.
  - cbn [fold_right map both fst snd]. rewrite Q2R_red, Q2R_plus, Q2R_minus, !Q2R_mult, IH.
    reflexivity.
Qed.

(** ** Rings *)
Section Rings.
Variable S : point -> Prop.
Lemma rows_apart edges : forall lists, Forall2 (is_row S) edges lists -> NoDup (concat lists) ->
  (forall e, In e edges -> fst e <> snd e) -> ForallOrdPairs apart edges ->
  ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False) edges.
Proof.
  induction edges as [|e edges IH]; intros lists F N D A; [apply FOP_nil|].
  inversion F as [|? l ? rest Re Rest]; subst. simpl in N.
  inversion A as [|? ? Ae Ar]; subst.
  assert (Nr : NoDup (concat rest)).
  { clear - N. induction l as [|v l IH]; simpl in N; auto. inversion N; auto. }
  assert (Nl : forall v, In v l -> ~ In v (concat rest)).
  { clear - N. induction l as [|u l IH]; simpl in N |- *; [tauto|].
    inversion N as [|? ? N1 N2]; subst. intros v [<-|I] J.
    - apply N1, in_or_app. auto.
    - exact (IH N2 v I J). }
  apply FOP_cons.
  - apply Forall_forall. intros f I x Xe Xf. rewrite Forall_forall in Ae.
    assert (G : exists k, is_row S f k /\ forall v, In v k -> In v (concat rest)).
    { clear - Rest I. induction Rest as [|g k gs ks R Rest IH]; [destruct I|].
      destruct I as [<-|I].
      - exists k. split; auto. intros v J. simpl. apply in_or_app. auto.
      - destruct (IH I) as (k' & K1 & K2). exists k'. split; auto.
        intros v J. simpl. apply in_or_app. auto. }
    destruct G as (k & Rf & Sub).
    apply (beyond_apart S e f l k) with (x := x); auto.
    + apply D; simpl; auto.
    + apply D; simpl; auto.
    + intros v I1 I2. apply (Nl v I1), Sub, I2.
  - apply (IH rest); auto. intros f I. apply D. simpl; auto.
Qed.
End Rings.

Section Polygons.
Variable yes no : list (list vertex).
Variable part : list (list vertex).
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
  Forall2 row_of (ring_edges (map real ring)) lists /\ NoDup (concat lists).
Proof.
  unfold check_ring. rewrite !andb_true_iff. intros [[_ H] N].
  exists (map (fun l : list stretch => map real (map snd l)) stretches). split.
  - rewrite ring_edges_map. revert stretches H N. induction (ring_edges ring) as [|[a b] E IH];
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
  - apply sorted_differ in N. unfold ends in N.
    replace (concat (map (fun l : list stretch => map real (map snd l)) stretches))
      with (map real (map snd (concat stretches))); auto.
    rewrite map_map, concat_map. f_equal. apply map_ext. intros l. rewrite map_map. reflexivity.
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
  intros H D A. destruct (ring_rows ring stretches H) as (lists & F & N).
  unfold check_ring in H. rewrite !andb_true_iff in H. destruct H as [[[H1 H2] _] _].
  split; [|split].
  - destruct ring as [|first rest]; [discriminate|]. simpl. intros p I.
    apply in_map_iff in I. destruct I as (v & <- & I). rewrite forallb_forall in H1.
    apply qbefore_real, H1, I.
  - apply (rows_apart (covered_set yes)) with (lists := lists); auto.
    apply rows_weaken, F.
  - intros e f I. rewrite !ring_edges_map in I. apply in_map_iff in I.
    destruct I as ([[a b] [b' d]] & E & I). unfold both in E. cbn [fst snd] in E.
    injection E; intros <- <-. cbn [fst snd]. rewrite forallb_forall in H2. specialize (H2 _ I).
    apply negb_true_iff in H2. intros Z. rewrite <- real_orient, <- Q2R_zero in Z.
    apply eqR_Qeq, Qeq_bool_iff in Z. congruence.
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

(** ** The theorem *)
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

Theorem form_is_right : forall (s : Q) (P Q : rings) (ps : list polygon) (w : witness)
    (cs : list component) (outside : component) (hs : list component)
    (stretches : list (list (list (list stretch)))),
  check_form s P Q ps w cs outside hs stretches = true ->
  is_sum s P Q (rings_of ps) /\ has_components (set_of (rings_of ps)) (length ps) /\
  has_holes (set_of (rings_of ps)) (length hs) /\ is_canonical (set_of (rings_of ps)) ps.
Proof.
  intros s P Q ps w cs o hs stretches H. unfold check_form in H. apply andb_prop in H.
  destruct H as [HH H]. destruct (holes_are_right _ _ _ _ _ _ _ _ HH) as (IS & _ & HO).
  assert (HC : check_components s P Q (rings_of ps) w cs = true)
    by (unfold check_holes in HH; apply andb_prop in HH; tauto).
  assert (HS : check_sum s P Q (rings_of ps) w = true)
    by (unfold check_components in HC; apply andb_prop in HC; tauto).
  assert (G : is_canonical (set_of (rings_of ps)) ps).
  2: { split; [exact IS|split; [|split; [exact HO|exact G]]]. destruct G as (C & F & _).
       exists C. exact F. }
  destruct (is_empty P || is_empty Q) eqn:Em.
  - pose proof (empty_sum s P Q _ w Em HS) as Z. destruct ps as [|p ps]; [|discriminate].
    exists (fun _ _ => False). split; [apply nothing_falls, empty_set|]. simpl.
    split; [intros x X; destruct (empty_set x X)|].
    split; [apply FOP_nil|split; [intros [|i] ? ? E; discriminate|apply Sorted_nil]].
  - pose proof (parts_fall s P Q _ w cs Em HC) as Fall.
    destruct (sum_parts s P Q _ w Em HS) as (OC & HB & Same).
    destruct (component_parts s P Q _ w cs Em HC) as (HR & HN & Whole & Len & Chk).
    destruct (result_turns s P Q _ w Em HS) as (TR & NN & Turns).
    apply andb_prop in H. destruct H as [H3 HA].
    change (map fst (filter covered (cells w))) with (covered_cells w) in H3.
    change (map fst (filter (fun c => negb (covered c)) (cells w))) with (other_cells w) in H3.
    change (split_by (map size cs) (covered_cells w)) with (parts_of w cs) in H3.
    set (yes := covered_cells w) in *. set (no := other_cells w) in *.
    set (R := rings_of ps) in *.
    assert (Yes : forall l, In l yes -> is_polygon l = true)
      by (intros l; apply (covered_are_polygons w OC)).
    pose proof (cells_once w HB HR) as Once. fold yes no in Once.
    assert (W : exists rest, yes = rest ++ concat (parts_of w cs)) by (exists []; auto).
    (* each ring of a polygon, by its class *)
    assert (Poly : forall i outer holes, nth_error ps i = Some (outer, holes) ->
      exists part c, nth_error (parts_of w cs) i = Some part /\ is_class part c = true /\
        (forall l, In l part -> In l yes) /\
        exists k, check_polygon no part (outer, holes) k = true).
    { intros i outer holes E. destruct (all3_nth _ _ _ _ _ _ H3 E) as (part & k & Ep & Hk).
      destruct (Chk i part Ep) as (c & Hc). unfold check_component in Hc. apply andb_prop in Hc.
      exists part, c. split; auto. split; [tauto|]. split; [|exists k; exact Hk].
      intros l I. eapply part_in_yes; eauto. }
    assert (Ring : forall i outer holes ring, nth_error ps i = Some (outer, holes) ->
      In ring (outer :: holes) -> exists part c lists,
        nth_error (parts_of w cs) i = Some part /\ is_class part c = true /\
        (forall l, In l part -> In l yes) /\
        (exists k, check_ring part no ring k = true) /\
        Forall2 (row_of yes part) (ring_edges (map real ring)) lists).
    { intros i outer holes ring E I.
      destruct (Poly i outer holes E) as (part & c & Ep & Hc & Sub & k & Hk).
      unfold check_polygon in Hk. rewrite !andb_true_iff in Hk. destruct Hk as [_ Hk].
      destruct (all2_partner _ _ _ Hk ring I) as (kr & Hr).
      destruct (ring_rows yes no part c Yes HN Once Sub Hc ring kr Hr) as (lists & F & _).
      exists part, c, lists. repeat (split; auto). exists kr. exact Hr. }
    assert (Edge : forall e, In e (real_edges R) -> exists i outer holes ring,
      nth_error ps i = Some (outer, holes) /\ In ring (outer :: holes) /\
      In e (ring_edges (map real ring))).
    { intros e I. unfold real_edges in I. apply in_flat_map in I. destruct I as (ring & I & J).
      unfold R, rings_of in I. apply in_flat_map in I. destruct I as ([outer holes] & I & K).
      apply In_nth_error in I. destruct I as (i & E). exists i, outer, holes, ring. auto. }
    assert (Rows : forall e, In e (real_edges R) -> exists l, is_row (covered_set yes) e l).
    { intros e I. destruct (Edge e I) as (i & outer & holes & ring & E & J & K).
      destruct (Ring i outer holes ring E J) as (part & c & lists & _ & _ & _ & _ & F).
      destruct (row_found yes part e _ _ F K) as (l & L). exists l.
      apply (row_weaken (class yes part)); auto. intros x [X _]. apply interior_in, X. }
    assert (Closed : Permutation (map fst (real_edges R)) (map snd (real_edges R)))
      by (rewrite real_edges_flat; apply rings_closed).
    assert (Bounds : forall y, (0 <= winding (real_edges R) y <= 1)%Z).
    { intros y. rewrite Turns. fold yes. pose proof (count_positive yes y Yes).
      assert (0 <= sumz (crossing_of y) (all_triangles no))%Z
        by (apply count_positive; intros l I; apply convex_polygon, HN, I).
      specialize (Once y). lia. }
    assert (Apart : ForallOrdPairs apart (real_edges R)).
    { apply ordered_pairs. intros a e b f d E.
      exact (edges_apart (covered_set yes) (real_edges R) Closed Rows NN Bounds a e b f d E). }
    exists (part_set yes (parts_of w cs)). rewrite <- (all3_length _ _ _ _ H3), Len.
    split; [exact Fall|split; [|split; [exact Apart|split]]].
    + intros x X Off. rewrite (set_of_fat R x TR) in X.
      assert (Near := Off). rewrite real_edges_flat in Near.
      destruct (rings_near _ x Near) as (e & He & K). rewrite <- real_edges_flat in K.
      fold R in K.
      destruct (X e He) as (y & Y & _ & Wy). exists e. split; auto. intros z Z.
      apply Same. apply counted_union; [apply all_positive, Yes|].
      fold yes. rewrite <- Turns, (K z Z), <- (K y Y). lia.
    + intros i outer holes E. destruct (Poly i outer holes E) as (? & _ & _ & _ & _ & k & Hk).
      unfold check_polygon in Hk. rewrite !andb_true_iff in Hk. cbn [fst snd] in Hk.
      destruct Hk as [[[A1 A2] A3] _]. split; [|split; [|split]].
      * rewrite <- area_real, <- Q2R_zero. apply less_real, A1.
      * intros hole I. rewrite forallb_forall in A2. specialize (A2 hole I).
        rewrite <- area_real, <- Q2R_zero. apply less_real, A2.
      * apply (ascends_sorted _ _ _ qring_before_real holes A3).
      * intros ring I.
        destruct (Ring i outer holes ring E I)
          as (part & c & lists & Ep & Hc & Sub & (k' & Hr) & F).
        assert (J : exists a b, real_edges R = a ++ ring_edges (map real ring) ++ b).
        { assert (K : In ring R).
          { unfold R, rings_of. apply in_flat_map. exists (outer, holes).
            split; [eapply nth_error_In; eauto|exact I]. }
          apply in_split in K. destruct K as (r1 & r2 & ->). unfold real_edges.
          rewrite flat_map_app. simpl. eauto. }
        destruct J as (a & b & J). split.
        { apply (ring_is_ring yes no part c Yes HN Once Sub Hc ring k' Hr).
          - intros e L. apply NN. rewrite J. apply in_or_app. right. apply in_or_app. auto.
          - rewrite J in Apart. apply pairs_of_part in Apart. exact Apart. }
        intros e L. destruct (row_found yes part e _ _ F L) as (l & Rl).
        apply (row_divides yes part) with (l := l); auto.
        { intros y Y. exists part. auto. }
        { intros y Y. apply Same, Y. }
    + rewrite <- (map_map fst (map real)). apply (ascends_sorted _ _ _ qring_before_real _ HA).
Qed.
