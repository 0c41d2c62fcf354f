(** Section 6 of the paper, Theorem 1: its second half is false. *)
From Coq Require Import ZArith Bool.
From Proved Require Import Paper.

Definition first : tetrahedron := ((1, -5, 5), (-2, -5, 3), ((2, 4, 1), (-2, 2, -4)))%Z.
Definition second : tetrahedron := ((5, 4, -2), (-4, -4, -3), ((5, -3, 1), (-4, 1, -5)))%Z.
Definition factors : spot := (5, 5, 1)%Z.
Definition pairs : list (nat * nat) := list_prod corners4 corners4.
Definition gets_another (before after : nat -> nat -> bool) : bool :=
  forallb (fun i => existsb (fun jk => negb (Nat.eqb (fst jk) (snd jk)) &&
    before i (fst jk) && after i (snd jk)) pairs) corners4.

Lemma another before after : gets_another before after = true -> forall i, In i corners4 ->
  exists j k, j <> k /\ before i j = true /\ after i k = true.
Proof.
  unfold gets_another. rewrite forallb_forall. intros H i I. specialize (H i I).
  apply existsb_exists in H. destruct H as ([j k] & _ & H). cbn [fst snd] in H.
  rewrite !andb_true_iff in H. destruct H as [[N A] B]. exists j, k. split; auto.
  apply negb_true_iff, Nat.eqb_neq in N. exact N.
Qed.
Theorem all_facets_may_change_and_no_edges_holds : all_facets_may_change_and_no_edges.
Proof.
  exists first, second, factors. split; [|split].
  - apply (another (facet_fits (scaled_by one_each first) second)
      (facet_fits (scaled_by factors first) second)). vm_compute. reflexivity.
  - apply (another (facet_fits second (scaled_by one_each first))
      (facet_fits second (scaled_by factors first))). vm_compute. reflexivity.
  - assert (H : forallb (fun ij => forallb (fun kl => eqb
      (edges_fit (scaled_by one_each first) second (fst ij) (snd ij) (fst kl) (snd kl))
      (edges_fit (scaled_by factors first) second (fst ij) (snd ij) (fst kl) (snd kl))) pairs)
      pairs = true) by (vm_compute; reflexivity).
    intros i j k l I J K L. rewrite forallb_forall in H.
    specialize (H (i, j) (in_prod _ _ i j I J)). rewrite forallb_forall in H.
    specialize (H (k, l) (in_prod _ _ k l K L)). apply eqb_prop in H. exact H.
Qed.
Theorem theorem_1_second_half_fails : ~ theorem_1_second_half.
Proof.
  intros H. destruct all_facets_may_change_and_no_edges_holds as (P & Q & s & F & _ & N).
  destruct (F 0%nat) as (j & k & D & B & A); [simpl; auto|].
  destruct (H P Q s) as (i & j' & k' & l & (I & J & K & L) & X).
  { exists 0%nat, j, k. auto. }
  apply X, N; auto.
Qed.
