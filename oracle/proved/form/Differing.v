(** Order of points and of rings, and points that differ wherever they move. *)
From Coq Require Import Lra Lia Psatz Bool Permutation.
From Proved Require Import Definitions Form Curves Numbers Rational Values Figures Corners.
Open Scope R_scope.

Section Here.
Context {now : scale_here}.

(** ** Order *)
Lemma qbefore_real p q : qbefore p q = true -> before (real p) (real q).
Proof.
  unfold qbefore, before. rewrite orb_true_iff, andb_true_iff. intros [H|[H1 H2]].
  - left. apply lt_value in H. exact H.
  - right. split; [apply equal_value, H1|apply lt_value, H2].
Qed.
Lemma qring_before_real l : forall k, qring_before l k = true ->
  ring_before (map real l) (map real k).
Proof.
  induction l as [|p l IH]; intros [|q k] H; try discriminate; simpl; auto.
  simpl in H. apply orb_prop in H. destruct H as [H|H]; [left; apply qbefore_real, H|right].
  apply andb_prop in H. split; [apply same_real; tauto|apply IH; tauto].
Qed.
Lemma ascends_sorted {A B} (f : A -> A -> bool) (g : A -> B) (R : B -> B -> Prop) :
  (forall x y, f x y = true -> R (g x) (g y)) -> forall l, ascends f l = true ->
  Sorted R (map g l).
Proof.
  intros H. induction l as [|x l IH]; simpl; intros K; [apply Sorted_nil|].
  apply andb_prop in K. destruct K as [K1 K2]. apply Sorted_cons; auto.
  destruct l as [|y l]; simpl; [apply HdRel_nil|apply HdRel_cons, H, K1].
Qed.
Lemma before_transitive p q r : before p q -> before q r -> before p r.
Proof. unfold before. lra. Qed.
Lemma ascending_differ l : Sorted before l -> NoDup l.
Proof.
  intros H. apply Sorted_StronglySorted in H; [|exact before_transitive].
  induction H as [|p l H IH F]; [apply NoDup_nil|]. apply NoDup_cons; auto.
  intros I. rewrite Forall_forall in F. specialize (F p I). unfold before in F. lra.
Qed.

(** ** Points that differ *)
Lemma keep_apart_real a b : keep_apart a b = true -> real a <> real b.
Proof.
  unfold keep_apart. intros H K. apply orb_prop in H. destruct H as [H|H].
  - exact (distinct_real _ _ H K).
  - apply differ_value in H. apply H. rewrite !real_dot, K. reflexivity.
Qed.
Lemma sooner_real p q : sooner p q = true -> before (point_of p) (point_of q).
Proof.
  unfold sooner, before. rewrite orb_true_iff, andb_true_iff. intros [H|[H1 H2]].
  - left. apply less_real in H. exact H.
  - right. split; [apply eq_real, H1|apply less_real, H2].
Qed.
Lemma flat_map_whole {A B} (f : A -> list B) : (forall a, (length (f a) <= 1)%nat) -> forall l,
  length (flat_map f l) = length l -> Forall2 (fun a b => f a = [b]) l (flat_map f l).
Proof.
  intros One. assert (Less : forall l, (length (flat_map f l) <= length l)%nat).
  { induction l as [|a l IH]; simpl; auto. rewrite app_length. specialize (One a). lia. }
  induction l as [|a l IH]; simpl; intros H; [apply Forall2_nil|]. rewrite app_length in H.
  specialize (One a). specialize (Less l).
  destruct (f a) as [|b [|? ?]] eqn:E; simpl in *; try lia. apply Forall2_cons; auto.
Qed.
Lemma fixed_vertex_one p : (length (fixed_vertex p) <= 1)%nat.
Proof. destruct p as [[x|k] [y|l]]; simpl; auto. Qed.
Lemma fixed_vertex_real p v : fixed_vertex p = [v] -> real p = point_of v.
Proof.
  destruct p as [[x|k] [y|l]]; try discriminate. simpl. intros H. injection H; intros <-.
  reflexivity.
Qed.
Lemma span_of_one p : (length (span_of p) <= 1)%nat.
Proof.
  unfold span_of. destruct (fst p) as [x|[|a [|b [|? ?]]]]; simpl; auto.
  destruct (Qle_bool a b); auto.
Qed.
Lemma span_of_real p s : span_of p = [s] -> snd s = p /\
  Q2R (fst (fst s)) <= value (fst p) <= Q2R (snd (fst s)).
Proof.
  assert (E : forall a b, value (Moving [a; b]) = (Q2R a + moment * Q2R b) / (1 + moment)).
  { intros a b. pose proof moment_positive. unfold value, worth, form, power; simpl. field. lra. }
  assert (G : forall a b, Q2R a <= Q2R b -> Q2R a <= value (Moving [a; b]) <= Q2R b /\
    Q2R a <= value (Moving [b; a]) <= Q2R b).
  { intros a b L. pose proof moment_positive as M. rewrite !E.
    assert (I : 0 < / (1 + moment)) by (apply Rinv_0_lt_compat; lra).
    assert (K : forall u v, v * (1 + moment) <= u -> v <= u / (1 + moment)).
    { intros u v H. apply Rmult_le_reg_r with (1 + moment); [lra|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l; lra. }
    assert (K' : forall u v, u <= v * (1 + moment) -> u / (1 + moment) <= v).
    { intros u v H. apply Rmult_le_reg_r with (1 + moment); [lra|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l; lra. }
    repeat split; [apply K|apply K'|apply K|apply K']; nra. }
  unfold span_of. destruct p as [[x|[|a [|b [|? ?]]]] y]; cbn [fst snd]; try discriminate.
  - intros H. injection H; intros <-. simpl. split; auto. lra.
  - intros H. injection H; intros <-. cbn [fst snd]. split; auto.
    unfold value, worth, form, power; simpl. unfold Rdiv. rewrite Rinv_1. lra.
  - destruct (Qle_bool a b) eqn:L; intros H; injection H; intros <-; cbn [fst snd]; split; auto.
    + apply G, le_real, L.
    + apply G, Rlt_le, less_real. unfold less. rewrite L. reflexivity.
Qed.
Definition is_span (s : span) : Prop :=
  Q2R (fst (fst s)) <= value (fst (snd s)) <= Q2R (snd (fst s)).
Lemma clear_differ l : StronglySorted (fun p q => Spans.leb p q = true) l ->
  (forall s, In s l -> is_span s) -> are_clear l = true -> NoDup (map real (map snd l)).
Proof.
  induction 1 as [|p l St IH F]; intros W H; [apply NoDup_nil|].
  simpl in H. apply andb_prop in H. destruct H as [C H]. cbn [map]. apply NoDup_cons.
  2: { apply IH; auto. intros s I. apply W. simpl; auto. }
  assert (Wp : is_span p) by (apply W; simpl; auto).
  assert (Wl : forall s, In s l -> is_span s) by (intros s I; apply W; simpl; auto).
  clear IH W H F. intros I. apply in_map_iff in I. destruct I as (c & E & I).
  apply in_map_iff in I. destruct I as (q & <- & I). revert I E.
  induction St as [|r l St IH F]; intros I E; [destruct I|]. simpl in C.
  destruct (less (snd (fst p)) (fst (fst r))) eqn:L.
  - apply less_real in L.
    assert (R : Q2R (fst (fst r)) <= Q2R (fst (fst q))).
    { destruct I as [->|I]; [lra|]. rewrite Forall_forall in F. apply le_real, (F q I). }
    specialize (Wl q I). unfold is_span in Wp, Wl. apply (f_equal fst) in E. simpl in E. lra.
  - apply andb_prop in C. destruct C as [A C]. destruct I as [->|I].
    + apply keep_apart_real in A. auto.
    + apply IH; auto. intros s J. apply Wl. simpl; auto.
Qed.
Lemma all_differ_real l : all_differ l = true -> NoDup (map real l).
Proof.
  unfold all_differ. destruct (Nat.eqb _ _) eqn:N.
  - intros H. apply Nat.eqb_eq in N. apply (flat_map_whole _ fixed_vertex_one) in N.
    replace (map real l) with (map point_of (flat_map fixed_vertex l)).
    + apply (ascends_sorted _ point_of before sooner_real) in H. apply ascending_differ in H.
      eapply Permutation_NoDup; [|exact H].
      apply Permutation_map, Permutation_sym, VertexSort.Permuted_sort.
    + clear H. induction N as [|p v l k E N IH]; simpl; auto.
      rewrite (fixed_vertex_real p v E). f_equal. exact IH.
  - rewrite !andb_true_iff. intros [S [A C]]. clear N. apply Nat.eqb_eq in S.
    apply (flat_map_whole _ span_of_one) in S.
    set (spans := flat_map span_of l) in *.
    assert (W : map snd spans = l /\ forall s, In s spans -> is_span s).
    { clear A C. induction S as [|p s l k E S IH]; simpl; [split; [auto|tauto]|].
      destruct IH as [I1 I2]. destruct (span_of_real p s E) as [E1 E2]. split; [congruence|].
      intros s' [<-|I]; auto. unfold is_span. rewrite E1. exact E2. }
    destruct W as [W1 W2]. rewrite <- W1.
    eapply Permutation_NoDup; [apply Permutation_map, Permutation_map, Permutation_sym,
      SpanSort.Permuted_sort|].
    apply clear_differ; auto.
    + apply Sorted_StronglySorted.
      * intros a b c. unfold Spans.leb. rewrite !Qle_bool_iff. apply Qle_trans.
      * rewrite <- (map_id (SpanSort.sort spans)). apply (ascends_sorted Spans.leb); auto.
    + intros s I. apply W2. eapply Permutation_in; [|exact I].
      apply Permutation_sym, SpanSort.Permuted_sort.
Qed.
End Here.
