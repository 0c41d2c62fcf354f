(** What the checker takes for a boundary event is one: no figure whose points move along lines is
    the sum before, at and after its scale. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Moving Touching Events OneForm Turned Rearranged Alike.
Open Scope R_scope.

(** ** Two states of one sum are the same figure. *)
Lemma same_point_or_not (x y : point) : {x = y} + {x <> y}.
Proof.
  destruct x as [x1 x2], y as [y1 y2].
  destruct (Req_EM_T x1 y1) as [->|N]; [|right; congruence].
  destruct (Req_EM_T x2 y2) as [->|N]; [left; auto|right; congruence].
Qed.
Lemma counts_occurrences x T : counts (Logic.eq x) T (count_occ same_point_or_not T x).
Proof.
  induction T as [|y T IH]; simpl; [apply counts_none|].
  destruct (same_point_or_not y x) as [->|N]; [apply counts_one|apply counts_not]; auto.
Qed.
Lemma counts_pairs {A} (T : A -> A -> Prop) (H : A -> Prop) l k :
  (forall a b, T a b -> (H a <-> H b)) -> Forall2 T l k -> forall n, counts H l n -> counts H k n.
Proof.
  intros G F. induction F as [|a b l k R F IH]; intros n C; auto.
  inversion C; subst; [apply counts_one|apply counts_not]; auto; [apply (G a b R)|]; auto.
  rewrite <- (G a b R). auto.
Qed.
Lemma passes_turned x R Q : turned R Q -> (passes x R <-> passes x Q).
Proof.
  intros T. pose proof (turned_permuted _ _ (turned_edges _ _ T)) as P.
  split; intros (e & I & O); exists e; split; auto.
  - exact (Permutation_in _ P I).
  - exact (Permutation_in _ (Permutation_sym P) I).
Qed.
Lemma touching_same rs qs T U : paired turned rs qs -> touch_in rs T -> touch_in qs U ->
  Permutation T U.
Proof.
  intros (ms & P & F) HT HU. apply (Permutation_count_occ same_point_or_not). intros x.
  destruct (HT x) as (n & N1 & N2). destruct (HU x) as (m & M1 & M2).
  assert (n = m).
  { apply (counts_same _ _ _ (counts_pairs turned (passes x) ms qs (passes_turned x) F n
      (counts_permutation _ _ _ P _ N1)) _ M1). }
  subst m. rewrite (counts_same _ _ _ (counts_occurrences x T) _ N2).
  symmetry. exact (counts_same _ _ _ (counts_occurrences x U) _ M2).
Qed.
Lemma states_same s P Q ps T n qs U m : is_state s P Q ps T n -> is_state s P Q qs U m ->
  same_figure (ps, T) (qs, U).
Proof.
  intros (SP & _ & _ & FP & TP) (SQ & _ & _ & FQ & TQ).
  assert (Pair : paired same_polygon ps qs).
  { apply (one_form_but_for_order_holds (set_of (rings_of ps))); auto.
    - apply rings_give_closed_sets_holds.
    - apply (form_same (set_of (rings_of qs))); auto. intros x. rewrite (SQ x). symmetry.
      apply SP. }
  split; [exact Pair|]. cbn [fst snd]. destruct Pair as (ms & Pm & F).
  destruct (same_polygons_rings _ _ F) as (rs & P1 & P2).
  apply (touching_same (rings_of ps) (rings_of qs)); auto. exists rs. split; auto.
  eapply Permutation_trans; [|exact P1]. apply Permutation_flat_map, Pm.
Qed.

(** ** A scale at which points are different that move differently *)
Lemma moved_twice s t m k : s <> t -> moved s m = moved s k -> moved t m = moved t k -> m = k.
Proof.
  destruct m as [[a1 a2] [b1 b2]], k as [[c1 c2] [d1 d2]]. unfold moved, add, scale.
  cbn [fst snd]. intros N E F. injection E; injection F; clear E F; intros F2 F1 E2 E1.
  assert (X1 : (s - t) * (b1 - d1) = 0) by lra. assert (X2 : (s - t) * (b2 - d2) = 0) by lra.
  apply Rmult_integral in X1. apply Rmult_integral in X2.
  assert (b1 = d1) by (destruct X1; [exfalso; apply N|]; lra).
  assert (b2 = d2) by (destruct X2; [exfalso; apply N|]; lra).
  subst. f_equal; f_equal; lra.
Qed.
Lemma all_different (L : list ((point * point) * (point * point))) : forall l h, l < h ->
  exists l' h', l <= l' /\ l' < h' /\ h' <= h /\ forall s m k, l' < s < h' -> In (m, k) L ->
    moved s m = moved s k -> m = k.
Proof.
  induction L as [|[m k] L IH]; intros l h H.
  { exists l, h. repeat split; try lra. intros s m k _ []. }
  assert (Less : exists g, l < g <= h /\ forall s, l < s < g -> moved s m = moved s k -> m = k).
  { destruct (classic (exists g, l < g < h /\ moved g m = moved g k)) as [(g & G & E)|N].
    - exists g. split; [lra|]. intros s S F. apply (moved_twice s g); auto. lra.
    - exists h. split; [lra|]. intros s S F. destruct N. exists s. auto. }
  destruct Less as (g & G & K). destruct (IH l g) as (l' & h' & H1 & H2 & H3 & J); [lra|].
  exists l', h'. repeat split; try lra. intros s a b S [Q|I].
  - injection Q; intros; subst. apply (K s); auto. lra.
  - apply (J s); auto.
Qed.
Lemma some_scale (L : list (point * point)) l h : l < h -> exists s, l < s < h /\
  forall m k, In m L -> In k L -> moved s m = moved s k -> m = k.
Proof.
  intros H. destruct (all_different (list_prod L L) l h H) as (l' & h' & H1 & H2 & H3 & K).
  exists ((l' + h') / 2). split; [lra|]. intros m k I J. apply (K _ m k); [lra|].
  apply in_prod; auto.
Qed.

(** There a figure tells how its points move. *)
Definition all_points {A} (f : list (polygon A) * list A) : list A :=
  concat (rings_of (fst f)) ++ snd f.
Lemma map_same {A} (g : A -> A) l : (forall x, In x l -> g x = x) -> map g l = l.
Proof. intros H. rewrite (map_ext_in g (fun x => x)); [apply map_id|auto]. Qed.
Lemma figure_same {A} (g : A -> A) f : (forall v, In v (all_points f) -> g v = v) ->
  figure_map g f = f.
Proof.
  destruct f as [ps T]. intros H. unfold figure_map, all_points in *. cbn [fst snd] in *.
  f_equal; [|apply map_same; intros v I; apply H, in_or_app; auto].
  assert (K : forall ring v, In ring (rings_of ps) -> In v ring -> g v = v).
  { intros ring v I J. apply H, in_or_app. left. apply in_concat. eauto. }
  clear H. unfold each_vertex. apply map_same. intros [o h] I.
  assert (R : forall ring, In ring (o :: h) -> map g ring = ring).
  { intros ring J. apply map_same. intros v. apply K. apply in_flat_map. exists (o, h). auto. }
  cbn [fst snd]. f_equal; [apply R; simpl; auto|]. apply map_same. intros ring J. apply R. simpl.
  auto.
Qed.
Lemma figure_twice {A B C} (f : A -> B) (g : B -> C) x :
  figure_map g (figure_map f x) = figure_map (fun a => g (f a)) x.
Proof. unfold figure_map. cbn [fst snd]. rewrite each_twice, map_map. reflexivity. Qed.
Lemma way_back s (L : list (point * point)) :
  (forall m k, In m L -> In k L -> moved s m = moved s k -> m = k) ->
  exists g, forall m, In m L -> g (moved s m) = m.
Proof.
  induction L as [|a L IH]; intros H; [exists (fun x => (x, x)); intros m []|].
  destruct IH as (g & G); [intros m k I J; apply H; simpl; auto|].
  exists (fun y => if same_point_or_not (moved s a) y then a else g y). intros m I.
  destruct (same_point_or_not (moved s a) (moved s m)) as [E|N].
  - apply H; simpl; auto.
  - destruct I as [<-|I]; [destruct N; auto|auto].
Qed.
Lemma same_tracks s f h :
  (forall m k, In m (all_points f ++ all_points h) -> In k (all_points f ++ all_points h) ->
    moved s m = moved s k -> m = k) ->
  same_figure (figure_map (moved s) f) (figure_map (moved s) h) -> same_figure f h.
Proof.
  intros H K. destruct (way_back s _ H) as (g & G). apply (same_figure_map g) in K.
  rewrite !figure_twice in K. rewrite !figure_same in K; auto; intros v I; apply G, in_or_app; auto.
Qed.

(** ** Figures that move along lines *)
Lemma at_tracks s m : fst (at_ s m) = figure_map (moved s) (tracks m).
Proof.
  destruct m as [[ps T] n]. unfold tracks, figure_map. cbn [fst snd at_].
  rewrite each_twice, map_map. reflexivity.
Qed.
(** A figure of a sum at a scale *)
Definition is_figure (s : R) (P Q : rings vertex) (f : list (polygon point) * list point) : Prop :=
  exists n, is_state s P Q (fst f) (snd f) n.
Lemma figures_same s P Q f g : is_figure s P Q f -> is_figure s P Q g -> same_figure f g.
Proof. destruct f, g. intros (n & F) (m & G). exact (states_same _ _ _ _ _ _ _ _ _ F G). Qed.
Lemma moving_same from to P Q f g : from < to ->
  (forall s, from < s < to -> is_figure s P Q (figure_map (moved s) f)) ->
  (forall s, from < s < to -> is_figure s P Q (figure_map (moved s) g)) -> same_figure f g.
Proof.
  intros L F G. destruct (some_scale (all_points f ++ all_points g) from to L) as (s & S & D).
  apply (same_tracks s); auto. apply (figures_same s P Q); auto.
Qed.
Lemma interval_figure from to P Q m s : is_interval from to P Q m -> Q2R from < s < Q2R to ->
  is_figure s P Q (figure_map (moved s) (tracks m)).
Proof.
  intros (_ & H) S. rewrite <- at_tracks. specialize (H s S). destruct m as [[ps T] n].
  exists n. exact H.
Qed.

(** ** Statements of OneForm.v *)
Theorem one_figure_of_an_interval_holds : one_figure_of_an_interval.
Proof.
  intros from to P Q m n H K. apply (moving_same (Q2R from) (Q2R to) P Q); [apply H| |];
    intros s S; apply (interval_figure from to); auto.
Qed.
Theorem boundary_events_are_events_holds : boundary_events_are_events.
Proof.
  intros from s to P Q before there after (B & A & H & Ch) (ps & T & M).
  pose proof (proj1 B) as L1. pose proof (proj1 A) as L2. set (f := (ps, T)).
  assert (F : forall t, Q2R from < t < Q2R to -> is_figure t P Q (figure_map (moved t) f))
    by (intros t S; apply (M t S)).
  assert (First : same_figure (tracks before) f).
  { apply (moving_same (Q2R from) (Q2R s) P Q _ _ L1); intros t S; [|apply F; lra].
    apply (interval_figure from s); auto. }
  assert (Last : same_figure f (tracks after)).
  { apply (moving_same (Q2R s) (Q2R to) P Q _ _ L2); intros t S; [apply F; lra|].
    apply (interval_figure s to); auto. }
  destruct Ch as [N|N]; apply N; [exact (same_figure_more _ _ _ First Last)|].
  rewrite at_tracks. apply (same_figure_more _ (figure_map (moved (Q2R s)) f)).
  - apply same_figure_map, First.
  - apply (figures_same (Q2R s) P Q); [apply F; lra|]. destruct there as [[qs U] n].
    exists n. apply H.
Qed.
