(** Claims `escapes`, `trapped` and `trap` of docs/certificates-paths.md: the programs of Traps.v
    are right. *)
From Coq Require Import Lra Lia Psatz Bool Classical.
From Proved Require Import Definitions Predicates Ways Moving Points Member Sums Crossings Fans
  Curves Unions Local Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees
  Theorems Components Sides Paths Clear Bounds Free Collisions Common Valid Circling Traps.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** Ways out *)
Lemma place_moves s m : place_at s (moves m) = moved_to s (track m).
Proof. destruct m as [[x0 x1] [y0 y1]]. reflexivity. Qed.
Lemma along_places s (S : point -> Prop) d rest : forall first,
  (forall p q, In (p, q) (segments (first :: rest)) -> forall x,
    on_segment (place_at s p) (place_at s q) x -> S x) ->
  joined S (place_at s first) (place_at s (last (first :: rest) d)).
Proof.
  induction rest as [|next more IH]; intros first H; [apply here|].
  apply joined_join with (place_at s next).
  - apply joined_step. apply (H first next). simpl; auto.
  - apply IH. intros p q I. apply H. simpl. auto.
Qed.
Lemma first_segment (first : moving_place) rest :
  exists q, In (first, q) (segments_of (first :: rest)).
Proof. destruct rest as [|q more]; [exists first|exists q]; simpl; auto. Qed.
Lemma segments_segments {A} (l : list A) e : In e (segments l) -> In e (segments_of l).
Proof. destruct l as [|a [|b r]]; auto. intros []. Qed.
Lemma far_is_free c i r o of_r of_o e n s t : check_sides c r o of_r of_o = true \/
    is_empty r || is_empty o = true -> check_far c i r o of_r of_o e n = true -> in_scales i s ->
  0 <= t -> free c s (outline r) (outline o) (next_to e n t s).
Proof.
  intros Sides H Si T. unfold check_far in H. apply andb_prop in H. destruct H as [N H].
  destruct (is_empty r || is_empty o) eqn:Em; [apply empty_free, Em|].
  destruct Sides as [Sides|]; [|discriminate]. cbn [orb] in H.
  destruct (positive_on _ _ _ _ s H Si) as [V W]. apply (held_apart_free c s r o of_r of_o);
    [apply Si|exact Sides|]. intros la lb Ia Ib. unfold check_sides in Sides.
  rewrite !andb_true_iff in Sides. destruct Sides as [[Hr Ho] _].
  apply (level_apart c e n n (root of_r) (root of_o)); auto; try (eapply operand_tree; eauto).
  assert (E : worth_at (level e n n (root of_r) (root of_o)) t s = t * dot (real n) (real n) +
    (value (of_s (level e (zero, zero) n (root of_r) (root of_o))) * s +
     value (rest (level e (zero, zero) n (root of_r) (root of_o))))).
  { unfold worth_at, level; cbn [of_t of_s rest]. rewrite !value_reduced, real_dot. ring. }
  rewrite E. assert (D : 0 <= dot (real n) (real n)) by (unfold dot; nra).
  assert (0 <= t * dot (real n) (real n)) by (apply Rmult_le_pos; auto).
  destruct c; [right; split; [reflexivity|lra]|left]. specialize (W eq_refl). lra.
Qed.
Lemma ray_unbounded (e n : point) : n <> (0, 0) ->
  ~ bounded (fun y => exists t, 0 <= t /\ y = add e (scale t n)).
Proof.
  intros N (r & H). assert (D : 0 < dot n n) by (apply square_positive; exact N).
  set (K := (Rabs (fst n) + Rabs (snd n)) * Rabs r + Rabs (dot n e) + 1).
  pose proof (Rabs_pos (fst n)). pose proof (Rabs_pos (snd n)). pose proof (Rabs_pos r).
  pose proof (Rabs_pos (dot n e)).
  assert (P : 0 <= (Rabs (fst n) + Rabs (snd n)) * Rabs r) by (apply Rmult_le_pos; lra).
  destruct (H (add e (scale (K / dot n n) n))) as [A B].
  { exists (K / dot n n). split; [|reflexivity].
    apply Rmult_le_pos; [unfold K; lra|apply Rlt_le, Rinv_0_lt_compat, D]. }
  set (y := add e (scale (K / dot n n) n)) in *. cbn [fst snd] in *. rewrite Rminus_0_r in *.
  assert (E : dot n y = dot n e + K).
  { unfold y. replace (dot n (add e (scale (K / dot n n) n)))
      with (dot n e + K / dot n n * dot n n) by (unfold dot, add, scale; cbn [fst snd]; ring).
    field. lra. }
  assert (G : dot n y <= (Rabs (fst n) + Rabs (snd n)) * Rabs r).
  { unfold dot. pose proof (Rle_abs (fst n * fst y)) as G1.
    pose proof (Rle_abs (snd n * snd y)) as G2. rewrite Rabs_mult in G1, G2. pose proof (Rle_abs r).
    assert (Rabs (fst n) * Rabs (fst y) <= Rabs (fst n) * Rabs r) by (apply Rmult_le_compat_l; lra).
    assert (Rabs (snd n) * Rabs (snd y) <= Rabs (snd n) * Rabs r) by (apply Rmult_le_compat_l; lra).
    lra. }
  pose proof (Rle_abs (- dot n e)) as L. rewrite Rabs_Ropp in L. unfold K in E. lra.
Qed.
Theorem escapes_is_right : forall (c : touch) (i : scales) (r o : rings vertex) (x : vertex)
    (of_r of_o : tiled) (places : list moving_place) (legs : list (leg * list step)) (n : vertex),
  check_escapes c i r o x of_r of_o places legs n = true -> escapes c r o x i.
Proof.
  intros c i r o x of_r of_o places legs n H s Si. unfold check_escapes in H.
  rewrite !andb_true_iff in H. destruct H as [[First Way] Far].
  destruct (clear_holds _ _ _ _ _ _ _ _ s Way Si) as [Ne Free]. rewrite !outline_fixed in Free.
  destruct places as [|first rest]; [contradiction|]. cbn [hd] in First.
  unfold starts_at in First. apply andb_prop in First. destruct First as [F0 F1].
  apply same_real in F0. apply same_real in F1.
  assert (X : place_at s first = point_of x).
  { unfold place_at. rewrite F0, F1. unfold add, scale, real, fixed, point_of; cbn [fst snd value].
    rewrite value_zero. f_equal; ring. }
  set (S := free c s (points r) (points o)) in *.
  set (e := last (first :: rest) (stays x)) in *.
  assert (J : joined S (point_of x) (place_at s e)).
  { rewrite <- X. apply along_places. intros p q I. apply Free, segments_segments, I. }
  assert (Sides : check_sides c (fixed_rings r) (fixed_rings o) of_r of_o = true \/
    is_empty (fixed_rings r) || is_empty (fixed_rings o) = true).
  { unfold check_clear in Way. apply andb_prop in Way. destruct Way as [_ Way].
    apply orb_prop in Way. destruct Way as [Way|Way]; [auto|]. apply andb_prop in Way. tauto. }
  assert (Ray : forall t, 0 <= t -> S (add (place_at s e) (scale t (real (fixed n))))).
  { intros t T. pose proof (far_is_free _ _ _ _ _ _ _ _ s t Sides Far Si T) as K.
    rewrite !outline_fixed in K. exact K. }
  split.
  - destruct (first_segment first rest) as (q & I). apply (Free first q I). rewrite X.
    exists 0. split; [lra|]. destruct (point_of x). simpl. f_equal; ring.
  - intros (b & B). apply (ray_unbounded (place_at s e) (real (fixed n))).
    + unfold check_far in Far. apply andb_prop in Far. destruct Far as [N _].
      apply distinct_real in N. intros E. apply N. rewrite E. unfold real; cbn [fst snd].
      rewrite value_zero. reflexivity.
    + exists b. intros y (t & T & ->). apply B. unfold reached. fold S.
      apply joined_join with (place_at s e); [exact J|]. apply joined_step.
      intros p (u & U & ->). set (k := real (fixed n)) in *.
      replace (fst _ + u * _, snd _ + u * _) with (add (place_at s e) (scale (u * t) k))
        by (unfold add, scale; cbn [fst snd]; f_equal; ring).
      apply Ray. apply Rmult_le_pos; lra.
Qed.

(** ** Rings *)
Lemma edge_collides c i r o of_r of_o m1 m2 k s x :
  check_sides c r o of_r of_o = true -> check_edge c i of_r of_o (m1, m2) k = true ->
  in_scales i s -> on_segment (moved_to s (track m1)) (moved_to s (track m2)) x ->
  collides c s (outline r) (outline o) x.
Proof.
  intros Sides H Si (u & U & X). unfold check_edge in H.
  rewrite andb_true_iff, forallb_forall in H. destruct H as [Cov H].
  destruct (covers_all _ i s Cov Si) as (j & J & Sj). apply in_map_iff in J.
  destruct J as (h & <- & J). specialize (H h J). cbn [fst snd] in H. apply andb_prop in H.
  destruct H as [H1 H2]. unfold solids_share in H1, H2.
  destruct (nth_error (solids of_r) (fst (fst k))) as [a|] eqn:Ea; [|discriminate].
  destruct (nth_error (solids of_o) (snd (fst k))) as [b|] eqn:Eb; [|discriminate].
  apply (shares_holds c _ _ _ _ _ s) in H1; auto. apply (shares_holds c _ _ _ _ _ s) in H2; auto.
  pose proof (shared_between _ _ _ _ _ _ _ _ u H1 H2 U) as K. rewrite !place_moves in K.
  change (at_ (moved_to s (track m1)) (moved_to s (track m2)) u) with
    (fst (moved_to s (track m1)) + u * (fst (moved_to s (track m2)) - fst (moved_to s (track m1))),
     snd (moved_to s (track m1)) + u * (snd (moved_to s (track m2)) - snd (moved_to s (track m1))))
    in K. rewrite <- X in K.
  eapply shared_collides; eauto using nth_error_In. apply Si.
Qed.
Lemma scales_between i s u v : in_scales i s -> in_scales i u -> s <= v <= u \/ u <= v <= s ->
  in_scales i v.
Proof.
  intros (S & Ls & Us) (U & Lu & Uu) V. split; [lra|split].
  - destruct V as [V|V]; [destruct Ls as [L|[L1 L2]]|destruct Lu as [L|[L1 L2]]]; try (left; lra).
    + destruct (Req_dec v s) as [->|]; [auto|left; lra].
    + destruct (Req_dec v u) as [->|]; [auto|left; lra].
  - destruct (high i) as [b|]; [|exact I].
    destruct V as [V|V]; [destruct Uu as [L|[L1 L2]]|destruct Us as [L|[L1 L2]]]; try (left; lra).
    + destruct (Req_dec v u) as [->|]; [auto|left; lra].
    + destruct (Req_dec v s) as [->|]; [auto|left; lra].
Qed.
Lemma among_scales i s : is_among i s = true -> in_scales i (Q2R s).
Proof.
  unfold is_among. rewrite !andb_true_iff, orb_true_iff, andb_true_iff. intros [[P L] U].
  apply less_real in P. rewrite Rational.Q2R_zero in P. split; [exact P|split].
  - destruct L as [L|[L1 L2]]; [left; apply less_real, L|right; split; auto; apply eq_real, L2].
  - destruct (high i); [|exact I]. apply orb_prop in U. destruct U as [U|U];
      [left; apply less_real, U|]. apply andb_prop in U. destruct U as [U1 U2].
    right. split; auto. apply eq_real, U2.
Qed.
Lemma corner_at_real s m : point_of (corner_at s m) = moved_to (Q2R s) (track m).
Proof.
  destruct m as [[x0 x1] [y0 y1]]. unfold corner_at, point_of, moved_to, track; cbn [fst snd].
  rewrite !Rational.Q2R_red, !Q2R_plus, !Q2R_mult. reflexivity.
Qed.
Theorem trapped_is_right : forall (c : touch) (i : scales) (r o : rings vertex) (x : vertex)
    (of_r of_o : tiled) (t : trapping),
  check_trapped c i r o x of_r of_o t = true -> is_trapped c r o x i.
Proof.
  intros c i r o x of_r of_o t H s Si. unfold check_trapped in H. rewrite !andb_true_iff in H.
  destruct H as [[[[Sides Here_] Edges] Among] Wind]. apply among_scales in Among.
  set (E := ring_edges (map track (ring t))).
  assert (P : Permutation.Permutation (map fst E) (map snd E)) by apply ring_closed.
  assert (Met : forall u, in_scales i u -> forall p, free_at c r o u p ->
    forall a b, In (a, b) (moved_edges u E) -> ~ on_segment a b p).
  { intros u Su p Fp a b I X. apply Fp. unfold moved_edges, E in I. rewrite ring_edges_map in I.
    rewrite map_map in I. apply in_map_iff in I. destruct I as ([m1 m2] & K & I).
    injection K; intros <- <-. destruct (all2_partner _ _ _ Edges _ I) as (k & L).
    rewrite <- !outline_fixed. eapply edge_collides; eauto. }
  assert (Free : forall u, in_scales i u -> free_at c r o u (point_of x)).
  { intros u Su. apply (free_is_right _ _ _ _ _ _ _ _ Here_); auto.
    exists (point_of x), (point_of x). split; [simpl; auto|]. exists 0. split; [lra|].
    destruct (point_of x). simpl. f_equal; ring. }
  assert (W : winding (moved_edges s E) (point_of x) <> 0%Z).
  { rewrite (winding_same E (point_of x) s (Q2R (some_scale t)) P).
    - intros Z. apply negb_true_iff, Z.eqb_neq in Wind. apply Wind. rewrite winding_real, <- Z.
      apply (f_equal (fun l => winding l (point_of x))). unfold moved_edges, E.
      change R2e with (both point_of). rewrite <- !ring_edges_map, !map_map.
      apply (f_equal ring_edges), map_ext. intros m. apply corner_at_real.
    - intros v V. pose proof (scales_between i s _ v Si Among V) as Sv.
      exact (Met v Sv _ (Free v Sv)). }
  split; [apply Free, Si|].
  destruct (winding_far (moved_edges s E)) as (b & _ & B).
  { unfold moved_edges, E. rewrite <- ring_edges_map. apply ring_closed. }
  exists b. intros y J. apply NNPP. intros N. apply W. rewrite <- (B y N).
  apply (joined_constant _ _ _ _ J). intros p Fp. apply winding_near.
  - unfold moved_edges, E. rewrite <- ring_edges_map. apply ring_closed.
  - apply (Met s Si p Fp).
Qed.
Theorem trap_is_right : forall (c : touch) (i : scales) (l : list scales) (r o : rings vertex)
    (x : vertex) (of_r of_o : tiled) (claims : list (scales * trap_claim)),
  check_trap c i l r o x of_r of_o claims = true -> is_trap c r o x i l.
Proof.
  intros c i l r o x of_r of_o claims H. unfold check_trap in H.
  rewrite andb_true_iff, forallb_forall in H. destruct H as [F H].
  refine (follow_right i l _ (is_kept c r o x) F _ _); intros j J s Sj; apply in_map_iff in J;
    destruct J as ([k w] & E & J); specialize (H _ J); unfold check_stay in H; simpl in E, H;
    injection E; intros Ew <-; destruct w as [places legs n|t|hits]; try discriminate.
  - apply (trapped_is_right _ _ _ _ _ _ _ _ H s Sj).
  - intros [_ B]. apply (escapes_is_right _ _ _ _ _ _ _ _ _ _ H s Sj). exact B.
  - intros [K _]. destruct (hit_is_right _ _ _ _ _ _ _ _ H s Sj) as (y & (a & b & I & Y) & C).
    simpl in I. destruct I as [I|[]]. injection I; intros <- <-. destruct Y as (u & U & ->).
    apply K. replace (point_of x) with
      (fst (point_of x) + u * (fst (point_of x) - fst (point_of x)),
       snd (point_of x) + u * (snd (point_of x) - snd (point_of x))); [exact C|].
    destruct (point_of x). simpl. f_equal; ring.
Qed.
