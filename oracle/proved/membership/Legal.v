(** The edges of a legal polygon set are in it: so its sums are unions (sum_is_union). Points and
    segments are their edges. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Fans Curves Unions Local
  Across Overlaps Components Canonical.
From Proved Require Import Paths Decomposed Gaps Unique Rounds.
Open Scope R_scope.

Lemma held_only x e l r : (forall f, In f (l ++ r) -> ~ on_segment (fst f) (snd f) x) ->
  inner (fst e) (snd e) x -> held x (l ++ e :: r) [e].
Proof.
  intros N I. induction l as [|f l IH]; simpl in *.
  - apply held_one; auto. induction r as [|g r IH]; [apply held_none|]. apply held_not; [auto with
    datatypes|].
    apply IH. intros f J. apply N. simpl. auto.
  - apply held_not; auto.
Qed.
Lemma shared_list a b (E : edges_t) : (forall f, In f E -> forall x y, on_segment a b x ->
  on_segment a b y ->
    on_segment (fst f) (snd f) x -> on_segment (fst f) (snd f) y -> x = y) ->
  exists L, forall f x, In f E -> on_segment a b x -> on_segment (fst f) (snd f) x -> In x L.
Proof.
  induction E as [|f E IH]; intros H; [exists []; intros f x []|].
  destruct IH as (L & K); [intros g I; apply H; simpl; auto|].
  destruct (classic (exists x0, on_segment a b x0 /\ on_segment (fst f) (snd f) x0)) as [(x0 & A &
    B)|N].
  - exists (x0 :: L). intros g x [<-|I] X Y; [left; apply (H f (or_introl eq_refl)); auto|right;
    eauto].
  - exists L. intros g x [<-|I] X Y; [destruct N; eauto|eauto].
Qed.
Theorem legal_has_edges E : closed E -> (forall e, In e E -> fst e <> snd e) ->
  share_points_only E -> once E -> has_edges E.
Proof.
  intros Cl NN Sh On p (a & b & I & O) e He. pose proof (NN _ I) as Nab. cbn [fst snd] in Nab.
  apply in_split in I. destruct I as (l & r & ->).
  destruct (pairs_at _ _ _ _ Sh) as [Sl Sr]. cbn [fst snd] in Sl, Sr.
  destruct (shared_list a b (l ++ r)) as (L & HL).
  { intros f J x y X Y Fx Fy. apply in_app_or in J. destruct J as [J|J]; [apply (Sl f J)|apply (Sr
    f J)]; auto. }
  (* an inner point of the edge near p, on no other edge *)
  assert (X : exists x, near (e / 2) p x /\ inner a b x /\ ~ In x L).
  { destruct O as (t & T & Ep). change p with p in *. rewrite Ep. clear Ep p.
    destruct (at_near a b t (e / 2)) as (d & D & K); [lra|].
    assert (U : exists u, 0 <= u <= 1 /\ u <> t /\ Rabs (u - t) < d).
    { destruct (Rle_dec t (1 / 2)).
      - exists (t + Rmin (1 / 2) (d / 2)). assert (0 < Rmin (1 / 2) (d / 2)) by (apply Rmin_glb_lt;
        lra).
        pose proof (Rmin_l (1 / 2) (d / 2)). pose proof (Rmin_r (1 / 2) (d / 2)).
        repeat split; try lra. apply Rabs_def1; lra.
      - exists (t - Rmin (1 / 2) (d / 2)). assert (0 < Rmin (1 / 2) (d / 2)) by (apply Rmin_glb_lt;
        lra).
        pose proof (Rmin_l (1 / 2) (d / 2)). pose proof (Rmin_r (1 / 2) (d / 2)).
        repeat split; try lra. apply Rabs_def1; lra. }
    destruct U as (u & U & Nu & Du).
    assert (Nat : at_ a b t <> at_ a b u).
    { intros Q. apply Nab. unfold at_ in Q. destruct a as [a1 a2], b as [b1 b2]. cbn [fst snd] in Q.
      injection Q; intros Q2 Q1. f_equal; nra. }
    destruct (one_not_in (a :: b :: L) _ _ Nat) as (x & Ix & Nx).
    exists x. assert (Ox : on_segment a b x).
    { apply (segment_in_segment a b (at_ a b t) (at_ a b u)); auto; apply at_on; lra. }
    split; [|split].
    - destruct Ix as (w & W & ->).
      replace (fst (at_ a b t) + w * (fst (at_ a b u) - fst (at_ a b t)),
               snd (at_ a b t) + w * (snd (at_ a b u) - snd (at_ a b t)))
        with (at_ a b (t + w * (u - t))) by (unfold at_; cbn [fst snd]; f_equal; ring).
      apply K. replace (t + w * (u - t) - t) with (w * (u - t)) by ring. rewrite Rabs_mult.
      rewrite (Rabs_right w) by lra. pose proof (Rabs_pos (u - t)). nra.
    - apply inner_of_segment; auto; intros ->; apply Nx; simpl; auto.
    - intros J. apply Nx. simpl. auto. }
  destruct X as (x & Nx & Ix & Lx).
  assert (Off : forall f, In f (l ++ r) -> ~ on_segment (fst f) (snd f) x).
  { intros f J Fx. apply Lx, (HL f x J); auto. apply inner_on_segment, Ix. }
  pose proof (held_only x (a, b) l r Off Ix) as Hd.
  destruct (winding_across _ _ _ Cl Hd) as (g & n & G & W).
  destruct (edges_near (l ++ r) x) as (h & Hh & Far).
  { intros (c & d & J & S). apply (Off (c, d) J S). }
  set (k := Rmin (e / 2) (Rmin g h)).
  assert (K : 0 < k) by (unfold k; repeat apply Rmin_glb_lt; lra).
  assert (Use : forall y, near k x y -> orient a b y <> 0 ->
    ~ on_some (l ++ (a, b) :: r) y /\ winding (l ++ (a, b) :: r) y = (n + is_left_of a b y)%Z).
  { intros y Y Oy. unfold k in Y. apply near_min in Y. destruct Y as [_ Y]. apply near_min in Y.
    destruct Y as [Y1 Y2]. split.
    - intros (c & d & J & S). apply in_app_or in J. destruct J as [J|[J|J]].
      + apply (Far y Y2). exists c, d. split; auto with datatypes.
      + injection J; intros; subst. apply Oy. destruct (segment_range _ _ _ S). auto.
      + apply (Far y Y2). exists c, d. split; auto with datatypes.
    - rewrite (W y Y1); [simpl; lia|]. intros f [<-|[]]. exact Oy. }
  assert (Ox : orient a b x = 0) by (apply inner_on_line, Ix).
  destruct (left_close a b x k Nab Ox K) as (y & Y & Ly).
  destruct (right_close a b x k Nab Ox K) as (z & Z & Lz).
  destruct (Use y Y ltac:(lra)) as [Fy Wy]. destruct (Use z Z ltac:(lra)) as [Fz Wz].
  exists y. split; [|split].
  - apply near_near with x; auto. unfold k in Y. apply near_min in Y. tauto.
  - apply off_all, Fy.
  - unfold is_left_of in Wy, Wz. destruct (Rlt_dec 0 (orient a b y)); [|lra].
    destruct (Rlt_dec 0 (orient a b z)); [lra|].
    destruct (On y (off_all _ _ Fy)) as [V|V], (On z (off_all _ _ Fz)) as [V'|V']; lia.
Qed.

(** Enough of it: rings of three vertices or more, no edge of length zero, no two edges with more
    than a point in common, and nothing wound around but once. Rings may run either way. *)
Definition winds_once (r : rings point) : Prop :=
  (forall ring, In ring r -> (3 <= length ring)%nat) /\
  (forall e, In e (all_edges r) -> fst e <> snd e) /\
  share_points_only (all_edges r) /\ once (all_edges r).
Lemma set_is_region r x : winds_once r -> set_of r x <-> region (all_edges r) x.
Proof.
  intros (L & _). unfold set_of. destruct r as [|[|a [|b [|c l]]] [|k r]]; try tauto;
    specialize (L _ (or_introl eq_refl)); simpl in L; lia.
Qed.
Lemma rings_are_closed r : closed (all_edges r).
Proof. apply rings_closed. Qed.
Lemma polygon_set_winds_once ps : is_polygon_set ps -> winds_once (rings_of ps).
Proof.
  intros (H & S & O).
  assert (R : forall ring, In ring (rings_of ps) -> is_simple ring).
  { intros ring I. apply in_flat_map in I. destruct I as ([outer holes] & I & J).
    destruct (H outer holes I) as (K & _ & L & _). destruct J as [<-|J]; [exact K|apply L, J]. }
  split; [|split; auto].
  - intros ring I. apply (R ring I).
  - intros e I. apply in_flat_map in I. destruct I as (ring & I & J).
    destruct (R ring I) as (_ & N & _). apply N, J.
Qed.

(** What a sum has to know of an operand: it is what its edges wind around, with them in it; or it
    is its edges, which wind around nothing. *)
Definition drawn (E : edges_t) (S : point -> Prop) : Prop := closed E /\
  ((forall p, S p <-> region E p) /\ has_edges E \/
   (forall p, S p <-> on_some E p) /\ forall y, winding E y = 0%Z).
Lemma back_and_forth a b y : (crossing a b y + (crossing b a y + 0) = 0)%Z.
Proof.
  unfold crossing. assert (O : orient b a y = - orient a b y + 0) by (unfold orient; ring).
  rewrite O. split_decisions; try reflexivity; exfalso; lra.
Qed.
Lemma no_crossing a y : crossing a a y = 0%Z.
Proof. unfold crossing. split_decisions; auto; exfalso; lra. Qed.
Lemma on_segment_back a b p : on_segment a b p -> on_segment b a p.
Proof.
  intros (t & T & ->). exists (1 - t). split; [lra|]. f_equal; ring.
Qed.
Lemma winds_once_is_drawn r : winds_once r -> drawn (all_edges r) (set_of r).
Proof.
  intros L. split; [apply rings_are_closed|]. left.
  split; [intros p; apply set_is_region, L|]. destruct L as (_ & N & S & O).
  apply legal_has_edges; auto. apply rings_are_closed.
Qed.
Lemma legal_is_drawn ps : is_legal ps -> drawn (all_edges (rings_of ps)) (set_of (rings_of ps)).
Proof.
  intros [(a & ->)|[(a & b & _ & ->)|L]].
  - split; [apply rings_are_closed|]. right. split.
    + intros p. simpl. split.
      * intros ->. exists a, a. split; [left; auto|apply on_segment_start].
      * intros (c & d & [Q|[]] & t & T & X). injection Q; intros; subst c d.
        rewrite X. destruct a. simpl. f_equal; ring.
    + intros y. simpl. rewrite no_crossing. reflexivity.
  - split; [apply rings_are_closed|]. right. split.
    + intros p. simpl. split.
      * intros O. exists a, b. split; [left; auto|exact O].
      * intros (c & d & [Q|[Q|[]]] & O); injection Q; intros; subst c d;
          auto using on_segment_back.
    + intros y. simpl. apply back_and_forth.
  - apply winds_once_is_drawn, polygon_set_winds_once, L.
Qed.

(** The sum of two such sets is a union, thin ones or not. *)
Lemma by_edges_back E F x : by_edges E F x <-> by_edges F E x.
Proof.
  split; intros (p & q & P & Q & ->); exists q, p; repeat split; auto;
    unfold add; f_equal; ring.
Qed.
Lemma lines_and_region E F x : closed F -> has_edges F ->
  (exists p q, on_some E p /\ region F q /\ x = add p q) <->
  by_vertex_of_E E F x \/ by_edges E F x.
Proof.
  intros C H. split.
  - intros (p & q & (a & b & I & O) & R & X). destruct (classic (by_edges E F x)) as [B|B]; auto.
    left. exists a, b. split; auto. apply (along_edge F a b x p); auto.
    + intros z Z N. apply B. exists z, (minus_ x z). split; [exists a, b; auto|split; auto].
      apply add_minus.
    + rewrite X. replace (minus_ (add p q) p) with q; auto.
      unfold minus_, add; destruct q; simpl; f_equal; ring.
  - intros [(a & b & I & R)|(p & q & P & Q & X)].
    + exists a, (minus_ x a). split; [|split; [exact R|apply add_minus]].
      exists a, b. split; auto. apply on_segment_start.
    + exists p, q. auto.
Qed.
Lemma nothing_within E y : (forall z, winding E z = 0%Z) -> ~ region E y.
Proof. intros W R. destruct (R 1 ltac:(lra)) as (z & _ & _ & K). rewrite W in K. lia. Qed.
Theorem drawn_sum_is_union E F S T x : drawn E S -> drawn F T ->
  (exists p q, S p /\ T q /\ x = add p q) <->
  by_vertex_of_E E F x \/ by_vertex_of_F E F x \/ by_edges E F x.
Proof.
  assert (Swap : forall (A B C D : point -> Prop), (forall p, A p <-> B p) ->
    (forall q, C q <-> D q) ->
    (exists p q, A p /\ C q /\ x = add p q) <-> exists p q, B p /\ D q /\ x = add p q).
  { intros A B C D K L. split; intros (p & q & H1 & H2 & H3); exists p, q; split;
      try (apply K; auto); split; auto; apply L; auto. }
  intros (CE & [(SE & HE)|(SE & WE)]) (CF & [(SF & HF)|(SF & WF)]); rewrite (Swap _ _ _ _ SE SF).
  - apply sum_is_union; auto.
  - assert (N : ~ by_vertex_of_E E F x).
    { intros (a & b & _ & R). exact (nothing_within _ _ WF R). }
    transitivity (by_vertex_of_E F E x \/ by_edges F E x).
    + rewrite <- lines_and_region by auto.
      split; intros (p & q & H1 & H2 & ->); exists q, p; repeat split; auto;
        unfold add; f_equal; ring.
    + rewrite (by_edges_back F E). change (by_vertex_of_E F E x) with (by_vertex_of_F E F x).
      tauto.
  - rewrite lines_and_region by auto.
    assert (N : ~ by_vertex_of_F E F x).
    { intros (a & b & _ & R). exact (nothing_within _ _ WE R). }
    tauto.
  - assert (N : ~ by_vertex_of_F E F x).
    { intros (a & b & _ & R). exact (nothing_within _ _ WE R). }
    assert (M : ~ by_vertex_of_E E F x).
    { intros (a & b & _ & R). exact (nothing_within _ _ WF R). }
    unfold by_edges in *. tauto.
Qed.
