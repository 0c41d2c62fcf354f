(** Beside a piece: all along it, on one side, is what is at the point that the program tests. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Local Across Overlaps Components Paths Decomposed Gaps
  Unique Beside.
From Proved Require Import Points Segments Member Decided Pieces Sorting Along Cuts Lone.
Open Scope R_scope.

Lemma near_all {A} (l : list A) (H : A -> point -> Prop) x :
  (forall i, In i l -> exists r, 0 < r /\ forall y, near r x y -> H i y) ->
  exists r, 0 < r /\ forall y, near r x y -> forall i, In i l -> H i y.
Proof.
  induction l as [|i l IH]; intros K; [exists 1; split; [lra|]; intros y _ i []|].
  destruct IH as (r & Hr & R); [intros j J; apply K; simpl; auto|].
  destruct (K i (or_introl eq_refl)) as (s & Hs & S). exists (Rmin r s).
  split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y. destruct Y as [Y1 Y2].
  intros j [<-|J]; auto.
Qed.
Lemma all_between (P : R -> Prop) s t : P s ->
  (forall u, s <= u <= t \/ t <= u <= s -> exists e, 0 < e /\
    forall v, Rabs (v - u) < e -> (P v <-> P u)) -> P t.
Proof.
  intros Ps L. apply (all_along (fun p => P (fst p)) (s, 0) (t, 0) Ps).
  intros p (k & K & ->). cbn [fst snd].
  destruct (L (s + k * (t - s))) as (e & He & M).
  { destruct (Rle_dec s t); [left|right]; nra. }
  exists e. split; auto. intros q [Q _]. apply M, Q.
Qed.

(** The segments of a list pass over a point. *)
Definition over_some (K : list edge) (x : point) : Prop := exists f, In f K /\ lies_on f x.
Lemma over_near K x : ~ over_some K x -> exists r, 0 < r /\ forall y, near r x y -> ~ over_some K y.
Proof.
  intros N. destruct (near_all K (fun f y => ~ lies_on f y) x) as (r & Hr & R).
  - intros f I. apply segment_near. intros O. apply N. exists f. auto.
  - exists r. split; auto. intros y Y (f & I & O). exact (R y Y f I O).
Qed.

Section Flank.
Variable K : list edge.
Variable T : point -> Prop.
Hypothesis constant : forall x, ~ over_some K x ->
  exists r, 0 < r /\ forall y, near r x y -> (T y <-> T x).
Variables a b : point.
Hypothesis long : a <> b.
Hypothesis lone : forall f x, In f K -> inner a b x -> lies_on f x -> forall y, lies_on f y ->
  orient a b y = 0.

Lemma clear x : inner a b x -> exists r, 0 < r /\ forall y, near r x y ->
  orient a b y <> 0 -> ~ over_some K y.
Proof.
  intros X. destruct (near_all K (fun f y => lies_on f y -> orient a b y = 0) x) as (r & Hr & R).
  - intros f I. destruct (classic (lies_on f x)) as [O|O].
    + exists 1. split; [lra|]. intros y _. apply (lone f x I X O).
    + destruct (segment_near _ _ _ O) as (r & Hr & N). exists r. split; auto.
      intros y Y Fy. destruct (N y Y Fy).
  - exists r. split; auto. intros y Y N (f & I & O). apply N, (R y Y f I O).
Qed.
Lemma near_between r x y z p : near r x y -> near r x z -> on_segment y z p -> near r x p.
Proof.
  intros [A B] [C D] (t & H & ->). apply Rabs_def2 in A, B, C, D.
  assert (M : forall u v, - r < u < r -> - r < v < r -> - r < u + t * (v - u) < r).
  { intros u v U V. pose proof (mean_positive (u + r) (v + r) t).
    pose proof (mean_positive (r - u) (r - v) t). lra. }
  split; apply Rabs_def1; cbn [fst snd].
  - pose proof (M (fst y - fst x) (fst z - fst x)). lra.
  - pose proof (M (fst y - fst x) (fst z - fst x)). lra.
  - pose proof (M (snd y - snd x) (snd z - snd x)). lra.
  - pose proof (M (snd y - snd x) (snd z - snd x)). lra.
Qed.
Lemma left_between y z p : 0 < orient a b y -> 0 < orient a b z -> on_segment y z p ->
  0 < orient a b p.
Proof. intros Y Z (t & H & ->). rewrite orient_on_segment. nra. Qed.
Lemma left_alike x : inner a b x -> exists r, 0 < r /\ forall y z, near r x y -> near r x z ->
  0 < orient a b y -> 0 < orient a b z -> T y -> T z.
Proof.
  intros X. destruct (clear x X) as (r & Hr & R). exists r. split; auto.
  intros y z Y Z Ly Lz Ty. apply (all_along T y z Ty). intros p P. apply constant, R.
  - exact (near_between r x y z p Y Z P).
  - pose proof (left_between y z p Ly Lz P). lra.
Qed.

(** All along the piece, on the left, is what is at a point l that the piece's point m sees. *)
Variables m l : point.
Hypothesis m_inside : inner a b m.
Hypothesis l_left : 0 < orient a b l.
Hypothesis way : forall p, on_segment m l p -> p <> m -> ~ over_some K p.
Theorem side_all x : T l -> inner a b x -> exists r, 0 < r /\ forall y, near r x y ->
  0 < orient a b y -> T y.
Proof.
  intros Tl X. pose proof (inner_on_line _ _ _ m_inside) as Zm.
  assert (Nl : l <> m) by (intros E; rewrite E in l_left; lra).
  set (P := fun u => exists r, 0 < r /\ forall y, near r (at_ a b u) y -> 0 < orient a b y -> T y).
  destruct m_inside as (u & U & Em). change (m = at_ a b u) in Em.
  destruct X as (w & W & Ex). change (x = at_ a b w) in Ex.
  assert (Pu : P u).
  { destruct (left_alike m m_inside) as (r & Hr & R). exists r. split; auto.
    rewrite <- Em. intros y Y Ly. destruct (near_start m l r Hr Nl) as (t & Ht & N).
    assert (Lt : orient a b (at_ m l t) = t * orient a b l).
    { transitivity ((1 - t) * orient a b m + t * orient a b l); [|rewrite Zm; ring].
      unfold orient, at_; cbn [fst snd]. ring. }
    apply (R (at_ m l t) y N Y); auto; [rewrite Lt; nra|].
    apply (all_along T l (at_ m l t) Tl). intros p O. apply constant, way.
    - apply segment_swap in O. destruct O as (k & Hk & ->).
      exists (t + k * (1 - t)). split; [nra|]. unfold at_; cbn [fst snd]. f_equal; ring.
    - intros ->. apply segment_swap in O. destruct O as (k & Hk & E).
      assert (0 < orient a b m); [|lra]. rewrite E, orient_on_segment, Lt.
      assert (0 < t * orient a b l) by nra.
      pose proof (mean_positive (t * orient a b l) (orient a b l) k). lra. }
  rewrite Ex. apply (all_between P u w Pu). intros v V.
  assert (Iv : inner a b (at_ a b v)) by (exists v; split; [lra|reflexivity]).
  destruct (left_alike _ Iv) as (r & Hr & R). destruct (at_near a b v (r / 2)) as (d & Hd & D);
    [lra|]. exists d. split; auto. intros v' V'. specialize (D v' V'). split.
  - intros (s & Hs & Q). exists r. split; auto. intros z Z Lz.
    destruct (left_close a b (at_ a b v') (Rmin s (r / 2)) long) as (y & Y & Ly).
    { apply at_orient. } { apply Rmin_glb_lt; lra. }
    apply near_min in Y. destruct Y as [Y1 Y2].
    apply (R y z); auto. exact (near_near r _ _ _ D Y2).
  - intros (s & Hs & Q). exists (r / 2). split; [lra|]. intros z Z Lz.
    destruct (left_close a b (at_ a b v) (Rmin s r) long) as (y & Y & Ly).
    { apply at_orient. } { apply Rmin_glb_lt; lra. }
    apply near_min in Y. destruct Y as [Y1 Y2].
    apply (R y z); auto. exact (near_near r _ _ _ D Z).
Qed.
End Flank.

(** ** The points beside the middle *)
Lemma least_positive l : 0 < Q2R (least l).
Proof.
  induction l as [|x l IH]; simpl; [rewrite one_real; lra|]. fold (least l).
  destruct (less 0 x) eqn:E; auto. apply less_real in E. rewrite zero_real in E.
  unfold min. destruct (Qle_bool x (least l)); auto.
Qed.
Lemma least_below l v : In v l -> 0 < Q2R v -> Q2R (least l) <= Q2R v.
Proof.
  induction l as [|x l IH]; [intros []|]. intros I V. simpl. fold (least l).
  assert (M : forall x y, Q2R (min x y) <= Q2R x /\ Q2R (min x y) <= Q2R y).
  { intros y z. unfold min. destruct (Qle_bool y z) eqn:E; [apply le_real in E; lra|].
    apply not_true_iff_false in E. rewrite le_real in E. lra. }
  destruct I as [<-|I].
  - destruct (less 0 x) eqn:E; [apply M|]. apply not_true_iff_false in E.
    rewrite less_real, zero_real in E. lra.
  - specialize (IH I V). destruct (less 0 x); auto. destruct (M x (least l)). lra.
Qed.
Definition step_to (m n : point) (t : R) : point := (fst m + t * fst n, snd m + t * snd n).
Lemma at_distance_real m n t : R2 (at_distance m n t) = step_to (R2 m) (R2 n) (Q2R t).
Proof. unfold at_distance. rewrite qadd_real, by_scale_real. reflexivity. Qed.

(** Where a segment is met from m along an axis: there a distance is on the list, unless the segment
    passes over m. *)
Section Axis.
Variables along across : vertex -> Q.
Variables L C : point -> R.
Hypothesis along_real : forall v, Q2R (along v) = L (R2 v).
Hypothesis across_real : forall v, Q2R (across v) = C (R2 v).
Hypothesis L_at : forall a b u, L (at_ a b u) = L a + u * (L b - L a).
Hypothesis C_at : forall a b u, C (at_ a b u) = C a + u * (C b - C a).
Hypothesis both : forall p q, L p = L q -> C p = C q -> p = q.
Lemma met_along_from m f p t : t <> 0 -> lies_on f p -> L p = L (R2 m) + t -> C p = C (R2 m) ->
  lies_on f (R2 m) \/
  exists v, In v (met_along along across m f) /\ (0 < Q2R v <= t \/ t <= Q2R v < 0).
Proof.
  destruct f as [a b]. unfold lies_on, start, finish, met_along; cbn [fst snd].
  intros T (u & U & E) Lp Cp. change (p = at_ (R2 a) (R2 b) u) in E. rewrite E in Lp, Cp. clear E.
  rewrite L_at in Lp. rewrite C_at in Cp.
  destruct (Qeq_bool (across a) (across b)) eqn:Q.
  - apply equal_real in Q. rewrite !across_real in Q. rewrite <- Q in Cp.
    set (v := L (R2 a) - L (R2 m)) in *. set (w := L (R2 b) - L (R2 m)) in *.
    assert (Et : t = v + u * (w - v)) by (unfold v, w; lra).
    destruct (Rle_dec (v * w) 0) as [M|M].
    + left. (* the ends are on both sides of m, or one is m *)
      assert (N : v - w <> 0).
      { intros N. assert (W : w = v) by lra. rewrite W in M, Et. assert (v = 0) by nra. lra. }
      exists (v / (v - w)). assert (G : v / (v - w) * (v - w) = v) by (field; exact N).
      set (k := v / (v - w)) in *. clearbody k. split.
      { assert (H : (w <= 0 <= v /\ 0 < v - w) \/ (v <= 0 <= w /\ v - w < 0)).
        { destruct (Rtotal_order v w) as [H|[H|H]]; [right|exfalso; lra|left];
            (split; [|lra]); split; apply Rnot_lt_le; intros H'; nra. }
        destruct H; split; apply Rnot_lt_le; intros H'; nra. }
      change (R2 m = at_ (R2 a) (R2 b) k). apply both; rewrite ?L_at, ?C_at.
      * unfold v, w in G. lra.
      * rewrite <- Q. lra.
    + right. assert (H : 0 < v /\ 0 < w \/ v < 0 /\ w < 0).
      { destruct (Rtotal_order v 0) as [H|[H|H]]; [right|exfalso|left]; nra. }
      destruct (Rle_dec (v * v) (w * w)).
      * exists (Qred (along a - along m)). split; [simpl; auto|].
        rewrite Q2R_red, Q2R_minus, !along_real. fold v. rewrite Et.
        destruct H; [left|right]; (assert (0 <= w - v \/ w - v <= 0) by lra); nra.
      * exists (Qred (along b - along m)). split; [simpl; auto|].
        rewrite Q2R_red, Q2R_minus, !along_real. fold w.
        assert (Et' : t = w + (1 - u) * (v - w)) by lra. rewrite Et'.
        destruct H; [left|right]; nra.
  - right. eexists. split; [left; reflexivity|].
    assert (N : Q2R (across b) - Q2R (across a) <> 0).
    { intros N. apply not_true_iff_false in Q. apply Q, equal_real. lra. }
    rewrite Q2R_red, Q2R_plus, Q2R_mult, Q2R_div, !Q2R_minus.
    + rewrite !across_real, !along_real in *.
      assert (G : (C (R2 m) - C (R2 a)) * ((L (R2 b) - L (R2 a)) / (C (R2 b) - C (R2 a))) =
        u * (L (R2 b) - L (R2 a))) by (rewrite <- Cp; field; exact N).
      rewrite G. lra.
    + intros Z. apply Qeq_eqR in Z. rewrite Q2R_minus, zero_real in Z. contradiction.
Qed.
End Axis.
Lemma met_from m n f t : R2 n = (0, 1) \/ R2 n = (-1, 0) -> forward f -> t <> 0 ->
  lies_on f (step_to (R2 m) (R2 n) t) -> lies_on f (R2 m) \/
  exists v, In v (met_at m n f) /\ (0 < Q2R v <= t \/ t <= Q2R v < 0).
Proof.
  intros Axis F T O. pose proof (segment_range _ _ _ O) as (_ & X & Y).
  unfold met_at. destruct Axis as [A|A]; rewrite A in O, X, Y; unfold step_to in O, X, Y;
    cbn [fst snd] in O, X, Y; pose proof (f_equal fst A) as A1; cbn [fst] in A1.
  - assert (Q : Qeq_bool (fst n) 0 = true) by (apply equal_real; rewrite zero_real; exact A1).
    rewrite Q. unfold forward, before in F. unfold point_of in X, F; cbn [fst snd] in X, F.
    assert (M : less (fst m) (fst (fst f)) || less (fst (snd f)) (fst m) = false).
    { apply orb_false_iff. rewrite <- !not_true_iff_false, !less_real. lra. }
    rewrite M. apply (met_along_from snd fst snd fst) with (p := (fst (R2 m) + t * 0,
      snd (R2 m) + t * 1)); auto; cbn [fst snd]; try ring.
    intros p q H K. apply point_eq; auto.
  - assert (Q : Qeq_bool (fst n) 0 = false).
    { apply not_true_iff_false. rewrite equal_real, zero_real. change (fst (R2 n) <> 0). lra. }
    rewrite Q.
    assert (M : apart_on_axis (snd m) (snd m) (snd (fst f)) (snd (snd f)) = false).
    { apply disjoint_intervals. unfold over_lap, Rmin, Rmax. unfold point_of in Y.
      cbn [fst snd] in Y.
      destruct (Rle_dec (Q2R (snd m)) (Q2R (snd m))),
        (Rle_dec (Q2R (snd (fst f))) (Q2R (snd (snd f)))); lra. }
    rewrite M.
    destruct (met_along_from fst snd fst snd ltac:(reflexivity) ltac:(reflexivity)
      ltac:(reflexivity) ltac:(reflexivity) point_eq m f
      (fst (R2 m) + t * -1, snd (R2 m) + t * 0) (- t)) as [H|(v & I & H)]; auto;
      cbn [fst snd]; try lra.
    right. exists (- v)%Q. split; [apply in_map, I|]. rewrite Q2R_opp. lra.
Qed.
