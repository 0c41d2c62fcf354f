(** Sums of convex polyhedra: a checker, and that what it takes is the sum as a set of points. *)
From Coq Require Import Lra Lia Bool.
From Proved Require Import Definitions Space Checker Corners Rational.
Open Scope Q_scope.

(** ** The checker *)
(** Each vertex of R is a sum S p + q, by the numbers of p and q; and each sum S p + q is a mean of
    vertices of R, by their numbers and weights. *)
Definition same3 (u v : vertex3) : bool :=
  let '(a, b, c) := u in let '(d, e, f) := v in Qeq_bool a d && Qeq_bool b e && Qeq_bool c f.
Definition stretched (s v : vertex3) : vertex3 :=
  let '(a, b, c) := s in let '(d, e, f) := v in (Qred (a * d), Qred (b * e), Qred (c * f)).
Definition is_pair (S : vertex3) (P Q : list vertex3) (v : vertex3) (ij : nat * nat) : bool :=
  match nth_error P (fst ij), nth_error Q (snd ij) with
  | Some p, Some q => same3 v (plus3 (stretched S p) q)
  | _, _ => false
  end.
Fixpoint weighed (R : list vertex3) (ws : list (nat * Q)) : option (Q * vertex3) :=
  match ws with
  | [] => Some (0, (0, 0, 0))
  | (k, w) :: r =>
      match nth_error R k, weighed R r with
      | Some v, Some (total, x) =>
          if Qle_bool 0 w then Some (Qred (w + total), plus3 (stretched (w, w, w) v) x) else None
      | _, _ => None
      end
  end.
Definition is_mean (R : list vertex3) (x : vertex3) (ws : list (nat * Q)) : bool :=
  match weighed R ws with
  | Some (total, y) => Qeq_bool total 1 && same3 x y
  | None => false
  end.
Definition check_body (S : vertex3) (P Q R : mesh) (pairs : list (nat * nat))
    (means : list (list (list (nat * QArith_base.Q)))) : bool :=
  is_convex_mesh P && is_convex_mesh Q && is_canonical_mesh R &&
  all2 (is_pair S (fst P) (fst Q)) (fst R) pairs &&
  all2 (fun p row => all2 (fun q ws => is_mean (fst R) (plus3 (stretched S p) q) ws) (fst Q) row)
    (fst P) means.

(** ** It is right. *)
Open Scope R_scope.
Lemma real3_plus u v : real3 (plus3 u v) = add3 (real3 u) (real3 v).
Proof.
  destruct u as [[a b] c], v as [[d e] f]. unfold plus3, real3, add3.
  rewrite !Q2R_red, !Q2R_plus. reflexivity.
Qed.
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
Lemma triples_equal (a b c d e f : R) : a = d -> b = e -> c = f -> (a, b, c) = (d, e, f).
Proof. congruence. Qed.
Ltac by_parts := unfold add3, scale3; apply triples_equal; ring.

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
(** Means of points of a hull are in it; here of images f v of the vertices of another one. *)
Lemma mean_in_hull (f : point3 -> point3) us vs : (forall u, In u us -> hull vs (f (real3 u))) ->
  forall ws, length ws = length us -> (forall w, In w ws -> 0 <= w) ->
  weighs vs (fold_right Rplus 0 ws) (mean ws (map f (map real3 us))).
Proof.
  induction us as [|u us IH]; intros H [|w ws] L P; try discriminate; simpl.
  - apply weighs_nothing.
  - apply weighs_sum; [|apply IH; auto].
    + rewrite <- (Rmult_1_r w) at 1. apply weighs_times; [apply P; simpl; auto|].
      apply H. simpl; auto.
    + intros k I. apply H. simpl; auto.
    + intros k I. apply P. simpl; auto.
Qed.

(** Images of means *)
Lemma mean_of_sums s q ps : forall ws, length ws = length ps ->
  mean ws (map (fun p => add3 (scale3 s p) q) ps)
    = add3 (scale3 s (mean ws ps)) (scale3 (fold_right Rplus 0 ws, fold_right Rplus 0 ws,
        fold_right Rplus 0 ws) q).
Proof.
  induction ps as [|p ps IH]; intros [|w ws] L; try discriminate; simpl.
  - destruct s as [[? ?] ?], q as [[? ?] ?]. by_parts.
  - rewrite IH by (simpl in L; congruence). generalize (mean ws ps), (fold_right Rplus 0 ws).
    intros m t. destruct s as [[? ?] ?], q as [[? ?] ?], p as [[? ?] ?], m as [[? ?] ?].
    by_parts.
Qed.
Lemma mean_of_moved p qs : forall ws, length ws = length qs ->
  mean ws (map (fun q => add3 p q) qs)
    = add3 (scale3 (fold_right Rplus 0 ws, fold_right Rplus 0 ws, fold_right Rplus 0 ws) p)
        (mean ws qs).
Proof.
  induction qs as [|q qs IH]; intros [|w ws] L; try discriminate; simpl.
  - destruct p as [[? ?] ?]. by_parts.
  - rewrite IH by (simpl in L; congruence). generalize (mean ws qs), (fold_right Rplus 0 ws).
    intros m t. destruct p as [[? ?] ?], q as [[? ?] ?], m as [[? ?] ?].
    by_parts.
Qed.
Lemma scale3_one x : scale3 (1, 1, 1) x = x.
Proof. destruct x as [[? ?] ?]. by_parts. Qed.

Lemma weighed_real R ws : forall total x, weighed R ws = Some (total, x) ->
  weighs R (Q2R total) (real3 x).
Proof.
  induction ws as [|[k w] ws IH]; intros total x H; cbn [weighed] in H.
  - injection H; intros <- <-. unfold real3. rewrite Q2R_zero. apply weighs_nothing.
  - destruct (nth_error R k) as [v|] eqn:E; [|discriminate]. apply nth_error_In in E.
    destruct (weighed R ws) as [[t y]|]; [|discriminate].
    destruct (Qle_bool 0 w) eqn:W; [|discriminate]. apply le_real in W. rewrite Q2R_zero in W.
    remember (plus3 (stretched (w, w, w) v) y) as z eqn:Z. injection H; intros <- <-. rewrite Z.
    rewrite Q2R_red, Q2R_plus, real3_plus, real3_stretched.
    apply weighs_sum; [|apply IH; reflexivity].
    rewrite <- (Rmult_1_r (Q2R w)) at 1. apply (weighs_times R (Q2R w) 1 (real3 v) W).
    apply vertex_in_hull, E.
Qed.
Lemma is_mean_in_hull R x ws : is_mean R x ws = true -> hull R (real3 x).
Proof.
  unfold is_mean. destruct (weighed R ws) as [[total y]|] eqn:E; [|discriminate].
  intros H. apply andb_prop in H. destruct H as [H1 H2]. apply weighed_real in E.
  apply eq_real in H1. rewrite H1, Q2R_one in E. rewrite (same3_real _ _ H2). exact E.
Qed.

Theorem body_is_right : forall (S : vertex3) (P Q R : mesh) (pairs : list (nat * nat))
    (means : list (list (list (nat * QArith_base.Q)))),
  check_body S P Q R pairs means = true ->
  is_convex_mesh P = true /\ is_convex_mesh Q = true /\ is_canonical_mesh R = true /\
  is_body_sum S (fst P) (fst Q) (fst R).
Proof.
  intros S P Q R pairs means H. unfold check_body in H. rewrite !andb_true_iff in H.
  destruct H as [[[[HP HQ] HR] HV] HM]. split; [auto|split; [auto|split; [auto|]]].
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
    assert (G : forall v, In v (fst Q) ->
      hull (fst R) (add3 (scale3 (real3 S) (mean us (map real3 (fst P)))) (real3 v))).
    { intros v I.
      assert (K : forall u, In u (fst P) ->
        hull (fst R) (add3 (scale3 (real3 S) (real3 u)) (real3 v))).
      { intros u J. destruct (all2_partner _ _ _ HM u J) as (row & HM').
        destruct (all2_partner _ _ _ HM' v I) as (w & Hw). apply is_mean_in_hull in Hw.
        rewrite real3_plus, real3_stretched in Hw. exact Hw. }
      pose proof (mean_in_hull (fun x => add3 (scale3 (real3 S) x) (real3 v)) (fst P) (fst R) K
        us Lu Pu) as M.
      rewrite mean_of_sums in M by (rewrite map_length; auto).
      rewrite Ou, scale3_one in M. exact M. }
    pose proof (mean_in_hull (fun x => add3 (scale3 (real3 S) (mean us (map real3 (fst P)))) x)
      (fst Q) (fst R) G ws Lw Pw) as M.
    rewrite mean_of_moved in M by (rewrite map_length; auto).
    rewrite Ow, scale3_one in M. exact M.
Qed.
