(** Of the rings that are traced around a class exactly one has an area above 0, and all others one
    below. *)
From Coq Require Import Lra Lia Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique Beside.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Kept Frontier
  Linked Coloured Upright Traced Bordered Rows Ringed Permuted Cycles Passing Bounding Outlined
  Outlines Areas Circled.
Open Scope R_scope.

(** ** Lists *)
Lemma pairs_differ {A} (R : A -> A -> Prop) l : NoDup l ->
  (forall a b, In a l -> In b l -> a <> b -> R a b) -> ForallOrdPairs R l.
Proof.
  induction l as [|a l IH]; intros D H; constructor; inversion D; subst.
  - apply Forall_forall. intros b I. apply H; simpl; auto. intros ->. contradiction.
  - apply IH; auto. intros b c I J. apply H; simpl; auto.
Qed.
Lemma one_chosen {A} (f : A -> Z) (test : A -> bool) l :
  (forall a, In a l -> f a = 1%Z /\ test a = true \/ f a = 0%Z /\ test a = false) ->
  sumz f l = 1%Z -> exists a, filter test l = [a].
Proof.
  intros H S. assert (G : sumz f l = Z.of_nat (length (filter test l))).
  { clear S. induction l as [|a l IH]; [reflexivity|]. cbn [filter sumz fold_right].
    change (f a + sumz f l = Z.of_nat (length (if test a then a :: filter test l else
      filter test l)))%Z.
    rewrite IH by (intros b I; apply H; simpl; auto).
    destruct (H a (or_introl eq_refl)) as [[-> ->]|[-> ->]]; cbn [length]; lia. }
  rewrite G in S. destruct (filter test l) as [|a [|b k]]; cbn [length] in S; try lia. eauto.
Qed.
Lemma two_parts {A} (p q : A -> bool) l : (forall a, In a l -> q a = negb (p a)) ->
  Permutation (filter p l ++ filter q l) l.
Proof.
  induction l as [|a l IH]; intros H; [constructor|]. cbn [filter].
  assert (G : Permutation (filter p l ++ filter q l) l)
    by (apply IH; intros b I; apply H; simpl; auto).
  rewrite (H a (or_introl eq_refl)). destruct (p a); cbn [negb].
  - apply perm_skip, G.
  - apply Permutation_trans with (a :: filter p l ++ filter q l); [|apply perm_skip, G].
    apply Permutation_sym, Permutation_middle.
Qed.
Lemma filter_map {A C} (test : C -> bool) (g : A -> C) l :
  filter test (map g l) = map g (filter (fun a => test (g a)) l).
Proof. induction l as [|a l IH]; simpl; auto. destruct (test (g a)); simpl; congruence. Qed.
Lemma winding_perm E F y : Permutation E F -> winding E y = winding F y.
Proof. apply (sumz_perm (fun e : point * point => crossing (fst e) (snd e) y)). Qed.
Lemma winding_concat L y :
  winding (map R2e (concat L)) y = sumz (fun l => winding (map R2e l) y) L.
Proof.
  induction L as [|l L IH]; [reflexivity|]. cbn [concat sumz fold_right]. rewrite map_app.
  change (winding (map R2e l ++ map R2e (concat L)) y =
    (winding (map R2e l) y + sumz (fun l => winding (map R2e l) y) L)%Z). rewrite <- IH.
  apply (sumz_app (fun e : point * point => crossing (fst e) (snd e) y)).
Qed.

Section Outer.
Variable S : point -> Prop.
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.
Hypothesis steady_off : forall x, ~ over_some B x -> steady S x.
Variable K : list (list cell).
Hypothesis falls : falls_into (interior S) (fun i => part_of (interior S) (nth i K [])) (length K).
Variable A : list cell.
Hypothesis A_class : In A K.
Variable high : R.
Hypothesis to_high : forall y, S y -> snd y <= high.
Let E := filter (bounds all A) B.
Let C := part_of (interior S) A.
Let loops := traces (length E) E E.
Let rows l := in_rows (from_least l).

Lemma class_apart : ForallOrdPairs no_common E.
Proof. apply pairs_filter, (boundary_apart is_in all all_forward). Qed.
Lemma class_avoids e x : In e E -> lies_on e x -> ~ C x.
Proof.
  apply (piece_avoids S C (map R2e B) (class_part S is_in all steady_off K falls A A_class) E
    (class_long S is_in all all_forward decided A)).
  intros f y J Y. apply filter_In in J. destruct J as [J Bo].
  exact (piece_borders S is_in all all_forward decided constant K falls A f y A_class J Bo Y).
Qed.
Lemma class_joined x y : C x -> C y -> joined C x y.
Proof. apply (class_part S is_in all steady_off K falls A A_class). Qed.
Lemma class_point : exists x, C x.
Proof.
  destruct (In_nth K A [] A_class) as (i & L & Q). destruct falls as [_ Each].
  destruct (Each i L) as (Some_ & _). cbv beta in Some_. rewrite Q in Some_. exact Some_.
Qed.

Section Loop.
Let nexts := class_nexts S is_in all all_forward decided constant steady_off K falls A A_class.
Variable l : list edge.
Hypothesis traced : In l loops.
Lemma loop_cycle : is_cycle E l.
Proof.
  apply (class_traces S is_in all all_forward decided constant steady_off K falls A A_class).
  exact traced.
Qed.
Lemma loop_within e : In e l -> In e E.
Proof.
  intros I. destruct (class_traces S is_in all all_forward decided constant steady_off K falls A
    A_class) as [P _]. apply (Permutation_in _ P), in_concat. exists l. auto.
Qed.
Lemma loop_apart : ForallOrdPairs no_common l.
Proof.
  destruct loop_cycle as (_ & _ & _ & _ & D). apply (pairs_differ _ l D).
  intros a b I J N x X Y. apply N.
  exact (apart_equal E class_apart a b x (loop_within a I) (loop_within b J) X Y).
Qed.
Lemma loop_some : l <> [].
Proof.
  destruct loop_cycle as (e & z & R & _). intros Q. pose proof (run_first E _ _ _ R) as F.
  rewrite Q in F. destruct F.
Qed.
Lemma run_ends e k z : run E e k z -> (forall a, In a k -> In a E) ->
  Permutation (finish z :: map start k) (start e :: map finish k).
Proof.
  induction 1 as [e|e f k z N R IH]; intros Sub; [apply perm_swap|]. cbn [map].
  destruct (nexts e f) as [_ Q]; auto; [apply Sub; simpl; auto|].
  apply Permutation_trans with (start e :: finish z :: map start k); [apply perm_swap|].
  apply perm_skip. rewrite Q. apply IH. intros a I. apply Sub. simpl. auto.
Qed.
Lemma loop_closes : closed (map R2e l).
Proof.
  destruct loop_cycle as (e & z & R & N & _). unfold closed. rewrite !map_map.
  change (Permutation (map start l) (map finish l)).
  pose proof (run_ends e l z R loop_within) as P.
  destruct (nexts z e) as [_ Q]; auto; [apply loop_within, (run_last E _ _ _ R)|].
  rewrite Q in P. exact (Permutation_cons_inv P).
Qed.

(** ** The ring from its least vertex, in rows *)
Let ring := map R2 (corners_of (rows l)).
Lemma rows_parts : (forall r, In r (rows l) -> is_straight r = true) /\
  (forall e, In e (concat (rows l)) -> start e <> finish e) /\
  ring_edges ring = map real_edge (rows l).
Proof.
  destruct (class_rings_pass S is_in all all_forward decided constant steady_off K falls A A_class l
    traced) as [P _]. fold (rows l) in P. unfold is_closed_ring in P.
  rewrite !andb_true_iff, !forallb_forall in P. destruct P as [[[_ St] Be] _].
  split; [exact St|split].
  - intros e I. unfold rows in I. rewrite (proj1 (in_rows_pieces _)) in I.
    apply (Permutation_in _ (from_least_members l)) in I.
    apply (class_long S is_in all all_forward decided A), loop_within, I.
  - apply corners_edges. intros r k J. pose proof (Be (r, k) J) as H. unfold bends in H.
    apply andb_true_iff in H. apply same_real, H.
Qed.
Lemma rows_perm : Permutation (concat (rows l)) l.
Proof. unfold rows. rewrite (proj1 (in_rows_pieces _)). apply from_least_members. Qed.
Lemma ring_winds y : winding (ring_edges ring) y = winding (map R2e l) y.
Proof.
  destruct rows_parts as (St & Lo & ->). rewrite (rows_wind (rows l) y St Lo).
  apply winding_perm, Permutation_map, rows_perm.
Qed.
Lemma ring_over y : on_some (ring_edges ring) y <-> over_some l y.
Proof.
  destruct rows_parts as (St & Lo & ->). rewrite (rows_cover (rows l) y St Lo).
  split; intros (e & I & O); exists e; split; auto; apply (Permutation_in _ rows_perm), I ||
    apply (Permutation_in _ (Permutation_sym rows_perm)), I.
Qed.
Lemma loop_area x : C x ->
  (winding (map R2e l) x = 1%Z /\ 0 < area ring) \/ (winding (map R2e l) x = 0%Z /\ area ring < 0).
Proof.
  intros Cx. destruct (ring_sign C class_joined x Cx E
    (class_long S is_in all all_forward decided A)
    (class_sided S is_in all all_forward decided constant K falls A A_class) class_avoids l
    loop_within loop_apart loop_some loop_closes) as [(Z & H & y & N & W)|(Z & H & y & N & W)];
    [left|right]; (split; [exact Z|]); [apply area_above|apply area_below];
    try (intros z Nz; rewrite ring_winds; apply H; rewrite <- ring_over; exact Nz);
    exists y; rewrite ring_over, ring_winds; auto.
Qed.
Lemma loop_tests x : C x -> exists one : bool,
  winding (map R2e l) x = (if one then 1 else 0)%Z /\
  less 0 (twice_area (corners_of (rows l))) = one /\
  less (twice_area (corners_of (rows l))) 0 = negb one.
Proof.
  intros Cx. destruct (loop_area x Cx) as [[Z P]|[Z P]]; [exists true|exists false];
    (split; [exact Z|]); unfold ring in P; rewrite <- twice_area_real, <- zero_real in P; split;
    try (apply less_real, P); apply not_true_iff_false; rewrite less_real; lra.
Qed.
End Loop.

Lemma loops_together x : C x -> sumz (fun l => winding (map R2e l) x) loops = 1%Z.
Proof.
  intros Cx. rewrite <- winding_concat.
  destruct (class_traces S is_in all all_forward decided constant steady_off K falls A A_class)
    as [P _]. transitivity (winding (map R2e E) x); [exact (winding_perm _ _ x
    (Permutation_map R2e P))|].
  apply (wound_once C (class_open S K falls A A_class) x Cx high) with
    (few := map start B ++ map finish B).
  - intros y Y. apply to_high, (class_in S A y Y).
  - exact (class_long S is_in all all_forward decided A).
  - exact (class_sided S is_in all all_forward decided constant K falls A A_class).
  - exact class_avoids.
  - exact (class_steady S is_in all all_forward decided constant steady_off K falls A A_class).
  - exact class_apart.
  - exact (class_closes S is_in all all_forward decided constant steady_off K falls A A_class).
Qed.
Theorem one_outer_ring : exists r, fst (snd (outline all B A)) = [r] /\
  less 0 (twice_area (corners_of r)) = true.
Proof.
  destruct class_point as (x & Cx).
  destruct (one_chosen (fun l => winding (map R2e l) x)
    (fun l => less 0 (twice_area (corners_of (rows l)))) loops) as (l & Q).
  - intros l I. destruct (loop_tests l I x Cx) as ([|] & W & T & _); auto.
  - apply loops_together, Cx.
  - exists (rows l). split.
    + unfold outline. cbv zeta. cbn [fst snd]. fold E loops.
      change (fun l => in_rows (from_least l)) with rows. rewrite filter_map.
      exact (f_equal (map rows) Q).
    + assert (I : In l [l]) by (simpl; auto). rewrite <- Q in I. apply filter_In in I. apply I.
Qed.
Theorem holes_negative :
  forallb (fun r => less (twice_area (corners_of r)) 0) (snd (snd (outline all B A))) = true.
Proof.
  apply forallb_forall. intros r I. unfold outline in I. cbv zeta in I. cbn [fst snd] in I.
  apply (Permutation_in _ (sort_members _ _)) in I. apply filter_In in I. apply I.
Qed.
(** No ring is left out. *)
Theorem all_rings_kept : Permutation (rings_of_outline (outline all B A))
  (map (fun l => in_rows (from_least l)) (traces (length E) E E)).
Proof.
  destruct class_point as (x & Cx). unfold rings_of_outline, outline. cbv zeta. cbn [fst snd].
  fold E loops. change (fun l => in_rows (from_least l)) with rows.
  eapply Permutation_trans; [apply Permutation_app_head, sort_members|]. apply two_parts.
  intros r I. apply in_map_iff in I. destruct I as (l & <- & I).
  destruct (loop_tests l I x Cx) as (one & _ & -> & ->). reflexivity.
Qed.
End Outer.
