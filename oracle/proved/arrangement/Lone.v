(** Pieces of segments that are cut at each other: they cover what the segments did, a segment that
    meets a piece inside holds all of it, and two that meet inside are the same. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Local Across Overlaps Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Sorting Along Cuts.
Open Scope R_scope.

Definition inside (e : edge) (x : point) : Prop := inner (start e) (finish e) x.
Lemma inside_on e x : inside e x -> lies_on e x.
Proof. apply inner_on_segment. Qed.

Section All.
Variable all : list edge.
Hypothesis all_forward : forall e, In e all -> forward e.

Definition cut_points (e : edge) : list vertex :=
  vertices_once (fst e :: snd e :: flat_map (meet e) all).
Lemma cut_point_from e v : In v (cut_points e) -> v = fst e \/ v = snd e \/
  exists f, In f all /\ In v (meet e f).
Proof.
  intros I. apply (in_turn_from _ _) in I. destruct I as [<-|[<-|I]]; auto.
  apply in_flat_map in I. auto.
Qed.
Lemma cut_point_has e v : In v (fst e :: snd e :: flat_map (meet e) all) ->
  exists w, In w (cut_points e) /\ R2 w = R2 v.
Proof.
  intros I. destruct (in_turn_has not_after same (fun v w => R2 v = R2 w)
    (fst e :: snd e :: flat_map (meet e) all) v) as (w & W & E); auto.
  - intros x y z -> ->. reflexivity.
  - intros x y H. apply same_real, H.
  - exists w. auto.
Qed.
Lemma cut_point_on e v : In e all -> In v (cut_points e) -> lies_on e (R2 v).
Proof.
  intros Ie I. apply cut_point_from in I. destruct I as [->|[->|(f & F & I)]].
  - apply on_segment_start.
  - apply on_segment_end.
  - apply meet_from in I; auto. tauto.
Qed.

(** A piece in its segment: no cut between its ends *)
Lemma cut_at e p : In e all -> In p (cut all e) -> exists s t, 0 <= s < t /\ t <= 1 /\
  start p = at_ (start e) (finish e) s /\ finish p = at_ (start e) (finish e) t /\
  forall v w, In v (cut_points e) -> R2 v = at_ (start e) (finish e) w -> w <= s \/ t <= w.
Proof.
  intros Ie I. pose proof (all_forward e Ie) as B. destruct p as [p q].
  pose proof (adjacent_in _ _ _ I) as [P Q].
  apply (neighbours _ _ not_after_total not_after_transitive not_after_same) in I.
  destruct I as [L K].
  destruct (on_at e _ (cut_point_on e p Ie P)) as (s & S & Es).
  destruct (on_at e _ (cut_point_on e q Ie Q)) as (t & T & Et).
  assert (Or : forall v w x y, R2 v = at_ (start e) (finish e) x ->
    R2 w = at_ (start e) (finish e) y -> not_after v w = true <-> x <= y).
  { intros v w x y V W. rewrite not_after_real, V, W, before_at by exact B. lra. }
  apply not_true_iff_false in L. rewrite (Or q p t s Et Es) in L.
  exists s, t. split; [lra|split; [lra|split; [exact Es|split; [exact Et|]]]].
  intros v w V W. destruct (K v V) as [H|H]; [left|right].
  - apply (Or v p w s W Es), H.
  - apply (Or q v t w Et W), H.
Qed.
Lemma cut_forward e p : In e all -> In p (cut all e) -> forward p.
Proof.
  intros Ie I. destruct (cut_at e p Ie I) as (s & t & S & T & P & Q & _).
  unfold forward. fold (start p) (finish p). rewrite P, Q. apply before_at; [|lra].
  apply all_forward, Ie.
Qed.
Lemma cut_within e p x : In e all -> In p (cut all e) -> lies_on p x -> lies_on e x.
Proof.
  intros Ie I O. destruct (cut_at e p Ie I) as (s & t & S & T & P & Q & _).
  unfold lies_on in O. fold (start p) (finish p) in O. rewrite P, Q in O.
  apply part_range in O; [|lra]. destruct O as (w & W & ->). apply at_on. lra.
Qed.
Lemma cut_cover e x : In e all -> lies_on e x -> exists p, In p (cut all e) /\ lies_on p x.
Proof.
  intros Ie O. pose proof (all_forward e Ie) as B. pose proof (before_different _ _ B) as N.
  fold (start e) (finish e) in B, N.
  destruct (on_at e x O) as (u & U & X).
  destruct (cut_point_has e (fst e)) as (a & A & Ea); [simpl; auto|].
  destruct (cut_point_has e (snd e)) as (b & Bb & Eb); [simpl; auto|].
  (* the points beyond x; if it is the end, those not before it *)
  set (V := fun v => if Req_EM_T u 1 then ~ before (R2 v) x else before x (R2 v)).
  assert (Va : R2 a = at_ (start e) (finish e) 0) by (rewrite at_0; exact Ea).
  assert (Vb : R2 b = at_ (start e) (finish e) 1) by (rewrite at_1; exact Eb).
  destruct (begins_between not_after same not_after_total not_after_transitive not_after_same
    V (fst e :: snd e :: flat_map (meet e) all) a b) as (p & q & I & Np & Vq); auto.
  - intros v w L H. rewrite not_after_real in L. revert L H. unfold V.
    destruct x, (R2 v), (R2 w). destruct (Req_EM_T u 1); unfold before; simpl; lra.
  - unfold V. rewrite X, Va. destruct (Req_EM_T u 1); rewrite before_at by exact B; lra.
  - unfold V. rewrite X, Vb. destruct (Req_EM_T u 1); rewrite before_at by exact B; lra.
  - exists (p, q). split; [exact I|].
    destruct (cut_at e (p, q) Ie I) as (s & t & S & T & P & Q & _).
    unfold V in Np, Vq. unfold start at 1 in P. unfold finish at 1 in Q. cbn [fst snd] in P, Q.
    unfold lies_on. cbn [fst snd]. rewrite P, Q, X in *. apply part_on.
    destruct (Req_EM_T u 1); rewrite before_at in Np by exact B; rewrite before_at in Vq by exact B;
      lra.
Qed.

(** Whoever meets a piece inside holds all of it. *)
Lemma cut_lone e p f x : In e all -> In p (cut all e) -> In f all -> inside p x -> lies_on f x ->
  forall y, lies_on p y -> lies_on f y.
Proof.
  intros Ie I If Ix Fx y Py. pose proof (all_forward e Ie) as B.
  pose proof (before_different _ _ B) as N. fold (start e) (finish e) in B, N.
  pose proof (cut_within e p x Ie I (inside_on p x Ix)) as Ex.
  destruct (cut_at e p Ie I) as (s & t & S & T & P & Q & K).
  unfold inside in Ix. unfold lies_on in Py. fold (start p) (finish p) in Py.
  rewrite P, Q in Ix, Py. apply part_inner in Ix; [|lra]. apply part_range in Py; [|lra].
  destruct Ix as (w & W & X), Py as (v & V & ->).
  assert (In_all : forall z, In z (meet e f) -> In z (fst e :: snd e :: flat_map (meet e) all)).
  { intros z Z. right. right. apply in_flat_map. exists f. auto. }
  assert (Pe := all_forward f If).
  destruct (Req_dec (slant e f) 0) as [Z|Z].
  2: { destruct (meet_has e f B Pe x Ex Fx Z) as (z & Iz & Ez).
    destruct (cut_point_has e z (In_all z Iz)) as (z' & Iz' & Ez').
    destruct (K z' w Iz'); [congruence|lra|lra]. }
  (* on one line: no end of f is inside the piece *)
  pose proof (one_line e f x Ex Fx Z) as Line.
  assert (End : forall z, z = fst f \/ z = snd f -> exists u, R2 z = at_ (start e) (finish e) u /\
    (u <= s \/ t <= u)).
  { intros z Hz. destruct (on_line (start e) (finish e) (R2 z) N) as (u & U).
    { apply Line. destruct Hz as [->| ->]; [apply on_segment_start|apply on_segment_end]. }
    exists u. split; auto. destruct (Rle_dec u s); auto. destruct (Rle_dec t u); auto.
    destruct (cut_point_has e z) as (z' & Iz' & Ez').
    - apply In_all, meet_ends; auto. unfold lies_on. fold (start e) (finish e). rewrite U.
      apply at_on. lra.
    - apply (K z' u Iz'). congruence. }
  destruct (End (fst f) (or_introl eq_refl)) as (c & Ec & Hc).
  destruct (End (snd f) (or_intror eq_refl)) as (d & Ed & Hd).
  unfold lies_on in *. rewrite Ec, Ed in *.
  apply Segments.at_between. destruct Fx as (k & Kk & Fx).
  change (x = at_ (at_ (start e) (finish e) c) (at_ (start e) (finish e) d) k) in Fx.
  rewrite at_at, X in Fx. apply at_same in Fx; auto.
  unfold Rmin, Rmax. destruct (Rle_dec c d), Hc, Hd; nra.
Qed.

(** ** All pieces *)
Lemma piece_from p : In p (pieces all) -> exists e, In e all /\ In p (cut all e).
Proof.
  intros I. unfold pieces in I. apply unique_from in I.
  apply (Permutation.Permutation_in _ (sort_members _ _)) in I.
  apply in_flat_map in I. exact I.
Qed.
Lemma piece_forward p : In p (pieces all) -> forward p.
Proof. intros I. destruct (piece_from p I) as (e & Ie & J). exact (cut_forward e p Ie J). Qed.
Lemma piece_cover e x : In e all -> lies_on e x -> exists p, In p (pieces all) /\ lies_on p x.
Proof.
  intros Ie O. destruct (cut_cover e x Ie O) as (p & I & Op).
  destruct (in_turn_has edge_le same_edge
    (fun p q => start p = start q /\ finish p = finish q) (flat_map (cut all) all) p)
    as (q & Q & E1 & E2).
  - auto.
  - intros u v w [-> ->] [-> ->]. auto.
  - intros u v H. unfold same_edge in H. apply andb_true_iff in H. rewrite !same_real in H. exact H.
  - apply in_flat_map. exists e. auto.
  - exists q. split; [exact Q|]. unfold lies_on in *. fold (start q) (finish q).
    rewrite <- E1, <- E2. exact Op.
Qed.
Lemma piece_lone p f x : In p (pieces all) -> In f all -> inside p x -> lies_on f x ->
  forall y, lies_on p y -> lies_on f y.
Proof. intros I. destruct (piece_from p I) as (e & Ie & J). exact (cut_lone e p f x Ie J). Qed.
Lemma piece_within p : In p (pieces all) -> exists e, In e all /\
  forall x, lies_on p x -> lies_on e x.
Proof.
  intros I. destruct (piece_from p I) as (e & Ie & J). exists e. split; auto.
  intros x. apply cut_within; auto.
Qed.

(** No segment, and no piece, ends inside a piece. *)
Lemma no_end_inside p f : In p (pieces all) -> In f all ->
  ~ inside p (start f) /\ ~ inside p (finish f).
Proof.
  intros I If. pose proof (before_different _ _ (piece_forward p I)) as N.
  fold (start p) (finish p) in N. pose proof (before_different _ _ (all_forward f If)) as M.
  fold (start f) (finish f) in M.
  assert (G : forall x, inside p x -> lies_on f x -> x <> start f /\ x <> finish f).
  { intros x X Fx. pose proof (piece_lone p f x I If X Fx) as H.
    destruct (on_at f _ (H _ (on_segment_start _ _))) as (u & U & Eu).
    destruct (on_at f _ (H _ (on_segment_end _ _))) as (v & V & Ev).
    fold (start p) in Eu. fold (finish p) in Ev.
    assert (u <> v) by (intros ->; apply N; congruence).
    destruct X as (w & W & X). change (x = at_ (start p) (finish p) w) in X.
    rewrite Eu, Ev, at_at in X.
    split; intros Y; rewrite Y in X.
    - rewrite <- (at_0 (start f) (finish f)) in X at 1. apply at_same in X; auto. nra.
    - rewrite <- (at_1 (start f) (finish f)) in X at 1. apply at_same in X; auto. nra. }
  split; intros X.
  - destruct (G _ X (on_segment_start _ _)). congruence.
  - destruct (G _ X (on_segment_end _ _)). congruence.
Qed.
Lemma no_cut_inside p q : In p (pieces all) -> In q (pieces all) ->
  ~ inside p (start q) /\ ~ inside p (finish q).
Proof.
  intros I J. pose proof (before_different _ _ (piece_forward p I)) as N.
  fold (start p) (finish p) in N. destruct (piece_from q J) as (f & If & K).
  assert (G : forall v, In v (cut_points f) -> ~ inside p (R2 v)).
  { intros v V X. pose proof (cut_point_on f v If V) as Fv.
    apply cut_point_from in V. destruct V as [->|[->|(g & Ig & V)]].
    - exact (proj1 (no_end_inside p f I If) X).
    - exact (proj2 (no_end_inside p f I If) X).
    - apply meet_from in V; auto. destruct V as (_ & Gv & [Z|[Y|Y]]).
      + apply Z. apply (two_shared f g (start p) (finish p)); auto.
        * apply (piece_lone p f _ I If X Fv), on_segment_start.
        * apply (piece_lone p g _ I Ig X Gv), on_segment_start.
        * apply (piece_lone p f _ I If X Fv), on_segment_end.
        * apply (piece_lone p g _ I Ig X Gv), on_segment_end.
      + rewrite Y in X. exact (proj1 (no_end_inside p g I Ig) X).
      + rewrite Y in X. exact (proj2 (no_end_inside p g I Ig) X). }
  destruct q as [a b]. apply adjacent_in in K. split; apply G; tauto.
Qed.
Lemma pieces_same p q x : In p (pieces all) -> In q (pieces all) -> inside p x -> inside q x ->
  forall y, lies_on p y -> lies_on q y.
Proof.
  intros I J P Q y Py. destruct (piece_from q J) as (f & If & K).
  pose proof (all_forward f If) as B. pose proof (before_different _ _ B) as N.
  fold (start f) (finish f) in N.
  pose proof (cut_within f q x If K (inside_on q x Q)) as Fx.
  pose proof (piece_lone p f x I If P Fx) as H.
  destruct (cut_at f q If K) as (s & t & S & T & Eq & Fq & _).
  destruct (on_at f _ (H _ (on_segment_start _ _))) as (u & U & Eu).
  destruct (on_at f _ (H _ (on_segment_end _ _))) as (v & V & Ev).
  fold (start p) in Eu. fold (finish p) in Ev.
  assert (D : u < v).
  { pose proof (piece_forward p I) as Fp. unfold forward in Fp. fold (start p) (finish p) in Fp.
    rewrite Eu, Ev in Fp. apply before_at in Fp; auto. }
  destruct (no_cut_inside p q I J) as [C1 C2]. unfold inside in *.
  unfold lies_on in *. fold (start p) (finish p) in Py. fold (start q) (finish q).
  rewrite Eu, Ev, Eq, Fq in *.
  apply part_inner in P; [|lra]. apply part_inner in Q; [|lra]. apply part_range in Py; [|lra].
  destruct P as (w & W & Ew), Q as (w' & W' & Ew'), Py as (z & Z & ->).
  rewrite Ew in Ew'. apply at_same in Ew'; auto. subst w'.
  apply part_on. split.
  - apply Rnot_lt_le. intros L. apply C1, inner_part. lra.
  - apply Rnot_lt_le. intros L. apply C2, inner_part. lra.
Qed.
End All.
