(** Edges between cells do not overlap, and the rings that they make pass no point twice. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Figures
  Rational Cancellation Bodies Components Classes Across Sides.
Open Scope R_scope.

Lemma on_segment_decided a b x : on_segment a b x \/ ~ on_segment a b x.
Proof.
  assert (Z : on_segment a b x -> orient a b x = 0 /\
    (fst a <= fst x <= fst b \/ fst b <= fst x <= fst a) /\
    (snd a <= snd x <= snd b \/ snd b <= snd x <= snd a)).
  { intros (t & T & ->). cbn [fst snd]. split; [unfold orient; simpl; ring|]. split.
    - destruct (Rle_dec (fst a) (fst b)); [left|right]; nra.
    - destruct (Rle_dec (snd a) (snd b)); [left|right]; nra. }
  destruct (Req_EM_T (orient a b x) 0) as [O|O]; [|right; tauto].
  destruct (Rle_dec (fst a) (fst x)), (Rle_dec (fst x) (fst b)), (Rle_dec (fst b) (fst x)),
    (Rle_dec (fst x) (fst a)), (Rle_dec (snd a) (snd x)), (Rle_dec (snd x) (snd b)),
    (Rle_dec (snd b) (snd x)), (Rle_dec (snd x) (snd a));
    first [left; apply segment_by_orient; tauto | right; tauto].
Qed.
Lemma same_point_decided (x y : point) : x = y \/ x <> y.
Proof.
  destruct x as [x1 x2], y as [y1 y2].
  destruct (Req_EM_T x1 y1) as [->|N]; [destruct (Req_EM_T x2 y2) as [->|N]; [left; auto|]|];
    right; intros Q; injection Q; intros; contradiction.
Qed.
Lemma inner_of_segment a b x : on_segment a b x -> x <> a -> x <> b -> inner a b x.
Proof.
  intros (t & T & E) A B. exists t. split; auto. split.
  - destruct (Req_dec t 0) as [->|]; [|lra]. destruct A. rewrite E.
    destruct a; simpl; f_equal; ring.
  - destruct (Req_dec t 1) as [->|]; [|lra]. destruct B. rewrite E.
    destruct b; simpl; f_equal; ring.
Qed.
Lemma segment_in_segment a b x y w : on_segment a b x -> on_segment a b y -> inner x y w ->
  on_segment a b w.
Proof.
  intros (s & S & ->) (t & T & ->) (u & U & ->). exists (s + u * (t - s)). split; [nra|].
  cbn [fst snd]. f_equal; ring.
Qed.
Lemma orient_start a b : orient a b a = 0.
Proof. unfold orient; ring. Qed.
Lemma row_weaken (C D S : point -> Prop) a b u l : (forall x, C x -> D x) -> row C S a b u l ->
  row D S a b u l.
Proof.
  intros H K. induction K as [|u v l (P1 & P2 & P3) K IH]; [apply row_end|].
  apply row_stretch; auto. split; [auto|split; [auto|]]. intros x X.
  destruct (P3 x X) as (r & Hr & G). exists r. split; auto. intros y Y.
  destruct (G y Y). auto.
Qed.

Section Sided.
Variable S : point -> Prop.
Definition is_row (e : point * point) (l : list point) : Prop :=
  row S S (fst e) (snd e) (fst e) l.
Definition is_sided (e : point * point) (x : point) : Prop := sided S S (fst e) (snd e) x.
Definition apart (e f : point * point) : Prop := forall x y, on_segment (fst e) (snd e) x ->
  on_segment (fst e) (snd e) y -> on_segment (fst f) (snd f) x ->
  on_segment (fst f) (snd f) y -> x = y.

(** Two edges through x with S on the left alone have the same direction. *)
Lemma same_way a b c d x z : sided S S a b x -> sided S S c d x -> orient a b x = 0 ->
  orient c d x = 0 -> c <> d -> along (minus b a) z < 0 -> along (minus d c) z < 0.
Proof.
  intros (r & Hr & K) (s & Hs & L) A B N Z.
  assert (G : forall z, along (minus b a) z < 0 -> along (minus d c) z <= 0).
  { clear z Z. intros z Z. destruct (Rle_dec (along (minus d c) z) 0) as [|P]; auto. exfalso.
    destruct (small_step x z (Rmin r s)) as (t & T & C); [apply Rmin_glb_lt; auto|].
    specialize (C t). rewrite Rabs_right in C by lra. specialize (C (Rle_refl t)).
    apply near_min in C. destruct C as [C1 C2].
    apply (proj2 (K _ C1)); [rewrite orient_shifted, A; nra|].
    apply (proj1 (L _ C2)). rewrite orient_shifted, B. nra. }
  pose proof (G z Z) as Le. destruct (Req_dec (along (minus d c) z) 0) as [E|]; [|lra]. exfalso.
  set (D := minus d c) in *. set (n := (- snd D, fst D)).
  assert (P : 0 < dot D D) by (apply square_positive; intros Q; apply N, minus_none, Q).
  set (h := - along (minus b a) z / (2 * (1 + Rabs (along (minus b a) n)))).
  pose proof (Rabs_pos (along (minus b a) n)).
  assert (H1 : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; lra).
  assert (H2 : h * (2 * (1 + Rabs (along (minus b a) n))) = - along (minus b a) z)
    by (unfold h; field; lra).
  specialize (G (shifted z n h)).
  replace (along (minus b a) (shifted z n h))
    with (along (minus b a) z + h * along (minus b a) n) in G
    by (unfold along, shifted; simpl; ring).
  replace (along D (shifted z n h)) with (along D z + h * dot D D) in G
    by (unfold along, shifted, n, dot; simpl; ring).
  pose proof (Rle_abs (along (minus b a) n)).
  assert (h * dot D D <= 0); [|nra]. rewrite E in G. rewrite Rplus_0_l in G. apply G. nra.
Qed.

Section Edges.
Variable E : list (point * point).
Hypothesis closed : Permutation (map fst E) (map snd E).
Hypothesis rows : forall e, In e E -> exists l, is_row e l.
Hypothesis no_null : forall e, In e E -> fst e <> snd e.
Hypothesis once : forall y, (0 <= winding E y <= 1)%Z.

Lemma sided_but_few : exists L : list point, forall e, In e E -> forall x,
  on_segment (fst e) (snd e) x -> In x L \/ (inner (fst e) (snd e) x /\ is_sided e x).
Proof.
  clear closed no_null once. induction E as [|e F IH]; [exists []; intros e []|].
  destruct IH as (L & K); [intros; apply rows; simpl; auto|].
  destruct (rows e (or_introl eq_refl)) as (l & R). exists (fst e :: l ++ L).
  intros f [<-|I] x X.
  - destruct (row_cover _ _ _ _ _ _ R (orient_start _ _) x X) as [->|(p & v & I & P & _ & _ & Q)];
      [simpl; auto|].
    destruct (same_point_decided x (fst e)) as [->|A]; [simpl; auto|].
    destruct Q as [->|[Q B]]; [left; right; apply in_or_app; auto|right]. split.
    + apply inner_of_segment; auto.
    + apply P, Q.
  - destruct (K f I x X) as [J|J]; auto. left. right. apply in_or_app. auto.
Qed.

Theorem edges_apart l e m f k : E = l ++ e :: m ++ f :: k -> apart e f.
Proof.
  intros EE x y Xe Ye Xf Yf.
  assert (D : x = y \/ x <> y) by apply same_point_decided.
  destruct D as [D|D]; auto. exfalso.
  destruct sided_but_few as (L & K). destruct (one_not_in L x y D) as (w & W & N).
  assert (Ie : In e E) by (rewrite EE; apply in_or_app; simpl; auto).
  assert (If : In f E).
  { rewrite EE. apply in_or_app. right. right. apply in_or_app. simpl. auto. }
  assert (G : forall g, In g E -> ~ on_segment (fst g) (snd g) w \/ inner (fst g) (snd g) w).
  { intros g I. destruct (on_segment_decided (fst g) (snd g) w) as [O|O]; auto.
    right. destruct (K g I w O) as [J|[J _]]; [contradiction|auto]. }
  assert (Sd : forall g, In g E -> inner (fst g) (snd g) w -> is_sided g w).
  { intros g I J. destruct (K g I w (inner_on_segment _ _ _ J)) as [Q|[_ Q]];
      [contradiction|auto]. }
  destruct (held_exists w E G) as (H & HH).
  destruct (K e Ie w (segment_in_segment _ _ x y w Xe Ye W)) as [J|[We Se]]; [contradiction|].
  destruct (K f If w (segment_in_segment _ _ x y w Xf Yf W)) as [J|[Wf _]]; [contradiction|].
  assert (Two : (2 <= length H)%nat).
  { rewrite EE in HH. exact (held_two w l e m f k H HH We Wf). }
  destruct (winding_across E H w closed HH) as (r & n & Hr & Wn).
  set (d := minus (snd e) (fst e)). set (z := (snd d, - fst d)).
  assert (P : 0 < dot d d).
  { apply square_positive. intros Q. apply (no_null e Ie), minus_none, Q. }
  assert (Z : along d z < 0).
  { replace (along d z) with (- dot d d) by (unfold along, z, dot; cbn [fst snd]; ring). lra. }
  assert (All : forall g, In g H -> orient (fst g) (snd g) w = 0 /\
    along (minus (snd g) (fst g)) z < 0).
  { intros g I. destruct (held_in w E H HH g I) as [J Q].
    pose proof (inner_on_line _ _ _ Q) as Og. split; auto.
    apply (same_way (fst e) (snd e) (fst g) (snd g) w z); auto.
    - apply Sd; auto.
    - apply inner_on_line, We. }
  destruct (small_step w z r Hr) as (t & T & Near).
  pose proof (Near t) as N1. pose proof (Near (- t)) as N2.
  rewrite Rabs_Ropp in N2. rewrite Rabs_right in N1, N2 by lra.
  assert (Or : forall g u, In g H -> orient (fst g) (snd g) (shifted w z u)
    = u * along (minus (snd g) (fst g)) z).
  { intros g u I. rewrite orient_shifted, (proj1 (All g I)). ring. }
  assert (W1 : winding E (shifted w z t) = n).
  { rewrite Wn; [|apply N1; lra|].
    - replace (sumz _ H) with 0%Z; [lia|]. symmetry.
      transitivity (sumz (fun _ : point * point => 0%Z) H).
      + apply sumz_ext. intros g I. unfold is_left_of. rewrite Or by auto.
        pose proof (proj2 (All g I)). destruct (Rlt_dec 0 _); auto. exfalso. nra.
      + clear. induction H; simpl; auto.
    - intros g I. rewrite Or by auto. pose proof (proj2 (All g I)). nra. }
  assert (W2 : winding E (shifted w z (- t)) = (n + Z.of_nat (length H))%Z).
  { rewrite Wn; [|apply N2; lra|].
    - f_equal. transitivity (sumz (fun _ : point * point => 1%Z) H).
      + apply sumz_ext. intros g I. unfold is_left_of. rewrite Or by auto.
        pose proof (proj2 (All g I)) as A. destruct (Rlt_dec 0 _) as [|Q]; auto. exfalso.
        apply Q. replace (- t * _) with (t * - along (minus (snd g) (fst g)) z) by ring.
        apply Rmult_lt_0_compat; lra.
      + clear. induction H as [|g H IH]; [reflexivity|].
        change (sumz _ (g :: H)) with (1 + sumz (fun _ : point * point => 1%Z) H)%Z.
        rewrite IH. cbn [length]. lia.
    - intros g I. rewrite Or by auto. pose proof (proj2 (All g I)). nra. }
  pose proof (once (shifted w z t)). pose proof (once (shifted w z (- t))). lia.
Qed.
End Edges.

(** ** A ring passes no point twice. *)
Lemma stretches_apart e f p v x : apart e f -> fst e <> snd e -> fst f <> snd f ->
  on_segment (fst e) (snd e) x -> x <> fst e ->
  on_stretch S S (fst e) (snd e) p v -> orient (fst e) (snd e) p = 0 -> x <> p ->
  (x = v \/ inner p v x) -> inner (fst f) (snd f) x -> is_sided f x -> False.
Proof.
  intros Ap Ne Nf Xe Xa P Op Xp Xv Xf (r & Hr & Sf).
  set (d := minus (snd e) (fst e)). set (g := minus (snd f) (fst f)).
  assert (D : d <> (0, 0)) by (intros Q; apply Ne, minus_none, Q).
  assert (G : g <> (0, 0)) by (intros Q; apply Nf, minus_none, Q).
  pose proof (square_positive d D) as PD. pose proof (square_positive g G) as PG.
  (* x along the stretch, and along e *)
  destruct (stretch_step S S _ _ p v Op P) as (s & Hs & Ev). fold d in Ev.
  assert (Ek : exists k, 0 < k <= s /\ x = shifted p d k).
  { destruct Xv as [->|(t & T & Ex)]; [exists s; split; [lra|exact Ev]|].
    exists (t * s). split; [nra|]. rewrite Ex, Ev. unfold shifted; simpl. f_equal; ring. }
  destruct Ek as (k & Hk & Ex).
  assert (Em : exists m, 0 < m <= 1 /\ x = shifted (fst e) d m).
  { destruct Xe as (m & M & Q). exists m. split; [|exact Q]. split; [|lra].
    destruct (Req_dec m 0) as [Z|]; [|lra]. destruct Xa. rewrite Q, Z.
    destruct (fst e); simpl; f_equal; ring. }
  destruct Em as (m & Hm & Exm).
  assert (On : orient (fst f) (snd f) x = 0) by (apply inner_on_line, Xf).
  (* w a little back along e *)
  set (w := fun t => shifted x d (- t)).
  assert (W1 : soon (fun t => near (r / 2) x (w t))).
  { destruct (small_step x d (r / 2)) as (t0 & T0 & N); [lra|]. exists t0. split; auto.
    intros t T. apply N. rewrite Rabs_Ropp, Rabs_right; lra. }
  assert (W2 : soon (fun t => inner p v (w t))).
  { exists k. split; [lra|]. intros t T. exists ((k - t) / s). split.
    - split; [apply Rdiv_lt_0_compat; lra|]. apply Rmult_lt_reg_r with s; [lra|].
      unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    - unfold w. rewrite Ex, Ev. unfold shifted; simpl. f_equal; field; lra. }
  assert (W3 : soon (fun t => on_segment (fst e) (snd e) (w t))).
  { exists m. split; [lra|]. intros t T. exists (m - t). split; [lra|].
    unfold w. rewrite Exm. unfold shifted, d, minus; simpl. f_equal; ring. }
  assert (Ow : forall t, orient (fst f) (snd f) (w t) = - t * along g d)
    by (intros t; unfold w; rewrite orient_shifted, On; fold g; ring).
  assert (Oe : forall t, orient (fst e) (snd e) (w t) = 0).
  { intros t. unfold w. rewrite Exm, shifted_twice, orient_shifted, orient_start.
    fold d. unfold along. ring. }
  destruct (Rtotal_order (along g d) 0) as [K|[K|K]].
  - destruct (soon_exists _ (soon_and _ _ W1 W2)) as (t & T & N & I).
    destruct P as (_ & _ & P). destruct (P _ I) as (q & Hq & Sq).
    destruct (near_left (fst f) (snd f) (w t)) as (u & Hu & Lf); [rewrite Ow; nra|].
    destruct (right_close (fst e) (snd e) (w t) (Rmin q (Rmin u (r / 2)))) as (y & Y & R); auto.
    { repeat apply Rmin_glb_lt; lra. }
    apply near_min in Y. destruct Y as [Y1 Y]. apply near_min in Y. destruct Y as [Y2 Y3].
    apply (proj2 (Sq y Y1) R). apply (proj1 (Sf y (near_near r x (w t) y N Y3))), Lf, Y2.
  - (* along f: two common points *)
    destruct Xf as (h & H & Exf). change (x = shifted (fst f) g h) in Exf.
    set (c := dot d g / dot g g).
    assert (Dc : d = (c * fst g, c * snd g)).
    { assert (Cg : c * dot g g = dot d g) by (unfold c; field; lra).
      unfold along, dot in *. destruct d as [d1 d2], g as [g1 g2]; simpl in *.
      f_equal; apply Rmult_eq_reg_r with (g1 * g1 + g2 * g2); try lra; apply Rminus_diag_uniq.
      - replace (d1 * (g1 * g1 + g2 * g2) - c * g1 * (g1 * g1 + g2 * g2))
          with (- g2 * (g1 * d2 - g2 * d1) + g1 * (d1 * g1 + d2 * g2 - c * (g1 * g1 + g2 * g2)))
          by ring. rewrite K, Cg. ring.
      - replace (d2 * (g1 * g1 + g2 * g2) - c * g2 * (g1 * g1 + g2 * g2))
          with (g1 * (g1 * d2 - g2 * d1) + g2 * (d1 * g1 + d2 * g2 - c * (g1 * g1 + g2 * g2)))
          by ring. rewrite K, Cg. ring. }
    assert (W4 : soon (fun t => on_segment (fst f) (snd f) (w t))).
    { pose proof (Rabs_pos c). pose proof (Rle_abs c). pose proof (Rle_abs (- c)) as C.
      rewrite Rabs_Ropp in C.
      exists (Rmin h (1 - h) / (1 + Rabs c)). pose proof (Rmin_l h (1 - h)).
      pose proof (Rmin_r h (1 - h)).
      assert (0 < Rmin h (1 - h)) by (apply Rmin_glb_lt; lra).
      split; [apply Rdiv_lt_0_compat; lra|]. intros t T.
      assert (Tc : t * (1 + Rabs c) < Rmin h (1 - h)).
      { destruct T as [_ T]. apply Rmult_lt_compat_r with (r := 1 + Rabs c) in T; [|lra].
        unfold Rdiv in T. rewrite Rmult_assoc, Rinv_l in T; lra. }
      exists (h - t * c). split; [nra|]. unfold w. rewrite Exf, Dc. unfold shifted; cbn [fst snd].
      fold g. unfold g, minus; cbn [fst snd]. f_equal; ring. }
    destruct (soon_exists _ (soon_and _ _ W3 W4)) as (t & T & A & B).
    assert (Q : x = w t).
    { apply Ap; auto. exists h. split; [lra|exact Exf]. }
    unfold w in Q. rewrite <- (shifted_none x d) in Q at 1. apply shifted_same in Q; auto. lra.
  - destruct (soon_exists _ (soon_and _ _ W1 W2)) as (t & T & N & I).
    destruct P as (_ & _ & P). destruct (P _ I) as (q & Hq & Sq).
    destruct (near_right (fst f) (snd f) (w t)) as (u & Hu & Rf); [rewrite Ow; nra|].
    destruct (left_close (fst e) (snd e) (w t) (Rmin q (Rmin u (r / 2)))) as (y & Y & L); auto.
    { repeat apply Rmin_glb_lt; lra. }
    apply near_min in Y. destruct Y as [Y1 Y]. apply near_min in Y. destruct Y as [Y2 Y3].
    apply (proj2 (Sf y (near_near r x (w t) y N Y3))); [apply Rf, Y2|]. apply (Sq y Y1), L.
Qed.

Lemma beyond_shared e f l k : apart e f -> fst e <> snd e -> fst f <> snd f -> is_row e l ->
  is_row f k -> forall x, beyond_start e x -> beyond_start f x -> In x l /\ In x k.
Proof.
  intros Ap Ne Nf Re Rf x [Xe Xa] [Xf Xc].
  destruct (row_cover _ _ _ _ _ _ Re (orient_start _ _) x Xe) as [|(p & v & Iv & P & Op & Xp & Cv)];
    [contradiction|].
  destruct (row_cover _ _ _ _ _ _ Rf (orient_start _ _) x Xf) as [|(q & u & Iu & Q & Oq & Xq & Cu)];
    [contradiction|].
  destruct Cu as [->|[Cu Bu]].
  - destruct Cv as [->|[Cv Bv]]; [auto|]. exfalso.
    apply (stretches_apart f e q u u); auto.
    + intros y z Y1 Z1 Y2 Z2. apply Ap; auto.
    + apply inner_of_segment; auto.
    + apply P, Cv.
  - exfalso. apply (stretches_apart e f p v x); auto.
    + tauto.
    + apply inner_of_segment; auto.
    + apply Q, Cu.
Qed.
Lemma beyond_apart e f l k : apart e f -> fst e <> snd e -> fst f <> snd f -> is_row e l ->
  is_row f k -> (forall v, In v l -> In v k -> False) ->
  forall x, beyond_start e x -> beyond_start f x -> False.
Proof.
  intros Ap Ne Nf Re Rf Dis x Xe Xf.
  destruct (beyond_shared e f l k Ap Ne Nf Re Rf x Xe Xf) as [L K]. exact (Dis x L K).
Qed.
End Sided.

(** ** Rings *)
Section Rings.
Variable S : point -> Prop.
Lemma rows_apart edges : forall lists, Forall2 (is_row S) edges lists -> NoDup (concat lists) ->
  (forall e, In e edges -> fst e <> snd e) -> ForallOrdPairs apart edges ->
  ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False) edges.
Proof.
  induction edges as [|e edges IH]; intros lists F N D A; [apply FOP_nil|].
  inversion F as [|? l ? rest Re Rest]; subst. simpl in N.
  inversion A as [|? ? Ae Ar]; subst.
  assert (Nr : NoDup (concat rest)).
  { clear - N. induction l as [|v l IH]; simpl in N; auto. inversion N; auto. }
  assert (Nl : forall v, In v l -> ~ In v (concat rest)).
  { clear - N. induction l as [|u l IH]; simpl in N |- *; [tauto|].
    inversion N as [|? ? N1 N2]; subst. intros v [<-|I] J.
    - apply N1, in_or_app. auto.
    - exact (IH N2 v I J). }
  apply FOP_cons.
  - apply Forall_forall. intros f I x Xe Xf. rewrite Forall_forall in Ae.
    assert (G : exists k, is_row S f k /\ forall v, In v k -> In v (concat rest)).
    { clear - Rest I. induction Rest as [|g k gs ks R Rest IH]; [destruct I|].
      destruct I as [<-|I].
      - exists k. split; auto. intros v J. simpl. apply in_or_app. auto.
      - destruct (IH I) as (k' & K1 & K2). exists k'. split; auto.
        intros v J. simpl. apply in_or_app. auto. }
    destruct G as (k & Rf & Sub).
    apply (beyond_apart S e f l k) with (x := x); auto.
    + apply D; simpl; auto.
    + apply D; simpl; auto.
    + intros v I1 I2. apply (Nl v I1), Sub, I2.
  - apply (IH rest); auto. intros f I. apply D. simpl; auto.
Qed.
End Rings.
