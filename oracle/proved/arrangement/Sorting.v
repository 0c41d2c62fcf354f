(** What is sorted has the same members, in order; neighbours have nothing between them. *)
From Coq Require Import Lia List Permutation Bool Sorted Classical.
From Proved Require Import Pieces.
Import ListNotations.

Lemma adjacent_in {A} (l : list A) p q : In (p, q) (adjacent l) -> In p l /\ In q l.
Proof.
  unfold adjacent. intros I. split; [exact (in_combine_l _ _ _ _ I)|].
  apply in_combine_r in I. destruct l; simpl in *; auto.
Qed.
(** Where some members have a property and others not, some neighbours differ. *)
Lemma change_between {A} (U : A -> Prop) (l : list A) x y : In x l -> In y l -> ~ U x -> U y ->
  exists p q, In (p, q) (adjacent l) /\ ((~ U p /\ U q) \/ (U p /\ ~ U q)).
Proof.
  assert (G : forall p r, (forall v w, In (v, w) (adjacent (p :: r)) -> (U v <-> U w)) ->
    forall v, In v (p :: r) -> (U v <-> U p)).
  { intros p r. revert p. induction r as [|q r IH]; intros p H v I.
    - destruct I as [<-|[]]. tauto.
    - destruct I as [<-|I]; [tauto|]. assert (U p <-> U q) by (apply H; simpl; auto).
      assert (U v <-> U q); [|tauto]. apply IH; auto. intros a b J. apply H. simpl. auto. }
  intros X Y Nx Uy. apply NNPP. intros N. destruct l as [|p r]; [destruct X|].
  assert (H : forall v w, In (v, w) (adjacent (p :: r)) -> (U v <-> U w)).
  { intros v w I. destruct (classic (U v)), (classic (U w)); try tauto; exfalso; apply N;
      exists v, w; tauto. }
  apply Nx, (G p r H x X), (G p r H y Y), Uy.
Qed.

Section SortBy.
Context {A : Type} (le eq : A -> A -> bool).
Hypothesis total : forall x y, le x y = true \/ le y x = true.
Hypothesis transitive : forall x y z, le x y = true -> le y z = true -> le x z = true.
Let ordered := StronglySorted (fun x y => le x y = true).

Lemma merge_members l : forall k, Permutation (merge le l k) (l ++ k).
Proof.
  induction l as [|x l IH]; intros k; [reflexivity|].
  induction k as [|y k IK]; [simpl; rewrite app_nil_r; reflexivity|].
  change (merge le (x :: l) (y :: k)) with
    (if le x y then x :: merge le l (y :: k) else y :: merge le (x :: l) k).
  destruct (le x y); [simpl; apply perm_skip, IH|].
  apply Permutation_trans with (y :: (x :: l) ++ k); [apply perm_skip, IK|].
  apply (Permutation_middle (x :: l) k y).
Qed.
Lemma merge_ordered l : forall k, ordered l -> ordered k -> ordered (merge le l k).
Proof.
  induction l as [|x l IH]; intros k L K; [exact K|].
  induction k as [|y k IK]; [exact L|].
  change (merge le (x :: l) (y :: k)) with
    (if le x y then x :: merge le l (y :: k) else y :: merge le (x :: l) k).
  apply StronglySorted_inv in L as L'. apply StronglySorted_inv in K as K'.
  destruct L' as [L1 L2], K' as [K1 K2]. rewrite Forall_forall in L2, K2.
  destruct (le x y) eqn:E.
  - constructor; [apply IH; auto|]. apply Forall_forall. intros z Z.
    apply (Permutation_in _ (merge_members l (y :: k))) in Z. apply in_app_or in Z.
    destruct Z as [Z|[<-|Z]]; auto. apply transitive with y; auto.
  - assert (E' : le y x = true) by (destruct (total x y); congruence).
    constructor; [apply IK; auto|]. apply Forall_forall. intros z Z.
    apply (Permutation_in _ (merge_members (x :: l) k)) in Z. apply in_app_or in Z.
    destruct Z as [[<-|Z]|Z]; auto. apply transitive with x; auto.
Qed.
Lemma pairs_members : forall n ls, (length ls <= n)%nat ->
  Permutation (concat (merge_pairs le ls)) (concat ls).
Proof.
  induction n as [|n IH]; intros ls L; [destruct ls; simpl in *; [reflexivity|lia]|].
  destruct ls as [|l [|k r]]; simpl in *; auto. rewrite app_assoc.
  apply Permutation_app; [apply merge_members|apply IH; lia].
Qed.
Lemma pairs_ordered : forall n ls, (length ls <= n)%nat ->
  (length (merge_pairs le ls) <= length ls)%nat /\
  ((2 <= length ls)%nat -> (length (merge_pairs le ls) < length ls)%nat) /\
  (Forall ordered ls -> Forall ordered (merge_pairs le ls)).
Proof.
  induction n as [|n IH]; intros ls L.
  - destruct ls; simpl in *; [repeat split; auto; lia|lia].
  - destruct ls as [|l [|k r]]; simpl in *; try (repeat split; auto; lia).
    destruct (IH r) as (Q & R & O); [lia|]. split; [lia|split; [lia|]].
    intros F. inversion F as [|? ? F1 F2]; inversion F2; subst. constructor; auto.
    apply merge_ordered; auto.
Qed.
Lemma all_members n : forall ls, Permutation (merge_all le n ls) (concat ls).
Proof.
  induction n as [|n IH]; intros [|l [|k r]]; simpl; rewrite ?app_nil_r; auto.
  rewrite IH. exact (pairs_members _ (l :: k :: r) (le_n _)).
Qed.
Lemma all_ordered n : forall ls, (length ls <= n)%nat -> Forall ordered ls ->
  ordered (merge_all le n ls).
Proof.
  induction n as [|n IH]; intros [|l [|k r]] L F; try (simpl in L; lia); try constructor;
    try (inversion F; assumption).
  destruct (pairs_ordered _ (l :: k :: r) (le_n _)) as (_ & S & O).
  apply IH; [simpl in *; lia|apply O, F].
Qed.
Lemma sort_members l : Permutation (sort le l) l.
Proof.
  unfold sort. rewrite all_members. induction l as [|x l IH]; simpl; auto.
Qed.
Lemma sort_ordered l : ordered (sort le l).
Proof.
  apply all_ordered; [rewrite map_length; auto|]. apply Forall_forall. intros k K.
  apply in_map_iff in K. destruct K as (x & <- & _). repeat constructor.
Qed.

Lemma unique_from l x : In x (unique eq l) -> In x l.
Proof.
  induction l as [|y [|z r] IH]; auto. change (unique eq (y :: z :: r)) with
    (if eq y z then unique eq (z :: r) else y :: unique eq (z :: r)).
  destruct (eq y z); [right; auto|]. intros [<-|I]; [left; reflexivity|right; auto].
Qed.
Lemma in_turn_from l x : In x (in_turn le eq l) -> In x l.
Proof. intros I. apply unique_from in I. apply (Permutation_in _ (sort_members l) I). Qed.
(** Of each member an equal one is left. *)
Lemma unique_has (R : A -> A -> Prop) l : (forall x, R x x) ->
  (forall x y z, R x y -> R y z -> R x z) -> (forall x y, eq x y = true -> R x y) ->
  forall x, In x l -> exists y, In y (unique eq l) /\ R x y.
Proof.
  intros Rf Tr Eq. induction l as [|y [|z r] IH]; intros x I; [destruct I|exists x; auto|].
  change (unique eq (y :: z :: r)) with
    (if eq y z then unique eq (z :: r) else y :: unique eq (z :: r)).
  destruct I as [<-|I].
  - destruct (eq y z) eqn:E; [|exists y; split; [left; reflexivity|auto]].
    destruct (IH z (or_introl eq_refl)) as (w & W & H). exists w. split; eauto.
  - destruct (IH x I) as (w & W & H). exists w. split; auto. destruct (eq y z); simpl; auto.
Qed.
Lemma in_turn_has (R : A -> A -> Prop) l x : (forall x, R x x) ->
  (forall x y z, R x y -> R y z -> R x z) -> (forall x y, eq x y = true -> R x y) ->
  In x l -> exists y, In y (in_turn le eq l) /\ R x y.
Proof.
  intros Rf Tr Eq I. apply unique_has; auto.
  apply (Permutation_in _ (Permutation_sym (sort_members l)) I).
Qed.

Hypothesis equal : forall x y, le x y = true -> le y x = true -> eq x y = true.
Let strict := StronglySorted (fun x y => le y x = false).
Lemma below x y : le y x = false -> le x y = true.
Proof. intros F. destruct (total x y); congruence. Qed.
Lemma unique_strict l : ordered l -> strict (unique eq l).
Proof.
  induction l as [|y [|z r] IH]; intros O; [constructor|repeat constructor|].
  change (unique eq (y :: z :: r)) with
    (if eq y z then unique eq (z :: r) else y :: unique eq (z :: r)).
  apply StronglySorted_inv in O. destruct O as [O1 O2]. rewrite Forall_forall in O2.
  destruct (eq y z) eqn:E; [apply IH, O1|]. constructor; [apply IH, O1|]. apply Forall_forall.
    intros w W.
  apply unique_from in W. apply not_true_iff_false. intros L.
  assert (le z w = true).
  { destruct W as [<-|W]; [destruct (total z z); auto|]. apply StronglySorted_inv in O1.
    destruct O1 as [_ O1]. rewrite Forall_forall in O1. auto. }
  rewrite (equal y z) in E; [discriminate| |].
  - apply O2. left. reflexivity.
  - apply transitive with w; auto.
Qed.
(** Neighbours of a list in turn: the first is before the second, nothing is between. *)
Lemma neighbours l p q : In (p, q) (adjacent (in_turn le eq l)) -> le q p = false /\
  forall z, In z (in_turn le eq l) -> le z p = true \/ le q z = true.
Proof.
  assert (S : strict (in_turn le eq l)) by apply unique_strict, sort_ordered.
  induction (in_turn le eq l) as [|x [|y r] IH]; intros I; [destruct I|destruct I|].
  apply StronglySorted_inv in S. destruct S as [S1 S2]. rewrite Forall_forall in S2.
  assert (Self : forall x, le x x = true) by (intros v; destruct (total v v); auto).
  destruct I as [E|I].
  - injection E; intros <- <-. split; [apply S2; simpl; auto|]. intros z [<-|[<-|Z]]; auto.
    right. apply below. apply StronglySorted_inv in S1. destruct S1 as [_ S1].
    rewrite Forall_forall in S1. auto.
  - destruct (IH S1 I) as [H1 H2]. split; auto. intros z [<-|Z]; auto.
    left. apply below, S2. apply adjacent_in in I. tauto.
Qed.
(** Where a property begins: two neighbours, if it holds of all after the first that has it. *)
Lemma begins_between (U : A -> Prop) l x y : (forall x y, le x y = true -> U x -> U y) ->
  In x (in_turn le eq l) -> In y (in_turn le eq l) -> ~ U x -> U y ->
  exists p q, In (p, q) (adjacent (in_turn le eq l)) /\ ~ U p /\ U q.
Proof.
  intros Up X Y Nx Uy. destruct (change_between U _ x y X Y Nx Uy) as (p & q & I & [H|[H K]]).
  - exists p, q. tauto.
  - exfalso. apply K. apply neighbours in I. destruct I as [L _]. apply below in L.
    apply (Up p q L H).
Qed.
End SortBy.
