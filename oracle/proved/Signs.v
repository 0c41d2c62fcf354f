(** Claim `sign`: signs of predicates between two scales, by the coefficients of forms in t and u,
    with the scale at (from t + to u) / (t + u). Forms are written as polynomials in u / t. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Sums Crossings Fans Curves Unions Checker
  Rational.

(** ** The checker *)
Open Scope Q_scope.
Fixpoint plus (l k : list Q) : list Q :=
  match l, k with
  | [], _ => k
  | _, [] => l
  | a :: l', b :: k' => Qred (a + b) :: plus l' k'
  end.
Definition times_number (a : Q) (l : list Q) : list Q := map (fun b => Qred (a * b)) l.
Fixpoint times (l k : list Q) : list Q :=
  match l with [] => [] | a :: l' => plus (times_number a k) (0 :: times l' k) end.
Definition less_form (l k : list Q) : list Q := plus l (times_number (-1) k).

(** A point's x, y and 1 *)
Definition triple := (list Q * list Q * list Q)%type.
Definition moving (from to : Q) (P Q : rings) (ij : index) : triple :=
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
Definition coefficients (from to : Q) (P Q : rings) (p : predicate) :=
  let at_ := moving from to P Q in
  match p with
  | Orientation a b c => product (at_ a) (across (at_ b) (at_ c))
  | Concurrent a b c d e f =>
      product (across (at_ a) (at_ b))
        (across (across (at_ c) (at_ d)) (across (at_ e) (at_ f)))
  end.
Definition are_of_sign (l : list Q) : bool :=
  forallb (Qle_bool 0) l && existsb (less 0) l.
Definition check_sign (from to : Q) (P Q : rings) (p : predicate) (z : Z) : bool :=
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
Definition form (l : list Q) (x : R) : R := polynomial (map Q2R l) x.
Lemma form_plus l : forall k x, form (plus l k) x = form l x + form k x.
Proof.
  induction l as [|a l IH]; intros [|b k] x; unfold form in *; simpl; try ring.
  rewrite IH, Q2R_red, Q2R_plus. ring.
Qed.
Lemma form_times_number a l x : form (times_number a l) x = Q2R a * form l x.
Proof.
  unfold form, times_number. induction l as [|b l IH]; simpl; [ring|].
  rewrite IH, Q2R_red, Q2R_mult. ring.
Qed.
Lemma form_times l k x : form (times l k) x = form l x * form k x.
Proof.
  induction l as [|a l IH]; [unfold form; simpl; ring|].
  cbn [times]. rewrite form_plus, form_times_number.
  change (form (0%Q :: times l k) x) with (Q2R 0 + x * form (times l k) x).
  change (form (a :: l) x) with (Q2R a + x * form l x). rewrite IH, Q2R_zero. ring.
Qed.
Lemma form_less l k x : form (less_form l k) x = form l x - form k x.
Proof.
  unfold less_form. rewrite form_plus, form_times_number.
  replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; lra). ring.
Qed.

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
  intros S. unfold forms, moving, form, times_triple, place, add, scale, real; cbn [map polynomial].
  cbn [fst snd]. rewrite !Q2R_red, !Q2R_plus, !Q2R_mult, Q2R_one.
  set (p := vertex_of P (fst ij)). set (q := vertex_of Q (snd ij)).
  f_equal; [f_equal|]; [| |ring].
  - replace ((1 + x) * (s * Q2R (fst p) + Q2R (fst q)))
      with ((1 + x) * s * Q2R (fst p) + (1 + x) * Q2R (fst q)) by ring. rewrite S. ring.
  - replace ((1 + x) * (s * Q2R (snd p) + Q2R (snd q)))
      with ((1 + x) * s * Q2R (snd p) + (1 + x) * Q2R (snd q)) by ring. rewrite S. ring.
Qed.
Lemma form_value from to P Q p x s : (1 + x) * s = Q2R from + Q2R to * x ->
  exists n, form (coefficients from to P Q p) x = (1 + x) ^ n * value s P Q p.
Proof.
  intros S. destruct p as [a b c|a b c d e f]; [exists 3%nat|exists 6%nat];
    unfold coefficients; rewrite form_product, !forms_across, !(forms_moving _ _ _ _ _ x s S);
    unfold value, times_triple, across_real, product_real, orient, determinant, line; ring.
Qed.

Lemma sign_positive l x : are_of_sign l = true -> 0 < x -> 0 < form l x.
Proof.
  unfold are_of_sign. intros H X. apply andb_prop in H. destruct H as [H1 H2].
  rewrite forallb_forall in H1.
  assert (G : (forall a, In a l -> 0 <= Q2R a) -> 0 <= form l x).
  { clear - X. induction l as [|a l IH]; unfold form in *; simpl; intros H; [lra|].
    assert (0 <= Q2R a) by auto. assert (0 <= polynomial (map Q2R l) x) by auto. nra. }
  assert (N : forall a, In a l -> 0 <= Q2R a).
  { intros a I. specialize (H1 a I). apply le_real in H1. rewrite Q2R_zero in H1. exact H1. }
  clear H1 G. induction l as [|a l IH]; [discriminate|].
  simpl in H2. apply orb_prop in H2. change (form (a :: l) x) with (Q2R a + x * form l x).
  assert (A : 0 <= Q2R a) by (apply N; simpl; auto).
  assert (P : forall k, (forall b, In b k -> 0 <= Q2R b) -> 0 <= form k x).
  { clear - X. induction k as [|b k IH]; unfold form in *; simpl; intros H; [lra|].
    assert (0 <= Q2R b) by auto. assert (0 <= polynomial (map Q2R k) x) by auto. nra. }
  destruct H2 as [H2|H2].
  - apply less_real in H2. rewrite Q2R_zero in H2.
    assert (0 <= form l x) by (apply P; intros; apply N; simpl; auto). nra.
  - assert (0 < form l x) by (apply IH; auto; intros; apply N; simpl; auto). nra.
Qed.
Lemma sign_zero l x : forallb (Qeq_bool 0) l = true -> form l x = 0.
Proof.
  induction l as [|a l IH]; intros H; [reflexivity|]. simpl in H. apply andb_prop in H.
  destruct H as [H1 H2]. change (form (a :: l) x) with (Q2R a + x * form l x).
  apply eq_real in H1. rewrite <- H1, IH, Q2R_zero by auto. ring.
Qed.

Theorem sign_is_right : forall (from to : Q) (P Q : rings) (p : predicate) (z : Z),
  check_sign from to P Q p z = true -> is_sign from to P Q p z.
Proof.
  intros from to P Q p z H s S. unfold check_sign in H. apply andb_prop in H.
  destruct H as [_ H].
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
