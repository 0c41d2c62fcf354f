(** How often a ring winds around a point while its corners move along lines: always as often, where
    it never meets the point. Far away nothing is wound around. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Corners Bodies
  Components Holes Paths Decomposed.
Open Scope R_scope.

(** ** What holds at a scale and close to it *)
Definition around (s : R) (H : R -> Prop) : Prop :=
  exists e, 0 < e /\ forall u, Rabs (u - s) < e -> H u.
Lemma around_and s H K : around s H -> around s K -> around s (fun u => H u /\ K u).
Proof.
  intros (e & He & A) (f & Hf & B). exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
  intros u U. pose proof (Rmin_l e f). pose proof (Rmin_r e f). split; [apply A|apply B]; lra.
Qed.
Lemma around_imp (s : R) (H K : R -> Prop) : (forall u, H u -> K u) -> around s H -> around s K.
Proof. intros I (e & He & A). exists e; auto. Qed.
Lemma around_positive k l m s : 0 < k + s * l + s * s * m ->
  around s (fun u => 0 < k + u * l + u * u * m).
Proof.
  set (v := k + s * l + s * s * m). intros V.
  set (K := Rabs l + Rabs m * (2 * Rabs s + 1) + 1).
  pose proof (Rabs_pos l). pose proof (Rabs_pos m). pose proof (Rabs_pos s).
  assert (HK : 0 < K) by (unfold K; nra).
  exists (Rmin 1 (v / K)). split; [apply Rmin_glb_lt; [lra|apply Rdiv_lt_0_compat; auto]|].
  intros u U. pose proof (Rmin_l 1 (v / K)). pose proof (Rmin_r 1 (v / K)).
  assert (W : Rabs (u - s) * K < v).
  { apply Rmult_lt_reg_r with (/ K); [apply Rinv_0_lt_compat; auto|].
    rewrite Rmult_assoc, Rinv_r by lra. unfold Rdiv in *. lra. }
  assert (E : k + u * l + u * u * m = v + (u - s) * (l + m * (u + s))) by (unfold v; ring).
  rewrite E. pose proof (Rle_abs (- ((u - s) * (l + m * (u + s))))) as A.
  rewrite Rabs_Ropp, Rabs_mult in A.
  assert (B : Rabs (l + m * (u + s)) <= K).
  { eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult. unfold K.
    assert (Rabs (u + s) <= 2 * Rabs s + 1).
    { replace (u + s) with ((u - s) + 2 * s) by ring. eapply Rle_trans; [apply Rabs_triang|].
      rewrite (Rabs_mult 2 s), (Rabs_right 2) by lra. lra. }
    pose proof (Rabs_pos (u + s)). nra. }
  pose proof (Rabs_pos (u - s)). pose proof (Rabs_pos (l + m * (u + s))). nra.
Qed.

(** ** Points that move along lines *)
Definition track_t := (point * point)%type.
Definition moved_to (s : R) (l : track_t) : point :=
  (fst (fst l) + s * fst (snd l), snd (fst l) + s * snd (snd l)).
Lemma around_linear k l s : 0 < k + s * l -> around s (fun u => 0 < k + u * l).
Proof.
  intros H. apply (around_imp s (fun u => 0 < k + u * l + u * u * 0)); [intros; lra|].
  apply around_positive. lra.
Qed.
Lemma around_right (a : track_t) (x : point) s : fst x < fst (moved_to s a) ->
  around s (fun u => fst x < fst (moved_to u a)).
Proof.
  unfold moved_to; cbn [fst snd]. intros H.
  apply (around_imp s (fun u => 0 < (fst (fst a) - fst x) + u * fst (snd a))); [intros; lra|].
  apply around_linear. lra.
Qed.
Lemma around_left (a : track_t) (x : point) s : fst (moved_to s a) < fst x ->
  around s (fun u => fst (moved_to u a) < fst x).
Proof.
  unfold moved_to; cbn [fst snd]. intros H.
  apply (around_imp s (fun u => 0 < (fst x - fst (fst a)) + u * - fst (snd a))); [intros; lra|].
  apply around_linear. lra.
Qed.
Lemma around_above (a : track_t) (x : point) s : snd x < snd (moved_to s a) ->
  around s (fun u => snd x < snd (moved_to u a)).
Proof.
  unfold moved_to; cbn [fst snd]. intros H.
  apply (around_imp s (fun u => 0 < (snd (fst a) - snd x) + u * snd (snd a))); [intros; lra|].
  apply around_linear. lra.
Qed.
Lemma around_below (a : track_t) (x : point) s : snd (moved_to s a) < snd x ->
  around s (fun u => snd (moved_to u a) < snd x).
Proof.
  unfold moved_to; cbn [fst snd]. intros H.
  apply (around_imp s (fun u => 0 < (snd x - snd (fst a)) + u * - snd (snd a))); [intros; lra|].
  apply around_linear. lra.
Qed.
Lemma around_turn (a b : track_t) (x : point) s :
  0 < orient (moved_to s a) (moved_to s b) x ->
  around s (fun u => 0 < orient (moved_to u a) (moved_to u b) x).
Proof.
  destruct a as [[a1 a2] [c1 c2]], b as [[b1 b2] [d1 d2]], x as [x1 x2].
  assert (E : forall u, orient (moved_to u ((a1, a2), (c1, c2)))
      (moved_to u ((b1, b2), (d1, d2))) (x1, x2) = ((b1 - a1) * (x2 - a2) - (b2 - a2) * (x1 - a1))
    + u * ((d1 - c1) * (x2 - a2) - (b1 - a1) * c2 - (d2 - c2) * (x1 - a1) + (b2 - a2) * c1)
    + u * u * ((d2 - c2) * c1 - (d1 - c1) * c2))
    by (intros; unfold orient, moved_to; cbn [fst snd]; ring).
  rewrite E. intros H. eapply around_imp; [|apply (around_positive _ _ _ s H)].
  intros u U. rewrite E. exact U.
Qed.
Lemma around_turn_right (a b : track_t) (x : point) s :
  orient (moved_to s a) (moved_to s b) x < 0 ->
  around s (fun u => orient (moved_to u a) (moved_to u b) x < 0).
Proof.
  intros H. rewrite orient_swap in H.
  apply (around_imp s (fun u => 0 < orient (moved_to u b) (moved_to u a) x)).
  - intros u U. rewrite orient_swap in U. lra.
  - apply around_turn. lra.
Qed.

(** ** An edge's crossing number is that of before, but for what its ends change. *)
Definition switch (s : R) (x : point) (v : track_t) (u : R) : Z :=
  if Req_EM_T (fst (moved_to s v)) (fst x) then
    if Rlt_dec (snd x) (snd (moved_to s v)) then reached (moved_to u v) x else 0%Z
  else 0%Z.
Lemma off_line a b x : fst a < fst b -> fst a <= fst x <= fst b -> ~ on_segment a b x ->
  orient a b x <> 0.
Proof.
  intros L X N E. apply N. destruct (fraction_between (fst a) (fst x) (fst b)) as (t & T & Et);
    [auto|lra|]. exists t. split; auto. destruct x as [x1 x2]. cbn [fst snd] in *. f_equal; auto.
  unfold orient in E; cbn [fst snd] in E. apply Rmult_eq_reg_l with (fst b - fst a); [|lra].
  rewrite Et in E. lra.
Qed.
Ltac decide_crossing := unfold crossing, switch, reached;
  repeat match goal with |- context [Req_EM_T ?v ?w] => destruct (Req_EM_T v w) end;
  split_decisions; try lia; exfalso; lra.
Lemma crossing_moves_right a b x s : let A := moved_to s a in let B := moved_to s b in
  fst A <= fst B -> ~ on_segment A B x -> exists C, around s (fun u =>
    crossing (moved_to u a) (moved_to u b) x = (C + switch s x b u - switch s x a u)%Z).
Proof.
  intros A B L N.
  assert (Turn : fst A < fst B -> fst A <= fst x <= fst B ->
    around s (fun u => 0 < orient (moved_to u a) (moved_to u b) x) /\ 0 < orient A B x \/
    around s (fun u => orient (moved_to u a) (moved_to u b) x < 0) /\ orient A B x < 0).
  { intros H1 H2. pose proof (off_line A B x H1 H2 N).
    destruct (Rtotal_order (orient A B x) 0) as [O|[O|O]]; [right|contradiction|left]; split; auto;
      [apply around_turn_right|apply around_turn]; exact O. }
  destruct (Rtotal_order (fst B) (fst x)) as [XB|[XB|XB]].
  - (* both on the left *)
    exists 0%Z. eapply around_imp; [|apply (around_and _ _ _ (around_left a x s ltac:(fold A; lra))
      (around_left b x s XB))]. intros u [U1 U2]. subst A B. decide_crossing.
  - destruct (Rtotal_order (fst A) (fst x)) as [XA|[XA|XA]]; [| |lra].
    + (* B above or below *)
      assert (E : orient A B x = (fst B - fst A) * (snd x - snd B))
        by (unfold orient; rewrite <- XB; ring).
      destruct (Turn ltac:(lra) ltac:(lra)) as [[T O]|[T O]];
        [exists 0%Z; assert (snd B < snd x) by nra|exists (-1)%Z; assert (snd x < snd B) by nra];
        (eapply around_imp; [|apply (around_and _ _ _ (around_left a x s XA) T)];
         intros u [U1 U2]; subst A B; decide_crossing).
    + (* both *)
      assert (V : (snd x < snd A /\ snd x < snd B) \/ (snd A < snd x /\ snd B < snd x)).
      { destruct (Rlt_dec (snd x) (snd A)), (Rlt_dec (snd x) (snd B)), (Rlt_dec (snd A) (snd x)),
          (Rlt_dec (snd B) (snd x)); try lra; exfalso; apply N, segment_by_orient; try lra;
          unfold orient; rewrite XA, XB; ring. }
      exists 0%Z. destruct V as [[V1 V2]|[V1 V2]].
      * eapply around_imp; [|apply (around_and _ _ _ (around_above a x s V1)
          (around_above b x s V2))]. intros u [U1 U2]. subst A B.
        set (a' := moved_to u a) in *. set (b' := moved_to u b) in *.
        assert (O1 : fst a' <= fst x < fst b' -> orient a' b' x < 0)
          by (intros; unfold orient; nra).
        assert (O2 : fst b' <= fst x < fst a' -> 0 < orient a' b' x)
          by (intros; unfold orient; nra).
        unfold crossing, switch, reached. fold a' b'.
        repeat match goal with |- context [Req_EM_T ?v ?w] => destruct (Req_EM_T v w) end;
        split_decisions; try lia; exfalso; lra.
      * eapply around_imp; [|apply (around_and _ _ _ (around_below a x s V1)
          (around_below b x s V2))]. intros u [U1 U2]. subst A B.
        rewrite crossing_above by auto. unfold switch.
        repeat match goal with |- context [Req_EM_T ?v ?w] => destruct (Req_EM_T v w) end;
        split_decisions; try lia; exfalso; lra.
  - destruct (Rtotal_order (fst A) (fst x)) as [XA|[XA|XA]].
    + (* x between *)
      destruct (Turn ltac:(lra) ltac:(lra)) as [[T O]|[T O]]; [exists 0%Z|exists (-1)%Z];
        (eapply around_imp; [|apply (around_and _ _ _ (around_left a x s XA)
          (around_and _ _ _ (around_right b x s XB) T))]; intros u (U1 & U2 & U3); subst A B;
         decide_crossing).
    + assert (E : orient A B x = (fst B - fst A) * (snd x - snd A))
        by (unfold orient; rewrite <- XA; ring).
      destruct (Turn ltac:(lra) ltac:(lra)) as [[T O]|[T O]];
        [assert (snd A < snd x) by nra|assert (snd x < snd A) by nra]; exists 0%Z;
        (eapply around_imp; [|apply (around_and _ _ _ (around_right b x s XB) T)];
         intros u [U1 U2]; subst A B; decide_crossing).
    + exists 0%Z. eapply around_imp; [|apply (around_and _ _ _
        (around_right a x s ltac:(fold A; lra)) (around_right b x s XB))].
      intros u [U1 U2]. subst A B. decide_crossing.
Qed.
Lemma crossing_moves a b x s : ~ on_segment (moved_to s a) (moved_to s b) x ->
  exists C, around s (fun u =>
    crossing (moved_to u a) (moved_to u b) x = (C + switch s x b u - switch s x a u)%Z).
Proof.
  intros N. destruct (Rle_dec (fst (moved_to s a)) (fst (moved_to s b))) as [L|L].
  - apply crossing_moves_right; auto.
  - destruct (crossing_moves_right b a x s) as (C & H); [lra|intros K; apply N, segment_swap, K|].
    exists (- C)%Z. eapply around_imp; [|exact H]. intros u U. rewrite crossing_reversed, U. lia.
Qed.

(** ** Rings *)
Definition moved_edges (s : R) (E : list (track_t * track_t)) : list (point * point) :=
  map (both (moved_to s)) E.
Theorem winding_moves E x s : Permutation (map fst E) (map snd E) ->
  (forall a b, In (a, b) (moved_edges s E) -> ~ on_segment a b x) ->
  around s (fun u => winding (moved_edges u E) x = winding (moved_edges s E) x).
Proof.
  intros P N.
  assert (G : exists C, around s (fun u => winding (moved_edges u E) x =
    (C + sumz (fun v => switch s x v u) (map snd E)
       - sumz (fun v => switch s x v u) (map fst E))%Z)).
  { clear P. induction E as [|[a b] E IH].
    - exists 0%Z, 1. split; [lra|]. reflexivity.
    - destruct IH as (C & H); [intros u v I; apply N; simpl; auto|].
      destruct (crossing_moves a b x s) as (D & K); [apply N; simpl; auto|].
      exists (C + D)%Z. eapply around_imp; [|apply (around_and _ _ _ H K)]. intros u [U1 U2].
      change (winding (moved_edges u ((a, b) :: E)) x)
        with (crossing (moved_to u a) (moved_to u b) x + winding (moved_edges u E) x)%Z.
      rewrite U1, U2. unfold sumz. simpl. lia. }
  destruct G as (C & e & He & H). exists e. split; auto.
  assert (F : forall u, Rabs (u - s) < e -> winding (moved_edges u E) x = C).
  { intros u U. rewrite (H u U), (sumz_perm _ _ _ P). lia. }
  intros u U. rewrite (F u U), F; auto. rewrite Rminus_diag_eq, Rabs_R0; auto.
Qed.
Theorem winding_same E x s u : Permutation (map fst E) (map snd E) ->
  (forall v, s <= v <= u \/ u <= v <= s ->
    forall a b, In (a, b) (moved_edges v E) -> ~ on_segment a b x) ->
  winding (moved_edges s E) x = winding (moved_edges u E) x.
Proof.
  intros P N.
  apply (constant_on_segment (fun p => winding (moved_edges (fst p) E) x) (s, 0) (u, 0)).
  intros p (t & T & ->). cbn [fst snd]. set (v := s + t * (u - s)).
  destruct (winding_moves E x v P) as (e & He & H).
  - apply N. unfold v. destruct (Rle_dec s u); [left|right]; split; nra.
  - exists e. split; auto. intros q [Q _]. apply H. exact Q.
Qed.

(** ** Far away *)
Lemma edges_bound (E : list (point * point)) : exists r, 0 < r /\ forall a b, In (a, b) E ->
  near r (0, 0) a /\ near r (0, 0) b.
Proof.
  assert (One : forall p : point, exists r, 0 < r /\ near r (0, 0) p).
  { intros [p1 p2]. exists (Rabs p1 + Rabs p2 + 1). pose proof (Rabs_pos p1).
    pose proof (Rabs_pos p2). unfold near; cbn [fst snd]. rewrite !Rminus_0_r.
    repeat split; lra. }
  assert (More : forall r s p, r <= s -> near r (0, 0) p -> near s (0, 0) p)
    by (unfold near; intros r s p L [A B]; split; lra).
  induction E as [|[a b] E (r & Hr & H)]; [exists 1; split; [lra|intros a b []]|].
  destruct (One a) as (s & Hs & A). destruct (One b) as (t & Ht & B).
  exists (r + s + t). split; [lra|]. intros u v [K|I].
  - injection K; intros; subst. split; eapply More; eauto; lra.
  - destruct (H u v I). split; eapply More; eauto; lra.
Qed.
Lemma in_between a b t r : 0 <= t <= 1 -> - r < a < r -> - r < b < r -> - r < a + t * (b - a) < r.
Proof. intros T A B. destruct (Rle_dec a b); split; nra. Qed.
Theorem winding_far E : Permutation (map fst E) (map snd E) ->
  exists r, 0 < r /\ forall y, ~ near r (0, 0) y -> winding E y = 0%Z.
Proof.
  intros P. destruct (edges_bound E) as (r & Hr & B). destruct (winding_above E) as (h & H).
  exists r. split; auto. intros y Y.
  set (F := fun p : point => forall a b, In (a, b) E -> ~ on_segment a b p).
  assert (Near_ : forall p, near r (0, 0) p <-> (- r < fst p < r /\ - r < snd p < r)).
  { intros p. unfold near; cbn [fst snd]. rewrite !Rminus_0_r. split.
    - intros [A1 A2]. apply Rabs_def2 in A1. apply Rabs_def2 in A2. lra.
    - intros [A1 A2]. split; apply Rabs_def1; lra. }
  pose proof (Rmax_l r h). pose proof (Rmax_r r h). set (z := (0, Rmax r h + 1)).
  assert (J : joined F y z).
  { apply (outside_joined (- r) (- r) r r F); [lra|lra| | |].
    - intros p O a b I (t & T & ->). apply O. destruct (B a b I) as [A1 A2].
      apply Near_ in A1. apply Near_ in A2. destruct A1 as [A1 A3], A2 as [A2 A4].
      cbn [fst snd]. split; apply in_between; auto.
    - intros K. apply Y, Near_, K.
    - unfold z; cbn [fst snd]. intros [_ K]. lra. }
  rewrite (joined_constant F (winding E) y z J); [apply H; unfold z; cbn [fst snd]; lra|].
  intros p K. apply winding_near; auto.
Qed.
