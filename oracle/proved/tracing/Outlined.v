(** A traced ring from its least vertex, in rows: the same pieces, from one that is before all
    others. *)
From Coq Require Import Lra Lia Bool Permutation Classical.
From Proved Require Import Definitions Form Local Across Overlaps Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Sorting Along Cuts Lone Traced Cycles Bounding.
Open Scope R_scope.

(** ** Rows *)
Lemma in_rows_pieces l : concat (in_rows l) = l /\ forall r, In r (in_rows l) -> r <> [].
Proof.
  induction l as [|e l [IH Ne]]; [split; [auto|intros r []]|]. cbn [in_rows].
  destruct (in_rows l) as [|[|f k] rows].
  - split; [rewrite <- IH; auto|]. intros r [<-|[]]. discriminate.
  - destruct (Ne [] (or_introl eq_refl) eq_refl).
  - destruct (sg (qcross (dir e) (dir f)) =? 0)%Z.
    + split; [rewrite <- IH; auto|]. intros r [<-|I]; [discriminate|]. apply Ne. simpl. auto.
    + split; [rewrite <- IH; auto|]. intros r [<-|I]; [discriminate|]. apply Ne, I.
Qed.
Lemma corners_of_pieces rows : (forall r, In r rows -> r <> []) ->
  exists k, Permutation (corners_of rows ++ k) (map fst (concat rows)).
Proof.
  induction rows as [|r rows IH]; intros Ne; [exists []; auto|].
  destruct IH as (k & P); [intros; apply Ne; simpl; auto|].
  destruct r as [|e r]; [destruct (Ne [] (or_introl eq_refl) eq_refl)|].
  exists (map fst r ++ k). cbn [corners_of map concat]. rewrite map_app. simpl. constructor.
  change (map (fun r => fst (edge_of r)) rows) with (corners_of rows).
  apply Permutation_trans with (map fst r ++ corners_of rows ++ k).
  - rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm.
  - apply Permutation_app_head, P.
Qed.

(** ** From the least vertex *)
Lemma turn_to_members n v : forall l, Permutation (turn_to n v l) l.
Proof.
  induction n as [|n IH]; intros [|e r]; simpl; auto. destruct (same (fst e) v); auto.
  apply Permutation_trans with (r ++ [e]); auto. apply Permutation_sym, Permutation_cons_append.
Qed.
Lemma turn_to_head v : forall n l1 e l2, same (fst e) v = true -> (length l1 <= n)%nat ->
  (0 < n)%nat -> exists f r, turn_to n v (l1 ++ e :: l2) = f :: r /\ same (fst f) v = true.
Proof.
  induction n as [|n IH]; intros l1 e l2 S L N; [lia|]. destruct l1 as [|d l1]; simpl.
  - rewrite S. eauto.
  - destruct (same (fst d) v) eqn:Q; [eauto|]. rewrite <- app_assoc. simpl in *.
    destruct n as [|n].
    + destruct l1; [|simpl in L; lia]. simpl. eauto.
    + apply IH; auto; lia.
Qed.
Definition least_start (e : edge) (l : list edge) : vertex :=
  fold_right (fun f m => if is_before (fst f) m then fst f else m) (fst e) l.
Lemma least_start_is e l : (exists f, In f (e :: l) /\ least_start e l = fst f) /\
  forall f, In f (e :: l) -> ~ before (start f) (R2 (least_start e l)).
Proof.
  assert (Irr : forall p : point, ~ before p p) by (intros p H; exact (never_both _ _ H H)).
  induction l as [|d l [(f & I & Q) Low]]; simpl.
  - split; [exists e; auto|]. intros f [<-|[]]. apply Irr.
  - destruct (is_before (fst d) (least_start e l)) eqn:H.
    + split; [exists d; auto|]. apply is_before_real in H. intros g [<-|[<-|J]].
      * intros B. apply (Low e); [simpl; auto|]. exact (before_transitive _ _ _ B H).
      * apply Irr.
      * intros B. apply (Low g); [simpl; auto|]. exact (before_transitive _ _ _ B H).
    + apply not_true_iff_false in H. rewrite is_before_real in H.
      split; [exists f; split; [|exact Q]; destruct I as [<-|I]; auto|].
      intros g [<-|[<-|J]]; auto; apply Low; simpl; auto.
Qed.
Lemma from_least_members l : Permutation (from_least l) l.
Proof. destruct l as [|e r]; [auto|]. apply turn_to_members. Qed.
Lemma from_least_head l : l <> [] -> exists f r, from_least l = f :: r /\
  forall g, In g l -> ~ before (start g) (start f).
Proof.
  destruct l as [|e r]; intros N; [destruct (N eq_refl)|].
  destruct (least_start_is e r) as [(d & I & Q) Low].
  destruct (in_split _ _ I) as (l1 & l2 & Sp).
  assert (Eq : same (fst d) (least_start e r) = true) by (apply same_real; rewrite Q; auto).
  assert (Len : length (e :: r) = (length l1 + length (d :: l2))%nat)
    by (rewrite Sp; apply app_length).
  destruct (turn_to_head (least_start e r) (length (e :: r)) l1 d l2 Eq) as (f & k & T & Sf);
    [|simpl; apply PeanoNat.Nat.lt_0_succ|].
  { eapply PeanoNat.Nat.le_trans; [apply PeanoNat.Nat.le_add_r|].
    apply PeanoNat.Nat.eq_le_incl. symmetry. exact Len. }
  exists f, k. split.
  - change (turn_to (length (e :: r)) (least_start e r) (e :: r) = f :: k).
    rewrite <- T. f_equal. exact Sp.
  - apply same_real in Sf. intros g J. unfold start at 2. rewrite Sf. apply Low, J.
Qed.

Section Ring.
Variable l : list edge.
Hypothesis l_once : NoDup l.
Hypothesis some_piece : l <> [].
Hypothesis ends_once : forall a b, In a l -> In b l -> finish a = finish b -> a = b.
Hypothesis starts_once : forall a b, In a l -> In b l -> start a = start b -> a = b.
Let rows := in_rows (from_least l).

Lemma each_pair_of {A} (test : A -> A -> bool) k : NoDup k ->
  (forall a b, In a k -> In b k -> a <> b -> test a b = true) -> each_pair test k = true.
Proof.
  induction k as [|a k IH]; intros D H; auto. inversion D; subst. simpl. apply andb_true_iff.
  split; [|apply IH; auto; intros; apply H; simpl; auto]. apply forallb_forall. intros b I.
  apply H; simpl; auto. intros ->. contradiction.
Qed.
Theorem passed_once_holds :
  each_pair (fun e f => negb (same (snd e) (snd f))) (concat rows) = true.
Proof.
  unfold rows. rewrite (proj1 (in_rows_pieces _)). apply each_pair_of.
  - exact (Permutation_NoDup (Permutation_sym (from_least_members l)) l_once).
  - intros a b I J N. apply negb_true_iff, not_true_iff_false. rewrite same_real. intros Q.
    apply N, ends_once; auto; apply (Permutation_in _ (from_least_members l)); auto.
Qed.
Theorem begins_least_holds : begins_least rows = true.
Proof.
  destruct (from_least_head l some_piece) as (f & k & Q & Low).
  unfold begins_least. pose proof (in_rows_pieces (from_least l)) as [Sum Ne]. fold rows in Sum, Ne.
  destruct (corners_of_pieces rows Ne) as (j & P). rewrite Sum in P.
  destruct rows as [|[|e r] rest]; [rewrite Q in Sum; discriminate Sum|
    destruct (Ne [] (or_introl eq_refl) eq_refl)|].
  assert (Ef : e = f) by (simpl in Sum; rewrite Q in Sum; injection Sum; auto). subst e.
  cbn [corners_of map]. apply forallb_forall. intros p I. apply is_before_real.
  assert (D : NoDup (map R2 (map fst (from_least l)))).
  { rewrite map_map. change (NoDup (map start (from_least l))).
    assert (D' : NoDup (from_least l))
      by exact (Permutation_NoDup (Permutation_sym (from_least_members l)) l_once).
    assert (Sub : forall a, In a (from_least l) -> In a l)
      by (intros a; apply (Permutation_in _ (from_least_members l))).
    clear - D' Sub starts_once. induction (from_least l) as [|a m IH]; simpl; constructor;
      inversion D'; subst.
    - intros I. apply in_map_iff in I. destruct I as (b & E & J). apply H1.
      replace a with b; auto. apply starts_once; auto; apply Sub; simpl; auto.
    - apply IH; auto. intros; apply Sub; simpl; auto. }
  apply (Permutation_NoDup (Permutation_map R2 (Permutation_sym P))) in D. simpl in D.
  inversion D; subst.
  assert (Ip : In p (map fst (from_least l))).
  { apply (Permutation_in _ P). simpl. right. apply in_or_app. left. exact I. }
  apply in_map_iff in Ip. destruct Ip as (g & <- & Ig).
  destruct (before_total (start f) (start g)) as [B|[B|B]]; auto.
  - exfalso. apply H1. change (In (start f) (map R2 (corners_of rest ++ j))). rewrite B.
    change (In (R2 (fst g)) (map R2 (corners_of rest ++ j))). apply in_map, in_or_app. left.
    exact I.
  - exfalso. apply (Low g); auto. exact (Permutation_in _ (from_least_members l) Ig).
Qed.
End Ring.
