(** Where the program of Taken.v answers, it is right, whatever it is given. *)
From Coq Require Import Lra Lia Psatz Permutation Classical Bool QArith Qreals Qreduction ZArith.
From Proved Require Import Definitions Form Legality Sums Crossings Curves Local.
From Proved Require Import Decomposed Gaps Unique Rounds Legal Points Member Decided Taken.
Open Scope R_scope.

Lemma eq_decides x y : Qeq_bool x y = true <-> Q2R x = Q2R y.
Proof. rewrite Qeq_bool_iff. split; [apply Qeq_eqR|apply eqR_Qeq]. Qed.
Lemma le_true x y : Qle_bool x y = true <-> Q2R x <= Q2R y.
Proof. rewrite Qle_bool_iff. split; [apply Qle_Rle|apply Rle_Qle]. Qed.
Lemma less_true x y : less x y = true <-> Q2R x < Q2R y.
Proof. rewrite less_decides. destruct (Rlt_dec (Q2R x) (Q2R y)); split; auto; discriminate. Qed.
Lemma zero_real : Q2R 0 = 0.
Proof. unfold Q2R; simpl; lra. Qed.

(** ** Pairs of edges *)
Lemma all_pairs_hold {A} test (l : list A) : all_pairs test l = true ->
  ForallOrdPairs (fun e f => test e f = true) l.
Proof.
  induction l as [|e r IH]; intros H; [constructor|]. simpl in H. apply andb_prop in H.
  destruct H as [H K]. constructor; auto. apply Forall_forall, forallb_forall. exact H.
Qed.
Lemma smaller_real x y : Q2R (smaller x y) = Rmin (Q2R x) (Q2R y).
Proof.
  unfold smaller, Rmin. rewrite le_decides. destruct (Rle_dec (Q2R x) (Q2R y)); reflexivity.
Qed.
Lemma greater_real x y : Q2R (greater x y) = Rmax (Q2R x) (Q2R y).
Proof.
  unfold greater, Rmax. rewrite le_decides. destruct (Rle_dec (Q2R x) (Q2R y)); reflexivity.
Qed.
Lemma touch_one_value a b c d x y : touch_on_axis a b c d = true ->
  (Q2R a <= x <= Q2R b \/ Q2R b <= x <= Q2R a) -> (Q2R c <= x <= Q2R d \/ Q2R d <= x <= Q2R c) ->
  (Q2R a <= y <= Q2R b \/ Q2R b <= y <= Q2R a) -> (Q2R c <= y <= Q2R d \/ Q2R d <= y <= Q2R c) ->
  x = y.
Proof.
  unfold touch_on_axis. rewrite le_true, smaller_real, !greater_real, !smaller_real.
  unfold Rmin, Rmax.
  repeat match goal with |- context [Rle_dec ?p ?q] => destruct (Rle_dec p q) end; lra.
Qed.
Lemma side_zero a b c : (side a b c =? 0)%Z = true <-> orient (R2 a) (R2 b) (R2 c) = 0.
Proof.
  rewrite <- qturn_real, <- zero_real, <- eq_decides, Qeq_bool_iff. unfold side. fold (qturn a b c).
  rewrite Z.eqb_eq. unfold sg, Qeq. simpl. rewrite Z.sgn_null_iff. lia.
Qed.
Lemma touch_at_most_holds e f : touch_at_most e f = true ->
  forall x y, on_segment (fst (R2e e)) (snd (R2e e)) x ->
    on_segment (fst (R2e e)) (snd (R2e e)) y -> on_segment (fst (R2e f)) (snd (R2e f)) x ->
    on_segment (fst (R2e f)) (snd (R2e f)) y -> x = y.
Proof.
  destruct e as [a b], f as [c d]. unfold touch_at_most, R2e, is_vertical, is_level.
  cbn [fst snd]. intros H x y Xe Ye Xf Yf.
  pose proof (segment_range _ _ _ Xe) as (O1 & X1 & X2). pose proof (segment_range _ _ _ Ye) as
    (O2 & Y1 & Y2). pose proof (segment_range _ _ _ Xf) as (O3 & X3 & X4).
  pose proof (segment_range _ _ _ Yf) as (O4 & Y3 & Y4).
  rewrite !orb_true_iff, !andb_true_iff, !negb_true_iff in H.
  assert (Same : fst x = fst y -> snd x = snd y -> x = y).
  { intros E1 E2. destruct x, y; cbn [fst snd] in *; congruence. }
  assert (On : (fst (R2 b) - fst (R2 a)) * (snd x - snd y) =
               (snd (R2 b) - snd (R2 a)) * (fst x - fst y)) by (unfold orient in O1, O2; lra).
  assert (On2 : (fst (R2 d) - fst (R2 c)) * (snd x - snd y) =
               (snd (R2 d) - snd (R2 c)) * (fst x - fst y)) by (unfold orient in O3, O4; lra).
  set (D := (fst (R2 b) - fst (R2 a)) * (snd (R2 d) - snd (R2 c)) -
            (snd (R2 b) - snd (R2 a)) * (fst (R2 d) - fst (R2 c))).
  assert (Across : D <> 0 -> x = y).
  { intros N. apply Same; apply Rminus_diag_uniq; apply Rmult_eq_reg_l with (2 := N); unfold D.
    - replace ((fst (R2 b) - fst (R2 a)) * (snd (R2 d) - snd (R2 c)) -
        (snd (R2 b) - snd (R2 a)) * (fst (R2 d) - fst (R2 c))) with
        ((fst (R2 b) - fst (R2 a)) * (snd (R2 d) - snd (R2 c)) -
        (fst (R2 d) - fst (R2 c)) * (snd (R2 b) - snd (R2 a))) by ring.
      rewrite Rmult_minus_distr_r, !Rmult_assoc, <- On, <- On2. ring.
    - replace ((fst (R2 b) - fst (R2 a)) * (snd (R2 d) - snd (R2 c)) -
        (snd (R2 b) - snd (R2 a)) * (fst (R2 d) - fst (R2 c))) with
        ((snd (R2 d) - snd (R2 c)) * (fst (R2 b) - fst (R2 a)) -
        (snd (R2 b) - snd (R2 a)) * (fst (R2 d) - fst (R2 c))) by ring.
      rewrite Rmult_minus_distr_r, !Rmult_assoc, On, On2. ring. }
  destruct (Req_dec D 0) as [Z|Z]; [|auto].
  destruct H as [[[H|H]|[V H]]|[V H]].
  - exfalso. apply not_true_iff_false in H. apply H, eq_decides. rewrite zero_real, <- Z.
    unfold Points.qcross, sub, D, point_of. cbn [fst snd].
    rewrite Q2R_minus, !Q2R_mult, !Q2R_red, !Q2R_minus. reflexivity.
  - exfalso. apply not_true_iff_false in H. apply H, side_zero.
    destruct Xf as (t & _ & ->). transitivity (orient (R2 a) (R2 b) (R2 c) + t * D);
      [rewrite Z; ring|]. rewrite <- O1. unfold orient, D. cbn [fst snd]. ring.
  - assert (E1 : fst x = fst y) by (apply (touch_one_value _ _ _ _ _ _ H); assumption).
    apply Same; auto. apply not_true_iff_false in V. rewrite eq_decides in V.
    apply Rminus_diag_uniq. apply Rmult_eq_reg_l with (fst (R2 b) - fst (R2 a)).
    + rewrite On, E1. ring.
    + unfold point_of; cbn [fst]. lra.
  - assert (E1 : snd x = snd y) by (apply (touch_one_value _ _ _ _ _ _ H); assumption).
    apply Same; auto. apply not_true_iff_false in V. rewrite eq_decides in V.
    apply Rminus_diag_uniq. apply Rmult_eq_reg_l with (snd (R2 b) - snd (R2 a)).
    + rewrite <- On, E1. ring.
    + unfold point_of; cbn [snd]. lra.
Qed.

(** ** Between two walls *)
Definition ht (e : edge) (u : R) : R :=
  snd (R2 (fst e)) + (u - fst (R2 (fst e))) * (snd (R2 (snd e)) - snd (R2 (fst e))) /
    (fst (R2 (snd e)) - fst (R2 (fst e))).
Lemma height_real x e : fst (R2 (fst e)) <> fst (R2 (snd e)) ->
  Q2R (height_at x e) = ht e (Q2R x).
Proof.
  destruct e as [a b]. unfold height_at, ht, point_of; cbn [fst snd]. intros N.
  rewrite Q2R_red, Q2R_plus, Q2R_div, Q2R_mult, !Q2R_minus; [reflexivity|].
  intros Z. apply Qeq_eqR in Z. rewrite Q2R_minus, zero_real in Z. lra.
Qed.
Lemma spans_real x0 x1 e : spans x0 x1 e = true ->
  let a := fst (R2 (fst e)) in let b := fst (R2 (snd e)) in
  (a < b /\ a <= Q2R x0 /\ Q2R x1 <= b) \/ (b < a /\ b <= Q2R x0 /\ Q2R x1 <= a).
Proof.
  unfold spans. rewrite orb_true_iff, !andb_true_iff, !le_true, !less_true. unfold point_of.
  cbn [fst snd]. tauto.
Qed.
Lemma turn_real e : turn_of e = (if Rlt_dec (fst (R2 (snd e))) (fst (R2 (fst e))) then 1 else -1)%Z.
Proof.
  unfold turn_of. rewrite less_decides. unfold point_of. cbn [fst snd].
  destruct (Rlt_dec (Q2R (fst (snd e))) (Q2R (fst (fst e)))); reflexivity.
Qed.
Section Walls.
Variables (x0 x1 : Q) (u : R).
Hypothesis Between : Q2R x0 < u < Q2R x1.

Lemma crossing_spanning e y : spans x0 x1 e = true -> fst y = u ->
  crossing (R2 (fst e)) (R2 (snd e)) y = if Rlt_dec (snd y) (ht e u) then turn_of e else 0%Z.
Proof.
  intros S U. apply spans_real in S. rewrite turn_real.
  assert (O : orient (R2 (fst e)) (R2 (snd e)) y =
              (fst (R2 (snd e)) - fst (R2 (fst e))) * (snd y - ht e u)).
  { unfold ht, orient. rewrite U. destruct S as [S|S]; field; lra. }
  unfold crossing. rewrite O, U.
  destruct S as [(L & A & B)|(L & A & B)]; split_decisions; try reflexivity; exfalso; nra.
Qed.
Lemma crossing_beside e y : is_beside x0 x1 e = true -> fst y = u ->
  crossing (R2 (fst e)) (R2 (snd e)) y = 0%Z.
Proof.
  unfold is_beside. rewrite orb_true_iff, !andb_true_iff, !le_true. intros S U.
  change (Q2R (fst (fst e))) with (fst (R2 (fst e))) in S.
  change (Q2R (fst (snd e))) with (fst (R2 (snd e))) in S.
  unfold crossing. rewrite U. split_decisions; try reflexivity; exfalso; lra.
Qed.

Definition sum_above (t : R) (S : list edge) : Z :=
  fold_right (fun e n => ((if Rlt_dec t (ht e u) then turn_of e else 0) + n)%Z) 0%Z S.
Lemma winding_above_ E y : forallb (fun e => spans x0 x1 e || is_beside x0 x1 e) E = true ->
  fst y = u -> winding (map R2e E) y = sum_above (snd y) (filter (spans x0 x1) E).
Proof.
  intros H U. induction E as [|e E IH]; [reflexivity|]. cbn [forallb] in H.
  apply andb_prop in H. destruct H as [H K]. cbn [map filter]. unfold R2e at 1.
  rewrite winding_cons, IH by auto. destruct (spans x0 x1 e) eqn:S.
  - rewrite (crossing_spanning _ _ S U). reflexivity.
  - cbn [orb] in H. rewrite (crossing_beside _ _ H U). reflexivity.
Qed.
Lemma ordered_real e f : spans x0 x1 e = true -> spans x0 x1 f = true ->
  are_ordered (heights x0 x1 e) (heights x0 x1 f) = true ->
  let m g := Q2R (middle_of (heights x0 x1 g)) in
  (m e < m f /\ ht e u < ht f u) \/ (m f < m e /\ ht f u < ht e u).
Proof.
  intros Se Sf. apply spans_real in Se. apply spans_real in Sf.
  unfold are_ordered, middle_of, heights. cbn [fst snd].
  rewrite andb_true_iff, negb_true_iff, le_true. intros [P N]. apply not_true_iff_false in N.
  rewrite eq_decides in N. rewrite Q2R_mult, !Q2R_minus in P. rewrite Q2R_plus, !Q2R_minus in N.
  rewrite zero_real in P, N. rewrite !Q2R_plus.
  assert (Ne : fst (R2 (fst e)) <> fst (R2 (snd e))) by lra.
  assert (Nf : fst (R2 (fst f)) <> fst (R2 (snd f))) by lra.
  rewrite !(height_real _ e), !(height_real _ f) in * by auto.
  assert (Lin : forall g, fst (R2 (fst g)) <> fst (R2 (snd g)) -> ht g u * (Q2R x1 - Q2R x0) =
    (Q2R x1 - u) * ht g (Q2R x0) + (u - Q2R x0) * ht g (Q2R x1)).
  { intros g Ng. unfold ht. field. lra. }
  pose proof (Lin e Ne) as Le. pose proof (Lin f Nf) as Lf. clear Lin Se Sf Ne Nf.
  pose proof Between as B. revert P N Le Lf B. generalize (ht e u) (ht f u). intros eu fu.
  generalize (ht e (Q2R x0)) (ht e (Q2R x1)) (ht f (Q2R x0)) (ht f (Q2R x1)).
  intros e0 e1 f0 f1. generalize (Q2R x0) (Q2R x1). intros w0 w1 P N Le Lf B.
  assert (D : (eu - fu) * (w1 - w0) = (w1 - u) * (e0 - f0) + (u - w0) * (e1 - f1))
    by (rewrite Rmult_minus_distr_r, Le, Lf; ring).
  assert (D' : (fu - eu) * (w1 - w0) = (w1 - u) * (f0 - e0) + (u - w0) * (f1 - e1))
    by (rewrite Rmult_minus_distr_r, Le, Lf; ring).
  destruct (Rlt_dec 0 (e0 - f0 + (e1 - f1))) as [L|L].
  - right. assert (0 <= e0 - f0 /\ 0 <= e1 - f1) by (split; apply Rnot_lt_le; intros M; nra).
    split; [lra|]. assert (0 < (eu - fu) * (w1 - w0)); [|nra]. rewrite D.
    destruct (Rlt_dec 0 (e0 - f0)); nra.
  - left. assert (e0 - f0 <= 0 /\ e1 - f1 <= 0) by (split; apply Rnot_lt_le; intros M; nra).
    split; [lra|]. assert (0 < (fu - eu) * (w1 - w0)); [|nra].
    rewrite D'.
    destruct (Rlt_dec (e0 - f0) 0); nra.
Qed.
Lemma lowest_above (t : R) (S : list edge) : (forall e, In e S -> ~ t < ht e u) \/
  exists l e r, S = l ++ e :: r /\ t < ht e u /\
    forall f, In f (l ++ r) -> t < ht f u -> ht e u <= ht f u.
Proof.
  induction S as [|e S IH]; [left; intros e []|].
  destruct IH as [IH|(l & g & r & -> & G & K)].
  - destruct (Rlt_dec t (ht e u)) as [L|L].
    + right. exists [], e, S. split; [reflexivity|split; [exact L|]].
      intros f I J. destruct (IH f I J).
    + left. intros f [<-|I]; auto.
  - right. destruct (Rlt_dec t (ht e u)) as [L|L]; [destruct (Rle_dec (ht e u) (ht g u)) as [M|M]|].
    + exists [], e, (l ++ g :: r). split; [reflexivity|split; [exact L|]].
      intros f I J. cbn [app] in I. apply in_app_or in I. destruct I as [I|[<-|I]]; auto.
      * apply Rle_trans with (ht g u); auto. apply K; auto with datatypes.
      * apply Rle_trans with (ht g u); auto. apply K; auto with datatypes.
    + exists (e :: l), g, r. split; [reflexivity|split; [exact G|]].
      intros f [<-|I] J; [lra|auto].
    + exists (e :: l), g, r. split; [reflexivity|split; [exact G|]].
      intros f [<-|I] J; [destruct (L J)|auto].
Qed.
Lemma sum_above_app t l r : sum_above t (l ++ r) = (sum_above t l + sum_above t r)%Z.
Proof.
  unfold sum_above. induction l as [|e l IH]; cbn [app fold_right]; [reflexivity|].
  rewrite IH. lia.
Qed.
Lemma turns_above_app e l r : turns_above e (l ++ r) = (turns_above e l + turns_above e r)%Z.
Proof.
  unfold turns_above. induction l as [|f l IH]; cbn [app fold_right]; [reflexivity|].
  rewrite IH. lia.
Qed.
Lemma same_sums t e S : (forall f, In f S -> (t < ht f u <->
    Q2R (middle_of (heights x0 x1 e)) < Q2R (middle_of (heights x0 x1 f)))) ->
  sum_above t S = turns_above (heights x0 x1 e) (map (heights x0 x1) S).
Proof.
  intros H. induction S as [|f S IH]; [reflexivity|].
  unfold sum_above, turns_above in *. cbn [map fold_right].
  rewrite IH by (intros g I; apply H; right; exact I). f_equal. rewrite less_decides.
  pose proof (H f (or_introl eq_refl)) as K. cbn [heights fst] in *.
  destruct (Rlt_dec t (ht f u)) as [L|L];
    destruct (Rlt_dec (Q2R (middle_of (heights x0 x1 e))) (Q2R (middle_of (heights x0 x1 f))))
      as [M|M]; auto; exfalso; tauto.
Qed.
Lemma alternate_once E y : alternate x0 x1 E = true -> fst y = u ->
  winding (map R2e E) y = 0%Z \/ winding (map R2e E) y = 1%Z.
Proof.
  unfold alternate. rewrite !andb_true_iff. intros [[A P] T] U.
  rewrite (winding_above_ E y A U).
  assert (Sp : forall e, In e (filter (spans x0 x1) E) -> spans x0 x1 e = true)
    by (intros e I; apply filter_In in I; tauto).
  revert P T Sp. generalize (filter (spans x0 x1) E). clear E A. intros S P T Sp.
  destruct (lowest_above (snd y) S) as [N|(l & e & r & -> & L & K)].
  - left. unfold sum_above. induction S as [|e S IH]; [reflexivity|]. cbn [fold_right].
    destruct (Rlt_dec (snd y) (ht e u)) as [L|_]; [destruct (N e (or_introl eq_refl) L)|].
    change (sum_above (snd y) S = 0%Z). clear - N. induction S as [|f S IH]; [reflexivity|].
    unfold sum_above in *. cbn [fold_right].
    destruct (Rlt_dec (snd y) (ht f u)) as [L|_];
      [destruct (N f (or_intror (or_introl eq_refl)) L)|].
    apply IH. intros g [<-|I]; apply N; simpl; auto.
  - apply all_pairs_hold in P. rewrite map_app in P. cbn [map] in P.
    destruct (pairs_at _ _ _ _ P) as [Pl Pr].
    assert (O : forall f, In f (l ++ r) ->
      let m g := Q2R (middle_of (heights x0 x1 g)) in
      (m e < m f /\ ht e u < ht f u) \/ (m f < m e /\ ht f u < ht e u)).
    { intros f I. assert (Se : spans x0 x1 e = true) by (apply Sp; auto with datatypes).
      assert (Sf : spans x0 x1 f = true)
        by (apply Sp; apply in_app_or in I; destruct I; auto with datatypes).
      apply in_app_or in I. destruct I as [I|I].
      - apply or_comm, (ordered_real f e Sf Se), Pl, in_map, I.
      - apply (ordered_real e f Se Sf), Pr, in_map, I. }
    assert (Q : forall f, In f (l ++ r) -> (snd y < ht f u <->
      Q2R (middle_of (heights x0 x1 e)) < Q2R (middle_of (heights x0 x1 f)))).
    { intros f I. pose proof (O f I) as Of. cbv zeta in Of. split; intros M.
      - pose proof (K f I M). lra.
      - lra. }
    rewrite sum_above_app. change (e :: r) with ([e] ++ r). rewrite sum_above_app.
    rewrite (same_sums _ e l) by (intros f I; apply Q, in_or_app; auto).
    rewrite (same_sums _ e r) by (intros f I; apply Q, in_or_app; auto).
    rewrite forallb_forall in T. specialize (T (heights x0 x1 e)).
    rewrite map_app in T. cbn [map] in T.
    change (heights x0 x1 e :: map (heights x0 x1) r) with ([heights x0 x1 e] ++ map (heights x0 x1)
      r) in T.
    rewrite !turns_above_app in T.
    assert (Self : turns_above (heights x0 x1 e) [heights x0 x1 e] = 0%Z).
    { unfold turns_above. cbn [fold_right]. rewrite less_decides.
      destruct (Rlt_dec _ _); [lra|reflexivity]. }
    rewrite Self in T. specialize (T ltac:(auto with datatypes)). apply Z.eqb_eq in T.
    assert (One : sum_above (snd y) [e] = turn_of e).
    { unfold sum_above. cbn [fold_right]. destruct (Rlt_dec (snd y) (ht e u)); [lia|tauto]. }
    rewrite One.
    change (fst (heights x0 x1 e)) with e in T. rewrite turn_real in *.
    destruct (Rlt_dec (fst (R2 (snd e))) (fst (R2 (fst e)))); cbn [Z.eqb Pos.eqb] in T; lia.
Qed.
End Walls.

(** ** All abscissas *)
Lemma last_from {A} (z x : A) r : last (z :: r) x = last r z.
Proof.
  revert z x. induction r as [|w r IH]; intros z x; [reflexivity|].
  change (last (z :: w :: r) x) with (last (w :: r) x). rewrite !IH. reflexivity.
Qed.
Lemma walls_around u x r : Q2R x < u < Q2R (last r x) ->
  (forall z, In z (x :: r) -> Q2R z <> u) ->
  exists w, In w (combine (x :: r) r) /\ Q2R (fst w) < u < Q2R (snd w).
Proof.
  revert x. induction r as [|z r IH]; intros x L N; [simpl in L; lra|].
  rewrite last_from in L. destruct (Rlt_dec u (Q2R z)) as [M|M].
  - exists (x, z). split; [left; reflexivity|]. cbn [fst snd]. lra.
  - assert (Q2R z <> u) by (apply N; simpl; auto).
    destruct (IH z ltac:(lra)) as (w & I & W); [intros y I; apply N; right; exact I|].
    exists w. split; [right; exact I|exact W].
Qed.
Lemma free_above (u : R) (l : list Q) : exists d, 0 < d /\
  forall v, u < v < u + d -> forall z, In z l -> Q2R z <> v.
Proof.
  induction l as [|x l (d & D & H)]; [exists 1; split; [lra|intros v _ z []]|].
  destruct (Rlt_dec u (Q2R x)) as [L|L].
  - exists (Rmin d (Q2R x - u)). split; [apply Rmin_glb_lt; lra|].
    pose proof (Rmin_l d (Q2R x - u)). pose proof (Rmin_r d (Q2R x - u)).
    intros v V z [<-|I]; [lra|]. apply H; auto. lra.
  - exists d. split; auto. intros v V z [<-|I]; [lra|auto].
Qed.
Lemma beyond_walls E y l h : forallb (within_walls l h) E = true ->
  fst y < Q2R l \/ Q2R h < fst y -> winding (map R2e E) y = 0%Z.
Proof.
  intros H O. induction E as [|e E IH]; [reflexivity|]. cbn [forallb] in H.
  apply andb_prop in H. destruct H as [H K]. cbn [map]. unfold R2e at 1.
  rewrite winding_cons, IH by auto. unfold within_walls in H.
  rewrite !andb_true_iff, !le_true in H.
  change (Q2R (fst (fst e))) with (fst (R2 (fst e))) in H.
  change (Q2R (fst (snd e))) with (fst (R2 (snd e))) in H.
  unfold crossing. split_decisions; try reflexivity; exfalso; lra.
Qed.
Lemma wind_once_holds E : closed (map R2e E) -> wind_once E = true -> once (map R2e E).
Proof.
  intros C W y Off.
  assert (Gen : exists y', winding (map R2e E) y' = winding (map R2e E) y /\
    forall z, In z (abscissas E) -> Q2R z <> fst y').
  { destruct (winding_here (map R2e E) y C) as (e & He & K).
    { intros (a & b & I & O). exact (Off a b I O). }
    destruct (free_above (fst y) (abscissas E)) as (d & D & F).
    assert (M : 0 < Rmin e d / 2) by (assert (0 < Rmin e d) by (apply Rmin_glb_lt; auto); lra).
    pose proof (Rmin_l e d). pose proof (Rmin_r e d).
    exists (fst y + Rmin e d / 2, snd y). split.
    - apply K. unfold near; cbn [fst snd]. split; apply Rabs_def1; lra.
    - apply F. cbn [fst]. lra. }
  destruct Gen as (y' & <- & N). clear Off y. unfold wind_once in W.
  destruct (abscissas E) as [|x r].
  - destruct E; [left; reflexivity|discriminate].
  - apply andb_prop in W. destruct W as [B W]. rewrite forallb_forall in W.
    destruct (Rlt_dec (fst y') (Q2R x)); [left; apply (beyond_walls _ _ _ _ B); auto|].
    destruct (Rlt_dec (Q2R (last r x)) (fst y')); [left; apply (beyond_walls _ _ _ _ B); auto|].
    assert (Q2R x <> fst y') by (apply N; left; reflexivity).
    assert (Q2R (last r x) <> fst y').
    { apply N. clear. revert x. induction r as [|z r IH]; intros x; [left; reflexivity|].
      rewrite last_from. right. apply IH. }
    destruct (walls_around (fst y') x r ltac:(lra) N) as (w & I & V).
    apply (alternate_once _ _ _ V _ _ (W w I) eq_refl).
Qed.

(** ** Sets that are taken *)
Lemma not_null e : negb (is_null e) = true -> fst (R2e e) <> snd (R2e e).
Proof.
  unfold is_null, is_vertical, is_level, R2e. cbn [fst snd]. rewrite negb_true_iff. intros H Q.
  apply not_true_iff_false in H. apply H. rewrite andb_true_iff, !eq_decides.
  unfold point_of in Q. injection Q; intros. auto.
Qed.
Lemma set_is_drawn r : is_set r = true -> drawn (all_edges (points r)) (set_of (points r)).
Proof.
  unfold is_set. rewrite !andb_true_iff. intros [[[L N] T] W]. apply winds_once_is_drawn.
  rewrite forallb_forall in L, N. apply all_pairs_hold in T. repeat apply conj.
  - intros ring I. apply in_map_iff in I. destruct I as (l & <- & I). rewrite map_length.
    apply Nat.leb_le, L, I.
  - intros e I. rewrite <- edges_of_points in I. apply in_map_iff in I.
    destruct I as (f & <- & I). apply not_null, N, I.
  - rewrite <- edges_of_points. unfold share_points_only. clear - T.
    induction T as [|e E F T IH]; cbn [map]; constructor; auto.
    apply Forall_forall. intros g I. apply in_map_iff in I. destruct I as (f & <- & I).
    rewrite Forall_forall in F. apply touch_at_most_holds, F, I.
  - rewrite <- edges_of_points. apply wind_once_holds; auto. rewrite edges_of_points.
    apply rings_are_closed.
Qed.
Lemma taken_is_drawn r : is_taken r = true -> drawn (all_edges (points r)) (set_of (points r)).
Proof.
  intros H. destruct r as [|[|a [|b [|c l]]] [|k r]]; try (apply set_is_drawn; exact H).
  - apply (legal_is_drawn [([R2 a], [])]). left. exists (R2 a). reflexivity.
  - apply (legal_is_drawn [([R2 a; R2 b], [])]). right. left. exists (R2 a), (R2 b).
    split; [apply (not_null (a, b)), H|reflexivity].
Qed.

(** The sets are not assumed to be anything: where there is an answer it is right. *)
Theorem decided_points_are_right : forall (s : Q) (P Q : rings vertex) (xs : list vertex)
    (answers : list bool), decide_points s P Q xs = Some answers ->
  Forall2 (fun x is_in => is_in = true <->
    in_sum (Q2R s) (points P) (points Q) (point_of x)) xs answers.
Proof.
  intros s P Q xs answers H. unfold decide_points in H.
  destruct (less 0 s) eqn:S; [|discriminate]. destruct (is_taken P) eqn:TP; [|discriminate].
  destruct (is_taken Q) eqn:TQ; [|discriminate]. cbn [andb] in H. injection H; intros <-.
  apply less_true in S. rewrite zero_real in S. clear H.
  induction xs as [|x xs IH]; cbn [map]; constructor; auto.
  apply decide_membership_is_right; auto using taken_is_drawn.
Qed.
