(** Convex hulls in space: means of their points, linear functions on them, cones from inside. *)
From Coq Require Import Lra Lia.
From Proved Require Import Definitions Space Rational Cones.
Open Scope R_scope.

Lemma real3_plus u v : real3 (plus3 u v) = add3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold plus3, real3, add3.
  rewrite !Q2R_red, !Q2R_plus. reflexivity.
Qed.
Lemma triples_equal (a b c d e f : R) : a = d -> b = e -> c = f -> (a, b, c) = (d, e, f).
Proof. congruence. Qed.
Ltac by_parts := unfold add3, scale3; apply triples_equal; ring.

Definition minus_3 (p q : point3) : point3 :=
  let '(a, b, c) := p in let '(d, e, f) := q in (a - d, b - e, c - f).

(** What has the weight t: t times a point of the hull *)
Definition weighs (vs : list vertex3) (t : R) (x : point3) : Prop := exists ws,
  length ws = length vs /\ (forall w, In w ws -> 0 <= w) /\ fold_right Rplus 0 ws = t /\
  x = mean ws (map real3 vs).
Lemma hull_weighs vs x : hull vs x <-> weighs vs 1 x.
Proof. reflexivity. Qed.
Lemma weighs_nothing vs : weighs vs 0 (0, 0, 0).
Proof.
  exists (map (fun _ => 0) vs). split; [apply map_length|split; [|split]].
  - intros w I. apply in_map_iff in I. destruct I as (_ & <- & _). lra.
  - induction vs; simpl; lra.
  - induction vs as [|v vs IH]; simpl; auto. rewrite <- IH.
    destruct (real3 v) as [[a b] c]. by_parts.
Qed.
Lemma weighs_sum vs : forall s t x y, weighs vs s x -> weighs vs t y ->
  weighs vs (s + t) (add3 x y).
Proof.
  intros s t x y (us & Lu & Pu & <- & ->) (ws & Lw & Pw & <- & ->).
  revert us ws Lu Lw Pu Pw. induction vs as [|v vs IH]; intros [|u us] [|w ws] Lu Lw Pu Pw;
    try discriminate.
  - exists []. simpl. repeat split; auto; try lra; try (intros ? []).
    by_parts.
  - destruct (IH us ws) as (zs & Lz & Pz & Sz & Mz); auto.
    { intros z I. apply Pu. simpl; auto. }
    { intros z I. apply Pw. simpl; auto. }
    exists (u + w :: zs). split; [simpl; congruence|split; [|split]].
    + intros z [<-|I]; auto. pose proof (Pu u (or_introl eq_refl)).
      pose proof (Pw w (or_introl eq_refl)). lra.
    + simpl. rewrite Sz. ring.
    + simpl. rewrite <- Mz. generalize (mean us (map real3 vs)), (mean ws (map real3 vs)).
      intros p q. destruct p as [[? ?] ?], q as [[? ?] ?], (real3 v) as [[? ?] ?].
      by_parts.
Qed.
Lemma weighs_times vs c t x : 0 <= c -> weighs vs t x -> weighs vs (c * t) (scale3 (c, c, c) x).
Proof.
  intros C (ws & L & P & <- & ->). exists (map (Rmult c) ws).
  split; [rewrite map_length; auto|split; [|split]].
  - intros w I. apply in_map_iff in I. destruct I as (u & <- & I). specialize (P u I). nra.
  - clear. induction ws; simpl; [ring|rewrite IHws; ring].
  - clear P. revert ws L. induction vs as [|v vs IH]; intros [|w ws] L; try discriminate; simpl.
    + apply triples_equal; ring.
    + rewrite <- IH by (simpl in L; congruence). generalize (mean ws (map real3 vs)). intros p.
      destruct p as [[? ?] ?], (real3 v) as [[? ?] ?]. by_parts.
Qed.
Lemma vertex_in_hull vs v : In v vs -> hull vs (real3 v).
Proof.
  change (In v vs -> weighs vs 1 (real3 v)). induction vs as [|u vs IH]; intros [].
  - subst u. destruct (weighs_nothing vs) as (ws & L & P & S & M).
    exists (1 :: ws). split; [simpl; congruence|split; [|split]].
    + intros w [<-|I]; auto. lra.
    + simpl. rewrite S. ring.
    + simpl. rewrite <- M. destruct (real3 v) as [[? ?] ?]. by_parts.
  - destruct (IH H) as (ws & L & P & S & M). exists (0 :: ws).
    split; [simpl; congruence|split; [|split]].
    + intros w [<-|I]; auto. lra.
    + simpl. rewrite S. ring.
    + simpl. rewrite <- M. destruct (real3 u) as [[? ?] ?], (real3 v) as [[? ?] ?].
      by_parts.
Qed.
(** ** Linear functions *)
Lemma real3_minus u v : real3 (minus3 u v) = minus_3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold minus3, real3, minus_3.
  rewrite !Q2R_red, !Q2R_minus. reflexivity.
Qed.
Lemma real3_cross u v : real3 (cross3 u v) = cross_3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold cross3, real3, cross_3.
  rewrite !Q2R_red, !Q2R_minus, !Q2R_mult. reflexivity.
Qed.
Lemma real3_dot u v : Q2R (dot3 u v) = dot_3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold dot3, real3, dot_3.
  rewrite !Q2R_plus, !Q2R_mult. reflexivity.
Qed.
Lemma dot_add3 n x y : dot_3 n (add3 x y) = dot_3 n x + dot_3 n y.
Proof. coordinates. ring. Qed.
Lemma dot_scale3 n c x : dot_3 n (scale3 (c, c, c) x) = c * dot_3 n x.
Proof. coordinates. ring. Qed.
Lemma dot_times n c x : dot_3 (scale3 (c, c, c) n) x = c * dot_3 n x.
Proof. coordinates. ring. Qed.
Lemma dot_mean n ps M : (forall p, In p ps -> dot_3 n p <= M) -> forall ws,
  length ws = length ps -> (forall w, In w ws -> 0 <= w) ->
  dot_3 n (mean ws ps) <= fold_right Rplus 0 ws * M.
Proof.
  induction ps as [|p ps IH]; intros H [|w ws] L W; try discriminate; cbn [mean fold_right].
  - destruct n as [[? ?] ?]. unfold dot_3. lra.
  - rewrite dot_add3, dot_scale3. assert (0 <= w) by (apply W; simpl; auto).
    assert (dot_3 n p <= M) by (apply H; simpl; auto).
    assert (dot_3 n (mean ws ps) <= fold_right Rplus 0 ws * M).
    { apply IH; [intros q I; apply H; simpl; auto|simpl in L; congruence|].
      intros u I. apply W. simpl; auto. }
    nra.
Qed.
(** A point that is strictly below all planes that no vertex is above, and one is below *)
Lemma dot_mean_less n ps M : (forall p, In p ps -> dot_3 n p <= M) -> forall ws,
  length ws = length ps -> (forall w, In w ws -> 0 < w) -> (exists p, In p ps /\ dot_3 n p < M) ->
  dot_3 n (mean ws ps) < fold_right Rplus 0 ws * M.
Proof.
  induction ps as [|p ps IH]; intros H [|w ws] L W (q & I & Q); try discriminate;
    [destruct I|]. cbn [mean fold_right].
  rewrite dot_add3, dot_scale3. assert (0 < w) by (apply W; simpl; auto).
  assert (dot_3 n p <= M) by (apply H; simpl; auto).
  assert (Hp : forall p, In p ps -> dot_3 n p <= M) by (intros r J; apply H; simpl; auto).
  assert (Lp : length ws = length ps) by (simpl in L; congruence).
  assert (Wp : forall u, In u ws -> 0 < u) by (intros u J; apply W; simpl; auto).
  destruct I as [->|I].
  - assert (dot_3 n (mean ws ps) <= fold_right Rplus 0 ws * M).
    { apply dot_mean; auto. intros u J. apply Rlt_le, Wp, J. }
    nra.
  - assert (dot_3 n (mean ws ps) < fold_right Rplus 0 ws * M) by (apply IH; eauto). nra.
Qed.
Lemma inside_exists vs : vs <> [] -> exists o, hull vs o /\ forall n M,
  (forall v, In v vs -> dot_3 n (real3 v) <= M) ->
  (exists v, In v vs /\ dot_3 n (real3 v) < M) -> dot_3 n o < M.
Proof.
  intros N. set (w := / INR (length vs)).
  assert (K : 0 < INR (length vs)).
  { apply lt_0_INR. destruct vs; [contradiction|simpl; lia]. }
  assert (W : 0 < w) by (apply Rinv_0_lt_compat, K).
  set (ws := map (fun _ : vertex3 => w) vs).
  assert (L : length ws = length (map real3 vs)) by (unfold ws; rewrite !map_length; auto).
  assert (P : forall u, In u ws -> 0 < u).
  { intros u I. apply in_map_iff in I. destruct I as (_ & <- & _). exact W. }
  assert (S : fold_right Rplus 0 ws = 1).
  { replace 1 with (INR (length vs) * w) by (unfold w; field; lra). unfold ws. clear.
    generalize w. intros r. induction vs as [|v vs IH]; [simpl; ring|].
    cbn [map fold_right length]. rewrite IH, S_INR. ring. }
  exists (mean ws (map real3 vs)). split.
  - exists ws. split; [unfold ws; apply map_length|split; [|split; [exact S|reflexivity]]].
    intros u I. apply Rlt_le, P, I.
  - intros n M H (v & I & V). rewrite <- (Rmult_1_l M), <- S. apply dot_mean_less; auto.
    + intros p J. apply in_map_iff in J. destruct J as (u & <- & J). apply H, J.
    + exists (real3 v). split; auto. apply in_map, I.
Qed.

(** ** Cones from a point inside *)
Lemma det_of_face n a b c o : dot_3 n (minus_3 b a) = 0 -> dot_3 n (minus_3 c a) = 0 ->
  0 < dot_3 n (cross_3 (minus_3 b a) (minus_3 c a)) -> dot_3 n o < dot_3 n a ->
  0 < volume_of (minus_3 a o) (minus_3 b o) (minus_3 c o).
Proof.
  intros B C D O.
  set (e := minus_3 b a) in *. set (f := minus_3 c a) in *. set (w := minus_3 a o).
  assert (E : dot_3 n n * volume_of (minus_3 a o) (minus_3 b o) (minus_3 c o)
    = dot_3 n (cross_3 e f) * dot_3 n w).
  { replace (dot_3 n (cross_3 e f) * dot_3 n w) with (dot_3 n (cross_3 e f) * dot_3 n w
      + dot_3 n e * dot_3 w (cross_3 n f) - dot_3 n f * dot_3 w (cross_3 n e))
      by (rewrite B, C; ring).
    unfold e, f, w. clear. unfold minus_3. coordinates. ring. }
  assert (W : 0 < dot_3 n w).
  { replace (dot_3 n w) with (dot_3 n a - dot_3 n o); [lra|].
    unfold w. clear. unfold minus_3. coordinates. ring. }
  assert (N : 0 <= dot_3 n n).
  { clear. destruct n as [[x y] z]. unfold dot_3. nra. }
  assert (P : 0 < dot_3 n (cross_3 e f) * dot_3 n w) by (apply Rmult_lt_0_compat; auto).
  rewrite <- E in P. destruct N as [N|N]; [|rewrite <- N in P; lra].
  apply Rmult_lt_reg_l with (dot_3 n n); auto. rewrite Rmult_0_r. exact P.
Qed.
(** A point of a cone that is not beyond the plane of its triangle *)
Lemma cone_in_hull vs n a b c o x : hull vs a -> hull vs b -> hull vs c -> hull vs o ->
  dot_3 n a = dot_3 n b -> dot_3 n a = dot_3 n c -> dot_3 n o < dot_3 n a ->
  0 < volume_of (minus_3 a o) (minus_3 b o) (minus_3 c o) ->
  in_cone (minus_3 a o) (minus_3 b o) (minus_3 c o) (minus_3 x o) -> dot_3 n x <= dot_3 n a ->
  hull vs x.
Proof.
  intros Ha Hb Hc Ho Eb Ec O D (K1 & K2 & K3) X.
  set (d := volume_of (minus_3 a o) (minus_3 b o) (minus_3 c o)) in *.
  set (i := volume_of (minus_3 b o) (minus_3 c o) (minus_3 x o)) in *.
  set (j := volume_of (minus_3 c o) (minus_3 a o) (minus_3 x o)) in *.
  set (k := volume_of (minus_3 a o) (minus_3 b o) (minus_3 x o)) in *.
  assert (V : scale3 (d, d, d) (minus_3 x o) = add3 (scale3 (i, i, i) (minus_3 a o))
    (add3 (scale3 (j, j, j) (minus_3 b o)) (scale3 (k, k, k) (minus_3 c o)))).
  { unfold d, i, j, k. clear. unfold minus_3. coordinates. apply triples_equal; ring. }
  assert (L : d * (dot_3 n x - dot_3 n o) = (i + j + k) * (dot_3 n a - dot_3 n o)).
  { pose proof (f_equal (dot_3 n) V) as E. rewrite !dot_add3, !dot_scale3 in E.
    assert (M : forall u, dot_3 n (minus_3 u o) = dot_3 n u - dot_3 n o)
      by (intros u; clear; unfold minus_3; coordinates; ring).
    rewrite !M, <- Eb, <- Ec in E. lra. }
  assert (S : i + j + k <= d) by nra.
  assert (I : 0 < / d) by (apply Rinv_0_lt_compat, D).
  assert (G : hull vs (add3 (scale3 ((d - (i + j + k)) * / d, (d - (i + j + k)) * / d,
      (d - (i + j + k)) * / d) o) (add3 (scale3 (i * / d, i * / d, i * / d) a)
      (add3 (scale3 (j * / d, j * / d, j * / d) b) (scale3 (k * / d, k * / d, k * / d) c))))).
  { apply hull_weighs.
    replace 1 with ((d - (i + j + k)) * / d * 1 + (i * / d * 1 + (j * / d * 1 + k * / d * 1)))
      by (field; lra).
    repeat apply weighs_sum; apply weighs_times; try assumption;
      apply Rmult_le_pos; lra. }
  replace x with (add3 (scale3 ((d - (i + j + k)) * / d, (d - (i + j + k)) * / d,
      (d - (i + j + k)) * / d) o) (add3 (scale3 (i * / d, i * / d, i * / d) a)
      (add3 (scale3 (j * / d, j * / d, j * / d) b) (scale3 (k * / d, k * / d, k * / d) c))));
    [exact G|].
  clear - V D. destruct x as [[x1 x2] x3], o as [[o1 o2] o3], a as [[a1 a2] a3],
    b as [[b1 b2] b3], c as [[c1 c2] c3]. clearbody d i j k. unfold add3, scale3, minus_3 in *.
  injection V; intros V3 V2 V1. apply triples_equal.
  - apply Rmult_eq_reg_l with d; [|lra].
    replace (d * x1) with (d * (x1 - o1) + d * o1) by ring. rewrite V1. field. lra.
  - apply Rmult_eq_reg_l with d; [|lra].
    replace (d * x2) with (d * (x2 - o2) + d * o2) by ring. rewrite V2. field. lra.
  - apply Rmult_eq_reg_l with d; [|lra].
    replace (d * x3) with (d * (x3 - o3) + d * o3) by ring. rewrite V3. field. lra.
Qed.

