(** Unions of triangles are told apart by crossing numbers: the two theorems that all else rests
    on. *)
From Coq Require Import Lra Lia Psatz.
From Proved Require Import Definitions Sums Crossings Fans Curves.

Definition triangle := (point * point * point)%type.
Definition union_of (T : list triangle) (p : point) : Prop := exists a b c, In (a, b, c) T /\
  closed_triangle a b c p.
Definition positive (T : list triangle) : Prop := forall a b c, In (a, b, c) T -> 0 < orient a b c.
Definition crossing_of (y : point) (t : triangle) : Z := let '(a, b, c) := t in crossing3 a b c y.
Definition edge_crossing (y : point) (e : point * point) : Z := crossing (fst e) (snd e) y.

Lemma triangle_counts T y t : positive T -> In t T -> (0 <= crossing_of y t)%Z.
Proof. intros O I. destruct t as [[a b] c]. simpl.
  destruct (triangle_crossing a b c y (O _ _ _ I)) as [[K|K] _]; lia. Qed.
Lemma union_counted T y a b c : positive T -> In (a, b, c) T -> open_triangle a b c y ->
  (1 <= sumz (crossing_of y) T)%Z.
Proof.
  intros O I K. apply (sumz_ge1 (crossing_of y) T (a, b, c)); auto.
  - intros t J. eapply triangle_counts; eauto.
  - simpl. destruct (triangle_crossing a b c y (O _ _ _ I)) as (_ & _ & H). rewrite (H K). lia.
Qed.
Lemma counted_union T y : positive T -> (1 <= sumz (crossing_of y) T)%Z -> union_of T y.
Proof.
  intros O H. apply sumz_pos in H. destruct H as ([[a b] c] & I & K). exists a, b, c. split; auto.
  simpl in K. destruct (triangle_crossing a b c y (O _ _ _ I)) as ([Z|Z] & H & _); [lia|auto].
Qed.

Lemma union_decided T y : union_of T y \/ forall a b c, In (a, b, c) T -> ~ closed_triangle a b c y.
Proof.
  induction T as [|[[a b] c] T IH].
  - right. simpl; tauto.
  - assert (D : closed_triangle a b c y \/ ~ closed_triangle a b c y).
    { unfold closed_triangle. destruct (Rle_dec 0 (orient a b y)), (Rle_dec 0 (orient b c y)),
      (Rle_dec 0 (orient c a y)); tauto. }
    destruct D as [D|D]; [left; exists a, b, c; simpl; auto|].
    destruct IH as [(a' & b' & c' & I & K)|IH]; [left; exists a', b', c'; simpl; auto|].
    right. simpl. intros a' b' c' [E|I]; [injection E; intros; subst; auto|auto].
Qed.
Lemma near_outside_all T x : positive T -> (forall a b c, In (a, b, c) T ->
  ~ closed_triangle a b c x) ->
  exists e, 0 < e /\ forall y, near e x y -> ~ union_of T y.
Proof.
  intros O N. induction T as [|[[a b] c] T IH].
  - exists 1. split; [lra|]. intros y _ (a & b & c & [] & _).
  - destruct (near_outside a b c x) as (e & He & K); [apply O; simpl; auto|apply N; simpl; auto|].
    destruct IH as (f & Hf & L); [intros ? ? ? I; apply O; simpl; auto|intros ? ? ? I; apply N;
      simpl; auto|].
    exists (Rmin e f). split; [apply Rmin_glb_lt; auto|].
    intros y [Y1 Y2] (a' & b' & c' & [E|I] & Y).
    + injection E; intros; subst. apply (K y); auto.
      split; eapply Rlt_le_trans; eauto using Rmin_l.
    + apply (L y); [split; eapply Rlt_le_trans; eauto using Rmin_r|]. exists a', b', c'; auto.
Qed.
Lemma curve_outside_all T x d : positive T -> (forall a b c, In (a, b, c) T ->
  ~ closed_triangle a b c x) ->
  soon (fun t => ~ union_of T (curve x d t)).
Proof.
  intros O N. destruct (near_outside_all T x O N) as (e & He & K).
  eapply soon_imp; [|apply (curve_near e x d He)]. simpl. intros t. apply K.
Qed.

(** Tilings: if the crossing numbers add up, the unions are the same. *)
Theorem same_count_same_union S T : positive S -> positive T ->
  (forall y, sumz (crossing_of y) S = sumz (crossing_of y) T) ->
  forall y, union_of S y -> union_of T y.
Proof.
  intros OS OT H y (a & b & c & I & K).
  destruct (union_decided T y) as [L|L]; auto. exfalso.
  destruct (soon_exists _ (soon_and _ _ (curve_inside a b c y (OS _ _ _ I) K)
    (curve_outside_all T y (minus (middle a b c) y) OT L))) as (t & _ & K1 & K2).
  apply K2, counted_union; auto. rewrite <- H. eapply union_counted; eauto.
Qed.

Theorem region_is_union E T : positive T -> (forall a b, In (a, b) E -> a <> b) ->
  (forall y, winding E y = sumz (crossing_of y) T) -> forall x, region E x <-> union_of T x.
Proof.
  intros O N H x. split.
  - intros R. destruct (union_decided T x) as [L|L]; auto. exfalso.
    destruct (near_outside_all T x O L) as (e & He & K). destruct (R e He) as (y & Y & _ & W).
    apply (K y Y), counted_union; auto. rewrite <- H. lia.
  - intros (a & b & c & I & K) e He. set (d := minus (middle a b c) x).
    assert (F : soon (fun t => forall s, In s E -> orient (fst s) (snd s) (curve x d t) <> 0)).
    { apply soon_all. intros [u v] J. apply curve_off, N, J. }
    destruct (soon_exists _ (soon_and _ _ F (soon_and _ _ (curve_near e x d He) (curve_inside a b c
      x (O _ _ _ I) K))))
      as (t & _ & K1 & K2 & K3).
    exists (curve x d t). split; [auto|split].
    + intros u v J (s & _ & S). apply (K1 (u, v) J). simpl. rewrite S. unfold orient; simpl. ring.
    + rewrite H. apply Z.lt_le_trans with 1%Z; [lia|]. exact (union_counted T _ a b c O I K3).
Qed.
