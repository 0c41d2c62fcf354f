(** What is traced around the classes of a boundary passes all tests of the program, where in each
    class one ring is an outer one and the others are holes. *)
From Coq Require Import Lra Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components Paths
  Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Kept Frontier
  Slabbed Linked Coloured Traced Rows Ringed Transfer Formed Bordered Permuted Cycles Bounding
  Outlined Outlines Ascending.
Open Scope R_scope.

Lemma ring_lists_permuted {A} (l k : list (list A)) : Permutation l k ->
  Permutation (concat l) (concat k).
Proof.
  rewrite <- (map_id l), <- (map_id k), <- !flat_map_concat_map. intros P.
  assert (Q := Permutation_flat_map (fun x : list A => x) P). rewrite !map_id in *. exact Q.
Qed.

Opaque parts outlines boundary traces.
Section Accepted.
Variable S : point -> Prop.
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.
Hypothesis steady_off : forall x, ~ over_some B x -> steady S x.
Let K := parts B true.
Hypothesis falls : falls_into (interior S) (fun i => part_of (interior S) (nth i K [])) (length K).
Let around (A : list cell) := filter (bounds all A) B.
Let traced (A : list cell) := traces (length (around A)) (around A) (around A).
Hypothesis one_outer : forall A, In A K -> exists r, fst (snd (outline all B A)) = [r].
Hypothesis rings_kept : forall A, In A K -> Permutation (rings_of_outline (outline all B A))
  (map (fun l => in_rows (from_least l)) (traced A)).

(** ** Each piece of the boundary bounds one class. *)
Lemma left_point_inside e : In e B -> interior S (R2 (left_point all e)).
Proof.
  intros I.
  destruct (kept_from S is_in all all_forward decided e I) as (p & Ip & Hp).
  pose proof (piece_forward all all_forward p Ip) as Fw.
  destruct (tested_clear all all_forward p Ip) as [Cl Cr].
  destruct Hp as [(-> & Sl & _)|(-> & _ & Sr)].
  - apply is_before_real in Fw. unfold left_point. rewrite Fw.
    exact (steady_inside S all constant _ Cl Sl).
  - assert (Nb : is_before (snd p) (fst p) = false).
    { apply not_true_iff_false. rewrite is_before_real. unfold forward, before in *. lra. }
    unfold left_point. cbn [fst snd]. rewrite Nb. unfold turned_back. cbn [fst snd].
    rewrite <- surjective_pairing. exact (steady_inside S all constant _ Cr Sr).
Qed.
Lemma bounds_part A e : In e B ->
  (bounds all A e = true <-> part_of (interior S) A (R2 (left_point all e))).
Proof.
  intros I. unfold bounds. cbv zeta. rewrite existsb_exists. split.
  - intros (c & Ic & H). split; [apply left_point_inside, I|]. exists c. split; auto.
    apply holds_real, H.
  - intros [_ (c & Ic & H)]. exists c. split; auto. apply holds_back, H.
Qed.
Lemma some_class e : In e B -> exists A, In A K /\ bounds all A e = true.
Proof.
  intros I. destruct (proj1 (proj1 falls _) (left_point_inside e I)) as (i & L & H).
  exists (nth i K []). split; [apply nth_In, L|]. apply bounds_part, H. exact I.
Qed.
Lemma B_apart : ForallOrdPairs no_common B.
Proof. exact (boundary_apart is_in all all_forward). Qed.
Lemma classes_apart :
  ForallOrdPairs (fun A D => forall e, In e (around A) -> In e (around D) -> False) K.
Proof.
  apply (pairs_by_place _ []). intros i j [I J] e H L. apply filter_In in H, L.
  destruct H as [Ie H], L as [_ L]. apply (bounds_part _ e Ie) in H, L.
  destruct falls as [_ Each].
  destruct (Each i (PeanoNat.Nat.lt_trans _ _ _ I J)) as (_ & _ & _ & Dis).
  pose proof (Dis j _ J H L). subst j. exact (PeanoNat.Nat.lt_irrefl _ I).
Qed.
Lemma pieces_once : NoDup (flat_map around K).
Proof.
  apply flat_once; [|exact classes_apart]. intros A _.
  apply NoDup_filter, (no_piece_twice B B_apart).
Qed.

(** ** All pieces are traced, each once. *)
Lemma outline_pieces A : In A K ->
  Permutation (concat (concat (rings_of_outline (outline all B A)))) (around A).
Proof.
  intros I.
  rewrite (ring_lists_permuted _ _ (ring_lists_permuted _ _ (rings_kept A I))).
  destruct (class_traces S is_in all all_forward decided constant steady_off K falls A I)
    as [P _]. fold B in P. fold (around A) in P. fold (traced A) in P.
  apply Permutation_trans with (concat (traced A)); [|exact P].
  clear P. induction (traced A) as [|l T IH]; auto. cbn [map concat]. rewrite concat_app.
  apply Permutation_app; [|exact IH]. rewrite (proj1 (in_rows_pieces _)). apply from_least_members.
Qed.
Let os := outlines all B.
Lemma outlines_are : Permutation os (map (outline all B) K).
Proof. Transparent outlines. apply sort_members. Opaque outlines. Qed.
Lemma pieces_by_outline l :
  all_pieces l = flat_map (fun o => concat (concat (rings_of_outline o))) l.
Proof.
  unfold all_pieces. induction l as [|o l IH]; auto. cbn [flat_map].
  rewrite !concat_app, IH. reflexivity.
Qed.
Lemma pieces_by_ring (l : list (list row)) : concat (concat l) = flat_map (@concat edge) l.
Proof. rewrite flat_map_concat_map. exact (concat_twice l). Qed.
Lemma pieces_traced : Permutation (all_pieces os) (flat_map around K).
Proof.
  rewrite pieces_by_outline, outlines_are, flat_map_concat_map, map_map, <- flat_map_concat_map.
  apply flat_permuted, outline_pieces.
Qed.
Lemma traced_once : NoDup (all_pieces os).
Proof. exact (Permutation_NoDup (Permutation_sym pieces_traced) pieces_once). Qed.
Lemma traced_are e : In e (all_pieces os) <-> In e B.
Proof.
  split; intros I.
  - apply (Permutation_in _ pieces_traced), in_flat_map in I. destruct I as (A & _ & I).
    apply filter_In in I. apply I.
  - apply (Permutation_in _ (Permutation_sym pieces_traced)), in_flat_map.
    destruct (some_class e I) as (A & HA & H). exists A. split; auto. apply filter_In. auto.
Qed.
Lemma each_outline o : In o os -> exists A, In A K /\ o = outline all B A.
Proof.
  intros I. apply (Permutation_in _ outlines_are), in_map_iff in I.
  destruct I as (A & <- & I). eauto.
Qed.
(** No piece is there twice, nor turned back. *)
Lemma pieces_pass : each_pair (fun e f => negb (same_edge e f) &&
  negb (same_edge e (turned_back f))) (all_pieces os) = true.
Proof.
  apply each_pair_of; [exact traced_once|]. intros e f I' J' N.
  pose proof (proj1 (traced_are e) I') as I. pose proof (proj1 (traced_are f) J') as J.
  assert (H : forall g, In g B -> inside g (at_ (start e) (finish e) (1 / 2)) -> e = g).
  { intros g Ig X. apply (apart_equal B B_apart e g _ I Ig (some_inside e) X). }
  apply andb_true_iff. rewrite !negb_true_iff, <- !not_true_iff_false. unfold same_edge.
  rewrite !andb_true_iff, !same_real. cbn [turned_back fst snd].
  split; intros [E1 E2]; apply N, H; auto; unfold start, finish; rewrite E1, E2.
  - apply some_inside.
  - exists (1 / 2). split; [lra|]. unfold at_, start, finish; cbn [fst snd]. f_equal; lra.
Qed.

(** ** Rings with equal corners have a piece in common. *)
Let rings := flat_map rings_of_outline os.
Lemma rings_pass ring : In ring rings -> is_closed_ring ring = true /\
  begins_least ring = true /\ forall e, In e (concat ring) -> In e B.
Proof.
  intros I. apply in_flat_map in I. destruct I as (o & Io & I).
  destruct (each_outline o Io) as (A & HA & ->).
  destruct (outline_rings_pass S is_in all all_forward decided constant steady_off K falls A HA
    ring I) as (T1 & T2 & _ & T4). auto.
Qed.
Lemma ring_parts ring : In ring rings -> (exists r k, ring = r :: k) /\
  (forall r, In r ring -> is_straight r = true) /\
  ring_edges (map R2 (corners_of ring)) = map real_edge ring.
Proof.
  intros I. destruct (rings_pass ring I) as (T & _). unfold is_closed_ring in T.
  rewrite !andb_true_iff, !forallb_forall in T. destruct T as [[[N St] Be] _].
  split; [destruct ring; [discriminate|eauto]|split; [exact St|]]. apply corners_edges.
  intros r k J. specialize (Be (r, k) J). unfold bends in Be. apply andb_true_iff in Be.
  apply same_real, Be.
Qed.
Lemma piece_in_common r k : In r rings -> In k rings ->
  map R2 (corners_of r) = map R2 (corners_of k) -> exists e, In e (concat r) /\ In e (concat k).
Proof.
  intros I J E. destruct (ring_parts r I) as ((a & r' & Er) & Sr & Cr).
  destruct (ring_parts k J) as ((b & k' & Ek) & Sk & Ck).
  destruct (rings_pass r I) as (_ & _ & Br). destruct (rings_pass k J) as (_ & _ & Bk).
  assert (Ar : forall e, In e a -> In e (concat r)) by (intros; subst r; apply in_or_app; auto).
  assert (Ak : forall e, In e b -> In e (concat k)) by (intros; subst k; apply in_or_app; auto).
  assert (Long : forall e, In e B -> start e <> finish e).
  { intros e Ie. destruct (some_class e Ie) as (A & HA & H).
    apply (class_long S is_in all all_forward decided A). apply filter_In. auto. }
  assert (Same : real_edge a = real_edge b).
  { rewrite E, Ck in Cr. rewrite Er, Ek in Cr. cbn [map] in Cr.
    symmetry. exact (f_equal (hd (real_edge a)) Cr). }
  destruct (row_is_edge a) as (_ & On & _).
  { apply Sr. rewrite Er. simpl. auto. }
  { intros e X. apply Long, Br, Ar, X. }
  destruct (row_is_edge b) as (_ & On' & _).
  { apply Sk. rewrite Ek. simpl. auto. }
  { intros e X. apply Long, Bk, Ak, X. }
  destruct a as [|e a]; [assert (T := Sr [] ltac:(rewrite Er; simpl; auto)); discriminate T|].
  set (m := at_ (start e) (finish e) (1 / 2)).
  assert (M : lies_on (edge_of (e :: a)) m).
  { apply On. exists e. split; [simpl; auto|]. apply inside_on, some_inside. }
  assert (M' : lies_on (edge_of b) m).
  { change (on_segment (fst (real_edge b)) (snd (real_edge b)) m). rewrite <- Same. exact M. }
  apply On' in M'. destruct M' as (f & F & Of).
  assert (Ie : In e B) by (apply Br, Ar; simpl; auto).
  assert (If : In f B) by (apply Bk, Ak, F).
  destruct (kept_no_end S is_in all all_forward decided e f Ie If) as [N1 N2].
  assert (X : inside f m).
  { apply inner_of_segment; auto; intros Q; [apply N1|apply N2]; rewrite <- Q;
      apply some_inside. }
  exists e. split; [apply Ar; simpl; auto|]. apply Ak.
  rewrite (apart_equal B B_apart e f m Ie If (some_inside e) X). exact F.
Qed.
Lemma ring_not_empty ring : In ring rings -> concat ring <> [].
Proof.
  intros I. destruct (ring_parts ring I) as ((r & k & ->) & St & _).
  specialize (St r (or_introl eq_refl)). destruct r; discriminate.
Qed.

(** ** The tests *)
Lemma outline_passes o : In o os -> is_outline all o = true.
Proof.
  intros Io. destruct (each_outline o Io) as (A & HA & Eo).
  assert (In_it : forall r, In r (rings_of_outline o) -> In r rings).
  { intros r J. apply in_flat_map. eauto. }
  assert (Once : NoDup (concat (concat (rings_of_outline o)))).
  { apply (Permutation_NoDup (l := around A)).
    - rewrite Eo. apply Permutation_sym, outline_pieces, HA.
    - apply NoDup_filter, (no_piece_twice B B_apart). }
  rewrite pieces_by_ring in Once.
  unfold is_outline. rewrite !andb_true_iff. split; [split; [split; [split|]|]|].
  - destruct (one_outer A HA) as (r & Er). rewrite <- Eo in Er. rewrite Er.
    assert (J : In r (fst (snd o))) by (rewrite Er; simpl; auto).
    rewrite Eo in J. apply filter_In in J. apply J.
  - apply forallb_forall. intros r J. rewrite Eo in J. unfold outline in J. cbv zeta in J.
    cbn [fst snd] in J. apply (Permutation_in _ (sort_members _ _)), filter_In in J. apply J.
  - apply forallb_forall. intros r J. destruct (rings_pass r (In_it r J)) as (T1 & T2 & _).
    rewrite T1, T2. reflexivity.
  - apply forallb_forall. intros e J. rewrite Eo in J.
    apply (Permutation_in _ (outline_pieces A HA)), filter_In in J. rewrite Eo. apply J.
  - assert (D : forall l, Permutation l (snd (snd o)) -> NoDup l /\ forall r k, In r l -> In k l ->
      r <> k -> map R2 (corners_of r) <> map R2 (corners_of k)).
    { intros l P. assert (Sub : forall r, In r l -> In r (rings_of_outline o)).
      { intros r J. apply in_or_app. right. exact (Permutation_in _ P J). }
      split.
      - apply (Permutation_NoDup (Permutation_sym P)).
        apply (once_after (fst (snd o))). apply (lists_once (@concat edge)); auto.
        intros r J. apply ring_not_empty, In_it, J.
      - intros r k J L N E. apply N.
        destruct (piece_in_common r k (In_it r (Sub r J)) (In_it k (Sub k L)) E) as (e & E1 & E2).
        exact (common_member (@concat edge) _ Once r k e (Sub r J) (Sub k L) E1 E2). }
    rewrite Eo in D |- *. unfold outline in D |- *. cbv zeta in D |- *. cbn [fst snd] in D |- *.
    destruct (D _ (Permutation_sym (sort_members _ _))) as [D1 D2].
    apply sorted_ascends; auto.
Qed.
Theorem outlines_pass : are_outlines all B (outlines all B) = true.
Proof.
  unfold are_outlines. fold os. rewrite !andb_true_iff. split; [split; [split; [split|]|]|].
  - apply forallb_forall, outline_passes.
  - exact pieces_pass.
  - apply forallb_forall. intros e I. apply existsb_exists. exists e.
    split; [apply traced_are, I|apply exact_self].
  - apply forallb_forall. intros e I. apply existsb_exists. exists e.
    split; [apply traced_are, I|apply exact_self].
  - set (f := fun o => concat (concat (rings_of_outline o))).
    pose proof traced_once as Once. rewrite pieces_by_outline in Once. fold f in Once.
    assert (Outer : forall o, In o os -> exists r, fst (snd o) = [r] /\ In r rings).
    { intros o I. destruct (each_outline o I) as (A & HA & Eo).
      destruct (one_outer A HA) as (r & Er). rewrite <- Eo in Er. exists r. split; auto.
      apply in_flat_map. exists o. split; auto. unfold rings_of_outline. rewrite Er. simpl. auto. }
    assert (Sub : forall (o : outlined) (r : list row) e, fst (snd o) = [r] ->
      In e (concat r) -> In e (f o)).
    { intros o r e E I. unfold f, rings_of_outline. rewrite E. simpl. rewrite concat_app.
      apply in_or_app. auto. }
    assert (D : NoDup os /\ forall o k, In o os -> In k os -> o <> k ->
      map R2 (outer_corners o) <> map R2 (outer_corners k)).
    { split.
      - apply (lists_once f); auto. intros o I. destruct (Outer o I) as (r & Er & Ir).
        pose proof (ring_not_empty r Ir) as N. destruct (concat r) as [|e l] eqn:C; [congruence|].
        intros Z. specialize (Sub o r e Er). rewrite C, Z in Sub. apply Sub. simpl. auto.
      - intros o k I J N E. apply N. destruct (Outer o I) as (r & Er & Ir).
        destruct (Outer k J) as (q & Eq & Iq). unfold outer_corners in E. rewrite Er, Eq in E.
        cbn [flat_map] in E. rewrite !app_nil_r in E.
        destruct (piece_in_common r q Ir Iq E) as (e & E1 & E2).
        apply (common_member f os Once o k e I J); eauto. }
    assert (D' : forall l, Permutation l os -> NoDup l /\ forall o k, In o l -> In k l -> o <> k ->
      map R2 (outer_corners o) <> map R2 (outer_corners k)).
    { intros l P. split; [exact (Permutation_NoDup (Permutation_sym P) (proj1 D))|].
      intros o k I J. apply D; apply (Permutation_in _ P); auto. }
    destruct (D' _ (Permutation_sym outlines_are)) as [D1 D2].
    Transparent outlines. unfold os, outlines. apply sorted_ascends; auto.
Qed.
End Accepted.
