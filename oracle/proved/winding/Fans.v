(** Rings of vertices as fans of triangles from the first vertex; convex combinations of three
    points; largest values of linear functions. *)
From Coq Require Import Lra Lia Psatz.
From Proved Require Import Definitions Sums Crossings.

Section Fan.
Context {A : Type}.
Fixpoint fan (first prev : A) (l : list A) : list (A * A * A) :=
  match l with [] => [] | x :: r => (first, prev, x) :: fan first x r end.
Definition fan_of (l : list A) : list (A * A * A) :=
  match l with a :: b :: r => fan a b r | _ => [] end.

Lemma fan_sum (f : A * A -> Z) : (forall a b, f (b, a) = (- f (a, b))%Z) ->
  forall r v0 v1, (f (v0, v1) + sumz f (path v0 v1 r))%Z =
    sumz (fun t => let '(a, b, c) := t in (f (a, b) + f (b, c) + f (c, a))%Z) (fan v0 v1 r).
Proof.
  intros H. induction r as [|x r IH]; intros v0 v1; simpl.
  - rewrite (H v0 v1). lia.
  - rewrite <- IH. rewrite (H v0 x). lia.
Qed.
Lemma ring_sum (f : A * A -> Z) : (forall a b, f (b, a) = (- f (a, b))%Z) ->
  forall l, sumz f (ring_edges l) =
    sumz (fun t => let '(a, b, c) := t in (f (a, b) + f (b, c) + f (c, a))%Z) (fan_of l).
Proof.
  intros H [|a [|b r]]; simpl; try reflexivity.
  - specialize (H a a). lia.
  - apply (fan_sum f H).
Qed.
Lemma fan_in r : forall v0 v1 a b c, In (a, b, c) (fan v0 v1 r) ->
  a = v0 /\ (b = v1 \/ In b r) /\ In c r.
Proof.
  induction r as [|x r IH]; intros v0 v1 a b c; simpl; [tauto|]. intros [E|I].
  - injection E; intros; subst; auto.
  - apply IH in I. intuition.
Qed.
Lemma fan_corners l a b c : In (a, b, c) (fan_of l) -> In a l /\ In b l /\ In c l.
Proof.
  destruct l as [|x [|y r]]; simpl; try tauto. intros I. apply fan_in in I. intuition (subst; auto).
Qed.
End Fan.

(** Affine combinations *)
Definition combination (l m n : R) (a b c : point) : point :=
  (l * fst a + m * fst b + n * fst c, l * snd a + m * snd b + n * snd c).

Lemma triangle_combination a b c p : 0 < orient a b c -> closed_triangle a b c p -> exists l m n,
  0 <= l /\ 0 <= m /\ 0 <= n /\ l + m + n = 1 /\ p = combination l m n a b c /\
  (open_triangle a b c p -> 0 < l /\ 0 < m /\ 0 < n).
Proof.
  intros D (H1 & H2 & H3).
  exists (orient b c p / orient a b c), (orient c a p / orient a b c), (orient a b p / orient a b
    c).
  assert (P : forall x, 0 <= x -> 0 <= x / orient a b c).
  { intros x K. apply Rmult_le_pos; [lra|]. apply Rlt_le, Rinv_0_lt_compat, D. }
  assert (P' : forall x, 0 < x -> 0 < x / orient a b c).
  { intros x K. apply Rmult_lt_0_compat; [lra|]. apply Rinv_0_lt_compat, D. }
  repeat split; auto.
  - rewrite <- (orient_sum a b c p) in *. field. lra.
  - destruct p as [px py]. unfold combination. simpl. f_equal.
    + apply Rmult_eq_reg_l with (orient a b c); [|lra]. field_simplify; [|lra]. unfold orient;
      simpl; ring.
    + apply Rmult_eq_reg_l with (orient a b c); [|lra]. field_simplify; [|lra]. unfold orient;
      simpl; ring.
  - destruct H as (K1 & K2 & K3). auto.
  - destruct H as (K1 & K2 & K3). auto.
  - destruct H as (K1 & K2 & K3). auto.
Qed.

Definition dot (n p : point) : R := fst n * fst p + snd n * snd p.
Lemma dot_combination n l m k a b c : dot n (combination l m k a b c) = l * dot n a + m * dot n b +
  k * dot n c.
Proof. unfold dot, combination; simpl; ring. Qed.
Lemma triangle_le n M a b c p : 0 < orient a b c -> closed_triangle a b c p ->
  dot n a <= M -> dot n b <= M -> dot n c <= M -> dot n p <= M.
Proof.
  intros D T Ha Hb Hc. destruct (triangle_combination a b c p D T) as (l & m & k & L & Mm & K & S &
    -> & _).
  rewrite dot_combination. nra.
Qed.
Lemma triangle_lt n M a b c p : 0 < orient a b c -> open_triangle a b c p -> ~ (fst n = 0 /\
  snd n = 0) ->
  dot n a <= M -> dot n b <= M -> dot n c <= M -> dot n p < M.
Proof.
  intros D T N Ha Hb Hc.
  assert (T' : closed_triangle a b c p) by (destruct T as (?&?&?); unfold closed_triangle;
    repeat split; lra).
  destruct (triangle_combination a b c p D T') as (l & m & k & L & Mm & K & S & E & I).
  destruct (I T) as (L' & M' & K'). rewrite E, dot_combination.
  assert (Q : dot n a < M \/ dot n b < M \/ dot n c < M).
  { destruct (Rlt_dec (dot n a) M), (Rlt_dec (dot n b) M), (Rlt_dec (dot n c) M); auto.
    exfalso. apply N.
    assert (E1 : fst n * (fst b - fst a) + snd n * (snd b - snd a) = 0) by (unfold dot in *; lra).
    assert (E2 : fst n * (fst c - fst a) + snd n * (snd c - snd a) = 0) by (unfold dot in *; lra).
    assert (F1 : fst n * orient a b c = 0).
    { unfold orient.
      replace (_ * _) with ((fst n * (fst b - fst a) + snd n * (snd b - snd a)) * (snd c - snd a)
        - (fst n * (fst c - fst a) + snd n * (snd c - snd a)) * (snd b - snd a)) by ring.
      rewrite E1, E2. ring. }
    assert (F2 : snd n * orient a b c = 0).
    { unfold orient.
      replace (_ * _) with ((fst n * (fst c - fst a) + snd n * (snd c - snd a)) * (fst b - fst a)
        - (fst n * (fst b - fst a) + snd n * (snd b - snd a)) * (fst c - fst a)) by ring.
      rewrite E1, E2. ring. }
    apply Rmult_integral in F1. apply Rmult_integral in F2. lra. }
  nra.
Qed.

(** A point on the left of all ring_edges is in a triangle of the fan. *)
Lemma left_in_fan r : forall v0 v1 p, r <> [] ->
  0 <= orient v0 v1 p -> (forall a b, In (a, b) (path v0 v1 r) -> 0 <= orient a b p) ->
  exists a b c, In (a, b, c) (fan v0 v1 r) /\ closed_triangle a b c p.
Proof.
  induction r as [|x r IH]; intros v0 v1 p N H0 H; [congruence|].
  simpl in *. destruct (Rle_dec (orient v0 x p) 0) as [K|K].
  - exists v0, v1, x. split; [auto|]. unfold closed_triangle. rewrite (orient_swap v0 x).
    repeat split; [lra| |lra]. apply H; auto.
  - destruct r as [|z r].
    + exfalso. apply K. specialize (H x v0). simpl in H. rewrite (orient_swap v0 x) in H.
      assert (0 <= - orient v0 x p) by auto. lra.
    + destruct (IH v0 x p) as (a & b & c & I & T); [discriminate|lra|intros; apply H; auto|].
      exists a, b, c; auto.
Qed.

