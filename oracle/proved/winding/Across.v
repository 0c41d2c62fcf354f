(** What the winding number of closed rings changes by from one side of an edge to the other: edges
    that overlap are counted. *)
From Coq Require Import Lra Lia Psatz Permutation.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local.
Open Scope R_scope.

Definition inner (a b x : point) : Prop := exists t, 0 < t < 1 /\
  x = (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a)).
Definition is_left_of (a b y : point) : Z := if Rlt_dec 0 (orient a b y) then 1%Z else 0%Z.

Lemma inner_on_line a b x : inner a b x -> orient a b x = 0.
Proof. intros (t & T & ->). unfold orient; simpl; ring. Qed.

Lemma crossing_across a b x : inner a b x -> exists e C, 0 < e /\ forall y, near e x y ->
  orient a b y <> 0 -> crossing a b y = (C + change x b y - change x a y + is_left_of a b y)%Z.
Proof.
  intros (t & T & ->). set (x := (_, _)). unfold is_left_of.
  destruct (Rtotal_order (fst a) (fst b)) as [L|[L|L]].
  - assert (X : fst a < fst x < fst b) by (unfold x; simpl; nra).
    exists (Rmin (fst x - fst a) (fst b - fst x)), (-1)%Z. split; [apply Rmin_glb_lt; lra|].
    intros y Y N. apply near_min in Y. destruct Y as [Y1 Y2].
    apply near_x in Y1. apply near_x in Y2.
    rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
  - assert (X : fst x = fst a) by (unfold x; simpl; rewrite L; ring).
    assert (O : forall y, orient a b y = - (snd b - snd a) * (fst y - fst a))
      by (intros y; unfold orient; rewrite L; ring).
    destruct (Rtotal_order (snd a) (snd b)) as [U|[U|U]].
    + assert (S : snd a < snd x < snd b) by (unfold x; simpl; nra).
      exists 1, (-1)%Z. split; [lra|]. intros y _ N. rewrite crossing_vertical by auto.
      rewrite (change_above x b), (change_below x a) by lra. unfold reached.
      rewrite O in *. split_decisions; try reflexivity; exfalso; nra.
    + exists 1, 0%Z. split; [lra|]. intros y _ N. exfalso. apply N. rewrite O, U. ring.
    + assert (S : snd b < snd x < snd a) by (unfold x; simpl; nra).
      exists 1, 0%Z. split; [lra|]. intros y _ N. rewrite crossing_vertical by auto.
      rewrite (change_above x a), (change_below x b) by lra. unfold reached.
      rewrite O in *. split_decisions; try reflexivity; exfalso; nra.
  - assert (X : fst b < fst x < fst a) by (unfold x; simpl; nra).
    exists (Rmin (fst x - fst b) (fst a - fst x)), 0%Z. split; [apply Rmin_glb_lt; lra|].
    intros y Y N. apply near_min in Y. destruct Y as [Y1 Y2].
    apply near_x in Y1. apply near_x in Y2.
    rewrite !change_off by lra. unfold crossing. split_decisions; try lra; reflexivity.
Qed.

Lemma inner_on_segment a b x : inner a b x -> on_segment a b x.
Proof. intros (t & T & E). exists t. split; [lra|exact E]. Qed.

(** The edges that a point is inside of, where it is no end of one *)
Inductive held (x : point) : list (point * point) -> list (point * point) -> Prop :=
| held_none : held x [] []
| held_not e E H : ~ on_segment (fst e) (snd e) x -> held x E H -> held x (e :: E) H
| held_one e E H : inner (fst e) (snd e) x -> held x E H -> held x (e :: E) (e :: H).
Lemma held_exists x E :
  (forall e, In e E -> ~ on_segment (fst e) (snd e) x \/ inner (fst e) (snd e) x) ->
  exists H, held x E H.
Proof.
  induction E as [|e E IH]; intros K; [exists []; apply held_none|].
  destruct IH as (H & HH); [intros; apply K; simpl; auto|].
  destruct (K e (or_introl eq_refl)) as [N|N].
  - exists H. apply held_not; auto.
  - exists (e :: H). apply held_one; auto.
Qed.
Lemma held_in x E H : held x E H -> forall e, In e H -> In e E /\ inner (fst e) (snd e) x.
Proof.
  induction 1; simpl; [tauto| |].
  - intros f I. destruct (IHheld f I). auto.
  - intros f [<-|I]; auto. destruct (IHheld f I). auto.
Qed.
Lemma held_at x l : forall e r H, held x (l ++ e :: r) H -> inner (fst e) (snd e) x ->
  exists before after, H = before ++ e :: after /\ held x r after.
Proof.
  induction l as [|d l IH]; simpl; intros e r H K I.
  - remember (e :: r) as E eqn:EE. destruct K as [|f E H N K|f E H N K]; try discriminate;
      injection EE; intros; subst.
    + destruct N. apply inner_on_segment, I.
    + exists [], H. auto.
  - remember (d :: l ++ e :: r) as E eqn:EE. destruct K as [|f E H N K|f E H N K];
      try discriminate; injection EE; intros; subst.
    + destruct (IH e r H K I) as (b & a & -> & A). exists b, a. auto.
    + destruct (IH e r H K I) as (b & a & -> & A). exists (d :: b), a. auto.
Qed.
Lemma held_two x l e m f k H : held x (l ++ e :: m ++ f :: k) H -> inner (fst e) (snd e) x ->
  inner (fst f) (snd f) x -> (2 <= length H)%nat.
Proof.
  intros K I J. destruct (held_at _ _ _ _ _ K I) as (b & a & -> & A).
  destruct (held_at _ _ _ _ _ A J) as (b' & a' & -> & _).
  rewrite app_length. simpl. rewrite app_length. simpl. lia.
Qed.

(** Near such a point closed edges wind so often, and once more on the left of each edge that the
    point is inside of. *)
Theorem winding_across E H x : Permutation (map fst E) (map snd E) -> held x E H ->
  exists r n, 0 < r /\ forall y, near r x y ->
    (forall e, In e H -> orient (fst e) (snd e) y <> 0) ->
    winding E y = (n + sumz (fun e => is_left_of (fst e) (snd e) y) H)%Z.
Proof.
  intros P K.
  assert (G : exists r C, 0 < r /\ forall y, near r x y ->
    (forall e, In e H -> orient (fst e) (snd e) y <> 0) ->
    winding E y = (C + sumz (fun v => change x v y) (map snd E)
      - sumz (fun v => change x v y) (map fst E)
      + sumz (fun e => is_left_of (fst e) (snd e) y) H)%Z).
  { clear P. induction K as [|[a b] E H N K IH|[a b] E H N K IH]; simpl.
    - exists 1, 0%Z. split; [lra|]. reflexivity.
    - destruct IH as (r & C & Hr & G). destruct (crossing_near a b x N) as (f & D & Hf & F).
      exists (Rmin r f), (C + D)%Z. split; [apply Rmin_glb_lt; auto|].
      intros y Y O. apply near_min in Y. destruct Y as [Y1 Y2]. specialize (G y Y1 O).
      specialize (F y Y2).
      change (winding ((a, b) :: E) y) with (crossing a b y + winding E y)%Z. rewrite F, G. lia.
    - destruct IH as (r & C & Hr & G). destruct (crossing_across a b x N) as (f & D & Hf & F).
      exists (Rmin r f), (C + D)%Z. split; [apply Rmin_glb_lt; auto|].
      intros y Y O. apply near_min in Y. destruct Y as [Y1 Y2].
      specialize (G y Y1 (fun e I => O e (or_intror I))).
      specialize (F y Y2 (O (a, b) (or_introl eq_refl))).
      change (winding ((a, b) :: E) y) with (crossing a b y + winding E y)%Z. rewrite F, G. lia. }
  destruct G as (r & C & Hr & G). exists r, C. split; auto. intros y Y O.
  rewrite (G y Y O), (sumz_perm _ _ _ P). lia.
Qed.

Lemma edge_long a b : a <> b -> let d1 := fst b - fst a in let d2 := snd b - snd a in
  0 < d1 * d1 + d2 * d2.
Proof.
  intros N d1 d2. assert (D : d1 <> 0 \/ d2 <> 0).
  { unfold d1, d2. destruct a as [a1 a2], b as [b1 b2]. simpl in *.
    destruct (Req_dec b1 a1), (Req_dec b2 a2); try (left; lra); try (right; lra).
    exfalso. apply N. f_equal; auto. }
  destruct D; nra.
Qed.

(** Two points on each side of a line, near a point of it *)
Lemma left_close a b w r : a <> b -> orient a b w = 0 -> 0 < r -> exists y, near r w y /\
  0 < orient a b y.
Proof.
  intros N O R. set (d1 := fst b - fst a). set (d2 := snd b - snd a).
  pose proof (edge_long a b N) as P. cbv zeta in P. fold d1 d2 in P.
  set (s := r / (1 + Rabs d1 + Rabs d2)). pose proof (Rabs_pos d1). pose proof (Rabs_pos d2).
  assert (S : 0 < s) by (apply Rdiv_lt_0_compat; lra).
  assert (E : s * (1 + Rabs d1 + Rabs d2) = r) by (unfold s; field; lra).
  exists (fst w - s * d2, snd w + s * d1). split.
  - split; cbn [fst snd].
    + replace (fst w - s * d2 - fst w) with (- (s * d2)) by ring.
      rewrite Rabs_Ropp, Rabs_mult, (Rabs_right s) by lra. nra.
    + replace (snd w + s * d1 - snd w) with (s * d1) by ring.
      rewrite Rabs_mult, (Rabs_right s) by lra. nra.
  - replace (orient a b (fst w - s * d2, snd w + s * d1))
      with (orient a b w + s * (d1 * d1 + d2 * d2))
      by (unfold orient, d1, d2; simpl; ring). rewrite O. nra.
Qed.
Lemma right_close a b w r : a <> b -> orient a b w = 0 -> 0 < r -> exists y, near r w y /\
  orient a b y < 0.
Proof.
  intros N O R. destruct (left_close b a w r) as (y & Y & L); auto.
  - rewrite orient_swap. lra.
  - exists y. split; auto. rewrite orient_swap in L. lra.
Qed.

(** Of the points inside a segment one is not in a finite list. *)
Lemma one_not_in (L : list point) a b : a <> b -> exists x, inner a b x /\ ~ In x L.
Proof.
  intros N.
  assert (G : forall lo hi, lo < hi -> exists lo' hi', lo <= lo' /\ lo' < hi' /\ hi' <= hi /\
    forall t, lo' < t < hi' -> ~ In (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a)) L).
  { induction L as [|p L IH]; intros lo hi H; [exists lo, hi; simpl; intuition lra|].
    destruct (IH lo hi H) as (l & h & H1 & H2 & H3 & K).
    set (m := (l + h) / 2).
    set (q := fun t => (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a))).
    assert (D : (forall t, l < t < m -> q t <> p) \/ (forall t, m < t < h -> q t <> p)).
    { (* the parameter of p, if it is on the line *)
      set (d1 := fst b - fst a). set (d2 := snd b - snd a).
      set (tau := ((fst p - fst a) * d1 + (snd p - snd a) * d2) / (d1 * d1 + d2 * d2)).
      pose proof (edge_long a b N) as P. cbv zeta in P. fold d1 d2 in P.
      assert (U : forall t, q t = p -> t = tau).
      { intros t E. unfold tau. rewrite <- E. unfold q. cbn [fst snd]. fold d1 d2.
        replace ((fst a + t * d1 - fst a) * d1 + (snd a + t * d2 - snd a) * d2)
          with (t * (d1 * d1 + d2 * d2)) by ring. field. lra. }
      destruct (Rle_dec tau m); [right|left]; intros t T E; apply U in E; lra. }
    destruct D as [D|D].
    - exists l, m. unfold m in *. repeat split; try lra. intros t T [E|I].
      + apply (D t T). unfold q. auto.
      + apply (K t); auto. lra.
    - exists m, h. unfold m in *. repeat split; try lra. intros t T [E|I].
      + apply (D t T). unfold q. auto.
      + apply (K t); auto. lra. }
  destruct (G 0 1 Rlt_0_1) as (l & h & H1 & H2 & H3 & K). set (t := (l + h) / 2).
  assert (T : l < t < h) by (unfold t; lra).
  exists (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a)). split; auto.
  exists t. split; [lra|reflexivity].
Qed.
