(** Classes of covered cells: each is open in the interior, and in each all points are joined. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Numbers Values
  Checker Corners Cancellation Bodies Scaling Trees Theorems Components.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** The only edge that m is on, by its direction u: near m the cell is what is left of it. *)
Definition along (u w : point) : R := fst u * snd w - snd u * fst w.
Lemma side_is l m u : side_of l m = Some u -> left_of l (real m) /\
  exists e, 0 < e /\ forall y, near e (real m) y ->
    0 <= along (real u) (minus y (real m)) -> left_of l y.
Proof.
  unfold side_of. intros H.
  destruct (filter _ (ring_edges l)) as [|[a b] [|? ?]] eqn:F; try discriminate.
  destruct (is_left l m) eqn:L; [|discriminate]. injection H; intros <-. cbn [fst snd].
  pose proof L as L'. apply is_left_real in L. split; [exact L|].
  assert (Z : orient (real a) (real b) (real m) = 0).
  { assert (I : In (a, b) [(a, b)]) by (simpl; auto). rewrite <- F in I.
    apply filter_In in I. destruct I as [_ I]. apply equal_value in I. cbn [fst snd] in I.
    rewrite real_orient, value_zero in I. symmetry. exact I. }
  assert (G : forall p q, In (p, q) (ring_edges l) ->
      (p, q) = (a, b) \/ 0 < orient (real p) (real q) (real m)).
  { intros p q I. specialize (L p q I). destruct (equal zero (qorient p q m)) eqn:E.
    - left. assert (J : In (p, q) [(a, b)]).
      { rewrite <- F. apply filter_In. split; auto. }
      destruct J as [J|[]]. auto.
    - right. rewrite <- real_orient, <- value_zero. apply not_equal_value; auto.
      apply (is_left_le l m L' p q I). }
  unfold left_of. clear F H L. induction (ring_edges l) as [|[p q] E IH].
  - exists 1. split; [lra|]. intros y _ _ ? ? [].
  - destruct IH as (e & He & K); [intros; apply G; simpl; auto|].
    destruct (G p q (or_introl eq_refl)) as [S|S].
    + injection S; intros -> ->. exists e. split; auto. intros y Y W p' q' [I|I]; [|eapply K;
      eauto].
      injection I; intros <- <-.
      replace (orient (real a) (real b) y) with
        (along (real (qminus b a)) (minus y (real m)) + orient (real a) (real b) (real m)).
      * rewrite Z. lra.
      * unfold along, orient, minus, qminus, real; cbn [fst snd]. rewrite !value_minus. ring.
    + destruct (near_left _ _ _ S) as (f & Hf & M). exists (Rmin e f).
      split; [apply Rmin_glb_lt; auto|]. intros y Y W p' q' [I|I]; apply near_min in Y.
      * injection I; intros <- <-. specialize (M y (proj2 Y)). lra.
      * apply (K y (proj1 Y) W); auto.
Qed.

Section Classes.
Variable yes no : list (list corner). (* covered cells, and the others *)
Hypothesis yes_polygons : forall l, In l yes -> is_polygon l = true.
Hypothesis no_convex : forall l, In l no -> is_convex l = true.
Hypothesis once : forall y, (sumz (crossing_of y) (all_triangles no)
  + sumz (crossing_of y) (all_triangles yes) <= 1)%Z.

Definition covered_set (x : point) : Prop := union_of (all_triangles yes) x.

Lemma triangle_of_cell (ls : list (list corner)) l a b c :
  In l ls -> In (a, b, c) (triangles l) -> In (a, b, c) (all_triangles ls).
Proof. intros I J. apply in_flat_map. exists l; auto. Qed.
Lemma no_positive : positive (all_triangles no).
Proof. apply all_positive. intros l I. apply convex_polygon, no_convex, I. Qed.
Lemma yes_positive : positive (all_triangles yes).
Proof. apply all_positive, yes_polygons. Qed.
Lemma interior_in x : interior covered_set x -> covered_set x.
Proof. intros (e & He & N). apply N, near_self, He. Qed.
Lemma interior_is_open (S : point -> Prop) x : interior S x ->
  exists e, 0 < e /\ forall y, near e x y -> interior S y.
Proof.
  intros (e & He & N). exists (e / 2). split; [lra|]. intros y Y. exists (e / 2). split; [lra|].
  intros z Z. apply N, (near_near e x y z); auto.
Qed.

(** No interior point is in a cell that is not covered. *)
Lemma not_in_others l x : In l no -> left_of l x -> interior covered_set x -> False.
Proof.
  intros I L (e & He & N). pose proof (convex_polygon _ (no_convex l I)) as P.
  destruct (left_polygon l x P L) as (a & b & c & J & K).
  pose proof (polygon_positive l P _ _ _ J) as D.
  destruct (soon_exists _ (soon_and _ _ (curve_near e x (minus (middle a b c) x) He)
    (curve_inside a b c x D K))) as (t & _ & K1 & K2).
  apply (no_overlap _ _ no_positive yes_positive once a b c _ (triangle_of_cell no l a b c I J) K2).
  apply N, K1.
Qed.

(** One class of covered cells *)
Section Class.
Variable cells : list (list corner).
Variable c : component.
Hypothesis inside_yes : forall l, In l cells -> In l yes.
Hypothesis one_class : is_class cells c = true.

Definition class (x : point) : Prop :=
  interior covered_set x /\ union_of (all_triangles cells) x.

Lemma class_convex l : In l cells -> is_convex l = true.
Proof.
  intros I. unfold is_class in one_class. rewrite andb_true_iff, forallb_forall in one_class.
  apply one_class, I.
Qed.
Lemma class_positive : positive (all_triangles cells).
Proof. apply all_positive. intros l I. apply convex_polygon, class_convex, I. Qed.

(** Paths in a class *)
Lemma left_in_class l x : In l cells -> left_of l x -> interior covered_set x -> class x.
Proof.
  intros I L X. split; auto.
  destruct (left_polygon l x (convex_polygon _ (class_convex l I)) L) as (u & v & w & J & K).
  exists u, v, w. split; auto. eapply triangle_of_cell; eauto.
Qed.
Lemma left_in_set l x : In l cells -> left_of l x -> covered_set x.
Proof.
  intros I L.
  destruct (left_polygon l x (convex_polygon _ (class_convex l I)) L) as (u & v & w & J & K).
  exists u, v, w. split; auto. apply (triangle_of_cell yes l); auto.
Qed.
Lemma strict_in_interior l x : In l cells -> strict l x -> interior covered_set x.
Proof.
  intros I X. destruct (left_is_open l x X) as (e & He & N). exists e. split; auto.
  intros y Y. apply (left_in_set l); auto.
Qed.
Lemma step_to_middle l x m : In l cells -> left_of l x -> interior covered_set x -> strict l m ->
  joined class x m.
Proof.
  intros I L X M. apply joined_step. intros p (t & T & ->).
  destruct (Req_EM_T t 0) as [->|N].
  - replace (fst x + 0 * (fst m - fst x), snd x + 0 * (snd m - snd x)) with x
      by (destruct x; simpl; f_equal; ring).
    apply (left_in_class l); auto.
  - assert (S : strict l (fst x + t * (fst m - fst x), snd x + t * (snd m - snd x)))
      by (apply strict_on_segment; auto; lra).
    apply (left_in_class l); auto; [apply strict_left, S|apply (strict_in_interior l); auto].
Qed.

(** All inner points of two cells are joined. *)
Definition meets (l k : list corner) : Prop :=
  forall m n, strict l m -> strict k n -> joined class m n.
Lemma meets_self l : In l cells -> meets l l.
Proof.
  intros I m n M N. apply (step_to_middle l); auto; [apply strict_left, M|].
  apply (strict_in_interior l); auto.
Qed.
Lemma meets_back l k : meets l k -> meets k l.
Proof. intros H m n M N. apply joined_back, H; auto. Qed.
Lemma meets_join l k j : In k cells -> meets l k -> meets k j -> meets l j.
Proof.
  intros I H K m n M N. destruct (convex_has_inside k (class_convex k I)) as (p & P).
  eapply joined_join; [apply H|apply K]; eauto.
Qed.
Lemma linked_meets l k m : In l cells -> In k cells -> left_of l m -> left_of k m ->
  interior covered_set m -> meets l k.
Proof.
  intros Il Ik Ll Lk X p q P Q. eapply joined_join.
  - apply joined_back, (step_to_middle l m p); auto.
  - apply (step_to_middle k m q); auto.
Qed.

(** A link: both cells together hold all points near m. *)
Lemma link_inside l k m : In l cells -> In k cells -> is_link l k m = true ->
  left_of l (real m) /\ left_of k (real m) /\ interior covered_set (real m).
Proof.
  intros Il Ik H. unfold is_link in H.
  destruct (side_of l m) as [u|] eqn:Eu; [|discriminate].
  destruct (side_of k m) as [v|] eqn:Ev; [|discriminate].
  apply andb_prop in H. destruct H as [H1 H2].
  apply equal_value in H1. symmetry in H1. apply lt_value in H2.
  destruct (side_is l m u Eu) as (Lu & e & He & Nu).
  destruct (side_is k m v Ev) as (Lv & f & Hf & Nv).
  split; [exact Lu|split; [exact Lv|]]. exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
  intros y Y. apply near_min in Y. destruct Y as [Y1 Y2].
  specialize (Nu y Y1). specialize (Nv y Y2).
  set (w := minus y (real m)) in *.
  rewrite value_minus, !value_times, value_zero in H1.
  rewrite value_plus, !value_times, value_zero in H2.
  unfold along, real in Nu, Nv. cbn [fst snd] in Nu, Nv.
  set (u1 := value (fst u)) in *. set (u2 := value (snd u)) in *.
  set (v1 := value (fst v)) in *. set (v2 := value (snd v)) in *.
  destruct (Rle_dec 0 (u1 * snd w - u2 * fst w)) as [P|P].
  - apply (left_in_set l); auto.
  - apply (left_in_set k); auto. apply Nv.
    assert (E : (u1 * u1 + u2 * u2) * (v1 * snd w - v2 * fst w)
      = (u1 * v1 + u2 * v2) * (u1 * snd w - u2 * fst w)
        - (u1 * v2 - u2 * v1) * (u1 * fst w + u2 * snd w)) by ring.
    rewrite H1 in E.
    assert (0 < u1 * u1 + u2 * u2).
    { destruct (Req_dec u1 0) as [Z1|Z1], (Req_dec u2 0) as [Z2|Z2]; nra. }
    nra.
Qed.

Lemma linked_all ls : forall before k, linked before ls k = true ->
  (forall l, In l before -> In l cells) -> (forall l, In l ls -> In l cells) ->
  (forall l j, In l before -> In j before -> meets l j) ->
  forall l j, In l (before ++ ls) -> In j (before ++ ls) -> meets l j.
Proof.
  induction ls as [|d ls IH]; intros before k H Hb Hl M.
  - rewrite app_nil_r. exact M.
  - destruct k as [|[n m] k]; [discriminate|]. simpl in H.
    destruct (nth_error before n) as [p|] eqn:E; [|discriminate].
    apply andb_prop in H. destruct H as [H1 H2]. apply nth_error_In in E.
    assert (Id : In d cells) by (apply Hl; simpl; auto).
    destruct (link_inside p d m (Hb p E) Id H1) as (Lp & Ld & X).
    pose proof (linked_meets p d (real m) (Hb p E) Id Lp Ld X) as Link.
    assert (G : forall l, In l before -> meets l d).
    { intros l I. apply (meets_join l p d (Hb p E)); auto. }
    intros l j Il Ij. apply (IH (d :: before) k H2).
    + intros i [<-|I]; auto.
    + intros i I. apply Hl. simpl; auto.
    + intros i i' [<-|I] [<-|I']; [apply meets_self, Id| | |]; auto. apply meets_back; auto.
    + apply in_app_or in Il. simpl. rewrite in_app_iff. simpl in Il. tauto.
    + apply in_app_or in Ij. simpl. rewrite in_app_iff. simpl in Ij. tauto.
Qed.

Lemma first_and_links : exists first others, cells = first :: others /\
  linked [first] others (links c) = true.
Proof.
  pose proof one_class as Co. unfold is_class in Co. rewrite andb_true_iff in Co.
  destruct Co as [_ Co]. unfold is_connected in Co. revert Co.
  generalize cells. intros [|first others] Co; [discriminate|]. exists first, others. auto.
Qed.
Theorem class_joined x y : class x -> class y -> joined class x y.
Proof.
  intros [X Ux] [Y Uy].
  assert (L : forall z, union_of (all_triangles cells) z -> exists l, In l cells /\ left_of l z).
  { intros z (a & b & d & I & K). apply in_flat_map in I. destruct I as (l & I & J).
    exists l. split; auto. apply convex_union_left; [apply class_convex, I|].
    exists a, b, d; auto. }
  destruct (L x Ux) as (l & Il & Lx). destruct (L y Uy) as (k & Ik & Ly).
  assert (M : meets l k).
  { destruct first_and_links as (first & others & E & Co).
    assert (In first cells) by (rewrite E; simpl; auto).
    apply (linked_all others [first] (links c) Co).
    - intros i [<-|[]]. auto.
    - intros i I. rewrite E. simpl; auto.
    - intros i j [<-|[]] [<-|[]]. apply meets_self. auto.
    - simpl. rewrite E in Il. exact Il.
    - simpl. rewrite E in Ik. exact Ik. }
  destruct (convex_has_inside l (class_convex l Il)) as (m & Hm).
  destruct (convex_has_inside k (class_convex k Ik)) as (n & Hn).
  eapply joined_join; [apply (step_to_middle l x m); auto|].
  eapply joined_join; [apply (M m n Hm Hn)|]. apply joined_back, (step_to_middle k y n); auto.
Qed.
Lemma class_not_empty : exists x, class x.
Proof.
  assert (E : exists l, In l cells)
    by (destruct first_and_links as (l & r & E & _); exists l; rewrite E; simpl; auto).
  destruct E as (l & I). destruct (convex_has_inside l (class_convex l I)) as (m & M).
  exists m. apply (left_in_class l); auto; [apply strict_left, M|].
  apply (strict_in_interior l); auto.
Qed.

(** The rim of a class: the class is open. *)
Hypothesis rim_holds : has_rim no cells c = true.
Definition rim_rings : rings corner := map fst (rim c).
Lemma rim_turns y : winding (real_edges rim_rings) y = sumz (crossing_of y) (all_triangles cells).
Proof.
  unfold has_rim in rim_holds. rewrite andb_true_iff in rim_holds.
  destruct rim_holds as [_ B]. rewrite real_edges_of, <- turns_of_polygons.
  apply (same_boundary_same_turns _ _ B).
Qed.
Lemma rim_in_others a b : In (a, b) (all_edges rim_rings) ->
  exists l, In l no /\ left_of l (real a) /\ left_of l (real b).
Proof.
  unfold has_rim in rim_holds. rewrite andb_true_iff, forallb_forall in rim_holds.
  destruct rim_holds as [B _]. unfold all_edges, rim_rings. intros I.
  apply in_flat_map in I. destruct I as (ring & J & I). apply in_map_iff in J.
  destruct J as ([r ns] & <- & J). specialize (B _ J). unfold on_rim in B. simpl in B, I.
  destruct (all2_partner _ _ _ B (a, b) I) as (n & E). cbn [fst snd] in E.
  destruct (nth_error no n) as [l|] eqn:El; [|discriminate]. apply andb_prop in E.
  exists l. split; [eapply nth_error_In; eauto|]. split; apply is_left_real; tauto.
Qed.
Lemma rim_constant x : interior covered_set x -> exists e, 0 < e /\ forall y, near e x y ->
  winding (real_edges rim_rings) y = winding (real_edges rim_rings) x.
Proof.
  intros X.
  assert (E : real_edges rim_rings = flat_map ring_edges (outline rim_rings))
    by reflexivity.
  rewrite E. apply rings_near. rewrite <- E, real_edges_of. intros a b I S.
  apply in_map_iff in I. destruct I as ([u v] & K & I). unfold real_edge in K. simpl in K.
  assert (a = real u /\ b = real v) as [-> ->] by (split; congruence).
  destruct (rim_in_others u v I) as (l & J & La & Lb).
  exact (not_in_others l x J (left_on_segment l _ _ x La Lb S) X).
Qed.
Lemma class_by_winding x : interior covered_set x ->
  (union_of (all_triangles cells) x <-> (1 <= winding (real_edges rim_rings) x)%Z).
Proof.
  intros X. split.
  - intros (u & v & w & I & K). destruct (rim_constant x X) as (e & He & N).
    destruct (soon_exists _ (soon_and _ _ (curve_near e x (minus (middle u v w) x) He)
      (curve_inside u v w x (class_positive _ _ _ I) K))) as (t & _ & K1 & K2).
    rewrite <- (N _ K1), rim_turns. apply (union_counted _ _ u v w); auto. apply class_positive.
  - rewrite rim_turns. apply counted_union, class_positive.
Qed.
Theorem class_open x : class x -> interior class x.
Proof.
  intros [X Y]. apply (class_by_winding x X) in Y. destruct (rim_constant x X) as (e & He & N).
  destruct (interior_is_open _ x X) as (f & Hf & M). exists (Rmin e f).
  split; [apply Rmin_glb_lt; auto|]. intros y Z. apply near_min in Z. destruct Z as [Z1 Z2].
  split; [apply M, Z2|]. apply class_by_winding; [apply M, Z2|]. rewrite (N y Z1). auto.
Qed.

End Class.
End Classes.
End Here.
