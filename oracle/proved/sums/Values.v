(** What the numbers of the checker are between two scales, at u / t = moment. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Numbers Rational Curves.
Open Scope R_scope.

#[global] Arguments nplus : simpl never.
#[global] Arguments nminus : simpl never.
#[global] Arguments ntimes : simpl never.
#[global] Arguments reduced : simpl never.
#[global] Arguments lt : simpl never.
#[global] Arguments le : simpl never.
#[global] Arguments equal : simpl never.
#[global] Arguments differ : simpl never.
#[global] Arguments greater_of : simpl never.
#[global] Arguments over : simpl never.

(** ** Forms *)
Definition form (l : list Q) (x : R) : R := polynomial (map Q2R l) x.
Lemma form_plus l : forall k x, form (plus l k) x = form l x + form k x.
Proof.
  induction l as [|a l IH]; intros [|b k] x; unfold form in *; simpl; try ring.
  rewrite IH, Q2R_plus. ring.
Qed.
Lemma form_times_number a l x : form (times_number a l) x = Q2R a * form l x.
Proof.
  unfold form, times_number. induction l as [|b l IH]; simpl; [ring|].
  rewrite IH, Q2R_mult. ring.
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
Lemma form_raise l x : form (raise l) x = (1 + x) * form l x.
Proof.
  unfold raise. rewrite form_plus.
  change (form (0%Q :: l) x) with (Q2R 0 + x * form l x). rewrite Q2R_zero. ring.
Qed.
Lemma form_not_negative l x : 0 <= x -> (forall a, In a l -> 0 <= Q2R a) -> 0 <= form l x.
Proof.
  intros X. induction l as [|a l IH]; unfold form in *; simpl; intros H; [lra|].
  assert (0 <= Q2R a) by auto. assert (0 <= polynomial (map Q2R l) x) by auto. nra.
Qed.
Lemma all_not_negative l : forallb (Qle_bool 0) l = true -> forall a, In a l -> 0 <= Q2R a.
Proof.
  rewrite forallb_forall. intros H a I. specialize (H a I). apply le_real in H.
  rewrite Q2R_zero in H. exact H.
Qed.
Lemma sign_positive l x : are_of_sign l = true -> 0 < x -> 0 < form l x.
Proof.
  unfold are_of_sign. intros H X. apply andb_prop in H. destruct H as [H1 H2].
  pose proof (all_not_negative l H1) as N. clear H1.
  induction l as [|a l IH]; [discriminate|].
  simpl in H2. apply orb_prop in H2. change (form (a :: l) x) with (Q2R a + x * form l x).
  assert (A : 0 <= Q2R a) by (apply N; simpl; auto). destruct H2 as [H2|H2].
  - apply less_real in H2. rewrite Q2R_zero in H2.
    assert (0 <= form l x) by (apply form_not_negative; [lra|intros; apply N; simpl; auto]). nra.
  - assert (0 < form l x) by (apply IH; auto; intros; apply N; simpl; auto). nra.
Qed.
Lemma sign_zero l x : forallb (Qeq_bool 0) l = true -> form l x = 0.
Proof.
  induction l as [|a l IH]; intros H; [reflexivity|]. simpl in H. apply andb_prop in H.
  destruct H as [H1 H2]. change (form (a :: l) x) with (Q2R a + x * form l x).
  apply eq_real in H1. rewrite <- H1, IH, Q2R_zero by auto. ring.
Qed.

(** ** Lengths: a form of n coefficients is divided by (t + u)^(n - 1). *)
Lemma plus_length l : forall k, length (plus l k) = max (length l) (length k).
Proof.
  induction l as [|a l IH]; intros [|b k]; simpl; auto.
Qed.
Lemma times_number_length a l : length (times_number a l) = length l.
Proof. apply map_length. Qed.
Lemma times_length l k : l <> [] -> k <> [] ->
  pred (length (times l k)) = (pred (length l) + pred (length k))%nat.
Proof.
  intros L K. destruct l as [|a l]; [contradiction|]. clear L. revert a.
  induction l as [|b l IH]; intros a; cbn [times]; rewrite plus_length, times_number_length;
    cbn [length].
  - destruct k as [|c k]; [contradiction|]. simpl. lia.
  - specialize (IH b). cbn [times] in IH. set (m := length (plus _ _)) in *.
    destruct k as [|c k]; [contradiction|]. cbn [length] in *.
    assert (0 < m)%nat.
    { unfold m. rewrite plus_length, times_number_length. cbn [length]. lia. }
    lia.
Qed.
Lemma raise_length l : length (raise l) = S (length l).
Proof. unfold raise. rewrite plus_length. cbn [length]. lia. Qed.

(** ** Values *)
Class scale_here := { moment : R; moment_positive : 0 < moment }.

Section Here.
Context {now : scale_here}.

Definition power (n : nat) : R := (1 + moment) ^ n.
Lemma power_positive n : 0 < power n.
Proof. apply pow_lt. pose proof moment_positive. lra. Qed.
Definition worth (l : list Q) : R := form l moment / power (pred (length l)).
Definition value (a : number) : R := match a with Fixed q => Q2R q | Moving l => worth l end.

Lemma worth_one q : worth [q] = Q2R q.
Proof. unfold worth, form, power; simpl. unfold Rdiv. rewrite Rinv_1. ring. Qed.
Lemma value_worth a : value a = worth (coefficients_of a).
Proof. destruct a; simpl; [rewrite worth_one|]; reflexivity. Qed.
Lemma worth_raise l : worth (raise l) = worth l.
Proof.
  destruct l as [|a l].
  - unfold worth, form, power; simpl. rewrite Q2R_zero. unfold Rdiv. rewrite Rinv_1. ring.
  - unfold worth. rewrite form_raise, raise_length. cbn [length pred].
    change (power (S (length l))) with ((1 + moment) * power (length l)).
    pose proof (power_positive (length l)). pose proof moment_positive. field. lra.
Qed.
Lemma worth_raised n : forall l, worth (raised n l) = worth l.
Proof. induction n; intros l; simpl; [reflexivity|]. rewrite IHn. apply worth_raise. Qed.
Lemma raised_length n : forall l, length (raised n l) = (n + length l)%nat.
Proof. induction n; intros l; simpl; [reflexivity|]. rewrite IHn, raise_length. lia. Qed.
Lemma level_worth f (g : R -> R -> R) :
  (forall l k, length l = length k -> worth (f l k) = g (worth l) (worth k)) ->
  forall l k, worth (leveled f l k) = g (worth l) (worth k).
Proof.
  intros H l k. unfold leveled. rewrite H; [rewrite !worth_raised; reflexivity|].
  rewrite !raised_length. lia.
Qed.
Lemma worth_plus l k : length l = length k -> worth (plus l k) = worth l + worth k.
Proof.
  intros E. unfold worth. rewrite form_plus, plus_length, E, Nat.max_id.
  pose proof (power_positive (pred (length k))). field. lra.
Qed.
Lemma worth_less l k : length l = length k -> worth (less_form l k) = worth l - worth k.
Proof.
  intros E. unfold worth. rewrite form_less. unfold less_form.
  rewrite plus_length, times_number_length, E, Nat.max_id.
  pose proof (power_positive (pred (length k))). field. lra.
Qed.
Lemma worth_times_number a l : worth (times_number a l) = Q2R a * worth l.
Proof.
  unfold worth. rewrite form_times_number, times_number_length.
  pose proof (power_positive (pred (length l))). field. lra.
Qed.
Lemma worth_none : worth [] = 0.
Proof. unfold worth, form, power; simpl. unfold Rdiv. ring. Qed.
Lemma worth_times l k : worth (times l k) = worth l * worth k.
Proof.
  destruct l as [|a l]; [simpl; rewrite worth_none; ring|].
  destruct k as [|b k].
  - rewrite worth_none, Rmult_0_r. unfold worth. rewrite form_times.
    unfold form at 2; simpl. pose proof (power_positive (pred (length (times (a :: l) [])))).
    field. apply Rgt_not_eq, power_positive.
  - unfold worth. rewrite form_times, times_length by discriminate. unfold power.
    rewrite pow_add. pose proof (power_positive (pred (length (a :: l)))).
    pose proof (power_positive (pred (length (b :: k)))). unfold power in *. field. lra.
Qed.

Lemma value_plus a b : value (nplus a b) = value a + value b.
Proof.
  unfold nplus, moved. rewrite (value_worth a), (value_worth b).
  destruct a, b; try apply (level_worth plus Rplus worth_plus).
  cbn [value coefficients_of]. rewrite !worth_one, Q2R_plus. reflexivity.
Qed.
Lemma value_minus a b : value (nminus a b) = value a - value b.
Proof.
  unfold nminus, moved. rewrite (value_worth a), (value_worth b).
  destruct a, b; try apply (level_worth less_form Rminus worth_less).
  cbn [value coefficients_of]. rewrite !worth_one, Q2R_minus. reflexivity.
Qed.
Lemma value_times a b : value (ntimes a b) = value a * value b.
Proof.
  unfold ntimes. destruct a, b; cbn [value].
  - apply Q2R_mult.
  - apply worth_times_number.
  - rewrite worth_times_number. ring.
  - apply worth_times.
Qed.
Lemma value_reduced a : value (reduced a) = value a.
Proof.
  destruct a as [q|l]; unfold reduced; cbn [value]; [apply Q2R_red|].
  unfold worth. rewrite map_length. f_equal. unfold form. rewrite map_map.
  f_equal. apply map_ext. intros. apply Q2R_red.
Qed.
Lemma value_zero : value zero = 0.
Proof. apply Q2R_zero. Qed.
Lemma value_one : value one = 1.
Proof. apply Q2R_one. Qed.
Lemma value_half : value half = / 2.
Proof. unfold half, value, Q2R; simpl. lra. Qed.

(** ** Tests *)
Lemma difference_worth b a : worth (difference b a) = value b - value a.
Proof. unfold difference. rewrite <- value_worth. apply value_minus. Qed.
Lemma worth_sign l : are_of_sign l = true -> 0 < worth l.
Proof.
  intros H. apply Rdiv_lt_0_compat; [|apply power_positive].
  apply sign_positive; [exact H|apply moment_positive].
Qed.
Lemma worth_not_negative l : forallb (Qle_bool 0) l = true -> 0 <= worth l.
Proof.
  intros H. apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat, power_positive].
  apply form_not_negative; [pose proof moment_positive; lra|apply all_not_negative, H].
Qed.
Lemma lt_value a b : lt a b = true -> value a < value b.
Proof.
  assert (G : are_of_sign (difference b a) = true -> value a < value b).
  { intros H. apply worth_sign in H. rewrite difference_worth in H. lra. }
  destruct a, b; unfold lt; auto. apply less_real.
Qed.
Lemma le_value a b : le a b = true -> value a <= value b.
Proof.
  assert (G : forallb (Qle_bool 0) (difference b a) = true -> value a <= value b).
  { intros H. apply worth_not_negative in H. rewrite difference_worth in H. lra. }
  destruct a, b; unfold le; auto. apply le_real.
Qed.
Lemma equal_value a b : equal a b = true -> value a = value b.
Proof.
  assert (G : forallb (Qeq_bool 0) (difference b a) = true -> value a = value b).
  { intros H. apply (sign_zero _ moment) in H. pose proof (difference_worth b a) as E.
    unfold worth in E. rewrite H in E. unfold Rdiv in E. lra. }
  destruct a, b; unfold equal; auto. apply eq_real.
Qed.
Lemma not_equal_value a b : le a b = true -> equal a b = false -> value a < value b.
Proof.
  assert (G : forallb (Qle_bool 0) (difference b a) = true ->
    forallb (Qeq_bool 0) (difference b a) = false -> value a < value b).
  { intros L E. assert (S : are_of_sign (difference b a) = true).
    { unfold are_of_sign. rewrite L. simpl. revert L E. generalize (difference b a).
      induction l as [|c l IH]; simpl; [discriminate|]. intros L E.
      apply andb_prop in L. destruct L as [L1 L2]. destruct (less 0 c) eqn:C; auto. simpl.
      apply IH; auto. destruct (Qeq_bool 0 c) eqn:Z; auto. exfalso.
      apply le_real in L1. unfold less in C. apply negb_false_iff, le_real in C.
      assert (Q : Q2R 0 = Q2R c) by lra. apply eqR_Qeq, Qeq_bool_iff in Q. congruence. }
    apply worth_sign in S. rewrite difference_worth in S. lra. }
  destruct a as [p|l], b as [q|k]; unfold le, equal; auto. intros L E. apply le_real in L.
  cbn [value]. destruct (Req_dec (Q2R p) (Q2R q)) as [Z|]; [|lra].
  apply eqR_Qeq, Qeq_bool_iff in Z. congruence.
Qed.
Lemma differ_value a b : differ a b = true -> value a <> value b.
Proof.
  unfold differ. intros H. apply orb_prop in H. destruct H as [H|H]; apply lt_value in H; lra.
Qed.

Lemma larger_real x y : Q2R x <= Q2R (larger x y) /\ Q2R y <= Q2R (larger x y).
Proof.
  unfold larger. destruct (Qle_bool x y) eqn:E.
  - apply le_real in E. lra.
  - assert (H : less y x = true) by (unfold less; rewrite E; auto). apply less_real in H. lra.
Qed.
Lemma form_largest l : forall k, length l = length k ->
  form l moment <= form (largest l k) moment /\ form k moment <= form (largest l k) moment.
Proof.
  pose proof moment_positive as X.
  induction l as [|a l IH]; intros [|b k] E; try discriminate; unfold form in *; simpl; [lra|].
  injection E; intros E'. destruct (IH k E') as [H1 H2]. destruct (larger_real a b). nra.
Qed.
Lemma largest_length l : forall k, length l = length k -> length (largest l k) = length k.
Proof. induction l; intros [|b k] E; try discriminate; simpl; auto. Qed.
Lemma worth_largest l k : worth l <= worth (leveled largest l k) /\
  worth k <= worth (leveled largest l k).
Proof.
  unfold leveled. set (l' := raised _ l). set (k' := raised _ k).
  assert (E : length l' = length k') by (unfold l', k'; rewrite !raised_length; lia).
  replace (worth l) with (worth l') by apply worth_raised.
  replace (worth k) with (worth k') by apply worth_raised. unfold worth.
  rewrite largest_length by exact E. rewrite E. destruct (form_largest l' k' E) as [H1 H2].
  pose proof (Rinv_0_lt_compat _ (power_positive (pred (length k')))).
  split; apply Rmult_le_compat_r; lra.
Qed.
Lemma greater_value a b : value a <= value (greater_of a b) /\ value b <= value (greater_of a b).
Proof.
  unfold greater_of, moved. rewrite (value_worth a), (value_worth b).
  destruct a, b; try apply worth_largest. cbn [value coefficients_of]. rewrite !worth_one.
  apply larger_real.
Qed.
End Here.
