(** Between two pieces that come in at v with a component on their left, counter-clockwise, one
    leaves v. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Fans Curves Unions Local Across
  Overlaps Components OneForm Paths Decomposed Gaps Unique Beside Leaving Next.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier
  Slabbed Cells Coloured Turns.
Open Scope R_scope.

Section Around.
Variable C : point -> Prop.
Hypothesis C_open : forall x, C x -> interior C x.
Variable E : list edge.
Variable few : list point.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis sided : forall e x, In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Hypothesis steady_off : forall x, ~ over_some E x -> ~ In x few -> steady C x.
Variable v : point.
Hypothesis v_end : forall e, In e E -> ~ inside e v.

(** More than half a turn, or just that: over a point between *)
Lemma turn_over y w z k : 0 < orient v y w -> 0 < orient v w z -> ahead v y z ->
  ~ 0 < orient v y z ->
  (0 < orient v y k /\ 0 < orient v k w) \/ (0 < orient v w k /\ 0 < orient v k z) ->
  between v y k z.
Proof.
  intros Yw Wz A N [[K1 K2]|[K1 K2]]; unfold between.
  - left. split; auto. destruct (Req_dec (orient v y z) 0) as [Z|Z]; [|right; lra].
    left. destruct A as [A|(l & L & ->)]; [contradiction|].
    assert (Q : orient v k (at_ v y (- l)) = l * orient v y k)
      by (unfold orient, at_; cbn [fst snd]; ring). rewrite Q. nra.
  - destruct (Rlt_dec 0 (orient v y k)) as [P|P]; [left; auto|]. right. split; [lra|]. split; auto.
    destruct A as [A|(l & L & ->)]; [lra|]. exfalso.
    assert (Q : orient v k (at_ v y (- l)) = l * orient v y k)
      by (unfold orient, at_; cbn [fst snd]; ring). rewrite Q in K2. nra.
Qed.
Lemma over_point r y z : 0 < r -> near r v y -> near r v z -> y <> v -> ahead v y z ->
  ~ 0 < orient v y z -> exists w, near r v w /\ 0 < orient v y w /\ 0 < orient v w z.
Proof.
  intros R Y Z Nv A N. destruct Y as [Y1 Y2], Z as [Z1 Z2].
  apply Rabs_def2 in Y1, Y2, Z1, Z2.
  destruct (Req_dec (orient v y z) 0) as [O|O].
  - destruct A as [A|(l & L & ->)]; [contradiction|].
    pose proof (edge_long v y (not_eq_sym Nv)) as D. cbv zeta in D.
    exists (fst v - (snd y - snd v), snd v + (fst y - fst v)). split; [|split].
    + split; cbn [fst snd]; apply Rabs_def1; lra.
    + unfold orient; cbn [fst snd]. lra.
    + unfold orient, at_; cbn [fst snd]. nra.
  - exists (fst v - (fst y - fst v + (fst z - fst v)) / 2,
      snd v - (snd y - snd v + (snd z - snd v)) / 2).
    split; [split; cbn [fst snd]; apply Rabs_def1; lra|].
    unfold orient in *; cbn [fst snd]. split; lra.
Qed.
Theorem met_around r y z : close E few v r -> near r v y -> near r v z -> ahead v y z ->
  ~ over_some E y -> ~ over_some E z -> ~ C y -> C z ->
  exists e, In e E /\ start e = v /\ between v y (finish e) z.
Proof.
  intros Cl Y Z A Ny Nz Cy Cz. destruct (Rlt_dec 0 (orient v y z)) as [T|T].
  - destruct (met_turning C C_open E few long sided steady_off v r y z) as (e & I & S & K1 & K2);
      auto. exists e. split; auto. split; auto. left. auto.
  - assert (Nv : y <> v).
    { intros ->. destruct A as [A|(l & L & ->)]; [apply A; unfold orient; ring|].
      apply Cy. replace (at_ v v (- l)) with v in Cz; auto. unfold at_. destruct v; cbn [fst snd].
      f_equal; ring. }
    destruct (over_point r y z) as (w0 & W0 & O1 & O2); auto; [apply Cl|].
    destruct (near_within v w0 r W0) as (s1 & S1 & K1).
    destruct (near_left v y w0 O1) as (s2 & S2 & K2).
    assert (O2' : 0 < orient z v w0) by (unfold orient in *; lra).
    destruct (near_left z v w0 O2') as (s3 & S3 & K3).
    destruct (aside_near E long w0 (Rmin s1 (Rmin s2 s3))) as (w & W & Nw & _);
      [repeat apply Rmin_glb_lt; auto|].
    apply near_min in W. destruct W as [W1 W]. apply near_min in W. destruct W as [W2 W3].
    specialize (K1 w W1). specialize (K2 w W2). specialize (K3 w W3).
    assert (K3' : 0 < orient v w z) by (unfold orient in *; lra).
    destruct (classic (C w)) as [Cw|Cw].
    + destruct (met_turning C C_open E few long sided steady_off v r y w) as (e & I & S & P1 & P2);
        auto. exists e. split; auto. split; auto. apply (turn_over y w z); auto.
    + destruct (met_turning C C_open E few long sided steady_off v r w z) as (e & I & S & P1 & P2);
        auto. exists e. split; auto. split; auto. apply (turn_over y w z); auto.
Qed.

(** Points beside a piece that comes in *)
Lemma on_piece e r : In e E -> finish e = v -> 0 < r ->
  exists t, 0 < t /\ near r v (at_ v (start e) t) /\ inside e (at_ v (start e) t).
Proof.
  intros I F R. destruct (at_near v (start e) 0 r R) as (d & D & K). rewrite at_0 in K.
  set (t := Rmin (1 / 2) (d / 2)). assert (T : 0 < t <= 1 / 2 /\ t < d).
  { unfold t. pose proof (Rmin_l (1 / 2) (d / 2)). pose proof (Rmin_r (1 / 2) (d / 2)).
    assert (0 < Rmin (1 / 2) (d / 2)) by (apply Rmin_glb_lt; lra). lra. }
  exists t. split; [tauto|]. split; [apply K; rewrite Rminus_0_r, Rabs_right; lra|].
  exists (1 - t). split; [lra|]. rewrite F. unfold at_; cbn [fst snd]. f_equal; ring.
Qed.
Lemma right_of e p r : In e E -> inside e p -> 0 < r -> exists y, near r p y /\
  orient (start e) (finish e) y < 0 /\ ~ over_some E y /\ ~ C y.
Proof.
  intros I P R. destruct (sided e p I P) as (s & Hs & K).
  destruct (right_close (start e) (finish e) p (Rmin r s)) as (x & X & O); auto.
  { apply inner_on_line, P. } { apply Rmin_glb_lt; auto. }
  destruct (near_within p x _ X) as (t & T & L). destruct (near_right _ _ _ O) as (u & U & M).
  destruct (aside_near E long x (Rmin t u)) as (y & Y & N & _); [apply Rmin_glb_lt; auto|].
  apply near_min in Y. destruct Y as [Y1 Y2]. pose proof (L y Y1) as Py. apply near_min in Py.
  exists y. specialize (M y Y2). split; [tauto|]. split; auto. split; auto.
  apply (K y); tauto.
Qed.
Lemma left_of_it e p r : In e E -> inside e p -> 0 < r -> exists y, near r p y /\
  0 < orient (start e) (finish e) y /\ ~ over_some E y /\ C y.
Proof.
  intros I P R. destruct (sided e p I P) as (s & Hs & K).
  destruct (left_close (start e) (finish e) p (Rmin r s)) as (x & X & O); auto.
  { apply inner_on_line, P. } { apply Rmin_glb_lt; auto. }
  destruct (near_within p x _ X) as (t & T & L). destruct (near_left _ _ _ O) as (u & U & M).
  destruct (aside_near E long x (Rmin t u)) as (y & Y & N & _); [apply Rmin_glb_lt; auto|].
  apply near_min in Y. destruct Y as [Y1 Y2]. pose proof (L y Y1) as Py. apply near_min in Py.
  exists y. specialize (M y Y2). split; [tauto|]. split; auto. split; auto.
  apply (K y); tauto.
Qed.
Lemma turned (a b : point) (t : R) : orient v a (at_ v b t) = t * orient v a b /\
  orient v (at_ v b t) a = t * orient v b a /\ orient a v b = - orient v a b.
Proof. unfold orient, at_; cbn [fst snd]. repeat split; ring. Qed.
(** The signs of a finite number of turns hold near a point. *)
Lemma signs_near (l : list (point * point)) x : exists r, 0 < r /\ forall y, near r x y ->
  forall a b, In (a, b) l -> (0 < orient a b x -> 0 < orient a b y) /\
    (orient a b x < 0 -> orient a b y < 0).
Proof.
  induction l as [|[a b] l (r & R & K)]; [exists 1; split; [lra|]; intros y _ a b []|].
  assert (H : exists s, 0 < s /\ forall y, near s x y -> (0 < orient a b x -> 0 < orient a b y) /\
    (orient a b x < 0 -> orient a b y < 0)).
  { destruct (Rtotal_order (orient a b x) 0) as [O|[O|O]].
    - destruct (near_right a b x O) as (s & Hs & L). exists s. split; auto. intros y Y.
      specialize (L y Y). split; auto. lra.
    - exists 1. split; [lra|]. intros. lra.
    - destruct (near_left a b x O) as (s & Hs & L). exists s. split; auto. intros y Y.
      specialize (L y Y). split; auto. lra. }
  destruct H as (s & Hs & L). exists (Rmin r s). split; [apply Rmin_glb_lt; auto|].
  intros y Y c d [Q|I]; apply near_min in Y.
  - injection Q; intros <- <-. apply L. tauto.
  - apply (K y); tauto.
Qed.

(** One leaves where one comes in. *)
Theorem some_leaves e : In e E -> finish e = v -> exists h, In h E /\ start h = v.
Proof.
  intros I F. destruct (some_close E few v v_end) as (r & Cl).
  destruct (on_piece e r I F (proj1 Cl)) as (t & T & Np & Ip).
  set (p := at_ v (start e) t) in *. destruct (near_within v p r Np) as (s & Hs & K).
  destruct (right_of e p s I Ip Hs) as (y & Y & Oy & Ny & Cy). rewrite F in Oy.
  destruct (signs_near [(v, y)] p) as (s' & Hs' & K').
  destruct (left_of_it e p (Rmin s s') I Ip) as (z & Z & Oz & Nz & Cz); [apply Rmin_glb_lt; auto|].
  apply near_min in Z. destruct Z as [Z1 Z2].
  assert (A : orient v y z < 0).
  { apply (K' z Z2 v y); [simpl; auto|]. unfold p. rewrite (proj1 (turned y (start e) t)).
    assert (orient v y (start e) < 0) by (unfold orient in *; lra). nra. }
  destruct (met_around r y z) as (h & Ih & Sh & _); auto; [left; lra|]. eauto.
Qed.

(** And between two that come in, counter-clockwise *)
Theorem leaves_between e f : In e E -> In f E -> finish e = v -> finish f = v ->
  ~ same_way v (start e) (start f) ->
  exists h, In h E /\ start h = v /\ between v (start e) (finish h) (start f).
Proof.
  intros Ie If Fe Ff Nw. destruct (some_close E few v v_end) as (r & Cl).
  set (a := start e) in *. set (b := start f) in *.
  assert (Na : a <> v) by (rewrite <- Fe; apply long, Ie).
  assert (Nb : b <> v) by (rewrite <- Ff; apply long, If).
  destruct (on_piece e r Ie Fe (proj1 Cl)) as (t & T & Np & Ip). fold a in Np, Ip.
  set (p := at_ v a t) in *. destruct (near_within v p r Np) as (s & Hs & K).
  destruct (signs_near [(v, b)] p) as (s' & Hs' & K').
  destruct (right_of e p (Rmin s s') Ie Ip) as (y & Y & Oy & Ny & Cy); [apply Rmin_glb_lt; auto|].
  apply near_min in Y. destruct Y as [Y1 Y2]. specialize (K y Y1).
  destruct (K' y Y2 v b (or_introl eq_refl)) as [Bp Bm].
  destruct (on_piece f r If Ff (proj1 Cl)) as (u & U & Nq & Iq). fold b in Nq, Iq.
  set (q := at_ v b u) in *. destruct (near_within v q r Nq) as (w & Hw & L).
  destruct (signs_near [(v, a); (v, y)] q) as (w' & Hw' & L').
  destruct (left_of_it f q (Rmin w w') If Iq) as (z & Z & Oz & Nz & Cz); [apply Rmin_glb_lt; auto|].
  apply near_min in Z. destruct Z as [Z1 Z2]. specialize (L z Z1).
  destruct (L' z Z2 v a (or_introl eq_refl)) as [Ap Am].
  destruct (L' z Z2 v y (or_intror (or_introl eq_refl))) as [Yp Ym].
  unfold p in Bp, Bm. rewrite (proj1 (turned b a t)) in Bp, Bm.
  unfold q in Ap, Am, Yp, Ym. rewrite (proj1 (turned a b u)) in Ap, Am.
  rewrite (proj1 (turned y b u)) in Yp, Ym.
  rewrite Fe in Oy. rewrite Ff in Oz. fold a in Oy. fold b in Oz.
  assert (Ay : 0 < orient v a y) by (unfold orient in *; lra).
  assert (Zb : 0 < orient v z b) by (unfold orient in *; lra).
  assert (Ba : orient v b a = - orient v a b) by (unfold orient; ring).
  assert (By : orient v b y = - orient v y b) by (unfold orient; ring).
  rewrite Ba, By in *.
  assert (Pl : forall k, orient v a k * orient v y z =
    orient v a y * orient v k z + orient v a z * orient v y k) by (intros; unfold orient; ring).
  assert (Case : 0 < orient v a b \/ orient v a b < 0 \/ (orient v a b = 0 /\ ahead v a b)).
  { destruct (Rtotal_order (orient v a b) 0) as [O|[O|O]]; auto. right; right. split; auto. right.
    destruct (on_line v a b) as (m & Em); auto.
    destruct (Rtotal_order m 0) as [M|[M|M]].
    - exists (- m). split; [lra|]. rewrite Ropp_involutive. exact Em.
    - exfalso. apply Nb. rewrite Em, M. apply at_0.
    - exfalso. apply Nw. exists m. auto. }
  assert (Less : 0 < orient v a z -> 0 < orient v y b -> exists h, In h E /\ start h = v /\
    between v a (finish h) b).
  { intros Az Yb. assert (Yz : 0 < orient v y z) by (apply Yp, Rmult_lt_0_compat; auto).
    destruct (met_turning C C_open E few long sided steady_off v r y z) as (h & Ih & Sh & K1 & K2);
      auto. exists h. split; auto. split; auto. set (k := finish h) in *. left.
    pose proof (Pl k) as Q1.
    assert (Q2 : orient v k b * orient v y z = orient v y b * orient v k z +
      orient v z b * orient v y k) by (unfold orient; ring).
    assert (P1 : 0 < orient v a y * orient v k z) by (apply Rmult_lt_0_compat; auto).
    assert (P2 : 0 < orient v a z * orient v y k) by (apply Rmult_lt_0_compat; auto).
    assert (P3 : 0 < orient v y b * orient v k z) by (apply Rmult_lt_0_compat; auto).
    assert (P4 : 0 < orient v z b * orient v y k) by (apply Rmult_lt_0_compat; auto).
    split; [|left]; apply (Rmult_lt_reg_r (orient v y z)); lra. }
  destruct Case as [O|[O|[O A]]].
  - apply Less; [apply Ap, Rmult_lt_0_compat; auto|].
    assert (- orient v y b < 0); [apply Bm; clear - O T; nra|lra].
  - assert (Az : orient v a z < 0) by (apply Am; clear - O U; nra).
    assert (Yb : orient v y b < 0) by (assert (0 < - orient v y b);
      [apply Bp; clear - O T; nra|lra]).
    assert (Yz : orient v y z < 0) by (apply Ym; clear - Yb U; nra).
    destruct (met_around r y z) as (h & Ih & Sh & B); auto; [left; lra|].
    exists h. split; auto. split; auto. set (k := finish h) in *.
    assert (G : 0 < orient v a k \/ 0 < orient v k b).
    { apply NNPP. intros N. assert (N1 : orient v a k <= 0) by lra.
      assert (N2 : orient v k b <= 0) by lra.
      assert (Q1 : orient v y k * orient v a b = orient v y b * orient v a k
        - orient v a y * orient v k b) by (unfold orient; ring).
      assert (Q2 : orient v k z * orient v a b = orient v a z * orient v k b
        + orient v z b * - orient v a k) by (unfold orient; ring).
      assert (P1 : 0 <= orient v y b * orient v a k) by (clear - Yb N1; nra).
      assert (P2 : orient v a y * orient v k b <= 0) by (clear - Ay N2; nra).
      assert (P3 : 0 <= orient v a z * orient v k b) by (clear - Az N2; nra).
      assert (P4 : 0 <= orient v z b * - orient v a k) by (clear - Zb N1; nra).
      assert (H1 : orient v y k <= 0) by (clear - O Q1 P1 P2; nra).
      assert (H2 : orient v k z <= 0) by (clear - O Q2 P3 P4; nra).
      destruct B as [[B1 _]|(_ & _ & B3)]; lra. }
    unfold between. destruct (Rlt_dec 0 (orient v a k)); [left; auto|]. right. lra.
  - destruct A as [A|(l & Hl & Eb)]; [contradiction|].
    assert (Q1 : orient v z b = l * orient v a z)
      by (rewrite Eb; unfold orient, at_; cbn [fst snd]; ring).
    assert (Q2 : orient v y b = l * orient v a y)
      by (rewrite Eb; unfold orient, at_; cbn [fst snd]; ring).
    apply Less; [clear - Q1 Zb Hl; nra|]. rewrite Q2. apply Rmult_lt_0_compat; auto.
Qed.
End Around.
