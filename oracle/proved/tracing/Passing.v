(** No traced ring passes a point twice: from the first piece by which it comes back to a point it
    would go on where it left. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique Beside Leaving Next.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier
  Slabbed Cells Coloured Traced Turns Around Sooner Permuted Cycles.
Open Scope R_scope.

(** What comes first comes before another that has not its direction. *)
Lemma first_before r k h : R2 r <> (0, 0) -> R2 k <> (0, 0) -> R2 h <> (0, 0) ->
  sooner r h k = false -> (forall m, 0 < m -> R2 h <> scale m (R2 r)) ->
  (forall m, 0 < m -> R2 h <> scale m (R2 k)) -> vector_between (R2 r) (R2 k) (R2 h).
Proof.
  intros N Nk Nh S Hr Hk. apply not_true_iff_false in S. rewrite sooner_real in S.
  revert N Nk Nh S Hr Hk. generalize (R2 r) (R2 k) (R2 h). clear. intros r k h N Nk Nh S Hr Hk.
  assert (S1 : at_most_half r h -> at_most_half r k) by (intros; apply NNPP; tauto).
  assert (S2 : (at_most_half r h <-> at_most_half r k) -> 0 <= turn_of k h).
  { intros. assert (~ 0 < turn_of h k) by tauto. unfold turn_of in *. lra. }
  clear S. assert (Rr : turn_of r r = 0) by (unfold turn_of; ring).
  assert (Zero : forall m (p : point), m = 0 -> scale m p = (0, 0)).
  { intros m p ->. unfold scale. f_equal; ring. }
  assert (S3 : (at_most_half r h <-> at_most_half r k) -> 0 < turn_of k h).
  { intros Q. specialize (S2 Q). destruct (Req_dec (turn_of k h) 0) as [Z|Z]; [|lra]. exfalso.
    destruct (parallel k h Nk Z) as (m & E & _).
    assert (M : m < 0).
    { destruct (Rtotal_order m 0) as [M|[M|M]]; auto.
      - exfalso. apply Nh. rewrite E. apply Zero, M.
      - exfalso. exact (Hk m M E). }
    assert (Th : turn_of r h = m * turn_of r k)
      by (rewrite E; unfold turn_of, scale; cbn [fst snd]; ring).
    destruct (half_cases r k N) as [[K K']|[[K K']|[(l & L & K & K')|(l & L & K & K')]]].
    - assert (H : at_most_half r h) by tauto. destruct H as [H|[H _]]; nra.
    - assert (H : ~ at_most_half r h) by tauto. apply H. left. nra.
    - apply (Hr (m * l)); [nra|]. rewrite E, K. unfold scale; cbn [fst snd]. f_equal; ring.
    - assert (H : ~ at_most_half r h) by tauto.
      destruct (half_cases r h N) as [[H1 H2]|[[H1 H2]|[(j & J & H1 & H2)|(j & J & H1 & H2)]]];
        try contradiction.
      + rewrite Th, K, (proj2 (scaled_turns l r r)), Rr in H1. lra.
      + destruct (Req_dec j 0) as [->|Nj]; [apply Nh; rewrite H1; apply Zero; auto|].
        apply (Hr j); [lra|exact H1]. }
  clear S2. unfold vector_between.
  destruct (half_cases r h N) as [[H H']|[[H H']|[(j & J & H & H')|(j & J & H & H')]]].
  - specialize (S1 H'). specialize (S3 (conj (fun _ => S1) (fun _ => H'))).
    destruct S1 as [K|[K K']]; [left; auto|]. exfalso.
    destruct (parallel r k N K) as (m & -> & M). apply M in K'.
    rewrite (proj1 (scaled_turns m r h)) in S3. nra.
  - destruct (half_cases r k N) as [[K K']|[[K K']|[(m & M & K & K')|(m & M & K & K')]]].
    + left. auto.
    + right. split; [lra|]. split; auto. apply S3. tauto.
    + right. rewrite K, (proj2 (scaled_turns m r r)), (proj1 (scaled_turns m r h)), Rr.
      split; [lra|]. split; [auto|nra].
    + exfalso. assert (P : 0 < turn_of k h) by (apply S3; tauto).
      rewrite K, (proj1 (scaled_turns m r h)) in P. nra.
  - specialize (S1 H'). specialize (S3 (conj (fun _ => S1) (fun _ => H'))). subst h.
    rewrite (proj2 (scaled_turns j r k)) in S3. destruct S1 as [K|[K K']].
    + left. split; [exact K|left]. rewrite (proj2 (scaled_turns j r k)). exact S3.
    + exfalso. rewrite K in S3. lra.
  - exfalso. destruct (Req_dec j 0) as [->|Nj]; [apply Nh; rewrite H; apply Zero; auto|].
    apply (Hr j); [lra|exact H].
Qed.

Section Passing.
Variables S C : point -> Prop.
Variable edges : edges_t.
Hypothesis part : is_part S C edges.
Variable E : list edge.
Variable few : list point.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis sided : forall e x, In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Hypothesis steady_off : forall x, ~ over_some E x -> ~ In x few -> steady C x.
Hypothesis no_end : forall e f, In e E -> In f E -> ~ inside e (finish f).
Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) E.

Lemma C_open x : C x -> interior C x.
Proof. apply part. Qed.
Lemma sided_in e x : In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Proof.
  intros I X. destruct (sided e x I X) as (r & R & H). exists r. split; auto. intros y Y.
  destruct (H y Y) as [H1 H2]. split; auto. intros O Cy. apply (H2 O), part, Cy.
Qed.
Lemma piece_divides e : In e E -> divides C S (start e, finish e).
Proof.
  intros I. exists [start e; finish e]. intros x O. cbn [fst snd] in *.
  destruct (classic (x = start e)) as [->|N1]; [left; simpl; auto|].
  destruct (classic (x = finish e)) as [->|N2]; [left; simpl; auto|]. right.
  apply sided; auto. apply inner_of_segment; auto.
Qed.
Lemma piece_avoids e x : In e E -> lies_on e x -> ~ C x.
Proof.
  intros I O. apply (edge_avoids S C edges part C (start e) (finish e)); auto.
  apply piece_divides, I.
Qed.

(** A run that does not pass v before its last piece is a way that avoids it. *)
Lemma avoid_way v : (forall a, In a E -> ~ inside a v) -> forall e l z, run E e l z ->
  (forall a, In a l -> In a E) -> (forall a b, In a l -> next_piece E a = Some b ->
    finish a = start b) ->
  finish e <> v -> (forall a, In a l -> a <> z -> finish a <> v) -> NoDup l -> e <> z ->
  joined (outside_it C v) (finish e) (start z).
Proof.
  intros Vi e l z R. induction R as [e|e f l z N R IH]; intros In_E Nx Ne Nv D Nz;
    [destruct (Nz eq_refl)|].
  assert (Ef : finish e = start f) by (apply Nx; simpl; auto).
  destruct (classic (f = z)) as [->|Nf]; [rewrite Ef; apply here|].
  inversion D; subst.
  assert (If : In f l) by exact (run_first _ _ _ _ R).
  assert (Vf : finish f <> v) by (apply Nv; simpl; auto).
  apply joined_join with (finish f).
  - rewrite Ef. apply joined_step. intros p O. split.
    + intros ->. apply (Vi f); [apply In_E; simpl; auto|]. apply inner_of_segment; auto.
      rewrite <- Ef. auto.
    + apply (piece_avoids f); auto. apply In_E. simpl. auto.
  - apply IH; auto.
    + intros; apply In_E; simpl; auto.
    + intros; apply Nx; simpl; auto.
    + intros; apply Nv; simpl; auto.
Qed.
(** The first piece by which a run comes back to where it began *)
Lemma first_back v : forall e l z, run E e l z -> NoDup l -> (exists a, In a l /\ finish a = v) ->
  exists k y, run E e k y /\ (forall a, In a k -> In a l) /\ NoDup k /\ finish y = v /\
    forall a, In a k -> a <> y -> finish a <> v.
Proof.
  induction 1 as [e|e f l z N R IH]; intros D (a & I & V).
  - destruct I as [<-|[]]. exists [e], e. split; [apply run_one|]. repeat split; auto.
    intros b [<-|[]] Nb. destruct (Nb eq_refl).
  - destruct (classic (finish e = v)) as [Ve|Ve].
    + exists [e], e. split; [apply run_one|]. repeat split; auto.
      * intros b [<-|[]]. simpl. auto.
      * repeat constructor. intros [].
      * intros b [<-|[]] Nb. destruct (Nb eq_refl).
    + inversion D; subst. destruct IH as (k & y & K & Sub & Dk & Vy & Fr); auto.
      { exists a. split; auto. destruct I as [<-|I]; [contradiction|exact I]. }
      exists (e :: k), y. split; [apply run_more with f; auto|]. repeat split; auto.
      * intros b [<-|J]; [left; auto|right; auto].
      * constructor; auto.
      * intros b [<-|J] Nb; auto.
Qed.
Lemma along_both (v a b : point) m t : 0 < m -> minus_ b v = scale m (minus_ a v) ->
  at_ v a t = at_ v b (t / m).
Proof.
  intros M. assert (K : t / m * m = t) by (field; lra). set (u := t / m) in *. clearbody u.
  destruct v as [v1 v2], a as [a1 a2], b as [b1 b2]. unfold minus_, scale, at_; cbn [fst snd].
  intros Q. injection Q; intros Q2 Q1. rewrite Q1, Q2, <- K. f_equal; ring.
Qed.
Lemma scaled_way (e f : edge) m : 0 < m -> minus_ (finish f) (start f) =
  scale m (minus_ (finish e) (start e)) -> start e = start f -> In e E -> In f E -> e = f.
Proof.
  intros M Q V I J. set (t := Rmin 1 m / 2). assert (T : 0 < t <= 1 / 2 /\ t < m).
  { unfold t. pose proof (Rmin_l 1 m). pose proof (Rmin_r 1 m).
    assert (0 < Rmin 1 m) by (apply Rmin_glb_lt; lra). lra. }
  assert (K : t / m * m = t) by (field; lra).
  assert (P : 0 < t / m < 1).
  { split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_lt_reg_r m); lra. }
  apply (apart_equal E apart e f (at_ (start e) (finish e) t) I J).
  - exists t. split; [lra|reflexivity].
  - exists (t / m). split; [exact P|]. change (at_ (start e) (finish e) t =
      at_ (start f) (finish f) (t / m)). rewrite <- V in *. apply along_both; auto.
Qed.

(** After the piece by which it comes back the program goes on by that of the way out. *)
Theorem back_goes_out v h k y : In h E -> start h = v -> run E h k y -> NoDup k ->
  (forall a, In a k -> In a E) -> finish y = v -> (forall a, In a k -> a <> y -> finish a <> v) ->
  next_piece E y = Some h.
Proof.
  intros Ih Sh R D In_E Vy Fr. assert (Iy : In y E) by exact (In_E y (run_last _ _ _ _ R)).
  destruct (next_is_there C C_open E few long sided_in steady_off no_end y Iy)
    as (n & Ny & In_ & Sn & First). rewrite Ny. f_equal.
  apply NNPP. intros Nn. assert (Vn : start n = v) by congruence.
  assert (Vi : forall a, In a E -> ~ inside a v) by (intros a Ia; rewrite <- Vy; auto).
  assert (Hy : h <> y) by (intros ->; apply (long y Iy); congruence).
  assert (Way : joined (outside_it C v) (finish h) (start y)).
  { apply (avoid_way v Vi h k y R In_E); auto.
    - intros a b Ia Nb. destruct (next_is_there C C_open E few long sided_in steady_off no_end a
        (In_E a Ia)) as (b' & Nb' & _ & Sb & _). congruence.
    - intros Q. apply (long h Ih). congruence. }
  pose proof (long h Ih) as Lh. pose proof (long n In_) as Ln. pose proof (long y Iy) as Ly.
  apply (none_between S C edges part v (finish h) (start y) (finish y)) with
    (k1 := start n) (k2 := finish n); auto.
  - apply piece_divides, Iy.
  - rewrite <- Vy. apply on_segment_end.
  - congruence.
  - apply piece_divides, In_.
  - rewrite <- Vn. apply on_segment_start.
  - congruence.
  - congruence.
  - intros p O. apply (piece_avoids h p Ih). rewrite <- Sh in O. exact O.
  - apply between_vectors.
    assert (Ry : R2 (back (dir y)) = minus_ (start y) v) by (rewrite back_real, Vy; reflexivity).
    assert (Rn : R2 (dir n) = minus_ (finish n) v) by (rewrite dir_real, Vn; reflexivity).
    assert (Rh : R2 (dir h) = minus_ (finish h) v) by (rewrite dir_real, Sh; reflexivity).
    rewrite <- Ry, <- Rn, <- Rh. apply first_before.
    + rewrite Ry. intros Z. apply difference_zero in Z. congruence.
    + rewrite Rn. intros Z. apply difference_zero in Z. congruence.
    + rewrite Rh. intros Z. apply difference_zero in Z. congruence.
    + apply First; auto. congruence.
    + intros m M. rewrite Ry, Rh. intros Q.
      (* the way out lies along the way in *)
      apply Hy. set (t := Rmin 1 m / 2). assert (T : 0 < t <= 1 / 2 /\ t < m).
      { unfold t. pose proof (Rmin_l 1 m). pose proof (Rmin_r 1 m).
        assert (0 < Rmin 1 m) by (apply Rmin_glb_lt; lra). lra. }
      assert (K : t / m * m = t) by (field; lra).
      assert (P : 0 < t / m < 1).
      { split; [apply Rdiv_lt_0_compat; lra|]. apply (Rmult_lt_reg_r m); lra. }
      apply (apart_equal E apart h y (at_ v (start y) t) Ih Iy).
      * exists (t / m). split; [exact P|]. rewrite Sh. apply along_both; auto.
      * exists (1 - t). split; [lra|]. rewrite Vy. unfold at_; cbn [fst snd]. f_equal; ring.
    + intros m M. rewrite dir_real, dir_real. intros Q. apply Nn. 
      apply (scaled_way n h m M Q); auto. congruence.
Qed.

(** So no two pieces of a ring end in one point. *)
Lemma run_join e l y f k z : run E e l y -> next_piece E y = Some f -> run E f k z ->
  run E e (l ++ k) z.
Proof.
  intros R N K. induction R as [e|e g l y M R IH]; simpl.
  - apply run_more with f; auto.
  - apply run_more with g; auto.
Qed.
Lemma run_split e l z a : run E e l z -> In a l -> a = z \/ exists l1 l2 g, l = l1 ++ l2 /\
  run E e l1 a /\ next_piece E a = Some g /\ run E g l2 z.
Proof.
  induction 1 as [e|e f l z N R IH]; intros I.
  - destruct I as [<-|[]]. auto.
  - destruct (classic (a = e)) as [->|Na].
    + right. exists [e], l, f. repeat split; auto. apply run_one.
    + destruct I as [<-|I]; [destruct (Na eq_refl)|]. destruct (IH I) as [->|(l1 & l2 & g & -> & R1
        & G & R2)]; auto. right. exists (e :: l1), l2, g. repeat split; auto.
      apply run_more with f; auto.
Qed.
Lemma cycle_from l a : is_cycle E l -> In a l -> exists h k, next_piece E a = Some h /\
  run E h k a /\ Permutation k l.
Proof.
  intros (e & z & R & Z & _) I.
  destruct (run_split e l z a R I) as [->|(l1 & l2 & g & -> & R1 & G & R2)].
  - exists e, l. auto.
  - exists g, (l2 ++ l1). repeat split; auto; [|apply Permutation_app_comm].
    apply run_join with z e; auto.
Qed.
Theorem passed_once l a b : is_cycle E l -> (forall c, In c l -> In c E) -> In a l -> In b l ->
  finish a = finish b -> a = b.
Proof.
  intros Cy In_E Ia Ib V. apply NNPP. intros N.
  destruct (cycle_from l a Cy Ia) as (h & k & Nh & R & P).
  assert (D : NoDup k).
  { destruct Cy as (_ & _ & _ & _ & D). exact (Permutation_NoDup (Permutation_sym P) D). }
  assert (Sub : forall c, In c k -> In c E).
  { intros c Ic. apply In_E. exact (Permutation_in _ P Ic). }
  destruct (run_split h k a b R (Permutation_in _ (Permutation_sym P) Ib)) as
    [Q|(k1 & k2 & g & -> & R1 & G & R2)]; [congruence|].
  assert (D1 : NoDup k1 /\ ~ In a k1).
  { pose proof (run_last _ _ _ _ R2) as L. clear - D L. split.
    - induction k1 as [|c k1 IH]; constructor; inversion D; subst; auto.
      intros I. apply H1, in_or_app. auto.
    - intros I. induction k1 as [|c k1 IH]; [destruct I|]. inversion D; subst.
      destruct I as [->|I]; auto. apply H1, in_or_app. auto. }
  destruct D1 as [D1 Na].
  destruct (next_is_there C C_open E few long sided_in steady_off no_end a (In_E a Ia))
    as (h' & Nh' & Ih & Sh & _). rewrite Nh in Nh'. injection Nh'; intros <-.
  destruct (first_back (finish a) h k1 b R1 D1) as (k & y & K & Sub' & Dk & Vy & Fr).
  { exists b. split; [exact (run_last _ _ _ _ R1)|auto]. }
  assert (Iy : In y k1) by apply Sub', (run_last _ _ _ _ K).
  apply Na. replace a with y; auto.
  apply (next_once C C_open E few long sided_in steady_off no_end apart y a h); auto.
  - apply Sub, in_or_app. auto.
  - apply (back_goes_out (finish a) h k); auto. intros c Ic. apply Sub, in_or_app. auto.
Qed.
End Passing.
