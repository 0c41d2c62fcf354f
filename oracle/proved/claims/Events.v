(** Claim `event`: a figure that moves before a scale, another one after it, or not the one there.
    *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Moving Numbers Rational Values Figures Corners
  Canonical Turned Touching Moves.

(** ** The checker *)
Open Scope Q_scope.
Definition same_vertex (p q : vertex) : bool :=
  Qeq_bool (fst p) (fst q) && Qeq_bool (snd p) (snd q).
Definition same_mover (m n : mover) : bool :=
  same_vertex (fst m) (fst n) && same_vertex (snd m) (snd n).
Definition same_both {A} (f : A -> A -> bool) (p q : A * A) : bool :=
  f (fst p) (fst q) && f (snd p) (snd q).
(** The turns of rings: two edges, one after the other *)
Definition turns_of {A} (ps : list (polygon A)) : list (A * A * (A * A)) :=
  flat_map (fun ring => ring_edges (ring_edges ring)) (rings_of ps).
Definition occurrences {A} (f : A -> A -> bool) (x : A) (l : list A) : nat :=
  length (filter (f x) l).
(** Entry n of two lists is in one more often than in the other. *)
Definition differs_at {A} (f : A -> A -> bool) (n : nat) (l k : list A) : bool :=
  match nth_error (l ++ k) n with
  | Some x => negb (Nat.eqb (occurrences f x l) (occurrences f x k))
  | None => false
  end.
(** Where two figures differ: the number of a turn, or of a touching point *)
Inductive difference_of := Of_turn (n : nat) | Of_touching (n : nat).
Definition check_difference {A} (f : A -> A -> bool) (d : difference_of)
    (a b : list (polygon A) * list A) : bool :=
  match d with
  | Of_turn n => differs_at (same_both (same_both f)) n (turns_of (fst a)) (turns_of (fst b))
  | Of_touching n => differs_at f n (snd a) (snd b)
  end.
(** What makes the event: another figure after it, another one at it, or other numbers *)
Inductive change := Another_after (d : difference_of) | Another_there (d : difference_of)
| Other_numbers.
Definition rational_state := (list (polygon vertex) * list vertex * nat)%type.
Definition numbers_of {A} (m : list (polygon A) * list A * nat) : nat * nat :=
  (length (fst (fst m)), snd m).
Definition same_numbers (a b : nat * nat) : bool :=
  Nat.eqb (fst a) (fst b) && Nat.eqb (snd a) (snd b).
Definition check_change (s : Q) (before : moving) (there : rational_state) (after : moving)
    (c : change) : bool :=
  match c with
  | Another_after d => check_difference same_mover d (fst before) (fst after)
  | Another_there d =>
      check_difference same_vertex d
        (each_vertex (at_one s) (fst (fst before)), map (at_one s) (snd (fst before))) (fst there)
  | Other_numbers =>
      negb (same_numbers (numbers_of before) (numbers_of there) &&
            same_numbers (numbers_of there) (numbers_of after))
  end.
Definition is_of_boundary (c : change) : bool :=
  match c with Other_numbers => false | _ => true end.
Record part_of_event := {
  figure_there : moving; first_move : derivation; more_moves : list scale_between }.
Definition check_event (from s to : Q) (P Q : rings vertex) (before after : part_of_event)
    (there : rational_state) (d : derivation) (c : change) : bool :=
  check_interval from s P Q (figure_there before) (first_move before) (more_moves before) &&
  check_interval s to P Q (figure_there after) (first_move after) (more_moves after) &&
  check_state (Fixed s) fixed P Q there d && check_order (fixed_polygons (fst (fst there))) &&
  check_change s (figure_there before) there (figure_there after) c.

(** ** Lists that differ *)
Open Scope R_scope.
Lemma same_vertex_point p q : same_vertex p q = true <-> point_of p = point_of q.
Proof.
  unfold same_vertex, point_of. rewrite andb_true_iff, !Qeq_bool_iff. split.
  - intros [H1 H2]. rewrite (Qeq_eqR _ _ H1), (Qeq_eqR _ _ H2). reflexivity.
  - intros E. injection E; intros E2 E1. split; apply eqR_Qeq; auto.
Qed.
Lemma same_mover_track m n : same_mover m n = true <-> track m = track n.
Proof.
  unfold same_mover. rewrite andb_true_iff, !same_vertex_point.
  destruct m as [[x0 x1] [y0 y1]], n as [[u0 u1] [v0 v1]]. unfold track, point_of. cbn [fst snd].
  split.
  - intros [H1 H2]. injection H1; injection H2; intros. congruence.
  - intros E. injection E; intros. split; congruence.
Qed.
Lemma same_both_pair {A B} (f : A -> A -> bool) (g : A -> B) :
  (forall a b, f a b = true <-> g a = g b) ->
  forall p q, same_both f p q = true <-> both g p = both g q.
Proof.
  intros H [a b] [c d]. unfold same_both, both. cbn [fst snd]. rewrite andb_true_iff, !H.
  split; [intros [E1 E2]; congruence|intros E; injection E; auto].
Qed.
Lemma occurrences_count {A B} (f : A -> A -> bool) (g : A -> B) x l :
  (forall a b, f a b = true <-> g a = g b) ->
  counts (Logic.eq (g x)) (map g l) (occurrences f x l).
Proof.
  intros H. unfold occurrences. induction l as [|a l IH]; [apply counts_none|].
  cbn [map filter]. destruct (f x a) eqn:E.
  - apply counts_one; auto. apply H, E.
  - apply counts_not; auto. intros K. apply H in K. congruence.
Qed.
Lemma differs_not_permuted {A B} (f : A -> A -> bool) (g : A -> B) n l k :
  (forall a b, f a b = true <-> g a = g b) -> differs_at f n l k = true ->
  ~ Permutation (map g l) (map g k).
Proof.
  intros H D Pm. unfold differs_at in D. destruct (nth_error (l ++ k) n) as [x|]; [|discriminate].
  apply negb_true_iff, Nat.eqb_neq in D. apply D.
  pose proof (counts_permutation _ _ _ Pm _ (occurrences_count f g x l H)) as C.
  exact (counts_same _ _ _ C _ (occurrences_count f g x k H)).
Qed.

(** ** The turns of figures that are the same but for order *)
Lemma same_polygons_rings {A} (ps qs : list (polygon A)) : Forall2 same_polygon ps qs ->
  exists rs, Permutation (rings_of ps) rs /\ Forall2 turned rs (rings_of qs).
Proof.
  induction 1 as [|p q ps qs [T (holes & Pm & Th)] F (rs & P1 & P2)].
  - exists []. split; [apply Permutation_refl|apply Forall2_nil].
  - exists (fst p :: holes ++ rs). unfold rings_of in *. cbn [flat_map]. split.
    + apply perm_skip, Permutation_app; auto.
    + apply Forall2_cons; auto. apply Forall2_app; auto.
Qed.
Lemma same_figure_turns {A} (f g : list (polygon A) * list A) : same_figure f g ->
  Permutation (turns_of (fst f)) (turns_of (fst g)).
Proof.
  intros ((ps & Pm & F) & _). unfold turns_of.
  destruct (same_polygons_rings _ _ F) as (rs & P1 & P2).
  apply Permutation_trans with (flat_map (fun ring => ring_edges (ring_edges ring)) rs).
  - apply Permutation_flat_map. eapply Permutation_trans; [|exact P1].
    unfold rings_of. apply Permutation_flat_map, Pm.
  - clear P1. induction P2 as [|r q rs qs T P2 IH]; simpl; auto. apply Permutation_app; auto.
    apply turned_permuted, turned_edges, turned_edges, T.
Qed.
Lemma turns_each {A B} (g : A -> B) ps :
  turns_of (each_vertex g ps) = map (both (both g)) (turns_of ps).
Proof.
  unfold turns_of.
  replace (rings_of (each_vertex g ps)) with (map (map g) (rings_of ps)).
  - rewrite !flat_map_concat_map, concat_map, !map_map. f_equal. apply map_ext. intros r.
    rewrite !ring_edges_map. reflexivity.
  - unfold rings_of, each_vertex. rewrite !flat_map_concat_map, concat_map, !map_map. reflexivity.
Qed.
Lemma difference_is_right {A B} (f : A -> A -> bool) (g : A -> B) d a b :
  (forall x y, f x y = true <-> g x = g y) -> check_difference f d a b = true ->
  ~ same_figure (each_vertex g (fst a), map g (snd a)) (each_vertex g (fst b), map g (snd b)).
Proof.
  intros H D S. destruct d as [n|n]; simpl in D.
  - apply same_figure_turns in S. cbn [fst] in S. rewrite !turns_each in S.
    revert S. apply (differs_not_permuted _ (both (both g)) n) in D; auto.
    apply same_both_pair, same_both_pair, H.
  - destruct S as [_ S]. revert S. apply (differs_not_permuted f g n); auto.
Qed.

(** ** It is right. *)
#[local] Instance standing : scale_here := {| moment := 1; moment_positive := Rlt_0_1 |}.
Definition real_state (s : rational_state) : state :=
  (figure (fst (fst s)), map point_of (snd (fst s)), snd s).
Lemma each_twice {A B C} (f : A -> B) (g : B -> C) ps :
  each_vertex g (each_vertex f ps) = each_vertex (fun a => g (f a)) ps.
Proof.
  unfold each_vertex. rewrite map_map. apply map_ext. intros [o h]. cbn [fst snd].
  apply f_equal2; [apply map_map|]. rewrite map_map. apply map_ext. intros l. apply map_map.
Qed.
Theorem event_is_right : forall (from s to : Q) (P Q : rings vertex)
    (before after : part_of_event) (there : rational_state) (d : derivation) (c : change),
  check_event from s to P Q before after there d c = true ->
  is_event from s to P Q (figure_there before) (real_state there) (figure_there after)
    (is_of_boundary c).
Proof.
  intros from s to P Q before after there d c H. unfold check_event in H.
  rewrite !andb_true_iff in H. destruct H as [[[[H1 H2] H3] H4] H5].
  split; [exact (interval_is_right _ _ _ _ _ _ _ H1)|].
  split; [exact (interval_is_right _ _ _ _ _ _ _ H2)|]. destruct there as [[ps T] holes]. split.
  - split; [exact (state_is_right _ _ _ _ _ _ _ _ H3)|].
    apply order_is_right in H4. rewrite polygons_fixed in H4. exact H4.
  - destruct (figure_there before) as [[pb Tb] nb]. destruct (figure_there after) as [[pa Ta] na].
    destruct c as [k|k|]; cbn [is_of_boundary check_change fst snd] in *.
    + left. exact (difference_is_right _ _ k (pb, Tb) (pa, Ta) same_mover_track H5).
    + right. pose proof (difference_is_right _ _ k _ _ same_vertex_point H5) as G.
      cbn [fst snd] in G. rewrite each_twice, map_map in G.
      rewrite (each_same _ _ (real_at_one s)), (map_ext _ _ (real_at_one s)) in G. exact G.
    + intros [E1 E2]. apply negb_true_iff in H5.
      assert (K : same_numbers (numbers_of (pb, Tb, nb)) (numbers_of (ps, T, holes)) &&
        same_numbers (numbers_of (ps, T, holes)) (numbers_of (pa, Ta, na)) = true).
      { unfold same_numbers, numbers_of, real_state, figure, each_vertex in *. cbn [fst snd] in *.
        rewrite !map_length in *. injection E1; injection E2; intros.
        rewrite !andb_true_iff, !Nat.eqb_eq. auto. }
      congruence.
Qed.
