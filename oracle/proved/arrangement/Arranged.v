(** What the program takes for granted, and that the cells that it takes for full are the set; that
    it holds of a sum *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique.
From Proved Require Import Points Legal Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks
  Kept Frontier Stacks Slabbed Cells Extent Reduced Coloured Holed.
Open Scope R_scope.

(** A set and segments in good order, and a program that tells its points *)
Definition is_arranged (is_in : vertex -> bool) (all : list edge) (S : point -> Prop) : Prop :=
  is_regular S /\ (exists low high, forall x, S x -> low <= snd x <= high) /\
  (forall e, In e all -> forward e) /\ (forall x, ~ over_some all x -> steady S x) /\
  decides is_in all S.
Lemma arranged_same is_in all (S T : point -> Prop) : (forall x, S x <-> T x) ->
  is_arranged is_in all S -> is_arranged is_in all T.
Proof.
  intros H ((C & Rg) & (l & h & Bd) & Fw & St & D). split; [|split; [|split; [|split]]].
  - split.
    + intros x Lim. apply H, C. intros e He. destruct (Lim e He) as (y & Y & K).
      exists y. split; [exact Y|apply H, K].
    + intros x r K Hr. destruct (Rg x r (proj2 (H x) K) Hr) as (y & Y & I). exists y.
      split; [exact Y|apply (interior_same S T y H I)].
  - exists l, h. intros x K. apply Bd, H, K.
  - exact Fw.
  - intros x N. destruct (St x N) as (r & Hr & K). exists r. split; auto. intros y Y.
    rewrite <- !H. apply K, Y.
  - intros v N. rewrite (D v N). apply H.
Qed.

Section Arranged.
Variable is_in : vertex -> bool.
Variable all : list edge.
Variable S : point -> Prop.
Hypothesis arranged : is_arranged is_in all S.
Let B := boundary is_in all.

(** The frontier of the set is on the pieces that are kept, all along each of which the set is on
    the left alone. *)
Theorem kept_pieces_bound :
  (forall x, ~ over_some B x -> steady S x) /\
  (forall e x, In e B -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
    (0 < orient (start e) (finish e) y -> S y) /\
    (orient (start e) (finish e) y < 0 -> ~ S y)) /\
  (forall e, In e B -> start e <> finish e) /\
  (forall e f x, In e B -> In f B -> inside e x -> inside f x ->
    forall y, lies_on e y -> lies_on f y).
Proof.
  destruct arranged as (R & _ & Fw & Steady & D).
  split; [|split; [|split]].
  - intros x N. apply (steady_off_kept _ R _ _ Fw D Steady x N).
  - intros e x I X. apply (kept_sided _ _ _ Fw D Steady e x I X).
  - intros e I. destruct (kept_from _ _ _ Fw D e I) as (p & Ip & H).
    pose proof (before_different _ _ (piece_forward _ Fw p Ip)) as L.
    destruct H as [(-> & _)|(-> & _)]; auto.
  - intros e f x I J X Y y Oy.
    destruct (kept_from _ _ _ Fw D e I) as (p & Ip & H).
    destruct (kept_from _ _ _ Fw D f J) as (q & Iq & K).
    assert (Turn : forall g h z, (g = h /\ True) \/ (g = (snd h, fst h) /\ True) ->
      (inside g z <-> inside h z) /\ (lies_on g z <-> lies_on h z)).
    { intros g h z [[-> _]|[-> _]]; [tauto|]. unfold inside, lies_on, start, finish; cbn [fst snd].
      split; [|split; apply segment_swap].
      split; intros (w & W & Ew); exists (1 - w); (split; [lra|]); rewrite Ew; f_equal; ring. }
    assert (Gp : (e = p /\ True) \/ (e = (snd p, fst p) /\ True)) by tauto.
    assert (Gq : (f = q /\ True) \/ (f = (snd q, fst q) /\ True)) by tauto.
    apply (Turn f q y Gq). apply (pieces_same _ Fw p q x Ip Iq).
    + apply (Turn e p x Gp), X.
    + apply (Turn f q x Gq), Y.
    + apply (Turn e p y Gp), Oy.
Qed.
Theorem full_cells_are_the_set x :
  (exists c, In c (concat (slabs B)) /\ full c = true /\ in_cell c x) <-> S x.
Proof.
  destruct arranged as (R & (low & high & H) & _).
  destruct kept_pieces_bound as (St & Sd & Lg & Al).
  apply (full_cells S R _ St Lg Al Sd low high); intros y Y; apply H, Y.
Qed.
Theorem parts_of_the_set :
  has_components S (length (parts B true)) /\ has_holes S (pred (length (parts B false))).
Proof.
  destruct arranged as (R & (low & high & H) & _).
  destruct kept_pieces_bound as (St & Sd & Lg & Al). split.
  - apply (has_parts _ R _ St Lg Al Sd low high); intros y Y; apply H, Y.
  - apply (has_holes_of_parts _ R _ St Lg Al Sd low high); intros y Y; apply H, Y.
Qed.
End Arranged.

(** ** The program, for legal operands at a scale. Two thin ones have no sum with an area. *)
Definition is_thin (ps : list (polygon point)) : Prop := is_point ps \/ is_segment ps.

Section Legal.
Variable s : Q.
Variables P Q : list (polygon vertex).
Hypothesis positive : 0 < Q2R s.
Hypothesis P_legal : is_legal (figure P).
Hypothesis Q_legal : is_legal (figure Q).
Hypothesis not_thin : ~ (is_thin (figure P) /\ is_thin (figure Q)).
Let E := all_edges (map (map (by_scale s)) (rings_of P)).
Let F := all_edges (rings_of Q).
Let S (p : point) := set_of (points (rings_of P)) (scale (/ Q2R s) p).
Let T := set_of (points (rings_of Q)).
Lemma fat : is_polygon_set (figure P) \/ is_polygon_set (figure Q).
Proof. unfold is_thin, is_legal in *. tauto. Qed.
Lemma P_drawn_here : drawn (map R2e E) S.
Proof.
  pose proof (legal_is_drawn _ P_legal) as D. rewrite <- rings_of_figure in D.
  apply (drawn_scaled _ _ _ positive) in D. rewrite <- scaled_edges_real in D. exact D.
Qed.
Lemma Q_drawn_here : drawn (map R2e F) T.
Proof.
  pose proof (legal_is_drawn _ Q_legal) as D. rewrite <- rings_of_figure, <- edges_of_points in D.
  exact D.
Qed.
Lemma area_here : has_area (map R2e E) S \/ has_area (map R2e F) T.
Proof.
  unfold E, F, S, T. rewrite scaled_edges_real, edges_of_points, !rings_of_figure.
  destruct fat as [A|A]; [left|right; exact (polygon_set_area _ A)].
  intros p. rewrite <- (Scaling.scale_forth (Q2R s) p positive) at 2.
  rewrite Scaling.region_scale_iff by exact positive. apply polygon_set_area, A.
Qed.
Lemma kinds_here : (is_slim E = false -> bordered (map R2e E) S) /\
  (is_slim F = false -> bordered (map R2e F) T).
Proof.
  assert (LE : length E = length (all_edges (rings_of (figure P)))).
  { rewrite <- (map_length R2e E). unfold E.
    rewrite scaled_edges_real, map_length, rings_of_figure. reflexivity. }
  assert (LF : length F = length (all_edges (rings_of (figure Q)))).
  { rewrite <- (map_length R2e F). unfold F. rewrite edges_of_points, rings_of_figure.
    reflexivity. }
  split; intros H.
  - pose proof (slim_unless_polygons _ E P_legal LE H) as L. unfold E, S.
    rewrite scaled_edges_real, !rings_of_figure. apply bordered_scaled; auto.
    apply polygon_set_bordered, L.
  - pose proof (slim_unless_polygons _ F Q_legal LF H) as L. unfold F, T.
    rewrite edges_of_points, !rings_of_figure. apply polygon_set_bordered, L.
Qed.
Definition sum_here := in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)).
Theorem sum_is_arranged : is_arranged (decide_point E F) (convolution E F) sum_here.
Proof.
  apply (arranged_same _ _ (sum_set S T)).
  { intros x. unfold sum_here, in_sum, S, T. split.
    - intros (p & q & Hp & Hq & X). exists (scale (/ Q2R s) p), q.
      rewrite Scaling.scale_forth by auto. auto.
    - intros (p & q & Hp & Hq & X). exists (scale (Q2R s) p), q.
      rewrite Scaling.scale_back by auto. auto. }
  pose proof P_drawn_here as DP. pose proof Q_drawn_here as DQ.
  split; [|split; [|split; [|split]]].
  - apply (sum_regular _ _ S T DP DQ area_here).
  - destruct (drawn_bounded _ S DP) as (l1 & h1 & H1).
    destruct (drawn_bounded _ T DQ) as (l2 & h2 & H2).
    exists (l1 + l2), (h1 + h2). intros y (p & q & Hp & Hq & ->). unfold add; cbn [snd].
    specialize (H1 p Hp). specialize (H2 q Hq). lra.
  - apply convolution_forward.
  - exact (sum_steady E F S T DP DQ area_here kinds_here).
  - intros v _. rewrite (sum_is_union_here E F S T DP DQ).
    apply decide_point_is_right; [apply DP|apply DQ].
Qed.
End Legal.

Theorem cells_are_the_sum : forall (s : Q) (P Q : list (polygon vertex)) (x : point),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  (exists c, In c (sum_cells s (rings_of P) (rings_of Q)) /\ full c = true /\ in_cell c x) <->
  in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) x.
Proof.
  intros s P Q x L LP LQ N.
  exact (full_cells_are_the_set _ _ _ (sum_is_arranged s P Q L LP LQ N) x).
Qed.
Theorem parts_are_counted : forall (s : Q) (P Q : list (polygon vertex)),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  let sum := in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) in
  let counted := count_parts s (rings_of P) (rings_of Q) in
  has_components sum (fst counted) /\ has_holes sum (snd counted).
Proof.
  intros s P Q L LP LQ N. exact (parts_of_the_set _ _ _ (sum_is_arranged s P Q L LP LQ N)).
Qed.
