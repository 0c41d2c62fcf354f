(** The winding number of closed rings does not change near a point that is on none of them. *)
From Coq Require Import Lra Lia Psatz Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions.
Open Scope R_scope.

(** What an edge's crossing number changes by at one of its ends, seen from x *)
Definition reached (v y : point) : Z := if Rle_dec (fst v) (fst y) then 1%Z else 0%Z.
Definition change (x v y : point) : Z :=
  if Req_EM_T (fst v) (fst x) then if Rlt_dec (snd x) (snd v) then reached v y else 0%Z else 0%Z.

Lemma change_off x v y : fst v <> fst x -> change x v y = 0%Z.
Proof. intros N. unfold change. destruct (Req_EM_T (fst v) (fst x)); [contradiction|reflexivity].
  Qed.
Lemma change_above x v y : fst v = fst x -> snd x < snd v -> change x v y = reached v y.
Proof. intros E L. unfold change. destruct (Req_EM_T (fst v) (fst x)); [|contradiction].
  destruct (Rlt_dec (snd x) (snd v)); [reflexivity|lra]. Qed.
Lemma change_below x v y : fst v = fst x -> snd v <= snd x -> change x v y = 0%Z.
Proof. intros E L. unfold change. destruct (Req_EM_T (fst v) (fst x)); [|contradiction].
  destruct (Rlt_dec (snd x) (snd v)); [lra|reflexivity]. Qed.

Lemma near_min e f x y : near (Rmin e f) x y -> near e x y /\ near f x y.
Proof. intros [A B]. pose proof (Rmin_l e f). pose proof (Rmin_r e f). unfold near. repeat split;
  lra. Qed.
Lemma near_x e x y : near e x y -> fst x - e < fst y < fst x + e.
Proof. intros [A _]. apply Rabs_def2 in A. lra. Qed.
Lemma near_left a b x : 0 < orient a b x -> exists e, 0 < e /\ forall y, near e x y ->
  0 < orient a b y.
Proof.
  intros H. destruct (near_right b a x) as (e & He & L); [rewrite orient_swap; lra|].
  exists e. split; auto. intros y Y. specialize (L y Y). rewrite orient_swap in L. lra.
Qed.

Lemma segment_swap a b y : on_segment a b y -> on_segment b a y.
Proof.
  intros (t & T & E). exists (1 - t). split; [lra|]. rewrite E. f_equal; ring.
Qed.

Lemma crossing_near_right a b x : fst a < fst b -> ~ on_segment a b x ->
  exists e C, 0 < e /\ forall y, near e x y -> crossing a b y = (C + change x b y - change x a y)%Z.
Proof.
  intros L N.
  assert (OFF : fst a <= fst x <= fst b -> orient a b x <> 0).
  { intros I E. apply N. exists ((fst x - fst a) / (fst b - fst a)). split.
    - split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]|].
      apply Rmult_le_reg_r with (fst b - fst a); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l;
        lra.
    - destruct x as [x1 x2]; simpl in *. unfold orient in E; simpl in E. f_equal.
      + field. lra.
      + apply Rmult_eq_reg_l with (fst b - fst a); [|lra]. field_simplify; [|lra]. lra. }
  destruct (Rtotal_order (fst x) (fst a)) as [X|[X|X]].
  - exists (fst a - fst x), 0%Z. split; [lra|]. intros y Y. apply near_x in Y.
    rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
  - assert (O : orient a b x <> 0) by (apply OFF; lra).
    assert (S : orient a b x = (fst b - fst a) * (snd x - snd a)) by (unfold orient; rewrite X;
      ring).
    destruct (Rtotal_order (snd x) (snd a)) as [Y|[Y|Y]].
    + destruct (near_right a b x) as (e & He & Ne); [nra|]. exists (Rmin e (fst b - fst x)), 0%Z.
      split; [apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H. destruct H as [H1 H2].
      specialize (Ne y H1). apply near_x in H2. rewrite (change_off x b), (change_above x a) by lra.
      unfold crossing, reached. split_decisions; try lra; reflexivity.
    + exfalso. apply O. rewrite S, Y. ring.
    + destruct (near_left a b x) as (e & He & Ne); [nra|]. exists (Rmin e (fst b - fst x)), 0%Z.
      split; [apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H. destruct H as [H1 H2].
      specialize (Ne y H1). apply near_x in H2. rewrite (change_off x b), (change_below x a) by lra.
      unfold crossing. split_decisions; try lra; reflexivity.
  - destruct (Rtotal_order (fst x) (fst b)) as [Z|[Z|Z]].
    + assert (O : orient a b x <> 0) by (apply OFF; lra).
      destruct (Rtotal_order (orient a b x) 0) as [Y|[Y|Y]]; [|contradiction|].
      * destruct (near_right a b x Y) as (e & He & Ne).
        exists (Rmin e (Rmin (fst b - fst x) (fst x - fst a))), (-1)%Z.
        split; [repeat apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H.
          destruct H as [H1 H2].
        apply near_min in H2. destruct H2 as [H2 H3]. specialize (Ne y H1). apply near_x in H2.
          apply near_x in H3.
        rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
      * destruct (near_left a b x Y) as (e & He & Ne).
        exists (Rmin e (Rmin (fst b - fst x) (fst x - fst a))), 0%Z.
        split; [repeat apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H.
          destruct H as [H1 H2].
        apply near_min in H2. destruct H2 as [H2 H3]. specialize (Ne y H1). apply near_x in H2.
          apply near_x in H3.
        rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
    + assert (O : orient a b x <> 0) by (apply OFF; lra).
      assert (S : orient a b x = (fst b - fst a) * (snd x - snd b)) by (unfold orient; rewrite Z;
        ring).
      destruct (Rtotal_order (snd x) (snd b)) as [Y|[Y|Y]].
      * destruct (near_right a b x) as (e & He & Ne); [nra|].
        exists (Rmin e (fst x - fst a)), (-1)%Z.
        split; [apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H. destruct H as [H1 H2].
        specialize (Ne y H1). apply near_x in H2. rewrite (change_off x a), (change_above x b) by
          lra.
        unfold crossing, reached. split_decisions; try lra; reflexivity.
      * exfalso. apply O. rewrite S, Y. ring.
      * destruct (near_left a b x) as (e & He & Ne); [nra|]. exists (Rmin e (fst x - fst a)), 0%Z.
        split; [apply Rmin_glb_lt; lra|]. intros y H. apply near_min in H. destruct H as [H1 H2].
        specialize (Ne y H1). apply near_x in H2. rewrite (change_off x a), (change_below x b) by
          lra.
        unfold crossing. split_decisions; try lra; reflexivity.
    + exists (fst x - fst b), 0%Z. split; [lra|]. intros y Y. apply near_x in Y.
      rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
Qed.

Lemma crossing_near a b x : ~ on_segment a b x ->
  exists e C, 0 < e /\ forall y, near e x y -> crossing a b y = (C + change x b y - change x a y)%Z.
Proof.
  intros N. destruct (Rtotal_order (fst a) (fst b)) as [L|[L|L]].
  - apply crossing_near_right; auto.
  - exists 1, 0%Z. split; [lra|]. intros y _. rewrite crossing_vertical by auto.
    destruct (Req_EM_T (fst a) (fst x)) as [E|E]; [|rewrite !change_off by lra; reflexivity].
    assert (S : forall u v w, u < v < w \/ w < v < u \/ v = u \/ v = w -> exists t, 0 <= t <= 1 /\
      v = u + t * (w - u)).
    { intros u v w [[H1 H2]|[[H1 H2]|[->| ->]]].
      - exists ((v - u) / (w - u)). split; [|field; lra].
        split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]|].
        apply Rmult_le_reg_r with (w - u); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
      - exists ((u - v) / (u - w)). split; [|field; lra].
        split; [apply Rmult_le_pos; [lra|apply Rlt_le, Rinv_0_lt_compat; lra]|].
        apply Rmult_le_reg_r with (u - w); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
      - exists 0. split; [lra|ring].
      - exists 1. split; [lra|ring]. }
    assert (NS : ~ (snd a < snd x < snd b \/ snd b < snd x < snd a \/ snd x = snd a \/ snd x = snd
      b)).
    { intros H. apply S in H. destruct H as (t & T & Q). apply N. exists t. split; auto.
      destruct x as [x1 x2]; simpl in *. rewrite <- Q. f_equal. rewrite <- L, E. ring. }
    destruct (Rlt_dec (snd x) (snd a)).
    + rewrite !change_above by lra. unfold reached. rewrite L. lia.
    + rewrite !change_below by lra. reflexivity.
  - destruct (crossing_near_right b a x) as (e & C & He & H); [lra|intros M;
    apply N, segment_swap, M|].
    exists e, (- C)%Z. split; auto. intros y Y. rewrite crossing_reversed, (H y Y). lia.
Qed.

Theorem winding_near E x : Permutation (map fst E) (map snd E) -> (forall a b, In (a, b) E ->
  ~ on_segment a b x) ->
  exists e, 0 < e /\ forall y, near e x y -> winding E y = winding E x.
Proof.
  intros P N.
  assert (G : exists e C, 0 < e /\ forall y, near e x y ->
    winding E y = (C + sumz (fun v => change x v y) (map snd E) - sumz (fun v => change x v y) (map
      fst E))%Z).
  { clear P. induction E as [|[a b] E IH].
    - exists 1, 0%Z. split; [lra|]. reflexivity.
    - destruct IH as (e & C & He & H); [intros u v I; apply N; simpl; auto|].
      destruct (crossing_near a b x) as (f & D & Hf & G); [apply N; simpl; auto|].
      exists (Rmin e f), (C + D)%Z. split; [apply Rmin_glb_lt; auto|].
      intros y Y. apply near_min in Y. destruct Y as [Y1 Y2]. specialize (H y Y1).
        specialize (G y Y2).
      change (winding ((a, b) :: E) y) with (crossing a b y + winding E y)%Z. rewrite G, H.
      unfold sumz. simpl. lia. }
  destruct G as (e & C & He & H). exists e. split; auto.
  assert (F : forall y, near e x y -> winding E y = C).
  { intros y Y. rewrite (H y Y), (sumz_perm _ _ _ P). lia. }
  intros y Y. rewrite (F y Y), F; auto. split; rewrite Rminus_diag_eq, Rabs_R0; auto.
Qed.

Lemma path_closed {A} (l : list A) : forall first prev,
  Permutation (map snd (path first prev l)) (first :: l) /\ map fst (path first prev l) = prev :: l.
Proof.
  induction l as [|z r IH]; intros first prev; simpl.
  - split; auto.
  - destruct (IH first z) as [I1 I2]. split; [|rewrite I2; reflexivity].
    rewrite I1. apply perm_swap.
Qed.
Lemma ring_closed {A} (l : list A) : Permutation (map fst (ring_edges l)) (map snd (ring_edges l)).
Proof.
  destruct l as [|a r]; simpl; auto. destruct (path_closed r a a) as [I1 I2]. rewrite I1, I2.
    reflexivity.
Qed.
Theorem rings_near (rs : list (list point)) x : (forall a b, In (a, b) (flat_map ring_edges rs) ->
  ~ on_segment a b x) ->
  exists e, 0 < e /\ forall y, near e x y -> winding (flat_map ring_edges rs) y = winding (flat_map
    ring_edges rs) x.
Proof.
  apply winding_near. induction rs as [|l rs IH]; simpl; auto. rewrite !map_app.
    apply Permutation_app; auto. apply ring_closed.
Qed.
