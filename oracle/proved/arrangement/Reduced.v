(** The frontier of a sum is on the reduced convolution. An edge of one set at a vertex of the other
    is left out where a point of the other set, close to the vertex, is right of the edge: the set
    of the edge is on its left, so the sum is all around. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals Qreduction ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Corners Scaling Crossings Local Across
  Overlaps Components Canonical Paths Decomposed Gaps Unique Rounds Convolution.
From Proved Require Import Points Segments Legal Member Decided Pieces Sorting Along Cuts Lone
  Flanks Kept Frontier Extent Opposite.
Open Scope R_scope.

(** ** What the program leaves out *)
Lemma not_all {A} (test : A -> bool) l : forallb test l = false ->
  exists x, In x l /\ test x = false.
Proof.
  induction l as [|x l IH]; [discriminate|]. cbn [forallb]. destruct (test x) eqn:T.
  - intros H. destruct (IH H) as (y & I & K). exists y. simpl. auto.
  - intros _. exists x. simpl. auto.
Qed.
Lemma fits_not d c : fits d c = false ->
  (exists w, In w (fst (snd c)) /\ turn_of (R2 d) (R2 w) < 0) \/
  (exists o, In o (snd (snd c)) /\ ~ along (R2 d) (R2 o)).
Proof.
  unfold fits. rewrite andb_false_iff. intros [H|H]; apply not_all in H;
    destruct H as (w & I & H); [left|right]; exists w; (split; [exact I|]).
  - apply Z.leb_gt in H. rewrite <- qcross_real. apply Z.ltb_lt in H. rewrite sg_neg in H.
    destruct (Rlt_dec _ 0); [auto|discriminate].
  - intros [A B]. apply not_true_iff_false in H. apply H. unfold one_way.
    rewrite sg_pos, dot_real. destruct (Rlt_dec _ _); [|contradiction].
    rewrite andb_true_r, Z.eqb_eq. rewrite <- qcross_real in A.
    pose proof (sg_neg (qcross d w)) as Neg. pose proof (sg_pos (qcross d w)) as Pos.
    rewrite A in Neg, Pos. destruct (Rlt_dec 0 0); [lra|].
    apply Z.ltb_ge in Neg, Pos. lia.
Qed.
Lemma bare_left l o w : is_bare l o = true -> In w l -> turn_of (R2 o) (R2 w) <= 0.
Proof.
  intros B I. unfold is_bare in B. rewrite forallb_forall in B. specialize (B w I).
  apply Z.leb_le in B. rewrite <- qcross_real. pose proof (sg_pos (qcross o w)) as Pos.
  destruct (Rlt_dec 0 (Q2R (qcross o w))); [|lra]. apply Z.ltb_lt in Pos. lia.
Qed.
Lemma arm_of F v w : In w (arms F v) -> exists f u, In f F /\
  passes_over (from_left f) v = true /\ (u = fst f \/ u = snd f) /\ w = sub u v.
Proof.
  intros I. apply in_flat_map in I. destruct I as (f & J & I).
  destruct (passes_over (from_left f) v) eqn:O; [|destruct I].
  destruct I as [<-|[<-|[]]]; exists f; eexists; repeat split; eauto.
Qed.
Lemma arm_in F f v u : In f F -> start f <> finish f -> lies_on f (R2 v) ->
  u = fst f \/ u = snd f -> In (sub u v) (arms F v).
Proof.
  intros I N O U. apply in_flat_map. exists f. split; [exact I|].
  assert (Fw : forward (from_left f)).
  { apply from_left_forward, not_true_iff_false. unfold null. rewrite same_real. exact N. }
  apply from_left_on, (passes_over_real _ v Fw) in O. rewrite O.
  destruct U as [->| ->]; simpl; auto.
Qed.
Lemma passed_over f v : passes_over (from_left f) v = true ->
  lies_on f (R2 v) \/ (R2 v = start f /\ R2 v = finish f).
Proof.
  intros O. destruct (null f) eqn:N; [right|left].
  - apply same_real in N. fold (start f) (finish f) in N. rewrite <- N.
    apply andb_true_iff in O. destruct O as [O B]. apply andb_true_iff in O. destruct O as [_ A].
    rewrite not_after_real in A, B. assert (G : R2 v = start f); [|auto].
    unfold start, finish, from_left in *. destruct (is_before _ _); cbn [fst snd] in A, B.
    + rewrite <- N in B. unfold before in A, B. apply point_eq; lra.
    + rewrite <- N in A. unfold before in A, B. apply point_eq; lra.
  - apply from_left_on, passes_over_real; auto. apply from_left_forward, N.
Qed.
Lemma drawn_edges E S p : drawn E S -> on_some E p -> S p.
Proof. intros (_ & [(H & K)|(H & _)]) O; apply H; auto. Qed.

(** An operand that is not slim is drawn by its edges, with the set on their left. *)
Definition bordered (E : edges_t) (S : point -> Prop) : Prop :=
  has_area E S /\ left_sides E S /\ forall e, In e E -> fst e <> snd e.

Section Corner.
Variables E F : list edge.
Variables S T : point -> Prop.
Hypothesis F_drawn : drawn (map R2e F) T.
Hypothesis E_kind : is_slim E = false -> bordered (map R2e E) S.
Hypothesis F_kind : is_slim F = false -> bordered (map R2e F) T.

Lemma left_out_right d f : In f F -> R2 d <> (0, 0) -> fits d (corner_at F f) = false ->
  right_near T (R2 d) (R2 (fst f)).
Proof.
  intros I Nd H. apply fits_not in H. unfold corner_at in H. cbn [fst snd] in H.
  set (v := fst f) in *. destruct H as [(w & Iw & H)|(o & Io & H)].
  - destruct (arm_of F v w Iw) as (g & u & Ig & O & U & ->). rewrite sub_real in H.
    apply arm_right with (R2 u); [|exact H]. intros t Ht. apply (drawn_edges _ _ _ F_drawn).
    exists (start g), (finish g). split; [exact (in_map R2e _ _ Ig)|].
    destruct (passed_over g v O) as [(s & Hs & Ev)|[A B]].
    + change (R2 v = at_ (start g) (finish g) s) in Ev. rewrite Ev.
      destruct U as [->| ->]; [fold (start g)|fold (finish g)].
      * exists (s - t * s). split; [nra|]. unfold at_; cbn [fst snd]. f_equal; ring.
      * exists (s + t * (1 - s)). split; [nra|]. unfold at_; cbn [fst snd]. f_equal; ring.
    + exfalso. assert (Eu : R2 u = R2 v) by (destruct U as [->| ->]; auto).
      rewrite Eu in H. unfold turn_of, minus_ in H; cbn [fst snd] in H. lra.
  - destruct (is_slim F) eqn:Sl; [destruct Io|]. destruct (F_kind eq_refl) as (A & L & N).
    apply filter_In in Io. destruct Io as [Io B]. apply in_map_iff in Io.
    destruct Io as (g & <- & Ig). apply filter_In in Ig. destruct Ig as [Ig Ev].
    apply same_real in Ev. rewrite dir_real in H. unfold start in H. rewrite Ev in H.
    pose proof (in_map R2e _ _ Ig) as Jg. unfold R2e at 1 in Jg. rewrite Ev in Jg.
    pose proof (N _ Jg) as Ng. cbn [fst snd] in Ng.
    apply half_right with (finish g); auto.
    apply (half_disc (map R2e F)); auto; [apply F_drawn|].
    intros a b Iab O. apply in_map_iff in Iab. destruct Iab as (k & Ek & Ik).
    pose proof (N _ (in_map R2e _ _ Ik)) as Nk. unfold R2e in Ek. injection Ek; intros <- <-.
    assert (G : forall u, u = fst k \/ u = snd k -> orient (R2 v) (finish g) (R2 u) <= 0).
    { intros u U. pose proof (bare_left _ _ _ B (arm_in F k v u Ik Nk O U)) as G.
      rewrite dir_real, sub_real in G. unfold start in G. rewrite Ev in G. exact G. }
    split; apply G; auto.
Qed.

Lemma exceptions : exists L, forall e, In e E -> forall p, lies_on e p -> ~ In p L ->
  inside e p /\ p <> start e /\ (is_slim E = false -> left_at S (start e) (finish e) p).
Proof.
  assert (G : forall K, incl K E -> exists L, forall e, In e K -> forall p, lies_on e p ->
    ~ In p L -> inside e p /\ p <> start e /\
      (is_slim E = false -> left_at S (start e) (finish e) p)).
  { induction K as [|e K IH]; intros Inc; [exists []; intros e []|].
    destruct IH as (L & HL); [intros f J; apply Inc; simpl; auto|].
    assert (M : exists M, forall p, inside e p -> ~ In p M -> is_slim E = false ->
      left_at S (start e) (finish e) p).
    { destruct (is_slim E); [exists []; intros; discriminate|].
      destruct (E_kind eq_refl) as (_ & Ls & _).
      destruct (Ls (start e) (finish e)) as (M & HM).
      - apply (in_map R2e E e), Inc. simpl. auto.
      - exists M. auto. }
    destruct M as (M & HM). exists (start e :: finish e :: M ++ L).
    intros f [<-|J] p O N.
    - assert (X : inside e p).
      { apply inner_of_segment; [exact O|intros ->; apply N; simpl; auto|].
        intros ->; apply N; simpl; auto. }
      split; [exact X|]. split; [intros ->; apply N; simpl; auto|]. apply HM; auto.
      intros I. apply N. simpl. auto with datatypes.
    - apply (HL f J p O). intros I. apply N. simpl. auto with datatypes. }
  apply G, incl_refl.
Qed.
Lemma moved_in e f : In e E -> In f F -> is_slim E || fits (dir e) (corner_at F f) = true ->
  In (moved e (fst f)) (translates E F).
Proof.
  intros I J H. apply in_flat_map. exists e. split; [exact I|].
  apply (in_map (fun c : corner => moved e (fst c)) _ (corner_at F f)).
  apply filter_In. split; [apply in_map, J|exact H].
Qed.
Lemma translated_on a b c x : on_segment (R2 a) (R2 b) (minus_ x (R2 c)) ->
  lies_on (qadd a c, qadd b c) x.
Proof.
  unfold lies_on; cbn [fst snd]. rewrite !qadd_real. generalize (R2 a) (R2 b) (R2 c).
  intros p q r (t & T' & Q). exists t. split; auto. unfold minus_ in Q. injection Q; intros E2 E1.
  apply point_eq; unfold add; cbn [fst snd]; lra.
Qed.
Lemma translated_long a b c : R2 a <> R2 b -> start (qadd a c, qadd b c) <>
  finish (qadd a c, qadd b c).
Proof.
  unfold start, finish; cbn [fst snd]. rewrite !qadd_real. intros N Q. apply N.
  unfold add in Q. injection Q; intros. apply point_eq; unfold point_of; cbn [fst snd]; lra.
Qed.
(** Off the segments that are kept, and finitely many points, an edge at a vertex is inside. *)
Theorem left_out_inside : exists X, forall y, ~ In y X ->
  (forall e v, In (moved e v) (translates E F) -> start e <> finish e ->
    ~ on_segment (start e) (finish e) (minus_ y (R2 v))) ->
  forall e f, In e E -> In f F -> on_segment (start e) (finish e) (minus_ y (start f)) ->
  interior (sum_set S T) y.
Proof.
  destruct exceptions as (L & HL).
  exists (flat_map (fun p => map (fun f => add p (start f)) F) L).
  intros y Ny K e f I J O. set (p := minus_ y (start f)) in *.
  assert (Ey : y = add p (start f)).
  { unfold p, add, minus_; destruct y; cbn [fst snd]. f_equal; ring. }
  assert (Np : ~ In p L).
  { intros Ip. apply Ny. apply in_flat_map. exists p. split; [exact Ip|]. rewrite Ey at 1.
    apply (in_map (fun f => add p (start f))), J. }
  destruct (HL e I p O Np) as (X & Ns & Lp).
  assert (N : start e <> finish e).
  { intros N. apply Ns. destruct X as (t & _ & ->). rewrite <- N. destruct (start e); cbn [fst snd].
    f_equal; ring. }
  destruct (is_slim E || fits (dir e) (corner_at F f)) eqn:H.
  - destruct (K e (fst f) (moved_in e f I J H) N O).
  - apply orb_false_iff in H. destruct H as [Sl H]. rewrite Ey.
    apply (opposite_inside S T (start e) (finish e) p (start f)).
    + apply inner_on_line, X.
    + apply Lp, Sl.
    + rewrite <- dir_real. apply left_out_right; auto. rewrite dir_real. intros Z. apply N.
      revert Z. generalize (start e) (finish e). intros [a1 a2] [b1 b2] Z. unfold minus_ in Z.
      cbn [fst snd] in Z. injection Z; intros. f_equal; lra.
Qed.
End Corner.

(** ** The program's convolution *)
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
Lemma convolution_over E F e v x : In (moved e v) (translates E F ++ translates F E) ->
  start e <> finish e -> on_segment (start e) (finish e) (minus_ x (R2 v)) ->
  over_some (convolution E F) x.
Proof.
  unfold moved. set (g := (qadd (fst e) v, qadd (snd e) v)). intros I L O.
  apply translated_on in O. apply (translated_long _ _ v) in L.
  destruct (in_turn_has edge_le same_edge (fun p q => start p = start q /\ finish p = finish q)
    (filter (fun e => negb (null e)) (translates E F ++ translates F E)) (from_left g))
    as (f & If & E1 & E2).
  - auto.
  - intros u v' w [-> ->] [-> ->]. auto.
  - intros u w H. unfold same_edge in H. apply andb_true_iff in H. rewrite !same_real in H. exact H.
  - apply filter_In. split; auto. rewrite null_either. apply negb_true_iff, not_true_iff_false.
    unfold null. rewrite same_real. exact L.
  - exists f. split; [exact If|]. change (lies_on g x) in O. apply from_left_on in O.
    unfold lies_on in *. fold (start f) (finish f). rewrite <- E1, <- E2. exact O.
Qed.
Lemma interior_steady S x : interior S x -> steady S x.
Proof.
  intros (r & Hr & H). exists r. split; auto. intros y Y.
  pose proof (H y Y). pose proof (H x (near_self r x Hr)). tauto.
Qed.

Section Sum.
Variables E F : list edge.
Let P := map R2e E.
Let Q := map R2e F.
Variables S T : point -> Prop.
Hypothesis P_drawn : drawn P S.
Hypothesis Q_drawn : drawn Q T.
Lemma sum_is_union_here x : sum_set S T x <-> union_of_sums P Q x.
Proof. exact (drawn_sum_is_union P Q S T x P_drawn Q_drawn). Qed.
Lemma vertex_starts (G : list edge) d : closed (map R2e G) -> In d (map snd (map R2e G)) ->
  exists f, In f G /\ start f = d.
Proof.
  intros C I. apply (Permutation_in _ (Permutation_sym C)) in I. rewrite map_map in I.
  apply in_map_iff in I. destruct I as (f & E1 & I). exists f. auto.
Qed.
Lemma off_all_translates x :
  (forall e f, In e E -> In f F -> ~ on_segment (start e) (finish e) (minus_ x (start f))) ->
  (forall e f, In e E -> In f F -> ~ on_segment (start f) (finish f) (minus_ x (start e))) ->
  off_convolution P Q x.
Proof.
  intros A B a b c d I J. unfold P, Q in *.
  pose proof (in_map snd _ _ I) as Ib. pose proof (in_map snd _ _ J) as Jd. cbn [snd] in Ib, Jd.
  apply in_map_iff in I. destruct I as (e & Ee & I). apply in_map_iff in J.
  destruct J as (f & Ef & J). unfold R2e in Ee, Ef. injection Ee; intros <- <-.
  injection Ef; intros <- <-.
  destruct (vertex_starts F _ (proj1 Q_drawn) Jd) as (f' & If' & Ed).
  destruct (vertex_starts E _ (proj1 P_drawn) Ib) as (e' & Ie' & Eb).
  split; [exact (A e f I J)|]. split; [rewrite <- Ed; exact (A e f' I If')|].
  split; [exact (B e f I J)|rewrite <- Eb; exact (B e' f Ie' J)].
Qed.

Hypothesis area : has_area P S \/ has_area Q T.
Hypothesis kinds : (is_slim E = false -> bordered P S) /\ (is_slim F = false -> bordered Q T).
(** The sum begins and ends on the reduced convolution only. *)
Theorem sum_steady x : ~ over_some (convolution E F) x -> steady (sum_set S T) x.
Proof.
  intros N. destruct kinds as [KP KQ].
  destruct (left_out_inside E F S T Q_drawn KP KQ) as (X & HX).
  destruct (left_out_inside F E T S P_drawn KQ KP) as (Y & HY).
  destruct (over_near _ x N) as (r & Hr & R).
  destruct (near_all (X ++ Y) (fun z y => y = z -> y = x) x) as (s & Hs & Far).
  { intros z _. destruct (classic (z = x)) as [->|Z]; [exists 1; split; [lra|auto]|].
    destruct (segment_near z z x) as (s & Hs & M).
    - intros (t & _ & Q'). apply Z. rewrite Q'. destruct z; cbn [fst snd]. f_equal; ring.
    - exists s. split; auto. intros y Y' ->. destruct (M z Y'). apply on_segment_start. }
  apply (isolated _ (sum_regular P Q S T P_drawn Q_drawn area) x (Rmin r s)).
  { apply Rmin_glb_lt; auto. }
  intros y Ny D. apply near_min in Ny. destruct Ny as [N1 N2]. specialize (R y N1).
  assert (OX : ~ In y X).
  { intros I. apply D, (Far y N2 y); auto with datatypes. }
  assert (OY : ~ In y Y).
  { intros I. apply D, (Far y N2 y); auto with datatypes. }
  assert (GX : forall e v, In (moved e v) (translates E F) -> start e <> finish e ->
    ~ on_segment (start e) (finish e) (minus_ y (R2 v))).
  { intros e v I L O. apply R, (convolution_over E F e v y); auto with datatypes. }
  assert (GY : forall e v, In (moved e v) (translates F E) -> start e <> finish e ->
    ~ on_segment (start e) (finish e) (minus_ y (R2 v))).
  { intros e v I L O. apply R, (convolution_over E F e v y); auto with datatypes. }
  specialize (HX y OX GX). specialize (HY y OY GY).
  destruct (classic (interior (sum_set S T) y)) as [I|I]; [apply interior_steady, I|].
  destruct (off_convolution_constant P Q (proj1 P_drawn) (proj1 Q_drawn) y) as (u & Hu & K).
  - apply off_all_translates; intros e f Ie If O; apply I.
    + exact (HX e f Ie If O).
    + apply (interior_same (sum_set T S)); [intros z; apply sum_swap|]. exact (HY f e If Ie O).
  - exists u. split; auto. intros z Z. rewrite !sum_is_union_here. apply K, Z.
Qed.
End Sum.

(** ** Polygon sets, at a scale *)
Lemma polygon_set_area ps : is_polygon_set ps ->
  has_area (all_edges (rings_of ps)) (set_of (rings_of ps)).
Proof. intros L p. apply set_is_region, polygon_set_winds_once, L. Qed.
Lemma polygon_set_bordered ps : is_polygon_set ps ->
  bordered (all_edges (rings_of ps)) (set_of (rings_of ps)).
Proof.
  intros L. pose proof (polygon_set_area ps L) as A.
  destruct (polygon_set_winds_once ps L) as (_ & N & S & O). split; [exact A|split; [|exact N]].
  apply legal_left_sides; auto. apply rings_are_closed.
Qed.
Lemma bordered_scaled s E S : 0 < s -> bordered E S ->
  bordered (map (both (scale s)) E) (fun p => S (scale (/ s) p)).
Proof.
  intros L (A & B & N). split; [|split].
  - intros p. rewrite <- (scale_forth s p L) at 2. rewrite region_scale_iff by exact L. apply A.
  - apply left_sides_scaled; auto.
  - intros e I. apply in_map_iff in I. destruct I as (g & <- & I). intros Z. apply (N g I).
    unfold both, scale in Z; cbn [fst snd] in Z. injection Z; intros.
    apply point_eq; apply Rmult_eq_reg_l with s; lra.
Qed.
Lemma slim_unless_polygons ps E : is_legal ps -> length E = length (all_edges (rings_of ps)) ->
  is_slim E = false -> is_polygon_set ps.
Proof.
  unfold is_slim. intros [(a & ->)|[(a & b & _ & ->)|L]] Len; [| |auto];
    rewrite Len; discriminate.
Qed.
