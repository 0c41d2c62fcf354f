(** The program of Validity.v decides whether polygons are legal: it says yes exactly where they
    are. *)
From Coq Require Import Lra Lia Permutation Bool QArith Qreals Qreduction ZArith.
From Proved Require Import Definitions Form Legality Sums Corners Scaling Local Overlaps Paths
  Decomposed Gaps Unique Rounds.
From Proved Require Import Points Legal Member Decided Pieces Along Cuts.
From Proved Require Import Validity Overhead Once Pairs.
Open Scope R_scope.

Notation real_ring := (map point_of).
Lemma ring_real ring : ring_edges (real_ring ring) = map R2e (ring_edges ring).
Proof. rewrite ring_edges_map. reflexivity. Qed.
Lemma area_real ring : Q2R (twice_area ring) = area (real_ring ring).
Proof.
  unfold twice_area, area. rewrite ring_real. induction (ring_edges ring) as [|e l IH]; simpl.
  - apply zero_real.
  - rewrite Q2R_red, Q2R_plus, qcross_real, IH. reflexivity.
Qed.
Lemma null_real e : null e = false <-> fst (R2e e) <> snd (R2e e).
Proof. unfold null. rewrite <- not_true_iff_false, same_real. reflexivity. Qed.

(** ** Lists of the figure, and of the file *)
Lemma in_figure ps o h : In (o, h) (figure ps) <-> exists p, In p ps /\
  o = real_ring (fst p) /\ h = map real_ring (snd p).
Proof.
  unfold figure, each_vertex. rewrite in_map_iff. split.
  - intros (p & E & I). injection E; intros <- <-. exists p. auto.
  - intros (p & I & -> & ->). exists p. auto.
Qed.
Lemma figure_edges ps : all_edges (rings_of (figure ps)) = map R2e (all_edges (rings_of ps)).
Proof. rewrite <- rings_of_figure, <- edges_of_points. reflexivity. Qed.
Lemma polygon_edges (p : polygon vertex) :
  all_edges (real_ring (fst p) :: map real_ring (snd p)) = map R2e (all_edges (fst p :: snd p)).
Proof. symmetry. exact (edges_of_points (fst p :: snd p)). Qed.
Lemma polygon_part (ps : list (polygon vertex)) p : In p ps -> exists l r,
  all_edges (rings_of ps) = l ++ all_edges (fst p :: snd p) ++ r.
Proof.
  intros I. destruct (in_split _ _ I) as (l & r & ->).
  exists (all_edges (rings_of l)), (all_edges (rings_of r)).
  unfold rings_of, all_edges. rewrite !flat_map_app. simpl. rewrite flat_map_app. simpl.
  rewrite <- app_assoc. reflexivity.
Qed.
Lemma ring_part (r : rings vertex) ring : In ring r -> exists l k,
  all_edges r = l ++ ring_edges ring ++ k.
Proof.
  intros I. destruct (in_split _ _ I) as (l & k & ->). exists (all_edges l), (all_edges k).
  unfold all_edges. rewrite flat_map_app. reflexivity.
Qed.
Lemma edges_closed_real r : closed (map R2e (all_edges r)).
Proof. rewrite edges_of_points. apply rings_are_closed. Qed.

(** The program's questions, of real points *)
Definition in_words (ps : list (polygon vertex)) : Prop :=
  ((forall ring, In ring (rings_of ps) -> is_simple (real_ring ring)) /\
   share_points_only (map R2e (all_edges (rings_of ps)))) /\
  (forall p, In p ps -> 0 < area (real_ring (fst p)) /\
    forall hole, In hole (snd p) -> area (real_ring hole) < 0) /\
  (forall p, In p ps -> once (map R2e (all_edges (fst p :: snd p)))) /\
  once (map R2e (all_edges (rings_of ps))).
Lemma in_words_right ps : in_words ps <-> is_polygon_set (figure ps).
Proof.
  unfold in_words, is_polygon_set. rewrite figure_edges. split.
  - intros ((S & Sh) & A & O & OE). split; [|split; auto]. intros o h I. apply in_figure in I.
    destruct I as (p & I & -> & ->). destruct (A p I) as [A1 A2].
    assert (K : forall ring, In ring (fst p :: snd p) -> is_simple (real_ring ring)).
    { intros ring J. apply S. apply in_flat_map. exists p. auto. }
    split; [apply K; simpl; auto|]. split; [exact A1|]. split.
    + intros hole J. apply in_map_iff in J. destruct J as (k & <- & J).
      split; [apply K; simpl; auto|apply A2, J].
    + rewrite polygon_edges. apply O, I.
  - intros (H & Sh & OE). split; [split; auto|split; [|split; auto]].
    + intros ring I. apply in_flat_map in I. destruct I as (p & I & J).
      destruct (H (real_ring (fst p)) (map real_ring (snd p))) as (S & _ & K & _).
      { apply in_figure. exists p. auto. }
      destruct J as [<-|J]; auto. apply K, in_map, J.
    + intros p I. destruct (H (real_ring (fst p)) (map real_ring (snd p))) as (_ & A & K & _).
      { apply in_figure. exists p. auto. }
      split; auto. intros hole J. apply K, in_map, J.
    + intros p I. destruct (H (real_ring (fst p)) (map real_ring (snd p))) as (_ & _ & _ & K).
      { apply in_figure. exists p. auto. }
      rewrite polygon_edges in K. exact K.
Qed.

(** ** The tests, one after the other *)
Definition long_rings (r : rings vertex) : Prop := forall ring, In ring r ->
  (3 <= length ring)%nat /\ forall e, In e (ring_edges ring) -> null e = false.
Lemma sound_right r : forallb sound_ring r = true <-> long_rings r.
Proof.
  rewrite forallb_forall. split; intros H ring I; specialize (H ring I); unfold sound_ring in *.
  - apply andb_true_iff in H. destruct H as [L N]. split; [apply Nat.leb_le, L|]. intros e J.
    rewrite forallb_forall in N. apply negb_true_iff, N, J.
  - destruct H as [L N]. apply andb_true_iff. split; [apply Nat.leb_le, L|].
    apply forallb_forall. intros e J. apply negb_true_iff, N, J.
Qed.
Lemma long_edges r : long_rings r -> forall e, In e (all_edges r) -> null e = false.
Proof.
  intros H e I. apply in_flat_map in I. destruct I as (ring & I & J). apply (H ring I), J.
Qed.
Lemma share_right E : (forall e, In e E -> null e = false) ->
  each_pair (fun e f => negb (overlap (from_left e) (from_left f))) E = true <->
  share_points_only (map R2e E).
Proof.
  intros N. unfold share_points_only. rewrite pairs_map. apply each_pair_right. intros e f I J.
  rewrite negb_true_iff, overlap_right by (apply from_left_forward; auto).
  rewrite one_common_lefts. unfold one_common, lies_on, R2e. cbn [fst snd]. split; intros H x y.
  - intros; apply H; auto.
  - intros; apply H; auto.
Qed.
Lemma pairs_one E : share_points_only (map R2e E) ->
  forall l e k f r, E = l ++ e :: k ++ f :: r -> one_common e f.
Proof.
  unfold share_points_only. rewrite pairs_map. intros P l e k f r ->.
  destruct (pairs_at _ _ _ _ P) as [_ H]. specialize (H f (in_elt _ _ _)).
  intros x y A B C D. apply H; auto.
Qed.
Lemma simple_right ring : (3 <= length ring)%nat ->
  (forall e, In e (ring_edges ring) -> null e = false) ->
  share_points_only (map R2e (ring_edges ring)) ->
  each_pair part_ways (ring_edges ring) = true <-> is_simple (real_ring ring).
Proof.
  intros L N S. unfold is_simple. rewrite ring_real, map_length, pairs_map.
  assert (G : each_pair part_ways (ring_edges ring) = true <->
    ForallOrdPairs (fun e f => forall x, beyond_start (R2e e) x -> beyond_start (R2e f) x -> False)
      (ring_edges ring)).
  { pose proof (pairs_one _ S) as One. clear S L. induction (ring_edges ring) as [|e l IH].
    - split; auto. constructor.
    - simpl. rewrite andb_true_iff, forallb_forall, IH.
      + assert (K : forall f, In f l -> part_ways e f = true <->
          forall x, beyond_start (R2e e) x -> beyond_start (R2e f) x -> False).
        { intros f J. apply part_ways_right; try (apply N; simpl; auto).
          destruct (in_split _ _ J) as (k & r & ->). exact (One [] e k f r eq_refl). }
        split.
        * intros [A B]. constructor; auto. apply Forall_forall. intros f J. apply K, A; auto.
        * intros P. inversion P as [|? ? A B]; subst. rewrite Forall_forall in A. split; auto.
          intros f J. apply (K f J), A, J.
      + intros f J. apply N. simpl. auto.
      + intros m f k g r ->. exact (One (e :: m) f k g r eq_refl). }
  rewrite G. split.
  - intros P. split; auto. split; auto. intros e I. apply in_map_iff in I.
    destruct I as (f & <- & I). apply null_real, N, I.
  - tauto.
Qed.
Lemma signs_right ps : forallb (fun p : polygon vertex => less 0 (twice_area (fst p)) &&
    forallb (fun hole => less (twice_area hole) 0) (snd p)) ps = true <->
  forall p, In p ps -> 0 < area (real_ring (fst p)) /\
    forall hole, In hole (snd p) -> area (real_ring hole) < 0.
Proof.
  rewrite forallb_forall. split; intros H p I; specialize (H p I); rewrite andb_true_iff in *;
    rewrite forallb_forall, less_real, area_real, zero_real in *; destruct H as [A B];
    split; auto; intros hole J; specialize (B hole J); rewrite less_real, area_real, zero_real in *;
    auto.
Qed.
(** A polygon alone is asked about once. *)
Lemma alone_or_all (ps : list (polygon vertex)) :
  (forall p, In p ps -> once (map R2e (all_edges (fst p :: snd p)))) ->
  (goes_once (all_edges (rings_of ps)) = true <-> once (map R2e (all_edges (rings_of ps)))) ->
  match ps with [_] => true | _ => goes_once (all_edges (rings_of ps)) end = true <->
  once (map R2e (all_edges (rings_of ps))).
Proof.
  intros H K. destruct ps as [|p [|q r]]; auto. split; auto. intros _.
  unfold rings_of. cbn [flat_map]. rewrite app_nil_r. apply H. simpl. auto.
Qed.
Theorem polygon_sets_are_decided ps :
  decide_polygon_set ps = true <-> is_polygon_set (figure ps).
Proof.
  rewrite <- in_words_right. unfold decide_polygon_set, in_words.
  set (E := all_edges (rings_of ps)). rewrite !andb_true_iff, signs_right, sound_right.
  assert (Long : (forall ring, In ring (rings_of ps) -> is_simple (real_ring ring)) ->
    long_rings (rings_of ps)).
  { intros H ring I. destruct (H ring I) as (L & N & _). rewrite map_length in L. split; auto.
    intros e J. apply null_real, N. rewrite ring_real. apply in_map, J. }
  assert (G : long_rings (rings_of ps) ->
    ((each_pair (fun e f => negb (overlap (from_left e) (from_left f))) E = true <->
      share_points_only (map R2e E)) /\
    (share_points_only (map R2e E) ->
     (forallb (fun ring => each_pair part_ways (ring_edges ring)) (rings_of ps) = true <->
      forall ring, In ring (rings_of ps) -> is_simple (real_ring ring)) /\
     (forallb (fun p => goes_once (all_edges (fst p :: snd p))) ps = true <->
      forall p, In p ps -> once (map R2e (all_edges (fst p :: snd p)))) /\
     (goes_once E = true <-> once (map R2e E))))).
  { intros H. pose proof (long_edges _ H) as N. fold E in N.
    split; [apply share_right, N|]. intros S. split; [|split].
    - assert (K : forall ring, In ring (rings_of ps) ->
        each_pair part_ways (ring_edges ring) = true <-> is_simple (real_ring ring)).
      { intros ring I. destruct (H ring I) as [L M]. apply simple_right; auto.
        destruct (ring_part _ _ I) as (l & k & Q). unfold E in S. rewrite Q, !map_app in S.
        apply pairs_app in S. destruct S as [_ S]. apply pairs_app in S. apply S. }
      rewrite forallb_forall. split; intros A ring I; apply K; auto.
    - assert (K : forall p, In p ps -> goes_once (all_edges (fst p :: snd p)) = true <->
        once (map R2e (all_edges (fst p :: snd p)))).
      { intros p I. destruct (polygon_part ps p I) as (l & k & Q). apply goes_once_is_right.
        - apply edges_closed_real.
        - intros e J. apply N. unfold E. rewrite Q. apply in_or_app. right. apply in_or_app. auto.
        - unfold E in S. rewrite Q, !map_app in S.
          apply pairs_app in S. destruct S as [_ S]. apply pairs_app in S. apply S. }
      rewrite forallb_forall. split; intros A p I; apply K; auto.
    - apply goes_once_is_right; auto. apply edges_closed_real. }
  split.
  - intros (((((A & B) & C) & D) & F) & O). destruct (G A) as (K & M). apply K in B.
    destruct (M B) as (M1 & M2 & M3). apply (proj1 (alone_or_all ps (proj1 M2 F) M3)) in O.
    exact (conj (conj (proj1 M1 C) B) (conj D (conj (proj1 M2 F) O))).
  - intros ((A & B) & D & F & O). pose proof (Long A) as L. destruct (G L) as (K & M).
    destruct (M B) as (M1 & M2 & M3). apply (proj2 K) in B.
    apply (proj2 (alone_or_all ps F M3)) in O.
    exact (conj (conj (conj (conj (conj L B) (proj2 M1 A)) D) (proj2 M2 F)) O).
Qed.

Theorem legality_is_decided : forall ps : list (polygon vertex),
  decide_legal ps = true <-> is_legal (figure ps).
Proof.
  intros ps. assert (Short : forall o : list vertex, (length o < 3)%nat ->
    ~ is_polygon_set (figure [(o, [])])).
  { intros o L (H & _). destruct (H (real_ring o) []) as ((K & _) & _).
    - simpl. auto.
    - rewrite map_length in K. lia. }
  assert (Else : ~ is_point (figure ps) -> ~ is_segment (figure ps) ->
    decide_polygon_set ps = true <-> is_legal (figure ps)).
  { intros P S. rewrite polygon_sets_are_decided. unfold is_legal. tauto. }
  unfold decide_legal.
  destruct ps as [|[[|a [|b [|c o]]] [|h hs]] [|q qs]]; try (apply Else;
    [intros (x & Q); discriminate Q|intros (x & y & _ & Q); discriminate Q]); clear Else.
  - split; auto. intros _. left. exists (point_of a). reflexivity.
  - rewrite negb_true_iff, <- not_true_iff_false, same_real. split.
    + intros N. right. left. exists (point_of a), (point_of b). split; auto.
    + intros [(x & Q)|[(x & y & N & Q)|S]]; [discriminate Q| |].
      * injection Q; intros -> ->. exact N.
      * destruct (Short [a; b] ltac:(simpl; lia) S).
Qed.

(** So a point is decided for operands that the program itself finds legal: nothing is assumed. *)
Corollary membership_of_legal_operands : forall (s : Q) (P Q : list (polygon vertex)) (x : vertex),
  less 0 s && decide_legal P && decide_legal Q = true ->
  decide_membership s (rings_of P) (rings_of Q) x = true <->
  in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) (point_of x).
Proof.
  intros s P Q x H. rewrite !andb_true_iff, !legality_is_decided, less_real, zero_real in H.
  apply membership_is_decided; tauto.
Qed.
