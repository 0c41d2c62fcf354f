(** Trees of pieces: what they hold (rule `pieces`), and codes that set all pairs of their pieces
    apart from a cell (rule `eq`, `sep`). *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Values Checker
  Corners Cancellation Bodies Scaling.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

Lemma node_induction (H : node -> Prop) : (forall v, H (Piece v)) ->
  (forall h k, (forall c, In c k -> H c) -> H (Group h k)) -> forall n, H n.
Proof.
  intros H1 H2. fix F 1. intros [v|h k]; [apply H1|apply H2].
  induction k as [|c k IH]; simpl; [tauto|]. intros d [<-|I]; [apply F|apply IH, I].
Qed.

(** A linear function is on each leaf at most what it is on the hull. *)
Lemma tree_le n : is_tree n = true -> is_body (hull_of n) = true /\
  forall l, In l (leaves n) -> is_body l = true /\
    forall u M, (forall v, In v (hull_of n) -> dot u (real v) <= M) ->
      forall v, In v l -> dot u (real v) <= M.
Proof.
  induction n as [v|h k IH] using node_induction; simpl; intros H.
  - split; auto. intros l [<-|[]]. split; auto.
  - apply andb_prop in H. destruct H as [O H]. split; auto. rewrite forallb_forall in H.
    intros l I. apply in_flat_map in I. destruct I as (c & I & J).
    specialize (H c I). apply andb_prop in H. destruct H as [Hc Hh].
    destruct (IH c I Hc) as [Oc K]. destruct (K l J) as [Ol Kl]. split; auto.
    intros u M B v V. apply (Kl u M); auto. intros w W. rewrite forallb_forall in Hh.
    specialize (Hh w W). apply holds_real in Hh. eapply body_le with (l := h); eauto.
    apply inside_body; auto.
Qed.
Lemma leaves_are_bodies n : is_tree n = true -> forall l, In l (leaves n) -> is_body l = true.
Proof. intros O l I. destruct (tree_le n O) as [_ K]. apply (K l I). Qed.

(** ** Operands *)
Lemma thin_cases {A} (r : rings A) : thin r = true ->
  (exists a, r = [[a]]) \/ (exists a b, r = [[a; b]]).
Proof.
  destruct r as [|[|a [|b [|c l]]] [|m r]]; try discriminate; eauto.
Qed.
Lemma set_of_fat r x : thin r = false -> set_of (outline r) x = region (real_edges r) x.
Proof. destruct r as [|[|a [|b [|c l]]] [|m r]]; try discriminate; reflexivity. Qed.
Lemma same_lists l k : all2 same l k = true -> map real l = map real k.
Proof. apply all2_map, same_real. Qed.
Lemma body_of_same l k x : map real l = map real k -> body l x -> body k x.
Proof.
  intros E. destruct l as [|a [|b [|c l]]], k as [|a' [|b' [|c' k]]]; try discriminate; auto.
  - injection E as E1 E2. unfold body, real. rewrite E1, E2. auto.
  - injection E as E1 E2 E3 E4. unfold body, real. rewrite E1, E2, E3, E4. auto.
  - unfold body, triangles. rewrite E. auto.
Qed.

Theorem operand_is_leaves s r o : 0 < value s -> check_operand s r o = true ->
  forall x, set_of (outline r) x <-> exists l, In l (leaves (root o)) /\ body l (scale (value s) x).
Proof.
  intros S H x. unfold check_operand in H. rewrite !andb_true_iff in H.
  destruct H as [[O _] H]. destruct (thin r) eqn:T.
  - assert (B : forall ring, r = [ring] -> exists leaf, leaves (root o) = [leaf] /\
        map real leaf = map (scale (value s)) (map real ring)).
    { intros ring ->. simpl in H. destruct (leaves (root o)) as [|leaf [|? ?]]; try discriminate.
      - exists leaf. split; auto. rewrite andb_true_r in H. apply same_lists in H.
        rewrite <- H, !map_map. apply map_ext. intros. apply real_scaled.
      - rewrite andb_false_r in H. discriminate. }
    assert (One : forall leaf, (exists l, In l [leaf] /\ body l (scale (value s) x)) <->
        body leaf (scale (value s) x)).
    { intros leaf. split; [intros (l & [<-|[]] & K); auto|exists leaf; simpl; auto]. }
    destruct (thin_cases r T) as [(a & ->)|(a & b & ->)].
    + destruct (B _ eq_refl) as (leaf & -> & E). rewrite One.
      destruct leaf as [|a' [|? ?]]; try discriminate.
      pose proof (f_equal (hd (0, 0)) E) as E1. simpl in E1 |- *. rewrite E1.
      split; [intros ->; auto|]. intros E2.
      rewrite <- (scale_back (value s) x S), E2, scale_back; auto.
    + destruct (B _ eq_refl) as (leaf & -> & E). rewrite One.
      destruct leaf as [|a' [|b' [|? ?]]]; try discriminate.
      pose proof (f_equal (hd (0, 0)) E) as E1. pose proof (f_equal (fun l => hd (0, 0) (tl l)) E)
        as E2.
      simpl in E1, E2 |- *. rewrite E1, E2.
      symmetry. apply on_segment_scale, S.
  - rewrite !andb_true_iff in H. destruct H as [[F D] B]. rewrite forallb_forall in F.
    rewrite (set_of_fat r x T), <- (region_scale_iff (value s) _ x S), <- scaled_edges.
    rewrite <- (union_of_all _ _ F). apply region_is_union.
    + apply all_positive, F.
    + apply no_null_different, D.
    + intros y. rewrite <- turns_of_polygons. apply (same_boundary_same_turns _ _ B).
Qed.

(** ** Solids: what a solid holds, the leaves hold. *)
Lemma pick_in l ns : forall k, pick l ns = Some k -> forall v, In v k -> In v l.
Proof.
  induction ns as [|n ns IH]; simpl; intros k H v I.
  - injection H; intros; subst. destruct I.
  - destruct (nth_error l n) eqn:E; [|discriminate]. destruct (pick l ns); [|discriminate].
    injection H; intros; subst.
    destruct I as [<-|I]; [eapply nth_error_In; eauto|eapply IH; eauto].
Qed.
Lemma solid_in_leaves ps d : is_solid ps d = true -> is_body (fst d) = true /\
  forall x, body (fst d) x -> exists l, In l ps /\ body l x.
Proof.
  unfold is_solid. destruct (pick ps (snd d)) as [k|] eqn:E; [|discriminate].
  assert (G : is_polygon (fst d) && forallb is_polygon k &&
    same_boundary (ring_edges (fst d)) (flat_map ring_edges k) = true ->
    is_body (fst d) = true /\ forall x, body (fst d) x -> exists l, In l ps /\ body l x).
  { rewrite !andb_true_iff, forallb_forall. intros [[H1 H2] H3].
    split; [apply polygon_is_body, H1|]. intros x X. rewrite polygon_body in X by auto.
    assert (X' : union_of (all_triangles k) x).
    { apply (same_count_same_union (triangles (fst d)) (all_triangles k)); auto.
      - apply polygon_positive, H1.
      - apply all_positive, H2.
      - intros y. rewrite <- turns_of_polygon, <- turns_of_polygons.
        apply (same_boundary_same_turns _ _ H3). }
    apply union_of_all in X'; auto. destruct X' as (l & I & L). exists l. split; auto.
    eapply pick_in; eauto. }
  destruct k as [|l [|m k]]; auto. rewrite andb_true_iff. intros [H1 H2]. split; auto.
  intros x X. exists l. split; [eapply pick_in; eauto; simpl; auto|].
  eapply body_of_same; [apply same_lists, H2|exact X].
Qed.

(** ** Separation *)
Definition separated (cell a b : list corner) : Prop := exists n : point, exists ma mb : R,
  ~ (fst n = 0 /\ snd n = 0) /\
  (forall v, In v a -> dot n (real v) <= ma) /\ (forall v, In v b -> dot n (real v) <= mb) /\
  (forall x, In x cell -> ma + mb <= dot n (real x)).
Lemma separated_swap cell a b : separated cell a b -> separated cell b a.
Proof.
  intros (n & ma & mb & N & Ha & Hb & Hc). exists n, mb, ma. repeat split; auto.
  intros x X. specialize (Hc x X). lra.
Qed.

Lemma tree_members h k c : is_tree (Group h k) = true -> In c k -> is_tree c = true.
Proof.
  simpl. intros W J. apply andb_prop in W. destruct W as [_ W]. rewrite forallb_forall in W.
  specialize (W c J). apply andb_prop in W. tauto.
Qed.
Lemma normal_separates n cell a b la lb : is_tree a = true -> is_tree b = true ->
  distinct n (zero, zero) = true ->
  forallb (fun x => le (nplus (support n (hull_of a)) (support n (hull_of b))) (qdot n x)) cell
    = true ->
  In la (leaves a) -> In lb (leaves b) -> separated cell la lb.
Proof.
  intros Wa Wb H1 H2 Ia Ib. rewrite forallb_forall in H2.
  destruct (tree_le a Wa) as [_ Ka]. destruct (tree_le b Wb) as [_ Kb].
  exists (real n), (value (support n (hull_of a))), (value (support n (hull_of b))).
  repeat apply conj.
  - intros [Z1 Z2]. apply distinct_real in H1. apply H1. unfold real at 2. cbn [fst snd].
    rewrite value_zero. destruct (real n). simpl in *. congruence.
  - apply (proj2 (Ka la Ia)). intros v V. apply support_real, V.
  - apply (proj2 (Kb lb Ib)). intros v V. apply support_real, V.
  - intros x X. rewrite <- real_dot, <- value_plus. apply le_value, H2, X.
Qed.

(** Each two pieces below a pair of the stack are below a pair for which a normal answers. *)
Lemma trees_opened (k : list node) (make : node -> node * node) st :
  (forall c, In c k -> is_tree (fst (make c)) = true /\ is_tree (snd (make c)) = true) ->
  (forall a b, In (a, b) st -> is_tree a = true /\ is_tree b = true) ->
  forall a b, In (a, b) (map make k ++ st) -> is_tree a = true /\ is_tree b = true.
Proof.
  intros H W a b J. apply in_app_or in J. destruct J as [J|J]; [|auto].
  apply in_map_iff in J. destruct J as (c & E & J). specialize (H c J). rewrite E in H. exact H.
Qed.
Theorem follow_answers answers code : forall stack, follow_with answers code stack = true ->
  (forall a b, In (a, b) stack -> is_tree a = true /\ is_tree b = true) ->
  forall a b la lb, In (a, b) stack -> In la (leaves a) -> In lb (leaves b) ->
    exists n a' b', answers n a' b' = true /\ is_tree a' = true /\ is_tree b' = true /\
      In la (leaves a') /\ In lb (leaves b').
Proof.
  induction code as [|i code IH]; intros stack H W a b la lb I Ia Ib.
  - destruct stack; [destruct I|discriminate].
  - destruct i; destruct stack as [|[x y] st]; try discriminate; simpl in H.
    + destruct x as [v|h k]; try discriminate. pose proof (W _ _ (or_introl eq_refl)) as [W1 W2].
      assert (W' := trees_opened k (fun c => (c, y)) st
        (fun c J => conj (tree_members h k c W1 J) W2) (fun a b J => W a b (or_intror J))).
      destruct I as [E|I]; [|apply (IH _ H W' a b); auto; apply in_or_app; auto].
      injection E; intros; subst. simpl in Ia. apply in_flat_map in Ia.
      destruct Ia as (c & J & K). apply (IH _ H W' c b); auto.
      apply in_or_app. left. apply in_map_iff. exists c; auto.
    + destruct y as [v|h k]; try discriminate. pose proof (W _ _ (or_introl eq_refl)) as [W1 W2].
      assert (W' := trees_opened k (fun c => (x, c)) st
        (fun c J => conj W1 (tree_members h k c W2 J)) (fun a b J => W a b (or_intror J))).
      destruct I as [E|I]; [|apply (IH _ H W' a b); auto; apply in_or_app; auto].
      injection E; intros; subst. simpl in Ib. apply in_flat_map in Ib.
      destruct Ib as (c & J & K). apply (IH _ H W' a c); auto.
      apply in_or_app. left. apply in_map_iff. exists c; auto.
    + apply andb_prop in H. destruct H as [H1 H].
      destruct I as [E|I]; [|apply (IH _ H (fun a b J => W a b (or_intror J)) a b); auto].
      injection E; intros; subst. destruct (W a b) as [Wa Wb]; [simpl; auto|].
      exists n, a, b. auto.
Qed.
Theorem follow_separates code cell stack : follow code cell stack = true ->
  (forall a b, In (a, b) stack -> is_tree a = true /\ is_tree b = true) ->
  forall a b la lb, In (a, b) stack -> In la (leaves a) -> In lb (leaves b) ->
    separated cell la lb.
Proof.
  intros H W a b la lb I Ia Ib.
  destruct (follow_answers _ _ _ H W a b la lb I Ia Ib) as (n & a' & b' & A & Wa & Wb & Ja & Jb).
  unfold separates in A. apply andb_prop in A.
  exact (normal_separates n cell a' b' la lb Wa Wb (proj1 A) (proj2 A) Ja Jb).
Qed.
End Here.
