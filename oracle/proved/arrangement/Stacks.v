(** Cells of a slab: one above the other, between neighbours by height. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals Qreduction ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Paths Decomposed Gaps
  Unique.
From Proved Require Import Points Member Decided Pieces Slabs Sorting Along Cuts Lone Flanks.
Open Scope R_scope.

(** ** Heights *)
Definition line_at (a b : point) (x : R) : R :=
  snd a + (x - fst a) * ((snd b - snd a) / (fst b - fst a)).
Lemma orient_line a b y : fst a <> fst b ->
  orient a b y = (fst b - fst a) * (snd y - line_at a b (fst y)).
Proof. intros N. unfold orient, line_at. field. lra. Qed.
Lemma line_swap a b x : fst a <> fst b -> line_at b a x = line_at a b x.
Proof. intros N. unfold line_at. field. lra. Qed.
Definition height_of (e : edge) (x : R) : R := line_at (start e) (finish e) x.
Definition slopes (e : edge) : Prop := fst (start e) <> fst (finish e).
Lemma vertical_real e : vertical e = false <-> slopes e.
Proof.
  unfold vertical, slopes. rewrite <- not_true_iff_false, equal_real. reflexivity.
Qed.
Lemma height_real x e : slopes e -> Q2R (height x e) = height_of e (Q2R x).
Proof.
  unfold slopes, height_of, height. destruct e as [a b]. unfold start, finish. cbn [fst snd].
  intros N. unfold line_at. destruct (Qeq_bool x (fst a)) eqn:A.
  { apply equal_real in A. rewrite A. unfold point_of; cbn [fst snd]. ring. }
  destruct (Qeq_bool x (fst b)) eqn:B.
  { apply equal_real in B. rewrite B. unfold point_of in *; cbn [fst snd] in *. field. lra. }
  rewrite Q2R_red, Q2R_plus, Q2R_div, Q2R_mult, !Q2R_minus; unfold point_of in *;
    cbn [fst snd] in *.
  - field. lra.
  - intros Z. apply Qeq_eqR in Z. rewrite Q2R_minus, zero_real in Z. lra.
Qed.
Lemma on_height e y : slopes e -> lies_on e y -> snd y = height_of e (fst y).
Proof.
  intros N O. apply segment_range in O. destruct O as [O _].
  fold (start e) (finish e) in O. rewrite orient_line in O by exact N.
  apply Rmult_integral in O. unfold slopes, height_of in *. lra.
Qed.
Lemma rightward_real e : rightward e = true <-> fst (start e) < fst (finish e).
Proof. unfold rightward. rewrite less_real. reflexivity. Qed.

(** Above and below the line of an edge from the left *)
Definition level (e : edge) (x : point) : R :=
  orient (start (from_left e)) (finish (from_left e)) x.
Lemma from_left_cases e : slopes e ->
  (rightward e = true /\ fst (start e) < fst (finish e) /\ from_left e = e) \/
  (rightward e = false /\ fst (finish e) < fst (start e) /\ from_left e = (snd e, fst e)).
Proof.
  unfold slopes. intros N. unfold from_left. destruct (is_before (fst e) (snd e)) eqn:B.
  - left. apply is_before_real in B. destruct B as [B|[B _]].
    + split; [apply rightward_real; exact B|auto].
    + contradiction.
  - right. apply not_true_iff_false in B. rewrite is_before_real in B. unfold before in B.
    assert (L : fst (finish e) < fst (start e)).
    { unfold start, finish in *. destruct (Rtotal_order (fst (R2 (fst e))) (fst (R2 (snd e))))
        as [H|[H|H]]; auto; [destruct B; auto|contradiction]. }
    split; auto. apply not_true_iff_false. rewrite rightward_real. lra.
Qed.
Lemma level_height e y : slopes e -> exists k, 0 < k /\
  level e y = k * (snd y - height_of e (fst y)).
Proof.
  intros N. unfold level, height_of. destruct (from_left_cases e N) as [(_ & L & ->)|(_ & L & ->)].
  - exists (fst (finish e) - fst (start e)). split; [lra|]. apply orient_line. lra.
  - exists (fst (start e) - fst (finish e)). split; [lra|].
    change (start (snd e, fst e)) with (finish e). change (finish (snd e, fst e)) with (start e).
    rewrite orient_line, line_swap by lra. reflexivity.
Qed.
Lemma level_sign e y : slopes e -> (0 < level e y <-> height_of e (fst y) < snd y) /\
  (level e y < 0 <-> snd y < height_of e (fst y)).
Proof.
  intros N. destruct (level_height e y N) as (k & K & ->).
  split; split; intros H; nra.
Qed.

(** ** Stacks *)
Section Stack.
Variables x0 x1 : Q.
Variable h : edge -> R.
Lemma stack_cell l : forall below, StronglySorted (fun e f => h e < h f) l ->
  (forall e, below = Some e -> forall f, In f l -> h e < h f) ->
  forall c, In c (stack x0 x1 below l) ->
  (from c = Some x0 /\ to c = Some x1) /\
  (forall e, bottom c = Some e -> below = Some e \/ In e l) /\
  (forall f, top c = Some f -> In f l) /\
  (forall e f, bottom c = Some e -> top c = Some f -> h e < h f) /\
  (forall g, below = Some g \/ In g l ->
    (exists e, bottom c = Some e /\ h g <= h e) \/ (exists f, top c = Some f /\ h f <= h g)).
Proof.
  induction l as [|e l IH]; intros below O L c I; simpl in I.
  { destruct I as [<-|[]]. cbn [from to bottom top]. repeat split; auto; try discriminate.
    intros g [E|[]]. left. exists g. split; auto. lra. }
  apply StronglySorted_inv in O. destruct O as [O1 O2]. rewrite Forall_forall in O2.
  destruct I as [<-|I].
  { cbn [from to bottom top]. repeat split; auto.
    - intros f E. injection E; intros <-. simpl. auto.
    - intros b f Eb E. injection E; intros <-. apply (L b Eb). simpl. auto.
    - intros g [E|[<-|J]].
      + left. exists g. split; auto. lra.
      + right. exists e. split; auto. lra.
      + right. exists e. split; auto. specialize (O2 g J). lra. }
  destruct (IH (Some e) O1) with (c := c) as (A & B & C & D & G); auto.
  { intros f E. injection E; intros <-. auto. }
  split; [exact A|split; [|split; [|split; [exact D|]]]].
  - intros f E. destruct (B f E) as [F|F]; [injection F; intros <-; simpl; auto|simpl; auto].
  - intros f E. simpl. auto.
  - intros g [E|[<-|J]]; auto. destruct (G e (or_introl eq_refl)) as [(b & Eb & H)|(f & Ef & H)].
    + left. exists b. split; auto. pose proof (L g E e (or_introl eq_refl)). lra.
    + exfalso. pose proof (O2 f (C f Ef)). lra.
Qed.
Lemma stack_cover (y : point) l : forall below,
  (forall e, below = Some e -> 0 < level e y) -> (forall e, In e l -> level e y <> 0) ->
  exists c, In c (stack x0 x1 below l) /\ from c = Some x0 /\ to c = Some x1 /\
  (forall e, bottom c = Some e -> 0 < level e y) /\ (forall f, top c = Some f -> level f y < 0).
Proof.
  induction l as [|e l IH]; intros below Bl H; simpl.
  - eexists. split; [left; reflexivity|]. cbn [from to bottom top].
    repeat split; auto. discriminate.
  - destruct (Rlt_dec (level e y) 0) as [L|L].
    + eexists. split; [left; reflexivity|]. cbn [from to bottom top]. repeat split; auto.
      intros f E. injection E; intros <-. exact L.
    + destruct (IH (Some e)) as (c & I & K).
      * intros f E. injection E; intros <-. pose proof (H e (or_introl eq_refl)). lra.
      * intros f J. apply H. simpl. auto.
      * exists c. split; auto.
Qed.
End Stack.

(** ** Edges by height *)
Lemma heights_total (p q : Q * edge) : Qle_bool (fst p) (fst q) = true \/
  Qle_bool (fst q) (fst p) = true.
Proof. rewrite !le_real. lra. Qed.
Lemma heights_transitive (p q r : Q * edge) : Qle_bool (fst p) (fst q) = true ->
  Qle_bool (fst q) (fst r) = true -> Qle_bool (fst p) (fst r) = true.
Proof. rewrite !le_real. lra. Qed.
Lemma heights_equal (p q : Q * edge) : Qle_bool (fst p) (fst q) = true ->
  Qle_bool (fst q) (fst p) = true -> Qeq_bool (fst p) (fst q) = true.
Proof. rewrite !le_real, equal_real. lra. Qed.
Lemma by_height_from m l e : In e (by_height m l) -> In e l.
Proof.
  unfold by_height. intros I. apply in_map_iff in I. destruct I as (p & <- & I).
  apply in_turn_from in I. apply in_map_iff in I. destruct I as (f & <- & I). exact I.
Qed.
Lemma by_height_has m l e : In e l -> exists f, In f (by_height m l) /\
  Q2R (height m f) = Q2R (height m e).
Proof.
  intros I.
  destruct (in_turn_has (fun p q => Qle_bool (fst p) (fst q)) (fun p q => Qeq_bool (fst p) (fst q))
    (fun p q : Q * edge => Q2R (fst p) = Q2R (fst q)) (map (fun e => (height m e, e)) l)
    (height m e, e)) as (p & J & E).
  - auto.
  - intros x y z -> ->. reflexivity.
  - intros x y. apply equal_real.
  - apply in_map_iff. exists e. auto.
  - exists (snd p). split; [apply in_map; exact J|].
    apply in_turn_from in J. apply in_map_iff in J. destruct J as (f & <- & _). auto.
Qed.
Lemma by_height_sorted m l :
  StronglySorted (fun e f => Q2R (height m e) < Q2R (height m f)) (by_height m l).
Proof.
  unfold by_height. set (k := map (fun e => (height m e, e)) l).
  pose proof (unique_strict _ _ heights_total heights_transitive heights_equal _
    (sort_ordered _ heights_total heights_transitive k)) as S.
  assert (F : forall p, In p (in_turn (fun p q : Q * edge => Qle_bool (fst p) (fst q))
    (fun p q => Qeq_bool (fst p) (fst q)) k) -> fst p = height m (snd p)).
  { intros p I. apply in_turn_from in I. apply in_map_iff in I. destruct I as (e & <- & _).
    reflexivity. }
  unfold in_turn in *. induction S as [|p r S IH H]; simpl; constructor.
  - apply IH. intros q Q. apply F. simpl. auto.
  - apply Forall_forall. intros e I. apply in_map_iff in I. destruct I as (q & <- & I).
    rewrite Forall_forall in H. specialize (H q I). apply not_true_iff_false in H.
    rewrite le_real in H. rewrite <- (F q), <- (F p); simpl; auto. lra.
Qed.
