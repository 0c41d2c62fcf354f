(** Rows of pieces along one line are edges: with their points, and what they wind. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Local Across Overlaps Paths Decomposed
  Gaps Unique.
From Proved Require Import Points Member Pieces Along Cuts Lone Flanks Traced.
Open Scope R_scope.

Lemma sg_zero q : (sg q =? 0)%Z = true <-> Q2R q = 0.
Proof.
  unfold sg. rewrite Z.eqb_eq, <- zero_real. split; intros H.
  - apply Qeq_eqR. unfold Qeq. simpl. lia.
  - apply eqR_Qeq in H. unfold Qeq in H. simpl in H. lia.
Qed.
Lemma sg_more q : (0 <? sg q)%Z = true <-> 0 < Q2R q.
Proof.
  rewrite sg_pos. destruct (Rlt_dec 0 (Q2R q)); split; auto; try discriminate; lra.
Qed.
Definition way_of (e : edge) : point := minus_ (finish e) (start e).
Lemma goes_on_real e f : start e <> finish e -> goes_on e f = true -> finish e = start f /\
  exists k, 0 < k /\ way_of f = scale k (way_of e).
Proof.
  intros N. unfold goes_on. rewrite !andb_true_iff, same_real, sg_zero, sg_more, qcross_real,
    dot_real, !dir_real. fold (way_of e) (way_of f). intros [[A C] D]. split; [exact A|].
  pose proof (edge_long _ _ N) as L. cbv zeta in L.
  unfold way_of in *. unfold turn_of, minus_ in *; cbn [fst snd] in *.
  set (d1 := fst (finish e) - fst (start e)) in *. set (d2 := snd (finish e) - snd (start e)) in *.
  set (k1 := fst (finish f) - fst (start f)) in *. set (k2 := snd (finish f) - snd (start f)) in *.
  exists ((d1 * k1 + d2 * k2) / (d1 * d1 + d2 * d2)). split; [apply Rdiv_lt_0_compat; auto|].
  unfold scale; cbn [fst snd]. assert (K : (d1 * k1 + d2 * k2) / (d1 * d1 + d2 * d2) *
    (d1 * d1 + d2 * d2) = d1 * k1 + d2 * k2) by (field; lra).
  set (k := (d1 * k1 + d2 * k2) / (d1 * d1 + d2 * d2)) in *.
  f_equal; apply Rmult_eq_reg_r with (d1 * d1 + d2 * d2); try lra; apply Rminus_diag_uniq.
  - transitivity (k1 * (d1 * d1 + d2 * d2) - d1 * (k * (d1 * d1 + d2 * d2))); [ring|]. rewrite K.
    transitivity (- d2 * (d1 * k2 - d2 * k1)); [ring|rewrite C; ring].
  - transitivity (k2 * (d1 * d1 + d2 * d2) - d2 * (k * (d1 * d1 + d2 * d2))); [ring|]. rewrite K.
    transitivity (d1 * (d1 * k2 - d2 * k1)); [ring|rewrite C; ring].
Qed.
Lemma last_any {A} (l : list A) x y z : last (z :: l) x = last (z :: l) y.
Proof. revert z. induction l as [|w l IH]; intros z; [reflexivity|]. exact (IH w). Qed.
Lemma edge_of_more e f k : edge_of (e :: f :: k) = (fst e, snd (edge_of (f :: k))).
Proof. unfold edge_of. cbn [snd]. f_equal. f_equal. exact (last_any k e f f). Qed.

(** Two segments end to end, the second the same way *)
Lemma end_to_end a m d k : 0 < k -> a <> m -> minus_ d m = scale k (minus_ m a) -> exists s,
  0 < s < 1 /\ m = at_ a d s /\ a <> d.
Proof.
  intros K N E. exists (/ (1 + k)). pose proof (Rinv_0_lt_compat (1 + k) ltac:(lra)) as P.
  assert (U : / (1 + k) * (1 + k) = 1) by (field; lra). set (s := / (1 + k)) in *.
  unfold minus_, scale in E; cbn [fst snd] in E. injection E; intros E2 E1.
  assert (D1 : fst d - fst a = (1 + k) * (fst m - fst a)) by lra.
  assert (D2 : snd d - snd a = (1 + k) * (snd m - snd a)) by lra.
  split; [split; nra|split].
  - apply point_eq; unfold at_; cbn [fst snd]; rewrite ?D1, ?D2.
    + transitivity (fst a + s * (1 + k) * (fst m - fst a)); [rewrite U; ring|ring].
    + transitivity (snd a + s * (1 + k) * (snd m - snd a)); [rewrite U; ring|ring].
  - intros ->. apply N. apply point_eq; nra.
Qed.
Lemma cut_in_two a d s x : 0 < s < 1 -> on_segment a d x <->
  on_segment a (at_ a d s) x \/ on_segment (at_ a d s) d x.
Proof.
  intros S. split.
  - intros (t & T & E). change (x = at_ a d t) in E. subst x. destruct (Rle_dec t s).
    + left. rewrite <- (at_0 a d) at 1. apply part_on. lra.
    + right. rewrite <- (at_1 a d) at 2. apply part_on. lra.
  - intros [H|H].
    + rewrite <- (at_0 a d) in H at 1. apply part_range in H; [|lra].
      destruct H as (w & W & ->). apply at_on. lra.
    + rewrite <- (at_1 a d) in H at 2. apply part_range in H; [|lra].
      destruct H as (w & W & ->). apply at_on. lra.
Qed.

Theorem row_is_edge r : is_straight r = true -> (forall e, In e r -> start e <> finish e) ->
  start (edge_of r) <> finish (edge_of r) /\
  (forall x, lies_on (edge_of r) x <-> exists p, In p r /\ lies_on p x) /\
  (forall y, crossing (start (edge_of r)) (finish (edge_of r)) y = winding (map R2e r) y) /\
  (forall x, lies_on (edge_of r) x -> x <> start (edge_of r) ->
    exists p, In p r /\ lies_on p x /\ x <> start p) /\
  Permutation (start (edge_of r) :: map finish r) (finish (edge_of r) :: map start r) /\
  exists k, 0 < k /\ way_of (edge_of r) = scale k (way_of (hd ((0, 0), (0, 0))%Q r)).
Proof.
  induction r as [|e [|f r] IH]; intros St Lo; [discriminate| |].
  - unfold edge_of. cbn [last]. rewrite <- surjective_pairing. cbn [hd].
    split; [apply Lo; simpl; auto|]. split; [|split; [|split; [|split]]].
    + intros x. split; [intros O; exists e; simpl; auto|]. intros (p & [<-|[]] & O). exact O.
    + intros y. cbn [map]. unfold R2e. rewrite winding_cons. cbn [winding fold_right].
      unfold start, finish. lia.
    + intros x O N. exists e. simpl. auto.
    + cbn [map]. apply perm_swap.
    + exists 1. split; [lra|]. unfold scale. destruct (way_of e); cbn [fst snd]. f_equal; ring.
  - cbn [is_straight] in St. change (goes_on e f && is_straight (f :: r) = true) in St.
    apply andb_true_iff in St. destruct St as [Go St].
    destruct IH as (L & On & Cr & Be & Pe & k & K & W); [exact St|intros; apply Lo; simpl; auto|].
    assert (Le : start e <> finish e) by (apply Lo; simpl; auto).
    destruct (goes_on_real e f Le Go) as (Ef & j & J & Wf). cbn [hd] in W.
    assert (Hs : start (edge_of (f :: r)) = start f) by reflexivity.
    rewrite edge_of_more. set (g := edge_of (f :: r)) in *.
    change (start (fst e, snd g)) with (start e). change (finish (fst e, snd g)) with (finish g).
    assert (Way : minus_ (finish g) (finish e) = scale (k * j) (minus_ (finish e) (start e))).
    { change (minus_ (finish e) (start e)) with (way_of e). rewrite Ef, <- Hs.
      change (minus_ (finish g) (start g)) with (way_of g). rewrite W, Wf.
      unfold scale; cbn [fst snd]. f_equal; ring. }
    destruct (end_to_end (start e) (finish e) (finish g) (k * j)) as (s & S & Em & Ne); auto;
      [nra|].
    assert (Lies : forall x, lies_on (fst e, snd g) x <-> lies_on e x \/ lies_on g x).
    { intros x. change (lies_on (fst e, snd g) x) with (on_segment (start e) (finish g) x).
      rewrite (cut_in_two (start e) (finish g) s x S), <- Em.
      unfold lies_on. fold (start e) (finish e) (start g) (finish g). rewrite Hs, Ef. tauto. }
    split; [exact Ne|split; [|split; [|split; [|split]]]].
    + intros x. rewrite Lies, On. split.
      * intros [O|(p & I & O)]; [exists e|exists p]; simpl; auto.
      * intros (p & [<-|I] & O); [left|right; exists p]; auto.
    + intros y. rewrite (crossing_cut (start e) (finish g) (finish e) y) by
        (rewrite Em; apply at_on; lra).
      change (map R2e (e :: f :: r)) with (R2e e :: map R2e (f :: r)). unfold R2e at 1.
      rewrite winding_cons, <- Cr, Hs, <- Ef. reflexivity.
    + intros x O N. apply Lies in O. destruct O as [O|O].
      * exists e. simpl. auto.
      * destruct (classic (x = finish e)) as [->|M].
        { exists e. split; [simpl; auto|split; [apply on_segment_end|auto]]. }
        destruct (Be x O) as (p & I & Op & Np); [rewrite Hs, <- Ef; exact M|].
        exists p. simpl in *. tauto.
    + change (map finish (e :: f :: r)) with (finish e :: map finish (f :: r)).
      change (map start (e :: f :: r)) with (start e :: map start (f :: r)).
      rewrite Ef, <- Hs. apply Permutation_trans with (start e :: finish g :: map start (f :: r));
        [apply perm_skip, Pe|apply perm_swap].
    + exists (1 + k * j). split; [nra|]. cbn [hd]. unfold way_of at 1.
      change (start (fst e, snd g)) with (start e). change (finish (fst e, snd g)) with (finish g).
      pose proof (f_equal fst Way) as W1. pose proof (f_equal snd Way) as W2.
      unfold minus_, scale in W1, W2. cbn [fst snd] in W1, W2.
      unfold way_of, minus_, scale; cbn [fst snd]. f_equal; lra.
Qed.

(** ** Rings of rows *)
Definition real_edge (r : row) : point * point := (start (edge_of r), finish (edge_of r)).
Lemma path_first {A} (l : list A) : forall first previous, map fst (path first previous l) =
  previous :: l.
Proof. intros f p. apply path_closed. Qed.
Lemma ring_first {A} (l : list A) : map fst (ring_edges l) = l.
Proof. destruct l as [|x l]; [reflexivity|apply path_first]. Qed.
Lemma corners_edges ring : (forall r k, In (r, k) (ring_edges ring) ->
    finish (edge_of r) = start (edge_of k)) ->
  ring_edges (map R2 (corners_of ring)) = map real_edge ring.
Proof.
  intros H. unfold corners_of. rewrite map_map.
  change (fun x => R2 (fst (edge_of x))) with (fun x => start (edge_of x)).
  rewrite Corners.ring_edges_map. rewrite <- (ring_first ring) at 2. rewrite map_map.
  apply map_ext_in. intros [r k] I. unfold Corners.both, real_edge; cbn [fst snd].
  rewrite (H r k I). reflexivity.
Qed.
Lemma rows_close rows : (forall r, In r rows -> is_straight r = true) ->
  (forall e, In e (concat rows) -> start e <> finish e) -> closed (map real_edge rows) ->
  closed (map R2e (concat rows)).
Proof.
  intros St Lo C.
  assert (P : Permutation (map (fun r => start (edge_of r)) rows ++ map finish (concat rows))
    (map (fun r => finish (edge_of r)) rows ++ map start (concat rows))).
  { clear C. induction rows as [|r rows IH]; simpl; auto.
    destruct (row_is_edge r) as (_ & _ & _ & _ & Pr & _).
    { apply St. simpl. auto. }
    { intros e I. apply Lo. simpl. apply in_or_app. auto. }
    assert (IH' := IH (fun k K => St k (or_intror K)) (fun e I => Lo e (in_or_app _ _ _ (or_intror
      I)))).
    rewrite !map_app.
    apply Permutation_trans with ((start (edge_of r) :: map finish r) ++
      (map (fun r => start (edge_of r)) rows ++ map finish (concat rows))).
    { simpl. apply perm_skip. rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm.
        }
    apply Permutation_trans with ((finish (edge_of r) :: map start r) ++
      (map (fun r => finish (edge_of r)) rows ++ map start (concat rows))).
    { apply Permutation_app; auto. }
    simpl. apply perm_skip. rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm. }
  unfold closed in *. rewrite !map_map in *. unfold real_edge in C. cbn [fst snd] in C.
  change (map (fun x => fst (R2e x)) (concat rows)) with (map start (concat rows)).
  change (map (fun x => snd (R2e x)) (concat rows)) with (map finish (concat rows)).
  apply Permutation_sym. apply (Permutation_app_inv_l (map (fun r => start (edge_of r)) rows)).
  rewrite P. apply Permutation_app_tail, Permutation_sym, C.
Qed.
Lemma rows_wind rows y : (forall r, In r rows -> is_straight r = true) ->
  (forall e, In e (concat rows) -> start e <> finish e) ->
  winding (map real_edge rows) y = winding (map R2e (concat rows)) y.
Proof.
  intros St Lo. induction rows as [|r rows IH]; [reflexivity|].
  assert (App : forall X Y, winding (X ++ Y) y = (winding X y + winding Y y)%Z).
  { intros X Y. unfold winding. induction X as [|e X IX]; [reflexivity|]. simpl. rewrite IX. lia. }
  change (concat (r :: rows)) with (r ++ concat rows) in *.
  change (map real_edge (r :: rows)) with (real_edge r :: map real_edge rows).
  destruct (row_is_edge r) as (_ & _ & Cr & _).
  { apply St. left. reflexivity. }
  { intros e I. apply Lo, in_or_app. auto. }
  rewrite map_app, App, <- Cr. unfold real_edge at 1. rewrite winding_cons. f_equal.
  apply IH; [intros k K; apply St; right; exact K|].
  intros e I. apply Lo, in_or_app. auto.
Qed.
Lemma rows_cover rows x : (forall r, In r rows -> is_straight r = true) ->
  (forall e, In e (concat rows) -> start e <> finish e) ->
  on_some (map real_edge rows) x <-> over_some (concat rows) x.
Proof.
  intros St Lo. split.
  - intros (a & b & I & O). apply in_map_iff in I. destruct I as (r & E & I).
    unfold real_edge in E. injection E; intros <- <-.
    destruct (row_is_edge r (St r I)) as (_ & On & _).
    { intros e J. apply Lo, in_concat. exists r. auto. }
    apply On in O. destruct O as (p & J & O). exists p. split; auto. apply in_concat. exists r.
      auto.
  - intros (p & J & O). apply in_concat in J. destruct J as (r & I & J).
    exists (start (edge_of r)), (finish (edge_of r)).
    split; [exact (in_map real_edge _ _ I)|].
    destruct (row_is_edge r (St r I)) as (_ & On & _).
    { intros e K. apply Lo, in_concat. exists r. auto. }
    apply On. exists p. auto.
Qed.
(** Each piece of a row runs the way of the row. *)
Lemma row_ways r : is_straight r = true -> (forall e, In e r -> start e <> finish e) ->
  forall p u v, In p r -> start p = at_ (start (edge_of r)) (finish (edge_of r)) u ->
  finish p = at_ (start (edge_of r)) (finish (edge_of r)) v -> u < v.
Proof.
  intros St Lo p u v I Eu Ev.
  assert (G : forall p, In p r -> exists k, 0 < k /\ way_of p = scale k (way_of (edge_of r))).
  { clear p u v I Eu Ev. induction r as [|e [|f r] IH]; [discriminate| |].
    - intros p [<-|[]]. exists 1. split; [lra|]. unfold edge_of. cbn [last].
      rewrite <- surjective_pairing. unfold scale. destruct (way_of e); cbn [fst snd].
        f_equal; ring.
    - destruct (row_is_edge (e :: f :: r) St Lo) as (_ & _ & _ & _ & _ & k & K & W). cbn [hd] in W.
      change (goes_on e f && is_straight (f :: r) = true) in St. apply andb_true_iff in St.
      destruct St as [Go St].
      assert (Le : start e <> finish e) by (apply Lo; simpl; auto).
      destruct (goes_on_real e f Le Go) as (_ & j & J & Wf).
      destruct (row_is_edge (f :: r) St (fun x X => Lo x (or_intror X))) as
        (_ & _ & _ & _ & _ & m & M & W'). cbn [hd] in W'.
      assert (We : way_of e = scale (/ k) (way_of (edge_of (e :: f :: r)))).
      { rewrite W. unfold scale. destruct (way_of e); cbn [fst snd]. f_equal; field; lra. }
      intros p [<-|I].
      + exists (/ k). split; [apply Rinv_0_lt_compat, K|exact We].
      + destruct (IH St (fun x X => Lo x (or_intror X)) p I) as (c & C & Wp).
        exists (c * (m * (j * / k))). split.
        * pose proof (Rinv_0_lt_compat k K). repeat apply Rmult_lt_0_compat; auto.
        * rewrite Wp, W', Wf, We. unfold scale; cbn [fst snd]. f_equal; ring. }
  destruct (G p I) as (k & K & W). destruct (row_is_edge r St Lo) as (N & _).
  pose proof (edge_long _ _ N) as L. cbv zeta in L.
  unfold way_of in W. rewrite Eu, Ev in W. unfold minus_, scale, at_ in W. cbn [fst snd] in W.
  pose proof (f_equal fst W) as W1. pose proof (f_equal snd W) as W2. cbn [fst snd] in W1, W2.
  set (d1 := fst (finish (edge_of r)) - fst (start (edge_of r))) in *.
  set (d2 := snd (finish (edge_of r)) - snd (start (edge_of r))) in *.
  assert (F1 : (v - u) * d1 = k * d1) by lra. assert (F2 : (v - u) * d2 = k * d2) by lra.
  assert (E : (v - u) * (d1 * d1 + d2 * d2) = k * (d1 * d1 + d2 * d2)).
  { transitivity (d1 * ((v - u) * d1) + d2 * ((v - u) * d2)); [ring|rewrite F1, F2; ring]. }
  apply Rmult_eq_reg_r in E; lra.
Qed.
