(** Claims `hit` and `valid` of docs/certificates-paths.md: the programs of Collisions.v are
    right. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components
  Paths Clear Bounds Free Collisions Common.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** Scales that follow each other *)
Lemma less_not x y : less x y = false -> Q2R y <= Q2R x.
Proof. unfold less. rewrite negb_false_iff. apply le_real. Qed.
Lemma differ_real x y : Qeq_bool x y = false -> Q2R x <> Q2R y.
Proof. intros H E. apply eqR_Qeq, Qeq_bool_iff in E. congruence. Qed.
Lemma void_none i s : is_void i = true -> in_scales i s -> False.
Proof.
  unfold is_void, in_scales. intros H (_ & L & U). destruct (high i) as [b|]; [|discriminate].
  apply orb_prop in H. destruct H as [H|H]; [apply less_real in H; destruct L, U; lra|].
  apply andb_prop in H. destruct H as [E N]. apply eq_real in E. apply negb_true_iff in N.
  destruct L as [L|[L1 L2]], U as [U|[U1 U2]]; try lra. rewrite L1, U1 in N. discriminate.
Qed.
Lemma starts_low i first s : starts_by i first = true -> in_scales i s ->
  Q2R (low first) < s \/ (low_in first = true /\ s = Q2R (low first)).
Proof.
  unfold starts_by. rewrite !orb_true_iff, andb_true_iff, orb_true_iff. intros H (S & L & _).
  destruct H as [[H|H]|[E H]].
  - apply less_real in H. destruct L; lra.
  - apply le_real in H. rewrite Q2R_zero in H. lra.
  - apply eq_real in E. destruct L as [L|[L1 L2]]; [lra|]. rewrite L1 in H.
    destruct H as [H|H]; [|discriminate]. right. split; [exact H|lra].
Qed.
Lemma after_scales b b_in i s : in_scales i s -> Q2R b < s \/ (s = Q2R b /\ b_in = false) ->
  in_scales (after b b_in i) s.
Proof.
  intros (S & L & U) H. unfold after. destruct (less b (low i)) eqn:E; [repeat split; auto|].
  apply less_not in E. split; [exact S|split; [|exact U]]. cbn [low low_in].
  destruct H as [H|[-> ->]]; [auto|]. right. split; [|reflexivity]. rewrite andb_true_r.
  destruct (Qeq_bool b (low i)) eqn:F; [|reflexivity]. apply eq_real in F.
  destruct L as [L|[L _]]; [lra|exact L].
Qed.
Theorem covers_all l : forall i s, covers i l = true -> in_scales i s -> in_some l s.
Proof.
  induction l as [|first more IH]; intros i s H Si; simpl in H; apply orb_prop in H;
    destruct H as [H|H]; try (destruct (void_none i s H Si)); try discriminate.
  apply andb_prop in H. destruct H as [H1 H2]. pose proof (starts_low i first s H1 Si) as L.
  assert (Here_ : forall U, match high first with None => True | Some b => s < Q2R b \/
      (high_in first = true /\ s = Q2R b) end = U -> U -> in_some (first :: more) s).
  { intros U <- K. exists first. split; [simpl; auto|].
    split; [apply Si|split; [exact L|exact K]]. }
  destruct (high first) as [b|]; [|apply (Here_ _ eq_refl); exact I].
  assert (D : (s < Q2R b \/ (high_in first = true /\ s = Q2R b)) \/
    (Q2R b < s \/ (s = Q2R b /\ high_in first = false))).
  { destruct (Rtotal_order s (Q2R b)) as [C|[C|C]]; auto. destruct (high_in first); auto. }
  destruct D as [D|D]; [apply (Here_ _ eq_refl), D|].
  destruct (IH _ s H2 (after_scales b _ i s Si D)) as (j & J & K). exists j. simpl; auto.
Qed.
Lemma follow_right i l claims (holds : R -> Prop) : follow_each_other i l claims = true ->
  (forall j, In (j, true) claims -> forall s, in_scales j s -> holds s) ->
  (forall j, In (j, false) claims -> forall s, in_scales j s -> ~ holds s) ->
  forall s, in_some l s <-> in_scales i s /\ holds s.
Proof.
  unfold follow_each_other. rewrite !andb_true_iff, !forallb_forall.
  intros [[All Listed] Yes] Hyes Hno s.
  assert (InYes : forall j, In j (map fst (filter snd claims)) <-> In (j, true) claims).
  { intros j. rewrite in_map_iff. split.
    - intros ([k f] & <- & J). apply filter_In in J. destruct J as [J F]. simpl in F. subst f. auto.
    - intros J. exists (j, true). split; auto. apply filter_In. auto. }
  split.
  - intros (v & I & Sv). specialize (Listed v I). apply andb_prop in Listed.
    destruct Listed as [L1 L2]. split.
    + destruct (covers_all _ _ s L1 Sv) as (k & [<-|[]] & K). exact K.
    + destruct (covers_all _ _ s L2 Sv) as (j & J & K). apply InYes in J. eapply Hyes; eauto.
  - intros [Si H]. destruct (covers_all _ _ s All Si) as (j & J & K). apply in_map_iff in J.
    destruct J as ([k f] & E & J). simpl in E. subst k. destruct f.
    + apply InYes in J. apply (covers_all _ j s (Yes j J) K).
    + destruct (Hno j J s K H).
Qed.

(** ** Claims *)
Lemma solids_collide c i r o of_r of_o ab x y s : check_sides c r o of_r of_o = true ->
  solids_share c i of_r of_o ab x y = true -> in_scales i s ->
  collides c s (outline r) (outline o) (place_at s x).
Proof.
  intros H K Si. unfold solids_share in K.
  destruct (nth_error (solids of_r) (fst ab)) as [a|] eqn:Ea; [|discriminate].
  destruct (nth_error (solids of_o) (snd ab)) as [b|] eqn:Eb; [|discriminate].
  apply (shared_collides c s r o of_r of_o a b _ (place_at s y) (proj1 Si) H
    (nth_error_In _ _ Ea) (nth_error_In _ _ Eb)). apply (shares_holds c i); auto.
Qed.
Theorem hit_is_right : forall (c : touch) (i : scales) (r o : rings vertex) (path : list vertex)
    (of_r of_o : tiled) (hits : list hit),
  check_hit c i r o path of_r of_o hits = true -> is_hit c r o path i.
Proof.
  intros c i r o path of_r of_o hits H s Si. unfold check_hit in H.
  rewrite !andb_true_iff, forallb_forall in H. destruct H as [[Sides Cov] H].
  destruct (covers_all _ i s Cov Si) as (j & J & Sj). apply in_map_iff in J.
  destruct J as (h & <- & J). specialize (H h J). unfold is_one_hit in H.
  destruct (nth_error _ (segment h)) as [[p q]|] eqn:E; [|discriminate].
  rewrite !andb_true_iff in H. destruct H as [[T0 T1] K].
  apply nth_error_In in E. rewrite segments_of_map in E. apply in_map_iff in E.
  destruct E as ([v w] & E & I). injection E; intros; subst p q. clear E.
  apply (positive_on _ _ _ _ s) in T0; auto. apply (positive_on _ _ _ _ s) in T1; auto.
  destruct T0 as [T0 _], T1 as [T1 _]. rewrite !value_minus, value_one, value_zero in T1.
  exists (place_at s (place_of (fixed v) (fixed w) h)). split.
  - exists (point_of v), (point_of w). split.
    + rewrite segments_of_map. apply in_map_iff. exists (v, w). auto.
    + exists (value (along_speed h) * s + value (along_start h)). split; [lra|].
      unfold place_at, place_of, qadd, qminus, add, scale, real, fixed, point_of; cbn [fst snd].
      rewrite !value_plus, !value_times, !value_minus. cbn [value]. f_equal; ring.
  - rewrite <- !outline_fixed. eapply solids_collide; eauto.
Qed.
Theorem valid_is_right : forall (c : touch) (i : scales) (l : list scales) (r o : rings vertex)
    (path : list vertex) (of_r of_o : tiled) (claims : list (scales * way_claim)),
  check_valid c i l r o path of_r of_o claims = true -> is_valid c r o path i l.
Proof.
  intros c i l r o path of_r of_o claims H. unfold check_valid in H.
  rewrite !andb_true_iff, forallb_forall in H. destruct H as [[Ne F] H].
  split; [intros ->; discriminate|].
  apply (follow_right i l _ (fun s => forall x, on_path (map point_of path) x ->
    free_at c r o s x) F); intros j J s Sj; apply in_map_iff in J; destruct J as ([k w] & E & J);
    specialize (H _ J); unfold check_way in H; simpl in E, H; injection E; intros Ew <-;
    destruct w as [legs|hits]; try discriminate.
  - apply (free_is_right _ _ _ _ _ _ _ _ H). exact Sj.
  - intros Free. destruct (hit_is_right _ _ _ _ _ _ _ _ H s Sj) as (x & X & K).
    apply (Free x X K).
Qed.
