(** Around each class of full cells of a boundary its pieces close up, one after another. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique Beside.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Kept Frontier
  Stacks Slabbed Cells Coloured Linked Traced Bordered Ringed Turns Around Sooner Permuted
  Cycles Passing.
Open Scope R_scope.

(** ** No piece is there twice. *)
Lemma edge_le_real e f : edge_le e f = true <->
  before (start e) (start f) \/ (start e = start f /\ ~ before (finish f) (finish e)).
Proof.
  unfold edge_le. rewrite orb_true_iff, andb_true_iff, is_before_real, same_real, not_after_real.
  reflexivity.
Qed.
Lemma before_total (p q : point) : before p q \/ p = q \/ before q p.
Proof.
  unfold before. destruct p as [a b], q as [c d]; cbn [fst snd].
  destruct (Rtotal_order a c) as [|[->|]]; auto. destruct (Rtotal_order b d) as [|[->|]]; auto.
Qed.
Lemma before_transitive (p q r : point) : before p q -> before q r -> before p r.
Proof. unfold before. destruct p, q, r; cbn [fst snd]. lra. Qed.
Lemma never_both (p q : point) : before p q -> before q p -> False.
Proof. unfold before. destruct p, q; cbn [fst snd]. lra. Qed.
Lemma edge_le_total e f : edge_le e f = true \/ edge_le f e = true.
Proof.
  rewrite !edge_le_real. destruct (before_total (start e) (start f)) as [H|[H|H]]; auto.
  destruct (classic (before (finish f) (finish e))) as [B|B]; [|auto]. right. right.
  split; auto. intros D. exact (never_both _ _ B D).
Qed.
Lemma edge_le_transitive e f g : edge_le e f = true -> edge_le f g = true -> edge_le e g = true.
Proof.
  rewrite !edge_le_real. intros [H|[H H']] [K|[K K']].
  - left. exact (before_transitive _ _ _ H K).
  - left. rewrite <- K. exact H.
  - left. rewrite H. exact K.
  - right. split; [congruence|]. intros B.
    destruct (before_total (finish f) (finish e)) as [D|[D|D]]; [auto| |].
    + apply K'. rewrite D. exact B.
    + apply K'. exact (before_transitive _ _ _ B D).
Qed.
Lemma edge_le_same e f : edge_le e f = true -> edge_le f e = true -> same_edge e f = true.
Proof.
  rewrite !edge_le_real. unfold same_edge. rewrite andb_true_iff, !same_real.
  fold (start e) (start f) (finish e) (finish f). intros [H|[H H']] [K|[K K']].
  - destruct (never_both _ _ H K).
  - rewrite K in H. destruct (never_both _ _ H H).
  - rewrite H in K. destruct (never_both _ _ K K).
  - split; auto. destruct (before_total (finish e) (finish f)) as [D|[D|D]]; tauto.
Qed.
Definition no_common (e f : edge) : Prop := forall x, inside e x -> inside f x -> False.
Lemma pairs_filter {A} (R : A -> A -> Prop) test l : ForallOrdPairs R l ->
  ForallOrdPairs R (filter test l).
Proof.
  induction 1 as [|x l F G IH]; cbn [filter]; [constructor|]. destruct (test x); auto.
  constructor; auto. rewrite Forall_forall in *. intros y Y. apply filter_In in Y. apply F, Y.
Qed.

Section Bounding.
Variable S : point -> Prop.
Variable is_in : vertex -> bool.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.
Hypothesis decided : decides is_in all S.
Hypothesis constant : forall x, ~ over_some all x -> steady S x.
Let B := boundary is_in all.
Hypothesis steady_off : forall x, ~ over_some B x -> steady S x.

Lemma pieces_apart : ForallOrdPairs no_common (pieces all).
Proof.
  assert (St : StronglySorted (fun e f => edge_le f e = false) (pieces all)).
  { unfold pieces, edges_once, in_turn.
    apply (unique_strict edge_le same_edge edge_le_total edge_le_transitive edge_le_same).
    apply (sort_ordered edge_le edge_le_total edge_le_transitive). }
  assert (G : forall e f, In e (pieces all) -> In f (pieces all) -> edge_le f e = false ->
    no_common e f).
  { intros e f I J N x X Y.
    pose proof (piece_forward all all_forward e I) as Fe.
    pose proof (piece_forward all all_forward f J) as Ff.
    destruct (same_ends e f (before_different _ _ Fe) (before_different _ _ Ff)
      (pieces_same all all_forward e f x I J X Y) (pieces_same all all_forward f e x J I Y X))
      as [[E1 E2]|[E1 E2]].
    - apply not_true_iff_false in N. apply N, edge_le_real. right. split; auto.
      rewrite E2. intros D. exact (never_both _ _ D D).
    - unfold forward in *. fold (start e) (finish e) in Fe. fold (start f) (finish f) in Ff.
      rewrite E1, E2 in Fe. exact (never_both _ _ Fe Ff). }
  induction St as [|e l St IH F]; constructor.
  - rewrite Forall_forall in *. intros f I. apply G; simpl; auto.
  - apply IH. intros; apply G; simpl; auto.
Qed.
Lemma boundary_apart : ForallOrdPairs no_common B.
Proof.
  unfold B, boundary. set (h := fun e : edge => _).
  assert (H : forall e f, In f (h e) -> forall x, inside f x -> inside e x).
  { intros e f I x X. unfold h in I. destruct (beside all e) as [l r].
    destruct (is_in l), (is_in r); try destruct I as [<-|[]]; try destruct I; auto.
    destruct X as (w & W & Q). exists (1 - w). split; [lra|]. rewrite Q. unfold start, finish.
    cbn [fst snd]. f_equal; ring. }
  assert (One : forall e, h e = [] \/ exists f, h e = [f]).
  { intros e. unfold h. destruct (beside all e) as [l r].
    destruct (is_in l), (is_in r); eauto. }
  clearbody h. induction pieces_apart as [|e l F G IH]; cbn [flat_map]; [constructor|].
  destruct (One e) as [->|(f & Q)]; cbn [app]; auto. rewrite Q. cbn [app]. constructor; auto.
  rewrite Forall_forall in *. intros g I x X Y. apply in_flat_map in I. destruct I as (k & J & I).
  apply (F k J x); [apply (H e f)|apply (H k g)]; auto. rewrite Q. simpl. auto.
Qed.

Lemma holds_back c p : in_cell c (R2 p) -> holds c p = true.
Proof.
  intros (A & D & L & H). unfold holds. rewrite !andb_true_iff. split; [split; [split|]|].
  - destruct (from c) as [q|]; auto. apply le_real. exact (A q eq_refl).
  - destruct (to c) as [q|]; auto. apply le_real. exact (D q eq_refl).
  - destruct (bottom c) as [e|]; auto. specialize (L e eq_refl).
    unfold side. fold (qturn (fst (from_left e)) (snd (from_left e)) p).
    unfold level, start, finish in L. rewrite <- qturn_real in L. apply Z.leb_le.
    pose proof (sg_neg (qturn (fst (from_left e)) (snd (from_left e)) p)) as N.
    destruct (Rlt_dec (Q2R (qturn (fst (from_left e)) (snd (from_left e)) p)) 0); [lra|].
    apply Z.ltb_ge in N. lia.
  - destruct (top c) as [e|]; auto. specialize (H e eq_refl).
    unfold side. fold (qturn (fst (from_left e)) (snd (from_left e)) p).
    unfold level, start, finish in H. rewrite <- qturn_real in H. apply Z.leb_le.
    pose proof (sg_pos (qturn (fst (from_left e)) (snd (from_left e)) p)) as N.
    destruct (Rlt_dec 0 (Q2R (qturn (fst (from_left e)) (snd (from_left e)) p))); [lra|].
    apply Z.ltb_ge in N. lia.
Qed.

Variable K : list (list cell).
Hypothesis falls : falls_into (interior S) (fun i => part_of (interior S) (nth i K [])) (length K).
Variable A : list cell.
Hypothesis A_class : In A K.
Let C := part_of (interior S) A.
Let E := filter (bounds all A) B.

Lemma class_open x : C x -> interior C x.
Proof.
  destruct (In_nth K A [] A_class) as (i & L & Q). destruct falls as [_ Each].
  destruct (Each i L) as (_ & Open & _). cbv beta in Open. rewrite Q in Open. apply Open.
Qed.
Lemma class_in x : C x -> S x.
Proof. intros [(r & R & H) _]. apply H, near_self, R. Qed.
(** Along a piece of the boundary that bounds another class *)
Lemma piece_passed e x : In e B -> bounds all A e = false -> inside e x -> steady C x.
Proof.
  intros I Bo X.
  destruct (kept_sided S is_in all all_forward decided constant e x I X) as (s & Hs & Sd).
  assert (Out : ~ C (R2 (left_point all e))).
  { intros [_ (c & Ic & Hc)]. apply not_true_iff_false in Bo. apply Bo. unfold bounds. cbv zeta.
    apply existsb_exists. exists c. split; auto. apply holds_back, Hc. }
  assert (Not : forall z, ~ over_some all z -> steady (fun y => ~ C y) z).
  { intros z N. destruct (part_steady S all constant K falls A z A_class N) as (r & R & H).
    exists r. split; auto. intros y Y. specialize (H y Y). unfold C. tauto. }
  assert (Got : exists r, 0 < r /\ forall y, near r x y -> 0 < orient (start e) (finish e) y ->
    ~ C y).
  { destruct (kept_from S is_in all all_forward decided e I) as (p & Ip & [(-> & _)|(-> & _)]).
    - pose proof (piece_forward all all_forward p Ip) as Fw. apply is_before_real in Fw.
      unfold left_point in Out. rewrite Fw in Out.
      apply (left_all all all_forward p Ip _ Not x); auto.
    - pose proof (piece_forward all all_forward p Ip) as Fw. unfold forward in Fw.
      assert (Nb : is_before (snd p) (fst p) = false).
      { apply not_true_iff_false. rewrite is_before_real. unfold before in *. lra. }
      unfold left_point in Out. cbn [fst snd] in Out. rewrite Nb in Out.
      unfold turned_back in Out. cbn [fst snd] in Out. rewrite <- surjective_pairing in Out.
      assert (X' : inside p x).
      { destruct X as (w & W & Q). exists (1 - w). split; [lra|]. rewrite Q.
        unfold start, finish; cbn [fst snd]. f_equal; ring. }
      destruct (right_all all all_forward p Ip _ Not x Out X') as (r & R & H).
      exists r. split; auto. intros y Y O. apply H; auto.
      change (start (snd p, fst p)) with (finish p) in O.
      change (finish (snd p, fst p)) with (start p) in O. rewrite orient_swap in O. lra. }
  destruct Got as (r & R & H).
  assert (None : forall y, near (Rmin r s) x y -> ~ C y).
  { intros y Y Cy. pose proof (near_min r s x y Y) as [Y1 Y2].
    destruct (Rtotal_order (orient (start e) (finish e) y) 0) as [O|[O|O]].
    - apply (proj2 (Sd y Y2) O), class_in, Cy.
    - destruct (class_open y Cy) as (t & T & L). destruct (near_within x y s Y2) as (u & U & M).
      assert (Long : start e <> finish e).
      { destruct (kept_from S is_in all all_forward decided e I) as (p & Ip & Hp).
        pose proof (before_different _ _ (piece_forward all all_forward p Ip)) as D.
        destruct Hp as [(-> & _)|(-> & _)]; unfold start, finish; cbn [fst snd]; auto. }
      destruct (right_close (start e) (finish e) y (Rmin t u) Long O) as (z & Z & Oz);
        [apply Rmin_glb_lt; auto|]. apply near_min in Z.
      apply (proj2 (Sd z (M z (proj2 Z))) Oz), class_in, L, Z.
    - exact (H y Y1 O Cy). }
  exists (Rmin r s). assert (P : 0 < Rmin r s) by (apply Rmin_glb_lt; auto). split; auto.
  intros y Y. split; intros Cy; exfalso; [exact (None y Y Cy)|].
  exact (None x (near_self _ _ P) Cy).
Qed.
Let few := map start B ++ map finish B.
Lemma class_steady x : ~ over_some E x -> ~ In x few -> steady C x.
Proof.
  intros N F. destruct (classic (over_some B x)) as [(e & I & O)|Off].
  - assert (X : inside e x).
    { apply inner_of_segment; auto; intros ->; apply F, in_or_app; [left|right]; apply in_map, I. }
    apply (piece_passed e x I); auto. apply not_true_iff_false. intros Bo. apply N. exists e.
    split; auto. apply filter_In. auto.
  - exact (part_steady S B steady_off K falls A x A_class Off).
Qed.
Lemma class_long e : In e E -> start e <> finish e.
Proof.
  intros I. apply filter_In in I. destruct I as [I _].
  destruct (kept_from S is_in all all_forward decided e I) as (p & Ip & Hp).
  pose proof (before_different _ _ (piece_forward all all_forward p Ip)) as D.
  destruct Hp as [(-> & _)|(-> & _)]; unfold start, finish; cbn [fst snd]; auto.
Qed.
Lemma class_sided e x : In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Proof.
  intros I X. apply filter_In in I. destruct I as [I Bo].
  destruct (piece_borders S is_in all all_forward decided constant K falls A e x A_class I Bo X)
    as (r & R & H). exists r. split; auto. intros y Y. destruct (H y Y) as [H1 H2].
  split; auto. intros O Cy. apply (H2 O), class_in, Cy.
Qed.
Lemma class_no_end e f : In e E -> In f E -> ~ inside e (finish f).
Proof.
  intros I J. apply filter_In in I. apply filter_In in J.
  apply (kept_no_end S is_in all all_forward decided); [apply I|apply J].
Qed.
Theorem class_next : exists N, map (next_piece E) E = map Some N /\ Permutation N E /\
  map start N = map finish E.
Proof.
  apply (next_permutes C class_open E few class_long class_sided class_steady class_no_end).
  apply pairs_filter, boundary_apart.
Qed.
Theorem class_closes : closed (map R2e E).
Proof.
  apply (pieces_close C class_open E few class_long class_sided class_steady class_no_end).
  apply pairs_filter, boundary_apart.
Qed.
(** Each piece of the class is in one of the rings that are traced, once. *)
Theorem class_traces : Permutation (concat (traces (length E) E E)) E /\
  forall ring, In ring (traces (length E) E E) -> is_cycle E ring.
Proof.
  assert (Ap : ForallOrdPairs no_common E) by apply pairs_filter, boundary_apart.
  apply traces_are_cycles.
  - intros e I. destruct (next_is_there C class_open E few class_long class_sided class_steady
      class_no_end e I) as (h & N & J & _). eauto.
  - exact (next_once C class_open E few class_long class_sided class_steady class_no_end Ap).
  - intros e f I J Q. unfold same_edge in Q. rewrite andb_true_iff, !same_real in Q.
    destruct Q as [Q1 Q2]. apply (apart_equal E Ap e f (at_ (start e) (finish e) (1 / 2)) I J).
    + apply some_inside.
    + unfold start, finish. rewrite Q1, Q2. apply some_inside.
  - intros e. unfold same_edge. apply andb_true_iff. rewrite !same_real. auto.
  - exact (no_piece_twice E Ap).
Qed.
(** And no ring passes a point twice. *)
Lemma class_part : is_part S C (map R2e B).
Proof.
  destruct (In_nth K A [] A_class) as (i & L & Q). destruct falls as [_ Each].
  destruct (Each i L) as (_ & _ & Joined & _). cbv beta in Joined. rewrite Q in Joined.
  split; [exact class_open|split; [exact Joined|split; [exact class_in|]]].
  intros x N. apply (part_steady S B steady_off K falls A x A_class). intros (e & I & O). apply N.
  exists (start e), (finish e). split; [exact (in_map R2e _ _ I)|exact O].
Qed.
Theorem class_passed_once ring a b : In ring (traces (length E) E E) -> In a ring -> In b ring ->
  finish a = finish b -> a = b.
Proof.
  intros I. destruct class_traces as [P Cy].
  apply (passed_once S C (map R2e B) class_part E few class_long).
  - intros e x J X. apply filter_In in J. destruct J as [J Bo].
    exact (piece_borders S is_in all all_forward decided constant K falls A e x A_class J Bo X).
  - exact class_steady.
  - exact class_no_end.
  - apply pairs_filter, boundary_apart.
  - apply Cy, I.
  - intros c J. apply (Permutation_in _ P). apply in_concat. exists ring. auto.
Qed.
End Bounding.
