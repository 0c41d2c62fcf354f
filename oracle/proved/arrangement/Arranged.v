(** The cells that the program takes for full are the sum. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique Convolution.
From Proved Require Import Points Legal Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks
  Kept Frontier Stacks Slabbed Cells Extent Coloured Holed.
Open Scope R_scope.

(** ** The program's convolution *)
Lemma translate_in E F e f : In e E -> In f F ->
  In (from_left (qadd (fst e) (fst f), qadd (snd e) (fst f))) (translates E F).
Proof.
  intros I J. apply in_flat_map. exists e. split; auto. apply in_map_iff. exists f. auto.
Qed.
Lemma null_either e : null (from_left e) = null e.
Proof.
  unfold from_left. destruct (is_before (fst e) (snd e)); auto. unfold null; cbn [fst snd].
  apply eq_true_iff_eq. rewrite !same_real. split; auto.
Qed.
Lemma convolution_forward E F e : In e (convolution E F) -> forward e.
Proof.
  intros I. apply in_turn_from, filter_In in I. destruct I as [I N].
  rewrite negb_true_iff in N.
  assert (G : exists g, e = from_left g).
  { apply in_app_or in I. destruct I as [I|I]; apply in_flat_map in I; destruct I as (f & _ & I);
      apply in_map_iff in I; destruct I as (g & <- & _); eexists; reflexivity. }
  destruct G as (g & ->). apply from_left_forward. rewrite <- null_either. exact N.
Qed.
Lemma convolution_over E F g x : In (from_left g) (translates E F ++ translates F E) ->
  start g <> finish g -> lies_on g x -> over_some (convolution E F) x.
Proof.
  intros I N O.
  destruct (in_turn_has edge_le same_edge (fun p q => start p = start q /\ finish p = finish q)
    (filter (fun e => negb (null e)) (translates E F ++ translates F E)) (from_left g))
    as (e & Ie & E1 & E2).
  - auto.
  - intros u v w [-> ->] [-> ->]. auto.
  - intros u v H. unfold same_edge in H. apply andb_true_iff in H. rewrite !same_real in H. exact H.
  - apply filter_In. split; auto. rewrite null_either. apply negb_true_iff, not_true_iff_false.
    unfold null. rewrite same_real. exact N.
  - exists e. split; [exact Ie|]. apply from_left_on in O. unfold lies_on in *.
    fold (start e) (finish e). rewrite <- E1, <- E2. exact O.
Qed.
Lemma translated_on a b c x : on_segment (R2 a) (R2 b) (minus_ x (R2 c)) ->
  lies_on (qadd a c, qadd b c) x.
Proof.
  unfold lies_on; cbn [fst snd]. rewrite !qadd_real. generalize (R2 a) (R2 b) (R2 c).
  intros p q r (t & T & E). exists t. split; auto. unfold minus_ in E. injection E; intros E2 E1.
  apply point_eq; unfold add; cbn [fst snd]; lra.
Qed.
Lemma translated_long a b c : R2 a <> R2 b -> start (qadd a c, qadd b c) <>
  finish (qadd a c, qadd b c).
Proof.
  unfold start, finish; cbn [fst snd]. rewrite !qadd_real. intros N E. apply N.
  unfold add in E. injection E; intros. apply point_eq; unfold point_of; cbn [fst snd]; lra.
Qed.

Section Sum.
Variables E F : list edge.
Let P := map R2e E.
Let Q := map R2e F.
Variables S T : point -> Prop.
Hypothesis P_drawn : drawn P S.
Hypothesis Q_drawn : drawn Q T.
Hypothesis area : has_area P S \/ has_area Q T.
Hypothesis edges_long : forall e f, In e P -> In f Q -> fst e <> snd e \/ fst f <> snd f.

Lemma vertex_starts (G : list edge) d : closed (map R2e G) -> In d (map snd (map R2e G)) ->
  exists f, In f G /\ R2 (fst f) = d.
Proof.
  intros C I. apply (Permutation_in _ (Permutation_sym C)) in I. rewrite map_map in I.
  apply in_map_iff in I. destruct I as (f & E1 & I). exists f. auto.
Qed.
Lemma swapped_on a c x : on_segment (R2 a) (R2 a) (minus_ x (R2 c)) -> x = add (R2 a) (R2 c).
Proof.
  intros (t & _ & O). rewrite (add_minus x (R2 c)), O. unfold add; cbn [fst snd]. f_equal; ring.
Qed.
(** Each edge at each vertex: edges of length zero are left out, their places are ends of others. *)
Lemma passed G H e f x : In (from_left (qadd (fst e) (fst f), qadd (snd e) (fst f)))
    (translates G H ++ translates H G) ->
  In (from_left (qadd (fst f) (fst e), qadd (snd f) (fst e))) (translates G H ++ translates H G) ->
  start e <> finish e \/ start f <> finish f ->
  on_segment (start e) (finish e) (minus_ x (start f)) -> over_some (convolution G H) x.
Proof.
  intros I J L O. destruct (classic (start e = finish e)) as [N|N].
  - destruct L as [L|L]; [contradiction|].
    apply (convolution_over G H (qadd (fst f) (fst e), qadd (snd f) (fst e)) x J).
    + apply translated_long. exact L.
    + unfold lies_on; cbn [fst snd]. rewrite !qadd_real. rewrite <- N in O.
      apply swapped_on in O. replace x with (add (R2 (fst f)) (R2 (fst e))).
      * apply on_segment_start.
      * rewrite O. unfold add; f_equal; ring.
  - apply (convolution_over G H (qadd (fst e) (fst f), qadd (snd e) (fst f)) x I).
    + apply translated_long. exact N.
    + apply translated_on, O.
Qed.
Lemma off_program x : ~ over_some (convolution E F) x -> off_convolution P Q x.
Proof.
  intros N a b c d I J. unfold P, Q in *.
  pose proof (in_map snd _ _ I) as Ib. pose proof (in_map snd _ _ J) as Jd. cbn [snd] in Ib, Jd.
  apply in_map_iff in I. destruct I as (e & Ee & I). apply in_map_iff in J.
  destruct J as (f & Ef & J). unfold R2e in Ee, Ef. injection Ee; intros <- <-.
  injection Ef; intros <- <-.
  assert (L : forall g h, In g E -> In h F -> start g <> finish g \/ start h <> finish h).
  { intros g h Ig Ih. exact (edges_long _ _ (in_map R2e _ _ Ig) (in_map R2e _ _ Ih)). }
  assert (A : forall g, In g F -> ~ on_segment (R2 (fst e)) (R2 (snd e)) (minus_ x (R2 (fst g)))).
  { intros g Ig O. apply N. apply (passed E F e g x); auto; apply in_or_app;
      [left|right]; apply translate_in; auto. }
  assert (B : forall g, In g E -> ~ on_segment (R2 (fst f)) (R2 (snd f)) (minus_ x (R2 (fst g)))).
  { intros g Ig O. apply N. apply (passed E F f g x); auto;
      [apply in_or_app; right|apply in_or_app; left|destruct (L g f Ig J); auto];
      apply translate_in; auto. }
  destruct (vertex_starts F _ (proj1 Q_drawn) Jd) as (f' & If' & Ed).
  destruct (vertex_starts E _ (proj1 P_drawn) Ib) as (e' & Ie' & Eb).
  split; [apply A, J|split; [rewrite <- Ed; apply A, If'|split; [apply B, I|]]].
  rewrite <- Eb. apply B, Ie'.
Qed.
Lemma sum_is_union_here x : sum_set S T x <-> union_of_sums P Q x.
Proof. exact (drawn_sum_is_union P Q S T x P_drawn Q_drawn). Qed.
Lemma sum_steady x : ~ over_some (convolution E F) x -> steady (sum_set S T) x.
Proof.
  intros N. destruct (off_convolution_constant P Q (proj1 P_drawn) (proj1 Q_drawn) x) as
    (r & Hr & K).
  - apply off_program, N.
  - exists r. split; auto. intros y Y. rewrite !sum_is_union_here. apply K, Y.
Qed.

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
    by (intros v; rewrite sum_is_union_here;
      apply decide_point_is_right; [apply P_drawn|apply Q_drawn]).
  pose proof (convolution_forward E F) as Fw.
  split; [|split; [|split]].
  - intros x N. apply (steady_off_kept _ R _ D _ Fw sum_steady x N).
  - intros e x I X. apply (kept_sided _ _ D _ Fw sum_steady e x I X).
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
Lemma polygon_set_long ps e : is_polygon_set ps -> In e (all_edges (rings_of ps)) ->
  fst e <> snd e.
Proof. intros L. apply (polygon_set_winds_once ps L). Qed.
Lemma polygon_set_area ps : is_polygon_set ps ->
  has_area (all_edges (rings_of ps)) (set_of (rings_of ps)).
Proof. intros L p. apply set_is_region, polygon_set_winds_once, L. Qed.

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
Lemma long_here e f : In e (map R2e E) -> In f (map R2e F) -> fst e <> snd e \/ fst f <> snd f.
Proof.
  unfold E, F. rewrite scaled_edges_real, edges_of_points, !rings_of_figure. intros I J.
  destruct fat as [A|A]; [left|right; exact (polygon_set_long _ f A J)].
  apply in_map_iff in I. destruct I as (g & <- & I). intros Z.
  apply (polygon_set_long _ g A I).
  unfold Corners.both, scale in Z; cbn [fst snd] in Z. injection Z; intros.
  apply point_eq; apply Rmult_eq_reg_l with (Q2R s); lra.
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
    (area_here s P Q L LP LQ N) (long_here s P Q L LP LQ N)).
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
    (area_here s P Q L LP LQ N) (long_here s P Q L LP LQ N)) as ((C & HC) & (D & HD & Bd)).
  pose proof (sum_here s P Q L) as H. split.
  - exists C. refine (falls_same _ _ C _ _ HC). intros x.
    split; apply interior_same; intros y; [apply H|apply iff_sym, H].
  - exists D. split; [|exact Bd]. refine (falls_same _ _ D _ _ HD). intros x.
    rewrite (H x). reflexivity.
Qed.
