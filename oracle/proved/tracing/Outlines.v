(** The rings of the program's outlines pass its tests of a ring, and are of the class's pieces. *)
From Coq Require Import Lra Lia Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Kept Frontier
  Linked Coloured Traced Permuted Cycles Bounding Outlined Closed.
Open Scope R_scope.

Section Outlines.
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
Let E := filter (bounds all A) B.

Lemma class_nexts a b : In a E -> next_piece E a = Some b -> In b E /\ finish a = start b.
Proof.
  destruct (class_next S is_in all all_forward decided constant steady_off K falls A A_class)
    as (N & Q & PN & SN). intros Ia Nb. fold B E in Q, PN, SN.
  assert (G : forall l M, map (next_piece E) l = map Some M -> map start M = map finish l ->
    In a l -> In b M /\ finish a = start b).
  { induction l as [|c l IH]; intros [|m M] H1 H2 J; try discriminate; [destruct J|].
    cbn [map] in H1, H2. injection H1; intros T1 N1.
    pose proof (f_equal (@tl point) H2) as T2.
    pose proof (f_equal (hd (finish a)) H2) as S1. cbn [tl hd] in T2, S1.
    destruct J as [->|J].
    - rewrite Nb in N1. injection N1; intros <-. split; [left; auto|symmetry; exact S1].
    - destruct (IH M T1 T2 J) as [G1 G2]. split; [right; auto|auto]. }
  destruct (G E N Q SN Ia) as [G1 G2]. split; [exact (Permutation_in _ PN G1)|exact G2].
Qed.
Theorem class_rings_pass ring : In ring (traces (length E) E E) ->
  is_closed_ring (in_rows (from_least ring)) = true /\
  begins_least (in_rows (from_least ring)) = true.
Proof.
  intros I.
  destruct (class_traces S is_in all all_forward decided constant steady_off K falls A A_class)
    as [P Cy].
  apply (ring_passes E).
  - exact (class_long S is_in all all_forward decided A).
  - apply pairs_filter, (boundary_apart is_in all all_forward).
  - exact class_nexts.
  - apply Cy, I.
  - intros e J. apply (Permutation_in _ P). apply in_concat. exists ring. auto.
  - intros a b. exact (class_passed_once S is_in all all_forward decided constant steady_off K falls
      A A_class ring a b I).
Qed.
Theorem outline_rings_pass ring : In ring (rings_of_outline (outline all B A)) ->
  is_closed_ring ring = true /\ begins_least ring = true /\
  forallb (bounds all A) (concat ring) = true /\ (forall e, In e (concat ring) -> In e B).
Proof.
  unfold rings_of_outline, outline. cbv zeta. cbn [fst snd]. fold E. intros I.
  assert (G : In ring (map (fun l => in_rows (from_least l)) (traces (length E) E E))).
  { apply in_app_or in I. destruct I as [I|I].
    - apply filter_In in I. apply I.
    - apply (Permutation_in _ (sort_members _ _)) in I. apply filter_In in I. apply I. }
  apply in_map_iff in G. destruct G as (l & <- & J). destruct (class_rings_pass l J) as [T1 T2].
  split; [exact T1|split; [exact T2|]].
  destruct (class_traces S is_in all all_forward decided constant steady_off K falls A A_class)
    as [P _].
  assert (In_E : forall e, In e (concat (in_rows (from_least l))) -> In e E).
  { intros e X. rewrite (proj1 (in_rows_pieces _)) in X.
    apply (Permutation_in _ (from_least_members l)) in X. apply (Permutation_in _ P).
    apply in_concat. exists l. auto. }
  split.
  - apply forallb_forall. intros e X. apply In_E in X. apply filter_In in X. apply X.
  - intros e X. apply In_E in X. apply filter_In in X. apply X.
Qed.
End Outlines.

(** All traced pieces are of the boundary, written as there. *)
Lemma exact_self e : exact_edge e e = true.
Proof.
  unfold exact_edge, exact_vertex, exact_number. rewrite !Z.eqb_refl, !Pos.eqb_refl. reflexivity.
Qed.
