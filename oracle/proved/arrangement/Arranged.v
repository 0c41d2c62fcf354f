(** The cells that the program takes for full are the sum. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique.
From Proved Require Import Points Legal Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks
  Kept Frontier Stacks Slabbed Cells Extent Reduced Coloured Holed.
Open Scope R_scope.

Section Sum.
Variables E F : list edge.
Let P := map R2e E.
Let Q := map R2e F.
Variables S T : point -> Prop.
Hypothesis P_drawn : drawn P S.
Hypothesis Q_drawn : drawn Q T.
Hypothesis area : has_area P S \/ has_area Q T.
Hypothesis kinds : (is_slim E = false -> bordered P S) /\ (is_slim F = false -> bordered Q T).

(** The frontier of the sum is on the pieces that are kept,
  all along each of which the sum is on the
    left alone. *)
Theorem kept_pieces_bound : let B := sum_boundary E F in
  (forall x, ~ over_some B x -> steady (sum_set S T) x) /\
  (forall e x, In e B -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
    (0 < orient (start e) (finish e) y -> sum_set S T y) /\
    (orient (start e) (finish e) y < 0 -> ~ sum_set S T y)) /\
  (forall e, In e B -> start e <> finish e) /\
  (forall e f x, In e B -> In f B -> inside e x -> inside f x ->
    forall y, lies_on e y -> lies_on f y).
Proof.
  intros B. pose proof (sum_regular P Q S T P_drawn Q_drawn area) as R.
  assert (D : forall v, decide_point E F v = true <-> sum_set S T (R2 v))
    by (intros v; rewrite (sum_is_union_here E F S T P_drawn Q_drawn);
      apply decide_point_is_right; [apply P_drawn|apply Q_drawn]).
  pose proof (convolution_forward E F) as Fw.
  pose proof (sum_steady E F S T P_drawn Q_drawn area kinds) as Steady.
  split; [|split; [|split]].
  - intros x N. apply (steady_off_kept _ R _ D _ Fw Steady x N).
  - intros e x I X. apply (kept_sided _ _ D _ Fw Steady e x I X).
  - intros e I. destruct (kept_from _ _ D _ e I) as (p & Ip & H).
    pose proof (before_different _ _ (piece_forward _ Fw p Ip)) as L.
    destruct H as [(-> & _)|(-> & _)]; auto.
  - intros e f x I J X Y y Oy.
    destruct (kept_from _ _ D _ e I) as (p & Ip & H). destruct (kept_from _ _ D _ f J) as (q & Iq &
      K).
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
Lemma set_bounded : exists low high, forall x, sum_set S T x -> low <= snd x <= high.
Proof.
  destruct (drawn_bounded P S P_drawn) as (l1 & h1 & H1).
  destruct (drawn_bounded Q T Q_drawn) as (l2 & h2 & H2).
  exists (l1 + l2), (h1 + h2). intros y (p & q & Hp & Hq & ->). unfold add; cbn [snd].
  specialize (H1 p Hp). specialize (H2 q Hq). lra.
Qed.
Theorem cells_of_the_sum x :
  (exists c, In c (concat (slabs (sum_boundary E F))) /\ full c = true /\ in_cell c x) <->
  sum_set S T x.
Proof.
  destruct kept_pieces_bound as (St & Sd & Lg & Al).
  destruct set_bounded as (low & high & H).
  apply (full_cells (sum_set S T) (sum_regular P Q S T P_drawn Q_drawn area) _ St Lg Al Sd low
    high);
    intros y Y; apply H, Y.
Qed.
Theorem parts_of_the_sum : let B := sum_boundary E F in
  has_components (sum_set S T) (length (parts B true)) /\
  has_holes (sum_set S T) (pred (length (parts B false))).
Proof.
  intros B. destruct kept_pieces_bound as (St & Sd & Lg & Al).
  destruct set_bounded as (low & high & H).
  pose proof (sum_regular P Q S T P_drawn Q_drawn area) as R. split.
  - apply (has_parts _ R _ St Lg Al Sd low high); intros y Y; apply H, Y.
  - apply (has_holes_of_parts _ R _ St Lg Al Sd low high); intros y Y; apply H, Y.
Qed.
End Sum.

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
Lemma sum_here x : sum_set S T x <-> in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) x.
Proof.
  unfold in_sum, S, T. split.
  - intros (p & q & Hp & Hq & X). exists (scale (/ Q2R s) p), q.
    rewrite Scaling.scale_forth by auto. auto.
  - intros (p & q & Hp & Hq & X). exists (scale (Q2R s) p), q.
    rewrite Scaling.scale_back by auto. auto.
Qed.
End Legal.

Theorem cells_are_the_sum : forall (s : Q) (P Q : list (polygon vertex)) (x : point),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  (exists c, In c (sum_cells s (rings_of P) (rings_of Q)) /\ full c = true /\ in_cell c x) <->
  in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) x.
Proof.
  intros s P Q x L LP LQ N. rewrite <- (sum_here s P Q L x).
  apply (cells_of_the_sum _ _ _ _ (P_drawn_here s P L LP) (Q_drawn_here Q LQ)
    (area_here s P Q L LP LQ N) (kinds_here s P Q L LP LQ)).
Qed.
Lemma falls_same (S T : point -> Prop) C n : (forall x, S x <-> T x) -> falls_into S C n ->
  falls_into T C n.
Proof. intros H (A & K). split; [|exact K]. intros x. rewrite <- H. apply A. Qed.
Theorem parts_are_counted : forall (s : Q) (P Q : list (polygon vertex)),
  0 < Q2R s -> is_legal (figure P) -> is_legal (figure Q) ->
  ~ (is_thin (figure P) /\ is_thin (figure Q)) ->
  let sum := in_sum (Q2R s) (points (rings_of P)) (points (rings_of Q)) in
  let counted := count_parts s (rings_of P) (rings_of Q) in
  has_components sum (fst counted) /\ has_holes sum (snd counted).
Proof.
  intros s P Q L LP LQ N sum counted.
  destruct (parts_of_the_sum _ _ _ _ (P_drawn_here s P L LP) (Q_drawn_here Q LQ)
    (area_here s P Q L LP LQ N) (kinds_here s P Q L LP LQ)) as ((C & HC) & (D & HD & Bd)).
  pose proof (sum_here s P Q L) as H. split.
  - exists C. refine (falls_same _ _ C _ _ HC). intros x.
    split; apply interior_same; intros y; [apply H|apply iff_sym, H].
  - exists D. split; [|exact Bd]. refine (falls_same _ _ D _ _ HD). intros x.
    rewrite (H x). reflexivity.
Qed.
