(** Where the next pieces are the pieces, the traced rings are cycles that part them: each piece is
    in one ring, once. *)
From Coq Require Import Lia Bool Permutation Classical.
From Proved Require Import Definitions Points Pieces Traced.

Section Cycles.
Variable E : list edge.
Hypothesis there : forall e, In e E -> exists h, next_piece E e = Some h /\ In h E.
Hypothesis once : forall e f h, In e E -> In f E -> next_piece E e = Some h ->
  next_piece E f = Some h -> e = f.
Hypothesis no_twin : forall e f, In e E -> In f E -> same_edge e f = true -> e = f.
Hypothesis same_self : forall e, same_edge e e = true.
Hypothesis E_once : NoDup E.

(** Pieces from e to z, each the next one of that before *)
Inductive run : edge -> list edge -> edge -> Prop :=
| run_one e : run e [e] e
| run_more e f l z : next_piece E e = Some f -> run f l z -> run e (e :: l) z.
Definition is_cycle (l : list edge) : Prop :=
  exists e z, run e l z /\ next_piece E z = Some e /\ NoDup l.

Lemma run_first e l z : run e l z -> In e l.
Proof. destruct 1; simpl; auto. Qed.
Lemma run_last e l z : run e l z -> In z l.
Proof. induction 1; simpl; auto. Qed.
Lemma run_before e l z : run e l z -> forall f, In f l -> f = e \/
  exists g, In g l /\ next_piece E g = Some f.
Proof.
  induction 1 as [e|e f l z N R IH]; intros g I.
  - destruct I as [<-|[]]. auto.
  - destruct I as [<-|I]; [auto|]. right. destruct (IH g I) as [->|(h & J & H)].
    + exists e. simpl. auto.
    + exists h. simpl. auto.
Qed.
Lemma run_on e l z f : run e l z -> next_piece E z = Some f -> run e (l ++ [f]) f.
Proof.
  induction 1 as [e|e g l z N R IH]; intros H; simpl.
  - apply run_more with f; auto. apply run_one.
  - apply run_more with g; auto.
Qed.
Lemma run_inside (P : edge -> Prop) e l z : (forall a b, P a -> next_piece E a = Some b -> P b) ->
  run e l z -> P e -> forall a, In a l -> P a.
Proof.
  intros H R. induction R as [e|e f l z N R IH]; intros Pe a I.
  - destruct I as [<-|[]]. auto.
  - destruct I as [<-|I]; auto. apply IH; auto. apply (H e); auto.
Qed.

Lemma traced n : forall pre begin e,
  (pre = [] /\ begin = e \/ exists y, run begin pre y /\ next_piece E y = Some e) ->
  NoDup (pre ++ [e]) -> (forall a, In a (pre ++ [e]) -> In a E) ->
  (length E <= n + length pre)%nat ->
  exists z, run e (trace n E begin e) z /\ next_piece E z = Some begin /\
    NoDup (pre ++ trace n E begin e).
Proof.
  induction n as [|n IH]; intros pre begin e Way Nd In_E L.
  - exfalso. pose proof (NoDup_incl_length Nd In_E) as K. rewrite app_length in K. simpl in *. lia.
  - assert (Ie : In e E) by (apply In_E, in_or_app; simpl; auto).
    assert (Ib : In begin E).
    { destruct Way as [[-> ->]|(y & R & _)]; auto. apply In_E, in_or_app. left.
      exact (run_first _ _ _ R). }
    destruct (there e Ie) as (f & N & If). cbn [trace]. rewrite N.
    destruct (same_edge f begin) eqn:S.
    + apply no_twin in S; auto. subst f. exists e. split; [apply run_one|]. auto.
    + assert (Ne : f <> begin) by (intros ->; rewrite same_self in S; discriminate).
      assert (Pre : forall a, In a pre -> a <> e).
      { intros a I ->. apply NoDup_remove_2 in Nd. apply Nd. rewrite app_nil_r. exact I. }
      assert (New : ~ In f (pre ++ [e])).
      { intros I. apply in_app_or in I.
        assert (G : exists g, In g pre /\ next_piece E g = Some f).
        { destruct Way as [[-> ->]|(y & R & H)].
          - destruct I as [[]|[<-|[]]]. destruct (Ne eq_refl).
          - destruct I as [I|[<-|[]]].
            + destruct (run_before _ _ _ R f I) as [->|G]; [destruct (Ne eq_refl)|exact G].
            + exists y. split; auto. exact (run_last _ _ _ R). }
        destruct G as (g & J & H). apply (Pre g J). apply (once g e f); auto.
        apply In_E, in_or_app. auto. }
      destruct (IH (pre ++ [e]) begin f) as (z & R & H & D).
      * right. exists e. split; auto. destruct Way as [[-> ->]|(y & R & H)]; [apply run_one|].
        apply run_on with y; auto.
      * apply (Permutation_NoDup (Permutation_cons_append (pre ++ [e]) f)). constructor; auto.
      * intros a I. apply in_app_or in I. destruct I as [I|[<-|[]]]; auto.
      * rewrite app_length. simpl. lia.
      * exists z. split; [apply run_more with f; auto|]. split; auto.
        rewrite <- app_assoc in D. exact D.
Qed.
Lemma trace_cycle e : In e E -> exists z, run e (trace (length E) E e e) z /\
  next_piece E z = Some e /\ NoDup (trace (length E) E e e).
Proof.
  intros I. apply (traced (length E) [] e e); simpl; auto; [repeat constructor; auto| |lia].
  intros a [<-|[]]. exact I.
Qed.
Lemma traces_part n : forall left, (length left <= n)%nat -> NoDup left ->
  (forall a, In a left -> In a E) ->
  (forall a b, In a left -> next_piece E a = Some b -> In b left) ->
  Permutation (concat (traces n E left)) left /\
  forall ring, In ring (traces n E left) -> is_cycle ring.
Proof.
  induction n as [|n IH]; intros left L Nd In_E Next.
  - destruct left; simpl in *; [split; [auto|intros ring []]|lia].
  - destruct left as [|e l]; [simpl; split; [auto|intros ring []]|]. set (left := e :: l) in *.
    cbn [traces]. fold left. set (ring := trace (length E) E e e).
    destruct (trace_cycle e) as (z & R & Z & D); [apply In_E; simpl; auto|]. fold ring in R, D.
    assert (Sub : forall a, In a ring -> In a left).
    { apply (run_inside (fun a => In a left) e ring z Next R). simpl. auto. }
    set (rest := filter (fun f => negb (existsb (same_edge f) ring)) left).
    assert (Rest : forall a, In a rest <-> In a left /\ ~ In a ring).
    { intros a. unfold rest. rewrite filter_In, negb_true_iff. split; intros [I H]; split; auto.
      - intros J. apply not_true_iff_false in H. apply H, existsb_exists. exists a. auto.
      - apply not_true_iff_false. intros X. apply existsb_exists in X. destruct X as (b & J & Q).
        apply no_twin in Q; auto. subst. auto. }
    assert (Perm : Permutation (ring ++ rest) left).
    { apply NoDup_Permutation; auto.
      - assert (Dr : NoDup rest) by (apply NoDup_filter, Nd). clear - D Dr Rest.
        assert (Dis : forall a, In a ring -> ~ In a rest) by (intros a I J; apply Rest in J; tauto).
        clear Rest. clearbody ring rest. induction ring as [|a k IH]; simpl; auto.
        inversion D; subst. constructor.
        + intros I. apply in_app_or in I. destruct I; auto. apply (Dis a); simpl; auto.
        + apply IH; auto. intros b I. apply Dis. simpl. auto.
      - intros a. rewrite in_app_iff, Rest. split; [intros [I|[I _]]; auto|]. intros I.
        destruct (classic (In a ring)); auto. }
    destruct (IH rest) as (P & C).
    + apply Permutation_length in Perm. rewrite app_length in Perm.
      pose proof (run_first _ _ _ R) as F. destruct ring; [destruct F|]. simpl in Perm, L.
      unfold left in *. simpl in *. lia.
    + apply NoDup_filter, Nd.
    + intros a I. apply In_E, Rest, I.
    + intros a b I N. apply Rest in I. destruct I as [I J]. apply Rest.
      split; [apply (Next a); auto|].
      intros Ib. apply J. destruct (run_before _ _ _ R b Ib) as [->|(g & Ig & Ng)].
      * replace a with z; [exact (run_last _ _ _ R)|]. apply (once z a e); auto.
        apply In_E, Sub, (run_last _ _ _ R).
      * replace a with g; auto. apply (once g a b); auto.
    + split.
      * cbn [concat]. apply Permutation_trans with (ring ++ rest); [|exact Perm].
        apply Permutation_app_head, P.
      * intros k [<-|I]; auto. exists e, z. auto.
Qed.
(** The rings of a class *)
Theorem traces_are_cycles : Permutation (concat (traces (length E) E E)) E /\
  forall ring, In ring (traces (length E) E E) -> is_cycle ring.
Proof.
  apply traces_part; auto. intros a b I N. destruct (there a I) as (h & H & J). congruence.
Qed.
End Cycles.
