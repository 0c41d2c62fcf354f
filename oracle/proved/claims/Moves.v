(** Claim `interval`: one figure that moves, with its touching points, between two scales. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Moving Sums Crossings Fans Curves Unions Local Numbers
  Rational Values Figures Corners Cancellation Bodies Scaling Trees Theorems Components Classes
  Counting Holes Across Sides Overlaps Canonical Touching.

(** ** The checker *)
Open Scope Q_scope.
Definition at_one (s : Q) (m : mover) : vertex :=
  let '(x0, x1, (y0, y1)) := m in (Qred (x0 + s * x1), Qred (y0 + s * y1)).
Definition between_two (a b : Q) (m : mover) : corner :=
  let '(x0, x1, (y0, y1)) := m in
  (Moving [Qred (x0 + a * x1); Qred (x0 + b * x1)],
   Moving [Qred (y0 + a * y1); Qred (y0 + b * y1)]).

(** The state of a sum: polygons, touching points, the number of holes *)
Definition check_state {A} (s : number) (place : A -> corner) (P Q : rings vertex)
    (state : list (polygon A) * list A * nat) (d : derivation) : bool :=
  let '(ps, touching, holes) := state in
  check_figure s (fixed_rings P) (fixed_rings Q) (each_vertex place ps) d &&
  Nat.eqb (length (holes_of d)) holes &&
  (if is_empty P || is_empty Q then match touching with [] => true | _ => false end
   else check_touching (flat_map ends (concat (rows_of d))) (map place touching)).
Definition check_between (a b : Q) (P Q : rings vertex) (m : moving) (d : derivation) : bool :=
  less a b && check_state (Moving [a; b]) (between_two a b) P Q m d.
Definition check_at (s : Q) (P Q : rings vertex) (m : moving) (d : derivation) : bool :=
  check_state (Fixed s) (fun v => fixed (at_one s v)) P Q m d.
(** A first `move`, and then at each scale s an `eq` and the `move` that begins there *)
Definition scale_between := (Q * derivation * derivation)%type.
Fixpoint check_interval (from to : Q) (P Q : rings vertex) (m : moving) (first : derivation)
    (rest : list scale_between) : bool :=
  match rest with
  | [] => check_between from to P Q m first
  | (s, d, next) :: more =>
      check_between from s P Q m first && check_at s P Q m d &&
      check_interval s to P Q m next more
  end.

Open Scope R_scope.
(** ** States *)
Section State.
Context {now : scale_here}.

Lemma all3_rings no ps : forall parts rows, all3 (check_polygon no) parts ps rows = true ->
  Forall2 (fun ring st => exists part, In part parts /\ check_ring part no ring st = true)
    (rings_of ps) (concat rows).
Proof.
  induction ps as [|[o h] ps IH]; intros [|part parts] [|k rows] H; try discriminate H.
  - apply Forall2_nil.
  - simpl in H. apply andb_prop in H. destruct H as [H1 H2]. unfold rings_of. cbn [flat_map concat].
    apply Forall2_app.
    + unfold check_polygon in H1. rewrite !andb_true_iff in H1. destruct H1 as [_ H1].
      cbn [fst snd] in *. clear H2. revert k H1. generalize (o :: h).
      induction l as [|ring l IHl]; intros [|st k] H; try discriminate H; [apply Forall2_nil|].
      simpl in H. apply andb_prop in H. destruct H as [H1 H2]. apply Forall2_cons; auto.
      exists part. simpl; auto.
    + eapply forall2_weaken; [|exact (IH parts rows H2)]. intros r st (q & I & K).
      exists q. simpl; auto.
Qed.
Lemma figure_touches s P Q ps d T : check_figure s P Q ps d = true ->
  is_empty P || is_empty Q = false ->
  check_touching (flat_map ends (concat (rows_of d))) T = true ->
  touch_in (outline (rings_of ps)) (map real T).
Proof.
  intros H Em HT.
  pose proof (all3_rings _ ps _ _ (figure_polygons s P Q ps d H Em)) as F.
  pose proof (figure_apart s P Q ps d H Em) as Ap. rewrite real_edges_flat in Ap.
  apply pairs_of_rings in Ap.
  set (S := covered_set (covered_cells (region_of d))).
  assert (G : exists l, map fst l = outline (rings_of ps) /\
    map snd l = map (fun st => map real (ends st)) (concat (rows_of d)) /\
    Forall (is_rowed S) l).
  { assert (Null : forall ring, In ring (rings_of ps) ->
      forall e, In e (ring_edges (map real ring)) -> fst e <> snd e).
    { intros ring I e J. apply (figure_null s P Q ps d H Em). rewrite real_edges_flat.
      apply in_flat_map. exists (map real ring). split; auto. apply in_map, I. }
    revert Null F. generalize (rings_of ps), (concat (rows_of d)). intros rs sts Null F.
    induction F as [|ring st rs sts R F IH].
    - exists []. repeat split; auto.
    - destruct IH as (l & L1 & L2 & L3); [intros; apply (Null ring0); simpl; auto|].
      exists ((map real ring, map real (ends st)) :: l). cbn [map]. rewrite L1, L2.
      repeat split; auto. apply Forall_cons; auto.
      destruct R as (part & I & Hr). apply In_nth_error in I. destruct I as (i & Ep).
      destruct (figure_class s P Q ps d H Em i part Ep) as ((c & Hc) & Sub).
      destruct (ring_rows _ _ part c (figure_yes s P Q ps d H Em) (figure_no s P Q ps d H Em)
        (figure_once s P Q ps d H Em) Sub Hc ring st Hr) as (lists & Rows & N & E).
      split; [rewrite <- E; exact N|split].
      + apply Null. simpl; auto.
      + exists lists. split; auto. eapply rows_weaken. exact Rows. }
  destruct G as (l & L1 & L2 & L3). rewrite Forall_forall in L3.
  change (map (map real) (rings_of ps)) with (outline (rings_of ps)) in Ap. rewrite <- L1 in *.
  assert (Sh : ForallOrdPairs share l).
  { clear - L3 Ap. induction l as [|p l IH]; [apply FOP_nil|]. cbn [map] in Ap.
    inversion Ap as [|? ? A1 A2]; subst. apply FOP_cons.
    - apply Forall_forall. intros q I. rewrite Forall_forall in A1.
      apply (rowed_share S); [apply L3; simpl; auto|apply L3; simpl; auto|].
      apply A1, in_map, I.
    - apply IH; auto. intros q I. apply L3. simpl; auto. }
  assert (Hold : forall p, In p l -> holds_ends p) by (intros p I; apply (rowed_holds S), L3, I).
  intros x. destruct (counts_exist (passes x) (map fst l)) as (n & Cn). exists n. split; auto.
  destruct (counts_exist (Logic.eq x) (concat (map snd l))) as (m & Cm).
  destruct (counts_ends x l Hold Sh n m Cn Cm) as [M1 M2].
  replace (pred n) with (pred m) by (destruct (Nat.le_gt_cases 2 n); [rewrite M2|]; lia).
  apply (touching_real _ _ _ _ HT). rewrite L2 in Cm.
  rewrite flat_map_concat_map, concat_map, map_map. exact Cm.
Qed.

Lemma state_is_right {A} (s : number) (place : A -> corner) (P Q : rings vertex) ps T holes d :
  check_state s place P Q (ps, T, holes) d = true ->
  is_state (value s) P Q (each_vertex (fun v => real (place v)) ps)
    (map (fun v => real (place v)) T) holes.
Proof.
  unfold check_state. rewrite !andb_true_iff. intros [[H N] HT]. apply Nat.eqb_eq in N.
  destruct (figure_is_right _ _ _ _ _ H) as (IS & CO & HO & FO).
  rewrite N, real_each, !outline_fixed in *.
  assert (Len : length (each_vertex place ps) = length ps) by apply map_length.
  assert (Len' : length (each_vertex (fun v => real (place v)) ps) = length ps)
    by apply map_length.
  split; [exact IS|split; [|split; [exact HO|split; [exact FO|]]]].
  - rewrite Len', <- Len. exact CO.
  - rewrite <- real_each, <- outline_of, <- (map_map place real).
    assert (E : forall r : rings vertex, is_empty (fixed_rings r) = is_empty r)
      by (intros [|? ?]; reflexivity).
    destruct (is_empty P || is_empty Q) eqn:Em.
    + destruct T; [|discriminate HT].
      assert (Em' : is_empty (fixed_rings P) || is_empty (fixed_rings Q) = true)
        by (rewrite !E; exact Em).
      rewrite (empty_sum _ _ _ _ _ Em' (figure_sum _ _ _ _ _ H)). intros x. exists 0%nat.
      split; apply counts_none.
    + apply (figure_touches s (fixed_rings P) (fixed_rings Q) _ d); auto. rewrite !E. exact Em.
Qed.
Lemma value_moving a b : value (Moving [a; b]) = (Q2R a + moment * Q2R b) / (1 + moment).
Proof. pose proof moment_positive. unfold value, worth, form, power; simpl. field. lra. Qed.
Lemma real_between a b m : real (between_two a b m) = at_scale (value (Moving [a; b])) m.
Proof.
  destruct m as [[x0 x1] [y0 y1]]. unfold between_two, real, at_scale, track, add, scale.
  cbn [fst snd]. rewrite !value_moving, !Q2R_red, !Q2R_plus, !Q2R_mult.
  pose proof moment_positive. f_equal; field; lra.
Qed.
Lemma real_at_one s m : point_of (at_one s m) = at_scale (Q2R s) m.
Proof.
  destruct m as [[x0 x1] [y0 y1]]. unfold at_one, point_of, at_scale, track, add, scale.
  cbn [fst snd]. rewrite !Q2R_red, !Q2R_plus, !Q2R_mult. f_equal; ring.
Qed.
End State.

Lemma each_same {A B} (f g : A -> B) : (forall a, f a = g a) ->
  forall ps, each_vertex f ps = each_vertex g ps.
Proof.
  intros E ps. unfold each_vertex. apply map_ext. intros p.
  rewrite (map_ext f g E). f_equal. apply map_ext. intros l. apply map_ext, E.
Qed.
Lemma between_is_right a b P Q m d : check_between a b P Q m d = true -> is_interval a b P Q m.
Proof.
  unfold check_between. intros H. apply andb_prop in H. destruct H as [L H].
  split; [apply less_real, L|]. intros s Hs.
  destruct m as [[ps T] holes]. unfold at_.
  assert (X : 0 < (s - Q2R a) / (Q2R b - s)) by (apply Rdiv_lt_0_compat; lra).
  pose proof (@state_is_right {| moment := _; moment_positive := X |} _ _ _ _ _ _ _ _ _ H) as G.
  assert (V : @value {| moment := _; moment_positive := X |} (Moving [a; b]) = s).
  { rewrite value_moving. cbn [moment]. field. lra. }
  rewrite V in G.
  assert (E : forall v, @real {| moment := _; moment_positive := X |} (between_two a b v)
    = at_scale s v) by (intros v; rewrite real_between, V; reflexivity).
  rewrite (each_same _ _ E), (map_ext _ _ E) in G. exact G.
Qed.
#[local] Instance standing : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.
Lemma at_is_right s P Q m d : check_at s P Q m d = true ->
  let '(ps, T, holes) := at_ (Q2R s) m in is_state (Q2R s) P Q ps T holes.
Proof.
  unfold check_at. intros H. destruct m as [[ps T] holes]. unfold at_.
  pose proof (state_is_right _ _ _ _ _ _ _ _ H) as G.
  rewrite (each_same _ _ (real_at_one s)), (map_ext _ _ (real_at_one s)) in G. exact G.
Qed.

Theorem interval_is_right : forall (from to : Q) (P Q : rings vertex) (m : moving)
    (first : derivation) (rest : list scale_between),
  check_interval from to P Q m first rest = true -> is_interval from to P Q m.
Proof.
  intros from to P Q m first rest. revert from first.
  induction rest as [|[[t d] next] rest IH]; intros from first H; simpl in H.
  - exact (between_is_right _ _ _ _ _ _ H).
  - rewrite !andb_true_iff in H. destruct H as [[H1 H2] H3].
    destruct (between_is_right _ _ _ _ _ _ H1) as [L1 B1]. destruct (IH t next H3) as [L2 B2].
    split; [lra|]. intros s Hs. destruct (Rtotal_order s (Q2R t)) as [L|[->|L]].
    + apply B1. lra.
    + apply (at_is_right t P Q m d H2).
    + apply B2. lra.
Qed.
