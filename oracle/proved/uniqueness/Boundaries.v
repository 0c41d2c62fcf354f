(** Two canonical forms of a closed set have as many polygons, with the same components, and their
    edges cover the same points. *)
From Coq Require Import Lra Lia Psatz Classical.
From Proved Require Import Definitions Form Crossings Fans Curves Unions Local Across Components
  Overlaps OneForm Paths Decomposed Gaps Unique.
Open Scope R_scope.

Definition form_edges (ps : list (polygon point)) : edges_t := all_edges (rings_of ps).

(** ** As many components: an injection of numbers below n into those below m *)
Lemma counted (f : nat -> nat -> Prop) : forall n m,
  (forall i, (i < n)%nat -> exists j, (j < m)%nat /\ f i j) ->
  (forall i k j, (i < n)%nat -> (k < n)%nat -> f i j -> f k j -> i = k) -> (n <= m)%nat.
Proof.
  intros n m Ex Inj.
  assert (L : exists l, length l = n /\ NoDup l /\ forall j, In j l -> (j < m)%nat /\
    exists i, (i < n)%nat /\ f i j).
  { assert (P : forall k, (k <= n)%nat -> exists l, length l = k /\ NoDup l /\
      forall j, In j l -> (j < m)%nat /\ exists i, (i < k)%nat /\ f i j).
    { induction k as [|k IH]; intros Le.
      { exists []. split; [reflexivity|split; [constructor|intros j []]]. }
      destruct IH as (l & Ll & Nd & H); [lia|]. destruct (Ex k) as (j & J & F); [lia|].
      exists (j :: l). split; [simpl; lia|]. split.
      - constructor; auto. intros I. destruct (H j I) as (_ & i & I1 & I2).
        assert (i = k) by (apply (Inj i k j); auto; lia). lia.
      - intros x [<-|I]; [split; auto; exists k; auto|]. destruct (H x I) as (A & i & B & D).
        split; auto. exists i. auto. }
    apply P. lia. }
  destruct L as (l & Ll & Nd & H). rewrite <- Ll, <- (seq_length m 0).
  apply NoDup_incl_length; auto. intros j J. apply in_seq. destruct (H j J). lia.
Qed.
Lemma as_many U C n D m : falls_into U C n -> falls_into U D m -> (n <= m)%nat.
Proof.
  intros FC FD. apply (counted (fun i j => forall x, C i x <-> D j x)).
  - intros i I. exact (components_unique U C n D m FC FD i I).
  - intros i k j I K Hi Hk. destruct FC as (_ & CC). destruct (CC i I) as ((x & X) & _ & _ & Dis).
    apply (Dis k x K X). apply Hk, Hi, X.
Qed.

(** ** The same boundary *)
Lemma edges_closed (E : edges_t) x : (forall e, 0 < e -> exists y, near e x y /\ on_some E y) ->
  on_some E x.
Proof.
  intros H. apply NNPP. intros N. destruct (edges_near E x N) as (e & He & K).
  destruct (H e He) as (y & Y & O). exact (K y Y O).
Qed.
(** Near each point of an edge the edge has points that are not in a list. *)
Lemma aside (few : list point) a b x e : a <> b -> on_segment a b x -> 0 < e ->
  exists y, on_segment a b y /\ near e x y /\ ~ In y few.
Proof.
  intros N (t & T & ->) He.
  change (exists y, on_segment a b y /\ near e (at_ a b t) y /\ ~ In y few).
  destruct (at_near a b t e He) as (d & Hd & K).
  (* an interval of parameters, of which only finitely many hit the list *)
  assert (I : exists l h, 0 <= l < h /\ h <= 1 /\ forall u, l < u < h -> Rabs (u - t) < d).
  { destruct (Rlt_dec t 1).
    - exists t, (Rmin 1 (t + d)). pose proof (Rmin_l 1 (t + d)). pose proof (Rmin_r 1 (t + d)).
      split; [split; [lra|apply Rmin_glb_lt; lra]|split; [lra|]]. intros u U. apply Rabs_def1; lra.
    - exists (Rmax 0 (1 - d)), 1. pose proof (Rmax_l 0 (1 - d)). pose proof (Rmax_r 0 (1 - d)).
      split; [split; [lra|apply Rmax_lub_lt; lra]|split; [lra|]]. intros u U.
      apply Rabs_def1; lra. }
  destruct I as (l & h & L & H1 & Hu).
  assert (P : forall l, l < h -> 0 <= l -> exists u, l < u < h /\ ~ In (at_ a b u) few).
  { clear - N H1. induction few as [|p few IH]; intros l L L0.
    - exists ((l + h) / 2). split; [lra|]. intros [].
    - destruct (IH l L L0) as (u & U & O). destruct (classic (at_ a b u = p)) as [E|E].
      + destruct (IH u) as (w & W & Ow); [lra|lra|]. exists w. split; [lra|].
        intros [Q|Q]; [|exact (Ow Q)]. rewrite <- E in Q. apply N. unfold at_ in Q.
        injection Q as Q1 Q2. destruct a as [a1 a2], b as [b1 b2]; cbn [fst snd] in *. f_equal; nra.
      + exists u. split; auto. intros [Q|Q]; auto. }
  destruct (P l) as (u & U & O); [lra|lra|]. exists (at_ a b u).
  split; [apply at_on; lra|]. split; auto.
Qed.

Lemma path_next {A} (first previous : A) rest e : In e (previous :: rest) ->
  exists f, In (e, f) (path first previous rest).
Proof.
  revert previous. induction rest as [|n rest IH]; intros previous I; simpl in *.
  - destruct I as [<-|[]]. exists first. auto.
  - destruct I as [<-|I]; [exists n; auto|]. destruct (IH n I) as (f & F). exists f. auto.
Qed.
Lemma ring_next {A} (ring : list A) e : In e ring -> exists f, In (e, f) (ring_edges ring).
Proof. destruct ring as [|a r]; [intros []|]. apply path_next. Qed.
(** No edge of a ring has length zero: its next edge turns. *)
Lemma ring_edge_long ring a b : is_ring ring -> In (a, b) (ring_edges ring) -> a <> b.
Proof.
  intros (_ & T) I E. destruct (ring_next _ _ I) as (f & F). apply (T _ _ F). subst.
  unfold orient; cbn [fst snd]. ring.
Qed.

Lemma in_form S ps a b : is_form S ps -> In (a, b) (form_edges ps) -> exists C : point -> Prop,
  (forall x, C x -> interior S x) /\ divides C S (a, b) /\ a <> b.
Proof.
  intros (C & FC & _ & _ & H) I. unfold form_edges, all_edges in I. apply in_flat_map in I.
  destruct I as (ring & R & I). unfold rings_of in R. apply in_flat_map in R.
  destruct R as ((outer & holes) & P & R). cbn [fst snd] in R.
  destruct (In_nth_error ps _ P) as (i & Ei). destruct (H i outer holes Ei) as (_ & _ & K).
  destruct (K ring R) as (Rg & D). exists (C i).
  split; [|split; [apply D, I|exact (ring_edge_long ring a b Rg I)]].
  intros x X. apply (proj1 FC x). exists i. split; auto. apply nth_error_Some. congruence.
Qed.

Theorem boundary_within S ps qs x : is_closed S -> is_form S ps -> is_form S qs ->
  on_some (form_edges ps) x -> on_some (form_edges qs) x.
Proof.
  intros Cl FP FQ (a & b & I & O). destruct (in_form S ps a b FP I) as (C & CS & (few & D) & N).
  assert (In2 : forall y, S y -> ~ on_some (form_edges qs) y -> interior S y).
  { destruct FQ as (_ & _ & H & _). intros y Y Z. apply H; auto. intros c d J Oc. apply Z.
    exists c, d. auto. }
  apply edges_closed. intros e He. destruct (aside few a b x e N O He) as (y & Oy & Ny & Out).
  exists y. split; auto. apply (edge_under_edge S _ y C a b Cl In2); auto.
  - intros z Z. destruct (CS z Z) as (r & R & K). apply K, near_self, R.
  - apply segment_range in Oy. tauto.
  - destruct (D y Oy) as [F|F]; [destruct (Out F)|exact F].
Qed.
(** Of a closed set two canonical forms have as many polygons, and the same points on edges. *)
Theorem forms_agree S ps qs : is_closed S -> is_form S ps -> is_form S qs ->
  length ps = length qs /\ forall x, on_some (form_edges ps) x <-> on_some (form_edges qs) x.
Proof.
  intros Cl FP FQ. split.
  - destruct FP as (C & FC & _), FQ as (D & FD & _).
    pose proof (as_many _ _ _ _ _ FC FD). pose proof (as_many _ _ _ _ _ FD FC). lia.
  - intros x. split; apply (boundary_within S); auto.
Qed.
(** A region is closed, so this is about sets given by rings. *)
Lemma region_is_closed E : is_closed (region E).
Proof. intros x H. apply region_closed, H. Qed.
