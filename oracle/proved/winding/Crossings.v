(** Crossing numbers of edges: they change sign with the direction, on one line they are
    differences of a function of the ends, and around a triangle they add up to 1 inside and to 0
    outside. *)
From Coq Require Import Lra Lia Psatz.
From Proved Require Import Definitions.


Lemma orient_swap a b y : orient b a y = - orient a b y.
Proof. unfold orient; ring. Qed.

Lemma crossing_reversed a b y : crossing b a y = (- crossing a b y)%Z.
Proof.
  unfold crossing. rewrite (orient_swap a b y).
  destruct (Rle_dec (fst a) (fst y)), (Rle_dec (fst b) (fst y)),
    (Rlt_dec (fst y) (fst b)), (Rlt_dec (fst y) (fst a)); try lra; auto;
  destruct (Rlt_dec (orient a b y) 0), (Rlt_dec 0 (orient a b y)),
    (Rlt_dec (- orient a b y) 0), (Rlt_dec 0 (- orient a b y)); try lra; auto.
Qed.

Lemma crossing_vertical a b y : fst a = fst b -> crossing a b y = 0%Z.
Proof.
  intros E. unfold crossing. rewrite E.
  destruct (Rle_dec (fst b) (fst y)), (Rlt_dec (fst y) (fst b)); auto; lra.
Qed.

(** On the line y = m x + c an edge is the difference of a function of its ends. *)
Definition step (m c x : R) (y : point) : Z :=
  if Rlt_dec (snd y) (m * fst y + c) then if Rle_dec x (fst y) then 1%Z else 0%Z else 0%Z.

Lemma crossing_on_line a b y m c :
  fst a <> fst b -> m = (snd b - snd a) / (fst b - fst a) -> c = snd a - m * fst a ->
  crossing a b y = (step m c (fst a) y * -1 + step m c (fst b) y * 1)%Z.
Proof.
  intros N Hm Hc.
  assert (O : orient a b y = (fst b - fst a) * (snd y - (m * fst y + c))).
  { unfold orient. subst c m. field. lra. }
  unfold crossing, step. rewrite O.
  destruct (Rle_dec (fst a) (fst y)), (Rle_dec (fst b) (fst y)),
    (Rlt_dec (fst y) (fst b)); try lra; auto;
  destruct (Rlt_dec (snd y) (m * fst y + c)); try lra; auto;
  destruct (Rlt_dec ((fst b - fst a) * (snd y - (m * fst y + c))) 0),
    (Rlt_dec 0 ((fst b - fst a) * (snd y - (m * fst y + c)))); auto; exfalso; nra.
Qed.


(** Triangles that turn left *)
Definition closed_triangle (a b c p : point) : Prop := 0 <= orient a b p /\ 0 <= orient b c p /\
  0 <= orient c a p.
Definition open_triangle (a b c p : point) : Prop := 0 < orient a b p /\ 0 < orient b c p /\
  0 < orient c a p.
Definition crossing3 (a b c y : point) : Z := (crossing a b y + crossing b c y + crossing c a y)%Z.

Lemma orient_sum a b c y : orient a b y + orient b c y + orient c a y = orient a b c.
Proof. unfold orient; ring. Qed.
Lemma orient_balance a b c y :
  (fst a - fst y) * orient b c y + (fst b - fst y) * orient c a y + (fst c - fst y) * orient a b y
    = 0.
Proof. unfold orient; ring. Qed.

Ltac split_decisions := repeat match goal with
  | |- context [Rle_dec ?x ?y] => destruct (Rle_dec x y)
  | |- context [Rlt_dec ?x ?y] => destruct (Rlt_dec x y)
  end; repeat match goal with
  | H : ~ (_ <= _) |- _ => apply Rnot_le_lt in H
  | H : ~ (_ < _) |- _ => apply Rnot_lt_le in H
  end.

(** u, v, w: the three orientations; al, be, ga: abscissas of the corners, seen from the point. *)
Lemma triangle_crossing_cases (al be ga u v w : R) :
  al * u + be * v + ga * w = 0 -> 0 < u + v + w -> ~ (al = be /\ be = ga) ->
  let f (p q o : R) : Z :=
    if Rle_dec p 0 then if Rlt_dec 0 q then if Rlt_dec o 0 then (-1)%Z else 0%Z else 0%Z
    else if Rle_dec q 0 then if Rlt_dec 0 o then 1%Z else 0%Z else 0%Z in
  let n := (f al be w + f be ga u + f ga al v)%Z in
  (n = 0%Z \/ n = 1%Z) /\ (n = 1%Z -> 0 <= w /\ 0 <= u /\ 0 <= v)
  /\ (0 < w /\ 0 < u /\ 0 < v -> n = 1%Z).
Proof.
  intros X D N f n. unfold n, f. clear n f.
  destruct (Rle_dec al 0), (Rle_dec be 0), (Rle_dec ga 0);
    split_decisions; try lra; simpl;
  (split; [ first [left; reflexivity | right; reflexivity | exfalso; nra]
          | split; [ intros K; first [discriminate K | clear K; repeat apply conj; nra | exfalso;
            nra]
                   | intros (K1 & K2 & K3); first [reflexivity | exfalso; nra | exfalso; apply N;
                     split; nra] ] ]).
Qed.

Lemma crossing_from_point a b y : crossing a b y =
  (if Rle_dec (fst a - fst y) 0 then if Rlt_dec 0 (fst b - fst y) then
     if Rlt_dec (orient a b y) 0 then (-1)%Z else 0%Z else 0%Z
   else if Rle_dec (fst b - fst y) 0 then if Rlt_dec 0 (orient a b y) then 1%Z else 0%Z else 0%Z).
Proof. unfold crossing. split_decisions; auto; exfalso; lra. Qed.

Lemma triangle_crossing a b c y : 0 < orient a b c ->
  (crossing3 a b c y = 0%Z \/ crossing3 a b c y = 1%Z) /\
  (crossing3 a b c y = 1%Z -> closed_triangle a b c y) /\ (open_triangle a b c y ->
    crossing3 a b c y = 1%Z).
Proof.
  intros D. rewrite <- (orient_sum a b c y) in D.
  pose proof (orient_balance a b c y) as X.
  unfold crossing3, closed_triangle, open_triangle. rewrite !crossing_from_point.
  refine (triangle_crossing_cases _ _ _ (orient b c y) (orient c a y) (orient a b y) X _ _); [lra|].
  intros [E1 E2]. rewrite orient_sum in D. assert (fst b = fst a) by lra.
    assert (fst c = fst a) by lra.
  unfold orient in D. rewrite H, H0 in D. lra.
Qed.
