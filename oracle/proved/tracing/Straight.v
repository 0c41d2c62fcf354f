(** The rows of a traced ring are straight, and it bends where one ends and the next begins. *)
From Coq Require Import Lra Lia Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Paths Decomposed Gaps
  Unique Rounds.
From Proved Require Import Points Member Pieces Sorting Along Cuts Lone Traced Rows Sooner Cycles
  Bounding Outlined.
Open Scope R_scope.

Definition nothing : edge := ((0, 0), (0, 0))%Q.
(** One piece after another, that does not turn back *)
Definition follows (e f : edge) : Prop := finish e = start f /\
  (turn_of (way_of e) (way_of f) = 0 -> 0 < along (way_of e) (way_of f)).
Definition turns (e f : edge) : Prop := finish e = start f /\
  turn_of (way_of e) (way_of f) <> 0.
Fixpoint linked {A} (R : A -> A -> Prop) (l : list A) : Prop :=
  match l with e :: ((f :: _) as r) => R e f /\ linked R r | _ => True end.
Lemma linked_at {A} (R : A -> A -> Prop) l : forall e f r, linked R (l ++ e :: f :: r) -> R e f.
Proof.
  induction l as [|a [|b l] IH]; intros e f r H; [apply H| |].
  - destruct H as [_ H]. apply (IH e f r H).
  - destruct H as [_ H]. apply (IH e f r H).
Qed.

Lemma turns_real e f : (sg (qcross (dir e) (dir f)) =? 0)%Z = true <->
  turn_of (way_of e) (way_of f) = 0.
Proof. rewrite sg_zero, qcross_real, !dir_real. reflexivity. Qed.
Lemma goes_on_holds e f : follows e f -> turn_of (way_of e) (way_of f) = 0 -> goes_on e f = true.
Proof.
  intros [E D] Z. unfold goes_on. rewrite !andb_true_iff. split; [split|].
  - apply same_real, E.
  - apply turns_real, Z.
  - apply sg_more. rewrite dot_real, !dir_real. apply D, Z.
Qed.

(** All pieces of a row have its direction. *)
Lemma row_directions r : is_straight r = true -> (forall e, In e r -> start e <> finish e) ->
  forall p, In p r -> exists m, 0 < m /\ way_of p = scale m (way_of (hd nothing r)).
Proof.
  induction r as [|e [|f r] IH]; intros St Lo p I; [discriminate| |].
  - destruct I as [<-|[]]. exists 1. split; [lra|]. cbn [hd]. unfold scale.
    destruct (way_of e); cbn [fst snd]; f_equal; ring.
  - change (goes_on e f && is_straight (f :: r) = true) in St. apply andb_true_iff in St.
    destruct St as [Go St]. assert (Le : start e <> finish e) by (apply Lo; simpl; auto).
    destruct (goes_on_real e f Le Go) as (_ & j & J & W). destruct I as [<-|I].
    + exists 1. split; [lra|]. cbn [hd]. unfold scale.
      destruct (way_of e); cbn [fst snd]; f_equal; ring.
    + destruct (IH St (fun g G => Lo g (or_intror G)) p I) as (m & M & Q). cbn [hd] in *.
      exists (m * j). split; [nra|]. rewrite Q, W. unfold scale; cbn [fst snd]. f_equal; ring.
Qed.
Lemma last_in {A} (d : A) r : r <> [] -> In (last r d) r.
Proof.
  induction r as [|e [|f r] IH]; intros N; [destruct (N eq_refl)|simpl; auto|].
  right. apply IH. discriminate.
Qed.
Lemma bends_hold r k : is_straight r = true -> is_straight k = true ->
  (forall e, In e r -> start e <> finish e) -> (forall e, In e k -> start e <> finish e) ->
  turns (last r nothing) (hd nothing k) -> bends r k = true.
Proof.
  intros Sr Sk Lr Lk [E T]. unfold bends. rewrite andb_true_iff, negb_true_iff. split.
  - apply same_real. destruct r as [|e r]; [discriminate|]. destruct k as [|f k]; [discriminate|].
    transitivity (finish (last (e :: r) nothing)); [|exact E].
    unfold edge_of, finish. cbn [fst snd]. rewrite (last_any r e nothing). reflexivity.
  - apply not_true_iff_false. intros Z. apply turns_real in Z. apply T.
    destruct (row_is_edge r Sr Lr) as (_ & _ & _ & _ & _ & m & M & Wr).
    destruct (row_is_edge k Sk Lk) as (_ & _ & _ & _ & _ & n & N & Wk).
    assert (Nr : r <> []) by (intros ->; discriminate Sr).
    destruct (row_directions r Sr Lr _ (last_in nothing r Nr)) as (j & J & Wl).
    change (((0, 0), (0, 0))%Q) with nothing in Wr, Wk.
    rewrite Wr, Wk in Z. rewrite Wl. clear Wr Wk Wl.
    assert (Y : turn_of (scale m (way_of (hd nothing r))) (scale n (way_of (hd nothing k))) = 0)
      by exact Z.
    clear Z. revert Y. generalize (way_of (hd nothing r)) (way_of (hd nothing k)). intros u w Z.
    assert (Z' : m * (n * turn_of u w) = 0).
    { transitivity (turn_of (scale m u) (scale n w)); [|exact Z]. unfold turn_of, scale.
      cbn [fst snd]. ring. }
    rewrite (proj1 (scaled_turns j u w)).
    apply Rmult_integral in Z'. destruct Z' as [Z'|Z']; [lra|]. apply Rmult_integral in Z'.
    destruct Z' as [Z'|Z']; [lra|]. rewrite Z'. ring.
Qed.

Lemma rows_linked l : linked follows l -> (forall r, In r (in_rows l) -> is_straight r = true) /\
  linked (fun r k => turns (last r nothing) (hd nothing k)) (in_rows l).
Proof.
  induction l as [|e l IH]; intros Li; [split; [intros r []|exact I]|].
  assert (Li' : linked follows l) by (destruct l; [exact I|apply Li]).
  destruct (IH Li') as [St Tu]. destruct (in_rows_pieces l) as [Sum Ne]. cbn [in_rows].
  destruct (in_rows l) as [|[|f k] rows].
  - split; [intros r [<-|[]]; auto|exact I].
  - destruct (Ne [] (or_introl eq_refl) eq_refl).
  - assert (Fo : follows e f) by (destruct l as [|g l]; [discriminate Sum|];
      simpl in Sum; injection Sum; intros _ <-; apply Li).
    destruct (sg (qcross (dir e) (dir f)) =? 0)%Z eqn:Z.
    + apply turns_real in Z. split.
      * intros r [<-|J]; [|apply St; simpl; auto].
        change (goes_on e f && is_straight (f :: k) = true). apply andb_true_iff.
        split; [apply goes_on_holds; auto|apply St; simpl; auto].
      * destruct rows as [|r rows]; [exact I|]. exact Tu.
    + apply not_true_iff_false in Z. rewrite turns_real in Z. split.
      * intros r [<-|J]; auto.
      * split; [|exact Tu]. split; [apply Fo|exact Z].
Qed.

Lemma last_concat {A} (d : A) (L : list (list A)) r : r <> [] ->
  last (concat (L ++ [r])) d = last r d.
Proof.
  intros N. rewrite concat_app. simpl. rewrite app_nil_r.
  assert (G : forall k : list A, last (k ++ r) d = last r d).
  { induction k as [|a k IH]; auto. simpl. destruct (k ++ r) eqn:Q; [|exact IH].
    apply app_eq_nil in Q. destruct Q. contradiction. }
  apply G.
Qed.
(** A ring that turns where it begins *)
Theorem rows_of_ring l : linked follows l -> (forall e, In e l -> start e <> finish e) ->
  turns (last l nothing) (hd nothing l) ->
  forallb is_straight (in_rows l) = true /\
  forallb (fun p => bends (fst p) (snd p)) (ring_edges (in_rows l)) = true.
Proof.
  intros Li Lo Tu. destruct (rows_linked l Li) as [St Be].
  destruct (in_rows_pieces l) as [Sum Ne].
  assert (Long : forall r, In r (in_rows l) -> forall e, In e r -> start e <> finish e).
  { intros r J e K. apply Lo. rewrite <- Sum. apply in_concat. exists r. auto. }
  split; [apply forallb_forall, St|]. apply forallb_forall. intros [r k] J. cbn [fst snd].
  assert (G : In r (in_rows l) -> In k (in_rows l) -> turns (last r nothing) (hd nothing k) ->
    bends r k = true).
  { intros I1 I2 T. exact (bends_hold r k (St r I1) (St k I2) (Long r I1) (Long k I2) T). }
  assert (Ends : forall m, in_rows l = m ++ [r] -> hd [] (in_rows l) = k ->
    turns (last r nothing) (hd nothing k)).
  { intros m Q H. replace (last r nothing) with (last l nothing).
    - replace (hd nothing k) with (hd nothing l); auto.
      rewrite <- Sum. destruct (in_rows l) as [|h t]; [destruct m; discriminate Q|].
      cbn [hd] in H. subst h. destruct k as [|e k]; [|reflexivity].
      destruct (Ne [] (or_introl eq_refl) eq_refl).
    - rewrite <- Sum at 1. rewrite Q. apply last_concat. apply Ne. rewrite Q.
      apply in_or_app. simpl. auto. }
  destruct (ring_pair _ _ _ J) as [[Q ->]|[(m & n & Q)|(m & Q)]].
  - apply G; try (rewrite Q; simpl; auto). apply (Ends []); rewrite Q; auto.
  - apply G; try (rewrite Q; apply in_or_app; simpl; auto).
    rewrite Q in Be. apply (linked_at _ _ _ _ _ Be).
  - apply G; try (rewrite Q; simpl; auto); [right; apply in_or_app; simpl; auto|].
    apply (Ends (k :: m)); rewrite Q; auto.
Qed.
