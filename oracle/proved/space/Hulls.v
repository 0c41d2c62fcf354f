(** Sums of convex polyhedra: a checker, and that what it takes is the sum as a set of points. *)
From Coq Require Import Lra Lia Bool.
From Proved Require Import Definitions Space Checker Corners Rational Values Cones Means Meshes.
Open Scope Q_scope.

(** ** The checker *)
(** Each vertex of R is a sum S p + q, by the numbers of p and q; and no such sum is above the plane
    of a facet. *)
Definition same3 (u v : vertex3) : bool :=
  let '(a, b, c) := u in let '(d, e, f) := v in Qeq_bool a d && Qeq_bool b e && Qeq_bool c f.
Definition stretched (s v : vertex3) : vertex3 :=
  let '(a, b, c) := s in let '(d, e, f) := v in (Qred (a * d), Qred (b * e), Qred (c * f)).
Definition is_pair (S : vertex3) (P Q : list vertex3) (v : vertex3) (ij : nat * nat) : bool :=
  match nth_error P (fst ij), nth_error Q (snd ij) with
  | Some p, Some q => same3 v (plus3 (stretched S p) q)
  | _, _ => false
  end.
(** The largest value of a x + b y + c z on points *)
Definition greatest (plane : Z * Z * Z * Z) (vs : list (Z * Z * Z * positive)) : Q :=
  let '(a, b, c, _) := plane in
  let at_ v := let '(x, y, z, w) := v in Qmake (a * x + b * y + c * z)%Z w in
  match vs with
  | [] => 0
  | v :: r => fold_right (fun u m => larger (at_ u) m) (at_ v) r
  end.
Definition is_above (m : mesh) (P Q : list (Z * Z * Z * positive)) (face : list nat) : bool :=
  let plane := plane_of (corners m face) in
  Qle_bool (greatest plane P + greatest plane Q) (inject_Z (snd plane)).
Definition check_body (S : vertex3) (P Q R : mesh) (pairs : list (nat * nat)) : bool :=
  is_convex_mesh P && is_convex_mesh Q && is_canonical_mesh R && forallb (is_fan R) (snd R) &&
  all2 (is_pair S (fst P) (fst Q)) (fst R) pairs &&
  let moved := map over_one (map (stretched S) (fst P)) in
  let others := map over_one (fst Q) in
  forallb (is_above R moved others) (snd R).

(** ** It is right. *)
Open Scope R_scope.
Lemma real3_stretched u v : real3 (stretched u v) = scale3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold stretched, real3, scale3.
  rewrite !Q2R_red, !Q2R_mult. reflexivity.
Qed.
Lemma same3_real u v : same3 u v = true -> real3 u = real3 v.
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold same3, real3. rewrite !andb_true_iff.
  intros [[A B] C]. rewrite (eq_real _ _ A), (eq_real _ _ B), (eq_real _ _ C). reflexivity.
Qed.
Lemma greatest_real ring vs v k : In v vs ->
  (let '(a, b, c, _) := plane_of ring in
   (IZR a, IZR b, IZR c) = scale3 (k, k, k) (real3 (area_vector ring))) ->
  k * dot_3 (real3 (area_vector ring)) (real3 v)
    <= Q2R (greatest (plane_of ring) (map over_one vs)).
Proof.
  intros I N. destruct (plane_of ring) as [[[a b] c] h].
  set (at_ := fun v : Z * Z * Z * positive =>
    let '(x, y, z, w) := v in Qmake (a * x + b * y + c * z)%Z w).
  assert (A : forall u, Q2R (at_ (over_one u)) = k * dot_3 (real3 (area_vector ring)) (real3 u)).
  { intros u. pose proof (over_one_real u) as U. destruct (over_one u) as [[[x y] z] w].
    unfold at_. rewrite real_whole, !plus_IZR, !mult_IZR, U.
    destruct (real3 (area_vector ring)) as [[n1 n2] n3]. unfold scale3 in N.
    injection N; intros -> -> ->. unfold dot_3. pose proof (pos_real w). field. lra. }
  rewrite <- A.
  change (greatest (a, b, c, h) (map over_one vs)) with (match map over_one vs with
    | [] => 0%Q | v :: r => fold_right (fun u m => larger (at_ u) m) (at_ v) r end).
  apply (in_map over_one) in I. revert I. generalize (map over_one vs), (over_one v).
  intros l u. destruct l as [|p r]; [intros []|].
  set (m := fold_right (fun v m => larger (at_ v) m) (at_ p)).
  assert (H : Q2R (at_ p) <= Q2R (m r) /\ (In u r -> Q2R (at_ u) <= Q2R (m r))).
  { induction r as [|w r IH]; simpl; [split; [lra|tauto]|].
    destruct IH as [I1 I2]. destruct (larger_real (at_ w) (m r)) as [M1 M2].
    unfold m in *. simpl in *. split; [lra|].
    intros [->|I]; [lra|]. specialize (I2 I). lra. }
  destruct H as [H1 H2]. intros [->|I]; auto.
Qed.

(** ** The theorem *)
Theorem body_is_right : forall (S : vertex3) (P Q R : mesh) (pairs : list (nat * nat)),
  check_body S P Q R pairs = true ->
  is_convex_mesh P = true /\ is_convex_mesh Q = true /\ is_canonical_mesh R = true /\
  is_bounded R /\ is_body_sum S (fst P) (fst Q) (fst R).
Proof.
  intros S P Q R pairs H. unfold check_body in H. rewrite !andb_true_iff in H.
  destruct H as [[[[[HP HQ] HR] HF] HV] HA].
  assert (CR : is_convex_mesh R = true)
    by (unfold is_canonical_mesh in HR; rewrite !andb_true_iff in HR; tauto).
  split; [auto|split; [auto|split; [auto|split; [exact (mesh_is_bounded R CR HF)|]]]].
  intros x. split.
  - intros (ws & L & Pos & One & ->).
    assert (G : forall vs ps, all2 (is_pair S (fst P) (fst Q)) vs ps = true ->
      forall us, length us = length vs -> (forall w, In w us -> 0 <= w) ->
      exists p q, weighs (fst P) (fold_right Rplus 0 us) p /\
        weighs (fst Q) (fold_right Rplus 0 us) q /\
        mean us (map real3 vs) = add3 (scale3 (real3 S) p) q).
    { induction vs as [|v vs IH]; intros [|ij ps] H [|u us] Lu Pu; try discriminate; simpl.
      - exists (0, 0, 0), (0, 0, 0). split; [apply weighs_nothing|].
        split; [apply weighs_nothing|]. destruct (real3 S) as [[? ?] ?].
        by_parts.
      - simpl in H. apply andb_prop in H. destruct H as [H1 H2].
        destruct (IH ps H2 us) as (p & q & Wp & Wq & E); [simpl in Lu; congruence| |].
        { intros w I. apply Pu. simpl; auto. }
        unfold is_pair in H1. destruct (nth_error (fst P) (fst ij)) as [a|] eqn:Ea; [|discriminate].
        destruct (nth_error (fst Q) (snd ij)) as [b|] eqn:Eb; [|discriminate].
        apply nth_error_In in Ea. apply nth_error_In in Eb. apply same3_real in H1.
        rewrite real3_plus, real3_stretched in H1.
        assert (U : 0 <= u) by (apply Pu; simpl; auto).
        exists (add3 (scale3 (u, u, u) (real3 a)) p), (add3 (scale3 (u, u, u) (real3 b)) q).
        split; [|split].
        + apply weighs_sum; auto. rewrite <- (Rmult_1_r u) at 1.
          apply weighs_times; auto. apply vertex_in_hull, Ea.
        + apply weighs_sum; auto. rewrite <- (Rmult_1_r u) at 1.
          apply weighs_times; auto. apply vertex_in_hull, Eb.
        + rewrite E, H1. destruct (real3 S) as [[? ?] ?], (real3 a) as [[? ?] ?],
            (real3 b) as [[? ?] ?], p as [[? ?] ?], q as [[? ?] ?].
          by_parts. }
    destruct (G (fst R) pairs HV ws L Pos) as (p & q & Wp & Wq & E). rewrite One in Wp, Wq.
    exists p, q. auto.
  - intros (p & q & (us & Lu & Pu & Ou & ->) & (ws & Lw & Pw & Ow & ->) & ->).
    apply (below_all_in_hull R CR HF). intros face F.
    rewrite forallb_forall in HA. specialize (HA face F). unfold is_above in HA.
    set (ring := corners R face) in *.
    apply le_real in HA. rewrite Q2R_plus in HA. unfold height_of, normal_of. fold ring.
    pose proof (plane_real ring) as L. destruct (plane_of ring) as [[[n1 n2] n3] h] eqn:Pl.
    destruct L as (k & K & N & Hh). cbn [snd] in HA.
    assert (Hq : Q2R (inject_Z h) = k * Q2R (level ring)).
    { rewrite <- Hh. unfold inject_Z. rewrite real_whole. field. }
    rewrite Hq in HA. set (n := real3 (area_vector ring)) in *.
    assert (At : let '(a, b, c, _) := plane_of ring in
      (IZR a, IZR b, IZR c) = scale3 (k, k, k) (real3 (area_vector ring)))
      by (rewrite Pl; exact N).
    rewrite <- Pl in HA. rewrite dot_add3.
    assert (A : dot_3 (scale3 (k, k, k) n) (scale3 (real3 S) (mean us (map real3 (fst P))))
      <= Q2R (greatest (plane_of ring) (map over_one (map (stretched S) (fst P))))).
    { assert (D : forall a, dot_3 (scale3 (k, k, k) n) (scale3 (real3 S) a)
        = dot_3 (scale3 (real3 S) (scale3 (k, k, k) n)) a).
      { intros a. destruct n as [[? ?] ?], (real3 S) as [[? ?] ?], a as [[? ?] ?].
        unfold dot_3, scale3. ring. }
      rewrite D, <- (Rmult_1_l (Q2R _)), <- Ou.
      apply dot_mean; [|rewrite map_length; auto|auto]. intros v I.
      apply in_map_iff in I. destruct I as (u & <- & I). rewrite <- D, <- real3_stretched.
      rewrite dot_times. apply greatest_real; auto. apply in_map, I. }
    assert (B : dot_3 (scale3 (k, k, k) n) (mean ws (map real3 (fst Q)))
      <= Q2R (greatest (plane_of ring) (map over_one (fst Q)))).
    { rewrite <- (Rmult_1_l (Q2R _)), <- Ow.
      apply dot_mean; [|rewrite map_length; auto|auto]. intros v I.
      apply in_map_iff in I. destruct I as (u & <- & I). rewrite dot_times.
      apply greatest_real; auto. }
    rewrite dot_times in A, B. apply Rmult_le_reg_l with k; auto.
    lra.
Qed.
