(** Edges that cancel, on each line, do not change any winding number: this is what the checker's
    comparison of two sorted lists says (rules `pieces` and `eq`). *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Checker Rational.
Open Scope R_scope.

(** The winding number of edges between rational vertices *)
Definition turns (E : list (vertex * vertex)) (y : point) : Z := winding (map real_edge E) y.

Definition step_of (y : point) (k : list Z) : Z :=
  match k with
  | [a; b; c; d; e; f] => step (IZR a * / IZR b) (IZR c * / IZR d) (IZR e * / IZR f) y
  | _ => 0%Z
  end.
Lemma keys_count e y : edge_crossing y (real_edge e) =
  (sumz (step_of y) (map snd (keys e)) - sumz (step_of y) (map fst (keys e)))%Z.
Proof.
  destruct e as [a b]. unfold edge_crossing, real_edge, keys. cbn [fst snd].
  destruct (Qeq_bool (fst a) (fst b)) eqn:E.
  - apply eq_real in E. rewrite crossing_vertical; auto.
  - assert (N : Q2R (fst a) <> Q2R (fst b)).
    { intros K. apply eqR_Qeq, Qeq_bool_iff in K. congruence. }
    assert (N' : ~ (fst b - fst a == 0)%Q).
    { intros K. apply Qeq_eqR in K. rewrite Q2R_minus, Q2R_zero in K. lra. }
    set (m := Qred ((snd b - snd a) / (fst b - fst a))).
    set (c := Qred (snd a - m * fst a)).
    assert (Hm : Q2R m = (Q2R (snd b) - Q2R (snd a)) / (Q2R (fst b) - Q2R (fst a))).
    { unfold m. rewrite Q2R_red, Q2R_div by exact N'. rewrite !Q2R_minus. reflexivity. }
    assert (Hc : Q2R c = Q2R (snd a) - Q2R m * Q2R (fst a)).
    { unfold c. rewrite Q2R_red, Q2R_minus, Q2R_mult. reflexivity. }
    rewrite (crossing_on_line (real a) (real b) y (Q2R m) (Q2R c) N Hm Hc).
    cbn [map fst snd sumz fold_right].
    change (step_of y (key m c (Qred (fst b))))
      with (step (Q2R m) (Q2R c) (Q2R (Qred (fst b))) y).
    change (step_of y (key m c (Qred (fst a))))
      with (step (Q2R m) (Q2R c) (Q2R (Qred (fst a))) y).
    rewrite !Q2R_red. unfold real. cbn [fst snd]. lia.
Qed.
Lemma turns_by_keys E y : turns E y =
  (sumz (step_of y) (map snd (flat_map keys E)) - sumz (step_of y) (map fst (flat_map keys E)))%Z.
Proof.
  unfold turns. induction E as [|e E IH]; [reflexivity|]. cbn [map flat_map].
  change (winding (real_edge e :: map real_edge E) y)
    with (edge_crossing y (real_edge e) + winding (map real_edge E) y)%Z.
  rewrite IH, keys_count, !map_app, !sumz_app. lia.
Qed.

Theorem same_boundary_same_turns E F : same_boundary E F = true ->
  forall y, turns E y = turns F y.
Proof.
  unfold same_boundary. intros H y.
  apply all2_equal in H;
    [|intros ? ? K; apply all2_equal in K; auto; intros ? ?; apply Z.eqb_eq].
  rewrite !turns_by_keys.
  assert (Pm : Permutation (map fst (flat_map keys E) ++ map snd (flat_map keys F))
                           (map snd (flat_map keys E) ++ map fst (flat_map keys F))).
  { eapply Permutation_trans; [apply KeySort.Permuted_sort|]. rewrite H.
    apply Permutation_sym, KeySort.Permuted_sort. }
  apply (sumz_perm (step_of y)) in Pm. rewrite !sumz_app in Pm. lia.
Qed.

Lemma no_null_different E : no_null E = true ->
  forall a b, In (a, b) (map real_edge E) -> a <> b.
Proof.
  unfold no_null. intros D a b I. apply in_map_iff in I. destruct I as ([u v] & E1 & I).
  unfold real_edge in E1. simpl in E1. injection E1; intros; subst a b.
  rewrite forallb_forall in D. specialize (D _ I). simpl in D.
  apply negb_true_iff in D. apply different_real, D.
Qed.
