(** Claim `sign`: signs of predicates between two scales, by the coefficients of forms in t and u,
    with the scale at (from t + to u) / (t + u). Forms are written as polynomials in u / t. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Curves Numbers Rational Values.

(** ** The checker *)
Open Scope Q_scope.
(** A point's x, y and 1 *)
Definition triple := (list Q * list Q * list Q)%type.
Definition moving (from to : Q) (P Q : rings vertex) (ij : index) : triple :=
  let p := vertex_of P (fst ij) in
  let q := vertex_of Q (snd ij) in
  ([Qred (from * fst p + fst q); Qred (to * fst p + fst q)],
   [Qred (from * snd p + snd q); Qred (to * snd p + snd q)], [1; 1]).
Definition across (u v : triple) : triple :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in
  (less_form (times u2 v3) (times u3 v2), less_form (times u3 v1) (times u1 v3),
   less_form (times u1 v2) (times u2 v1)).
Definition product (u v : triple) : list Q :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in
  plus (times u1 v1) (plus (times u2 v2) (times u3 v3)).
Definition coefficients (from to : Q) (P Q : rings vertex) (p : predicate) :=
  let at_ := moving from to P Q in
  match p with
  | Orientation a b c => product (at_ a) (across (at_ b) (at_ c))
  | Concurrent a b c d e f =>
      product (across (at_ a) (at_ b))
        (across (across (at_ c) (at_ d)) (across (at_ e) (at_ f)))
  end.
Definition check_sign (from to : Q) (P Q : rings vertex) (p : predicate) (z : Z) : bool :=
  Qle_bool from to &&
  (let l := coefficients from to P Q p in
   match z with
   | 0%Z => forallb (Qeq_bool 0) l
   | 1%Z => are_of_sign l
   | (-1)%Z => are_of_sign (times_number (-1) l)
   | _ => false
   end).

(** ** It is right. *)
Open Scope R_scope.
(** What forms stand for *)
Definition forms (u : triple) (x : R) : R * R * R :=
  let '(u1, u2, u3) := u in (form u1 x, form u2 x, form u3 x).
Definition across_real (u v : R * R * R) : R * R * R :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in
  (u2 * v3 - u3 * v2, u3 * v1 - u1 * v3, u1 * v2 - u2 * v1).
Definition product_real (u v : R * R * R) : R :=
  let '(u1, u2, u3) := u in let '(v1, v2, v3) := v in u1 * v1 + (u2 * v2 + u3 * v3).
Lemma forms_across u v x : forms (across u v) x = across_real (forms u x) (forms v x).
Proof.
  destruct u as [[u1 u2] u3], v as [[v1 v2] v3]. unfold across, across_real, forms.
  rewrite !form_less, !form_times. reflexivity.
Qed.
Lemma form_product u v x : form (product u v) x = product_real (forms u x) (forms v x).
Proof.
  destruct u as [[u1 u2] u3], v as [[v1 v2] v3]. unfold product, product_real, forms.
  rewrite !form_plus, !form_times. reflexivity.
Qed.
Definition times_triple (w : R) (p : point) : R * R * R := (w * fst p, w * snd p, w).
Lemma forms_moving from to P Q ij x s : (1 + x) * s = Q2R from + Q2R to * x ->
  forms (moving from to P Q ij) x = times_triple (1 + x) (place s P Q ij).
Proof.
  intros S. unfold forms, moving, form, times_triple, place, add, scale, point_of;
    cbn [map polynomial].
  cbn [fst snd]. rewrite !Q2R_red, !Q2R_plus, !Q2R_mult, Q2R_one.
  set (p := vertex_of P (fst ij)). set (q := vertex_of Q (snd ij)).
  f_equal; [f_equal|]; [| |ring].
  - replace ((1 + x) * (s * Q2R (fst p) + Q2R (fst q)))
      with ((1 + x) * s * Q2R (fst p) + (1 + x) * Q2R (fst q)) by ring. rewrite S. ring.
  - replace ((1 + x) * (s * Q2R (snd p) + Q2R (snd q)))
      with ((1 + x) * s * Q2R (snd p) + (1 + x) * Q2R (snd q)) by ring. rewrite S. ring.
Qed.
Lemma form_value from to P Q p x s : (1 + x) * s = Q2R from + Q2R to * x ->
  exists n, form (coefficients from to P Q p) x = (1 + x) ^ n * value_of s P Q p.
Proof.
  intros S. destruct p as [a b c|a b c d e f]; [exists 3%nat|exists 6%nat];
    unfold coefficients; rewrite form_product, !forms_across, !(forms_moving _ _ _ _ _ x s S);
    unfold value_of, times_triple, across_real, product_real, orient, determinant, line; ring.
Qed.

Theorem sign_is_right : forall (from to : Q) (P Q : rings vertex) (p : predicate) (z : Z),
  check_sign from to P Q p z = true -> is_sign from to P Q p z.
Proof.
  intros from to P Q p z H. unfold check_sign in H. apply andb_prop in H.
  destruct H as [L H]. split; [apply le_real, L|]. intros s S.
  assert (X : exists x, 0 < x /\ (1 + x) * s = Q2R from + Q2R to * x).
  { destruct S as [S|[S1 S2]].
    - exists ((s - Q2R from) / (Q2R to - s)).
      split; [apply Rdiv_lt_0_compat; lra|field; lra].
    - exists 1. split; [lra|]. lra. }
  destruct X as (x & X & E). destruct (form_value from to P Q p x s E) as (n & F).
  assert (N : 0 < (1 + x) ^ n) by (apply pow_lt; lra).
  set (l := coefficients from to P Q p) in *. unfold has_sign.
  destruct z as [|[z|z|]|[z|z|]]; try discriminate.
  - right. right. split; auto. rewrite (sign_zero l x H) in F.
    symmetry in F. apply Rmult_integral in F. destruct F; auto. lra.
  - left. split; auto. pose proof (sign_positive l x H X) as G. rewrite F in G. nra.
  - right. left. split; auto. pose proof (sign_positive _ x H X) as G.
    rewrite form_times_number, F in G.
    replace (Q2R (-1)) with (-1) in G by (unfold Q2R; simpl; lra). nra.
Qed.
