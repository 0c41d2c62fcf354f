(** Classes of cells: each cell is in one, the cells of one are chained by links, and none is linked
    with a cell of another. *)
From Coq Require Import Lia List Permutation Bool Sorted Classical.
From Proved Require Import Slabs.
Import ListNotations.

(** ** Pairs of a list *)
Lemma pairs_two {A} (R : A -> A -> Prop) l a b : (forall x y, R x y -> R y x) ->
  ForallOrdPairs R l -> In a l -> In b l -> a = b \/ R a b.
Proof.
  intros Sy F. induction F as [|x l H F IH]; intros I J; [destruct I|].
  rewrite Forall_forall in H. destruct I as [<-|I], J as [<-|J]; auto.
Qed.
Lemma pairs_filter {A} (R : A -> A -> Prop) p l : ForallOrdPairs R l ->
  ForallOrdPairs R (filter p l).
Proof.
  intros F. induction F as [|x l H F IH]; simpl; [constructor|].
  destruct (p x); auto. constructor; auto. rewrite Forall_forall in *.
  intros y I. apply filter_In in I. apply H, I.
Qed.
Lemma pairs_join {A} (R : A -> A -> Prop) l k : ForallOrdPairs R l -> ForallOrdPairs R k ->
  (forall a b, In a l -> In b k -> R a b) -> ForallOrdPairs R (l ++ k).
Proof.
  intros F G H. induction F as [|x l K F IH]; simpl; auto. constructor.
  - rewrite Forall_forall in *. intros y I. apply in_app_or in I. destruct I as [I|I]; auto.
    apply H; simpl; auto.
  - apply IH. intros a b I J. apply H; simpl; auto.
Qed.
Lemma pairs_concat {A} (R : A -> A -> Prop) ls : (forall l, In l ls -> ForallOrdPairs R l) ->
  ForallOrdPairs (fun l k => forall a b, In a l -> In b k -> R a b) ls ->
  ForallOrdPairs R (concat ls).
Proof.
  intros H F. induction F as [|l ls K F IH]; simpl; [constructor|].
  apply pairs_join; [apply H; simpl; auto|apply IH; intros; apply H; simpl; auto|].
  intros a b I J. apply in_concat in J. destruct J as (k & Jk & J).
  rewrite Forall_forall in K. apply (K k Jk a b I J).
Qed.
Lemma pairs_nth {A} (R : A -> A -> Prop) l d : ForallOrdPairs R l -> forall i j,
  (i < j)%nat -> (j < length l)%nat -> R (nth i l d) (nth j l d).
Proof.
  intros F. induction F as [|x l K F IH]; simpl; intros i j I J; [lia|].
  destruct j as [|j]; [lia|]. destruct i as [|i].
  - rewrite Forall_forall in K. apply K, nth_In. lia.
  - apply IH; lia.
Qed.

(** ** Chains *)
Inductive chained (A : list cell) (c : cell) : cell -> Prop :=
| chain_here : chained A c c
| chain_on d e : chained A c d -> In e A -> linked d e = true -> chained A c e.
Lemma linked_back c d : linked c d = linked d c.
Proof. unfold linked. apply orb_comm. Qed.
Lemma chained_more A B c d : (forall e, In e A -> In e B) -> chained A c d -> chained B c d.
Proof. intros H K. induction K as [|d e K IH I L]; [constructor|eapply chain_on; eauto]. Qed.
Lemma chained_join A c d e : chained A c d -> chained A d e -> chained A c e.
Proof. intros H K. induction K; auto. eapply chain_on; eauto. Qed.
Lemma chained_back A c d : In c A -> chained A c d -> chained A d c.
Proof.
  intros I K. induction K as [|d e K IH J L]; [constructor|].
  apply chained_join with d; auto. eapply chain_on; [constructor| |rewrite linked_back; exact L].
  destruct K; auto.
Qed.

(** ** The program *)
Lemma classes_from l A c : In A (classes l) -> In c A -> In c l.
Proof.
  revert A. induction l as [|d l IH]; intros A I J; [destruct I|]. simpl in I.
  destruct I as [<-|I].
  - destruct J as [<-|J]; [left; reflexivity|]. apply in_concat in J. destruct J as (B & K & J).
    apply filter_In in K. right. apply (IH B); tauto.
  - apply filter_In in I. right. apply (IH A); tauto.
Qed.
Lemma classes_have l c : In c l -> exists A, In A (classes l) /\ In c A.
Proof.
  induction l as [|d l IH]; intros I; [destruct I|]. simpl. destruct I as [<-|I].
  - eexists. split; [left; reflexivity|simpl; auto].
  - destruct (IH I) as (A & K & J). destruct (existsb (linked d) A) eqn:E.
    + eexists. split; [left; reflexivity|]. right. apply in_concat. exists A. split; auto.
      apply filter_In. auto.
    + exists A. split; auto. right. apply filter_In. rewrite E. auto.
Qed.
Lemma classes_some l A : In A (classes l) -> exists c, In c A.
Proof.
  revert A. induction l as [|d l IH]; intros A I; [destruct I|]. simpl in I.
  destruct I as [<-|I]; [exists d; simpl; auto|]. apply filter_In in I. apply IH; tauto.
Qed.
Lemma classes_chained l A c d : In A (classes l) -> In c A -> In d A -> chained A c d.
Proof.
  revert A c d. induction l as [|e l IH]; intros A c d I; [destruct I|]. simpl in I.
  destruct I as [<-|I]; [|apply filter_In in I; apply IH; tauto].
  set (A := e :: concat (filter (existsb (linked e)) (classes l))).
  assert (G : forall c, In c A -> chained A e c).
  { intros x [<-|J]; [constructor|]. apply in_concat in J. destruct J as (B & K & J).
    assert (Sub : forall y, In y B -> In y A).
    { intros y Y. right. apply in_concat. exists B. auto. }
    apply filter_In in K. destruct K as [K E]. apply existsb_exists in E.
    destruct E as (y & Y & L). apply chained_join with y.
    - eapply chain_on; [constructor|apply Sub, Y|exact L].
    - apply (chained_more B A y x Sub), IH; auto. }
  intros C D. apply chained_join with e; [|apply G, D].
  apply chained_back; [left; reflexivity|apply G, C].
Qed.
(** Cells of two classes are not linked, and in whatever relation the cells of the list are. *)
Lemma classes_apart (R : cell -> cell -> Prop) l : (forall c d, R c d -> R d c) ->
  ForallOrdPairs R l -> ForallOrdPairs (fun A B => forall c d, In c A -> In d B ->
    linked c d = false /\ R c d) (classes l).
Proof.
  intros Sy F. induction F as [|e l H F IH]; [constructor|]. simpl.
  rewrite Forall_forall in H. constructor; [|apply pairs_filter, IH].
  apply Forall_forall. intros B K. apply filter_In in K. destruct K as [K E].
  apply negb_true_iff in E.
  intros c d [<-|C] D.
  - split; [|apply H, (classes_from l B); auto].
    apply not_true_iff_false. intros L. apply not_true_iff_false in E. apply E.
    apply existsb_exists. exists d. auto.
  - apply in_concat in C. destruct C as (A & J & C). apply filter_In in J. destruct J as [J E'].
    assert (Sy' : forall A B, (forall c d, In c A -> In d B -> linked c d = false /\ R c d) ->
      forall c d, In c B -> In d A -> linked c d = false /\ R c d).
    { intros X Y G x y Ix Iy. destruct (G y x Iy Ix). rewrite linked_back. auto. }
    destruct (pairs_two _ (classes l) A B Sy' IH J K) as [Q|Q]; auto. subst. congruence.
Qed.
