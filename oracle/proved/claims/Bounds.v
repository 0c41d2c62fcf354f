(** Step `clear`: what bounds and codes say at a place and a scale. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components
  Clear.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** Bounds *)
Definition worth_at (b : bound) (t s : R) : R :=
  value (of_t b) * t + value (of_s b) * s + value (rest b).
Definition holds_at (b : bound) (t s : R) : Prop :=
  if is_strict b then 0 < worth_at b t s else 0 <= worth_at b t s.
Lemma total_holds t s : forall ms cell, forallb (Qle_bool 0) ms = true ->
  (forall b, In b cell -> holds_at b t s) -> holds_at (total ms cell) t s.
Proof.
  assert (None_ : holds_at {| of_t := zero; of_s := zero; rest := zero; is_strict := false |} t s).
  { unfold holds_at, worth_at; cbn [of_t of_s rest is_strict]. rewrite value_zero. lra. }
  induction ms as [|m ms IH]; intros [|b cell] M H; try exact None_. simpl.
  simpl in M. apply andb_prop in M. destruct M as [M1 M]. apply le_real in M1.
  rewrite Q2R_zero in M1. specialize (IH cell M (fun b I => H b (or_intror I))).
  specialize (H b (or_introl eq_refl)). destruct (Qeq_bool m 0) eqn:Z; auto.
  assert (P : 0 < Q2R m).
  { destruct (Req_dec (Q2R m) 0) as [E|]; [|lra]. exfalso. rewrite <- Q2R_zero in E.
    apply eqR_Qeq, Qeq_bool_iff in E. congruence. }
  assert (E : worth_at {|
      of_t := reduced (nplus (ntimes (Fixed m) (of_t b)) (of_t (total ms cell)));
      of_s := reduced (nplus (ntimes (Fixed m) (of_s b)) (of_s (total ms cell)));
      rest := reduced (nplus (ntimes (Fixed m) (rest b)) (rest (total ms cell)));
      is_strict := is_strict b || is_strict (total ms cell) |} t s
    = Q2R m * worth_at b t s + worth_at (total ms cell) t s).
  { unfold worth_at; cbn [of_t of_s rest]. rewrite !value_reduced, !value_plus, !value_times.
    cbn [value]. ring. }
  unfold holds_at in *. rewrite E. cbn [is_strict].
  destruct (is_strict b), (is_strict (total ms cell)); cbn [orb]; nra.
Qed.
Lemma contradiction_fails ms cell t s : is_contradiction ms cell = true ->
  (forall b, In b cell -> holds_at b t s) -> False.
Proof.
  unfold is_contradiction. rewrite !andb_true_iff, orb_true_iff, andb_true_iff.
  intros [M [[T S] C]] H. pose proof (total_holds t s ms cell M H) as K.
  apply equal_value in T. apply equal_value in S. unfold holds_at, worth_at in K.
  rewrite T, S, value_zero in K. destruct C as [C|[C1 C2]].
  - apply lt_value in C. rewrite value_zero in C. destruct (is_strict _); lra.
  - rewrite C1 in K. apply le_value in C2. rewrite value_zero in C2. lra.
Qed.
Lemma bounds_hold i s t : in_scales i s -> forall b, In b (bounds_of i) -> holds_at b t s.
Proof.
  intros (S & L & H) b I. unfold bounds_of in I. simpl in I. destruct I as [<-|I].
  - unfold holds_at, worth_at; cbn [of_t of_s rest is_strict value].
    rewrite value_zero, value_one, Q2R_opp. destruct L as [L|[-> L]];
      [destruct (negb _ || _); lra|]. simpl. destruct (Qle_bool (low i) 0) eqn:E; [|lra].
    apply le_real in E. rewrite Q2R_zero in E. lra.
  - destruct (high i) as [h|]; [|destruct I]. simpl in I. destruct I as [<-|[]].
    unfold holds_at, worth_at; cbn [of_t of_s rest is_strict value].
    replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; lra). rewrite value_zero.
    destruct H as [H|[-> ->]]; [destruct (negb _); lra|simpl; lra].
Qed.
Lemma at_one_value slope rest_ s :
  value (at_one slope rest_ s) = value slope * value s + value rest_.
Proof. unfold at_one. rewrite value_reduced, value_plus, value_times. reflexivity. Qed.
Lemma positive_on i strictly slope rest_ s : is_positive_on i strictly slope rest_ = true ->
  in_scales i s -> let v := value slope * s + value rest_ in
  0 <= v /\ (strictly = true -> 0 < v).
Proof.
  intros H (S & L & U). unfold is_positive_on in H. rewrite !andb_true_iff in H.
  destruct H as [[F G] K]. apply le_value in F. apply le_value in G.
  rewrite at_one_value, value_zero in F. rewrite value_zero in G. cbn [value] in F.
  assert (K' : strictly = true ->
    (0 < value slope * Q2R (low i) + value rest_ \/
     0 < value (match high i with None => slope | Some b => at_one slope rest_ (Fixed b) end) /\
       Q2R (low i) < s) /\
    (0 < value (match high i with None => slope | Some b => at_one slope rest_ (Fixed b) end) \/
     match high i with None => True | Some b => s < Q2R b end)).
  { intros ->. cbn [negb orb] in K. rewrite !andb_true_iff, !orb_true_iff, andb_true_iff in K.
    destruct K as [K1 K2]. split.
    - destruct K1 as [K1|[K1 K3]].
      + apply lt_value in K1. rewrite at_one_value, value_zero in K1. auto.
      + right. apply lt_value in K1. rewrite value_zero in K1. split; [exact K1|].
        destruct L as [L|[L1 L2]]; [exact L|]. rewrite L1 in K3. cbn [negb orb] in K3.
        apply le_real in K3. rewrite Q2R_zero in K3. lra.
    - destruct K2 as [K2|K2]; [left; apply lt_value in K2; rewrite value_zero in K2; exact K2|].
      right. destruct (high i); [|exact I]. destruct U as [U|[U1 U2]]; [exact U|].
      rewrite U1 in K2. discriminate. }
  clear K. set (l := Q2R (low i)) in *. assert (Ls : l <= s) by (destruct L; lra). clear L.
  cbv zeta. destruct (high i) as [h|].
  - rewrite at_one_value in *. cbn [value] in *. set (u := Q2R h) in *.
    assert (Us : s <= u) by (destruct U; lra). clear U.
    destruct (Req_dec l u) as [E|N].
    + assert (s = l) by lra. subst s. split; [lra|]. intros St. specialize (K' St).
      rewrite <- E in *. lra.
    + assert (D : 0 < u - l) by lra.
      assert (C : (u - l) * (value slope * s + value rest_) =
        (u - s) * (value slope * l + value rest_) + (s - l) * (value slope * u + value rest_))
        by ring.
      assert (P1 : 0 <= (u - s) * (value slope * l + value rest_)) by (apply Rmult_le_pos; lra).
      assert (P2 : 0 <= (s - l) * (value slope * u + value rest_)) by (apply Rmult_le_pos; lra).
      split; [apply Rmult_le_reg_l with (u - l); lra|]. intros St. specialize (K' St).
      apply Rmult_lt_reg_l with (u - l); [exact D|]. rewrite Rmult_0_r, C.
      assert (Q1 : forall v w, 0 < v -> 0 < w -> 0 < v * w)
        by (intros; apply Rmult_lt_0_compat; auto).
      destruct K' as [[A|[A1 A2]] [B|B]].
      * destruct (Req_dec s l) as [->|]; [specialize (Q1 _ _ D A); lra|].
        specialize (Q1 (s - l) _ ltac:(lra) B). lra.
      * specialize (Q1 (u - s) _ ltac:(lra) A). lra.
      * specialize (Q1 (s - l) _ ltac:(lra) B). lra.
      * specialize (Q1 (s - l) _ ltac:(lra) A1). lra.
  - split; [nra|]. intros St. specialize (K' St). destruct K' as [[A|[A1 A2]] _]; nra.
Qed.

(** ** Places *)
Definition place_at (s : R) (p : moving_place) : point :=
  add (real (fst p)) (scale s (real (snd p))).
Definition next_to (p : moving_place) (d : corner) (t s : R) : point :=
  add (place_at s p) (scale t (real d)).
Lemma real_opposite n p : dot (real (opposite n)) p = - dot (real n) p.
Proof.
  unfold opposite, dot, real; cbn [fst snd]. rewrite !value_minus, value_zero. ring.
Qed.
Lemma level_worth p d n a b t s : worth_at (level p d n a b) t s = dot (real n) (next_to p d t s)
  - s * value (support (opposite n) (hull_of a)) - value (support n (hull_of b)).
Proof.
  unfold worth_at, level; cbn [of_t of_s rest]. rewrite !value_reduced, !value_minus, !real_dot.
  unfold next_to, place_at, dot, add, scale; cbn [fst snd]. ring.
Qed.
Lemma negative_worth b strictly t s : worth_at (negative b strictly) t s = - worth_at b t s.
Proof.
  unfold worth_at, negative; cbn [of_t of_s rest]. rewrite !value_minus, value_zero. ring.
Qed.

(** Two pieces that a normal holds apart *)
Definition held_apart (c : touch) (s : R) (x : point) (la lb : list corner) : Prop :=
  exists (n : point) (ma mb : R), ~ (fst n = 0 /\ snd n = 0) /\
    (forall v, In v la -> - dot n (real v) <= ma) /\ (forall v, In v lb -> dot n (real v) <= mb) /\
    match c with Allowed => s * ma + mb <= dot n x | Forbidden => s * ma + mb < dot n x end.
Lemma level_apart c p d n a b t s la lb : is_tree a = true -> is_tree b = true ->
  distinct n (zero, zero) = true -> In la (leaves a) -> In lb (leaves b) ->
  (0 < worth_at (level p d n a b) t s \/ (c = Allowed /\ 0 <= worth_at (level p d n a b) t s)) ->
  held_apart c s (next_to p d t s) la lb.
Proof.
  intros Wa Wb N Ia Ib H. rewrite level_worth in H.
  destruct (tree_le a Wa) as [_ Ka]. destruct (tree_le b Wb) as [_ Kb].
  exists (real n), (value (support (opposite n) (hull_of a))), (value (support n (hull_of b))).
  repeat apply conj.
  - intros [Z1 Z2]. apply distinct_real in N. apply N. unfold real at 2. cbn [fst snd].
    rewrite value_zero. destruct (real n). simpl in *. congruence.
  - intros v V. rewrite <- real_opposite. revert v V. apply (proj2 (Ka la Ia)).
    intros v V. apply support_real, V.
  - apply (proj2 (Kb lb Ib)). intros v V. apply support_real, V.
  - destruct c, H as [H|[H1 H2]]; try discriminate; lra.
Qed.
Lemma nodes_opened (k : list node) (make : node -> list bound * node * node) st :
  (forall c, In c k -> is_tree (snd (fst (make c))) = true /\ is_tree (snd (make c)) = true) ->
  (forall e, In e st -> is_tree (snd (fst e)) = true /\ is_tree (snd e) = true) ->
  forall e, In e (map make k ++ st) -> is_tree (snd (fst e)) = true /\ is_tree (snd e) = true.
Proof.
  intros H W e J. apply in_app_or in J. destruct J as [J|J]; [|auto].
  apply in_map_iff in J. destruct J as (c & <- & J). auto.
Qed.
Theorem ways_held_apart c p d t s la lb : forall code stack, follow_ways c p d code stack = true ->
  (forall e, In e stack -> is_tree (snd (fst e)) = true /\ is_tree (snd e) = true) ->
  forall cell a b, In (cell, a, b) stack -> (forall x, In x cell -> holds_at x t s) ->
    In la (leaves a) -> In lb (leaves b) -> held_apart c s (next_to p d t s) la lb.
Proof.
  induction code as [|i code IH]; intros stack H W cell a b I Hc Ia Ib.
  - destruct stack; [destruct I|discriminate].
  - destruct i; destruct stack as [|[[cell' x] y] st]; try discriminate; simpl in H.
    + destruct x as [v|h k]; try discriminate. pose proof (W _ (or_introl eq_refl)) as [W1 W2].
      assert (W' := nodes_opened k (fun a => (cell', a, y)) st
        (fun c J => conj (tree_members h k c W1 J) W2) (fun e J => W e (or_intror J))).
      destruct I as [E|I]; [|apply (IH _ H W' cell a b); auto; apply in_or_app; auto].
      injection E; intros; subst. simpl in Ia. apply in_flat_map in Ia.
      destruct Ia as (m & J & K). apply (IH _ H W' cell m b); auto.
      apply in_or_app. left. apply in_map_iff. exists m; auto.
    + destruct y as [v|h k]; try discriminate. pose proof (W _ (or_introl eq_refl)) as [W1 W2].
      assert (W' := nodes_opened k (fun b => (cell', x, b)) st
        (fun c J => conj W1 (tree_members h k c W2 J)) (fun e J => W e (or_intror J))).
      destruct I as [E|I]; [|apply (IH _ H W' cell a b); auto; apply in_or_app; auto].
      injection E; intros; subst. simpl in Ib. apply in_flat_map in Ib.
      destruct Ib as (m & J & K). apply (IH _ H W' cell a m); auto.
      apply in_or_app. left. apply in_map_iff. exists m; auto.
    + pose proof (W _ (or_introl eq_refl)) as Wt.
      assert (W' : forall e, In e ((negative (beyond t0) false :: cell', x, y) ::
        (beyond t0 :: cell', x, y) :: st) ->
        is_tree (snd (fst e)) = true /\ is_tree (snd e) = true).
      { intros e [<-|[<-|J]]; auto. apply W; simpl; auto. }
      destruct I as [E|I]; [|apply (IH _ H W' cell a b); simpl; auto].
      injection E; intros; subst.
      assert (B : worth_at (beyond t0) t s = t - Q2R t0).
      { unfold worth_at, beyond; cbn [of_t of_s rest value]. rewrite value_one, value_zero, Q2R_opp.
        ring. }
      destruct (Rle_dec t (Q2R t0)).
      * apply (IH _ H W' (negative (beyond t0) false :: cell) a b); simpl; auto.
        intros z [<-|Z]; auto. unfold holds_at. rewrite negative_worth, B. simpl. lra.
      * apply (IH _ H W' (beyond t0 :: cell) a b); simpl; auto.
        intros z [<-|Z]; auto. unfold holds_at. rewrite B. simpl. lra.
    + apply andb_prop in H. destruct H as [N H]. pose proof (W _ (or_introl eq_refl)) as Wt.
      set (new := negative (level p d n x y) (is_allowed c)) in *.
      assert (W' : forall e, In e ((new :: cell', x, y) :: st) ->
        is_tree (snd (fst e)) = true /\ is_tree (snd e) = true).
      { intros e [<-|J]; auto. apply W; simpl; auto. }
      destruct I as [E|I]; [|apply (IH _ H W' cell a b); simpl; auto].
      injection E; intros; subst. simpl in Wt. destruct Wt as [Wa Wb].
      assert (A : held_apart c s (next_to p d t s) la lb \/ holds_at new t s).
      { unfold holds_at, new at 1 2 3. rewrite negative_worth.
        set (v := worth_at (level p d n a b) t s).
        assert (G : 0 < v \/ (c = Allowed /\ 0 <= v) -> held_apart c s (next_to p d t s) la lb)
          by (apply level_apart; auto).
        destruct c; unfold is_allowed, negative; cbn [is_strict].
        - destruct (Rle_dec 0 v); [left; apply G; auto|right; lra].
        - destruct (Rlt_dec 0 v); [left; apply G; auto|right; lra]. }
      destruct A as [A|A]; auto. apply (IH _ H W' (new :: cell) a b); simpl; auto.
      intros z [<-|Z]; auto.
    + apply andb_prop in H. destruct H as [N H].
      destruct I as [E|I]; [|apply (IH _ H (fun e J => W e (or_intror J)) cell a b); auto].
      injection E; intros; subst. destruct (contradiction_fails ms cell t s N Hc).
Qed.
