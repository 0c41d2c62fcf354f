(** Parts, forms and regions stay if lists or sets are written in another way. *)
From Coq Require Import Lra Lia Permutation Classical FinFun.
From Proved Require Import Definitions Form Local Paths Decomposed Gaps Unique.
From Proved Require Import Slabs.
Open Scope R_scope.

Lemma falls_permuted S (H : list cell -> point -> Prop) K K' : Permutation K K' ->
  falls_into S (fun i => H (nth i K [])) (length K) ->
  falls_into S (fun i => H (nth i K' [])) (length K').
Proof.
  intros P (Cover & Each). apply (Permutation_nth K K' []) in P. cbv zeta in P.
  destruct P as (L & f & Bf & Inj & E). rewrite L.
  pose proof (proj1 (bInjective_bSurjective Bf) Inj) as Sur. split.
  - intros x. rewrite Cover. split.
    + intros (i & I & X). destruct (Sur i I) as (j & J & F). exists j. split; auto.
      rewrite E, F by auto. exact X.
    + intros (i & I & X). exists (f i). split; [apply Bf, I|]. rewrite <- E by auto. exact X.
  - intros i I. rewrite (E i I). destruct (Each (f i) (Bf i I)) as (A & O & J & D).
    split; [exact A|split; [exact O|split; [exact J|]]]. intros j x Lj X Y.
    apply Inj; auto. apply (D (f j) x (Bf j Lj) X). rewrite <- (E j Lj). exact Y.
Qed.
Lemma form_same (S T : point -> Prop) ps : (forall x, S x <-> T x) -> is_form S ps -> is_form T ps.
Proof.
  intros H (C & Fa & In2 & Sh & Each). exists C.
  assert (Int : forall x, interior S x <-> interior T x).
  { intros x. split; intros (e & He & K); exists e; (split; [auto|]); intros y Y; apply H, K, Y. }
  split; [|split; [|split; [exact Sh|]]].
  - destruct Fa as (Cover & R). split; [|exact R]. intros x. rewrite <- Int. apply Cover.
  - intros x X N. apply Int, In2; auto. apply H, X.
  - intros i outer holes E. destruct (Each i outer holes E) as (A & A' & R).
    split; [exact A|split; [exact A'|]]. intros ring I. destruct (R ring I) as (Rg & D).
    split; [exact Rg|]. intros e J. destruct (D e J) as (few & F). exists few. intros x X.
    destruct (F x X) as [L|(r & Hr & K)]; [auto|]. right. exists r. split; auto. intros y Y.
    destruct (K y Y) as [K1 K2]. split; auto. intros O Ty. apply (K2 O), H, Ty.
Qed.
Lemma concat_twice {A} (l : list (list (list A))) : concat (concat l) = concat (map (@concat A) l).
Proof. induction l as [|x l IH]; simpl; auto. rewrite concat_app, IH. reflexivity. Qed.
Lemma pairs_part {A} (R : A -> A -> Prop) l ls : In l ls -> ForallOrdPairs R (concat ls) ->
  ForallOrdPairs R l.
Proof.
  intros I F. apply in_split in I. destruct I as (u & v & ->).
  rewrite concat_app in F. simpl in F.
  assert (Drop : forall u : list A, ForallOrdPairs R (u ++ l ++ concat v) ->
    ForallOrdPairs R (l ++ concat v)).
  { clear. induction u as [|a u IH]; simpl; auto. intros F. inversion F; auto. }
  apply Drop in F. clear - F. induction l as [|a l IH]; constructor; inversion F; subst; auto.
  rewrite Forall_forall in *. intros b I. apply H1, in_or_app. auto.
Qed.
Lemma region_same E F x : (forall y, winding E y = winding F y) ->
  (forall y, on_some E y <-> on_some F y) -> region E x -> region F x.
Proof.
  intros W O H e He. destruct (H e He) as (y & Y & N & P). exists y. split; auto. split.
  - intros a b I Oy. destruct (proj2 (O y)) as (c & d & J & Oc); [exists a, b; auto|].
    exact (N c d J Oc).
  - rewrite <- W. exact P.
Qed.
