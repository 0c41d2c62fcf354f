(** Lists of points in the program's order. Of two different ones one is before the other, so that
    sorted lists ascend where no two are equal. *)
From Coq Require Import Bool QArith Qreals Sorted Permutation.
From Proved Require Import Definitions Form Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Sorting Along Cuts Traced Ringed Bounding.
Open Scope R_scope.

Lemma list_le_real p q l k : list_le (p :: l) (q :: k) = true <->
  before (R2 p) (R2 q) \/ R2 p = R2 q /\ list_le l k = true.
Proof. simpl. rewrite orb_true_iff, andb_true_iff, is_before_real, same_real. reflexivity. Qed.
Lemma list_le_total l : forall k, list_le l k = true \/ list_le k l = true.
Proof.
  induction l as [|p l IH]; intros [|q k]; auto. rewrite !list_le_real.
  destruct (before_total (R2 p) (R2 q)) as [H|[H|H]]; auto. destruct (IH k); auto.
Qed.
Lemma list_le_transitive l : forall k m, list_le l k = true -> list_le k m = true ->
  list_le l m = true.
Proof.
  induction l as [|p l IH]; intros [|q k] [|o m]; auto; try discriminate. rewrite !list_le_real.
  intros [H|[H H']] [K|[K K']].
  - left. exact (before_transitive _ _ _ H K).
  - left. rewrite <- K. exact H.
  - left. rewrite H. exact K.
  - right. split; [congruence|eauto].
Qed.
Lemma less_unless_equal l : forall k, list_le l k = true ->
  list_less l k = true \/ map R2 l = map R2 k.
Proof.
  induction l as [|p l IH]; intros [|q k] H; auto; try discriminate.
  apply list_le_real in H. cbn [list_less map]. rewrite orb_true_iff, andb_true_iff,
    is_before_real, same_real.
  destruct H as [H|[E H]]; auto. destruct (IH k H) as [L|L]; auto. right. congruence.
Qed.

Lemma ascending_holds {A} (test : A -> A -> bool) l :
  StronglySorted (fun x y => test x y = true) l -> ascending test l = true.
Proof.
  induction 1 as [|x l S IH F]; auto. destruct l as [|y r]; auto.
  change (test x y && ascending test (y :: r) = true). apply andb_true_iff. split; auto.
  inversion F; auto.
Qed.
(** What is sorted by lists that differ ascends. *)
Theorem sorted_ascends {A} (f : A -> list vertex) l : NoDup l ->
  (forall x y, In x l -> In y l -> x <> y -> map R2 (f x) <> map R2 (f y)) ->
  ascending (fun x y => list_less (f x) (f y)) (sort (fun x y => list_le (f x) (f y)) l) = true.
Proof.
  set (le := fun x y => list_le (f x) (f y)). intros N D. apply ascending_holds.
  pose proof (sort_members le l) as P.
  assert (O : StronglySorted (fun x y => le x y = true) (sort le l)).
  { apply sort_ordered; unfold le.
    - intros x y. apply list_le_total.
    - intros x y z. apply list_le_transitive. }
  apply (Permutation_NoDup (Permutation_sym P)) in N.
  assert (D' : forall x y, In x (sort le l) -> In y (sort le l) -> x <> y ->
    map R2 (f x) <> map R2 (f y)).
  { intros x y X Y. apply D; apply (Permutation_in _ P); auto. }
  clear D P. revert N D'. induction O as [|x k O IH F]; intros N D; constructor;
    inversion N; subst.
  - apply IH; auto. intros; apply D; simpl; auto.
  - rewrite Forall_forall in *. intros y I. destruct (less_unless_equal (f x) (f y) (F y I))
      as [L|L]; auto. exfalso. apply (D x y); simpl; auto. intros ->. contradiction.
Qed.

(** ** Members of different lists *)
Lemma once_after {A} (l k : list A) : NoDup (l ++ k) -> NoDup k.
Proof. induction l as [|x l IH]; auto. simpl. inversion 1; auto. Qed.
Section Lists.
Context {A C : Type} (f : C -> list A).
Lemma common_member l : NoDup (flat_map f l) -> forall x y a, In x l -> In y l -> In a (f x) ->
  In a (f y) -> x = y.
Proof.
  induction l as [|z l IH]; cbn [flat_map]; intros N x y a X Y Hx Hy; [destruct X|].
  assert (Split : NoDup (flat_map f l) /\ forall w, In w l -> In a (f z) -> In a (f w) -> False).
  { split; [exact (once_after _ _ N)|]. intros w W Hz Hw.
    apply in_split in Hz. destruct Hz as (u & v & E). rewrite E, <- app_assoc in N.
    apply NoDup_remove_2 in N. apply N, in_or_app. right. apply in_or_app. right.
    apply in_flat_map. eauto. }
  destruct Split as [N' D]. destruct X as [<-|X], Y as [<-|Y]; auto; try (exfalso; eauto; fail).
  apply (IH N' x y a); auto.
Qed.
Lemma lists_once l : NoDup (flat_map f l) -> (forall x, In x l -> f x <> []) -> NoDup l.
Proof.
  induction l as [|z l IH]; cbn [flat_map]; intros N E; constructor.
  - intros I. destruct (f z) as [|a k] eqn:Q; [destruct (E z (or_introl eq_refl) Q)|].
    simpl in N. inversion N as [|b m No]; subst. apply No, in_or_app. right. apply in_flat_map.
    exists z. rewrite Q. simpl. auto.
  - apply IH; [exact (once_after _ _ N)|]. intros; apply E; simpl; auto.
Qed.
Lemma flat_once l : (forall x, In x l -> NoDup (f x)) ->
  ForallOrdPairs (fun x y => forall a, In a (f x) -> In a (f y) -> False) l ->
  NoDup (flat_map f l).
Proof.
  intros N P. induction P as [|x l F P IH]; cbn [flat_map]; [constructor|].
  rewrite Forall_forall in F.
  assert (Nl : NoDup (flat_map f l)) by (apply IH; intros; apply N; simpl; auto).
  assert (D : forall a, In a (f x) -> ~ In a (flat_map f l)).
  { intros a I J. apply in_flat_map in J. destruct J as (y & Y & J). exact (F y Y a I J). }
  specialize (N x (or_introl eq_refl)). clear - N Nl D.
  induction (f x) as [|a k IH]; simpl; auto. inversion N; subst. constructor.
  - intros I. apply in_app_or in I. destruct I as [I|I]; [contradiction|].
    exact (D a (or_introl eq_refl) I).
  - apply IH; auto. intros b I. apply D. simpl. auto.
Qed.
End Lists.
Lemma pairs_by_place {A} (R : A -> A -> Prop) (d : A) l :
  (forall i j, (i < j < length l)%nat -> R (nth i l d) (nth j l d)) -> ForallOrdPairs R l.
Proof.
  induction l as [|x l IH]; intros H; constructor.
  - apply Forall_forall. intros y I. destruct (In_nth l y d I) as (j & J & <-).
    apply (H O (Datatypes.S j)). simpl. split; [apply PeanoNat.Nat.lt_0_succ|].
    apply -> PeanoNat.Nat.succ_lt_mono. exact J.
  - apply IH. intros i j [I J]. apply (H (Datatypes.S i) (Datatypes.S j)). simpl.
    split; apply -> PeanoNat.Nat.succ_lt_mono; assumption.
Qed.
Lemma flat_permuted {A C} (f g : C -> list A) l : (forall x, In x l -> Permutation (f x) (g x)) ->
  Permutation (flat_map f l) (flat_map g l).
Proof.
  induction l as [|x l IH]; cbn [flat_map]; intros H; auto.
  apply Permutation_app; [apply H|apply IH; intros; apply H]; simpl; auto.
Qed.
