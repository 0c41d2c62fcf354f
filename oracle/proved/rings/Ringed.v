(** The test of rings, in real points: rings of rows, apart, each passing a point once. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Paths Decomposed
  Gaps Unique Rounds.
From Proved Require Import Points Member Pieces Along Cuts Lone Flanks Parted Disjoint Traced Rows.
Open Scope R_scope.

(** ** Tests of lists *)
Lemma each_pair_holds {A} (test : A -> A -> bool) l : each_pair test l = true ->
  ForallOrdPairs (fun x y => test x y = true) l.
Proof.
  induction l as [|x l IH]; simpl; intros H; constructor; apply andb_true_iff in H.
  - apply Forall_forall. apply forallb_forall, H.
  - apply IH, H.
Qed.
Lemma exact_same e f : exact_edge e f = true -> e = f.
Proof.
  unfold exact_edge, exact_vertex, exact_number. rewrite !andb_true_iff, !Z.eqb_eq, !Pos.eqb_eq.
  destruct e as [[[a b] [c d]] [[g h] [i j]]], f as [[[a' b'] [c' d']] [[g' h'] [i' j']]]; simpl.
  intros [[[-> ->] [-> ->]] [[-> ->] [-> ->]]]. reflexivity.
Qed.
Lemma ascending_sorted {A} (test : A -> A -> bool) (R : A -> A -> Prop) l :
  (forall x y, test x y = true -> R x y) -> ascending test l = true -> Sorted R l.
Proof.
  intros H. induction l as [|x l IH]; intros T; constructor.
  - destruct l as [|y r]; [constructor|]. apply IH.
    change (test x y && ascending test (y :: r) = true) in T. apply andb_true_iff in T. tauto.
  - destruct l as [|y r]; constructor.
    change (test x y && ascending test (y :: r) = true) in T. apply andb_true_iff in T.
    apply H. tauto.
Qed.
Lemma list_less_real l : forall k, list_less l k = true -> ring_before (map R2 l) (map R2 k).
Proof.
  induction l as [|p l IH]; intros [|q k] H; simpl in *; try discriminate; auto.
  apply orb_true_iff in H. destruct H as [H|H]; [left; apply is_before_real, H|right].
  apply andb_true_iff in H. destruct H as [E H]. apply same_real in E. auto.
Qed.
Lemma twice_area_real l : Q2R (twice_area l) = area (map R2 l).
Proof.
  unfold twice_area, area. rewrite Corners.ring_edges_map.
  induction (ring_edges l) as [|[a b] E IH]; simpl; [apply zero_real|].
  rewrite Q2R_red, Q2R_plus, IH, qcross_real. reflexivity.
Qed.
Lemma sorted_map {A C} (f : A -> C) (R : C -> C -> Prop) l :
  Sorted (fun x y => R (f x) (f y)) l -> Sorted R (map f l).
Proof.
  intros S. induction S as [|x l S IH H]; simpl; constructor; auto.
  destruct H; simpl; constructor; auto.
Qed.

(** ** The same segment *)
Lemma same_ends e f : start e <> finish e -> start f <> finish f ->
  (forall y, lies_on e y -> lies_on f y) -> (forall y, lies_on f y -> lies_on e y) ->
  (start e = start f /\ finish e = finish f) \/ (start e = finish f /\ finish e = start f).
Proof.
  intros Ne Nf H K.
  destruct (on_at f _ (H _ (on_segment_start _ _))) as (s & S & Es).
  destruct (on_at f _ (H _ (on_segment_end _ _))) as (t & T & Et).
  fold (start e) in Es. fold (finish e) in Et.
  destruct (on_at e _ (K _ (on_segment_start _ _))) as (u & U & Eu).
  destruct (on_at e _ (K _ (on_segment_end _ _))) as (v & V & Ev).
  fold (start f) in Eu. fold (finish f) in Ev.
  rewrite Es, Et, at_at in Eu. rewrite Es, Et, at_at in Ev.
  rewrite <- (at_0 (start f) (finish f)) in Eu at 1. apply at_same in Eu; auto.
  rewrite <- (at_1 (start f) (finish f)) in Ev at 1. apply at_same in Ev; auto.
  assert (C : (s = 0 /\ t = 1) \/ (s = 1 /\ t = 0)).
  { destruct (Req_dec s 0) as [Zs|Zs].
    - left. split; auto. subst s. nra.
    - assert (t = 0) by nra. subst t. right. split; auto. nra. }
  destruct C as [[-> ->]|[-> ->]]; rewrite at_0, at_1 in *; auto.
Qed.

Section Pieces_.
Variable G : list edge.
Hypothesis long : forall e, In e G -> start e <> finish e.
Hypothesis alike : forall e f x, In e G -> In f G -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Hypothesis no_end : forall e f, In e G -> In f G -> ~ inside e (start f) /\ ~ inside e (finish f).
Lemma tested_apart : each_pair (fun e f => negb (same_edge e f) && negb (same_edge e (turned_back
  f)))
    G = true -> ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Proof.
  intros T. apply each_pair_holds in T.
  apply (pairs_weaken _ _ _) with (2 := T). intros e f I J H x X Y.
  apply andb_true_iff in H. rewrite !negb_true_iff in H. destruct H as [H1 H2].
  apply not_true_iff_false in H1. apply not_true_iff_false in H2.
  destruct (same_ends e f (long e I) (long f J) (alike e f x I J X Y) (alike f e x J I Y X))
    as [[E1 E2]|[E1 E2]].
  - apply H1. unfold same_edge. rewrite andb_true_iff, !same_real. auto.
  - apply H2. unfold same_edge, turned_back. cbn [fst snd]. rewrite andb_true_iff, !same_real. auto.
Qed.

Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Variable rows : list row.
Hypothesis together : concat rows = G.
Hypothesis straight : forall r, In r rows -> is_straight r = true.
Lemma row_long r : In r rows -> forall e, In e r -> start e <> finish e.
Proof. intros I e J. apply long. rewrite <- together. apply in_concat. exists r. auto. Qed.
Lemma pairs_of_concat {A} (R : A -> A -> Prop) ls : ForallOrdPairs R (concat ls) ->
  ForallOrdPairs (fun l k => forall a b, In a l -> In b k -> R a b) ls.
Proof.
  induction ls as [|l ls IH]; simpl; intros F; constructor.
  - apply Forall_forall. intros k K a b I J. apply in_split in I. destruct I as (u & v & ->).
    rewrite <- app_assoc in F. simpl in F. destruct (pairs_at _ _ _ _ F) as [_ Fr].
    apply Fr. apply in_or_app. right. apply in_concat. exists k. auto.
  - apply IH. clear - F. induction l as [|a l IL]; simpl in *; auto. apply IL.
    inversion F; auto.
Qed.
Lemma pairs_weaken_in {A} (R S : A -> A -> Prop) l : (forall a b, In a l -> In b l -> R a b ->
  S a b) -> ForallOrdPairs R l -> ForallOrdPairs S l.
Proof. exact (pairs_weaken R S l). Qed.
Lemma pairs_and {A} (R S : A -> A -> Prop) l : ForallOrdPairs R l -> ForallOrdPairs S l ->
  ForallOrdPairs (fun a b => R a b /\ S a b) l.
Proof.
  intros F. induction F as [|x l H F IH]; intros K; constructor; inversion K as [|y k K1 K2]; subst.
  - rewrite Forall_forall in *. auto.
  - apply IH, K2.
Qed.
(** Two rows have no more than a point in common. *)
Lemma rows_share_points : ForallOrdPairs (fun e f => forall x y, on_segment (fst e) (snd e) x ->
    on_segment (fst e) (snd e) y -> on_segment (fst f) (snd f) x ->
    on_segment (fst f) (snd f) y -> x = y) (map real_edge rows).
Proof.
  apply pairs_map. assert (F := apart). rewrite <- together in F. apply pairs_of_concat in F.
  apply (pairs_weaken_in _ _ rows) with (2 := F). intros r k I J H x y Xr Yr Xk Yk.
  destruct (classic (x = y)) as [|N]; auto. exfalso.
  destruct (one_not_in (map start G ++ map finish G) x y N) as (w & W & Out).
  destruct (row_is_edge r (straight r I) (row_long r I)) as (_ & On & _).
  destruct (row_is_edge k (straight k J) (row_long k J)) as (_ & On' & _).
  pose proof (segment_in_segment _ _ x y w Xr Yr W) as Wr.
  pose proof (segment_in_segment _ _ x y w Xk Yk W) as Wk.
  destruct (proj1 (On w) Wr) as (p & P & Op). destruct (proj1 (On' w) Wk) as (q & Q & Oq).
  assert (Ins : forall e, In e G -> lies_on e w -> inside e w).
  { intros e Ie O. apply inner_of_segment; auto; intros E; apply Out; rewrite E; apply in_or_app;
      [left; apply (in_map start _ _ Ie)|right; apply (in_map finish _ _ Ie)]. }
  assert (Gp : In p G) by (rewrite <- together; apply in_concat; exists r; auto).
  assert (Gq : In q G) by (rewrite <- together; apply in_concat; exists k; auto).
  apply (H p q P Q w); auto.
Qed.
(** A ring whose pieces end in different points passes no point twice. *)
Lemma ring_once ring : (forall r, In r ring -> In r rows) ->
  ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) (concat ring) ->
  each_pair (fun e f => negb (same (snd e) (snd f))) (concat ring) = true ->
  ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False)
    (map real_edge ring).
Proof.
  intros Sub Ap T. apply each_pair_holds in T. apply pairs_map.
  apply pairs_of_concat in Ap. apply pairs_of_concat in T.
  assert (Both : ForallOrdPairs (fun r k => (forall e f, In e r -> In f k -> forall x, inside e x ->
      inside f x -> False) /\ forall e f, In e r -> In f k -> negb (same (snd e) (snd f)) = true)
      ring).
  { exact (pairs_and _ _ ring Ap T). }
  apply (pairs_weaken_in _ _ ring) with (2 := Both).
  intros r k I J [Ha Hd] x [X1 X2] [Y1 Y2]. unfold real_edge in X1, X2, Y1, Y2.
  cbn [fst snd] in X1, X2, Y1, Y2.
  destruct (row_is_edge r (straight r (Sub r I)) (row_long r (Sub r I))) as (_ & _ & _ & Be & _).
  destruct (row_is_edge k (straight k (Sub k J)) (row_long k (Sub k J))) as (_ & _ & _ & Be' & _).
  destruct (Be x X1 X2) as (p & P & Op & Np). destruct (Be' x Y1 Y2) as (q & Q & Oq & Nq).
  assert (Gp : In p G) by (rewrite <- together; apply in_concat; exists r; auto).
  assert (Gq : In q G) by (rewrite <- together; apply in_concat; exists k; auto).
  destruct (classic (x = finish p)) as [Ep|Mp]; destruct (classic (x = finish q)) as [Eq|Mq].
  - pose proof (Hd p q P Q) as D. apply negb_true_iff, not_true_iff_false in D. apply D.
    apply same_real. fold (finish p) (finish q). congruence.
  - apply (proj2 (no_end q p Gq Gp)). rewrite <- Ep. apply inner_of_segment; auto.
  - apply (proj2 (no_end p q Gp Gq)). rewrite <- Eq. apply inner_of_segment; auto.
  - apply (Ha p q P Q x); apply inner_of_segment; auto.
Qed.
Lemma bends_real r k : In r rows -> In k rows -> bends r k = true ->
  finish (edge_of r) = start (edge_of k) /\
  orient (start (edge_of r)) (finish (edge_of r)) (finish (edge_of k)) <> 0.
Proof.
  intros I J H. unfold bends in H. rewrite andb_true_iff, negb_true_iff, same_real in H.
  destruct H as [E C]. split; [exact E|]. apply not_true_iff_false in C.
  rewrite sg_zero, qcross_real, !dir_real in C. intros O. apply C.
  change (finish (edge_of r) = start (edge_of k)) in E. rewrite <- E.
  rewrite <- O. unfold turn_of, minus_, orient; cbn [fst snd]. ring.
Qed.
End Pieces_.
