(** Edges that cancel, on each line, do not change any winding number: this is what the checker's
    comparison of two sorted lists says (rules `pieces` and `eq`). *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Numbers Values Checker
  Corners.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** The winding number of edges between rational vertices *)
Definition turns (E : list (corner * corner)) (y : point) : Z := winding (map real_edge E) y.

(** What a point of a line contributes *)
Definition step_of (y : point) (k : key) : Z :=
  step (value (slope k)) (value (offset k)) (value (abscissa k)) y.
Lemma keys_count e k y : keys e = Some k -> edge_crossing y (real_edge e) =
  (sumz (step_of y) (map snd k) - sumz (step_of y) (map fst k))%Z.
Proof.
  destruct e as [a b]. unfold edge_crossing, real_edge, keys. cbn [fst snd].
  destruct (equal (fst a) (fst b)) eqn:E.
  - intros H. injection H; intros <-. apply equal_value in E. rewrite crossing_vertical; auto.
  - set (m := over _ _). set (c := reduced _).
    destruct (differ (fst a) (fst b) && _) eqn:D; [|discriminate]. intros H.
    injection H; intros <-. apply andb_prop in D. destruct D as [N L].
    apply differ_value in N. apply equal_value in L. rewrite value_plus, value_times in L.
    assert (Hc : value c = value (snd a) - value m * value (fst a)).
    { unfold c. rewrite value_reduced, value_minus, value_times. reflexivity. }
    assert (Hm : value m = (value (snd b) - value (snd a)) / (value (fst b) - value (fst a))).
    { rewrite L, Hc. field. lra. }
    rewrite (crossing_on_line (real a) (real b) y (value m) (value c) N Hm Hc).
    cbn [map fst snd sumz fold_right]. unfold step_of. cbn [slope offset abscissa key_of].
    rewrite !value_reduced. unfold real. cbn [fst snd]. lia.
Qed.
Lemma turns_by_keys E y : forall k, all_keys E = Some k -> turns E y =
  (sumz (step_of y) (map snd k) - sumz (step_of y) (map fst k))%Z.
Proof.
  unfold turns. induction E as [|e E IH]; intros k H; simpl in H.
  - injection H; intros <-. reflexivity.
  - destruct (keys e) as [l|] eqn:K; [|discriminate].
    destruct (all_keys E) as [m|]; [|discriminate]. injection H; intros <-. cbn [map].
    change (winding (real_edge e :: map real_edge E) y)
      with (edge_crossing y (real_edge e) + winding (map real_edge E) y)%Z.
    rewrite (IH m eq_refl), (keys_count e l y K), !map_app, !sumz_app. lia.
Qed.

Theorem same_boundary_same_turns E F : same_boundary E F = true ->
  forall y, turns E y = turns F y.
Proof.
  unfold same_boundary. intros H y.
  destruct (all_keys E) as [e|] eqn:Ke; [|discriminate].
  destruct (all_keys F) as [f|] eqn:Kf; [|discriminate].
  rewrite (turns_by_keys E y e Ke), (turns_by_keys F y f Kf).
  apply (all2_map _ (step_of y)) in H.
  2: { intros k l K. unfold same_key in K. rewrite !andb_true_iff in K.
       destruct K as [[K1 K2] K3]. unfold step_of.
       rewrite (equal_value _ _ K1), (equal_value _ _ K2), (equal_value _ _ K3). reflexivity. }
  assert (S : forall l,
    sumz (step_of y) l = fold_right Z.add 0%Z (map (step_of y) (KeySort.sort l))).
  { intros l. rewrite (sumz_perm _ _ _ (KeySort.Permuted_sort l)).
    induction (KeySort.sort l); simpl; congruence. }
  pose proof (S (map fst e ++ map snd f)) as S1. pose proof (S (map snd e ++ map fst f)) as S2.
  rewrite H, <- S2, !sumz_app in S1. lia.
Qed.

Lemma no_null_different E : no_null E = true ->
  forall a b, In (a, b) (map real_edge E) -> a <> b.
Proof.
  unfold no_null. intros D a b I. apply in_map_iff in I. destruct I as ([u v] & E1 & I).
  unfold real_edge in E1. simpl in E1. injection E1; intros; subst a b.
  rewrite forallb_forall in D. specialize (D _ I). apply distinct_real, D.
Qed.
End Here.
