(** The piece that the program takes after each piece of a class: one of them, and none is taken
    twice. So the pieces of a class close up. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique Beside Leaving Next.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier
  Slabbed Cells Coloured Traced Turns Around Sooner.
Open Scope R_scope.

Lemma back_real e : R2 (back (dir e)) = minus_ (start e) (finish e).
Proof.
  unfold back. transitivity (- fst (R2 (dir e)), - snd (R2 (dir e))).
  - unfold point_of; cbn [fst snd]. rewrite !Q2R_opp. reflexivity.
  - rewrite dir_real. unfold minus_; cbn [fst snd]. f_equal; ring.
Qed.
Lemma turn_at v x y : turn_of (minus_ x v) (minus_ y v) = orient v x y.
Proof. unfold turn_of, minus_, orient; cbn [fst snd]. ring. Qed.
Lemma between_vectors v u k h : between v u k h <->
  vector_between (minus_ u v) (minus_ k v) (minus_ h v).
Proof. unfold between, vector_between. rewrite !turn_at. tauto. Qed.
Lemma difference_zero (x y : point) : minus_ x y = (0, 0) -> x = y.
Proof. unfold minus_. intros E. injection E; intros. apply point_eq; lra. Qed.

Section Permuted.
Variable C : point -> Prop.
Hypothesis C_open : forall x, C x -> interior C x.
Variable E : list edge.
Variable few : list point.
Hypothesis long : forall e, In e E -> start e <> finish e.
Hypothesis sided : forall e x, In e E -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> C y) /\ (orient (start e) (finish e) y < 0 -> ~ C y).
Hypothesis steady_off : forall x, ~ over_some E x -> ~ In x few -> steady C x.
Hypothesis no_end : forall e f, In e E -> In f E -> ~ inside e (finish f).
Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) E.

Lemma apart_equal e f x : In e E -> In f E -> inside e x -> inside f x -> e = f.
Proof.
  intros I J X Y. destruct (classic (e = f)) as [|N]; auto. exfalso.
  destruct (in_split _ _ I) as (l & k & Q). rewrite Q in J, apart.
  destruct (Rounds.pairs_at _ _ _ _ apart) as [Pl Pr]. apply in_app_or in J.
  destruct J as [J|[J|J]]; [exact (Pl f J x Y X)|auto|exact (Pr f J x X Y)].
Qed.
Lemma some_inside e : inside e (at_ (start e) (finish e) (1 / 2)).
Proof. exists (1 / 2). split; [lra|reflexivity]. Qed.
Lemma no_piece_twice : NoDup E.
Proof.
  clear - apart. induction E as [|e l IH]; constructor; inversion apart as [|x k F G]; subst; auto.
  intros I. rewrite Forall_forall in F. apply (F e I _ (some_inside e) (some_inside e)).
Qed.
Lemma in_ways_differ e f : In e E -> In f E -> finish e = finish f -> e <> f ->
  ~ same_way (finish e) (start e) (start f).
Proof.
  intros I J F N (l & L & Q). apply N. set (v := finish e) in *.
  set (t := Rmin 1 l / 2). assert (T : 0 < t <= 1 / 2 /\ t < l).
  { unfold t. pose proof (Rmin_l 1 l). pose proof (Rmin_r 1 l).
    assert (0 < Rmin 1 l) by (apply Rmin_glb_lt; lra). lra. }
  apply (apart_equal e f (at_ v (start e) t) I J).
  - exists (1 - t). split; [lra|]. fold v. unfold at_; cbn [fst snd]. f_equal; ring.
  - assert (K : t / l * l = t) by (field; lra). exists (1 - t / l). split.
    + split; [|assert (0 < t / l) by (apply Rdiv_lt_0_compat; lra); lra].
      assert (t / l < 1); [|lra]. apply (Rmult_lt_reg_r l); lra.
    + rewrite <- F, Q. fold v. set (m := t / l) in *. clearbody m. rewrite <- K.
      unfold at_; cbn [fst snd]. f_equal; ring.
Qed.

Theorem next_is_there e : In e E -> exists h, next_piece E e = Some h /\ In h E /\
  start h = finish e /\
  forall k, In k E -> start k = finish e -> sooner (back (dir e)) (dir k) (dir h) = false.
Proof.
  intros I.
  destruct (some_leaves C C_open E few long sided steady_off (finish e)) with (e := e)
    as (k & Ik & Sk); auto.
  assert (Fl : forall k, In k (filter (fun f => same (fst f) (snd e)) E) <->
    In k E /\ start k = finish e).
  { intros g. rewrite filter_In, same_real. reflexivity. }
  unfold next_piece.
  destruct (first_exists (back (dir e)) (filter (fun f => same (fst f) (snd e)) E) k) as (h & H).
  { apply Fl. auto. }
  exists h. split; auto. apply first_is_first in H.
  - destruct H as [H K]. apply Fl in H. split; [tauto|split; [tauto|]]. intros g Ig Sg. apply K, Fl.
    auto.
  - rewrite back_real. intros Z. apply (long e I), difference_zero, Z.
Qed.
Theorem next_once e f h : In e E -> In f E -> next_piece E e = Some h ->
  next_piece E f = Some h -> e = f.
Proof.
  intros Ie If Ne Nf. destruct (next_is_there e Ie) as (h1 & Q1 & Ih & He & Fe).
  destruct (next_is_there f If) as (h2 & Q2 & _ & Hf & Ff).
  rewrite Ne in Q1. injection Q1; intros <-. rewrite Nf in Q2. injection Q2; intros <-.
  apply NNPP. intros N. assert (V : finish f = finish e) by congruence.
  set (v := finish e) in *.
  assert (Lb : forall e f, In e E -> In f E -> finish e = v -> finish f = v -> e <> f ->
    exists k, In k E /\ start k = v /\ between v (start e) (finish k) (start f)).
  { intros d g Id Ig Vd Vg Ndg.
    apply (leaves_between C C_open E few long sided steady_off v); auto.
    - intros c Ic. rewrite <- Vd. auto.
    - rewrite <- Vd. apply in_ways_differ; auto. congruence. }
  assert (Nh : R2 (dir h) <> (0, 0)).
  { rewrite dir_real. intros Z. apply (long h Ih). symmetry. apply difference_zero, Z. }
  assert (Get : forall d g, In d E -> In g E -> finish d = v -> finish g = v -> d <> g ->
    (forall k, In k E -> start k = v -> sooner (back (dir d)) (dir k) (dir h) = false) ->
    vector_between (minus_ (start d) v) (R2 (dir h)) (minus_ (start g) v)).
  { intros d g Id Ig Vd Vg Ndg Fd. destruct (Lb d g Id Ig Vd Vg Ndg) as (k & Ik & Sk & B).
    apply between_vectors in B. specialize (Fd k Ik Sk).
    assert (Rd : R2 (back (dir d)) = minus_ (start d) v) by (rewrite back_real, Vd; reflexivity).
    rewrite <- Rd. apply (sooner_between _ (dir k)); auto.
    - rewrite Rd. intros Z. apply (long d Id). rewrite Vd. apply difference_zero, Z.
    - rewrite Rd, dir_real, Sk. exact B. }
  assert (B1 := Get e f Ie If eq_refl V N Fe).
  assert (B2 := Get f e If Ie V eq_refl (not_eq_sym N)). rewrite V in Ff. specialize (B2 Ff).
  exact (not_both_between _ _ _ B1 B2).
Qed.
(** The next pieces are the pieces. *)
Theorem next_permutes : exists N, map (next_piece E) E = map Some N /\ Permutation N E /\
  map start N = map finish E.
Proof.
  assert (G : forall l, (forall e, In e l -> In e E) -> exists N, map (next_piece E) l = map Some N
    /\ (forall h, In h N -> In h E /\ exists e, In e l /\ next_piece E e = Some h) /\
    map start N = map finish l /\ length N = length l).
  { induction l as [|e l IH]; intros Sb; [exists []; repeat split; try easy; intros h []|].
    destruct IH as (N & Q & K & S & L); [intros; apply Sb; simpl; auto|].
    destruct (next_is_there e) as (h & H & Ih & Sh & _); [apply Sb; simpl; auto|].
    exists (h :: N). cbn [map length]. rewrite H, Q, S, L, Sh. repeat split; auto.
    - destruct H0 as [<-|J]; auto. apply K, J.
    - destruct H0 as [<-|J]; [exists e; simpl; auto|]. destruct (K _ J) as [_ (f & F & Hf)].
      exists f. simpl. auto. }
  destruct (G E) as (N & Q & K & S & L); auto. exists N. split; auto. split; auto.
  apply NoDup_Permutation_bis.
  - apply (NoDup_map_inv Some). rewrite <- Q. pose proof no_piece_twice as D.
    assert (Sub : forall l, (forall e, In e l -> In e E) -> NoDup l ->
      NoDup (map (next_piece E) l)).
    { induction l as [|e l IH]; intros Sb Dl; cbn [map]; constructor; inversion Dl; subst; auto.
      - intros I. apply in_map_iff in I. destruct I as (f & F & J).
        destruct (next_is_there e) as (h & H & _); [apply Sb; simpl; auto|].
        assert (e = f); [|subst; auto].
        apply (next_once e f h); auto; [apply Sb; simpl; auto|apply Sb; simpl; auto|congruence].
      - apply IH; auto. intros; apply Sb; simpl; auto. }
    apply Sub; auto.
  - lia.
  - intros h H. apply K, H.
Qed.
Theorem pieces_close : closed (map R2e E).
Proof.
  destruct next_permutes as (N & _ & P & S). unfold closed. rewrite !map_map.
  change (Permutation (map start E) (map finish E)). rewrite <- S. apply Permutation_map.
  symmetry. exact P.
Qed.
End Permuted.
