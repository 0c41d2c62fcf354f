(** Touching points: a checker, and that it finds where rings touch. *)
From Coq Require Import Lra Lia Psatz Bool Mergesort Orders Permutation.
From Proved Require Import Definitions Form Moving Sums Crossings Fans Curves Unions Local Numbers
  Rational Values Figures Corners Cancellation Bodies Scaling Trees Theorems Components Classes
  Counting Holes Across Sides Overlaps Differing Canonical.

(** ** The checker *)
Open Scope Q_scope.
(** They are the ends of stretches that come again. Points are sorted by their codes. *)
Module Coded <: TotalLeBool.
  Definition t := (list Z * corner)%type.
  Definition leb (p q : t) := comes_before (fst p) (fst q).
  Definition leb_total (p q : t) := comes_before_total (fst p) (fst q).
End Coded.
Module CodedSort := Sort Coded.
Definition sorted (l : list corner) : list corner :=
  map snd (CodedSort.sort (map (fun p => (code_of (fst p) ++ code_of (snd p), p)) l)).
(** Each point once, and as often as it comes again *)
Fixpoint groups (l : list corner) : list corner * list corner :=
  match l with
  | [] => ([], [])
  | p :: r =>
      let '(each, again) := groups r in
      match each with
      | q :: _ => if same p q then (each, p :: again) else (p :: each, again)
      | [] => ([p], again)
      end
  end.
Definition check_touching (ends touching : list corner) : bool :=
  let '(each, again) := groups (sorted ends) in
  all_differ each && all2 same again (sorted touching).

(** ** Counting *)
Open Scope R_scope.
Lemma counts_same {A} (H : A -> Prop) l n : counts H l n -> forall m, counts H l m -> n = m.
Proof.
  induction 1; intros m K; inversion K; subst; auto; try contradiction.
Qed.
Lemma counts_exist {A} (H : A -> Prop) l : exists n, counts H l n.
Proof.
  induction l as [|a l (n & IH)]; [exists 0%nat; apply counts_none|].
  destruct (Classical_Prop.classic (H a)).
  - exists (S n). apply counts_one; auto.
  - exists n. apply counts_not; auto.
Qed.
Lemma counts_app {A} (H : A -> Prop) l k n m : counts H l n -> counts H k m ->
  counts H (l ++ k) (n + m).
Proof.
  induction 1; intros K; simpl; [exact K|apply counts_one; auto|apply counts_not; auto].
Qed.
Lemma counts_permutation {A} (H : A -> Prop) l k : Permutation l k -> forall n, counts H l n ->
  counts H k n.
Proof.
  induction 1; intros n K; auto.
  - inversion K; subst; [apply counts_one|apply counts_not]; auto.
  - inversion K as [|? ? ? H1 K1|? ? ? H1 K1]; subst;
      inversion K1 as [|? ? ? H2 K2|? ? ? H2 K2]; subst;
      repeat first [apply counts_one; [assumption|]|apply counts_not; [assumption|]|assumption].
Qed.
Lemma counts_nothing {A} (H : A -> Prop) l : (forall a, In a l -> ~ H a) -> counts H l 0.
Proof.
  induction l as [|a l IH]; intros N; [apply counts_none|].
  apply counts_not; [apply N; simpl; auto|]. apply IH. intros b I. apply N. simpl; auto.
Qed.
Lemma counts_some {A} (H : A -> Prop) l n : counts H l n -> (0 < n)%nat ->
  exists a, In a l /\ H a.
Proof.
  induction 1 as [|a l n Ha K IH|a l n Ha K IH]; intros P; [lia|exists a; simpl; auto|].
  destruct (IH P) as (b & I & B). exists b. simpl; auto.
Qed.
Lemma counts_different {A} (x : A) l : NoDup l ->
  (In x l /\ counts (Logic.eq x) l 1) \/ (~ In x l /\ counts (Logic.eq x) l 0).
Proof.
  intros N. destruct (Classical_Prop.classic (In x l)) as [I|I].
  - left. split; auto. induction N as [|a l F N IH]; [destruct I|].
    destruct (Classical_Prop.classic (x = a)) as [->|D].
    + apply counts_one; auto. apply counts_nothing. intros b J <-. contradiction.
    + apply counts_not; auto. apply IH. destruct I; congruence.
  - right. split; auto. apply counts_nothing. intros a J <-. contradiction.
Qed.

(** ** Touching points *)
Section Here.
Context {now : scale_here}.

Lemma groups_real l : forall each again, groups l = (each, again) ->
  Permutation (map real l) (map real each ++ map real again) /\
  forall v, In v (map real again) -> In v (map real each).
Proof.
  induction l as [|p l IH]; intros each again H; simpl in H.
  - injection H; intros <- <-. split; [apply perm_nil|simpl; tauto].
  - destruct (groups l) as [e a]. destruct (IH e a eq_refl) as [I1 I2]. clear IH.
    destruct e as [|q e].
    + injection H; intros <- <-. simpl in *. split; [apply perm_skip, I1|].
      intros v I. destruct (I2 v I).
    + destruct (same p q) eqn:E; injection H; intros <- <-.
      * apply same_real in E. cbn [map] in *. split.
        { apply Permutation_trans with (real p :: (real q :: map real e) ++ map real a);
            [apply perm_skip, I1|]. apply Permutation_middle. }
        { intros v [<-|I]; [left; auto|apply I2, I]. }
      * cbn [map] in *. split; [apply perm_skip, I1|]. intros v I. right. apply I2, I.
Qed.
Lemma sorted_real l : Permutation (map real l) (map real (sorted l)).
Proof.
  apply Permutation_map. unfold sorted.
  eapply Permutation_trans; [|apply Permutation_map, CodedSort.Permuted_sort].
  rewrite map_map. cbn [snd]. rewrite map_id. apply Permutation_refl.
Qed.
Lemma touching_real ends touching x n : check_touching ends touching = true ->
  counts (Logic.eq x) (map real ends) n -> counts (Logic.eq x) (map real touching) (pred n).
Proof.
  unfold check_touching. destruct (groups (sorted ends)) as [each again] eqn:G. intros H C.
  apply andb_prop in H. destruct H as [D T]. apply all_differ_real in D.
  apply (all2_map same real same_real) in T.
  destruct (groups_real _ _ _ G) as [Pm Sub].
  apply (counts_permutation _ _ _ (sorted_real ends)) in C.
  apply (counts_permutation _ _ _ Pm) in C.
  apply (counts_permutation _ _ _ (Permutation_sym (sorted_real touching))). rewrite <- T.
  destruct (counts_exist (Logic.eq x) (map real again)) as (k & K).
  destruct (counts_different x (map real each) D) as [[I E]|[I E]];
    pose proof (counts_same _ _ _ (counts_app _ _ _ _ _ E K) _ C) as <-; simpl.
  - exact K.
  - assert (Z : counts (Logic.eq x) (map real again) 0).
    { apply counts_nothing. intros v V <-. apply I, Sub, V. }
    rewrite (counts_same _ _ _ K _ Z). exact Z.
Qed.
End Here.

(** Rings, each with the ends of its stretches *)
Definition holds_ends (p : list point * list point) : Prop := NoDup (snd p) /\
  forall x, In x (snd p) -> passes x (fst p).
Definition share (p q : list point * list point) : Prop := forall x, passes x (fst p) ->
  passes x (fst q) -> In x (snd p) /\ In x (snd q).
Lemma counts_all x l : (forall p, In p l -> holds_ends p) ->
  (forall p, In p l -> passes x (fst p) -> In x (snd p)) ->
  forall n, counts (passes x) (map fst l) n -> counts (Logic.eq x) (concat (map snd l)) n.
Proof.
  induction l as [|[r e] l IH]; intros W Sh n K; simpl in *.
  - inversion K; subst. apply counts_none.
  - assert (I : forall m, counts (passes x) (map fst l) m ->
      counts (Logic.eq x) (concat (map snd l)) m) by (intros; apply IH; auto).
    destruct (W (r, e) (or_introl eq_refl)) as [N P]. cbn [fst snd] in *.
    inversion K as [|? ? m Hr K'|? ? m Hr K']; subst.
    + specialize (Sh (r, e) (or_introl eq_refl) Hr). cbn [snd] in Sh.
      destruct (counts_different x e N) as [[_ C]|[C _]]; [|contradiction].
      apply (counts_app _ _ _ 1 m C). apply I, K'.
    + destruct (counts_different x e N) as [[C _]|[_ C]]; [destruct (Hr (P x C))|].
      apply (counts_app _ _ _ 0 n C). apply I, K'.
Qed.
Lemma counts_ends x l : (forall p, In p l -> holds_ends p) -> ForallOrdPairs share l ->
  forall n m, counts (passes x) (map fst l) n -> counts (Logic.eq x) (concat (map snd l)) m ->
    (m <= n)%nat /\ ((2 <= n)%nat -> m = n).
Proof.
  induction l as [|[r e] l IH]; intros W F n m K C; simpl in *.
  - inversion K; subst. inversion C; subst. lia.
  - inversion F as [|? ? F1 F2]; subst. destruct (counts_exist (Logic.eq x) (concat (map snd l)))
      as (m' & C').
    destruct (W (r, e) (or_introl eq_refl)) as [N P]. cbn [fst snd] in *.
    assert (W' : forall p, In p l -> holds_ends p) by auto.
    inversion K as [|? ? n' Hr K'|? ? n' Hr K']; subst.
    + destruct (IH W' F2 n' m' K' C') as [I1 I2].
      destruct (counts_different x e N) as [[J D]|[J D]];
        pose proof (counts_same _ _ _ (counts_app _ _ _ _ _ D C') _ C) as <-.
      * destruct (Nat.eq_dec n' 0) as [->|Z]; [lia|].
        assert (C2 : counts (Logic.eq x) (concat (map snd l)) n').
        { apply counts_all; auto. intros p Ip Hp. rewrite Forall_forall in F1.
          apply (F1 p Ip x Hr Hp). }
        rewrite (counts_same _ _ _ C' _ C2). lia.
      * destruct (Nat.eq_dec n' 0) as [->|Z]; [lia|]. exfalso.
        destruct (counts_some _ _ _ K') as (q & Iq & Hq); [lia|].
        apply in_map_iff in Iq. destruct Iq as (p & <- & Ip). rewrite Forall_forall in F1.
        apply J. apply (F1 p Ip x Hr Hq).
    + destruct (IH W' F2 n m' K' C') as [I1 I2].
      destruct (counts_different x e N) as [[J D]|[J D]]; [destruct (Hr (P x J))|].
      pose proof (counts_same _ _ _ (counts_app _ _ _ _ _ D C') _ C) as <-. simpl. auto.
Qed.

(** ** What is found of rings *)
Lemma row_ends C S a b u l : row C S a b u l -> orient a b u = 0 -> forall v, In v l ->
  on_segment u b v.
Proof.
  induction 1 as [|u v l P K IH]; intros U w I; [destruct I|].
  destruct (stretch_step C S a b u v U P) as (s & Hs & E).
  destruct (row_length C S a b v l K (proj1 P)) as (t & Ht & F).
  set (d := minus b a) in *.
  assert (B : b = shifted u d (s + t)) by (rewrite <- shifted_twice, <- E; exact F).
  assert (V : forall m, 0 <= m <= 1 -> on_segment u b (shifted u d (m * (s + t)))).
  { intros m M. exists m. split; auto. rewrite B. unfold shifted; cbn [fst snd]. f_equal; ring. }
  assert (St : 0 < s + t) by lra.
  destruct I as [<-|I].
  - replace v with (shifted u d (s / (s + t) * (s + t))).
    + apply V. split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]|].
      apply Rmult_le_reg_r with (s + t); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    + rewrite E. f_equal. field. lra.
  - destruct (IH (proj1 P) w I) as (m & M & W).
    replace w with (shifted u d ((s + m * t) / (s + t) * (s + t))).
    + apply V. split.
      * apply Rmult_le_pos; [nra|apply Rlt_le, Rinv_0_lt_compat; lra].
      * apply Rmult_le_reg_r with (s + t); auto. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; nra.
    + rewrite W. pose proof (f_equal fst F) as F1. pose proof (f_equal snd F) as F2.
      pose proof (f_equal fst E) as E1. pose proof (f_equal snd E) as E2.
      unfold shifted in *; cbn [fst snd] in *. rewrite F1, F2, E1, E2. f_equal; field; lra.
Qed.
Lemma passes_beyond x ring : (forall e, In e (ring_edges ring) -> fst e <> snd e) ->
  passes x ring -> exists e, In e (ring_edges ring) /\ beyond_start e x.
Proof.
  intros N (e & I & X). destruct (Classical_Prop.classic (x = fst e)) as [->|D].
  - assert (J : In (fst e) (map snd (ring_edges ring))).
    { eapply Permutation_in; [apply ring_closed|]. apply in_map, I. }
    apply in_map_iff in J. destruct J as (f & E & J). exists f. split; auto. split.
    + exists 1. split; [lra|]. rewrite <- E. destruct (snd f), (fst f); simpl. f_equal; ring.
    + rewrite <- E. intros Q. apply (N f J). auto.
  - exists e. split; auto. split; auto.
Qed.
Lemma pairs_of_rings {A B} (R : B -> B -> Prop) (f : A -> list B) l :
  ForallOrdPairs R (flat_map f l) ->
  ForallOrdPairs (fun a b => forall e g, In e (f a) -> In g (f b) -> R e g) l.
Proof.
  assert (App : forall k m, ForallOrdPairs R (k ++ m) ->
    (forall e g, In e k -> In g m -> R e g) /\ ForallOrdPairs R m).
  { induction k as [|e k IH]; simpl; intros m H; [split; [tauto|auto]|].
    inversion H as [|? ? H1 H2]; subst. destruct (IH m H2) as [I1 I2]. split; auto.
    rewrite Forall_forall in H1. intros e' g [<-|I] J; [|apply I1; auto].
    apply H1, in_or_app. auto. }
  induction l as [|a l IH]; simpl; intros H; [apply FOP_nil|].
  destruct (App _ _ H) as [H1 H2]. apply FOP_cons; auto. apply Forall_forall.
  intros b I e g J K. apply H1; auto. apply in_flat_map. exists b. auto.
Qed.

Section Rings.
Variable S : point -> Prop.
Definition is_rowed (p : list point * list point) : Prop := NoDup (snd p) /\
  (forall e, In e (ring_edges (fst p)) -> fst e <> snd e) /\
  exists lists, Forall2 (is_row S) (ring_edges (fst p)) lists /\ concat lists = snd p.
Lemma rowed_holds p : is_rowed p -> holds_ends p.
Proof.
  intros (N & _ & lists & F & E). split; auto. intros x I. rewrite <- E in I.
  apply in_concat in I. destruct I as (l & I & J). clear N E.
  assert (G : exists e, In e (ring_edges (fst p)) /\ is_row S e l).
  { induction F as [|e k es ks R F IH]; [destruct I|]. destruct I as [<-|I].
    - exists e. simpl; auto.
    - destruct (IH I) as (g & G1 & G2). exists g. simpl; auto. }
  destruct G as (e & Ie & R). exists e. split; auto.
  apply (row_ends _ _ _ _ _ _ R (orient_start _ _) x J).
Qed.
Lemma rowed_share p q : is_rowed p -> is_rowed q ->
  (forall e f, In e (ring_edges (fst p)) -> In f (ring_edges (fst q)) -> apart e f) -> share p q.
Proof.
  intros (_ & Np & lp & Fp & Ep) (_ & Nq & lq & Fq & Eq) Ap x Xp Xq.
  destruct (passes_beyond x _ Np Xp) as (e & Ie & Be).
  destruct (passes_beyond x _ Nq Xq) as (f & If & Bf).
  assert (Row : forall edges lists g, Forall2 (is_row S) edges lists -> In g edges -> exists l,
    is_row S g l /\ forall v, In v l -> In v (concat lists)).
  { intros edges lists g F. induction F as [|e' k es ks R F IH]; intros I; [destruct I|].
    destruct I as [<-|I].
    - exists k. split; auto. intros v J. simpl. apply in_or_app. auto.
    - destruct (IH I) as (l & L1 & L2). exists l. split; auto. intros v J. simpl.
      apply in_or_app. auto. }
  destruct (Row _ _ e Fp Ie) as (l & Rl & Sl). destruct (Row _ _ f Fq If) as (k & Rk & Sk).
  destruct (beyond_shared S e f l k (Ap e f Ie If) (Np e Ie) (Nq f If) Rl Rk x Be Bf) as [L K].
  rewrite <- Ep, <- Eq. split; auto.
Qed.
End Rings.

Lemma forall2_weaken {A B} (R S : A -> B -> Prop) : (forall a b, R a b -> S a b) ->
  forall l k, Forall2 R l k -> Forall2 S l k.
Proof. intros H l k F. induction F; [apply Forall2_nil|apply Forall2_cons; auto]. Qed.
