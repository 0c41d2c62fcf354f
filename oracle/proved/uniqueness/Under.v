(** Forms of one closed set run along each other, polygon by polygon. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside Rounds
  Next Shared.
Open Scope R_scope.

Lemma many_under a b (F : edges_t) : forall l h, l < h ->
  (forall t, l < t < h -> on_some F (at_ a b t)) -> exists c d t u, In (c, d) F /\
  l < t /\ t < u /\ u < h /\ on_segment c d (at_ a b t) /\ on_segment c d (at_ a b u).
Proof.
  induction F as [|[c d] F IH]; intros l h L H.
  - destruct (H ((l + h) / 2)) as (c & d & [] & _). lra.
  - destruct (classic (exists t u, l < t /\ t < u /\ u < h /\ on_segment c d (at_ a b t) /\
      on_segment c d (at_ a b u))) as [(t & u & K)|N].
    { exists c, d, t, u. simpl. tauto. }
    assert (Less : exists k, l < k <= h /\ forall t, l < t < k -> ~ on_segment c d (at_ a b t)).
    { destruct (classic (exists k, l < k < h /\ on_segment c d (at_ a b k))) as [(k & K & O)|M].
      - exists k. split; [lra|]. intros t T Ot. apply N. exists t, k. repeat split; auto; lra.
      - exists h. split; [lra|]. intros t T O. apply M. exists t. auto. }
    destruct Less as (k & K & O). destruct (IH l k) as (c' & d' & t & u & I & G); [lra| |].
    + intros t T. destruct (H t ltac:(lra)) as (c' & d' & [I|I] & G).
      * injection I; intros; subst. destruct (O t T G).
      * exists c', d'. auto.
    + exists c', d', t, u. simpl. split; auto. intuition lra.
Qed.
(** Two points of one edge on another: both on one line *)
Lemma along a b c d t u : a <> b -> c <> d -> t < u -> on_segment c d (at_ a b t) ->
  on_segment c d (at_ a b u) -> exists k, k <> 0 /\
  (forall y, orient c d y = k * orient a b y) /\
  (0 < k -> 0 < u -> t < 1 -> together (a, b) (c, d)).
Proof.
  intros N M T (p & P & Ep) (q & Q & Eq). unfold at_ in Ep, Eq.
  injection Ep; injection Eq; clear Ep Eq; intros Q2 Q1 P2 P1.
  assert (D1 : (q - p) * (fst d - fst c) = (u - t) * (fst b - fst a)) by lra.
  assert (D2 : (q - p) * (snd d - snd c) = (u - t) * (snd b - snd a)) by lra.
  assert (PQ : q <> p).
  { intros ->. apply N. rewrite Rminus_diag_eq, Rmult_0_l in D1, D2 by auto.
    symmetry in D1, D2. apply Rmult_integral in D1. apply Rmult_integral in D2.
    destruct a as [a1 a2], b as [b1 b2]. cbn [fst snd] in *. destruct D1, D2; f_equal; lra. }
  set (k := (u - t) / (q - p)).
  assert (K1 : fst d - fst c = k * (fst b - fst a))
    by (apply (Rmult_eq_reg_l (q - p)); [rewrite D1; unfold k; field|]; lra).
  assert (K2 : snd d - snd c = k * (snd b - snd a))
    by (apply (Rmult_eq_reg_l (q - p)); [rewrite D2; unfold k; field|]; lra).
  assert (C1 : fst c = fst a + (t - p * k) * (fst b - fst a)) by (rewrite K1 in P1; lra).
  assert (C2 : snd c = snd a + (t - p * k) * (snd b - snd a)) by (rewrite K2 in P2; lra).
  exists k. split; [|split].
  - unfold k. intros Z. apply (Rmult_eq_compat_r (q - p)) in Z. field_simplify in Z; lra.
  - intros y. unfold orient. rewrite K1, K2, C1, C2. ring.
  - intros K U T1. assert (X : k * (q - p) = u - t) by (unfold k; field; lra).
    assert (0 <= p * k) by nra. assert (0 <= (1 - q) * k) by nra.
    exists (t - p * k), (t - p * k + k). cbn [fst snd]. unfold at_.
    split; [lra|]. split; [lra|]. split; [lra|]. destruct c as [c1 c2], d as [d1 d2].
    cbn [fst snd] in *. split; f_equal; lra.
Qed.

(** ** What a form says, polygon by polygon *)
Definition parts (S : point -> Prop) (ps : list (polygon point)) (C : nat -> point -> Prop) :=
  falls_into (interior S) C (length ps) /\
  (forall i, (i < length ps)%nat -> is_part S (C i) (form_edges ps)) /\
  forall i outer holes, nth_error ps i = Some (outer, holes) ->
    0 < area outer /\ (forall hole, In hole holes -> area hole < 0) /\
    forall ring, In ring (outer :: holes) -> bounds S (C i) ring.
Lemma form_parts S ps : is_closed S -> is_form S ps -> exists C, parts S ps C.
Proof.
  intros Cl (C & FC & In2 & _ & H). exists C. split; auto. split.
  - intros i I. destruct FC as (U & K). destruct (K i I) as (_ & Op & J & Dis).
    assert (Sub : forall x, C i x -> S x).
    { intros x X. destruct (proj2 (U x)) as (r & R & G); [exists i; auto|].
      apply G, near_self, R. }
    split; auto. split; auto. split; auto. intros x N.
    assert (In2' : forall y, S y -> ~ on_some (form_edges ps) y -> interior S y).
    { intros y Y Z. apply In2; auto. intros a b J' O. apply Z. exists a, b. auto. }
    destruct (classic (S x)) as [Sx|Sx].
    + destruct (proj1 (U x) (In2' x Sx N)) as (k & Kk & Ck).
      destruct (K k Kk) as (_ & OpK & _ & DisK). destruct (OpK x Ck) as (r & R & G).
      exists r. split; auto. intros y Y. specialize (G y Y). split; intros X.
      * rewrite <- (DisK i y I G X). exact Ck.
      * rewrite <- (DisK i x I Ck X). exact G.
    + destruct (off_edges S (form_edges ps) x Cl In2' N) as (r & R & G). exists r. split; auto.
      intros y Y. split; intros X; exfalso; apply Sx; [apply (G y Y)|]; auto.
  - intros i outer holes Q. destruct (H i outer holes Q) as (A & B & D). split; [|split]; auto.
Qed.
Lemma bounds_same S (C D : point -> Prop) R : (forall x, C x <-> D x) -> bounds S C R ->
  bounds S D R.
Proof.
  intros H (Rg & K). split; auto. intros e I. destruct (K e I) as (few & G). exists few.
  intros x O. destruct (G x O) as [F|(r & Hr & L)]; auto. right. exists r. split; auto.
  intros y Y. destruct (L y Y) as (A & B). split; auto. intros P. apply H, A, P.
Qed.
Lemma edge_of_form ps e : In e (form_edges ps) -> exists j outer holes ring,
  nth_error ps j = Some (outer, holes) /\ In ring (outer :: holes) /\ In e (ring_edges ring).
Proof.
  intros I. apply in_flat_map in I. destruct I as (ring & R & I). apply in_flat_map in R.
  destruct R as ((outer & holes) & P & R). destruct (In_nth_error ps _ P) as (j & J).
  exists j, outer, holes, ring. auto.
Qed.
Lemma ring_of_form (ps : list (polygon point)) i outer holes ring :
  nth_error ps i = Some (outer, holes) -> In ring (outer :: holes) -> In ring (rings_of ps).
Proof. intros N I. apply in_flat_map. exists (outer, holes). split; eauto using nth_error_In. Qed.

(** Under each edge of a form runs an edge of any other form, in its direction, with a point that is
    on the left of both. *)
Lemma runs S ps qs C D i outer holes ring e : is_closed S -> is_form S ps -> is_form S qs ->
  parts S ps C -> parts S qs D ->
  nth_error ps i = Some (outer, holes) -> In ring (outer :: holes) ->
  In e (ring_edges ring) -> exists j outer' holes' ring' f, nth_error qs j = Some (outer', holes')
    /\ In ring' (outer' :: holes') /\ In f (ring_edges ring') /\ together e f /\
    exists x, C i x /\ D j x.
Proof.
  intros Cl FP FQ (_ & PC & HC) (_ & _ & HD) N I Ie. destruct e as [a b].
  assert (Len : (i < length ps)%nat) by (apply nth_error_Some; congruence).
  destruct (HC i outer holes N) as (_ & _ & B). destruct (B ring I) as (Rg & Dv). clear B.
  pose proof (ring_edge_long ring a b Rg Ie) as Lab. destruct (Dv _ Ie) as (few & Kab).
  destruct (many_under a b (form_edges qs) 0 1 Rlt_0_1) as
    (c & d & t & u & If & T0 & TU & U1 & Ot & Ou).
  { intros t T. apply (boundary_within S ps qs); auto. exists a, b. split; [|apply at_on; lra].
    apply in_flat_map. exists ring. split; auto. exact (ring_of_form _ _ _ _ _ N I). }
  destruct (edge_of_form qs _ If) as (j & outer' & holes' & ring' & N' & I' & If').
  destruct (HD j outer' holes' N') as (_ & _ & B). destruct (B ring' I') as (Rg' & Dv'). clear B.
  pose proof (ring_edge_long ring' c d Rg' If') as Lcd. destruct (Dv' _ If') as (few' & Kcd).
  destruct (along a b c d t u Lab Lcd TU Ot Ou) as (k & K0 & Ok & Tog).
  assert (Ntu : at_ a b t <> at_ a b u).
  { intros Q. apply (at_apart a b t u Lab) in Q. lra. }
  destruct (one_not_in (few ++ few') _ _ Ntu) as (x & (w & W & Ex) & Out).
  rewrite in_app_iff in Out.
  assert (Oab : on_segment a b x) by (rewrite Ex; apply segment_in; try apply at_on; lra).
  assert (Ocd : on_segment c d x) by (rewrite Ex; apply segment_in; auto; lra).
  destruct (Kab x Oab) as [F|(r & R & L)]; [tauto|].
  destruct (Kcd x Ocd) as [F|(r' & R' & L')]; [tauto|].
  destruct (left_close a b x (Rmin r r')) as (y & Y & Oy); auto.
  { apply segment_range in Oab. tauto. } { apply Rmin_glb_lt; auto. }
  apply near_min in Y. destruct Y as [Y Y'].
  assert (Cy : C i y) by (apply (L y Y), Oy). destruct (L' y Y') as (Left & Right).
  cbn [fst snd] in Left, Right. rewrite Ok in Left, Right.
  destruct (Rtotal_order k 0) as [K|[K|K]]; [|contradiction|].
  - exfalso. apply Right; [nra|]. destruct (PC i Len) as (_ & _ & Sub & _). auto.
  - exists j, outer', holes', ring', (c, d). do 3 (split; auto). split; [apply Tog; auto; lra|].
    exists y. split; auto. apply Left. nra.
Qed.

(** Each ring of a polygon has the edges of a ring of the polygon of the same component. *)
Lemma ring_meets S ps qs C D i j outer holes outer' holes' ring : is_closed S -> is_form S ps ->
  is_form S qs -> parts S ps C -> parts S qs D -> nth_error ps i = Some (outer, holes) ->
  nth_error qs j = Some (outer', holes') -> (forall x, C i x <-> D j x) ->
  In ring (outer :: holes) -> exists ring', In ring' (outer' :: holes') /\
    forall e, In e (ring_edges ring) <-> In e (ring_edges ring').
Proof.
  intros Cl FP FQ PC PD N N' Same I.
  assert (E : exists e, In e (ring_edges ring)).
  { assert (A : area ring <> 0).
    { destruct PC as (_ & _ & H). destruct (H i _ _ N) as (A & B & _).
      destruct I as [<-|I]; [lra|]. specialize (B ring I). lra. }
    destruct (ring_edges ring) as [|e E] eqn:Q; [|exists e; simpl; auto].
    destruct A. unfold area. rewrite Q. reflexivity. }
  destruct E as (e & Ie).
  destruct (runs S ps qs C D i outer holes ring e Cl FP FQ PC PD N I Ie) as
    (k & o & h & ring' & f & Nk & Ik & If & T & x & Cx & Dx).
  assert (Lj : (j < length qs)%nat) by (apply nth_error_Some; congruence).
  assert (Lk : (k < length qs)%nat) by (apply nth_error_Some; congruence).
  assert (Li : (i < length ps)%nat) by (apply nth_error_Some; congruence).
  assert (j = k).
  { destruct PD as ((_ & Dj) & _ & _). destruct (Dj j Lj) as (_ & _ & _ & Dis).
    apply (Dis k x); auto. apply Same, Cx. }
  subst k. rewrite N' in Nk. injection Nk; intros; subst o h. exists ring'. split; auto.
  destruct PC as (_ & Pt & HC). destruct PD as (_ & _ & HD).
  apply (edges_shared S (C i) (form_edges ps) ring ring' e f); auto.
  - apply (HC i _ _ N); auto.
  - apply (bounds_same S (D j)); [intros y; symmetry; apply Same|]. apply (HD j _ _ N'); auto.
Qed.
