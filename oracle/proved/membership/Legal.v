(** The edges of a legal polygon set are in it: so its sums are unions (sum_is_union). *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components Canonical.
From Proved Require Import Paths Decomposed Gaps Unique Rounds.
Open Scope R_scope.

(** Rings may touch in points: no two edges have more than a point in common. *)
Definition share_points_only (E : list (point * point)) : Prop :=
  ForallOrdPairs (fun e f => forall x y, on_segment (fst e) (snd e) x ->
    on_segment (fst e) (snd e) y -> on_segment (fst f) (snd f) x ->
    on_segment (fst f) (snd f) y -> x = y) E.
(** What is wound around, is wound around once. *)
Definition once (E : list (point * point)) : Prop :=
  forall y, ~ on_some E y -> winding E y = 0%Z \/ winding E y = 1%Z.

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
    destruct (On y Fy) as [V|V], (On z Fz) as [V'|V']; lia.
Qed.

(** Two polygon sets: their sum at the scale 1 is a union. *)
Theorem legal_sum_is_union (P Q : rings point) :
  (forall e, In e (all_edges P) -> fst e <> snd e) ->
  (forall e, In e (all_edges Q) -> fst e <> snd e) ->
  share_points_only (all_edges P) -> once (all_edges P) ->
  share_points_only (all_edges Q) -> once (all_edges Q) -> forall x,
  (exists p q, region (all_edges P) p /\ region (all_edges Q) q /\ x = add p q) <->
  by_vertex_of_E (all_edges P) (all_edges Q) x \/ by_vertex_of_F (all_edges P) (all_edges Q) x \/
  by_edges (all_edges P) (all_edges Q) x.
Proof.
  intros NP NQ SP OP SQ OQ x. apply sum_is_union; try apply legal_has_edges; auto;
    unfold closed, all_edges; apply rings_closed.
Qed.

(** Rings of three vertices or more, no edge of length zero, no two edges with more than a point in
    common, and nothing wound around but once *)
Definition is_legal (r : rings point) : Prop :=
  (forall ring, In ring r -> (3 <= length ring)%nat) /\
  (forall e, In e (all_edges r) -> fst e <> snd e) /\
  share_points_only (all_edges r) /\ once (all_edges r).
Lemma legal_region r x : is_legal r -> set_of r x <-> region (all_edges r) x.
Proof.
  intros (L & _). unfold set_of. destruct r as [|[|a [|b [|c l]]] [|k r]]; try tauto;
    specialize (L _ (or_introl eq_refl)); simpl in L; lia.
Qed.
Lemma legal_closed r : closed (all_edges r).
Proof. apply rings_closed. Qed.
Lemma legal_edges_in r : is_legal r -> has_edges (all_edges r).
Proof.
  intros (_ & N & S & O). apply legal_has_edges; auto. apply legal_closed.
Qed.
